//! Radii, regimes and pressures of the contacts in a state: against closed forms of Hertzian contact, and against sums
//! over many heights of a contact that is solved here, by bisection, from the equations of docs/model.md.

use crate::common::surfaces::model;
use crate::common::{assert_near, simpson};
use asperity::{HeightFamily, Params, State, WARNING_PLASTIC};
use statrs::function::erf::{erfc, erfc_inv};
use statrs::function::gamma::gamma;
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// The fraction of Gaussian heights above z, to some 1e-11.
fn above(z: f64) -> f64 {
    0.5 * erfc(z / SQRT_2)
}

/// A Hertzian surface of many summits, whose contacts at moderate load lie in all three regimes.
fn hertzian() -> Params {
    let mut params = Params { work_of_adhesion: 0.0, asperity_count: 1e6, burgers_vector: 0.5, ..Params::paper() };
    params.slip.radius_1 = 800.0;
    params.slip.radius_2 = 2000.0;
    params.slip.stress_2 = 1.0 / 200.0;
    params
}

#[test]
fn hertzian_contacts_are_those_of_closed_forms() {
    let params = hertzian();
    let model = model(&params);
    let length = (params.height_std * params.summit_radius).sqrt();
    for d in [-1.0, 0.5, 2.0, 4.0] {
        let state = model.state_at_gap(d * params.height_std).expect("a state");
        let what = format!("at {d}");
        let fraction = above(d);
        assert_near(state.fraction_in_contact, fraction, 1e-10, &what);
        // a = (R sigma u)^(1/2), u = z - d.
        let kink = |radius: f64| above(d + (radius * params.burgers_vector / length).powi(2)) / fraction;
        let (first, second) = (kink(params.slip.radius_1), kink(params.slip.radius_2));
        assert_near(state.fraction_below_slip_radius_1, 1.0 - first, 1e-8, &what);
        assert_near(state.fraction_between_slip_radii, first - second, 1e-8, &what);
        assert_near(state.fraction_above_slip_radius_2, second, 1e-8, &what);
        let number = fraction * params.asperity_count;
        let tallest = SQRT_2 * erfc_inv(2.0 * fraction / (number + 1.0));
        assert_near(state.max_contact_radius, length * (tallest - d).sqrt(), 1e-9, &what);
        // z = d + s^2
        let mean = simpson(0.0, 9.0_f64.max(9.0 - d).sqrt(), |s| {
            2.0 * s * s * length * (-0.5 * (d + s * s).powi(2)).exp() / (2.0 * PI).sqrt()
        }) / fraction;
        assert_near(state.mean_contact_radius, mean, 1e-9, &what);
    }
}

/// One summit in contact after Maugis, as docs/model.md has it, in sigma, b and E* b^2.
struct Summit {
    alpha: f64,
    beta: f64,
    gamma: f64,
    b_over_h: f64,
    g: f64,
}

impl Summit {
    /// Overlap, contact radius and load; theta not so small that the brackets cancel.
    fn at(&self, theta: f64) -> [f64; 3] {
        let Self { alpha, beta, gamma, b_over_h, g } = *self;
        let (sin, cos) = theta.sin_cos();
        let k2 = alpha * b_over_h / (PI * beta * g) * (sin * cos - theta * (2.0 * theta).cos());
        let k1 = 4.0 * gamma * b_over_h.powi(2) / PI * (theta * sin + cos - 1.0);
        let c = 2.0 / (k1 + (k1 * k1 + 4.0 * k2).sqrt());
        let a = c * cos;
        let overlap = a * a / (beta * beta * g) - 2.0 * gamma * b_over_h / (alpha * beta) * c * sin;
        let load = 4.0 * alpha / (3.0 * beta * g) * a.powi(3) - 2.0 * gamma * b_over_h * (sin * cos + theta) * c * c;
        [overlap, a, load]
    }

    /// theta at which contact ends.
    fn break_away(&self) -> f64 {
        let (mut lower, mut upper) = (0.05, FRAC_PI_2);
        for _ in 0..100 {
            let (left, right) = (lower + (upper - lower) / 3.0, upper - (upper - lower) / 3.0);
            if self.at(left)[0] > self.at(right)[0] {
                lower = left;
            } else {
                upper = right;
            }
        }
        upper
    }

