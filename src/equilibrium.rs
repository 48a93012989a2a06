//! Load control: the separation at which the population carries a load, and the pull-off load below which
//! there is none.
//!
//! Unloading from heavy load follows the load down to its first minimum over separation. Below that minimum
//! nothing holds the surfaces together; above it each load has one state.

use crate::error::Error;
use crate::population::{integrate_short, Population, Sums};
use crate::root;

/// Separations are searched between these, in sigma.
const CLOSEST: f64 = -1e60;
/// The load curve is looked at for its first minimum from this separation of the means, in sigma...
const SCAN_START: f64 = -6.0;
/// ...in steps of this: sums over the heights change on the scale of their standard deviation, not faster...
const SCAN_STEP: f64 = 1.0;
/// ...or, where radii that vary with height may let the load rise within less, of the wider of these, and twice it where
/// they vary gently; where the heights may gather at several, of half the range of adhesion within both...
const WIDEST_SCAN: f64 = 0.25;
const FINEST_SCAN: f64 = 0.02;
/// ...where heights end, up to this far from where nothing touches or attracts any more, relative to it.
const NEAREST_TO_END: f64 = 1e-9;
/// ...no farther out than this many ranges of adhesion.
const FARTHEST_SCAN: f64 = 1e12;
/// A pull-off load smaller than exp of this cannot be told from none.
const SMALLEST_LOG_LOAD: f64 = -640.0;
/// The lightest load of a highest summit, in the same way.
const SMALLEST_LOG_LOAD_AT_END: f64 = -690.0;
/// Below this part of the pull-off load, load minus pull-off load is integrated from the slope: the difference of
/// the two loads would have lost too many digits.
const NEAR_PULL_OFF: f64 = 1e-4;

/// The lightest loads of a highest summit are found by halving the distance from it, hundreds of times.
const MOST_STEPS: u32 = 1000;

/// How well a load next to the pull-off load is known, relative to it.
const LOAD_ROUNDING: f64 = 2e-11;

/// Where the surfaces part under load control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PullOff {
    /// In sigma.
    pub separation: f64,
    /// Negative, in E* b^2 per summit.
    pub load: f64,
    /// In G* b^2 per summit.
    pub friction: f64,
}

/// The branch of equilibrium states under load control.
#[derive(Debug, Clone)]
pub struct Equilibrium {
    pull_off: Option<PullOff>,
    /// The largest separation on the branch.
    farthest: f64,
}

impl Equilibrium {
    /// Finds the pull-off point.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if there is one that cannot be found.
    pub fn new(population: &Population) -> Result<Self, Error> {
        if !population.is_adhesive() {
            return Ok(Self { pull_off: None, farthest: population.farthest() });
        }
        // Where heights gather, minima are shallow.
        let scanned = if population.has_single_minimum() || !population.heights().is_log_concave() {
            bracket_first_minimum(population).map(|bracket| ends(population, bracket))
        } else {
            // Many states are looked at for a sign.
            bracket_first_minimum(&population.roughly()).map(|bracket| about(population, bracket))
        };
        let at_foot = bracket_at_foot(population).map(|bracket| ends(population, bracket));
        let bracket = match (scanned, at_foot) {
            (Some(scanned), Some(at_foot)) => Some(if at_foot[0].0 < scanned[0].0 { at_foot } else { scanned }),
            (scanned, at_foot) => scanned.or(at_foot),
        };
        match bracket {
            Some(bracket) => Self::within(population, bracket),
            None => Ok(Self { pull_off: None, farthest: population.farthest() }),
        }
    }

    /// The branch that ends near a separation at which the load was found to rise already, or to be below what was taken
    /// for its first minimum.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if no minimum can be found there, [`Error::OutOfRange`] if the load there is not negative.
    pub fn ending_near(population: &Population, off_branch: f64) -> Result<Self, Error> {
        let mut rising = off_branch;
        while falls(population, rising) {
            rising += FINEST_SCAN;
            if rising > population.farthest() {
                return Err(Error::NotConverged { what: "separation at pull-off", value: off_branch });
            }
        }
        let mut step = 1e-3;
        while step < 100.0 {
            if falls(population, rising - step) {
                return Self::within(population, ends(population, (rising - step, rising)));
            }
            step *= 2.0;
        }
        Err(Error::NotConverged { what: "separation at pull-off", value: off_branch })
    }

