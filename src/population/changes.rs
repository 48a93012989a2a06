//! What load and friction at a fixed separation change by as the parameters of the surface change.
//!
//! Every change is a sum over the summits, as the slopes are: a group changes the law of one summit, a radius parameter its
//! radius, a parameter of the heights moves it, a slip constant changes its friction. To this comes what moves past the edge
//! of contact and past where attraction sets in. Nothing is taken by differences.

use super::break_away::Edge;
use super::radius::RadiusProfile;
use super::walk::{ContactVisitor, Progress};
use super::{Point, Population};
use crate::asperity::contact::Rates;
use crate::asperity::slip::Slip;
use crate::distribution::Motion;
use crate::elementary::exp;
use crate::error::Error;
use crate::groups::GROUPS;

/// An amplitude that changes no radius: with it panels heed how radii would change with height.
const NO_AMPLITUDE: f64 = 1e-60;

/// A change of the sums per change of a parameter.
#[derive(Debug, Clone, Copy, Default)]
pub struct Change {
    /// Of the load, in E* b^2 per summit.
    pub load: f64,
    /// Of the friction force, in G* b^2 per summit.
    pub friction: f64,
}

/// The changes at one separation from the mean of the heights, or from a point that moves with them.
#[derive(Debug, Clone, Copy, Default)]
pub struct Changes {
    /// By the logarithms of the groups.
    pub by_groups: [Change; GROUPS],
    /// By epsilon and by ln rho of eq (3).
    pub by_radius: [Change; 2],
    /// By the parameters of the heights, as [`Motion`] has them.
    pub by_heights: [Change; 2],
    /// Of the friction by the logarithms of the slip constants.
    pub friction_by_slip: [f64; 4],
}

impl Change {
    fn add(&mut self, weight: f64, of_one: Self) {
        self.load += weight * of_one.load;
        self.friction += weight * of_one.friction;
    }
}

/// How heights move at fixed quantiles; where they do not, by nothing.
struct Heights<'a> {
    motion: Option<Box<dyn Motion + 'a>>,
    of_origin: [f64; 2],
}

impl Heights<'_> {
    /// By each parameter, how a height moves above the origin, and with it.
    fn at(&self, z: f64) -> [(f64, f64); 2] {
        let rises = self.motion.as_ref().map_or([0.0; 2], |motion| motion.above_origin(z));
        std::array::from_fn(|i| (rises[i], self.of_origin[i]))
    }
}

/// Adds up what summits in contact contribute.
struct Adding<'a> {
    population: &'a Population,
    heights: &'a Heights<'a>,
    changes: Changes,
}

impl ContactVisitor for Adding<'_> {
    fn contacts(&mut self, fraction: f64, point: &Point, slip: &Slip) {
        let Point { z, g_rate, contact } = *point;
        let Population { law, radius, .. } = self.population;
        let changes = &mut self.changes;
        let friction = slip.friction(&contact);
        let s_by_overlap = contact.s_by_overlap();
        let load_by_overlap = contact.by_s.load * s_by_overlap;
        let friction_by_overlap = friction.rate(&contact.by_s) * s_by_overlap;
        let at_fixed_overlap = |rates: Rates| Change {
            load: rates.load - load_by_overlap * rates.overlap,
            friction: friction.rate(&rates) - friction_by_overlap * rates.overlap,
        };
        let by_g = at_fixed_overlap(contact.by_g);
        for (change, rates) in changes.by_groups.iter_mut().zip(law.by_groups(contact.parameter, radius.factor(z))) {
            change.add(fraction, at_fixed_overlap(rates));
        }
        for (change, g_change) in changes.by_radius.iter_mut().zip(radius.changes(z)) {
            change.add(fraction * g_change, by_g);
        }
        for (change, (rise, of_origin)) in changes.by_heights.iter_mut().zip(self.heights.at(z)) {
            let g_change = g_rate * (rise + of_origin);
            let load = load_by_overlap * rise + by_g.load * g_change;
            change.add(fraction, Change { load, friction: friction_by_overlap * rise + by_g.friction * g_change });
        }
        let of_stress = friction.force - friction.by_hertz_load * contact.hertz_load;
        for (change, log_change) in changes.friction_by_slip.iter_mut().zip(slip.log_changes(contact.radius)) {
            *change += fraction * of_stress * log_change;
        }
    }
}

