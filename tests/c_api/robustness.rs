//! Whatever bits a caller passes: a documented status, a message, untouched outputs, no trap, no hang.

use crate::common::processor_time::{process_time, processor_time, LONGEST_CALL};
use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::collections::BTreeMap;
use std::ptr::null_mut;
use std::sync::{mpsc, Arc, Mutex};
use std::time::Duration;

const SEED: u64 = 0x5eed_c0de;
/// Every bit that a state may warn with.
const ALL_WARNINGS: u64 = 2 * ASPERITY_WARNING_FEW_WAVES - 1;
/// A surface whose calls together take longer hangs, or nearly so: of the processor time of the process, which other tests
/// use too.
const LONGEST_SURFACE: Duration = Duration::from_secs(300);
/// So many surfaces that hang are enough to know.
const MOST_HANGING: usize = 3;

type SummitCall =
    unsafe extern "C" fn(*const asperity_model, usize, *const f64, *const f64, *mut f64, *mut f64, *mut f64) -> i32;

/// Functions by pointer, so that none is inlined into code that looks at the floating-point flags.
#[derive(Clone, Copy)]
struct Library {
    create: unsafe extern "C" fn(*const asperity_params, *mut *mut asperity_model) -> i32,
    at_load: unsafe extern "C" fn(*const asperity_model, f64, *mut asperity_state) -> i32,
    at_separation: unsafe extern "C" fn(*const asperity_model, f64, *mut asperity_state) -> i32,
    friction: unsafe extern "C" fn(*const asperity_model, f64) -> f64,
    force: unsafe extern "C" fn(*const asperity_model, f64) -> f64,
    summits: SummitCall,
}

/// The library, how long its slowest call took, what it was, and what went wrong.
struct Watched {
    library: Library,
    slowest: Duration,
    call: String,
    failures: Vec<String>,
    /// The call that runs, for who waits for it.
    running: Option<Arc<Mutex<String>>>,
}

impl Watched {
    fn new() -> Self {
        let library = Library {
            create: asperity_create,
            at_load: asperity_state_at_load,
            at_separation: asperity_state_at_gap,
            friction: asperity_friction_at_load,
            force: asperity_friction_force_at_load,
            summits: asperity_summits_at_overlaps,
        };
        Self {
            library: std::hint::black_box(library),
            slowest: Duration::ZERO,
            call: String::new(),
            failures: Vec::new(),
            running: None,
        }
    }

    /// Notes a failure; all are looked at before the test fails, so that one run shows every one.
    fn claim(&mut self, holds: bool, failure: impl FnOnce() -> String) {
        if !holds {
            self.failures.push(failure());
        }
    }

    /// Takes over what another saw.
    fn merge(&mut self, other: Self) {
        self.failures.extend(other.failures);
        if other.slowest > self.slowest {
            (self.slowest, self.call) = (other.slowest, other.call);
        }
    }

    /// Reports; fails if anything went wrong.
    fn finish(self, seed: u64) {
        println!("the slowest call took {:?}: {}", self.slowest, self.call);
        let shown = self.failures.iter().take(8).map(String::as_str).collect::<Vec<_>>().join("\n");
        assert!(self.failures.is_empty(), "{} failures, seed {seed:#x}, the first:\n{shown}", self.failures.len());
    }

    /// A call that must raise no floating-point flag, and end in time. One that seems slow is timed again: the machine
    /// may have been busy elsewhere.
    fn call<T>(&mut self, what: &dyn Fn() -> String, mut call: impl FnMut(Library) -> T) -> T {
        if let Some(running) = &self.running {
            *running.lock().expect("no thread panicked") = what();
        }
        let library = self.library;
        let mut timed = || {
            let start = processor_time();
            let (answer, complaint) = flags::watch(|| call(library));
            (answer, complaint, processor_time() - start)
        };
        let (mut answer, complaint, mut took) = timed();
        if took >= LONGEST_CALL {
            let again = timed();
            answer = again.0;
            took = took.min(again.2);
        }
        self.claim(took < LONGEST_CALL, || format!("{} took {took:?}", what()));
        if let Some(complaint) = complaint {
            self.failures.push(format!("{}: {complaint}", what()));
        }
        if took > self.slowest {
            (self.slowest, self.call) = (took, what());
        }
        answer
    }

