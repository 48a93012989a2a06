//! The sums against integrals over heights by another rule, and surfaces for unit tests.

use super::*;
use crate::params::Params;

/// The population of a surface that is valid.
pub fn of(params: &Params) -> Population {
    let (groups, heights, radius) = params.surface().expect("a surface");
    Population::new(&groups, params.slip, heights, radius, params.attraction).expect("a population")
}
