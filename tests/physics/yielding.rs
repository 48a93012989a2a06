//! Summits that yield: against reference values, limits, and an integration over heights of the law as docs/model.md has
//! it, written down anew.
//!
//! `reference/yielding.json`: 18 surfaces, computed without the library and checked against arbitrary precision. Units: E*
//! b^2 for load, G* b^2 for friction, b^2 for area, G* b for stiffness, b for displacement, sigma for separation, one
//! summit.

use crate::common::second_evaluation::heights::{Heights, Johnson, Table};
use crate::common::surfaces::{dimensionless, johnson, model};
use crate::common::{assert_near, reference_rows};
use asperity::asperity::slip::SlipConstants;
use asperity::{ContactLawKind, Error, HeightFamily, Model, Params, SlipOnset};
use serde::Deserialize;
use std::f64::consts::PI;

#[derive(Deserialize)]
pub struct Case {
    pub params: CaseParams,
    pub rows: Vec<Row>,
}

#[derive(Debug, Deserialize)]
pub struct CaseParams {
    alpha: f64,
    beta: f64,
    eta: f64,
    eps: f64,
    rho: f64,
    omega: Option<f64>,
    q: f64,
}

#[derive(Deserialize)]
pub struct Row {
    pub separation: f64,
    pub load: f64,
    pub friction: f64,
    area: f64,
    contacting: f64,
    elastic: f64,
    flowing: f64,
    pub tangential_stiffness: f64,
    /// Displacement, force, stiffness.
    pub tangential: Vec<[f64; 3]>,
}

pub fn cases() -> Vec<Case> {
    reference_rows::read("yielding.json")
}

impl CaseParams {
    pub fn params(&self) -> Params {
        Params {
            hardness: self.eta,
            tangential_modulus: self.q,
            contact_law: ContactLawKind::ElasticPlastic,
            // What the rows are of.
            slip_onset: SlipOnset::Whole,
            heights: self.omega.map_or(HeightFamily::Gaussian, |shape| HeightFamily::Weibull { shape }),
            radius_amplitude: self.eps,
            radius_rate: self.rho,
            ..in_units_of_one(self.alpha, self.beta)
        }
    }
}

/// E* = G* = b = N = 1, no adhesion.
fn in_units_of_one(alpha: f64, beta: f64) -> Params {
    Params {
        composite_modulus: 1.0,
        effective_shear_modulus: 1.0,
        work_of_adhesion: 0.0,
        height_std: alpha * beta,
        summit_radius: beta / alpha,
        ..Params::paper()
    }
}

#[test]
fn reference_values_are_reproduced() {
    let (mut rows, mut worst) = (0, 0.0_f64);
    for case in cases() {
        let params = case.params.params();
        let model = model(&params);
        for row in &case.rows {
            let state = model.state_at_gap(row.separation * params.height_std).expect("a state");
            for (name, found, expected, scale) in [
                ("load", state.load, row.load, row.load),
                ("friction", state.friction_force, row.friction, row.friction),
                ("area", state.real_area, row.area, row.area),
                ("contacting", state.contacting, row.contacting, row.contacting),
                ("elastic", state.fraction_elastic * state.contacting, row.elastic, row.contacting),
                ("flowing", state.fraction_flowing * state.contacting, row.flowing, row.contacting),
                ("stiffness", state.tangential_stiffness, row.tangential_stiffness, row.tangential_stiffness),
            ] {
                let error = (found - expected).abs() / scale;
                worst = worst.max(error);
                assert!(error < 1e-10, "{:?} at {}: {name} {found:e}, not {expected:e}", case.params, row.separation);
            }
            rows += 1;
        }
    }
    println!("{rows} rows, worst {worst:e}");
    assert_eq!(rows, 54);
}

