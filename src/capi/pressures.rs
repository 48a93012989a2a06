//! Many contacts by pressure, or with a smooth sign of the slip rate: the calls of `slope`, a block at a time. All of it runs in the
//! library's floating-point environment: what vectors evaluate ahead of a condition would raise exceptions.

use super::batch::{self, Arrays, Quantity};
use super::boundary::{self, not_null, write, Failure};
use super::model::{self, asperity_model};
use super::slope::{by_pressure, is_allowed, load_of, slipping, stress, ALLOWED};
use super::status::asperity_status;
use crate::error::Error;
use crate::float_bits::finite;
use crate::model::Model;
use crate::regularised::smooth_sign;

/// Contacts that are answered at a time.
const BLOCK: usize = 128;

/// Friction coefficients at many contact pressures, and their slopes.
///
/// @param model          a model
/// @param n              number of pressures
/// @param pressure       n nominal contact pressures [stress], positive in compression
/// @param nominal_area   the area that carries `asperity_count` summits [length^2], from 1e-60 to 1e60; the same for
///                       all
/// @param mu             receives n coefficients
/// @param dmu_dpressure  receives n slopes d(mu)/d(pressure) [1/stress]
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`nominal_area`; all elements are
///         NaN), `ASPERITY_INVALID_LOAD` (a pressure that is NaN or infinite), `ASPERITY_SEPARATED`,
///         `ASPERITY_OUT_OF_RANGE` (a finite pressure that cannot be evaluated, where the answer is NaN)
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_at_pressures(
    model: *const asperity_model,
    n: usize,
    pressure: *const f64,
    nominal_area: f64,
    mu: *mut f64,
    dmu_dpressure: *mut f64,
) -> asperity_status {
    at_pressures(model, Quantity::Coefficient, n, (pressure, nominal_area), mu, dmu_dpressure)
}

/// Frictional shear stresses at many contact pressures, and their slopes.
///
/// @param model              a model
/// @param n                  number of pressures
/// @param pressure           n nominal contact pressures [stress], positive in compression
/// @param nominal_area       as for `asperity_friction_at_pressures`
/// @param stress             receives n stresses: friction force over `nominal_area` [stress]
/// @param dstress_dpressure  receives n slopes d(stress)/d(pressure)
/// @return as `asperity_friction_at_pressures`
#[no_mangle]
pub unsafe extern "C" fn asperity_shear_stresses_at_pressures(
    model: *const asperity_model,
    n: usize,
    pressure: *const f64,
    nominal_area: f64,
    stress: *mut f64,
    dstress_dpressure: *mut f64,
) -> asperity_status {
    at_pressures(model, Quantity::Force, n, (pressure, nominal_area), stress, dstress_dpressure)
}

unsafe fn at_pressures(
    model: *const asperity_model,
    quantity: Quantity,
    n: usize,
    (pressure, area): (*const f64, f64),
    value: *mut f64,
    slope: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        if n > 0 {
            not_null(pressure, "pressure")?;
        }
        let mut first_invalid = None;
        for begin in (0..n).step_by(BLOCK) {
            let count = BLOCK.min(n - begin);
            let mut pressures = [0.0; BLOCK];
            for (i, pressures) in pressures[..count].iter_mut().enumerate() {
                *pressures = pressure.add(begin + i).read_unaligned();
            }
            let loads = pressures.map(|pressure| load_of(pressure, area));
            let (mut values, mut slopes) = ([0.0; BLOCK], [0.0; BLOCK]);
            let found = batch::fill(model, quantity, arrays(count, &loads, &mut values, &mut slopes));
            first_invalid = first_invalid.or(found.map(|(i, load)| (begin + i, pressures[i], load)));
            for i in 0..count {
                let (of_one, slope_of_one) = match quantity {
                    Quantity::Coefficient => (values[i], by_pressure(slopes[i], area)),
                    _ => (stress(values[i], area), slopes[i]),
                };
                write(value, begin + i, of_one);
                write(slope, begin + i, slope_of_one);
            }
        }
        first_invalid.map_or(Ok(()), |(index, pressure, load)| Err(refused(model, index, pressure, area, load)))
    })
}

