"""The page `dev/gallery.md`: each figure next to what the paper says about it, with the numbers found here.

Every number and every ordering on the page is computed when the page is written. An ordering that did not hold at all
loads drawn would be printed with the loads where it does.
"""

from __future__ import annotations

import contextlib
import io
import math
from typing import Callable, Sequence

import numpy as np
import numpy.typing as npt

from . import curves
from .curves import HEAVIEST, LIGHTEST, LOADS, Array, CurveFigure, friction, model, surface

Mask = npt.NDArray[np.bool_]

_SHOWN = np.array([1.0, 10.0, 100.0, 1000.0, 10000.0])
_REGIME_SHOWN = np.array([1e-6, 1e-4, 1e-2, 1.0, 10.0])


def text() -> str:
    """The whole page."""
    parts = [_introduction(), _figure_3(), *map(_skew_figure, curves.SKEW_FIGURES)]
    parts += [_radius_figure(figure) for figure in curves.RADIUS_FIGURES]
    parts += [_kurtosis(), _regimes(), _yield(), _microslip(), _not_compared(), CORRECTIONS]
    return "\n\n".join(parts) + "\n"


_PROGRAM = """\
from asperity import Model, Params

for beta in (1000, 500):
    model = Model(Params.dimensionless(alpha=0.01, beta=beta, gamma=0.001))     # Gaussian heights: figures 4 and 6
    print(beta, *(f"{model.friction_at_load(load):.3f}" for load in (1, 100, 10000)))
"""


def _introduction() -> str:
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(_PROGRAM, {})
    return f"""\
# The paper's figures: friction coefficient against load

The library reproduces what the text of G. G. Adams and S. Müftü, *Improvements to a scale-dependent model for contact and
friction*, J. Phys. D: Appl. Phys. 38 (2005) 1402–1409, says about its figures 3 to 10. Loads P are in N G b², of N asperities
([α, β, γ](../model.md#units-and-groups-eqs-7-8)); μ = F/P. Three loads of two curves, after `pip install './python[plot]'` in a checkout:

```python
{_PROGRAM}```

```text
{printed.getvalue()}```

Weibull heights: `skew=-1`; radii that grow with height: `radius_amplitude=0.5`. `python docs/gallery FOLDER` writes this
page, its pictures and the curves as CSV, and a test fails if a number here is not what the library computes."""


def _not_compared() -> str:
    return f"""\
## What cannot be compared

The paper prints no table of its curves, and its text names no load. So the curves cannot be
compared point by point. The tables compare what the text says of them, at loads from {LIGHTEST:g} to {HEAVIEST:g} that were
chosen here. Three more inputs had to be chosen: Poisson's ratio (0.3), b/h in the figures (1, which the paper calls
typical) and the constants of the shear strength (Hurtado and Kim's, see [model.md](../model.md)). The range of loads
matters: if many asperities are high, adhesion alone holds lightly loaded surfaces together, and μ grows without limit as the
load goes to zero."""


CORRECTIONS = """\
## Corrections to the printed paper

| Eq. | Printed | Here | Why it is certain |
|---|---|---|---|
| (4) | (m² − 1)·atan√(m² − 1) − m + 1 | √(m² − 1)·atan√(m² − 1) − m + 1 | Maugis' paper; only then is the limit of attraction λ = 0.655 = (9/32)^⅓ |
| (10), (11) | h − u with u the overlap | h + u | u is the gap there; only then does (11) join (5) as a → 0 |
| (14), (15) | no π | F = π a² τ | the sentence before |
| (20) | density in z from 0 | z + z_M from 0, z_M = B₁/C | the text has z = 0 at the mean; Table 1 lists z_M as the mean |"""


# ---- Figure 3 ----