    /// Contact radius and load at an overlap; `None` out of contact.
    fn at_overlap(&self, overlap: f64) -> Option<[f64; 2]> {
        let (mut lower, mut upper) = (1e-3, self.break_away());
        if overlap < self.at(upper)[0] {
            return None;
        }
        for _ in 0..60 {
            let middle = 0.5 * (lower + upper);
            if self.at(middle)[0] > overlap {
                lower = middle;
            } else {
                upper = middle;
            }
        }
        let [_, radius, load] = self.at(0.5 * (lower + upper));
        Some([radius, load])
    }
}

/// What the state tells of the contacts, summed over heights in small steps.
fn brute_force(params: &Params, separation: f64) -> [f64; 6] {
    const STEPS: usize = 24_000;
    const HIGHEST: f64 = 9.0;
    let b = params.burgers_vector;
    let d = separation / params.height_std;
    let density = |z: f64| match params.heights {
        HeightFamily::Weibull { shape } => {
            let [first, second] = [1.0, 2.0].map(|n| gamma(1.0 + n / shape));
            let scale = (second - first * first).sqrt();
            let y = z * scale + first;
            let power = if y > 0.0 { y.powf(shape) } else { 0.0 };
            if power > 0.0 {
                scale * shape * power / y * (-power).exp()
            } else {
                0.0
            }
        }
        _ => (-0.5 * z * z).exp() / (2.0 * PI).sqrt(),
    };
    let lowest = d - 3.0;
    let step = (HIGHEST - lowest) / STEPS as f64;
    // From the top: weight, radius, load.
    let contacts: Vec<[f64; 3]> = (0..STEPS)
        .filter_map(|i| {
            let z = HIGHEST - (i as f64 + 0.5) * step;
            let summit = Summit {
                alpha: (params.height_std / params.summit_radius).sqrt(),
                beta: (params.height_std * params.summit_radius).sqrt() / b,
                gamma: params.work_of_adhesion / (params.composite_modulus * b),
                b_over_h: b / params.adhesion_range,
                g: 1.0 + params.radius_amplitude * (params.radius_rate * z).tanh(),
            };
            let [radius, load] = summit.at_overlap(z - d)?;
            Some([step * density(z), radius, load])
        })
        .collect();
    let sum = |f: &dyn Fn(f64, f64) -> f64| contacts.iter().map(|&[w, a, load]| w * f(a, load)).sum::<f64>();
    let count = sum(&|_, _| 1.0);
    let mean = sum(&|a, _| a) / count;
    let below = sum(&|a, _| f64::from(u8::from(a <= params.slip.radius_1))) / count;
    let above = sum(&|a, _| f64::from(u8::from(a >= params.slip.radius_2))) / count;
    let pressure = sum(&|_, load| load) / sum(&|a, _| PI * a * a) * params.composite_modulus;
    let number = count * params.asperity_count;
    let mut higher = 0.0;
    let mut largest = mean;
    for [weight, radius, _] in &contacts {
        higher += weight;
        if higher >= count / (number + 1.0) && number > 1.0 {
            largest = largest.max(*radius);
        }
    }
    [count, mean * b, largest * b, below, above, pressure]
}

