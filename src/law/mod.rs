//! The compiled law: friction force and tangential stiffness as functions of load, in the caller's units, at the price of
//! one polynomial.
//!
//! In x = load - pull-off each has its only nearby singularity at x = 0. A table has a row for each fraction
//! of a binade of x, found from the bits of x without log or search; a row is a polynomial in the mantissa. Value and slope
//! agree where rows meet. A row across which the law has a kink is a link to several polynomials. Beyond the table the law goes
//! on as a power of x. No load is evaluated exactly.

mod continuation;
mod coordinate;
mod curve;
mod fill;
mod gap;
mod newton;
mod panel;
mod planes;
mod position;
mod row;
mod states;
mod table;
pub mod tolerance;

use crate::equilibrium::{Branch, Even, Local, PullOff};
use crate::memory::Limits;
use crate::numerics::elementary::{exp, log, log1p};
use crate::population::Sums;
pub use continuation::Beyond;
#[cfg(target_arch = "x86_64")]
pub use continuation::{Continuation, DIGIT, DIGIT_BITS};
use curve::Curve;
use fill::{Filling, Source};
pub use gap::Gap;
use planes::Planes;
use std::sync::Arc;

pub use gap::Lengths;
pub use row::{polynomial, Row};
#[cfg(target_arch = "x86_64")]
pub use row::{COEFFICIENTS, DIVISIONS, OFFSET};
pub use states::Unfollowed;
pub use table::Table;

/// Rows of one table at most, with the parts of rows: 80 KiB, and some for each kink of the curve.
const MOST_ROWS: usize = 1280;
const MOST_ROWS_PER_KINK: usize = 2;
/// Rows per binade, as a power of two: so many that nearly all are good.
const LOAD_FRACTION: u32 = 1;
/// ln of the ratio of the ends of a row, at most.
const ROW: f64 = 0.41;
/// The law reaches from this part of the pull-off load above it, or of the load at which half of the summits touch, to so many
/// times that load, or the pull-off load; beyond, it goes on as a power.
const LIGHTEST_OF_PULL_OFF: f64 = 1e-9;
const LIGHTEST_OF_HALF: f64 = 1e-15;
const HEAVIEST_OF_HALF: f64 = 1e3;
/// A pull-off load smaller than this part of the load at which half of the summits touch is none.
const LIGHTEST_PULL_OFF: f64 = 1e-30;
/// It also reaches to the load at which the mean of the heights is pressed in by this part of the summit radius, where contacts are 0.07 R
/// wide: the load of a ball whose height hardly varies. Deeper than this, in sigma, heights lose their digits.
const DEEPEST_OF_RADIUS: f64 = 1.0 / 200.0;
const DEEPEST: f64 = 1e6;
const HEAVIEST_OF_PULL_OFF: f64 = 1e4;
/// Places of waves bear loads that are lighter and heavier than these, as logarithms; crests more, where nothing gives way.
const LIGHTER_PLACES: f64 = 40.0;
const HEAVIER_PLACES: f64 = 3.0;
/// The law below a largest load reaches to this part of it, as a logarithm; it goes on as a power.
const LIGHTEST_OF_LARGEST: f64 = 16.0;
/// The curve is farther from exact states than at those that it is compared with by up to so many times, and rows from the curve.
const FARTHEST_OF_CURVE: f64 = 5.0;
const FARTHEST_OF_ROW: f64 = 1.5;
/// What is compiled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// The friction force.
    Friction,
    /// The sum of contact radii over psi, to which the tangential stiffness is proportional.
    Radius,
}

impl Quantity {
    pub const COUNT: usize = 2;
    pub const ALL: [Self; Self::COUNT] = [Self::Friction, Self::Radius];

    /// The quantity of a state, and its slope by separation.
    #[inline]
    pub fn of(self, sums: &Sums) -> (f64, f64) {
        match self {
            Self::Friction => (sums.friction, sums.friction_slope),
            Self::Radius => sums.spread_radius(),
        }
    }
}

/// Friction force and tangential stiffness against load, and load against gap.
#[derive(Debug, Clone)]
pub struct Law {
    compiled: [Compiled; Quantity::COUNT],
    gap: Gap,
    planes: Option<Box<Planes>>,
    limits: Limits,
}

