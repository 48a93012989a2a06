//! One asperity: its contact (Maugis), its attraction out of contact, its friction force.
//!
//! Everything here is dimensionless: contact radii in the Burgers vector b, overlap in sigma, load in
//! E* b^2, friction force in G* b^2. `g` is the local radius of curvature over the mean one, eq (3).

pub mod attraction;
pub mod maugis;
pub mod slip;
