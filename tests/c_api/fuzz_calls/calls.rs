//! Each function of the C interface, called with its oracles: a documented status with a message, outputs untouched
//! where it is refused, no floating-point flag raised, no call without end, answers that agree with each other.

use super::table::*;
use super::TABLE_AT;
use crate::common::neighbours::Neighbours;
use crate::common::processor_time::{processor_time, LONGEST_CALL};
use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::collections::BTreeMap;
use std::ffi::c_char;
use std::hint::black_box;
use std::ptr::null_mut;
use std::time::Duration;

/// Heavier loads, in `composite_modulus burgers_vector^2 asperity_count`, may be out of range.
const HEAVIEST: f64 = 0.9e80;
/// The accuracy of an exact load, relative to the loads that it is the difference of: next to pull-off, where friction
/// changes much with load, that of the friction force is less.
const LOAD_ERROR: f64 = 1e-11;
/// How far the load must rise beyond pull-off before it falls again, and by how much it may fall before, relative to the
/// loads that it is the difference of. There are first minima as shallow as that.
const LEAST_RISE: f64 = 1e-12;
const LARGEST_FALL: f64 = 1e-9;
/// How far a slope may be from the secant over twice this of load - pull-off, extrapolated to none, relative to F/(load -
/// pull-off): errors of the law, and what the secant is off by still where radii change steeply with height. Beside that, what
/// the forces are known to.
const STEP: f64 = 1e-4;
const SECANT: f64 = 1e-5;
/// Up to this part of the pull-off load above it forces are known to fewer digits, and steps are longer.
const NEAR_PULL_OFF: f64 = 1e-2;
const STEP_NEAR_PULL_OFF: f64 = 1e-3;
/// Separations nearer to each other than this many of their roundings say little of the slope between. Only where so many
/// summits gather at one height that they part within that do loads lie as near.
const UNRESOLVED: f64 = 1e5;
/// Lighter loads, in the same unit or the caller's, may have no friction that is a number.
const LIGHTEST: f64 = 1e-250;
/// Nor lighter ones than this part of the lightest of the table, from where the law goes on as a power of the load.
const FAR_BELOW: f64 = 1e-100;
/// What outputs hold before a call.
const BEFORE: f64 = -7.25;

/// What bits hold before a call.
const UNSET: u64 = u64::MAX;

type Shared = *const asperity_model;

/// What was called, and the worst that was seen.
#[derive(Default)]
pub struct Tally {
    /// Calls of each function whose answers were checked.
    pub calls: BTreeMap<&'static str, u64>,
    /// Refusals of `asperity_create` by status.
    pub refused: BTreeMap<i32, u64>,
    /// The slowest call.
    pub slowest: Duration,
    /// What it was.
    pub slowest_call: String,
    /// Calls that took longer than they may.
    pub too_slow: Vec<String>,
    /// The largest relative difference of the table from exact evaluation.
    pub table_difference: f64,
    /// The largest such difference over `table_error`.
    pub table_ratio: f64,
    /// The largest difference of a slope from the secant, relative to F/(load - pull-off).
    pub secant_difference: f64,
    /// Secants between states whose separations are one but for roundings, which are not compared.
    pub unresolved: u64,
    /// The largest fall of the friction force between two loads, relative to it.
    pub largest_fall: f64,
}

/// A model with what it was made from.
pub struct Model {
    pub handle: Handle,
    pub params: asperity_params,
    pub summary: asperity_summary,
}

impl Model {
    fn new(handle: Handle, params: asperity_params) -> Self {
        let summary = handle.summary();
        Self { handle, params, summary }
    }

    /// What loads are measured in.
    fn unit_load(&self) -> f64 {
        let p = &self.params;
        p.composite_modulus * p.burgers_vector * p.burgers_vector * p.asperity_count
    }

    /// How well the friction force at a load can be known, relative to it, given how well a load can.
    fn resolution(&self, load: f64) -> f64 {
        let mut slope = BEFORE;
        // SAFETY: the model lives.
        let force = unsafe { asperity_friction_force_and_slope_at_load(self.handle.0, load, &mut slope) };
        slope.min(1e300) * LOAD_ERROR * load.abs().max(-self.summary.pull_off_load) / force
    }

    /// Whether the law at a load is that of exact states: beyond the table it goes on as a power.
    fn is_compiled(&self, load: f64) -> bool {
        let s = &self.summary;
        load == s.pull_off_load || (s.min_table_load..s.max_table_load).contains(&load)
    }

    fn is_within_range(&self, load: f64) -> bool {
        is_finite(load) && load <= HEAVIEST * self.unit_load()
    }
}

/// Calls with their oracles; what is seen goes into the tally.
pub struct Calls<'a> {
    tally: &'a mut Tally,
}

/// By bits, since comparing a signalling NaN raises a flag.
fn is_finite(x: f64) -> bool {
    x.to_bits() >> 52 & 0x7ff != 0x7ff
}

fn is_quiet_nan(x: f64) -> bool {
    x.is_nan() && x.to_bits() >> 51 & 1 == 1
}

/// Calls a function by pointer, so that it is not inlined into code that looks at the flags.
macro_rules! call {
    ($calls:expr, $model:expr, $function:ident ( $($argument:expr),* )) => {{
        let what = || format!(concat!(stringify!($function), " {:?} of {:?}"), ($($argument,)*), $model);
        // SAFETY: the arguments are valid, or such as the function must refuse.
        $calls.watch(stringify!($function), what, || unsafe { black_box($function as unsafe extern "C" fn($(call!(@any $argument)),*) -> _)($($argument),*) })
    }};
    (@any $argument:expr) => { _ };
}

impl<'a> Calls<'a> {
    pub fn new(tally: &'a mut Tally) -> Self {
        Self { tally }
    }

