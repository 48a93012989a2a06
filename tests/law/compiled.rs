//! The compiled law is the exact model: values, slopes, joints between rows, the pull-off point, on random surfaces.

use crate::common::neighbours::Neighbours;
use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{crowded, dimensionless, model};
use asperity::{Error, HeightFamily, Model, Params};

const SEED: u64 = 0x5eed_1a40;
const SETS: usize = 48;
const LOADS: usize = 40;

/// A surface drawn from what the library is used for.
fn random_params(random: &mut SplitMix) -> Params {
    let alpha = random.log_between(1e-3, 0.1);
    let beta = random.log_between(50.0, 1e5);
    let gamma = if random.chance(0.2) { 0.0 } else { random.log_between(1e-5, 0.02) };
    let b_over_h = random.between(0.3, 1.5);
    let mut params = dimensionless(alpha, beta, gamma, b_over_h);
    params.heights = random_heights(random);
    if random.chance(0.3) {
        params.radius_amplitude = random.between(-1.0, 1.0);
        params.radius_rate = random.log_between(0.1, 5.0);
    }
    params
}

/// Heights of any family; of tables few enough that rows lie between their kinks.
fn random_heights(random: &mut SplitMix) -> HeightFamily {
    match random.below(7) {
        0 | 1 => HeightFamily::Gaussian,
        2 | 3 => HeightFamily::Weibull { shape: random.log_between(1.1, 60.0) },
        4 => {
            let skew = random.between(-2.0, 2.0);
            HeightFamily::Johnson { skew, kurtosis: 1.87 + 1.25 * skew * skew + random.log_between(0.01, 10.0) }
        }
        5 => {
            // Each stretch is up to three times as steep as its neighbour, in height and in slope.
            let [mut at, mut rise, mut square] = [0.0, 1.0, 1.0];
            let rows = (0..13).map(|_| {
                at += rise;
                rise *= random.log_between(1.0 / 3.0, 3.0);
                square *= random.log_between(0.5, 2.0);
                (at, square)
            });
            let (height, slope): (Vec<f64>, Vec<f64>) = rows.unzip();
            HeightFamily::AtScores { height: height.into(), slope: slope.into() }
        }
        _ => {
            let count = 4 + random.below(16);
            let mut at = 0.0;
            let mut height = || {
                at += random.between(0.2, 1.0);
                at
            };
            let height: Vec<f64> = (0..count).map(|_| height()).collect();
            let density: Vec<f64> =
                (0..count).map(|_| if random.chance(0.1) { 0.0 } else { random.between(0.1, 1.0) }).collect();
            HeightFamily::Tabulated { height: height.into(), density: density.into() }
        }
    }
}

/// The models of the random surfaces, of which every other knows its nominal area; one that is refused must be so for a documented
/// reason.
pub fn random_models(seed: u64, count: usize) -> Vec<Model> {
    let mut random = SplitMix(seed);
    let mut models = Vec::new();
    for set in 0..count {
        let share = 1e-4 * 1e5_f64.powf(set as f64 / count as f64);
        let params = random_params(&mut random);
        let params = if set % 2 == 0 { params } else { crowded(params, share) };
        match Model::new(&params) {
            Ok(model) => models.push(model),
            Err(Error::OutOfRange { .. } | Error::NotConverged { .. }) => {}
            Err(other) => panic!("seed {seed:#x}, set {set}: {params:?}: {other}"),
        }
    }
    assert!(models.len() * 10 >= count * 9, "seed {seed:#x}: {} of {count} surfaces are refused", count - models.len());
    models
}

/// The range of load - pull-off in which table and exact evaluation are compared.
fn excess_range(model: &Model) -> (f64, f64) {
    let summary = model.summary();
    let nearest = summary.min_table_load - summary.pull_off_load;
    (nearest.max(1e-9 * -summary.pull_off_load), summary.max_table_load - summary.pull_off_load)
}

