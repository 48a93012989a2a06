//! Where the model holds: what it assumes of a state, as numbers that exceed 1 where an assumption fails, and the search for
//! such states. The sources of the bounds are in docs/model.md, "Is the model valid here?".

use super::State;
use crate::error::Error;
use crate::numerics::neighbours::Neighbours;
use crate::params::{ContactLawKind, HeightFamily, Params};
use std::ffi::CStr;

/// Set in [`State::warnings`](crate::State::warnings) where summits yield, but the contact law is elastic.
pub const WARNING_PLASTIC: u64 = 1;
/// Set where summits are too close to act independently.
pub const WARNING_CROWDED: u64 = 2;
/// Set where contacts are not small against the radius of their summits.
pub const WARNING_STEEP: u64 = 4;
/// Set where contacts are too small for continuum mechanics.
pub const WARNING_ATOMIC: u64 = 8;
/// Set where fewer than 20 summits touch, so that averages are not reliable.
pub const WARNING_FEW: u64 = 16;
/// Set where adhesion presses the surfaces together with more than the load.
pub const WARNING_ADHESIVE: u64 = 32;
/// Set where the strength of the interface is the default, not a measured one.
pub const WARNING_UNCALIBRATED: u64 = 64;
/// Set where the surface is rough on so many scales that summits stand on summits.
pub const WARNING_BROAD: u64 = 128;
/// Set where the interface is stronger than the softer body.
pub const WARNING_STRONG: u64 = 256;
/// Set where too few waves of the roughness fit the nominal area for it to be like another.
pub const WARNING_FEW_WAVES: u64 = 512;
/// Set where much of the load is on flat tops.
pub const WARNING_FLAT_TOP: u64 = 1024;
/// Set where heights are known not to be Gaussian, but taken as such.
pub const WARNING_NOT_GAUSSIAN: u64 = 2048;

/// The mean pressure of an elastic contact, over the hardness, at which yield sets in below its surface: 1.1 of the
/// yield stress, of which the hardness is 2.8 (Johnson, Contact Mechanics, 1985, sections 6.1 and 6.2).
const YIELD_PRESSURE: f64 = 0.4;
/// The plasticity index above which contacts flow at any load (Greenwood and Williamson, Proc. R. Soc. A 295, 1966).
const FLOW_INDEX: f64 = 1.0;
/// The fraction of the nominal area up to which contacts are too far apart to matter to each other; of the summits in contact too,
/// where the slope of the surface is not known: asperities that stand for a surface with its slope may touch each other.
const CROWDED_FRACTION: f64 = 0.1;
/// The mean contact radius over that of the summits up to which a summit is a paraboloid of small strain ...
const STEEP_RATIO: f64 = 0.1;
/// ... and the slope of the surface, where it is known, up to which it is 4 % longer than its plan.
const STEEP_SLOPE: f64 = 0.3;
/// Mean waves a side of the nominal area, from which on friction is that of boundary elements to 10 % or so (docs/validation.md).
const FEWEST_WAVES: f64 = 8.0;
/// The share of the load on flat tops up to which surfaces are those of boundary elements (docs/validation.md).
const FLAT_SHARE: f64 = 0.25;
/// The number of contacts from which the mean over surfaces at one load is that at one separation, to 1/20.
const FEWEST_CONTACTS: f64 = 20.0;

/// The loads of Hertz' contacts over the load, from which on adhesion presses with more than the load.
const ADHESIVE_SHARE: f64 = 2.0;
/// Nayak's bandwidth up to which friction is that of boundary elements to 10 % or so (docs/validation.md).
const BROAD_BANDWIDTH: f64 = 6.0;
/// What exceeds its bound whatever the state.
const ALWAYS: f64 = f64::MAX;

/// For each warning, in the order of their bits, a quantity over its bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures([f64; WARNINGS]);

/// All warnings, and how many they are.
pub const EVERY_WARNING: u64 = 2 * WARNING_NOT_GAUSSIAN - 1;
pub const WARNINGS: usize = EVERY_WARNING.count_ones() as usize;

