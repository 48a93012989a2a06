//! Load control: the separation at which the population carries a load, and the pull-off load below which there is none.
//!
//! Unloading from heavy load follows the load down to its first minimum over separation. Below that minimum nothing holds
//! the surfaces together; above it each load has one state.

mod fall;
mod pull_off;
mod waves;

pub use pull_off::PullOff;
pub use waves::{hills, ridges, Even, Local, Place, Waves};

use crate::asperity::slip::Slip;
use crate::error::Error;
use crate::numerics::elementary::{exp, log};
use crate::numerics::root::MOST_STEPS;
use crate::population::{Microslip, Population, Statistics, Sums};
use fall::Fall;
use pull_off::End;
use std::sync::{Arc, OnceLock};

/// ln(load - pull-off load) is met as far as rounding lets it, or to this where steps no longer shrink.
const LOG_TOLERANCE: f64 = 1e-11;
/// Where the load is above pull-off by more than this part of that load, their difference has all digits that it needs.
const FARTHEST_FALL: f64 = 0.05;
/// Where it is by less than this part of what presses and what pulls, their difference has too few digits for a table.
const NEAREST_DIFFERENCE: f64 = 1e-5;
/// ln of the lightest load that is a number to all digits; lighter ones have its coefficient of friction.
const LOG_LIGHTEST_LOAD: f64 = -690.0;

/// The equilibrium states of a surface pair under load control, from heavy load to pull-off.
#[derive(Debug, Clone)]
pub struct Branch {
    population: Population,
    /// Those on which the population stands, if any.
    waves: Option<Arc<Waves>>,
    kinks: Vec<f64>,
    /// Not known before it is asked for of surfaces like others, of which the pull-off load is this.
    end: OnceLock<End>,
    like: f64,
    /// The load minus the pull-off load near that, if there is one, once it is asked for.
    fall: OnceLock<Fall>,
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
    /// The gap between the mean planes, in sigma, where waves tell it at once.
    pub gap: Option<f64>,
}

impl Branch {
    /// The branch of a population, which it owns.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if there is a pull-off point that cannot be found, [`Error::OutOfRange`] if the load there is
    /// not negative.
    pub fn new(population: Population) -> Result<Self, Error> {
        let end = End::of(&population)?;
        Ok(Self::ending(population, end))
    }

    /// The branch of a population like that of another, summed as that is, which is not looked for where it ends as long as it is pressed.
    ///
    /// # Errors
    /// As [`Branch::new`].
    pub fn like(other: &Self, population: Population) -> Result<Self, Error> {
        let population = population.summed(other.population.is_rough());
        match population.is_adhesive() {
            true => Ok(Self {
                like: other.pull_off_load(),
                end: OnceLock::new(),
                ..Self::ending(population, End::default())
            }),
            false => Self::new(population),
        }
    }

    fn ending(population: Population, end: End) -> Self {
        let (kinks, fall) = (population.kinks(), OnceLock::new());
        Self { population, waves: None, kinks, end: end.into(), like: 0.0, fall }
    }

    /// Where it ends; nowhere if that is not to be found.
    fn end(&self) -> &End {
        self.end.get_or_init(|| End::of(&self.population).unwrap_or_default())
    }

    /// The same as far as it is known.
    fn end_if_known(&self) -> End {
        self.end.get().copied().unwrap_or(End { pull_off: None, farthest: self.population.farthest() })
    }

    /// The branch of the same population on waves, without adhesion. Where one place has a kink the mean over many hardly has one, but of
    /// heights whose density has kinks.
    pub fn on_waves(self, waves: Waves) -> Self {
        let has_kinks = self.population.heights().outline().is_piecewise_polynomial;
        let kinks = self.kinks.iter().filter(|_| has_kinks);
        let mut kinks: Vec<f64> = kinks.flat_map(|&kink| waves.separations_at(kink)).collect();
        kinks.sort_by(f64::total_cmp);
        let end = End { farthest: self.farthest() + waves.highest(), ..*self.end() };
        Self { waves: Some(Arc::new(waves)), kinks, end: end.into(), ..self }
    }

    /// The branch that ends before a separation at which the load was found to rise already.
    pub fn ending_near(self, separation: f64) -> Result<Self, Error> {
        let end = End::before(&self.population, separation)?;
        Ok(Self { end: end.into(), fall: OnceLock::new(), ..self })
    }

