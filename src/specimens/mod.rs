//! Single specimens: what a device, or one bead, has of friction, stiffness and adhesion, on the summits that it happens to have.
//!
//! The sums of the model are means over all heights at a given separation. A specimen has so many summits as there are, at heights that are
//! drawn at random (`heights`), each with the exact law of one summit, and is unloaded from heavy load (`unload`), so that it jumps over
//! states that could not hold.

mod heights;
mod statistics;
mod unload;

use crate::error::Error;
use crate::model::{Model, Surfaces, Units};
use crate::numerics::elementary::pow;
use crate::numerics::float_bits::finite;
use crate::params::Params;
use crate::population::{LoadTable, Sums};
pub(crate) use heights::Heights;
pub use statistics::spread;
use std::cell::OnceCell;
use std::f64::consts::PI;
use unload::{too_many, Contacts, Specimen, Sphere, Summits, MOST_DRAWN};

/// On a sphere with fewer summits about its lowest point Poisson's statistics do not hold.
const FEWEST_ON_SPHERE: f64 = 3.0;
/// The table of the loads of summits reaches so many times as deep as one specimen does.
const TABLED: f64 = 1.5;

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

/// Specimens that are kept from one call to the next, of one seed, and not exact, but to 1e-6.
#[derive(Debug)]
pub(crate) struct Kept {
    all: Vec<Summits>,
    /// A table that reaches as deep as so many contacts of one specimen.
    contacts: f64,
    table: OnceCell<Option<LoadTable>>,
}

impl Kept {
    pub fn new(count: usize, contacts: f64) -> Self {
        let mut all = Vec::new();
        all.resize_with(count, Summits::default);
        Self { all, contacts, table: OnceCell::new() }
    }
}

/// A specimen under a load, in the units of its summits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Standing {
    pub contacts: Contacts,
    /// Sums of its summits, with what neighbours change.
    pub sums: Sums,
    /// Between the mean of the heights and the other surface, in sigma.
    pub separation: f64,
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
        let mut found = Vec::with_capacity(asked.count * loads.len());
        self.stand((asked, MOST_DRAWN), &Heights::of(self), loads, None, &mut |standing, pull_off_force| {
            found.push(standing.map_or(Held::apart(pull_off_force), |standing| {
                let gap = match asked.sphere_radius == 0.0 {
                    true => self.gap_at(standing.separation),
                    false => self.gap_of_lone(standing.separation),
                };
                standing.held(self.units(), gap, pull_off_force)
            }));
        })?;
        Ok(found)
    }
}