def _figure_3() -> str:
    lambdas = {beta: model(surface(0.01, beta, 0.001)).summary().lambda_ for beta in (500, 1000)}
    loads = {beta: _load_of_effect(beta, percent) for beta, percent in ((1000, 2.1), (500, 3.8))}
    effects = {beta: curves.attraction_effect(beta, _SHOWN) for beta in (1000, 500)}
    grows = curves.attraction_effect(500) > curves.attraction_effect(1000)
    rows = [f"| {beta} | {lambdas[beta]:.3f} | {_cells(effects[beta], '.2f')} |" for beta in effects]
    claims = [
        (
            "λ = 0.523 for β = 1000, 0.415 for β = 500",
            f"λ = {lambdas[1000]:.3f} and {lambdas[500]:.3f}",
        ),
        (
            "asperities out of contact raise μ at a given load, most at the smallest load",
            f"for β = 1000 the increase {_falls(curves.attraction_effect(1000))}, for β = 500 it "
            f"{_falls(curves.attraction_effect(500))}",
        ),
        (
            "at most 2.1 % for λ = 0.523, 3.8 % for λ = 0.415",
            f"2.1 % at load {_number(loads[1000])} and 3.8 % at load {_number(loads[500])}, more at lighter loads; "
            f"{_where(grows, 'it is larger for the smaller λ')}",
        ),
        ("no effect for λ > 0.655", _above_the_limit()),
    ]
    return f"""\
## Figure 3: asperities out of contact

![Friction with and without attraction of asperities out of contact](../figures/figure-3.svg)

[The curves as CSV](../figures/figure-3.csv)

{_table(claims)}

Increase of μ in per cent:

| β | λ | {_heads(_SHOWN)} |
|---|---|{'---|' * _SHOWN.size}
{chr(10).join(rows)}

Both percentages are met, at loads that differ by a factor of {loads[500] / loads[1000]:.0f}. The paper gives them for
the smallest applied load; it does not say which that is, nor whether it is the same for both."""


def _load_of_effect(beta: float, percent: float) -> float:
    """Where the effect, which falls with load, is so many per cent: by bisection."""
    light, heavy = 1e-6, 1e6
    while heavy / light > 1 + 1e-9:
        middle = math.sqrt(light * heavy)
        if curves.attraction_effect(beta, np.array([middle]))[0] > percent:
            light = middle
        else:
            heavy = middle
    return light


def _above_the_limit() -> str:
    """The largest effect just below and just above the limit of lambda, with beta = 1000."""

    def largest(wanted: float) -> str:
        gamma = math.sqrt(wanted**3 * 2 * math.pi * 0.01 / (9 * 1000))
        return f"{_number(np.abs(curves.attraction_effect(1000, gamma=gamma)).max())} % for λ = {wanted}"

    return f"with β = 1000 and a larger γ at most {largest(0.65)} and {largest(0.66)}, at all loads"


# ---- Figures 4 to 7 ----


def _skew_figure(figure: CurveFigure) -> str:
    *weibull, gaussian = [friction(curve.params) for curve in figure.curves]
    falls = [float(mu[0] - mu[-1]) for mu in weibull]
    claims = [
        (
            "positive skew lowers, negative skew raises μ",
            _where(_descending(weibull), "μ falls from each skew to the next larger one"),
        ),
        (
            "and its variation with load",
            f"μ falls from load {LIGHTEST:g} to {HEAVIEST:g} by {_list(falls)} for skew {_list(curves.SKEWS)}",
        ),
        *_SKEW_CLAIMS[figure.number](figure),
    ]
    alpha, beta, gamma = figure.groups
    rows = [f"| {_plain(curve.label)} | {_cells(friction(curve.params, _SHOWN), '.4g')} |" for curve in figure.curves]
    return f"""\
## Figure {figure.number}: skew, α = {alpha:g}, β = {beta:g}, γ = {gamma:g}

![Friction for skews from -1 to 1](../figures/figure-{figure.number}.svg)

[The curves as CSV](../figures/figure-{figure.number}.csv)

{_table(claims)}

| μ at load | {_heads(_SHOWN)} |
|---|{'---|' * _SHOWN.size}
{chr(10).join(rows)}"""


def _gaussian_and_no_skew(figure: CurveFigure) -> list[tuple[str, str]]:
    loads = np.array([1.0, 100.0, 1e4, 1e5])
    no_skew, gaussian = friction(figure.curves[2].params, loads), friction(figure.curves[-1].params, loads)
    differences = [f"{_number(100 * (a / b - 1))} % at {load:g}" for a, b, load in zip(no_skew, gaussian, loads)]
    claim = "Gaussian and zero-skew Weibull heights differ at light loads"
    return [(claim, f"μ of zero skew is above that of the Gaussian by {', '.join(differences)}")]


def _smoother(figure: CurveFigure) -> list[tuple[str, str]]:
    def spread(of: CurveFigure) -> Array:
        return friction(of.curves[0].params) - friction(of.curves[4].params)

    smooth, rough = spread(figure), spread(curves.SKEW_FIGURES[0])
    found = _where(smooth > rough, "μ(skew −1) − μ(skew 1) is larger than in figure 4")
    return [("the smoother surface shows a greater effect of skew", f"{found}: {_pair(smooth)} against {_pair(rough)}")]