    /// One call: counted, timed, its flags looked at.
    fn watch<T>(&mut self, name: &'static str, what: impl Fn() -> String, call: impl FnOnce() -> T) -> T {
        self.watch_many(name, 1, what, call)
    }

    /// One call that answers for so many elements.
    fn watch_many<T>(
        &mut self,
        name: &'static str,
        elements: usize,
        what: impl Fn() -> String,
        call: impl FnOnce() -> T,
    ) -> T {
        let start = processor_time();
        let (answer, complaint) = flags::watch(call);
        let took = processor_time() - start;
        *self.tally.calls.entry(name).or_default() += 1;
        if let Some(complaint) = complaint {
            panic!("{}: {complaint}", what());
        }
        if took > self.tally.slowest {
            (self.tally.slowest, self.tally.slowest_call) = (took, what());
        }
        if took > LONGEST_CALL * elements.max(1) as u32 {
            self.tally.too_slow.push(format!("{took:?}: {}", what()));
        }
        answer
    }

    /// A status is one of those the header lists, and a refusal has a message of its own.
    fn documented(&self, status: i32, allowed: &[i32], what: &dyn Fn() -> String) {
        if status == OK {
            return;
        }
        assert!(allowed.contains(&status), "{}: status {status}: {}", what(), message());
        let message = message();
        let own = !message.is_empty() && message != NULL_MESSAGE;
        assert!(own, "{}: status {status} with the message '{message}'", what());
    }

    pub fn create(&mut self, params: &asperity_params) -> Option<Model> {
        let untouched: *mut asperity_model = std::ptr::without_provenance_mut(0x5eed_0000);
        let mut model = untouched;
        let out: *mut *mut asperity_model = &mut model;
        reset_message();
        let params_at: *const asperity_params = params;
        let status = call!(self, params, asperity_create(params_at, out));
        if status == OK {
            assert!(!model.is_null() && model != untouched, "{params:?}: no model");
            let model = Model::new(Handle(model), *params);
            let [kept, expected] = [&asperity_params::of(&model.handle), &echo(params)].map(words_of);
            assert_eq!(kept[1..TABLE_AT], expected[1..TABLE_AT], "{params:?}");
            self.check_summary(&model);
            if model.summary.pull_off_load < 0.0 {
                self.beyond_pull_off(&model);
            }
            return Some(model);
        }
        *self.tally.refused.entry(status).or_default() += 1;
        self.documented(status, refusals(params), &|| format!("create {params:?}"));
        assert_eq!(model, untouched, "{params:?}: refused, yet *model is written");
        None
    }

    fn check_summary(&mut self, model: &Model) {
        let s = &model.summary;
        let sound = s.pull_off_load <= 0.0
            && s.pull_off_friction_force >= 0.0
            && s.zero_load_friction_force >= 0.0
            && s.min_table_load >= s.pull_off_load
            && s.max_table_load > s.min_table_load
            && s.table_error >= 0.0
            && s.table_error <= 1e-6;
        let finite = bytes(s)[8..].chunks(8).all(|word| is_finite(f64::from_ne_bytes(word.try_into().expect("8"))));
        assert!(sound && finite, "{:?}: {s:?}", model.params);
    }

    /// Beyond pull-off the load rises, if only within a last bit of the separation, before it may fall again.
    fn beyond_pull_off(&mut self, model: &Model) {
        let (at, mut state): (Shared, _) = (model.handle.0, asperity_state::empty());
        let state_at: *mut asperity_state = &mut state;
        let pull_off = model.summary.pull_off_load;
        assert_eq!(call!(self, model.params, asperity_state_at_load(at, pull_off, state_at)), OK, "{:?}", model.params);
        let (end, height_std) = (state.gap, model.params.height_std);
        for offset in (-15..0).map(|k| height_std * 10_f64.powi(k)) {
            let status = call!(self, model.params, asperity_state_at_gap(at, end + offset, state_at));
            assert_eq!(status, OK, "{end:e} + {offset:e}: {}; {:?}", message(), model.params);
            let loads = (state.load - state.attraction_load).abs() + state.attraction_load.abs();
            let change = (state.load - pull_off) / loads;
            if change > LEAST_RISE {
                break;
            }
            assert!(
                change > -LARGEST_FALL,
                "load {:e} at {end:e} + {offset:e} below {pull_off:e}; {:?}",
                state.load,
                model.params
            );
        }
    }

    fn force(&mut self, model: &Model, load: f64) -> f64 {
        let at: Shared = model.handle.0;
        call!(self, model.params, asperity_friction_force_at_load(at, load))
    }

