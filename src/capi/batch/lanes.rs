//! The vector form of the law, written once for any number of lanes.

use super::{one, Arrays, Quantity};
use crate::law::{Row, Table, COEFFICIENTS, OFFSET};
use crate::model::{Known, Model};
use std::mem::{size_of, MaybeUninit};

/// A vector of floats, with its masks and integers; every method is one or two instructions.
///
/// # Safety
/// The processor has the instructions of the implementation, and the calling function is compiled for them.
pub unsafe trait Lanes: Copy {
    const COUNT: usize;
    /// A truth value per lane.
    type Mask: Copy;
    /// A 64-bit integer per lane.
    type Bits: Copy;

    unsafe fn read(at: *const f64) -> Self;
    unsafe fn write(self, at: *mut f64);
    unsafe fn splat(x: f64) -> Self;
    unsafe fn add(self, other: Self) -> Self;
    unsafe fn sub(self, other: Self) -> Self;
    unsafe fn mul(self, other: Self) -> Self;
    unsafe fn max(self, other: Self) -> Self;
    unsafe fn div(self, other: Self) -> Self;
    /// self/other where the mask is set, any number elsewhere, without raising a flag there.
    unsafe fn div_where(self, mask: Self::Mask, other: Self) -> Self;
    /// self < other, false for NaN, without raising a flag.
    unsafe fn lt(self, other: Self) -> Self::Mask;
    unsafe fn is_nan(self) -> Self::Mask;
    /// NaN, signalling or not, or infinite; without raising a flag.
    unsafe fn not_finite(self) -> Self::Mask;
    /// `other` where the mask is set.
    unsafe fn or_where(self, mask: Self::Mask, other: Self) -> Self;
    unsafe fn bits(self) -> Self::Bits;
    unsafe fn from_bits(bits: Self::Bits) -> Self;
    /// The row of each lane, at an offset in bytes, transposed: coefficient j of all lanes in vector j.
    unsafe fn rows(rows: *const Row, offset: &Self::Bits) -> [Self; COEFFICIENTS];

    unsafe fn splat_bits(x: u64) -> Self::Bits;
    unsafe fn and_bits(a: Self::Bits, b: Self::Bits) -> Self::Bits;
    unsafe fn or_bits(a: Self::Bits, b: Self::Bits) -> Self::Bits;
    unsafe fn sub_bits(a: Self::Bits, b: Self::Bits) -> Self::Bits;
    unsafe fn shift_right(a: Self::Bits, count: u32) -> Self::Bits;
    /// a < 0 or a >= bound, as signed integers.
    unsafe fn outside(a: Self::Bits, bound: u64) -> Self::Mask;
    unsafe fn or_bits_where(a: Self::Bits, mask: Self::Mask, b: Self::Bits) -> Self::Bits;

