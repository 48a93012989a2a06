//! Families of heights beyond the paper's: Johnson's system and measured densities.

use crate::common::processor_time::{processor_time, LONGEST_CALL};
use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{self, bins, dimensionless, johnson, table};
use asperity::{Error, HeightFamily, Model, Params};

/// Loads over decades, from where a few summits touch to where all do; per summit in the paper's units.
const LOADS: [f64; 8] = [1e-6, 1e-3, 0.1, 1.0, 30.0, 1e3, 3e4, 1e6];

fn surface(gamma: f64, heights: HeightFamily) -> Params {
    Params { heights, ..dimensionless(0.01, 1000.0, gamma, 1.0) }
}

fn model(gamma: f64, heights: HeightFamily) -> Model {
    surfaces::model(&surface(gamma, heights))
}

/// A function at equal distances.
fn sampled(count: usize, from: f64, to: f64, density: impl Fn(f64) -> f64) -> HeightFamily {
    let height: Vec<f64> = (0..count).map(|i| from + (to - from) * i as f64 / (count - 1) as f64).collect();
    let density: Vec<f64> = height.iter().map(|&z| density(z)).collect();
    table(&height, &density)
}

fn bell(z: f64) -> f64 {
    (-0.5 * z * z).exp()
}

/// The largest relative difference of exact friction forces at loads.
fn difference(a: &Model, b: &Model, loads: &[f64]) -> f64 {
    let force = |model: &Model, load: f64| model.state_at_load(load).expect("a state").friction_force;
    loads.iter().map(|&load| (force(a, load) / force(b, load) - 1.0).abs()).fold(0.0, f64::max)
}

/// The kurtosis of the lognormal curve of a skew, between Johnson's two kinds.
fn lognormal_kurtosis(skew: f64) -> f64 {
    let (mut lower, mut upper) = (1.0, 2.0 + skew.abs());
    for _ in 0..100 {
        let w: f64 = 0.5 * (lower + upper);
        if (w + 2.0) * (w + 2.0) * (w - 1.0) < skew * skew {
            lower = w;
        } else {
            upper = w;
        }
    }
    let w: f64 = lower;
    w.powi(4) + 2.0 * w.powi(3) + 3.0 * w * w - 3.0
}

#[test]
fn the_gaussian_is_the_limit_of_johnsons_system() {
    for gamma in [0.0, 0.001, 0.003] {
        let gaussian = model(gamma, HeightFamily::Gaussian);
        assert_eq!(difference(&model(gamma, johnson(0.0, 3.0)), &gaussian, &LOADS), 0.0);
        for h in [1e-14, 1e-12] {
            for (skew, kurtosis) in [(0.0, 3.0 + h), (0.0, 3.0 - h), (h, 3.0), (-h, 3.0), (h, 3.0 + h), (-h, 3.0 - h)] {
                let error = difference(&model(gamma, johnson(skew, kurtosis)), &gaussian, &LOADS);
                assert!(error < 1e-10, "gamma {gamma}, skew {skew}, kurtosis {kurtosis}: {error:e}");
            }
        }
        // To first order the friction force moves by the same on both sides.
        for load in LOADS {
            let force = |heights| model(gamma, heights).state_at_load(load).expect("a state").friction_force;
            let middle = force(HeightFamily::Gaussian);
            for (name, a, b) in [
                ("kurtosis", johnson(0.0, 3.0 + 1e-5), johnson(0.0, 3.0 - 1e-5)),
                ("skew", johnson(1e-5, 3.0), johnson(-1e-5, 3.0)),
            ] {
                let (up, down) = (force(a) / middle - 1.0, force(b) / middle - 1.0);
                assert!((up + down).abs() < 5e-3 * up.abs() + 1e-12, "{name}, load {load}: {up:e}, {down:e}");
            }
        }
    }
}

