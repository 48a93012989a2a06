//! The laws of one asperity against a flat: contact, attraction out of contact, slip.

pub mod attraction;
pub mod contact;
pub mod elastic_plastic;
pub mod hertz;
pub mod maugis;
pub mod slip;
