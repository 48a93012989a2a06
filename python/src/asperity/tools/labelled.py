"""Arrays with labels: what comes in as a pandas Series or DataFrame or an xarray DataArray goes out as the same.

Neither package is imported for that: the values that a caller brings tell what they are.
"""

from __future__ import annotations

from typing import Any, Protocol, TypeVar


class HasLabels(Protocol):
    """A Series, DataFrame or DataArray."""

    def to_numpy(self, *arguments: Any, **options: Any) -> Any:
        """The values."""


Labelled = TypeVar("Labelled", bound=HasLabels)


def frame(columns: dict[str, Any]) -> Any:
    """A `pandas.DataFrame` of columns.

    Raises:
        ImportError: pandas is missing.
    """
    try:
        import pandas
    except ImportError as error:
        raise ImportError(f"a DataFrame needs pandas ({error}): pip install pandas") from None
    return pandas.DataFrame(columns)


def like(given: Any, values: Any, name: str) -> Any:
    """Values of the shape of what was given, with its labels if it has some, under a name of their own."""
    if hasattr(given, "dims") and hasattr(given, "coords"):
        found = given.copy(data=values)
        found.name, found.attrs = name, {}
        return found
    if hasattr(given, "iloc") and hasattr(given, "columns"):
        return type(given)(values, index=given.index, columns=given.columns)
    if hasattr(given, "iloc"):
        return type(given)(values, index=given.index, name=name)
    return values
