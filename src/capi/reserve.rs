//! Memory set aside while a model is made, so that a failed allocation is a status and not the abort that Rust makes of it.
//!
//! An allocation that the system refuses to a thread inside [`held`] comes out of the thread's reserve. Where that was a
//! temporary one, nothing is lost; what still lies in the reserve at the end is dropped again, and the call fails with
//! `ASPERITY_OUT_OF_MEMORY`. The physics allocates as it likes and knows nothing of this.
//!
//! The C interface allocates nowhere else but in [`held`]. A Rust program that uses the crate gets this allocator as its
//! own, which outside [`held`] is the system's, unless it leaves out the feature `memory-reserve`.

use super::boundary::Failure;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};

/// Bytes set aside: more than any call takes. A table of 256 heights takes half of it; `tests/harden/out_of_memory.c` has models
/// made of nothing else.
const SIZE: usize = 1 << 23;
const WHOLE: Layout = match Layout::from_size_align(SIZE, 64) {
    Ok(layout) => layout,
    Err(_) => panic!("a layout"),
};

/// A thread's reserve.
#[derive(Clone, Copy)]
struct Reserve {
    /// NULL where nothing is set aside.
    start: *mut u8,
    /// Bytes handed out, from the start.
    used: usize,
    /// Blocks handed out and not yet given back.
    live: usize,
}

const NONE: Reserve = Reserve { start: std::ptr::null_mut(), used: 0, live: 0 };

thread_local! {
    // Without a destructor or a lazy value: reading it allocates nothing.
    static RESERVE: Cell<Reserve> = const { Cell::new(NONE) };
}

/// Makes something, with a reserve for the allocations that the system refuses. What `make` keeps, it returns.
///
/// # Errors
/// [`Failure::out_of_memory`] where the system refused memory that is to stay; else what `make` fails with.
pub fn held<T>(make: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    let outer = Reserve::open()?;
    let mut made = catch_unwind(AssertUnwindSafe(make));
    if RESERVE.get().live > 0 {
        made = Ok(Err(Failure::out_of_memory())); // drops what was made, or the panic's message
    }
    Reserve::close(outer);
    made.unwrap_or_else(|panic| resume_unwind(panic))
}

impl Reserve {
    /// Puts one in place; the one that was there before.
    #[inline(never)]
    fn open() -> Result<Self, Failure> {
        // SAFETY: its size is not 0.
        let start = unsafe { System.alloc(WHOLE) };
        if start.is_null() {
            return Err(Failure::out_of_memory());
        }
        Ok(RESERVE.replace(Self { start, ..NONE }))
    }

    /// Puts the one before back in its place.
    #[inline(never)]
    fn close(outer: Self) {
        let Self { start, live, .. } = RESERVE.replace(outer);
        if live == 0 {
            // SAFETY: it came from there, and nothing of it is in use.
            unsafe { System.dealloc(start, WHOLE) };
        }
    }

    /// A block of what is left; NULL if it does not fit.
    fn take(&mut self, layout: Layout) -> *mut u8 {
        if self.start.is_null() {
            return self.start;
        }
        let at = (self.start as usize + self.used).next_multiple_of(layout.align()) - self.start as usize;
        if layout.size() > SIZE - at.min(SIZE) {
            return std::ptr::null_mut();
        }
        (self.used, self.live) = (at + layout.size(), self.live + 1);
        // SAFETY: within the block of SIZE bytes.
        unsafe { self.start.add(at) }
    }

    /// Whether a block lies in it.
    fn has(&self, at: *mut u8) -> bool {
        !self.start.is_null() && (at as usize).wrapping_sub(self.start as usize) < SIZE
    }

    /// Takes a block back; its memory is there again if it was the last one.
    fn give_back(&mut self, at: *mut u8, size: usize) {
        let offset = at as usize - self.start as usize;
        self.live -= 1;
        if offset + size == self.used {
            self.used = offset;
        }
    }
}

/// The system's allocator, with the reserve behind it.
struct Allocator;

#[cfg(feature = "memory-reserve")]
#[global_allocator]
static ALLOCATOR: Allocator = Allocator;

#[cold]
#[inline(never)]
fn from_reserve(layout: Layout) -> *mut u8 {
    let mut reserve = RESERVE.get();
    let at = reserve.take(layout);
    RESERVE.set(reserve);
    at
}

