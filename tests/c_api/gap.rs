//! Loads at gaps: the batch has the bits of the scalar call, unaligned and in place, and says what is wrong where.

use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::ptr::null_mut;

const SEED: u64 = 0x6a9;

fn models() -> [Handle; 4] {
    let paper = asperity_params::dimensionless(0.01, 1000.0, 0.001, 1.0);
    [
        Handle::new(&paper),
        Handle::new(&asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0)),
        Handle::new(&paper.weibull(1.2)),
        Handle::new(&paper.radii(0.9, 2.0)),
    ]
}

/// Separations of every kind: among the heights, apart, in compression beyond the table, no numbers.
fn mixed_gaps(random: &mut SplitMix, sigma: f64, count: usize) -> Vec<f64> {
    let corners =
        [f64::NAN, f64::INFINITY, f64::from_bits(0xfff4 << 48), 0.0, -0.0, 1e300, -1e300, f64::from_bits(1), -f64::MAX];
    let gap = |random: &mut SplitMix| match random.below(12) {
        0 => corners[random.below(corners.len())],
        1 => -sigma * random.log_between(1e2, 1e11),
        _ => sigma * random.between(-6.0, 14.0),
    };
    (0..count).map(|_| gap(random)).collect()
}

fn scalar(model: *const asperity_model, gap: f64) -> (f64, f64) {
    let mut slope = 7.0;
    // SAFETY: the model lives.
    let (alone, load) = unsafe {
        let alone = asperity_load_and_slope_at_gap(model, gap, null_mut());
        (alone, asperity_load_and_slope_at_gap(model, gap, &mut slope))
    };
    assert_eq!(alone.to_bits(), load.to_bits(), "{gap:e}");
    (load, slope)
}

#[test]
fn an_element_has_the_bits_of_the_call_for_one() {
    let mut random = SplitMix(SEED);
    for handle in models() {
        let model = handle.0;
        let sigma = asperity_params::initial().height_std;
        for count in [0, 1, 2, 3, 4, 7, 127, 128, 129, 1000] {
            let gaps = mixed_gaps(&mut random, sigma, count);
            let expected: Vec<(f64, f64)> = gaps.iter().map(|&d| scalar(model, d)).collect();
            let same = |loads: &[f64], slopes: &[f64]| {
                for (i, &(load, slope)) in expected.iter().enumerate() {
                    let found = (loads[i].to_bits(), slopes[i].to_bits());
                    assert_eq!(found, (load.to_bits(), slope.to_bits()), "{i}: {:e}", gaps[i]);
                }
            };
            let (mut load, mut slope) = (vec![0.0; count], vec![0.0; count]);
            // SAFETY: arrays of so many elements; in place both ways.
            unsafe {
                let (d, loads, slopes) = (gaps.as_ptr(), load.as_mut_ptr(), slope.as_mut_ptr());
                asperity_loads_at_gaps(model, count, d, loads, slopes);
                same(&load, &slope);
                let mut place = gaps.clone();
                asperity_loads_at_gaps(model, count, place.as_ptr(), place.as_mut_ptr(), slopes);
                same(&place, &slope);
                place.clone_from(&gaps);
                asperity_loads_at_gaps(model, count, place.as_ptr(), loads, place.as_mut_ptr());
                same(&load, &place);
                // One byte off, and one output only.
                let mut bytes = vec![0_u8; 8 * count + 8];
                let unaligned = bytes.as_mut_ptr().add(1).cast::<f64>();
                std::ptr::copy_nonoverlapping(d.cast::<u8>(), unaligned.cast(), 8 * count);
                asperity_loads_at_gaps(model, count, unaligned, null_mut(), slopes);
                same(&load, &slope);
                asperity_loads_at_gaps(model, count, unaligned, unaligned, null_mut());
                std::ptr::copy_nonoverlapping(unaligned.cast::<u8>(), loads.cast(), 8 * count);
                same(&load, &slope);
            }
        }
    }
}

#[test]
fn the_first_gap_that_is_not_in_order_is_named() {
    let handle = Handle::new(&asperity_params::initial());
    let model = handle.0;
    for (gap, status, says) in [
        (f64::NAN, ASPERITY_INVALID_PARAMETER, "gap = NaN: must be finite"),
        (f64::INFINITY, ASPERITY_INVALID_PARAMETER, "must be finite"),
        (1e4, ASPERITY_SEPARATED, "gap = 10000: the surfaces part at "),
        (f64::MAX, ASPERITY_SEPARATED, "the surfaces part at "),
        (-1e300, ASPERITY_OUT_OF_RANGE, "1e50 height_std"),
    ] {
        for index in [0, 5, 131, 299] {
            let mut gaps = [1.0; 300];
            gaps[index] = gap;
            gaps[299] = gap;
            let mut load = [0.0; 300];
            // SAFETY: arrays of 300 elements.
            let found = unsafe { asperity_loads_at_gaps(model, 300, gaps.as_ptr(), load.as_mut_ptr(), null_mut()) };
            assert_eq!(found, status, "{gap}: {}", message());
            let message = message();
            assert!(message.starts_with(&format!("element {index}: ")) && message.contains(says), "{message}");
            assert!(load[index].is_nan() != (status == ASPERITY_SEPARATED), "{}", load[index]);
        }
    }
}

/// Many at a time are answered otherwise than one.
#[test]
fn a_batch_parts_where_one_contact_does() {
    for handle in models() {
        let mut table = asperity_table::empty();
        let mut load = [0.0; 16];
        let mut at = |gap: f64, n| {
            // SAFETY: arrays of 16 elements.
            let status =
                unsafe { asperity_loads_at_gaps(handle.0, n, [gap; 16].as_ptr(), load.as_mut_ptr(), null_mut()) };
            (status, load[0])
        };
        // SAFETY: a struct of its size.
        assert_eq!(unsafe { asperity_table_of(handle.0, ASPERITY_TABLE_LOAD_AT_GAP, &mut table) }, ASPERITY_OK);
        let first_row = f64::from_bits(table.base << table.shift);
        let mut parted = [0; 2];
        for part in [-1.0, -1e-9, 0.0, 1e-300, 1e-9, 0.3, 0.999, 1.0, 1.001, 2.0] {
            let gap = -(table.pull_off_load + part * first_row);
            assert_eq!(at(gap, 16), at(gap, 1), "{part} of the first row");
            parted[usize::from(at(gap, 1).0 == ASPERITY_SEPARATED)] += 1;
        }
        assert!(parted.iter().all(|&count| count > 1), "{parted:?}");
    }
}
