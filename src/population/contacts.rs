//! The summits in contact at a separation, told apart by the radius of their contact: its mean, its largest value, and
//! how many there are in each regime of slip.
//!
//! Walked anew with every panel, for exact states only: the sums that a law is compiled from need none of this.

use super::break_edges::Edge;
use super::density::Density;
use super::panels::{Sink, MOST_PANELS};
use super::point::Point;
use super::{ends, Population};
use crate::asperity::maugis::Contact;
use crate::elementary::log;
use crate::gauss_legendre;
use crate::root;
use crate::surface::heights::Heights;

/// Contact radii, in b, and their share of the regimes of slip.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Contacts {
    /// Mean contact radius.
    pub mean_radius: f64,
    /// Contact radius of the tallest of so many summits as there are; not below the mean.
    pub largest_radius: f64,
    /// Fractions of the contacts up to the first kink of the slip law, between the two, and from the second on.
    pub by_regime: [f64; 3],
}

/// Heights between which all summits are in contact.
struct Range {
    lower: (f64, Option<Edge>),
    upper: (f64, Option<Edge>),
}

/// Counts contacts, and keeps every contact radius that it sees with its height.
struct Counting<'a> {
    population: &'a Population,
    density: &'a Density<'a>,
    count: f64,
    radius: f64,
    by_regime: [f64; 3],
    seen: Vec<(f64, f64)>,
}

impl Sink for Counting<'_> {
    /// The largest radius may be there.
    const EXTREMA: bool = true;

    fn log_scale(&self) -> f64 {
        self.density.log_scale
    }

    fn panel(&mut self, from: &Point, to: &Point, _by_height: bool) {
        self.seen.extend([from, to].map(|point| (point.z, point.contact.radius)));
    }

    fn node(&mut self, z: f64, weight: f64, contact: &Contact) {
        self.summits(z, weight * self.density.at(z, contact.overlap), contact);
    }

    fn summits(&mut self, z: f64, weight: f64, contact: &Contact) {
        let [first, second] = self.population.slip.kinks();
        let regime = usize::from(contact.radius > first) + usize::from(contact.radius >= second);
        self.count += weight;
        self.radius += weight * contact.radius;
        self.by_regime[regime] += weight;
        self.seen.push((z, contact.radius));
    }

    fn out_of_panels(&mut self) {
        self.count = f64::NAN;
    }
}

impl Population {
    /// The contacts at a separation, of which `number` are expected on the surface; all 0 where there are none. `None` if
    /// they cannot be counted in as many panels as there may be.
    pub fn contacts(&self, separation: f64, number: f64) -> Option<Contacts> {
        let ranges = self.contact_ranges(separation);
        let Some(&Range { lower: (lowest, edge), .. }) = ranges.first() else { return Some(Contacts::default()) };
        let overlap = edge.filter(|edge| edge.z == lowest).map_or(lowest - separation, |edge| edge.contact.overlap);
        let density = &Density::above(&self.heights, lowest, overlap, separation);
        let mut counting =
            Counting { population: self, density, count: 0.0, radius: 0.0, by_regime: [0.0; 3], seen: Vec::new() };
        for Range { lower: (lower, lower_edge), upper: (upper, upper_edge) } in &ranges {
            let (lower, upper) = self.heights.worth_summing(*lower, *upper);
            if lower < upper {
                self.walk_contacts(
                    separation,
                    (lower, lower_edge.as_ref()),
                    (upper, upper_edge.as_ref()),
                    &mut counting,
                );
            }
        }
        let Counting { count, radius, by_regime, seen, .. } = counting;
        if count.is_nan() {
            return None;
        }
        if count == 0.0 {
            return Some(Contacts::default());
        }
        let mean_radius = radius / count;
        let mut largest_radius = mean_radius;
        if number > 1.0 {
            let exceeding = count / (number + 1.0);
            let (lower, upper) = self.heights.worth_summing(lowest, f64::INFINITY);
            let excess = |z: f64| log((self.exceedance(z, separation, density) / exceeding).max(1e-100));
            let tallest = root::bracketed(excess, lower, upper);
            let is_within = |range: &Range| range.lower.0 <= tallest && tallest <= range.upper.0;
            let there = ranges.iter().any(is_within).then(|| self.point_cold(separation, tallest).contact.radius);
            let below = seen.iter().filter(|(z, _)| *z <= tallest).map(|(_, radius)| *radius);
            largest_radius = below.chain(there).fold(mean_radius, f64::max);
        }
        Some(Contacts { mean_radius, largest_radius, by_regime: by_regime.map(|weight| weight / count) })
    }

