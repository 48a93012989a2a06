//! Heights of a measured density: a table, joined by a monotone cubic cumulative distribution and standardised.
//!
//! Between two heights of the table the density is a parabola through the two densities. Its mass is that of the monotone
//! cubic through them (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980, 238-246; slopes of Fritsch and Butland, SIAM J.
//! Sci. Stat. Comput. 5, 1984, 300-304), limited so that the parabola is monotonic. The cumulative distribution is then the
//! cubic Hermite interpolant of its values at the heights with the densities as slopes, and monotonic; no density is
//! negative, and none is larger than all of the table. Zero densities at the ends are left out up to the last one.

use super::gaussian::GAUSSIAN;
use super::{HeightDistribution, Outline};
use crate::error::Error;
use crate::numerics::elementary::log;
use crate::numerics::float_bits::finite;
use crate::numerics::hermite::monotone_slope;
use crate::numerics::quadrature::{integrate_short, POINTS};

/// How many heights a table may have: each is a kink of the friction law, and the table of the law resolves no more.
pub const TABLE_LENGTHS: (usize, usize) = (3, 256);
/// No height of the support is farther from the mean, in standard deviations.
const WIDEST_RANGE: f64 = 1e4;
/// The highest height is made the origin unless it is farther from the mean than this, in standard deviations.
const FARTHEST_HIGHEST: f64 = 16.0;
/// Larger heights could overflow when combined.
const LARGEST_HEIGHT: f64 = 1e300;
/// Neighbouring heights are at least this part of the range of the support apart: a step may be that steep.
const NEAREST: f64 = 1e-12;
/// A standardised density of a table.
#[derive(Debug)]
pub struct Tabulated {
    /// Heights of the support, from the origin.
    knots: Vec<f64>,
    /// The density between each and the next.
    pieces: Vec<DensityPiece>,
    outline: Outline,
}

/// The density on a piece of the support: (1 - t) lower + t upper + t (1 - t) bulge with t from 0 to 1.
#[derive(Debug, Clone, Copy)]
struct DensityPiece {
    lower: f64,
    upper: f64,
    bulge: f64,
}

impl DensityPiece {
    /// The density so far below the next height and so far above the last.
    #[inline]
    fn at(&self, below: f64, above: f64) -> f64 {
        let t = above / (above + below);
        let rest = below / (above + below);
        rest * self.lower + t * self.upper + t * rest * self.bulge
    }

    /// Its derivative by height.
    fn slope(&self, below: f64, above: f64) -> f64 {
        let length = above + below;
        (self.upper - self.lower + (below - above) / length * self.bulge) / length
    }
}

impl Tabulated {
    /// The density of a table of heights in any unit and from any origin, which need not be normalised.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::InvalidEntry`] naming the first entry that is refused; [`Error::OutOfRange`].
    pub fn new(height: &[f64], density: &[f64]) -> Result<Self, Error> {
        let (height, density) = checked(height, density)?;
        // Heights as parts of the range of the support, densities as parts of the largest.
        let range = height[height.len() - 1] - height[0];
        let part: Vec<f64> = height.iter().map(|h| (h - height[0]) / range).collect();
        let largest = density.iter().fold(0.0_f64, |largest, &d| largest.max(d));
        let relative: Vec<f64> = density.iter().map(|d| d / largest).collect();
        let pieces = pieces(&part, &relative);

        let moment = |of: &dyn Fn(f64) -> f64| -> f64 {
            // The integrand is of degree 6 at most.
            pieces
                .iter()
                .zip(part.windows(2))
                .map(|(p, ends)| integrate_short(ends[0], ends[1], |x| p.at(ends[1] - x, x - ends[0]) * of(x)))
                .sum()
        };
        let mass = moment(&|_| 1.0);
        let mean = moment(&|x| x) / mass;
        let square = |x: f64| (x - mean) * (x - mean);
        let variance = moment(&square) / mass;
        let deviation = variance.sqrt();
        if 1.0 > WIDEST_RANGE * deviation {
            let allowed = "must be at most 1e4: leave heights out that nearly no asperity has";
            return Err(Error::out_of_range("table_height range over standard deviation", 1.0 / deviation, allowed));
        }
        let highest = (1.0 - mean) / deviation;
        let origin = if highest <= FARTHEST_HIGHEST { highest } else { 0.0 };
        let zero = if origin == 0.0 { mean } else { 1.0 };
        let scale = deviation / mass;
        let scaled =
            |p: &DensityPiece| DensityPiece { lower: p.lower * scale, upper: p.upper * scale, bulge: p.bulge * scale };
        let last_rise = relative.windows(2).rposition(|ends| ends[1] > ends[0]);
        let knots: Vec<f64> = part.iter().map(|x| (x - zero) / deviation).collect();
        let outline = Outline {
            origin,
            support: (knots[0], knots[knots.len() - 1]),
            last_mode: knots[last_rise.map_or(0, |i| i + 1)],
            skew: moment(&|x| square(x) * (x - mean)) / mass / (variance * deviation),
            kurtosis: moment(&|x| square(x) * square(x)) / mass / (variance * variance),
            is_log_concave: false,
            is_piecewise_polynomial: true,
            ..GAUSSIAN
        };
        let pieces = pieces.iter().map(scaled).collect();
        Ok(Self { knots, pieces, outline })
    }

