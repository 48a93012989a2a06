//! Contacts that have each borne a largest load of its own, and spring back from it: between models that are unloaded from a few loads,
//! made when they are first asked for.
//!
//! Force and stiffness over those at the largest load hardly depend on that load, at the same part of it: they are interpolated.

use super::Model;
use crate::law::Quantity;
use crate::memory::{PerLevel, Sloped};
use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::{power_of_two, MANTISSA_BITS};
use crate::numerics::four::Portable;
use std::sync::{Arc, OnceLock};

/// Models that are unloaded from largest loads each twice the one before, of those of whose summits some yield.
#[derive(Debug, Clone)]
pub(super) struct Unloaded {
    /// The exponent of the lightest, and whether each can be made.
    first: u64,
    models: Arc<[OnceLock<Option<Box<Top>>>]>,
}

/// A model after its largest load, and what it has there.
#[derive(Debug)]
struct Top {
    model: Model,
    load: f64,
    values: [f64; Quantity::COUNT],
}

/// The law of contacts after a largest load.
#[derive(Debug, Clone, Copy)]
pub(super) struct After<'a> {
    largest: f64,
    values: [f64; Quantity::COUNT],
    /// Models after other largest loads, with their weights.
    near: [(&'a Model, f64, [f64; Quantity::COUNT], f64); 2],
}

impl Unloaded {
    /// Those of a table of loads.
    pub fn of((lightest, heaviest): (f64, f64)) -> Self {
        let exponent = |load: f64| load.to_bits() >> MANTISSA_BITS;
        let count = exponent(heaviest).saturating_sub(exponent(lightest)) + 1;
        Self { first: exponent(lightest) + 1, models: (0..count).map(|_| OnceLock::new()).collect() }
    }

    /// The one at a place, if it can be made.
    fn at(&self, place: u64, first: &Model) -> Option<&Top> {
        let cell = self.models.get(place as usize)?;
        let made = cell.get_or_init(|| {
            let load = power_of_two(self.first + place);
            let model = first.unloaded_for(load, true).ok()?;
            let values = Quantity::ALL.map(|quantity| model.value_and_slope(quantity, load).0);
            Some(Box::new(Top { model, load, values }))
        });
        made.as_deref()
    }
}

impl Model {
    /// The law after a largest load, where that is not the law of this model.
    #[cold]
    #[inline(never)]
    pub(super) fn after(&self, largest: f64) -> Option<After<'_>> {
        let unloaded = self.unloaded.as_ref()?;
        if largest <= self.largest_load || largest > self.heaviest {
            return None;
        }
        let place = (largest.to_bits() >> MANTISSA_BITS).saturating_sub(unloaded.first);
        let values = |load: f64| Quantity::ALL.map(|quantity| self.value_and_slope(quantity, load).0);
        let upper = unloaded.at(place + 1, self).map(|top| (&top.model, top.load, top.values));
        let lower = match power_of_two(unloaded.first + place) <= self.largest_load {
            true => Some((self, self.largest_load, values(self.largest_load))),
            false => unloaded.at(place, self).map(|top| (&top.model, top.load, top.values)),
        };
        let (lower, upper) = (lower.or(upper)?, upper.or(lower)?);
        let above = if upper.1 > lower.1 { log(largest / lower.1) / log(upper.1 / lower.1) } else { 0.0 };
        let above = above.clamp(0.0, 1.0);
        let near = [(lower.0, lower.1, lower.2, 1.0 - above), (upper.0, upper.1, upper.2, above)];
        Some(After { largest, values: values(largest), near })
    }
}

impl After<'_> {
    /// Force and stiffness with their slopes at a load below the largest.
    pub fn sloped(&self, load: f64) -> [Sloped; Quantity::COUNT] {
        Quantity::ALL.map(|quantity| self.of(quantity, load))
    }

    fn of(&self, quantity: Quantity, load: f64) -> Sloped {
        let of = quantity as usize;
        let [mut log_part, mut slope] = [0.0; 2];
        for (model, top, values, weight) in self.near {
            let (value, slope_there) = model.value_and_slope(quantity, load / self.largest * top);
            log_part += weight * log(value / values[of]);
            slope += weight * (slope_there / value * top);
        }
        let value = self.values[of] * exp(log_part);
        Sloped { value, slope: value * (slope / self.largest) }
    }

    /// As [`Limits::at_excess`](crate::memory::Limits::at_excess) at a load.
    #[inline(never)]
    pub fn limits(&self, load: f64, cut: Option<[f64; 2]>, shares: &mut PerLevel, slopes: &mut PerLevel) {
        let (mut one, mut one_slopes) = (*shares, *slopes);
        shares.fill(0.0);
        slopes.fill(0.0);
        for (model, top, _, weight) in self.near {
            // By the load of that model.
            let unit = top / self.largest;
            let cut = cut.map(|[place, slope]| [place, slope / unit]);
            model.law.limits().at_excess::<Portable, true>(load * unit, cut, &mut one, &mut one_slopes);
            for j in 0..shares.len() {
                shares[j] += weight * one[j];
                slopes[j] += weight * unit * one_slopes[j];
            }
        }
    }
}
