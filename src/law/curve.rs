//! The branch of load control as a smooth curve through exact states, from which the table is filled.
//!
//! The coordinate is s = arsinh((x/|pull-off|)^(1/2)) with x = load - pull-off: near pull-off, where load has its
//! minimum over separation, it is linear in separation, far from it logarithmic in load; without adhesion it is
//! ln(x)/2. In it ln F is smooth on the whole branch. Panels of exact states at Chebyshev points, each with its slope,
//! are joined by Hermite interpolation, and a panel that misses the exact states between its nodes is halved.

use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::population::Population;

/// Exact states per panel.
const NODES: usize = 10;
/// Interpolation conditions per panel: value and slope at every node.
const CONDITIONS: usize = 2 * NODES;
/// The branch is followed from this separation of the means, in sigma; heavier loads are evaluated exactly.
const CLOSEST: f64 = -12.0;
/// The branch is followed from at least this much above the pull-off load, in ln(load).
const LOG_ABOVE_PULL_OFF: f64 = 9.0;
/// Largest error of ln F, and of its slope relative to the slope, at which a panel is good.
const VALUE_TOLERANCE: f64 = 1e-11;
const SLOPE_TOLERANCE: f64 = 1e-9;
/// The first panels are this wide, in sigma.
const FIRST_WIDTH: f64 = 2.2;
/// Without a pull-off load a panel covers no more than this part of what is left of the branch.
const MOST_OF_THE_REST: f64 = 0.7;
/// No more than about this many exact states are spent; lighter loads than they reach are evaluated exactly.
const MOST_SAMPLES: usize = 800;
/// The narrowest first attempt, in sigma.
const NARROWEST: f64 = 1e-3;
/// A panel is halved this often at most, and the one that ends at pull-off, where load may change steeply, so often:
/// what is then not resolved (a height density whose foot passes the edge of contact, say) is evaluated exactly.
const MOST_HALVINGS: u32 = 5;
const MOST_HALVINGS_AT_END: u32 = 12;

/// What is not found where the load rises with separation already: the branch ends before.
pub const BRANCH: &str = "load on the branch at separation";

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

/// The curve, from heavy to light load.
#[derive(Debug, Clone)]
pub struct Curve {
    coordinate: Coordinate,
    panels: Vec<Panel>,
    /// Exact states spent.
    samples: usize,
}

impl Coordinate {
    fn of(self, log_excess: f64) -> f64 {
        match self.log_pull_off {
            Some(log_pull_off) => (0.5 * (log_excess - log_pull_off)).exp().asinh(),
            None => 0.5 * log_excess,
        }
    }

    /// ds/d(ln x).
    fn rate(self, s: f64) -> f64 {
        match self.log_pull_off {
            Some(_) => 0.5 * s.tanh(),
            None => 0.5,
        }
    }
}

impl Curve {
    /// Follows the branch from heavy load down to pull-off, or through `log_range` of ln(load) without one. Hands every
    /// exact state that is not a node to `check`.
    ///
    /// # Errors
    /// [`Error::NotConverged`] where the branch cannot be followed.
    pub fn new(
        population: &Population,
        equilibrium: &Equilibrium,
        log_range: f64,
        check: &mut Vec<Sample>,
    ) -> Result<Self, Error> {
        let log_pull_off = equilibrium.pull_off().map(|point| (-point.load).ln());
        let force = equilibrium.pull_off().map_or(1.0, |point| point.friction);
        let mut curve = Self { coordinate: Coordinate { log_pull_off, force }, panels: Vec::new(), samples: 0 };
        let end = equilibrium.farthest();
        let closest = CLOSEST - population.heights().origin();
        let mut from = curve.sample(population, equilibrium, closest.min(end - 10.0))?;
        // Adhesion that is strong beside the roughness: on to loads well above pull-off.
        while log_pull_off.is_some_and(|pull_off| from.log_excess < pull_off + LOG_ABOVE_PULL_OFF) {
            from = curve.sample(population, equilibrium, 1.5 * from.separation.min(closest))?;
        }
        let lightest = from.log_excess - log_range;
        check.push(from);
        let mut width = FIRST_WIDTH;
        while from.separation < end
            && (log_pull_off.is_some() || from.log_excess > lightest)
            && curve.samples < MOST_SAMPLES
        {
            let mut to = from.separation + width.max(0.4 * -from.separation);
            if log_pull_off.is_none() {
                // Load vanishes at the end as a power of the distance.
                to = to.min(from.separation + MOST_OF_THE_REST * (end - from.separation));
            } else if to + 0.25 * width > end {
                to = end;
            }
            let panels = curve.panels.len();
            from = curve.follow(population, equilibrium, from, to, 0, check)?;
            // Wider where one panel did, narrower where it took several.
            width = if curve.panels.len() == panels + 1 { 1.3 * width } else { (0.5 * width).max(NARROWEST) };
        }
        Ok(curve)
    }

