//! Rows filled from the law: whole, or in as many parts as it takes.

use super::row::{coefficients, compared, polynomial, Row, DIVISIONS, ROW_CHECKS, ROW_NODES};
use super::table::Table;
use super::tolerance::larger;
use crate::numerics::ascending;
use crate::numerics::elementary::{exp, log, log1p};
use std::f64::consts::LN_2;
use std::ops::Range;

/// Where the law is asked for a row: where it is determined, where it is compared, and at its end.
const ROW_PARTS: [f64; 8] =
    [ROW_NODES[0], ROW_NODES[1], ROW_NODES[2], ROW_NODES[3], ROW_CHECKS[0], ROW_CHECKS[1], ROW_CHECKS[2], 1.0];
/// A link leads to so many rows.
const LINKED: usize = DIVISIONS + 1;
/// The most pieces of a row: links of three levels.
const MOST_PIECES_OF_ROW: usize = LINKED * LINKED * LINKED;
/// Next to where the law is not smooth it may be a non-integer power of the distance, which takes shorter and shorter
/// pieces: by this factor.
const NEXT_TO_JOINT: f64 = 0.125;
/// No piece is shorter than this part of its row: x has few digits more.
const SHORTEST_PIECE: f64 = 1e-8;

/// The law, as rows are filled from it: a value in the caller's units and its slope by ln x. The places of a call are near to each
/// other. x is in the units of the model.
pub trait Source {
    fn at<const N: usize>(&self, log_x: [f64; N]) -> [(f64, f64); N];
    /// ln x between two of them where the law is not smooth, rising.
    fn joints(&self, lower: f64, upper: f64) -> Vec<f64>;
    /// Smaller values are known to the same part of this one as larger ones of themselves.
    fn least(&self) -> f64 {
        0.0
    }
}

/// What rows are filled from.
pub struct Filling<'a, S> {
    source: &'a S,
    /// ln of the caller's unit of x.
    log_unit: f64,
    /// Rows per binade, and the part of a mantissa that each takes.
    per_binade: u64,
    width: f64,
}

impl<'a, S: Source> Filling<'a, S> {
    /// From a source, of which 1 is so much in the caller's units of x, rows of a fraction 1/2^`fraction` of a binade.
    pub fn new(source: &'a S, unit: f64, fraction: u32) -> Self {
        let per_binade = 1 << fraction;
        Self { source, log_unit: log(unit), per_binade, width: 1.0 / per_binade as f64 }
    }

    /// Fills so many rows of a table. Those that miss the law are divided into pieces, as far as a table of `most` rows and pieces has
    /// room. The largest error found.
    pub fn rows(&self, table: &mut Table, count: usize, most: usize) -> f64 {
        let (mut worst, mut missed) = (0.0_f64, Vec::new());
        table.rows.reserve(count);
        let mut left = None;
        for index in 0..count {
            let place = self.place(table.base + index as u64);
            let piece = self.piece(&place, (0.0, self.width), left);
            table.rows.push(piece.row);
            if piece.is_good {
                worst = worst.max(piece.error);
            } else {
                missed.push((index, piece.error));
            }
            left = Some(piece.right);
        }
        table.row_count = count;
        // The heaviest first.
        for (row, error) in missed.into_iter().rev() {
            worst = worst.max(self.divide(table, row, most.saturating_sub(table.rows.len())).unwrap_or(error));
        }
        table.rows.shrink_to_fit();
        worst
    }

    fn place(&self, row: u64) -> Place {
        let start = (row % self.per_binade) as f64 * self.width;
        let log_binade = log_binade(row / self.per_binade) - self.log_unit;
        let mut place = Place { start, log_binade, joints: Vec::new() };
        let joints = self.source.joints(place.log(0.0), place.log(self.width));
        place.joints = joints.into_iter().map(|joint| exp(joint - log_binade) - 1.0 - start).collect();
        place
    }

    /// Replaces a row by a link to pieces, if there is room for so many more rows; the largest error of these.
    fn divide(&self, table: &mut Table, row: usize, room: usize) -> Option<f64> {
        let (pieces, error) = self.pieces(table.base + row as u64, room)?;
        table.rows[row] = linked(&mut table.rows, &pieces, self.width);
        Some(error)
    }

