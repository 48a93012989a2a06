//! Weibull heights, eqs (18)-(21): standardised to mean 0 and standard deviation 1, so that the shape
//! omega alone remains, and with it skew and kurtosis together.

use crate::elementary::{exp, exp_each, expm1, lgamma, log, log1p, pow};
use crate::root;

/// The smallest and largest shape the library evaluates: below 1 the density has a pole at its foot.
pub const SHAPE_RANGE: (f64, f64) = (1.0, 1e6);

/// The skew of a Weibull distribution as omega -> infinity: -12 sqrt(6) zeta(3) / pi^3.
pub const SKEW_LIMIT: f64 = -1.139_547_099_404_648_7;

/// A standardised Weibull distribution.
#[derive(Debug, Clone, PartialEq)]
pub struct Weibull {
    shape: f64,
    /// ln B_1 = ln Gamma(1 + 1/omega).
    ln_b1: f64,
    /// z_M = B_1 / C of eq (20): the support begins at -z_M.
    mean: f64,
    /// ln(omega / z_M).
    ln_shape_over_mean: f64,
    skew: f64,
    kurtosis: f64,
}

impl Weibull {
    /// The distribution of shape omega, which must lie in [`SHAPE_RANGE`].
    pub fn new(shape: f64) -> Self {
        let x = 1.0 / shape;
        // Central moments over B_1^n, from e_n = B_n / B_1^n - 1.
        let e = |n: i32| expm1(ln_moment_ratio(n, x));
        let variance = e(2);
        let (third, fourth) = if x <= 0.125 {
            // The leading terms of e_n cancel for small x: cancel them in the series.
            let excess = |n: i32| exp_m1_minus(ln_moment_ratio(n, x));
            (
                series(x, |j| powi(3, j) - 3.0 * powi(2, j) + 3.0) + excess(3) - 3.0 * excess(2),
                series(x, |j| powi(4, j) - 4.0 * powi(3, j) + 6.0 * powi(2, j) - 4.0) + excess(4) - 4.0 * excess(3)
                    + 6.0 * excess(2),
            )
        } else {
            (e(3) - 3.0 * e(2), e(4) - 4.0 * e(3) + 6.0 * e(2))
        };
        let mean = 1.0 / variance.sqrt();
        Self {
            shape,
            ln_b1: ln_gamma_1p(x),
            mean,
            ln_shape_over_mean: log(shape / mean),
            skew: third / pow(variance, 1.5),
            kurtosis: fourth / (variance * variance),
        }
    }

    /// The shape whose skew this is; `None` outside what [`SHAPE_RANGE`] covers.
    pub fn shape_of_skew(skew: f64) -> Option<f64> {
        let (smallest, largest) = SHAPE_RANGE;
        let residual = |ln_shape: f64| Self::new(exp(ln_shape)).skew - skew;
        let (lower, upper) = (log(smallest), log(largest));
        if residual(lower) < -1e-12 || residual(upper) > 1e-12 {
            return None;
        }
        Some(exp(root::bracketed(residual, lower, upper)).clamp(smallest, largest))
    }

    /// omega.
    pub fn shape(&self) -> f64 {
        self.shape
    }

    /// z_M of eq (20), the mean above the foot of the distribution.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Skew, eq (21).
    pub fn skew(&self) -> f64 {
        self.skew
    }

    /// Kurtosis, eq (21).
    pub fn kurtosis(&self) -> f64 {
        self.kurtosis
    }

    /// ln phi and d(ln phi)/dz at z; z must lie above the foot.
    #[inline]
    pub fn log_density(&self, z: f64) -> (f64, f64) {
        let ([log_density], [hazard]) = self.log_density_and_hazard([z]);
        (log_density, (self.shape - 1.0 - self.shape * hazard) / (z + self.mean))
    }

    /// ln phi and the cumulative hazard at each of several heights above the foot.
    #[inline]
    pub fn log_density_and_hazard<const N: usize>(&self, heights: [f64; N]) -> ([f64; N], [f64; N]) {
        let relative = heights.map(|z| log1p(z / self.mean));
        // t = ln (C y)^omega with y = z + z_M
        let t = relative.map(|relative| self.shape * (self.ln_b1 + relative));
        let hazard = exp_each(t.map(|t| t.min(600.0)));
        (std::array::from_fn(|i| self.ln_shape_over_mean + t[i] - relative[i] - hazard[i]), hazard)
    }

    /// The cumulative hazard (C y)^omega at z.
    pub fn hazard(&self, z: f64) -> f64 {
        let relative = (z / self.mean).max(-1.0);
        if relative <= -1.0 {
            return 0.0;
        }
        exp((self.shape * (self.ln_b1 + log1p(relative))).min(600.0))
    }

    /// The height of a given cumulative hazard.
    pub fn height_of_hazard(&self, hazard: f64) -> f64 {
        self.mean * expm1(log(hazard) / self.shape - self.ln_b1)
    }
}

