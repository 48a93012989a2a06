"""What `import asperity.mujoco`, `asperity.mujoco_warp` and `asperity.mjx` say where their host is missing. With it, the `run.sh` of
`hosts/mujoco`, `hosts/mujoco_warp` and `hosts/mjx` test the modules."""

from __future__ import annotations

import importlib
import sys

import pytest


@pytest.mark.parametrize(("module", "host", "package"), [
    ("asperity.mujoco", "mujoco", "mujoco"), ("asperity.mujoco_warp", "mujoco_warp", "mujoco-warp"),
    ("asperity.mjx", "mujoco", "mujoco-mjx"),
])  # fmt: skip
def test_without_the_host_the_message_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, module: str, host: str, package: str
) -> None:
    monkeypatch.setitem(sys.modules, host, None)
    monkeypatch.delitem(sys.modules, module, raising=False)
    with pytest.raises(ImportError, match=f"pip install {package}$"):
        importlib.import_module(module)