/// One quantity against load.
#[derive(Debug, Clone)]
struct Compiled {
    table: Table,
    beyond: Box<Beyond>, // apart, so that models are small on the stack
    error: f64,
}

/// The caller's units of load and of a quantity.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    /// The load that is 1 in the dimensionless model.
    pub load: f64,
    /// What the quantity is in the caller's units where it is 1 in the model.
    pub value: f64,
}

/// The loads above pull-off that are compiled, in the model's units, and how many rows a table of them may have.
#[derive(Debug, Clone, Copy)]
pub struct Reach {
    log_lightest: f64,
    log_heaviest: f64,
    /// Pull-off itself, if there is one that counts.
    pull_off: Option<PullOff>,
    most_rows: usize,
}

impl Reach {
    fn of(branch: &Branch) -> Self {
        let population = &*branch.population().at_first_loading();
        let half = population.at_separation(-population.heights().outline().origin).load().abs();
        let pull_off = branch.pull_off().filter(|point| -point.load > LIGHTEST_PULL_OFF * half);
        let lightest = pull_off.map_or(LIGHTEST_OF_HALF * half, |point| LIGHTEST_OF_PULL_OFF * -point.load);
        let depth = (DEEPEST_OF_RADIUS * population.mean_radius()).min(DEEPEST);
        let pressed = population.at_separation(-population.heights().outline().origin - depth).load();
        let heaviest = (HEAVIEST_OF_PULL_OFF * -branch.pull_off_load()).max(HEAVIEST_OF_HALF * half).max(pressed);
        Self {
            // By a row more, so that whole rows reach as far.
            log_lightest: log(lightest) - ROW,
            log_heaviest: log(heaviest) + ROW,
            pull_off,
            most_rows: MOST_ROWS + MOST_ROWS_PER_KINK * branch.kinks().len(),
        }
    }
}

impl Law {
    /// Compiles the law in units of load, of each quantity and of length, whose origin is the mean plane. After a larger load an anchor
    /// has the separation under it, and the gap, in sigma; only of lighter loads, if no others are asked for.
    ///
    /// # Errors
    /// [`Unfollowed`] where the load rises with separation already: the branch ends before.
    pub fn new(
        branch: &Branch,
        load: f64,
        units: [f64; Quantity::COUNT],
        lengths: Lengths,
        anchor: Option<(f64, f64)>,
        only_lighter: bool,
    ) -> Result<Self, Unfollowed> {
        let mut reach = Reach::of(branch);
        if only_lighter {
            let population = branch.population();
            reach.log_heaviest = log(population.at_separation(population.largest()).load()) + ROW;
            reach.log_lightest = reach.log_heaviest - LIGHTEST_OF_LARGEST;
        }
        let curve = Curve::new(branch, &reach, anchor)?;
        let compiled = Quantity::ALL.map(|quantity| {
            let scale = Scale { load, value: units[quantity as usize] };
            Compiled::new(branch, &curve, reach, quantity, scale)
        });
        let table = &compiled[Quantity::Friction as usize].table;
        let limits = limits(branch, &curve, [table.begin_of(0), table.begin_of(table.row_count)], load);
        let gap = Gap::new(branch, &curve, reach, lengths, load);
        Ok(Self { compiled, gap, planes: curve.into_planes(), limits })
    }

    /// The law of a branch as waves of this height at most, in sigma, are followed by.
    ///
    /// # Errors
    /// As [`Law::new`].
    pub fn even(branch: &Branch, highest: f64) -> Result<Arc<dyn Even>, Unfollowed> {
        let reach = Reach::of(branch);
        let log_lightest = reach.log_lightest - LIGHTER_PLACES;
        let log_heaviest = reach.log_heaviest + HEAVIER_PLACES + 1.5 * log1p(highest);
        let curve = Curve::new(branch, &Reach { log_lightest, log_heaviest, ..reach }, None)?;
        let limits = limits(branch, &curve, [reach.log_lightest, log_heaviest].map(exp), 1.0);
        Ok(Arc::new(Flat { curve, limits }))
    }

    /// The table of a quantity.
    #[inline]
    pub fn table(&self, quantity: Quantity) -> &Table {
        &self.compiled[quantity as usize].table
    }

    /// What answers above pull-off where the table does not.
    #[inline]
    pub fn beyond(&self, quantity: Quantity) -> &Beyond {
        &self.compiled[quantity as usize].beyond
    }

