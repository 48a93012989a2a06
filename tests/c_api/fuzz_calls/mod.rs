//! Bytes to calls of the C interface, and what must hold of every answer: shared by `tests/c_api/fuzz.rs` and the libFuzzer
//! target in `fuzz/`.
//!
//! The bytes choose parameters, then calls and their arguments until they run out: raw bit patterns beside mostly valid
//! surfaces, so that deep states are reached. A parameter or family that is added goes into `Bytes::params`.

#![allow(unsafe_code)]

pub mod calls;
pub mod table;

use crate::common::neighbours::Neighbours;
use crate::interface::*;
pub use calls::{Calls, Tally};
use std::mem::offset_of;

/// The word of the parameters at which the table's pointers begin, which are trusted: they lead to `TABLES` or nowhere.
pub const TABLE_AT: usize = offset_of!(asperity_params, table_height) / 8;
const TABLE_LENGTH: usize = 9;
/// Heights, and densities at them: some that are valid, some that are not.
static TABLES: [[f64; TABLE_LENGTH]; 8] = [
    [-2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0],
    [1e-9, 2e-9, 3e-9, 4e-9, 6e-9, 8e-9, 9e-9, 1e-8, 1.1e-8],
    [0.0, 0.25, 0.5, 0.75, 1.0, 0.75, 0.5, 0.25, 0.0],
    [0.1, 1.0, 3.0, 1.0, 0.1, 0.2, 0.6, 0.3, 0.0],
    [1e-3, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 1e-3],
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
    [0.0, 1.0, f64::NAN, 1.0, -1.0, 1.0, f64::INFINITY, 1e300, 5e-324],
    [0.0; TABLE_LENGTH],
];

/// What the bytes say; zeros when they have run out.
pub struct Bytes<'a>(pub &'a [u8]);