// SAFETY: blocks are the system's, or of the thread's reserve, which does not hand out bytes twice.
unsafe impl GlobalAlloc for Allocator {
    #[inline(never)] // There are hundreds of calls, and inlined they take 30 kB.
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let at = System.alloc(layout);
        if at.is_null() {
            from_reserve(layout)
        } else {
            at
        }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        let mut at = System.alloc_zeroed(layout);
        if at.is_null() {
            at = from_reserve(layout);
            if !at.is_null() {
                at.write_bytes(0, layout.size());
            }
        }
        at
    }

    #[inline(never)]
    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        let mut reserve = RESERVE.get();
        if reserve.has(at) {
            reserve.give_back(at, layout.size());
            RESERVE.set(reserve);
        } else {
            System.dealloc(at, layout);
        }
    }

    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let to = Layout::from_size_align_unchecked(size, layout.align());
        let moved = if RESERVE.get().has(at) {
            self.alloc(to)
        } else {
            let moved = System.realloc(at, layout, size);
            if !moved.is_null() {
                return moved;
            }
            from_reserve(to)
        };
        if !moved.is_null() {
            moved.copy_from_nonoverlapping(at, size.min(layout.size()));
            self.dealloc(at, layout);
        }
        moved
    }
}

#[cfg(all(test, feature = "memory-reserve"))]
mod tests {
    use super::*;

    /// What an allocation gets that the system refuses.
    fn block(size: usize, align: usize) -> (*mut u8, Layout) {
        let layout = Layout::from_size_align(size, align).expect("a layout");
        (from_reserve(layout), layout)
    }

    #[test]
    fn blocks_do_not_overlap_and_the_last_one_is_there_again() {
        assert!(block(8, 8).0.is_null(), "there is no reserve");
        let outer = Reserve::open().expect("memory");
        let start = RESERVE.get().start as usize;
        let blocks = [(3, 1), (40, 64), (8, 8), (SIZE - 112, 16)].map(|(size, align)| block(size, align));
        assert_eq!(blocks.map(|(at, _)| at as usize - start), [0, 64, 104, 112]);
        assert!(block(1, 1).0.is_null() && blocks.iter().all(|(at, _)| RESERVE.get().has(*at)));
        assert!(!RESERVE.get().has((start + SIZE) as *mut u8) && !RESERVE.get().has((start - 1) as *mut u8));
        // SAFETY: each is given back once.
        let drop = |(at, layout)| unsafe { Allocator.dealloc(at, layout) };
        drop(blocks[0]); // There are others behind it.
        assert_eq!((RESERVE.get().used, RESERVE.get().live), (SIZE, 3));
        drop(blocks[3]);
        assert_eq!((RESERVE.get().used, RESERVE.get().live), (112, 2));
        assert!(block(usize::MAX / 2, 1).0.is_null() && block(SIZE - 111, 1).0.is_null());
        assert_eq!(block(SIZE - 112, 1).0 as usize - start, 112);
        drop((blocks[3].0, Layout::from_size_align(SIZE - 112, 1).expect("a layout")));
        blocks[1..3].iter().copied().for_each(drop);
        assert_eq!(RESERVE.get().live, 0);
        Reserve::close(outer);
        assert!(block(8, 8).0.is_null(), "there is no reserve any more");
    }

    #[test]
    fn a_block_of_the_reserve_moves_with_its_bytes() {
        let made = held(|| {
            let (at, layout) = block(4, 1);
            // SAFETY: blocks of the size that they are given; the old one is no more in use.
            unsafe {
                at.copy_from_nonoverlapping([1, 2, 3, 4].as_ptr(), 4);
                let longer = Allocator.realloc(at, layout, 1000);
                assert!(!RESERVE.get().has(longer) && RESERVE.get().live == 0);
                let bytes = std::slice::from_raw_parts(longer, 4).to_vec();
                Allocator.dealloc(longer, Layout::from_size_align_unchecked(1000, 1));
                Ok(bytes)
            }
        });
        assert_eq!(made, Ok(vec![1, 2, 3, 4]));
    }

    /// What is made is dropped, and nothing of the reserve is in use then; also by a call within a call.
    #[test]
    fn what_stays_in_the_reserve_is_a_failure() {
        let keep = || {
            let (at, _) = block(8, 8);
            // SAFETY: a number of the size and alignment of its block.
            Ok(unsafe {
                at.cast::<u64>().write(7);
                Box::from_raw(at.cast::<u64>())
            })
        };
        assert_eq!(held(keep), Err(Failure::out_of_memory()));
        assert_eq!(held(|| Ok((held(keep), RESERVE.get().live))), Ok((Err(Failure::out_of_memory()), 0)));
        assert_eq!(held(|| Ok(7)), Ok(7));
        assert!(RESERVE.get().start.is_null());
    }
}
