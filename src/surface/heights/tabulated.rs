//! Heights of a measured density: a table, joined by a monotone cubic cumulative distribution and standardised.
//!
//! Between two heights of the table the density is a parabola through the two densities. Its mass is that of the monotone
//! cubic through them (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980, 238-246; slopes of Fritsch and Butland, SIAM J.
//! Sci. Stat. Comput. 5, 1984, 300-304), limited so that the parabola is monotonic. The cumulative distribution is then the
//! cubic Hermite interpolant of its values at the heights with the densities as slopes, and monotonic; no density is
//! negative, and none is larger than all of the table. Zero densities at the ends are left out up to the last one.

use crate::error::Error;
use crate::params::finite;
use crate::population::{integrate_short, nodes, POINTS};

/// How many heights a table may have.
pub const LENGTHS: (usize, usize) = (3, 4096);
/// No height of the support is farther from the mean, in standard deviations.
const FARTHEST: f64 = 1e4;
/// The highest height is made the origin unless it is farther from the mean than this, in standard deviations.
const FARTHEST_ORIGIN: f64 = 16.0;
/// Larger heights could overflow when combined.
const LARGEST_HEIGHT: f64 = 1e300;
/// Cells of at least so many pieces, as powers of two.
const SMALLEST_CELL: u32 = 3;
/// Neighbouring heights are at least this part of the range of the support apart: a step may be that steep.
const NEAREST: f64 = 1e-12;
/// What is nearer to a knot than this, relative to 1 or to its height, counts as at the knot.
const AT_KNOT: f64 = 4e-15;

/// A standardised density of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Tabulated {
    /// Heights of the support, from the origin.
    knots: Vec<f64>,
    /// The density between each and the next.
    pieces: Vec<Piece>,
    /// For each knot the one at or above it with the largest density.
    peaks: Vec<usize>,
    /// Cells of 8 pieces, 16, 32, ...
    cells: Vec<Vec<Cell>>,
    origin: f64,
    skew: f64,
    kurtosis: f64,
}

/// For a cell of many pieces the integrals of the density times the polynomials that are 1 at one Gauss point of the cell
/// and 0 at the others: with these weights the values there integrate what is smooth across the cell against the density.
type Cell = [f64; POINTS];

/// The density on a piece of the support: (1 - t) lower + t upper + t (1 - t) bulge with t from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    lower: f64,
    upper: f64,
    bulge: f64,
}

impl Piece {
    fn at(&self, below: f64, above: f64) -> f64 {
        let t = above / (above + below);
        let rest = below / (above + below);
        rest * self.lower + t * self.upper + t * rest * self.bulge
    }

    fn is_empty(&self) -> bool {
        self.lower == 0.0 && self.upper == 0.0
    }
}

impl Tabulated {
    /// The density of a table of heights in any unit and from any origin, which need not be normalised.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::InvalidEntry`] naming the first offence; [`Error::OutOfRange`].
    pub fn new(height: &[f64], density: &[f64]) -> Result<Self, Error> {
        let (height, density) = checked(height, density)?;
        // Heights as parts of the range of the support, densities as parts of the largest.
        let range = height[height.len() - 1] - height[0];
        let part: Vec<f64> = height.iter().map(|h| (h - height[0]) / range).collect();
        let largest = density.iter().fold(0.0_f64, |largest, &d| largest.max(d));
        let relative: Vec<f64> = density.iter().map(|d| d / largest).collect();
        let pieces = pieces(&part, &relative);

        let moment = |of: &dyn Fn(f64) -> f64| -> f64 {
            let integrals = pieces.iter().zip(part.windows(2)).filter(|(piece, _)| !piece.is_empty());
            // Of degree 6 at most.
            integrals
                .map(|(p, ends)| integrate_short(ends[0], ends[1], |x| p.at(ends[1] - x, x - ends[0]) * of(x)))
                .sum()
        };
        let mass = moment(&|_| 1.0);
        let mean = moment(&|x| x) / mass;
        let central = |power: i32| moment(&|x| (x - mean).powi(power)) / mass;
        let deviation = central(2).sqrt();
        if 1.0 > FARTHEST * deviation {
            return Err(Error::OutOfRange {
                name: "table_height range over standard deviation",
                value: (1.0 / deviation).into(),
                allowed: "must be at most 1e4: leave heights out that nearly no summit has",
            });
        }
        let highest = (1.0 - mean) / deviation;
        let origin = if highest <= FARTHEST_ORIGIN { highest } else { 0.0 };
        let zero = if origin == 0.0 { mean } else { 1.0 };
        let scale = deviation / mass;
        let scaled = |p: &Piece| Piece { lower: p.lower * scale, upper: p.upper * scale, bulge: p.bulge * scale };
        let mut peaks: Vec<usize> = (0..part.len()).collect();
        for i in (0..part.len() - 1).rev() {
            if relative[peaks[i + 1]] > relative[i] {
                peaks[i] = peaks[i + 1];
            }
        }
        let knots: Vec<f64> = part.iter().map(|x| (x - zero) / deviation).collect();
        let pieces: Vec<Piece> = pieces.iter().map(scaled).collect();
        Ok(Self {
            cells: cells(&knots, &pieces),
            knots,
            pieces,
            peaks,
            origin,
            skew: central(3) / deviation.powi(3),
            kurtosis: central(4) / deviation.powi(4),
        })
    }