    /// The limits of the levels of stiffness.
    #[inline]
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// The gap between mean planes at a separation of the population, in the caller's unit.
    pub fn gap_at(&self, separation: f64) -> f64 {
        self.gap.lengths().callers(self.anchor(separation).1)
    }

    /// A separation and its gap, in sigma.
    pub fn anchor(&self, separation: f64) -> (f64, f64) {
        (separation, self.planes.as_ref().map_or(separation, |planes| planes.gap(separation).0))
    }

    /// The separation of the population at a gap in the caller's unit.
    pub fn separation_at(&self, gap: f64) -> f64 {
        let gap = self.gap.lengths().dimensionless(gap);
        self.planes.as_ref().map_or(gap, |planes| planes.separation(gap))
    }

    /// The separation that carries a load, to some digits; `None` beyond the table.
    pub fn separation_of(&self, load: f64) -> Option<f64> {
        self.gap.of_load(load).map(|gap| self.separation_at(gap))
    }

    /// Load against gap.
    #[inline]
    pub fn gap(&self) -> &Gap {
        &self.gap
    }

    /// The largest relative error found when the table of a quantity was built.
    pub fn error(&self, quantity: Quantity) -> f64 {
        self.compiled[quantity as usize].error
    }
}

/// The limits of the levels of stiffness between two values of load - pull-off, in units of load.
fn limits(branch: &Branch, curve: &Curve, ends: [f64; 2], load: f64) -> Limits {
    let contacts = |x: f64| {
        let log_excess = log(x) - log(load);
        let separation = curve.separation(log_excess)?;
        let [[(friction, _)], [(radius, _)]] = Quantity::ALL.map(|quantity| curve.at_each(quantity, [log_excess]));
        Some([separation, friction / radius])
    };
    Limits::new(branch, ends, &contacts)
}

/// What waves follow of the surface that they carry.
#[derive(Debug)]
struct Flat {
    curve: Curve,
    limits: Limits,
}

impl Even for Flat {
    fn local(&self, separation: f64) -> Local {
        self.curve.local(separation)
    }

    fn quantities(&self, separation: f64) -> [(f64, f64); Quantity::COUNT] {
        self.curve.quantities(separation)
    }

    fn lost_to_slip(&self, load: f64, displacement: f64) -> [f64; 2] {
        self.limits.lost(load, displacement)
    }
}

/// A quantity against ln(load - pull-off), in the caller's units.
struct AgainstLoad<'a> {
    curve: &'a Curve,
    quantity: Quantity,
    unit: f64,
}

impl Source for AgainstLoad<'_> {
    fn at<const N: usize>(&self, log_excess: [f64; N]) -> [(f64, f64); N] {
        self.curve.at_each(self.quantity, log_excess).map(|(value, slope)| {
            let value = self.unit * value;
            (value, value * slope)
        })
    }

    fn joints(&self, lower: f64, upper: f64) -> Vec<f64> {
        let joints = self.curve.kinks().iter().rev().map(|kink| kink.1);
        joints.filter(|&joint| joint > lower && joint < upper).collect()
    }
}

