//! What several groups of tests share; each group takes what it needs.

#![allow(dead_code)]

pub mod c_compiler;
#[path = "../../src/numerics/neighbours.rs"]
pub mod neighbours;
pub mod processor_time;
pub mod reference_rows;
pub mod second_evaluation;
pub mod sobol;
pub mod splitmix;
pub mod surfaces;

/// Fails unless a value is within a relative tolerance of what is expected.
#[track_caller]
pub fn assert_near(value: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((value - expected).abs() <= tolerance * expected.abs(), "{what}: {value}, not {expected}");
}

/// An integral by Simpson's rule.
pub fn simpson(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: u32 = 20_000;
    let step = (to - from) / f64::from(STEPS);
    let weight = |i: u32| if i == 0 || i == STEPS { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
    (0..=STEPS).map(|i| weight(i) * f(from + step * f64::from(i))).sum::<f64>() * step / 3.0
}

/// The number in an environment variable, which makes a test longer or shorter.
pub fn number_from_environment<T: std::str::FromStr>(name: &str, otherwise: T) -> T {
    std::env::var(name).map_or(otherwise, |text| text.parse().unwrap_or_else(|_| panic!("{name} = {text}: a number")))
}