    /// Third standardised moment.
    pub fn skew(&self) -> f64 {
        self.skew
    }

    /// Fourth standardised moment.
    pub fn kurtosis(&self) -> f64 {
        self.kurtosis
    }

    /// The height above the mean from which heights are measured.
    pub fn origin(&self) -> f64 {
        self.origin
    }

    /// The ends of the support.
    pub fn support(&self) -> (f64, f64) {
        (self.knots[0], self.knots[self.knots.len() - 1])
    }

    /// The heights where the density is not smooth.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The density.
    pub fn density(&self, z: f64) -> f64 {
        let above = self.knots.partition_point(|&knot| knot < z);
        if above == 0 || above == self.knots.len() {
            // At the foot itself the edge of contact needs the density above it.
            return if z == self.knots[0] { self.pieces[0].lower } else { 0.0 };
        }
        self.pieces[above - 1].at(self.knots[above] - z, z - self.knots[above - 1])
    }

    /// The height at or above another where the density is largest, to the order of magnitude.
    pub fn peak_above(&self, start: f64) -> f64 {
        match self.peaks.get(self.next_knot(start)) {
            Some(&peak) if self.density(self.knots[peak]) > self.density(start) => self.knots[peak],
            _ => start,
        }
    }

    /// How far above z the density is a polynomial.
    pub fn smooth_length(&self, z: f64) -> f64 {
        let next = self.next_knot(z);
        self.knots.get(next).map_or(f64::MAX, |knot| knot - z)
    }

    /// How far below a height the density is a polynomial.
    pub fn smooth_length_below(&self, z: f64) -> f64 {
        let z = z - AT_KNOT * (1.0 + z.abs());
        let next = self.knots.partition_point(|&knot| knot < z);
        if next == 0 {
            f64::MAX
        } else {
            z - self.knots[next - 1]
        }
    }

    /// The longest cell that begins at a height and is no longer than this: its length, and its weights for the points of
    /// [`nodes`].
    pub fn cell(&self, z: f64, longest: f64) -> Option<(f64, &[f64; POINTS])> {
        let first = self.next_knot(z).checked_sub(1)?;
        if (self.knots[first] - z).abs() > AT_KNOT * (1.0 + z.abs()) {
            return None;
        }
        (0..self.cells.len()).rev().find_map(|level| {
            let shift = SMALLEST_CELL + level as u32;
            let weights = self.cells[level].get(first >> shift)?;
            let is_start = first.is_multiple_of(1 << shift);
            let length = is_start.then(|| self.knots[first + (1 << shift)] - z)?;
            (length <= longest).then_some((length, weights))
        })
    }

    /// Whether the density is a polynomial between two heights.
    pub fn is_smooth(&self, from: f64, to: f64) -> bool {
        let slack = AT_KNOT * (1.0 + to.abs());
        // Also what is nearer to the last knot than that ends there: there may be nothing else in contact.
        to - from <= self.smooth_length(from) + slack && to <= self.support().1 + slack
    }