fn relative(a: f64, b: f64) -> f64 {
    (a / b - 1.0).abs()
}

/// All claims of a test are looked at before it fails, so that one run shows every surface at fault.
#[derive(Default)]
pub struct Failures(Vec<String>);

impl Failures {
    pub fn claim(&mut self, holds: bool, failure: impl FnOnce() -> String) {
        if !holds {
            self.0.push(failure());
        }
    }

    pub fn report(self) {
        let shown = self.0.iter().take(8).map(String::as_str).collect::<Vec<_>>().join("\n");
        assert!(self.0.is_empty(), "{} failures, seed {SEED:#x}, the first:\n{shown}", self.0.len());
    }
}

#[test]
fn the_table_agrees_with_exact_evaluation() {
    let mut random = SplitMix(SEED ^ 1);
    let mut failures = Failures::default();
    for model in random_models(SEED, SETS) {
        let summary = model.summary();
        let (nearest, farthest) = excess_range(&model);
        let mut found = 0.0_f64;
        for i in 0..LOADS {
            let part = (i as f64 + random.between(0.0, 1.0)) / LOADS as f64;
            let load = summary.pull_off_load + nearest * (farthest / nearest).powf(part);
            let exact = match model.state_at_load(load) {
                Ok(exact) => exact,
                Err(error) => {
                    failures.claim(false, || format!("load {load:e}: {error}; {:?}", model.params()));
                    continue;
                }
            };
            let (force, slope) = model.friction_force_and_slope(load);
            let error = relative(force, exact.friction_force);
            let slope_error = relative(slope, exact.dforce_dload);
            failures.claim(error <= 1e-6, || {
                let exact = exact.friction_force;
                format!("load {load:e}: force {force:e}, exactly {exact:e}, error {error:e}; {:?}", model.params())
            });
            failures.claim(slope_error <= 1e-4, || {
                let exact = exact.dforce_dload;
                format!(
                    "load {load:e}: slope {slope:e}, exactly {exact:e}, error {slope_error:e}; {:?}",
                    model.params()
                )
            });
            // From K_t follows the conductance.
            let radii = model.tangential_stiffness_at_load(load) / summary.stiffness_per_radius;
            let off = relative(radii, exact.contact_radius_sum);
            failures.claim(off <= 1e-6, || {
                format!("load {load:e}: sum of contact radii {radii:e}, off by {off:e}; {:?}", model.params())
            });
            found = found.max(error);
        }
        failures.claim(found <= summary.table_error, || {
            format!("table_error {:e}, but {found:e} is found; {:?}", summary.table_error, model.params())
        });
    }
    failures.report();
}

/// The last load at which load - pull-off is below x, and the first at which it is not.
fn around(pull_off: f64, x: f64) -> (f64, f64) {
    let mut load = pull_off + x;
    while load - pull_off >= x {
        load = load.below();
    }
    while load.above() - pull_off < x {
        load = load.above();
    }
    (load, load.above())
}

#[test]
fn force_and_slope_are_continuous_where_rows_meet() {
    let mut failures = Failures::default();
    let (mut edges, mut between_parts) = (0, 0);
    for model in random_models(SEED ^ 2, 24) {
        let pull_off = model.summary().pull_off_load;
        let (nearest, farthest) = excess_range(&model);
        // Sixteenths of a binade are edges of any table: it has 2 or 8 rows a binade.
        let sixteenth = 1_u64 << 48;
        let mut bits = nearest.to_bits() / sixteenth * sixteenth;
        while f64::from_bits(bits) <= farthest {
            let x = f64::from_bits(bits);
            bits += sixteenth;
            let (below, at) = around(pull_off, x);
            let ((f, s), (force, slope)) = (model.friction_force_and_slope(below), model.friction_force_and_slope(at));
            let step = at - below;
            let jump = (force - f - 0.5 * (s + slope) * step).abs() / force;
            // The slope of the smooth curve changes by no more than x does.
            let slope_jump = (relative(s, slope) - 2.0 * step / x).max(0.0);
            edges += 1;
            // Whole rows meet to rounding, and the last part of a divided row meets the next row as well as parts meet the curve.
            if jump <= 2e-10 && slope_jump <= 1e-7 {
                between_parts += usize::from(jump > 1e-12);
                continue;
            }
            failures
                .claim(false, || format!("x {x:e}: jump {jump:e}, of the slope {slope_jump:e}; {:?}", model.params()));
        }
    }
    println!("{edges} edges");
    assert!(between_parts * 500 < edges, "{between_parts} of {edges} edges meet to no more than 1e-12");
    failures.report();
}

