//! Where the model holds: what it assumes of a state, as numbers that exceed 1 where an assumption fails, and the search for
//! such states. The sources of the bounds are in docs/theory.md, "Is the model valid here?".

use super::State;
use crate::error::Error;
use crate::neighbours::Neighbours;
use crate::params::{ContactLawKind, Params};

/// Set in [`State::warnings`](crate::State::warnings) where summits yield, though their law is elastic.
pub const WARNING_PLASTIC: u64 = 1;
/// Set where summits are too close to act alone.
pub const WARNING_CROWDED: u64 = 2;
/// Set where contacts are not small against the radius of their summits.
pub const WARNING_STEEP: u64 = 4;
/// Set where contacts are too small for continuum mechanics.
pub const WARNING_ATOMIC: u64 = 8;
/// Set where so few summits touch that one surface differs from another.
pub const WARNING_FEW: u64 = 16;
/// Set where adhesion presses the surfaces together with more than the load.
pub const WARNING_ADHESIVE: u64 = 32;

/// The mean pressure of an elastic contact, over the hardness, at which yield sets in below its surface: 1.1 of the
/// yield stress, of which the hardness is 2.8 (Johnson, Contact Mechanics, 1985, sections 6.1 and 6.2).
const YIELD_PRESSURE: f64 = 0.4;
/// The plasticity index above which contacts flow at any load (Greenwood and Williamson, Proc. R. Soc. A 295, 1966).
const PLASTIC_INDEX: f64 = 1.0;
/// The fraction of the summits in contact, and of the nominal area, up to which contacts are too far apart to matter to each
/// other.
const CROWDED_FRACTION: f64 = 0.1;
/// The mean contact radius over that of the summits up to which a summit is a paraboloid of small strain.
const STEEP_RATIO: f64 = 0.1;
/// The number of contacts from which the mean over surfaces at one load is that at one separation, to 1/20.
const FEWEST_CONTACTS: f64 = 20.0;
/// The `asperity_count` of the paper's loads, which are loads of a mean summit.
const LOADS_PER_SUMMIT: f64 = 1.0;

/// For each warning, in the order of their bits, a quantity over its bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures([f64; 6]);

impl Measures {
    /// Of a state of the surfaces with these parameters and this pull-off load, at most 0.
    pub fn new(params: &Params, pull_off_load: f64, state: &State) -> Self {
        let touching = state.contacting > 0.0;
        let is_elastic = params.contact_law == ContactLawKind::Maugis;
        let plastic = match is_elastic && params.hardness > 0.0 {
            true => (state.mean_asperity_pressure / (YIELD_PRESSURE * params.hardness))
                .max(state.plasticity_index / PLASTIC_INDEX),
            false => 0.0,
        };
        let area = if params.nominal_area > 0.0 { state.real_area / params.nominal_area } else { 0.0 };
        let crowded = state.fraction_in_contact.max(area) / CROWDED_FRACTION;
        let atomic = if touching { params.burgers_vector / state.mean_contact_radius } else { 0.0 };
        let over = |large: f64, small: f64| if small > 0.0 { large / small } else { f64::MAX };
        let of_many = params.asperity_count != LOADS_PER_SUMMIT;
        let few = if of_many { over(FEWEST_CONTACTS, state.contacting) } else { 0.0 };
        let adhesive = if of_many && pull_off_load < 0.0 { over(-pull_off_load, state.load) } else { 0.0 };
        Self([plastic, crowded, state.mean_steepness / STEEP_RATIO, atomic, few, adhesive])
    }

    /// The bits of the assumptions that fail.
    pub fn warnings(&self) -> u64 {
        self.0.iter().enumerate().filter(|(_, measure)| **measure > 1.0).map(|(bit, _)| 1 << bit).sum()
    }
}

/// How far apart the states are that are looked at [sigma], next to the middle of the heights and to the lightest load ...
const STEP: f64 = 0.1;
/// ... and up to this distance from both; farther off, by this part of what the distance exceeds it: the contacts change
/// slowly there.
const MIDDLE: f64 = 10.0;
const GROWTH: f64 = 0.5;
/// Whether a measure rises from an end inwards is seen from a state so far inside, in steps.
const NEXT_TO_END: f64 = 0.01;
/// A golden section takes this part of the interval off, and after so many of them 1e-7 of it is left.
const GOLDEN: f64 = 0.381_966_011_250_105_1;
const SECTIONS: u32 = 34;

