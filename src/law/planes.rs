//! How far apart the mean planes of the surfaces are: the gap u of a separation d of the summits, u = d + the integral of 1 - psi from d
//! to infinity, and the separation of a gap. Without a nominal area psi is 1, and both are the same.
//!
//! In each panel of the curve the separation is a polynomial of the gap through the panel's exact states, with its slopes 1/psi. Beyond
//! the branch there are panels of the same kind, up to where psi is 1. Farther in compression than the first panel, psi is constant.
//! Heights of the mean of the summits above the mean plane of the surface are left to the callers.

use super::panel::{chebyshev, Hermite, Length, Sample, NODES};
use super::position::Positions;
use crate::equilibrium::Branch;
use crate::numerics::{quadrature, root};

/// Beyond the branch panels end where 1 - psi is less than this.
const NEGLIGIBLE: f64 = 1e-9;
/// A panel there reaches as far as the real area falls by this factor, as a power of e, or over this part of what is left to the
/// separation from which on nothing touches; there are no more than so many.
const FALL_OF_AREA: f64 = 8.0;
const MOST_OF_THE_REST: f64 = 0.7;
const MOST_PANELS: usize = 64;

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

/// Separations against gaps.
#[derive(Debug, Clone)]
pub struct Planes {
    /// In ascending order.
    panels: Vec<Panel>,
    /// psi where the first begins.
    first_psi: f64,
}

/// A stretch between two separations.
#[derive(Debug, Clone)]
struct Panel {
    begin: Ends,
    end: Ends,
    length: Length,
    separation: Hermite,
}

/// A separation with its gap.
#[derive(Debug, Clone, Copy)]
struct Ends {
    separation: f64,
    gap: f64,
}

/// How far the mean planes move apart from one place to another, before it is known where they are.
#[derive(Debug, Clone)]
pub struct Rise {
    from: Place,
    to: Place,
    whole: f64,
    /// Places in between with their rises; none where psi is a cubic.
    within: Option<[(Place, f64); NODES]>,
}

impl Rise {
    /// From one state to another, through those of the nodes, if it is not so short that psi is a cubic.
    pub fn between(from: &Sample, to: &Sample, nodes: Option<&[Sample; NODES]>, positions: Positions) -> Self {
        match nodes {
            Some(nodes) => Self::new(Place::of(from), Place::of(to), nodes.each_ref().map(Place::of), positions),
            None => Self::of_short(Place::of(from), Place::of(to)),
        }
    }

    /// Through places in between.
    fn new(from: Place, to: Place, nodes: [Place; NODES], positions: Positions) -> Self {
        let length = Length::of(positions, from.separation, to.separation);
        let (mut places, mut slopes, mut bends) = ([0.0; NODES], [0.0; NODES], [0.0; NODES]);
        for (i, node) in nodes.iter().enumerate() {
            let (place, density) = length.between(from.separation, node.separation);
            places[i] = place;
            slopes[i] = node.psi() / density;
            bends[i] = node.psi() * length.bend(node.separation) - node.crowding.1 / (density * density);
        }
        let slope = Hermite::new(0.0, places, slopes, bends);
        let between = |from: f64, to: f64| -> f64 {
            quadrature::nodes_of_part(0.0, from, to).map(|(place, weight)| weight * slope.at(place).0).sum()
        };
        let (mut whole, mut last) = (0.0, 0.0);
        let within = std::array::from_fn(|i| {
            whole += between(last, places[i]);
            last = places[i];
            (nodes[i], whole)
        });
        whole += between(last, length.between(from.separation, to.separation).0);
        Self { from, to, whole, within: Some(within) }
    }

    /// Between places so near to each other that psi is a cubic.
    fn of_short(from: Place, to: Place) -> Self {
        let width = to.separation - from.separation;
        let bend = (to.crowding.1 - from.crowding.1) * width * width / 12.0;
        Self { from, to, whole: 0.5 * width * (from.psi() + to.psi()) + bend, within: None }
    }
}