#[test]
fn friction_force_grows_with_load() {
    let mut failures = Failures::default();
    for model in random_models(SEED ^ 3, 24) {
        let pull_off = model.summary().pull_off_load;
        let (nearest, farthest) = excess_range(&model);
        let mut sweep = |factor: f64, from: f64, to: f64| {
            let mut x = from;
            let (mut last_load, mut last) = (pull_off, model.friction_force_at_load(pull_off));
            while x < to {
                let load = pull_off + x;
                let force = model.friction_force_at_load(load);
                failures.claim(force >= last && force > 0.0, || {
                    format!("load {load:e}: {force:e} after {last:e} at {last_load:e}; {:?}", model.params())
                });
                (last_load, last) = (load, force);
                x *= factor;
            }
        };
        // The table; then across its two ends, beyond which the law goes on as a power.
        sweep(1.0 + 1.0 / 512.0, nearest, farthest);
        let smallest = (4.0 * f64::EPSILON * -pull_off).max(1e-3 * nearest);
        sweep(1.5, smallest, 10.0 * nearest);
        sweep(1.3, 0.1 * farthest, 100.0 * farthest);
    }
    failures.report();
}

#[test]
fn a_heavier_pull_than_pull_off_leaves_no_friction() {
    for model in random_models(SEED ^ 5, 24) {
        let pull_off = model.summary().pull_off_load;
        for load in [pull_off.below(), 2.0 * pull_off - 1e-300, -1e300, -f64::MAX] {
            let (force, slope) = model.friction_force_and_slope(load);
            assert_eq!((force, slope), (0.0, 0.0), "load {load:e}, {:?}", model.params());
            assert_eq!(model.friction_and_slope(load), (0.0, 0.0), "load {load:e}, {:?}", model.params());
            assert!(matches!(model.state_at_load(load), Err(Error::Separated { .. })), "{:?}", model.params());
        }
    }
}

#[test]
fn friction_at_pull_off_is_that_of_the_summary_with_infinite_slope() {
    let mut failures = Failures::default();
    for model in random_models(SEED ^ 6, 32) {
        let summary = model.summary();
        if summary.pull_off_load == 0.0 {
            continue;
        }
        let params = model.params();
        let (pull_off, at_pull_off) = (summary.pull_off_load, summary.pull_off_friction_force);
        let (force, slope) = model.friction_force_and_slope(pull_off);
        failures.claim(relative(force, at_pull_off) <= 1e-13, || {
            format!("at pull-off {pull_off:e}: {force:e}, in the summary {at_pull_off:e}; {params:?}")
        });
        failures.claim(slope == f64::INFINITY, || format!("slope {slope:e} at pull-off {pull_off:e}; {params:?}"));
        // Of a surface that hardly adheres the table ends above zero load, and the law goes on as another power.
        if summary.min_table_load > 0.0 {
            continue;
        }
        // Towards pull-off the force falls to that, as the root of the distance; the slope grows, finite.
        let loads = [
            pull_off.above(),
            pull_off.above().above(),
            pull_off * (1.0 - 1e-12),
            pull_off * (1.0 - 1e-9),
            pull_off * (1.0 - 1e-6),
        ];
        let mut last = (force, f64::INFINITY);
        for load in loads {
            let (force, slope) = model.friction_force_and_slope(load);
            let x = load - pull_off;
            failures.claim(force > last.0 && slope < last.1 && slope > 0.0, || {
                format!("x {x:e} above pull-off {pull_off:e}: {force:e}, slope {slope:e}, after {last:?}; {params:?}")
            });
            // F = F0 + c x^(1/2) to first order, of which F' = c x^(-1/2)/2.
            let rise = force - at_pull_off;
            let root = 2.0 * slope * x;
            failures.claim((rise - root).abs() <= 0.05 * rise + 1e-13 * at_pull_off, || {
                format!("x {x:e} above pull-off {pull_off:e}: rise {rise:e}, by the slope {root:e}; {params:?}")
            });
            last = (force, slope);
        }
    }
    failures.report();
}