fn arrays(count: usize, load: &[f64; BLOCK], value: &mut [f64; BLOCK], slope: &mut [f64; BLOCK]) -> Arrays {
    Arrays { n: count, load: load.as_ptr(), value: value.as_mut_ptr(), slope: slope.as_mut_ptr() }
}

/// What is wrong with a pressure or the area.
fn refused(model: &Model, index: usize, pressure: f64, area: f64, load: f64) -> Failure {
    if !is_allowed(area) {
        return Error::invalid("nominal_area", area, ALLOWED).into();
    }
    let error = if !finite(pressure) {
        Error::InvalidLoad { name: "pressure", value: pressure }
    } else if !finite(load) {
        Error::out_of_range("pressure", pressure, "must be within 1e120 of zero")
    } else {
        return Quantity::Force.failure(model, index, load);
    };
    Failure::of_element(index, &error)
}

/// Friction forces of many sliding contacts, with a smooth sign of the slip rates, and their two slopes.
///
/// @param model              a model
/// @param n                  number of contacts
/// @param load               n normal loads [force]
/// @param slip_rate          n tangential velocities [length/time], signed
/// @param transition_rate    slip rate at which the force reaches 76 % of the law's, from 1e-60 to 1e60; the same for
///                           all
/// @param force              receives n forces [force]
/// @param dforce_dload       receives n derivatives by load
/// @param dforce_dslip_rate  receives n derivatives by slip rate [force time/length]
/// @return as `asperity_friction_at_loads`, and `ASPERITY_INVALID_PARAMETER` (a slip rate that is NaN or infinite, or
///         `transition_rate`; all elements are then NaN)
#[no_mangle]
pub unsafe extern "C" fn asperity_slip_forces(
    model: *const asperity_model,
    n: usize,
    load: *const f64,
    slip_rate: *const f64,
    transition_rate: f64,
    force: *mut f64,
    dforce_dload: *mut f64,
    dforce_dslip_rate: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        if n > 0 {
            not_null(load, "load")?;
            not_null(slip_rate, "slip_rate")?;
        }
        let mut first_invalid = None;
        for begin in (0..n).step_by(BLOCK) {
            let count = BLOCK.min(n - begin);
            let (mut loads, mut rates) = ([0.0; BLOCK], [0.0; BLOCK]);
            for i in 0..count {
                loads[i] = load.add(begin + i).read_unaligned();
                rates[i] = slip_rate.add(begin + i).read_unaligned();
            }
            let (mut forces, mut slopes) = ([0.0; BLOCK], [0.0; BLOCK]);
            let found = batch::fill(model, Quantity::Force, arrays(count, &loads, &mut forces, &mut slopes));
            let is_sliding = |i: usize| is_allowed(transition_rate) && finite(rates[i]);
            let still = (0..count).find(|&i| !is_sliding(i));
            let at = [still, found.map(|(i, _)| i)].into_iter().flatten().min();
            first_invalid = first_invalid.or(at.map(|i| (begin + i, rates[i], loads[i])));
            let signs = signs(&rates, transition_rate, count);
            for i in 0..count {
                let (value, slope, by_rate) = match is_sliding(i) {
                    true => slipping((forces[i], slopes[i]), signs[i]),
                    false => (f64::NAN, f64::NAN, f64::NAN),
                };
                write(force, begin + i, value);
                write(dforce_dload, begin + i, slope);
                write(dforce_dslip_rate, begin + i, by_rate);
            }
        }
        first_invalid.map_or(Ok(()), |(index, rate, load)| {
            if !is_allowed(transition_rate) {
                return Err(Error::invalid("transition_rate", transition_rate, ALLOWED).into());
            }
            Err(match finite(rate) {
                false => Failure::of_element(index, &Error::invalid("slip_rate", rate, "must be finite")),
                true => Quantity::Force.failure(model, index, load),
            })
        })
    })
}

/// The smooth signs and their slopes of all rates that have one.
fn signs(rates: &[f64; BLOCK], transition_rate: f64, count: usize) -> [(f64, f64); BLOCK] {
    let mut signs = [(0.0, 0.0); BLOCK];
    if is_allowed(transition_rate) {
        for (sign, &rate) in signs[..count].iter_mut().zip(rates).filter(|(_, rate)| finite(**rate)) {
            *sign = smooth_sign(rate, transition_rate);
        }
    }
    signs
}
