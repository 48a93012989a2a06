//! Load control: the separation at which the population carries a load, and the pull-off load below which
//! there is none.
//!
//! Unloading from heavy load follows the load down to its first minimum over separation. Below that minimum
//! nothing holds the surfaces together; above it each load has one state.

use crate::elementary::{exp, log};
use crate::error::Error;
use crate::gauss_legendre::integrate_short;
use crate::population::{Population, Sums};
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

/// Hardly any heights are this many sigma below their mean: where they begin is then no kink.
const LOWEST_FOOT: f64 = 8.0;

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

/// The equilibrium states of a surface pair under load control, from heavy load to pull-off.
#[derive(Debug, Clone)]
pub struct Branch {
    population: Population,
    equilibrium: Equilibrium,
}

/// A state on the branch.
#[derive(Debug, Clone, Copy)]
pub struct BranchPoint {
    /// ln(load - pull-off load).
    pub log_excess: f64,
    /// Its derivative by separation.
    pub rate: f64,
    /// The sums over the summits.
    pub sums: Sums,
}

impl Branch {
    /// The branch of a population, which it owns.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if there is a pull-off point that cannot be found, [`Error::OutOfRange`] if the load
    /// there is not negative.
    pub fn new(population: Population) -> Result<Self, Error> {
        let equilibrium = Equilibrium::new(&population)?;
        Ok(Self { population, equilibrium })
    }

    /// The branch that ends before a separation at which the load was found to rise already.
    ///
    /// # Errors
    /// As [`Branch::new`].
    pub fn ending_near(self, separation: f64) -> Result<Self, Error> {
        let equilibrium = Equilibrium::ending_near(&self.population, separation)?;
        Ok(Self { equilibrium, ..self })
    }

    /// The summits.
    pub fn population(&self) -> &Population {
        &self.population
    }

    /// The pull-off point; `None` without adhesion, or where its load is too small for a number.
    pub fn pull_off(&self) -> Option<PullOff> {
        self.equilibrium.pull_off()
    }

    /// The smallest load of the branch, where friction sets in: the pull-off load, or 0.
    pub fn pull_off_load(&self) -> f64 {
        self.equilibrium.pull_off_load()
    }

    /// The largest separation on the branch.
    pub fn farthest(&self) -> f64 {
        self.equilibrium.farthest()
    }

    /// The state at a separation on the branch.
    pub fn log_excess(&self, separation: f64) -> BranchPoint {
        let (log_excess, rate, sums) = self.equilibrium.log_excess(&self.population, separation);
        BranchPoint { log_excess, rate, sums }
    }

    /// The separation at which ln(load - pull-off load) is this, and the sums there, from a guess if there is one.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn at_log_excess(&self, target: f64, guess: Option<f64>) -> Result<(f64, Sums), Error> {
        self.equilibrium.at_log_excess(&self.population, target, guess)
    }

    /// The separations at which the sums are not smooth, in ascending order: where a height at which the density has a
    /// kink, or begins, passes an overlap at which the law of one summit has one. Of heights that are smooth, where
    /// nearly all pass such an overlap within a small part of it: there the sums are smooth on their own scale alone.
    pub fn kinks(&self) -> Vec<f64> {
        let population = &self.population;
        let mut kinks = [population.kinks(), population.deep_passings()].concat();
        if population.heights().foot() > -population.heights().origin() - LOWEST_FOOT {
            kinks.extend(population.passings_of_foot());
        }
        kinks.sort_by(f64::total_cmp);
        kinks.dedup();
        kinks
    }
}

