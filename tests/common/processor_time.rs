//! The processor time of this thread: limits on time hold on a machine that is busy elsewhere too.

#![allow(unsafe_code)]

use std::time::Duration;

/// Used so far.
#[cfg(all(target_os = "linux", not(miri)))]
pub fn processor_time() -> Duration {
    const CLOCK_THREAD_CPUTIME_ID: i32 = 3;
    extern "C" {
        fn clock_gettime(clock: i32, time: *mut [i64; 2]) -> i32;
    }
    let mut time = [0; 2];
    // SAFETY: struct timespec of 64-bit Linux.
    assert_eq!(unsafe { clock_gettime(CLOCK_THREAD_CPUTIME_ID, &mut time) }, 0);
    Duration::new(time[0] as u64, time[1] as u32)
}

/// Elsewhere the time on the clock.
#[cfg(any(not(target_os = "linux"), miri))]
pub fn processor_time() -> Duration {
    std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default()
}
