//! Random bytes through the C interface: parameters, calls, their order and arguments (`fuzz_calls/`).
//!
//! `cargo test` makes about 40,000 calls. `make fuzz` makes 10^7; ASPERITY_FUZZ_CALLS and ASPERITY_FUZZ_SEED say how
//! many and which.

use super::fuzz_calls::{run, Tally};
use crate::common::number_from_environment;
use crate::common::splitmix::SplitMix;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::time::Instant;

const SEED: u64 = 0x5eed_f022;
const CALLS: u64 = 40_000;
/// Calls after which a long run says how far it is.
const PROGRESS: u64 = 500_000;
/// So many failures are enough to know.
const MOST_FAILURES: usize = 8;

impl Tally {
    /// All calls.
    fn total(&self) -> u64 {
        self.calls.values().sum()
    }

    /// Takes over what another saw.
    fn merge(&mut self, other: Self) {
        for (name, count) in other.calls {
            *self.calls.entry(name).or_default() += count;
        }
        for (status, count) in other.refused {
            *self.refused.entry(status).or_default() += count;
        }
        if other.slowest > self.slowest {
            (self.slowest, self.slowest_call) = (other.slowest, other.slowest_call);
        }
        self.too_slow.extend(other.too_slow);
        self.table_difference = self.table_difference.max(other.table_difference);
        self.table_ratio = self.table_ratio.max(other.table_ratio);
        self.secant_difference = self.secant_difference.max(other.secant_difference);
        self.unresolved += other.unresolved;
        self.largest_fall = self.largest_fall.max(other.largest_fall);
    }
}

/// One input, from its own seed.
fn input(seed: u64) -> Vec<u8> {
    let mut random = SplitMix(seed);
    let length = 64 << random.below(8);
    (0..length).map(|_| random.bits() as u8).collect()
}

/// A gap of 0 far below the last whole row of the table, a share rounded above what a sum can have, a table that is 1e100 times
/// off, a slope at a far displacement, layers next to pull-off in which friction falls, a stiffness that is again the largest.
#[test]
fn bytes_that_once_failed_do_not_again() {
    for seed in [
        0xa9e_0001_6062,
        0xdc9_0001_6062,
        0x15e7_0001_6062,
        0x1a14_0001_6062,
        0x2a9e_0001_6062,
        0x687c_0000_0309,
        0x6b30_00ab_ff5a,
        0x88b1_00ab_ff5a,
        0x778d_00ac_01a3,
        0x5b_0000_16c6,
        0x407_78c4_07d0,
        0x7e0_78c4_07d1,
    ] {
        run(&input(seed), &mut Tally::default());
    }
}

#[test]
fn any_bytes_give_answers_as_promised() {
    let seed = number_from_environment("ASPERITY_FUZZ_SEED", SEED);
    let wanted = number_from_environment("ASPERITY_FUZZ_CALLS", CALLS);
    let start = Instant::now();
    let mut tally = Tally::default();
    let mut failures = Vec::new();
    let mut inputs = 0;
    while tally.total() < wanted && failures.len() < MOST_FAILURES {
        let this = seed.wrapping_add(inputs << 32);
        inputs += 1;
        let bytes = input(this);
        let mut seen = Tally::default();
        if let Err(panic) = catch_unwind(AssertUnwindSafe(|| run(&bytes, &mut seen))) {
            let text = panic.downcast_ref::<String>().cloned();
            println!("failed: seed {this:#x}");
            failures.push(format!("seed {this:#x}: {}", text.unwrap_or_else(|| "a panic without text".into())));
        }
        let before = tally.total();
        tally.merge(seen);
        if tally.total() / PROGRESS > before / PROGRESS {
            println!("{} calls of {wanted} in {:.0?}, {} failures", tally.total(), start.elapsed(), failures.len());
        }
    }
    let took = start.elapsed().as_secs_f64();
    println!("{} calls of {} inputs from seed {seed:#x} in {took:.1} s", tally.total(), inputs);
    for (name, count) in &tally.calls {
        println!("  {name}: {count}");
    }
    println!("refused by status: {:?}", tally.refused);
    println!("slowest call: {:?}, {}", tally.slowest, tally.slowest_call);
    println!(
        "table against exact: {:.1e}, {:.2} times table_error; slope against secant: {:.1e}, but {} between states that are \
         one to rounding; largest fall of F: {:.1e}",
        tally.table_difference, tally.table_ratio, tally.secant_difference, tally.unresolved, tally.largest_fall
    );
    // Without optimisation all is slow.
    if !cfg!(debug_assertions) {
        failures.extend(tally.too_slow.into_iter().take(MOST_FAILURES));
    }
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
}
