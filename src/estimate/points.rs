//! Measured points as an estimate takes them.

use crate::model::calibration::MeasuredPoint;
use crate::numerics::ascending;
use crate::numerics::elementary::{exp, log};

/// Of more points, those whose loads are nearest are taken together.
const MOST_SOLVED: usize = 16;

/// Measured points at one load.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    pub load: f64,
    pub log_force: f64,
    /// The variance of its error.
    pub noise: f64,
    /// How far those at this load are off their mean, squared, over their errors; and how many more than one they are.
    pub scatter: f64,
    pub more: usize,
}

/// Points with those at the same load as one, and of more than can be solved for those that are nearest.
pub fn merged(points: &[MeasuredPoint]) -> Vec<Point> {
    let of = |point: &MeasuredPoint| Point {
        load: point.load,
        log_force: log(point.force),
        noise: point.error * point.error,
        scatter: 0.0,
        more: 0,
    };
    let sorted = |points: Vec<Point>, by: fn(&Point) -> f64| {
        let order = ascending(&points.iter().map(by).collect::<Vec<_>>());
        order.into_iter().map(|i| points[i]).collect::<Vec<_>>()
    };
    let found = sorted(points.iter().map(of).collect(), |point| point.log_force);
    let mut found = sorted(found, |point| point.load);
    let apart = |pair: &[Point]| {
        if pair[0].load > 0.0 {
            log(pair[1].load / pair[0].load)
        } else {
            pair[1].load - pair[0].load
        }
    };
    while found.len() > 1 {
        let nearest = found.windows(2).map(apart).enumerate().min_by(|one, other| one.1.total_cmp(&other.1));
        let Some((at, distance)) = nearest.filter(|&(_, distance)| distance == 0.0 || found.len() > MOST_SOLVED) else {
            break;
        };
        let other = found.remove(at + 1);
        found[at] = found[at].with(&other, distance == 0.0);
    }
    found
}

impl Point {
    /// Two as one, at the mean of their loads; F/P is what is averaged.
    fn with(&self, other: &Self, at_one_load: bool) -> Self {
        let (one, two) = (1.0 / self.noise, 1.0 / other.noise);
        let mean = |a: f64, b: f64| (one * a + two * b) / (one + two);
        let load = if at_one_load { self.load } else { exp(mean(log(self.load), log(other.load))) };
        let log_ratio = |point: &Self| point.log_force - if point.load > 0.0 { log(point.load) } else { 0.0 };
        let (a, b) = (log_ratio(self), log_ratio(other));
        let scatter = self.scatter + other.scatter + one * two / (one + two) * (a - b) * (a - b);
        let log_force = mean(a, b) + if load > 0.0 { log(load) } else { 0.0 };
        Self { load, log_force, noise: 1.0 / (one + two), scatter, more: self.more + other.more + 1 }
    }
}