    /// The first knot above a height.
    fn next_knot(&self, z: f64) -> usize {
        let z = z + AT_KNOT * (1.0 + z.abs());
        self.knots.partition_point(|&knot| knot <= z)
    }
}

/// The weights of all cells: each integral is that of a polynomial of degree 17 on each piece.
fn cells(knots: &[f64], pieces: &[Piece]) -> Vec<Vec<Cell>> {
    let points: Vec<f64> = nodes(0.0, 1.0).map(|(x, _)| x).collect();
    let scales: Vec<f64> = points
        .iter()
        .map(|x| 1.0 / points.iter().filter(|other| *other != x).map(|other| x - other).product::<f64>())
        .collect();
    let cell = |from: usize, to: usize| {
        let (start, length) = (knots[from], knots[to] - knots[from]);
        let mut weights = [0.0; POINTS];
        for (piece, ends) in pieces[from..to].iter().zip(knots[from..=to].windows(2)) {
            if piece.is_empty() {
                continue;
            }
            for (z, weight) in nodes(ends[0], ends[1]) {
                let mass = weight * piece.at(ends[1] - z, z - ends[0]);
                let x = (z - start) / length;
                let all: f64 = points.iter().map(|point| x - point).product();
                for ((weight, point), scale) in weights.iter_mut().zip(&points).zip(&scales) {
                    // Next to a Gauss point of the cell its own polynomial is 1, the others are 0.
                    let distance = x - point;
                    *weight += if distance == 0.0 { mass } else { mass * all / distance * scale };
                }
            }
        }
        weights
    };
    let mut levels = Vec::new();
    for shift in SMALLEST_CELL.. {
        let count = pieces.len() >> shift;
        if count == 0 {
            return levels;
        }
        levels.push((0..count).map(|i| cell(i << shift, (i + 1) << shift)).collect());
    }
    levels
}

/// A table that has a meaning, without what lies beyond its support.
fn checked<'a>(height: &'a [f64], density: &'a [f64]) -> Result<(&'a [f64], &'a [f64]), Error> {
    let (fewest, most) = LENGTHS;
    let invalid = |name, value: usize, allowed| Error::InvalidParameter { name, value: (value as f64).into(), allowed };
    if height.len() < fewest || height.len() > most {
        return Err(invalid("table_length", height.len(), "must be between 3 and 4096"));
    }
    if density.len() != height.len() {
        return Err(invalid("length of table_density", density.len(), "must be that of table_height"));
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
        return Err(Error::OutOfRange {
            name: "table_height",
            value: value.into(),
            allowed: "must be between -1e300 and 1e300; choose another unit",
        });
    }
    let Some(first) = density.iter().position(|&d| d > 0.0) else {
        return Err(Error::InvalidParameter {
            name: "table_density",
            value: 0.0.into(),
            allowed: "must be > 0 at one height at least",
        });
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
fn pieces(height: &[f64], density: &[f64]) -> Vec<Piece> {
    let secants: Vec<f64> =
        height.windows(2).zip(density.windows(2)).map(|(h, d)| (d[1] - d[0]) / (h[1] - h[0])).collect();
    let slope = |i: usize| {
        if i == 0 || i == secants.len() {
            return secants[i.saturating_sub(1)];
        }
        let (before, after) = (secants[i - 1], secants[i]);
        if (before > 0.0) != (after > 0.0) || before == 0.0 || after == 0.0 {
            return 0.0;
        }
        let (left, right) = (height[i] - height[i - 1], height[i + 1] - height[i]);
        let (w1, w2) = (2.0 * right + left, right + 2.0 * left);
        (w1 + w2) / (w1 / before + w2 / after)
    };
    (0..secants.len())
        .map(|i| {
            let rise = (density[i + 1] - density[i]).abs();
            // Six times what the mass over the length is above the mean of the two densities.
            let bulge = -0.5 * (height[i + 1] - height[i]) * (slope(i + 1) - slope(i));
            Piece { lower: density[i], upper: density[i + 1], bulge: bulge.clamp(-rise, rise) }
        })
        .collect()
}
