//! The compiled law: against exact states of the same model.

#[path = "../common/mod.rs"]
mod common;

mod compiled;
mod load_at_separation;