/// Friction and stiffness by the tables, from light loads to heavy ones, where heights pass first yield and flow far from
/// their mean too.
#[test]
fn compiled_laws_are_exact_states_to_1e_8() {
    let mut all: Vec<Params> = cases().iter().map(|case| case.params.params()).collect();
    let yielding = |heights: HeightFamily, hardness: f64| Params {
        hardness,
        contact_law: ContactLawKind::ElasticPlastic,
        heights,
        ..in_units_of_one(0.02, 2000.0)
    };
    let heights = HeightFamily::Tabulated {
        height: [-3.0, -1.0, 0.0, 1.0, 1.5].into(),
        density: [0.0, 1.0, 0.1, 1.0, 0.0].into(),
    };
    for hardness in [1e-5, 0.003, 0.3, 100.0] {
        all.push(yielding(heights.clone(), hardness));
        all.push(yielding(HeightFamily::Gaussian, hardness));
        all.push(yielding(johnson(-0.8, 3.4), hardness));
        all.push(Params { radius_amplitude: 1.0, ..yielding(johnson(0.8, 4.5), hardness) });
        all.push(Params { radius_amplitude: -0.95, radius_rate: 2.0, ..yielding(HeightFamily::Gaussian, hardness) });
    }
    for params in &all {
        let model = model(params);
        let summary = model.summary();
        assert!(summary.table_error < 1e-6, "{params:?}: {:e}", summary.table_error);
        let (lightest, heaviest) = (summary.min_table_load, summary.max_table_load);
        assert!(heaviest > 1e18 * lightest, "{params:?}: {lightest:e} to {heaviest:e}");
        for i in 0..60 {
            let load = lightest * (heaviest / lightest).powf((f64::from(i) + 0.37) / 60.0);
            let state = model.state_at_load(load).expect("a state");
            let force = model.friction_force_at_load(load) / state.friction_force - 1.0;
            let stiffness = model.tangential_stiffness_at_load(load) / state.tangential_stiffness - 1.0;
            assert!(force.abs() < 1e-6, "{params:?}: force at {load:e} off by {force:e}");
            assert!(stiffness.abs() < 1e-6, "{params:?}: stiffness at {load:e} off by {stiffness:e}");
        }
    }
}

/// Flowing summits carry a load that is proportional to the overlap: heavy ones are far deeper than elastic summits.
#[test]
fn states_reach_the_heaviest_load_that_there_may_be() {
    for (alpha, beta, hardness, radius_amplitude) in
        [(0.02, 2000.0, 0.003, 0.0), (10.0, 0.1, 1e-5, 0.0), (1e-5, 0.1, 1e-5, 0.0), (10.0, 0.1, 1e-5, 0.9)]
    {
        let contact_law = ContactLawKind::ElasticPlastic;
        let model = model(&Params { hardness, contact_law, radius_amplitude, ..in_units_of_one(alpha, beta) });
        for load in [1e40, 1e60, 9.9e79] {
            let state = model.state_at_load(load).unwrap_or_else(|error| panic!("{alpha} {beta}: {error}"));
            let (area, expected) = (state.real_area, load / hardness);
            assert!((area / expected - 1.0).abs() < 1e-12, "{alpha} {beta}: {area:e}, not {expected:e}");
        }
    }
}

#[test]
fn without_an_end_of_hardness_summits_are_those_of_hertz() {
    for (epsilon, heights) in [(0.0, HeightFamily::Gaussian), (-0.6, johnson(0.5, 4.0))] {
        let elastic = Params { radius_amplitude: epsilon, heights, ..in_units_of_one(0.01, 1000.0) };
        let hard = Params { hardness: 100.0, contact_law: ContactLawKind::ElasticPlastic, ..elastic.clone() };
        let [elastic, hard] = [elastic, hard].map(|params| model(&params));
        for load in [1e-6, 1.0, 1e4, 1e8] {
            let [a, b] = [&hard, &elastic].map(|model| model.state_at_load(load).expect("a state"));
            for (a, b) in [
                (a.friction_force, b.friction_force),
                (a.real_area, b.real_area),
                (a.gap, b.gap),
                (a.dforce_dload, b.dforce_dload),
                (a.tangential_stiffness, b.tangential_stiffness),
                (hard.friction_at_load(load), elastic.friction_at_load(load)),
                (a.fraction_elastic, 1.0),
                (a.fraction_flowing + 1.0, 1.0),
            ] {
                assert_near(a, b, 1e-12, &format!("at {load}, epsilon {epsilon}"));
            }
        }
    }
}