impl Measures {
    /// What is measured of a state of the surfaces with these parameters.
    pub fn new(params: &Params, state: &State) -> Self {
        let of_many = params.is_of_many();
        let touching = state.contacting > 0.0;
        let is_elastic = params.contact_law == ContactLawKind::Maugis;
        let plastic = match is_elastic && params.hardness > 0.0 {
            true => (state.mean_asperity_pressure / (YIELD_PRESSURE * params.hardness))
                .max(state.plasticity_index / FLOW_INDEX),
            false => 0.0,
        };
        let area = if params.nominal_area > 0.0 { state.real_area / params.nominal_area } else { 0.0 };
        let knows_slope = params.rms_slope > 0.0;
        let touching_part = if knows_slope { 0.0 } else { state.fraction_in_contact };
        let crowded = if of_many { touching_part.max(area) / CROWDED_FRACTION } else { 0.0 };
        let atomic = if touching { params.burgers_vector / state.mean_contact_radius } else { 0.0 };
        let over = |large: f64, small: f64| if small > 0.0 { large / small } else { f64::MAX };
        let few = if of_many { over(FEWEST_CONTACTS, state.contacting) } else { 0.0 };
        let adheres = of_many && params.work_of_adhesion > 0.0;
        let adhesive = if adheres { over(state.hertz_load / ADHESIVE_SHARE, state.load) } else { 0.0 };
        let uncalibrated = if params.has_default_strength() { ALWAYS } else { 0.0 };
        let strong = match touching && params.hardness > 0.0 {
            true => {
                let stress = params.slip_law().stress(state.mean_contact_radius / params.burgers_vector);
                stress * params.effective_shear_modulus / shear_strength(params.hardness)
            }
            false => 0.0,
        };
        let broad = params.known_bandwidth() / BROAD_BANDWIDTH;
        let steep = match knows_slope {
            true => params.rms_slope / STEEP_SLOPE,
            false => state.mean_steepness / STEEP_RATIO,
        };
        let waves = params.waves_a_side();
        let few_waves = if of_many && waves > 0.0 { FEWEST_WAVES / waves } else { 0.0 };
        let flat_top = state.load_on_flats / FLAT_SHARE;
        let not_gaussian =
            if params.taken_as_gaussian && params.heights == HeightFamily::Gaussian { ALWAYS } else { 0.0 };
        Self([
            plastic,
            crowded,
            steep,
            atomic,
            few,
            adhesive,
            uncalibrated,
            broad,
            strong,
            few_waves,
            flat_top,
            not_gaussian,
        ])
    }

    /// The bits of the assumptions that fail.
    pub fn warnings(&self) -> u64 {
        self.0.iter().enumerate().filter(|(_, measure)| **measure > 1.0).map(|(bit, _)| 1 << bit).sum()
    }
}

/// The shear strength of a body of this hardness, three times the yield stress, after von Mises.
fn shear_strength(hardness: f64) -> f64 {
    hardness / (3.0 * 3.0_f64.sqrt())
}

/// How far apart the states are that are looked at [sigma], next to the middle of the heights and to the lightest load, of surfaces and of
/// those whose heights have one hump, or on waves, which are means over many separations ...
pub const NEAR_STEPS: [f64; 2] = [0.1, 0.5];
/// ... and up to this distance from both; farther off, by this part of what the distance exceeds it: the contacts change
/// slowly there.
const NEAR_DISTANCE: f64 = 10.0;
const GROWTH: f64 = 0.5;
/// Whether a measure rises from an end inwards is seen from a state so far inside [sigma].
const NEXT_TO_END: f64 = 0.001;
/// A golden section takes this part of the interval off, and after so many of them 1e-7 of it is left.
const GOLDEN: f64 = 0.381_966_011_250_105_1;
const SECTIONS: u32 = 34;
/// A peak with straight sides rises above the second of three even states by four times what their parabola does.
const RISE: f64 = 4.0;

/// The warnings of all states between two separations, in sigma, from what is measured at each.
///
/// More summits touch and their area grows as the surfaces approach. Mean radius and pressure mostly grow as well, but not
/// where many summits begin to touch at once, or sharper ones. All measures are therefore followed in steps, and refined
/// wherever one is larger than its neighbours.
///
/// # Errors
/// Those of the states.
pub fn warnings_between(
    (near, far): (f64, f64),
    step: f64,
    at: impl Fn(f64) -> Result<Measures, Error>,
) -> Result<u64, Error> {
    let states: Result<Vec<_>, Error> = separations(near, far, step).into_iter().map(|d| Ok((d, at(d)?))).collect();
    let states = states?;
    let mut warnings = states.iter().fold(0, |bits, (_, measures)| bits | measures.warnings());
    for around in states.windows(3) {
        for bit in (0..WARNINGS).filter(|&bit| may_exceed(around, bit)) {
            if warnings & (1 << bit) == 0 && exceeds(around[0].0, around[2].0, |d| Ok(at(d)?.0[bit]))? {
                warnings |= 1 << bit;
            }
        }
    }
    Ok(warnings)
}

