//! Positions, in which lengths of panels are measured: equal to separations among the heights, logarithmic far from them,
//! where what matters is the part by which a separation changes.

use crate::numerics::elementary::{exp, log};

/// Positions turn from separations to their logarithms this far from the mean height, in sigma.
const TURN: f64 = 3.7;
/// Panels shorter than this are as long in separation.
const SHORT_PANEL: f64 = 0.1;

/// Positions of separations.
#[derive(Debug, Clone, Copy)]
pub struct Positions {
    /// The separation at which the flat is at the mean height.
    pub middle: f64,
}

impl Positions {
    /// What panels are long in: arsinh of the distance from the mean height.
    pub fn position(&self, separation: f64) -> f64 {
        let distance = (separation - self.middle) / TURN;
        let size = distance.abs();
        (TURN * log(size + (1.0 + size * size).sqrt())).copysign(distance)
    }

    /// The separation at a position.
    pub fn separation(&self, position: f64) -> f64 {
        let growth = exp(position.abs() / TURN);
        self.middle + (0.5 * TURN * (growth - 1.0 / growth)).copysign(position)
    }

    /// Whether a panel is so short that positions have too few digits.
    pub fn is_short(&self, from: f64, to: f64) -> bool {
        (to - from) * self.density(from) < SHORT_PANEL
    }

    /// How long a panel between two separations is.
    pub fn distance(&self, from: f64, to: f64) -> f64 {
        if self.is_short(from, to) {
            (to - from) * self.density(from)
        } else {
            self.position(to) - self.position(from)
        }
    }

    /// The separation at a distance beyond another.
    pub fn beyond(&self, from: f64, length: f64) -> f64 {
        if length < SHORT_PANEL {
            from + length / self.density(from)
        } else {
            self.separation(self.position(from) + length)
        }
    }

    /// The separation at a part of a panel, -1 at its beginning and 1 at its end.
    pub fn between(&self, from: f64, to: f64, part: f64) -> f64 {
        let at = |from: f64, to: f64| 0.5 * (from + to) + 0.5 * part * (to - from);
        if self.is_short(from, to) {
            at(from, to)
        } else {
            self.separation(at(self.position(from), self.position(to)))
        }
    }

    /// d^2(separation)/d(position)^2.
    pub fn bend(&self, separation: f64) -> f64 {
        (separation - self.middle) / (TURN * TURN)
    }

    /// d(position)/d(separation).
    pub fn density(&self, separation: f64) -> f64 {
        let distance = (separation - self.middle) / TURN;
        1.0 / (1.0 + distance * distance).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::near;

    #[test]
    fn positions_are_separations_among_the_heights_and_logarithms_far_from_them() {
        let positions = Positions { middle: 3.0 };
        for separation in [-5e8, -100.0, 2.0, 3.0, 3.1, 40.0] {
            let position = positions.position(separation);
            assert!(near(positions.separation(position), separation, 1e-12), "{separation}");
        }
        assert!([1e-7, -1e-7].iter().all(|&step| near(positions.position(3.0 + step), step, 1e-8)));
        let decade = positions.position(-1e6) - positions.position(-1e7);
        assert!((decade - TURN * 10_f64.ln()).abs() < 1e-5, "{decade}");
    }
}
