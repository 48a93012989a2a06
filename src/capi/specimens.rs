//! Single specimens, as C asks for them.

use super::boundary::{self, not_null, reference, write, wrong_struct_size, Failure};
use super::model::{self, asperity_model};
use super::status::asperity_status;
use crate::error::Error;
use crate::specimens::{Held, Specimens, Spread};
use std::mem::{align_of, size_of};

/// An element of a quantity of `asperity_specimens`: the mean over the specimens.
pub const ASPERITY_SPREAD_MEAN: i32 = 0;
/// The standard deviation from specimen to specimen.
pub const ASPERITY_SPREAD_DEVIATION: i32 = 1;
/// The 2.5 % quantile: one specimen in forty has less.
pub const ASPERITY_SPREAD_LOW: i32 = 2;
/// The median.
pub const ASPERITY_SPREAD_MEDIAN: i32 = 3;
/// The 97.5 % quantile.
pub const ASPERITY_SPREAD_HIGH: i32 = 4;

/// A quantity of `asperity_each_specimen_at_loads`: the friction force [force], >= 0; 0 where the specimen is apart.
pub const ASPERITY_SPECIMEN_FRICTION_FORCE: i32 = 0;
/// Tangential force by displacement while all contacts stick [force/length].
pub const ASPERITY_SPECIMEN_TANGENTIAL_STIFFNESS: i32 = 1;
/// Minus d(load)/d(gap) [force/length].
pub const ASPERITY_SPECIMEN_NORMAL_STIFFNESS: i32 = 2;
/// The gap between the mean planes [length]; NaN where the specimen is apart.
pub const ASPERITY_SPECIMEN_GAP: i32 = 3;
/// Number of summits in contact [-].
pub const ASPERITY_SPECIMEN_CONTACTS: i32 = 4;
/// The largest pull that the specimen withstands [force], >= 0; the same at each load.
pub const ASPERITY_SPECIMEN_PULL_OFF_FORCE: i32 = 5;
/// How many quantities there are.
pub const ASPERITY_SPECIMEN_LENGTH: i32 = 6;

/// Specimens of a surface pair under one load. Each quantity has five numbers: `found.gap[ASPERITY_SPREAD_MEDIAN]`.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_specimens {
    /// Set it to `sizeof(asperity_specimens)` in the first element before the call; the elements are this far apart.
    pub struct_size: u64,
    /// Normal load P [force].
    pub load: f64,
    /// Fraction of the specimens that are apart [-]: they do not withstand so much pull. Their friction, stiffness and contacts are 0.
    pub apart: f64,
    /// Friction force F [force].
    pub friction_force: [f64; 5],
    /// K_t [force/length]: tangential force by displacement while all contacts stick.
    pub tangential_stiffness: [f64; 5],
    /// Minus d(load)/d(gap) [force/length].
    pub normal_stiffness: [f64; 5],
    /// Gap between the mean planes of the surfaces [length], of the specimens that hold; NaN if none does.
    pub gap: [f64; 5],
    /// Number of summits in contact [-].
    pub contacts: [f64; 5],
    /// The largest pull that a specimen withstands [force], >= 0; the same at each load.
    pub pull_off_force: [f64; 5],
}

/// No more specimens may be asked for.
const MOST_SPECIMENS: u64 = 10_000_000;

/// Specimens under the loads of a caller.
///
/// # Safety
/// As that of every entry point.
unsafe fn held(
    model: *const asperity_model,
    first: u64,
    specimens: usize,
    seed: u64,
    n: usize,
    load: *const f64,
) -> Result<(Vec<f64>, Vec<Held>), Failure> {
    let model = model::of(model)?;
    if specimens as u64 > MOST_SPECIMENS {
        let allowed = "must be at most 1e7; 400 give the mean within some 1 %";
        return Err(Error::out_of_range("specimens", specimens as f64, allowed).into());
    }
    if n > 0 {
        not_null(load, "load")?;
    }
    let loads: Vec<f64> = (0..n).map(|i| load.add(i).read_unaligned()).collect();
    for (i, &load) in loads.iter().enumerate() {
        model.validate_specimens_load(load).map_err(|error| Failure::of_element(i, &error))?;
    }
    let found = model.specimens_at_loads(Specimens { first, count: specimens, seed }, &loads)?;
    Ok((loads, found))
}