/// The warnings of all states between two separations, in sigma, from what is measured at each.
///
/// More summits touch and their area grows as the surfaces approach. Mean radius and pressure mostly grow as well, but not
/// where many summits begin to touch at once, or sharper ones. All measures are therefore followed in steps, and refined
/// wherever one is larger than its neighbours.
///
/// # Errors
/// Those of the states.
pub fn warnings_between(near: f64, far: f64, at: impl Fn(f64) -> Result<Measures, Error>) -> Result<u64, Error> {
    let states: Result<Vec<_>, Error> = separations(near, far).into_iter().map(|d| Ok((d, at(d)?))).collect();
    let states = states?;
    let mut warnings = states.iter().fold(0, |bits, (_, measures)| bits | measures.warnings());
    for around in states.windows(3) {
        let [before, here, after] = [0, 1, 2].map(|i| around[i].1 .0);
        // Where a measure is constant there is nothing to refine.
        for bit in (0..here.len()).filter(|&bit| here[bit] > before[bit] && here[bit] >= after[bit]) {
            if warnings & (1 << bit) == 0 && exceeds(around[0].0, around[2].0, |d| Ok(at(d)?.0[bit]))? {
                warnings |= 1 << bit;
            }
        }
    }
    Ok(warnings)
}

/// Separations from `near` to `far`, both included.
fn separations(near: f64, far: f64) -> Vec<f64> {
    let beside = (NEXT_TO_END * STEP).min(0.5 * (far - near));
    let mut all = vec![near, near + beside];
    let mut here = near;
    while here < far {
        let distance = here.abs().min(far - here);
        here = (here + STEP + GROWTH * (distance - MIDDLE).max(0.0)).max(here.above());
        all.push(here);
    }
    all.retain(|&d| d < far - beside);
    all.extend([far - beside, far]);
    all.dedup();
    all
}

/// Whether a measure with one maximum between two separations exceeds 1 there.
fn exceeds(mut from: f64, mut to: f64, measure: impl Fn(f64) -> Result<f64, Error>) -> Result<bool, Error> {
    let inner = |from: f64, to: f64| from + GOLDEN * (to - from);
    let mut left = (inner(from, to), measure(inner(from, to))?);
    let mut right = (inner(to, from), measure(inner(to, from))?);
    for _ in 0..SECTIONS {
        if left.1.max(right.1) > 1.0 {
            return Ok(true);
        }
        if left.1 >= right.1 {
            (to, right) = (right.0, left);
            left = (inner(from, to), measure(inner(from, to))?);
        } else {
            (from, left) = (left.0, right);
            right = (inner(to, from), measure(inner(to, from))?);
        }
    }
    Ok(false)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Model;

    #[test]
    fn summits_whose_law_yields_are_not_warned_of() {
        let elastic = Params { hardness: 1e-3, ..Params::default() };
        let state = Model::new(&elastic).expect("a model").state_at_load(10.0).expect("a state");
        assert_eq!(Measures::new(&elastic, 0.0, &state).warnings(), WARNING_PLASTIC);
        let plastic = Params { contact_law: ContactLawKind::ElasticPlastic, ..elastic };
        assert_eq!(Measures::new(&plastic, 0.0, &state).warnings(), 0);
    }

    /// A peak between states, of a measure that is below 1 at each of them.
    #[test]
    fn what_exceeds_its_bound_only_between_the_steps_is_found() {
        for (height, found) in [(1.0 + 1e-9, 1 << 2), (1.0 - 1e-9, 0)] {
            for peak in [-3e5, -0.3217, 0.0004, 4.0561, 7.7999] {
                let scale = 1.0 + f64::abs(peak);
                let at = |d: f64| {
                    let steep = height - ((d - peak) / scale).powi(2);
                    Ok(Measures([0.0, 0.0, steep, 0.0, 0.0, 0.0]))
                };
                assert_eq!(warnings_between(-1e6, 7.8, at), Ok(found), "{peak}");
            }
        }
    }

    #[test]
    fn steps_reach_both_ends_and_none_is_long_in_the_middle() {
        for (near, far) in [(-1e53, 30.0), (-2.0, 5.0), (3.0, 3.0), (1.0, 1.0 + 1e-15), (-1e5, -9e4)] {
            let all = separations(near, far);
            assert_eq!((all[0], all[all.len() - 1]), (near, far));
            assert!(all.len() < 1000 && all.windows(2).all(|pair| pair[1] > pair[0]), "{near} to {far}");
            let short = |pair: &[f64]| pair[0].abs().min(far - pair[0]) > MIDDLE || pair[1] - pair[0] < 1.01 * STEP;
            assert!(all.windows(2).all(short), "{near} to {far}");
        }
    }
}
