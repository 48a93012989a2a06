//! The integrals of a density times the polynomials through Gauss points, from its integrals times Legendre polynomials p_k, scaled
//! so that x^k has the factor 1: then p_(k+1) = x p_k - k^2/(4 k^2 - 1) p_(k-1).

use super::quadrature::{HALF, POINTS};

/// For each k, p_k at the Gauss points times their weights, over the integral of its square: there the polynomial through the points
/// that is 1 at one of them and 0 at the others is the sum of these times p_k.
const AT_POINTS: [[f64; POINTS]; POINTS] = at_points();

/// k^2/(4 k^2 - 1)
const FACTORS: [f64; POINTS] = {
    let mut factors = [0.0; POINTS];
    let mut k = 1;
    while k < POINTS {
        let square = (k * k) as f64;
        factors[k] = square / (4.0 * square - 1.0);
        k += 1;
    }
    factors
};

const fn at_points() -> [[f64; POINTS]; POINTS] {
    let mut rows = [[0.0; POINTS]; POINTS];
    let mut i = 0;
    while i < POINTS {
        let is_above = i >= POINTS / 2;
        let (x, weight) = HALF[if is_above { i - POINTS / 2 } else { POINTS / 2 - 1 - i }];
        let x = if is_above { x } else { -x };
        let (mut before, mut here, mut square, mut k) = (0.0, 1.0, 2.0, 0);
        while k < POINTS {
            rows[k][i] = weight * here / square;
            (before, here) = (here, x * here - FACTORS[k] * before);
            k += 1;
            square *= if k < POINTS { FACTORS[k] } else { 0.0 };
        }
        i += 1;
    }
    rows
}

/// The integrals of a density times p_0, p_1 and so on, as sums over places from -1 to 1.
#[derive(Default)]
pub struct Moments([[f64; 2]; POINTS]);

impl Moments {
    /// Adds places with what the density is there times their weights.
    #[inline]
    pub fn add<const N: usize>(&mut self, places: &[f64; N], fractions: &[f64; N]) {
        let (mut before, mut here) = ([0.0; N], *fractions);
        for (moment, factor) in self.0.iter_mut().zip(FACTORS) {
            for i in 0..N {
                moment[i % 2] += here[i];
            }
            for i in 0..N {
                (before[i], here[i]) = (here[i], places[i] * here[i] - factor * before[i]);
            }
        }
    }

    /// What the Gauss points weigh.
    pub fn weights(&self) -> [f64; POINTS] {
        let mut weights = [0.0; POINTS];
        for (row, moment) in AT_POINTS.iter().zip(self.0) {
            for (weight, at_point) in weights.iter_mut().zip(row) {
                *weight += at_point * (moment[0] + moment[1]);
            }
        }
        weights
    }
}

#[cfg(test)]
mod tests {
    use super::super::quadrature::{nodes, panel};
    use super::*;

    #[test]
    fn the_integral_over_a_part_takes_no_values_but_those_at_the_points() {
        let mut moments = Moments::default();
        let part = panel(-0.4, 0.9);
        moments.add(&part.map(|(x, _)| x), &part.map(|(x, weight)| weight * x.exp()));
        let values = panel(-1.0, 1.0).map(|(x, _)| 2.0 + x.powi(13));
        let found: f64 = moments.weights().iter().zip(values).map(|(weight, value)| weight * value).sum();
        let exact: f64 = nodes(-0.4, 0.9).map(|(x, weight)| weight * x.exp() * (2.0 + x.powi(13))).sum();
        assert!((found - exact).abs() < 1e-14, "{found}, not {exact}");
    }
}
