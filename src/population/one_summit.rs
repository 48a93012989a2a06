//! One summit alone: the law that the sums are made of, eqs (4)-(6), (9)-(11) and (13)-(15), and where summits stand.

use super::sums::{Summit, Sums};
use super::Population;
use crate::asperity::contact::Contact;
use crate::asperity::maugis::FOLD_LAMBDA_CUBED;
use crate::numerics::elementary::{exp, log};
use std::f64::consts::PI;

/// A summit of a specimen. Heights and overlaps in sigma.
#[derive(Debug)]
pub struct OneSummit {
    /// How far it lies below the tallest summit of its specimen.
    pub depth: f64,
    /// Its radius over the mean one.
    pub g: f64,
    /// The overlap at which it breaks away.
    break_away: f64,
    /// Parameter of its law, overlap, and the slope of the one by the other, where it was last asked for.
    before: (f64, f64, f64),
    /// Where a table has it.
    place: Option<(usize, f64)>,
}

/// The load of a summit in E* b^2, and its slope by overlap.
#[derive(Debug, Clone, Copy, Default)]
pub struct Pressed {
    pub load: f64,
    pub by_overlap: f64,
}

/// Rows of the load of one summit in contact, and of the parameter of its law, by the root of the overlap beyond break-away, of which both
/// are smooth: each with what its slope makes over a step. Between rows there are cubics.
type Rows = [[f64; 4]; ROWS];
const ROWS: usize = 33;
const LOAD: usize = 0;
const PARAMETER: usize = 2;
const UNASKED: (f64, f64, f64) = (f64::NAN, 0.0, 0.0);

/// Loads of summits in contact, where it takes a solution of equations to have them: rows for some radii, in equal steps of their
/// logarithm, between which there are straight lines. What is read is so to some 1e-5.
#[derive(Debug)]
pub struct LoadTable {
    step: f64,
    log_least: f64,
    log_step: f64,
    of_radii: Vec<Rows>,
}

impl LoadTable {
    /// A radius and the next differ by no more than this.
    const FINENESS: f64 = 0.03;
    /// The first slope is that next to break-away, where the overlap has none.
    const NEXT_TO_BREAK_AWAY: f64 = 1e-4;

    /// Which rows a radius is above, and what part of the way to the next; `None` of one outside.
    fn place(&self, g: f64) -> Option<(usize, f64)> {
        let last = self.of_radii.len() - 1;
        if last == 0 {
            return Some((0, 0.0));
        }
        let place = (log(g) - self.log_least) / self.log_step;
        let first = (place as usize).min(last - 1);
        (place >= 0.0 && place <= last as f64).then_some((first, place - first as f64))
    }

    /// The load by the root of the overlap beyond break-away, or the parameter, and its slope over a step; `None` beyond the rows.
    #[inline]
    fn read(&self, what: usize, (first, part): (usize, f64), root: f64) -> Option<(f64, f64)> {
        let place = root / self.step;
        let row = place as usize;
        let t = place - row as f64;
        let of = |rows: &Rows| {
            let [from, to] = [rows.get(row)?, rows.get(row + 1)?];
            let (rise, begin, end) = (to[what] - from[what], from[what + 1], to[what + 1]);
            let (square, cube) = (3.0 * rise - 2.0 * begin - end, begin + end - 2.0 * rise);
            Some((from[what] + t * (begin + t * (square + t * cube)), begin + t * (2.0 * square + 3.0 * t * cube)))
        };
        let (mut value, mut slope) = of(&self.of_radii[first])?;
        if part > 0.0 {
            let (next, slope_of_next) = of(&self.of_radii[first + 1])?;
            (value, slope) = (value + part * (next - value), slope + part * (slope_of_next - slope));
        }
        Some((value, slope))
    }
}

impl OneSummit {
    /// As if nothing had been asked of it.
    pub fn forget(&mut self) {
        self.before = UNASKED;
    }
}

impl Population {
    /// Loads of summits as high as this or higher, and up to an overlap; `sharper` as of `one_summit`. `None` where there is no need for a
    /// table, and where radii differ too much.
    pub fn load_table(&self, lowest: f64, largest: f64, sharper: f64) -> Option<LoadTable> {
        const WIDEST: f64 = 3.0;
        let ends = [lowest, self.highest.min(lowest.abs() + 40.0)].map(|z| self.factor_of_one(z, sharper));
        let [least, most] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let has_fold = |g: f64| self.lambda_cubed * g > FOLD_LAMBDA_CUBED;
        let (log_least, width) = (log(least), log(most / least));
        if self.most_pull() == 0.0 || !(0.0..=WIDEST).contains(&width) || has_fold(least) != has_fold(most) {
            return None;
        }
        let radii = if width > 0.0 { 1 + (width / LoadTable::FINENESS) as usize } else { 0 };
        let log_step = width / radii.max(1) as f64;
        let step = (largest - self.law.break_away(most).overlap.min(self.deepest)).max(0.0).sqrt() / (ROWS - 1) as f64;
        let of_radii: Vec<Rows> = (0..=radii).map(|i| self.rows(exp(log_least + i as f64 * log_step), step)).collect();
        let is_finite = of_radii.iter().flatten().flatten().all(|number| number.is_finite());
        // The last radius is within.
        (is_finite && step > 0.0).then_some(LoadTable {
            step,
            log_least,
            log_step: log_step * (1.0 + f64::EPSILON),
            of_radii,
        })
    }

