//! The pull-off point: the first minimum of the load over separation, coming from heavy load.

use crate::error::Error;
use crate::numerics::elementary::log;
use crate::numerics::root;
use crate::population::{Population, Sums};

/// The load is looked at for its first minimum from this separation of the means, in sigma.
const SCAN_START: f64 = -6.0;
/// Where there is one minimum, in steps that grow from this: the load changes on the scale of the heights, not faster.
const FIRST_STEP: f64 = 1.0;
/// Where radii vary or heights are not log-concave the load may rise within less: steps in sigma are at most this.
const WIDEST_STEP: f64 = 0.25;
/// Where the load presses they may be longer: of the way to where it would be 0 if it went on to fall as it does, this part.
const PART_OF_TANGENT: f64 = 0.8;
/// A minimum narrower than this is not looked for.
const NARROWEST_STEP: f64 = 0.02;
/// A bracket is looked at in so many parts for an earlier and shallower minimum.
const BRACKET_PARTS: u32 = 16;
/// Where heights end, the load is looked at up to this far from where nothing is left, relative to it.
const NEAREST_TO_END: f64 = 1e-9;
/// Farther out than this many ranges of adhesion separations no longer resolve what adhesion does.
const FARTHEST_SCAN: f64 = 1e12;
/// A pull-off load smaller than exp of this cannot be told from none.
const LOG_LIGHTEST_PULL_OFF: f64 = -640.0;

/// Where the surfaces part under load control.
#[derive(Debug, Clone, Copy)]
pub struct PullOff {
    /// In sigma.
    pub separation: f64,
    /// Negative, in E* b^2 per summit.
    pub load: f64,
    /// The sums over the summits.
    pub sums: Sums,
}

/// The end of the branch: where the load has its first minimum, or where nothing is left.
#[derive(Debug, Clone, Copy, Default)]
pub struct End {
    /// `None` without adhesion, or where its load is too small for a number.
    pub pull_off: Option<PullOff>,
    /// The largest separation on the branch.
    pub farthest: f64,
}

impl End {
    /// The end of the branch of a population, looked for from heavy load, and found to all digits.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if it cannot be found; [`Error::OutOfRange`] if the load there is not negative.
    pub fn of(population: &Population) -> Result<Self, Error> {
        let none = Self { pull_off: None, farthest: population.farthest() };
        if !population.is_adhesive() {
            return Ok(none);
        }
        let bracket = bracket_first_minimum(population, population.has_single_minimum())?;
        if population.is_rough() {
            let exact = population.summed(false);
            return match bracket {
                Some((from, to)) if falls(&exact, from)? && !falls(&exact, to)? => Self::within(&exact, (from, to)),
                _ => Self::of(&exact),
            };
        }
        bracket.map_or(Ok(none), |bracket| Self::within(population, bracket))
    }

    /// The end before a separation at which the load was found to rise already.
    ///
    /// # Errors
    /// As [`End::of`].
    pub fn before(population: &Population, off_branch: f64) -> Result<Self, Error> {
        let mut rising = off_branch;
        while falls(population, rising)? {
            rising += NARROWEST_STEP;
            if rising > population.farthest() {
                return Err(Error::NotConverged { what: "separation at pull-off", value: off_branch });
            }
        }
        let (falling, _) = falling_before(population, rising, 0.05 * NARROWEST_STEP)?;
        Self::within(population, (falling, rising))
    }

    /// Within a bracket of separations between which the load stops falling.
    fn within(population: &Population, (lower, upper): (f64, f64)) -> Result<Self, Error> {
        let slope = |separation: f64| population.at_separation(separation).load_slope;
        let mut separation = root::bracketed(slope, lower, upper);
        let mut sums = sums_at(population, separation)?;
        // Out of contact the load rises. Where it falls up to the last contact, the point found may lie beyond it by rounding.
        let mut step = f64::EPSILON * separation.abs();
        while sums.load() < 0.0 && sums.contacting == 0.0 && separation > lower {
            separation = lower.max(separation - step);
            sums = sums_at(population, separation)?;
            step *= 2.0;
        }
        let is_number = sums.load() != 0.0 && log(sums.load().abs()) >= LOG_LIGHTEST_PULL_OFF;
        if is_number && sums.load() > 0.0 {
            let allowed = "(in composite_modulus burgers_vector^2 per asperity) must be below 0: here most asperities part while \
                          a few tall ones still carry the load, and the surfaces would part in steps; use heights without \
                          a second maximum, or work_of_adhesion = 0";
            return Err(Error::out_of_range("pull-off load", sums.load(), allowed));
        }
        let pull_off = PullOff { separation, load: sums.load(), sums };
        Ok(Self { pull_off: is_number.then_some(pull_off), farthest: separation })
    }
}

