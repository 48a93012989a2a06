//! Standardised height distributions a second time. A family that the library gains becomes a variant here: its log
//! density, where it begins, which heights matter, where it is not smooth.

/// Contributions below exp of minus this of the largest are left out.
const NEGLIGIBLE: f64 = 60.0;

#[derive(Debug, Clone)]
pub enum Heights {
    Gaussian,
    /// `rate` is C of eq (20), `mean` z_M.
    Weibull {
        shape: f64,
        rate: f64,
        mean: f64,
    },
}

impl Heights {
    /// Weibull heights of a shape. With x exponentially distributed y = x^(1/omega) has the moments B_n; mean and variance
    /// are sums over t = ln x, where the trapezium rule converges doubly exponentially. Taken about 1, nothing cancels.
    pub fn weibull(shape: f64) -> Self {
        let expectation = |f: &dyn Fn(f64) -> f64| {
            let step = 1.0 / 64.0;
            (-45 * 64..4 * 64).map(|i| f64::from(i) * step).map(|t| step * (t - t.exp()).exp() * f(t)).sum::<f64>()
        };
        let above_one = expectation(&|t| (t / shape).exp_m1());
        let variance = expectation(&|t| ((t / shape).exp_m1() - above_one).powi(2));
        let rate = variance.sqrt();
        Heights::Weibull { shape, rate, mean: (1.0 + above_one) / rate }
    }

    pub fn log_density(&self, z: f64) -> f64 {
        match *self {
            Heights::Gaussian => -0.5 * z * z - 0.5 * (2.0 * std::f64::consts::PI).ln(),
            Heights::Weibull { shape, rate, mean } => {
                let y = rate * (z + mean);
                if y <= 0.0 {
                    return f64::NEG_INFINITY;
                }
                (shape * rate).ln() + (shape - 1.0) * y.ln() - y.powf(shape)
            }
        }
    }

    /// Where the support begins.
    pub fn foot(&self) -> f64 {
        match *self {
            Heights::Gaussian => f64::NEG_INFINITY,
            Heights::Weibull { mean, .. } => -mean,
        }
    }

    /// The heights at or above one that are not negligible, and ln of the largest density among them.
    pub fn range(&self, lowest: f64) -> (f64, f64, f64) {
        match *self {
            Heights::Gaussian => {
                let half = (2.0 * NEGLIGIBLE).sqrt();
                let lower = lowest.max(-half);
                (lower, lower.max(0.0).hypot(half), self.log_density(lower.max(0.0)))
            }
            Heights::Weibull { shape, rate, mean } => {
                let lower = lowest.max(-mean);
                let mode = ((shape - 1.0) / shape).powf(1.0 / shape) / rate - mean;
                let hazard = (rate * (lower + mean)).powf(shape);
                let upper = (hazard + NEGLIGIBLE).powf(1.0 / shape) / rate - mean;
                (lower, upper, self.log_density(lower.max(mode)))
            }
        }
    }

    /// Heights at which integrals are cut, so that no piece is much longer than what varies in it.
    pub fn cuts(&self) -> Vec<f64> {
        match *self {
            Heights::Gaussian => vec![-4.0, -1.5, 1.5, 4.0],
            Heights::Weibull { shape, rate, mean } => [1e-6, 1e-3, 0.1, 1.0, 5.0, 20.0]
                .iter()
                .map(|hazard: &f64| hazard.powf(1.0 / shape) / rate - mean)
                .collect(),
        }
    }
}
