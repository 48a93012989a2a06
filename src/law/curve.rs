//! The branch of load control as a smooth curve through exact states, from which the table is filled.
//!
//! The coordinate is s = arsinh((x/|pull-off|)^(1/2)) with x = load - pull-off: near pull-off, where load has its
//! minimum over separation, it is linear in separation, far from it logarithmic in load; without adhesion it is
//! ln(x)/2. In it ln F is smooth on the whole branch. Panels of exact states at Chebyshev points, each with its slope,
//! are joined by Hermite interpolation; a panel that misses the exact states between its nodes is tried again shorter.

use super::reach::{Next, Reach};
use super::CONDITIONS;
use crate::elementary::{cos, exp, exp_each, log, log1p, sinh};
use crate::equilibrium::{Branch, BranchPoint};
use std::f64::consts::LN_2;

/// Exact states per panel.
const NODES: usize = CONDITIONS / 2;
/// Without adhesion, how near to the highest summit the branch is followed: loads there are no numbers.
const LEAST_OVERLAP: f64 = 1e-100;
/// The branch is followed from this separation of the means, in sigma; heavier loads are evaluated exactly.
const CLOSEST: f64 = -12.0;
/// The branch is followed from at least this much above the pull-off load, in ln(load).
const LOG_ABOVE_PULL_OFF: f64 = 9.0;
/// Largest error of ln F, and of its slope relative to the slope, at which a panel is good.
const VALUE_TOLERANCE: f64 = 1e-11;
const SLOPE_TOLERANCE: f64 = 1e-9;
/// No more than about this many exact states are spent; lighter loads than they reach are evaluated exactly.
const MOST_SAMPLES: usize = 800;

/// At this separation the load rises already, or cannot be had: the branch ends before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unfollowed {
    pub separation: f64,
}

/// What s measures.
#[derive(Debug, Clone, Copy)]
struct Coordinate {
    /// ln |pull-off load|, if there is one.
    log_pull_off: Option<f64>,
    /// The force whose logarithm is taken relative to: that at pull-off, where small changes must be resolved.
    force: f64,
}

/// An exact state on the branch.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    separation: f64,
    /// ln(load - pull-off load).
    pub log_excess: f64,
    s: f64,
    /// ln F over the reference force of the curve.
    pub log_force: f64,
    /// d(ln F)/ds.
    slope: f64,
    /// d(ln F)/d(ln x).
    pub log_slope: f64,
}

/// A stretch of the curve, with s falling as separation grows.
#[derive(Debug, Clone)]
struct Panel {
    /// s at its ends.
    lowest: f64,
    highest: f64,
    nodes: [f64; NODES],
    /// ln F in Newton's form, each node twice.
    log_force: [f64; CONDITIONS],
    /// Separation in Newton's form, each node once.
    separation: [f64; NODES],
    /// Whether it meets the exact states between its nodes.
    good: bool,
}

/// A panel with the exact states that it was compared with.
struct Attempt {
    panel: Panel,
    between: [Sample; 2],
    end: Sample,
    /// The largest error over its tolerance.
    excess: f64,
}

/// The curve, from heavy to light load.
#[derive(Debug, Clone)]
pub struct Curve {
    coordinate: Coordinate,
    panels: Vec<Panel>,
    /// Exact states spent.
    samples: usize,
    /// Whether panels end at all kinks.
    resolved: bool,
}

impl Coordinate {
    /// s and ds/d(ln x) at ln x.
    fn at(self, log_excess: f64) -> (f64, f64) {
        self.at_each([log_excess])[0]
    }

    /// The same at each of several.
    fn at_each<const N: usize>(self, log_excess: [f64; N]) -> [(f64, f64); N] {
        let Some(log_pull_off) = self.log_pull_off else {
            return log_excess.map(|log_excess| (0.5 * log_excess, 0.5));
        };
        let log_sinh = log_excess.map(|log_excess| 0.5 * (log_excess - log_pull_off));
        let sinh = exp_each(log_sinh);
        std::array::from_fn(|i| {
            let sinh = sinh[i];
            if sinh > 1e9 {
                return (LN_2 + log_sinh[i], 0.5);
            }
            let cosh = (1.0 + sinh * sinh).sqrt();
            let s = if sinh > 1.0 { log(sinh + cosh) } else { log1p(sinh + sinh * sinh / (1.0 + cosh)) };
            (s, 0.5 * sinh / cosh)
        })
    }
}

