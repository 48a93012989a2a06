//! Gauss-Legendre quadrature with 16 points, exact for polynomials of degree 31, and with fewer on short panels.

/// Points per panel.
pub const POINTS: usize = 16;

/// The positive abscissae on [-1, 1] with their weights: roots of the Legendre polynomial P_16.
#[allow(clippy::excessive_precision)]
pub(super) const HALF: [(f64, f64); POINTS / 2] = [
    (0.095012509837637440185, 0.18945061045506849629),
    (0.28160355077925891323, 0.18260341504492358887),
    (0.45801677765722738634, 0.16915651939500253819),
    (0.61787624440264374845, 0.14959598881657673208),
    (0.7554044083550030339, 0.12462897125553387205),
    (0.86563120238783174388, 0.09515851168249278481),
    (0.94457502307323257608, 0.062253523938647892863),
    (0.9894009349916499326, 0.027152459411754094852),
];

/// The same for 10 points and for 6.
#[allow(clippy::excessive_precision)]
const HALF_OF_10: [(f64, f64); 5] = [
    (0.14887433898163121088, 0.29552422471475287017),
    (0.4333953941292471908, 0.26926671930999635509),
    (0.67940956829902440623, 0.219086362515982044),
    (0.86506336668898451073, 0.14945134915058059315),
    (0.97390652851717172008, 0.066671344308688137594),
];
#[allow(clippy::excessive_precision)]
const HALF_OF_6: [(f64, f64); 3] = [
    (0.23861918608319690863, 0.46791393457269104739),
    (0.66120938646626451366, 0.36076157304813860757),
    (0.93246951420315202781, 0.17132449237917034504),
];
const HALF_OF_4: [(f64, f64); 2] =
    [(0.339_981_043_584_856_26, 0.652_145_154_862_546_1), (0.861_136_311_594_052_6, 0.347_854_845_137_453_85)];

/// The abscissae and weights of the rule on the interval from `a` to `b` (weights are positive also if b < a).
#[inline]
pub fn nodes(a: f64, b: f64) -> impl Iterator<Item = (f64, f64)> {
    on(&HALF, a, b)
}

/// The same, all at once.
#[inline]
pub fn panel(a: f64, b: f64) -> [(f64, f64); POINTS] {
    points(a, b)
}

/// The same with N points: 4, 6 or 16.
#[inline]
pub fn points<const N: usize>(a: f64, b: f64) -> [(f64, f64); N] {
    let half: &[(f64, f64)] = match N {
        4 => &HALF_OF_4,
        6 => &HALF_OF_6,
        _ => &HALF,
    };
    let mut nodes = on(half, a, b);
    std::array::from_fn(|_| nodes.next().unwrap_or_default())
}

/// As [`nodes`], with fewer points where the panel is but a `part` of one that 16 points are enough for: the error is
/// about (part/4)^(2 points), and (part/4)^(2 points - k) where what is summed begins as a power k of the distance: 7 for loads of
/// contacts with the last summits before the highest.
#[inline]
pub fn nodes_of_part(part: f64, a: f64, b: f64) -> impl Iterator<Item = (f64, f64)> {
    let half: &[(f64, f64)] = match part {
        _ if part < 0.02 => &HALF_OF_6,
        _ if part < 0.35 => &HALF_OF_10,
        _ => &HALF,
    };
    on(half, a, b)
}

#[inline]
fn on(positive: &'static [(f64, f64)], a: f64, b: f64) -> impl Iterator<Item = (f64, f64)> {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let width = half.abs();
    positive
        .iter()
        .rev()
        .map(move |&(x, w)| (middle - half * x, width * w))
        .chain(positive.iter().map(move |&(x, w)| (middle + half * x, width * w)))
}

/// The integral from `a` to `b` of a function so smooth between them that 4 points give it to rounding.
pub fn integrate_short(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    on(&HALF_OF_4, a, b).map(|(x, weight)| weight.copysign(b - a) * f(x)).sum()
}

#[cfg(test)]
mod tests {
    use super::nodes;

    #[test]
    fn polynomials_of_degree_31_are_exact() {
        for degree in [0, 1, 15, 31] {
            let sum: f64 = nodes(0.0, 2.0).map(|(x, w)| w * x.powi(degree)).sum();
            let exact = 2f64.powi(degree + 1) / f64::from(degree + 1);
            assert!((sum / exact - 1.0).abs() < 1e-14, "degree {degree}");
        }
        let sum_32: f64 = nodes(-1.0, 1.0).map(|(x, w)| w * x.powi(32)).sum();
        assert!((sum_32 * 16.5 - 1.0).abs() > 1e-13);
    }
}