/// Single specimens at loads: how friction, stiffness, gap and pull-off differ between nominally equal ones.
///
/// The model is a mean over many specimens. Where fewer than some 20 summits touch, one specimen differs from another and from the
/// model, and its pull-off force, which its tallest summits have, is larger by orders of magnitude. Here the heights of the summits
/// of each specimen are drawn at random, `asperity_count` of them. Each summit has the exact law of one summit. A specimen is
/// unloaded from the heaviest load: at each load it stands at the nearest gap at which its load has fallen to that one.
///
/// ```c
/// asperity_specimens found;
/// double load = 1e-6;
/// found.struct_size = sizeof found;
/// if (asperity_specimens_at_loads(model, 400, 1, 1, &load, &found) == ASPERITY_OK)
///     printf("%g N, of 95 %% of the specimens %g to %g N\n", found.friction_force[ASPERITY_SPREAD_MEAN],
///            found.friction_force[ASPERITY_SPREAD_LOW], found.friction_force[ASPERITY_SPREAD_HIGH]);
/// ```
///
/// @param specimens  how many; 400 give means within 1 %
/// @param seed       of the random numbers: the same specimens for the same seed, on any machine
/// @param load       normal loads [force], in any order, also 0 and, with adhesion, negative ones
/// @param found      receives n elements; unchanged on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`, no specimen),
///         `ASPERITY_INVALID_LOAD`, `ASPERITY_OUT_OF_RANGE` (a load that is too heavy, less than one summit, or more than 1e7
///         summits that would have to be drawn), `ASPERITY_NOT_CONVERGED`
#[no_mangle]
pub unsafe extern "C" fn asperity_specimens_at_loads(
    model: *const asperity_model,
    specimens: usize,
    seed: u64,
    n: usize,
    load: *const f64,
    found: *mut asperity_specimens,
) -> asperity_status {
    boundary::status(|| {
        let mut step = 0;
        if n > 0 {
            // SAFETY: struct_size is the first field, and the caller has set it.
            step = *reference(found.cast::<u64>(), "found")?;
            if step < 16 || step % align_of::<asperity_specimens>() as u64 != 0 || step > LARGEST {
                return Err(wrong_struct_size(step, "must be set to sizeof(asperity_specimens) in the first element"));
            }
        }
        if specimens == 0 {
            return Err(Failure::invalid(format_args!("specimens = 0: must be 1 or more")));
        }
        let (loads, held) = held(model, 0, specimens, seed, n, load)?;
        for (i, &load) in loads.iter().enumerate() {
            let of_load = || held.iter().skip(i).step_by(n);
            let five = |quantity: fn(&Held) -> f64| {
                let Spread { mean, deviation, low, median, high } = Spread::of(of_load().map(quantity));
                [mean, deviation, low, median, high]
            };
            let apart = of_load().filter(|one| one.gap.is_nan()).count();
            let one = asperity_specimens {
                struct_size: step,
                load,
                apart: apart as f64 / specimens as f64,
                friction_force: five(|one| one.friction_force),
                tangential_stiffness: five(|one| one.tangential_stiffness),
                normal_stiffness: five(|one| one.normal_stiffness),
                gap: five(|one| one.gap),
                contacts: five(|one| one.contacts),
                pull_off_force: five(|one| one.pull_off_force),
            };
            let count = size_of::<asperity_specimens>().min(step as usize);
            // SAFETY: the caller says that n elements are so far apart.
            let to = found.cast::<u8>().add(i * step as usize);
            std::ptr::copy_nonoverlapping((&raw const one).cast::<u8>(), to, count);
        }
        Ok(())
    })
}

/// No struct of a later version is larger [bytes].
const LARGEST: u64 = 4096;

/// The specimens of `asperity_specimens_at_loads` one by one, or a range of them: so that threads may share them.
///
/// ```c
/// double values[400][ASPERITY_SPECIMEN_LENGTH], load = 1e-6;
/// asperity_each_specimen_at_loads(model, 0, 400, 1, 1, &load, &values[0][0]);
/// printf("the friction force of the first: %g N\n", values[0][ASPERITY_SPECIMEN_FRICTION_FORCE]);
/// ```
///
/// @param first      the first specimen, from 0; those before it count among the summits that may be drawn
/// @param specimens  how many
/// @param seed,load  as of `asperity_specimens_at_loads`
/// @param values     receives `specimens` times n times `ASPERITY_SPECIMEN_LENGTH` numbers: of each specimen, of each load, the
///                   quantities
/// @return as `asperity_specimens_at_loads`
#[no_mangle]
pub unsafe extern "C" fn asperity_each_specimen_at_loads(
    model: *const asperity_model,
    first: u64,
    specimens: usize,
    seed: u64,
    n: usize,
    load: *const f64,
    values: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let (_, held) = held(model, first, specimens, seed, n, load)?;
        for (i, one) in held.iter().enumerate() {
            let quantities = [
                one.friction_force,
                one.tangential_stiffness,
                one.normal_stiffness,
                one.gap,
                one.contacts,
                one.pull_off_force,
            ];
            for (k, value) in quantities.into_iter().enumerate() {
                write(values, i * quantities.len() + k, value);
            }
        }
        Ok(())
    })
}