    /// The piece that holds a height of the support; at a height of the table the one below it.
    fn piece_of(&self, z: f64) -> usize {
        self.knots.partition_point(|&knot| knot < z).clamp(1, self.pieces.len()) - 1
    }

    fn density_on(&self, piece: usize, z: f64) -> f64 {
        self.pieces[piece].at(self.knots[piece + 1] - z, z - self.knots[piece])
    }

    fn density(&self, z: f64) -> f64 {
        let (lower, upper) = self.outline.support;
        if z < lower || z > upper {
            return 0.0;
        }
        self.density_on(self.piece_of(z), z)
    }
}

impl HeightDistribution for Tabulated {
    fn outline(&self) -> &Outline {
        &self.outline
    }

    fn log_density(&self, z: f64) -> f64 {
        log(self.density(z))
    }

    fn log_density_slope(&self, z: f64) -> f64 {
        let piece = self.piece_of(z);
        let density = self.density_on(piece, z);
        if density == 0.0 {
            return 0.0;
        }
        self.pieces[piece].slope(self.knots[piece + 1] - z, z - self.knots[piece]) / density
    }

    /// Nodes beyond those that are needed repeat one.
    fn densities(&self, z: [f64; POINTS]) -> [f64; POINTS] {
        // As a rule all nodes of a panel lie on one piece.
        let piece = self.piece_of(z[POINTS / 2]);
        let within = self.knots[piece]..=self.knots[piece + 1];
        let mut last = (f64::NAN, 0.0);
        z.map(|z| {
            if z != last.0 {
                last = (z, if within.contains(&z) { self.density_on(piece, z) } else { self.density(z) });
            }
            last.1
        })
    }

    /// Its singularities are its breakpoints.
    fn distance_to_singularity(&self, _z: f64) -> f64 {
        f64::INFINITY
    }

    fn breakpoints(&self) -> &[f64] {
        &self.knots
    }
}

/// Whether a table may have so many heights.
///
/// # Errors
/// [`Error::InvalidParameter`] for too few, [`Error::OutOfRange`] for too many.
pub fn check_length(length: usize) -> Result<(), Error> {
    let (name, value, (fewest, most)) = ("table_length", length as f64, TABLE_LENGTHS);
    if length < fewest {
        return Err(Error::invalid(name, value, "must be between 3 and 256"));
    }
    if length > most {
        let allowed =
            "must be between 3 and 256, as many as the law can resolve: smooth the density, or take wider bins";
        return Err(Error::out_of_range(name, value, allowed));
    }
    Ok(())
}

/// A table that has a meaning, without what lies beyond its support.
fn checked<'a>(height: &'a [f64], density: &'a [f64]) -> Result<(&'a [f64], &'a [f64]), Error> {
    check_length(height.len())?;
    if density.len() != height.len() {
        return Err(Error::invalid("length of table_density", density.len() as f64, "must be that of table_height"));
    }
    for (index, (&h, &d)) in height.iter().zip(density).enumerate() {
        let entry = |name, value: f64, allowed| Error::InvalidEntry { name, index, value, allowed };
        if !finite(h) {
            return Err(entry("table_height", h, "must be finite"));
        }
        if index > 0 && h <= height[index - 1] {
            return Err(entry("table_height", h, "must be greater than the height before it"));
        }
        if !finite(d) || d < 0.0 {
            return Err(entry("table_density", d, "must be finite and >= 0"));
        }
    }
    let (lowest, highest) = (height[0], height[height.len() - 1]);
    if lowest < -LARGEST_HEIGHT || highest > LARGEST_HEIGHT {
        let value = if highest > LARGEST_HEIGHT { highest } else { lowest };
        let allowed = "must be between -1e300 and 1e300; choose another unit";
        return Err(Error::out_of_range("table_height", value, allowed));
    }
    let Some(first) = density.iter().position(|&d| d > 0.0) else {
        return Err(Error::invalid("table_density", 0.0, "must be > 0 at one height at least"));
    };
    let last = density.iter().rposition(|&d| d > 0.0).unwrap_or(first);
    let support = first.saturating_sub(1)..(last + 2).min(height.len());
    let range = height[support.end - 1] - height[support.start];
    for index in support.clone().skip(1) {
        if height[index] - height[index - 1] < NEAREST * range {
            return Err(Error::InvalidEntry {
                name: "table_height",
                index,
                value: height[index],
                allowed: "must be greater than the height before it by 1e-12 of their range at least",
            });
        }
    }
    Ok((&height[support.clone()], &density[support]))
}