#[test]
fn friction_is_continuous_across_the_lognormal_line() {
    // Not smooth: beside the line the two kinds move away from it in different directions.
    for skew in [-3.0, -1.0, -0.1, 0.1, 1.0, 3.0] {
        let kurtosis = lognormal_kurtosis(skew);
        let at = |part: f64| model(0.001, johnson(skew, kurtosis * (1.0 + part)));
        let on_it = at(0.0);
        for part in [1e-13, 1e-10, 1e-7, 1e-4] {
            for part in [part, -part] {
                let error = difference(&at(part), &on_it, &LOADS);
                assert!(error < 1e-11 + 300.0 * part.abs(), "skew {skew}, off the line by {part:e}: {error:e}");
            }
        }
    }
}

#[test]
fn johnsons_curve_of_weibulls_moments_nears_weibulls() {
    // Two distributions that share four moments differ in the fifth and beyond: more, the farther up in the tail lies what
    // carries the load. Here nearly all summits touch at a load of 1e5, a few in a hundred at 1e3.
    const LOADS: [f64; 4] = [1e3, 1e4, 1e5, 1e6];
    for shape in [1.5, 2.2, 3.602, 7.493] {
        let weibull = model(0.001, HeightFamily::Weibull { shape });
        let summary = weibull.summary();
        let johnson = model(0.001, johnson(summary.skew, summary.kurtosis));
        let gaussian = model(0.001, HeightFamily::Gaussian);
        let same = johnson.summary();
        assert_eq!((same.skew, same.kurtosis), (summary.skew, summary.kurtosis));
        for (load, most) in LOADS.into_iter().zip([0.03, 0.015, 1e-3, 1e-6]) {
            let share = weibull.state_at_load(load).expect("a state").contacting;
            let error = difference(&johnson, &weibull, &[load]);
            let of_gaussian = difference(&gaussian, &weibull, &[load]);
            println!("shape {shape}, load {load}, {share:.4} in contact: {error:.1e}, Gaussian {of_gaussian:.1e}");
            assert!(error < most && 2.0 * error < of_gaussian, "shape {shape}, load {load}: {error:e}");
        }
    }
}

#[test]
fn kurtosis_alone_changes_friction() {
    let mu = |kurtosis: f64| model(0.001, johnson(0.0, kurtosis)).friction_at_load(1.0);
    assert!((mu(6.0) / mu(2.5) - 1.0).abs() > 0.02, "{} and {}", mu(6.0), mu(2.5));
}

#[test]
fn impossible_and_extreme_moments_are_refused() {
    let refused = |skew, kurtosis| Model::new(&surface(0.001, johnson(skew, kurtosis))).expect_err("a refusal");
    for (skew, kurtosis) in
        [(0.0, 1.0), (1.0, 2.0), (-2.0, 4.9), (0.0, f64::NAN), (0.0, -3.0), (1e200, 1e299), (0.0, f64::INFINITY)]
    {
        let error = refused(skew, kurtosis);
        assert!(matches!(error, Error::InvalidParameter { name: "kurtosis", .. }), "{error}");
        assert!(error.to_string().contains("> skew^2 + 1"), "{error}");
    }
    assert!(matches!(refused(f64::NAN, 3.0), Error::InvalidParameter { name: "skew", .. }));
    for (skew, kurtosis, name, bound) in [
        (0.0, 100.1, "kurtosis", "at most 100"),
        (0.0, 1.8, "kurtosis", "at least 1.87 + 1.25 skew^2"),
        (1.0, 3.1, "kurtosis", "at least 1.87 + 1.25 skew^2"),
        (3.1, 30.0, "skew", "between -3 and 3"),
        (-40.0, 1e5, "skew", "between -3 and 3"),
    ] {
        let error = refused(skew, kurtosis);
        assert!(matches!(error, Error::OutOfRange { name: found, .. } if found == name), "{error}");
        assert!(error.to_string().contains(bound) && error.to_string().contains("take a table"), "{error}");
    }
}

