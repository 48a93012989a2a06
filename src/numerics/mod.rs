//! Numerical methods that know nothing of contacts: quadrature, interpolation and roots.

pub mod hermite;
pub mod quadrature;
pub mod root;
