//! Texts, as C takes them: copied into a buffer of the caller.

use std::ffi::c_char;

/// Copies a text, given in pieces, into a caller's buffer, NUL-terminated and cut to fit; returns its whole length.
///
/// # Safety
/// `buffer` is NULL or has `length` bytes.
pub unsafe fn write_text<'a>(buffer: *mut c_char, length: usize, pieces: impl IntoIterator<Item = &'a [u8]>) -> usize {
    // The last byte is for the NUL.
    let room = if buffer.is_null() { 0 } else { length.saturating_sub(1) };
    let mut whole: usize = 0;
    for piece in pieces {
        let count = piece.len().min(room.saturating_sub(whole));
        // SAFETY: no more than the room that is left in the caller's bytes.
        std::ptr::copy_nonoverlapping(piece.as_ptr(), buffer.cast::<u8>().wrapping_add(whole), count);
        whole += piece.len();
    }
    if !buffer.is_null() && length > 0 {
        buffer.add(whole.min(room)).write(0);
    }
    whole
}
