//! Random numbers for tests: splitmix64 (Steele, Lea and Flood 2014), the same on every machine for a seed.

/// The generator; its state is the seed.
pub struct SplitMix(pub u64);

impl SplitMix {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * ((self.bits() >> 11) as f64 * f64::EPSILON / 2.0)
    }

    /// Uniform in the logarithm.
    pub fn log_between(&mut self, from: f64, to: f64) -> f64 {
        self.between(from.ln(), to.ln()).exp().clamp(from, to)
    }

    /// A whole number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    /// True with a probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }

    /// A float of random bits: half of them of any exponent, half from the few that code goes wrong with.
    pub fn any_float(&mut self) -> f64 {
        const SPECIAL: [u64; 16] = [
            0,                     // 0
            1 << 63,               // -0
            1,                     // the smallest denormal
            (1 << 63) | 1,         //
            0x000f_ffff_ffff_ffff, // the largest denormal
            0x0010_0000_0000_0000, // the smallest normal
            0x7fef_ffff_ffff_ffff, // the largest
            0xffef_ffff_ffff_ffff, //
            0x7ff0_0000_0000_0000, // infinity
            0xfff0_0000_0000_0000, //
            0x7ff8_0000_0000_0000, // quiet NaN
            0x7ff0_0000_0000_0001, // signalling NaN
            0xfff0_0000_dead_beef, //
            0x3ff0_0000_0000_0000, // 1
            0xbff0_0000_0000_0000, //
            0x7ff7_ffff_ffff_ffff, // signalling NaN
        ];
        if self.chance(0.5) {
            f64::from_bits(self.bits())
        } else {
            f64::from_bits(SPECIAL[self.below(SPECIAL.len())])
        }
    }
}
