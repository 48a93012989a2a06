//! Single specimens: what a device, or one bead, has of friction, stiffness and adhesion, on the summits that it happens to have.
//!
//! The sums of the model are means over all heights at a given separation. A specimen has so many summits as there are, at heights that are
//! drawn at random (`heights`), each with the exact law of one summit, and is unloaded from heavy load (`unload`), so that it jumps over
//! states that could not hold.

mod heights;
mod statistics;
mod unload;

use crate::error::Error;
use crate::model::Model;
use crate::numerics::elementary::pow;
use crate::numerics::float_bits::finite;
use crate::params::Params;
use crate::population::Sums;
use heights::Heights;
pub use statistics::spread;
use std::f64::consts::PI;
use unload::{too_many, Specimen, Sphere, MOST_DRAWN};

/// On a sphere with fewer summits about its lowest point Poisson's statistics do not hold.
const FEWEST_ON_SPHERE: f64 = 3.0;

/// A specimen under one load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// Friction force [force]; 0 where the specimen is apart.
    pub friction_force: f64,
    /// Tangential force by displacement while all contacts stick [force/length].
    pub tangential_stiffness: f64,
    /// Minus the slope of the load by the gap [force/length].
    pub normal_stiffness: f64,
    /// The gap between the mean planes [length]; NaN where the specimen is apart.
    pub gap: f64,
    /// Summits in contact.
    pub contacts: f64,
    /// The largest pull that the specimen withstands [force], the same at each load.
    pub pull_off_force: f64,
}

/// Which specimens are asked for.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Specimens {
    /// R [length] of rough spheres, which bear on the summits about their lowest point; 0: specimens are flat.
    pub sphere_radius: f64,
    /// The first one, from 0.
    pub first: u64,
    /// How many.
    pub count: usize,
    /// Of the random numbers: the same specimens for the same seed.
    pub seed: u64,
}

impl Model {
    /// Whether specimens may be asked for at a load, also below the pull-off load of the model.
    ///
    /// # Errors
    /// As [`Model::validate_load`].
    pub(crate) fn validate_specimens_load(&self, load: f64) -> Result<(), Error> {
        self.validate_load(if finite(load) { load.max(0.0) } else { load })
    }

    /// Specimens under loads, each with all loads, in the order of these.
    ///
    /// # Errors
    /// [`Error::InvalidLoad`], [`Error::OutOfRange`] for too heavy loads, less than one summit, or too many that must be drawn.
    pub fn specimens_at_loads(&self, asked: Specimens, loads: &[f64]) -> Result<Vec<Held>, Error> {
        for &load in loads {
            self.validate_specimens_load(load)?;
        }
        let count = self.units().count;
        if count < 1.0 {
            let allowed = "a specimen needs its number of summits, 1 or more: give its nominal_area";
            return Err(Error::out_of_range("asperity_count", count, allowed));
        }
        let of_one = self.units().load / count;
        let mut order = crate::numerics::ascending(loads);
        order.reverse();
        let heaviest = order.first().map_or(0.0, |&i| loads[i].max(0.0)) / of_one;
        let population = self.population();
        if self.largest_load > 0.0 {
            let allowed = "single specimens are those of first loading: ask the model that this one was unloaded from";
            return Err(Error::out_of_range("largest_load", self.largest_load, allowed));
        }
        let (lowest, highest) = population.extent();
        let heights = Heights::new(population.heights(), lowest, highest);
        let sphere = self.sphere(asked.sphere_radius, heaviest * of_one)?;
        let specimen = |index: u64| Specimen::new(population, &heights, (count, sphere), asked.seed, index);
        // One that is like the others says where to begin and how many summits are drawn, with all ranges before this one.
        let mut typical = specimen(u64::MAX);
        let from = typical.pressed(-population.range_of_adhesion(), heaviest)?;
        let from = typical.unloaded(from, heaviest)?.unwrap_or(0.0);
        let drawn = typical.drawn().max(loads.len()) as f64 * (asked.first as f64 + asked.count as f64);
        if drawn > MOST_DRAWN {
            return Err(too_many(drawn));
        }
        let mut found = vec![Held::apart(0.0); asked.count * loads.len()];
        for (i, found) in found.chunks_mut(loads.len().max(1)).enumerate() {
            let mut one = specimen(asked.first.wrapping_add(i as u64));
            let pull_off_force = one.pull_off()? * of_one;
            found.fill(Held::apart(pull_off_force));
            let mut approach = Some(one.pressed(from, heaviest)?);
            let mut last = None;
            // Neither is the pull-off force known to the last digit.
            for &k in order.iter().filter(|&&k| loads[k] >= -1.000_001 * pull_off_force) {
                match last {
                    Some(j) if loads[j] == loads[k] => found[k] = found[j],
                    _ => {
                        let Some(before) = approach else { break };
                        approach = one.unloaded(before, loads[k] / of_one)?;
                        if let Some(approach) = approach {
                            found[k] = self.held(&mut one, approach, pull_off_force)?;
                        }
                    }
                }
                last = Some(k);
            }
        }
        Ok(found)
    }