impl Bytes<'_> {
    fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    fn word(&mut self) -> u64 {
        u64::from_le_bytes(std::array::from_fn(|_| self.byte()))
    }

    fn below(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    /// In [0, 1), on a grid of 2^-16: short inputs reach far.
    fn part(&mut self) -> f64 {
        f64::from(u16::from_le_bytes([self.byte(), self.byte()])) / 65536.0
    }

    fn log_between(&mut self, from: f64, to: f64) -> f64 {
        (from.ln() + self.part() * (to / from).ln()).exp().clamp(from, to)
    }

    /// Any bits, or one of the numbers that code goes wrong with.
    fn any_float(&mut self) -> f64 {
        const SPECIAL: [u64; 12] = [
            0,
            1 << 63,
            1,
            0x800f_ffff_ffff_ffff, // the largest denormal, negative
            0x0010_0000_0000_0000, // the smallest normal
            0x7fef_ffff_ffff_ffff, // the largest
            0xffef_ffff_ffff_ffff,
            0x7ff0_0000_0000_0000, // infinity
            0xfff0_0000_0000_0000,
            0x7ff8_0000_0000_0000, // quiet NaN
            0x7ff0_0000_0000_0001, // signalling NaN
            0xbff0_0000_0000_0000, // -1
        ];
        match self.below(32) {
            which if which < SPECIAL.len() => f64::from_bits(SPECIAL[which]),
            _ => f64::from_bits(self.word()),
        }
    }

    /// Parameters: of a surface that may well be evaluated, with one number of raw bits, or all of raw bits.
    fn params(&mut self) -> asperity_params {
        match self.below(16) {
            0 => self.raw_params(),
            1 => {
                let mut params = self.surface();
                let at = 1 + self.below(TABLE_AT - 1);
                set_word(&mut params, at, self.any_float().to_bits());
                params
            }
            2 => {
                let mut params = self.surface();
                set_word(&mut params, 0, self.word() >> self.below(64)); // struct_size
                params
            }
            _ => self.surface(),
        }
    }

    fn raw_params(&mut self) -> asperity_params {
        let mut params = asperity_params::initial();
        for at in 1..TABLE_AT {
            set_word(&mut params, at, self.any_float().to_bits());
        }
        params = self.tabulated(params);
        params.height_distribution = i32::from(self.byte() as i8) >> 5;
        params.attraction = i32::from(self.byte() as i8) >> 6;
        (params.waviness_height, params.waviness_width) = (self.any_float(), self.any_float());
        params.waviness_shape = i32::from(self.byte() as i8) >> 5;
        params.taken_as_gaussian = params.waviness_shape >> 1;
        params
    }

    /// A surface in any system of units, within what the library evaluates.
    fn surface(&mut self) -> asperity_params {
        let gamma = if self.below(8) == 0 { 0.0 } else { self.log_between(1e-7, 1.0) };
        let (alpha, beta) = (self.log_between(1e-4, 1.0), self.log_between(1.0, 1e7));
        let b_over_h = self.log_between(0.05, 20.0);
        let mut params = asperity_params::dimensionless(alpha, beta, gamma, b_over_h);
        let (length, force) = (self.log_between(1e-10, 1e3), self.log_between(1e-6, 1e6));
        let stress = force / (length * length);
        let count = self.log_between(1e-3, 1e15);
        let units = [stress, stress, force / length, length, length, length, length, count];
        for (quantity, unit) in params.quantities().into_iter().zip(units) {
            *quantity *= unit;
        }
        params = match self.below(16) {
            0..=5 => params,
            6..=10 => params.weibull(self.log_between(1.0, 200.0)),
            11 => params.weibull(self.log_between(100.0, 400.0)),
            12..=13 => {
                let skew = 4.0 * self.part() - 2.0;
                params.johnson(skew, 1.25 * skew * skew + 1.8 + self.log_between(0.01, 20.0))
            }
            _ => self.tabulated(params),
        };
        if self.below(16) == 0 {
            let amplitude = [-1.0, 1.0, 2.0 * self.part() - 1.0][self.below(3)];
            params = params.radii(amplitude, self.log_between(1e-3, 100.0));
        }
        params.attraction = i32::from(self.below(8) != 0);
        params.slip_onset = i32::from(self.below(8) == 0);
        if gamma == 0.0 && self.below(2) == 0 {
            let spacing = params.height_std * self.log_between(3.0, 300.0);
            params.nominal_area = params.asperity_count * spacing * spacing;
            params.waviness_height = params.height_std * self.log_between(0.01, 40.0);
            params.waviness_width = params.nominal_area.sqrt() * self.log_between(0.01, 2.0);
            params.waviness_shape = self.below(3) as i32;
        }
        match self.below(16) {
            0 => params.cap(f64::INFINITY),
            1 => params.cap(self.log_between(1e-6, 1e6)),
            _ => params,
        }
    }

    /// With a table of heights, of which not all are valid.
    fn tabulated(&mut self, mut params: asperity_params) -> asperity_params {
        params = params.table(&TABLES[self.below(2)], &TABLES[self.below(TABLES.len())]);
        params.table_length = if self.below(4) == 0 { self.below(TABLE_LENGTH + 1) } else { TABLE_LENGTH } as u64;
        if self.below(16) == 0 {
            *[&mut params.table_height, &mut params.table_density][self.below(2)] = std::ptr::null();
            params.table_length = self.word();
        }
        params
    }

    /// A text that may describe a surface: parts of one that does, and any bytes.
    fn text(&mut self) -> Vec<u8> {
        const PARTS: [&str; 24] = [
            "\n",
            " = ",
            "[",
            "]",
            "\"",
            "{",
            "}",
            ", ",
            "1e-6\n",
            "\u{feff}",
            "nominal_area = 1e-6\n",
            "hardness = 1e9\n",
            "skew = 0.1\n",
            "kurtosis = 3.5\n",
            "heights = \"weibull\"\n",
            "attraction = false\n",
            "table_height = [0, 1, 2]\n",
            "table_density = [0.5, 1, 0]\n",
            "pair = \"Si/Si\"\n",
            "interface = \"MoS2 film in dry air\"\n",
            "calibration_load = 1e-3\ncalibration_friction_coefficient = 0.1\n",
            "[materials]\nE1 = 1e11\nnu1 = 0.3\nE2 = inf\nnu2 = 0\n",
            "[roughness]\nRa = 1e-8\nRSm = 1e-6\n",
            "[roughness]\nSq = [1e-8, 2e-8]\nSdq = [0.1, 0.1]\nSsc = [1e6, 1e6]\n",
        ];
        let mut text = Vec::new();
        for _ in 0..self.below(24) {
            match self.byte() {
                0 => text.push(self.byte()),
                part => text.extend(PARTS[usize::from(part) % PARTS.len()].bytes()),
            }
        }
        text
    }

    /// A load: on the branch, near its ends, or of any bits.
    fn load(&mut self, summary: &asperity_summary) -> f64 {
        let pull_off = summary.pull_off_load;
        let (nearest, farthest) = (summary.min_table_load - pull_off, summary.max_table_load - pull_off);
        match self.below(16) {
            0 => self.any_float(),
            1 => -self.part() * -pull_off,
            2 => pull_off + self.log_between(nearest * 1e-9, nearest),
            3 => match self.below(4) {
                0 => f64::MAX,
                1 => self.log_between(farthest, f64::MAX),
                _ => farthest * self.log_between(1.0, 1e12),
            },
            4 => [
                pull_off,
                pull_off.above(),
                pull_off.below(),
                0.0,
                -0.0,
                summary.min_table_load,
                summary.min_table_load.below(),
                summary.max_table_load,
                summary.max_table_load.above(),
            ][self.below(9)],
            _ => pull_off + self.log_between(nearest, farthest),
        }
    }

    /// A separation, `sigma` being the standard deviation of heights.
    fn separation(&mut self, sigma: f64) -> f64 {
        match self.below(8) {
            0 => self.any_float(),
            1 => -sigma * self.log_between(1.0, 1e12),
            2 => sigma * self.log_between(1.0, 1e12),
            _ => sigma * (16.0 * self.part() - 8.0),
        }
    }
}

