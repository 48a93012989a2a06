//! The law for four loads side by side.

use super::avx2::{Bits, Lanes, Mask};
use super::{one, Arrays, Asked, FirstInvalid};
use crate::law::{Beyond, Continuation, Row, Table, COEFFICIENTS, DIGIT, DIGIT_BITS, DIVISIONS, OFFSET};
use crate::model::{Known, Model};
use crate::numerics::float_bits::MANTISSA_BITS;
use std::mem::{size_of, MaybeUninit};

const SIGN_AND_EXPONENT: u64 = !Table::MANTISSA;
/// log2 of the size of a row.
const ROW_SHIFT: u32 = size_of::<Row>().trailing_zeros();
/// Lighter positive loads may make a slope overflow: the scalar call takes care.
const LIGHTEST: f64 = 1e-100;
/// In place of a load that is not tame, of which arithmetic or a comparison would raise a flag: below any table.
const BELOW_TABLES: f64 = -1e300;

/// Vectors whose rows are found before the first of them is read. What a processor can look ahead is less than the way
/// from a load to its result: a row whose address is known by then need not wait.
const BLOCK: usize = 16;

/// Where the table has the answers to a vector of loads.
#[derive(Clone, Copy)]
struct Found {
    /// The loads, with [`BELOW_TABLES`] for those that are not tame.
    load: Lanes,
    /// Where within its row, or the part of it, each load lies; NaN where the table does not reach.
    t: Lanes,
    /// The row's offset in bytes; the first row's where the table does not reach.
    offset: Bits,
}

/// A vector that is not answered by rows alone.
#[derive(Clone, Copy)]
struct Other {
    found: Found,
    /// Its first element.
    i: usize,
    /// What its rows give, if all lanes have one.
    values: Option<(Lanes, Lanes)>,
    /// Whether links lead any lane to a row.
    is_linked: bool,
}

/// What vectors of loads are to be compared with.
struct TableLimits<'a> {
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
struct Answers {
    value: Lanes,
    slope: Lanes,
    /// Those that are left to the scalar call.
    slow: Mask,
    /// Those below pull-off, too heavy or not finite.
    failed: Mask,
}

/// What is known beside the table. Zero is a gap like others, and there is no load where the surfaces are apart.
fn known(model: &Model, quantity: Asked) -> Known {
    let unknown = (f64::NAN, f64::NAN);
    match quantity {
        Asked::Load => Known { at_pull_off: unknown, at_zero: unknown, apart: 0.0, light_slope: 0.0, heavy: f64::NAN },
        _ => model.known(quantity.tabulated()),
    }
}

/// Evaluates all full vectors; returns how many elements they are.
#[target_feature(enable = "avx2")]
pub unsafe fn evaluate(model: &Model, quantity: Asked, arrays: Arrays, first_invalid: &mut FirstInvalid) -> usize {
    match (quantity == Asked::Coefficient, !arrays.slope.is_null()) {
        (false, false) => evaluate_as::<false, false>(model, quantity, arrays, first_invalid),
        (false, true) => evaluate_as::<false, true>(model, quantity, arrays, first_invalid),
        (true, false) => evaluate_as::<true, false>(model, quantity, arrays, first_invalid),
        (true, true) => evaluate_as::<true, true>(model, quantity, arrays, first_invalid),
    }
}

/// The same, of the coefficient or of what the table has, with slopes or without.
#[inline(always)]
unsafe fn evaluate_as<const COEFFICIENT: bool, const SLOPE: bool>(
    model: &Model,
    quantity: Asked,
    arrays: Arrays,
    first_invalid: &mut FirstInvalid,
) -> usize {
    let table = quantity.table(model);
    let cap = model.params().max_friction_coefficient;
    let (known, inverse_cap, beyond) = (known(model, quantity), model.inverse_cap(), quantity.beyond(model));
    let (least, heaviest) = match quantity {
        Asked::Load => (model.least_approach(), model.deepest_compression()),
        _ => (0.0, model.heaviest_load()),
    };
    let limits = TableLimits { table, known, cap, inverse_cap, beyond, least, heaviest };
    let vectors = arrays.n / Lanes::COUNT;
    let mut block = [MaybeUninit::<Found>::uninit(); BLOCK];
    // The vectors of the block that no rows answer by themselves, or cap.
    let mut others = [MaybeUninit::<Other>::uninit(); BLOCK];
    let mut begin = 0;
    while begin < vectors {
        let in_block = (vectors - begin).min(BLOCK);
        let element = |vector: usize| (begin + vector) * Lanes::COUNT;
        for (vector, found) in block[..in_block].iter_mut().enumerate() {
            found.write(find(table, Lanes::read(arrays.load.add(element(vector)))));
        }
        let mut count = 0;
        for (vector, found) in block[..in_block].iter().enumerate() {
            let (found, i) = (found.assume_init_ref(), element(vector));
            if let Err(values) = by_rows::<SLOPE>(&limits, COEFFICIENT, found, arrays, i) {
                others[count].write(Other { found: *found, i, values, is_linked: false });
                count += 1;
            }
        }
        if count != 0 {
            answer_others::<SLOPE>(model, quantity, &limits, arrays, &mut others[..count], first_invalid);
        }
        begin += in_block;
    }
    vectors * Lanes::COUNT
}

