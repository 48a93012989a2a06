//! One summit alone: the law that the sums are made of, eqs (4)-(6), (9)-(11) and (13)-(15), and where summits stand.

use super::sums::{Summit, Sums};
use super::Population;
use crate::asperity::contact::Contact;

/// A summit of a specimen. Heights and overlaps in sigma.
#[derive(Debug, Clone, Copy)]
pub struct OneSummit {
    /// How far it lies below the tallest summit of its specimen.
    pub depth: f64,
    /// Its radius over the mean one.
    pub g: f64,
    /// The overlap at which it breaks away.
    break_away: f64,
    /// Parameter of its law, overlap, and the slope of the one by the other, where it was last asked for.
    before: (f64, f64, f64),
}

/// The load of a summit in E* b^2, and its slope by overlap.
#[derive(Debug, Clone, Copy, Default)]
pub struct Pressed {
    pub load: f64,
    pub by_overlap: f64,
}

impl Population {
    /// The summit of a height, so far below the tallest; `sharper` adds to the inverse of its radius over the mean one.
    pub fn one_summit(&self, z: f64, depth: f64, sharper: f64) -> OneSummit {
        let g = 1.0 / (1.0 / self.radius.factor(z) + sharper);
        let equal = self.radius.is_constant() && sharper == 0.0;
        let break_away = if equal { self.deepest } else { self.law.break_away(g).overlap };
        OneSummit { depth, g, break_away, before: (f64::NAN, 0.0, 0.0) }
    }

    /// The load of a summit at an overlap on the branch of unloading: in contact down to its break-away, and below attracted
    /// where there is such a state.
    #[inline]
    pub fn load_of_one(&self, summit: &mut OneSummit, overlap: f64) -> Pressed {
        if overlap >= summit.break_away {
            let contact = self.contact_of_one(summit, overlap);
            return Pressed { load: contact.load, by_overlap: contact.by_s.load * contact.s_by_overlap() };
        }
        let attracted = self.attraction_of(overlap, summit.g);
        attracted.map_or(Pressed::default(), |one| Pressed { load: one.load, by_overlap: one.load_by_overlap })
    }

    /// A summit at an overlap with all that the sums take of it; `None` out of contact.
    pub fn contact_at(&self, summit: &mut OneSummit, overlap: f64) -> Option<Summit> {
        (overlap >= summit.break_away).then(|| {
            let contact = self.contact_of_one(summit, overlap);
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
        self.most_pull
    }

    /// The sums of lone summits with what neighbours change.
    pub fn among_neighbours(&self, sums: Sums) -> Sums {
        self.crowding.map_or(sums, |crowding| crowding.among(sums))
    }
}
