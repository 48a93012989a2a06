//! Sums next to kinks, the edge of contact, and surfaces for unit tests.

use super::*;
use crate::distribution::at_scores::{table_score, SCORES};
use crate::numerics::neighbours::Neighbours;
use crate::numerics::quadrature;
use crate::numerics::random::Random;
use crate::params::{ContactLawKind, HeightFamily, Params};

/// The population of a surface that is valid.
pub fn of(params: &Params) -> Population {
    let (groups, heights, radius) = params.surface().expect("a surface");
    Population::new(&groups, params.slip_law(), heights, radius, params.attraction).expect("a population")
}

pub fn surface([alpha, beta, gamma, b_over_h]: [f64; 4], heights: HeightFamily, [amplitude, rate]: [f64; 2]) -> Params {
    let mut params = Params { heights, radius_amplitude: amplitude, radius_rate: rate, ..Params::paper() };
    params.set_dimensionless(alpha, beta, gamma, b_over_h, 0.3).expect("a surface");
    params
}

/// A surface of which the summits yield.
pub fn yielding(groups: [f64; 4], heights: HeightFamily, radii: [f64; 2]) -> Params {
    let params = surface(groups, heights, radii);
    Params { contact_law: ContactLawKind::ElasticPlastic, hardness: 0.02 * params.composite_modulus, ..params }
}

pub fn table() -> HeightFamily {
    let (height, density) = ([-3.0, -1.0, 0.0, 1.0, 1.5], [0.0, 1.0, 0.1, 1.0, 0.0]);
    HeightFamily::Tabulated { height: height.into(), density: density.into() }
}

/// So many bins over 7 standard deviations, of uneven counts.
pub fn bins(count: u32) -> HeightFamily {
    let height: Vec<f64> = (0..=count).map(|i| -3.5 + 7.0 * f64::from(i) / f64::from(count)).collect();
    let density = height.iter().map(|z| (-0.5 * z * z).exp() * (1.0 + 0.3 * (7.0 * z * z * z).sin())).collect();
    HeightFamily::Tabulated { height: height.into(), density }
}

pub const WEAK: [f64; 4] = [0.01, 1000.0, 1e-3, 0.2];
pub const FOLD: [f64; 4] = [0.01, 1000.0, 0.02, 1.0];
pub const HERTZ: [f64; 4] = [0.01, 1000.0, 0.0, 1.0];

fn surfaces() -> Vec<Params> {
    let mut surfaces = Vec::new();
    for groups in [WEAK, FOLD, HERTZ] {
        for radii in [[0.0, 1.0], [0.6, 0.8], [-0.4, 0.5]] {
            let johnson = HeightFamily::Johnson { skew: 0.5, kurtosis: 4.0 };
            for heights in [HeightFamily::Gaussian, HeightFamily::Weibull { shape: 2.2 }, johnson, table()] {
                surfaces.push(surface(groups, heights, radii));
            }
        }
    }
    surfaces
}

/// Where a lower end of the heights, or another breakpoint, passes an overlap at which the law is not smooth, to the last bit.
#[test]
fn sums_are_numbers_at_every_kink_and_next_to_it() {
    let mut surfaces = surfaces();
    surfaces.push(surface([0.01, 100.0, 1e-8, 1e-3], HeightFamily::Weibull { shape: 8.0 }, [0.0, 1.0]));
    for params in surfaces {
        let population = of(&params);
        for kink in population.kinks() {
            for separation in [kink.below().below(), kink.below(), kink, kink.above(), kink.above().above()] {
                let sums = population.at_separation(separation);
                let is_known =
                    sums.load().is_finite() && sums.load_slope.is_finite() && sums.friction_slope.is_finite();
                assert!(is_known, "{params:?} at {separation}: {sums:?}");
            }
        }
    }
}

