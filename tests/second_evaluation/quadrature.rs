//! Tanh-sinh quadrature of several functions at once, on pieces that are halved until two levels agree.

use std::f64::consts::PI;

/// Functions that are integrated together.
pub const COMPONENTS: usize = 7;
pub type Values = [f64; COMPONENTS];

/// Two levels agree to this part of the sum of all pieces.
const TOLERANCE: f64 = 3e-11;
/// Pieces are halved no more often.
const DEEPEST: u32 = 24;

/// The integral over pieces, whose kind the integrand is told, and whether all of them met the tolerance.
pub fn integrate(pieces: &[(f64, f64, bool)], f: impl Fn(f64, bool) -> Values) -> (Values, bool) {
    let magnitude = |values: &[Values]| {
        let mut sum = [0.0; COMPONENTS];
        for value in values {
            for (sum, x) in sum.iter_mut().zip(value) {
                *sum += x.abs();
            }
        }
        sum
    };
    let coarse: Vec<Values> = pieces.iter().map(|&(a, b, kind)| level(a, b, 0.25, 0, |z| f(z, kind))).collect();
    let scale = magnitude(&coarse);
    let mut total = [0.0; COMPONENTS];
    let mut converged = true;
    for (&(a, b, kind), first) in pieces.iter().zip(coarse) {
        let (value, good) = refine(a, b, first, &scale, DEEPEST, &|z| f(z, kind));
        converged &= good;
        for (total, x) in total.iter_mut().zip(value) {
            *total += x;
        }
    }
    (total, converged)
}

fn refine(a: f64, b: f64, first: Values, scale: &Values, depth: u32, f: &impl Fn(f64) -> Values) -> (Values, bool) {
    let mut last = first;
    let mut step = 0.25;
    for _ in 0..3 {
        step *= 0.5;
        // The points between those of the level before.
        let between = level(a, b, 2.0 * step, 1, f);
        let mut next = [0.0; COMPONENTS];
        let mut worst = 0.0_f64;
        for i in 0..COMPONENTS {
            next[i] = 0.5 * (last[i] + between[i]);
            if scale[i] > 0.0 {
                worst = worst.max((next[i] - last[i]).abs() / scale[i]);
            }
        }
        last = next;
        if worst <= TOLERANCE {
            return (last, true);
        }
    }
    let middle = 0.5 * (a + b);
    if depth == 0 || middle <= a || middle >= b {
        return (last, false);
    }
    let (lower, one) = refine(a, middle, level(a, middle, 0.25, 0, f), scale, depth - 1, f);
    let (upper, other) = refine(middle, b, level(middle, b, 0.25, 0, f), scale, depth - 1, f);
    (std::array::from_fn(|i| lower[i] + upper[i]), one && other)
}

/// The trapezium sum with a step in t, where z = a + (b - a)/(1 + exp(-pi sinh t)); `offset` 1 shifts it by half a step.
fn level(a: f64, b: f64, step: f64, offset: i32, f: impl Fn(f64) -> Values) -> Values {
    const END: f64 = 3.25;
    let mut sum = [0.0; COMPONENTS];
    let count = (END / step).ceil() as i32;
    for i in -count..=count {
        let t = (f64::from(i) + 0.5 * f64::from(offset)) * step;
        if t.abs() > END {
            continue;
        }
        let decay = (-PI * t.abs().sinh()).exp();
        let near = decay / (1.0 + decay);
        let z = if t < 0.0 { a + (b - a) * near } else { b - (b - a) * near };
        let weight = step * (b - a) * PI * t.cosh() * near / (1.0 + decay);
        if z <= a || z >= b {
            continue;
        }
        for (sum, x) in sum.iter_mut().zip(f(z)) {
            *sum += weight * x;
        }
    }
    sum
}