/// Where the branch of a population ends.
#[derive(Debug, Clone)]
struct Equilibrium {
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
            bracket_first_minimum(population)?.map(|bracket| ends(population, bracket))
        } else {
            // Many states are looked at for a sign.
            bracket_first_minimum(&population.roughly())?.map(|bracket| about(population, bracket))
        };
        let at_foot = bracket_at_foot(population)?.map(|bracket| ends(population, bracket));
        let (scanned, at_foot) = (scanned.transpose()?, at_foot.transpose()?);
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
        while falls(population, rising)? {
            rising += FINEST_SCAN;
            if rising > population.farthest() {
                return Err(Error::NotConverged { what: "separation at pull-off", value: off_branch });
            }
        }
        let mut step = 1e-3;
        while step < 100.0 {
            if falls(population, rising - step)? {
                return Self::within(population, ends(population, (rising - step, rising))?);
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
        let scale = |sums: &Sums| exp((sums.log_scale - at_lower.log_scale).clamp(-600.0, 600.0));
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
        let sums = sums.known(separation)?;
        if sums.load() >= 0.0 {
            return Err(Error::OutOfRange {
                name: "pull-off load",
                value: sums.unscaled().load().into(),
                allowed:
                    "(in composite_modulus burgers_vector^2 per summit) must be below 0: here most summits part while \
                          a few tall ones still carry the load, and the surfaces would part in steps",
            });
        }
        let log_load = log(-sums.load()) + sums.log_scale;
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
            let load = sums.load();
            return (log(load.max(f64::MIN_POSITIVE)) + sums.log_scale, sums.load_slope / load, sums);
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
        // A logarithm as small as can be stands for that of nothing, but not in its slope.
        (log(excess.max(f64::MIN_POSITIVE)), sums.load_slope / excess, sums)
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
            // Where no load is above that of pull-off, the slope of the logarithm leads nowhere.
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
fn bracket_first_minimum(population: &Population) -> Result<Option<(f64, f64)>, Error> {
    let farthest = population.farthest();
    // A first look at the middle of the heights; where there may be several minima, from heavy load.
    let single = population.has_single_minimum();
    let mut here = if single { 0.0 } else { SCAN_START } - population.heights().origin();
    let mut step = SCAN_STEP;
    while !falls(population, here)? {
        here -= step;
        step *= 1.5;
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
                return Ok(None);
            }
        }
        let sums = sums_at(population, next)?;
        if sums.load_slope >= 0.0 {
            // The slope vanishes also where nothing is left; past a minimum the load is negative.
            let past = match sums.load() < 0.0 {
                true => Some(next),
                false => before_nothing_is_left(population, &mut here, next)?,
            };
            let first = |past| if single { Ok((here, past)) } else { first_bracket(population, here, past) };
            return past.map(first).transpose();
        }
        // What is positive and as small as that has no minimum that counts behind it.
        if log(sums.load()) + sums.log_scale < SMALLEST_LOG_LOAD {
            return Ok(None);
        }
        here = next;
        // Far out the heights change on the scale of their distance.
        step = if single { 1.5 * step } else { scan_step.max(0.1 * here) };
    }
    Ok(None)
}

/// Two separations between which the load has a minimum because many summits that gather at the foot part at once: next to
/// where they lose contact or attraction, nearer than a scan looks.
fn bracket_at_foot(population: &Population) -> Result<Option<(f64, f64)>, Error> {
    const NEAREST: i32 = 15;
    let scale = population.heights().head() - population.heights().foot();
    let offsets = (1..=NEAREST).map(|k| -0.1_f64.powi(k)).chain((1..=NEAREST).rev().map(|k| 0.1_f64.powi(k)));
    let partings = population.partings();
    for (index, &parting) in partings.iter().enumerate() {
        let until = partings.get(index + 1).map_or(f64::INFINITY, |after| 0.5 * (parting + after));
        let separations = offsets.clone().map(|offset| parting + scale * offset);
        let mut lowest = f64::INFINITY;
        // The last separation at which the load falls, and the first after that at which it does not.
        let (mut lower, mut upper) = (None, None);
        for separation in separations.take_while(|&separation| separation < until) {
            let sums = sums_at(population, separation)?.unscaled();
            let (load, falls) = (sums.load(), sums.load_slope < 0.0);
            if lower.is_none() && !falls {
                return Ok(None);
            }
            // The slope alone says little: next to the parting it may be that of a few summits.
            let known = LOAD_ROUNDING * (sums.load_contacting.abs() + sums.load_attracted.abs());
            if load > lowest + known {
                return Ok(lower.map(|lower| (lower, upper.unwrap_or(separation))));
            }
            if falls {
                (lower, upper) = (Some(separation), None);
            } else {
                upper = upper.or(Some(separation));
            }
            lowest = lowest.min(load);
        }
    }
    Ok(None)
}

/// A separation past the minimum at which something is left, where a step led from a falling load to nothing; `None` if
/// the load falls until nothing is left. Moves `here` on where the load falls still.
fn before_nothing_is_left(population: &Population, here: &mut f64, nothing: f64) -> Result<Option<f64>, Error> {
    let mut nothing = nothing;
    while nothing - *here > 1e-9 * (1.0 + here.abs()) {
        let middle = 0.5 * (*here + nothing);
        let sums = sums_at(population, middle)?;
        if sums.load_slope < 0.0 {
            *here = middle;
        } else if sums.load() < 0.0 {
            return Ok(Some(middle));
        } else {
            nothing = middle;
        }
    }
    Ok(None)
}

/// The first part of a bracket across which the slope changes sign: where radii vary, the load may have a shallow
/// minimum before the deepest one.
fn first_bracket(population: &Population, lower: f64, upper: f64) -> Result<(f64, f64), Error> {
    const PARTS: u32 = 16;
    let at = |part: u32| lower + (upper - lower) * f64::from(part) / f64::from(PARTS);
    let mut first = 1;
    while first < PARTS && falls(population, at(first))? {
        first += 1;
    }
    Ok((at(first - 1), at(first)))
}

