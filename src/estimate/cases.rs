//! The roughnesses that a process may have left, with their probabilities.

use super::known::{deviation, SLOPE_FACTOR};
use crate::by_name::{Case, Machined};
use crate::numerics::elementary::exp;

/// The middle first. Of one unknown they are the three nodes of Gauss, of two the five that integrate as exactly: the middle, and
/// 3^(1/2) standard deviations to either side of it along each.
pub fn of(machined: Option<&Machined>) -> Vec<(Case, f64)> {
    let mut unknown = Vec::new();
    if let Some(machined) = machined {
        if !machined.has_height {
            let reach = exp(3.0_f64.sqrt() * deviation(machined.process.middle_and_factor().1));
            unknown.push([reach, 1.0 / reach].map(|height| Case { height, ..Case::MIDDLE }));
        }
        if !machined.has_slope {
            let reach = exp(3.0_f64.sqrt() * deviation(SLOPE_FACTOR));
            unknown.push([reach, 1.0 / reach].map(|slope| Case { slope, ..Case::MIDDLE }));
        }
    }
    let mut cases = vec![(Case::MIDDLE, 1.0 - unknown.len() as f64 / 3.0)];
    cases.extend(unknown.into_iter().flatten().map(|case| (case, 1.0 / 6.0)));
    cases
}