impl Panel {
    /// Of a rise that ends at a gap.
    fn new(rise: &Rise, end_gap: f64, positions: Positions) -> Self {
        let (from, to, begin_gap) = (&rise.from, &rise.to, end_gap - rise.whole);
        // As far from a middle as separations are, over psi.
        let middle = begin_gap - from.psi() * (from.separation - positions.middle);
        let length = Length::of(Positions { middle }, begin_gap, end_gap);
        let apart = |place: &Place| place.separation - from.separation;
        let separation = match &rise.within {
            Some(within) => {
                let places = within.map(|(_, rise)| length.between(begin_gap, begin_gap + rise));
                let slopes = std::array::from_fn(|i| 1.0 / (within[i].0.psi() * places[i].1));
                Hermite::new(0.0, places.map(|(place, _)| place), within.map(|(place, _)| apart(&place)), slopes)
            }
            None => {
                let [start, end] = [(from, 0.0), (to, rise.whole)].map(|(place, at)| (at, 1.0 / place.psi()));
                Hermite::cubic(0.0, start, end, apart(to))
            }
        };
        let ends = |place: &Place, gap: f64| Ends { separation: place.separation, gap };
        let length = if rise.within.is_some() { length } else { Length::Separation };
        Self { begin: ends(from, begin_gap), end: ends(to, end_gap), length, separation }
    }

    /// The separation at a gap, and its slope.
    fn separation(&self, gap: f64) -> (f64, f64) {
        let (place, density) = self.length.between(self.begin.gap, gap);
        let (rise, slope) = self.separation.at(place);
        (self.begin.separation + rise, slope * density)
    }

    fn gap(&self, separation: f64) -> f64 {
        root::bracketed(|gap| self.separation(gap).0 - separation, self.begin.gap, self.end.gap)
    }
}

impl Planes {
    /// From what the mean planes rise by along the branch, which ends in the last of them.
    pub fn new(branch: &Branch, mut rises: Vec<Rise>, positions: Positions) -> Self {
        extend(branch, &mut rises, positions);
        let mut gap = rises.last().map_or(0.0, |rise| rise.to.separation);
        let first_psi = rises.first().map_or(1.0, |rise| rise.from.psi());
        let mut panels = Vec::with_capacity(rises.len());
        for rise in rises.iter().rev() {
            panels.push(Panel::new(rise, gap, positions));
            gap -= rise.whole;
        }
        panels.reverse();
        Self { panels, first_psi }
    }

    /// The separation at a gap, and its slope.
    pub fn separation(&self, gap: f64) -> (f64, f64) {
        match self.panels.get(self.panels.partition_point(|panel| panel.end.gap < gap)) {
            Some(panel) if gap >= panel.begin.gap => panel.separation(gap),
            Some(Panel { begin, .. }) => (begin.separation + (gap - begin.gap) / self.first_psi, 1.0 / self.first_psi),
            None => (gap, 1.0),
        }
    }

    /// The gap at a separation.
    pub fn gap(&self, separation: f64) -> f64 {
        match self.panels.get(self.panels.partition_point(|panel| panel.end.separation < separation)) {
            Some(Panel { end, .. }) if separation == end.separation => end.gap,
            Some(panel) if separation >= panel.begin.separation => panel.gap(separation),
            Some(Panel { begin, .. }) => begin.gap + (separation - begin.separation) * self.first_psi,
            None => separation,
        }
    }
}

/// Adds rises beyond the branch, up to where neighbours change nothing.
fn extend(branch: &Branch, rises: &mut Vec<Rise>, positions: Positions) {
    let population = branch.population();
    let place = |separation: f64| Place { separation, crowding: population.at_separation(separation).crowding };
    let Some(last) = rises.last() else { return };
    let mut from = last.to;
    let end = population.farthest();
    for _ in 0..MOST_PANELS {
        if from.crowding.0 < NEGLIGIBLE {
            return;
        }
        let next_kink = branch.kinks().iter().copied().find(|&kink| kink > from.separation).unwrap_or(end);
        // 1 - psi goes as the root of the area.
        let fall = 0.5 * FALL_OF_AREA * from.crowding.0 / -from.crowding.1;
        let length = fall.min(MOST_OF_THE_REST * (end - from.separation)).min(next_kink - from.separation);
        if length.is_nan() || length <= 0.0 {
            return;
        }
        let to = place(from.separation + length);
        let nodes = std::array::from_fn(|i| place(positions.between(from.separation, to.separation, chebyshev(i))));
        rises.push(Rise::new(from, to, nodes, positions));
        from = to;
    }
}
