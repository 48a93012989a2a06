//! Names of a caller whose field of letters may have no NUL.

use crate::interface::*;
use std::ffi::c_char;
use std::ptr::null_mut;

/// Letters with nothing behind them: no NUL, and no memory that may be read.
struct Letters {
    pages: *mut u8,
    page: usize,
    count: usize,
}

impl Letters {
    fn new(count: usize) -> Self {
        // SAFETY: two pages of our own, of which the second is closed.
        unsafe {
            let page = usize::try_from(libc::sysconf(libc::_SC_PAGESIZE)).expect("a page has a size");
            let (open, own) = (libc::PROT_READ | libc::PROT_WRITE, libc::MAP_PRIVATE | libc::MAP_ANON);
            let pages = libc::mmap(null_mut(), 2 * page, open, own, -1, 0);
            assert_ne!(pages, libc::MAP_FAILED);
            let pages = pages.cast::<u8>();
            pages.add(page - count).write_bytes(b'x', count);
            assert_eq!(libc::mprotect(pages.add(page).cast(), page, libc::PROT_NONE), 0);
            Self { pages, page, count }
        }
    }

    fn pointer(&self) -> *const c_char {
        // SAFETY: within the first page.
        unsafe { self.pages.add(self.page - self.count).cast() }
    }
}

impl Drop for Letters {
    fn drop(&mut self) {
        // SAFETY: mapped so.
        unsafe { libc::munmap(self.pages.cast(), 2 * self.page) };
    }
}

/// The header's promise to a caller whose field of letters may have no NUL; more letters than that are not told of either.
#[test]
fn no_more_than_64_bytes_of_a_name_are_read() {
    let mut params = asperity_params::unset();
    let told = "x".repeat(64);
    // First the longer ones, to be told of a limit that is too long before it is the end of the process.
    for letters in [Letters::new(70), Letters::new(64)] {
        let name = letters.pointer();
        let mut value = 0.0;
        // A description fails with the length 0.
        let calls: [&mut dyn FnMut() -> i32; 4] = [
            // SAFETY: initialised parameters, and names of 64 bytes; what is refused writes nothing.
            &mut || unsafe {
                asperity_describe(ASPERITY_NAMES_MATERIALS, name, null_mut(), 0) as i32 + INVALID_PARAMETER
            },
            &mut || unsafe { asperity_params_get_value(&asperity_params::unset(), name, &mut value) },
            &mut || unsafe { asperity_params_set_pair(&mut asperity_params::unset(), name) },
            &mut || unsafe { asperity_params_set_values(&mut params, 1, &name, &1.0) },
        ];
        for (i, call) in calls.into_iter().enumerate() {
            assert_eq!(call(), INVALID_PARAMETER, "{i}: {}", message());
            let others = message().strip_prefix(&told).map(|others| others.starts_with('x'));
            assert_eq!(others, Some(false), "{i}: {}", message());
        }
    }
}
