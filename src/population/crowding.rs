//! What neighbours change: each presses the surface between the contacts down, so that the mean planes of the surfaces approach
//! by less than the summits do. Neighbours share elastic compliance only: with K_1 the stiffness of summits that do not know of each
//! other, the planes approach by 1 - (1 - psi) K_1/(2 E* sum a) where summits do by 1, and 1/K = 1/K_1 - (1 - psi)/(2 E* sum a). For
//! Hertz' contacts K_1 is 2 E* sum a. Beyond pull-off, where the load rises with separation, K_1 counts as 0. A contact in the middle of its share of the nominal area, a flux tube, has the part psi = (1 -
//! (A/A_0)^(1/2))^1.8 of the compliance, and of the resistance, that it has alone (Cooper, Mikic and Yovanovich, 1969, with the
//! power 1.5; 1.8 is that of boundary elements, docs/model.md). A is the real area, A_0 the nominal one.
//!
//! Tubes end where contacts are islands no more: half of the surfaces touch then (0.415 in A. Wang and M. H. Mueser,
//! arXiv:2010.13470, 0.5 by Bruggeman). There the share A/A_0 saturates, smoothly, so that stiffness rises with any load and stays
//! finite.

use super::Sums;
use crate::numerics::elementary::{exp, log};

const POWER: f64 = 1.8;
/// The largest share of the nominal area.
const LARGEST_SHARE: f64 = 0.5;

/// Of one summit.
#[derive(Debug, Clone, Copy)]
pub struct Crowding {
    /// In b^2.
    pub nominal_area: f64,
    /// 2 E* a, in E* b^2 per sigma, of a contact of the radius b: 2 alpha beta.
    pub stiffness_of_radius: f64,
}

impl Crowding {
    /// The sums with what neighbours change.
    pub fn among(self, sums: Sums) -> Sums {
        let elastic = self.stiffness_of_radius * sums.radius;
        let crowding = self.of(&sums);
        let given_way = if elastic > 0.0 { crowding.0 * (-sums.load_slope / elastic).max(0.0) } else { 0.0 };
        Sums { crowding, given_way, ..sums }
    }

    /// 1 - psi of sums, and its slope by separation.
    fn of(self, sums: &Sums) -> (f64, f64) {
        let ratio = sums.area / self.nominal_area / LARGEST_SHARE;
        if ratio.is_nan() || ratio <= 0.0 {
            return (0.0, 0.0);
        }
        // The share over the largest is ratio/(1 + ratio^4)^(1/4); the slope of its logarithm by the ratio's is 1/(1 + ratio^4).
        let square = if ratio < 1.0 { ratio * ratio } else { 1.0 / (ratio * ratio) };
        let fourth_root = (1.0 + square * square).sqrt().sqrt();
        let share = LARGEST_SHARE * if ratio < 1.0 { ratio / fourth_root } else { 1.0 / fourth_root };
        let share_slope = if ratio < 1.0 { 1.0 } else { square * square } / (1.0 + square * square);
        let root = share.sqrt();
        let left = 1.0 - root;
        let psi = exp(POWER * log(left));
        (1.0 - psi, POWER * psi / left * 0.5 * root * share_slope * (sums.area_slope / sums.area))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(share: f64) -> (f64, f64) {
        let sums = Sums { area: 3.0 * share, area_slope: 3.0, ..Sums::default() };
        Crowding { nominal_area: 3.0, stiffness_of_radius: 1.0 }.of(&sums)
    }

    #[test]
    fn few_contacts_share_as_in_flux_tubes_and_islands_that_meet_share_no_more() {
        for (share, tolerance) in [(1e-20, 1e-15), (1e-6, 1e-13), (0.01, 1e-7), (0.1, 1e-3), (0.2, 1e-2)] {
            let tubes = (1.0 - f64::sqrt(share)).powf(1.8);
            assert!(((1.0 - at(share).0) / tubes - 1.0).abs() < tolerance, "{share}: {:?}", at(share));
        }
        let least = (1.0 - f64::sqrt(0.5)).powf(1.8);
        for share in [5.0, 1e80, 1e200] {
            let (off, slope) = at(share);
            assert!(((1.0 - off) / least - 1.0).abs() < 1e-4 && (0.0..1e-3).contains(&slope), "{share}: {off}");
        }
        assert_eq!(at(0.0), (0.0, 0.0));
    }

    #[test]
    fn slopes_are_those_of_secants() {
        for share in [1e-4, 0.003, 0.1, 0.4999, 0.5001, 0.7, 3.0] {
            let step = 1e-5 * share;
            let secant = (at(share + step).0 - at(share - step).0) / (2.0 * step);
            let (_, slope) = at(share);
            assert!((slope / secant - 1.0).abs() < 1e-7, "{share}: {slope}, not {secant}");
        }
    }
}
