//! Rows filled from the law: whole, or in as many parts as it takes.

use super::row::{
    error_within_tolerance, polynomial, PieceBasis, Row, RowBasis, BETWEEN, BETWEEN_OF_PIECE, DIVISIONS, INTERIOR,
    OF_PIECE,
};
use super::table::Table;
use crate::elementary::{exp, log, log1p};
use std::f64::consts::LN_2;
use std::ops::Range;

/// Where the law is asked for a row: where it is determined, where it is compared, and at its end.
const PARTS: [f64; 8] = [INTERIOR[0], INTERIOR[1], INTERIOR[2], INTERIOR[3], BETWEEN[0], BETWEEN[1], BETWEEN[2], 1.0];
/// The most pieces of a row: links of two levels.
const MOST_PIECES: usize = (DIVISIONS + 1) * (DIVISIONS + 1);
/// Where a row is not good as a whole, a piece with more joints than this is not tried: most are not good either.
const FEW_JOINTS: usize = 2;
/// Next to where the law is not smooth it may be a non-integer power of the distance, which takes shorter and shorter
/// pieces: by this factor.
const NEXT_TO_JOINT: f64 = 0.125;
/// No piece is shorter than this part of its row: x has few digits more.
const SHORTEST_PIECE: f64 = 1e-9;

/// The law, as rows are filled from it: a value in the caller's units and its slope by ln x, NaN where they are not known. The
/// places of a call are near to each other. x is in the units of the model.
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

/// A piece: where in its row it begins, by mantissa, and its polynomial.
type Piece = (f64, Row);

impl<'a, S: Source> Filling<'a, S> {
    /// From a source, of which 1 is so much in the caller's units of x, rows of a fraction 1/2^`fraction` of a binade.
    pub fn new(source: &'a S, unit: f64, fraction: u32) -> Self {
        let per_binade = 1 << fraction;
        Self { source, log_unit: log(unit), per_binade, width: 1.0 / per_binade as f64 }
    }

    /// Fills as many rows of a table; those that miss the law are left out. The largest error of the others.
    pub fn rows(&self, table: &mut Table, count: usize) -> f64 {
        let basis = RowBasis::new();
        // ln(mantissa), the same in every binade.
        let mantissas: Vec<[f64; PARTS.len()]> =
            (0..self.per_binade).map(|row| PARTS.map(|part| log1p((row as f64 + part) * self.width))).collect();
        let points_of = |row: u64| {
            let within = row % self.per_binade;
            let log_binade = log_binade(row / self.per_binade) - self.log_unit;
            let mut points = self.source.at(mantissas[within as usize].map(|log| log + log_binade));
            for (point, part) in points.iter_mut().zip(PARTS) {
                point.1 = point.1 * self.width / (1.0 + (within as f64 + part) * self.width);
            }
            points
        };
        let mut worst = 0.0_f64;
        let mut left = points_of(table.base - 1)[7];
        for row in table.base..table.base + count as u64 {
            // In the next binade the same part of a row is twice as long.
            if row % self.per_binade == 0 {
                left.1 *= 2.0;
            }
            let points = points_of(row);
            let interior = [points[0].0, points[1].0, points[2].0, points[3].0];
            let coefficients = basis.coefficients(left, points[7], interior);
            let compared = BETWEEN.into_iter().zip(&points[4..7]);
            match self.error_of(&coefficients, self.width, compared) {
                Some(error) => {
                    worst = worst.max(error);
                    table.rows.push(scaled(coefficients, self.width));
                }
                None => table.rows.push(Row::LEFT_OUT),
            }
            left = points[7];
        }
        table.row_count = table.rows.len();
        worst
    }

    /// Divides the rows that are left out into pieces, as far as a table of so many rows and pieces has room; the largest error
    /// of these.
    pub fn divide_left_out(&self, table: &mut Table, most: usize) -> f64 {
        let mut worst = 0.0_f64;
        for row in (0..table.row_count).rev() {
            if table.rows[row].is_left_out() {
                worst = worst.max(self.divide(table, row, most - table.rows.len()));
            }
        }
        worst
    }