    /// Creates a model; on failure the handle is untouched and the message says why.
    fn create(&mut self, params: &asperity_params) -> Result<Handle, i32> {
        let untouched: *mut asperity_model = std::ptr::without_provenance_mut(0x5eed_0000);
        let mut made = Vec::new();
        reset_message();
        let status = self.call(&|| format!("create {params:?}"), |library| {
            let mut model = untouched;
            // SAFETY: both live as long as the call.
            let status = unsafe { (library.create)(params, &mut model) };
            if status == OK {
                made.push(Handle(model));
            } else {
                assert_eq!(model, untouched, "{params:?}: refused, yet *model is written");
            }
            status
        });
        if status == OK {
            return Ok(made.pop().expect("a model"));
        }
        refused(status, &[INVALID_PARAMETER, OUT_OF_RANGE, NOT_CONVERGED], &|| format!("create {params:?}"));
        Err(status)
    }

    /// The exact state at a load.
    fn at_load(&mut self, handle: &Handle, load: f64) -> Result<asperity_state, i32> {
        self.state("state_at_load", &[INVALID_LOAD, SEPARATED, OUT_OF_RANGE, NOT_CONVERGED], load, |library, state| {
            // SAFETY: the model lives, the struct has its size set.
            unsafe { (library.at_load)(handle.0, load, state) }
        })
    }

    /// The exact state at a separation.
    fn at_separation(&mut self, handle: &Handle, separation: f64) -> Result<asperity_state, i32> {
        self.state("state_at_gap", &[INVALID_PARAMETER, OUT_OF_RANGE], separation, |library, state| {
            // SAFETY: the model lives, the struct has its size set.
            unsafe { (library.at_separation)(handle.0, separation, state) }
        })
    }

    fn state(
        &mut self,
        name: &str,
        documented: &[i32],
        at: f64,
        call: impl Fn(Library, *mut asperity_state) -> i32,
    ) -> Result<asperity_state, i32> {
        let what = || format!("{name} {at:e} ({:#x})", at.to_bits());
        let mut state = asperity_state { load: 7.0, attraction_load: 7.0, ..asperity_state::empty() };
        let before = bytes(&state).to_vec();
        reset_message();
        let status = self.call(&what, |library| call(library, &mut state));
        if status == OK {
            return Ok(state);
        }
        refused(status, documented, &what);
        assert_eq!(bytes(&state), before, "{}: refused, yet the state is written", what());
        Err(status)
    }
}

/// A refusal has a documented status and a message of its own.
fn refused(status: i32, documented: &[i32], what: &dyn Fn() -> String) {
    assert!(documented.contains(&status), "{}: status {status} is not documented: {}", what(), message());
    let message = message();
    assert!(!message.is_empty() && !message.contains("NULL"), "{}: status {status}, message '{message}'", what());
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
        && state.warnings <= ALL_WARNINGS
        && finite.iter().all(|x| x.is_finite())
        && !rates.iter().any(|x| x.is_nan())
        && positive.iter().all(|&x| x >= 0.0)
        && state.attraction_load <= 0.0
}

