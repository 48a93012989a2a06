//! What one number may be.

use crate::error::Error;
use crate::numerics::float_bits::{finite, nan};

/// Raw quantities beyond this, or below its inverse, could overflow when combined.
pub const LARGEST_QUANTITY: f64 = 1e40;

pub const POSITIVE: &str = "must be finite and > 0";

pub fn positive(name: &'static str, value: f64) -> Result<(), Error> {
    magnitude(name, value, POSITIVE)
}

pub fn not_negative(name: &'static str, value: f64, allowed: &'static str) -> Result<(), Error> {
    // By bits, as a NaN may be a signalling one.
    let is_zero = value.to_bits() << 1 == 0;
    if is_zero {
        Ok(())
    } else {
        magnitude(name, value, allowed)
    }
}

pub fn magnitude(name: &'static str, value: f64, allowed: &'static str) -> Result<(), Error> {
    if !finite(value) || value <= 0.0 {
        return Err(Error::invalid(name, value, allowed));
    }
    if !(1.0 / LARGEST_QUANTITY..=LARGEST_QUANTITY).contains(&value) {
        return Err(Error::out_of_range(name, value, "must be between 1e-40 and 1e40; choose other units"));
    }
    Ok(())
}

pub fn poisson_ratio(name: &'static str, value: f64) -> Result<(), Error> {
    if nan(value) || !(value > -1.0 && value <= 0.5) {
        return Err(Error::invalid(
            name,
            value,
            "must be > -1 and <= 0.5; is it in per cent, or Young's modulus, which comes before it?",
        ));
    }
    Ok(())
}
