//! The dimensionless groups of the model, eqs (7) and (8).

use std::f64::consts::PI;

/// What a contact depends on beside its heights and radii.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groups {
    /// Surface roughness parameter (sigma/R)^(1/2).
    pub alpha: f64,
    /// Friction regime parameter (R sigma)^(1/2) / b.
    pub beta: f64,
    /// Surface energy parameter w / (E* b).
    pub gamma: f64,
    /// Burgers vector over the range of adhesion, b/h.
    pub b_over_h: f64,
    /// Hardness over composite modulus, H/E*; infinite where it is not known.
    pub hardness: f64,
    /// Whether summits yield.
    pub yields: bool,
    /// Nominal area of one summit in b^2; 0 where it is not known.
    pub nominal_area: f64,
}

impl Groups {
    /// lambda^3 of eq (7).
    pub fn lambda_cubed(&self) -> f64 {
        let cube = self.b_over_h * self.b_over_h * self.b_over_h;
        4.5 / PI * self.beta * self.gamma * self.gamma * cube / self.alpha
    }

    /// 2 E* a, in E* b^2 per standard deviation of height, of a contact of the radius b.
    pub fn stiffness_of_radius(&self) -> f64 {
        2.0 * self.alpha * self.beta
    }

    /// The range of adhesion in standard deviations of height, h/sigma.
    pub fn reach(&self) -> f64 {
        1.0 / (self.alpha * self.beta * self.b_over_h)
    }
}
