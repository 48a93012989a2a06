//! What a user begins with: the header, the programs of the pages, the examples in C and C++.

#[path = "../common/mod.rs"]
mod common;

#[cfg(unix)]
mod declarations;
mod example;
mod header;
mod readme;
