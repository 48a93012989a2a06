//! How far apart the mean planes of the surfaces are: the gap u of a separation d of the summits, u = d + the integral of what the
//! surface gives way by from d to infinity (`population::crowding`), and the separation of a gap. Without a nominal area both are the same.
//!
//! In each panel of the curve 1 - psi is a polynomial through the panel's exact states, with its slopes; load and contact radius are
//! those of the curve. On waves the gaps of these states are known. From pull-off on, or beyond the lightest load, gaps are separations. Farther in compression than the first
//! panel, gaps change at the rate with which it begins. The height of the mean of the summits above the mean plane of the surface is left to the callers.

use super::coordinate::Coordinate;
use super::panel::{CurvePanel, Hermite, Sample, PANEL_NODES};
use super::position::Positions;
use super::tolerance::{self, larger};
use super::Quantity;
use crate::numerics::elementary::exp;
use crate::numerics::quadrature::integrate_short;
use crate::numerics::root;

/// Steps of Newton's method; some four are enough.
const MOST_NEWTON_STEPS: u32 = 12;
/// Positions at gaps are found to this part of a panel: after such a step the next would be rounding.
const LAST_NEWTON_STEP: f64 = 1e-9;

/// Gaps against separations.
#[derive(Debug, Clone)]
pub struct Planes {
    positions: Positions,
    /// In ascending order.
    panels: Vec<PlanesPanel>,
    /// d(gap)/d(separation) where the first begins.
    first_rate: f64,
    /// What a gap is more than the separation where neighbours change nothing any more: 0 but for what a larger load has left.
    lead: f64,
}

/// A stretch between two positions.
#[derive(Debug, Clone)]
pub struct PlanesPanel {
    pub begin: f64,
    end: f64,
    /// The gaps there.
    begin_gap: f64,
    end_gap: f64,
    /// What the gap rises by.
    rise: Hermite,
}

impl PlanesPanel {
    /// Through the states at its nodes, along a panel of the curve; where gaps begin is not known yet. Contacts of the radius b have
    /// this elastic stiffness.
    pub fn new(
        nodes: &[Sample; PANEL_NODES],
        panel: &CurvePanel,
        coordinate: Coordinate,
        positions: Positions,
        stiffness_of_radius: f64,
    ) -> Self {
        let of = |number: fn(&Sample) -> f64| nodes.each_ref().map(number);
        let (places, rates) = (of(|node| node.position), of(|node| node.gap_rate));
        let (begin, end) = (places[0], places[PANEL_NODES - 1]);
        let through = |rises: [f64; PANEL_NODES]| {
            let rise = Hermite::new(places, rises, rates);
            Self { begin, end, begin_gap: 0.0, end_gap: rises[PANEL_NODES - 1], rise }
        };
        if let Some(first) = nodes[0].gap {
            return through(nodes.each_ref().map(|node| node.gap.unwrap_or(f64::NAN) - first));
        }
        let crowding = Hermite::new(places, of(|node| node.crowding.0), of(|node| node.crowding.1));
        let rate = |position: f64| {
            let (off, (s, s_rate)) = (crowding.at(position).0, panel.s_at(position));
            let [(log_spread, _)] = panel.log_value_at(Quantity::Radius, [s]);
            let elastic = stiffness_of_radius * exp(log_spread) * (1.0 - off);
            let load_rate = coordinate.load(s).1 * s_rate;
            positions.rates(positions.separation(position)).0 + off * load_rate.min(0.0) / elastic
        };
        let (mut rise, mut last) = (0.0, places[0]);
        through(places.map(|position| {
            rise += integrate_short(last, position, rate);
            last = position;
            rise
        }))
    }

    /// How far the rate is off at a state that is not a node, over the tolerance of what that makes of gaps and of their slopes.
    pub fn error_at(&self, state: &Sample) -> f64 {
        let off = (self.rise.at(state.position).1 - state.gap_rate).abs();
        let of_gap = off * (self.end - self.begin) / (1.0 + state.separation.abs());
        larger(of_gap / tolerance::VALUE, off / state.gap_rate / tolerance::SLOPE)
    }

