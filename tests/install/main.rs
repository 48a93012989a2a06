//! What a user gets: the header.

mod header;
