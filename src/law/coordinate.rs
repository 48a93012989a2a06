//! The coordinate of the curve, s = arsinh((x/|pull-off|)^(1/2)) with x = load - pull-off: near pull-off, where load has its
//! minimum over separation, it is linear in separation, far from it logarithmic in load. Without a pull-off load that counts it is
//! ln(x)/2.

use crate::numerics::elementary::{exp, exp_each, log, log1p_each, sinh};

/// The coordinate of a branch.
#[derive(Debug, Clone, Copy)]
pub struct Coordinate {
    /// ln |pull-off load|, if there is one that counts.
    pub log_pull_off: Option<f64>,
    /// The pull-off load.
    pub pull_off: f64,
}

impl Coordinate {
    /// s and ds/d(ln x) at ln x.
    pub fn at(self, log_excess: f64) -> (f64, f64) {
        self.at_each([log_excess])[0]
    }

    /// The same at each of several.
    pub fn at_each<const N: usize>(self, log_excess: [f64; N]) -> [(f64, f64); N] {
        let Some(log_pull_off) = self.log_pull_off else {
            return log_excess.map(|log_excess| (0.5 * log_excess, 0.5));
        };
        let sinh = exp_each(log_excess.map(|log_excess| 0.5 * (log_excess - log_pull_off)));
        let cosh = sinh.map(|sinh| (1.0 + sinh * sinh).sqrt());
        let s: [f64; N] = log1p_each(std::array::from_fn(|i| sinh[i] + sinh[i] * sinh[i] / (1.0 + cosh[i])));
        std::array::from_fn(|i| (s[i], 0.5 * sinh[i] / cosh[i]))
    }

    /// The load and its slope by s.
    pub fn load(self, s: f64) -> (f64, f64) {
        if self.log_pull_off.is_none() {
            let excess = exp(2.0 * s);
            return (excess + self.pull_off, 2.0 * excess);
        }
        let sinh = sinh(s);
        (self.pull_off * (1.0 - sinh * sinh), -2.0 * self.pull_off * sinh * (1.0 + sinh * sinh).sqrt())
    }

    /// What the load changes by with s, relative to it or to the pull-off load, whichever is larger.
    pub fn load_by_s(self, s: f64) -> f64 {
        let (load, slope) = self.load(s);
        slope / load.abs().max(-self.pull_off)
    }

    /// ln x at s.
    pub fn log_excess(self, s: f64) -> f64 {
        self.log_pull_off.map_or(2.0 * s, |log_pull_off| 2.0 * log(sinh(s)) + log_pull_off)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::near;

    #[test]
    fn the_coordinate_is_arsinh_of_the_root_of_load_over_pull_off() {
        let coordinate = Coordinate { log_pull_off: Some(-7.0), pull_off: -exp(-7.0) };
        for log_excess in [-40.0, -20.0, -7.0, -3.0, -1.01, -0.99, 0.3, 2.0, 5.0, 10.0, 30.0, 60.0, 200.0] {
            let (s, rate) = coordinate.at(log_excess);
            let root = (0.5 * (log_excess + 7.0)).exp();
            assert!(near(s, root.asinh(), 1e-14), "{log_excess}: {s}");
            assert!(near(rate, 0.5 * root / root.hypot(1.0), 1e-14), "{log_excess}: {rate}");
            let pull_off = (-7_f64).exp();
            let (load, by_s) = coordinate.load(s);
            assert!((load - (log_excess.exp() - pull_off)).abs() <= 1e-12 * load.abs().max(pull_off), "{load}");
            assert!(near(by_s, log_excess.exp() / rate, 1e-12), "{by_s}");
            assert!(near(coordinate.log_excess(s), log_excess, 1e-13));
        }
        let none = Coordinate { log_pull_off: None, pull_off: -1e-5 };
        assert_eq!(none.at(-8.0), (-4.0, 0.5));
        assert_eq!(none.load(-4.0), (exp(-8.0) - 1e-5, 2.0 * exp(-8.0)));
    }
}
