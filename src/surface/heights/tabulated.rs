//! Heights of a measured density: a table, joined by a monotone cubic cumulative distribution and standardised.
//!
//! Between two heights of the table the density is a parabola through the two densities. Its mass is that of the monotone
//! cubic through them (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980, 238-246; slopes of Fritsch and Butland, SIAM J.
//! Sci. Stat. Comput. 5, 1984, 300-304), limited so that the parabola is monotonic. The cumulative distribution is then the
//! cubic Hermite interpolant of its values at the heights with the densities as slopes, and monotonic; no density is
//! negative, and none is larger than all of the table. Zero densities at the ends are left out up to the last one.

use crate::error::Error;
use crate::float_bits::finite;
use crate::gauss_legendre::{integrate_short, nodes, POINTS};

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
            // Of degree 6 at most.
            pieces
                .iter()
                .zip(part.windows(2))
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
        if before.signum() != after.signum() {
            return 0.0;
        }
        // A harmonic mean: also 0 where one of the two is.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Value;

    fn near(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance * b.abs()
    }

    /// Uneven heights with uneven densities, zero in the middle and at one end.
    fn uneven(count: usize) -> (Vec<f64>, Vec<f64>) {
        let height = (0..count).map(|i| i as f64 + 0.3 * (i as f64).sin()).collect();
        let density = (0..count).map(|i| if i == 5 || i == 6 { 0.0 } else { 2.0 + (1.7 * i as f64).cos() });
        (height, density.collect())
    }

    /// The mean of a function of the height above the mean.
    fn mean(table: &Tabulated, f: impl Fn(f64) -> f64) -> f64 {
        let pieces = table.knots().windows(2);
        pieces.map(|ends| integrate_short(ends[0], ends[1], |z| table.density(z) * f(z + table.origin()))).sum()
    }

    #[test]
    fn the_density_is_that_of_the_table_at_its_heights_and_standardised() {
        let (height, density) = uneven(20);
        let table = Tabulated::new(&height, &density).expect("a table");
        let knots = table.knots();
        let scale = (knots[19] - knots[0]) / (height[19] - height[0]);
        let unit = table.density(knots[3]) / density[3];
        for i in 0..20 {
            assert!((knots[i] - knots[0] - scale * (height[i] - height[0])).abs() < 1e-14, "{i}");
            assert!((table.density(knots[i]) - unit * density[i]).abs() < 1e-14, "{i}");
        }
        assert_eq!(table.support(), (knots[0], 0.0));
        assert_eq!([table.density(knots[0] - 1e-9), table.density(1e-9)], [0.0; 2]);
        let expected = [1.0, 0.0, 1.0, table.skew(), table.kurtosis()];
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

    /// A straight line has the mass of its trapezium, a parabola through three points nearly that of Simpson's rule.
    #[test]
    fn masses_of_pieces_are_those_of_the_monotone_cubic() {
        let line = Tabulated::new(&[0.0, 1.0, 2.0, 4.0], &[0.0, 1.0, 2.0, 4.0]).expect("a table");
        assert!(near(line.skew(), -0.4 * 2.0_f64.sqrt(), 1e-13), "{}", line.skew());
        assert!(near(line.kurtosis(), 2.4, 1e-13), "{}", line.kurtosis());
        // Slopes of Fritsch and Butland: secants at the ends; of 2 and 1.5 over lengths 2 and 1, (4 + 5)/(4/2 + 5/1.5).
        let bent = pieces(&[1.0, 3.0, 4.0], &[0.5, 4.5, 6.0]);
        let middle = 9.0 / (4.0 / 2.0 + 5.0 / 1.5);
        let expected = [-0.5 * 2.0 * (middle - 2.0), -0.5 * (1.5 - middle)];
        assert!(near(bent[0].bulge, expected[0], 1e-14) && near(bent[1].bulge, expected[1], 1e-14), "{bent:?}");
        // A maximum is flat, and the bulge no more than the rise.
        let peak = pieces(&[0.0, 1.0, 2.0], &[0.0, 1.0, 0.0]);
        assert_eq!([peak[0].bulge, peak[1].bulge], [0.5, 0.5]);
        // So is where it begins to be constant.
        for density in [[0.0, 1.0, 1.0], [1.0, 1.0, 2.0], [2.0, 1.0, 1.0], [1.0, 1.0, 0.0]] {
            let level = pieces(&[0.0, 1.0, 2.0], &density);
            let bulges = [0.5 * (density[1] - density[0]), -0.5 * (density[2] - density[1])];
            assert_eq!([level[0].bulge, level[1].bulge], bulges, "{density:?}");
        }
        let steep = pieces(&[0.0, 1.0, 11.0, 11.1], &[1.0, 0.5, 1.5, 100.0]);
        assert_eq!(steep[1].bulge, -1.0);
        // A parabola through three points.
        assert_eq!(Piece { lower: 1.0, upper: 3.0, bulge: 2.0 }.at(1.0, 3.0), 2.875);
    }

    #[test]
    fn zeros_at_the_ends_are_left_out_up_to_the_last() {
        let height = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let support = |density: &[f64; 7]| {
            let (height, of_support) = checked(&height, density).expect("a table");
            assert_eq!(height.len(), of_support.len());
            (height[0], height[height.len() - 1])
        };
        assert_eq!(support(&[0.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0]), (1.0, 4.0));
        assert_eq!(support(&[0.0, 1.0, 1.0, 2.0, 0.0, 1.0, 0.0]), (0.0, 6.0));
        assert_eq!(support(&[1.0; 7]), (0.0, 6.0));
        assert_eq!(support(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]), (5.0, 6.0));
        assert_eq!(support(&[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]), (0.0, 1.0));
        // They must be in order all the same.
        let refused = checked(&[0.0, 2.0, 1.0, 3.0, 4.0, 5.0], &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
        assert!(matches!(refused, Err(Error::InvalidEntry { index: 2, .. })), "{refused:?}");
        for unit in [1e-9, 1e9] {
            let at = |x: f64| unit * (7.0 + x);
            let near = |apart: f64| checked(&[at(0.0), at(1.0), at(1.0 + apart), at(2.0)], &[1.0; 4]).is_ok();
            assert_eq!([near(0.9 * 2.0 * NEAREST), near(1.1 * 2.0 * NEAREST)], [false, true], "{unit:e}");
        }
        assert!(checked(&[0.0, NEAREST, 1.0], &[1.0; 3]).is_ok());
    }

    #[test]
    fn tables_are_taken_up_to_the_limits_and_no_further() {
        let table = |count: usize| {
            let height: Vec<f64> = (0..count).map(|i| i as f64).collect();
            Tabulated::new(&height, &vec![1.0; count]).map(|table| table.knots().len())
        };
        for (count, taken) in [(2, false), (3, true), (4096, true), (4097, false)] {
            assert_eq!(table(count).is_ok(), taken, "{count}");
        }
        let high = |highest: f64| Tabulated::new(&[-LARGEST_HEIGHT, 0.0, highest], &[1.0; 3]).is_ok();
        let low = |lowest: f64| Tabulated::new(&[lowest, 0.0, LARGEST_HEIGHT], &[1.0; 3]).is_ok();
        assert!(high(LARGEST_HEIGHT) && !high(LARGEST_HEIGHT.next_up()));
        assert!(low(-LARGEST_HEIGHT) && !low((-LARGEST_HEIGHT).next_down()));
        // The message names the one that is too large.
        let far = Tabulated::new(&[-2.0 * LARGEST_HEIGHT, 0.0, LARGEST_HEIGHT], &[1.0; 3]);
        assert!(
            matches!(far, Err(Error::OutOfRange { value, .. }) if value == (-2.0 * LARGEST_HEIGHT).into()),
            "{far:?}"
        );
        // All but all of the summits within a small part of the range.
        let narrow = |far: f64| Tabulated::new(&[0.0, 1.0, 2.0, far], &[1.0, 1.0, 0.0, 1e-300]);
        let deviation = 1.0 / narrow(100.0).map(|table| table.knots()[1] - table.knots()[0]).expect("a table");
        assert!(narrow(0.999 * FARTHEST * deviation).is_ok());
        let refused = narrow(2.0 * FARTHEST * deviation);
        let Err(Error::OutOfRange { value: Value::Real(range), .. }) = refused else { panic!("{refused:?}") };
        assert!(near(range, 2.0 * FARTHEST, 1e-9), "{range}");
        // The highest height is the origin where it is near.
        let origin = |far: f64| narrow(far).expect("a table").origin();
        assert!(origin(15.0 * deviation) > 10.0 && origin(18.0 * deviation) == 0.0);
    }

    #[test]
    fn lengths_reach_from_knot_to_knot() {
        let (height, density) = uneven(20);
        let table = Tabulated::new(&height, &density).expect("a table");
        let knots = table.knots().to_vec();
        let tiny = 1e-15;
        for (i, ends) in knots.windows(2).enumerate() {
            let [from, to] = [ends[0], ends[1]];
            let middle = 0.5 * (from + to);
            for z in [from, from * (1.0 + tiny), from * (1.0 - tiny)] {
                assert!(near(table.smooth_length(z), to - from, 1e-12), "{i}");
                assert!(table.is_smooth(z, to) && table.is_smooth(z, to * (1.0 - tiny)), "{i}");
                assert!(!table.is_smooth(z, to + 1e-9), "{i}");
            }
            assert!(near(table.smooth_length(middle), to - middle, 1e-12), "{i}");
            assert!(near(table.smooth_length_below(middle), middle - from, 1e-12), "{i}");
            assert!(near(table.smooth_length_below(to), to - from, 1e-12), "{i}");
        }
        assert_eq!(table.smooth_length(1.0), f64::MAX);
        assert_eq!(table.smooth_length_below(knots[0]), f64::MAX);
        assert!(!table.is_smooth(-0.1, 0.1));
        // The largest density at or above.
        for start in [knots[0] - 1.0, knots[4], 0.5 * (knots[8] + knots[9]), knots[19]] {
            let peak = table.peak_above(start);
            let above = knots.iter().filter(|&&knot| knot >= start);
            let largest = above.fold(table.density(start), |largest, &knot| largest.max(table.density(knot)));
            assert!(peak >= start && table.density(peak) == largest, "{start}: {peak}");
        }
    }

    /// What rounds to a knot is at it, next to the origin and far from it; what is farther away is not.
    #[test]
    fn what_is_nearly_at_a_knot_is_at_it() {
        // Both ends of the support far from the mean in standard deviations, or the head the origin.
        let far: Vec<f64> = [0.0].into_iter().chain((0..16).map(|i| 1e4 + f64::from(i))).collect();
        let mut density = vec![1.0; 17];
        (density[0], density[1]) = (1e-9, 0.0);
        let mirrored: Vec<f64> = far.iter().rev().map(|h| 2e4 - h).collect();
        let reversed: Vec<f64> = density.iter().rev().copied().collect();
        for (height, density) in [(far, density), (mirrored, reversed)] {
            let table = Tabulated::new(&height, &density).expect("a table");
            let knots = table.knots().to_vec();
            let farthest = knots[0].abs().max(knots[16]);
            assert!(farthest > 1e3, "{farthest}");
            for i in 1..16 {
                let (below, knot, above) = (knots[i - 1], knots[i], knots[i + 1]);
                let apart = |part: f64| part * AT_KNOT * (1.0 + knot.abs());
                for z in [-0.5, 0.0, 0.5].map(|part| knot + apart(part)) {
                    assert!(near(table.smooth_length(z), above - knot, 1e-9), "{z}");
                    assert!(near(table.smooth_length_below(z), knot - below, 1e-9), "{z}");
                    assert!(table.is_smooth(below, z) && table.is_smooth(z, above), "{z}");
                    assert_eq!(table.cell(z, f64::MAX).is_some(), i == 8, "{z}, {i}");
                }
                let (lower, upper) = (knot - apart(8.0), knot + apart(8.0));
                assert!(table.smooth_length(lower) < 1e-9 && table.smooth_length_below(upper) < 1e-9, "{knot}");
                assert!(!table.is_smooth(knot - 0.1, upper), "{knot}");
                assert!(table.cell(lower, f64::MAX).is_none() && table.cell(upper, f64::MAX).is_none(), "{knot}");
            }
            let head = knots[16];
            let apart = |part: f64| part * AT_KNOT * (1.0 + head.abs());
            assert!(table.is_smooth(knots[15], head + apart(0.5)) && !table.is_smooth(knots[15], head + apart(8.0)));
            assert!(near(table.smooth_length_below(head + apart(0.5)), head - knots[15], 1e-9));
            // From the top down in about as many panels as there are pieces.
            let (mut z, mut panels) = (head, 0);
            while z > knots[0] + 1e-9 && panels < 100 {
                z -= table.smooth_length_below(z);
                panels += 1;
            }
            assert!(panels <= 32, "{panels} of {head}");
        }
    }

    /// Of a function that is smooth across a cell, against the sum over its pieces.
    #[test]
    fn cells_integrate_against_the_density() {
        let (height, density) = uneven(45);
        let table = Tabulated::new(&height, &density).expect("a table");
        let knots = table.knots().to_vec();
        let smooth = |z: f64| (0.9 * z).sin() + 2.0;
        for (first, longest, pieces) in [
            (0, f64::MAX, Some(32)),
            (0, knots[32] - knots[0], Some(32)),
            (0, knots[32] - knots[0] - 1e-9, Some(16)),
            (8, f64::MAX, Some(8)),
            (16, f64::MAX, Some(16)),
            (32, f64::MAX, Some(8)),
            (32, 1e-3, None),
            (40, f64::MAX, None),
            (4, f64::MAX, None),
        ] {
            let found = table.cell(knots[first], longest);
            assert_eq!(found.is_some(), pieces.is_some(), "from {first}");
            let (Some((length, weights)), Some(pieces)) = (found, pieces) else { continue };
            assert!(near(length, knots[first + pieces] - knots[first], 1e-12), "from {first}: {length}");
            let sum: f64 = nodes(0.0, 1.0).zip(weights).map(|((x, _), w)| w * smooth(knots[first] + x * length)).sum();
            let whole: f64 = knots[first..=first + pieces]
                .windows(2)
                .map(|ends| integrate_short(ends[0], ends[1], |z| table.density(z) * smooth(z)))
                .sum();
            assert!(near(sum, whole, 1e-9), "from {first}: {sum}, not {whole}");
        }
        assert!(table.cell(knots[8] + 1e-9, f64::MAX).is_none() && table.cell(knots[0] - 1.0, f64::MAX).is_none());
    }
}