/// Answers what rows alone do not: compiled once for all quantities, as it takes 5 kB.
#[target_feature(enable = "avx2")]
#[inline(never)]
unsafe fn answer_others<const SLOPE: bool>(
    model: &Model,
    quantity: Asked,
    limits: &TableLimits,
    arrays: Arrays,
    others: &mut [MaybeUninit<Other>],
    first_invalid: &mut FirstInvalid,
) {
    let (table, is_coefficient) = (limits.table, quantity == Asked::Coefficient);
    // All links before the first of their parts is read, as above.
    for other in &mut *others {
        let other = other.assume_init_mut();
        if other.values.is_none() {
            let t = other.found.t;
            other.is_linked = follow_links(table, &mut other.found, t);
        }
    }
    'others: for other in others {
        let Other { found, i, values, is_linked } = other.assume_init_mut();
        while *is_linked {
            match by_rows::<SLOPE>(limits, is_coefficient, found, arrays, *i) {
                Ok(()) => continue 'others,
                Err(of_parts) => *values = of_parts,
            }
            // Parts may be links too.
            *is_linked = values.is_none() && follow_links(table, found, find(table, found.load).t);
        }
        let (value, rate) = match *values {
            Some(values) => values,
            None if Lanes::lanes_of(found.t.is_nan()) == Lanes::ALL => (found.t, found.t),
            None => polynomial::<SLOPE>(&Lanes::rows(table.rows.as_ptr(), &found.offset), found.t),
        };
        // Where the rows do not answer the rate is NaN, so that no product raises a flag whatever the binade is.
        let slope = if SLOPE { by_load(table, found.load, rate) } else { rate };
        let (value, slope) = if Lanes::lanes_of(found.t.is_nan()) == 0 {
            (value, slope)
        } else {
            or_beyond::<SLOPE>(limits, found, (value, slope))
        };
        let loads = Lanes::read(arrays.load.add(*i));
        let answers = beside_rows::<SLOPE>(limits, is_coefficient, loads, value, slope);
        write_and_ask::<SLOPE>(&answers, model, quantity, arrays, *i, first_invalid);
    }
}

/// Writes the answers to the elements from the i-th on, if rows have all of them and none is capped or needs care; otherwise
/// gives what the rows have, if there is one for each.
#[inline(always)]
unsafe fn by_rows<const SLOPE: bool>(
    limits: &TableLimits,
    is_coefficient: bool,
    found: &Found,
    arrays: Arrays,
    i: usize,
) -> Result<(), Option<(Lanes, Lanes)>> {
    let load = found.load;
    // Loading whole rows and transposing them takes half the time of gather instructions.
    let c = Lanes::rows(limits.table.rows.as_ptr(), &found.offset);
    if Lanes::lanes_of(c[0].unordered(found.t)) != 0 {
        return Err(None);
    }
    let (mut value, rate) = polynomial::<SLOPE>(&c, found.t);
    if is_coefficient && Lanes::lanes_of(open::<SLOPE>(limits, load, value)) != Lanes::ALL {
        return Err(Some((value, rate)));
    }
    let mut slope = if SLOPE { by_load(limits.table, load, rate) } else { rate };
    if is_coefficient {
        value = value.div(load);
        slope = if SLOPE { slope.sub(value).div(load) } else { slope };
    }
    write::<SLOPE>(value, slope, arrays, i);
    Ok(())
}

