//! Friction laws from contact physics, callable from any solver.
//!
//! The crate computes the friction of two rough surfaces under a normal load, with its slope, for the contacts of a solver.
//! The model sums over the summits at which the surfaces touch: adhesion (Maugis), a shear strength that depends on the
//! radius of each contact (Hurtado and Kim), and attraction of summits out of contact, over a distribution of heights
//! (Adams and Müftü, J. Phys. D: Appl. Phys. 38 (2005) 1402–1409). It does not predict the shear strength of the
//! interface: call [`Params::calibrate`] with one measurement.
//!
//! ```
//! use asperity::materials::Bodies;
//! use asperity::{Model, Params};
//!
//! // SI units; any other consistent system will do, if you set moduli and lengths yourself.
//! let mut params = Params::default();
//! params.set_bodies(&Bodies::find("steel/steel").ok_or("two names of asperity::materials")?)?;
//! params.height_std = 0.3e-6;
//! params.summit_radius = 10e-6;
//! params.asperity_count = 1.7e10 * 1e-4; // summits per area, times the area
//! let model = Model::new(&params)?;
//!
//! // The compiled law, in nanoseconds, for the inner loop of a solver ...
//! let (mu, slope) = model.friction_and_slope(10.0);
//! assert!(mu > 0.0 && slope < 0.0);
//! // ... and the exact state, for the engineer.
//! let state = model.state_at_load(10.0)?;
//! assert!((state.friction_coefficient / mu - 1.0).abs() < 1e-6);
//! println!("{} of the summits touch, warnings {:#b}", state.contacting, model.check_loads(1.0, 100.0)?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// A library says what it has to say by its answers.
#![cfg_attr(not(test), deny(clippy::print_stdout, clippy::print_stderr))]
// Units stand in brackets, which rustdoc takes for links.
#![allow(rustdoc::broken_intra_doc_links, rustdoc::private_intra_doc_links)]

mod by_name;
#[doc(hidden)]
pub mod capi;
mod equilibrium;
mod error;
mod estimate;
mod law;
pub mod materials;
mod memory;
mod model;
mod numerics;
mod params;
mod specimens;
mod text;

// Parts of the physics, which tests of this crate ask one by one; no part of the interface.
#[doc(hidden)]
pub mod asperity;
#[doc(hidden)]
pub mod distribution;
#[doc(hidden)]
pub mod population;

pub use crate::asperity::slip::{SlipConstants, SlipOnset};
pub use error::{CalibrationFailure, Error, Value};
pub use memory::{MicroslipStep, STATE as MICROSLIP_LENGTH};
pub use model::validity::{
    WARNING_ADHESIVE, WARNING_ATOMIC, WARNING_BROAD, WARNING_CROWDED, WARNING_FEW, WARNING_FEW_WAVES, WARNING_FLAT_TOP,
    WARNING_NOT_GAUSSIAN, WARNING_PLASTIC, WARNING_STEEP, WARNING_STRONG, WARNING_UNCALIBRATED,
};
pub use model::{Model, State, Summary};
pub use params::spectrum::SpectralMoments;
pub use params::{ContactLawKind, HeightFamily, Params, Waviness, WavinessShape};
pub use specimens::{spread, Held, Specimens};
