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
use crate::asperity::slip::Slip;
use crate::numerics::elementary::{exp, log};
use std::f64::consts::PI;

const POWER: f64 = 1.8;
/// The largest share of the nominal area.
const LARGEST_SHARE: f64 = 0.5;
/// The share at which patches of contact span the surface, as above.
const PERCOLATION: f64 = 0.42;

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

    /// The sums with the friction of contacts that have merged: the law of slip takes their mean radius to be greater by
    /// (1 - A/(0.42 A_0))^(-1/2), of which the series up to the third power is taken: 2 % less at 0.19 of A_0, and no singularity.
    pub fn merged(self, sums: Sums, slip: &Slip) -> Sums {
        if !(sums.area > 0.0 && sums.radius > 0.0) {
            return sums;
        }
        let share = sums.area / (PERCOLATION * self.nominal_area);
        let square = 1.0 + share * (1.0 + share * (1.0 + share));
        let growth_rate = 0.5 * share * (1.0 + share * (2.0 + 3.0 * share)) / square * (sums.area_slope / sums.area);
        let mean_rate = sums.area_slope / sums.area - sums.radius_slope / sums.radius;
        let (power, by_mean) = slip.power_of_mean(sums.area / (PI * sums.radius));
        let log_growth = 0.5 * log(square);
        let ratio = exp(power * log_growth);
        let ratio_rate = ratio * (power * growth_rate + by_mean * mean_rate * log_growth);
        // What grows with pressure does not depend on radii.
        let of_pressure = slip.by_hertz_load();
        let [stress, stress_rate] =
            [sums.friction - of_pressure * sums.hertz_load, sums.friction_slope - of_pressure * sums.hertz_load_slope];
        let friction = sums.friction - (1.0 - ratio) * stress;
        let friction_slope = sums.friction_slope - (1.0 - ratio) * stress_rate + ratio_rate * stress;
        Sums { lost_to_merging: 1.0 - friction / sums.friction, friction, friction_slope, ..sums }
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
    use crate::asperity::slip::{SlipConstants, SlipOnset};

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
    fn patches_of_contact_that_merge_slip_as_larger_ones_do() {
        let constants = SlipConstants { radius_1: 1.0, stress_1: 1.0, radius_2: 1e4, stress_2: 0.01 };
        let crowding = Crowding { nominal_area: 1.0, stiffness_of_radius: 1.0 };
        for (of_pressure, mean) in [(0.0, 0.1), (0.0, 30.0), (0.2, 30.0), (0.2, 9e3)] {
            let slip = Slip::new(constants, of_pressure, SlipOnset::Partial);
            // Contacts of one radius, more of them and larger ones where the surfaces are nearer.
            let at = |share: f64| {
                let radius = mean * (1.0 + share);
                let [hertz_load, stress] = [0.3 * share, slip.stress(radius)];
                let friction = share * stress + of_pressure * hertz_load;
                Sums { area: share, radius: share / (PI * radius), hertz_load, friction, ..Sums::default() }
            };
            for share in [1e-9, 1e-3, 0.05, 0.2, 0.41, 0.7] {
                let rate = |of: fn(&Sums) -> f64| {
                    (of(&at(share + 1e-6 * share)) - of(&at(share * (1.0 - 1e-6)))) / (2e-6 * share)
                };
                let friction_slope = rate(|sums| sums.friction);
                let sums = Sums {
                    area_slope: 1.0,
                    radius_slope: rate(|sums| sums.radius),
                    hertz_load_slope: 0.3,
                    friction_slope,
                    ..at(share)
                };
                let found = crowding.merged(sums, &slip);
                let part = share / 0.42;
                let growth = f64::sqrt(1.0 + part + part * part + part.powi(3));
                let radius = mean * (1.0 + share);
                let power = slip.power_of_mean(radius).0;
                let expected = share * slip.stress(radius) * growth.powf(power) + of_pressure * 0.3 * share;
                assert!((found.friction / expected - 1.0).abs() < 1e-12, "{share}: {} {expected}", found.friction);
                let merged = |share: f64| crowding.merged(at(share), &slip).friction;
                let secant = (merged(share + 1e-6 * share) - merged(share * (1.0 - 1e-6))) / (2e-6 * share);
                assert!(
                    (found.friction_slope / secant - 1.0).abs() < 1e-6,
                    "{share}: {} {secant}",
                    found.friction_slope
                );
                let part = 1.0 - found.lost_to_merging;
                assert!((part * sums.friction / found.friction - 1.0).abs() < 1e-12);
            }
        }
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
