//! Sums of five hundred random surfaces at ten separations, as they were on 2026-11-28 (`reference/states.csv`: surface, separation
//! from the mean height, load and friction per summit, fraction in contact, slopes of both): whatever sums them later gives the same.

use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{johnson, table};
use asperity::asperity::groups::Groups;
use asperity::asperity::slip::{Slip, SlipConstants, SlipOnset};
use asperity::distribution::{heights, HeightFamily};
use asperity::population::radius::RadiusProfile;
use asperity::population::{Population, Sums};

const SURFACES: u64 = 500;
const STATES: usize = 10;

fn random_heights(random: &mut SplitMix) -> HeightFamily {
    match random.below(5) {
        0 | 1 => HeightFamily::Gaussian,
        2 => HeightFamily::Weibull { shape: random.log_between(1.0, 60.0) },
        3 => {
            let skew = random.between(-2.5, 2.5);
            johnson(skew, 1.87 + 1.25 * skew * skew + random.log_between(1e-3, 30.0))
        }
        _ => {
            let count = if random.chance(0.8) { 3 + random.below(10) } else { 100 };
            let mut height = Vec::new();
            for _ in 0..count {
                height.push(height.last().copied().unwrap_or(0.0) + random.between(0.05, 1.0));
            }
            // Some are 0, and with them the slope of the height by the normal score is infinite.
            let density: Vec<f64> = (0..count).map(|_| random.between(-0.1, 1.0).max(0.0)).collect();
            table(&height, &density)
        }
    }
}

/// A surface of the box, and separations from heavy contact to the last summits; `None` where the library refuses it.
fn random_surface(random: &mut SplitMix) -> (Option<Population>, [f64; STATES]) {
    let adheres = random.chance(0.55);
    let yields = !adheres && random.chance(0.5);
    let [alpha, beta, gamma] = [(2e-3, 0.5), (3.0, 1e6), (1e-6, 1.0)].map(|(from, to)| random.log_between(from, to));
    let groups = Groups {
        alpha,
        beta,
        gamma: if adheres { gamma } else { 0.0 },
        b_over_h: random.log_between(0.02, 10.0),
        hardness: if yields { random.log_between(1e-3, 0.1) } else { f64::INFINITY },
        yields,
        nominal_area: 0.0,
    };
    let family = random_heights(random);
    let amplitude = if random.chance(0.4) { 0.0 } else { random.between(-1.05, 1.05).clamp(-1.0, 1.0) };
    let rate = random.log_between(0.05, 8.0);
    let pressure = if random.chance(0.2) { random.between(0.0, 0.2) } else { 0.0 };
    let above_mean = std::array::from_fn(|i| match i {
        0 => -random.log_between(10.0, 1000.0),
        1 | 2 => random.between(-12.0, -4.0),
        3 => random.between(4.0, 6.0),
        _ => random.between(-4.0, 4.5),
    });
    let Ok(heights) = heights(&family) else { return (None, above_mean) };
    let radius = RadiusProfile { amplitude, rate, origin: heights.outline().origin, scores: None };
    let slip = Slip::new(SlipConstants::default(), pressure, SlipOnset::Partial);
    (Population::new(&groups, slip, heights, radius, random.chance(0.7)).ok(), above_mean)
}

fn numbers(sums: &Sums) -> [f64; 5] {
    [sums.load(), sums.friction, sums.contacting, sums.load_slope, sums.friction_slope]
}

/// Of each surface that was made then, one is made now.
#[test]
fn sums_are_what_they_were() {
    let rows = include_str!("../reference/states.csv");
    let mut compared = 0;
    let mut rows = rows
        .lines()
        .skip(1)
        .map(|row| row.split(',').map(|x| x.parse().expect("a number")).collect::<Vec<f64>>())
        .peekable();
    for surface in 0..SURFACES {
        let (population, above_mean) = random_surface(&mut SplitMix(surface));
        for above in above_mean {
            let Some(row) = rows.next_if(|row| row[0] as u64 == surface && (row[1] / above - 1.0).abs() < 1e-9) else {
                continue;
            };
            let population = population.as_ref().unwrap_or_else(|| panic!("surface {surface} was made"));
            let sums = population.at_separation(above - population.heights().outline().origin);
            // What presses and what pulls may nearly cancel.
            let size = sums.load_contacting.abs() + sums.load_attracted.abs();
            for (i, (found, expected)) in numbers(&sums).into_iter().zip(&row[2..]).enumerate() {
                let known = [1e-9 * size, 1e-9 * expected.abs(), 1e-9, 1e-8 * expected.abs(), 1e-8 * expected.abs()][i];
                assert!(
                    (found - expected).abs() <= known,
                    "number {i} of surface {surface} at {above}: {found:e}, not {expected:e}"
                );
            }
            compared += 1;
        }
    }
    assert!(compared > 4500 && rows.next().is_none(), "{compared} states");
}