/// Two separations between which the load has its first minimum, a single one or not; `None` where the load falls as long as it is a
/// number.
fn bracket_first_minimum(population: &Population, single: bool) -> Result<Option<(f64, f64)>, Error> {
    let mut here = if single { 0.0 } else { SCAN_START } - population.heights().outline().origin;
    let mut sums = sums_at(population, here)?;
    if sums.load_slope >= 0.0 {
        (here, sums) = falling_before(population, here, FIRST_STEP)?;
    }
    let farthest = match single {
        true => population.farthest(),
        false => population.farthest().min(FARTHEST_SCAN * population.range_of_adhesion()),
    };
    let mut step = if single { FIRST_STEP } else { scan_step(population) };
    while here < farthest {
        // A load that presses and falls ever more slowly is 0 no sooner than its slope says.
        let next = here + if single { step } else { step.max(PART_OF_TANGENT * (sums.load() / -sums.load_slope)) };
        sums = sums_at(population, next)?;
        if sums.load_slope >= 0.0 {
            // The slope vanishes also where nothing is left.
            let past =
                if is_past_minimum(&sums) { Some(next) } else { before_nothing_is_left(population, &mut here, next)? };
            let first = |past| if single { Ok((here, past)) } else { first_bracket(population, here, past) };
            return past.map(first).transpose();
        }
        // What is positive and as small as that has no minimum that counts behind it.
        if sums.load() > 0.0 && log(sums.load()) < LOG_LIGHTEST_PULL_OFF {
            return Ok(None);
        }
        here = next;
        // Far out the heights change on the scale of their distance.
        step = if single { 1.5 * step } else { step.max(0.1 * here) };
    }
    Ok(None)
}

/// The step in which a load that may have several minima is looked at.
fn scan_step(population: &Population) -> f64 {
    let widest = (0.5 * population.radius_scale()).clamp(WIDEST_STEP, 2.0 * WIDEST_STEP);
    match population.heights().outline().is_piecewise_polynomial {
        false => widest,
        true => (0.5 * population.range_of_adhesion()).clamp(NARROWEST_STEP, WIDEST_STEP),
    }
}

/// A separation past the minimum at which something is left, where a step led from a falling load to nothing; `None` if
/// the load falls until nothing is left. Moves `here` on where the load falls still.
fn before_nothing_is_left(population: &Population, here: &mut f64, nothing: f64) -> Result<Option<f64>, Error> {
    let mut nothing = nothing;
    while nothing - *here > NEAREST_TO_END * (1.0 + here.abs()) {
        let middle = 0.5 * (*here + nothing);
        let sums = sums_at(population, middle)?;
        if sums.load_slope < 0.0 {
            *here = middle;
        } else if is_past_minimum(&sums) {
            return Ok(Some(middle));
        } else {
            nothing = middle;
        }
    }
    Ok(None)
}

/// Whether a load that does not fall is past a minimum: it pulls, or it presses and rises.
fn is_past_minimum(sums: &Sums) -> bool {
    let load = sums.load();
    load < 0.0 || (load > 0.0 && sums.load_slope > 0.0 && log(load) >= LOG_LIGHTEST_PULL_OFF)
}

/// The first part of a bracket across which the slope changes sign.
fn first_bracket(population: &Population, lower: f64, upper: f64) -> Result<(f64, f64), Error> {
    let at = |part: u32| lower + (upper - lower) * f64::from(part) / f64::from(BRACKET_PARTS);
    for part in 1..BRACKET_PARTS {
        if !falls(population, at(part))? {
            return Ok((at(part - 1), at(part)));
        }
    }
    Ok((at(BRACKET_PARTS - 1), upper))
}

/// A separation before one from which on the load rises, at which it falls, and the sums there: in steps that grow from this.
fn falling_before(population: &Population, rising: f64, first_step: f64) -> Result<(f64, Sums), Error> {
    let mut step = first_step;
    loop {
        let sums = sums_at(population, rising - step)?;
        if sums.load_slope < 0.0 {
            return Ok((rising - step, sums));
        }
        step *= 2.0;
    }
}

/// Whether the load falls as separation grows.
fn falls(population: &Population, separation: f64) -> Result<bool, Error> {
    Ok(sums_at(population, separation)?.load_slope < 0.0)
}

/// The sums at a separation, or why there are none.
fn sums_at(population: &Population, separation: f64) -> Result<Sums, Error> {
    population.at_separation(separation).known(separation)
}
