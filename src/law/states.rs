//! The exact states of the curve: those between which its panels lie at first, and those of panels and of their halves.

use super::coordinate::Coordinate;
use super::panel::{Sample, PANEL_NODES};
use super::position::Positions;
use super::{Quantity, Reach};
use crate::equilibrium::{Branch, BranchPoint, PullOff};
use crate::numerics::elementary::log;
use crate::numerics::neighbours::Neighbours;

/// The ends of the loads are looked for in steps between these, in position, of so much more than slopes tell.
const STEPS: (f64, f64) = (1.0, 9.0);
const STEP_MORE: f64 = 1.15;
/// No panel is shorter, and no kink is nearer to the next or to an end: what is then not resolved is too short to matter. It is
/// the last of these, or a part of the range of adhesion where that is less, but so long that positions tell its eighths.
const SHORTEST: (f64, f64) = (1e-11, 1e-8);
const SHORTEST_OF_RANGE: f64 = 1e-3;

/// At this separation the load rises already, or cannot be had: the branch ends before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unfollowed {
    pub separation: f64,
}

/// The states of a stretch at eighths of its length in position, as far as they are known but for its ends: at even ones are the nodes
/// of a panel.
#[derive(Clone, Copy)]
pub struct Stretch {
    pub from: Sample,
    pub to: Sample,
    between: [Option<Sample>; 7],
}

impl Stretch {
    pub fn new(from: Sample, to: Sample) -> Self {
        Self { from, to, between: [None; 7] }
    }

    pub fn length(&self) -> f64 {
        self.to.position - self.from.position
    }

    /// The state at an eighth, if it is known.
    fn known(&self, eighth: usize) -> Option<Sample> {
        match eighth {
            0 => Some(self.from),
            8 => Some(self.to),
            _ => self.between[eighth - 1],
        }
    }

    /// Its halves, with their ends, if it has the states of its nodes.
    pub fn halves(&self) -> Option<[Self; 2]> {
        let middle = self.known(4)?;
        let [mut near, mut far] = [Self::new(self.from, middle), Self::new(middle, self.to)];
        for eighth in 1..4 {
            near.between[2 * eighth - 1] = self.known(eighth);
            far.between[2 * eighth - 1] = self.known(4 + eighth);
        }
        Some([near, far])
    }
}

/// Separation and ln x of kinks.
type Kinks = Vec<(f64, f64)>;

/// Asks a branch for states.
pub struct States<'a> {
    pub branch: &'a Branch,
    pub coordinate: Coordinate,
    pub positions: Positions,
    /// How many were asked for.
    pub count: usize,
    /// No panel or distance of kinks is shorter.
    pub shortest: f64,
}

impl<'a> States<'a> {
    pub fn new(branch: &'a Branch, coordinate: Coordinate, positions: Positions) -> Self {
        let shortest = match branch.population().range_of_adhesion() {
            0.0 => SHORTEST.1,
            range => {
                // Where adhesion reaches far beyond the heights, so do positions.
                let middle = -branch.population().heights().outline().origin;
                let among_heights = SHORTEST.1 / positions.rates(middle).0.max(1.0);
                (SHORTEST_OF_RANGE * range).min(among_heights).clamp(SHORTEST.0, SHORTEST.1)
            }
        };
        Self { branch, coordinate, positions, count: 0, shortest }
    }

    /// The state at a position on the branch.
    fn at(&mut self, position: f64) -> Result<Sample, Unfollowed> {
        self.of(position, self.positions.separation(position))
    }

    /// The state at a position on the branch, of which this is the separation.
    fn of(&mut self, position: f64, separation: f64) -> Result<Sample, Unfollowed> {
        self.count += 1;
        let point = self.branch.point(separation);
        // A load below that of the end is as far above it as can be told.
        if !(point.rate < 0.0 && point.sums.friction > 0.0 && point.log_excess > log(f64::MIN_POSITIVE)) {
            return Err(Unfollowed { separation });
        }
        Ok(self.sample(position, separation, point))
    }

    fn sample(&self, position: f64, separation: f64, point: BranchPoint) -> Sample {
        let BranchPoint { log_excess, rate, sums, gap } = point;
        let (s, s_rate) = self.coordinate.at(log_excess);
        let values = Quantity::ALL.map(|quantity| quantity.of(&sums));
        let position_rate = self.positions.rates(separation).0;
        Sample {
            separation,
            position,
            gap,
            gap_rate: sums.approach_of_planes() * position_rate,
            crowding: (sums.crowding.0, sums.crowding.1 * position_rate),
            log_excess,
            s,
            s_by_position: s_rate * rate * position_rate,
            load_by_s: self.coordinate.load_by_s(s),
            log_value: values.map(|(value, _)| log(value)),
            slope: values.map(|(value, slope)| slope / value / rate / s_rate),
        }
    }

