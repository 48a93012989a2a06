//! Slips of units: parameters that no two surfaces have, with a guess at the unit that was meant.
//!
//! The library does not know the caller's units, so most of this is done by ratios: see the limits of the groups in
//! `checks`. Where the Burgers vector is some tenths of 1e-9 it is one in metres, as those of all crystals are, and what is
//! impossible in SI units is refused. The paper's units, b = 1, and those in mm or um are not judged so.

use super::Params;
use crate::error::Error;

/// Burgers vectors, in metres.
const CRYSTALS: std::ops::RangeInclusive<f64> = 1e-10..=1e-9;
/// Hardness over E*: from soft metals (1e-3) and rubber (1) there is room to either side.
const HARDNESS: std::ops::RangeInclusive<f64> = 1e-5..=100.0;
/// A sphere of 10 cm is a body and not a summit.
const WIDEST_SUMMIT: f64 = 0.1;
/// Diamond takes some 11 J/m^2 to cleave.
const STRONGEST_ADHESION: f64 = 20.0;
/// Gels have some kPa.
const SOFTEST: f64 = 1e3;
/// Half a summit is none.
const FEWEST_SUMMITS: f64 = 0.5;
/// A square metre of summits that are 6 nm apart.
const MOST_SUMMITS: f64 = 3e16;