    /// Replaces a row that is left out by a link to pieces, if so many more rows are enough; the largest error of these.
    fn divide(&self, table: &mut Table, row: usize, room: usize) -> f64 {
        let Some((pieces, error)) = self.pieces(table.base + row as u64, room) else { return 0.0 };
        let (begins, rows): (Vec<f64>, Vec<Row>) = pieces.into_iter().unzip();
        if let [whole] = rows[..] {
            table.rows[row] = whole;
            return error;
        }
        let groups = groups(&begins, self.width);
        let first = table.rows.len();
        let mut below = first + groups.len();
        table.rows[row] = Row::link(first, &groups[1..].iter().map(|group| begins[group.start]).collect::<Vec<f64>>());
        for group in &groups {
            table.rows.push(match group.len() {
                1 => rows[group.start],
                _ => Row::link(below, &begins[group.start + 1..group.end]),
            });
            below += if group.len() > 1 { group.len() } else { 0 };
        }
        for group in groups.into_iter().filter(|group| group.len() > 1) {
            table.rows.extend(&rows[group]);
        }
        error
    }

    /// Polynomials for the parts of a row, as few as are good; `None` if they are more than there is room for.
    fn pieces(&self, row: u64, room: usize) -> Option<(Vec<Piece>, f64)> {
        let basis = PieceBasis::new();
        let start = (row % self.per_binade) as f64 * self.width;
        let log_binade = log_binade(row / self.per_binade) - self.log_unit;
        let log_of = |t: f64| log1p(start + t) + log_binade;
        let joints = self.source.joints(log_of(0.0), log_of(self.width));
        let joints: Vec<f64> = joints.into_iter().map(|joint| exp(joint - log_binade) - 1.0 - start).collect();
        let most = MOST_PIECES.min(room);
        let fill = |begin: f64, end: f64| {
            let length = end - begin;
            let within = joints.iter().filter(|&&joint| joint > begin && joint < end).count();
            let is_tried = length == self.width || within <= FEW_JOINTS;
            let filled = is_tried.then(|| self.piece(&basis, start + begin, length, log_binade)).flatten();
            Part { begin, end, filled }
        };
        let mut parts = vec![fill(0.0, self.width)];
        // The longest first: if there is not room for all pieces, those that are left out are short.
        let mut shortest = 1.0;
        while shortest >= SHORTEST_PIECE {
            let mut i = 0;
            while i < parts.len() {
                let Part { begin, end, filled } = parts[i];
                if filled.is_none() && end - begin >= shortest * self.width && parts.len() < most {
                    let at = division(&joints, begin, end);
                    parts.splice(i..=i, [fill(begin, at), fill(at, end)]);
                } else {
                    i += 1;
                }
            }
            shortest *= NEXT_TO_JOINT;
        }
        let worst = parts.iter().filter_map(|part| part.filled).fold(0.0, |worst: f64, (_, error)| worst.max(error));
        let mut pieces: Vec<Piece> =
            parts.iter().map(|part| (part.begin, part.filled.map_or(Row::LEFT_OUT, |(row, _)| row))).collect();
        // Side by side they are one.
        pieces.dedup_by(|next, piece| next.1.is_left_out() && piece.1.is_left_out());
        // Links take room too.
        let links = if pieces.len() > DIVISIONS + 1 { DIVISIONS + 1 } else { 0 };
        let any = pieces.iter().any(|(_, piece)| !piece.is_left_out());
        (any && pieces.len() + links <= room).then_some((pieces, worst))
    }