    /// A state as it is beyond it: at the largest load the slopes are those of unloading.
    pub fn beyond(&mut self, state: Sample) -> Result<Sample, Unfollowed> {
        if state.separation != self.branch.population().largest() {
            return Ok(state);
        }
        let beyond = self.of(state.position, state.separation.above())?;
        Ok(Sample { s: state.s, log_excess: state.log_excess, log_value: state.log_value, ..beyond })
    }

    /// The states between which panels lie at first, in ascending order, from beyond the heaviest load of a reach to pull-off, or beyond
    /// the lightest; and separation and ln x of the kinks among them.
    pub fn knots(&mut self, reach: &Reach) -> Result<(Vec<Sample>, Kinks), Unfollowed> {
        // Slopes by x are no numbers at pull-off.
        let end = reach.pull_off.map(|PullOff { separation, sums, .. }| {
            let point = BranchPoint { log_excess: f64::NEG_INFINITY, rate: f64::NAN, sums, gap: None };
            self.sample(self.positions.position(separation), separation, point)
        });
        let middle = self.positions.position(-self.branch.population().heights().outline().origin);
        let farthest = end.map_or(self.positions.position(self.branch.farthest()), |end| end.position);
        let largest = self.branch.population().largest();
        let middle = if largest < f64::INFINITY { middle.min(self.positions.position(largest)) } else { middle };
        let mut heaviest = self.at(middle.min(farthest - 2.0))?;
        let mut states = vec![heaviest];
        if end.is_none() {
            let mut lightest = heaviest;
            while lightest.log_excess > reach.log_lightest {
                let mut step = step_to(&lightest, reach.log_lightest);
                // Not so far that nothing touches, as may be the crests of waves within a step.
                lightest = loop {
                    match self.at((lightest.position + step).min(0.5 * (lightest.position + farthest))) {
                        Err(_) if step > self.shortest => step *= 0.5,
                        Ok(next) if next.position < lightest.position + self.shortest => {
                            return Err(Unfollowed { separation: next.separation });
                        }
                        next => break next?,
                    }
                };
                states.push(lightest);
            }
        }
        while heaviest.log_excess < reach.log_heaviest {
            heaviest = self.at(heaviest.position - step_to(&heaviest, reach.log_heaviest))?;
            states.push(heaviest);
        }
        states.extend(end);
        states.sort_by(|a, b| a.position.total_cmp(&b.position));
        let kinks = self.add_kinks(&mut states)?;
        Ok((states, kinks))
    }

    /// Adds states at kinks between others; separation and ln x of those on the branch.
    fn add_kinks(&mut self, states: &mut Vec<Sample>) -> Result<Kinks, Unfollowed> {
        let mut kinks = Vec::new();
        for &kink in self.branch.kinks() {
            let position = self.positions.position(kink);
            let next = states.partition_point(|state| state.position < position);
            let is_apart = |other: &Sample| (position - other.position).abs() > self.shortest;
            if next > 0 && next < states.len() && is_apart(&states[next - 1]) && is_apart(&states[next]) {
                let state = self.of(position, kink)?;
                kinks.push((kink, state.log_excess));
                states.insert(next, state);
            }
        }
        Ok(kinks)
    }

    /// The state of a stretch at an eighth, which it then knows.
    pub fn eighth(&mut self, stretch: &mut Stretch, eighth: usize) -> Result<Sample, Unfollowed> {
        if let Some(state) = stretch.known(eighth) {
            return Ok(state);
        }
        let position = stretch.from.position + stretch.length() * eighth as f64 / 8.0;
        let state = self.at(position)?;
        stretch.between[eighth - 1] = Some(state);
        Ok(state)
    }

    /// Those at the nodes of a panel, at every so many eighths.
    pub fn nodes(&mut self, stretch: &mut Stretch, step: usize) -> Result<[Sample; PANEL_NODES], Unfollowed> {
        let mut nodes = [stretch.from; PANEL_NODES];
        for (i, node) in nodes.iter_mut().enumerate() {
            *node = self.eighth(stretch, 8.min(step * i))?;
        }
        Ok(nodes)
    }
}

/// How far the position of a load is from that of another, so far as the slope there tells.
fn step_to(from: &Sample, log_excess: f64) -> f64 {
    let rate = 2.0 * from.s_by_position;
    (STEP_MORE * (log_excess - from.log_excess) / rate).abs().clamp(STEPS.0, STEPS.1)
}
