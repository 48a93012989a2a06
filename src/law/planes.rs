//! How far apart the mean planes of the surfaces are: the gap u of a separation d of the summits, u = d + the integral of 1 -
//! psi from d to infinity, and the separation of a gap. Without a nominal area psi is 1, and both are the same.
//!
//! In each panel of the curve psi is a polynomial through the panel's exact states, with its slopes; its integral is the gap.
//! Beyond the branch there are panels of the same kind, up to where psi is 1. Farther in compression than the first panel, psi
//! is constant. The height of the mean of the summits above the mean plane of the surface is left to the callers.

use super::panel::{chebyshev, Hermite, Length, Sample, PANEL_CHECKS, PANEL_NODES};
use super::position::Positions;
use super::steps::MOST_OF_THE_REST;
use super::tolerance::{self, larger};
use crate::equilibrium::Branch;
use crate::numerics::quadrature::integrate_short;
use crate::numerics::root;

/// A panel beyond the branch reaches as far as the real area falls by this factor, as a power of e, or over a part of what is left to the
/// separation from which on nothing touches. There are no more than so many.
const FALL_OF_AREA: f64 = 8.0;
const MOST_PANELS_BEYOND: usize = 64;
/// One that misses psi between its nodes is halved, to this part at the least.
const LEAST_PART: f64 = 1.0 / 64.0;
/// None is shorter, relative to 1 or to the separation: its nodes would have no digits.
const SHORTEST_PLANES_PANEL: f64 = 1e-9;
/// Steps of Newton's method; some four are enough.
const MOST_NEWTON_STEPS: u32 = 12;

/// A separation with 1 - psi, and the slope of that.
#[derive(Debug, Clone, Copy)]
struct Place {
    separation: f64,
    crowding: (f64, f64),
}

impl Place {
    fn of(sample: &Sample) -> Self {
        Self { separation: sample.separation, crowding: sample.crowding }
    }

    fn psi(&self) -> f64 {
        1.0 - self.crowding.0
    }
}

/// Gaps against separations.
#[derive(Debug, Clone)]
pub struct Planes {
    /// In ascending order: those of the curve, and those beyond it.
    panels: Vec<PlanesPanel>,
    /// psi where the first begins.
    first_psi: f64,
}

/// A stretch between two separations.
#[derive(Debug, Clone)]
pub struct PlanesPanel {
    begin: f64,
    end: f64,
    /// The gaps there.
    begin_gap: f64,
    end_gap: f64,
    length: Length,
    /// How long it is, in that.
    whole: f64,
    /// What the gap rises by.
    rise: Hermite,
}

impl PlanesPanel {
    /// From one state to another, through those of the nodes; where gaps begin is not known yet.
    pub fn between(from: &Sample, to: &Sample, nodes: &[Sample; PANEL_NODES], positions: Positions) -> Self {
        Self::new(Place::of(from), Place::of(to), nodes.each_ref().map(Place::of), positions)
    }

    fn new(from: Place, to: Place, nodes: [Place; PANEL_NODES], positions: Positions) -> Self {
        let length = Length::of(positions, from.separation, to.separation);
        let (mut places, mut slopes, mut bends) = ([0.0; PANEL_NODES], [0.0; PANEL_NODES], [0.0; PANEL_NODES]);
        for (i, node) in nodes.iter().enumerate() {
            let (place, density) = length.between(from.separation, node.separation);
            places[i] = place;
            slopes[i] = node.psi() / density;
            bends[i] = node.psi() * length.bend(node.separation) - node.crowding.1 / (density * density);
        }
        let slope = Hermite::new(0.0, places, slopes, bends);
        let rise_between = |from: f64, to: f64| integrate_short(from, to, |place| slope.at(place).0);
        let (mut rise, mut last) = (0.0, 0.0);
        let rises = places.map(|place| {
            rise += rise_between(last, place);
            last = place;
            rise
        });
        let (whole, _) = length.between(from.separation, to.separation);
        let end_gap = rise + rise_between(last, whole);
        let rise = Hermite::new(0.0, places, rises, slopes);
        Self { begin: from.separation, end: to.separation, begin_gap: 0.0, end_gap, length, whole, rise }
    }

    /// The largest relative error of psi at these states.
    pub fn error_at(&self, states: &[Sample]) -> f64 {
        states.iter().map(|state| self.error_of(&Place::of(state))).fold(0.0, larger)
    }

    fn error_of(&self, known: &Place) -> f64 {
        let (place, density) = self.length.between(self.begin, known.separation);
        (self.rise.at(place).1 * density / known.psi() - 1.0).abs()
    }

    /// The gap at a separation.
    fn gap(&self, separation: f64) -> f64 {
        let (place, _) = self.length.between(self.begin, separation);
        self.begin_gap + self.rise.at(place).0
    }

