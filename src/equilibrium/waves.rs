//! Waves on which the roughness stands: at each place the rough law holds at the gap of the place, and the half-space below gives way
//! with one wave number,
//!
//! ```text
//! u - c p(u) = D - w        P = <p>        gap = D + c <p> = <u>        S/(1 + l S) = <s/(1 + l s)>
//! ```
//!
//! with w the height of the place in sigma, p the load in E* b^2 per summit, s the sum of the contact radii over psi, and l = 2 E* c. A
//! state is told by the separation of the summits at places of the mean height.

use crate::numerics::quadrature;
use crate::numerics::root::MOST_STEPS;
use crate::population::Sums;
use std::f64::consts::{PI, SQRT_2};
use std::fmt::Debug;
use std::sync::Arc;

/// Places of ridges for each such height, in sigma.
const RIDGES: f64 = 24.0;
const LOW_RIDGES: f64 = 4.0;
/// Hills take a panel of places more for each such height.
const LOW_HILLS: f64 = 2.0;
/// Separations of places are found to this part of 1 or of them: the next step of Newton's method would be rounding.
const LAST_STEP: f64 = 1e-7;
/// Places that bear less than this part of the load count for nothing but sums.
const NEGLIGIBLE: f64 = 1e-9;
/// Where the pressure is less than this part of that at the crests there is no contact.
const NOTHING: f64 = 1e-20;

/// The surface without its waves, as it is compiled.
pub trait Even: Debug + Send + Sync {
    /// Load and gap at a separation, with their slopes.
    fn local(&self, separation: f64) -> Local;
    /// The quantities of the law at a separation, with their slopes: the friction force, and the contact radii over psi.
    fn quantities(&self, separation: f64) -> [(f64, f64); 2];
    /// By how much less than contacts that stick those under a load resist a displacement, over strength by stiffness: the force over
    /// the strength, and the part of the stiffness.
    fn lost_to_slip(&self, load: f64, displacement: f64) -> [f64; 2];
}

/// A place of the surface, each number with its slope by separation.
#[derive(Debug, Clone, Copy, Default)]
pub struct Local {
    pub separation: f64,
    pub gap: (f64, f64),
    pub load: (f64, f64),
}

/// Part of the surface at one separation.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    pub part: f64,
    pub separation: f64,
    /// What its contacts are displaced by over what all are on average.
    pub displaced: f64,
    pub sums: Sums,
}

/// Waves and the surface that they carry.
#[derive(Debug, Clone)]
pub struct Waves {
    even: Arc<dyn Even>,
    /// Heights in sigma, from the crests down, with their part of the surface.
    places: Vec<(f64, f64)>,
    /// c, in sigma per E* b^2 and summit.
    compliance: f64,
    /// l, per b.
    spread_compliance: f64,
}

/// Heights of a root mean square height, from the crests down, and their part of the surface: cos x by the places of Gauss and Chebyshev.
pub fn ridges(height: f64) -> Vec<(f64, f64)> {
    let count = RIDGES * (height / LOW_RIDGES).max(1.0).ceil();
    let at = |k: usize| (SQRT_2 * height * libm::cos((k as f64 + 0.5) * PI / count), 1.0 / count);
    (0..count as usize).map(at).collect()
}

/// The same of cos x + cos y, whose density at v is 1/(2 pi M(1, v/2)), with Gauss' arithmetic-geometric mean M. Towards v = 0, where it
/// is infinite, places gather: v = 2 t^3.
pub fn hills(height: f64) -> Vec<(f64, f64)> {
    let panels = (height / LOW_HILLS).max(1.0).ceil();
    let panel = |k: usize| quadrature::nodes(k as f64 / panels, (k as f64 + 1.0) / panels);
    let place =
        |(t, weight): (f64, f64)| (2.0 * t * t * t, 3.0 * t * t * weight / (PI * mean_of_gauss(1.0, t * t * t)));
    let troughs: Vec<(f64, f64)> = (0..panels as usize).flat_map(panel).map(place).collect();
    let crests = troughs.iter().rev().map(|&(v, part)| (height * v, part));
    crests.chain(troughs.iter().map(|&(v, part)| (-height * v, part))).collect()
}