    unsafe fn or_mask(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    unsafe fn not_mask(a: Self::Mask) -> Self::Mask;
    unsafe fn and_mask(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Bit i for lane i.
    unsafe fn lanes_of(mask: Self::Mask) -> u32;
}

const SIGN_AND_EXPONENT: u64 = !Table::MANTISSA;
/// log2 of the size of a row.
const ROW_SHIFT: u32 = size_of::<Row>().trailing_zeros();
/// Lighter positive loads may make a slope overflow: the scalar call takes care.
const LIGHTEST: f64 = 1e-100;

/// Vectors whose rows are found before the first of them is read. What a processor can look ahead is less than the way
/// from a load to its result: a row whose address is known by then need not wait.
const BLOCK: usize = 16;

/// Where the table has the answers to a vector of loads.
#[derive(Clone, Copy)]
struct Found<L: Lanes> {
    /// The loads, with 1 for those that are not finite.
    load: L,
    /// Where within its row each load lies; NaN where the table does not reach.
    t: L,
    /// The row's offset in bytes; the first row's where the table does not reach.
    offset: L::Bits,
}

/// What vectors of loads are to be compared with.
struct Limits<'a> {
    table: &'a Table,
    known: Known,
    cap: f64,
    inverse_cap: f64,
}

/// The answers to a vector of loads.
#[derive(Clone, Copy)]
struct Answers<L: Lanes> {
    value: L,
    slope: L,
    /// Those that are left to the scalar call.
    slow: L::Mask,
    /// Those below pull-off.
    apart: L::Mask,
}

/// Evaluates all full vectors; returns how many elements they are.
#[inline(always)]
pub unsafe fn evaluate<L: Lanes>(
    model: &Model,
    quantity: Quantity,
    arrays: Arrays,
    offence: &mut Option<(usize, f64)>,
) -> usize {
    let table = model.table(quantity.tabulated());
    let cap = model.params().max_friction_coefficient;
    let limits = Limits { table, known: model.known(quantity.tabulated()), cap, inverse_cap: model.inverse_cap() };
    let with_slope = !arrays.slope.is_null();
    let vectors = arrays.n / L::COUNT;
    let mut block = [MaybeUninit::<Found<L>>::uninit(); BLOCK];
    let mut begin = 0;
    while begin < vectors {
        let in_block = (vectors - begin).min(BLOCK);
        for (vector, found) in block[..in_block].iter_mut().enumerate() {
            found.write(find::<L>(table, L::read(arrays.load.add((begin + vector) * L::COUNT))));
        }
        for (vector, found) in block[..in_block].iter().enumerate() {
            let i = (begin + vector) * L::COUNT;
            let found = found.assume_init_ref();
            let answers = force::<L>(table, found, found.t, found.offset, with_slope);
            let closed = match quantity {
                Quantity::Coefficient => closed::<L>(&limits, found.load, answers.value),
                _ => answers.slow,
            };
            if L::lanes_of(L::or_mask(answers.slow, closed)) == 0 {
                let answers = match quantity {
                    Quantity::Coefficient => divided::<L>(answers, found.load, with_slope),
                    _ => answers,
                };
                write::<L>(&answers, arrays, i);
            } else {
                let mut answers = beside_rows::<L>(&limits, found, with_slope, answers);
                if quantity == Quantity::Coefficient {
                    answers = coefficient::<L>(&limits, found.load, with_slope, answers);
                }
                write_and_ask::<L>(&answers, model, quantity, arrays, i, offence);
            }
        }
        begin += in_block;
    }
    vectors * L::COUNT
}

/// Coefficients from forces, where all lanes are ordinary.
#[inline(always)]
unsafe fn divided<L: Lanes>(answers: Answers<L>, load: L, with_slope: bool) -> Answers<L> {
    let value = answers.value.div(load);
    let slope = if with_slope { answers.slope.sub(value).div(load) } else { answers.slope };
    Answers { value, slope, ..answers }
}

/// Writes the answers to the elements from the i-th on.
#[inline(always)]
unsafe fn write<L: Lanes>(answers: &Answers<L>, arrays: Arrays, i: usize) {
    if !arrays.value.is_null() {
        answers.value.write(arrays.value.add(i));
    }
    if !arrays.slope.is_null() {
        answers.slope.write(arrays.slope.add(i));
    }
}

/// The same, but asks the scalar call for those that are left to it, and keeps the first offence.
#[inline(always)]
unsafe fn write_and_ask<L: Lanes>(
    answers: &Answers<L>,
    model: &Model,
    quantity: Quantity,
    arrays: Arrays,
    i: usize,
    offence: &mut Option<(usize, f64)>,
) {
    let (slow, apart) = (L::lanes_of(answers.slow), L::lanes_of(answers.apart));
    // The input, before an output that may be the same array is written.
    let mut kept = [0.0; 8];
    if slow | apart != 0 {
        L::read(arrays.load.add(i)).write(kept.as_mut_ptr());
    }
    write::<L>(answers, arrays, i);
    if slow == 0 && (apart == 0 || offence.is_some()) {
        return;
    }
    for (lane, &load) in kept.iter().enumerate().take(L::COUNT) {
        if slow >> lane & 1 != 0 {
            one(model, quantity, arrays, i + lane, load, offence);
        } else if apart >> lane & 1 != 0 {
            offence.get_or_insert((i + lane, load));
        }
    }
}

/// Finds the rows.
#[inline(always)]
unsafe fn find<L: Lanes>(table: &Table, loads: L) -> Found<L> {
    // Arithmetic with a signalling NaN would raise a flag, a comparison too: go on with 1 instead.
    let not_finite = loads.not_finite();
    let load = loads.or_where(not_finite, L::splat(1.0));
    let x = load.sub(L::splat(table.pull_off)).bits();
    // The row's offset in bytes: its index times 64.
    let shifted = L::and_bits(L::shift_right(x, table.shift - ROW_SHIFT), L::splat_bits(u64::MAX << ROW_SHIFT));
    let offset = L::sub_bits(shifted, L::splat_bits(table.base << ROW_SHIFT));
    let slow = L::or_mask(not_finite, L::outside(offset, (table.row_count as u64) << ROW_SHIFT));
    let one = L::splat_bits(Table::ONE);
    let within_row = L::and_bits(x, L::splat_bits(table.within_row()));
    let t = L::from_bits(L::or_bits(within_row, one)).sub(L::splat(1.0));
    Found { load, t: t.or_where(slow, L::splat(f64::NAN)), offset: L::or_bits_where(offset, slow, L::splat_bits(0)) }
}

/// Values and slopes from the table; lanes that it does not answer are slow, and have zeros.
#[inline(always)]
unsafe fn force<L: Lanes>(table: &Table, found: &Found<L>, t: L, offset: L::Bits, with_slope: bool) -> Answers<L> {
    // Loading whole rows and transposing them takes half the time of gather instructions.
    let c = L::rows(table.rows.as_ptr(), &offset);
    // The same order of operations as the scalar polynomial.
    let t2 = t.mul(t);
    let t4 = t2.mul(t2);
    let low = c[0].add(c[1].mul(t)).add(c[2].add(c[3].mul(t)).mul(t2));
    let high = c[4].add(c[5].mul(t)).add(c[6].add(c[7].mul(t)).mul(t2));
    let value = low.add(high.mul(t4));
    // Outside the table, at links and rows that are left out. The largest of a number and NaN would raise a flag.
    let slow = value.is_nan();
    let value = value.or_where(slow, L::splat(0.0));
    let apart = L::splat(0.0).is_nan();
    if !with_slope {
        return Answers { value, slope: value, slow, apart };
    }
    let low = c[1].add(times::<L>(2.0, c[2]).mul(t));
    let low = low.add(times::<L>(3.0, c[3]).add(times::<L>(4.0, c[4]).mul(t)).mul(t2));
    let high = times::<L>(5.0, c[5]).add(times::<L>(6.0, c[6]).mul(t)).add(times::<L>(7.0, c[7]).mul(t2));
    let rate = low.add(high.mul(t4));
    // Where the table does not reach t is NaN, and at links the rate, so that the product raises no flag whatever the
    // binade is.
    let excess = found.load.sub(L::splat(table.pull_off));
    let binade = L::and_bits(excess.bits(), L::splat_bits(SIGN_AND_EXPONENT));
    let inverse_binade = L::from_bits(L::sub_bits(L::splat_bits(Table::TWICE_BIAS), binade));
    Answers { value, slope: rate.mul(inverse_binade), slow, apart }
}

/// What no row answers by itself: loads in parts of rows, at zero and below pull-off.
#[inline(always)]
unsafe fn beside_rows<L: Lanes>(
    limits: &Limits,
    found: &Found<L>,
    with_slope: bool,
    answers: Answers<L>,
) -> Answers<L> {
    let inside = L::not_mask(found.t.is_nan());
    let (part, offset) = follow_links::<L>(limits.table, found.t, found.offset, L::and_mask(answers.slow, inside));
    let parts = force::<L>(limits.table, found, part, offset, with_slope);
    let zero = L::splat(0.0);
    let Known { at_zero, apart: apart_slope, .. } = limits.known;
    let apart = L::and_mask(parts.slow, found.load.lt(L::splat(limits.table.pull_off)));
    let is_zero = L::not_mask(L::or_mask(found.load.lt(zero), zero.lt(found.load)));
    let at_zero_load = L::and_mask(parts.slow, L::and_mask(is_zero, L::not_mask(apart)));
    let value = parts.value.or_where(apart, zero).or_where(at_zero_load, L::splat(at_zero.0));
    let slope = parts.slope.or_where(apart, L::splat(apart_slope)).or_where(at_zero_load, L::splat(at_zero.1));
    let known = L::or_mask(apart, at_zero_load);
    Answers { value, slope, slow: L::and_mask(parts.slow, L::not_mask(known)), apart }
}

/// t and offset of the parts to which links lead; of rows that are left out t is NaN.
#[inline(always)]
unsafe fn follow_links<L: Lanes>(table: &Table, t: L, offset: L::Bits, mut linked: L::Mask) -> (L, L::Bits) {
    let (mut begin, mut offset, mut left_out) = (L::splat(0.0), offset, L::splat(0.0).is_nan());
    while L::lanes_of(linked) != 0 {
        let c = L::rows(table.rows.as_ptr(), &offset);
        let link = L::and_bits(c[0].bits(), L::splat_bits(OFFSET));
        let nowhere = L::outside(L::sub_bits(link, L::splat_bits(1)), u64::MAX >> 1);
        left_out = L::or_mask(left_out, L::and_mask(linked, nowhere));
        linked = L::and_mask(linked, L::not_mask(nowhere));
        let mut part = link;
        for division in &c[2..] {
            let before = L::not_mask(t.lt(*division));
            begin = begin.or_where(L::and_mask(linked, before), *division);
            part =
                L::or_bits_where(part, before, L::sub_bits(part, L::splat_bits((-(size_of::<Row>() as i64)) as u64)));
        }
        offset = L::or_bits_where(offset, linked, part);
        let first = L::rows(table.rows.as_ptr(), &offset)[0];
        linked = L::and_mask(linked, first.is_nan());
    }
    (t.sub(begin).or_where(left_out, L::splat(f64::NAN)), offset)
}

/// Where the coefficient is capped, or the load so light that the slope may overflow.
#[inline(always)]
unsafe fn closed<L: Lanes>(limits: &Limits, load: L, force: L) -> L::Mask {
    L::not_mask(force.mul(L::splat(limits.inverse_cap)).max(L::splat(LIGHTEST)).lt(load))
}

/// Coefficients from forces.
#[inline(always)]
unsafe fn coefficient<L: Lanes>(limits: &Limits, load: L, with_slope: bool, answers: Answers<L>) -> Answers<L> {
    let Answers { value: force, slope: force_slope, slow, apart } = answers;
    let capped_load = force.mul(L::splat(limits.inverse_cap));
    let care = L::or_mask(L::or_mask(slow, apart), closed::<L>(limits, load, force));
    let ordinary = L::not_mask(care);
    // Only what cannot trap is divided.
    let mu = force.div_where(ordinary, load);
    let slope = if with_slope { force_slope.sub(mu).div_where(ordinary, load) } else { mu };
    let zero = L::splat(0.0);
    let known = L::not_mask(L::or_mask(slow, apart));
    let capped = L::and_mask(known, L::not_mask(capped_load.lt(load)));
    // Also where the force is not known, from pull-off to zero.
    let pulling = L::or_mask(zero.lt(load), load.lt(L::splat(limits.table.pull_off)));
    let capped = L::or_mask(capped, L::not_mask(L::or_mask(pulling, apart)));
    let value = mu.or_where(apart, zero).or_where(capped, L::splat(limits.cap));
    let slope = slope.or_where(L::or_mask(apart, capped), zero);
    let slow = L::and_mask(care, L::not_mask(L::or_mask(apart, capped)));
    Answers { value, slope, slow, apart }
}

#[inline(always)]
unsafe fn times<L: Lanes>(factor: f64, coefficient: L) -> L {
    L::splat(factor).mul(coefficient)
}