    /// The scalar calls at a load, against each other and the rules of the header. Returns force and slope.
    pub fn at_load(&mut self, model: &Model, load: f64) {
        let at: Shared = model.handle.0;
        let p = model.params;
        let pull_off = model.summary.pull_off_load;
        let cap = p.max_friction_coefficient;
        let (mut slope, mut mu_slope) = (BEFORE, BEFORE);
        let (slope_at, mu_slope_at): (*mut f64, *mut f64) = (&mut slope, &mut mu_slope);
        let force = self.force(model, load);
        let mu: f64 = call!(self, p, asperity_friction_at_load(at, load));
        let force_again: f64 = call!(self, p, asperity_friction_force_and_slope_at_load(at, load, slope_at));
        let mu_again: f64 = call!(self, p, asperity_friction_and_slope_at_load(at, load, mu_slope_at));
        let what =
            || format!("load {load:e} ({:#x}): F {force:e} {slope:e}, mu {mu:e} {mu_slope:e}; {p:?}", load.to_bits());
        assert_eq!(force.to_bits(), force_again.to_bits(), "{}", what());
        assert_eq!(mu.to_bits(), mu_again.to_bits(), "{}", what());
        if !is_finite(load) {
            let all = [force, mu, slope, mu_slope];
            assert!(all.iter().all(|&x| is_quiet_nan(x)), "{}", what());
        } else if load < pull_off {
            assert_eq!([force, mu, mu_slope], [0.0; 3], "{}", what());
            // Without a pull-off load force has there the slope of the lightest load of the table.
            assert!(if pull_off == 0.0 { slope >= 0.0 && is_finite(slope) } else { slope == 0.0 }, "{}", what());
        } else if model.is_within_range(load) {
            assert!(is_finite(force) && force >= 0.0 && slope >= 0.0, "{}", what());
            // Nothing is left at zero load without adhesion, nor, of a power of the load, far below the table.
            let lightest = (LIGHTEST * model.unit_load().max(1.0)).max(FAR_BELOW * model.summary.min_table_load);
            assert!(force > 0.0 || load <= lightest, "{}", what());
            assert!(slope.is_finite() || load == pull_off, "{}", what());
            assert!(!mu_slope.is_nan() && mu >= 0.0 && mu <= cap, "{}", what());
            let close = |a: f64, b: f64| (a - b).abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs());
            let capped = mu == cap && (load <= 0.0 || force / load >= cap.min(1e139) * (1.0 - 1e-15));
            assert!(capped || close(mu, force / load) || load < f64::MIN_POSITIVE, "{}", what());
            assert!(mu != cap || mu_slope == 0.0 || close(mu, force / load), "{}", what());
        } else {
            assert!(is_quiet_nan(force) || force > 0.0, "{}", what());
        }
        self.before_slip(model, load, force);
    }

    /// The loads at a number taken for a separation, by each call; and the batches beside friction by load.
    pub fn at_gap(&mut self, model: &Model, separation: f64) {
        let (at, p): (Shared, _) = (model.handle.0, model.params);
        let (mut slope, mut load_of_batch, mut slope_of_batch) = (BEFORE, BEFORE, BEFORE);
        let one: usize = 1;
        let (from, slope_at): (*const f64, *mut f64) = (&separation, &mut slope);
        let (load_at, slopes_at, skipped): (*mut f64, *mut f64, *mut f64) =
            (&mut load_of_batch, &mut slope_of_batch, null_mut());
        let load: f64 = call!(self, p, asperity_load_and_slope_at_gap(at, separation, skipped));
        let again: f64 = call!(self, p, asperity_load_and_slope_at_gap(at, separation, slope_at));
        let status: i32 = call!(self, p, asperity_loads_at_gaps(at, one, from, load_at, slopes_at));
        let what = || format!("separation {separation:e}: {load:e} {slope:e}, status {status}; {p:?}");
        let same = [load, again, load_of_batch].map(f64::to_bits);
        assert!(same[0] == same[1] && same[0] == same[2] && slope.to_bits() == slope_of_batch.to_bits(), "{}", what());
        self.documented(status, &[INVALID_PARAMETER, SEPARATED, OUT_OF_RANGE], &what);
        assert_eq!(status == OUT_OF_RANGE || status == INVALID_PARAMETER, load.is_nan(), "{}", what());
        assert!(load.is_nan() || (is_finite(load) && slope <= 0.0), "{}", what());
        assert!(status != SEPARATED || (load == 0.0 && slope == 0.0), "{}", what());
        let pull_off = model.summary.pull_off_load;
        assert!(load.is_nan() || load >= pull_off * (1.0 + 1e-9), "{}", what());
        let friction = [INVALID_PARAMETER, INVALID_LOAD, SEPARATED, OUT_OF_RANGE];
        let (models, which): ([Shared; 1], u32) = ([at], (separation.to_bits() & 1) as u32);
        let (models_at, which_at): (*const Shared, *const u32) = (models.as_ptr(), &which);
        let status: i32 = call!(
            self,
            p,
            asperity_friction_force_at_loads_of(models_at, one, one, which_at, from, load_at, slopes_at)
        );
        self.documented(status, &friction, &what);
        assert!(which == 0 || is_quiet_nan(load_of_batch), "{}", what());
    }

    /// Tangential stiffness and force at a load, of which the friction force is known.
    fn before_slip(&mut self, model: &Model, load: f64, friction: f64) {
        let (at, p): (Shared, _) = (model.handle.0, model.params);
        let stiffness: f64 = call!(self, p, asperity_tangential_stiffness_at_load(at, load));
        let (mut batch, mut force, mut slope) = (BEFORE, BEFORE, BEFORE);
        let (load_at, batch_at): (*const f64, *mut f64) = (&load, &mut batch);
        let (force_at, slope_at): (*mut f64, *mut f64) = (&mut force, &mut slope);
        let one: usize = 1;
        let told: i32 = call!(self, p, asperity_tangential_stiffness_at_loads(at, one, load_at, batch_at));
        let far: f64 = 1e150;
        let status: i32 = call!(self, p, asperity_tangential_at_load(at, load, far, force_at, slope_at));
        let what =
            || format!("load {load:e}: F {friction:e}, K {stiffness:e}, status {status}, T {force:e} {slope:e}; {p:?}");
        assert_eq!(batch.to_bits(), stiffness.to_bits(), "{}", what());
        assert!(is_quiet_nan(stiffness) || stiffness >= 0.0, "{}", what());
        assert!(told != OK || is_finite(stiffness), "{}", what());
        if status == OK && told == OK && friction > 0.0 && model.is_compiled(load) {
            assert!(force >= 0.0 && force <= friction * (1.0 + 1e-6) && slope >= 0.0, "{}", what());
        } else if status != OK {
            assert!(force.to_bits() == BEFORE.to_bits() && slope.to_bits() == BEFORE.to_bits(), "{}", what());
        }
    }

    /// A path of a contact that remembers, and each of its steps in a batch of one.
    pub fn path(&mut self, model: &Model, steps: &[(f64, [f64; 2])]) {
        const LENGTH: usize = 43;
        let (at, p): (Shared, _) = (model.handle.0, model.params);
        let length: usize = call!(self, p, asperity_microslip_length(at));
        assert_eq!(length, LENGTH);
        let mut state = [0.0; LENGTH];
        for &(load, increment) in steps {
            let friction: f64 = call!(self, p, asperity_friction_force_at_load(at, load));
            let (before, one): ([f64; LENGTH], usize) = (state, 1);
            let mut out = asperity_microslip::empty();
            let (by, from, to): (*const f64, *const f64, *mut f64) =
                (increment.as_ptr(), before.as_ptr(), state.as_mut_ptr());
            let to_out: *mut asperity_microslip = &mut out;
            let status: i32 = call!(self, p, asperity_microslip_step(at, load, by, from, to, to_out));
            let what = || format!("load {load:e}, {increment:?}, F {friction:e}, status {status}: {out:?}; {p:?}");
            let (mut batch, mut force, mut stiffness) = ([BEFORE; LENGTH], [BEFORE; 2], [BEFORE; 4]);
            let (to, force_at, stiffness_at): (*mut f64, *mut f64, *mut f64) =
                (batch.as_mut_ptr(), force.as_mut_ptr(), stiffness.as_mut_ptr());
            let load_at: *const f64 = &load;
            let told: i32 =
                call!(self, p, asperity_microslip_steps(at, one, load_at, by, from, to, force_at, stiffness_at));
            assert_eq!(told, status, "{}", what());
            if status == OK || status == SEPARATED {
                let same = bytes(&batch) == bytes(&state)
                    && bytes(&force) == bytes(&out.force)
                    && bytes(&stiffness) == bytes(&out.stiffness);
                let numbers = [out.dforce_dload, [out.dissipated, out.slipping]].concat();
                let finite = numbers.iter().chain(&out.stiffness).chain(&state).all(|&x| is_finite(x));
                // The smallest numbers have no digits left for the sum of elements.
                let bounded = out.force[0].hypot(out.force[1]) <= friction * (1.0 + 1e-14) + f64::MIN_POSITIVE;
                assert!(same && finite && bounded && out.dissipated >= 0.0, "{}", what());
                assert!((0.0..=1.0).contains(&out.slipping), "{}", what());
            } else {
                assert!(
                    bytes(&before) == bytes(&state) && is_quiet_nan(force[0]) && is_quiet_nan(stiffness[3]),
                    "{}",
                    what()
                );
            }
        }
    }

    /// Batches of loads: the bits of single calls, whatever outputs are asked for, also in place.
    pub fn batches(&mut self, model: &Model, loads: &[f64], kind: usize) {
        type Batch = unsafe extern "C" fn(Shared, usize, *const f64, *mut f64, *mut f64) -> i32;
        type One = unsafe extern "C" fn(Shared, f64, *mut f64) -> f64;
        let (batch, one, name): (Batch, One, _) = if kind & 1 == 0 {
            (
                asperity_friction_force_at_loads,
                asperity_friction_force_and_slope_at_load,
                "asperity_friction_force_at_loads",
            )
        } else {
            (asperity_friction_at_loads, asperity_friction_and_slope_at_load, "asperity_friction_at_loads")
        };
        let (batch, n, at) = (black_box(batch), loads.len(), model.handle.0);
        // A place that is not aligned to vectors; the last element is not the call's.
        let mut value = [BEFORE; 64];
        let mut slope = [BEFORE; 64];
        value[1..=n].copy_from_slice(loads);
        let first = kind & 1;
        let what = || format!("{name} of {loads:?}, kind {kind}; {:?}", model.params);
        reset_message();
        let (in_place, no_slope) = (kind & 2 != 0, kind & 4 != 0);
        let status = self.watch_many(name, n, what, || {
            let value_at = value[1..].as_mut_ptr();
            let from = if in_place { value_at.cast_const() } else { loads.as_ptr() };
            let slope_at = if no_slope { null_mut() } else { slope[1 + first..].as_mut_ptr() };
            // SAFETY: n elements each, or NULL; an output may be the input.
            unsafe { batch(at, n, from, value_at, slope_at) }
        });
        let pull_off = model.summary.pull_off_load;
        // A finite load without an answer is invalid as well, wherever it is heavy enough to have none.
        let alone = |load: f64| unsafe { one(at, load, null_mut()) };
        let first_invalid = loads.iter().position(|&load| !is_finite(load) || load < pull_off || alone(load).is_nan());
        let expected = match first_invalid {
            None => OK,
            Some(i) if !is_finite(loads[i]) => INVALID_LOAD,
            Some(i) if loads[i] < pull_off => SEPARATED,
            Some(i) => {
                assert!(!model.is_within_range(loads[i]), "{}: no answer at {:e}", what(), loads[i]);
                OUT_OF_RANGE
            }
        };
        assert_eq!(status, expected, "{}: {}", what(), message());
        if let Some(i) = first_invalid {
            assert!(message().starts_with(&format!("element {i}: load = ")), "{}: {}", what(), message());
        }
        for (i, &load) in loads.iter().enumerate() {
            let mut alone_slope = BEFORE;
            // SAFETY: the model lives.
            let alone = unsafe { one(at, load, &mut alone_slope) };
            assert_eq!(value[1 + i].to_bits(), alone.to_bits(), "{}: element {i}", what());
            let expected = if no_slope { BEFORE } else { alone_slope };
            assert_eq!(slope[1 + first + i].to_bits(), expected.to_bits(), "{}: slope of element {i}", what());
        }
        let outside = [value[0], value[n + 1], slope[first], slope[n + 1 + first]];
        assert_eq!(outside, [BEFORE; 4], "{}: wrote outside", what());
    }

    /// The exact state at a load, against the compiled law.
    pub fn exact(&mut self, model: &Model, load: f64) {
        let at: Shared = model.handle.0;
        let mut state = asperity_state { load: BEFORE, attraction_load: BEFORE, ..asperity_state::empty() };
        let before = bytes(&state).to_vec();
        let state_at: *mut asperity_state = &mut state;
        reset_message();
        let status = call!(self, model.params, asperity_state_at_load(at, load, state_at));
        let s = &model.summary;
        let what = || format!("state at load {load:e} ({:#x}): {state:?}; {s:?}; {:?}", load.to_bits(), model.params);
        if status != OK {
            self.documented(status, &[INVALID_LOAD, SEPARATED, OUT_OF_RANGE, NOT_CONVERGED], &what);
            assert_eq!(bytes(&state), before, "{}: refused, yet the state is written", what());
            let expected = if !is_finite(load) {
                INVALID_LOAD
            } else if load < s.pull_off_load {
                SEPARATED
            } else {
                OUT_OF_RANGE
            };
            assert_eq!(status, expected, "{}: {}", what(), message());
            let at_zero = load == 0.0 && s.pull_off_load == 0.0;
            assert!(expected != OUT_OF_RANGE || at_zero || !model.is_within_range(load), "{}: {}", what(), message());
            return;
        }
        assert!(is_sound(&state), "{}", what());
        assert!(state.load == load && load >= s.pull_off_load, "{}", what());
        let force = self.force(model, load);
        let difference = (force / state.friction_force - 1.0).abs();
        // Beyond the table the law goes on as a power.
        if state.friction_force < f64::MIN_POSITIVE || !model.is_compiled(load) {
            return;
        }
        self.tally.table_difference = self.tally.table_difference.max(difference);
        let allowed = s.table_error + 2e-13 + model.resolution(load);
        assert!(difference <= allowed, "{}: table {force:e}, off by {difference:e}", what());
        if s.table_error > 0.0 && difference > 2e-13 + model.resolution(load) {
            self.tally.table_ratio = self.tally.table_ratio.max(difference / s.table_error);
        }
    }

    /// A load is found again at its gap. Far lighter ones than those of the table change more within the last bit of a gap.
    pub fn round_trip(&mut self, model: &Model, load: f64) {
        let (at, p, s): (Shared, _, _) = (model.handle.0, model.params, model.summary);
        let mut state = asperity_state::empty();
        let state_at: *mut asperity_state = &mut state;
        assert_eq!(call!(self, p, asperity_state_at_load(at, load, state_at)), OK, "{load:e}: {}; {p:?}", message());
        let (gap, force) = (state.gap, state.friction_force);
        assert_eq!(call!(self, p, asperity_state_at_gap(at, gap, state_at)), OK, "{load:e}: {}; {p:?}", message());
        // Contacts that push and contacts that pull cancel in a load: its resolution is that of their loads. Both states have 1e-9.
        let largest = load.abs().max(-s.pull_off_load).max(state.attraction_load.abs());
        let off = (state.load - load).abs();
        assert!(off <= 1e-8 * largest, "load {load:e} at its gap {gap:e} is {:e}; {p:?}", state.load);
        // Beyond the table the law goes on as a power, good to some digits where loads are heavy, to none below it.
        let tolerance = match load {
            _ if load >= s.max_table_load => 0.5,
            _ if load < s.min_table_load && load > s.pull_off_load => f64::INFINITY,
            _ => 1e-6,
        };
        let found = self.force(model, load);
        assert!(
            found >= 0.0 && (found - force).abs() <= tolerance * force,
            "load {load:e}: {found:e}, exactly {force:e}; {p:?}"
        );
    }

    /// The warnings of all loads from one to another, against those of the states at both.
    pub fn check_loads(&mut self, model: &Model, one: f64, other: f64) {
        let at: Shared = model.handle.0;
        let mut warnings = UNSET;
        let out: *mut u64 = &mut warnings;
        reset_message();
        let what = || format!("check_loads({one:e}, {other:e}); {:?}", model.params);
        // It evaluates some hundred states, each of which may take a tenth of what a call may.
        let status = self.watch_many("asperity_check_loads", 10, what, || {
            // SAFETY: the model lives, as does the output.
            unsafe { black_box(asperity_check_loads as unsafe extern "C" fn(_, _, _, _) -> _)(at, one, other, out) }
        });
        let states = [one, other].map(|load| {
            let mut state = asperity_state::empty();
            let state_at: *mut asperity_state = &mut state;
            let status = call!(self, model.params, asperity_state_at_load(at, load, state_at));
            (status, state.warnings)
        });
        if status != OK {
            self.documented(status, &[INVALID_PARAMETER, INVALID_LOAD, SEPARATED, OUT_OF_RANGE, NOT_CONVERGED], &what);
            assert_eq!(warnings, UNSET, "{}: refused, yet the warnings are written", what());
            let falls = status == INVALID_PARAMETER;
            assert!(falls || states.iter().any(|state| state.0 == status), "{}: {states:?}, {}", what(), message());
            assert!(!falls || one > other, "{}: {}", what(), message());
            return;
        }
        let ends = states[0].1 | states[1].1;
        assert!(one <= other && warnings & ends == ends, "{}: {warnings:b}, {states:?}", what());
        assert!(warnings < 2 * ASPERITY_WARNING_NOT_GAUSSIAN, "{}: {warnings:b}", what());
    }

    pub fn separation(&mut self, model: &Model, separation: f64) {
        let at: Shared = model.handle.0;
        let mut state = asperity_state { load: BEFORE, attraction_load: BEFORE, ..asperity_state::empty() };
        let before = bytes(&state).to_vec();
        let state_at: *mut asperity_state = &mut state;
        reset_message();
        let status = call!(self, model.params, asperity_state_at_gap(at, separation, state_at));
        let what = || format!("state at separation {separation:e}: {state:?}; {:?}", model.params);
        if status == OK {
            assert!(is_sound(&state), "{}", what());
            return;
        }
        self.documented(status, &[INVALID_PARAMETER, OUT_OF_RANGE], &what);
        assert_eq!(status == INVALID_PARAMETER, !is_finite(separation), "{}: {}", what(), message());
        assert_eq!(bytes(&state), before, "{}: refused, yet the state is written", what());
    }

    /// The slope at a load of the table, against the central secant.
    pub fn secant(&mut self, model: &Model, part: f64) {
        let s = &model.summary;
        let (nearest, farthest) = (s.min_table_load - s.pull_off_load, s.max_table_load - s.pull_off_load);
        let near = nearest.max(-1e-6 * s.pull_off_load) * 1.01;
        let x = near * (0.99 * farthest / near).powf(part);
        let step = if x < -NEAR_PULL_OFF * s.pull_off_load { STEP_NEAR_PULL_OFF } else { STEP };
        let load = s.pull_off_load + x;
        let (at, mut slope): (Shared, f64) = (model.handle.0, BEFORE);
        let slope_at: *mut f64 = &mut slope;
        let force = call!(self, model.params, asperity_friction_force_and_slope_at_load(at, load, slope_at));
        let ends = |step: f64| (s.pull_off_load + x * (1.0 - step), s.pull_off_load + x * (1.0 + step));
        let mut secant = |step: f64| {
            let (below, above) = ends(step);
            (self.force(model, above) - self.force(model, below)) / (above - below)
        };
        // What a secant is off by goes with the square of its length.
        let (whole, half) = (secant(step), secant(0.5 * step));
        let secant = half + (half - whole) / 3.0;
        let difference = (slope - secant).abs() * x / force;
        // Far below the heights all contacts pass a slip radius within one step: secants then depend on their length. A jump
        // within them is told all the same.
        let unsettled = (half - whole).abs() * x / force;
        let is_near = difference <= SECANT + unsettled + 4.0 * model.resolution(load) / step;
        if !is_near && !self.are_resolved(model, ends(step)) {
            self.tally.unresolved += 1;
            return;
        }
        self.tally.secant_difference = self.tally.secant_difference.max(difference);
        assert!(
            is_near,
            "load {load:e}: slope {slope:e}, secant {secant:e}, difference {difference:e} of F/x; {:?}",
            model.params
        );
    }

    /// Whether the separations of two loads are told apart by more than roundings.
    fn are_resolved(&mut self, model: &Model, (lighter, heavier): (f64, f64)) -> bool {
        let [lighter, heavier] = [lighter, heavier].map(|load| {
            let (at, mut state): (Shared, _) = (model.handle.0, asperity_state::empty());
            let state_at: *mut asperity_state = &mut state;
            assert_eq!(call!(self, model.params, asperity_state_at_load(at, load, state_at)), OK, "load {load:e}");
            state.gap
        });
        let height_std = model.params.height_std;
        (lighter - heavier).abs() > UNRESOLVED * f64::EPSILON * lighter.abs().max(height_std)
    }

    /// Two loads on the branch: the heavier one has no less friction.
    pub fn order(&mut self, model: &Model, one: f64, other: f64) {
        let pull_off = model.summary.pull_off_load;
        // Loads that are hardly numbers have hardly an order.
        let on_branch =
            |load: f64| model.is_within_range(load) && load >= pull_off && (load == 0.0 || load.abs() > 1e-290);
        if !on_branch(one) || !on_branch(other) {
            return;
        }
        let (lighter, heavier) = if one <= other { (one, other) } else { (other, one) };
        for (lighter, heavier) in [(lighter, heavier), (heavier, heavier.above()), (heavier, heavier * 1.000_001)] {
            let (less, more) = (self.force(model, lighter), self.force(model, heavier));
            if lighter > heavier || !model.is_within_range(heavier) || less <= more {
                continue;
            }
            let fall = less / more - 1.0;
            self.tally.largest_fall = self.tally.largest_fall.max(fall);
            // A row and its exact neighbour agree to the accuracy of the law; exact states have that of their load,
            // which is the difference of what presses and what pulls.
            let allowed = 2.0 * model.summary.table_error + 1e-12 + model.resolution(lighter);
            assert!(
                fall <= allowed,
                "F falls by {fall:e}, from {less:e} at {lighter:e} to {more:e} at {heavier:e}; {:?}",
                model.params
            );
        }
    }

    /// A function of the table with any arguments.
    pub fn any(&mut self, model: &Model, seed: u64) {
        let mut random = SplitMix(seed);
        let call = &CALLS[random.below(CALLS.len())];
        let n = if call.is_batch() { random.below(4) } else { 1 };
        // What others would miss, and files.
        let is_left_out = |is| matches!(is, ChangedModel | FreedModel);
        if call.at(is_left_out).next().is_some() || call.name == "asperity_params_read" {
            return;
        }
        let mut prepared = call.prepare(&model.handle, n);
        let (mut texts, mut text_length) = (Vec::new(), 0);
        for (i, &(_, is)) in call.arguments.iter().enumerate() {
            if let Text(says) = is {
                // Ends as before, whatever else it says.
                let mut text = says.to_bytes_with_nul().to_vec();
                text_length = says.count_bytes();
                for _ in 0..random.below(4) {
                    text[random.below(text_length)] = random.bits() as u8;
                }
                prepared.words[i].pointer = text.as_mut_ptr().cast();
                texts.push(text);
            }
            if random.chance(0.6) {
                continue;
            }
            let (word, place) = (&mut prepared.words[i], &mut prepared.places[i]);
            match is {
                Number(_) => word.bits = random.any_float().to_bits(),
                In(..) if n > 0 => place[random.below(n)] = random.any_float().to_bits(),
                // The models are as many as they are said to be.
                Whole(_) if call.at(|is| is == Models).next().is_none() => {
                    word.bits = random.bits() >> random.below(64)
                }
                Struct(_) | Params | ChangedParams => {
                    place.resize(ROOM / 8, UNTOUCHED);
                    let size = random.bits() >> random.below(64);
                    // No more is claimed than there is room for, unless it is a size that is refused.
                    place[0] = if size > ROOM as u64 / 8 { size | 1 } else { size };
                    word.pointer = place.as_mut_ptr().cast();
                }
                Length => word.bits = random.below(text_length + 1) as u64,
                Room => word.bits = random.below(ROOM + 1) as u64,
                MayOut(_) | Out(_) | NewModel | Buffer | Model if random.chance(0.3) => word.pointer = null_mut(),
                _ => {}
            }
        }
        let before = prepared.places.clone();
        reset_message();
        let told = self.watch_many(call.name, 10, || format!("{} {prepared:?}", call.name), || call.run(&prepared));
        let what = format!("{}, seed {seed:#x}: {told:?}: {}", call.name, message());
        check(call, &prepared, &before, told, &what);
        free_what_was_made(call, &prepared);
    }

    /// Numbers by name: what is set reads back as it was given, what is refused changes nothing.
    pub fn names(&mut self, mut text: [u8; 65], which: [usize; 5], x: [f64; 5]) {
        text[64] = 0;
        let before = asperity_params::initial();
        let (any, values): (*const c_char, *const f64) = (text.as_ptr().cast(), x.as_ptr());
        for names in [which.map(|which| asperity_name(ASPERITY_NAMES_PARAMETERS, which % 26)), [any; 5]] {
            let (mut params, mut back) = (before, 0.0);
            let (at, names_at): (*mut asperity_params, *const *const c_char) = (&mut params, names.as_ptr());
            let (name, back_at): (*const c_char, *mut f64) = (names[0], &mut back);
            let what = || format!("{which:?} or {text:?} = {x:?}");
            reset_message();
            for several in [true, false] {
                params = before;
                let count: usize = if several { 5 } else { 1 };
                let status = call!(self, x, asperity_params_set_values(at, count, names_at, values));
                if status != OK {
                    self.documented(status, &[INVALID_PARAMETER, OUT_OF_RANGE], &what);
                    assert_eq!(bytes(&params), bytes(&before), "{}: refused, yet the parameters are changed", what());
                } else if !several {
                    let read_only: *const asperity_params = at;
                    let read = call!(self, x, asperity_params_get_value(read_only, name, back_at));
                    // The skew of Weibull heights is kept as their shape, and an integer has no sign of zero.
                    let as_shape = params.weibull_shape != before.weibull_shape && params.skew == before.skew;
                    let same = back.to_bits() == x[0].to_bits() || back == x[0] || as_shape;
                    assert!(read == OK && same, "{}: reads back as {back:e}", what());
                }
            }
        }
    }

    /// A text: refused, it changes nothing; taken, the parameters that it makes are written and read again bit for bit.
    pub fn text(&mut self, text: &[u8], any: f64, unit: f64) {
        let before = asperity_params::unset();
        let mut params = before;
        let (at, text_at): (*mut asperity_params, *const c_char) = (&mut params, text.as_ptr().cast());
        let what = || String::from_utf8_lossy(text).into_owned();
        reset_message();
        let status = call!(self, what(), asperity_params_set_text(at, text_at, text.len()));
        if status == OK {
            let (read_only, mut written): (*const asperity_params, _) = (at, [0_u8; 4096]);
            let written_at: *mut c_char = written.as_mut_ptr().cast();
            let length: usize = call!(self, what(), asperity_params_text(read_only, written_at, 4096_usize));
            let mut again = before;
            let (again_at, written_at): (*mut asperity_params, *const c_char) = (&mut again, written.as_ptr().cast());
            let status = call!(self, what(), asperity_params_set_text(again_at, written_at, length));
            assert_eq!(status, OK, "{}: {}", what(), message());
            assert_eq!(bytes(&again), bytes(&params), "{}: {}", what(), String::from_utf8_lossy(&written[..length]));
        } else {
            let allowed = [INVALID_PARAMETER, OUT_OF_RANGE, INVALID_LOAD, SEPARATED, NOT_CONVERGED];
            self.documented(status, &allowed, &what);
            assert_eq!(bytes(&params), bytes(&before), "{}: refused, yet the parameters are changed", what());
        }
        self.estimate(text, &[any, unit]);
        // Units that are any numbers, and some that are.
        for (length, force) in [(any, unit), (unit, any), (unit, 1.0 / unit)] {
            let before = params;
            let status = call!(self, unit, asperity_params_set_units(at, length, force));
            if status != OK {
                self.documented(status, &[INVALID_PARAMETER, OUT_OF_RANGE], &|| format!("units {length:e}, {force:e}"));
                assert_eq!(bytes(&params), bytes(&before), "{length:e}, {force:e}: refused, yet changed");
            }
        }
    }

    /// An estimate of a text: refused, it writes nothing; taken, the coefficient is in its band.
    fn estimate(&mut self, text: &[u8], loads: &[f64; 2]) {
        // SAFETY: zero bits are a value of every field.
        let mut found: [asperity_estimate; 2] = unsafe { std::mem::zeroed() };
        found[0].struct_size = size_of::<asperity_estimate>() as u64;
        let (text_at, found_at): (*const c_char, *mut asperity_estimate) = (text.as_ptr().cast(), found.as_mut_ptr());
        let loads_at: *const f64 = loads.as_ptr();
        let what = || format!("{loads:?} {}", String::from_utf8_lossy(text));
        reset_message();
        let status = call!(self, what(), asperity_estimate_at_loads(text_at, text.len(), 2_usize, loads_at, found_at));
        if status == OK {
            for one in found {
                let numbers = [one.friction_coefficient, one.low, one.high, one.friction_force, one.model_share];
                assert!(numbers.iter().all(|number| *number >= 0.0), "{}: {one:?}", what());
                assert!(one.low <= one.high, "{}: {one:?}", what());
            }
        } else {
            let allowed = [INVALID_PARAMETER, OUT_OF_RANGE, INVALID_LOAD, SEPARATED, NOT_CONVERGED];
            self.documented(status, &allowed, &what);
            assert!(found[1].struct_size == 0 && found[0].load == 0.0, "{}: refused, yet written", what());
        }
        let (no_buffer, none): (*mut c_char, usize) = (null_mut(), 0);
        let length: usize =
            call!(self, what(), asperity_estimate_text(text_at, text.len(), 2_usize, loads_at, no_buffer, none));
        assert_eq!(length > 0, status == OK, "{}", what());
        let mut params = asperity_params::unset();
        let at: *mut asperity_params = &mut params;
        let of_text = call!(self, what(), asperity_params_set_text(at, text_at, text.len()));
        // A text without an area is one of pressures for an estimate alone; a strength above the shear modulus has no curve.
        let has_none = found.iter().all(|one| one.curve_coefficient.is_nan()) || found[0].is_of_pressures == 1;
        assert!(of_text == OK || status != OK || has_none, "{}: {}", what(), message());
        let taken = bytes(&params) != bytes(&asperity_params::unset());
        assert!(of_text == OK || !taken, "{}: refused, yet changed", what());
    }

    /// Other parameters for a model: where they are refused, it answers bit for bit as before; where they are taken, as
    /// a new one does.
    pub fn set_params(&mut self, model: &Model, params: &asperity_params) {
        let before = answers(&model.handle);
        let (at, params_at): (*mut asperity_model, *const asperity_params) = (model.handle.0, params);
        reset_message();
        let status = call!(self, params, asperity_set_params(at, params_at));
        if status == OK {
            let new = self.create(params).expect("a model of parameters that were just taken");
            assert_eq!(answers(&model.handle), answers(&new.handle), "{params:?}");
            let back: *const asperity_params = &model.params;
            assert_eq!(call!(self, params, asperity_set_params(at, back)), OK, "{}", message());
        } else {
            self.documented(status, refusals(params), &|| format!("{params:?}"));
        }
        assert_eq!(answers(&model.handle), before, "after {params:?}, of {:?}", model.params);
    }
}

