//! Value and slope of one contact in one call: by load, by pressure, and with a smooth sign of the slip rate.

use super::batch::Quantity;
use super::boundary::{self, write};
use super::fp_environment;
use super::model::asperity_model;
use crate::float_bits::finite;
use crate::regularised::smooth_sign;

/// Areas and rates must lie between these, pressures below the square of the larger.
const SMALLEST: f64 = 1e-60;
const LARGEST: f64 = 1e60;
/// What is said of others.
pub(super) const ALLOWED: &str = "must be from 1e-60 to 1e60";

/// Returns the friction coefficient at a load, and writes its slope.
///
/// @param model      a model
/// @param load       normal load [force]
/// @param dmu_dload  receives d(mu)/d(load) [1/force]: 0 where mu is capped and below pull-off, NaN where mu is NaN
/// @return as `asperity_friction_at_load`
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_and_slope_at_load(
    model: *const asperity_model,
    load: f64,
    dmu_dload: *mut f64,
) -> f64 {
    boundary::fast!(contained_value, {
        let (mu, slope) = at(model, Quantity::Coefficient, load);
        write(dmu_dload, 0, slope);
        mu
    })
}

/// Returns the friction force at a load, and writes its slope: what an implicit solver needs in one call.
///
/// @param model         a model
/// @param load          normal load [force]
/// @param dforce_dload  receives dF/d(load) [-]. With adhesion: finite at zero load, INFINITY at the pull-off load
///                      itself, 0 below it. Without adhesion F has no slope at zero load: at zero load and below, the
///                      library writes the slope at the lightest load of the table, `min_table_load`. NaN where F is
///                      NaN
/// @return as `asperity_friction_force_at_load`
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_and_slope_at_load(
    model: *const asperity_model,
    load: f64,
    dforce_dload: *mut f64,
) -> f64 {
    boundary::fast!(contained_value, {
        let (force, slope) = at(model, Quantity::Force, load);
        write(dforce_dload, 0, slope);
        force
    })
}

/// Returns the friction coefficient at a contact pressure, for solvers that hand over load per area.
///
/// The load is the pressure times `nominal_area`, the area that carries the model's `asperity_count` summits. The area of a
/// mesh facet or of an integration point plays no part: the answer depends on summits per area alone.
///
/// For a model whose `asperity_count` summits stand on 1e-8 m^2:
///
/// ```c
/// double area = 1e-8;
/// double slope, mu = asperity_friction_at_pressure(model, 1e5, area, &slope);
/// ```
///
/// @param model          a model
/// @param pressure       nominal contact pressure [stress], positive in compression
/// @param nominal_area   the area that carries `asperity_count` summits [length^2], from 1e-60 to 1e60
/// @param dmu_dpressure  receives d(mu)/d(pressure) [1/stress]
/// @return as `asperity_friction_at_load` at that load; a quiet NaN also for an area out of its range
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_at_pressure(
    model: *const asperity_model,
    pressure: f64,
    nominal_area: f64,
    dmu_dpressure: *mut f64,
) -> f64 {
    boundary::fast!(contained_value, {
        let (mu, slope) = at(model, Quantity::Coefficient, load_of(pressure, nominal_area));
        write(dmu_dpressure, 0, by_pressure(slope, nominal_area));
        mu
    })
}

/// Returns the frictional shear stress at a contact pressure: friction force per nominal area.
///
/// @param model               a model
/// @param pressure            nominal contact pressure [stress], positive in compression
/// @param nominal_area        as for `asperity_friction_at_pressure` [length^2]
/// @param dstress_dpressure   receives d(stress)/d(pressure) [-]
/// @return friction force over `nominal_area` [stress], finite also at zero and negative pressure down to pull-off; 0
///         below pull-off; a quiet NaN for a pressure that is not finite, an area out of its range, a NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_shear_stress_at_pressure(
    model: *const asperity_model,
    pressure: f64,
    nominal_area: f64,
    dstress_dpressure: *mut f64,
) -> f64 {
    boundary::fast!(contained_value, {
        let (force, slope) = at(model, Quantity::Force, load_of(pressure, nominal_area));
        write(dstress_dpressure, 0, slope);
        stress(force, nominal_area)
    })
}

