//! How a quantity differs from specimen to specimen.

use crate::numerics::ascending;

/// Mean, standard deviation, and the 2.5, 50 and 97.5 % quantiles of all numbers that are not NaN: NaN of none, as the deviation of one.
pub fn spread(values: impl Iterator<Item = f64>) -> [f64; 5] {
    let values: Vec<f64> = values.filter(|value| !value.is_nan()).collect();
    let sorted: Vec<f64> = ascending(&values).into_iter().map(|i| values[i]).collect();
    let n = sorted.len() as f64;
    let Some(last) = sorted.len().checked_sub(1) else { return [f64::NAN; 5] };
    // About one of them, without cancellation.
    let base = sorted[last / 2];
    let off = sorted.iter().map(|value| value - base).sum::<f64>() / n;
    let squares: f64 = sorted.iter().map(|value| (value - base - off).powi(2)).sum();
    let quantile = |part: f64| {
        let at = part * last as f64;
        let (below, above) = (sorted[at as usize], sorted[(at as usize + 1).min(last)]);
        below + (at - at.floor()) * (above - below)
    };
    let deviation = if last > 0 { (squares / last as f64).sqrt() } else { f64::NAN };
    [base + off, deviation, quantile(0.025), quantile(0.5), quantile(0.975)]
}