/// Writes the answers to the elements from the i-th on.
#[inline(always)]
unsafe fn write<const SLOPE: bool>(value: Lanes, slope: Lanes, arrays: Arrays, i: usize) {
    if !arrays.value.is_null() {
        value.write(arrays.value.add(i));
    }
    if SLOPE {
        slope.write(arrays.slope.add(i));
    }
}

/// The same, but asks the scalar call for those that are left to it, and keeps the first that is invalid.
#[inline(always)]
unsafe fn write_and_ask<const SLOPE: bool>(
    answers: &Answers,
    model: &Model,
    quantity: Asked,
    arrays: Arrays,
    i: usize,
    first_invalid: &mut FirstInvalid,
) {
    let (slow, failed) = (Lanes::lanes_of(answers.slow), Lanes::lanes_of(answers.failed));
    if slow == 0 && (failed == 0 || first_invalid.is_some()) {
        return write::<SLOPE>(answers.value, answers.slope, arrays, i);
    }
    // The input, before an output that may be the same array is written.
    let mut kept = [0.0; Lanes::COUNT];
    Lanes::read(arrays.load.add(i)).write(kept.as_mut_ptr());
    write::<SLOPE>(answers.value, answers.slope, arrays, i);
    for (lane, &load) in kept.iter().enumerate() {
        if slow >> lane & 1 != 0 {
            one(model, quantity, arrays, i + lane, load, first_invalid);
        } else if failed >> lane & 1 != 0 {
            first_invalid.get_or_insert((i + lane, load));
        }
    }
}

/// Finds the rows.
#[inline(always)]
unsafe fn find(table: &Table, loads: Lanes) -> Found {
    let load = loads.or_where(loads.not_tame(), Lanes::splat(BELOW_TABLES));
    let x = load.sub(Lanes::splat(table.pull_off)).bits();
    // The row's offset in bytes: its index times 64.
    let shifted =
        Lanes::and_bits(Lanes::shift_right(x, table.shift - ROW_SHIFT), Lanes::splat_bits(u64::MAX << ROW_SHIFT));
    let offset = Lanes::sub_bits(shifted, Lanes::splat_bits(table.base << ROW_SHIFT));
    let inside = Lanes::below(offset, (table.row_count as u64) << ROW_SHIFT);
    Found {
        load,
        t: Lanes::splat(f64::NAN).or_where(inside, within(Table::within_row(table.shift), x)),
        offset: Lanes::or_bits_where(Lanes::splat_bits(0), inside, offset),
    }
}

/// Where in its row x of these bits lies.
#[inline(always)]
unsafe fn within(within_row: u64, x: Bits) -> Lanes {
    // The bits of 1 and what follows them.
    let within_row = Lanes::and_bits(x, Lanes::splat_bits(within_row));
    Lanes::from_bits(Lanes::add_bits(within_row, Lanes::splat_bits(Table::ONE))).sub(Lanes::splat(1.0))
}

/// Values from the rows and their slopes by t; NaN outside the table, at links and rows that are left out.
#[inline(always)]
unsafe fn polynomial<const SLOPE: bool>(c: &[Lanes; COEFFICIENTS], t: Lanes) -> (Lanes, Lanes) {
    // The same order of operations as the scalar polynomial.
    let t2 = t.mul(t);
    let t4 = t2.mul(t2);
    let low = c[0].add(c[1].mul(t)).add(c[2].add(c[3].mul(t)).mul(t2));
    let high = c[4].add(c[5].mul(t)).add(c[6].add(c[7].mul(t)).mul(t2));
    let value = low.add(high.mul(t4));
    if !SLOPE {
        return (value, value);
    }
    let low = c[1].add(times(2.0, c[2]).mul(t));
    let low = low.add(times(3.0, c[3]).add(times(4.0, c[4]).mul(t)).mul(t2));
    let high = times(5.0, c[5]).add(times(6.0, c[6]).mul(t)).add(times(7.0, c[7]).mul(t2));
    (value, low.add(high.mul(t4)))
}

/// Slopes by load from slopes by t at finite loads.
#[inline(always)]
unsafe fn by_load(table: &Table, load: Lanes, rate: Lanes) -> Lanes {
    rate.mul(per_mantissa(load.sub(Lanes::splat(table.pull_off)).bits()))
}

/// 1/2^e of x by its bits, e its exponent.
#[inline(always)]
unsafe fn per_mantissa(x: Bits) -> Lanes {
    Lanes::from_bits(Lanes::sub_bits(
        Lanes::splat_bits(Table::TWICE_BIAS),
        Lanes::and_bits(x, Lanes::splat_bits(SIGN_AND_EXPONENT)),
    ))
}