#[test]
fn contacts_are_those_of_a_sum_over_heights() {
    let mut paper = Params { asperity_count: 3e4, burgers_vector: 0.8, ..Params::paper() };
    paper.slip.radius_1 = 300.0;
    paper.slip.radius_2 = 900.0;
    paper.slip.stress_2 = 1.0 / 300.0;
    let mut sticky = Params { work_of_adhesion: 10.0 * paper.work_of_adhesion, ..paper.clone() };
    sticky.set_skew(0.6).expect("a skew");
    let growing = Params { radius_amplitude: 0.9, radius_rate: 0.8, ..paper.clone() };
    // Radii that fall so fast that the tallest summits have smaller contacts than lower ones.
    let shrinking = Params { radius_amplitude: -0.95, radius_rate: 1.0, ..paper.clone() };
    for (name, params) in [("paper", paper), ("sticky", sticky), ("growing", growing), ("shrinking", shrinking)] {
        let model = model(&params);
        for d in [0.0, 1.5] {
            let separation = d * params.height_std;
            let state = model.state_at_gap(separation).expect("a state");
            let [count, mean, largest, below, above, pressure] = brute_force(&params, separation);
            let what = |quantity: &str| format!("{quantity}, {name} at {d}");
            assert_near(state.fraction_in_contact, count, 1e-3, &what("fraction in contact"));
            assert_near(state.mean_contact_radius, mean, 1e-3, &what("mean radius"));
            assert_near(state.max_contact_radius, largest, 1e-3, &what("largest radius"));
            assert_near(state.fraction_below_slip_radius_1, below, 5e-3, &what("below"));
            // The tallest of 1e17 summits are none of those that are summed one by one.
            let found = state.fraction_above_slip_radius_2;
            assert!((found - above).abs() < 5e-3 * above + 1e-17, "{}: {found:e}, not {above:e}", what("above"));
            assert_near(state.mean_asperity_pressure, pressure, 2e-3, &what("pressure"));
            let whole = below + above + state.fraction_between_slip_radii;
            assert_near(whole, 1.0, 3e-3, &what("all regimes"));
        }
    }
}

/// What holds of every state.
fn assert_consistent(state: &State, params: &Params, what: &str) {
    let regimes =
        [state.fraction_below_slip_radius_1, state.fraction_between_slip_radii, state.fraction_above_slip_radius_2];
    assert!(regimes.iter().all(|part| (0.0..=1.0).contains(part)), "{what}: {state:?}");
    assert_near(regimes.iter().sum(), 1.0, 1e-12, what);
    assert_near(state.contacting, state.fraction_in_contact * params.asperity_count, 1e-12, what);
    assert!(
        state.mean_contact_radius > 0.0 && state.max_contact_radius >= state.mean_contact_radius,
        "{what}: {state:?}"
    );
    // The area of the mean radius is no more than the mean area.
    let mean_area = state.real_area / state.contacting;
    assert!(PI * state.mean_contact_radius.powi(2) <= mean_area * (1.0 + 1e-9), "{what}: {state:?}");
}

#[test]
fn states_are_consistent_from_pull_off_to_heavy_load() {
    for (work, amplitude) in [(0.0, 0.0), (0.003, 0.0), (0.03, 0.0), (0.003, -1.0), (0.003, 1.0)] {
        let params =
            Params { work_of_adhesion: work, radius_amplitude: amplitude, asperity_count: 1e5, ..Params::paper() };
        let model = model(&params);
        let pull_off = model.summary().pull_off_load;
        let mut loads: Vec<f64> = (-6..12).map(|k| pull_off + 1e5 * 10.0_f64.powi(k)).collect();
        loads.extend((pull_off < 0.0).then_some(pull_off));
        for load in loads {
            let state = model.state_at_load(load).expect("a state");
            assert_consistent(&state, &params, &format!("w = {work}, epsilon = {amplitude}, load {load}"));
        }
    }
}

#[test]
fn the_largest_of_one_contact_or_fewer_is_the_mean() {
    let state = model(&Params::paper()).state_at_load(1.0).expect("a state");
    assert!(state.contacting < 1.0);
    assert_eq!(state.max_contact_radius.to_bits(), state.mean_contact_radius.to_bits());
}

#[test]
fn more_summits_have_a_larger_largest_contact() {
    let largest = [1e2, 1e4, 1e6, 1e12, 1e30].map(|asperity_count| {
        let params = Params { asperity_count, ..Params::paper() };
        model(&params).state_at_gap(params.height_std).expect("a state").max_contact_radius
    });
    assert!(largest.windows(2).all(|pair| pair[1] > pair[0]), "{largest:?}");
}