    /// Polynomials for the parts of a row, as few as are good or there is room for, and their largest error.
    fn pieces(&self, row: u64, room: usize) -> Option<(Vec<(f64, Row)>, f64)> {
        // Links take room too: one for each LINKED rows that they lead to.
        let most = MOST_PIECES_OF_ROW.min((room * DIVISIONS / LINKED).checked_sub(1).filter(|&most| most > 0)?);
        let place = self.place(row);
        let fill = |begin: f64, end: f64| self.piece(&place, (begin, end), None);
        let mut pieces = vec![fill(0.0, self.width)];
        // The longest first: if there is not room for all, those that miss the law are short.
        let mut shortest = 1.0;
        while shortest >= SHORTEST_PIECE {
            let mut i = 0;
            while i < pieces.len() {
                let RowPiece { begin, end, is_good, .. } = pieces[i];
                if !is_good && end - begin >= shortest * self.width && pieces.len() < most {
                    let at = division(&place.joints, begin, end);
                    pieces.splice(i..=i, [fill(begin, at), fill(at, end)]);
                } else {
                    i += 1;
                }
            }
            shortest *= NEXT_TO_JOINT;
        }
        let worst = pieces.iter().fold(0.0, |worst: f64, piece| worst.max(piece.error));
        Some((pieces.iter().map(|piece| (piece.begin, piece.row)).collect(), worst))
    }

    /// The polynomial of a part of a row, of which the value and the slope by ln x where it begins may be known.
    fn piece(&self, place: &Place, (begin, end): (f64, f64), left: Option<(f64, f64)>) -> RowPiece {
        let length = end - begin;
        let left = left.unwrap_or_else(|| self.source.at([place.log(begin)])[0]);
        let law = self.source.at(ROW_PARTS.map(|part| place.log(begin + part * length)));
        // By the part of the piece.
        let rate = |(value, slope): (f64, f64), part: f64| {
            (value, slope * length / (1.0 + place.start + begin + part * length))
        };
        let interior = [law[0].0, law[1].0, law[2].0, law[3].0];
        let coefficients = coefficients(rate(left, 0.0), rate(law[7], 1.0), interior);
        let (mut error, mut miss) = (0.0, 0.0);
        for (part, exact) in ROW_CHECKS.into_iter().zip(&law[4..7]) {
            let found = self.compared(polynomial(&coefficients, part), rate(*exact, part), length);
            (error, miss) = (larger(error, found.0), larger(miss, found.1));
        }
        // Where the law is not smooth within it, it is farthest off.
        for &joint in place.joints.iter().filter(|&&joint| joint > begin && joint < end) {
            let part = (joint - begin) / length;
            let [exact] = self.source.at([place.log(joint)]);
            let found = self.compared(polynomial(&coefficients, part), rate(exact, part), length);
            (error, miss) = (larger(error, found.0), larger(miss, found.1));
        }
        let row = Row::of_length(coefficients, length);
        RowPiece { begin, end, row, error, is_good: miss <= 1.0, right: law[7] }
    }

    /// The error of a value, and that of it or its slope over their tolerance; the slope is by so much of the mantissa.
    fn compared(&self, found: (f64, f64), exact: (f64, f64), length: f64) -> (f64, f64) {
        let least = self.source.least();
        compared(found, exact, (least, least * length))
    }
}

/// Where a row begins, by mantissa less one, and ln of the beginning of its binade in the units of the model.
struct Place {
    start: f64,
    log_binade: f64,
    /// How far into it the law is not smooth, by mantissa.
    joints: Vec<f64>,
}

impl Place {
    /// ln x at so much of the mantissa beyond its beginning.
    fn log(&self, t: f64) -> f64 {
        log1p(self.start + t) + self.log_binade
    }
}