    /// Adds the panel between two separations, halved as often as it takes; returns the state at its end.
    fn follow(
        &mut self,
        population: &Population,
        equilibrium: &Equilibrium,
        from: Sample,
        to: f64,
        halvings: u32,
        check: &mut Vec<Sample>,
    ) -> Result<Sample, Error> {
        let (middle, half) = (0.5 * (from.separation + to), 0.5 * (to - from.separation));
        let mut nodes = [from; NODES];
        for (j, node) in nodes.iter_mut().enumerate() {
            let angle = std::f64::consts::PI * (j as f64 + 0.5) / NODES as f64;
            *node = self.sample(population, equilibrium, middle - half * angle.cos())?;
        }
        let end = match equilibrium.pull_off() {
            Some(point) if point.separation == to => Sample {
                separation: to,
                log_excess: f64::NEG_INFINITY,
                s: 0.0,
                log_force: 0.0,
                slope: f64::NAN,
                log_slope: f64::NAN,
            },
            _ => self.sample(population, equilibrium, to)?,
        };
        let mut panel = Panel::new(from.s, end.s, &nodes);
        // Between the nodes: in the middle of the panel, and where the nodes are farthest apart in s.
        let between = self.sample(population, equilibrium, middle + 0.1 * half)?;
        let (first, last) = (nodes[0].separation, nodes[NODES - 1].separation);
        let sparse = panel.separation_at(panel.sparsest()).clamp(first, last);
        let sparse = self.sample(population, equilibrium, sparse)?;
        let good = [from, between, sparse, end].iter().all(|sample| panel.is_good(sample));
        self.samples += NODES + 3;
        let most = if to == equilibrium.farthest() { MOST_HALVINGS_AT_END } else { MOST_HALVINGS };
        if !good && halvings < most && self.samples < MOST_SAMPLES {
            let next = self.follow(population, equilibrium, from, middle, halvings + 1, check)?;
            return self.follow(population, equilibrium, next, to, halvings + 1, check);
        }
        panel.good = good;
        self.panels.push(panel);
        check.push(between);
        check.push(sparse);
        if end.slope.is_finite() {
            check.push(end);
        }
        Ok(end)
    }

    fn sample(&self, population: &Population, equilibrium: &Equilibrium, separation: f64) -> Result<Sample, Error> {
        let (log_excess, rate, sums) = equilibrium.log_excess(population, separation);
        if !(rate < 0.0 && sums.friction > 0.0) {
            return Err(Error::NotConverged { what: BRANCH, value: separation });
        }
        let s = self.coordinate.of(log_excess);
        let log_slope = sums.friction_slope / sums.friction / rate;
        Ok(Sample {
            separation,
            log_excess,
            s,
            log_force: (sums.friction / self.coordinate.force).ln() + sums.log_scale,
            slope: log_slope / self.coordinate.rate(s),
            log_slope,
        })
    }

    /// The range of ln(load - pull-off) it covers; the lower end is minus infinity where it begins at pull-off.
    pub fn log_range(&self) -> (f64, f64) {
        let (Some(first), Some(last)) = (self.panels.first(), self.panels.last()) else {
            return (0.0, 0.0);
        };
        let log = |s: f64| match self.coordinate.log_pull_off {
            Some(log_pull_off) => 2.0 * s.sinh().ln() + log_pull_off,
            None => 2.0 * s,
        };
        let lower = if last.lowest > 0.0 || self.coordinate.log_pull_off.is_none() {
            log(last.lowest)
        } else {
            f64::NEG_INFINITY
        };
        (lower, log(first.highest))
    }

    /// F and d(ln F)/d(ln x) at ln x; NaN where the curve is not known to be good.
    pub fn at(&self, log_excess: f64) -> (f64, f64) {
        let s = self.coordinate.of(log_excess);
        let panel = self.panel(s);
        if !panel.good {
            return (f64::NAN, f64::NAN);
        }
        let (log_force, slope) = panel.log_force_at(s);
        (self.coordinate.force * log_force.exp(), slope * self.coordinate.rate(s))
    }

    /// F of an exact state.
    pub fn force_of(&self, sample: &Sample) -> f64 {
        self.coordinate.force * sample.log_force.exp()
    }

    /// The separation at ln x, to a few digits, where the curve covers it.
    pub fn separation(&self, log_excess: f64) -> Option<f64> {
        let s = self.coordinate.of(log_excess);
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

    /// ln F and its derivative by s.
    fn log_force_at(&self, s: f64) -> (f64, f64) {
        let (mut value, mut slope) = (self.log_force[CONDITIONS - 1], 0.0);
        for i in (0..CONDITIONS - 1).rev() {
            let distance = s - self.nodes[i / 2];
            slope = slope * distance + value;
            value = value * distance + self.log_force[i];
        }
        (value, slope)
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

    fn is_good(&self, sample: &Sample) -> bool {
        let (value, slope) = self.log_force_at(sample.s);
        (value - sample.log_force).abs() <= VALUE_TOLERANCE
            && (sample.slope.is_nan() || (slope - sample.slope).abs() <= SLOPE_TOLERANCE * sample.slope.abs())
    }
}