/// zeta(j) - 1 for j = 2, 3, ...
#[allow(clippy::excessive_precision)]
const ZETA_MINUS_1: [f64; 54] = [
    0.64493406684822643647,
    0.2020569031595942854,
    0.082323233711138191516,
    0.036927755143369926331,
    0.017343061984449139715,
    0.0083492773819228268398,
    0.0040773561979443393787,
    0.0020083928260822144179,
    0.00099457512781808533715,
    0.0004941886041194645587,
    0.00024608655330804829864,
    0.00012271334757848914675,
    0.000061248135058704829259,
    0.000030588236307020493552,
    0.000015282259408651871733,
    7.6371976378997622736e-6,
    3.8172932649998398565e-6,
    1.9082127165539389257e-6,
    9.5396203387279611315e-7,
    4.7693298678780646312e-7,
    2.3845050272773299e-7,
    1.1921992596531107307e-7,
    5.9608189051259479612e-8,
    2.9803503514652280186e-8,
    1.4901554828365041235e-8,
    7.450711789835429492e-9,
    3.7253340247884570548e-9,
    1.8626597235130490064e-9,
    9.3132743241966818287e-10,
    4.656629065033784073e-10,
    2.328311833676505492e-10,
    1.1641550172700519776e-10,
    5.8207720879027008893e-11,
    2.9103850444970996869e-11,
    1.4551921891041984236e-11,
    7.2759598350574810145e-12,
    3.6379795473786511902e-12,
    1.8189896503070659477e-12,
    9.0949478402638892829e-13,
    4.547473783042154027e-13,
    2.2737368458246525151e-13,
    1.1368684076802278492e-13,
    5.6843419876275856141e-14,
    2.8421709768893018463e-14,
    1.4210854828031606744e-14,
    7.1054273952108527052e-15,
    3.5527136913371137367e-15,
    1.7763568435791204144e-15,
    8.8817842109308161928e-16,
    4.4408921031438141182e-16,
    2.2204460507980423997e-16,
    1.110223025141065656e-16,
    5.551115124845479754e-17,
    2.7755575621361171278e-17,
];

fn powi(base: i32, exponent: usize) -> f64 {
    f64::from(base).powi(exponent as i32)
}

/// The sum over j >= 2 of (-1)^j zeta(j)/j c(j) x^j, to which ln Gamma(1 + n x) contributes c(j) = n^j.
fn series(x: f64, c: impl Fn(usize) -> f64) -> f64 {
    let mut sum = 0.0;
    for (i, zeta_minus_1) in ZETA_MINUS_1.iter().enumerate().rev() {
        let j = i + 2;
        let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
        sum += sign * (1.0 + zeta_minus_1) / j as f64 * c(j) * x.powi(j as i32);
    }
    sum
}

/// exp(x) - 1 - x for |x| < 0.5.
fn exp_m1_minus(x: f64) -> f64 {
    let mut sum = 0.0;
    for k in (2..20).rev() {
        sum = (sum * x + 1.0) / f64::from(k);
    }
    sum * x * x
}

/// ln(B_n / B_1^n) = ln Gamma(1 + n x) - n ln Gamma(1 + x), without cancellation for small x.
fn ln_moment_ratio(n: i32, x: f64) -> f64 {
    let n_float = f64::from(n);
    if n_float * x <= 0.5 {
        return series(x, |j| powi(n, j) - n_float);
    }
    ln_gamma_1p(n_float * x) - n_float * ln_gamma_1p(x)
}

