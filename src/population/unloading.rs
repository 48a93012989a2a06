//! Summits after a larger load: up to the separation at which they stood under it they are as at first loading, beyond it they
//! spring back (`asperity::unloaded`).

use super::break_away::LEAST_RATE;
use super::{Point, Population};
use crate::asperity::contact::ContactLaw;
use crate::asperity::unloaded::Unloaded;
use crate::numerics::root;
use std::borrow::Cow;
use std::sync::Arc;

impl Population {
    /// The same summits after they stood at a separation; `None` if taller ones would part before lower ones, where radii vary.
    pub fn unloaded_from(&self, separation: f64) -> Option<Self> {
        let unloaded = Self { largest: separation, ..self.clone() };
        let law = unloaded.unloading(0.0);
        let (lowest, highest) = (separation.max(self.lower_cut), self.highest);
        let follows = |z: f64| {
            let (g, g_rate) = self.radius.at(z);
            let (_, [by_overlap, by_g]) = law.spring(z - separation, g);
            by_overlap + by_g * g_rate > LEAST_RATE * by_overlap
        };
        (self.radius.is_constant() || self.radius.looks(lowest, highest).all(follows)).then_some(unloaded)
    }

    /// The same summits at first loading.
    pub fn at_first_loading(&self) -> Cow<'_, Self> {
        match self.largest < f64::INFINITY {
            true => Cow::Owned(Self { largest: f64::INFINITY, ..self.clone() }),
            false => Cow::Borrowed(self),
        }
    }

    /// The separation under the largest load, which nothing has reached at first loading: then it is infinite.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// The summits as they are at a separation.
    pub(super) fn as_at(&self, separation: f64) -> Cow<'_, Self> {
        if separation <= self.largest {
            return Cow::Borrowed(self);
        }
        let lost = separation - self.largest;
        let law = Arc::new(self.unloading(lost));
        Cow::Owned(Self { law, lost, nodes: None, largest: f64::INFINITY, ..self.clone() })
    }

    fn unloading(&self, lost: f64) -> Unloaded {
        let (first_yield, stiffness_of_radius) = (self.kinks_of_contact[0], self.groups.stiffness_of_radius());
        Unloaded { loading: Arc::clone(&self.law), first_yield, stiffness_of_radius, lost }
    }

    /// The separation from which on a summit of a height is apart.
    pub(super) fn parts_at(&self, z: f64) -> f64 {
        match z > self.largest {
            true => self.largest + self.unloading(0.0).spring(z - self.largest, self.radius.factor(z)).0,
            false => z,
        }
    }

    /// The separations of unloading at which the sums are not smooth: where a height at which they are not passes the edge of contact or
    /// a radius of the slip law, or the largest contact does.
    pub(super) fn kinks_of_unloading(&self, ends_of_heights: &[f64]) -> Vec<f64> {
        let (law, from) = (self.unloading(0.0), self.largest);
        let yielding = self
            .kinks_of_contact
            .iter()
            .flat_map(|&overlap| self.heights_where(|z| z - from - overlap * self.radius.factor(z)));
        let heights: Vec<f64> = ends_of_heights.iter().copied().chain(yielding).filter(|&z| z > from).collect();
        let mut kinks = vec![from];
        kinks.extend(heights.iter().map(|&z| self.parts_at(z)));
        for radius in self.slip.kinks() {
            // x at which the contact has it.
            let left = |z: f64| {
                let largest = self.law.at_overlap(z - from, self.radius.factor(z), 0.0).radius;
                (z > from && largest > radius).then(|| (radius / largest).powi(2))
            };
            let passes = |z: f64| Some(from + (self.parts_at(z) - from) * (1.0 - left(z)?));
            kinks.extend(heights.iter().filter_map(|&z| passes(z)));
            if !self.radius.is_constant() {
                kinks.extend(self.separations_where(&|z| {
                    let lost = passes(z)? - from;
                    let (g, g_rate) = self.radius.at(z);
                    let contact = Unloaded { lost, ..law.clone() }.at_overlap(z - from - lost, g, 0.0);
                    Some((Point { z, g_rate, contact }.radius_change(), from + lost))
                }));
            }
        }
        kinks
    }

    /// The heights at which a function changes sign.
    fn heights_where(&self, f: impl Fn(f64) -> f64) -> Vec<f64> {
        if self.radius.is_constant() {
            return vec![root::bracketed(&f, self.lower_cut, self.highest)];
        }
        self.separations_where(&|z| Some((f(z), z)))
    }
}