fn mean_of_gauss(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 1e-15 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

impl Waves {
    /// Places of a compliance, of contacts that have this elastic stiffness per radius.
    pub fn new(even: Arc<dyn Even>, places: Vec<(f64, f64)>, compliance: f64, stiffness_of_radius: f64) -> Self {
        Self { even, places, compliance, spread_compliance: compliance * stiffness_of_radius }
    }

    /// The height of the crests.
    pub fn highest(&self) -> f64 {
        self.places[0].0
    }

    /// The sums, whose slopes are by separation, as a mean over places of what each has, and the gap.
    pub fn mean(&self, separation: f64, of: impl Fn(&Local) -> Sums) -> (Sums, f64) {
        let base = self.even.local(separation);
        let stiffness = |gap_rate: f64, load_slope: f64| gap_rate - self.compliance * load_slope;
        let moves = stiffness(base.gap.1, base.load.1);
        let (mut mean, mut gap, mut gap_rate, mut spread, mut spread_slope) = (Sums::default(), 0.0, 0.0, 0.0, 0.0);
        let touching = self.each(&base, |part, local| {
            let sums = of(local);
            let rate = moves / stiffness(sums.approach_of_planes(), sums.load_slope);
            mean.add(&sums, part, rate);
            gap += part * local.gap.0;
            gap_rate += part * rate * sums.approach_of_planes();
            let (s, slope) = sums.spread_radius();
            let share = 1.0 / (1.0 + self.spread_compliance * s);
            spread += part * s * share;
            spread_slope += part * rate * slope * share * share;
        });
        for &(height, part) in &self.places[touching..] {
            gap += part * (base.gap.0 - self.compliance * base.load.0 - height);
            gap_rate += part * moves;
        }
        mean.given_way = 1.0 - gap_rate;
        let share = 1.0 / (1.0 - self.spread_compliance * spread);
        mean.spread_over((spread * share, spread_slope * share * share));
        (mean, gap)
    }

    /// The same of what is compiled: load, friction, contact radii over psi, and gap.
    pub fn compiled(&self, separation: f64) -> (Sums, f64) {
        self.mean(separation, |local| {
            let [friction, spread] = self.even.quantities(local.separation);
            Sums {
                load_contacting: local.load.0,
                load_slope: local.load.1,
                friction: friction.0,
                friction_slope: friction.1,
                radius: spread.0,
                radius_slope: spread.1,
                given_way: 1.0 - local.gap.1,
                ..Sums::default()
            }
        })
    }

    /// The places that bear load, with the sums that each has.
    pub fn places(&self, separation: f64, of: impl Fn(f64) -> Sums) -> Vec<Place> {
        let mut found = Vec::with_capacity(self.places.len());
        self.each(&self.even.local(separation), |part, local| found.push((part, *local)));
        let crest = found[0];
        let load: f64 = found.iter().map(|(part, local)| part * local.load.0).sum();
        found.retain(|(part, local)| part * local.load.0 > NEGLIGIBLE * load);
        if found.is_empty() {
            // Lighter than what is compiled, crests bear all.
            found.push(crest);
        }
        let (mut radius, mut moved) = (0.0, 0.0);
        let mut places: Vec<_> = found
            .into_iter()
            .map(|(part, Local { separation, .. })| {
                let sums = of(separation);
                let displaced = 1.0 / (sums.psi() * (1.0 + self.spread_compliance * sums.spread_radius().0));
                radius += part * sums.radius;
                moved += part * displaced * sums.radius;
                Place { part, separation, displaced, sums }
            })
            .collect();
        if moved > 0.0 {
            places.iter_mut().for_each(|place| place.displaced *= radius / moved);
        }
        places
    }

    /// The pressure at places, as the mean over the load, over that of the whole surface.
    pub fn pressing(&self, separation: f64) -> f64 {
        let (mut load, mut square) = (0.0, 0.0);
        self.each(&self.even.local(separation), |part, local| {
            (load, square) = (load + part * local.load.0, square + part * local.load.0 * local.load.0);
        });
        if load > 0.0 {
            square / (load * load)
        } else {
            1.0
        }
    }

    /// As [`Population::lost_to_slip`](crate::population::Population::lost_to_slip).
    pub fn lost_to_slip<const N: usize>(&self, separation: f64, force_over_radius: [f64; N]) -> Option<[[f64; 3]; N]> {
        let (mut strength, mut stiffness, mut lost) = (0.0, 0.0, [[0.0; 2]; N]);
        self.each(&self.even.local(separation), |part, local| {
            let [(friction, _), (spread, _)] = self.even.quantities(local.separation);
            let resists = spread / (1.0 + self.spread_compliance * spread);
            (strength, stiffness) = (strength + part * friction, stiffness + part * resists);
            for (lost, force) in lost.iter_mut().zip(force_over_radius).filter(|_| friction > 0.0) {
                let [force, given_up] = self.even.lost_to_slip(local.load.0, force * resists / friction);
                *lost = [lost[0] + part * friction * force, lost[1] + part * resists * given_up];
            }
        });
        let of =
            |i: usize| [force_over_radius[i] * stiffness / strength, lost[i][0] / strength, lost[i][1] / stiffness];
        (strength > 0.0).then(|| std::array::from_fn(of))
    }

    /// The separation that places of the mean height have where those of a height have another: where a place has a kink the mean has one.
    pub fn separations_at(&self, separation: f64) -> impl Iterator<Item = f64> + '_ {
        let base = self.even.local(separation);
        self.places.iter().map(move |&(height, _)| self.shifted(&base, height, separation + height).separation)
    }

    /// Hands over each place that touches with its part of the surface, where places of the mean height are so; how many those are.
    fn each(&self, base: &Local, mut take: impl FnMut(f64, &Local)) -> usize {
        let mut least = 0.0;
        let mut before = Local { separation: base.separation - self.highest(), gap: (0.0, 1.0), ..Local::default() };
        let mut last = self.highest();
        for (i, &(height, part)) in self.places.iter().enumerate() {
            let guess = before.separation + (last - height) / (before.gap.1 - self.compliance * before.load.1);
            (before, last) = (self.shifted(base, -height, guess), height);
            if before.load.0 < least {
                return i;
            }
            least = least.max(NOTHING * before.load.0);
            take(part, &before);
        }
        self.places.len()
    }

    /// The place at which u - c p is by so much more than at another, from a guess of its separation. It is concave: Newton's method
    /// comes from below.
    fn shifted(&self, base: &Local, shift: f64, guess: f64) -> Local {
        let mut separation = guess;
        for _ in 0..MOST_STEPS {
            let Local { gap, load, .. } = self.even.local(separation);
            let off = gap.0 - base.gap.0 - self.compliance * (load.0 - base.load.0) - shift;
            let step = -off / (gap.1 - self.compliance * load.1);
            separation += step;
            if step.abs() <= LAST_STEP * (1.0 + separation.abs()) {
                return Local {
                    separation,
                    gap: (gap.0 + step * gap.1, gap.1),
                    load: (load.0 + step * load.1, load.1),
                };
            }
        }
        Local { separation: f64::NAN, ..*base }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_the_whole_surface_and_have_its_moments() {
        for height in [0.3, 30.0] {
            for (places, fourth) in [(ridges(height), 1.5), (hills(height), 2.25)] {
                let moment = |power: i32| places.iter().map(|(v, part)| part * (v / height).powi(power)).sum::<f64>();
                for (power, expected) in [(0, 1.0), (1, 0.0), (2, 1.0), (3, 0.0), (4, fourth)] {
                    assert!((moment(power) - expected).abs() < 1e-7, "{power}: {}", moment(power));
                }
                assert!(places.windows(2).all(|pair| pair[0].0 > pair[1].0));
            }
        }
    }
}
