"""The examples in docstrings print what they say; what users start with has one."""

from __future__ import annotations

import doctest
import importlib
import inspect
import warnings

import pytest

import asperity

MODULES = ("one_line", "model", "_friction_law", "params", "fits.fit", "fits.uncertainty")
WITH_EXAMPLES = (
    asperity.friction,
    asperity.Model,
    asperity.Model.friction_at_load,
    asperity.Model.check,
    asperity.Params.from_iso25178,
    asperity.Params.calibrated,
    asperity.fit,
    asperity.uncertainty,
)


@pytest.mark.parametrize("name", MODULES)
def test_examples_print_what_they_say(name: str) -> None:
    module = importlib.import_module(f"asperity.{name}")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", asperity.ValidityWarning)
        result = doctest.testmod(module, extraglobs={"asperity": asperity})
    assert result.failed == 0 and result.attempted > 0


@pytest.mark.parametrize("item", WITH_EXAMPLES)
def test_what_users_start_with_has_an_example(item: object) -> None:
    assert ">>> " in (inspect.getdoc(item) or "")


def test_every_public_name_says_in_its_first_line_what_it_is() -> None:
    for name in asperity.__all__:
        item = getattr(asperity, name)
        if inspect.ismodule(item) or isinstance(item, str):
            continue
        first = (inspect.getdoc(item) or "").split("\n")[0]
        assert len(first) > 20, name
    for owner in (asperity.Model, asperity.Params):
        for name, item in inspect.getmembers(owner):
            if not name.startswith("_") and (callable(item) or isinstance(item, property)):
                assert len((inspect.getdoc(item) or "").split("\n")[0]) > 20, f"{owner.__name__}.{name}"