/// Refuses what no two surfaces have, where parameters are numbers already.
///
/// # Errors
/// [`Error::OutOfRange`], with the likely slip.
pub fn check(params: &Params) -> Result<(), Error> {
    let hardness = params.hardness / params.composite_modulus;
    if params.hardness != 0.0 && !HARDNESS.contains(&hardness) {
        let allowed =
            "must be between 1e-5 and 100, or hardness 0 for not known; is hardness in GPa, and of the softer body?";
        return Err(Error::out_of_range("hardness/composite_modulus", hardness, allowed));
    }
    if !CRYSTALS.contains(&params.burgers_vector) {
        return Ok(());
    }
    let (modulus, work, radius) = (params.composite_modulus, params.work_of_adhesion, params.summit_radius);
    let count = params.asperity_count;
    let (name, value, allowed) = if modulus < SOFTEST {
        ("composite_modulus", modulus, "must be at least 1000 Pa where burgers_vector is in m; is it in GPa?")
    } else if work > STRONGEST_ADHESION {
        ("work_of_adhesion", work, "must be at most 20 J/m^2 where burgers_vector is in m; is it in mJ/m^2?")
    } else if radius > WIDEST_SUMMIT {
        ("summit_radius", radius, "must be at most 0.1 m where burgers_vector is in m; is it in um?")
    } else if count < FEWEST_SUMMITS {
        let allowed =
            "fewer than one summit; is the summit density per um^2 or mm^2, and the area in m^2? For a part of \
                       a summit ask a model of the whole for load/part, and take that part of the force";
        ("asperity_count", count, allowed)
    } else if count > MOST_SUMMITS {
        let allowed = "must be at most 3e16 where burgers_vector is in m; is the area in um^2, and the summit density \
                       per m^2?";
        ("asperity_count", count, allowed)
    } else {
        return Ok(());
    };
    Err(Error::out_of_range(name, value, allowed))
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
            ..Params::default()
        };
        params.set_materials(young_1, poisson_1, young_2, poisson_2).expect("materials");
        params
    }

    /// Which surfaces pass although one of their numbers is in another unit.
    fn passes(slip: impl Fn(&mut Params), hint: &str) -> Vec<&'static str> {
        let mut passed = Vec::new();
        for surface in &SURFACES {
            let (name, mut params) = (surface.0, params(surface));
            slip(&mut params);
            match params.surface() {
                Ok(_) => passed.push(name),
                Err(error) => assert!(error.to_string().contains(hint), "{name}: {error}, not {hint}"),
            }
        }
        passed
    }

    #[test]
    fn rubber_that_adheres_is_told_that_it_is_outside_of_the_law() {
        let mut soft = params(&SURFACES[4]);
        soft.set_materials(2e6, 0.5, 72e9, 0.17).expect("materials");
        let told = soft.surface().expect_err("adhesion of rubber").to_string();
        assert!(told.contains("Rubber and gels are outside of the law"), "{told}");
        soft.work_of_adhesion = 0.0;
        soft.surface().expect("what the message says to try");
    }

    #[test]
    fn a_slip_of_units_is_refused_with_the_unit_that_was_meant() {
        let all = SURFACES.map(|(name, ..)| name);
        assert_eq!(passes(|_| {}, ""), all);
        let none: [&str; 0] = [];
        assert_eq!(passes(|params| params.work_of_adhesion *= 1e3, "in mJ/m^2"), none);
        assert_eq!(passes(|params| params.summit_radius *= 1e6, "in um?"), ["gold tip on mica"]);
        assert_eq!(passes(|params| params.height_std *= 1e6, "height_std in um or nm?"), ["wafer"]);
        assert_eq!(passes(|params| params.height_std *= 1e9, "height_std in um or nm?"), none);
        let both = |params: &mut Params| (params.height_std, params.summit_radius) = (1e-3, 10.0);
        assert_eq!(passes(both, "in um?"), none);
        assert_eq!(passes(|params| params.burgers_vector *= 1e9, "burgers_vector in nm?"), none);
        assert_eq!(passes(|params| params.adhesion_range *= 1e9, "adhesion_range in nm?"), none);
        let in_gpa = |params: &mut Params, work: f64| {
            for modulus in [&mut params.composite_modulus, &mut params.effective_shear_modulus, &mut params.hardness] {
                *modulus *= 1e-9;
            }
            params.work_of_adhesion *= work;
        };
        assert_eq!(passes(|params| in_gpa(params, 1.0), "GPa?"), none);
        assert_eq!(passes(|params| in_gpa(params, 0.0), "GPa?"), none);
        assert_eq!(passes(|params| params.hardness *= 1e-9, "hardness in GPa"), none);
        assert_eq!(passes(|params| params.hardness *= 1e9, "hardness in GPa"), none);
        let count = |factor: f64| passes(|params| params.asperity_count *= factor, "");
        assert_eq!(count(1e-12), none, "density per um^2");
        assert_eq!(count(1e-6), ["ground steel", "wafer"], "density per mm^2");
        assert_eq!(count(1e12), ["gold tip on mica"], "area in um^2");
        assert_eq!(count(1e6), all, "area in mm^2: as large as other surfaces are");
    }

    #[test]
    fn other_units_are_not_judged_as_metres() {
        // The same surfaces in um-uN-MPa and in the paper's units are as good; their counts are the caller's.
        for surface in &SURFACES {
            let (name, si) = (surface.0, params(surface));
            for (length, stress) in [(1e6, 1e-6), (1e3, 1e-6), (1.0 / si.burgers_vector, 1.0 / si.composite_modulus)] {
                for count in [1e-3, 1.0, 1e30] {
                    let params = Params { asperity_count: count, ..si.in_units(stress, length) };
                    assert_eq!(params.surface().err(), None, "{name} with lengths times {length}");
                }
            }
        }
    }

    #[test]
    fn what_some_surface_has_is_taken_up_to_the_limits_and_no_further() {
        let refused = |change: &dyn Fn(&mut Params)| {
            let mut params = params(&SURFACES[0]);
            change(&mut params);
            check(&params).err().map(|error| error.to_string())
        };
        type Change = fn(&mut Params, f64);
        let limits: [(&str, f64, f64, Change); 7] = [
            ("composite_modulus", SOFTEST, -1.0, |params, x| (params.composite_modulus, params.hardness) = (x, 0.0)),
            ("work_of_adhesion", STRONGEST_ADHESION, 1.0, |params, x| params.work_of_adhesion = x),
            ("summit_radius", WIDEST_SUMMIT, 1.0, |params, x| params.summit_radius = x),
            ("asperity_count", FEWEST_SUMMITS, -1.0, |params, x| params.asperity_count = x),
            ("asperity_count", MOST_SUMMITS, 1.0, |params, x| params.asperity_count = x),
            ("hardness/composite_modulus", 1e-5, -1.0, |params, x| params.hardness = x * params.composite_modulus),
            ("hardness/composite_modulus", 100.0, 1.0, |params, x| params.hardness = x * params.composite_modulus),
        ];
        for (name, limit, outwards, set) in limits {
            assert_eq!(refused(&|params| set(params, limit * (1.0 - 1e-12 * outwards))), None, "{name}");
            let message = refused(&|params| set(params, limit * (1.0 + 1e-12 * outwards))).expect(name);
            assert!(message.starts_with(name), "{message}");
        }
    }
}
