//! Friction laws from contact physics, callable from any solver.
//!
//! Two rough elastic surfaces touch at their summits; adhesion pulls them together (Maugis), each summit's shear
//! strength depends on its own contact radius (Hurtado and Kim), and summits out of contact still attract. Summed
//! over the distribution of heights, friction depends on load and scale (Adams and Müftü, Nanotechnology 16 (2005)).
//!
//! ```
//! use asperity::{Model, Params};
//!
//! let model = Model::new(&Params::default())?;
//! let mu = model.friction_at_load(1.0);
//! assert!(mu > model.friction_at_load(100.0));
//! # Ok::<(), asperity::Error>(())
//! ```

pub mod asperity;
mod c_string;
#[doc(hidden)]
pub mod capi;
pub mod distribution;
mod elementary;
mod equilibrium;
mod error;
mod float_bits;
pub mod groups;
mod joint_distribution;
mod law;
pub mod materials;
mod model;
mod neighbours;
pub mod numerics;
mod params;
pub mod population;
pub mod regularised;
mod sensitivity;
pub mod spectrum;
mod validity;

pub use error::{Error, Value};
pub use model::{Model, State, Summary, SummitState};
pub use params::{ContactLawKind, HeightFamily, Params};
pub use sensitivity::Sensitivities;
pub use validity::{WARNING_ATOMIC, WARNING_CROWDED, WARNING_FEW, WARNING_PLASTIC, WARNING_STEEP};