    /// The polynomial of a part of a row that begins at a mantissa, less one, and its error, if it is good.
    fn piece(&self, basis: &PieceBasis, begin: f64, length: f64, log_binade: f64) -> Option<(Row, f64)> {
        const ALL: usize = OF_PIECE.len() + BETWEEN_OF_PIECE.len();
        let parts: [f64; ALL] =
            std::array::from_fn(
                |i| if i < OF_PIECE.len() { OF_PIECE[i] } else { BETWEEN_OF_PIECE[i - OF_PIECE.len()] },
            );
        let mantissas = parts.map(|part| begin + part * length);
        let law = self.source.at(mantissas.map(|mantissa| log1p(mantissa) + log_binade));
        let points: [(f64, f64); ALL] = std::array::from_fn(|i| (law[i].0, law[i].1 * length / (1.0 + mantissas[i])));
        let slopes = std::array::from_fn(|i| points[i].1);
        let coefficients = basis.coefficients(points[0].0, slopes);
        let end = (1.0, &points[OF_PIECE.len() - 1]);
        let compared = BETWEEN_OF_PIECE.into_iter().zip(&points[OF_PIECE.len()..]).chain([end]);
        self.error_of(&coefficients, length, compared).map(|error| (scaled(coefficients, length), error))
    }

    /// The largest error of the polynomial of a part of so long a mantissa where it is compared, if it is good in all of these
    /// places.
    fn error_of<'b>(
        &self,
        coefficients: &[f64; 8],
        length: f64,
        compared: impl Iterator<Item = (f64, &'b (f64, f64))>,
    ) -> Option<f64> {
        if coefficients.iter().any(|coefficient| coefficient.is_nan()) {
            return None;
        }
        let least = (self.source.least(), self.source.least() * length);
        let mut worst = 0.0_f64;
        for (part, exact) in compared {
            worst = worst.max(error_within_tolerance(polynomial(coefficients, part), *exact, least)?);
        }
        Some(worst)
    }
}

/// A part of a row, and its polynomial with its error, if that is good.
#[derive(Clone, Copy)]
struct Part {
    begin: f64,
    end: f64,
    filled: Option<(Row, f64)>,
}