def _smaller_beta(figure: CurveFigure) -> list[tuple[str, str]]:
    def gain(index: int) -> Array:
        return friction(figure.curves[index].params) / friction(curves.SKEW_FIGURES[0].curves[index].params)

    gaussian, negative = gain(5), gain(0)
    return [
        (
            "a smaller β raises the friction of Gaussian heights",
            f"{_where(gaussian > 1, 'μ is larger than in figure 4')}: by the factor {_pair(gaussian)}",
        ),
        (
            "this effect of β falls as skew decreases to −1",
            f"{_where(negative < gaussian, 'the factor for skew −1 is below that of the Gaussian')}: it is "
            f"{_pair(negative)}. At lighter loads adhesion alone holds the surfaces of skew −1 together, more so for "
            "the smaller β, and the text does not apply",
        ),
    ]


def _more_energy(figure: CurveFigure) -> list[tuple[str, str]]:
    gains = [
        friction(ours.params) / friction(theirs.params)
        for ours, theirs in zip(figure.curves, curves.SKEW_FIGURES[0].curves)
    ]
    middle = LOADS.size // 2
    found = _where(np.min(gains, axis=0) > 1, "μ is larger than in figure 4 for every curve")
    factors = _list([float(gain[middle]) for gain in gains[:5]])
    return [
        (
            "more surface energy raises friction for positive and negative skew",
            f"{found}: at load {_number(LOADS[middle])} by the factors {factors} for skew {_list(curves.SKEWS)}",
        )
    ]


_SKEW_CLAIMS: dict[int, Callable[[CurveFigure], list[tuple[str, str]]]] = {
    4: _gaussian_and_no_skew,
    5: _smoother,
    6: _smaller_beta,
    7: _more_energy,
}


# ---- Figures 8 to 10 ----


def _radius_figure(figure: CurveFigure) -> str:
    all_mu = [friction(curve.params) for curve in figure.curves]
    falls = [float(mu[0] - mu[-1]) for mu in all_mu]
    spread = all_mu[0] - all_mu[-1]
    claims = [
        (
            "friction is highest for ε = 1 and lowest for ε = −0.95",
            _where(_descending(all_mu), "μ falls from each ε to the next smaller one"),
        ),
        (
            "and so is its dependence on load, which ε = −0.95 reduces dramatically",
            f"μ falls from load {LIGHTEST:g} to {HEAVIEST:g} by {_list(falls)} for ε = {_list(curves.AMPLITUDES)}; "
            f"for ε = −0.95 that is {100 * falls[-1] / falls[2]:.0f} % of the fall for ε = 0",
        ),
        (
            "less so for larger loads",
            f"μ(ε = 1) − μ(ε = −0.95) is {_pair(spread)}, and {_falls(spread)}",
        ),
    ]
    if figure.number != 8:
        other = [friction(curve.params) for curve in curves.RADIUS_FIGURES[0].curves]
        reference = other[0] - other[-1]
        cause = "β" if figure.number == 9 else "α"
        found = _where(spread < reference, "that difference is smaller than in figure 8")
        claims.append((f"less so for a larger {cause}", f"{found}: there it is {_pair(reference)}"))
    alpha, beta, gamma = figure.groups
    rows = [f"| {_plain(curve.label)} | {_cells(friction(curve.params, _SHOWN), '.4g')} |" for curve in figure.curves]
    return f"""\
## Figure {figure.number}: radii that vary with height, α = {alpha:g}, β = {beta:g}, γ = {gamma:g}

![Friction for radii that grow or shrink with height](../figures/figure-{figure.number}.svg)

[The curves as CSV](../figures/figure-{figure.number}.csv)

{_table(claims)}

| μ at load | {_heads(_SHOWN)} |
|---|{'---|' * _SHOWN.size}
{chr(10).join(rows)}"""


# ---- Beyond the paper ----