    /// The rows of a radius.
    fn rows(&self, g: f64, step: f64) -> Rows {
        let break_away = self.law.break_away(g).overlap;
        let mut summit = OneSummit { depth: 0.0, g, break_away, before: UNASKED, place: None };
        let mut rows = [[0.0; 4]; ROWS];
        for (i, row) in rows.iter_mut().enumerate().rev() {
            let over = if i == 0 { LoadTable::NEXT_TO_BREAK_AWAY } else { 0.0 };
            let root = step * (i as f64 + over);
            let contact = self.contact_of_one(&mut summit, break_away + root * root);
            let by_place = 2.0 * root * step * contact.s_by_overlap();
            let load = contact.by_s.load * by_place;
            *row = [contact.load - over * load, load, contact.parameter - over * by_place, by_place];
        }
        rows
    }

    /// The radius of a summit over the mean one.
    fn factor_of_one(&self, z: f64, sharper: f64) -> f64 {
        1.0 / (1.0 / self.radius.factor(z) + sharper)
    }

    /// The summit of a height, so far below the tallest; `sharper` adds to the inverse of its radius over the mean one.
    pub fn one_summit(&self, z: f64, depth: f64, sharper: f64, table: Option<&LoadTable>) -> OneSummit {
        let g = self.factor_of_one(z, sharper);
        let equal = self.radius.is_constant() && sharper == 0.0;
        let break_away = if equal { self.deepest } else { self.law.break_away(g).overlap };
        OneSummit { depth, g, break_away, before: UNASKED, place: table.and_then(|table| table.place(g)) }
    }

    /// The load of a summit at an overlap on the branch of unloading: in contact down to its break-away, and below attracted
    /// where there is such a state. What a table has of it is taken from there.
    #[inline]
    pub fn load_of_one(&self, summit: &mut OneSummit, overlap: f64, table: Option<&LoadTable>) -> Pressed {
        if overlap >= summit.break_away {
            let root = (overlap - summit.break_away).sqrt();
            let told = table.zip(summit.place).and_then(|(table, place)| Some((table, table.read(LOAD, place, root)?)));
            if let Some((table, (load, by_place))) = told {
                return Pressed { load, by_overlap: by_place / (2.0 * root * table.step) };
            }
            let contact = self.contact_of_one(summit, overlap);
            return Pressed { load: contact.load, by_overlap: contact.by_s.load * contact.s_by_overlap() };
        }
        let attracted = self.attraction_of(overlap, summit.g);
        attracted.map_or(Pressed::default(), |one| Pressed { load: one.load, by_overlap: one.load_by_overlap })
    }

    /// The parameter that a table has of a summit.
    fn parameter_of_one(&self, summit: &OneSummit, overlap: f64, table: Option<&LoadTable>) -> Option<f64> {
        let over = (overlap >= summit.break_away).then_some(overlap - summit.break_away)?;
        Some(table?.read(PARAMETER, summit.place?, over.sqrt())?.0)
    }

    /// Begins at what a table has of a summit when that is asked for exactly.
    pub fn begin_with(&self, summit: &mut OneSummit, overlap: f64, table: Option<&LoadTable>) {
        if let Some(parameter) = self.parameter_of_one(summit, overlap, table) {
            summit.before = (parameter, overlap, 0.0);
        }
    }

    /// A summit at an overlap with all that the sums take of it; `None` out of contact. What a table has of it is taken from there.
    pub fn contact_at(&self, summit: &mut OneSummit, overlap: f64, table: Option<&LoadTable>) -> Option<Summit> {
        (overlap >= summit.break_away).then(|| {
            let contact = match self.parameter_of_one(summit, overlap, table) {
                Some(parameter) => self.law.at(parameter, summit.g),
                None => self.contact_of_one(summit, overlap),
            };
            Summit::new(&contact, self.slip.friction(&contact))
        })
    }

    #[inline]
    fn contact_of_one(&self, summit: &mut OneSummit, overlap: f64) -> Contact {
        let (parameter, at, slope) = summit.before;
        let onwards = parameter + slope * (overlap - at);
        let guess = if onwards > 0.0 { onwards } else { self.law.guess(overlap, summit.g) };
        let contact = self.law.at_overlap(overlap, summit.g, guess);
        summit.before = (contact.parameter, overlap, contact.s_by_overlap());
        contact
    }

    /// No summit of the mean radius pulls with more than this, in E* b^2: 2 pi w R.
    pub fn most_pull(&self) -> f64 {
        2.0 * PI * self.groups.gamma * self.groups.beta / self.groups.alpha
    }

    /// The sums of lone summits with what neighbours change.
    pub fn among_neighbours(&self, sums: Sums) -> Sums {
        let Some(crowding) = self.crowding() else { return sums };
        let sums = crowding.among(sums);
        if self.radius.scores.is_some() {
            crowding.merged(sums, &self.slip)
        } else {
            sums
        }
    }
}