impl Population {
    /// The changes at a separation, by radius and by heights where they are asked for, else 0. The parameters of the heights
    /// move the origin of heights too, and the separation with it.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if the sums take more panels than there may be.
    pub fn changes(&self, separation: f64, with_radius: bool, with_heights: bool) -> Result<Changes, Error> {
        let heights = match self.heights.motion().filter(|_| with_heights) {
            Some(motion) => Heights { of_origin: motion.of_origin(), motion: Some(motion) },
            None => Heights { of_origin: [0.0; 2], motion: None },
        };
        let heeds_radius = with_radius && self.radius.is_constant();
        let amplitude = if heeds_radius { NO_AMPLITUDE } else { self.radius.amplitude };
        let radius = RadiusProfile { amplitude, ..self.radius };
        // A table of nodes would cost more than these sums.
        let varied = Self { radius, ..self.without_tables() };
        varied.summed_changes(separation, &heights)
    }

    fn summed_changes(&self, separation: f64, heights: &Heights) -> Result<Changes, Error> {
        let edge = self.edge(separation);
        let mut adding = Adding { population: self, heights, changes: Changes::default() };
        if let Some(walk) = self.contacts(separation, &edge) {
            self.walk(&walk, &mut Progress::default(), &mut adding)?;
        }
        let mut changes = adding.changes;
        self.add_attraction_changes(&mut changes, separation, &edge, heights)?;
        if self.has_summits_at(&edge) {
            self.add_edge_changes(&mut changes, separation, &edge, heights);
        }
        Ok(changes)
    }

    /// Adds what summits gain and lose that move past the edge of contact.
    fn add_edge_changes(&self, changes: &mut Changes, separation: f64, edge: &Edge, heights: &Heights) {
        let Point { z, g_rate, contact } = edge.point;
        let below = self.attraction_at(z - separation, z).map_or(0.0, |attracted| attracted.load);
        let lost = Change { load: contact.load - below, friction: self.slip.friction(&contact).force };
        let density = exp(self.heights.log_density(z));
        let add = |change: &mut Change, edge_rise: f64| change.add(-density * edge_rise, lost);
        // At break-away du/ds = 0, so that changes at fixed s are those of the overlap there.
        let of_law = self.law.by_groups(contact.parameter, self.radius.factor(z));
        for (change, rates) in changes.by_groups.iter_mut().zip(of_law) {
            add(change, rates.overlap / edge.rate);
        }
        for (change, g_change) in changes.by_radius.iter_mut().zip(self.radius.changes(z)) {
            add(change, contact.by_g.overlap * g_change / edge.rate);
        }
        for (change, (rise, of_origin)) in changes.by_heights.iter_mut().zip(heights.at(z)) {
            add(change, contact.by_g.overlap * g_rate * of_origin / edge.rate - rise);
        }
    }

