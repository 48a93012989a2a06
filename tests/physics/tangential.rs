//! Contacts before they slip: stiffness and microslip, against reference values and what their definition says.

use super::yielding::cases;
use crate::common::surfaces::{dimensionless, johnson, model, table};
use crate::common::{assert_near, simpson};
use asperity::{Error, HeightFamily, Params, SlipConstants, SlipOnset};

/// With adhesion at zero and pulling load too, and where contacts break at a finite radius; contacts that slip as a whole and in
/// part.
fn surfaces() -> Vec<Params> {
    let mut surfaces: Vec<Params> = cases().iter().step_by(5).map(|case| case.params.params()).collect();
    surfaces.extend([
        dimensionless(0.01, 1000.0, 1e-3, 1.0),
        dimensionless(0.01, 1000.0, 0.02, 1.0),
        Params { radius_amplitude: 0.6, ..dimensionless(0.01, 1000.0, 0.0, 1.0) },
        Params { heights: johnson(0.5, 4.0), ..dimensionless(0.02, 300.0, 1e-3, 0.5) },
        Params { pressure_coefficient: 0.2, ..dimensionless(0.01, 1000.0, 1e-3, 1.0) },
    ]);
    let onsets = [SlipOnset::Partial, SlipOnset::Whole];
    surfaces.iter().flat_map(|surface| onsets.map(|slip_onset| Params { slip_onset, ..surface.clone() })).collect()
}

