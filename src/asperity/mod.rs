//! The laws of one asperity against a flat: the groups they depend on, contact, attraction out of contact, slip.

pub mod attraction;
pub mod contact;
pub mod elastic_plastic;
pub mod groups;
pub mod hertz;
pub mod maugis;
pub mod slip;
pub mod unloaded;
