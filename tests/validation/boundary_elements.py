"""The law against boundary elements: the same rough surface pressed by both, and what they say of area and friction.

An isotropic Gaussian surface on a periodic square is pressed against a flat by tamaas (Frérot, Anciaux, Rey, Pham-Ba
and Molinari, J. Open Source Softw. 5 (2020), 2121) with the solver of Polonsky and Keer (Wear 231 (1999), 206): an
elastic half-space, no adhesion, summits that press each other down and contacts of any shape. Friction is that of eqs
(13) to (15), summed over the patches of contact, each taken for a circle of its area. The library answers for the same
surface from two of its spectral moments, and from McCool's summits of three moments.

usage: boundary_elements.py [FILE.csv]

Computes every surface anew, for two hours or so on one core, and writes boundary_elements.csv.
"""

from __future__ import annotations

import csv
import math
import sys
import warnings
from dataclasses import astuple, dataclass, fields
from functools import lru_cache
from pathlib import Path
from typing import Any, Iterable, Iterator, TypeVar

import numpy as np
import tamaas

from asperity import Model, Params, State, ValidityWarning
from asperity import surface as topography

FILE = Path(__file__).with_name("boundary_elements.csv")

# In the unit of the grid and of E* = G* = 1. Slopes cancel from area and friction at a given load over E* times slope.
SLOPE = 0.1
# Nominal pressure over E* and root mean square gradient: real areas of about 0.12, 1.2, 3.5, 10 and 17 % of the nominal.
PRESSURES = (5e-4, 5e-3, 1.5e-2, 4.5e-2, 8e-2)
# The mean gap at a slightly greater pressure tells the stiffness.
GREATER = 1.1
# Contacts are then between the slip radii, 28 and 80000 b, where the size of the contacts matters most.
BURGERS_VECTOR = 0.01
# Of the solver: the complementarity of gap and pressure. From 1e-5 to 1e-8 no digit of the tables changes.
TOLERANCE = 1e-6
# Yastrebov, Anciaux and Molinari, Tribol. Int. 114 (2017), 161: a grid overrates an area by this times perimeter times
# spacing, as its squares stick out of the true contact.
OUTLINE = (math.pi - 1 + math.log(2)) / 24


CONTACT: dict[str, Any] = dict(
    composite_modulus=1.0, effective_shear_modulus=1.0, work_of_adhesion=0.0, adhesion_range=BURGERS_VECTOR,
    burgers_vector=BURGERS_VECTOR,
)  # fmt: skip


