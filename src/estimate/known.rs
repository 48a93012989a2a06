//! What is known of surfaces and interfaces of which little was measured, as data: the roughness of processes, and how far
//! defaults may be off.
//!
//! Ra by process has a source. For slopes of machined surfaces none was found that names its sampling length, so that these are
//! assumptions with a wide band (docs/when-to-use.md).

use crate::numerics::elementary::log;

/// 95 % of a normal distribution lie within so many standard deviations.
pub const REACH_95: f64 = 1.959_963_984_540_054;

/// Summits per area times their radius and standard deviation of height, of a surface without a nominal area (Greenwood and
/// Williamson, Proc. R. Soc. A 295, 1966).
pub const SUMMIT_PRODUCT: f64 = 0.05;

/// The standard deviation of a logarithm of which 95 % lie within a factor either way.
pub fn deviation(factor: f64) -> f64 {
    log(factor) / REACH_95
}

/// A way to machine metal, and the range of Ra [m] that it leaves.
#[derive(Debug, PartialEq)]
pub struct Process {
    pub name: &'static str,
    pub mean_deviation: [f64; 2],
}

macro_rules! processes {
    ($($name:literal: $least:literal to $most:literal;)*) => {
        &[$(Process { name: $name, mean_deviation: [$least, $most] }),*]
    };
}

/// CalQlata, Surface Finish (machining); Machinery's Handbook (25th edition, p. 708) has the same as a chart (quoted).
pub static PROCESSES: &[Process] = processes! {
    "superfinished": 0.05e-6 to 0.2e-6;
    "lapped": 0.05e-6 to 0.4e-6;
    "honed": 0.1e-6 to 0.8e-6;
    "ground": 0.1e-6 to 1.6e-6;
    "turned": 0.4e-6 to 6.3e-6;
    "bored": 0.4e-6 to 6.3e-6;
    "milled": 0.8e-6 to 6.3e-6;
};

impl Process {
    pub fn find(name: &str) -> Option<&'static Self> {
        PROCESSES.iter().find(|process| process.name == name)
    }

    /// Whether it cuts the hills off and leaves plateaus, so that the surface is not Gaussian.
    pub fn leaves_plateaus(&self) -> bool {
        ["honed", "superfinished"].contains(&self.name)
    }

    /// The middle of the range, and the factor from it to either end, within which 95 % are taken to be.
    pub fn middle_and_factor(&self) -> (f64, f64) {
        let [least, most] = self.mean_deviation;
        ((least * most).sqrt(), (most / least).sqrt())
    }
}

/// The root mean square slope along a profile of a machined surface whose profile has this Rq [m]: assumed, to `SLOPE_FACTOR`.
pub fn machined_slope(height: f64) -> f64 {
    0.14 * (height / 1e-6).sqrt()
}
