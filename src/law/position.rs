//! Positions, in which lengths of panels are measured: the coordinate in which loads are smooth, rising with separation.

use crate::equilibrium::Branch;
use crate::numerics::elementary::{exp, log, log1p, sinh};

/// Positions turn from separations to their logarithms this far from the mean height, in sigma, or as far as adhesion reaches, and grow
/// by this per power of e.
const TURN: f64 = 3.7;
/// Heights that end farther above their mean than this, in sigma, are as if they did not end.
const FARTHEST_END: f64 = 100.0;

/// How separations follow from positions.
#[derive(Debug, Clone, Copy)]
pub enum Positions {
    /// As separations among the heights, about their mean, and logarithmic far from them.
    Around { middle: f64, turn: f64 },
    /// Logarithmic in the distance from the highest summit, towards which load goes to 0.
    Below { highest: f64 },
}

impl Positions {
    /// Of a branch: of one that ends at pull-off, or far off, around its heights.
    pub fn of(branch: &Branch, has_pull_off: bool) -> Self {
        let population = branch.population();
        let (middle, turn) = (-population.heights().outline().origin, TURN.max(population.range_of_adhesion()));
        match has_pull_off || population.heights().outline().support.1 - middle > FARTHEST_END {
            true => Self::Around { middle, turn },
            false => Self::Below { highest: branch.farthest() },
        }
    }

    /// The position of a separation; infinite where nothing is left.
    pub fn position(self, separation: f64) -> f64 {
        match self {
            Self::Around { middle, turn } => {
                let size = ((separation - middle) / turn).abs();
                (TURN * log1p(size + size * size / (1.0 + (1.0 + size * size).sqrt()))).copysign(separation - middle)
            }
            Self::Below { highest } if separation >= highest => f64::INFINITY,
            Self::Below { highest } => -log(highest - separation),
        }
    }

    /// The separation at a position.
    pub fn separation(self, position: f64) -> f64 {
        match self {
            Self::Around { middle, turn } => middle + turn * sinh(position / TURN),
            Self::Below { highest } => highest - exp(-position),
        }
    }

    /// d(separation)/d(position) at a separation, and d^2(separation)/d(position)^2.
    pub fn rates(self, separation: f64) -> (f64, f64) {
        match self {
            Self::Around { middle, turn } => {
                let distance = (separation - middle) / turn;
                (turn / TURN * (1.0 + distance * distance).sqrt(), (separation - middle) / (TURN * TURN))
            }
            Self::Below { highest } => (highest - separation, separation - highest),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::near;

    #[test]
    fn positions_and_separations_follow_from_each_other_with_their_rates() {
        for positions in [Positions::Around { middle: 3.0, turn: 20.0 }, Positions::Below { highest: 50.0 }] {
            for separation in [-5e8, -100.0, 2.0, 3.0, 3.1, 40.0] {
                let position = positions.position(separation);
                assert!(near(positions.separation(position), separation, 1e-12), "{separation}");
                let [before, after] = [-1e-4, 1e-4].map(|step| positions.separation(position + step));
                let (rate, bend) = positions.rates(separation);
                assert!(near((after - before) / 2e-4, rate, 1e-8), "{separation}");
                let rates = [before, after].map(|separation| positions.rates(separation).0);
                assert!((rates[1] - rates[0]) / 2e-4 - bend < 1e-7 * rate, "{separation}");
            }
        }
    }
}