/// A part of a row: where in it it begins and ends, by mantissa, its polynomial with its error, and whether that is good.
#[derive(Clone, Copy)]
struct RowPiece {
    begin: f64,
    end: f64,
    row: Row,
    error: f64,
    is_good: bool,
    /// Value and slope by ln x where it ends.
    right: (f64, f64),
}

/// The row of a piece, or a link to those of several, which are appended to `rows`.
fn linked(rows: &mut Vec<Row>, pieces: &[(f64, Row)], end: f64) -> Row {
    if let [(_, row)] = pieces {
        return *row;
    }
    let begins: Vec<f64> = pieces.iter().map(|(begin, _)| *begin).collect();
    let groups = groups(&begins, end);
    let first = rows.len();
    rows.extend(groups.iter().map(|group| pieces[group.start].1));
    for (i, group) in groups.iter().enumerate() {
        let end = begins.get(group.end).copied().unwrap_or(end);
        rows[first + i] = linked(rows, &pieces[group.clone()], end);
    }
    Row::link(first, &groups[1..].iter().map(|group| begins[group.start]).collect::<Vec<f64>>())
}

/// The pieces to which each place of a link leads: one, or several by another link. The widest pieces are alone, so that most loads
/// follow one link.
fn groups(begins: &[f64], end: f64) -> Vec<Range<usize>> {
    let ends = begins[1..].iter().chain([&end]);
    let less_by_length: Vec<f64> = ends.zip(begins).map(|(end, begin)| begin - end).collect();
    let by_length = ascending(&less_by_length);
    // As many as links hold of as few levels as can be.
    let mut largest = LINKED;
    while largest * LINKED < begins.len() {
        largest *= LINKED;
    }
    let alone_in = |alone: &[usize]| {
        let mut groups: Vec<Range<usize>> = Vec::new();
        for piece in 0..begins.len() {
            match groups.last_mut() {
                Some(group) if group.len() < largest && !alone.contains(&piece) && !alone.contains(&group.start) => {
                    group.end += 1;
                }
                _ => groups.push(piece..piece + 1),
            }
        }
        groups
    };
    let most = begins.len().min(LINKED);
    let mut found = (1..=most).rev().map(|count| alone_in(&by_length[..count])).filter(|groups| groups.len() <= LINKED);
    found.next().unwrap_or_else(|| alone_in(&[]))
}

/// Where to divide a piece: where the law is not smooth, next to the middle; else next to an end where it is not, or in the
/// middle.
fn division(joints: &[f64], begin: f64, end: f64) -> f64 {
    let middle = 0.5 * (begin + end);
    let margin = SHORTEST_PIECE * (end - begin);
    let within = joints.iter().copied().filter(|&joint| joint > begin + margin && joint < end - margin);
    let near_end = match (joints.contains(&begin), joints.contains(&end)) {
        (true, false) => begin + NEXT_TO_JOINT * (end - begin),
        (false, true) => end - NEXT_TO_JOINT * (end - begin),
        _ => middle,
    };
    within.min_by(|a, b| (a - middle).abs().total_cmp(&(b - middle).abs())).unwrap_or(near_end)
}

/// ln of the beginning of the binade with these bits.
fn log_binade(bits: u64) -> f64 {
    (bits as f64 - 1023.0) * LN_2
}

#[cfg(test)]
mod tests {
    use super::super::tolerance;
    use super::*;

    /// A law and the slope of its logarithm by ln x, where that is not smooth, and its unit.
    struct Law<F>(F, Option<f64>, f64);

    const FRACTION: u32 = 2;
    const WIDTH: f64 = 0.25;

    /// The caller's units of x and of the value.
    #[derive(Clone, Copy)]
    struct Scale {
        load: f64,
        value: f64,
    }

    impl<F: Fn(f64) -> (f64, f64)> Source for Law<F> {
        fn at<const N: usize>(&self, log_x: [f64; N]) -> [(f64, f64); N] {
            log_x.map(|log_x| {
                let (value, power) = self.0(log_x);
                (self.2 * value, self.2 * value * power)
            })
        }

        fn joints(&self, lower: f64, upper: f64) -> Vec<f64> {
            self.1.into_iter().filter(|&at| at > lower && at < upper).collect()
        }
    }

