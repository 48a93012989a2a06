//! The population of summits: how their heights are distributed and how their radii vary with height.

pub mod heights;
pub mod radius;
pub mod spectrum;
