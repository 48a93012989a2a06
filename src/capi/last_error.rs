//! The message of a thread's last failure, copied out on request.
//!
//! The thread-local has no destructor, so that a host may unload the library while threads that used it live on.

use super::text::write_text;
use std::cell::RefCell;
use std::ffi::c_char;
use std::fmt::{Display, Write};

/// Longer messages are cut.
const CAPACITY: usize = 512;

struct Message {
    bytes: [u8; CAPACITY],
    length: usize,
}

thread_local! {
    static MESSAGE: RefCell<Message> = const { RefCell::new(Message { bytes: [0; CAPACITY], length: 0 }) };
}

impl Write for Message {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        let count = text.len().min(CAPACITY - self.length);
        self.bytes[self.length..][..count].copy_from_slice(&text.as_bytes()[..count]);
        self.length += count;
        Ok(())
    }
}

/// Stores a message for this thread.
#[cold]
#[inline(never)]
pub fn set(message: &dyn Display) {
    MESSAGE.with(|cell| {
        if let Ok(mut stored) = cell.try_borrow_mut() {
            stored.length = 0;
            let _ = write!(stored, "{message}");
        }
    });
}

/// Copies the message of this thread's last failure: which parameter, its value, and what is allowed.
///
/// It is the message of the last call on this thread that returned a status other than `ASPERITY_OK`, and empty if there was
/// none. Calls that succeed do not change it.
///
/// As an example: "summit_radius = -1: must be finite and > 0".
///
/// @return the length of the whole message [bytes], without the NUL: it is cut unless `length` is greater
#[no_mangle]
pub unsafe extern "C" fn asperity_last_error(buffer: *mut c_char, length: usize) -> usize {
    MESSAGE.with(|cell| {
        let Ok(message) = cell.try_borrow() else { return 0 };
        write_text(buffer, length, [&message.bytes[..message.length]])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_that_is_too_long_is_cut() {
        set(&format_args!("{}{}", "a".repeat(CAPACITY - 2), "bcde"));
        MESSAGE.with_borrow(|message| {
            assert_eq!((message.length, &message.bytes[CAPACITY - 3..]), (CAPACITY, b"abc".as_slice()));
        });
    }
}