impl Surfaces {
    /// Hands over how specimens of these heights stand under loads, each with all loads, in the order of these, and the pull-off force of
    /// each; not at all where it is apart. So many summits may be drawn at most.
    pub(crate) fn stand(
        &self,
        (asked, most_drawn): (Specimens, f64),
        heights: &Heights,
        loads: &[f64],
        kept: Option<&mut Kept>,
        take: &mut dyn FnMut(Option<Standing>, f64),
    ) -> Result<(), Error> {
        let waves = self.params().waviness.height;
        if waves > 0.0 {
            let allowed = "must be 0: single specimens of wavy surfaces are not modelled; ask for the mean";
            return Err(Error::out_of_range("waviness_height", waves, allowed));
        }
        let count = self.units().count;
        if count < 1.0 {
            let allowed = "a specimen needs its number of asperities, 1 or more: give its nominal_area";
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
        let sphere = self.sphere(asked.sphere_radius, heaviest * of_one)?;
        let alike = asked.first as f64 + asked.count as f64;
        let (range, sharper) = (population.range_of_adhesion(), sphere.map_or(0.0, |sphere| sphere.sharper));
        let (several, most, mut drawn) = ((count, sphere), (alike, most_drawn), Summits::default());
        // One that is like the others says where to begin and how many summits are drawn, with all ranges before this one.
        let mut typical = Specimen::new((population, None), heights, several, most, (asked.seed, u64::MAX), &mut drawn);
        let tallest = typical.tallest();
        // Other specimens reach as low as this one, or somewhat lower.
        let tabled = |depth| {
            let deep = TABLED * (depth + range);
            population.load_table(tallest - deep, deep, sharper)
        };
        let (kept, known) = kept.map_or((&mut [][..], None), |Kept { all, contacts, table }| {
            let table = table.get_or_init(|| tabled(tallest - heights.of_hazard(*contacts / count)));
            (&mut all[..], Some(table.as_ref()))
        });
        typical.look_up(known.flatten());
        let from = typical.pressed(-range, heaviest)?;
        let from = typical.unloaded(from, heaviest)?.unwrap_or(0.0);
        let summits = typical.drawn().max(loads.len()) as f64 * alike;
        if summits > most_drawn {
            return Err(too_many(summits));
        }
        let made = if known.is_none() { tabled(from) } else { None };
        let table = known.unwrap_or(made.as_ref());
        let mut found = vec![None; loads.len()];
        for i in 0..asked.count {
            let mut own = Summits::default();
            let (drawn, index) = (kept.get_mut(i).unwrap_or(&mut own), asked.first.wrapping_add(i as u64));
            let mut one = Specimen::new((population, table), heights, several, most, (asked.seed, index), drawn);
            let pull_off = one.pull_off()?;
            found.fill(None);
            let mut approach = Some(one.pressed(from, heaviest)?);
            let mut last = None;
            // Neither is the pull-off force known to the last digit.
            for &k in order.iter().filter(|&&k| loads[k] >= -1.000_001 * pull_off * of_one) {
                match last {
                    Some(j) if loads[j] == loads[k] => found[k] = found[j],
                    _ => {
                        let Some(before) = approach else { break };
                        approach = one.unloaded(before, loads[k] / of_one)?;
                        if let Some(approach) = approach {
                            let at = if known.is_none() { one.exact(approach, loads[k] / of_one)? } else { approach };
                            found[k] = Some(self.standing(&mut one, at, known.is_some())?);
                        }
                    }
                }
                last = Some(k);
            }
            found.iter().for_each(|standing| take(*standing, pull_off * of_one));
        }
        Ok(())
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
                says: "must be set, since a sphere needs the asperities per area",
            });
        }
        let number = 2.0 * PI * radius * height_std * asperity_count / nominal_area;
        if number < FEWEST_ON_SPHERE {
            return refused(radius, "fewer than 3 asperities stand within height_std of the lowest point: take one smooth hill, a specimen of one \
                                    asperity of this radius");
        }
        let touched = pow(0.75 * load * radius / composite_modulus, 2.0 / 3.0);
        if touched > radius * height_std {
            return refused(radius, "under this load the sphere itself flattens, beyond Hertz' radius of (R height_std)^(1/2): take a flat \
                                    specimen of the area pi (a^2 + 1.5 R height_std), with a of Hertz");
        }
        Ok(Some(Sphere { number, sharper: summit_radius / radius }))
    }

    fn standing(&self, one: &mut Specimen, approach: f64, by_table: bool) -> Result<Standing, Error> {
        let contacts = one.contacts(approach, by_table)?;
        // Summits on a sphere have neighbours on one side.
        let count = self.units().count;
        let lone = Sums {
            area: contacts.area / count,
            radius: contacts.radius / count,
            load_slope: -contacts.stiffness / count,
            ..Sums::default()
        };
        let sums = if one.is_flat() { self.population().among_neighbours(lone) } else { lone };
        Ok(Standing { contacts, sums, separation: one.tallest() - approach })
    }
}

impl Standing {
    /// The real area [length^2], and the load of Hertz' contacts of the same radii [force].
    pub(crate) fn area_and_hertz(&self, units: &Units) -> [f64; 2] {
        let Contacts { area, hertz_load, .. } = self.contacts;
        [area * units.area, hertz_load * units.load].map(|all| all / units.count)
    }

    pub(crate) fn held(&self, units: &Units, gap: f64, pull_off_force: f64) -> Held {
        let Self { contacts, sums, .. } = self;
        Held {
            friction_force: contacts.friction * units.force / units.count,
            tangential_stiffness: contacts.radius / sums.psi() * units.stiffness / units.count,
            normal_stiffness: contacts.stiffness / sums.approach_of_planes() * (units.load / units.count)
                / units.length,
            gap,
            contacts: contacts.number,
            pull_off_force,
        }
    }
}

impl Held {
    fn apart(pull_off_force: f64) -> Self {
        let [friction_force, tangential_stiffness, normal_stiffness, contacts] = [0.0; 4];
        Self { friction_force, tangential_stiffness, normal_stiffness, gap: f64::NAN, contacts, pull_off_force }
    }
}
