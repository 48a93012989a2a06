//! The equilibrium of one specimen: its summits at the separations at which they carry given loads, unloaded from a heavy one.
//!
//! Where a specimen is, is told by the overlap of its tallest summit, its approach. As the surfaces part, the load of a summit is a convex
//! function of the separation that may jump up where it breaks away. A step by the load in excess over the slopes of the summits whose
//! load falls therefore never passes a separation at which the load is the one wanted.

use super::heights::{bits, exponential, uniform, Heights};
use crate::error::Error;
use crate::population::{LoadTable, OneSummit, Population, Pressed};

/// Loads are found to this part of the sum of the loads of all summits, each by its amount.
const TOLERANCE: f64 = 1e-12;
/// From this part on one more step of Newton's method finds them to that.
const NEXT_TO: f64 = 1e-6;
/// Where some summits pull the less the farther they are, steps are no longer than this part of the range of adhesion: a dip of the
/// load may be missed that is shorter.
const LONGEST: f64 = 0.03;
/// It bounds the time of a call.
const MOST_STEPS: u32 = 100_000;
/// A specimen is pressed until it carries more than its load by approaches that grow by this.
const GROWTH: f64 = 1.3;
const FIRST_PRESS: f64 = 0.05;
/// Of an interval in which the load is least so many golden sections leave 1e-5, over which it is the same to rounding.
const SECTIONS: u32 = 24;
/// Summits that may be drawn for one specimen, and for all.
pub const MOST_DRAWN: f64 = 1e7;

/// The loads of the summits at an approach.
#[derive(Debug, Clone, Copy, Default)]
pub struct Loads {
    pub load: f64,
    /// Sum of their amounts.
    magnitude: f64,
    /// How fast the load of those falls that fall as the surfaces part, and rises of the others.
    falls: f64,
    rises: f64,
    /// A load that the specimen does not fall below at this and any larger approach, if no more summits come near.
    bound: f64,
}

/// What the contacts of a specimen amount to.
#[derive(Debug, Clone, Copy, Default)]
pub struct Contacts {
    pub number: f64,
    pub friction: f64,
    pub radius: f64,
    pub area: f64,
    /// The load of Hertz' contacts of the same radii.
    pub hertz_load: f64,
    /// Minus the slope of the load by separation.
    pub stiffness: f64,
}

/// A rough sphere.
#[derive(Debug, Clone, Copy)]
pub struct Sphere {
    /// 2 pi R eta sigma: how many summits stand within sigma of its lowest point.
    pub number: f64,
    /// The mean radius of the summits over its own.
    pub sharper: f64,
}

/// The summits of a specimen that were drawn, the tallest first.
#[derive(Debug, Default)]
pub struct Summits {
    hazard: f64,
    tallest: f64,
    all: Vec<OneSummit>,
    /// The largest pull that it withstands, once that is known.
    pull_off: Option<f64>,
}

/// A specimen with the summits that were drawn, which may be kept.
pub struct Specimen<'a> {
    population: &'a Population,
    /// Loads of its summits, where it takes a solution of equations to have them: to look for a state.
    table: Option<&'a LoadTable>,
    heights: &'a Heights,
    /// The seed, and which of the specimens it is.
    random: (u64, u64),
    count: f64,
    sphere: Option<Sphere>,
    alike: f64,
    most_drawn: f64,
    drawn: &'a mut Summits,
}

impl<'a> Specimen<'a> {
    /// Of so many summits on a plane, or on a sphere, one of some that are alike, for which so many summits may be drawn.
    pub fn new(
        (population, table): (&'a Population, Option<&'a LoadTable>),
        heights: &'a Heights,
        (count, sphere): (f64, Option<Sphere>),
        (alike, most_drawn): (f64, f64),
        (seed, index): (u64, u64),
        drawn: &'a mut Summits,
    ) -> Self {
        let one_more = uniform(bits(seed, index, u64::MAX)) < count - count.floor();
        let count = if sphere.is_some() { f64::INFINITY } else { count.floor() + f64::from(u8::from(one_more)) };
        let random = (seed, index);
        let mut specimen = Self { population, table, heights, random, count, sphere, alike, most_drawn, drawn };
        match specimen.drawn.all.is_empty() {
            true => specimen.draw(),
            false => specimen.forget(),
        }
        specimen
    }

    /// What its summits are asked does not depend on what they were asked before.
    fn forget(&mut self) {
        self.drawn.all.iter_mut().for_each(OneSummit::forget);
    }

    /// The height of its tallest summit, above the mean of the heights, on a sphere above that at its lowest point.
    pub fn tallest(&self) -> f64 {
        self.drawn.tallest
    }