    /// The branch that ends in a bracket, of two separations with their sums.
    fn within(
        population: &Population,
        [(lower, at_lower), (upper, at_upper)]: [(f64, Sums); 2],
    ) -> Result<Self, Error> {
        // All in one scale, so that interpolation makes sense; of what is far below it, the sign.
        let scale = |sums: &Sums| (sums.log_scale - at_lower.log_scale).clamp(-600.0, 600.0).exp();
        let slope = |sums: &Sums| sums.load_slope * scale(sums);
        let load = |sums: &Sums| sums.load() * scale(sums);
        let (mut last, mut sums) = (lower, at_lower);
        let mut lowest = (lower, at_lower);
        // A load that falls on both sides rises in a jump between.
        let mut separation = if slope(&at_upper) < 0.0 {
            lower
        } else {
            let slope_at = |separation: f64| {
                (last, sums) = (separation, population.at_separation(separation));
                if load(&sums) < load(&lowest.1) {
                    lowest = (last, sums);
                }
                slope(&sums)
            };
            root::between(slope_at, (lower, slope(&at_lower)), (upper, slope(&at_upper)))
        };
        if separation != last {
            sums = population.at_separation(separation);
        }
        // Where summits that gather at the foot part at once, the slope changes sign in a jump: the load may have jumped.
        let jumped = load(&sums) - load(&lowest.1) > LOAD_ROUNDING * load(&lowest.1).abs();
        if jumped && !population.partings().is_empty() {
            (separation, sums) = lowest;
        }
        if sums.load() >= 0.0 {
            return Err(Error::OutOfRange {
                name: "pull-off load",
                value: sums.unscaled().load().into(),
                allowed:
                    "(in composite_modulus burgers_vector^2 per summit) must be below 0: here most summits part while \
                          a few tall ones still carry the load, and the surfaces would part in steps",
            });
        }
        let log_load = (-sums.load()).ln() + sums.log_scale;
        if log_load < SMALLEST_LOG_LOAD {
            return Ok(Self { pull_off: None, farthest: separation });
        }
        let sums = sums.unscaled();
        let pull_off = PullOff { separation, load: sums.load(), friction: sums.friction };
        Ok(Self { pull_off: Some(pull_off), farthest: separation })
    }

    /// The pull-off point; `None` without adhesion, or where its load is too small for a number.
    pub fn pull_off(&self) -> Option<PullOff> {
        self.pull_off
    }

    /// The smallest load of the branch, where friction sets in: the pull-off load, or 0.
    pub fn pull_off_load(&self) -> f64 {
        self.pull_off.map_or(0.0, |point| point.load)
    }

    /// The largest separation on the branch.
    pub fn farthest(&self) -> f64 {
        self.farthest
    }

    /// ln(load - pull-off load) at a separation on the branch, with its derivative by separation, and the sums.
    pub fn log_excess(&self, population: &Population, separation: f64) -> (f64, f64, Sums) {
        let sums = population.at_separation(separation);
        let Some(pull_off) = self.pull_off else {
            let load = sums.load().max(f64::MIN_POSITIVE);
            return (load.ln() + sums.log_scale, sums.load_slope / load, sums);
        };
        let sums = sums.unscaled();
        let mut excess = sums.load() - pull_off.load;
        if excess < NEAR_PULL_OFF * -pull_off.load {
            let slope = |d: f64| -population.at_separation(d).unscaled().load_slope;
            let integral = integrate_short(separation, pull_off.separation, slope);
            // The two differ by rounding, unless the slope has a kink between: the foot of the heights passes an edge of
            // contact. The difference is then the better one.
            if (integral - excess).abs() <= LOAD_ROUNDING * -pull_off.load {
                excess = integral;
            }
        }
        let excess = excess.max(f64::MIN_POSITIVE);
        (excess.ln(), sums.load_slope / excess, sums)
    }

