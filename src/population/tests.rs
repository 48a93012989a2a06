//! The sums against integrals over heights by another rule, and surfaces for unit tests.

use super::*;
use crate::neighbours::Neighbours;
use crate::numerics::quadrature;
use crate::params::{HeightFamily, Params};

/// The population of a surface that is valid.
pub fn of(params: &Params) -> Population {
    let (groups, heights, radius) = params.surface().expect("a surface");
    Population::new(&groups, params.slip, heights, radius, params.attraction).expect("a population")
}

pub fn surface([alpha, beta, gamma, b_over_h]: [f64; 4], heights: HeightFamily, [amplitude, rate]: [f64; 2]) -> Params {
    let mut params = Params { heights, radius_amplitude: amplitude, radius_rate: rate, ..Params::default() };
    params.set_dimensionless(alpha, beta, gamma, b_over_h, 0.3).expect("a surface");
    params
}

pub fn table() -> HeightFamily {
    let (height, density) = ([-3.0, -1.0, 0.0, 1.0, 1.5], [0.0, 1.0, 0.1, 1.0, 0.0]);
    HeightFamily::Tabulated { height: height.into(), density: density.into() }
}

/// Several functions integrated in panels that are halved until the halves agree with the whole.
fn halved(f: &impl Fn(f64) -> [f64; 5], from: f64, to: f64) -> [f64; 5] {
    let sum = |a: [f64; 5], b: [f64; 5]| std::array::from_fn(|i| a[i] + b[i]);
    let panel = |from: f64, to: f64| {
        quadrature::nodes(from, to).fold([0.0; 5], |all, (x, weight)| sum(all, f(x).map(|value| weight * value)))
    };
    let ends: Vec<f64> = (0..=64).map(|i| from + (to - from) * f64::from(i) / 64.0).collect();
    let mut left: Vec<_> = ends.windows(2).map(|ends| (ends[0], ends[1], panel(ends[0], ends[1]))).collect();
    let size = left.iter().fold([0.0; 5], |all, part| sum(all, part.2.map(f64::abs)));
    let mut done = [0.0; 5];
    while let Some((from, to, whole)) = left.pop() {
        let middle = 0.5 * (from + to);
        let halves = [panel(from, middle), panel(middle, to)];
        let both = sum(halves[0], halves[1]);
        if (0..5).all(|i| (both[i] - whole[i]).abs() <= 1e-13 * size[i]) || to - from < 1e-9 {
            done = sum(done, both);
        } else {
            left.extend([(from, middle, halves[0]), (middle, to, halves[1])]);
        }
    }
    done
}