    pub fn look_up(&mut self, table: Option<&'a LoadTable>) {
        self.table = table;
    }

    pub fn is_flat(&self) -> bool {
        self.sphere.is_none()
    }

    /// How many summits were drawn.
    pub fn drawn(&self) -> usize {
        self.drawn.all.len()
    }

    /// Draws the next summit.
    fn draw(&mut self) {
        let j = self.drawn.all.len();
        let (seed, index) = self.random;
        let step = exponential(seed, index, j);
        let (above, z, sharper) = match self.sphere {
            None => {
                self.drawn.hazard += step / (self.count - j as f64);
                let z = self.heights.of_hazard(self.drawn.hazard);
                (z, z, 0.0)
            }
            Some(Sphere { number, sharper }) => {
                self.drawn.hazard += step / number;
                let share = uniform(bits(!seed, index, j as u64));
                let (above, z) = self.heights.on_sphere(self.drawn.hazard, share);
                (above, z, sharper)
            }
        };
        if j == 0 {
            self.drawn.tallest = above;
        }
        self.drawn.all.push(self.population.one_summit(z, self.drawn.tallest - above, sharper, self.table));
    }

    /// Draws all summits that are near at an approach; returns how many there are.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if they are too many.
    fn near(&mut self, approach: f64) -> Result<usize, Error> {
        let farthest = approach + self.population.range_of_adhesion();
        while (self.drawn.all.len() as f64) < self.count
            && self.drawn.all.last().is_some_and(|last| last.depth < farthest)
        {
            let drawn = self.drawn.all.len() as f64 * self.alike;
            if drawn >= self.most_drawn {
                return Err(too_many(drawn));
            }
            self.draw();
        }
        Ok(self.drawn.all.partition_point(|summit| summit.depth < farthest))
    }

    /// The loads of the summits at an approach, as the table has them.
    pub fn loads(&mut self, approach: f64) -> Result<Loads, Error> {
        self.loads_by(approach, self.table)
    }

    fn loads_by(&mut self, approach: f64, table: Option<&LoadTable>) -> Result<Loads, Error> {
        let near = self.near(approach)?;
        let mut loads = Loads::default();
        let most_pull = self.population.most_pull();
        for summit in &mut self.drawn.all[..near] {
            let Pressed { load, by_overlap } = self.population.load_of_one(summit, approach - summit.depth, table);
            loads.load += load;
            loads.magnitude += load.abs();
            loads.falls += by_overlap.max(0.0);
            loads.rises += (-by_overlap).max(0.0);
            loads.bound += if by_overlap > 0.0 || most_pull == 0.0 { load } else { -most_pull * summit.g };
        }
        if loads.load.is_nan() {
            return Err(Error::NotConverged { what: "load of a specimen at approach / height_std", value: approach });
        }
        Ok(loads)
    }

    /// The contacts at an approach, if so asked as the table has them.
    pub fn contacts(&mut self, approach: f64, by_table: bool) -> Result<Contacts, Error> {
        let table = self.table.filter(|_| by_table);
        let near = self.near(approach)?;
        let mut all = Contacts::default();
        for summit in &mut self.drawn.all[..near] {
            let overlap = approach - summit.depth;
            let Some(one) = self.population.contact_at(summit, overlap, table) else {
                all.stiffness += self.population.load_of_one(summit, overlap, table).by_overlap;
                continue;
            };
            all.stiffness += one.load_by_overlap;
            if one.radius > 0.0 {
                all.number += 1.0;
                all.friction += one.friction;
                all.radius += one.radius;
                all.hertz_load += one.hertz_load;
                all.area += std::f64::consts::PI * one.radius * one.radius;
            }
        }
        Ok(all)
    }

    /// An approach, from a first one on, at which, and at all larger ones, the specimen carries more than a load.
    pub fn pressed(&mut self, from: f64, load: f64) -> Result<f64, Error> {
        let (mut approach, mut step) = (from, FIRST_PRESS);
        while self.loads(approach)?.bound <= load {
            approach += step;
            step *= GROWTH;
        }
        Ok(approach)
    }