/// How parameters may be refused.
fn refusals(params: &asperity_params) -> &'static [i32] {
    let lacks_table = params.height_distribution == ASPERITY_HEIGHTS_TABULATED
        && (params.table_height.is_null() || params.table_density.is_null());
    if lacks_table {
        &[INVALID_PARAMETER, OUT_OF_RANGE, NULL_POINTER]
    } else {
        &[INVALID_PARAMETER, OUT_OF_RANGE, NOT_CONVERGED]
    }
}

/// What `asperity_get_params` gives for parameters that were taken: what is not read has its default.
fn echo(params: &asperity_params) -> asperity_params {
    let mut echo = *params;
    let default = asperity_params::initial();
    if params.height_distribution != ASPERITY_HEIGHTS_WEIBULL {
        echo.weibull_shape = default.weibull_shape;
    }
    if params.height_distribution != ASPERITY_HEIGHTS_JOHNSON {
        (echo.skew, echo.kurtosis) = (default.skew, default.kurtosis);
    }
    echo
}

fn words_of(params: &asperity_params) -> Vec<u64> {
    bytes(params).chunks(8).map(|word| u64::from_ne_bytes(word.try_into().expect("8 bytes"))).collect()
}

/// Every number that a caller could want is one: finite where it must be, with its sign.
fn is_sound(state: &asperity_state) -> bool {
    let finite = [state.load, state.gap, state.friction_force, state.real_area, state.contacting];
    let rates = [state.friction_coefficient, state.dforce_dload, state.dmu_dload, state.dload_dgap];
    let positive = [state.friction_force, state.real_area, state.contacting, state.attracted];
    let radii = [state.mean_contact_radius, state.max_contact_radius];
    let contacts = [state.fraction_in_contact, state.mean_asperity_pressure, state.plasticity_index];
    let fractions =
        [state.fraction_below_slip_radius_1, state.fraction_between_slip_radii, state.fraction_above_slip_radius_2];
    let whole: f64 = fractions.iter().sum();
    let touching = (whole - 1.0).abs() < 1e-9 && radii[0] > 0.0 && radii[1] >= radii[0];
    let apart = whole == 0.0 && radii == [0.0; 2];
    (if state.contacting > 0.0 { touching } else { apart })
        && radii.iter().chain(&contacts).chain(&fractions).all(|x| x.is_finite())
        && fractions.iter().all(|&x| x >= 0.0)
        && state.warnings < 2 * ASPERITY_WARNING_NOT_GAUSSIAN
        && finite.iter().all(|x| x.is_finite())
        && !rates.iter().any(|x| x.is_nan())
        && positive.iter().all(|&x| x >= 0.0)
        && state.attraction_load <= 0.0
}

/// The bits of what a model answers at some loads.
fn answers(handle: &Handle) -> Vec<u8> {
    let summary = handle.summary();
    let mut answers = bytes(&summary).to_vec();
    for part in [-0.9, 0.0, 1e-8, 1e-3, 0.1, 2.0] {
        let load = if part < 0.0 { part * -summary.pull_off_load } else { part * summary.max_table_load };
        // SAFETY: the model lives.
        answers.extend(unsafe { asperity_friction_force_at_load(handle.0, load) }.to_bits().to_ne_bytes());
    }
    // The model's own copy of a table may lie elsewhere.
    answers.extend(&bytes(&asperity_params::of(handle))[..8 * TABLE_AT]);
    answers
}

/// What `reset_message` leaves.
const NULL_MESSAGE: &str = "model is NULL: pass a valid pointer";
