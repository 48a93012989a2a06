//! A second static library of Rust in a program. It panics, and catches that.

/// The sum of 0 to n - 1, after a panic.
#[no_mangle]
pub extern "C" fn second_sum(n: u64) -> u64 {
    std::panic::set_hook(Box::new(|_| {})); // says nothing of it
    let numbers: Vec<u64> = (0..n).collect();
    let beyond = std::panic::catch_unwind(|| numbers[numbers.len()]);
    beyond.unwrap_or_else(|_| numbers.iter().sum())
}