impl Population {
    /// Number, load, area and friction of the contacts, and the number of attracted summits: over the root of the height
    /// above break-away, contact by contact.
    fn by_halves(&self, separation: f64) -> [f64; 5] {
        let edge = self.edge(separation).point.z;
        let density = |z: f64| self.heights.log_density(z).exp();
        let start = edge.max(self.lower_cut);
        let contact = |t: f64| {
            let z = start + t * t;
            let g = self.radius.factor(z);
            let contact = self.law.at_overlap(z - separation, g, self.law.guess(z - separation, g));
            let (friction, area) = (self.slip.force(contact.radius).0, std::f64::consts::PI * contact.radius.powi(2));
            [1.0, contact.load, area, friction, 0.0].map(|value| 2.0 * t * density(z) * value)
        };
        let attracted = |z: f64| {
            let exists = self.attraction_at(z - separation, z).is_some();
            [0.0, 0.0, 0.0, 0.0, if exists { density(z) } else { 0.0 }]
        };
        let top = self.highest;
        let mut cuts: Vec<f64> = self.heights.breakpoints().iter().copied().filter(|&z| z > start && z < top).collect();
        cuts.extend([start, top]);
        cuts.sort_by(f64::total_cmp);
        let mut sums = [0.0; 5];
        for ends in cuts.windows(2).filter(|_| top > start) {
            let part = halved(&contact, (ends[0] - start).sqrt(), (ends[1] - start).sqrt());
            sums = std::array::from_fn(|i| sums[i] + part[i]);
        }
        if let Some(law) = &self.attraction {
            let from = (separation - law.reach).max(self.lower_cut);
            if from < edge.min(top) {
                sums[4] = halved(&attracted, from, edge.min(top))[4];
            }
        }
        sums
    }
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

/// At heavy and light loads, with kinks of the slip law among the contacts, and where contact breaks at a fold.
#[test]
fn sums_are_integrals_over_heights() {
    for params in surfaces() {
        let population = of(&params);
        for separation in [-3.0, -0.4, 0.3, 1.1].map(|d| d - population.heights.origin()) {
            let (sums, expected) = (population.at_separation(separation), population.by_halves(separation));
            let found = [sums.contacting, sums.load_contacting, sums.area, sums.friction, sums.attracted];
            for (i, name) in ["contacting", "load", "area", "friction", "attracted"].into_iter().enumerate() {
                let off = (found[i] - expected[i]).abs();
                assert!(
                    off <= 1e-10 * expected[i].abs() + 1e-14,
                    "{name} of {params:?} at {separation}: {found:?}, {expected:?}"
                );
            }
        }
    }
}

/// Where a foot of the heights, or another breakpoint, passes an overlap at which the law is not smooth, to the last bit.
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
fn slopes_are_those_of_secants() {
    for params in surfaces() {
        let population = of(&params);
        for separation in [-3.0, -0.41, 0.31].map(|d| d - population.heights.origin()) {
            let at = |step: f64| population.at_separation(separation + step);
            let (here, below, above) = (at(0.0), at(-1e-5), at(1e-5));
            for (name, rise, slope) in [
                ("load", above.load() - below.load(), here.load_slope),
                ("friction", above.friction - below.friction, here.friction_slope),
            ] {
                let secant = rise / 2e-5;
                assert!(
                    (secant - slope).abs() < 1e-5 * slope.abs(),
                    "{name} of {params:?} at {separation}: {slope}, not {secant}"
                );
            }
        }
    }
}

/// What is the same at every separation, and what is laid anew.
#[test]
fn tabulated_nodes_and_a_walk_give_the_same() {
    for params in surfaces().into_iter().filter(|params| params.radius_amplitude == 0.0) {
        let tabulated = of(&params);
        let walked = Population { nodes: None, ..tabulated.clone() };
        for separation in [-3.0, -0.4, 0.3, 1.1].map(|d| d - tabulated.heights.origin()) {
            let (a, b) = (tabulated.at_separation(separation), walked.at_separation(separation));
            for (a, b) in [(a.load_contacting, b.load_contacting), (a.area, b.area), (a.friction, b.friction)] {
                assert!((a - b).abs() <= 2e-13 * b.abs(), "{params:?} at {separation}: {a:e}, {b:e}");
            }
        }
    }
}

#[test]
fn contact_begins_where_a_summit_has_just_the_overlap_of_break_away() {
    for params in surfaces() {
        let population = of(&params);
        for separation in [-3.0, 0.3, 4.0] {
            let separation = separation - population.heights.origin();
            let Edge { point, rate } = population.edge(separation);
            if point.z > population.highest || point.z < population.lower_cut {
                continue; // no summit
            }
            let excess = |z: f64| z - separation - population.law.break_away(population.radius.factor(z)).overlap;
            assert!(excess(point.z).abs() < 1e-13 * (1.0 + separation.abs()), "{params:?}: {:e}", excess(point.z));
            let secant = (excess(point.z + 1e-6) - excess(point.z - 1e-6)) / 2e-6;
            assert!((secant - rate).abs() < 1e-6 && rate > 0.0, "{params:?}: {rate}, not {secant}");
        }
    }
}