@dataclass(frozen=True)
class Spectrum:
    """Waves with wavenumbers from `lowest` to `highest` a side, on a square of `grid` points a side.

    Their power falls as q^(-2 - 2 hurst) above `corner` and is constant below. With two `bands`, the waves between the
    first and the last octave are left out.
    """

    grid: int
    lowest: float
    corner: float
    highest: float
    hurst: float
    bands: int
    seeds: int

    def power(self, q: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        """Of a wave with q waves a side, but for a factor."""
        inside = (q >= self.lowest) & (q <= self.highest)
        if self.bands == 2:
            inside &= (q <= 2 * self.lowest) | (q >= self.highest / 2)
        return np.where(inside, np.maximum(q, self.corner) ** (-2 - 2 * self.hurst), 0.0)


def falling(grid: int, lowest: float, highest: float, hurst: float, seeds: int) -> Spectrum:
    """A spectrum that falls from its longest wave on."""
    return Spectrum(grid, lowest, lowest, highest, hurst, 1, seeds)


# The shortest wave has 16 points.
RESOLVED = (
    falling(512, 13, 32, -1.0, 4),
    falling(512, 6, 32, 0.1, 4),
    falling(512, 4, 32, 0.8, 4),
    falling(1024, 2, 64, 0.8, 2),
)
# The shortest wave has 4 points, which is enough for area, friction, gap and stiffness.
COARSE = (
    # Narrow.
    falling(512, 52, 128, -1.0, 2),
    falling(512, 13, 128, 0.8, 4),
    # Self-affine.
    falling(512, 8, 128, 0.8, 4),
    falling(512, 4, 128, 0.3, 4),
    falling(512, 4, 128, 0.5, 4),
    falling(512, 4, 128, 0.8, 4),
    falling(512, 4, 128, 1.0, 4),
    falling(512, 2, 128, 0.5, 2),
    falling(512, 2, 128, 0.8, 4),
    falling(512, 1, 128, 0.8, 4),
    # With a plateau.
    Spectrum(512, 1, 4, 128, 0.8, 1, 4),
    Spectrum(512, 1, 8, 128, 0.8, 1, 4),
    Spectrum(512, 2, 8, 128, 0.5, 1, 2),
    Spectrum(512, 4, 16, 128, 0.8, 1, 4),
    # In two bands.
    Spectrum(512, 4, 4, 128, 0.3, 2, 2),
    Spectrum(512, 4, 4, 128, 0.8, 2, 4),
    Spectrum(512, 8, 8, 128, 0.8, 2, 2),
    # On more scales.
    falling(1024, 4, 256, 0.5, 1),
    falling(1024, 4, 256, 0.8, 2),
    falling(1024, 4, 256, 1.0, 2),
    falling(1024, 1, 256, 0.8, 1),
    Spectrum(1024, 1, 8, 256, 0.8, 1, 1),
    falling(2048, 4, 512, 0.8, 2),
    falling(2048, 4, 512, 1.0, 2),
)
SPECTRA = RESOLVED + COARSE


@dataclass(frozen=True)
class Known:
    """One surface at one load: what is known of it, in the unit of the grid, and what boundary elements answer.

    Attributes:
        seed: of the random numbers of the surface, whose spectrum is told by the columns before it.
        m0, m2, m4: spectral moments.
        pressure: nominal pressure over E* and root mean square gradient.
        area: real area over nominal area.
        friction: friction force over G* and nominal area.
        patches: number of patches of contact.
    """

    grid: int
    lowest: float
    corner: float
    highest: float
    hurst: float
    bands: int
    seed: int
    m0: float
    m2: float
    m4: float
    pressure: float
    area: float
    friction: float
    patches: int

    @property
    def bandwidth(self) -> float:
        """Nayak's, m0 m4/m2^2."""
        return self.m0 * self.m4 / self.m2**2

    @property
    def waves(self) -> float:
        """Of the longest waves with full power, how many fit a side."""
        return self.corner

    @property
    def kind(self) -> str:
        """Of the spectrum."""
        if self.bands == 2:
            return "two bands"
        if self.corner > self.lowest:
            return "plateau"
        return "narrow" if self.highest < 10 * self.lowest else f"self-affine, H = {self.hurst:g}"

    @property
    def fitted(self) -> bool:
        """Whether the constants of src/params/spectrum.rs were fitted to this surface, by fit_asperities.py."""
        return self.seed % 2 == 0

    def is_of(self, spectrum: Spectrum) -> bool:
        """Whether the surface has this spectrum."""
        return (self.grid, self.lowest, self.corner, self.highest, self.hurst, self.bands) == astuple(spectrum)[:-1]

    def from_moments(self, **law: Any) -> Params:
        """Parameters from m0 and m2, with the law of contact."""
        moments = dict(m0=self.m0, m2=self.m2, nominal_area=float(self.grid**2))
        return Params.from_spectral_moments(**moments, **CONTACT | law)

    def from_mccool(self, bandwidth: float) -> Params:
        """Parameters of McCool's summits, with m0, m2 and a bandwidth."""
        moments = dict(m0=self.m0, m2=self.m2, m4=bandwidth * self.m2**2 / self.m0, nominal_area=float(self.grid**2))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)  # of the bias that is measured here
            return Params.from_spectral_moments(**moments, summits="mccool", **CONTACT)

    def predicted(self, params: Params) -> Prediction:
        """The library over the boundary elements."""
        return self.ratios(state(params, self.load))

    def ratios(self, state: State) -> Prediction:
        """A state over the boundary elements."""
        nominal = self.grid**2
        return Prediction(state.real_area / nominal / self.area, state.friction_force / nominal / self.friction)

    def areas(self, params: Params, pressures: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        """Real over nominal area by the library, at nominal pressures over E* and gradient."""
        nominal = self.grid**2
        return np.array([state(params, pressure * SLOPE * nominal).real_area / nominal for pressure in pressures])

    @property
    def load(self) -> float:
        """Over E*."""
        return self.pressure * SLOPE * self.grid**2


@dataclass(frozen=True)
class Row(Known):
    """An elastic surface.

    Attributes:
        patch_radius: mean radius of the patches, each taken for a circle and weighted by its area.
        gap: mean distance of the surfaces.
        greater_gap: the same at `GREATER` times the pressure.
    """

    patch_radius: float
    gap: float
    greater_gap: float

    @property
    def by_moments(self) -> Planes:
        """By the library, from m0 and m2."""
        params = self.from_moments()
        here, greater = (state(params, factor * self.load) for factor in (1.0, GREATER))
        stiffness = (self.gap - self.greater_gap) / (here.gap - greater.gap)
        return Planes(*astuple(self.ratios(here)), stiffness, (here.gap - self.gap) / math.sqrt(self.m0))

    @property
    def by_mccool(self) -> Prediction:
        """By the library, from the three moments: McCool's summits."""
        return self.predicted(self.from_mccool(self.bandwidth))


@dataclass(frozen=True)
class Prediction:
    """Area and friction of the library over those of the boundary elements."""

    area: float
    friction: float


@dataclass(frozen=True)
class Planes(Prediction):
    """Normal stiffness too, and the gap of the library less that of the boundary elements, over root mean square height."""

    stiffness: float
    gap: float


@lru_cache(maxsize=None)
def model(params: Params) -> Model:
    return Model(params)


def state(params: Params, load: float) -> State:
    """Of a model that is made once."""
    return model(params).state_at_load(load)


def surface(spectrum: Spectrum, seed: int) -> tuple[np.ndarray[Any, Any], topography.SpectralMoments]:
    """Heights on a periodic grid of spacing 1, and their spectral moments, exactly: sums over the waves."""
    n = spectrum.grid
    wave = np.fft.fftfreq(n, 1 / n)
    q = np.hypot(wave[:, None], wave[None, :])
    noise = np.random.default_rng(seed).standard_normal((n, n))
    waves = np.fft.fft2(noise) * np.sqrt(spectrum.power(q))
    power = np.abs(waves) ** 2
    q *= 2 * math.pi / n
    # Means over all directions: of cos^2 a half, of cos^4 three eighths.
    m0, m2, m4 = float(power.sum()), float((q**2 * power).sum()) / 2, float(3 / 8 * (q**4 * power).sum())
    scale = SLOPE**2 / (2 * m2)
    moments = topography.SpectralMoments(m0 * scale, m2 * scale, m4 * scale)
    # Parseval's factor of numpy's transform is n^4; it cancels from the heights, which are scaled by their slope.
    heights = np.fft.ifft2(waves).real * n**2 * math.sqrt(scale)
    return heights, moments


def press(heights: np.ndarray[Any, Any], pressures: tuple[float, ...]) -> Iterator[tuple[Any, ...]]:
    """By boundary elements at nominal pressures over E*: what `patches` says, the mean gap, and the mean gap at a slightly
    greater pressure."""
    n = heights.shape[0]
    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [float(n)] * 2, [n] * 2)
    model.E, model.nu = 1.0, 0.0
    solver = tamaas.PolonskyKeerRey(model, heights, TOLERANCE)
    solver.max_iter = 10000

    def mean_gap(pressure: float) -> float:
        reached = solver.solve(pressure)
        if not reached <= TOLERANCE:
            raise RuntimeError(f"the solver reaches {reached:g} at a pressure of {pressure:g}, not {TOLERANCE:g}")
        # But for a constant, by which it is 0 in contact.
        gap = np.asarray(model.displacement) - heights
        return float(gap.mean() - gap[np.asarray(model.traction) > 0].mean())

    for pressure in pressures:
        gap = mean_gap(pressure)
        contact = patches(model.traction)
        yield *contact, gap, mean_gap(GREATER * pressure)


