//! libFuzzer on the C interface: the calls and oracles are those of `tests/c_api/fuzz.rs`.
//!
//! `make fuzz-coverage` runs it with AddressSanitizer.

#![no_main]
#![allow(unsafe_code)]

#[path = "../../tests/c_api/fuzz_calls/mod.rs"]
mod fuzz_calls;
#[path = "../../tests/c_api/interface.rs"]
mod interface;
#[path = "../../src/numerics/neighbours.rs"]
mod neighbours;
#[path = "../../tests/common/processor_time.rs"]
mod processor_time;
#[path = "../../tests/common/splitmix.rs"]
mod splitmix;
mod common {
    pub(crate) use crate::{neighbours, processor_time, splitmix};
}

/// AddressSanitizer and counters of coverage take some three times as long.
const LONGEST_CALL: std::time::Duration = std::time::Duration::from_secs(4);

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let mut tally = fuzz_calls::Tally::default();
    fuzz_calls::run(bytes, &mut tally);
    assert!(tally.too_slow.is_empty() || tally.slowest < LONGEST_CALL, "too slow: {:?}", tally.too_slow);
});
