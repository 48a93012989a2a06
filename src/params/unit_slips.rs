//! Slips of units: parameters that no two surfaces have, with a guess at the unit that was meant.
//!
//! The library does not know the caller's units, so most of this is done by ratios: see the limits of the groups in
//! `checks`. But all crystals have Burgers vectors of some tenths of a nm: one of some 1e-10 is in metres, one of some 1e-7 in
//! millimetres, and what is impossible in SI units, in N-mm-MPa or in kN-mm-GPa is refused. The paper's units, b = 1, and those in
//! um are not judged so.

use super::Params;
use crate::error::Error;
use std::ops::RangeInclusive;

/// Hardness over E*: from soft metals (1e-3) and rubber (1) there is room to either side.
const SOFTEST: (f64, &str) = (
    1e-5,
    "must be at least 1e-5, or hardness 0 for not known; is hardness in GPa, in MPa or a Vickers number (times 9.81e6 in Pa), and of \
     the softer body?",
);
const HARDEST: (f64, &str) = (
    100.0,
    "must be at most 100, or hardness 0 for not known; is the modulus, or E1 or E2, in MPa or GPa, or hardness in another unit?",
);
/// Nayak's bandwidth: of a fractal dimension of 2.2, 4e3 goes with three decades of wavelengths, 2e5 with four.
pub(super) const BROADEST: (f64, &str) = (
    1e6,
    "must be at most 1e6: is m0 the square of Rq, is asperity_count a number \
     of asperities and not a density, and are all lengths in one unit?",
);
/// Summits per area times their height deviation and radius: of Gaussian surfaces 0.016 and more, of a few dimples on a plate 1e-6.
const SPARSEST: (f64, &str) = (
    1e-7,
    "must be at least 1e-7, since no surface has so few asperities on its area; is nominal_area in mm^2 or um^2 beside lengths in m, \
     or asperity_count a density per mm^2 or um^2?",
);
/// Where lengths are in m or mm there is less: in GPa beside moduli in MPa all hardnesses are below.
const SOFTEST_METAL: (f64, &str) =
    (3e-4, "must be at least 3e-4, or hardness 0 for not known; is hardness in GPa or in MPa, and of the softer body?");

