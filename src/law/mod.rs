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
mod panel;
mod planes;
mod position;
mod row;
mod steps;
mod table;
pub mod tolerance;

use crate::equilibrium::Branch;
use crate::memory::Limits;
use crate::numerics::elementary::{exp, log};
use crate::population::Sums;
pub use continuation::Beyond;
#[cfg(target_arch = "x86_64")]
pub use continuation::{Continuation, DIGIT, DIGIT_BITS};
use curve::Curve;
use fill::{Filling, Source};
pub use gap::Gap;
use panel::Sample;
use planes::Planes;

pub use curve::Unfollowed;
pub use gap::Lengths;
pub use row::{polynomial, Row};
#[cfg(target_arch = "x86_64")]
pub use row::{COEFFICIENTS, DIVISIONS, OFFSET};
pub use table::Table;

/// Rows of one table at most, with the parts of rows: 80 KiB, and some for each kink of the curve.
const MOST_ROWS: usize = 1280;
const MOST_ROWS_PER_KINK: usize = 2;
/// Rows per binade, as a power of two: so many that nearly all are good.
const FRACTION: u32 = 1;
/// ln of the ratio of the ends of a row, at most.
const ROW: f64 = 0.41;
/// The law reaches from this part of the pull-off load above it, or of the load at which half of the summits touch, to so many
/// times that load, or the pull-off load; beyond, it goes on as a power.
const LIGHTEST_OF_PULL_OFF: f64 = 1e-9;
const LIGHTEST_OF_HALF: f64 = 1e-24;
const HEAVIEST_OF_HALF: f64 = 1e3;
/// It also reaches to the load at which the mean of the heights is pressed in by this part of the summit radius, where contacts are 0.07 R
/// wide: the load of a ball whose height hardly varies. Deeper than this, in sigma, heights lose their digits.
const DEEPEST_OF_RADIUS: f64 = 1.0 / 200.0;
const DEEPEST: f64 = 1e6;
const HEAVIEST_OF_PULL_OFF: f64 = 1e4;
/// A pull-off load smaller than this part of the load at which half of the summits touch is none.
const LIGHTEST_PULL_OFF: f64 = 1e-30;
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
    /// Whether pull-off itself is.
    has_pull_off: bool,
    most_rows: usize,
    /// Whether it is a part of what a law reaches, for one who asks for no other loads.
    is_part: bool,
}

impl Reach {
    fn of(branch: &Branch) -> Self {
        let population = branch.population();
        let half = population.at_separation(-population.heights().origin()).load().abs();
        let pull_off = -branch.pull_off_load();
        let lightest = (LIGHTEST_OF_PULL_OFF * pull_off).max(LIGHTEST_OF_HALF * half);
        let depth = (DEEPEST_OF_RADIUS * population.mean_radius()).min(DEEPEST);
        let pressed = population.at_separation(-population.heights().origin() - depth).load();
        let heaviest = (HEAVIEST_OF_PULL_OFF * pull_off).max(HEAVIEST_OF_HALF * half).max(pressed);
        Self {
            // By a row more, so that whole rows reach as far.
            log_lightest: log(lightest) - ROW,
            log_heaviest: log(heaviest) + ROW,
            has_pull_off: pull_off > LIGHTEST_PULL_OFF * half,
            most_rows: MOST_ROWS + MOST_ROWS_PER_KINK * branch.kinks().len(),
            is_part: false,
        }
    }

    /// The part of it between two loads above pull-off, in the model's units, which is not empty.
    fn between(self, log_lightest: f64, log_heaviest: f64) -> Self {
        // Wherever it begins, two rows' length holds a whole one.
        let log_heaviest = (log_heaviest + ROW).max(self.log_lightest + 2.0 * ROW).min(self.log_heaviest);
        let log_lightest = (log_lightest - ROW).min(log_heaviest - 2.0 * ROW).max(self.log_lightest);
        Self { log_lightest, log_heaviest, is_part: true, ..self }
    }
}

impl Law {
    /// Compiles the law in units of load, of each quantity and of length, whose origin is the mean plane.
    ///
    /// # Errors
    /// [`Unfollowed`] where the load rises with separation already: the branch ends before.
    pub fn new(
        branch: &Branch,
        load: f64,
        units: [f64; Quantity::COUNT],
        lengths: Lengths,
    ) -> Result<Self, Unfollowed> {
        Self::compiled(branch, load, units, lengths, Reach::of(branch))
    }

