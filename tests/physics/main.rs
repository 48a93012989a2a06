//! The model's answers: against reference values, published numbers, closed forms, and what the paper's figures show.

#[path = "../common/mod.rs"]
mod common;

mod contacts;
mod figures;
mod film;
mod foundation;
mod heights;
mod mean_planes;
mod microslip;
mod published;
mod reference;
mod specimens;
mod tangential;
mod unloading;
mod validity;
mod waviness;
mod yielding;