/// An engineering surface in a random system of units, one of whose numbers may be far off.
fn random_real(random: &mut SplitMix) -> asperity_params {
    let mut params = asperity_params::initial();
    let modulus = random.log_between(1e6, 1e12);
    let sigma = random.log_between(1e-10, 1e-5);
    let quantities = [
        modulus,
        modulus * random.between(0.2, 1.0),
        if random.chance(0.1) { 0.0 } else { random.log_between(1e-4, 3.0) },
        random.log_between(1e-10, 3e-9),
        random.log_between(1e-10, 1e-9),
        sigma,
        sigma * random.log_between(1e2, 1e7),
        random.log_between(1.0, 1e15),
    ];
    let (length, force) = (random.log_between(1e-6, 1e6), random.log_between(1e-6, 1e6));
    let stress = force / (length * length);
    let units = [stress, stress, force / length, length, length, length, length, 1.0];
    for (i, quantity) in params.quantities().into_iter().enumerate() {
        *quantity = quantities[i] * units[i];
    }
    if random.chance(0.3) {
        *params.quantities()[random.below(8)] *= random.log_between(1e-6, 1e6);
    }
    params.attraction = random.below(2) as i32;
    if random.chance(0.4) {
        params = params.weibull(random.log_between(0.2, 1e7));
    } else if random.chance(0.4) {
        params = {
            // Not so skewed that heights end hundreds of sigma up: a separation from the mean has too few digits there.
            let skew = random.between(-1.2, 1.2);
            params.johnson(skew, skew * skew + random.log_between(1.05, 10.0))
        };
    }
    if random.chance(0.3) {
        params = params.radii(random.between(-1.0, 1.0), random.log_between(1e-3, 1e3));
    }
    params
}

/// A corner of what the model can be evaluated for: about half of all numbers at an end of their range.
fn random_corner(random: &mut SplitMix) -> asperity_params {
    let mut end = |from: f64, to: f64| match random.below(4) {
        0 => from * (1.0 + 1e-9),
        1 => to * (1.0 - 1e-9),
        _ => random.log_between(from, to),
    };
    let alpha = end(1e-5, 10.0);
    let beta = end(0.1, 1e8);
    let gamma = end(1e-9, 10.0);
    let b_over_h = end(1e-3, 100.0);
    let shape = end(0.3, 300.0);
    let rate = end(1e-3, 1e3);
    let mut params =
        asperity_params::dimensionless(alpha, beta, if random.chance(0.1) { 0.0 } else { gamma }, b_over_h);
    if random.chance(0.6) {
        params = params.weibull(shape);
    }
    if random.chance(0.5) {
        let amplitude = [-1.0, 1.0, random.between(-1.0, 1.0)][random.below(3)];
        params = params.radii(amplitude, rate);
    }
    params.attraction = i32::from(!random.chance(0.2));
    params
}

/// Calls of every kind on a model, with loads, separations, overlaps and heights of random bits.
fn call_with_random_bits(
    watched: &mut Watched,
    random: &mut SplitMix,
    handle: &Handle,
    count: usize,
    params: &asperity_params,
) {
    for _ in 0..count {
        let x = random.any_float();
        let what = || format!("load or separation {x:e} ({:#x}), {params:?}", x.to_bits());
        for state in [watched.at_load(handle, x), watched.at_separation(handle, x)].into_iter().flatten() {
            watched.claim(is_sound(&state), || format!("{}: {state:?}", what()));
        }
        // SAFETY: the model lives.
        let mu = watched.call(&what, |library| unsafe { (library.friction)(handle.0, x) });
        // SAFETY: the model lives.
        let force = watched.call(&what, |library| unsafe { (library.force)(handle.0, x) });
        let as_promised = if x.is_finite() {
            !(mu < 0.0 || force < 0.0 || force.is_infinite())
        } else {
            mu.is_nan() && force.is_nan()
        };
        watched.claim(as_promised, || format!("{}: mu {mu:e}, force {force:e}", what()));
        let height = f64::from_bits(x.to_bits().swap_bytes());
        let what = || format!("overlap {x:e}, height {height:e}, {params:?}");
        let [mut load, mut force, mut radius] = [7.0; 3];
        // SAFETY: the model lives, the arrays have one element.
        let status = watched.call(&what, |library| unsafe {
            (library.summits)(handle.0, 1, &x, &height, &mut load, &mut force, &mut radius)
        });
        let as_promised = match status {
            OK => load.is_finite() && force >= 0.0 && force.is_finite() && radius >= 0.0 && radius.is_finite(),
            _ => [load, force, radius].iter().all(|value| value.is_nan()),
        };
        watched.claim(as_promised, || format!("{}: status {status}, {load:e}, {force:e}, {radius:e}", what()));
        if status != OK {
            refused(status, &[INVALID_PARAMETER, OUT_OF_RANGE], &what);
        }
    }
}