/// The largest contact is the one that 1/(n + 1) of the contacts exceed: as the second radius of the slip law, it cuts
/// that fraction off.
#[test]
fn the_largest_contact_is_exceeded_by_one_in_n_plus_1() {
    let families = [
        HeightFamily::Gaussian,
        HeightFamily::Weibull { shape: 2.2 },
        HeightFamily::Johnson { skew: 0.6, kurtosis: 4.5 },
        HeightFamily::Johnson { skew: -0.4, kurtosis: 2.6 },
        HeightFamily::Tabulated {
            height: (0..9).map(f64::from).collect(),
            density: [0.0, 1.0, 4.0, 7.0, 6.0, 0.0, 0.0, 2.0, 0.5].into(),
        },
    ];
    for heights in families {
        for d in [-0.5, 1.5] {
            let mut params = Params { heights: heights.clone(), asperity_count: 1e3, ..Params::paper() };
            let separation = d * params.height_std;
            let first = model(&params).state_at_gap(separation).expect("a state");
            params.slip.radius_2 = first.max_contact_radius / params.burgers_vector;
            params.slip.stress_2 = params.slip.stress_1;
            let state = model(&params).state_at_gap(separation).expect("a state");
            assert!(state.contacting > 1.0, "{heights:?}: {state:?}");
            let what = format!("{heights:?} at {d}");
            assert_near(state.fraction_above_slip_radius_2, 1.0 / (state.contacting + 1.0), 1e-9, &what);
        }
    }
}

#[test]
fn nothing_touches_far_away() {
    let params = Params { hardness: 1.0, ..Params::paper() };
    let model = model(&params);
    // In sigma: heights of which some are counted, none but the last, none.
    for separation in [63.2, 63.35, 64.0, 1e5] {
        let state = model.state_at_gap(separation * params.height_std).expect("a state");
        assert_eq!((state.contacting, state.mean_contact_radius, state.max_contact_radius), (0.0, 0.0, 0.0));
        assert_eq!((state.load, state.friction_force, state.fraction_in_contact), (0.0, 0.0, 0.0));
        assert!(state.plasticity_index > 0.0);
        if separation > 63.3 {
            assert_eq!(state.mean_asperity_pressure, 0.0);
        }
    }
}

#[test]
fn the_elastic_assumption_fails_where_contacts_yield() {
    let params = hertzian();
    // So heavy a load that the mean pressure passes its limit before the index does.
    let separation = -3.0 * params.height_std;
    let at_hardness = |hardness: f64| {
        let model = model(&Params { hardness, ..params.clone() });
        model.state_at_gap(separation).expect("a state")
    };
    let elastic = at_hardness(0.0);
    assert_eq!(
        (elastic.plasticity_index, elastic.warnings & WARNING_PLASTIC),
        (0.0, 0),
        "without a hardness nothing is known"
    );
    let pressure = elastic.mean_asperity_pressure;
    assert_near(pressure, elastic.load / elastic.real_area, 1e-12, "all of the load is carried by contacts");
    let (hard, soft) = (at_hardness(pressure / 0.4 * (1.0 + 1e-6)), at_hardness(pressure / 0.4 * (1.0 - 1e-6)));
    assert_eq!((hard.warnings & WARNING_PLASTIC, soft.warnings & WARNING_PLASTIC), (0, WARNING_PLASTIC));
    let rough = params.composite_modulus * (params.height_std / params.summit_radius).sqrt();
    assert_near(soft.plasticity_index, rough / (pressure / 0.4 * (1.0 - 1e-6)), 1e-12, "(E*/H) (sigma/R)^(1/2)");
    assert!(soft.plasticity_index < 1.0, "the pressure alone warns");

    // At light load the mean pressure is below the limit, the index warns nevertheless.
    for (hardness, warnings) in [(rough * (1.0 + 1e-9), 0), (rough * (1.0 - 1e-9), WARNING_PLASTIC)] {
        let model = model(&Params { hardness, ..params.clone() });
        let state = model.state_at_gap(6.0 * params.height_std).expect("a state");
        assert!(state.mean_asperity_pressure < 0.4 * hardness);
        assert_eq!(state.warnings & WARNING_PLASTIC, warnings, "plasticity index {}", state.plasticity_index);
    }
}