    /// Where summits are in contact, from low to high.
    fn contact_ranges(&self, separation: f64) -> Vec<Range> {
        let edges = self.edges.at_separation(&self.maugis, &self.radius, separation);
        let foot = self.heights.foot();
        let mut contact = self.lowest_are_in_contact(&edges, separation);
        let mut ranges = Vec::new();
        let mut lower = (foot, None);
        for edge in edges.iter().map(Some).chain([None]) {
            let upper = (edge.map_or(f64::INFINITY, |edge| edge.z), edge.copied());
            if contact && lower.0 < upper.0 {
                ranges.push(Range { lower, upper });
            }
            contact = !contact;
            lower = (upper.0.max(foot), upper.1);
        }
        ranges
    }

    /// The fraction of all summits that are higher, on the scale of a density.
    fn exceedance(&self, z: f64, separation: f64, density: &Density) -> f64 {
        if let Heights::Ends(ends) = &self.heights {
            return ends::mass_above(ends, z, density.log_scale);
        }
        let (mut z, upper) = self.heights.worth_summing(z, f64::INFINITY);
        let mut fraction = 0.0;
        for _ in 0..MOST_PANELS {
            if z >= upper {
                break;
            }
            let length = self.without_remnant(self.heights.smooth_length(z, density.log_scale), upper - z);
            fraction += gauss_legendre::nodes(0.0, length)
                .map(|(rise, weight)| weight * density.at(z + rise, z + rise - separation))
                .sum::<f64>();
            z += length;
        }
        fraction
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asperity::maugis::tests::EVALUATIONS;
    use crate::params::{HeightFamily, Params};
    use crate::surface::heights::UNDERFLOW;

    /// Surfaces from all over their parameters, by multiples of irrational numbers, which fill a space evenly.
    fn surface(number: u32) -> Option<Population> {
        let part = |k: i32| (f64::from(number) * 1.05_f64.powi(-k)).fract();
        let log = |k: i32, from: f64, to: f64| from * (to / from).powf(part(k));
        let skew = 6.0 * (part(1) - 0.5) * part(2);
        let johnson = |more: f64| HeightFamily::Johnson { skew, kurtosis: (1.0 + skew * skew) * (1.0 + more) };
        let (height, density) = ([-3.0, -1.0, 0.0, 1.0, 1.5], [0.0, 1.0, 0.1, 1.0, 0.0]);
        let heights = match number % 6 {
            0 => HeightFamily::Gaussian,
            1 => HeightFamily::Weibull { shape: log(3, 1.01, 200.0) },
            2 => HeightFamily::Tabulated { height: height.to_vec().into(), density: density.to_vec().into() },
            3 => johnson(log(3, 0.01, 100.0)),
            _ => johnson(log(3, 1e-3, 1.0)),
        };
        let radius_amplitude = [0.0, 1.0, -1.0, 2.0 * part(4) - 1.0, 2.0 * part(4) - 1.0][number as usize % 5];
        let gamma = if part(5) < 0.3 { 0.0 } else { log(6, 1e-7, 1.0) };
        let mut params = Params { heights, radius_amplitude, radius_rate: log(7, 1e-3, 100.0), ..Params::default() };
        params.set_dimensionless(log(8, 1e-4, 1.0), log(9, 1.0, 1e7), gamma, log(10, 0.05, 20.0), 0.3).ok()?;
        let (groups, heights, radius) = params.surface().ok()?;
        Some(Population::new(&groups, params.slip, heights, radius, true))
    }

    impl Population {
        /// Where summits that are not in contact attract, from low to high.
        fn attraction_ranges(&self, separation: f64, contacts: &[Range]) -> Vec<(f64, f64)> {
            let Some(law) = &self.attraction else { return Vec::new() };
            let mut gaps = Vec::new();
            let mut lower = self.heights.foot().max(separation - law.reach);
            for (from, to) in contacts.iter().map(|range| (range.lower.0, range.upper.0)).chain([(f64::INFINITY, 0.0)])
            {
                let gap = self.heights.worth_summing(lower, from);
                gaps.extend(self.where_attraction_exists(gap.0, gap.1));
                lower = lower.max(to);
            }
            gaps
        }
    }

    /// However panels are laid, they count as many summits in contact, and as many that attract, as there are between the
    /// ends of contact and attraction.
    #[test]
    fn summits_are_counted_as_there_are_heights() {
        let (mut in_contact, mut attracted) = (0, 0);
        for (number, population) in (0..250).filter_map(|number| Some((number, surface(number)?))) {
            let part = |k: i32| (f64::from(number) * 1.03_f64.powi(-k)).fract();
            let far = population.farthest() * part(4);
            for separation in [-10f64.powf(7.0 * part(1)), 4.0 * (part(2) - 0.5), 4.0 * (part(3) - 0.5), far] {
                let separation = separation - population.heights.origin();
                let sums = population.at_separation(separation);
                assert!(sums.are_known(), "surface {number} at {separation}");
                let contacts = population.contact_ranges(separation);
                let gaps = population.attraction_ranges(separation, &contacts);
                let (first, edge) = contacts.first().map_or((f64::INFINITY, None), |range| range.lower);
                let (lowest, overlap) = match (gaps.first(), edge) {
                    (Some(&(gap, _)), _) if gap < first => (gap, gap - separation),
                    (_, Some(edge)) if edge.z == first => (first, edge.contact.overlap),
                    _ => (first, first - separation),
                };
                if lowest == f64::INFINITY {
                    continue;
                }
                let density = &Density::above(&population.heights, lowest, overlap, separation);
                if density.log_scale < UNDERFLOW {
                    continue;
                }
                let scale = (density.log_scale - sums.log_scale).exp();
                let above = |z: f64| match z < f64::INFINITY {
                    true => scale * population.exceedance(z, separation, density),
                    false => 0.0,
                };
                let contacts = contacts.iter().map(|range| (range.lower.0, range.upper.0)).collect();
                for (name, found, ranges) in
                    [("contacts", sums.contacting, contacts), ("attracted", sums.attracted, gaps)]
                {
                    let expected: f64 = ranges.iter().map(|&(lower, upper)| above(lower) - above(upper)).sum();
                    let error = (found - expected).abs() / above(lowest).max(1e-250);
                    assert!(
                        error < 5e-11,
                        "{name} of surface {number} at {separation}: {found}, not {expected}: {error:e}"
                    );
                    *(if name == "contacts" { &mut in_contact } else { &mut attracted }) += usize::from(found > 0.0);
                }
            }
        }
        assert!(in_contact > 500 && attracted > 200, "{in_contact}, {attracted}");
    }

    /// The population of a Johnson curve of a skew and of so much more kurtosis than the least.
    fn johnson(
        (skew, more): (f64, f64),
        [alpha, beta, gamma, b_over_h]: [f64; 4],
        (radius_amplitude, radius_rate): (f64, f64),
    ) -> Population {
        let heights = HeightFamily::Johnson { skew, kurtosis: skew * skew + 1.0 + more };
        let mut params = Params { heights, radius_amplitude, radius_rate, ..Params::default() };
        params.set_dimensionless(alpha, beta, gamma, b_over_h, 0.3).expect("groups");
        super::super::tests::of(&params)
    }

    /// Where the summits that gather at an end just lose contact or attraction, rounding says how many have: but each is
    /// counted once.
    #[test]
    fn summits_that_gather_at_an_end_part_there() {
        for (moments, groups, radius) in [
            ((0.272, 0.0217), [0.0048, 3.36, 0.283, 0.332], (-0.42, 4.1)),
            ((0.7375, 0.0261), [0.0048, 355.0, 0.0267, 0.41], (0.0, 1.0)),
            ((-0.603, 1e-9), [1e-4, 191.0, 0.00234, 4.77], (-1.0, 3.57)),
            ((0.3, 1e-4), [0.01, 20.0, 0.02, 0.5], (0.6, 0.5)),
            ((0.3, 0.21), [0.01, 1e3, 1e-3, 1.0], (0.0, 1.0)),
            // The lowest summits have next to no radius: the load is that of the others.
            (
                (1.91961669921875, 0.008822481593),
                [3.54604018e-4, 21.725002689, 0.086138226, 1.24591612],
                (1.0, 30.0130534),
            ),
        ] {
            let population = johnson(moments, groups, radius);
            let Heights::Ends(ends) = &population.heights else { panic!("heights that gather") };
            for parting in population.partings() {
                let at = |step: f64| population.at_separation(parting + step * parting.abs().max(1.0));
                let before = at(-1e-8);
                for step in [-1e-9, -1e-11, -1e-13, -4e-15, -1e-15, -4e-16, 0.0, 4e-16, 1e-15] {
                    let sums = at(step);
                    for (load, expected, counted, all) in [
                        (sums.load_contacting, before.load_contacting, sums.contacting, before.contacting),
                        (sums.load_attracted, before.load_attracted, sums.attracted, before.attracted),
                    ] {
                        let near = (load - expected).abs() <= 1e-3 * expected.abs();
                        assert!(
                            near || counted != all && (counted / all - 1.0).abs() > 1e-3,
                            "{moments:?}, {step:e}: {load:e}, not {expected:e}"
                        );
                    }
                }
                for step in [-1e-6, -1e-8, -1e-10, -1e-13, -1e-15, 0.0, 1e-15, 1e-13, 1e-10, 1e-8, 1e-6] {
                    let separation = parting + step * parting.abs().max(1.0);
                    EVALUATIONS.set(0);
                    let sums = population.at_separation(separation);
                    let count = EVALUATIONS.get();
                    if let Some(law) = population.attraction_of(population.radius.factor(ends.ends()[0])) {
                        let all = super::super::ends::mass_above(ends, separation - law.reach, sums.log_scale);
                        let counted = sums.contacting + sums.attracted;
                        assert!((counted / all - 1.0).abs() < 1e-12, "{moments:?}, {step:e}: {counted} of {all}");
                    }
                    for part in [sums.contacting, sums.attracted] {
                        assert!((0.0..1.0 + 1e-12).contains(&part), "{moments:?}, {step:e}: {sums:?}");
                    }
                    assert!(count < 10_000, "{moments:?}, {step:e}: {count} evaluations");
                    assert!(population.contacts(separation, 1e3).is_some(), "{moments:?}, {step:e}");
                }
            }
        }
    }

    #[test]
    fn contacts_that_run_out_of_panels_are_not_known() {
        let population = johnson((0.3, 2.1), [0.01, 1e3, 1e-3, 1.0], (0.0, 1.0));
        let density = &Density::above(&population.heights, -1.0, 1.0, -2.0);
        let mut counting = Counting {
            population: &population,
            density,
            count: 0.5,
            radius: 3.0,
            by_regime: [0.0; 3],
            seen: Vec::new(),
        };
        counting.out_of_panels();
        assert!(counting.count.is_nan());
    }

    /// A density that falls linearly, with and without heights on the line.
    #[test]
    fn a_density_does_not_depend_on_how_many_heights_tell_it() {
        let table = |pieces: u32, (amplitude, rate): (f64, f64), gamma: f64, kinks: [f64; 2]| {
            let height: Vec<f64> = (0..=pieces).map(|i| f64::from(i) / f64::from(pieces)).collect();
            let density: Vec<f64> = height.iter().map(|h| 1.0 - h).collect();
            let heights = HeightFamily::Tabulated { height: height.into(), density: density.into() };
            let mut params = Params { heights, radius_amplitude: amplitude, radius_rate: rate, ..Params::default() };
            params.set_dimensionless(0.01, 1e3, gamma, 1.0, 0.3).expect("groups");
            [params.slip.radius_1, params.slip.radius_2] = kinks;
            params.slip.stress_2 = 0.5 * params.slip.stress_1;
            super::super::tests::of(&params)
        };
        for (radius, gamma, kinks) in [
            ((0.0, 1.0), 1e-3, [300.0, 900.0]),
            ((0.8, 1.0), 1e-3, [300.0, 900.0]),
            ((-0.8, 4.0), 1e-3, [300.0, 900.0]),
            ((0.5, 30.0), 1e-4, [300.0, 900.0]),
            ((-0.9, 0.3), 0.0, [300.0, 900.0]),
            ((0.0, 1.0), 1e-3, [3.0, 10.0]),
            ((0.0, 1.0), 1e-4, [3.0, 10.0]),
        ] {
            let (coarse, fine) = (table(2, radius, gamma, kinks), table(128, radius, gamma, kinks));
            let foot = coarse.heights.foot();
            for separation in
                [-3.0, -0.3, -0.1, -0.03, -0.01, 0.0, 0.02, 0.3, 1.0, 2.0, 3.5, 4.1].map(|above| foot + above)
            {
                let what = format!("{radius:?}, {gamma} at {}", separation - foot);
                let [a, b] = [&coarse, &fine].map(|population| population.at_separation(separation).unscaled());
                for (a, b) in [
                    (a.load_contacting, b.load_contacting),
                    (a.load_attracted, b.load_attracted),
                    (a.friction, b.friction),
                    (a.area, b.area),
                    (a.contacting, b.contacting),
                    (a.load_slope, b.load_slope),
                    (a.friction_slope, b.friction_slope),
                ] {
                    assert!((a - b).abs() <= 1e-9 * a.abs(), "{what}: {a:e} {b:e}");
                }
                let [a, b] = [&coarse, &fine].map(|population| population.contacts(separation, 300.0).expect("few"));
                for (a, b) in [(a.mean_radius, b.mean_radius), (a.largest_radius, b.largest_radius)] {
                    assert!((a - b).abs() <= 1e-9 * a, "{what}: {a:e} {b:e}");
                }
                for (a, b) in a.by_regime.into_iter().zip(b.by_regime) {
                    assert!((a - b).abs() <= 1e-9, "{what}: {a:e} {b:e}");
                }
            }
        }
    }

    /// Where radii fall with height, the largest contact is not that of the highest summit.
    #[test]
    fn the_largest_contact_is_that_of_no_node() {
        let population = of_radii(-0.99, 2.0);
        let radius = |z: f64| population.point_cold(-0.5, z).contact.radius;
        let (mut lower, mut upper) = (-0.5, 4.0);
        while upper - lower > 1e-6 {
            let (left, right) = (lower + (upper - lower) / 3.0, upper - (upper - lower) / 3.0);
            (lower, upper) = if radius(left) < radius(right) { (left, upper) } else { (lower, right) };
        }
        assert!(lower > -0.4 && upper < 3.0, "{lower}");
        let found = population.contacts(-0.5, 1e6).expect("few panels").largest_radius;
        assert!((found / radius(lower) - 1.0).abs() < 1e-11, "{found}, not {}", radius(lower));
    }

    fn of_radii(radius_amplitude: f64, radius_rate: f64) -> Population {
        super::super::tests::of(&Params { radius_amplitude, radius_rate, ..Params::default() })
    }

    /// What summits that gather at two ends sum to between two heights, in many panels that end where the law of one is
    /// singular: the largest load, then mass times load, area, one.
    fn in_small_steps(
        population: &Population,
        (lower, upper): (f64, f64),
        log_scale: f64,
        law: impl Fn(f64) -> [f64; 3],
    ) -> [f64; 3] {
        let Heights::Ends(ends) = &population.heights else { panic!("{:?}", population.heights) };
        let scores = [lower, upper].map(|z| ends.score(ends.place_of(z).logit).clamp(-13.0, 13.0));
        let [from, to] = scores.map(|score| ends.logit_of_score(score));
        let mut sums = [0.0; 3];
        let middle = 0.5 * (from + to);
        for (edge, towards) in [(from, 1.0), (to, -1.0)] {
            let mut done = 0.0;
            while done < middle - from {
                // Shorter than what changes with height; beyond where places differ, than the normal density.
                let x = edge + towards * done;
                let place = ends.place(x);
                let steepness = place.above_foot * place.below_head / ends.width() * population.radius.rate;
                let step = match -towards * x - 80.0 {
                    beyond if beyond > 0.0 => beyond,
                    _ if x.abs() > 80.0 => f64::MAX,
                    _ => (0.5 * done).clamp(1e-12, 0.5 / (1.0 + steepness)),
                };
                let step = step.min(0.5 * ends.epsilon());
                let next = (done + step).min(middle - from);
                for (x, weight) in gauss_legendre::nodes(x, edge + towards * next) {
                    let mass = weight * ends.mass(x, log_scale);
                    for (sum, part) in sums.iter_mut().zip(law(ends.height(&ends.place(x)))) {
                        *sum += mass * part;
                    }
                }
                done = next;
            }
        }
        sums
    }

    #[test]
    fn sums_of_summits_that_gather_at_two_ends_are_those_of_small_steps() {
        let mut count = 0;
        for (moments, groups, radius, separations) in [
            ((2.137, 1e-10), [0.0188, 19.17, 0.008454, 7.551], (-1.0, 51.42), [-2.9, -2.8, -2.6]),
            ((-1.7566, 1e-7), [0.00175, 1964.0, 0.00058, 0.1256], (0.8765, 14.99), [-0.8, -0.34, 0.5]),
            ((-0.0394, 0.07439), [0.00502, 40.43, 0.000556, 2.32], (-1.0, 0.0885), [-1.9, -0.947, 0.3]),
            ((0.4964, 0.001), [0.00178, 15.66, 2.22e-6, 1.03], (0.9866, 0.0028), [-1.3, 0.0215, 1.7]),
            ((0.3, 0.05), [0.01, 100.0, 1e-3, 1.0], (0.0, 1.0), [-1.7, -0.7, 0.4]),
            ((0.3, 0.11), [0.02, 100.0, 1e-2, 1.0], (0.5, 2.0), [-1.7, -0.7, -0.3]),
            ((0.09, 1e-6), [0.0014, 7.6e6, 0.0, 0.09], (1.0, 45.0), [-1.0, -1e-3, -3e-8]),
            ((-0.11, 0.001), [0.002, 1.6, 0.185, 0.08], (1.0, 64.0), [-1.0, 3904.3, 3904.9]),
        ] {
            let population = johnson(moments, groups, radius);
            for separation in separations {
                let sums = population.at_separation(separation);
                let contacts = population.contact_ranges(separation);
                let gaps = population.attraction_ranges(separation, &contacts);
                let mut exact = [[0.0; 3]; 2];
                for range in &contacts {
                    let part = (range.lower.0, range.upper.0);
                    let part = in_small_steps(&population, part, sums.log_scale, |z| {
                        let contact = population.point_cold(separation, z).contact;
                        [contact.load, std::f64::consts::PI * contact.radius * contact.radius, 1.0]
                    });
                    exact[0] = std::array::from_fn(|i| exact[0][i] + part[i]);
                }
                for &range in &gaps {
                    let law = population.attraction.as_ref().expect("adhesion");
                    let part = in_small_steps(&population, range, sums.log_scale, |z| {
                        let g = population.radius.factor(z);
                        let summit = law.at(law.circle(z - separation, g), g);
                        [summit.load, 0.0, 1.0]
                    });
                    exact[1] = std::array::from_fn(|i| exact[1][i] + part[i]);
                    count += 1;
                }
                let [[load, area, contacting], [load_attracted, _, attracted]] = exact;
                let (loads, all) = (load.abs() + load_attracted.abs(), contacting + attracted);
                for (name, found, exact, scale) in [
                    ("load", sums.load_contacting, load, loads),
                    ("area", sums.area, area, area),
                    ("contacting", sums.contacting, contacting, all),
                    ("attraction", sums.load_attracted, load_attracted, loads),
                    ("attracted", sums.attracted, attracted, all),
                ] {
                    let error = (found - exact).abs() / exact.abs().max(1e-4 * scale).max(1e-250);
                    assert!(error < 1e-9, "{name} of {moments:?} at {separation}: {found:e}, not {exact:e}: {error:e}");
                }
            }
        }
        assert!(count > 12, "{count}");
    }

    #[test]
    fn attraction_of_summits_that_gather_at_two_ends_takes_few_places() {
        let mut count = 0;
        for (moments, groups, radius, separations) in [
            ((-1.7566, 1e-7), [0.00175, 1964.0, 0.00058, 0.1256], (0.8765, 14.99), [-0.8, -0.34, 0.5]),
            ((-0.0394, 0.07439), [0.00502, 40.43, 0.000556, 2.32], (-1.0, 0.0885), [-1.9, -0.947, 0.3]),
            ((0.3, 0.11), [0.02, 100.0, 1e-3, 1.0], (0.5, 2.0), [-1.7, -0.7, -0.3]),
            ((-0.11, 0.001), [0.002, 1.6, 0.185, 0.08], (1.0, 64.0), [-1.0, 3904.3, 3904.9]),
        ] {
            let population = johnson(moments, groups, radius);
            let (Heights::Ends(ends), Some(law)) = (&population.heights, &population.attraction) else { panic!() };
            for separation in separations {
                let contacts = population.contact_ranges(separation);
                for (lower, upper) in population.attraction_ranges(separation, &contacts) {
                    let lower = (lower, (lower - separation).max(-law.reach));
                    assert!(population.attracted_between_ends(ends, law, lower, upper, 0.0, |_, _| count += 1));
                }
            }
        }
        assert!(count <= 1580, "{count} places, not 1559");
    }
}