/// Loads that a model must answer: from pull-off to beyond the heaviest of the table, with their round trips.
fn check_round_trips(watched: &mut Watched, handle: &Handle, params: &asperity_params) {
    let summary = handle.summary();
    let pull_off = summary.pull_off_load;
    let scale = -pull_off;
    let heavy = summary.max_table_load.max(scale);
    let mut loads = vec![1e-6 * heavy, 1e-3 * heavy, 0.3 * heavy, 3.0 * heavy];
    if scale > 0.0 {
        loads.extend([pull_off, -0.999 * scale, -0.5 * scale, 0.0, scale, 100.0 * scale]);
    }
    for load in loads {
        let what = || format!("load {load:e} (pull-off {pull_off:e}), {params:?}");
        let there = watched.at_load(handle, load);
        let Ok(state) = there else {
            watched.failures.push(format!("{}: {there:?}: {}", what(), message()));
            continue;
        };
        watched.claim(is_sound(&state), || format!("{}: {state:?}", what()));
        let again = watched.at_separation(handle, state.gap);
        let Ok(again) = again else {
            watched.failures.push(format!("{}: at its separation {again:?}: {}", what(), message()));
            continue;
        };
        let off = (again.load - load).abs();
        // Contacts that push and contacts that pull cancel in a load: its resolution is that of their loads.
        watched.claim(off <= 1e-9 * load.abs().max(scale).max(again.attraction_load.abs()), || {
            format!("{}: at its separation {:e} the load is {:e}", what(), state.gap, again.load)
        });
        // SAFETY: the model lives.
        let force = watched.call(&what, |library| unsafe { (library.force)(handle.0, load) });
        // Beyond the table the law goes on as a power: good to some digits where it is heavy, to none below it.
        let tolerance = match load {
            _ if load >= summary.max_table_load => 0.5,
            _ if load < summary.min_table_load && load > pull_off => f64::INFINITY,
            _ => 1e-8,
        };
        watched.claim(force >= 0.0 && (force - state.friction_force).abs() <= tolerance * state.friction_force, || {
            format!("{}: force {force:e}, exactly {:e}", what(), state.friction_force)
        });
    }
}

/// Creates the model of a surface and checks it; or says why it is refused.
fn check_surface(watched: &mut Watched, random: &mut SplitMix, params: &asperity_params) -> Result<(), String> {
    match watched.create(params) {
        Ok(handle) => {
            check_round_trips(watched, &handle, params);
            call_with_random_bits(watched, random, &handle, 2, params);
            Ok(())
        }
        Err(status) => {
            let message = message();
            watched.claim(status != INVALID_PARAMETER, || format!("create {params:?}: {message}"));
            Err(format!("status {status}: {}", message.split(" = ").next().unwrap_or_default()))
        }
    }
}

