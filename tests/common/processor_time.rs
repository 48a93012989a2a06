//! Processor time: limits on it hold on a machine that is busy elsewhere too.

#![allow(unsafe_code)]

use std::time::Duration;

/// What a call must not take: ten times the second that is promised, so that a slow machine passes and a search without end
/// fails. The promise itself is measured by `make domain`.
pub const LONGEST_CALL: Duration = Duration::from_secs(10);

/// Used so far by this thread.
#[cfg(all(unix, not(miri)))]
pub fn processor_time() -> Duration {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: a struct to write to.
    assert_eq!(unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &mut time) }, 0);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}

/// Elsewhere the time on the clock.
#[cfg(any(not(unix), miri))]
pub fn processor_time() -> Duration {
    std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default()
}
