//! Sums, pull-off and their slopes: against a second evaluation that shares no code with the library.

#[path = "../common/mod.rs"]
mod common;

mod domain;
mod domain_map;
mod findings;
mod found_by_sweeps;
mod states;
mod thresholds;
