//! The C interface: any arguments, pointers and threads; the same bits from every call that answers one question.

#![allow(unsafe_code)]

#[path = "../common/mod.rs"]
mod common;

mod allocations;
mod contract;
mod domains;
mod estimate;
mod fuzz;
mod fuzz_calls;
mod gap;
mod interface;
#[cfg(all(unix, not(miri)))]
mod letters;
mod microslip;
mod pairs;
#[cfg(not(miri))]
mod programs;
mod refusals;
mod surface_text;
mod surfaces;
mod tangential;
