//! libFuzzer on the C interface: the calls and oracles are those of `tests/fuzz.rs`.
//!
//! `make fuzz-coverage` runs it with AddressSanitizer.

#![no_main]
#![allow(unsafe_code)]

#[path = "../../tests/c_abi/mod.rs"]
mod c_abi;
#[path = "../../tests/fuzz_calls/mod.rs"]
mod fuzz_calls;
#[path = "../../tests/processor_time/mod.rs"]
mod processor_time;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let mut tally = fuzz_calls::Tally::default();
    fuzz_calls::run(bytes, &mut tally);
    assert!(tally.too_slow.is_empty(), "too slow: {:?}", tally.too_slow);
});