/// The pieces to which each place of a row's link leads: one, or several by another link. The widest pieces are alone, so that
/// most loads follow one link.
fn groups(begins: &[f64], end: f64) -> Vec<Range<usize>> {
    let ends = begins[1..].iter().chain([&end]);
    let lengths: Vec<f64> = ends.zip(begins).map(|(end, begin)| end - begin).collect();
    let mut by_length: Vec<usize> = (0..begins.len()).collect();
    by_length.sort_by(|&a, &b| lengths[b].total_cmp(&lengths[a]));
    let alone_in = |alone: &[usize]| {
        let mut groups: Vec<Range<usize>> = Vec::new();
        for piece in 0..begins.len() {
            match groups.last_mut() {
                Some(group) if group.len() <= DIVISIONS && !alone.contains(&piece) && !alone.contains(&group.start) => {
                    group.end += 1;
                }
                _ => groups.push(piece..piece + 1),
            }
        }
        groups
    };
    let most = begins.len().min(DIVISIONS + 1);
    let mut found =
        (1..=most).rev().map(|count| alone_in(&by_length[..count])).filter(|groups| groups.len() <= DIVISIONS + 1);
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

/// The row of a polynomial in the part of a length.
fn scaled(coefficients: [f64; 8], length: f64) -> Row {
    let mut scale = 1.0;
    Row(coefficients.map(|coefficient| {
        let scaled = coefficient * scale;
        scale /= length;
        scaled
    }))
}

#[cfg(test)]
mod tests {
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

    /// The rows of a law from x = 1 on, divided where there is room for so many pieces, and the largest error of whole ones.
    fn filled(law: impl Fn(f64) -> (f64, f64), joint: Option<f64>, scale: Scale, count: usize, room: usize) -> Table {
        let source = Law(law, joint, scale.value);
        let mut table = Table::new(FRACTION, 1_f64.to_bits() >> Table::shift_of(FRACTION), 0.0);
        let filling = Filling::new(&source, scale.load, FRACTION);
        let error = filling.rows(&mut table, count);
        assert!(error < 5e-11 && (error > 1e-17 || count == 1), "{error:e}");
        let most = table.rows.len() + room;
        filling.divide_left_out(&mut table, most);
        table
    }

    fn assert_on_the_law(table: &Table, law: impl Fn(f64) -> (f64, f64), scale: Scale, end: f64) {
        for i in 0..3000 {
            let x = end.powf((f64::from(i) + 0.5) / 3000.0);
            let (force, slope) = table.at_load(x).expect("it answers");
            let (exact, power) = law((x / scale.load).ln());
            let exact = scale.value * exact;
            assert!((force / exact - 1.0).abs() < 5e-11, "{x}: {force}, not {exact}");
            assert!((slope * x / exact / power - 1.0).abs() < 5e-9, "{x}: slope {slope}");
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
        let table = filled(law, Some(at), scale, 12, 100);
        assert_eq!((table.row_count, table.rows.len()), (12, 14));
        let links: Vec<usize> = (0..12).filter(|&row| table.rows[row].is_link()).collect();
        assert_eq!(links, [5]);
        assert_on_the_law(&table, law, scale, 8.0);
        assert!(table.at_load(8.0).is_none() && table.at_load(0.99).is_none());
    }

    /// As many wiggles in a row as one level of links cannot hold, and as many as two cannot.
    #[test]
    fn the_widest_pieces_of_a_row_take_one_link_and_all_have_their_place() {
        for count in 2..=MOST_PIECES {
            let mut begins = vec![0.0];
            for piece in 0..count {
                let is_wide = [0, 15, count - 1].contains(&piece);
                begins.push(begins[piece] + if is_wide { 100.0 } else { 1.0 });
            }
            let end = begins.pop().expect("the end");
            let groups = groups(&begins, end);
            assert!(
                groups.len() <= DIVISIONS + 1 && groups.iter().all(|group| group.len() <= DIVISIONS + 1),
                "{groups:?}"
            );
            assert!(groups.iter().cloned().flatten().eq(0..count), "{groups:?}");
            // As long as there is room.
            for wide in [0, 15, count - 1].into_iter().filter(|&wide| wide < count && count <= 31) {
                assert!(groups.contains(&(wide..wide + 1)), "{wide} of {count}: {groups:?}");
            }
        }
    }

    #[test]
    fn links_lead_over_links_to_as_many_parts_as_there_is_room_for() {
        let scale = Scale { load: 1.0, value: 1.0 };
        let wiggly = |per_row: f64| {
            move |log_excess: f64| {
                let rate = 2.0 * std::f64::consts::PI * per_row / WIDTH;
                let (sine, cosine) = crate::elementary::sincos(rate * log_excess);
                (exp(log_excess) * (1.0 + 1e-3 * sine), 1.0 + 1e-3 * rate * cosine / (1.0 + 1e-3 * sine))
            }
        };
        let full = filled(wiggly(4.0), None, scale, 1, 100);
        assert!(full.rows.len() > 1 + DIVISIONS + 2 && !full.rows.iter().any(Row::is_left_out), "{}", full.rows.len());
        assert_on_the_law(&full, wiggly(4.0), scale, 1.0 + WIDTH);
        // Too many: left out, as a whole or where there is no room.
        let crowded = filled(wiggly(1000.0), None, scale, 1, 100);
        assert!(crowded.rows.len() <= 101 && crowded.at_load(1.1).is_none());
        let cramped = filled(wiggly(4.0), None, scale, 1, 5);
        assert!(cramped.rows.len() <= 6, "{}", cramped.rows.len());
        // What is left out side by side is one part.
        let half = (1.0 + 0.5 * WIDTH).ln();
        let begun = move |log_excess: f64| match log_excess < half {
            true => (exp(log_excess), 1.0),
            false => wiggly(1000.0)(log_excess),
        };
        let begun = filled(begun, Some(half), scale, 1, 100);
        assert_eq!(begun.rows.iter().filter(|row| row.is_left_out()).count(), 1, "{:?}", begun.rows);
        assert!(begun.at_load(1.001).is_some() && begun.at_load(1.249).is_none());
    }
}