/// What surfaces have in units that their Burgers vector tells, each bound with what it is and the likely slip.
struct UnitSystem {
    burgers_vector: RangeInclusive<f64>,
    /// Gels have some kPa.
    softest: (f64, &'static str),
    /// Diamond has 6e11 Pa; rigid bodies may be given a thousand times that.
    stiffest: (f64, &'static str),
    /// Diamond takes some 11 J/m^2 to cleave, more than all others.
    strongest_adhesion: (f64, &'static str),
    /// Summits that differ by tenths of a millimetre make a casting, and not a surface that was finished.
    roughest: (f64, &'static str),
    /// A sphere of 10 cm is a body and not a summit.
    widest_summit: (f64, &'static str),
    /// Half a summit is none.
    fewest_summits: (f64, &'static str),
    /// A square metre of summits that are 6 nm apart.
    most_summits: (f64, &'static str),
}

const UNITS: [UnitSystem; 2] = [
    UnitSystem {
        burgers_vector: 1e-10..=1e-9,
        softest: (1e3, "must be at least 1000 Pa where burgers_vector is in m; is it, or E1 or E2, in MPa or GPa?"),
        stiffest: (1e16, "must be at most 1e16 Pa where burgers_vector is in m; is it, or E1 or E2, too large by a factor of 1e9?"),
        strongest_adhesion: (12.0, "must be at most 12 J/m^2 where burgers_vector is in m; is it in mJ/m^2?"),
        roughest: (1e-4, "must be at most 1e-4 m where burgers_vector is in m; is it in mm, um or nm?"),
        widest_summit: (0.1, "must be at most 0.1 m where burgers_vector is in m; is it in mm, um or nm?"),
        fewest_summits: (
            0.5,
            "less than one asperity; is nominal_area smaller than a wave of the roughness, or the summit density per um^2 or mm^2 \
             and the area in m^2? To model a part of an asperity, ask a model of the whole asperity for load/part, and take that part of the force",
        ),
        most_summits: (
            3e16,
            "must be at most 3e16 where burgers_vector is in m; is the area in um^2, and the summit density per m^2?",
        ),
    },
    UnitSystem {
        burgers_vector: 1e-7..=1e-6,
        softest: (1e-6, "must be at least 1e-6 GPa, or 1e-3 MPa, where burgers_vector is in mm; is it, or E1 or E2, in GPa?"),
        stiffest: (1e7, "must be at most 1e7 MPa where burgers_vector is in mm; is it in Pa?"),
        strongest_adhesion: (0.012, "must be at most 0.012 N/mm where burgers_vector is in mm; is it in J/m^2?"),
        roughest: (0.1, "must be at most 0.1 mm where burgers_vector is in mm; is it in um?"),
        widest_summit: (100.0, "must be at most 100 mm where burgers_vector is in mm; is it in um?"),
        fewest_summits: (
            0.5,
            "less than one asperity; is nominal_area smaller than a wave of the roughness, or the summit density per um^2 and the \
             area in mm^2? To model a part of an asperity, ask a model of the whole asperity for load/part, and take that part of the force",
        ),
        most_summits: (
            3e16,
            "must be at most 3e16 where burgers_vector is in mm; is the area in mm^2, and the summit density per m^2?",
        ),
    },
];

/// Refuses what no two surfaces have, where parameters are numbers already.
///
/// # Errors
/// [`Error::OutOfRange`], with the likely slip.
pub fn check(params: &Params) -> Result<(), Error> {
    type Bound = (f64, &'static str);
    let refuse = |is_outside: bool, name, value, allowed| match is_outside {
        true => Err(Error::out_of_range(name, value, allowed)),
        false => Ok(()),
    };
    let at_least = |name, value, (bound, allowed): Bound| refuse(value < bound, name, value, allowed);
    let at_most = |name, value, (bound, allowed): Bound| refuse(value > bound, name, value, allowed);
    let units = UNITS.iter().find(|units| units.burgers_vector.contains(&params.burgers_vector));
    if let Some(units) = units {
        at_least("composite_modulus", params.composite_modulus, units.softest)?;
        at_most("composite_modulus", params.composite_modulus, units.stiffest)?;
    }
    let hardness = params.hardness / params.composite_modulus;
    if params.hardness != 0.0 {
        at_least("hardness/composite_modulus", hardness, SOFTEST)?;
        at_most("hardness/composite_modulus", hardness, HARDEST)?;
    }
    if params.nominal_area > 0.0 && params.is_of_many() {
        at_least("asperity_count/nominal_area height_std summit_radius", params.summit_product(), SPARSEST)?;
    }
    let Some(units) = units else { return Ok(()) };
    if params.hardness != 0.0 {
        at_least("hardness/composite_modulus", hardness, SOFTEST_METAL)?;
    }
    at_most("work_of_adhesion", params.work_of_adhesion, units.strongest_adhesion)?;
    if params.is_of_many() {
        at_most("height_std", params.height_std, units.roughest)?;
    }
    at_most("summit_radius", params.summit_radius, units.widest_summit)?;
    at_most("bandwidth", params.known_bandwidth().max(params.bandwidth_of_density()), BROADEST)?;
    at_least("asperity_count", params.asperity_count, units.fewest_summits)?;
    at_most("asperity_count", params.asperity_count, units.most_summits)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Surface = (&'static str, [f64; 4], [f64; 6]);

    /// In SI units E and nu of both bodies, w, b, sigma, R, density R sigma being 0.05, N as density times area, and H.
    const SURFACES: [Surface; 5] = [
        ("polysilicon", [160e9, 0.22, 160e9, 0.22], [0.063, 0.384e-9, 5e-9, 1e-6, 1e13 * 1e-8, 12e9]),
        ("ground steel", [205e9, 0.3, 205e9, 0.3], [0.05, 0.248e-9, 0.3e-6, 1e-5, 1.7e10 * 1e-4, 7.5e9]),
        ("wafer", [160e9, 0.22, 160e9, 0.22], [0.1, 0.384e-9, 0.3e-9, 5e-5, 3e12 * 1e-4, 12e9]),
        ("gold tip on mica", [78e9, 0.44, 60e9, 0.25], [0.1, 0.288e-9, 0.3e-9, 2e-8, 8e15 * 1e-14, 1.3e9]),
        ("tread rubber on glass", [15e6, 0.5, 72e9, 0.17], [0.05, 0.5e-9, 1e-6, 1e-4, 5e8 * 1e-4, 5e6]),
    ];

    fn params(&(_, [young_1, poisson_1, young_2, poisson_2], others): &Surface) -> Params {
        let [work_of_adhesion, burgers_vector, height_std, summit_radius, asperity_count, hardness] = others;
        let mut params = Params {
            work_of_adhesion,
            adhesion_range: burgers_vector,
            burgers_vector,
            height_std,
            summit_radius,
            asperity_count,
            hardness,
            ..Params::paper()
        };
        params.set_materials(young_1, poisson_1, young_2, poisson_2).expect("materials");
        params
    }

    /// The same surfaces in other units.
    fn in_units(params: &Params, stress: f64, length: f64) -> Params {
        let mut other = params.clone();
        other.set_units(1.0 / length, 1.0 / (stress * length * length)).expect("units");
        other
    }

    #[test]
    fn an_elastomer_that_adheres_is_told_how_to_be_set() {
        let mut soft = params(&SURFACES[4]);
        soft.set_materials(2e6, 0.5, 72e9, 0.17).expect("materials");
        let told = soft.surface().expect_err("adhesion of rubber").to_string();
        assert!(told.contains("An elastomer has no Burgers vector: set slip_stress_1 = slip_stress_2"), "{told}");
        soft.slip.stress_2 = soft.slip.stress_1;
        soft.burgers_vector = 1.001 * soft.work_of_adhesion / (10.0 * soft.composite_modulus);
        soft.surface().expect("what the message says to set");
    }

    #[test]
    fn a_slip_of_units_is_refused_with_the_unit_that_was_meant() {
        let in_gpa = |params: &mut Params, work: f64| {
            for modulus in [&mut params.composite_modulus, &mut params.effective_shear_modulus, &mut params.hardness] {
                *modulus *= 1e-9;
            }
            params.work_of_adhesion *= work;
        };
        let moduli = |params: &mut Params, factor: f64| {
            params.composite_modulus *= factor;
            params.effective_shear_modulus *= factor;
        };
        let in_mm = |params: &mut Params| *params = in_units(params, 1e-6, 1e3);
        let all: &[&str] = &SURFACES.map(|(name, ..)| name);
        let heights = "height_std in um or nm?|is it in mm, um or nm?";
        let soft = "is it, or E1 or E2, in MPa or GPa?|is the modulus, or E1 or E2, in MPa";
        type Slip<'a> = (&'a dyn Fn(&mut Params), &'a str, &'a [&'a str]);
        let slips: [Slip; 24] = [
            (&|_| {}, "", all),
            (&|params| params.work_of_adhesion *= 1e3, "in mJ/m^2", &[]),
            (&|params| params.summit_radius *= 1e6, "in um?|is it in mm, um or nm?", &["gold tip on mica"]),
            (&|params| params.height_std *= 1e6, heights, &[]),
            (&|params| params.height_std *= 1e9, heights, &[]),
            (&|params| (params.height_std, params.summit_radius) = (1e-3, 10.0), "is it in mm, um or nm?", &[]),
            (&|params| params.burgers_vector *= 1e9, "burgers_vector in nm?", &[]),
            (&|params| params.adhesion_range *= 1e9, "adhesion_range in nm?", &[]),
            (&|params| in_gpa(params, 1.0), "GPa?", &[]),
            (&|params| in_gpa(params, 0.0), "GPa?", &[]),
            (&|params| params.hardness *= 1e-9, "hardness in GPa", &[]),
            (&|params| params.hardness *= 1e9, "hardness in another unit", &[]),
            // The bodies alone: of rubber they are gels.
            (&|params| moduli(params, 1e-9), soft, &[]),
            (&|params| moduli(params, 1e-6), soft, &[]),
            // A density per um^2 or mm^2; an area in um^2, or in mm^2, which is as large as other surfaces are.
            (&|params| params.asperity_count *= 1e-12, "", &[]),
            (&|params| params.asperity_count *= 1e-6, "", &["ground steel", "wafer"]),
            (&|params| params.asperity_count *= 1e12, "", &["gold tip on mica"]),
            (&|params| params.asperity_count *= 1e6, "", all),
            // Among N, mm and MPa, or kN, mm and GPa.
            (&in_mm, "", all),
            (&|params| *params = in_units(params, 1e-9, 1e3), "", all),
            (&|params| *params = in_units(params, 1.0, 1e3), "in Pa?", &[]),
            (&|params| (in_mm(params), params.work_of_adhesion *= 1e3).1, "in J/m^2", &[]),
            (&|params| (in_mm(params), params.burgers_vector *= 1e6).1, "burgers_vector in nm?", &[]),
            (&|params| (in_mm(params), params.hardness *= 1e-3).1, "hardness in GPa", &[]),
        ];
        for (i, (slip, hints, expected)) in slips.into_iter().enumerate() {
            let passes = |surface: &&Surface| {
                let mut params = params(surface);
                slip(&mut params);
                let told = params.surface().err().map(|error| error.to_string());
                let is_meant = |told: &String| hints.split('|').any(|hint| told.contains(hint));
                assert!(told.iter().all(is_meant), "{i}, {}: {told:?}, not {hints}", surface.0);
                told.is_none()
            };
            let passed: Vec<_> = SURFACES.iter().filter(passes).map(|surface| surface.0).collect();
            assert_eq!(passed, expected, "{i}, {hints}");
        }
    }

    /// In um-uN-MPa, in mm and in the paper's units the same surfaces are as good; in mm a count is judged as it is in m.
    #[test]
    fn other_units_are_not_judged_as_metres() {
        for surface in &SURFACES {
            let (name, si) = (surface.0, params(surface));
            for (length, stress) in [(1e6, 1e-6), (1e3, 1e-6), (1.0 / si.burgers_vector, 1.0 / si.composite_modulus)] {
                for asperity_count in if length == 1e3 { [0.5, 1.0, 3e16] } else { [1e-3, 1.0, 1e30] } {
                    let params = Params { asperity_count, ..in_units(&si, stress, length) };
                    assert_eq!(params.surface().err(), None, "{name} with lengths times {length}");
                }
            }
        }
    }
}