impl Curve {
    /// Follows the branch from heavy load down to pull-off, but not farther than `log_range` of the heaviest ln(load -
    /// pull-off). Hands every exact state that is not a node to `check`.
    ///
    /// # Errors
    /// [`Unfollowed`].
    pub fn new(branch: &Branch, log_range: impl Fn(f64) -> f64, check: &mut Vec<Sample>) -> Result<Self, Unfollowed> {
        let log_pull_off = branch.pull_off().map(|point| log(-point.load));
        let force = branch.pull_off().map_or(1.0, |point| point.friction);
        let mut curve =
            Self { coordinate: Coordinate { log_pull_off, force }, panels: Vec::new(), samples: 0, resolved: true };
        let end = match branch.pull_off() {
            Some(point) => point.separation,
            None => branch.farthest() - LEAST_OVERLAP,
        };
        let closest = CLOSEST - branch.population().heights().origin();
        let mut from = curve.sample(branch, closest.min(end - 10.0))?;
        // Adhesion that is strong beside the roughness: on to loads well above pull-off.
        while log_pull_off.is_some_and(|pull_off| from.log_excess < pull_off + LOG_ABOVE_PULL_OFF) {
            from = curve.sample(branch, 1.5 * from.separation.min(closest))?;
        }
        let lightest = from.log_excess - log_range(from.log_excess);
        check.push(from);
        let mut reach = Reach::new(branch, end);
        curve.resolved = reach.is_resolved();
        let most_samples = MOST_SAMPLES + 2 * NODES * reach.kinks().len();
        while from.separation < end && from.log_excess > lightest && curve.samples < most_samples {
            match reach.next(from.separation, from.s) {
                Next::Gap(to) => {
                    let next = curve.sample(branch, to)?;
                    curve.panels.push(Panel::gap(&from, &next));
                    curve.samples += 1;
                    from = next;
                }
                Next::Panel(stretch) => {
                    let attempt = curve.attempt(branch, from, stretch.to)?;
                    if !reach.keeps(&stretch, attempt.excess) {
                        continue;
                    }
                    curve.panels.push(attempt.panel);
                    check.extend(attempt.between);
                    if attempt.end.slope.is_finite() {
                        check.push(attempt.end);
                    }
                    from = attempt.end;
                }
            }
        }
        Ok(curve)
    }

    /// A panel between two separations, and how well it meets the exact states that are not its nodes.
    fn attempt(&mut self, branch: &Branch, from: Sample, to: f64) -> Result<Attempt, Unfollowed> {
        let (middle, half) = (0.5 * (from.separation + to), 0.5 * (to - from.separation));
        let mut nodes = [from; NODES];
        for (j, node) in nodes.iter_mut().enumerate() {
            let angle = std::f64::consts::PI * (j as f64 + 0.5) / NODES as f64;
            *node = self.sample(branch, middle - half * cos(angle))?;
        }
        let end = match branch.pull_off() {
            Some(point) if point.separation == to => Sample {
                separation: to,
                log_excess: f64::NEG_INFINITY,
                s: 0.0,
                log_force: 0.0,
                slope: f64::NAN,
                log_slope: f64::NAN,
            },
            _ => self.sample(branch, to)?,
        };
        let mut panel = Panel::new(from.s, end.s, &nodes);
        // Between the nodes: in the middle of the panel, and where the nodes are farthest apart in s.
        let between = self.sample(branch, middle + 0.1 * half)?;
        let (first, last) = (nodes[0].separation, nodes[NODES - 1].separation);
        let sparse = panel.separation_at(panel.sparsest()).max(first).min(last);
        let sparse = self.sample(branch, sparse)?;
        self.samples += NODES + 3;
        let excess = [from, between, sparse, end].iter().map(|sample| panel.excess(sample)).fold(0.0, largest);
        panel.good = excess <= 1.0;
        Ok(Attempt { panel, between: [between, sparse], end, excess })
    }

