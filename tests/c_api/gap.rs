//! Loads at gaps: a batch says what is wrong where, and parts where one contact does.

use crate::interface::*;
use std::ptr::null_mut;

fn models() -> [Handle; 4] {
    let paper = asperity_params::dimensionless(0.01, 1000.0, 0.001, 1.0);
    [
        Handle::new(&paper),
        Handle::new(&asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0)),
        Handle::new(&paper.weibull(1.2)),
        Handle::new(&paper.radii(0.9, 2.0)),
    ]
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