/// The area of soft summits is the load over the hardness, whatever their shape.
#[test]
fn soft_summits_carry_the_load_on_an_area_of_load_over_hardness() {
    for (epsilon, heights) in [(0.0, HeightFamily::Gaussian), (0.9, HeightFamily::Weibull { shape: 2.0 })] {
        let params = Params {
            hardness: 1e-5,
            contact_law: ContactLawKind::ElasticPlastic,
            radius_amplitude: epsilon,
            heights,
            ..in_units_of_one(1.0, 1000.0)
        };
        let model = model(&params);
        for d in [-2.0, 0.0, 1.5] {
            let state = model.state_at_gap(d * params.height_std).expect("a state");
            assert_near(state.real_area * params.hardness, state.load, 1e-12, &format!("area at {d}"));
            assert_near(state.mean_asperity_pressure, params.hardness, 1e-12, &format!("pressure at {d}"));
            assert!(state.fraction_flowing > 1.0 - 1e-6 && state.fraction_elastic < 1e-6, "{state:?}");
            // mu = tau/H: between the strengths of the smallest and the largest contacts.
            let mu = state.friction_force / state.load * params.hardness;
            assert!(mu > params.slip.stress_2 && mu < params.slip.stress_1, "{mu}");
        }
    }
}

/// What elastic summits are told of yield: how many would have begun to.
#[test]
fn elastic_summits_of_a_known_hardness_are_counted_by_the_overlap_of_first_yield() {
    let yielding = Params {
        hardness: 0.01,
        contact_law: ContactLawKind::ElasticPlastic,
        radius_amplitude: -0.5,
        ..in_units_of_one(0.01, 1000.0)
    };
    let elastic = Params { contact_law: ContactLawKind::Maugis, ..yielding.clone() };
    let unknown = Params { hardness: 0.0, ..elastic.clone() };
    let [yielding, elastic, unknown] = [yielding, elastic, unknown].map(|params| model(&params));
    for separation in [-5.0, 0.0, 15.0] {
        let [yielding, elastic, unknown] =
            [&yielding, &elastic, &unknown].map(|model| model.state_at_gap(separation).expect("a state"));
        assert!(elastic.fraction_elastic > 0.1 && elastic.fraction_elastic < 0.9, "{elastic:?}");
        assert_near(elastic.fraction_elastic, yielding.fraction_elastic, 1e-12, "elastic");
        assert_eq!((elastic.fraction_flowing, unknown.fraction_flowing), (0.0, 0.0));
        assert_near(unknown.fraction_elastic, 1.0, 1e-14, "of unknown hardness");
        assert_near(elastic.friction_force, unknown.friction_force, 1e-15, "friction");
    }
    let adhesive = model(&Params { hardness: 0.02, ..dimensionless(0.01, 1000.0, 1e-3, 1.0) });
    let state = adhesive.state_at_load(100.0).expect("a state");
    assert!(state.fraction_elastic > 0.0 && state.fraction_elastic <= 1.0, "{state:?}");
}

/// A surface of summits that yield, summed over heights by Simpson's rule between all kinks.
struct Second {
    params: Params,
    heights: Heights,
    alpha: f64,
    beta: f64,
}

/// Contacts, load, area, friction, sum of radii, tangential force, elastic and flowing contacts.
type Totals = [f64; 8];

impl Second {
    fn new(params: Params, heights: Heights) -> Self {
        let Params { height_std, summit_radius, .. } = params;
        Self { alpha: (height_std / summit_radius).sqrt(), beta: (height_std * summit_radius).sqrt(), params, heights }
    }

    fn g(&self, z: f64) -> f64 {
        1.0 + self.params.radius_amplitude * (self.params.radius_rate * z).tanh()
    }

    /// The overlaps of first yield and flow.
    fn yields(&self, z: f64) -> [f64; 2] {
        let first = (3.0 * PI * 0.4 * self.params.hardness / 4.0 / self.alpha).powi(2) * self.g(z);
        [first, 54.0 * first]
    }

    /// Contact radius and load at an overlap.
    fn contact(&self, z: f64, u: f64) -> (f64, f64) {
        let [first, flow] = self.yields(z);
        let hertz = self.beta * self.beta * self.g(z) * u;
        if u <= first {
            let a = hertz.sqrt();
            return (a, 4.0 * self.alpha / (3.0 * self.beta * self.g(z)) * a.powi(3));
        }
        let s = ((u - first) / (flow - first)).min(1.0);
        let square = hertz * (1.0 + 3.0 * s * s - 2.0 * s * s * s);
        let pressure = self.params.hardness * (1.0 - 0.6 * (flow / u).max(1.0).ln() / 54_f64.ln());
        (square.sqrt(), PI * square * pressure)
    }