#[test]
fn contact_begins_where_a_summit_has_just_the_overlap_of_break_away() {
    for params in surfaces() {
        let population = of(&params);
        for separation in [-3.0, 0.3, 4.0] {
            let separation = separation - population.heights.outline().origin;
            let Edge { point, rate } = population.edge(separation);
            if point.z > population.highest || point.z < population.lower_cut {
                continue; // no summit
            }
            let residual = |z: f64| z - separation - population.law.break_away(population.radius.factor(z)).overlap;
            assert!(residual(point.z).abs() < 1e-13 * (1.0 + separation.abs()), "{params:?}: {:e}", residual(point.z));
            let secant = (residual(point.z + 1e-6) - residual(point.z - 1e-6)) / 2e-6;
            assert!((secant - rate).abs() < 1e-6 && rate > 0.0, "{params:?}: {rate}, not {secant}");
        }
    }
}

/// How far the slopes of load and friction are from secants over steps and their doubles, relative to these.
fn errors_of_slopes(population: &Population, separation: f64, step: f64) -> [f64; 2] {
    let sums = |step: f64| population.at_separation(separation + step);
    let secant = |step: f64, of: fn(&Sums) -> f64| (of(&sums(step)) - of(&sums(-step))) / (2.0 * step);
    let slope = |of| (4.0 * secant(step, of) - secant(2.0 * step, of)) / 3.0;
    let exact = population.at_separation(separation);
    [exact.load_slope / slope(Sums::load) - 1.0, exact.friction_slope / slope(|sums| sums.friction) - 1.0]
}

/// Adhesive summits of which the taller have smaller radii, down to nothing.
fn falling_radii() -> [Params; 2] {
    let surface = |groups, rate, density: [f64; 9]| {
        let height = [-2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0];
        surface(groups, HeightFamily::Tabulated { height: height.into(), density: density.into() }, [-1.0, rate])
    };
    [
        surface([1.9e-3, 8870.0, 1.9e-3, 8.7], 2.5, [0.001, 2.0, 0.001, 2.0, 0.001, 2.0, 0.001, 2.0, 0.001]),
        surface([3.6e-3, 3.95e6, 0.71, 0.29], 15.2, [1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 9.0, 10.0, 11.0]),
    ]
}

/// There the parameter of contact turns back within a stretch of heights.
#[test]
fn slopes_are_secants_where_radii_fall_to_nothing() {
    for params in falling_radii() {
        let population = of(&params);
        let kinks = population.kinks();
        let separations = (1..120).map(|i| -0.02 * f64::from(i));
        // Not across a kink.
        for separation in separations.filter(|at| kinks.iter().all(|kink| (kink - at).abs() > 1e-3)) {
            let [load, friction] = errors_of_slopes(&population, separation, 1e-4);
            assert!(load.abs().max(friction.abs()) < 3e-8, "{params:?} at {separation}: {load:e}, {friction:e}");
        }
    }
}

/// Plateaus, deep pits, and tall patches.
fn tables_at_scores() -> Vec<HeightFamily> {
    let table = |height: fn(f64) -> f64, slope: fn(f64) -> f64| HeightFamily::AtScores {
        height: (0..SCORES).map(|i| height(table_score(i))).collect(),
        slope: (0..SCORES).map(|i| slope(table_score(i))).collect(),
    };
    vec![
        table(|g| g, |_| 0.1),
        table(|g| if g > 0.5 { 0.2 * (g - 0.5) } else { 1.5 * (g - 0.5) }, |g| if g > 0.5 { 0.02 } else { 0.1 }),
        table(|g| (0.6 * g).exp(), |g| 0.1 * (0.6 * g).exp()),
        table(|g| -(-0.6 * g).exp(), |g| 0.1 * (-0.5 * g).exp()),
        table(|g| g + 0.45 * (2.0 * g).sin(), |g| 0.1 + 0.03 * (3.0 * g).cos()),
    ]
}