    /// The gap at a position, and its slope by that.
    fn gap(&self, position: f64) -> (f64, f64) {
        let (rise, rate) = self.rise.at(position);
        (self.begin_gap + rise, rate)
    }

    /// The position at each of several gaps, and its slope.
    fn places<const N: usize>(&self, gap: [f64; N]) -> [(f64, f64); N] {
        let rise = gap.map(|gap| gap - self.begin_gap);
        let mean = (self.end - self.begin) / (self.end_gap - self.begin_gap);
        let mut position = rise.map(|rise| (self.begin + mean * rise).clamp(self.begin, self.end));
        for _ in 0..MOST_NEWTON_STEPS {
            let found = position.map(|position| self.rise.at(position));
            let steps: [f64; N] = std::array::from_fn(|i| (rise[i] - found[i].0) / found[i].1);
            for (position, step) in position.iter_mut().zip(steps) {
                *position = (*position + step).clamp(self.begin, self.end);
            }
            if steps.iter().all(|step| step.abs() <= LAST_NEWTON_STEP * (self.end - self.begin)) {
                return std::array::from_fn(|i| (position[i], 1.0 / found[i].1));
            }
        }
        rise.map(|rise| {
            let position = root::bracketed(|position| self.rise.at(position).0 - rise, self.begin, self.end);
            (position, 1.0 / self.rise.at(position).1)
        })
    }
}

impl Planes {
    /// From panels in ascending order.
    pub fn new(mut panels: Vec<PlanesPanel>, positions: Positions) -> Self {
        let first_rate = panels
            .first()
            .map_or(1.0, |first| first.rise.at(first.begin).1 / positions.rates(positions.separation(first.begin)).0);
        let mut gap = panels.last().map_or(0.0, |panel| positions.separation(panel.end));
        for panel in panels.iter_mut().rev() {
            let rise = panel.end_gap;
            (panel.end_gap, panel.begin_gap) = (gap, gap - rise);
            gap -= rise;
        }
        panels.shrink_to_fit();
        Self { positions, panels, first_rate, lead: 0.0 }
    }

    /// With gaps so much larger that one is that of a separation.
    pub fn anchored(mut self, (separation, gap): (f64, f64)) -> Self {
        let lead = gap - self.gap(separation).0;
        for panel in &mut self.panels {
            panel.begin_gap += lead;
            panel.end_gap += lead;
        }
        Self { lead, ..self }
    }

    /// The index of the panel of a gap, or of the last one.
    fn index_of(&self, gap: f64) -> usize {
        self.panels.partition_point(|panel| panel.end_gap < gap).min(self.panels.len() - 1)
    }

    /// The position at neighbouring gaps of panels, and its slope.
    pub fn places<const N: usize>(&self, gap: [f64; N]) -> [(f64, f64); N] {
        let index = self.index_of(gap[0]);
        match gap.iter().all(|&gap| self.index_of(gap) == index) {
            true => self.panels[index].places(gap),
            false => gap.map(|gap| self.panels[self.index_of(gap)].places([gap])[0]),
        }
    }

    /// The separation at a gap.
    pub fn separation(&self, gap: f64) -> f64 {
        match (self.panels.first(), self.panels.last()) {
            (Some(first), _) if gap < first.begin_gap => {
                self.positions.separation(first.begin) + (gap - first.begin_gap) / self.first_rate
            }
            (_, Some(last)) if gap <= last.end_gap => self.positions.separation(self.places([gap])[0].0),
            _ => gap - self.lead,
        }
    }

    /// The gap at a separation, and its slope.
    pub fn gap(&self, separation: f64) -> (f64, f64) {
        self.gap_at(separation, self.positions.position(separation))
    }

    /// The same at a separation of which this is the position.
    pub fn gap_at(&self, separation: f64, position: f64) -> (f64, f64) {
        match self.panels.get(self.panels.partition_point(|panel| panel.end < position)) {
            Some(panel) if position >= panel.begin => {
                let (gap, rate) = panel.gap(position);
                (gap, rate / self.positions.rates(separation).0)
            }
            Some(panel) => {
                let beyond = separation - self.positions.separation(panel.begin);
                (panel.begin_gap + beyond * self.first_rate, self.first_rate)
            }
            None => (separation + self.lead, 1.0),
        }
    }
}