    fn sample(&self, branch: &Branch, separation: f64) -> Result<Sample, Unfollowed> {
        let BranchPoint { log_excess, rate, sums } = branch.log_excess(separation);
        // A load below that of the end is as far above it as can be told.
        let below_end = match self.coordinate.log_pull_off {
            Some(_) => log_excess <= log(f64::MIN_POSITIVE),
            None => sums.load() <= 0.0,
        };
        if !(rate < 0.0 && sums.friction > 0.0) || below_end {
            return Err(Unfollowed { separation });
        }
        let (s, s_rate) = self.coordinate.at(log_excess);
        let log_slope = sums.friction_slope / sums.friction / rate;
        Ok(Sample {
            separation,
            log_excess,
            s,
            log_force: log(sums.friction / self.coordinate.force),
            slope: log_slope / s_rate,
            log_slope,
        })
    }

    /// The range of ln(load - pull-off) it covers; the lower end is minus infinity where it begins at pull-off.
    pub fn log_range(&self) -> (f64, f64) {
        let (Some(first), Some(last)) = (self.panels.first(), self.panels.last()) else {
            return (0.0, 0.0);
        };
        let log = |s: f64| match self.coordinate.log_pull_off {
            Some(log_pull_off) => 2.0 * log(sinh(s)) + log_pull_off,
            None => 2.0 * s,
        };
        (log(last.lowest), log(first.highest))
    }

    /// F and d(ln F)/d(ln x) at neighbouring ln x; NaN where the curve is not known to be good.
    pub fn at<const N: usize>(&self, log_excess: [f64; N]) -> [(f64, f64); N] {
        let coordinates = self.coordinate.at_each(log_excess);
        let s = coordinates.map(|(s, _)| s);
        // Mostly one panel holds all: then they are evaluated side by side.
        let panel = self.panel(s[0]);
        let log_force = if s.iter().all(|&s| std::ptr::eq(self.panel(s), panel)) {
            panel.log_force_at(s)
        } else {
            s.map(|s| self.panel(s).log_force_at([s])[0])
        };
        let force = exp_each(log_force.map(|(log_force, _)| log_force));
        std::array::from_fn(|i| (self.coordinate.force * force[i], log_force[i].1 * coordinates[i].1))
    }

    /// Whether panels end at all kinks; if not, there are too many, and the curve serves to find separations.
    pub fn is_resolved(&self) -> bool {
        self.resolved
    }

    /// F of an exact state.
    pub fn force_of(&self, sample: &Sample) -> f64 {
        self.coordinate.force * exp(sample.log_force)
    }

    /// The separation at ln x, to a few digits, where the curve covers it.
    pub fn separation(&self, log_excess: f64) -> Option<f64> {
        let (s, _) = self.coordinate.at(log_excess);
        let panel = self.panel(s);
        (s >= panel.lowest && s <= panel.highest).then(|| panel.separation_at(s))
    }

    fn panel(&self, s: f64) -> &Panel {
        let index = self.panels.partition_point(|panel| panel.lowest > s);
        &self.panels[index.min(self.panels.len() - 1)]
    }
}

impl Panel {
    fn new(highest: f64, lowest: f64, samples: &[Sample; NODES]) -> Self {
        let nodes = samples.map(|sample| sample.s);
        // Divided differences; between the two copies of a node they are the slope.
        let mut log_force = [0.0; CONDITIONS];
        for (i, value) in log_force.iter_mut().enumerate() {
            *value = samples[i / 2].log_force;
        }
        for order in 1..CONDITIONS {
            for i in (order..CONDITIONS).rev() {
                let (a, b) = (nodes[(i - order) / 2], nodes[i / 2]);
                log_force[i] = if order == 1 && i % 2 == 1 {
                    samples[i / 2].slope
                } else {
                    (log_force[i] - log_force[i - 1]) / (b - a)
                };
            }
        }
        let mut separation = samples.map(|sample| sample.separation);
        for order in 1..NODES {
            for i in (order..NODES).rev() {
                separation[i] = (separation[i] - separation[i - 1]) / (nodes[i] - nodes[i - order]);
            }
        }
        Self { lowest, highest, nodes, log_force, separation, good: false }
    }

    /// Between two states with nothing known but these.
    fn gap(from: &Sample, to: &Sample) -> Self {
        let mut separation = [0.0; NODES];
        separation[0] = 0.5 * (from.separation + to.separation);
        Self {
            lowest: to.s,
            highest: from.s,
            nodes: [0.0; NODES],
            log_force: [0.0; CONDITIONS],
            separation,
            good: false,
        }
    }

