//! The friction force as a function of load.

use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::population::Population;

/// placeholder until compiled
#[derive(Debug, Clone)]
pub struct Law;

impl Law {
    /// new
    pub fn new(_: &Population, _: &Equilibrium) -> Result<Self, Error> {
        Ok(Self)
    }
    /// range
    pub fn range(&self) -> (f64, f64) {
        (0.0, 0.0)
    }
    /// error
    pub fn error(&self) -> f64 {
        0.0
    }
}
