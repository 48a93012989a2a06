//! The separations at which the sums are not smooth.
//!
//! A summit has kinks: where its contact begins, where its attraction does, at the contact radii of the slip law, at the overlaps of
//! the law of contact. The height of the summits that are at one moves with the separation. The sums have a kink where that height
//! passes one at which the density of heights is not smooth; and, where radii vary with height, where it turns back, since there
//! two heights meet, and where the contact that begins has a radius of the slip law's.

use super::break_away::Edge;
use super::{Point, Population};
use crate::asperity::contact::Contact;
use crate::numerics::{ascending, root};

/// Hardly any heights are below this, in sigma from their mean: where they begin is then no kink.
const LOWEST_END: f64 = -8.0;
/// Kinks nearer to each other than this, relative to 1 or to the separation, are one.
const SAME_KINK: f64 = 1e-8;

impl Population {
    /// The separations at which the sums are not smooth, in ascending order.
    pub fn kinks(&self) -> Vec<f64> {
        let (lower_end, _) = self.heights.support();
        let is_power = self.heights.power_at_lower_end().is_some();
        let lower_end = (is_power && lower_end + self.heights.origin() > LOWEST_END).then_some(lower_end);
        let heights = self.heights.breakpoints().iter().copied().chain(lower_end);
        let mut kinks: Vec<f64> = heights.flat_map(|z| self.kinks_of_height(z)).collect();
        if !self.radius.is_constant() {
            for radius in self.slip.kinks() {
                kinks.extend(self.separations_where(|z| {
                    let (g, g_rate) = self.radius.at(z);
                    let contact = self.contact_of_radius(radius, g)?;
                    Some((Point { z, g_rate, contact }.radius_change(), z - contact.overlap))
                }));
                kinks.extend(self.separations_where(|z| {
                    let edge = Edge::at(&*self.law, &self.radius, z).point.contact;
                    Some((edge.radius - radius, z - edge.overlap))
                }));
            }
            for overlap in self.kinks_of_contact.into_iter().filter(|kink| kink.is_finite()) {
                kinks.extend(self.separations_where(|z| {
                    let (g, g_rate) = self.radius.at(z);
                    Some((1.0 - overlap * g_rate, z - overlap * g))
                }));
            }
        }
        let mut kinks: Vec<f64> = ascending(&kinks).into_iter().map(|i| kinks[i]).collect();
        kinks.dedup_by(|next, kink| *next - *kink < SAME_KINK * (1.0 + kink.abs()));
        kinks
    }

    /// The separations at which a height passes what a summit has a kink at.
    fn kinks_of_height(&self, z: f64) -> Vec<f64> {
        let g = self.radius.factor(z);
        let mut kinks = vec![z - self.law.break_away(g).overlap];
        kinks.extend(self.attraction.as_ref().map(|law| z + law.reach));
        kinks.extend(
            self.slip.kinks().iter().filter_map(|&radius| Some(z - self.contact_of_radius(radius, g)?.overlap)),
        );
        kinks.extend(self.kinks_of_contact.iter().map(|overlap| z - overlap * g).filter(|kink| kink.is_finite()));
        kinks
    }

    /// The separations, which `at` gives as its second, at the heights where its first changes sign.
    fn separations_where(&self, at: impl Fn(f64) -> Option<(f64, f64)>) -> Vec<f64> {
        let value = |z: f64| at(z).map(|(value, _)| value);
        let looks: Vec<_> = self.radius.looks(self.lower_cut, self.highest).map(|z| (z, value(z))).collect();
        let passed = looks.windows(2).filter_map(|between| {
            let [(lower, before), (upper, after)] = [between[0], between[1]];
            ((before? < 0.0) != (after? < 0.0)).then_some((lower, upper))
        });
        let at_root =
            passed.filter_map(|(lower, upper)| at(root::bracketed(|z| value(z).unwrap_or(f64::NAN), lower, upper)));
        at_root.map(|(_, separation)| separation).collect()
    }

    /// The contact of a radius; `None` if it breaks before it is as small.
    pub(super) fn contact_of_radius(&self, radius: f64, g: f64) -> Option<Contact> {
        let edge = self.law.break_away(g);
        if radius <= edge.radius {
            return None;
        }
        let residual = |s: f64| self.law.at(s, g).radius - radius;
        let mut upper = edge.parameter + 1.0;
        while residual(upper) < 0.0 {
            upper *= 2.0;
        }
        Some(self.law.at(root::bracketed(residual, edge.parameter, upper), g))
    }
}
