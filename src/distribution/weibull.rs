//! Weibull heights, eqs (18)-(21): standardised to mean 0 and standard deviation 1, so that the shape
//! omega alone remains, and with it skew and kurtosis together.

use super::gaussian::GAUSSIAN;
use super::{moments, HeightDistribution, Outline};
use crate::error::Error;
use crate::numerics::elementary::{exp, exp_each, expm1, log, log1p, log1p_each};
use crate::numerics::float_bits::finite;
use crate::numerics::quadrature::POINTS;
use crate::numerics::root;

/// The smallest and largest shape that is evaluated: below 1 the density has a pole at its lower end, and above 200 the
/// distribution cannot be told from its limit by any surface.
pub const SHAPE_RANGE: (f64, f64) = (1.0, 200.0);

/// The skew of a Weibull distribution as omega -> infinity: -12 sqrt(6) zeta(3) / pi^3.
pub const SKEW_LIMIT: f64 = -1.139_547_099_404_648_7;

/// A standardised Weibull distribution.
#[derive(Debug)]
pub struct Weibull {
    shape: f64,
    /// ln B_1 = ln Gamma(1 + 1/omega).
    ln_b1: f64,
    /// z_M = B_1 / C of eq (20): the support begins at -z_M.
    mean: f64,
    /// ln(omega / z_M).
    ln_shape_over_mean: f64,
    outline: Outline,
}

impl Weibull {
    /// The distribution of shape omega.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless finite and positive, [`Error::OutOfRange`] outside [`SHAPE_RANGE`].
    pub fn new(shape: f64) -> Result<Self, Error> {
        let name = "weibull_shape";
        if !finite(shape) || shape <= 0.0 {
            return Err(Error::invalid(name, shape, "must be finite and > 0"));
        }
        let (smallest, largest) = SHAPE_RANGE;
        if shape < smallest || shape > largest {
            let allowed = if shape < smallest {
                "must be at least 1: below, the density is infinite at the lowest asperity; take a table of heights"
            } else {
                "must be at most 200, where the skew is within 0.03 of its limit; take 200"
            };
            return Err(Error::out_of_range(name, shape, allowed));
        }
        Ok(Self::of_shape(shape))
    }

    fn of_shape(shape: f64) -> Self {
        let (ln_b1, [variance, skew, kurtosis]) = moments_of(shape);
        let mean = 1.0 / variance.sqrt();
        let outline = Outline {
            support: (-mean, f64::INFINITY),
            // Where the cumulative hazard is 1 - 1/omega.
            last_mode: mean * expm1(log(1.0 - 1.0 / shape) / shape - ln_b1),
            skew,
            kurtosis,
            power_at_lower_end: Some(shape - 1.0),
            ..GAUSSIAN
        };
        Self { shape, ln_b1, mean, ln_shape_over_mean: log(shape / mean), outline }
    }

    /// The shape whose skew this is.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] at or below [`SKEW_LIMIT`], [`Error::OutOfRange`] outside what [`SHAPE_RANGE`] covers.
    pub fn shape_of_skew(skew: f64) -> Result<f64, Error> {
        if !finite(skew) || skew <= SKEW_LIMIT {
            let allowed =
                "must be finite and > -1.13955, the limit of the Weibull family; Johnson heights have any skew \
                           from -3 to 3";
            return Err(Error::invalid("skew", skew, allowed));
        }
        let (smallest, largest) = SHAPE_RANGE;
        let residual = |ln_shape: f64| moments_of(exp(ln_shape)).1[1] - skew;
        let (lower, upper) = (log(smallest), log(largest));
        if residual(lower) < -1e-12 || residual(upper) > 1e-12 {
            let allowed = "must be that of a Weibull shape between 1 and 200, -1.1100 to 2; Johnson heights have any \
                           skew from -3 to 3";
            return Err(Error::out_of_range("skew", skew, allowed));
        }
        Ok(exp(root::bracketed(residual, lower, upper)).clamp(smallest, largest))
    }

    /// ln(1 + z/z_M), ln of the height above the lower end over the mean height; finite at the end itself.
    #[inline]
    fn log_relative<const N: usize>(&self, z: [f64; N]) -> [f64; N] {
        /// exp of less is 0.
        const LOWEST: f64 = -745.0;
        log1p_each(z.map(|z| (z / self.mean).max(-1.0))).map(|log| log.max(LOWEST))
    }