    /// The separation at which ln(load - pull-off load) is this, and the sums there, from a guess if there is one.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn at_log_excess(
        &self,
        population: &Population,
        target: f64,
        guess: Option<f64>,
    ) -> Result<(f64, Sums), Error> {
        let failure = Error::NotConverged { what: "ln(load - pull-off load)", value: target };
        // Where heights end nothing scales the sums up: lighter loads are no numbers.
        let ends = population.heights().head().is_finite();
        let target = if ends { target.max(SMALLEST_LOG_LOAD_AT_END) } else { target };
        let mut upper = self.farthest;
        let (mut separation, mut here, mut lower);
        match guess {
            Some(guess) => {
                separation = guess.min(upper);
                here = self.log_excess(population, separation);
                lower = CLOSEST;
            }
            None => {
                // A bracket, from where the branch ends or the middle of the heights, leftwards to heavy load.
                lower = upper.min(1.0) - 1.0;
                let mut step = 2.0;
                here = self.log_excess(population, lower);
                while here.0 < target {
                    upper = lower;
                    lower -= step;
                    step *= 4.0;
                    if lower < CLOSEST {
                        return Err(failure);
                    }
                    here = self.log_excess(population, lower);
                }
                separation = lower;
            }
        }
        let mut last_step = f64::MAX;
        for _ in 0..MOST_STEPS {
            let (log_excess, slope, sums) = here;
            if !sums.are_known() {
                return Err(failure);
            }
            let residual = log_excess - target;
            if residual >= 0.0 {
                lower = separation;
            } else {
                upper = separation;
            }
            // Beyond a pull-off load that is no number the slope of its logarithm is none either.
            let newton = if slope < 0.0 && slope.is_finite() { separation - residual / slope } else { lower };
            let resolution = 4.0 * f64::EPSILON * separation.abs().max(f64::MIN_POSITIVE);
            let next = if (newton - separation).abs() <= resolution || (newton > lower && newton < upper) {
                newton
            } else {
                // No step to the left is much longer than the separation itself.
                0.5 * (lower.max(separation - separation.abs() - 4.0) + upper)
            };
            let change = (next - separation).abs();
            if residual.abs() <= 4.0 * f64::EPSILON
                || change <= resolution
                || upper - lower <= resolution
                || (residual.abs() < 1e-11 && change >= 0.5 * last_step)
            {
                return Ok((separation, sums));
            }
            last_step = change;
            separation = next;
            here = self.log_excess(population, separation);
        }
        Err(failure)
    }
}

/// Two separations between which the load has its first minimum, coming from heavy load; `None` where the load
/// falls as long as it can be represented.
fn bracket_first_minimum(population: &Population) -> Option<(f64, f64)> {
    let farthest = population.farthest();
    // A first look at the middle of the heights; where there may be several minima, from heavy load.
    let single = population.has_single_minimum();
    let mut here = if single { 0.0 } else { SCAN_START } - population.heights().origin();
    let mut step = SCAN_STEP;
    while !falls(population, here) {
        here -= step;
        step *= 1.5;
        if here < CLOSEST {
            return None;
        }
    }
    let scan_step = if single {
        SCAN_STEP
    } else if population.heights().is_log_concave() {
        (0.5 * population.radius_scale()).clamp(WIDEST_SCAN, 2.0 * WIDEST_SCAN)
    } else {
        (0.5 * population.range_of_adhesion()).clamp(FINEST_SCAN, WIDEST_SCAN)
    };
    step = scan_step;
    // In a tail so heavy that the load falls that far out, separations no longer resolve what adhesion does.
    let farthest = if single { farthest } else { farthest.min(FARTHEST_SCAN * population.range_of_adhesion()) };
    // Beyond where nothing touches or attracts any more there is no slope to be seen.
    let ends = population.heights().head().is_finite();
    while here < farthest {
        let mut next = here + step;
        if ends && next > here + 0.5 * (farthest - here) {
            next = here + 0.5 * (farthest - here);
            if farthest - next < NEAREST_TO_END * (1.0 + farthest.abs()) {
                return None;
            }
        }
        let sums = population.at_separation(next);
        if sums.load_slope >= 0.0 {
            // The slope vanishes also where nothing is left; past a minimum the load is negative.
            let past = if sums.load() < 0.0 { next } else { before_nothing_is_left(population, &mut here, next)? };
            return Some(if single { (here, past) } else { first_bracket(population, here, past) });
        }
        // What is positive and as small as that has no minimum that counts behind it.
        if sums.load().ln() + sums.log_scale < SMALLEST_LOG_LOAD {
            return None;
        }
        here = next;
        // Far out the heights change on the scale of their distance.
        step = if single { 1.5 * step } else { scan_step.max(0.1 * here) };
    }
    None
}