/// A slope by pressure from one by load.
pub(super) fn by_pressure(slope: f64, nominal_area: f64) -> f64 {
    // A slope of 1e300 or more is a saturated one already. Tested by bits: comparing a NaN may raise a flag.
    let moderate = slope.to_bits() & !(1 << 63) < 1e200_f64.to_bits();
    slope * if moderate { nominal_area } else { 1.0 }
}

/// A force over an area; that is NaN already where the area is not allowed.
pub(super) fn stress(force: f64, nominal_area: f64) -> f64 {
    force / if is_allowed(nominal_area) { nominal_area } else { 1.0 }
}

/// Returns the friction force of a sliding contact with a smooth sign of the slip rate, and writes its two slopes.
///
/// The force is F(load) tanh(slip_rate / transition_rate), for solvers that integrate through zero slip rate. It has the sign
/// of the slip rate, and friction opposes slip: apply minus this force to the body whose slip rate you give. A contact that
/// should stick creeps instead, more slowly for a smaller `transition_rate`.
///
/// How to choose `transition_rate`:
///
/// - Sliding: take less than a third of the slowest sliding speed of interest, at which friction is then 0.5 % low.
/// - Holding: a tangential force T < F makes the contact creep with transition_rate artanh(T/F). Keep that below the creep
///   that you allow.
/// - Explicit steps h of a mass m stop without a change of sign if transition_rate >= F h/m. They oscillate below half of that.
///
/// At 1 mN and 0.2 m/s, with a transition rate of 1 mm/s:
///
/// ```c
/// double force_on_body = -asperity_slip_force(model, 1e-3, 0.2, 1e-3, NULL, NULL);
/// ```
///
/// @param model              a model
/// @param load               normal load [force]
/// @param slip_rate          tangential velocity [length/time], signed
/// @param transition_rate    slip rate at which the force reaches 76 % of F [length/time], from 1e-60 to 1e60
/// @param dforce_dload       receives the derivative by load [-]
/// @param dforce_dslip_rate  receives the derivative by slip rate [force time/length]
/// @return the force [force]; a quiet NaN for a load or slip rate that is not finite, a transition rate out of its
///         range, a NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_slip_force(
    model: *const asperity_model,
    load: f64,
    slip_rate: f64,
    transition_rate: f64,
    dforce_dload: *mut f64,
    dforce_dslip_rate: *mut f64,
) -> f64 {
    boundary::fast!(contained_value, {
        if !finite(slip_rate) || !is_allowed(transition_rate) {
            write(dforce_dload, 0, f64::NAN);
            write(dforce_dslip_rate, 0, f64::NAN);
            return f64::NAN;
        }
        let (force, slope) = at(model, Quantity::Force, load);
        let (sign, sign_rate) = fp_environment::held(|| smooth_sign(slip_rate, transition_rate));
        let (force, by_load, by_rate) = slipping((force, slope), (sign, sign_rate));
        write(dforce_dload, 0, by_load);
        write(dforce_dslip_rate, 0, by_rate);
        force
    })
}

/// The force of a sliding contact, its slope by load and by slip rate, from those without a sign, and the sign and its slope.
#[inline]
pub(super) fn slipping((force, slope): (f64, f64), (sign, sign_rate): (f64, f64)) -> (f64, f64, f64) {
    // At pull-off the slope is infinite; times a sign of zero it is zero, and the product must not be formed ahead.
    (force * sign, sign * if sign == 0.0 { 0.0 } else { slope }, force * sign_rate)
}

unsafe fn at(model: *const asperity_model, quantity: Quantity, load: f64) -> (f64, f64) {
    model.as_ref().map_or((f64::NAN, f64::NAN), |handle| quantity.at(&handle.model, load))
}

/// NaN where one of them is not allowed.
pub(super) fn load_of(pressure: f64, nominal_area: f64) -> f64 {
    let size = pressure.to_bits() & !(1 << 63);
    let allowed = size <= (LARGEST * LARGEST).to_bits() && is_allowed(nominal_area);
    // The product of what cannot raise a flag, should it be evaluated ahead.
    let (p, a) = if allowed { (pressure, nominal_area) } else { (0.0, 1.0) };
    if allowed {
        p * a
    } else {
        f64::NAN
    }
}

/// Compares bits, which order positive numbers: comparing a signalling NaN would raise a flag.
pub(super) fn is_allowed(x: f64) -> bool {
    (SMALLEST.to_bits()..=LARGEST.to_bits()).contains(&x.to_bits())
}