    /// ln phi at each height of the support.
    #[inline]
    fn log_densities<const N: usize>(&self, z: [f64; N]) -> [f64; N] {
        let relative = self.log_relative(z);
        // The logarithm of the cumulative hazard (C y)^omega at y = z + z_M.
        let log_hazard = relative.map(|relative| self.shape * (self.ln_b1 + relative));
        // Beyond these bounds a hazard is nothing, or the density is.
        let hazard = exp_each(log_hazard.map(|log_hazard| log_hazard.clamp(-700.0, 600.0)));
        std::array::from_fn(|i| {
            // (omega - 1) ln y, which must be 0 at the lower end if omega is 1.
            let power = self.shape * self.ln_b1 + (self.shape - 1.0) * relative[i];
            self.ln_shape_over_mean + power - hazard[i]
        })
    }
}

impl HeightDistribution for Weibull {
    fn outline(&self) -> &Outline {
        &self.outline
    }

    fn log_density(&self, z: f64) -> f64 {
        if z < -self.mean {
            return f64::NEG_INFINITY;
        }
        let [log_density] = self.log_densities([z]);
        log_density
    }

    fn log_density_slope(&self, z: f64) -> f64 {
        let [relative] = self.log_relative([z]);
        let hazard = exp((self.shape * (self.ln_b1 + relative)).min(600.0));
        (self.shape - 1.0 - self.shape * hazard) / (z + self.mean).max(f64::MIN_POSITIVE)
    }

    fn densities(&self, z: [f64; POINTS]) -> [f64; POINTS] {
        let densities = exp_each(self.log_densities(z));
        std::array::from_fn(|i| if z[i] < -self.mean { 0.0 } else { densities[i] })
    }

    fn distance_to_singularity(&self, z: f64) -> f64 {
        z + self.mean
    }
}

/// ln of heights t^(1/omega) with their weights: the cumulative hazard t is exponentially distributed, and means are summed by
/// the trapezoidal rule in s = ln t. Its integrand exp(s - e^s) is analytic to a distance of pi/2, so that a step of 3/16
/// leaves nothing.
fn hazard_nodes(shape: f64) -> impl Iterator<Item = (f64, f64)> {
    const LOG_STEP: f64 = 0.1875;
    (-230..=24).map(move |i| {
        let s = LOG_STEP * f64::from(i);
        (s / shape, LOG_STEP * exp(s - exp(s)))
    })
}

/// ln B_1, and eq (21): the variance of heights over their mean, skew and kurtosis.
fn moments_of(shape: f64) -> (f64, [f64; 3]) {
    // As differences from 1 and from B_1: heights of large shapes are nearly equal.
    let ln_b1 = log1p(hazard_nodes(shape).map(|(log_height, weight)| weight * expm1(log_height)).sum());
    (ln_b1, moments(hazard_nodes(shape).map(|(log_height, weight)| (weight, expm1(log_height - ln_b1)))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::near;
    use crate::numerics::neighbours::Neighbours;

    fn weibull(shape: f64) -> Weibull {
        Weibull::new(shape).expect("a shape")
    }

    /// A mean of sqrt(6)/pi omega and Gumbel's moments.
    #[test]
    fn moments_of_large_shapes_are_those_of_the_limit() {
        let limit = Weibull::of_shape(1e6);
        assert!(near(limit.outline.skew, SKEW_LIMIT, 1e-5) && near(limit.outline.kurtosis, 5.4, 1e-5));
        assert!(near(limit.mean, 1e6 * 6.0_f64.sqrt() / std::f64::consts::PI, 1e-5), "{}", limit.mean);
    }

    #[test]
    fn a_shape_is_that_of_its_skew() {
        for shape in [1.0, 1.3, 3.602, 40.0, 200.0] {
            let found = Weibull::shape_of_skew(weibull(shape).outline.skew).expect("a shape");
            assert!(near(found, shape, 1e-12 * shape), "{found}, not {shape}");
        }
        // What rounds to the end of the range is there.
        assert_eq!(Weibull::shape_of_skew(2.0 + 1e-13), Ok(1.0));
    }

    #[test]
    fn skews_are_taken_up_to_the_limits_and_no_further() {
        for skew in [2.0 + 1e-9, weibull(200.0).outline.skew - 1e-9, SKEW_LIMIT.above()] {
            assert!(matches!(Weibull::shape_of_skew(skew), Err(Error::OutOfRange { name: "skew", .. })), "{skew}");
        }
        for skew in [SKEW_LIMIT, f64::NAN, f64::INFINITY] {
            assert!(matches!(Weibull::shape_of_skew(skew), Err(Error::InvalidParameter { .. })), "{skew}");
        }
    }
}