/// A skew and a kurtosis from all over the domain, and next to its edge.
fn anywhere(random: &mut SplitMix) -> (f64, f64) {
    let skew = if random.chance(0.25) { 0.0 } else { random.between(-3.0, 3.0) };
    let least = 1.87 + 1.25 * skew * skew;
    (skew, (least + random.log_between(1e-6, 100.0)).min(100.0))
}

/// The compiled law is that of exact states, with its slope, at loads spread evenly over decades between two; friction rises with load.
fn assert_compiled(model: &Model, (from, to): (f64, f64), count: usize, name: &str) {
    let (pull_off, mut random, mut last) =
        (model.summary().pull_off_load, SplitMix(count as u64), (0.0, f64::INFINITY));
    for i in 0..count {
        let load = pull_off + from * (to / from).powf((i as f64 + random.between(0.0, 1.0)) / count as f64);
        let exact = model.state_at_load(load).unwrap_or_else(|error| panic!("{name}, load {load}: {error}"));
        let (force, slope) = model.friction_force_and_slope(load);
        let error = (force / exact.friction_force - 1.0).abs();
        assert!(error < 1e-6 && error <= model.summary().table_error, "{name}, load {load}: {error:e}");
        let slope_error = (slope / exact.dforce_dload - 1.0).abs();
        assert!(slope_error < 1e-4, "{name}, load {load}: slope {slope_error:e}");
        assert!(force > last.0 && exact.gap <= last.1 && exact.dload_dgap < 0.0, "{name}, load {load}: {exact:?}");
        last = (force, exact.gap);
    }
}

/// From next to pull-off to the end of the table.
fn whole_table(model: &Model) -> (f64, f64) {
    let summary = model.summary();
    let nearest = (summary.min_table_load - summary.pull_off_load).max(1e-9 * -summary.pull_off_load);
    (nearest, summary.max_table_load - summary.pull_off_load)
}

#[test]
fn the_whole_domain_makes_sound_models() {
    let mut random = SplitMix(0x000e_d6e5);
    let mut made = 0;
    for i in 0..80 {
        let (skew, kurtosis) = anywhere(&mut random);
        let gamma = [0.0, 0.0, 1e-4, 0.001, 0.003][random.below(5)];
        let mut params = surface(gamma, johnson(skew, kurtosis));
        params.attraction = random.chance(0.7);
        if random.chance(0.4) {
            (params.radius_amplitude, params.radius_rate) = (random.between(-0.95, 0.95), random.log_between(0.1, 2.0));
        }
        let name =
            format!("{i}: skew {skew}, kurtosis {kurtosis:?}, gamma {gamma}, epsilon {}", params.radius_amplitude);
        let start = processor_time();
        let model = match Model::new(&params) {
            Ok(model) => model,
            // The surfaces part in steps.
            Err(Error::OutOfRange { name: "pull-off load", .. }) if gamma > 0.0 => continue,
            Err(error) => panic!("{name}: {error}"),
        };
        let took = processor_time() - start;
        assert!(took < LONGEST_CALL, "{name}: {took:?}");
        made += 1;
        let summary = model.summary();
        assert_eq!((summary.skew, summary.kurtosis), (skew, kurtosis), "{name}");
        assert_compiled(&model, whole_table(&model), 16, &name);
    }
    assert!(made > 40, "{made} models");
}