    fn friction(&self, a: f64) -> f64 {
        let SlipConstants { radius_1, stress_1, radius_2, stress_2 } = self.params.slip;
        let exponent = (stress_1 / stress_2).ln() / (radius_2 / radius_1).ln();
        PI * a * a * (stress_1 * (a / radius_1).max(1.0).powf(-exponent)).max(stress_2)
    }

    fn summit(&self, z: f64, u: f64, stick: f64) -> Totals {
        let [first, flow] = self.yields(z);
        let (a, load) = self.contact(z, u);
        let friction = self.friction(a);
        let of = |holds: bool| f64::from(u8::from(holds));
        [1.0, load, PI * a * a, friction, a, friction.min(stick * a), of(u < first), of(u > flow)]
    }

    /// At a separation, in sigma; a contact that sticks bears `stick` times its radius.
    fn at_separation(&self, separation: f64, stick: f64) -> Totals {
        let (lower, upper, _) = self.heights.range(separation);
        // z = separation + t^2
        let (from, to) = ((lower - separation).max(0.0).sqrt(), (upper - separation).sqrt());
        let excesses = |t: f64| -> [f64; 5] {
            let (z, u) = (separation + t * t, t * t);
            let [first, flow] = self.yields(z);
            let (a, _) = self.contact(z, u);
            let slip = self.params.slip;
            let sticks = if a > 0.0 { stick * a - self.friction(a) } else { stick };
            [u - first, u - flow, a - slip.radius_1, a - slip.radius_2, sticks]
        };
        const LOOKS: u32 = 4000;
        let at = |i: u32| from + (to - from) * f64::from(i) / f64::from(LOOKS);
        let mut cuts = vec![from, to];
        for i in 0..LOOKS {
            for kink in 0..5 {
                let (mut below, mut above) = (at(i), at(i + 1));
                let sign = excesses(below)[kink] < 0.0;
                if (excesses(above)[kink] < 0.0) == sign {
                    continue;
                }
                for _ in 0..60 {
                    let middle = 0.5 * (below + above);
                    *if (excesses(middle)[kink] < 0.0) == sign { &mut below } else { &mut above } = middle;
                }
                cuts.push(0.5 * (below + above));
            }
        }
        let breaks = self.heights.cuts().into_iter().filter(|&z| z > separation).map(|z| (z - separation).sqrt());
        cuts.extend(breaks.filter(|&t| t > from && t < to));
        cuts.sort_by(f64::total_cmp);
        let mut totals = [0.0; 8];
        for ends in cuts.windows(2).filter(|ends| ends[1] - ends[0] > 1e-12) {
            // Not at the ends themselves, where a count may be that of either side.
            const PANELS: u32 = 1500;
            let step = (ends[1] - ends[0]) / f64::from(PANELS);
            for i in 0..PANELS {
                for (node, weight) in [(-0.6_f64.sqrt(), 5.0), (0.0, 8.0), (0.6_f64.sqrt(), 5.0)] {
                    let t = ends[0] + step * (f64::from(i) + 0.5 + 0.5 * node);
                    let z = separation + t * t;
                    let factor = 2.0 * t * self.heights.log_density(z).exp() * step * weight / 18.0;
                    let summit = self.summit(z, t * t, stick);
                    totals = std::array::from_fn(|k| totals[k] + factor * summit[k]);
                }
            }
        }
        totals
    }
}

