//! How a quantity differs from specimen to specimen.

use crate::numerics::ascending;

/// Mean, standard deviation, and the 2.5, 50 and 97.5 % quantiles; NaN of no numbers, and a deviation of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// What one in forty is below.
    pub low: f64,
    /// Median.
    pub median: f64,
    /// What one in forty is above.
    pub high: f64,
}

impl Spread {
    /// The spread of all numbers that are not NaN.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let values: Vec<f64> = values.filter(|value| !value.is_nan()).collect();
        let sorted: Vec<f64> = ascending(&values).into_iter().map(|i| values[i]).collect();
        let n = sorted.len() as f64;
        let none = f64::NAN;
        if sorted.is_empty() {
            return Self { mean: none, deviation: none, low: none, median: none, high: none };
        }
        // About one of them, without cancellation.
        let base = sorted[sorted.len() / 2];
        let off = sorted.iter().map(|value| value - base).sum::<f64>() / n;
        let squares: f64 = sorted.iter().map(|value| (value - base - off).powi(2)).sum();
        let quantile = |part: f64| {
            let at = part * (n - 1.0);
            let (below, rest) = (sorted[at as usize], at - at.floor());
            below + rest * (sorted[(at as usize + 1).min(sorted.len() - 1)] - below)
        };
        Self {
            mean: base + off,
            deviation: if n > 1.0 { (squares / (n - 1.0)).sqrt() } else { none },
            low: quantile(0.025),
            median: quantile(0.5),
            high: quantile(0.975),
        }
    }
}
