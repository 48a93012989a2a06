//! The density of heights at one separation, relative to that of a summit near which all that counts lies.
//!
//! Far out in the tail of the heights ln phi is large and changes fast: there the density is had from the rise above
//! the reference as a difference of overlaps, which are small and so known to more digits than heights.

use crate::surface::heights::Heights;

/// phi(z) exp(-log_scale).
#[derive(Debug, Clone, Copy)]
pub struct Density<'a> {
    heights: &'a Heights,
    /// Height and overlap of the reference.
    height: f64,
    overlap: f64,
    /// Whether overlaps are known to more digits than heights.
    by_overlap: bool,
    /// ln phi of the reference.
    pub log_scale: f64,
}

impl<'a> Density<'a> {
    /// For what lies above the lowest summit that counts, of this height and overlap. The reference is that or, where the
    /// density is larger above, its mode.
    pub fn above(heights: &'a Heights, height: f64, overlap: f64, separation: f64) -> Self {
        let peak = heights.peak_above(height);
        let (height, overlap) = if height < peak { (peak, peak - separation) } else { (height, overlap) };
        let log_density = heights.log_scale(height);
        // At the foot it may be infinite; above, the density falls.
        let log_scale = if log_density.is_finite() { log_density } else { 0.0 };
        Self { heights, height, overlap, by_overlap: overlap.abs() < height.abs(), log_scale }
    }

    /// The density at a height, which has this overlap.
    #[inline]
    pub fn at(&self, z: f64, overlap: f64) -> f64 {
        let rise = if self.by_overlap { overlap - self.overlap } else { z - self.height };
        self.heights.relative_density(self.height, rise, self.log_scale)
    }

    /// The same at the heights of several overlaps, side by side.
    #[inline]
    pub fn at_each<const N: usize>(&self, separation: f64, overlaps: [f64; N]) -> [f64; N] {
        let rises = match self.by_overlap {
            true => overlaps.map(|overlap| overlap - self.overlap),
            false => overlaps.map(|overlap| separation + overlap - self.height),
        };
        self.heights.relative_density_each(self.height, rises, self.log_scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_out_densities_have_the_digits_of_overlaps() {
        let heights = Heights::Gaussian;
        for separation in [30.3, 50.7, 57.1] {
            for lowest in [-0.0123, 0.0, 0.001] {
                let height = separation + lowest;
                let density = Density::above(&heights, height, lowest, separation);
                let overlaps = [lowest, 0.002, 0.0137, 0.1, 0.3];
                for (overlap, each) in overlaps.into_iter().zip(density.at_each(separation, overlaps)) {
                    let rise = overlap - lowest;
                    let expected = f64::exp(-rise * (height + 0.5 * rise));
                    for found in [each, density.at(separation + overlap, overlap)] {
                        assert!((found / expected - 1.0).abs() < 1e-14, "{found:e}, not {expected:e} at {separation}");
                    }
                }
            }
        }
    }
}
