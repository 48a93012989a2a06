//! The C interface. It knows nothing of physics: it checks pointers, converts structs, contains panics.
//!
//! Every entry point passes through [`boundary`], most through [`boundary::status`]. All `unsafe` of the library is
//! in this folder.
#![allow(unsafe_code, non_camel_case_types)]

mod batch;
mod boundary;
mod evaluate;
mod fp_environment;
mod last_error;
mod model;
mod params;
mod reserve;
mod scalar;
mod setters;
mod slope;
mod state;
mod status;
mod table;
mod version;