/// Separations from `near` to `far`, both included.
fn separations(near: f64, far: f64, step: f64) -> Vec<f64> {
    let beside = NEXT_TO_END.min(0.5 * (far - near));
    let mut all = vec![near, near + beside];
    let mut here = near;
    while here < far {
        let distance = here.abs().min(far - here);
        here = (here + step + GROWTH * (distance - NEAR_DISTANCE).max(0.0)).max(here.above());
        all.push(here);
    }
    all.retain(|&d| d < far - beside);
    all.extend([far - beside, far]);
    all.dedup();
    all
}

/// Whether a measure is largest at the second of three states and may exceed 1 between the others: if the largest value were above that by
/// [`RISE`] times what a parabola through the three has, or by what the second is above the lower of its neighbours.
fn may_exceed(around: &[(f64, Measures)], bit: usize) -> bool {
    let [(from, before), (at, here), (to, after)] = [0, 1, 2].map(|i| (around[i].0, around[i].1 .0[bit]));
    let (rise, fall) = (here - before, here - after);
    if !(rise > 0.0 && fall >= 0.0) {
        // Where a measure is constant there is nothing to refine.
        return false;
    }
    let (rising, falling) = (rise / (at - from), fall / (to - at));
    let slope = (rising * (to - at) - falling * (at - from)) / (to - from);
    let above = slope * slope / (4.0 * (rising + falling) / (to - from));
    here + (RISE * above).max(rise.max(fall)) > 1.0
}

/// Whether a measure with one maximum between two separations exceeds 1.
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