#[test]
fn a_fine_table_of_a_family_nears_the_family_with_the_third_power_of_its_spacing() {
    let loads = [1.0, 30.0, 1e3, 3e4, 1e6];
    let rayleigh = |z: f64| z * bell(z);
    for gamma in [0.0, 0.001] {
        let gaussian = model(gamma, HeightFamily::Gaussian);
        let weibull = model(gamma, HeightFamily::Weibull { shape: 2.0 });
        let errors = |count: usize| {
            [
                difference(&model(gamma, sampled(count, -8.0, 8.0, bell)), &gaussian, &loads),
                difference(&model(gamma, sampled(count, 0.0, 9.0, rayleigh)), &weibull, &loads),
            ]
        };
        let (coarse, fine, finest) = (errors(64), errors(127), errors(253));
        for family in 0..2 {
            println!("gamma {gamma}: {:.1e}, {:.1e}, {:.1e}", coarse[family], fine[family], finest[family]);
            // Twice finer, twice.
            let order = (coarse[family] / finest[family]).log2() / 2.0;
            assert!(order > 2.7, "gamma {gamma}, family {family}: order {order}");
            assert!(coarse[family] < 1e-2 && finest[family] < 1e-4, "{:?} {:?}", coarse, finest);
        }
    }
}

/// A measured histogram with an empty bin, a jump at each end and two maxima.
const HEIGHT: [f64; 9] = [0.0, 0.5, 1.5, 2.0, 2.25, 3.0, 3.5, 4.0, 5.0];
const DENSITY: [f64; 9] = [0.25, 1.0, 2.0, 0.5, 0.0, 0.0, 1.5, 1.0, 0.125];

#[test]
fn unit_and_origin_of_heights_and_unit_of_density_do_not_matter() {
    let reference = model(0.001, table(&HEIGHT, &DENSITY));
    for (unit, origin, amount) in
        [(1.0, 1024.0, 1.0), (2.0_f64.powi(-30), 0.0, 1e300), (1e-9, -1e-3, 1e-320), (1e250, 1e251, 3.0)]
    {
        let height = HEIGHT.map(|h| h * unit + origin);
        let density = DENSITY.map(|d| d * amount);
        let moved = model(0.001, table(&height, &density));
        // What rounding the heights loses; the smallest densities have few digits.
        let rounding = 1e-13 + 4.0 * f64::EPSILON * (origin / unit).abs() + 1e-323 / amount;
        let error = difference(&moved, &reference, &LOADS);
        assert!(error <= rounding * 100.0, "unit {unit}, origin {origin}: {error:e}");
        assert!((moved.summary().skew - reference.summary().skew).abs() < 100.0 * rounding);
    }
}

#[test]
fn the_law_of_a_table_is_exact_where_it_answers() {
    let two_bumps = |z: f64| bell((z - 1.0) / 0.3) + 0.1 * bell((z - 3.0) / 0.2);
    let jumps = table(&[0.0, 1.0, 1.0 + 1e-9, 2.0, 2.0 + 1e-9, 3.0], &[1.0, 1.0, 3.0, 3.0, 0.5, 0.5]);
    let tables = [
        ("histogram", table(&HEIGHT, &DENSITY)),
        ("jumps", jumps),
        ("two bumps", sampled(30, 0.0, 4.0, two_bumps)),
        ("fine", sampled(250, -5.0, 5.0, bell)),
    ];
    for (name, heights) in tables {
        for gamma in [0.0, 0.001] {
            let model = model(gamma, heights.clone());
            assert_compiled(&model, whole_table(&model), 100, &format!("{name}, gamma {gamma}"));
        }
    }
}

/// A histogram of so many heights of a skewed surface in equal bins, with the scatter of counts.
fn histogram(bins: usize, count: f64) -> HeightFamily {
    let mut random = SplitMix(0x0041_5706);
    let density = |z: f64| bell(z) * (1.0 + 0.08 * (z * z * z - 3.0 * z)).max(0.0);
    let height: Vec<f64> = (0..bins).map(|i| -3.6 + 7.6 * (i as f64 + 0.5) / bins as f64).collect();
    let counts = height.iter().map(|&z| {
        let expected = count * density(z) / (2.0 * std::f64::consts::PI).sqrt() * 7.6 / bins as f64;
        // The sum of 12 uniform numbers is nearly normal.
        let deviation = (0..12).map(|_| random.between(0.0, 1.0)).sum::<f64>() - 6.0;
        (expected + expected.sqrt() * deviation).round().max(0.0)
    });
    let density: Vec<f64> = counts.collect();
    table(&height, &density)
}