/// ln Gamma(1 + x), x >= 0.
fn ln_gamma_1p(x: f64) -> f64 {
    if x > 1.0 {
        return lgamma(1.0 + x);
    }
    // zeta(j) = 1 + (zeta(j) - 1): the ones sum to x - ln(1 + x), the rest converges for |x| < 2.
    const ONE_MINUS_EULER: f64 = 0.422_784_335_098_467_13;
    let mut sum = 0.0;
    for (i, zeta_minus_1) in ZETA_MINUS_1.iter().enumerate().rev() {
        let j = (i + 2) as f64;
        sum = -x * sum + zeta_minus_1 / j;
    }
    x * ONE_MINUS_EULER - log1p(x) + x * x * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table 1 of Adams and Muftu (2005); the last digits of 6.340 and 2.716 are the paper's rounding.
    #[test]
    fn moments_reproduce_table_1() {
        let table = [
            (40.74, 32.32, -1.0, 4.773),
            (7.493, 6.340, -0.5, 3.258),
            (3.602, 3.243, 0.0, 2.716),
            (2.216, 2.098, 0.5, 3.028),
            (1.564, 1.530, 1.0, 4.159),
        ];
        for (shape, mean, skew, kurtosis) in table {
            let w = Weibull::new(shape);
            assert!((w.mean() / mean - 1.0).abs() < 5e-4, "mean {} at {shape}", w.mean());
            assert!((w.skew() - skew).abs() < 6e-4, "skew {} at {shape}", w.skew());
            assert!((w.kurtosis() - kurtosis).abs() < 1e-3, "kurtosis {} at {shape}", w.kurtosis());
        }
    }

    fn near(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance * b.abs()
    }

    /// Gamma(1 + n/omega) is (n/omega)!; the limit of large omega is Gumbel's distribution.
    #[test]
    fn moments_are_those_of_factorials_and_of_the_limit() {
        let root_pi = std::f64::consts::PI.sqrt();
        for (shape, factorials) in [(1.0, [1.0, 2.0, 6.0, 24.0]), (2.0, [0.5 * root_pi, 1.0, 0.75 * root_pi, 2.0])] {
            let [b1, b2, b3, b4]: [f64; 4] = factorials;
            let variance = b2 - b1 * b1;
            let third = b3 - 3.0 * b1 * b2 + 2.0 * b1 * b1 * b1;
            let fourth = b4 - 4.0 * b1 * b3 + 6.0 * b1 * b1 * b2 - 3.0 * b1.powi(4);
            let w = Weibull::new(shape);
            assert!(near(w.mean(), b1 / variance.sqrt(), 1e-13), "{shape}: {}", w.mean());
            assert!(near(w.skew(), third / variance.powf(1.5), 1e-13), "{shape}: {}", w.skew());
            assert!(near(w.kurtosis(), fourth / (variance * variance), 1e-13), "{shape}: {}", w.kurtosis());
        }
        let limit = Weibull::new(1e6);
        assert!(near(limit.skew(), SKEW_LIMIT, 1e-5) && near(limit.kurtosis(), 5.4, 1e-5));
        // mean sqrt(6)/pi omega of Gumbel's standard deviation pi/(sqrt(6) omega).
        assert!(near(limit.mean(), 1e6 * 6.0_f64.sqrt() / std::f64::consts::PI, 1e-5), "{}", limit.mean());
        for shape in [8.0, 2.0, 1.0] {
            // Where one formula takes over from another.
            let (a, b) = (Weibull::new(shape * (1.0 - 1e-14)), Weibull::new(shape * (1.0 + 1e-14)));
            assert!(near(a.skew(), b.skew(), 1e-10) && near(a.kurtosis(), b.kurtosis(), 1e-10), "{a:?}, {b:?}");
        }
        // Their first terms, where x is small.
        for n in [2_i32, 3, 4] {
            let x = 1e-6_f64;
            let c = |j: i32| f64::from(n.pow(j as u32) - n);
            let [second, third, fourth] = [1.644_934_066_848_226_4, 1.202_056_903_159_594, 1.082_323_233_711_138];
            let expected = x * x * (second / 2.0 * c(2) - x * (third / 3.0 * c(3) - x * fourth / 4.0 * c(4)));
            assert!(near(ln_moment_ratio(n, x), expected, 1e-15), "{n}");
        }
        for x in [0.0, 1e-9, 0.1, 0.5, 0.99, 1.0, 1.01, 3.0] {
            assert!((ln_gamma_1p(x) - lgamma(1.0 + x)).abs() < 1e-13, "{x}");
        }
    }

    #[test]
    fn density_and_hazard_belong_together() {
        for shape in [1.0, 1.5, 3.602, 40.0, 1e5] {
            let w = Weibull::new(shape);
            for hazard in [1e-6, 0.1, 1.0, 5.0, 30.0, 500.0] {
                let z = w.height_of_hazard(hazard);
                assert!(near(w.hazard(z), hazard, 1e-9), "{shape}: {} of {hazard}", w.hazard(z));
                // What exceeds z is exp(-hazard): its slope is the density.
                let step = 1e-5 * (z + w.mean()) / shape;
                let rate = (w.hazard(z + step) - w.hazard(z - step)) / (2.0 * step);
                let (log_density, slope) = w.log_density(z);
                assert!((log_density - (rate.ln() - hazard)).abs() < 1e-6, "{shape}: {log_density}");
                let secant = (w.log_density(z + step).0 - w.log_density(z - step).0) / (2.0 * step);
                assert!(
                    (slope - secant).abs() <= 1e-5 * (slope.abs() + (shape * hazard + 1.0) / (z + w.mean())),
                    "{slope}"
                );
            }
            assert_eq!([w.hazard(-w.mean()), w.hazard(-2.0 * w.mean())], [0.0; 2]);
        }
    }

    #[test]
    fn a_shape_is_that_of_its_skew() {
        for shape in [1.0, 1.3, 3.602, 40.0, 1e4] {
            let found = Weibull::shape_of_skew(Weibull::new(shape).skew()).expect("a shape");
            assert!(near(found, shape, 1e-12 * shape), "{found}, not {shape}");
        }
        assert_eq!(Weibull::shape_of_skew(2.0 + 1e-9), None);
        assert_eq!(Weibull::shape_of_skew(SKEW_LIMIT), None);
        // What rounds to the ends of the range is there.
        assert_eq!(Weibull::shape_of_skew(2.0 + 1e-13), Some(1.0));
    }
}