/// A bracket with the sums at its ends.
fn ends(population: &Population, (lower, upper): (f64, f64)) -> Result<[(f64, Sums); 2], Error> {
    Ok([(lower, sums_at(population, lower)?), (upper, sums_at(population, upper)?)])
}

/// The same about a bracket that was found by rough sums, which may mistake a sign next to where it changes.
fn about(population: &Population, bracket: (f64, f64)) -> Result<[(f64, Sums); 2], Error> {
    let [mut lower, mut upper] = ends(population, bracket)?;
    let mut step = (upper.0 - lower.0).max(f64::EPSILON * upper.0.abs());
    while lower.1.load_slope >= 0.0 && lower.0 > CLOSEST {
        lower = (lower.0 - step, sums_at(population, lower.0 - step)?);
        step *= 2.0;
    }
    while upper.1.load_slope < 0.0 && upper.0 < population.farthest() {
        upper = (upper.0 + step, sums_at(population, upper.0 + step)?);
        step *= 2.0;
    }
    Ok([lower, upper])
}

/// Whether the load falls as separation grows.
fn falls(population: &Population, separation: f64) -> Result<bool, Error> {
    Ok(sums_at(population, separation)?.load_slope < 0.0)
}

/// The sums at a separation, or why there are none.
fn sums_at(population: &Population, separation: f64) -> Result<Sums, Error> {
    population.at_separation(separation).known(separation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asperity::maugis::tests::EVALUATIONS;
    use crate::params::{HeightFamily, Params};

    /// Heights, alpha, beta, gamma and b/h, epsilon and rho.
    type Surface = (HeightFamily, [f64; 4], [f64; 2]);

    const ALIKE: [f64; 2] = [0.0, 1.0];
    const WEAK: [f64; 4] = [0.01, 1000.0, 1e-3, 1.0];
    const STRONG: [f64; 4] = [0.01, 1000.0, 0.02, 1.0];

    fn population((heights, [alpha, beta, gamma, b_over_h], [amplitude, rate]): &Surface) -> Population {
        let mut params =
            Params { heights: heights.clone(), radius_amplitude: *amplitude, radius_rate: *rate, ..Params::default() };
        params.set_dimensionless(*alpha, *beta, *gamma, *b_over_h, 0.3).expect("a surface");
        crate::population::tests::of(&params)
    }

    fn table() -> HeightFamily {
        let (height, density) = ([-3.0, -1.0, 0.0, 1.0, 1.5], [0.0, 1.0, 0.1, 1.0, 0.0]);
        HeightFamily::Tabulated { height: height.to_vec().into(), density: density.to_vec().into() }
    }

    /// Most summits about the second of these heights, a few about the last but one.
    fn tailed(height: [f64; 6]) -> HeightFamily {
        HeightFamily::Tabulated { height: height.to_vec().into(), density: vec![0.0, 1.0, 0.0, 0.0, 1e-6, 0.0].into() }
    }

    fn johnson(skew: f64, kurtosis: f64) -> HeightFamily {
        HeightFamily::Johnson { skew, kurtosis }
    }

    /// Surfaces with a pull-off load, and how many contacts are evaluated to find the bracket among the heights, that at the
    /// foot, the branch, and six states on it.
    fn surfaces() -> [(Surface, [u32; 4]); 17] {
        let first_of_two = [4.1046984e-4, 6.7468579e6, 0.24253, 0.224919];
        [
            // With equal radii contacts are not evaluated anew.
            ((HeightFamily::Gaussian, WEAK, ALIKE), [0, 0, 0, 2511]),
            ((HeightFamily::Gaussian, STRONG, ALIKE), [0, 0, 0, 5847]),
            ((HeightFamily::Gaussian, [0.01, 1000.0, 1.0, 1.0], ALIKE), [0, 0, 0, 6504]),
            ((HeightFamily::Weibull { shape: 1.5 }, WEAK, ALIKE), [338, 0, 1614, 19263]),
            ((HeightFamily::Gaussian, WEAK, [0.6, 1.5]), [23380, 0, 11044, 93503]),
            ((HeightFamily::Gaussian, STRONG, [-0.9, 1.5]), [24628, 0, 30183, 238611]),
            ((HeightFamily::Gaussian, STRONG, [0.9, 0.1]), [13656, 0, 19275, 132057]),
            ((HeightFamily::Gaussian, first_of_two, [-0.60546875, 9.119288]), [33429, 0, 41978, 264218]),
            ((HeightFamily::Weibull { shape: 2.4 }, WEAK, [-0.6, 4.0]), [26933, 0, 14589, 77571]),
            ((johnson(-0.8, 6.0), STRONG, [-0.5, 2.0]), [28989, 0, 41560, 304937]),
            ((johnson(0.5, 1.27), [0.01, 1000.0, 0.05, 0.2], ALIKE), [7796, 8692, 18421, 63319]),
            ((johnson(0.5, 1.27), [0.01, 1000.0, 0.05, 1.0], ALIKE), [11000, 8516, 22957, 65345]),
            ((johnson(1.0, 2.02), [0.01, 1000.0, 0.02, 0.2], ALIKE), [12072, 1210, 16755, 70247]),
            ((table(), WEAK, ALIKE), [19902, 0, 21005, 29237]),
            ((table(), STRONG, ALIKE), [2896, 0, 3448, 15701]),
            ((table(), WEAK, [0.7, 2.0]), [46134, 0, 48125, 66546]),
            ((table(), [0.01, 1000.0, 1.0, 1.0], [0.7, 2.0]), [19589, 0, 30402, 174141]),
        ]
    }

    /// The value, and how many contacts were evaluated for it.
    fn counted<T>(value: impl FnOnce() -> T) -> (T, u32) {
        EVALUATIONS.set(0);
        (value(), EVALUATIONS.get())
    }

    #[track_caller]
    fn assert_few(what: &str, surface: &Surface, count: u32, most: u32) {
        assert!(count <= most + most / 200, "{what} of {surface:?}: {count} contacts, not {most}");
    }

    fn load_at(population: &Population, separation: f64) -> f64 {
        population.at_separation(separation).unscaled().load()
    }

    /// How near to pull-off the slope is asked for.
    fn near(separation: f64) -> f64 {
        1e-6 * separation.abs().max(1.0)
    }

    fn load_falls(population: &Population, separation: f64) -> bool {
        falls(population, separation).expect("sums")
    }

    #[test]
    fn the_branch_ends_at_the_first_minimum_of_the_load() {
        for (surface, [_, _, most, _]) in surfaces() {
            let population = population(&surface);
            let (branch, count) = counted(|| Equilibrium::new(&population).expect("a branch"));
            // The last steps to a minimum are of rounding, which may take one more or one less.
            assert_few("the branch", &surface, count, most + most / 10);
            let point = branch.pull_off().expect("a pull-off point");
            let end = point.separation;
            assert_eq!((branch.farthest(), branch.pull_off_load()), (end, point.load));
            assert_eq!(load_at(&population, end), point.load);
            assert!((1..=400).all(|i| load_falls(&population, end - near(end) - 0.01 * f64::from(i))), "{surface:?}");
            assert!(
                load_falls(&population, end - near(end)) && !load_falls(&population, end + near(end)),
                "{surface:?}"
            );
        }
    }

    /// Where radii and heights are alike, steps that grow by half from the mean; elsewhere a sixteenth of a step.
    #[test]
    fn the_load_is_looked_at_in_steps_of_the_right_size() {
        for (surface, [most, ..]) in surfaces() {
            let population = population(&surface);
            let (bracket, count) = counted(|| bracket_first_minimum(&population).expect("sums"));
            assert_few("the bracket", &surface, count, most);
            let (lower, upper) = bracket.expect("a bracket");
            assert!(load_falls(&population, lower) && !load_falls(&population, upper), "{surface:?}: {lower}, {upper}");
            let step = if population.has_single_minimum() {
                let steps = (lower + population.heights().origin()) / 2.0 + 1.0;
                assert!((steps.log(1.5) - steps.log(1.5).round()).abs() < 1e-9, "{surface:?}: {lower}");
                steps
            } else if population.heights().is_log_concave() {
                (0.5 / surface.2[1]).clamp(0.25, 0.5).max(0.1 * lower) / 16.0
            } else {
                0.25_f64.min(0.5 * population.range_of_adhesion()) / 16.0
            };
            let off = (upper - lower) / step - 1.0;
            assert!(off < 1e-9 && (off > -0.2), "{surface:?}: {lower}, {upper}, not {step}");
        }
    }

    /// Both sides of it, wherever the bracket that is to be mended was, and no more of them than must be.
    #[test]
    fn a_bracket_is_mended_by_going_on_from_its_ends() {
        for (surface, _) in surfaces() {
            let population = population(&surface);
            let branch = Equilibrium::new(&population).expect("a branch");
            let end = branch.farthest();
            for (lower, upper) in
                [(-0.02, 0.02), (-0.05, -0.03), (0.01, 0.03), (0.05, 0.06), (-1e-9, -1e-9), (-0.01, -0.01)]
            {
                let [(a, at_a), (b, at_b)] = about(&population, (end + lower, end + upper)).expect("sums");
                assert!(at_a.load_slope < 0.0 && at_b.load_slope >= 0.0, "{surface:?}: {a}, {b} about {end}");
                assert_eq!(at_a.load_slope, population.at_separation(a).load_slope);
                assert_eq!(at_b.load_slope, population.at_separation(b).load_slope);
                // Steps double, so that none is longer than all before it.
                let widest: f64 = 2.0 * (upper - lower) + 2.0 * lower.abs().max(upper.abs()) + 1e-12;
                assert!(
                    a <= end && b >= end && b - a <= widest,
                    "{surface:?}: {a}, {b} about {end} from {lower}, {upper}"
                );
                let found = Equilibrium::within(&population, [(a, at_a), (b, at_b)]).expect("a branch");
                assert!(
                    (found.farthest() - end).abs() < 1e-8 * end.abs().max(1.0),
                    "{surface:?}: {found:?}, not {branch:?}"
                );
            }
        }
    }

    #[test]
    fn the_branch_that_ends_near_a_separation_is_found() {
        for (surface, _) in surfaces() {
            let population = population(&surface);
            let branch = Equilibrium::new(&population).expect("a branch");
            for offset in [-0.3, -0.03, 1e-6, 4e-4, 0.02] {
                let found = Equilibrium::ending_near(&population, branch.farthest() + offset).expect("a branch");
                let off = (found.farthest() - branch.farthest()).abs();
                assert!(
                    off < 1e-8 * branch.farthest().abs().max(1.0),
                    "{surface:?}: {found:?}, not {branch:?} {offset}"
                );
            }
        }
        // A later minimum is one too.
        for (index, end) in [(5, 1.9154), (7, 1.1442), (10, 0.4733), (12, 0.2810)] {
            let (surface, _) = &surfaces()[index];
            let found = Equilibrium::ending_near(&population(surface), end + 0.02).expect("a branch");
            assert!((found.farthest() - end).abs() < 1e-4, "{surface:?}: {found:?}, not {end}");
        }
        let repulsive = population(&(table(), [0.01, 1000.0, 0.0, 1.0], ALIKE));
        let error =
            Equilibrium::ending_near(&repulsive, repulsive.farthest() - 0.5).expect_err("the load falls to the end");
        assert!(matches!(error, Error::NotConverged { .. }), "{error}");
        let repulsive = population(&(HeightFamily::Gaussian, [0.01, 1000.0, 0.0, 1.0], ALIKE));
        let error = Equilibrium::ending_near(&repulsive, 3.0).expect_err("the load falls everywhere");
        assert!(matches!(error, Error::OutOfRange { name: "pull-off load", .. }), "{error}");
    }

    /// The load of a population without adhesion falls until nothing is left.
    #[test]
    fn where_nothing_is_left_no_minimum_is_found() {
        let population = population(&(table(), [0.01, 1000.0, 0.0, 1.0], ALIKE));
        let last = population.heights().head();
        let mut here = last - 0.5;
        let (past, count) = counted(|| before_nothing_is_left(&population, &mut here, last + 0.25));
        assert_eq!(past, Ok(None));
        assert!(here < last && last - here < 2e-9, "{here}, not {last}");
        assert!(count <= 921 + 4, "{count} contacts");
        // With adhesion there is one before.
        let population = self::population(&(table(), STRONG, ALIKE));
        let end = Equilibrium::new(&population).expect("a branch").farthest();
        let mut here = end - 0.01;
        let past = before_nothing_is_left(&population, &mut here, population.farthest() + 1.0).expect("sums");
        let past = past.expect("a load that pulls");
        assert!(load_at(&population, past) < 0.0 && !load_falls(&population, past) && past > end);
        assert!(load_falls(&population, here) && here < end);
    }

    #[test]
    fn a_bracket_is_cut_where_the_load_rises_first() {
        let (surface, _) = &surfaces()[0];
        let population = population(surface);
        let end = Equilibrium::new(&population).expect("a branch").farthest();
        for part in 0..16 {
            let (lower, width) = (end - 0.1 * (f64::from(part) + 0.5), 1.6);
            let (a, b) = first_bracket(&population, lower, lower + width).expect("sums");
            let off = (a - lower - 0.1 * f64::from(part)).abs() + (b - a - 0.1).abs();
            assert!(off < 1e-12, "{a}, {b} about {end}, part {part}");
        }
    }

    #[test]
    fn summits_that_part_at_the_foot_leave_a_minimum_beside_that() {
        let mut some = 0;
        for (surface, [_, most, ..]) in surfaces() {
            let population = population(&surface);
            let (bracket, count) = counted(|| bracket_at_foot(&population).expect("sums"));
            assert_few("the bracket", &surface, count, most);
            if let Some((lower, upper)) = bracket {
                some += 1;
                let (before, at) = (load_at(&population, lower), load_at(&population, upper));
                assert!(load_falls(&population, lower) && (at >= before || !load_falls(&population, upper)));
                let parting = population.partings()[0];
                let (nearer, farther) = ((parting - lower).abs(), (parting - upper).abs());
                assert!(nearer.max(farther) < 12.0 * nearer.min(farther), "{surface:?}: {lower}, {upper}, {parting}");
            }
        }
        assert_eq!(some, 2);
    }

    /// Contact first and attraction soon after: the minimum is beside one of the two.
    #[test]
    fn a_minimum_beside_one_parting_is_not_looked_for_beside_another() {
        for (moments, groups, beside) in [
            ((0.2121494, 1.1200138), [0.19461009, 19.136892, 0.6606602, 0.1514688], 0),
            ((-0.489457, 1.2877357), [0.00914899, 330.1119, 0.017672985, 0.24989143], 0),
            ((-1.0669039, 2.1550202), [1.6579479e-4, 5689.5963, 9.2311e-5, 0.82552873], 1),
            ((-1.3680833, 3.0642251), [9.24114e-4, 13819.52, 0.0073409785, 0.052169169], 1),
            ((-0.8602528, 1.742354), [0.3040613, 19604.971, 3.817995e-5, 7.7090694], 1),
        ] {
            let population = population(&(johnson(moments.0, moments.1), groups, ALIKE));
            let partings = population.partings();
            let (lower, upper) = bracket_at_foot(&population).expect("sums").expect("a bracket");
            let [before, after] = [lower, upper].map(|separation| separation - partings[beside]);
            let (nearer, farther) = (before.abs().min(after.abs()), before.abs().max(after.abs()));
            let middle = 0.5 * (partings[0] + partings[1]);
            let is_beside = if beside == 0 { upper < middle } else { lower > middle };
            assert!(farther < 12.0 * nearer && is_beside, "{moments:?}: {before:e}, {after:e} of {partings:?}");
            if let Ok(branch) = Equilibrium::new(&population) {
                let end = branch.farthest();
                assert!(end >= lower && end <= upper, "{moments:?}: {end} not from {lower} to {upper}");
            }
        }
    }

    /// Adhesion so strong that the load rises at the mean height already.
    #[test]
    fn the_search_for_the_minimum_begins_where_the_load_falls() {
        let population = population(&(HeightFamily::Weibull { shape: 1.2 }, [0.01, 1000.0, 0.05, 1.0], ALIKE));
        let origin = population.heights().origin();
        assert_eq!(bracket_first_minimum(&population), Ok(Some((-1.0 - origin, -origin))));
        assert!(!load_falls(&population, -origin));
    }

    /// Far below the highest summits, of which there are so few that the load has a minimum without them.
    #[test]
    fn the_search_for_the_minimum_begins_among_most_heights() {
        let population = population(&(tailed([0.0, 1.0, 2.0, 6.0, 6.5, 7.0]), STRONG, ALIKE));
        let (lower, upper) = bracket_first_minimum(&population).expect("sums").expect("a bracket");
        let origin = population.heights().origin();
        assert!(origin > 12.0 && lower > -3.0 - origin && upper < 6.0 - origin, "{lower}, {upper} below {origin}");
        // So far to the left a guess beyond the end of the branch leads back.
        let branch = Equilibrium::new(&population).expect("a branch");
        let target = log(-branch.pull_off_load()) - 3.0;
        let (separation, _) = branch.at_log_excess(&population, target, Some(-5.0)).expect("a state");
        assert!(separation < branch.farthest() && branch.farthest() < -9.0, "{separation} of {branch:?}");
    }

    /// Summits at the foot part at once, and the load, which falls before, rises.
    #[test]
    fn the_branch_ends_before_a_jump_of_the_load() {
        for (heights, groups, radii) in [
            (johnson(-0.937307, 1.881893), [7.7212e-4, 91.4535, 4.32703e-6, 7.7011], [-0.632445, 0.769541]),
            (johnson(0.8329426, 1.6997249), [0.0016562242, 61.948891, 6.0524703e-6, 4.8762614], ALIKE),
            (johnson(-0.8641318, 1.8453223), [6.2100242e-4, 1290.354312, 6.4854982e-6, 0.5358852], ALIKE),
            (johnson(-1.0126823, 2.0316476), [0.0373222, 2.4815523, 5.578989e-5, 4.7864413], ALIKE),
            (johnson(-1.2384868, 2.6452719), [0.0043036815, 316.793726, 0.001981027, 0.4866693], ALIKE),
            (johnson(0.5114498, 1.262764), [0.0138588516, 4.4010831, 3.9135642e-4, 17.4768316], [0.9368157, 6.5963524]),
        ] {
            let population = population(&(heights, groups, radii));
            let end = Equilibrium::new(&population).expect("a branch").farthest();
            assert!((1..=400).all(|i| load_falls(&population, end - 0.01 * f64::from(i))), "{groups:?}");
            // Last bits after which all have parted that part at once.
            let step = 1e-13 * end.abs().max(1.0);
            let [before, at, after] = [-step, 0.0, step].map(|offset| load_at(&population, end + offset));
            assert!(at <= before && after > at + 1e-9 * at.abs(), "{before:e}, {at:e}, {after:e} at {end}, {groups:?}");
        }
        // One that pushes there is refused, with the load before it jumps.
        for (heights, groups, radii) in [
            (johnson(0.458, 1.279), [0.0756, 68354.2, 1.7283e-3, 0.1578], [0.5283, 2.7162]),
            (
                johnson(0.6334090806001313, 1.4276035443641226),
                [0.2076859627146805, 1.6829599707794622, 0.0007682368451847479, 1.5135404581245966],
                ALIKE,
            ),
            (
                johnson(0.1965548406005837, 1.0445989855842333),
                [0.019736472963045124, 5.571744928008887, 3.506341180992003e-6, 4.885428284789647],
                ALIKE,
            ),
            (
                johnson(0.3451053486001001, 1.2151675572399743),
                [0.000328394189310387, 2897.188671716792, 4.0760734790790666e-7, 0.5469676598426736],
                ALIKE,
            ),
        ] {
            let population = population(&(heights, groups, radii));
            let (lower, upper) = bracket_at_foot(&population).expect("sums").expect("a bracket");
            let lightest = load_at(&population, lower).min(load_at(&population, upper));
            match Equilibrium::new(&population) {
                Err(Error::OutOfRange { name: "pull-off load", value, .. }) => {
                    let value: f64 = value.to_string().parse().expect("a number");
                    let near = lightest * (1.0 + LOAD_ROUNDING);
                    assert!(value <= near && value > 0.999 * lightest, "{value}, not {lightest}");
                }
                other => panic!("{other:?}"),
            }
        }
    }

    /// Next to where summits part the last bit of the separation decides how many have, and of the load.
    #[test]
    fn rounding_next_to_where_summits_part_is_no_minimum() {
        let population = population(&(johnson(-0.6989, 1.5227), [5.916e-4, 1.3194, 2.011e-6, 8.1656], ALIKE));
        assert_eq!(bracket_at_foot(&population), Ok(None));
        let [parting, ..] = population.partings()[..] else { panic!("summits that part") };
        assert!((1..=20).all(|i| load_at(&population, parting) > load_at(&population, parting + 0.1 * f64::from(i))));
        let point = Equilibrium::new(&population).expect("a branch").pull_off().expect("a pull-off point");
        assert!(
            (point.separation - 0.96209).abs() < 1e-5 && (point.load / -0.027_986_369_77 - 1.0).abs() < 1e-8,
            "{point:?}"
        );
    }

    /// Though the separations about it that were looked at have the same load.
    #[test]
    fn a_minimum_at_the_foot_is_known_to_its_digits() {
        for surface in [
            (johnson(0.26567455, 1.07598647), [0.0542331947, 34421.458, 1.00591939e-6, 2.12213267], ALIKE),
            (
                johnson(-0.4683377, 1.2244759),
                [1.24636438e-4, 9926.96283, 6.7428364e-3, 3.0301507],
                [-0.9158376, 8.4493253],
            ),
        ] {
            let population = population(&surface);
            let end = Equilibrium::new(&population).expect("a branch").farthest();
            let near = 2e-9 * end.abs();
            assert!(load_falls(&population, end - near) && !load_falls(&population, end + near), "{surface:?}: {end}");
        }
    }

    /// Loads are no numbers before they rise, or separations do not resolve the range of adhesion.
    #[test]
    fn few_states_are_looked_at_where_the_load_falls_to_nothing() {
        for (surface, ends, most) in [
            ((HeightFamily::Gaussian, [0.0183, 114_785.0, 9.798e-5, 0.6895], ALIKE), false, 380),
            ((HeightFamily::Weibull { shape: 4.885 }, [0.0691, 77_762.7, 3.5604e-4, 0.1398], ALIKE), false, 2835),
            ((table(), [10.0, 1e8, 1e-9, 100.0], ALIKE), false, 88_627),
            ((johnson(0.0, 1e8), [0.01, 1000.0, 1e-9, 100.0], ALIKE), false, 887_287),
            ((tailed([0.0, 1.0, 2.0, 10.0, 11.0, 12.0]), [10.0, 1e8, 1e-9, 100.0], ALIKE), false, 116_912),
            // Shorter than a step.
            ((table(), [0.01, 1000.0, 1e-5, 20.0], ALIKE), true, 52_996),
        ] {
            let population = population(&surface);
            let (branch, count) = counted(|| Equilibrium::new(&population).expect("a branch"));
            assert_eq!(branch.pull_off().is_some(), ends, "{surface:?}");
            assert_few("the branch", &surface, count, most);
        }
    }

    /// From next to pull-off to heavy load, wherever the search begins.
    #[test]
    fn a_load_has_its_separation_from_any_guess_and_from_none() {
        for (surface, [.., most]) in surfaces() {
            let population = population(&surface);
            let branch = Equilibrium::new(&population).expect("a branch");
            let end = branch.farthest();
            let mut all = 0;
            for above in [-22.0, -2.0, 40.0] {
                let target = log(-branch.pull_off_load()) + above;
                for guess in [None, Some(end + 1.0)] {
                    let (found, count) = counted(|| branch.at_log_excess(&population, target, guess));
                    let (separation, sums) = found.expect("a state");
                    all += count;
                    assert_eq!(sums.unscaled().load(), load_at(&population, separation));
                    // To the digits that loads have.
                    let off = (branch.log_excess(&population, separation).0 - target) * above.min(0.0).exp();
                    assert!(
                        separation <= end && off.abs() < 1e-9,
                        "{surface:?}: {off:e} at {separation}, {above} {guess:?}"
                    );
                }
            }
            assert_few("the states", &surface, all, most + most / 10);
            let too_heavy = branch.at_log_excess(&population, 400.0, None).expect_err("no such load");
            assert!(matches!(too_heavy, Error::NotConverged { .. }), "{too_heavy}");
        }
    }

    /// The pull-off load is no number, and next to where the branch ends the load is negative.
    #[test]
    fn a_light_load_has_its_separation_from_a_guess_where_loads_pull() {
        let population = population(&(HeightFamily::Gaussian, [0.3, 1000.0, 0.1, 10.0], ALIKE));
        let branch = Equilibrium::new(&population).expect("a branch");
        for target in [-600.0, -100.0, 1.0] {
            for part in [1.0, 0.9999, 0.999, 0.9] {
                let guess = part * branch.farthest();
                let (found, sums) = branch.at_log_excess(&population, target, Some(guess)).expect("a state");
                let off = log(sums.load()) + sums.log_scale - target;
                assert!(off.abs() < 1e-10, "{off:e} at {found} from {guess}");
            }
        }
    }

    /// Sums over the heights are taken once, but next to pull-off, where a difference of loads has too few digits.
    #[test]
    fn loads_are_integrated_next_to_pull_off_alone() {
        for (surface, _) in surfaces().into_iter().filter(|(_, [_, _, count, _])| *count > 0) {
            let population = population(&surface);
            let branch = Equilibrium::new(&population).expect("a branch");
            for (part, most) in [(1e-2, 1), (1e-3, 1), (1e-5, 7)] {
                let target = log(-branch.pull_off_load() * part);
                let (separation, _) = branch.at_log_excess(&population, target, None).expect("a state");
                let (_, once) = counted(|| population.at_separation(separation));
                let (_, count) = counted(|| branch.log_excess(&population, separation));
                assert!(
                    count <= most * once && count > most / 2 * once,
                    "{surface:?}: {count} contacts, not {most} x {once}"
                );
            }
        }
    }

    /// On both sides of the smallest load that counts.
    #[test]
    fn a_pull_off_load_that_can_not_be_told_from_none_is_none() {
        let surface = |b_over_h: f64| (HeightFamily::Gaussian, [0.3, 1000.0, 0.1, b_over_h], ALIKE);
        let branch = |b_over_h: f64| Equilibrium::new(&population(&surface(b_over_h))).expect("a branch");
        let (least, none) = (branch(1.0), branch(10.0));
        assert!((-1e-270..-1e-278).contains(&least.pull_off_load()), "{least:?}");
        assert_eq!((none.pull_off(), none.pull_off_load()), (None, 0.0));
        assert!((none.farthest() - 35.848).abs() < 0.01, "{none:?}");
    }

    /// Above pull-off the load rises with the square of what separation is less: to more digits than the difference has.
    #[test]
    fn loads_next_to_pull_off_are_known_beyond_their_digits() {
        let population = population(&(HeightFamily::Gaussian, STRONG, ALIKE));
        let branch = Equilibrium::new(&population).expect("a branch");
        let curvature = |distance: f64| {
            let (log_excess, rate, _) = branch.log_excess(&population, branch.farthest() - distance);
            assert!((rate * distance / -2.0 - 1.0).abs() < 2.0 * distance, "{rate:e} at {distance:e}");
            log_excess.exp() / distance.powi(2)
        };
        let limit = curvature(1e-5);
        for distance in [1e-8, 1e-7, 1e-6] {
            let off = curvature(distance) / limit - 1.0;
            assert!(off.abs() < 2e-5, "{off:e} at {distance:e}");
        }
    }
}