impl Compiled {
    /// Fills the table from the curve, as far as both reach.
    fn new(branch: &Branch, curve: &Curve, reach: Reach, quantity: Quantity, scale: Scale) -> Self {
        let (lower, upper) = curve.log_range();
        let (lower, upper) =
            (lower.max(reach.log_lightest) + log(scale.load), upper.min(reach.log_heaviest) + log(scale.load));
        let shift = Table::shift_of(LOAD_FRACTION);
        // The rows that hold the ends, but for what the curve does not reach.
        let end = exp(upper.min(700.0)).to_bits() >> shift;
        let base = ((exp(lower.max(-700.0)).to_bits() >> shift) + 1).min(end);
        let mut table = Table::new(LOAD_FRACTION, base, branch.pull_off_load() * scale.load);
        let source = AgainstLoad { curve, quantity, unit: scale.value };
        let filling = Filling::new(&source, scale.load, LOAD_FRACTION);
        let error = filling.rows(&mut table, (end - base) as usize, reach.most_rows);
        let error = FARTHEST_OF_ROW * error + FARTHEST_OF_CURVE * curve.error(quantity);
        let at_pull_off = branch.pull_off().map_or(0.0, |point| quantity.of(&point.sums).0 * scale.value);
        let beyond = Box::new(Beyond::new(&table, Some(at_pull_off), table.pull_off));
        Self { table, beyond, error }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::neighbours::Neighbours;
    use crate::params::Params;

    /// The paper's default case with another surface energy.
    pub(super) fn branch(gamma: f64) -> Branch {
        let mut params = Params::paper();
        params.set_dimensionless(0.01, 1000.0, gamma, 1.0, 0.3).expect("a surface");
        Branch::new(crate::population::tests::of(&params)).expect("a branch")
    }

    const LOAD_UNIT: f64 = 3.0;
    const QUANTITY_UNITS: [f64; 2] = [0.5, 7.0];
    const LENGTHS: Lengths = Lengths { unit: 3e-9, origin: 0.0 };

    #[test]
    fn every_row_of_the_default_case_answers_from_next_to_pull_off_to_any_load_of_a_solver() {
        for gamma in [0.0, 0.001] {
            let branch = branch(gamma);
            let law = Law::new(&branch, LOAD_UNIT, QUANTITY_UNITS, LENGTHS, None, false).expect("a law");
            for quantity in Quantity::ALL {
                let error = law.error(quantity);
                assert!(error > 1e-16 && error < tolerance::MOST, "{quantity:?}: {error:e}");
            }
            let table = law.table(Quantity::Friction);
            for load in [0.1, 1.0, 55.0, 3e3].map(|load| load * LOAD_UNIT) {
                let separation = law.separation_of(load).expect("it is covered");
                let found = branch.log_excess(separation).sums.load() * LOAD_UNIT;
                assert!((found / load - 1.0).abs() < tolerance::MOST, "{found}, not {load}");
            }
            let (lightest, heaviest) = table.range();
            let half = branch.population().at_separation(0.0).load() * LOAD_UNIT;
            let pull_off = branch.pull_off_load() * LOAD_UNIT;
            let nearest = if gamma > 0.0 { -pull_off * LIGHTEST_OF_PULL_OFF } else { LIGHTEST_OF_HALF * half };
            let reached = (lightest - pull_off) / nearest;
            assert!(reached <= 1.0 && reached > 0.7, "{reached}");
            let reached = heaviest / (HEAVIEST_OF_HALF * half);
            assert!((1.0..1.7).contains(&reached), "{heaviest:e}, half the asperities touch at {half:e}");
            for (load, answers) in [
                (lightest, true),
                (pull_off + (lightest - pull_off) * (1.0 - 1e-3), false),
                (heaviest.below(), true),
                (heaviest, false),
            ] {
                assert_eq!(table.at_load(load).is_some(), answers, "{load:e}");
            }
        }
    }

    /// Within a tenth of the load.
    #[test]
    fn rows_in_which_all_summits_pass_a_radius_of_the_slip_law_are_answered() {
        for beta in [16_000.0, 13_000.0] {
            let mut params = Params::paper();
            params.set_dimensionless(0.01, beta, 0.001, 1.0, 0.3).expect("a surface");
            let branch = Branch::new(crate::population::tests::of(&params)).expect("a branch");
            let law = Law::new(&branch, LOAD_UNIT, QUANTITY_UNITS, LENGTHS, None, false).expect("a law");
            let table = law.table(Quantity::Friction);
            // Hertz' overlap at that radius, in sigma, with R = beta/alpha and sigma = alpha beta.
            let overlap = 8e4 * 8e4 / (beta * beta);
            let (first, last) = (-overlap - 6.0, -overlap + 6.0);
            let mut misses = 0;
            for i in 0..200 {
                let separation = first + (last - first) * (f64::from(i) / 180.0 - 0.05);
                let point = branch.log_excess(separation);
                let x = LOAD_UNIT * point.sums.load() - table.pull_off;
                let (force, slope) = table.at_excess(x).expect("the table answers");
                let exact = QUANTITY_UNITS[0] * point.sums.friction;
                let exact_slope = QUANTITY_UNITS[0] * point.sums.friction_slope / (LOAD_UNIT * point.sums.load_slope);
                assert!((force / exact - 1.0).abs() < tolerance::MOST, "{separation}: {force:e}, not {exact:e}");
                misses += usize::from((slope / exact_slope - 1.0).abs() > 1e-4);
            }
            // Now and then the exact slope has fewer digits, so far below the heights.
            assert!(misses <= 10, "{misses} missed");
        }
    }
}
