//! The coordinate of the curve, s = arsinh((x/|pull-off|)^(1/2)) with x = load - pull-off: near pull-off, where load has its
//! minimum over separation, it is linear in separation, far from it logarithmic in load. Without adhesion it is ln(x)/2.

use crate::numerics::elementary::{exp, exp_each, log, log1p, sinh};
use std::f64::consts::LN_2;

/// Where ln(sinh s) is larger, so many terms of the series of ln((1 + (1 + y)^(1/2))/2) give it to rounding.
const FAR: f64 = 3.0;
const LOG_SINH_SERIES: [f64; 5] = [1.0 / 4.0, -3.0 / 32.0, 5.0 / 96.0, -35.0 / 1024.0, 63.0 / 2560.0];
/// The coordinate of a branch.
#[derive(Debug, Clone, Copy)]
pub struct Coordinate {
    /// ln |pull-off load|, if there is one.
    pub log_pull_off: Option<f64>,
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
        let log_sinh = log_excess.map(|log_excess| 0.5 * (log_excess - log_pull_off));
        if log_sinh.iter().all(|&log_sinh| log_sinh > FAR) {
            // s = ln 2 + ln(sinh s) + ln((1 + (1 + y)^(1/2))/2) with y = 1/sinh^2 s.
            let y = exp_each(log_sinh.map(|log_sinh| -2.0 * log_sinh));
            return std::array::from_fn(|i| {
                let y = y[i];
                let rest = y
                    * (LOG_SINH_SERIES[0]
                        + y * (LOG_SINH_SERIES[1]
                            + y * (LOG_SINH_SERIES[2] + y * (LOG_SINH_SERIES[3] + y * LOG_SINH_SERIES[4]))));
                (LN_2 + log_sinh[i] + rest, 0.5 / (1.0 + y).sqrt())
            });
        }
        exp_each(log_sinh).map(|sinh| {
            let cosh = (1.0 + sinh * sinh).sqrt();
            let s = if sinh > 1.0 { log(sinh + cosh) } else { log1p(sinh + sinh * sinh / (1.0 + cosh)) };
            (s, 0.5 * sinh / cosh)
        })
    }

    /// The load and its slope by s.
    pub fn load(self, s: f64) -> (f64, f64) {
        let Some(log_pull_off) = self.log_pull_off else {
            let load = exp(2.0 * s);
            return (load, 2.0 * load);
        };
        if s > 20.0 {
            // sinh^2 s is exp(2 s)/4 to rounding, and may be no number beside a small pull-off load.
            let load = exp(2.0 * (s - LN_2) + log_pull_off);
            return (load, 2.0 * load);
        }
        let (pull_off, sinh) = (exp(log_pull_off), sinh(s));
        (pull_off * (sinh * sinh - 1.0), 2.0 * pull_off * sinh * (1.0 + sinh * sinh).sqrt())
    }

    /// ln x at s.
    pub fn log_excess(self, s: f64) -> f64 {
        match self.log_pull_off {
            Some(log_pull_off) if s > 20.0 => 2.0 * (s - LN_2) + log_pull_off,
            Some(log_pull_off) => 2.0 * log(sinh(s)) + log_pull_off,
            None => 2.0 * s,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::near;

    #[test]
    fn the_coordinate_is_arsinh_of_the_root_of_load_over_pull_off() {
        let coordinate = Coordinate { log_pull_off: Some(-7.0) };
        for log_excess in [-40.0, -20.0, -7.0, -3.0, -1.01, -0.99, 0.3, 2.0, 5.0, 10.0, 30.0, 34.4, 34.5, 60.0, 700.0] {
            let (s, rate) = coordinate.at(log_excess);
            let root = (0.5 * (log_excess + 7.0)).exp();
            assert!(near(s, root.asinh(), 1e-14), "{log_excess}: {s}");
            assert!(near(rate, 0.5 * root / root.hypot(1.0), 1e-14), "{log_excess}: {rate}");
            let pull_off = (-7_f64).exp();
            let (load, by_s) = coordinate.load(s);
            assert!((load - (log_excess.exp() - pull_off)).abs() <= 1e-13 * load.abs().max(pull_off), "{load}");
            assert!(near(by_s, log_excess.exp() / rate, 1e-12), "{by_s}");
        }
        // The pull-off load is next to the smallest number and the load next to the largest.
        let (s, rate) = Coordinate { log_pull_off: Some(-640.0) }.at(700.0);
        assert!(near(s, 670.0 + LN_2, 1e-15) && rate == 0.5, "{s}, {rate}");
        assert_eq!(Coordinate { log_pull_off: None }.at(-8.0), (-4.0, 0.5));
        assert_eq!(Coordinate { log_pull_off: None }.load(-4.0), (exp(-8.0), 2.0 * exp(-8.0)));
    }
}