/// The warnings in the order of their bits: names, bits, and what each means.
pub static WARNING_TEXTS: [(&CStr, u64, &CStr); WARNINGS] = [
    (
        c"PLASTIC",
        WARNING_PLASTIC,
        c"asperities yield: the mean asperity pressure is above 0.4 of the hardness, or the plasticity index is above \
          1; use the elastic-plastic contact law (contact_law 1, by name elastic-plastic) with work_of_adhesion 0, \
          or lighter loads if only the pressure is too high",
    ),
    (
        c"CROWDED",
        WARNING_CROWDED,
        c"asperities do not act independently: the real area is more than 10 % of nominal_area, or, where no rms_slope is \
          given, more than 10 % of the asperities touch; areas are rough here, and stiffness no longer grows with neighbours from \
          about half of nominal_area on; use lighter loads, or check height_std, asperity_count and nominal_area, which \
          are usually too small",
    ),
    (
        c"STEEP",
        WARNING_STEEP,
        c"the surface is too steep for small strains: rms_slope is above 0.3, or, where none is given, contact radii are \
          above a tenth of the radii of asperities on average; use lighter loads if only the radii are too large, and check slope and \
          summit_radius: a height map that is noisy gives too steep a surface and too small a radius",
    ),
    (
        c"ATOMIC",
        WARNING_ATOMIC,
        c"contacts are too small for continuum mechanics: their mean radius is below burgers_vector; use heavier \
          loads, or a height map that is filtered at the size of the contacts",
    ),
    (
        c"FEW",
        WARNING_FEW,
        c"fewer than 20 asperities touch, so averages are not reliable: nominally equal specimens differ from each other and \
          from the model; use heavier loads or a larger nominal area, or ask for single specimens",
    ),
    (
        c"ADHESIVE",
        WARNING_ADHESIVE,
        c"adhesion presses the surfaces together with more than the load, where models of independent asperities are \
          quantitatively wrong; use heavier loads, or check work_of_adhesion, height_std and summit_radius: input \
          that is too smooth or too clean is the usual cause",
    ),
    (
        c"UNCALIBRATED",
        WARNING_UNCALIBRATED,
        c"the strength of the interface is the default or that of other materials, not a measured one, and friction \
          is proportional to it: with the default it was up to 14 times too low or 26 times too high; measure friction once and calibrate \
          with it, or set slip stresses and pressure_coefficient to measured values",
    ),
    (
        c"BROAD",
        WARNING_BROAD,
        c"the surface is rough on many scales, with a bandwidth above 6, so that summits that were counted stand on summits: at a \
          bandwidth of 27 they give 7 to 24 % less friction and 30 to 43 % less real area than boundary elements; give the mean \
          squares of height and slope instead (m0 and m2, or Sq and Sdq), or measure friction at the load of use",
    ),
    (
        c"STRONG",
        WARNING_STRONG,
        c"the interface is stronger than the softer body: the slip stress at the mean contact radius exceeds hardness/(3 sqrt 3), so \
          that the body shears before the interface slips; give the hardness of the softer body as it is where they touch, or check the \
          load and the area of the measured friction, or take an interface that slips more easily",
    ),
    (
        c"FEW_WAVES",
        WARNING_FEW_WAVES,
        c"fewer than 8 mean waves of the roughness fit a side of nominal_area, so that one or two hills may carry the \
          load: friction is then 1.05 to 1.8 times what the model predicts, most at light loads, and nominally equal \
          surfaces differ by up to 30 %; use a larger area, or remove waves longer than it from the heights",
    ),
    (
        c"FLAT_TOP",
        WARNING_FLAT_TOP,
        c"more than a quarter of the load is on flat tops, where a table of heights at scores does not say what the surface is like: real \
          area is 0.8 to 1.4 times that of boundary elements there, friction that was calibrated at another load 0.7 to 1; calibrate at the \
          load of use",
    ),
    (
        c"NOT_GAUSSIAN",
        WARNING_NOT_GAUSSIAN,
        c"the surface is known not to be Gaussian, as one that honing, lapping or wear left with plateaus, but its heights are taken as \
          such: real area is then 0.2 to 1 times that of boundary elements; give heights_at_scores and slopes_at_scores of a height map, \
          or Spq, Svq and Smq with Sdq",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asperity::slip::SlipConstants;
    use crate::Model;

    #[test]
    fn summits_whose_law_yields_are_not_warned_of() {
        // Weaker than the softer body.
        let slip = SlipConstants { stress_1: 1e-5, stress_2: 1e-5, ..SlipConstants::default() };
        let elastic = Params { hardness: 1e-3, slip, ..Params::paper() };
        let state = Model::new(&elastic).expect("a model").state_at_load(10.0).expect("a state");
        assert_eq!(Measures::new(&elastic, &state).warnings(), WARNING_PLASTIC);
        let plastic = Params { contact_law: ContactLawKind::ElasticPlastic, ..elastic };
        assert_eq!(Measures::new(&plastic, &state).warnings(), 0);
    }

    /// Between two separations, however many of the states that are looked at lie between them.
    #[test]
    fn where_a_bound_is_exceeded_is_found() {
        let (near, far) = (-3.0, 5.0);
        for (from, to) in [(near, far), (near, 1.23456), (-1.23456, far), (0.17, 0.33), (0.17, 0.43)] {
            let at = |d: f64| {
                let mut measures = Measures([0.0; WARNINGS]);
                measures.0[2] = if (from..=to).contains(&d) { 2.0 } else { 0.0 };
                Ok(measures)
            };
            assert_eq!(warnings_between((near, far), NEAR_STEPS[0], at), Ok(1 << 2), "{from} to {to}");
        }
    }

    /// A peak between states, of a measure that is below 1 at each of them.
    #[test]
    fn what_exceeds_its_bound_only_between_the_steps_is_found() {
        for (height, found) in [(1.0 + 1e-9, 1 << 2), (1.0 - 1e-9, 0)] {
            for peak in [-3e5, -0.3217, 0.0004, 4.0561, 7.7999] {
                let scale = 1.0 + f64::abs(peak);
                let at = |d: f64| {
                    let steep = height - ((d - peak) / scale).powi(2);
                    let mut measures = Measures([0.0; WARNINGS]);
                    measures.0[2] = steep;
                    Ok(measures)
                };
                assert_eq!(warnings_between((-1e6, 7.8), NEAR_STEPS[0], at), Ok(found), "{peak}");
            }
        }
    }
}