    /// The same between two loads above pull-off alone, in the model's units: sooner, for few questions.
    ///
    /// # Errors
    /// As [`Law::new`].
    pub fn between(
        branch: &Branch,
        load: f64,
        units: [f64; Quantity::COUNT],
        lengths: Lengths,
        [lightest, heaviest]: [f64; 2],
    ) -> Result<Self, Unfollowed> {
        let reach = Reach::of(branch).between(log(lightest), log(heaviest));
        Self::compiled(branch, load, units, lengths, reach)
    }

    fn compiled(
        branch: &Branch,
        load: f64,
        units: [f64; Quantity::COUNT],
        lengths: Lengths,
        reach: Reach,
    ) -> Result<Self, Unfollowed> {
        let mut samples = Vec::new();
        let curve = Curve::new(branch, reach, &mut samples)?;
        let compiled = Quantity::ALL.map(|quantity| {
            let scale = Scale { load, value: units[quantity as usize] };
            let mut compiled = Compiled::new(branch, &curve, reach, quantity, scale);
            compiled.compare(quantity, scale, &samples);
            compiled
        });
        let table = &compiled[Quantity::Friction as usize].table;
        let contacts = |x: f64| {
            let log_excess = log(x) - log(load);
            let separation = curve.separation(log_excess)?;
            let [[(friction, _)], [(radius, _)]] = Quantity::ALL.map(|quantity| curve.at_each(quantity, [log_excess]));
            Some([separation, friction / radius])
        };
        let ends = [table.begin_of(0), table.begin_of(table.row_count)];
        let limits = Limits::new(branch.population(), ends, &contacts);
        let gap = Gap::new(branch, &curve, reach, lengths, load);
        Ok(Self { compiled, gap, planes: curve.into_planes(), limits })
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
        let gap = self.planes.as_ref().map_or(separation, |planes| planes.gap(separation));
        self.gap.lengths().callers(gap)
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
        self.curve.log_joints(lower, upper)
    }
}

impl Compiled {
    /// Fills the table from the curve, as far as both reach.
    fn new(branch: &Branch, curve: &Curve, reach: Reach, quantity: Quantity, scale: Scale) -> Self {
        let (lower, upper) = curve.log_range();
        let (lower, upper) =
            (lower.max(reach.log_lightest) + log(scale.load), upper.min(reach.log_heaviest) + log(scale.load));
        let shift = Table::shift_of(FRACTION);
        // The rows that hold the ends, but for what the curve does not reach.
        let end = exp(upper.min(700.0)).to_bits() >> shift;
        let base = ((exp(lower.max(-700.0)).to_bits() >> shift) + 1).min(end);
        let mut table = Table::new(FRACTION, base, branch.pull_off_load() * scale.load);
        let source = AgainstLoad { curve, quantity, unit: scale.value };
        let filling = Filling::new(&source, scale.load, FRACTION);
        let error = filling.rows(&mut table, (end - base) as usize, reach.most_rows);
        let error = error.max(curve.error_at_pull_off(quantity, reach.log_lightest));
        let at_pull_off = branch.pull_off().map_or(0.0, |point| quantity.of(&point.sums).0 * scale.value);
        let beyond = Box::new(Beyond::new(&table, Some(at_pull_off), table.pull_off));
        Self { table, beyond, error }
    }

