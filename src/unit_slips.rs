//! Slips of units: parameters that no two surfaces have, with a guess at the unit that was meant.
//!
//! The library does not know the caller's units, so most of this is done by ratios: see the limits of the groups in
//! `params`. Where the Burgers vector is some tenths of 1e-9 it is one in metres, as those of all crystals are, and what is
//! impossible in SI units is refused. The paper's units, b = 1, and those in mm or um are not judged so.

use crate::error::Error;
use crate::params::Params;

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
    let refuse = |name: &'static str, value: f64, allowed: &'static str| {
        Err(Error::OutOfRange { name, value: value.into(), allowed })
    };
    let hardness = params.hardness / params.composite_modulus;
    if params.hardness != 0.0 && !HARDNESS.contains(&hardness) {
        return refuse(
            "hardness/composite_modulus",
            hardness,
            "must be between 1e-5 and 100, or hardness 0 for not known; is hardness in GPa, and of the softer body?",
        );
    }
    if !CRYSTALS.contains(&params.burgers_vector) {
        return Ok(());
    }
    if params.composite_modulus < SOFTEST {
        return refuse(
            "composite_modulus",
            params.composite_modulus,
            "must be at least 1000 Pa where burgers_vector is in m; is it in GPa?",
        );
    }
    if params.work_of_adhesion > STRONGEST_ADHESION {
        return refuse(
            "work_of_adhesion",
            params.work_of_adhesion,
            "must be at most 20 J/m^2 where burgers_vector is in m; is it in mJ/m^2?",
        );
    }
    if params.summit_radius > WIDEST_SUMMIT {
        return refuse(
            "summit_radius",
            params.summit_radius,
            "must be at most 0.1 m where burgers_vector is in m; is it in um?",
        );
    }
    if params.asperity_count < FEWEST_SUMMITS {
        return refuse(
            "asperity_count",
            params.asperity_count,
            "fewer than one summit; is the summit density per um^2 or mm^2, and the area in m^2? For a part of a summit \
             ask a model of the whole for load/part, and take that part of the force",
        );
    }
    if params.asperity_count > MOST_SUMMITS {
        return refuse(
            "asperity_count",
            params.asperity_count,
            "must be at most 3e16 where burgers_vector is in m; is the area in um^2, and the summit density per m^2?",
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Surface {
        name: &'static str,
        young: [f64; 2],
        poisson: [f64; 2],
        work: f64,
        burgers: f64,
        sigma: f64,
        radius: f64,
        density: f64,
        area: f64,
        hardness: f64,
    }

    /// Surfaces in SI units, with density R sigma = 0.05.
    const SURFACES: [Surface; 5] = [
        Surface {
            name: "polysilicon",
            young: [160e9, 160e9],
            poisson: [0.22, 0.22],
            work: 0.063,
            burgers: 0.384e-9,
            sigma: 5e-9,
            radius: 1e-6,
            density: 1e13,
            area: 1e-8,
            hardness: 12e9,
        },
        Surface {
            name: "ground steel",
            young: [205e9, 205e9],
            poisson: [0.3, 0.3],
            work: 0.05,
            burgers: 0.248e-9,
            sigma: 0.3e-6,
            radius: 1e-5,
            density: 1.7e10,
            area: 1e-4,
            hardness: 7.5e9,
        },
        Surface {
            name: "wafer",
            young: [160e9, 160e9],
            poisson: [0.22, 0.22],
            work: 0.1,
            burgers: 0.384e-9,
            sigma: 0.3e-9,
            radius: 5e-5,
            density: 3e12,
            area: 1e-4,
            hardness: 12e9,
        },
        Surface {
            name: "gold tip on mica",
            young: [78e9, 60e9],
            poisson: [0.44, 0.25],
            work: 0.1,
            burgers: 0.288e-9,
            sigma: 0.3e-9,
            radius: 2e-8,
            density: 8e15,
            area: 1e-14,
            hardness: 1.3e9,
        },
        Surface {
            name: "tread rubber on glass",
            young: [15e6, 72e9],
            poisson: [0.5, 0.17],
            work: 0.05,
            burgers: 0.5e-9,
            sigma: 1e-6,
            radius: 1e-4,
            density: 5e8,
            area: 1e-4,
            hardness: 5e6,
        },
    ];

    fn params(surface: &Surface) -> Params {
        let mut params = Params {
            work_of_adhesion: surface.work,
            adhesion_range: surface.burgers,
            burgers_vector: surface.burgers,
            height_std: surface.sigma,
            summit_radius: surface.radius,
            asperity_count: surface.density * surface.area,
            hardness: surface.hardness,
            ..Params::default()
        };
        let ([young_1, young_2], [poisson_1, poisson_2]) = (surface.young, surface.poisson);
        params.set_materials(young_1, poisson_1, young_2, poisson_2).expect("materials");
        params
    }

    /// Which surfaces pass although one of their numbers is in another unit.
    fn passes(slip: impl Fn(&mut Params), hint: &str) -> Vec<&'static str> {
        let mut passed = Vec::new();
        for surface in &SURFACES {
            let mut params = params(surface);
            slip(&mut params);
            match params.surface() {
                Ok(_) => passed.push(surface.name),
                Err(error) => assert!(error.to_string().contains(hint), "{}: {error}, not {hint}", surface.name),
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
        let all: Vec<_> = SURFACES.iter().map(|surface| surface.name).collect();
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
            let si = params(surface);
            for (length, stress) in [(1e6, 1e-6), (1e3, 1e-6), (1.0 / surface.burgers, 1.0 / si.composite_modulus)] {
                let mut params = si.clone();
                for modulus in
                    [&mut params.composite_modulus, &mut params.effective_shear_modulus, &mut params.hardness]
                {
                    *modulus *= stress;
                }
                params.work_of_adhesion *= stress * length;
                params.adhesion_range *= length;
                params.burgers_vector *= length;
                params.height_std *= length;
                params.summit_radius *= length;
                for count in [1e-3, 1.0, 1e30] {
                    params.asperity_count = count;
                    assert_eq!(params.surface().err(), None, "{} with lengths times {length}", surface.name);
                }
            }
        }
    }

    #[test]
    fn what_some_surface_has_is_taken_up_to_the_limits_and_no_further() {
        let mems = || params(&SURFACES[0]);
        let refused = |change: &dyn Fn(&mut Params)| {
            let mut params = mems();
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
