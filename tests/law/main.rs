//! The compiled law: against exact states of the same model.

#[path = "../common/mod.rs"]
mod common;

mod beyond_table;
mod compiled;
mod extreme_summits;
mod load_at_gap;