/// Of heights that the reference does not have, with radii that change so steeply that a kink passes the heights more than
/// once, and with a strength that falls so fast with the contact radius that contacts of three sizes begin to slip at once.
#[test]
fn sums_are_those_of_an_integration_over_heights() {
    let curve = Johnson::new(true, 0.7, 1.6);
    let table = Table::new(vec![-3.0, -1.0, 0.0, 1.0, 1.5], vec![0.0, 1.0, 0.1, 1.0, 0.0]);
    let falling = SlipConstants { radius_1: 100.0, stress_1: 0.1, radius_2: 1000.0, stress_2: 0.002 };
    let mut compared = 0;
    for (alpha, beta, hardness, radii, slip) in [
        (0.03, 3000.0, 0.008, [0.0, 1.0], SlipConstants::default()),
        (0.02, 1500.0, 0.02, [0.7, 3.0], falling),
        (0.05, 500.0, 0.01, [-0.9, 0.6], falling),
        (0.01, 5000.0, 0.01, [0.95, 8.0], SlipConstants::default()),
    ] {
        for heights in [Heights::Gaussian, Heights::Johnson(curve.clone()), Heights::Table(table.clone())] {
            let family = match &heights {
                Heights::Gaussian => HeightFamily::Gaussian,
                Heights::Johnson(curve) => johnson(curve.skew, curve.kurtosis),
                Heights::Table(table) => HeightFamily::Tabulated {
                    height: table.height.clone().into(),
                    density: table.density.clone().into(),
                },
                Heights::Weibull { .. } | Heights::Scores(_) => panic!("other tests have them"),
            };
            let params = Params {
                hardness,
                contact_law: ContactLawKind::ElasticPlastic,
                heights: family,
                radius_amplitude: radii[0],
                radius_rate: radii[1],
                slip,
                tangential_modulus: 0.25,
                slip_onset: SlipOnset::Whole,
                ..in_units_of_one(alpha, beta)
            };
            let model = model(&params);
            let second = Second::new(params.clone(), heights);
            for d in [-1.5, 0.2, 1.1] {
                let state = model.state_at_gap(d * params.height_std).expect("a state");
                let displacement = 0.4 * state.friction_force / state.tangential_stiffness;
                let force = model.tangential_at_load(state.load, displacement).expect("a force").0;
                let expected = second.at_separation(d, 8.0 * 0.25 * displacement);
                let stiffness = 8.0 * 0.25 * expected[4];
                for (name, found, expected) in [
                    ("contacting", state.contacting, expected[0]),
                    ("load", state.load, expected[1]),
                    ("area", state.real_area, expected[2]),
                    ("friction", state.friction_force, expected[3]),
                    ("stiffness", state.tangential_stiffness, stiffness),
                    ("tangential force", force, expected[5]),
                    ("elastic", 1.0 + state.fraction_elastic, 1.0 + expected[6] / expected[0]),
                    ("flowing", 1.0 + state.fraction_flowing, 1.0 + expected[7] / expected[0]),
                ] {
                    assert_near(found, expected, 1e-9, &format!("{name} of {params:?} at {d}"));
                    compared += 1;
                }
            }
        }
    }
    assert_eq!(compared, 4 * 3 * 3 * 8);
}

#[test]
fn what_yielding_summits_cannot_have_is_refused_with_a_reason() {
    let yielding = Params { contact_law: ContactLawKind::ElasticPlastic, ..in_units_of_one(0.01, 1000.0) };
    let refused = |params: Params| -> Error { Model::new(&params).expect_err("no model") };
    let soft = Params { hardness: 0.01, ..yielding.clone() };
    assert!(Model::new(&soft).is_ok());
    for (error, begins) in [
        (refused(yielding), "hardness = 0: must be > 0 where contact_law is ASPERITY_CONTACT_ELASTIC_PLASTIC (1)"),
        (
            refused(Params { work_of_adhesion: 1e-3, ..soft.clone() }),
            "work_of_adhesion = 0.001: must be 0 where contact_law is ASPERITY_CONTACT_ELASTIC_PLASTIC (1)",
        ),
        (refused(Params { hardness: -1.0, ..soft.clone() }), "hardness = -1: must be finite and >= 0"),
        (refused(Params { hardness: f64::NAN, ..soft.clone() }), "hardness = NaN: must be finite and >= 0"),
        (refused(Params { tangential_modulus: -1.0, ..soft.clone() }), "tangential_modulus = -1: must be finite"),
        (refused(Params { tangential_modulus: f64::NAN, ..soft }), "tangential_modulus = NaN: must be finite"),
    ] {
        assert!(error.to_string().starts_with(begins), "{error}");
        assert!(matches!(error, Error::InvalidParameter { .. }), "{error:?}");
    }
}