    /// Compares the table with the exact states that did not make it.
    fn compare(&mut self, quantity: Quantity, scale: Scale, samples: &[Sample]) {
        for sample in samples {
            let Some((value, _)) = self.table.at_excess(exp(sample.log_excess + log(scale.load))) else { continue };
            let exact = scale.value * sample.value[quantity as usize];
            self.error = self.error.max((value / exact - 1.0).abs());
        }
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

    const LOAD: f64 = 3.0;
    const UNITS: [f64; 2] = [0.5, 7.0];
    const LENGTHS: Lengths = Lengths { unit: 3e-9, origin: 0.0 };

    #[test]
    fn every_row_of_the_default_case_answers_from_next_to_pull_off_to_any_load_of_a_solver() {
        for gamma in [0.0, 0.001] {
            let branch = branch(gamma);
            let law = Law::new(&branch, LOAD, UNITS, LENGTHS).expect("a law");
            for quantity in Quantity::ALL {
                let error = law.error(quantity);
                assert!(error > 1e-16 && error < 2.0 * tolerance::VALUE, "{quantity:?}: {error:e}");
            }
            let table = law.table(Quantity::Friction);
            for load in [0.1, 1.0, 55.0, 3e3].map(|load| load * LOAD) {
                let separation = law.separation_of(load).expect("it is covered");
                let found = branch.log_excess(separation).sums.load() * LOAD;
                assert!((found / load - 1.0).abs() < 1e-8, "{found}, not {load}");
            }
            let (lightest, heaviest) = table.range();
            let half = branch.population().at_separation(0.0).load() * LOAD;
            let pull_off = branch.pull_off_load() * LOAD;
            let nearest = (-pull_off * LIGHTEST_OF_PULL_OFF).max(LIGHTEST_OF_HALF * half);
            let reached = (lightest - pull_off) / nearest;
            assert!(reached <= 1.0 && reached > 0.7, "{reached}");
            let reached = heaviest / (HEAVIEST_OF_HALF * half);
            assert!((1.0..1.7).contains(&reached), "{heaviest:e}, half the summits touch at {half:e}");
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
            let law = Law::new(&branch, LOAD, UNITS, LENGTHS).expect("a law");
            let table = law.table(Quantity::Friction);
            // Hertz' overlap at that radius, in sigma, with R = beta/alpha and sigma = alpha beta.
            let overlap = 8e4 * 8e4 / (beta * beta);
            let (first, last) = (-overlap - 6.0, -overlap + 6.0);
            let mut misses = 0;
            for i in 0..200 {
                let separation = first + (last - first) * (f64::from(i) / 180.0 - 0.05);
                let point = branch.log_excess(separation);
                let x = LOAD * point.sums.load() - table.pull_off;
                let (force, slope) = table.at_excess(x).expect("the table answers");
                let exact = UNITS[0] * point.sums.friction;
                let exact_slope = UNITS[0] * point.sums.friction_slope / (LOAD * point.sums.load_slope);
                assert!((force / exact - 1.0).abs() < 1e-8, "{separation}: {force:e}, not {exact:e}");
                misses += usize::from((slope / exact_slope - 1.0).abs() > 1e-6);
            }
            // Now and then the exact slope has fewer digits, so far below the heights.
            assert!(misses <= 10, "{misses} missed");
        }
    }

    /// Of an exact state that the table had not been made from, and of one that lies off.
    #[test]
    fn the_error_of_a_table_is_that_of_the_exact_state_farthest_from_it() {
        let branch = branch(0.001);
        let reach = Reach::of(&branch);
        let mut samples = Vec::new();
        let curve = Curve::new(&branch, reach, &mut samples).expect("a curve");
        let scale = Scale { load: LOAD, value: UNITS[0] };
        for off in [1e-6, -3e-4] {
            let mut compiled = Compiled::new(&branch, &curve, reach, Quantity::Friction, scale);
            let unseen = compiled.error;
            compiled.compare(Quantity::Friction, scale, &samples);
            assert!(compiled.error >= unseen && compiled.error < 2.0 * tolerance::VALUE);
            let middle = samples.len() / 2;
            let mut moved = samples.clone();
            moved[middle].value[Quantity::Friction as usize] *= 1.0 + off;
            compiled.compare(Quantity::Friction, scale, &moved);
            assert!((compiled.error / off.abs() - 1.0).abs() < 1e-3, "{off:e}: {:e}", compiled.error);
        }
    }

    /// As for the summits of a sum.
    #[test]
    fn a_law_takes_about_as_many_states_and_rows_as_are_known_to_be_enough() {
        use crate::population::tests::{assert_work, of, surface, table, FOLD, HERTZ, WEAK};
        let taken = [WEAK, FOLD, HERTZ].map(|groups| {
            let weibull = crate::params::HeightFamily::Weibull { shape: 2.2 };
            [(weibull, [0.0, 1.0]), (table(), [0.0, 1.0]), (crate::params::HeightFamily::Gaussian, [-0.4, 0.5])].map(
                |(heights, radii)| {
                    let branch = Branch::new(of(&surface(groups, heights, radii))).expect("a branch");
                    let mut samples = Vec::new();
                    let curve = Curve::new(&branch, Reach::of(&branch), &mut samples).expect("a curve");
                    let law = Law::new(&branch, LOAD, UNITS, LENGTHS).expect("a law");
                    let rows = law.table(Quantity::Friction).rows.len();
                    [samples.len(), curve.joints().count(), rows, law.gap().table().rows.len()]
                },
            )
        });
        assert_work(
            &taken.as_flattened().iter().map(|taken| &taken[..]).collect::<Vec<_>>(),
            &[
                &[57, 19, 147, 83],
                &[93, 31, 123, 88],
                &[24, 8, 127, 80],
                &[36, 12, 98, 71],
                &[69, 23, 112, 86],
                &[15, 5, 88, 69],
                &[49, 16, 188, 150],
                &[124, 41, 206, 260],
                &[25, 8, 181, 176],
            ],
            "states, panels, rows of friction and of the gap",
        );
    }

    /// Each took from one second to a hundred, where a rule for panels or states did not hold: counted, as seconds depend on
    /// the machine.
    #[test]
    fn surfaces_that_once_took_seconds_take_about_as_much_work_as_is_known_to_be_enough() {
        use crate::params::HeightFamily::{Gaussian, Johnson, Weibull};
        use crate::population::tests::{assert_work, of, panels_laid, surface};
        let steep = [8.381849222214722e-4, 5152715.137756967, 2.1029807018159652e-4, 0.12704386771093445];
        let steep_radii = [-4.882807843387127e-4, 1.8110672237718294e-2];
        let surfaces = [
            // Radii that grow steeply with height.
            surface(
                [2.0908000435205257e-4, 1.4265824462018043e5, 1.6597859509616816e-3, 18.427013627578155],
                Gaussian,
                [0.8203125004656613, 78.08688986353269],
            ),
            // Surfaces that part where the lowest summits break away.
            surface(
                [5.19488780366486e-4, 7.048285653914581, 1.8055327116728395e-3, 7.064024554613074e-2],
                Weibull { shape: 1.4497158551457616 },
                [-0.4035644526593387, 1.0243232072942617e-2],
            ),
            // Contact radii that are steep next to a fold.
            surface(steep, Weibull { shape: 13.725755182418508 }, steep_radii),
            surface(steep, Johnson { skew: 0.30102992992860056, kurtosis: 3.152413671326139 }, steep_radii),
            surface(
                [1.6125735486823817e-4, 4489745.052009353, 3.579252348691782e-5, 0.23586978144945048],
                Gaussian,
                [0.8989257817156613, 2.8797221476349354e-2],
            ),
            // Radii that vanish slowly below.
            Params {
                composite_modulus: 55138.43262183106,
                effective_shear_modulus: 38596.90283528174,
                work_of_adhesion: 4.234924302839713,
                adhesion_range: 0.5837335342803278,
                burgers_vector: 0.07564568844106759,
                height_std: 61.823409756505534,
                summit_radius: 31570600.084798086,
                asperity_count: 4671255193.968686,
                radius_amplitude: 1.0,
                radius_rate: 0.05634686409069578,
                ..Params::paper()
            },
        ];
        let panels = surfaces.map(|params| {
            [panels_laid(|| {
                let branch = Branch::new(of(&params)).expect("a branch");
                Law::new(&branch, LOAD, UNITS, LENGTHS).expect("a law")
            })]
        });
        assert_work(
            &panels.each_ref().map(|panels| &panels[..]),
            &[&[8767], &[10464], &[3564], &[3586], &[3021], &[2233]],
            "panels",
        );
    }

    /// Weibull's density, which begins with a power, and a table with edges and steps: the slopes of both quantities are what callers
    /// are told.
    #[test]
    fn slopes_are_known_next_to_a_kink_too() {
        let steps = crate::params::HeightFamily::Tabulated {
            height: [0.0, 1.0, 1.000_000_001, 2.0, 2.000_000_001, 3.0].into(),
            density: [1.0, 1.0, 3.0, 3.0, 0.5, 0.5].into(),
        };
        let mut compared = 0;
        for heights in [crate::params::HeightFamily::Weibull { shape: 1.1 }, crate::population::tests::table(), steps] {
            let branch = Branch::new(crate::population::tests::of(&Params { heights, ..Params::paper() }));
            let branch = branch.expect("a branch");
            let law = Law::new(&branch, LOAD, UNITS, LENGTHS).expect("a law");
            let excess = |sums: &Sums| sums.load() - branch.pull_off_load();
            let at = |separation: f64| branch.population().at_separation(separation);
            let kinks: Vec<f64> =
                branch.kinks().iter().copied().filter(|&kink| kink < branch.farthest() - 0.2).collect();
            let loads: Vec<f64> = kinks.iter().map(|&kink| excess(&at(kink))).collect();
            for (i, &kink) in kinks.iter().enumerate() {
                for j in 0..60 {
                    let distance = [1.0, -1.0][(i + j) % 2] * 10_f64.powf(-8.0 + 7.0 * j as f64 / 60.0);
                    let sums = at(kink + distance);
                    let x = excess(&sums);
                    let known = if loads.iter().any(|load| (load / x - 1.0).abs() < 0.01) { 1e-3 } else { 1e-6 };
                    for quantity in Quantity::ALL {
                        let Some((_, slope)) = law.table(quantity).at_excess(LOAD * x) else { continue };
                        let exact = UNITS[quantity as usize] * quantity.of(&sums).1 / (LOAD * sums.load_slope);
                        let miss = (slope / exact - 1.0).abs();
                        assert!(miss < known, "{quantity:?}: {miss:e} at {distance:e} from {kink}");
                        compared += 1;
                    }
                }
            }
        }
        assert!(compared > 1000, "{compared}");
    }

    /// Where the lower end of Weibull's density passes an edge of contact, friction is a non-integer power of the distance in load.
    #[test]
    fn rows_with_a_non_integer_power_are_answered_up_to_it() {
        for (shape, adhesion) in [(1.8, 1.0), (2.0, 1.0), (1.8, 0.0), (3.6, 1.0)] {
            let default = Params::paper();
            let params = Params {
                heights: crate::params::HeightFamily::Weibull { shape },
                work_of_adhesion: adhesion * default.work_of_adhesion,
                ..default
            };
            let branch = Branch::new(crate::population::tests::of(&params)).expect("a branch");
            let law = Law::new(&branch, LOAD, UNITS, LENGTHS).expect("a law");
            let feet: Vec<f64> = branch.kinks().iter().copied().filter(|&kink| kink > -10.0).collect();
            assert!(feet.len() >= 2, "{feet:?}");
            for quantity in Quantity::ALL {
                let table = law.table(quantity);
                for i in 0..600 {
                    // On both sides of each, at distances of all sizes.
                    let distance = [1e-1, -1e-1][i % 2] * 10_f64.powf(-7.0 * (i / 6) as f64 / 100.0);
                    let separation = feet[i / 2 % feet.len()] + distance;
                    let point = branch.log_excess(separation);
                    let load = LOAD * point.sums.load();
                    let found = table.at_load(load);
                    let (value, slope) = found.unwrap_or_else(|| panic!("{shape}: {separation} is not answered"));
                    let (exact, exact_slope) = quantity.of(&point.sums);
                    let exact = UNITS[quantity as usize] * exact;
                    let exact_slope = UNITS[quantity as usize] * exact_slope / (LOAD * point.sums.load_slope);
                    assert!((value / exact - 1.0).abs() < 1e-8, "{shape}, {quantity:?}, {separation}: {value:e}");
                    let miss = (slope / exact_slope - 1.0).abs();
                    // Next to one panels are short, and slopes may miss by more.
                    let distance = feet.iter().map(|lower_end| (separation - lower_end).abs()).fold(f64::MAX, f64::min);
                    let tolerance = 1e-6 * (0.01 / distance).max(1.0);
                    assert!(miss < tolerance, "{shape}, {quantity:?}, {separation}, {distance:e}: {miss:e}");
                }
            }
        }
    }
}
