//! Single specimens, as C asks for them.

use super::boundary::{self, not_null, reference, write, wrong_struct_size, Failure};
use super::model::{self, asperity_model};
use super::status::asperity_status;
use crate::specimens::{spread, Held, Specimens};
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
    /// K_t [force/length] while all contacts stick.
    pub tangential_stiffness: [f64; 5],
    /// Minus d(load)/d(gap) [force/length].
    pub normal_stiffness: [f64; 5],
    /// Gap between the mean planes of the surfaces [length], of the specimens that hold; NaN if none does.
    pub gap: [f64; 5],
    /// Number of asperities in contact [-].
    pub contacts: [f64; 5],
    /// The largest pull that a specimen withstands [force], >= 0; the same at each load.
    pub pull_off_force: [f64; 5],
}

/// Specimens under the loads of a caller.
///
/// # Safety
/// As that of every entry point.
unsafe fn held(
    model: *const asperity_model,
    asked: Specimens,
    n: usize,
    load: *const f64,
) -> Result<(Vec<f64>, Vec<Held>), Failure> {
    let model = model::of(model)?;
    if n > 0 {
        not_null(load, "load")?;
    }
    let loads: Vec<f64> = (0..n).map(|i| load.add(i).read_unaligned()).collect();
    for (i, &load) in loads.iter().enumerate() {
        model.validate_specimens_load(load).map_err(|error| Failure::of_element(i, &error))?;
    }
    let found = model.specimens_at_loads(asked, &loads)?;
    Ok((loads, found))
}

/// Single specimens at loads: how friction, stiffness, gap and pull-off differ between nominally equal ones.
///
/// The model is a mean over many specimens. Where fewer than some 20 asperities touch, one specimen differs from another and from the
/// model, and its pull-off force, which its tallest asperities have, is larger by orders of magnitude. Here the heights of the
/// asperities of each specimen are drawn at random, `asperity_count` of them. Each asperity has the exact law of one asperity. A
/// specimen is unloaded from the heaviest load: at each load it stands at the nearest gap at which its load has fallen to that one.
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
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`, no specimen), `ASPERITY_INVALID_LOAD`,
///         `ASPERITY_OUT_OF_RANGE` (a load that is too heavy, less than one asperity, or more than 1e7 asperities that would have to be
///         drawn), `ASPERITY_NOT_CONVERGED`
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
        let (loads, held) = held(model, Specimens { count: specimens, seed, ..Specimens::default() }, n, load)?;
        for (i, &load) in loads.iter().enumerate() {
            let of_load = || held.iter().skip(i).step_by(n);
            let five = |quantity: fn(&Held) -> f64| spread(of_load().map(quantity));
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

/// The specimens of `asperity_specimens_at_loads` one by one, or a range of them, so that threads may share them; also rough spheres.
///
/// A rough sphere (a bead, a ball) has `asperity_count` asperities on each `nominal_area`, which stand on its curved surface. It bears
/// on those about its lowest point, and its pull-off force is theirs. The sphere itself does not flatten: loads are refused from which
/// it does, where the radius of Hertz' contact of the smooth sphere exceeds (R sigma)^(1/2), and so are spheres on which fewer than 3
/// asperities stand within sigma of the lowest point.
///
/// @param sphere_radius  R [length]; 0: the surface is flat
/// @param first          the first specimen, from 0; those before it count among the asperities that may be drawn
/// @param specimens      how many
/// @param seed,load      as of `asperity_specimens_at_loads`
/// @param friction_force        receives F [force] of each specimen at each load, loads of one specimen next to each other; 0 if it is
///                              apart
/// @param tangential_stiffness  receives K_t [force/length] likewise
/// @param normal_stiffness      receives minus d(load)/d(gap) [force/length] likewise
/// @param gap                   receives the gaps [length] likewise; NaN if it is apart
/// @param contacts              receives numbers of asperities in contact [-] likewise
/// @param pull_off_force        receives the largest pull that the specimen withstands [force], >= 0, the same at each load
/// @return as `asperity_specimens_at_loads`
#[no_mangle]
#[allow(clippy::too_many_arguments)] // As many as there are quantities.
pub unsafe extern "C" fn asperity_each_specimen_at_loads(
    model: *const asperity_model,
    sphere_radius: f64,
    first: u64,
    specimens: usize,
    seed: u64,
    n: usize,
    load: *const f64,
    friction_force: *mut f64,
    tangential_stiffness: *mut f64,
    normal_stiffness: *mut f64,
    gap: *mut f64,
    contacts: *mut f64,
    pull_off_force: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let asked = Specimens { sphere_radius, first, count: specimens, seed };
        let (_, held) = held(model, asked, n, load)?;
        for (i, one) in held.iter().enumerate() {
            write(friction_force, i, one.friction_force);
            write(tangential_stiffness, i, one.tangential_stiffness);
            write(normal_stiffness, i, one.normal_stiffness);
            write(gap, i, one.gap);
            write(contacts, i, one.contacts);
            write(pull_off_force, i, one.pull_off_force);
        }
        Ok(())
    })
}