    /// The rows of a law from x = 1 on, divided where there is room for so many pieces, and the largest error.
    fn filled(
        law: impl Fn(f64) -> (f64, f64),
        joint: Option<f64>,
        scale: Scale,
        count: usize,
        room: usize,
    ) -> (Table, f64) {
        let source = Law(law, joint, scale.value);
        let mut table = Table::new(FRACTION, 1_f64.to_bits() >> Table::shift_of(FRACTION), 0.0);
        let error = Filling::new(&source, scale.load, FRACTION).rows(&mut table, count, count + room);
        assert!(table.rows.len() <= count + room, "{}", table.rows.len());
        (table, error)
    }

    fn assert_on_the_law(table: &Table, law: impl Fn(f64) -> (f64, f64), scale: Scale, end: f64) {
        for i in 0..3000 {
            let x = end.powf((f64::from(i) + 0.5) / 3000.0);
            let (force, slope) = table.at_load(x).expect("it answers");
            let (exact, power) = law((x / scale.load).ln());
            let exact = scale.value * exact;
            assert!((force / exact - 1.0).abs() < 2.0 * tolerance::VALUE, "{x}: {force}, not {exact}");
            assert!((slope * x / exact / power - 1.0).abs() < 2.0 * tolerance::SLOPE, "{x}: slope {slope}");
        }
    }

    /// F = x^(2/3), of which the slope falls from a load on: over three binades, with a kink in the sixth row.
    #[test]
    fn rows_lie_on_the_law_and_a_row_with_a_kink_has_two_parts() {
        let scale = Scale { load: 3.0, value: 0.5 };
        let at = (2.6_f64 * 1.1 / scale.load).ln();
        let law = |log_excess: f64| {
            let beyond = (log_excess - at).max(0.0);
            (exp(2.0 / 3.0 * log_excess - 0.15 * beyond * beyond), 2.0 / 3.0 - 0.3 * beyond)
        };
        let (table, error) = filled(law, Some(at), scale, 12, 100);
        assert!(error < 5e-11 && error > 1e-17, "{error:e}");
        assert_eq!((table.row_count, table.rows.len()), (12, 14));
        let links: Vec<usize> = (0..12).filter(|&row| table.rows[row].is_link()).collect();
        assert_eq!(links, [5]);
        assert_on_the_law(&table, law, scale, 8.0);
        assert!(table.at_load(8.0).is_none() && table.at_load(0.99).is_none());
    }

    #[test]
    fn links_lead_over_links_to_as_many_parts_as_there_is_room_for() {
        let scale = Scale { load: 1.0, value: 1.0 };
        let wiggly = |per_row: f64| {
            move |log_excess: f64| {
                let rate = 2.0 * std::f64::consts::PI * per_row / WIDTH;
                let (sine, cosine) = crate::numerics::elementary::sincos(rate * log_excess);
                (exp(log_excess) * (1.0 + 1e-3 * sine), 1.0 + 1e-3 * rate * cosine / (1.0 + 1e-3 * sine))
            }
        };
        let (full, error) = filled(wiggly(4.0), None, scale, 1, 100);
        assert!(full.rows.len() > 1 + LINKED + 1 && error < 2.0 * tolerance::VALUE, "{}, {error:e}", full.rows.len());
        assert_on_the_law(&full, wiggly(4.0), scale, 1.0 + WIDTH);
        // Where there are too many, or too little room, the law is followed less well, and the error says so.
        for (per_row, room) in [(1000.0, 100), (16.0, 12), (8.0, 5)] {
            let (cramped, error) = filled(wiggly(per_row), None, scale, 1, room);
            assert!(error > 5.0 * tolerance::VALUE, "{error:e}");
            for x in [1.01, 1.1, 1.24] {
                let (value, _) = cramped.at_load(x).expect("it answers");
                let miss = (value / wiggly(per_row)(log(x)).0 - 1.0).abs();
                assert!(miss < 10.0 * error + 2e-3, "{x}: {miss:e}, {error:e}");
            }
        }
    }
}