    /// The branch of the same summits with other slip stresses at the same radii, of which sums are asked and not what is compiled.
    pub fn with_slip(&self, slip: Slip) -> Self {
        let population = self.population.with_slip(slip);
        let sums = |point: PullOff| PullOff { sums: population.at_separation(point.separation), ..point };
        let end = self.end.get().map(|end| End { pull_off: end.pull_off.map(sums), ..*end });
        let end = end.map_or_else(OnceLock::new, OnceLock::from);
        Self { end, waves: self.waves.clone(), kinks: self.kinks.clone(), fall: OnceLock::new(), population, ..*self }
    }

    /// As [`Population::summed`].
    pub fn summed(&self, is_rough: bool) -> Self {
        Self { population: self.population.summed(is_rough), ..self.clone() }
    }

    /// Gives back what is tabulated of the population until sums are asked for.
    pub fn forget_table(&mut self) {
        self.population.forget_table();
    }

    /// The summits.
    pub fn population(&self) -> &Population {
        &self.population
    }

    /// The separations at which the sums are not smooth, in ascending order.
    pub fn kinks(&self) -> &[f64] {
        &self.kinks
    }

    /// The pull-off point; `None` without adhesion, or where its load is too small for a number.
    pub fn pull_off(&self) -> Option<PullOff> {
        self.end().pull_off
    }

    /// The smallest load of the branch, where friction sets in: the pull-off load, or 0.
    pub fn pull_off_load(&self) -> f64 {
        self.pull_off().map_or(0.0, |point| point.load)
    }

    /// The load from which others are counted: the pull-off load, or that of surfaces like these.
    pub fn least_load(&self) -> f64 {
        self.end.get().map_or(self.like, |end| end.pull_off.map_or(0.0, |point| point.load))
    }

    /// The largest separation on the branch.
    pub fn farthest(&self) -> f64 {
        self.end().farthest
    }

    /// The state at a separation on the branch; near pull-off with fewer digits of ln(load - pull-off load), but for next to it.
    pub fn point(&self, separation: f64) -> BranchPoint {
        let (sums, gap) = match &self.waves {
            Some(waves) => {
                let (sums, gap) = waves.compiled(separation);
                (sums, Some(gap))
            }
            None => (self.population.at_separation(separation), None),
        };
        let size = sums.hertz_load - sums.load_attracted - self.pull_off_load();
        if self.pull_off().is_some() && sums.load() - self.pull_off_load() < NEAREST_DIFFERENCE * size {
            return self.log_excess(separation);
        }
        BranchPoint { gap, ..Self::point_of(sums, sums.load() - self.pull_off_load()) }
    }

    /// The sums at a separation.
    pub fn sums(&self, separation: f64) -> Sums {
        let exact = |separation: f64| self.population.at_separation(separation);
        self.waves
            .as_ref()
            .map_or_else(|| exact(separation), |waves| waves.mean(separation, |at| exact(at.separation)).0)
    }

    /// The pressure at places, as the mean over the load, over that of the whole surface.
    pub fn pressing(&self, separation: f64) -> f64 {
        self.waves.as_ref().map_or(1.0, |waves| waves.pressing(separation))
    }

    /// The gap between the mean planes at a separation, in sigma, where waves tell it.
    pub fn gap(&self, separation: f64) -> Option<f64> {
        self.waves.as_ref().map(|waves| waves.compiled(separation).1)
    }

    /// The parts of the surface that touch, each at its separation, where it has these sums.
    fn places(&self, separation: f64, sums: &Sums) -> Vec<Place> {
        match &self.waves {
            Some(waves) => waves.places(separation, |separation| self.population.at_separation(separation)),
            None => vec![Place { part: 1.0, separation, displaced: 1.0, sums: *sums }],
        }
    }

    /// The contacts at a separation with these sums, of which `number` are expected on the surface.
    ///
    /// # Errors
    /// As [`Population::statistics`], and the next as [`Population::microslip`].
    pub fn statistics(&self, separation: f64, sums: &Sums, number: f64) -> Result<Statistics, Error> {
        let places = self.places(separation, sums);
        let all: f64 = places.iter().map(|at| at.part * at.sums.contacting).sum();
        let mut mean = Statistics::default();
        for Place { part, separation, sums, .. } in places {
            let part = part * sums.contacting / all;
            mean.add(&self.population.statistics(separation, number * part)?, part);
        }
        Ok(mean)
    }

    /// The contacts at a separation with these sums, displaced so far that one that sticks bears this force times its radius; and the force as
    /// patches that have merged bear it.
    pub fn microslip(&self, separation: f64, sums: &Sums, force_over_radius: f64) -> Result<Microslip, Error> {
        let mut all = Microslip::default();
        for Place { part, separation, displaced, sums } in self.places(separation, sums) {
            let merging = 1.0 - sums.lost_to_merging;
            let one = self.population.microslip(separation, force_over_radius * displaced / merging)?;
            all.force += part * merging * one.force;
            all.sticking += part * displaced * one.sticking;
            all.radius += part * displaced * one.radius;
        }
        Ok(all)
    }

