//! Contacts of several pairs of surfaces in one call. With slopes they are sorted by model, a block at a time, so that each model
//! answers its own as a batch; forces alone cost less than sorting.

use super::batch::{self, Arrays, Asked};
use super::boundary::{self, not_null, write, Failure};
use super::model::{self, asperity_model};
use super::status::asperity_status;
use crate::model::Model;

/// Contacts that are sorted at a time, and the most models by which they are: of more, each has few contacts in a block, and all are
/// asked alone.
const PAIR_BLOCK: usize = 1024;
const MOST_MODELS: usize = 64;

/// Friction forces of contacts that belong to several pairs of surfaces, and their slopes, in one call.
///
/// `which[i]` says which of the models answers `load[i]`.
///
/// @param models         models_length models, none of them NULL
/// @param models_length  number of models
/// @param which          n indices of models, from 0
/// @param load           n loads [force]
/// @param force          receives n forces [force], NaN where `which` is not below `models_length`
/// @param dforce_dload   receives n slopes dF/d(load), as `asperity_friction_force_at_loads` has them
/// @return as `asperity_friction_at_loads`, and `ASPERITY_INVALID_PARAMETER` (`which` is not below `models_length`)
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_at_loads_of(
    models: *const *const asperity_model,
    models_length: usize,
    n: usize,
    which: *const u32,
    load: *const f64,
    force: *mut f64,
    dforce_dload: *mut f64,
) -> asperity_status {
    boundary::contained_status(|| {
        if models_length > 0 {
            not_null(models, "models")?;
        }
        if n > 0 {
            not_null(which, "which")?;
            not_null(load, "load")?;
        }
        let models = Models { first: models, count: models_length };
        models.check()?;
        let mut first_invalid: Option<Invalid> = None;
        for begin in (0..n).step_by(PAIR_BLOCK) {
            let contacts =
                Contacts { begin, count: PAIR_BLOCK.min(n - begin), which, load, force, slope: dforce_dload };
            let invalid = match models_length <= MOST_MODELS && !dforce_dload.is_null() {
                true => sorted(&models, &contacts),
                false => one_by_one(&models, &contacts),
            };
            first_invalid = first_invalid.or(invalid);
        }
        first_invalid.map_or(Ok(()), |invalid| Err(invalid.failure(&models)))
    })
}

/// The caller's models.
struct Models {
    first: *const *const asperity_model,
    count: usize,
}

impl Models {
    /// Refuses a model that is NULL.
    unsafe fn check(&self) -> Result<(), Failure> {
        match (0..self.count).find(|&index| self.first.add(index).read_unaligned().is_null()) {
            Some(index) => Err(Failure::null_element("models", index)),
            None => Ok(()),
        }
    }

    unsafe fn get(&self, index: usize) -> &Model {
        &(*self.first.add(index).read_unaligned()).model
    }
}

/// A block of the caller's contacts.
struct Contacts {
    begin: usize,
    count: usize,
    which: *const u32,
    load: *const f64,
    force: *mut f64,
    slope: *mut f64,
}

impl Contacts {
    unsafe fn which(&self, i: usize) -> usize {
        self.which.add(self.begin + i).read_unaligned() as usize
    }

    unsafe fn load(&self, i: usize) -> f64 {
        self.load.add(self.begin + i).read_unaligned()
    }

    unsafe fn write(&self, i: usize, force: f64, slope: f64) {
        write(self.force, self.begin + i, force);
        write(self.slope, self.begin + i, slope);
    }
}

/// A contact that has no answer.
#[derive(Clone, Copy)]
struct Invalid {
    index: usize,
    which: usize,
    load: f64,
}

impl Invalid {
    unsafe fn failure(&self, models: &Models) -> Failure {
        match self.which < models.count {
            true => Asked::Force.failure(models.get(self.which), self.index, self.load),
            false => Failure::invalid(format_args!(
                "element {}: which = {}: must be below models_length = {}",
                self.index, self.which, models.count
            )),
        }
    }
}