/// The sums by many short panels in the root of the distance from the edge.
#[test]
fn sums_over_a_table_at_scores_are_integrals_of_its_density() {
    let mut surfaces = Vec::new();
    for heights in tables_at_scores() {
        // Radii that fall steeply between plateaus and pits are refused with adhesion.
        let adhesive = surface(WEAK, heights.clone(), [-0.61, 0.9]);
        surfaces.extend(crate::Model::new(&adhesive).is_ok().then_some(adhesive));
        surfaces.push(surface(HERTZ, heights.clone(), [-0.61, 0.9]));
        surfaces.push(yielding(HERTZ, heights, [-0.61, 0.9]));
    }
    assert!(surfaces.len() > 11);
    for params in surfaces {
        let population = of(&params);
        for separation in [-3.0, -1.0, 0.0, 0.7, 1.7, 3.0] {
            let sums = population.at_separation(separation);
            let edge = population.edge(separation).point.z;
            let mut found = [0.0; 3];
            let reach = (population.highest.min(60.0) - edge).max(1.0).sqrt();
            let even = (0..=3000).map(|i| reach * f64::from(i) / 3e3);
            let knots =
                population.heights.breakpoints().iter().filter(|&&knot| knot > edge).map(|knot| (knot - edge).sqrt());
            let mut ends: Vec<f64> = even.chain(knots.filter(|&v| v < reach)).collect();
            ends.sort_by(f64::total_cmp);
            for ends in ends.windows(2) {
                for (v, weight) in quadrature::nodes(ends[0], ends[1]) {
                    let z = edge + v * v;
                    let point = population.at_height(
                        separation,
                        z,
                        population.law.guess(z - separation, population.radius.factor(z)),
                    );
                    let fraction = 2.0 * v * weight * population.heights.log_density(z).exp();
                    let friction = population.slip.friction(&point.contact).force;
                    let values = [point.contact.load, friction, PI * point.contact.radius * point.contact.radius];
                    found.iter_mut().zip(values).for_each(|(sum, value)| *sum += fraction * value);
                }
            }
            for (sum, found) in [sums.load_contacting, sums.friction, sums.area].into_iter().zip(found) {
                assert!((sum / found - 1.0).abs() < 3e-8, "{params:?} at {separation}: {sum:e}, not {found:e}");
            }
            if population.kinks().iter().all(|kink| (kink - separation).abs() > 1e-3) {
                let [load, friction] = errors_of_slopes(&population, separation, 1e-4);
                assert!(load.abs().max(friction.abs()) < 3e-7, "{params:?} at {separation}: {load:e}, {friction:e}");
            }
        }
    }
}

/// Radii are cubics between two scores, so that a summit is nearest to a kink of the law of contact more than once within a panel.
#[test]
fn models_of_yielding_summits_are_made_of_any_table_at_scores() {
    let mut random = Random(1);
    let mut between = |least: f64, most: f64| random.between(least, most);
    for _ in 0..if cfg!(miri) { 1 } else { 60 } {
        let [mut height, mut rise, mut log_slope] = [0.0, 1.0, 0.0];
        let rows = (0..SCORES).map(|_| {
            height += rise;
            rise *= between(-1.1, 1.1).exp();
            log_slope += between(-0.8, 0.8);
            (height, log_slope.exp())
        });
        let (height, slope): (Vec<f64>, Vec<f64>) = rows.unzip();
        let heights = HeightFamily::AtScores { height: height.into(), slope: slope.into() };
        let [alpha, beta] = [between(-5.0, -2.0).exp(), between(4.0, 10.0).exp()];
        let mut params = yielding([alpha, beta, 0.0, 1.0], heights, [-0.61, 0.9]);
        params.hardness = params.composite_modulus * between(-5.0, -2.0).exp();
        let error = crate::Model::new(&params).map(|model| model.summary().table_error);
        assert!(matches!(error, Ok(error) if error <= 1e-6), "{params:?}: {error:?}");
    }
}