/// Writes a word of a struct that consists of words.
fn set_word(params: &mut asperity_params, at: usize, word: u64) {
    assert!(at < size_of::<asperity_params>() / 8);
    // SAFETY: within the struct, all bits of which are values.
    unsafe { std::ptr::from_mut(params).cast::<u64>().add(at).write(word) }
}

/// Does what the bytes say. Panics where an answer is not as promised.
pub fn run(bytes: &[u8], tally: &mut Tally) {
    let mut bytes = Bytes(bytes);
    let mut calls = Calls::new(tally);
    while !bytes.0.is_empty() {
        let params = bytes.params();
        let Some(model) = calls.create(&params) else { continue };
        // So many steps on one model, as far as the bytes go: making it costs as much as thousands of calls.
        for _ in 0..1 + 8 * bytes.below(256) {
            if bytes.0.is_empty() {
                break;
            }
            step(&mut bytes, &mut calls, &model);
        }
    }
}

fn step(bytes: &mut Bytes, calls: &mut Calls, model: &calls::Model) {
    let summary = &model.summary;
    match bytes.byte() {
        0..=99 => calls.at_load(model, bytes.load(summary)),
        100..=144 => {
            let loads: Vec<f64> = (0..bytes.below(40)).map(|_| bytes.load(summary)).collect();
            calls.batches(model, &loads, bytes.below(8));
        }
        145..=159 => calls.exact(model, bytes.load(summary)),
        160..=169 => {
            let length = model.params.height_std * bytes.log_between(1e-9, 1e3);
            let steps: Vec<(f64, [f64; 2])> = (0..1 + bytes.below(12))
                .map(|_| {
                    let by = match bytes.below(16) {
                        0 => [bytes.any_float(), bytes.any_float()],
                        _ => [0, 1].map(|_| (2.0 * bytes.part() - 1.0) * length),
                    };
                    (bytes.load(summary), by)
                })
                .collect();
            calls.path(model, &steps);
        }
        170..=174 => calls.separation(model, bytes.separation(model.params.height_std)),
        175..=177 => calls.at_gap(model, bytes.separation(model.params.height_std)),
        178..=179 => calls.at_gap(model, bytes.any_float()),
        180..=199 => calls.secant(model, bytes.part()),
        200..=219 => calls.order(model, bytes.load(summary), bytes.load(summary)),
        220..=242 => calls.any(model, bytes.word() >> bytes.below(64)),
        243..=244 => {
            let text = std::array::from_fn(|_| bytes.byte());
            calls.names(text, std::array::from_fn(|_| bytes.below(24)), std::array::from_fn(|_| bytes.any_float()));
        }
        // As many bytes as these once took: inputs that once failed stay what they are.
        kind @ 245..=252 => {
            match kind {
                245..=249 => (0..5).for_each(|_| {
                    let _ = if bytes.below(3) == 0 { bytes.any_float() } else { bytes.part() };
                }),
                kind => bytes.0 = bytes.0.get(if kind == 250 { 67 } else { 1 }..).unwrap_or_default(),
            }
            calls.any(model, bytes.0.len() as u64 ^ summary.pull_off_load.to_bits());
        }
        253 => {
            let text = bytes.text();
            calls.text(&text, bytes.any_float(), bytes.log_between(1e-12, 1e12));
        }
        254 => calls.check_loads(model, bytes.load(summary), bytes.load(summary)),
        255 => {
            let other = bytes.params();
            calls.set_params(model, &other);
        }
    }
}