#[test]
fn measured_histograms_of_many_bins_are_compiled() {
    for (bins, count, gamma) in [(100, 2e4, 0.0), (100, 2e4, 0.003), (200, 1e5, 0.0), (250, 1e5, 0.0), (250, 1e6, 0.0)]
    {
        let model = model(gamma, histogram(bins, count));
        // From where one summit in 10^4 touches to where all do.
        let from_pull_off = |load: f64| load - model.summary().pull_off_load;
        let range = (from_pull_off(30.0), from_pull_off(1e6));
        assert_compiled(&model, range, 150, &format!("{bins} bins of {count:e} heights, gamma {gamma}"));
    }
}

#[test]
fn slopes_are_those_of_secants() {
    let families = [
        johnson(1.0, 3.2),
        johnson(-1.0, 6.0),
        johnson(0.0, 20.0),
        johnson(0.0, 1.9),
        johnson(1.5, 4.8),
        johnson(-1.0, 3.15),
        table(&HEIGHT, &DENSITY),
    ];
    let mut made = 0;
    for heights in families {
        for gamma in [0.0, 0.001, 0.003] {
            for amplitude in [0.0, 0.6] {
                let params = Params { radius_amplitude: amplitude, ..surface(gamma, heights.clone()) };
                let model = match Model::new(&params) {
                    Err(Error::OutOfRange { name: "pull-off load", .. }) if gamma > 0.0 => continue, // two heights
                    model => model.unwrap_or_else(|error| panic!("{heights:?}: {error}")),
                };
                made += 1;
                for separation in [-2.0, 0.1, 0.7, 1.0] {
                    let at = |part: f64| model.state_at_gap((separation + part) * params.height_std).expect("a state");
                    let (here, step) = (at(0.0), 1e-5);
                    if here.contacting + here.attracted == 0.0 {
                        continue; // above the highest summit
                    }
                    let (above, below) = (at(step), at(-step));
                    let secant = (above.load - below.load) / (above.gap - below.gap);
                    assert!(
                        (secant / here.dload_dgap - 1.0).abs() < 1e-6,
                        "{heights:?}, gamma {gamma}, epsilon {amplitude}, d {separation}: {secant:e}, not {:e}",
                        here.dload_dgap
                    );
                    let secant = (above.friction_force - below.friction_force) / (above.load - below.load);
                    assert!(
                        (secant / here.dforce_dload - 1.0).abs() < 1e-6,
                        "{heights:?}, gamma {gamma}, epsilon {amplitude}, d {separation}: {secant:e}, not {:e}",
                        here.dforce_dload
                    );
                }
            }
        }
    }
    assert!(made >= 28, "{made} models");
}