    /// ln F and its derivative by s; NaN where the panel is not known to be good.
    fn log_force_at<const N: usize>(&self, s: [f64; N]) -> [(f64, f64); N] {
        if !self.good {
            return [(f64::NAN, f64::NAN); N];
        }
        self.interpolated(s)
    }

    /// ln F and its derivative by s, good or not.
    fn interpolated<const N: usize>(&self, s: [f64; N]) -> [(f64, f64); N] {
        let mut value = [self.log_force[CONDITIONS - 1]; N];
        let mut slope = [0.0; N];
        for i in (0..CONDITIONS - 1).rev() {
            for k in 0..N {
                let distance = s[k] - self.nodes[i / 2];
                slope[k] = slope[k] * distance + value[k];
                value[k] = value[k] * distance + self.log_force[i];
            }
        }
        std::array::from_fn(|k| (value[k], slope[k]))
    }

    fn separation_at(&self, s: f64) -> f64 {
        let mut value = self.separation[NODES - 1];
        for i in (0..NODES - 1).rev() {
            value = value * (s - self.nodes[i]) + self.separation[i];
        }
        value
    }

    /// The middle of the widest gap between neighbouring nodes.
    fn sparsest(&self) -> f64 {
        let gap = |pair: &[f64]| (pair[1] - pair[0]).abs();
        let widest = self.nodes.windows(2).max_by(|a, b| gap(a).total_cmp(&gap(b)));
        widest.map_or(self.lowest, |pair| 0.5 * (pair[0] + pair[1]))
    }

    /// How far an exact state lies from the curve, over the tolerance; infinite where either is not a number.
    fn excess(&self, sample: &Sample) -> f64 {
        let [(value, slope)] = self.interpolated([sample.s]);
        let value_excess = (value - sample.log_force).abs() / VALUE_TOLERANCE;
        if sample.slope.is_nan() {
            return value_excess; // at pull-off itself
        }
        largest(value_excess, (slope / sample.slope - 1.0).abs() / SLOPE_TOLERANCE)
    }
}