/// Beyond the table: value and slope go on where it ends, and a decade farther the local power is still that of its end.
#[test]
fn beyond_the_table_the_law_goes_on_with_its_slope_as_a_power_of_the_load() {
    let mut failures = Failures::default();
    for model in random_models(SEED ^ 7, 32) {
        let summary = model.summary();
        let (pull_off, base) = (summary.pull_off_load, summary.pull_off_friction_force);
        for (end, base, onwards) in [(summary.min_table_load, base, 0.1), (summary.max_table_load, 0.0, 10.0)] {
            let x = end - pull_off;
            let power = |load: f64| {
                let (force, slope) = model.friction_force_and_slope(load);
                slope * (load - pull_off) / (force - base)
            };
            let (below, above) = (end - 1e-9 * x, end + 1e-9 * x);
            let ((force, slope), (next, next_slope)) =
                (model.friction_force_and_slope(below), model.friction_force_and_slope(above));
            // Of a difference from the force at pull-off the digits are fewer.
            let known = 1e-7 + 1e-15 * next / (next - base);
            failures.claim(relative(next, force) < 1e-8 && relative(next_slope, slope) < 1e-6, || {
                format!("at {end:e}: {force:e}, {slope:e}, then {next:e}, {next_slope:e}; {:?}", model.params())
            });
            let far = pull_off + onwards * x;
            failures.claim((power(far) - power(end)).abs() < known.max(1e-6), || {
                format!("at {end:e}: power {}, then {}; {:?}", power(end), power(far), model.params())
            });
        }
        // Down to pull-off and zero load friction falls, and is not less than at pull-off.
        let (lightest, zero) = (model.friction_force_at_load(summary.min_table_load), summary.zero_load_friction_force);
        let is_beyond = summary.min_table_load > 0.0;
        failures
            .claim(zero >= base && (!is_beyond || zero <= lightest), || format!("{base:e}, {zero:e}, {lightest:e}"));
    }
    failures.report();
}

#[test]
fn without_adhesion_friction_vanishes_with_load() {
    let model = model(&dimensionless(0.01, 1000.0, 0.0, 1.0));
    let summary = model.summary();
    assert_eq!((summary.pull_off_load, summary.pull_off_friction_force), (0.0, 0.0));
    // Newton's method wants a slope at 0, too, but none of an open contact.
    let lightest = model.friction_force_and_slope(summary.min_table_load).1;
    assert!(lightest > 0.0 && lightest.is_finite());
    for (load, slope) in [(0.0, lightest), (-0.0, lightest), (-1e-300, 0.0)] {
        assert_eq!(model.friction_force_and_slope(load), (0.0, slope), "{load}");
        assert_eq!(model.friction_and_slope(load).1, 0.0, "{load}");
    }
    let mut last = 0.0;
    for exponent in -300..80 {
        let load = 10f64.powi(exponent);
        let force = model.friction_force_at_load(load);
        assert!(force > last, "load {load:e}: {force:e} after {last:e}");
        last = force;
    }
}