#[test]
fn reference_values_are_reproduced() {
    let mut compared = 0;
    for case in cases() {
        let model = model(&case.params.params());
        for row in &case.rows {
            // The load of a separation is known to rounding, and forces move with it.
            let known = |error: f64| error < 1e-11;
            let stiffness = model.tangential_stiffness_at_load(row.load) / row.tangential_stiffness - 1.0;
            assert!(stiffness.abs() < 1e-6, "{:?} at {}: {stiffness:e}", case.params, row.load);
            for &[displacement, force, slope] in &row.tangential {
                let found = model.tangential_at_load(row.load, displacement).expect("a force");
                let errors = [(found.0 - force).abs() / force, (found.1 - slope).abs() / row.tangential_stiffness];
                assert!(
                    errors.into_iter().all(known),
                    "{:?} at {}: {found:?}, not {force:e}, {slope:e}",
                    case.params,
                    row.load
                );
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 4 * 54);
}

#[test]
fn force_rises_from_stiffness_times_displacement_to_the_friction_force() {
    for params in surfaces() {
        let model = model(&params);
        let pull_off = model.summary().pull_off_load;
        for load in [0.9 * pull_off, 0.0, 1e-3, 1.0, 1e4].into_iter().filter(|&load| load > 0.0 || pull_off < 0.0) {
            let state = model.state_at_load(load).expect("a state");
            let (friction, stiffness) = (state.friction_force, state.tangential_stiffness);
            let at = |displacement: f64| model.tangential_at_load(load, displacement).expect("a force");
            let length = friction / stiffness;
            let what = format!("{params:?} at {load}");
            assert_near(at(1e-9 * length).0, 1e-9 * friction, 1e-6, &what);
            assert_near(at(0.0).1, stiffness, 1e-15, &what);
            assert_eq!(at(0.0).0, 0.0);
            for far in [1e4 * length, 1e200, f64::MAX] {
                assert_near(at(far).0, friction, 1e-11, &what);
                assert_eq!(at(far).1, 0.0, "{what}");
            }
            let mut last = (0.0, stiffness * (1.0 + 1e-12));
            for i in 1..60 {
                let displacement = 0.1 * f64::from(i) * length;
                let here = at(displacement);
                let rises = here.0 >= last.0 * (1.0 - 1e-11) && here.0 <= friction * (1.0 + 1e-11) && here.1 <= last.1;
                assert!(rises, "{what}: {here:?} after {last:?}");
                let back = at(-displacement);
                assert_eq!(back, (-here.0, here.1), "{what}");
                let step = 1e-6 * length;
                let secant = (at(displacement + step).0 - at(displacement - step).0) / (2.0 * step);
                assert!((secant - here.1).abs() < 1e-5 * stiffness, "{what}: {secant}, not {}", here.1);
                last = here;
            }
        }
    }
}

/// Far below the heights all summits are of one size: they stick, and then all slip.
#[test]
fn equal_summits_stick_and_slip_as_one() {
    let whole = SlipOnset::Whole;
    let model = model(&Params { tangential_modulus: 0.7, slip_onset: whole, ..dimensionless(0.01, 1000.0, 0.0, 1.0) });
    let state = model.state_at_gap(-1e9 * 10.0).expect("a state");
    let [friction, stiffness] = [state.friction_force, state.tangential_stiffness];
    let length = friction / stiffness;
    let at = |part: f64| model.tangential_at_load(state.load, part * length).expect("a force");
    for part in [1e-3, 0.5, 1.0 - 1e-7] {
        assert_near(at(part).0, part * friction, 1e-9, "sticking");
        assert_near(at(part).1, stiffness, 1e-9, "sticking");
    }
    for part in [1.0 + 1e-7, 2.0] {
        assert_near(at(part).0, friction, 1e-12, "slipping");
        assert_eq!(at(part).1, 0.0);
    }
    // 8 G^ a for each of N summits.
    assert_near(stiffness, 8.0 * 0.7 * state.mean_contact_radius * state.contacting, 1e-12, "stiffness");
}

/// Without adhesion, with a strength in proportion to pressure, contacts stick from an overlap on: the force is an integral of two
/// powers of the overlap over Gaussian heights.
#[test]
fn a_strength_in_proportion_to_pressure_slips_below_one_overlap() {
    let (kappa, modulus) = (0.3, 0.7);
    let none = SlipConstants { stress_1: 0.0, stress_2: 0.0, ..SlipConstants::default() };
    let params = Params {
        slip: none,
        pressure_coefficient: kappa,
        tangential_modulus: modulus,
        slip_onset: SlipOnset::Whole,
        ..dimensionless(0.01, 1000.0, 0.0, 1.0)
    };
    let model = model(&params);
    let Params { composite_modulus: stiff, summit_radius: radius, height_std: sigma, .. } = params;
    for separation in [2.5, 1.0, -0.5].map(|d| d * sigma) {
        let state = model.state_at_gap(separation).expect("a state");
        for part in [1e-3, 0.03, 0.25, 1.0, 2.0] {
            let displacement = part * state.friction_force / state.tangential_stiffness;
            // kappa 4/3 E* R^(1/2) u^(3/2) is 8 G^ (R u)^(1/2) delta.
            let sticking_from = 6.0 * modulus * displacement / (kappa * stiff);
            let force = |u: f64| {
                let strength = kappa * 4.0 / 3.0 * stiff * radius.sqrt() * u.powf(1.5);
                strength.min(8.0 * modulus * (radius * u).sqrt() * displacement)
            };
            // In the root of the overlap both powers are polynomials.
            let of_root = |x: f64| {
                let z = (separation + x * x) / sigma;
                2.0 * x * force(x * x) * (-0.5 * z * z).exp() / (sigma * std::f64::consts::TAU.sqrt())
            };
            let ends = [0.0, sticking_from.sqrt(), (12.0 * sigma).sqrt().max(2.0 * sticking_from.sqrt())];
            let exact: f64 = ends.windows(2).map(|ends| simpson(ends[0], ends[1], of_root)).sum();
            let (found, _) = model.tangential_at_load(state.load, displacement).expect("a force");
            assert_near(found, exact, 1e-10, &format!("at {separation}, {part}"));
        }
    }
}

/// Without adhesion, with a strength in proportion to pressure, what contacts resist is the friction of the load that a larger
/// separation takes from them (M. Ciavarella, J. Appl. Mech. 65 (1998) 998; J. Jaeger, Arch. Appl. Mech. 68 (1998) 245), whatever
/// their heights and radii.
#[test]
fn partial_slip_with_a_strength_in_proportion_to_pressure_is_the_difference_of_two_loads() {
    let (kappa, modulus) = (0.3, 0.7);
    let mut compared = 0;
    for (heights, radius_amplitude) in [
        (HeightFamily::Gaussian, 0.0),
        (HeightFamily::Weibull { shape: 3.602 }, 0.0),
        (HeightFamily::Weibull { shape: 1.3 }, 0.0),
        (HeightFamily::Weibull { shape: 40.0 }, 0.0),
        (johnson(0.5, 4.0), 0.0),
        (table(&[-2.0, -1.0, 0.3, 1.0, 3.0], &[0.0, 0.4, 0.3, 0.5, 0.0]), 0.0),
        (HeightFamily::Gaussian, 0.6),
        (johnson(-0.8, 5.0), -0.7),
    ] {
        let params = Params {
            slip: SlipConstants { stress_1: 0.0, stress_2: 0.0, ..SlipConstants::default() },
            pressure_coefficient: kappa,
            tangential_modulus: modulus,
            heights,
            radius_amplitude,
            ..dimensionless(0.01, 1000.0, 0.0, 1.0)
        };
        let model = model(&params);
        let at = |separation: f64| model.state_at_gap(separation).expect("a state");
        for separation in [2.2, 1.0, -0.5, -4.0].map(|d| d * params.height_std) {
            let state = at(separation);
            // Heights that end below it.
            if state.contacting == 0.0 {
                continue;
            }
            for part in [1e-3, 0.03, 0.1, 0.25, 0.7, 1.0, 2.0] {
                let displacement = part * state.friction_force / state.tangential_stiffness;
                let raised = at(separation + 4.0 * modulus * displacement / (kappa * params.composite_modulus));
                let exact = kappa * (state.load - raised.load);
                let (found, stiffness) = model.tangential_at_load(state.load, displacement).expect("a force");
                // Loads cancel where the displacement is small.
                let error = (found - exact).abs() / (exact + 1e-4 * kappa * state.load);
                // dT/d(delta) is that of the load.
                let slope = -4.0 * modulus / params.composite_modulus * raised.dload_dgap;
                let slope_error = (stiffness - slope).abs() / state.tangential_stiffness;
                compared += 1;
                let what = format!("{:?}, {radius_amplitude}, at {separation}, {part}", params.heights);
                assert!(error < 1e-10, "{what}: {found}, not {exact}: {error:e}");
                assert!(slope_error < 1e-10, "{what}: {stiffness}, not {slope}: {slope_error:e}");
            }
        }
    }
    assert!(compared > 200);
}

/// With the slip law's three regimes, over Gaussian heights, by another integration.
#[test]
fn partial_slip_in_the_regimes_of_the_slip_law_is_the_sum_over_single_contacts() {
    let slip = SlipConstants { radius_1: 28.0, stress_1: 0.02, radius_2: 300.0, stress_2: 0.004 };
    let params = Params { slip, tangential_modulus: 0.7, ..dimensionless(0.01, 1000.0, 0.0, 1.0) };
    let model = model(&params);
    let (shear, radius, sigma) = (params.effective_shear_modulus, params.summit_radius, params.height_std);
    let power = (slip.stress_2 / slip.stress_1).ln() / (slip.radius_2 / slip.radius_1).ln();
    let strength = |a: f64| {
        let stress = match a {
            _ if a < slip.radius_1 => slip.stress_1,
            _ if a < slip.radius_2 => slip.stress_1 * (a / slip.radius_1).powf(power),
            _ => slip.stress_2,
        };
        std::f64::consts::PI * a * a * stress * shear
    };
    for separation in [2.5, 0.5, -3.0].map(|d| d * sigma) {
        let state = model.state_at_gap(separation).expect("a state");
        for part in [0.01, 0.2, 0.6, 1.2] {
            let displacement = part * state.friction_force / state.tangential_stiffness;
            let stuck = |a: f64| 8.0 * 0.7 * a * displacement;
            let force = |a: f64| {
                let left = (1.0 - stuck(a) / (1.5 * strength(a))).max(0.0);
                strength(a) * (1.0 - left.powf(1.5))
            };
            // Strength over radius rises with the radius.
            let (mut slips, mut sticks) = (1e-9, 1e9);
            for _ in 0..200 {
                let middle = f64::sqrt(slips * sticks);
                *if stuck(middle) > 1.5 * strength(middle) { &mut slips } else { &mut sticks } = middle;
            }
            let of_radius = |a: f64| {
                let z = (separation + a * a / radius) / sigma;
                2.0 * a / radius * force(a) * (-0.5 * z * z).exp() / (sigma * std::f64::consts::TAU.sqrt())
            };
            let lowest = (radius * (-separation - 12.0 * sigma).max(0.0)).sqrt();
            let highest = (radius * (12.0 * sigma - separation)).sqrt();
            let mut ends = [slip.radius_1, slip.radius_2, slips].map(|a| a.clamp(lowest, highest)).to_vec();
            ends.extend([lowest, highest]);
            ends.sort_by(f64::total_cmp);
            let exact: f64 = ends.windows(2).map(|ends| eased_simpson(ends[0], ends[1], of_radius)).sum();
            let (found, _) = model.tangential_at_load(state.load, displacement).expect("a force");
            assert_near(found, exact, 1e-9, &format!("at {separation}, {part}"));
        }
    }
}

/// Where a function goes as the power of 3/2 of the distance from an end.
fn eased_simpson(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    simpson(0.0, 1.0, |t| 6.0 * t * (1.0 - t) * (to - from) * f(from + (to - from) * t * t * (3.0 - 2.0 * t)))
}

#[test]
fn the_default_of_the_tangential_modulus_is_that_of_one_material_and_of_a_rigid_body() {
    for (second, nu_2) in [(200.0, 0.3), (f64::INFINITY, 0.2)] {
        let mut params = dimensionless(0.01, 1000.0, 0.0, 1.0);
        params.set_materials(200.0, 0.3, second, nu_2).expect("materials");
        let default = model(&Params { tangential_modulus: 0.0, ..params.clone() });
        let given = model(&params);
        for load in [1e-3, 10.0] {
            let [a, b] = [&default, &given].map(|model| model.tangential_stiffness_at_load(load));
            assert_near(a, b, 1e-14, "stiffness");
        }
    }
}

#[test]
fn compiled_stiffness_at_pull_off_is_that_of_the_state_and_below_it_none() {
    for params in surfaces() {
        let model = model(&params);
        let pull_off = model.summary().pull_off_load;
        let at_pull_off = model.tangential_stiffness_at_load(pull_off);
        if pull_off < 0.0 {
            let state = model.state_at_load(pull_off).expect("a state");
            assert_eq!(at_pull_off, state.tangential_stiffness);
            assert_eq!(model.tangential_stiffness_at_load(1.1 * pull_off), 0.0);
            assert!(model.tangential_stiffness_at_load(0.0) > at_pull_off);
        } else {
            assert_eq!((at_pull_off, model.tangential_stiffness_at_load(-1.0)), (0.0, 0.0));
        }
        for load in [f64::NAN, f64::INFINITY, 1e300] {
            assert!(model.tangential_stiffness_at_load(load).is_nan());
        }
    }
}

#[test]
fn bad_loads_and_displacements_are_refused() {
    let model = model(&Params { heights: HeightFamily::Gaussian, ..dimensionless(0.01, 1000.0, 1e-3, 1.0) });
    let pull_off = model.summary().pull_off_load;
    for displacement in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = model.tangential_at_load(1.0, displacement).expect_err("no force");
        assert_eq!(
            error.to_string(),
            format!("displacement = {}: must be finite", asperity::Value::from(displacement))
        );
    }
    assert!(matches!(model.tangential_at_load(2.0 * pull_off, 1.0), Err(Error::Separated { .. })));
    assert!(matches!(model.tangential_at_load(f64::NAN, 1.0), Err(Error::InvalidLoad { .. })));
    assert!(matches!(model.tangential_at_load(1e300, 1.0), Err(Error::OutOfRange { .. })));
    // Without adhesion nothing touches at zero load, and nothing resists.
    let hertz = super::tangential::model(&dimensionless(0.01, 1000.0, 0.0, 1.0));
    assert_eq!(hertz.tangential_at_load(0.0, 1.0), Ok((0.0, 0.0)));
    assert!(matches!(hertz.tangential_at_load(-1.0, 1.0), Err(Error::Separated { .. })));
    // As light as loads can be.
    let (force, stiffness) = hertz.tangential_at_load(1e-305, 1e-3).expect("a force");
    assert!(force > 0.0 && stiffness >= 0.0 && force <= hertz.friction_force_at_load(1e-305) * (1.0 + 1e-10));
}