/// Checks so many random surfaces, each on a thread of its own, so that one that hangs is reported and left behind.
fn check_surfaces(seed: u64, count: usize, draw: fn(&mut SplitMix) -> asperity_params) {
    let mut random = SplitMix(seed);
    let mut watched = Watched::new();
    let mut refusals = BTreeMap::<String, usize>::new();
    let (mut created, mut hanging) = (0, 0);
    for _ in 0..count {
        let mut the_same = SplitMix(random.0);
        let params = draw(&mut random);
        let running = Arc::new(Mutex::new(String::new()));
        let mut its_watch = Watched { running: Some(Arc::clone(&running)), ..Watched::new() };
        let mut its_random = SplitMix(random.bits());
        let (sender, receiver) = mpsc::channel();
        std::thread::spawn(move || {
            // Drawn anew: pointers do not go from thread to thread.
            let params = draw(&mut the_same);
            let answer = check_surface(&mut its_watch, &mut its_random, &params);
            // Nobody listens any more if it took too long.
            let _ = sender.send((answer, its_watch));
        });
        let start = process_time();
        let answer = loop {
            match receiver.recv_timeout(Duration::from_secs(1)) {
                Err(mpsc::RecvTimeoutError::Timeout) if process_time() - start < LONGEST_SURFACE => {}
                answer => break answer,
            }
        };
        match answer {
            Ok((Ok(()), seen)) => {
                created += 1;
                watched.merge(seen);
            }
            Ok((Err(refusal), seen)) => {
                *refusals.entry(refusal).or_default() += 1;
                watched.merge(seen);
            }
            Err(mpsc::RecvTimeoutError::Timeout) => {
                let call = running.lock().expect("no thread panicked").clone();
                let failure = format!("still running after {LONGEST_SURFACE:?}: {call}, of {params:?}");
                watched.failures.insert(hanging, failure);
                hanging += 1;
            }
            Err(mpsc::RecvTimeoutError::Disconnected) => watched.failures.push(format!("panicked: {params:?}")),
        }
        if hanging == MOST_HANGING {
            break;
        }
    }
    println!("{created} created; {hanging} hang; refused {refusals:?}");
    watched.claim(hanging == MOST_HANGING || 3 * created >= count, || format!("only {created} of {count} are created"));
    watched.finish(seed);
}

#[test]
fn realistic_surfaces_in_any_units_are_refused_or_work() {
    check_surfaces(SEED ^ 5, 60, random_real);
}

#[test]
fn degenerate_surfaces_are_refused_or_work() {
    check_surfaces(SEED ^ 6, 60, random_corner);
}

#[test]
fn no_adhesion_has_no_sign() {
    let none = asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0);
    let mut negative = asperity_params::dimensionless(0.01, 1000.0, -0.0, 1.0);
    assert!(negative.work_of_adhesion.is_sign_negative() && negative.work_of_adhesion == 0.0);
    let (none, signed) = (Handle::new(&none), Handle::new(&negative));
    for load in [0.0, 1e-3, 1.0, 1e3] {
        // SAFETY: both models live.
        let forces = unsafe { [none.0, signed.0].map(|model| asperity_friction_force_at_load(model, load)) };
        assert_eq!(forces[0].to_bits(), forces[1].to_bits(), "at {load}");
    }
    negative.work_of_adhesion = -1e-300;
    // SAFETY: the parameters live.
    assert_eq!(unsafe { asperity_create(&negative, &mut null_mut()) }, INVALID_PARAMETER, "{}", message());
}

/// No adhesion, so that there is no pull-off load to be found among hundreds of kinks.
#[test]
fn tables_are_read_from_the_fewest_heights_to_the_most() {
    let height: Vec<f64> = (0..257).map(f64::from).collect();
    let density = vec![1.0; height.len()];
    for (length, expected) in [(2, INVALID_PARAMETER), (3, OK), (256, OK), (257, OUT_OF_RANGE)] {
        let mut params = asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0);
        params.height_distribution = ASPERITY_HEIGHTS_TABULATED;
        (params.table_height, params.table_density) = (height.as_ptr(), density.as_ptr());
        params.table_length = length;
        let mut model = null_mut();
        // SAFETY: the table has so many heights.
        assert_eq!(unsafe { asperity_create(&params, &mut model) }, expected, "{length}: {}", message());
        assert_eq!(expected == OK, !model.is_null());
        // SAFETY: a model, or NULL.
        unsafe { asperity_free(model) };
    }
}