def patches(pressure: np.ndarray[Any, Any], hardness: float = math.inf) -> tuple[float, float, int, float]:
    """Real area and friction force, over the nominal area, number of the patches that bear pressure, and their mean radius
    weighted by area."""
    found = tamaas.FloodFill.getClusters(pressure > 0, False)
    areas = np.array([patch.area - OUTLINE * patch.perimeter for patch in found])
    if math.isfinite(hardness):
        # No patch is smaller than its load over the hardness. The outline is that of elastic contacts, and too much for these.
        loads = np.array([pressure[tuple(np.array(patch.points).T % len(pressure))].sum() for patch in found])
        areas = np.maximum(areas, loads / hardness)
    friction, radius = slip_force(areas).sum() / pressure.size, np.average(np.sqrt(areas / math.pi), weights=areas)
    return float(areas.sum()) / pressure.size, float(friction), len(found), float(radius)


def slip_force(areas: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Eqs (13) to (15) with the constants of Hurtado and Kim, for circles of these areas."""
    radius = np.sqrt(areas / math.pi) / BURGERS_VECTOR
    exponent = -math.log(1290 / 43) / math.log(8e4 / 28)
    return np.asarray(areas * np.clip(radius / 28, 1, 8e4 / 28) ** exponent / 43)


def known(spectrum: Spectrum, seed: int, moments: topography.SpectralMoments) -> tuple[Any, ...]:
    """What a row knows of its surface."""
    return *astuple(spectrum)[:-1], seed, moments.m0, moments.m2, moments.m4


def compare(spectrum: Spectrum, seed: int, ratios: tuple[float, ...] = PRESSURES) -> Iterator[Row]:
    """One surface at pressures over E* and slope."""
    heights, moments = surface(spectrum, seed)
    for ratio, answer in zip(ratios, press(heights, tuple(ratio * SLOPE for ratio in ratios))):
        yield Row(*known(spectrum, seed, moments), ratio, *answer)


AnyRow = TypeVar("AnyRow", bound=Any)


def read(file: Path, row: type[AnyRow]) -> list[AnyRow]:
    """The rows of a frozen file."""
    with file.open(encoding="utf-8", newline="") as text:
        lines = csv.reader(line for line in text if not line.startswith("#"))
        if next(lines) != [field.name for field in fields(row)]:
            raise ValueError(f"{file}: not the columns of this script")
        kinds = [int if field.type == "int" else float for field in fields(row)]
        return [row(*(kind(cell) for kind, cell in zip(kinds, line))) for line in lines]


def write(file: Path, row: type[AnyRow], rows: Iterable[AnyRow], script: str) -> None:
    """A frozen file, row by row as they come."""
    with file.open("w", encoding="utf-8", newline="") as out:
        out.write(f"# Written by {script} with tamaas {tamaas.__version__}.\n")
        table = csv.writer(out, lineterminator="\n")
        table.writerow([field.name for field in fields(row)])
        for found in rows:
            table.writerow([value if isinstance(value, int) else f"{value:.7g}" for value in astuple(found)])
            out.flush()


def frozen(file: Path = FILE) -> list[Row]:
    """The rows of boundary_elements.csv."""
    return read(file, Row)


def surfaces() -> list[tuple[Spectrum, int]]:
    """Spectra and seeds, the small grids first."""
    all_of_them = [(spectrum, seed) for spectrum in SPECTRA for seed in range(spectrum.seeds)]
    return sorted(all_of_them, key=lambda one: (one[0].grid, one[1]))


def rows() -> Iterator[Row]:
    """All of boundary_elements.csv, anew."""
    for spectrum, seed in surfaces():
        yield from compare(spectrum, seed)


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else FILE, Row, rows(), "tests/validation/boundary_elements.py")