/// The first of two.
fn first(a: Option<Invalid>, b: Invalid) -> Option<Invalid> {
    a.filter(|a| a.index <= b.index).or(Some(b))
}

/// Sorts the contacts of a block by model; each model answers its own, with slopes.
unsafe fn sorted(models: &Models, contacts: &Contacts) -> Option<Invalid> {
    // One place more: those of no model.
    let mut ends = [0_usize; MOST_MODELS + 1];
    let place = |i: usize| contacts.which(i).min(models.count);
    for i in 0..contacts.count {
        ends[place(i)] += 1;
    }
    let mut begin = 0;
    for end in &mut ends[..=models.count] {
        // Where the next contact of the model goes; in the end where the next model's begin.
        (begin, *end) = (begin + *end, begin);
    }
    let (mut load, mut order) = ([0.0; PAIR_BLOCK], [0_u16; PAIR_BLOCK]);
    for i in 0..contacts.count {
        let next = &mut ends[place(i)];
        load[*next] = contacts.load(i);
        order[*next] = i as u16;
        *next += 1;
    }
    let mut invalid = None;
    let (mut force, mut slope) = ([0.0; PAIR_BLOCK], [0.0; PAIR_BLOCK]);
    let mut begin = 0;
    for (which, &end) in ends[..models.count].iter().enumerate() {
        let arrays = Arrays {
            n: end - begin,
            load: load[begin..end].as_ptr(),
            value: force[begin..end].as_mut_ptr(),
            slope: slope[begin..end].as_mut_ptr(),
        };
        if let Some((at, load)) = batch::fill(models.get(which), Asked::Force, arrays) {
            let index = contacts.begin + usize::from(order[begin + at]);
            invalid = first(invalid, Invalid { index, which, load });
        }
        begin = end;
    }
    for at in begin..contacts.count {
        (force[at], slope[at]) = (f64::NAN, f64::NAN);
    }
    if begin < contacts.count {
        let i = usize::from(order[begin]);
        let (which, load) = (contacts.which(i), load[begin]);
        invalid = first(invalid, Invalid { index: contacts.begin + i, which, load });
    }
    for (at, &i) in order[..contacts.count].iter().enumerate() {
        contacts.write(usize::from(i), force[at], slope[at]);
    }
    invalid
}

/// Asks for each contact alone.
unsafe fn one_by_one(models: &Models, contacts: &Contacts) -> Option<Invalid> {
    // What may be overwritten.
    let mut loads = [0.0; PAIR_BLOCK];
    let mut suspects = 0_u64;
    for (i, kept) in loads[..contacts.count].iter_mut().enumerate() {
        let (which, load) = (contacts.which(i), contacts.load(i));
        *kept = load;
        let mut force = f64::NAN;
        if which < models.count {
            let handle = models.first.add(which).read_unaligned();
            force = match contacts.slope.is_null() {
                true => model::value_at(handle, Asked::Force, load),
                false => {
                    let (force, slope) = Asked::Force.at(models.get(which), load);
                    write(contacts.slope, contacts.begin + i, slope);
                    force
                }
            };
        } else {
            write(contacts.slope, contacts.begin + i, f64::NAN);
        }
        write(contacts.force, contacts.begin + i, force);
        // All others are in order: 0 and NaN are below and above them. By bits: comparing a NaN may raise a flag.
        suspects |= u64::from(force.to_bits().wrapping_sub(1) >= f64::INFINITY.to_bits() - 1);
    }
    if suspects == 0 {
        return None;
    }
    let is_invalid = |i: &usize| {
        let which = contacts.which(*i);
        which >= models.count || Asked::Force.is_invalid(models.get(which), loads[*i])
    };
    let i = (0..contacts.count).find(is_invalid)?;
    Some(Invalid { index: contacts.begin + i, which: contacts.which(i), load: loads[i] })
}