/// The density between each height and the next.
fn pieces(height: &[f64], density: &[f64]) -> Vec<DensityPiece> {
    let secants: Vec<f64> =
        height.windows(2).zip(density.windows(2)).map(|(h, d)| (d[1] - d[0]) / (h[1] - h[0])).collect();
    let slope = |i: usize| {
        if i == 0 || i == secants.len() {
            return secants[i.saturating_sub(1)];
        }
        let length = |i: usize| height[i + 1] - height[i];
        monotone_slope((length(i - 1), secants[i - 1]), (length(i), secants[i]))
    };
    (0..secants.len())
        .map(|i| {
            let rise = (density[i + 1] - density[i]).abs();
            // Six times what the mass over the length is above the mean of the two densities.
            let bulge = -0.5 * (height[i + 1] - height[i]) * (slope(i + 1) - slope(i));
            DensityPiece { lower: density[i], upper: density[i + 1], bulge: bulge.clamp(-rise, rise) }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uneven heights with uneven densities, zero in the middle and at one end.
    fn uneven(count: usize) -> (Vec<f64>, Vec<f64>) {
        let height = (0..count).map(|i| i as f64 + 0.3 * (i as f64).sin()).collect();
        let density = (0..count).map(|i| if i == 5 || i == 6 { 0.0 } else { 2.0 + (1.7 * i as f64).cos() });
        (height, density.collect())
    }

    /// The mean of a function of the height above the mean.
    fn mean(table: &Tabulated, f: impl Fn(f64) -> f64) -> f64 {
        let pieces = table.knots.windows(2);
        pieces.map(|ends| integrate_short(ends[0], ends[1], |z| table.density(z) * f(z + table.outline.origin))).sum()
    }

    #[test]
    fn the_density_is_that_of_the_table_at_its_heights_and_standardised() {
        let (height, density) = uneven(20);
        let table = Tabulated::new(&height, &density).expect("a table");
        let knots = &table.knots;
        let scale = (knots[19] - knots[0]) / (height[19] - height[0]);
        let unit = table.density(knots[3]) / density[3];
        for i in 0..20 {
            assert!((knots[i] - knots[0] - scale * (height[i] - height[0])).abs() < 1e-14, "{i}");
            assert!((table.density(knots[i]) - unit * density[i]).abs() < 1e-14, "{i}");
        }
        assert_eq!(table.outline.support, (knots[0], 0.0));
        assert_eq!([table.density(knots[0] - 1e-9), table.density(1e-9)], [0.0; 2]);
        let expected = [1.0, 0.0, 1.0, table.outline.skew, table.outline().kurtosis];
        for (power, expected) in expected.into_iter().enumerate() {
            let found = mean(&table, |z| z.powi(power as i32));
            assert!((found - expected).abs() < 1e-13, "moment {power}: {found}, not {expected}");
        }
        // Between two heights the density stays between theirs.
        for (i, ends) in knots.windows(2).enumerate() {
            for part in [0.1, 0.5, 0.9] {
                let found = table.density(ends[0] + part * (ends[1] - ends[0])) / unit;
                let (low, high) = (density[i].min(density[i + 1]), density[i].max(density[i + 1]));
                assert!(found > low - 1e-13 && found < high + 1e-13, "{found} between {low} and {high}");
            }
        }
    }

    #[test]
    fn above_the_last_mode_the_density_only_falls() {
        for (density, last) in
            [([1.0, 3.0, 2.0, 2.5, 1.0], 3), ([5.0, 4.0, 4.0, 1.0, 0.0], 0), ([0.0, 1.0, 2.0, 3.0, 4.0], 4)]
        {
            let table = Tabulated::new(&[0.0, 1.0, 2.0, 3.0, 4.0], &density).expect("a table");
            assert_eq!(table.outline.last_mode, table.knots[last]);
        }
    }
}