def _kurtosis() -> str:
    *johnson, _ = [friction(curve.params) for curve in curves.KURTOSIS_CURVES]
    skewed = [friction(curve.params) for curve in curves.SKEW_FIGURES[0].curves]
    rising = [f"{kurtosis:g} ({_pair(mu)})" for kurtosis, mu in zip(curves.KURTOSES, johnson) if mu[-1] > mu[0]]
    claims = [
        (
            "skew and kurtosis cannot be varied independently with a Weibull distribution",
            "with Johnson's they can: all heights of the upper panel have skew 0",
        ),
        (
            "says nothing of kurtosis alone",
            f"{_where(_descending(johnson), 'μ falls from each kurtosis to the next larger one')}; at load "
            f"{LIGHTEST:g} by the factor {_number(johnson[0][0] / johnson[-1][0])} from kurtosis "
            f"{curves.KURTOSES[0]:g} to {curves.KURTOSES[-1]:g}, while from skew −1 to 1 in figure 4 it is "
            f"{_number(skewed[0][0] / skewed[4][0])}",
        ),
        (
            "friction falls with load",
            f"not so for kurtosis {' and '.join(rising)}: a few asperities far above the rest carry the light loads",
        ),
    ]
    shown = curves.KURTOSIS_CURVES
    rows = [f"| {_plain(curve.label)} | {_cells(friction(curve.params, _SHOWN), '.4g')} |" for curve in shown]
    pairs = [_same_moments(skew) for skew in curves.SKEWS]
    return f"""\
## Kurtosis at fixed skew: what Weibull heights cannot show

![Friction for kurtoses from 2 to 6 at skew 0, and over the kurtosis](../figures/kurtosis.svg)

[The curves as CSV](../figures/kurtosis.csv)

{_table(claims)}

| μ at load | {_heads(_SHOWN)} |
|---|{'---|' * _SHOWN.size}
{chr(10).join(rows)}

Kurtosis 3 with skew 0 is the Gaussian. But four moments do not fix a distribution, and light loads rest on its far end:
Johnson's heights with skew and kurtosis of the Weibull heights of figure 4 give another μ, by these per cent:

| Skew | Kurtosis | {_heads(_SHOWN)} |
|---|---|{'---|' * _SHOWN.size}
{chr(10).join(pairs)}

In the lower panel the curves for the skews −0.5 and 0.5 have a kink at kurtosis {_lognormal_kurtosis(0.5):.3f}. There
Johnson's heights are lognormal, and depart from that in different ways to either side: they are bounded at both ends
for smaller kurtosis, at none for larger."""


def _same_moments(skew: float) -> str:
    weibull = surface(*curves.DEFAULT, skew=skew)
    kurtosis = model(weibull).summary().kurtosis
    johnson = surface(*curves.DEFAULT, skew=skew, kurtosis=kurtosis)
    difference = 100 * (friction(johnson, _SHOWN) / friction(weibull, _SHOWN) - 1)
    return f"| {_number(skew)} | {kurtosis:.3f} | {_cells(difference, '.1f').replace('-', '−')} |"


def _lognormal_kurtosis(skew: float) -> float:
    """With w = exp(variance of the logarithm): skew^2 = (w - 1)(w + 2)^2, kurtosis = w^4 + 2 w^3 + 3 w^2 - 3."""
    w = max(root.real for root in np.roots([1, 3, 0, -4 - skew**2]))
    return float(w**4 + 2 * w**3 + 3 * w**2 - 3)


def _regimes() -> str:
    rows = []
    for beta in curves.REGIME_BETAS:
        summary = model(surface(0.01, beta, curves.REGIME_GAMMA)).summary()
        below, between, above = curves.regimes(beta, _REGIME_SHOWN)
        for name, fractions in (("a < a₁", below), ("a₁ < a < a₂", between), ("a > a₂", above)):
            rows.append(f"| {_number(beta)} | {summary.lambda_:.3f} | {name} | {_cells(fractions, '.4f')} |")
    heads = " | ".join(f"P = {load:g}" for load in _REGIME_SHOWN)
    return f"""\
## Regimes of slip

![Fractions of the contacts in the regimes of slip, over the load](../figures/regimes.svg)

[The curves as CSV](../figures/regimes.csv)

A contact of radius below a₁ = 28 b slips as a whole, at the largest shear strength; above a₂ = 80000 b the strength is
30 times smaller; between it falls with the radius. β decides where a surface is, since β b is the radius of a contact
that overlaps by σ without adhesion. Fractions of the contacts, with α = 0.01 and γ = {curves.REGIME_GAMMA:g}, at loads
in N G b² αβ²:

| β | λ | Radius | {heads} |
|---|---|---|{'---|' * _REGIME_SHOWN.size}
{chr(10).join(rows)}"""


