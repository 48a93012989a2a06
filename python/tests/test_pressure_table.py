"""The table of pressures against laws in closed form, of which the largest error between rows is known."""

from __future__ import annotations

from typing import Callable

import numpy as np
import numpy.typing as npt
import pytest

from asperity.hosts import pressure_table as _pressure_table
from asperity.hosts.pressure_table import pressure_table

Array = npt.NDArray[np.float64]


def largest_error(law: Callable[[Array], Array], pressure: Array, friction: Array) -> float:
    """Between all rows, at places as dense next to the first row as next to the last."""
    rows = zip(pressure, pressure[1:])
    places = np.concatenate([np.r_[np.geomspace(p, q, 4001), np.linspace(p, q, 4001)] for p, q in rows])
    return float(np.max(abs(np.interp(places, pressure, friction) / law(places) - 1)))


@pytest.mark.parametrize("last", [3.0, 1e2, 1e4, 1e6])
@pytest.mark.parametrize("power", [-2.0, -1 / 3, 0.5])
def test_the_error_of_a_line_is_found_wherever_it_is(power: float, last: float) -> None:
    """Two thirds of the way for a steep fall; for a rise down to a thousandth, where evenly spaced samples find 7 % less."""

    def law(pressure: Array) -> Array:
        return np.asarray((pressure / 1e3) ** power)

    ends = np.array([1e3, 1e3 * last])
    expected = largest_error(law, ends, law(ends))
    assert _pressure_table._error(law, *ends) == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize("tolerance", [0.05, 1e-2, 1e-3])
def test_rows_are_as_far_apart_as_the_tolerance_lets_them_be(tolerance: float) -> None:
    def law(pressure: Array) -> Array:
        return 0.1 + 1 / (1 + pressure)

    table = pressure_table(law, 1e-3, 1e6, tolerance)
    found = largest_error(law, table.at, table.value)
    assert 0.9 * tolerance < found <= tolerance
    assert table.error == pytest.approx(found, rel=0.02)


@pytest.mark.parametrize("of", ["light", "heavy"])
def test_a_peak_is_seen_at_either_end(of: str) -> None:
    """Of light pressures evenly spaced samples see nothing, of heavy ones those of even ratios."""

    def law(pressure: Array) -> Array:
        away = (np.log(pressure) - 2) / 0.5 if of == "light" else (pressure / 1e6 - 0.9) / 0.03
        return np.asarray(1 + 0.1 * np.exp(-(away**2)))

    table = pressure_table(law, 1.0, 1e6, 1e-2)
    assert largest_error(law, table.at, table.value) <= 1e-2 and len(table.at) < 30


def test_an_end_of_more_than_nine_digits_ends_the_rows() -> None:
    """Rounded down it is below itself, and rows that must reach it would never end."""
    table = pressure_table(lambda pressure: 1 / pressure, 1.0, 10.0000000001, 1e-2)
    assert table.at[-1] == 10