/// What no row answers by itself: capped coefficients, loads at zero and below pull-off.
#[inline(always)]
unsafe fn beside_rows<const SLOPE: bool>(
    limits: &TableLimits,
    is_coefficient: bool,
    loads: Lanes,
    value: Lanes,
    slope: Lanes,
) -> Answers {
    // Those that are not tame have no answer: go on with 1. But below all loads the surfaces are apart.
    let (mut load, mut unanswered) = (loads, loads.not_tame());
    if Lanes::lanes_of(unanswered) != 0 {
        let lowest = Lanes::and_mask(loads.is_negative(), Lanes::not_mask(loads.not_finite()));
        load = load.or_where(unanswered, Lanes::splat(1.0));
        load = load.or_where(Lanes::and_mask(unanswered, lowest), Lanes::splat(BELOW_TABLES));
        unanswered = Lanes::and_mask(unanswered, Lanes::not_mask(lowest));
    }
    let (zero, x) = (Lanes::splat(0.0), load.sub(Lanes::splat(limits.table.pull_off)));
    let apart = x.lt(Lanes::splat(limits.least));
    let excessive = Lanes::or_mask(unanswered, Lanes::splat(limits.heaviest).lt(load));
    let failed = Lanes::or_mask(apart, excessive);
    let nan = Lanes::splat(f64::NAN);
    let pressing = zero.lt(load);
    let unknown = value.is_nan();
    if is_coefficient {
        let ordinary = open::<SLOPE>(limits, load, value);
        let uncapped = value.mul(Lanes::splat(limits.inverse_cap)).lt(load);
        // From pull-off to zero also where the force is not known.
        let capped = Lanes::or_mask(Lanes::not_mask(pressing), Lanes::not_mask(Lanes::or_mask(unknown, uncapped)));
        let capped = Lanes::and_mask(capped, Lanes::not_mask(apart));
        // Only what cannot trap is divided; not chosen by the same mask, or the compiler would divide all.
        let mu = value.div_where(ordinary, load);
        let slope = if SLOPE { slope.sub(mu).div_where(ordinary, load) } else { zero };
        let value = mu.or_where(apart, zero).or_where(capped, Lanes::splat(limits.cap)).or_where(excessive, nan);
        let slope = slope.or_where(Lanes::or_mask(apart, capped), zero).or_where(excessive, nan);
        let slow = Lanes::not_mask(Lanes::or_mask(ordinary, Lanes::or_mask(failed, capped)));
        return Answers { value, slope, slow, failed };
    }
    let Known { at_zero, at_pull_off, apart: apart_slope, .. } = limits.known;
    let (mut value, mut slope) = (value.or_where(apart, zero), slope.or_where(apart, Lanes::splat(apart_slope)));
    if Lanes::lanes_of(unknown) != 0 {
        // Zero may be an argument like others, of which nothing is known ahead.
        for (number, (known, known_slope)) in [(load, at_zero), (x, at_pull_off)] {
            let other = Lanes::or_mask(Lanes::or_mask(zero.lt(number), number.lt(zero)), Lanes::splat(known).is_nan());
            let is_known = Lanes::and_mask(unknown, Lanes::not_mask(Lanes::or_mask(other, apart)));
            value = value.or_where(is_known, Lanes::splat(known));
            slope = slope.or_where(is_known, Lanes::splat(known_slope));
        }
    }
    let slow = Lanes::and_mask(value.is_nan(), Lanes::not_mask(failed));
    Answers { value: value.or_where(excessive, nan), slope: slope.or_where(excessive, nan), slow, failed }
}

