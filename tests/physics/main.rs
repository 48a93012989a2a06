//! The model's answers: against reference values, published numbers, closed forms, and what the paper's figures show.

#[path = "../common/mod.rs"]
mod common;

mod contacts;
mod figures;
mod heights;
mod published;
mod reference;
mod tangential;
mod validity;
mod yielding;