/// The larger of two numbers, infinite if either is not one.
fn largest(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::branch;
    use super::*;
    use crate::params::{HeightFamily, Params};

    fn near(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance * b.abs()
    }

    #[test]
    fn the_coordinate_is_arsinh_of_the_root_of_load_over_pull_off() {
        let pull_off = Coordinate { log_pull_off: Some(-7.0), force: 1.0 };
        for log_excess in [-40.0, -20.0, -7.0, -3.0, 10.0, 30.0, 34.4, 34.5, 60.0, 700.0] {
            let (s, rate) = pull_off.at(log_excess);
            let root = (0.5 * (log_excess + 7.0)).exp();
            assert!(near(s, root.asinh(), 1e-14), "{log_excess}: {s}");
            assert!(near(rate, 0.5 * root / root.hypot(1.0), 1e-14), "{log_excess}: {rate}");
        }
        // Of a pull-off load next to the smallest number and a load next to the largest.
        let (s, rate) = Coordinate { log_pull_off: Some(-640.0), force: 1.0 }.at(700.0);
        assert!(near(s, 670.0 + LN_2, 1e-15) && rate == 0.5, "{s}, {rate}");
        assert_eq!(Coordinate { log_pull_off: None, force: 1.0 }.at(-8.0), (-4.0, 0.5));
    }

    #[test]
    fn the_curve_reaches_from_its_heaviest_state_to_pull_off_or_as_light_as_asked_for() {
        for (gamma, range) in [(0.0, 20.0), (0.001, 20.0), (0.001, 1e3)] {
            let branch = branch(gamma);
            let mut states = Vec::new();
            let curve = Curve::new(&branch, |_| range, &mut states).expect("a curve");
            let (lower, upper) = curve.log_range();
            assert!(near(upper, states[0].log_excess, 1e-13), "{upper}");
            assert!(upper - lower >= range && curve.is_resolved(), "{lower} to {upper}");
            assert!(if range < 100.0 { upper - lower < 3.0 * range } else { lower == f64::NEG_INFINITY }, "{lower}");
            for state in &states {
                let found = curve.separation(state.log_excess).expect("a separation");
                assert!((found - state.separation).abs() < 1e-4, "{found}, not {}", state.separation);
                let [(force, slope)] = curve.at([state.log_excess]);
                assert!(near(force, curve.force_of(state), 1e-10), "{force}");
                assert!(near(slope, state.log_slope, 1e-8), "{slope}");
            }
            assert_eq!(curve.separation(upper + 1e-9), None);
            assert_eq!(curve.separation(lower.max(-1e3) - 1e-9).is_some(), lower == f64::NEG_INFINITY);
            // Side by side as one by one, also where panels meet.
            let several: [f64; 8] = std::array::from_fn(|i| lower.max(upper - 40.0) + 2.5 * i as f64 + 0.1);
            assert_eq!(curve.at(several), several.map(|log_excess| curve.at([log_excess])[0]));
        }
    }

    fn of(params: &Params) -> Branch {
        Branch::new(crate::population::tests::of(params)).expect("a branch")
    }

    fn table(height: &[f64], density: &[f64]) -> HeightFamily {
        HeightFamily::Tabulated { height: height.into(), density: density.into() }
    }

    /// Heavy loads are those at a separation far below the mean height and below pull-off, and far above the pull-off load.
    #[test]
    fn the_curve_begins_where_loads_are_heavy() {
        let heaviest = |params: &Params| {
            let branch = of(params);
            let mut states = Vec::new();
            Curve::new(&branch, |_| 5.0, &mut states).expect("a curve");
            let pull_off = branch.pull_off().expect("a pull-off point");
            (states[0], pull_off, branch.population().heights().origin())
        };
        // Measured from elsewhere than their mean.
        let (state, _, origin) =
            heaviest(&Params { heights: table(&[7.0, 8.0, 9.0], &[0.0, 1.0, 0.0]), ..Params::default() });
        assert!(near(state.separation, CLOSEST - origin, 1e-14) && origin > 1.0, "{state:?}, {origin}");
        // A few low and blunt summits among sharp ones set the pull-off load.
        let (state, pull_off, _) = heaviest(&Params {
            heights: table(&[0.0, 0.1, 0.2, 9.9, 10.0, 10.1], &[0.0, 1.0, 0.0, 0.0, 19.0, 0.0]),
            radius_amplitude: -1.0,
            radius_rate: 100.0,
            work_of_adhesion: 0.05 * Params::default().work_of_adhesion,
            ..Params::default()
        });
        assert!(near(state.separation, pull_off.separation - 10.0, 1e-14), "{state:?}, {pull_off:?}");
        // Strong adhesion beside little roughness.
        let mut strong = Params::default();
        strong.set_dimensionless(1e-3, 10.0, 1.0, 1.0, 0.3).expect("a surface");
        let (state, pull_off, _) = heaviest(&strong);
        let above = state.log_excess - (-pull_off.load).ln();
        assert!(
            state.separation < CLOSEST && (LOG_ABOVE_PULL_OFF..LOG_ABOVE_PULL_OFF + 1.0).contains(&above),
            "{above}"
        );
    }

    /// Without a pull-off load, of heights that end: down to where contacts have lost their digits.
    #[test]
    fn the_curve_of_heights_that_end_ends_next_to_them() {
        let branch = of(&Params {
            heights: table(&[0.0, 1.0, 2.0, 4.0], &[0.0, 2.0, 3.0, 0.0]),
            work_of_adhesion: 0.0,
            ..Params::default()
        });
        let curve = Curve::new(&branch, |_| 1e3, &mut Vec::new()).expect("a curve");
        let end = curve.separation(curve.log_range().0).expect("a separation");
        let highest = branch.population().heights().support().1;
        assert!(highest - end > 0.0 && highest - end < 1e-3, "{}", highest - end);
    }

    #[test]
    fn a_panel_is_compared_between_its_nodes_and_its_states_are_counted() {
        let branch = branch(0.001);
        let mut curve = Curve::new(&branch, |_| 1e3, &mut Vec::new()).expect("a curve");
        let spent = NODES + 3;
        let fewest = spent * curve.panels.len();
        assert!((fewest..=fewest + 4 * spent).contains(&curve.samples), "{} states", curve.samples);
        let from = curve.sample(&branch, -1.0).expect("a state");
        let Attempt { panel, between, end, .. } = curve.attempt(&branch, from, 0.5).expect("a panel");
        assert_eq!((panel.highest, panel.lowest, end.separation), (from.s, end.s, 0.5));
        let gap = panel.nodes.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
        let nearest =
            between.map(|state| panel.nodes.map(|node| (node - state.s).abs()).into_iter().fold(9.0, f64::min));
        assert!(near(nearest[1], 0.5 * gap, 1e-2) && nearest[0] > 0.05 * gap, "{nearest:?} in gaps of {gap}");
    }

    /// As many kinks as are resolved take more states than a smooth curve may.
    #[test]
    fn the_curve_of_a_table_with_many_kinks_is_followed_to_its_end() {
        let height: Vec<f64> = (0..55).map(f64::from).collect();
        let density: Vec<f64> = height.iter().map(|h| h * (54.0 - h)).collect();
        let branch = of(&Params { heights: table(&height, &density), ..Params::default() });
        let curve = Curve::new(&branch, |_| 60.0, &mut Vec::new()).expect("a curve");
        assert!(curve.is_resolved() && curve.samples > MOST_SAMPLES + 500, "{} states", curve.samples);
        assert_eq!(curve.log_range().0, f64::NEG_INFINITY);
    }

    /// ln F = 2 + 3 s + s^2/2 at separations 1 - s.
    fn parabola() -> Panel {
        let sample = |s: f64| Sample {
            separation: 1.0 - s,
            log_excess: 2.0 * s,
            s,
            log_force: 2.0 + 3.0 * s + 0.5 * s * s,
            slope: 3.0 + s,
            log_slope: f64::NAN,
        };
        let node = |j: usize| 0.1 + (1.0 + (std::f64::consts::PI * (j as f64 + 0.5) / NODES as f64).cos()).powf(1.2);
        Panel { good: true, ..Panel::new(2.5, 0.1, &std::array::from_fn(|j| sample(node(j)))) }
    }

    #[test]
    fn a_panel_has_the_values_and_slopes_it_is_made_from_and_says_how_far_others_lie() {
        let panel = parabola();
        let exact =
            Sample { separation: 0.7, log_excess: 0.6, s: 0.3, log_force: 2.945, slope: 3.3, log_slope: f64::NAN };
        assert!(near(panel.separation_at(0.3), 0.7, 1e-13));
        let [(value, slope)] = panel.log_force_at([0.3]);
        assert!(near(value, 2.945, 1e-13) && near(slope, 3.3, 1e-11), "{value}, {slope}");
        assert!(Panel { good: false, ..panel.clone() }.log_force_at([0.3])[0].0.is_nan());
        let gaps: Vec<[f64; 2]> =
            panel.nodes.windows(2).map(|pair| [pair[0] - pair[1], 0.5 * (pair[0] + pair[1])]).collect();
        let widest = gaps.iter().fold([0.0; 2], |widest, &gap| if gap[0] > widest[0] { gap } else { widest });
        assert!(near(panel.sparsest(), widest[1], 1e-15), "{}, not {widest:?} of {gaps:?}", panel.sparsest());
        let off = |value: f64, slope: f64| {
            panel.excess(&Sample { log_force: exact.log_force + value, slope: exact.slope * (1.0 + slope), ..exact })
        };
        for sign in [1.0, -1.0] {
            assert!(near(off(sign * 20.0 * VALUE_TOLERANCE, 0.0), 20.0, 0.1), "{}", off(20.0 * VALUE_TOLERANCE, 0.0));
            assert!(near(off(0.0, sign * 20.0 * SLOPE_TOLERANCE), 20.0, 0.1), "{}", off(0.0, 20.0 * SLOPE_TOLERANCE));
        }
        assert!(off(0.0, 0.0) < 0.1);
        // At pull-off itself there is no slope; a value that is none is as far as can be.
        let at_pull_off = Sample { slope: f64::NAN, log_force: exact.log_force + 5.0 * VALUE_TOLERANCE, ..exact };
        assert!(near(panel.excess(&at_pull_off), 5.0, 0.1));
        assert_eq!(panel.excess(&Sample { log_force: f64::NAN, ..exact }), f64::INFINITY);
        assert_eq!(largest(1.0, f64::NAN), f64::INFINITY);
        assert_eq!(largest(f64::NAN, 1.0), f64::INFINITY);
        assert_eq!(largest(1.0, 2.0), 2.0);
    }
}