#[test]
fn tables_without_a_meaning_are_refused_by_name_and_index() {
    let refused = |height: &[f64], density: &[f64]| {
        Model::new(&surface(0.001, table(height, density))).expect_err("a refusal").to_string()
    };
    let cases = [
        (refused(&[0.0, 1.0], &[1.0, 1.0]), "table_length = 2: must be between 3 and 256"),
        (
            refused(&[0.0; 257], &[1.0; 257]),
            "table_length = 257: must be between 3 and 256, as many as the law can resolve: smooth",
        ),
        (refused(&[0.0, 1.0, 2.0], &[1.0, 1.0]), "length of table_density = 2: must be that of table_height"),
        (refused(&[0.0, 2.0, 2.0], &[1.0; 3]), "table_height[2] = 2: must be greater than the height before it"),
        (refused(&[0.0, 2.0, 1.0], &[1.0; 3]), "table_height[2] = 1: must be greater than the height before it"),
        // Below the last bits of their range two heights are one.
        (
            refused(&[-1.0, 0.0, 1.0 - 1e-16, 1.0], &[1.0; 4]),
            "table_height[3] = 1: must be greater than the height before it by 1e-12 of their range at least",
        ),
        (
            refused(&[0.0, 1e-310, 1.0], &[1.0; 3]),
            "table_height[1] = 1e-310: must be greater than the height before it by",
        ),
        (refused(&[0.0, f64::NAN, 1.0], &[1.0; 3]), "table_height[1] = NaN: must be finite"),
        (refused(&[0.0, 1.0, 2.0], &[1.0, -0.5, 1.0]), "table_density[1] = -0.5: must be finite and >= 0"),
        (refused(&[0.0, 1.0, 2.0], &[1.0, 1.0, f64::INFINITY]), "table_density[2] = inf: must be finite and >= 0"),
        (refused(&[0.0, 1.0, 2.0], &[0.0; 3]), "table_density = 0: must be > 0 at one height at least"),
        (refused(&[-1e308, 0.0, 1e308], &[1.0; 3]), "table_height = 1e308: must be between -1e300 and 1e300"),
        (refused(&[0.0, 1.0, 2.0, 1e6], &[1e9, 1e9, 0.0, 1e-9]), "must be at most 1e4"),
    ];
    for (message, expected) in cases {
        assert!(message.contains(expected), "{message}");
    }
}

/// Hertz' contacts of bins of equal density add up in closed form. Next to where the density drops the sum over the summits once
/// ended: its slope there let the rest look negligible.
#[test]
fn loads_of_histograms_are_those_of_the_closed_form() {
    // The second drop takes no time to speak of, but leaves few summits.
    for (densities, step) in [
        (vec![1.0, 3.0, 5.0, 4.0, 4e-5], 1e-11),
        (vec![1.0, 3.0, 5.0, 4.0, 1e-3, 1e-8], 1e-11),
        (vec![1.0, 3.0, 5.0, 4.0, 4e-7, 4e-7, 4e-7], 1e-8),
        (vec![0.5, 4.0, 2.0, 1.0], 1e-11),
    ] {
        let model = model(0.0, bins(&densities, step));
        let count: f64 = densities.iter().sum();
        // Bins begin a step later than they end.
        let middle = |bin: usize| bin as f64 + 0.5 + 0.5 * step;
        let mean = densities.iter().enumerate().map(|(bin, density)| density * middle(bin)).sum::<f64>() / count;
        let square = |bin: usize| (middle(bin) - mean).powi(2) + 1.0 / 12.0;
        let variance = densities.iter().enumerate().map(|(bin, density)| density * square(bin)).sum::<f64>() / count;
        let sigma = variance.sqrt();
        // The sum of (z - d)^power.
        let sum = |d: f64, power: f64| -> f64 {
            let above = |bin: usize| ((bin as f64 + 0.5 * step - mean) / sigma - d).max(0.0).powf(power + 1.0);
            let bins = densities.iter().enumerate().map(|(bin, density)| density * (above(bin + 1) - above(bin)));
            bins.sum::<f64>() * sigma / count / (power + 1.0)
        };
        let highest = (densities.len() as f64 - mean) / sigma;
        for i in 0..800 {
            let d = highest - 1e-3 * (0.5 + f64::from(i)) * highest.max(1.0) * if i % 8 == 7 { 20.0 } else { 1.25 };
            let state = model.state_at_gap(d * model.params().height_std).expect("a state");
            let slope = state.dload_dgap * model.params().height_std;
            let unit = 4.0 / 3.0 * 0.01 * 1e6 * model.params().composite_modulus;
            for (found, power) in [(state.load / unit, 1.5), (-slope / (1.5 * unit), 0.5)] {
                let expected = sum(d, power);
                // Steps are places to so many digits.
                let known = 1e-11 + 4.0 * step * power * sum(d, power - 1.0) / expected;
                assert!((found / expected - 1.0).abs() < known, "{densities:?} at {d}: {found:e}, not {expected:e}");
            }
        }
    }
}