    /// A rough sphere under a load; `None` for a plane.
    fn sphere(&self, radius: f64, load: f64) -> Result<Option<Sphere>, Error> {
        let refused = |value: f64, allowed| Err(Error::out_of_range("sphere_radius", value, allowed));
        let Params { height_std, asperity_count, nominal_area, summit_radius, composite_modulus, .. } = *self.params();
        if radius == 0.0 {
            return Ok(None);
        }
        if !finite(radius) || radius < 0.0 {
            return Err(Error::invalid("sphere_radius", radius, "must be finite and >= 0; 0 is a plane"));
        }
        if nominal_area == 0.0 {
            return Err(Error::Missing {
                name: "nominal_area",
                says: "must be set, since a sphere needs the summits per area",
            });
        }
        let number = 2.0 * PI * radius * height_std * asperity_count / nominal_area;
        if number < FEWEST_ON_SPHERE {
            return refused(radius, "fewer than 3 summits stand within height_std of the lowest point: take one smooth hill, a specimen of one \
                                    summit of this radius");
        }
        let touched = pow(0.75 * load * radius / composite_modulus, 2.0 / 3.0);
        if touched > radius * height_std {
            return refused(radius, "under this load the sphere itself flattens, beyond Hertz' radius of (R height_std)^(1/2): take a flat \
                                    specimen of the area pi (a^2 + 1.5 R height_std), with a of Hertz");
        }
        Ok(Some(Sphere { number, sharper: summit_radius / radius }))
    }

    fn held(&self, one: &mut Specimen, approach: f64, pull_off_force: f64) -> Result<Held, Error> {
        let (contacts, units) = (one.contacts(approach)?, self.units());
        // Summits on a sphere have neighbours on one side.
        let lone = Sums {
            area: contacts.area / units.count,
            radius: contacts.radius / units.count,
            load_slope: -contacts.stiffness / units.count,
            ..Sums::default()
        };
        let sums = if one.is_flat() { self.population().among_neighbours(lone) } else { lone };
        let separation = one.tallest() - approach;
        Ok(Held {
            friction_force: contacts.friction * units.force / units.count,
            tangential_stiffness: contacts.radius / sums.psi() * units.stiffness / units.count,
            normal_stiffness: contacts.stiffness / sums.approach_of_planes() * (units.load / units.count)
                / units.length,
            gap: if one.is_flat() { self.gap_at(separation) } else { self.gap_of_lone(separation) },
            contacts: contacts.number,
            pull_off_force,
        })
    }
}

impl Held {
    fn apart(pull_off_force: f64) -> Self {
        Self {
            friction_force: 0.0,
            tangential_stiffness: 0.0,
            normal_stiffness: 0.0,
            gap: f64::NAN,
            contacts: 0.0,
            pull_off_force,
        }
    }
}