    /// Adds the summits that attract.
    fn add_attraction_changes(
        &self,
        changes: &mut Changes,
        separation: f64,
        edge: &Edge,
        heights: &Heights,
    ) -> Result<(), Error> {
        let Some(range) = self.attracted_range(separation, edge) else { return Ok(()) };
        let law = range.law;
        if range.sets_in {
            let (z, overlap) = range.from;
            let gain = exp(self.heights.log_density(z)) * law.at_overlap(overlap, self.radius.factor(z)).load;
            for (change, reach_change) in changes.by_groups.iter_mut().zip(law.reach_changes()) {
                change.load += gain * reach_change;
            }
            for (change, (rise, _)) in changes.by_heights.iter_mut().zip(heights.at(z)) {
                change.load += gain * rise;
            }
        }
        self.visit_attracted(&range, separation, |z, overlap, fraction| {
            let (g, g_rate) = self.radius.at(z);
            let (by_groups, by_g) = law.load_changes(overlap, g);
            for (change, by_group) in changes.by_groups.iter_mut().zip(by_groups) {
                change.load += fraction * by_group;
            }
            for (change, g_change) in changes.by_radius.iter_mut().zip(self.radius.changes(z)) {
                change.load += fraction * by_g * g_change;
            }
            let by_overlap = law.at_overlap(overlap, g).load_by_overlap;
            for (change, (rise, of_origin)) in changes.by_heights.iter_mut().zip(heights.at(z)) {
                change.load += fraction * (by_overlap * rise + by_g * g_rate * (rise + of_origin));
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{of, surface, table, yielding, FOLD, HERTZ, WEAK};
    use super::*;
    use crate::groups::Groups;
    use crate::params::{HeightFamily, Params};

    /// The derivative of load and friction at a separation that moves, by what makes a population.
    fn secants(step: f64, varied: impl Fn(f64) -> (Population, f64)) -> Change {
        let at = |change: f64| {
            let (population, separation) = varied(change);
            let sums = population.at_separation(separation);
            [sums.load(), sums.friction]
        };
        let secant = |step: f64| {
            let [after, before] = [at(step), at(-step)];
            [0, 1].map(|i| (after[i] - before[i]) / (2.0 * step))
        };
        let (narrow, wide) = (secant(step), secant(2.0 * step));
        let [load, friction] = [0, 1].map(|i| (4.0 * narrow[i] - wide[i]) / 3.0);
        Change { load, friction }
    }

    /// With the height distribution of its shape parameters, which are moved by so much.
    fn reshaped(params: &Params, which: usize, change: f64) -> Params {
        let (more_skew, more_kurtosis) = if which == 0 { (change, 0.0) } else { (0.0, change) };
        let heights = match &params.heights {
            HeightFamily::Weibull { shape } => HeightFamily::Weibull { shape: shape + more_skew },
            HeightFamily::Gaussian => HeightFamily::Johnson { skew: more_skew, kurtosis: 3.0 + more_kurtosis },
            HeightFamily::Johnson { skew, kurtosis } => {
                HeightFamily::Johnson { skew: skew + more_skew, kurtosis: kurtosis + more_kurtosis }
            }
            table => table.clone(),
        };
        Params { heights, ..params.clone() }
    }

    fn surfaces() -> Vec<Params> {
        let weibull = HeightFamily::Weibull { shape: 2.2 };
        let johnson = HeightFamily::Johnson { skew: 0.5, kurtosis: 4.0 };
        let mut film = surface(WEAK, weibull.clone(), [0.3, 0.7]);
        film.pressure_coefficient = 0.1;
        // All regimes of the slip law have contacts.
        (film.slip.radius_1, film.slip.radius_2, film.slip.stress_2) = (20.0, 60.0, 0.007);
        vec![
            surface(WEAK, HeightFamily::Gaussian, [0.0, 1.0]),
            surface(FOLD, weibull, [0.0, 1.0]),
            surface(FOLD, johnson, [-0.4, 0.5]),
            surface(WEAK, table(), [0.6, 0.8]),
            // Heights measured from their upper end, which moves.
            surface(WEAK, HeightFamily::Johnson { skew: -0.9, kurtosis: 3.2 }, [0.6, 0.8]),
            yielding(HERTZ, HeightFamily::Gaussian, [0.3, 0.7]),
            film,
        ]
    }

    #[test]
    fn changes_are_secants_of_populations() {
        let mut moving = 0;
        for params in surfaces() {
            let (groups, heights, radius) = params.surface().expect("a surface");
            let new = |groups: &Groups, radius| {
                Population::new(groups, params.slip_law(), heights.clone(), radius, true).expect("a population")
            };
            let population = of(&params);
            for above_mean in [-1.3, 0.4, 1.1] {
                let separation = above_mean - heights.origin();
                let sums = population.at_separation(separation);
                let changes = population.changes(separation, true, true).expect("changes");
                let check = |what: &str, which: usize, change: Change, expected: Change| {
                    let load = (change.load - expected.load).abs() / (sums.hertz_load + expected.load.abs());
                    let friction =
                        (change.friction - expected.friction).abs() / (sums.friction + expected.friction.abs());
                    let error = load.max(friction);
                    assert!(
                        error < 3e-8,
                        "{what} {which} at {separation} of {params:?}: {change:?}, not {expected:?}: {error:e}"
                    );
                };
                for which in 0..GROUPS {
                    let expected = secants(2e-4, |change| (new(&groups.grown(which, change), radius), separation));
                    check("group", which, changes.by_groups[which], expected);
                }
                let by_amplitude = secants(2e-4, |change| {
                    (new(&groups, RadiusProfile { amplitude: radius.amplitude + change, ..radius }), separation)
                });
                check("amplitude", 0, changes.by_radius[0], by_amplitude);
                let by_rate = secants(2e-4, |change| {
                    (new(&groups, RadiusProfile { rate: radius.rate * change.exp(), ..radius }), separation)
                });
                check("rate", 1, changes.by_radius[1], by_rate);
                let motion = heights.motion();
                let of_origin = motion.as_ref().map_or([0.0; 2], |motion| motion.of_origin());
                // On either side of the kurtosis of the Gaussian Johnson's curves bend differently.
                moving += usize::from(of_origin != [0.0; 2]);
                let last = if params.heights == HeightFamily::Gaussian { 1 } else { 2 };
                for which in 0..last {
                    let expected = secants(1e-3, |change| (of(&reshaped(&params, which, change)), separation));
                    check("heights", which, changes.by_heights[which], expected);
                }
                for which in 0..4 {
                    let expected = secants(2e-4, |change| {
                        let mut params = params.clone();
                        let constants = &mut params.slip;
                        let constant = match which {
                            0 => &mut constants.radius_1,
                            1 => &mut constants.stress_1,
                            2 => &mut constants.radius_2,
                            _ => &mut constants.stress_2,
                        };
                        *constant *= change.exp();
                        (of(&params), separation)
                    });
                    check("slip", which, Change { load: 0.0, friction: changes.friction_by_slip[which] }, expected);
                }
            }
        }
        assert!(moving > 0);
    }
}
