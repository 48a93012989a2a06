//! The C interface. It knows nothing of physics: it checks pointers, converts structs, contains panics.
//!
//! Every entry point passes through `boundary`, most through `boundary::status`. All `unsafe` of the library is
//! in this folder.
#![allow(unsafe_code, non_camel_case_types)]

mod about;
mod batch;
mod boundary;
mod calibration;
mod estimate;
mod evaluate;
#[cfg(target_arch = "x86_64")]
mod four_avx2;
mod fp_environment;
mod gap;
mod given;
mod last_error;
mod look_up;
mod microslip;
mod model;
mod names;
mod output;
mod pairs;
mod params;
mod scalar;
mod setters;
mod specimens;
mod state;
mod status;
mod surface_file;
mod surface_text;
mod table;
mod tables;
mod tangential;
mod text;
mod validity;
mod version;

// For C through the header, for the tests of this crate as items; no part of the Rust interface.
pub use about::*;
pub use calibration::*;
pub use estimate::*;
pub use evaluate::*;
pub use gap::*;
pub use last_error::asperity_last_error;
pub use look_up::*;
pub use microslip::*;
pub use model::*;
pub use names::*;
pub use pairs::*;
pub use params::*;
pub use setters::*;
pub use specimens::*;
pub use state::*;
pub use status::*;
pub use surface_file::*;
pub use surface_text::*;
pub use table::*;
pub use tangential::*;
pub use validity::*;
pub use version::*;