/// Leads the lanes of which the row is a link to the parts of it in which their loads lie, at `t` within the whole row. Whether
/// there are any.
#[inline(always)]
unsafe fn follow_links(table: &Table, found: &mut Found, t: Lanes) -> bool {
    let inside = Lanes::not_mask(t.is_nan());
    if Lanes::lanes_of(inside) == 0 {
        return false;
    }
    let c = Lanes::rows(table.rows.as_ptr(), &found.offset);
    let first = Lanes::and_bits(c[0].bits(), Lanes::splat_bits(OFFSET));
    let linked = Lanes::and_mask(c[0].is_nan(), inside);
    if Lanes::lanes_of(linked) == 0 {
        return false;
    }
    // One part on for each that does not begin after t.
    let mut part = first;
    let mut begin = Lanes::splat(0.0);
    let divisions = &c[COEFFICIENTS - DIVISIONS..];
    for &division in divisions {
        let before = t.lt(division);
        begin = division.or_where(before, begin);
        let next = Lanes::or_bits_where(Lanes::splat_bits(size_of::<Row>() as u64), before, Lanes::splat_bits(0));
        part = Lanes::add_bits(part, next);
    }
    // The first part begins where what it is a part of does.
    let within = t.sub(begin).or_where(t.lt(divisions[0]), found.t);
    found.t = found.t.or_where(linked, within);
    found.offset = Lanes::or_bits_where(found.offset, linked, part);
    true
}

/// Values and their slopes by t; where the table does not reach and nothing overflows or underflows, those of the power with which
/// it goes on.
#[inline(always)]
unsafe fn or_beyond<const SLOPE: bool>(
    limits: &TableLimits,
    found: &Found,
    (mut value, mut slope): (Lanes, Lanes),
) -> (Lanes, Lanes) {
    let (table, beyond) = (limits.table, limits.beyond);
    let outside = found.t.is_nan();
    let is_light = found.load.sub(Lanes::splat(table.pull_off)).lt(Lanes::splat(beyond.begin));
    for (is_heavy, end) in beyond.ends.iter().enumerate() {
        let is_here = Lanes::and_mask(outside, if is_heavy == 1 { Lanes::not_mask(is_light) } else { is_light });
        if Lanes::lanes_of(is_here) == 0 {
            continue;
        }
        let x = found.load.sub(Lanes::splat(end.origin));
        let exponent = Lanes::shift_right(x.bits(), MANTISSA_BITS);
        let (first, last) = (*end.moderate.start(), *end.moderate.end());
        let is_moderate = Lanes::below(Lanes::sub_bits(exponent, Lanes::splat_bits(first)), last + 1 - first);
        let is_answered = Lanes::and_mask(is_here, is_moderate);
        if Lanes::lanes_of(is_answered) == 0 {
            continue;
        }
        let x = Lanes::or_bits_where(Lanes::splat_bits(end.binade << MANTISSA_BITS), is_answered, x.bits());
        let (binade, exponent) = (Lanes::splat_bits(end.binade), Lanes::shift_right(x, MANTISSA_BITS));
        let mut binades =
            if is_heavy == 1 { Lanes::sub_bits(exponent, binade) } else { Lanes::sub_bits(binade, exponent) };
        let mut factor = Lanes::splat(1.0);
        for factors in &end.factors {
            let digit = Lanes::and_bits(binades, Lanes::splat_bits(DIGIT as u64 - 1));
            factor = factor.mul(Lanes::gather(factors.as_ptr(), digit));
            binades = Lanes::shift_right(binades, DIGIT_BITS);
            // The factors of no binade are 1.
            if Lanes::lanes_of(Lanes::below(binades, 1)) == Lanes::ALL {
                break;
            }
        }
        // The row's offset in bytes, as in the table, within a binade.
        let shifted = Lanes::shift_right(x, Continuation::shift() - ROW_SHIFT);
        let offset = Lanes::and_bits(shifted, Lanes::splat_bits((end.rows.len() as u64 - 1) << ROW_SHIFT));
        let c = Lanes::rows(end.rows.as_ptr(), &offset);
        let (power, rate) = polynomial::<SLOPE>(&c, within(Table::within_row(Continuation::shift()), x));
        value = value.or_where(is_answered, Lanes::splat(end.base).add(factor.mul(power)));
        if SLOPE {
            slope = slope.or_where(is_answered, factor.mul(rate).mul(per_mantissa(x)));
        }
    }
    (value, slope)
}

/// Where the coefficient is not capped, nor the load so light that the slope may overflow; not where the force is NaN.
#[inline(always)]
unsafe fn open<const SLOPE: bool>(limits: &TableLimits, load: Lanes, force: Lanes) -> Mask {
    let open = force.mul(Lanes::splat(limits.inverse_cap)).lt(load);
    if SLOPE {
        Lanes::and_mask(open, Lanes::splat(LIGHTEST).lt(load))
    } else {
        open
    }
}

#[inline(always)]
unsafe fn times(factor: f64, coefficient: Lanes) -> Lanes {
    Lanes::splat(factor).mul(coefficient)
}