    /// The place at each of several gaps, and its slope.
    pub fn places<const N: usize>(&self, gap: [f64; N]) -> [(f64, f64); N] {
        let rise = gap.map(|gap| gap - self.begin_gap);
        let mean = (self.end - self.begin) / (self.end_gap - self.begin_gap);
        let mut place = rise.map(|rise| self.length.between(self.begin, self.begin + mean * rise).0);
        for _ in 0..MOST_NEWTON_STEPS {
            let found = place.map(|place| self.rise.at(place));
            let steps: [f64; N] = std::array::from_fn(|i| (rise[i] - found[i].0) / found[i].1);
            for (place, step) in place.iter_mut().zip(steps) {
                *place = (*place + step).clamp(0.0, self.whole);
            }
            // After such a step the next would be rounding.
            if steps.iter().all(|step| step.abs() <= tolerance::VALUE * self.whole) {
                return std::array::from_fn(|i| (place[i], 1.0 / found[i].1));
            }
        }
        rise.map(|rise| {
            let place = root::bracketed(|place| self.rise.at(place).0 - rise, 0.0, self.whole);
            (place, 1.0 / self.rise.at(place).1)
        })
    }
}

impl Planes {
    /// From the panels of the curve.
    pub fn new(branch: &Branch, mut panels: Vec<PlanesPanel>, positions: Positions) -> Self {
        let first_psi =
            panels.first().map_or(1.0, |first| first.rise.at(0.0).1 * first.length.between(first.begin, first.begin).1);
        extend(branch, &mut panels, positions);
        let mut gap = panels.last().map_or(0.0, |panel| panel.end);
        for panel in panels.iter_mut().rev() {
            let rise = panel.end_gap;
            (panel.end_gap, panel.begin_gap) = (gap, gap - rise);
            gap -= rise;
        }
        Self { panels, first_psi }
    }

    /// The index of the panel of a gap, or of the next one.
    pub fn index_of(&self, gap: f64) -> usize {
        self.panels.partition_point(|panel| panel.end_gap < gap)
    }

    pub fn panel(&self, index: usize) -> &PlanesPanel {
        &self.panels[index]
    }

    /// The separation at a gap.
    pub fn separation(&self, gap: f64) -> f64 {
        match self.panels.get(self.index_of(gap)) {
            Some(panel) if gap >= panel.begin_gap => {
                let [(place, _)] = panel.places([gap]);
                panel.length.beyond(panel.begin, place)
            }
            Some(panel) => panel.begin + (gap - panel.begin_gap) / self.first_psi,
            None => gap,
        }
    }

    /// The gap at a separation.
    pub fn gap(&self, separation: f64) -> f64 {
        match self.panels.get(self.panels.partition_point(|panel| panel.end < separation)) {
            Some(panel) if separation == panel.end => panel.end_gap,
            Some(panel) if separation >= panel.begin => panel.gap(separation),
            Some(panel) => panel.begin_gap + (separation - panel.begin) * self.first_psi,
            None => separation,
        }
    }
}

/// Adds panels beyond the branch, up to where neighbours change nothing.
fn extend(branch: &Branch, panels: &mut Vec<PlanesPanel>, positions: Positions) {
    let population = branch.population();
    let place = |separation: f64| Place { separation, crowding: population.at_separation(separation).crowding };
    let Some(last) = panels.last() else { return };
    let mut from = place(last.end);
    let end = population.farthest();
    let mut part = 1.0;
    for _ in 0..MOST_PANELS_BEYOND {
        if from.crowding.0 < tolerance::VALUE {
            return;
        }
        let least = SHORTEST_PLANES_PANEL * (1.0 + from.separation.abs());
        let next_kink = branch.kinks().iter().copied().find(|&kink| kink - from.separation > least).unwrap_or(end);
        // 1 - psi goes as the root of the area.
        let fall = 0.5 * FALL_OF_AREA * from.crowding.0 / -from.crowding.1;
        let length = part * fall.min(MOST_OF_THE_REST * (end - from.separation)).min(next_kink - from.separation);
        if length.is_nan() || length < least {
            return;
        }
        let to = place(from.separation + length);
        let nodes = std::array::from_fn(|i| place(positions.between(from.separation, to.separation, chebyshev(i))));
        let panel = PlanesPanel::new(from, to, nodes, positions);
        if !panel.end_gap.is_finite() {
            return;
        }
        let between = place(positions.between(from.separation, to.separation, PANEL_CHECKS[0]));
        if part > LEAST_PART && panel.error_of(&between) > tolerance::SLOPE {
            part *= 0.5;
            continue;
        }
        panels.push(panel);
        from = to;
    }
}