/// Two separations between which the load has a minimum because many summits that gather at the foot part at once: next to
/// where they lose contact or attraction, nearer than a scan looks.
fn bracket_at_foot(population: &Population) -> Option<(f64, f64)> {
    const NEAREST: i32 = 15;
    let scale = population.heights().head() - population.heights().foot();
    let offsets = (1..=NEAREST).map(|k| -0.1_f64.powi(k)).chain((1..=NEAREST).rev().map(|k| 0.1_f64.powi(k)));
    let first_minimum = |parting: f64| {
        let mut before: Option<(f64, f64)> = None;
        for separation in offsets.clone().map(|offset| parting + scale * offset) {
            let sums = population.at_separation(separation).unscaled();
            let rises = sums.load_slope >= 0.0;
            match before {
                None if rises => return None,
                Some((nearer, load)) if rises || sums.load() >= load => return Some((nearer, separation)),
                _ => before = Some((separation, sums.load())),
            }
        }
        None
    };
    population.partings().into_iter().find_map(first_minimum)
}

/// A separation past the minimum at which something is left, where a step led from a falling load to nothing; `None` if
/// the load falls until nothing is left. Moves `here` on where the load falls still.
fn before_nothing_is_left(population: &Population, here: &mut f64, nothing: f64) -> Option<f64> {
    let mut nothing = nothing;
    while nothing - *here > 1e-9 * (1.0 + here.abs()) {
        let middle = 0.5 * (*here + nothing);
        let sums = population.at_separation(middle);
        if sums.load_slope < 0.0 {
            *here = middle;
        } else if sums.load() < 0.0 {
            return Some(middle);
        } else {
            nothing = middle;
        }
    }
    None
}

/// The first part of a bracket across which the slope changes sign: where radii vary, the load may have a shallow
/// minimum before the deepest one.
fn first_bracket(population: &Population, lower: f64, upper: f64) -> (f64, f64) {
    const PARTS: u32 = 16;
    let at = |part: u32| lower + (upper - lower) * f64::from(part) / f64::from(PARTS);
    let first = (1..PARTS).find(|&part| !falls(population, at(part))).unwrap_or(PARTS);
    (at(first - 1), at(first))
}

/// A bracket with the sums at its ends.
fn ends(population: &Population, (lower, upper): (f64, f64)) -> [(f64, Sums); 2] {
    [lower, upper].map(|separation| (separation, population.at_separation(separation)))
}

/// The same about a bracket that was found by rough sums, which may mistake a sign next to where it changes.
fn about(population: &Population, bracket: (f64, f64)) -> [(f64, Sums); 2] {
    let [mut lower, mut upper] = ends(population, bracket);
    let mut step = (upper.0 - lower.0).max(f64::EPSILON * upper.0.abs());
    while lower.1.load_slope >= 0.0 && lower.0 > CLOSEST {
        lower = (lower.0 - step, population.at_separation(lower.0 - step));
        step *= 2.0;
    }
    while upper.1.load_slope < 0.0 && upper.0 < population.farthest() {
        upper = (upper.0 + step, population.at_separation(upper.0 + step));
        step *= 2.0;
    }
    [lower, upper]
}

/// Whether the load falls as separation grows.
fn falls(population: &Population, separation: f64) -> bool {
    population.at_separation(separation).load_slope < 0.0
}