    /// The largest approach, up to one at which the specimen carries more, at which its load is this one; `None` if there is none.
    pub fn unloaded(&mut self, from: f64, load: f64) -> Result<Option<f64>, Error> {
        let (range, mut approach) = (self.population.range_of_adhesion(), from);
        if range == 0.0 && load <= 0.0 {
            return Ok((load == 0.0).then_some(0.0));
        }
        let (mut before, mut here) = (from, self.loads(approach)?);
        for _ in 0..MOST_STEPS {
            let excess = here.load - load;
            if excess.abs() <= TOLERANCE * here.magnitude {
                return Ok(Some(approach));
            }
            if excess < 0.0 {
                return self.between(approach, before, load).map(Some);
            }
            if here.falls <= 0.0 || approach <= -range {
                return Ok(None);
            }
            let (safe, slope) = (excess / here.falls, here.falls - here.rises);
            let newton = if slope > 0.0 { excess / slope } else { f64::INFINITY };
            if excess <= NEXT_TO * here.magnitude && newton <= 2.0 * safe {
                return Ok(Some(approach - newton));
            }
            let next = approach - safe.max(newton.min(LONGEST * range));
            if next == approach {
                return Ok(Some(approach));
            }
            (before, approach, here) = (approach, next, self.loads(next)?);
        }
        Err(Error::NotConverged { what: "approach of a specimen under load", value: load })
    }

    /// An approach at which the table has a load, as the laws of the summits themselves have it: by Newton's method, where it leads hardly
    /// farther.
    pub fn exact(&mut self, mut approach: f64, load: f64) -> Result<f64, Error> {
        const FARTHEST: f64 = 1e-4;
        for summit in &mut self.drawn.all {
            self.population.begin_with(summit, approach - summit.depth, self.table);
        }
        for _ in 0..u32::from(self.table.is_some()) * 2 {
            let here = self.loads_by(approach, None)?;
            let step = (here.load - load) / (here.falls - here.rises);
            let is_near = step.abs() <= FARTHEST * self.population.range_of_adhesion();
            if here.falls <= here.rises || !is_near {
                break;
            }
            approach -= step;
            if (here.load - load).abs() <= NEXT_TO * here.magnitude {
                break;
            }
        }
        Ok(approach)
    }

    /// The approach of a load between two, at the first of which the specimen carries less.
    fn between(&mut self, mut less: f64, mut more: f64, load: f64) -> Result<f64, Error> {
        for _ in 0..200 {
            let middle = 0.5 * (less + more);
            if middle <= less || middle >= more {
                break;
            }
            let here = self.loads(middle)?;
            if (here.load - load).abs() <= TOLERANCE * here.magnitude {
                return Ok(middle);
            }
            *(if here.load < load { &mut less } else { &mut more }) = middle;
        }
        Ok(more)
    }

    /// The largest pull that the specimen withstands.
    pub fn pull_off(&mut self) -> Result<f64, Error> {
        if let Some(known) = self.drawn.pull_off {
            return Ok(known);
        }
        let found = self.look_for_pull_off()?;
        self.drawn.pull_off = Some(found);
        self.forget();
        Ok(found)
    }

    fn look_for_pull_off(&mut self) -> Result<f64, Error> {
        let range = self.population.range_of_adhesion();
        if range == 0.0 {
            return Ok(0.0);
        }
        let step = LONGEST * range;
        let (mut approach, mut least, mut at) = (-range, 0.0, -range);
        for _ in 0..MOST_STEPS {
            let here = self.loads(approach)?;
            if here.load < least {
                (least, at) = (here.load, approach);
            }
            if here.bound > least {
                break;
            }
            approach += step;
        }
        // By golden sections.
        const PART: f64 = 0.381_966_011_250_105_1;
        let (mut lower, mut upper) = (at - step, at + step);
        let mut on = |approach: f64| -> Result<(f64, f64), Error> {
            let load = self.loads(approach)?.load;
            (least, at) = if load < least { (load, approach) } else { (least, at) };
            Ok((approach, load))
        };
        let (mut left, mut right) = (on(lower + PART * (upper - lower))?, on(upper - PART * (upper - lower))?);
        for _ in 0..SECTIONS {
            if left.1 < right.1 {
                (upper, right) = (right.0, left);
                left = on(lower + PART * (upper - lower))?;
            } else {
                (lower, left) = (left.0, right);
                right = on(upper - PART * (upper - lower))?;
            }
        }
        // At its minimum the load hardly depends on where that is.
        Ok(if self.table.is_some() { -self.loads_by(at, None)?.load } else { -least })
    }
}

/// Why specimens of so many summits are refused.
pub fn too_many(drawn: f64) -> Error {
    let allowed = "so many asperities of the specimens have to be drawn, and 1e7 at most may be: ask for fewer specimens, for lighter or fewer loads, \
                   or for a smaller nominal_area; specimens of more than 50 contacts hardly differ from the model";
    Error::out_of_range("specimens", drawn, allowed)
}
