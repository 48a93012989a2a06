//! One summit alone: the law that the sums are made of, eqs (4)-(6), (9)-(11) and (13)-(15).

use super::Population;

/// A summit at an overlap. Load in E* b^2, friction in G* b^2, radius in b.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OneSummit {
    /// Load; negative where it pulls.
    pub load: f64,
    /// Friction force; 0 out of contact.
    pub friction: f64,
    /// Contact radius; 0 out of contact.
    pub radius: f64,
}

impl Population {
    /// The summit of height z at an overlap, in sigma, on the branch of unloading: in contact down to its break-away, and
    /// below attracted where there is such a state.
    pub fn one_summit(&self, overlap: f64, z: f64) -> OneSummit {
        let g = self.radius.factor(z);
        let break_away = if self.radius.is_constant() { self.deepest } else { self.law.break_away(g).overlap };
        if overlap < break_away {
            let load = self.attraction_at(overlap, z).map_or(0.0, |attracted| attracted.load);
            return OneSummit { load, friction: 0.0, radius: 0.0 };
        }
        let contact = self.law.at_overlap(overlap, g, self.law.guess(overlap, g));
        OneSummit { load: contact.load, friction: self.slip.friction(&contact).force, radius: contact.radius }
    }
}
