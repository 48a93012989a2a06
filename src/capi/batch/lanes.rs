//! The vector form of the law, written once for any number of lanes.

use super::{one, Arrays, FirstInvalid, Quantity};
use crate::law::{Beyond, Continuation, Row, Table, COEFFICIENTS, DIGIT, DIGIT_BITS, DIVISIONS, MANTISSA_BITS, OFFSET};
use crate::model::{Known, Model};
use std::mem::{size_of, MaybeUninit};

/// Methods that become part of the calling function, which is compiled for their instructions.
macro_rules! inlined {
    ($($(#[$doc:meta])* fn $name:ident($($arguments:tt)*) $(-> $returned:ty)? $body:block)*) => {
        $($(#[$doc])* #[inline(always)] unsafe fn $name($($arguments)*) $(-> $returned)? $body)*
    };
}
pub(super) use inlined;

/// A vector of floats, with its masks and integers; every method is one or two instructions.
///
/// # Safety
/// The processor has the instructions of the implementation, and the calling function is compiled for them.
pub unsafe trait Lanes: Copy {
    const COUNT: usize;
    /// What [`Lanes::lanes_of`] gives where all lanes are set.
    const ALL: u32 = (1 << Self::COUNT) - 1;
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
    unsafe fn div(self, other: Self) -> Self;
    /// self < other, false for NaN, without raising a flag.
    unsafe fn lt(self, other: Self) -> Self::Mask;
    /// Whether it or the other is NaN.
    unsafe fn unordered(self, other: Self) -> Self::Mask;
    /// NaN, signalling or not, or infinite; without raising a flag.
    unsafe fn not_finite(self) -> Self::Mask;
    /// `other` where the mask is set.
    unsafe fn or_where(self, mask: Self::Mask, other: Self) -> Self;
    unsafe fn bits(self) -> Self::Bits;
    unsafe fn from_bits(bits: Self::Bits) -> Self;
    /// Coefficients `from` to `from` + 3 of the row of each lane, at an offset in bytes, transposed: a vector each.
    unsafe fn half_rows(rows: *const Row, offset: &Self::Bits, from: usize) -> [Self; 4];
    /// The number of each lane, by index.
    unsafe fn gather(numbers: *const f64, index: Self::Bits) -> Self;
    /// [`answer_others`], in a function of its own with the instructions of the implementation.
    unsafe fn answer_others<const SLOPE: bool>(
        model: &Model,
        quantity: Quantity,
        limits: &Limits,
        arrays: Arrays,
        others: &mut [MaybeUninit<Other<Self>>],
        first_invalid: &mut FirstInvalid,
    );

    unsafe fn and_bits(a: Self::Bits, b: Self::Bits) -> Self::Bits;
    unsafe fn add_bits(a: Self::Bits, b: Self::Bits) -> Self::Bits;
    unsafe fn sub_bits(a: Self::Bits, b: Self::Bits) -> Self::Bits;
    unsafe fn shift_right(a: Self::Bits, count: u32) -> Self::Bits;
    /// a < bound, as unsigned integers; the bound is below 2^32 and not 0.
    unsafe fn below(a: Self::Bits, bound: u64) -> Self::Mask;

    unsafe fn or_mask(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    unsafe fn not_mask(a: Self::Mask) -> Self::Mask;
    unsafe fn and_mask(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Bit i for lane i.
    unsafe fn lanes_of(mask: Self::Mask) -> u32;

    inlined! {
        /// All coefficients of the row of each lane.
        fn rows(rows: *const Row, offset: &Self::Bits) -> [Self; COEFFICIENTS] {
            let [c0, c1, c2, c3] = Self::half_rows(rows, offset, 0);
            let [c4, c5, c6, c7] = Self::half_rows(rows, offset, 4);
            [c0, c1, c2, c3, c4, c5, c6, c7]
        }
        fn is_nan(self) -> Self::Mask { self.unordered(self) }
        /// self/other where the mask is set, any number elsewhere, without raising a flag there.
        fn div_where(self, mask: Self::Mask, other: Self) -> Self {
            // Not 1, by which the compiler would choose after dividing all lanes.
            self.div(Self::splat(2.0).or_where(mask, other))
        }
        fn splat_bits(x: u64) -> Self::Bits { Self::splat(f64::from_bits(x)).bits() }
        /// `b` where the mask is set.
        fn or_bits_where(a: Self::Bits, mask: Self::Mask, b: Self::Bits) -> Self::Bits {
            Self::from_bits(a).or_where(mask, Self::from_bits(b)).bits()
        }
    }
}

const SIGN_AND_EXPONENT: u64 = !Table::MANTISSA;
/// log2 of the size of a row.
const ROW_SHIFT: u32 = size_of::<Row>().trailing_zeros();
/// Lighter positive loads may make a slope overflow: the scalar call takes care.
const LIGHTEST: f64 = 1e-100;
/// In place of a load that is not finite, of which arithmetic or a comparison would raise a flag: below any table.
const BELOW_TABLES: f64 = -1e300;

/// Vectors whose rows are found before the first of them is read. What a processor can look ahead is less than the way
/// from a load to its result: a row whose address is known by then need not wait.
const BLOCK: usize = 16;

/// Where the table has the answers to a vector of loads.
#[derive(Clone, Copy)]
struct Found<L: Lanes> {
    /// The loads, with [`BELOW_TABLES`] for those that are not finite.
    load: L,
    /// Where within its row, or the part of it, each load lies; NaN where the table does not reach.
    t: L,
    /// The row's offset in bytes; the first row's where the table does not reach.
    offset: L::Bits,
}

/// A vector that is not answered by rows alone.
#[derive(Clone, Copy)]
pub struct Other<L: Lanes> {
    found: Found<L>,
    /// Its first element.
    i: usize,
    /// What its rows give, if all lanes have one.
    values: Option<(L, L)>,
    /// Whether links lead any lane to a row.
    is_linked: bool,
}

/// What vectors of loads are to be compared with.
pub struct Limits<'a> {
    table: &'a Table,
    known: Known,
    cap: f64,
    inverse_cap: f64,
    beyond: &'a Beyond,
    /// The surfaces are apart at a smaller load - pull-off, and heavier loads are not allowed.
    least: f64,
    heaviest: f64,
}

/// The answers to a vector of loads.
#[derive(Clone, Copy)]
struct Answers<L: Lanes> {
    value: L,
    slope: L,
    /// Those that are left to the scalar call.
    slow: L::Mask,
    /// Those below pull-off, too heavy or not finite.
    failed: L::Mask,
}

/// What is known beside the table. Zero is a gap like others, and there is no load where the surfaces are apart.
fn known(model: &Model, quantity: Quantity) -> Known {
    let unknown = (f64::NAN, f64::NAN);
    match quantity {
        Quantity::Load => {
            Known { at_pull_off: unknown, at_zero: unknown, apart: 0.0, light_slope: 0.0, heavy: f64::NAN }
        }
        _ => model.known(quantity.tabulated()),
    }
}

/// Evaluates all full vectors; returns how many elements they are.
#[inline(always)]
pub unsafe fn evaluate<L: Lanes>(
    model: &Model,
    quantity: Quantity,
    arrays: Arrays,
    first_invalid: &mut FirstInvalid,
) -> usize {
    match (quantity == Quantity::Coefficient, !arrays.slope.is_null()) {
        (false, false) => evaluate_as::<L, false, false>(model, quantity, arrays, first_invalid),
        (false, true) => evaluate_as::<L, false, true>(model, quantity, arrays, first_invalid),
        (true, false) => evaluate_as::<L, true, false>(model, quantity, arrays, first_invalid),
        (true, true) => evaluate_as::<L, true, true>(model, quantity, arrays, first_invalid),
    }
}

/// The same, of the coefficient or of what the table has, with slopes or without.
#[inline(always)]
unsafe fn evaluate_as<L: Lanes, const COEFFICIENT: bool, const SLOPE: bool>(
    model: &Model,
    quantity: Quantity,
    arrays: Arrays,
    first_invalid: &mut FirstInvalid,
) -> usize {
    let table = quantity.table(model);
    let cap = model.params().max_friction_coefficient;
    let (known, inverse_cap, beyond) = (known(model, quantity), model.inverse_cap(), quantity.beyond(model));
    let (least, heaviest) = match quantity {
        Quantity::Load => (model.least_approach(), model.deepest_compression()),
        _ => (0.0, model.heaviest_load()),
    };
    let limits = Limits { table, known, cap, inverse_cap, beyond, least, heaviest };
    let vectors = arrays.n / L::COUNT;
    let mut block = [MaybeUninit::<Found<L>>::uninit(); BLOCK];
    // The vectors of the block that no rows answer by themselves, or cap.
    let mut others = [MaybeUninit::<Other<L>>::uninit(); BLOCK];
    let mut begin = 0;
    while begin < vectors {
        let in_block = (vectors - begin).min(BLOCK);
        let element = |vector: usize| (begin + vector) * L::COUNT;
        for (vector, found) in block[..in_block].iter_mut().enumerate() {
            found.write(find::<L>(table, L::read(arrays.load.add(element(vector)))));
        }
        let mut count = 0;
        for (vector, found) in block[..in_block].iter().enumerate() {
            let (found, i) = (found.assume_init_ref(), element(vector));
            if let Err(values) = by_rows::<L, SLOPE>(&limits, COEFFICIENT, found, arrays, i) {
                others[count].write(Other { found: *found, i, values, is_linked: false });
                count += 1;
            }
        }
        if count != 0 {
            L::answer_others::<SLOPE>(model, quantity, &limits, arrays, &mut others[..count], first_invalid);
        }
        begin += in_block;
    }
    vectors * L::COUNT
}

/// Answers what rows alone do not: compiled once for all quantities, as it takes 5 kB.
#[inline(always)]
pub unsafe fn answer_others<L: Lanes, const SLOPE: bool>(
    model: &Model,
    quantity: Quantity,
    limits: &Limits,
    arrays: Arrays,
    others: &mut [MaybeUninit<Other<L>>],
    first_invalid: &mut FirstInvalid,
) {
    let (table, is_coefficient) = (limits.table, quantity == Quantity::Coefficient);
    // All links before the first of their parts is read, as above.
    for other in &mut *others {
        let other = other.assume_init_mut();
        if other.values.is_none() {
            let t = other.found.t;
            other.is_linked = follow_links::<L>(table, &mut other.found, t);
        }
    }
    'others: for other in others {
        let Other { found, i, values, is_linked } = other.assume_init_mut();
        while *is_linked {
            match by_rows::<L, SLOPE>(limits, is_coefficient, found, arrays, *i) {
                Ok(()) => continue 'others,
                Err(of_parts) => *values = of_parts,
            }
            // Parts may be links too.
            *is_linked = values.is_none() && follow_links::<L>(table, found, find::<L>(table, found.load).t);
        }
        let (value, rate) = match *values {
            Some(values) => values,
            None if L::lanes_of(found.t.is_nan()) == L::ALL => (found.t, found.t),
            None => polynomial::<L, SLOPE>(&L::rows(table.rows.as_ptr(), &found.offset), found.t),
        };
        // Where the rows do not answer the rate is NaN, so that no product raises a flag whatever the binade is.
        let slope = if SLOPE { by_load::<L>(table, found.load, rate) } else { rate };
        let (value, slope) = if L::lanes_of(found.t.is_nan()) == 0 {
            (value, slope)
        } else {
            or_beyond::<L, SLOPE>(limits, found, (value, slope))
        };
        let loads = L::read(arrays.load.add(*i));
        let answers = beside_rows::<L, SLOPE>(limits, is_coefficient, loads, value, slope);
        write_and_ask::<L, SLOPE>(&answers, model, quantity, arrays, *i, first_invalid);
    }
}

/// Writes the answers to the elements from the i-th on, if rows have all of them and none is capped or needs care; otherwise
/// gives what the rows have, if there is one for each.
#[inline(always)]
unsafe fn by_rows<L: Lanes, const SLOPE: bool>(
    limits: &Limits,
    is_coefficient: bool,
    found: &Found<L>,
    arrays: Arrays,
    i: usize,
) -> Result<(), Option<(L, L)>> {
    let load = found.load;
    // Loading whole rows and transposing them takes half the time of gather instructions.
    let c = L::rows(limits.table.rows.as_ptr(), &found.offset);
    if L::lanes_of(c[0].unordered(found.t)) != 0 {
        return Err(None);
    }
    let (mut value, rate) = polynomial::<L, SLOPE>(&c, found.t);
    if is_coefficient && L::lanes_of(open::<L, SLOPE>(limits, load, value)) != L::ALL {
        return Err(Some((value, rate)));
    }
    let mut slope = if SLOPE { by_load::<L>(limits.table, load, rate) } else { rate };
    if is_coefficient {
        value = value.div(load);
        slope = if SLOPE { slope.sub(value).div(load) } else { slope };
    }
    write::<L, SLOPE>(value, slope, arrays, i);
    Ok(())
}

/// Writes the answers to the elements from the i-th on.
#[inline(always)]
unsafe fn write<L: Lanes, const SLOPE: bool>(value: L, slope: L, arrays: Arrays, i: usize) {
    if !arrays.value.is_null() {
        value.write(arrays.value.add(i));
    }
    if SLOPE {
        slope.write(arrays.slope.add(i));
    }
}

/// The same, but asks the scalar call for those that are left to it, and keeps the first that is invalid.
#[inline(always)]
unsafe fn write_and_ask<L: Lanes, const SLOPE: bool>(
    answers: &Answers<L>,
    model: &Model,
    quantity: Quantity,
    arrays: Arrays,
    i: usize,
    first_invalid: &mut FirstInvalid,
) {
    let (slow, failed) = (L::lanes_of(answers.slow), L::lanes_of(answers.failed));
    if slow == 0 && (failed == 0 || first_invalid.is_some()) {
        return write::<L, SLOPE>(answers.value, answers.slope, arrays, i);
    }
    // The input, before an output that may be the same array is written.
    let mut kept = [0.0; 8];
    L::read(arrays.load.add(i)).write(kept.as_mut_ptr());
    write::<L, SLOPE>(answers.value, answers.slope, arrays, i);
    for (lane, &load) in kept.iter().enumerate().take(L::COUNT) {
        if slow >> lane & 1 != 0 {
            one(model, quantity, arrays, i + lane, load, first_invalid);
        } else if failed >> lane & 1 != 0 {
            first_invalid.get_or_insert((i + lane, load));
        }
    }
}

/// Finds the rows.
#[inline(always)]
unsafe fn find<L: Lanes>(table: &Table, loads: L) -> Found<L> {
    let load = loads.or_where(loads.not_finite(), L::splat(BELOW_TABLES));
    let x = load.sub(L::splat(table.pull_off)).bits();
    // The row's offset in bytes: its index times 64.
    let shifted = L::and_bits(L::shift_right(x, table.shift - ROW_SHIFT), L::splat_bits(u64::MAX << ROW_SHIFT));
    let offset = L::sub_bits(shifted, L::splat_bits(table.base << ROW_SHIFT));
    let inside = L::below(offset, (table.row_count as u64) << ROW_SHIFT);
    Found {
        load,
        t: L::splat(f64::NAN).or_where(inside, within::<L>(Table::within_row(table.shift), x)),
        offset: L::or_bits_where(L::splat_bits(0), inside, offset),
    }
}

/// Where in its row x of these bits lies.
#[inline(always)]
unsafe fn within<L: Lanes>(within_row: u64, x: L::Bits) -> L {
    // The bits of 1 and what follows them.
    let within_row = L::and_bits(x, L::splat_bits(within_row));
    L::from_bits(L::add_bits(within_row, L::splat_bits(Table::ONE))).sub(L::splat(1.0))
}

/// Values from the rows and their slopes by t; NaN outside the table, at links and rows that are left out.
#[inline(always)]
unsafe fn polynomial<L: Lanes, const SLOPE: bool>(c: &[L; COEFFICIENTS], t: L) -> (L, L) {
    // The same order of operations as the scalar polynomial.
    let t2 = t.mul(t);
    let t4 = t2.mul(t2);
    let low = c[0].add(c[1].mul(t)).add(c[2].add(c[3].mul(t)).mul(t2));
    let high = c[4].add(c[5].mul(t)).add(c[6].add(c[7].mul(t)).mul(t2));
    let value = low.add(high.mul(t4));
    if !SLOPE {
        return (value, value);
    }
    let low = c[1].add(times::<L>(2.0, c[2]).mul(t));
    let low = low.add(times::<L>(3.0, c[3]).add(times::<L>(4.0, c[4]).mul(t)).mul(t2));
    let high = times::<L>(5.0, c[5]).add(times::<L>(6.0, c[6]).mul(t)).add(times::<L>(7.0, c[7]).mul(t2));
    (value, low.add(high.mul(t4)))
}

/// Slopes by load from slopes by t at finite loads.
#[inline(always)]
unsafe fn by_load<L: Lanes>(table: &Table, load: L, rate: L) -> L {
    rate.mul(per_mantissa::<L>(load.sub(L::splat(table.pull_off)).bits()))
}

/// 1/2^e of x by its bits, e its exponent.
#[inline(always)]
unsafe fn per_mantissa<L: Lanes>(x: L::Bits) -> L {
    L::from_bits(L::sub_bits(L::splat_bits(Table::TWICE_BIAS), L::and_bits(x, L::splat_bits(SIGN_AND_EXPONENT))))
}

/// What no row answers by itself: capped coefficients, loads at zero and below pull-off.
#[inline(always)]
unsafe fn beside_rows<L: Lanes, const SLOPE: bool>(
    limits: &Limits,
    is_coefficient: bool,
    loads: L,
    value: L,
    slope: L,
) -> Answers<L> {
    // Those that are not finite have no answer: go on with 1.
    let not_finite = loads.not_finite();
    let load = loads.or_where(not_finite, L::splat(1.0));
    let (zero, x) = (L::splat(0.0), load.sub(L::splat(limits.table.pull_off)));
    let apart = x.lt(L::splat(limits.least));
    let excessive = L::or_mask(not_finite, L::splat(limits.heaviest).lt(load));
    let failed = L::or_mask(apart, excessive);
    let nan = L::splat(f64::NAN);
    let pressing = zero.lt(load);
    let unknown = value.is_nan();
    if is_coefficient {
        let ordinary = open::<L, SLOPE>(limits, load, value);
        let uncapped = value.mul(L::splat(limits.inverse_cap)).lt(load);
        // From pull-off to zero also where the force is not known.
        let capped = L::or_mask(L::not_mask(pressing), L::not_mask(L::or_mask(unknown, uncapped)));
        let capped = L::and_mask(capped, L::not_mask(apart));
        // Only what cannot trap is divided; not chosen by the same mask, or the compiler would divide all.
        let mu = value.div_where(ordinary, load);
        let slope = if SLOPE { slope.sub(mu).div_where(ordinary, load) } else { zero };
        let value = mu.or_where(apart, zero).or_where(capped, L::splat(limits.cap)).or_where(excessive, nan);
        let slope = slope.or_where(L::or_mask(apart, capped), zero).or_where(excessive, nan);
        let slow = L::not_mask(L::or_mask(ordinary, L::or_mask(failed, capped)));
        return Answers { value, slope, slow, failed };
    }
    let Known { at_zero, at_pull_off, apart: apart_slope, .. } = limits.known;
    let (mut value, mut slope) = (value.or_where(apart, zero), slope.or_where(apart, L::splat(apart_slope)));
    if L::lanes_of(unknown) != 0 {
        // Zero may be an argument like others, of which nothing is known ahead.
        for (number, (known, known_slope)) in [(load, at_zero), (x, at_pull_off)] {
            let other = L::or_mask(L::or_mask(zero.lt(number), number.lt(zero)), L::splat(known).is_nan());
            let is_known = L::and_mask(unknown, L::not_mask(L::or_mask(other, apart)));
            value = value.or_where(is_known, L::splat(known));
            slope = slope.or_where(is_known, L::splat(known_slope));
        }
    }
    let slow = L::and_mask(value.is_nan(), L::not_mask(failed));
    Answers { value: value.or_where(excessive, nan), slope: slope.or_where(excessive, nan), slow, failed }
}

/// Leads the lanes of which the row is a link to the parts of it in which their loads lie, at `t` within the whole row. Whether
/// there are any.
#[inline(always)]
unsafe fn follow_links<L: Lanes>(table: &Table, found: &mut Found<L>, t: L) -> bool {
    let inside = L::not_mask(t.is_nan());
    if L::lanes_of(inside) == 0 {
        return false;
    }
    let c = L::rows(table.rows.as_ptr(), &found.offset);
    let first = L::and_bits(c[0].bits(), L::splat_bits(OFFSET));
    let linked = L::and_mask(c[0].is_nan(), inside);
    if L::lanes_of(linked) == 0 {
        return false;
    }
    // One part on for each that does not begin after t.
    let mut part = first;
    let mut begin = L::splat(0.0);
    let divisions = &c[COEFFICIENTS - DIVISIONS..];
    for &division in divisions {
        let before = t.lt(division);
        begin = division.or_where(before, begin);
        let next = L::or_bits_where(L::splat_bits(size_of::<Row>() as u64), before, L::splat_bits(0));
        part = L::add_bits(part, next);
    }
    // The first part begins where what it is a part of does.
    let within = t.sub(begin).or_where(t.lt(divisions[0]), found.t);
    found.t = found.t.or_where(linked, within);
    found.offset = L::or_bits_where(found.offset, linked, part);
    true
}

/// Values and their slopes by t; where the table does not reach and nothing overflows or underflows, those of the power with which
/// it goes on.
#[inline(always)]
unsafe fn or_beyond<L: Lanes, const SLOPE: bool>(
    limits: &Limits,
    found: &Found<L>,
    (mut value, mut slope): (L, L),
) -> (L, L) {
    let (table, beyond) = (limits.table, limits.beyond);
    let outside = found.t.is_nan();
    let is_light = found.load.sub(L::splat(table.pull_off)).lt(L::splat(beyond.begin));
    for (is_heavy, end) in beyond.ends.iter().enumerate() {
        let is_here = L::and_mask(outside, if is_heavy == 1 { L::not_mask(is_light) } else { is_light });
        if L::lanes_of(is_here) == 0 {
            continue;
        }
        let x = found.load.sub(L::splat(end.origin));
        let exponent = L::shift_right(x.bits(), MANTISSA_BITS);
        let (first, last) = (*end.moderate.start(), *end.moderate.end());
        let is_moderate = L::below(L::sub_bits(exponent, L::splat_bits(first)), last + 1 - first);
        let is_answered = L::and_mask(is_here, is_moderate);
        if L::lanes_of(is_answered) == 0 {
            continue;
        }
        let x = L::or_bits_where(L::splat_bits(end.binade << MANTISSA_BITS), is_answered, x.bits());
        let (binade, exponent) = (L::splat_bits(end.binade), L::shift_right(x, MANTISSA_BITS));
        let mut binades = if is_heavy == 1 { L::sub_bits(exponent, binade) } else { L::sub_bits(binade, exponent) };
        let mut factor = L::splat(1.0);
        for factors in &end.factors {
            let digit = L::and_bits(binades, L::splat_bits(DIGIT as u64 - 1));
            factor = factor.mul(L::gather(factors.as_ptr(), digit));
            binades = L::shift_right(binades, DIGIT_BITS);
            // The factors of no binade are 1.
            if L::lanes_of(L::below(binades, 1)) == L::ALL {
                break;
            }
        }
        // The row's offset in bytes, as in the table, within a binade.
        let shifted = L::shift_right(x, Continuation::shift() - ROW_SHIFT);
        let offset = L::and_bits(shifted, L::splat_bits((end.rows.len() as u64 - 1) << ROW_SHIFT));
        let c = L::rows(end.rows.as_ptr(), &offset);
        let (power, rate) = polynomial::<L, SLOPE>(&c, within::<L>(Table::within_row(Continuation::shift()), x));
        value = value.or_where(is_answered, L::splat(end.base).add(factor.mul(power)));
        if SLOPE {
            slope = slope.or_where(is_answered, factor.mul(rate).mul(per_mantissa::<L>(x)));
        }
    }
    (value, slope)
}

/// Where the coefficient is not capped, nor the load so light that the slope may overflow; not where the force is NaN.
#[inline(always)]
unsafe fn open<L: Lanes, const SLOPE: bool>(limits: &Limits, load: L, force: L) -> L::Mask {
    let open = force.mul(L::splat(limits.inverse_cap)).lt(load);
    if SLOPE {
        L::and_mask(open, L::splat(LIGHTEST).lt(load))
    } else {
        open
    }
}

#[inline(always)]
unsafe fn times<L: Lanes>(factor: f64, coefficient: L) -> L {
    L::splat(factor).mul(coefficient)
}
