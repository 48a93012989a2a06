//! Radius of curvature of a summit as a function of its height, eq (3).

/// g(z) = 1 + epsilon tanh(rho z), the local radius over the mean one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadiusProfile {
    /// epsilon, in [-1, 1].
    pub amplitude: f64,
    /// rho > 0, per sigma.
    pub rate: f64,
    /// Where heights are measured from, above their mean.
    pub origin: f64,
}

/// Smaller radius factors are taken as this: such summits carry nothing, and squares stay in range.
const SMALLEST_FACTOR: f64 = 1e-60;

impl RadiusProfile {
    /// Whether all summits have the same radius.
    pub fn is_constant(&self) -> bool {
        self.amplitude == 0.0
    }

    /// g and dg/dz at height z, without cancellation where g goes to 0 (|epsilon| = 1).
    #[inline]
    pub fn at(&self, z: f64) -> (f64, f64) {
        if self.is_constant() {
            return (1.0, 0.0);
        }
        let size = self.amplitude.abs();
        let y = self.rate * (z + self.origin) * self.amplitude.signum();
        let decay = (-2.0 * y.abs()).exp();
        let g = if y >= 0.0 {
            1.0 + size * (1.0 - decay) / (1.0 + decay)
        } else {
            (1.0 - size) + size * 2.0 * decay / (1.0 + decay)
        };
        let slope = self.amplitude * self.rate * 4.0 * decay / ((1.0 + decay) * (1.0 + decay));
        if g > SMALLEST_FACTOR {
            (g, slope)
        } else {
            (SMALLEST_FACTOR, 0.0)
        }
    }

    /// g at height z.
    #[inline]
    pub fn factor(&self, z: f64) -> f64 {
        self.at(z).0
    }

    /// How far above z one smooth piece may reach: the poles of tanh lie at +-i pi/(2 rho).
    pub fn smooth_length(&self, z: f64) -> f64 {
        if self.is_constant() {
            return f64::MAX;
        }
        let pole = std::f64::consts::FRAC_PI_2 / self.rate;
        let z = z + self.origin;
        if z < 0.0 {
            (0.65 * -z).max(1.1 * pole)
        } else {
            1.1 * z.hypot(pole)
        }
    }
}