    /// As [`Population::lost_to_slip`]. On waves, of which each place is displaced as if all stuck, to some three digits.
    pub fn lost_to_slip<const N: usize>(&self, separation: f64, force_over_radius: [f64; N]) -> Option<[[f64; 3]; N]> {
        match &self.waves {
            Some(waves) => waves.lost_to_slip(separation, force_over_radius),
            None => self.population.lost_to_slip(separation, force_over_radius),
        }
    }

    /// The state at a separation on the branch.
    pub fn log_excess(&self, separation: f64) -> BranchPoint {
        let sums = self.sums(separation);
        let difference = sums.load() - self.least_load();
        let is_near = difference < FARTHEST_FALL * -self.least_load();
        let fall = self.end_if_known().pull_off.filter(|_| is_near).and_then(|pull_off| {
            // Rough sums would never do.
            let exact = self.population.summed(false);
            let fall = self.fall.get_or_init(|| Fall::new(&exact, &self.kinks, &pull_off));
            fall.from(&exact, separation)
        });
        Self::point_of(sums, fall.unwrap_or(difference))
    }

    fn point_of(sums: Sums, excess: f64) -> BranchPoint {
        // A logarithm as small as can be stands for that of nothing, but not in its slope.
        BranchPoint { log_excess: log(excess.max(f64::MIN_POSITIVE)), rate: sums.load_slope / excess, sums, gap: None }
    }

    /// The separation at which ln(load - least load) is this, and the sums there, from a guess if there is one, to a tolerance or as far
    /// as rounding lets it.
    pub fn at_log_excess(&self, target: f64, guess: Option<f64>, tolerance: f64) -> Result<(f64, Sums), Error> {
        if target < LOG_LIGHTEST_LOAD && self.least_load() == 0.0 {
            // Sums that small have few digits: the straight line from the lightest load that has all.
            let (separation, sums) = self.at_log_excess(LOG_LIGHTEST_LOAD, guess, tolerance)?;
            return Ok((separation, sums.scaled(exp(target - LOG_LIGHTEST_LOAD))));
        }
        // On waves what is compiled leads there at a small part of the cost.
        let compiled = |separation: f64| self.point(separation);
        let guess = match &self.waves {
            Some(_) if guess.is_none() || tolerance > 0.0 => {
                self.searched(target, guess, LOG_TOLERANCE, &compiled).ok().map(|(separation, _)| separation)
            }
            _ => guess,
        };
        self.searched(target, guess, tolerance, &|separation| self.log_excess(separation))
    }

    /// The same by states that are found in one way or another.
    fn searched(
        &self,
        target: f64,
        guess: Option<f64>,
        tolerance: f64,
        at: &dyn Fn(f64) -> BranchPoint,
    ) -> Result<(f64, Sums), Error> {
        let failure = Error::NotConverged { what: "ln(load - pull-off load)", value: target };
        let (mut lower, mut upper) = (f64::NEG_INFINITY, self.end_if_known().farthest);
        let mut separation = guess.map_or(upper.min(1.0) - 1.0, |guess| guess.min(upper));
        let mut last_step = f64::MAX;
        for _ in 0..MOST_STEPS {
            let BranchPoint { log_excess, rate, sums, .. } = at(separation);
            sums.known(separation)?;
            let residual = log_excess - target;
            if residual >= 0.0 {
                lower = separation;
            } else {
                upper = separation;
            }
            // Where no load is above that of pull-off, the slope of the logarithm leads nowhere.
            let newton = if rate < 0.0 && rate.is_finite() { separation - residual / rate } else { lower };
            let resolution = 4.0 * f64::EPSILON * separation.abs().max(f64::MIN_POSITIVE);
            let next = if (newton - separation).abs() <= resolution || (newton > lower && newton < upper) {
                newton
            } else {
                // No step to the left is much longer than the separation itself.
                0.5 * (lower.max(separation - separation.abs() - 4.0) + upper)
            };
            let step = (next - separation).abs();
            if residual.abs() <= tolerance.max(4.0 * f64::EPSILON)
                || step <= resolution
                || (residual.abs() < LOG_TOLERANCE && step >= 0.5 * last_step)
            {
                return Ok((separation, sums));
            }
            last_step = step;
            separation = next;
        }
        Err(failure)
    }
}

#[cfg(test)]
mod tests;