def _yield() -> str:
    rows = []
    for index in curves.YIELD_INDICES:
        for name, fractions in zip(("elastic", "elastic-plastic", "flowing"), curves.yields(index, _REGIME_SHOWN)):
            rows.append(f"| {_number(index)} | {name} | {_cells(fractions, '.4f')} |")
    heads = " | ".join(f"P = {load:g}" for load in _REGIME_SHOWN)
    return f"""\
## Regimes of yield

![Fractions of elastic, elastic-plastic and flowing contacts, over the load](../figures/yield.svg)

[The curves as CSV](../figures/yield.csv)

Asperities that yield ([model.md](../model.md#asperities-that-yield-zhao-maietta-and-chang)), for three plasticity indices ψ =
(E*/H)(σ/R)^½. ψ decides, more than the load, until most asperities touch: heavier loads bring more contacts of all sizes.
Fractions of the contacts, with α = 0.01 and β = 1000, at loads in N G b² αβ²:

| ψ | Contacts | {heads} |
|---|---|{'---|' * _REGIME_SHOWN.size}
{chr(10).join(rows)}"""


def _microslip() -> str:
    shown = np.array([0.25, 0.5, 1.0, 2.0, 3.0])
    forces = [
        f"| {_plain(curve.label)} | {_cells(curves.microslip(curve.params, shown), '.4f')} |"
        for curve in curves.MICROSLIP_SURFACES
    ]
    first, *_ = curves.MICROSLIP_SURFACES
    works = [
        f"| {amplitude:g} | {curves.loop(first.params, amplitude)[2]:.4f} | {max(0.0, 4 * (amplitude - 1)):.4f} |"
        for amplitude in curves.MICROSLIP_AMPLITUDES
    ]
    heads = " | ".join(f"δ = {displacement:g}" for displacement in shown)
    return f"""\
## Microslip

![Tangential force over the displacement, and loops of hysteresis](../figures/microslip.svg)

[The curves as CSV](../figures/microslip.csv)

Contacts begin with the stiffness 8 Ĝ a and slip from their rims inwards until their force is their strength: those whose strength
over radius is least, small ones, slip first ([model.md](../model.md#before-a-contact-slips-stiffness-and-microslip)). T/F at displacements in F/K_t, at load
{curves.MICROSLIP_LOAD:g}:

| T/F | {heads} |
|---|{'---|' * shown.size}
{chr(10).join(forces)}

The lower panel has loops between the displacements ±A of the first surface. The table compares the work of a cycle, in F²/K_t, with that
of asperities that all slip at the same displacement, 4 (A − 1) for A > 1:

| A | Work | Of equal asperities that slip as a whole |
|---|---|---|
{chr(10).join(works)}"""


# ---- Words and cells ----


def _descending(rows: Sequence[Array]) -> Mask:
    """At which loads each row is above the next."""
    below: Mask = (np.diff(np.array(rows), axis=0) < 0).min(axis=0)
    return below


def _falls(values: Array) -> str:
    return "falls with load at all loads" if (np.diff(values) < 0).all() else "does not fall at all loads"


def _where(holds: Mask, claim: str) -> str:
    """A claim with the loads of the figure where it holds."""
    if holds.all():
        return f"at all loads {claim}"
    if not holds.any():
        return f"at no load {claim}"
    first, last = np.flatnonzero(holds)[[0, -1]]
    if not holds[first : last + 1].all():
        return f"at some loads only {claim}"
    return f"from load {_number(LOADS[first])} to {_number(LOADS[last])} {claim}"


def _pair(values: Array) -> str:
    return f"{_number(values[0])} at load {LIGHTEST:g} and {_number(values[-1])} at {HEAVIEST:g}"


def _list(numbers: Sequence[float]) -> str:
    return ", ".join(map(_number, numbers))


def _number(number: float) -> str:
    """Three digits, and no exponent where these numbers need none."""
    return f"{float(f'{number:.3g}'):g}".replace("-", "−")


def _table(claims: Sequence[tuple[str, str]]) -> str:
    rows = [f"| {paper} | {here} |" for paper, here in claims]
    return "\n".join(["| The paper | Here |", "|---|---|", *rows])


def _cells(values: Array, form: str) -> str:
    return " | ".join(format(float(value), form) for value in values)


def _heads(loads: Array) -> str:
    return " | ".join(f"P = {load:g}" for load in loads)


def _plain(label: str) -> str:
    letters = (("\\varepsilon", "ε"), ("\\beta", "β"), ("\\psi", "ψ"))
    for symbol, word in (("$", ""), *letters, ("S =", "skew"), ("K =", "kurtosis"), ("-", "−")):
        label = label.replace(symbol, word)
    return label
