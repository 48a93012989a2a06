//! The contract of the C interface: what the head of asperity.h says of all functions, asked of each through one description of it.

use crate::common::neighbours::Neighbours;
use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::ffi::{c_char, c_void, CStr};
use std::ptr::null_mut;

/// What an argument is, with the value that it has in an ordinary call.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Is {
    Model,
    /// A model that the call changes; one that it frees.
    ChangedModel,
    FreedModel,
    Params,
    ChangedParams,
    Number(f64),
    /// A size, an index or a choice.
    Whole(u64),
    /// How many elements there are.
    Count,
    /// So many numbers for each element to read.
    In(usize, f64),
    /// The same, where NULL stands for an array of zeros.
    MayIn(f64),
    /// So many numbers for each element to write, which NULL skips; those that it does not skip.
    MayOut(usize),
    Out(usize),
    /// A handle to write; a struct of so many bytes, which begins with its size.
    NewModel,
    Struct(usize),
    Text(&'static CStr),
    /// The length of the text before.
    Length,
    /// Room for a text, and how much there is.
    Buffer,
    Room,
    /// Arrays with one pointer or one index.
    Models,
    Which,
    Names(&'static CStr),
}
use Is::*;

/// A function, with its arguments in order.
struct Call {
    name: &'static str,
    arguments: &'static [(&'static str, Is)],
    run: fn(&[Word]) -> Told,
}

/// The bits of an argument.
#[derive(Clone, Copy)]
struct Word {
    pointer: *mut c_void,
    bits: u64,
}

trait FromWord {
    fn of(word: Word) -> Self;
}

macro_rules! from_word {
    ($($type:ty = $word:ident: $value:expr;)*) => {
        $(impl FromWord for $type { fn of($word: Word) -> Self { $value } })*
    };
}
from_word! {
    f64 = word: f64::from_bits(word.bits);
    u64 = word: word.bits;
    usize = word: word.bits as usize;
    i32 = word: word.bits as i32;
}
impl<T> FromWord for *const T {
    fn of(word: Word) -> Self {
        word.pointer.cast_const().cast()
    }
}
impl<T> FromWord for *mut T {
    fn of(word: Word) -> Self {
        word.pointer.cast()
    }
}

/// What a function returns.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Told {
    Status(i32),
    Number(u64),
    Length(usize),
    Version(u32),
    String(usize),
    Nothing,
}

trait Tell {
    fn told(self) -> Told;
}

macro_rules! tell {
    ($($type:ty = $value:ident: $told:expr;)*) => {
        $(impl Tell for $type { fn told(self) -> Told { let $value = self; $told } })*
    };
}
tell! {
    i32 = status: Told::Status(status);
    f64 = number: Told::Number(number.to_bits());
    usize = length: Told::Length(length);
    u32 = version: Told::Version(version);
    *const c_char = text: Told::String(text as usize);
    () = _nothing: Told::Nothing;
}

macro_rules! calls {
    ($($function:ident($($argument:ident: $is:expr),*);)*) => {
        &[$(Call {
            name: stringify!($function),
            arguments: &[$((stringify!($argument), $is)),*],
            run: |words| {
                let mut _words = words.iter().copied();
                #[allow(unused_unsafe)] // Some functions are safe.
                // SAFETY: the arguments are those that the row describes, or such as the function must refuse.
                unsafe { $function($({ let _: Is = $is; FromWord::of(_words.next().expect("an argument")) }),*) }.told()
            },
        }),*]
    };
}

const SURFACE: &CStr = c"pair = \"steel/steel\"\nnominal_area = 1e-4\nmeasured = [1000, 0.16]\n[roughness]\nRa = 0.8e-6\nprocess = \"ground\"\n";
const LOAD: f64 = 1e-3;
const STATE: usize = 42;

#[rustfmt::skip]
const CALLS: &[Call] = calls! {
    asperity_estimate_at_loads(surface: Text(SURFACE), length: Length, n: Count, load: In(1, 10.0), estimates: Struct(size_of::<asperity_estimate>()));
    asperity_estimate_text(surface: Text(SURFACE), length: Length, n: Count, load: In(1, 10.0), buffer: Buffer, buffer_length: Room);
    asperity_params_init(params: ChangedParams, struct_size: Whole(size_of::<asperity_params>() as u64));
    asperity_params_set_dimensionless(params: ChangedParams, alpha: Number(0.1), beta: Number(4.0), gamma: Number(1e-3), b_over_h: Number(1.0), poisson: Number(0.3));
    asperity_params_set_materials(params: ChangedParams, E1: Number(2e11), nu1: Number(0.3), E2: Number(1e11), nu2: Number(0.2));
    asperity_params_set_spectral_moments(params: ChangedParams, m0: Number(1e-16), m2: Number(1e-4), m4: Number(1e10), nominal_area: Number(1e-6));
    asperity_params_set_pair(params: ChangedParams, name: Text(c"Si/Si"));
    asperity_params_set_units(params: ChangedParams, length: Number(1e-3), force: Number(1.0));
    asperity_params_set_values(params: ChangedParams, count: Count, names: Names(c"rms_slope"), values: In(1, 0.2));
    asperity_params_get_value(params: Params, name: Text(c"rms_slope"), value: Out(1));
    asperity_params_calibrate(params: ChangedParams, load: Number(1.0), friction_coefficient: Number(0.3));
    asperity_params_calibrate_force(params: ChangedParams, load: Number(1.0), friction_force: Number(0.3));
    asperity_params_set_text(params: ChangedParams, text: Text(c"rms_slope = 0.2"), length: Length);
    asperity_params_set_estimate(params: ChangedParams, surface: Text(SURFACE), length: Length);
    asperity_params_text(params: Params, buffer: Buffer, length: Room);
    asperity_params_read(params: ChangedParams, path: Text(c"hosts/surface.toml"));
    asperity_create(params: Params, model: NewModel);
    asperity_set_params(model: ChangedModel, params: Params);
    asperity_get_params(model: Model, params: Struct(size_of::<asperity_params>()));
    asperity_free(model: FreedModel);
    asperity_name(kind: Whole(1), index: Whole(0));
    asperity_describe(kind: Whole(1), name: Text(c"Si"), buffer: Buffer, length: Room);
    asperity_friction_at_load(model: Model, load: Number(LOAD));
    asperity_friction_force_at_load(model: Model, load: Number(LOAD));
    asperity_friction_at_loads(model: Model, n: Count, load: In(1, LOAD), mu: MayOut(1), dmu_dload: MayOut(1));
    asperity_friction_force_at_loads(model: Model, n: Count, load: In(1, LOAD), force: MayOut(1), dforce_dload: MayOut(1));
    asperity_friction_and_slope_at_load(model: Model, load: Number(LOAD), dmu_dload: MayOut(1));
    asperity_friction_force_and_slope_at_load(model: Model, load: Number(LOAD), dforce_dload: MayOut(1));
    asperity_friction_force_at_loads_of(models: Models, models_length: Whole(1), n: Count, which: Which, load: In(1, LOAD), force: MayOut(1), dforce_dload: MayOut(1));
    asperity_tangential_stiffness_at_load(model: Model, load: Number(LOAD));
    asperity_tangential_stiffness_at_loads(model: Model, n: Count, load: In(1, LOAD), stiffness: MayOut(1));
    asperity_tangential_at_load(model: Model, load: Number(LOAD), displacement: Number(1e-3), force: MayOut(1), stiffness: MayOut(1));
    asperity_microslip_length(model: Model);
    asperity_microslip_step(model: Model, load: Number(LOAD), increment: In(2, 1e-3), before: In(STATE, 0.0), after: MayOut(STATE), out: Struct(size_of::<asperity_microslip>()));
    asperity_microslip_steps(model: Model, n: Count, load: In(1, LOAD), increment: In(2, 1e-3), before: In(STATE, 0.0), after: MayOut(STATE), force: MayOut(2), stiffness: MayOut(4));
    asperity_microslip_turn(state: Out(STATE), cosine: Number(1.0), sine: Number(0.5));
    asperity_load_and_slope_at_gap(model: Model, gap: Number(1e-2), dload_dgap: MayOut(1));
    asperity_loads_at_gaps(model: Model, n: Count, gap: In(1, 1e-2), load: MayOut(1), dload_dgap: MayOut(1));
    asperity_summits_at_overlaps(model: Model, n: Count, overlap: In(1, 1e-2), height: MayIn(1e-3), load: MayOut(1), force: MayOut(1), radius: MayOut(1));
    asperity_state_at_load(model: Model, load: Number(LOAD), state: Struct(size_of::<asperity_state>()));
    asperity_state_at_gap(model: Model, gap: Number(1e-2), state: Struct(size_of::<asperity_state>()));
    asperity_summary_of(model: Model, summary: Struct(size_of::<asperity_summary>()));
    asperity_check_loads(model: Model, lightest: Number(1e-3), heaviest: Number(1e-2), warnings: Out(1));
    asperity_warnings_text(warnings: Whole(u64::MAX), buffer: Buffer, length: Room);
    asperity_last_error(buffer: Buffer, length: Room);
    asperity_status_string(status: Whole(5));
    asperity_abi_version();
    asperity_version();
    asperity_table_of(model: Model, kind: Whole(1), table: Struct(size_of::<asperity_table>()));
};

const SEED: u64 = 0x5eed_ba7c;
/// What memory holds that a call must leave as it is.
const UNTOUCHED: u64 = 0x5eed_5eed_5eed_5eed;
/// Room for a text [bytes].
const ROOM: usize = 1 << 13;

/// Arguments of a call with the memory that they point to.
struct Prepared {
    words: Vec<Word>,
    places: Vec<Vec<u64>>,
    /// Pointers and names that arrays point to.
    _pointers: Vec<Box<[*const c_void]>>,
}

impl Call {
    /// An ordinary call of n elements.
    fn prepare(&self, model: &Handle, n: usize) -> Prepared {
        let mut prepared = Prepared { words: Vec::new(), places: Vec::new(), _pointers: Vec::new() };
        let mut text = 0;
        for &(_, is) in self.arguments {
            let number = |bits: u64| (bits, Vec::new());
            let array = |width: usize, value: f64| {
                (0, (0..n * width).map(|_| value.to_bits()).chain([UNTOUCHED]).collect::<Vec<_>>())
            };
            let params = || {
                let params = soonest_made();
                (0, bytes(&params).chunks(8).map(word_of).chain([UNTOUCHED]).collect())
            };
            let mut pointer = None;
            let (bits, place) = match is {
                Model | ChangedModel => {
                    pointer = Some(model.0.cast());
                    number(0)
                }
                FreedModel => {
                    let mut own = null_mut();
                    // SAFETY: a place for a handle.
                    assert_eq!(unsafe { asperity_create(&soonest_made(), &mut own) }, OK);
                    pointer = Some(own.cast());
                    number(0)
                }
                Params | ChangedParams => params(),
                Number(value) => number(value.to_bits()),
                Whole(whole) => number(whole),
                Count => number(n as u64),
                In(width, value) => array(width, value),
                MayIn(value) => array(1, value),
                MayOut(width) | Out(width) => (0, vec![UNTOUCHED; n * width + 1]),
                NewModel => (0, vec![UNTOUCHED; 2]),
                Struct(size) => {
                    let mut place = vec![UNTOUCHED; n * size / 8 + 1];
                    place[0] = size as u64;
                    (0, place)
                }
                Text(says) => {
                    text = says.count_bytes();
                    pointer = Some(says.as_ptr().cast_mut().cast());
                    number(0)
                }
                Length => number(text as u64),
                Buffer => (0, vec![UNTOUCHED; ROOM / 8 + 1]),
                Room => number(ROOM as u64),
                Models | Names(_) => {
                    let one: *const c_void = if let Names(name) = is { name.as_ptr().cast() } else { model.0.cast() };
                    prepared._pointers.push(vec![one; n.max(1)].into());
                    pointer = prepared._pointers.last().map(|array| array.as_ptr().cast_mut().cast());
                    number(0)
                }
                Which => (0, vec![0; n.div_ceil(2) + 1]),
            };
            prepared.places.push(place);
            let place = prepared.places.last_mut().filter(|place| !place.is_empty());
            let pointer = pointer.or(place.map(|place| place.as_mut_ptr().cast()));
            prepared.words.push(Word { pointer: pointer.unwrap_or(null_mut()), bits });
        }
        if self.name == "asperity_microslip_turn" {
            prepared.places[0][..STATE].fill(0);
        }
        prepared
    }

    /// Runs it; no call raises what a host may trap, or changes the floating-point environment.
    fn run(&self, prepared: &Prepared) -> Told {
        let (told, complaint) = flags::watch(|| std::hint::black_box(self.run)(&prepared.words));
        assert_eq!(complaint, None, "{}", self.name);
        told
    }

    fn at(&self, is: impl Fn(Is) -> bool) -> impl Iterator<Item = usize> {
        let found: Vec<usize> = (0..self.arguments.len()).filter(|&i| is(self.arguments[i].1)).collect();
        found.into_iter()
    }

    fn is_batch(&self) -> bool {
        self.at(|is| is == Count).next().is_some()
    }
}

/// Whether something is written there.
fn is_output(is: Is) -> bool {
    matches!(is, MayOut(_) | Out(_) | NewModel | Struct(_) | Buffer | ChangedParams)
}

fn word_of(bytes: &[u8]) -> u64 {
    u64::from_ne_bytes(bytes.try_into().expect("8 bytes"))
}

/// The surface whose model is soonest made.
fn soonest_made() -> asperity_params {
    asperity_params::dimensionless(0.6, 0.3, 2.0, 40.0)
}

fn free_what_was_made(call: &Call, prepared: &Prepared) {
    for i in call.at(|is| is == NewModel) {
        if prepared.places[i][0] != UNTOUCHED {
            // SAFETY: a model that the call made.
            unsafe { asperity_free(std::ptr::with_exposed_provenance_mut(prepared.places[i][0] as usize)) };
        }
    }
}

fn is_success(told: Told) -> bool {
    match told {
        Told::Status(status) => status == OK,
        Told::Number(bits) => f64::from_bits(bits).is_finite(),
        Told::Length(length) => length > 0,
        Told::String(at) => at != 0,
        Told::Version(version) => version == 1,
        Told::Nothing => true,
    }
}

#[test]
#[cfg_attr(miri, ignore = "reads text, which takes half a minute there")]
fn every_function_of_the_header_is_described_with_its_arguments() {
    let header = include_str!("../../include/asperity.h");
    let mut missing = Vec::new();
    let mut functions = 0;
    for (at, line) in header.lines().enumerate() {
        let is_declared =
            !line.starts_with([' ', '#', '/', '*', '}']) && line.contains('(') && line.contains("asperity_");
        let Some((before, _)) = line.split_once('(').filter(|_| is_declared) else { continue };
        let name = before.rsplit([' ', '*']).next().expect("a name");
        let rest = header.lines().skip(at).collect::<Vec<_>>().join(" ");
        let arguments = rest[rest.find('(').expect("a bracket") + 1..].split(");").next().expect("an end");
        let names: Vec<&str> = arguments
            .split(',')
            .map(|one| one.trim().rsplit([' ', '*']).next().expect("a name"))
            .filter(|&one| one != "void")
            .collect();
        functions += 1;
        let described = CALLS.iter().find(|call| call.name == name);
        let is_so =
            described.is_some_and(|call| call.arguments.iter().map(|(name, _)| *name).eq(names.iter().copied()));
        missing.extend((!is_so).then_some(name));
    }
    assert_eq!((missing, functions), (Vec::new(), CALLS.len()));
}

#[test]
fn an_ordinary_call_succeeds_and_writes_all_of_its_outputs_and_no_more() {
    let model = Handle::new(&soonest_made());
    reset_message();
    for call in CALLS {
        let ends = if call.is_batch() && call.at(|is| matches!(is, Names(_))).next().is_none() { 3 } else { 1 };
        let prepared = call.prepare(&model, ends);
        let told = call.run(&prepared);
        assert!(is_success(told), "{}: {told:?}: {}", call.name, message());
        for i in call.at(is_output) {
            let (place, (name, is)) = (&prepared.places[i], call.arguments[i]);
            assert_eq!(place.last(), Some(&UNTOUCHED), "{}: wrote beyond {name}", call.name);
            let is_text = is == Buffer;
            let written = if is_text { 1 } else { place.len() - 1 };
            let is_table = call.name == "asperity_get_params";
            assert!(
                is_table || place[..written].iter().all(|&word| word != UNTOUCHED),
                "{}: {name}: {place:x?}",
                call.name
            );
        }
        free_what_was_made(call, &prepared);
    }
}

#[test]
fn repeats_and_threads_give_the_same_bits() {
    let model = Handle::new(&soonest_made());
    let is_shared = |call: &&Call| call.at(|is| matches!(is, ChangedModel | FreedModel | NewModel)).next().is_none();
    // The message is that of each thread.
    for call in CALLS.iter().filter(is_shared).filter(|call| call.name != "asperity_last_error") {
        let answer = || {
            let prepared = call.prepare(&model, 1);
            let told = call.run(&prepared);
            (told, prepared.places)
        };
        let expected = answer();
        std::thread::scope(|scope| {
            let threads = [(); 3].map(|()| scope.spawn(|| [answer(), answer()]));
            for found in threads.map(|thread| thread.join().expect("an answer")) {
                assert!(found.iter().all(|one| *one == expected), "{}: {found:x?}, {expected:x?}", call.name);
            }
        });
    }
}

#[test]
fn null_is_refused_by_name_or_skipped() {
    let model = Handle::new(&soonest_made());
    for call in CALLS {
        let whole = call.prepare(&model, 1);
        let expected = call.run(&whole);
        free_what_was_made(call, &whole);
        for i in call.at(|is| !matches!(is, Number(_) | Whole(_) | Count | Length | Room)) {
            let (name, is) = call.arguments[i];
            let mut prepared = call.prepare(&model, 1);
            let before = prepared.places.clone();
            prepared.words[i].pointer = null_mut();
            reset_message();
            let told = call.run(&prepared);
            let what = format!("{}: {name} = NULL: {told:?}: {}", call.name, message());
            if matches!(is, MayIn(_) | MayOut(_) | Buffer | FreedModel) {
                assert!(told == expected || call.name == "asperity_last_error", "{what}");
                let others = call.at(|is| is_output(is) && is != Buffer).filter(|&other| other != i);
                let same =
                    others.into_iter().all(|other| is == MayIn(1e-3) || prepared.places[other] == whole.places[other]);
                assert!(same, "{what}");
                continue;
            }
            match told {
                Told::Status(status) => {
                    assert_eq!(status, NULL_POINTER, "{what}");
                    assert!(message().starts_with(&format!("{name} is NULL")) || is == Models, "{what}");
                }
                Told::Number(bits) => assert!(f64::from_bits(bits).is_nan() && bits >> 51 & 1 == 1, "{what}"),
                Told::Length(length) => assert_eq!(length, 0, "{what}"),
                _ => panic!("{what}"),
            }
            for output in call.at(|is| is_output(is) && !matches!(is, Buffer | MayOut(_))) {
                assert!(prepared.places[output] == before[output], "{what}: yet written");
            }
        }
    }
}

#[test]
fn numbers_of_every_kind_get_an_answer_or_a_status_with_a_message() {
    let model = Handle::new(&soonest_made());
    let special = [
        f64::NAN,
        f64::from_bits(0x7ff0_0000_0000_0001),
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        5e-324,
        -5e-324,
        0.0,
        -0.0,
        -1.0,
        1e300,
        -1e-300,
        1e-30,
        1e30,
    ];
    let known = [OK, INVALID_PARAMETER, INVALID_LOAD, SEPARATED, OUT_OF_RANGE, NOT_CONVERGED];
    for call in CALLS {
        for i in call.at(|is| matches!(is, Number(_) | In(..) | MayIn(_))) {
            for value in special {
                let mut prepared = call.prepare(&model, 1);
                match call.arguments[i].1 {
                    Number(_) => prepared.words[i].bits = value.to_bits(),
                    _ => prepared.places[i][0] = value.to_bits(),
                }
                let before = prepared.places.clone();
                reset_message();
                let told = call.run(&prepared);
                let what = format!("{}: {} = {value:e}: {told:?}: {}", call.name, call.arguments[i].0, message());
                match told {
                    Told::Status(status) => {
                        assert!(known.contains(&status), "{what}");
                        let has_message = !message().is_empty() && !message().starts_with("model is NULL");
                        assert_eq!(has_message, status != OK, "{what}");
                        // Batches fill all elements; without contact a step has forces of 0.
                        let fills = call.is_batch() || status == SEPARATED;
                        for output in call.at(|is| is_output(is) && !fills && status != OK) {
                            assert!(prepared.places[output] == before[output], "{what}: yet written");
                        }
                    }
                    Told::Number(bits) => {
                        let number = f64::from_bits(bits);
                        assert!(!number.is_nan() || bits >> 51 & 1 == 1, "{what}: a signalling NaN");
                        assert!(value.is_finite() || number.is_nan(), "{what}");
                    }
                    Told::Length(_) => {}
                    _ => panic!("{what}"),
                }
                free_what_was_made(call, &prepared);
            }
        }
    }
}

#[test]
fn structs_of_other_sizes_are_filled_no_further_or_refused() {
    let model = Handle::new(&soonest_made());
    for call in CALLS {
        for i in call.at(|is| matches!(is, Struct(_) | ChangedParams | Params)) {
            let whole = match call.arguments[i].1 {
                Struct(size) => size,
                _ => size_of::<asperity_params>(),
            };
            // Parameters are of one size.
            let fills = matches!(call.arguments[i].1, Struct(_)) && call.name != "asperity_get_params";
            for size in [0, 1, 8, 12, 15, 16, 24, whole - 8, whole - 1, whole + 4, whole + 8, whole + 64, usize::MAX] {
                let mut prepared = call.prepare(&model, 1);
                prepared.places[i].resize(whole / 8 + 9, UNTOUCHED);
                prepared.places[i][0] = size as u64;
                prepared.words[i].pointer = prepared.places[i].as_mut_ptr().cast();
                let before = prepared.places[i].clone();
                if call.name == "asperity_params_init" {
                    prepared.words[1].bits = size as u64;
                }
                reset_message();
                let told = call.run(&prepared);
                let what = format!("{}: struct_size = {size}: {told:?}: {}", call.name, message());
                if fills && size >= 16 && size % 8 == 0 && size <= whole + 64 {
                    let end = size.min(whole) / 8;
                    assert!(is_success(told) && prepared.places[i][end..] == before[end..], "{what}");
                } else {
                    let is_refused = told == Told::Status(INVALID_PARAMETER) || told == Told::Length(0);
                    assert!(is_refused && message().contains("struct_size = "), "{what}");
                    assert!(prepared.places[i] == before, "{what}: yet written");
                }
                free_what_was_made(call, &prepared);
            }
        }
    }
}

#[test]
fn no_elements_need_no_arrays() {
    let model = Handle::new(&soonest_made());
    for call in CALLS.iter().filter(|call| call.is_batch()) {
        let mut prepared = call.prepare(&model, 0);
        for i in call.at(|is| matches!(is, In(..) | MayIn(_) | MayOut(_) | Out(_) | Struct(_) | Which | Names(_))) {
            prepared.words[i].pointer = null_mut();
        }
        let told = call.run(&prepared);
        assert!(is_success(told), "{}: {told:?}: {}", call.name, message());
    }
}

/// Models whose tables differ in kind: adhesion or none, rows left out, caps, units, metal that yields.
fn models() -> Vec<Handle> {
    let paper = asperity_params::dimensionless(0.01, 1000.0, 0.001, 1.0);
    let hertz = asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0);
    let uneven = asperity_params::dimensionless(0.05, 60.0, 0.02, 1.5);
    // SI at the size of atoms.
    let mut small_units = paper;
    let scales = [1e11, 1e11, 10.0, 1e-10, 1e-10, 1e-10, 1e-10, 1e6];
    small_units.quantities().into_iter().zip(scales).for_each(|(quantity, scale)| *quantity *= scale);
    let metal = ASPERITY_CONTACT_ELASTIC_PLASTIC;
    let yielding = asperity_params { contact_law: metal, hardness: 0.01 * hertz.composite_modulus, ..hertz };
    [
        paper,
        hertz,
        paper.weibull(40.0),
        paper.weibull(1.2),
        paper.radii(0.9, 2.0),
        paper.cap(1.0),
        paper.cap(f64::INFINITY),
        small_units,
        yielding,
        uneven.weibull(1.1),
        uneven.weibull(60.0),
        uneven.radii(-1.0, 3.0),
        uneven.weibull(20.0).radii(1.0, 5.0),
    ]
    .map(|params| Handle::new(&params))
    .into()
}

/// Loads or gaps of every kind: in the table, beyond its ends, around pull-off and zero, invalid.
fn mixed(random: &mut SplitMix, model: &Handle, count: usize) -> Vec<f64> {
    let summary = model.summary();
    let (pull_off, sigma) = (summary.pull_off_load, asperity_params::of(model).height_std);
    let corners = [
        f64::NAN,
        f64::from_bits(0x7ff0_0000_0000_0001),
        f64::from_bits(0xfff4_0000_0000_0000),
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -0.0,
        f64::from_bits(1),
        -f64::from_bits(1),
        f64::MIN_POSITIVE,
        1e-200,
        pull_off,
        pull_off.above(),
        pull_off.below(),
        2.0 * pull_off - 1e-30,
        -f64::MAX,
        summary.min_table_load,
        summary.min_table_load.below(),
        summary.max_table_load,
        summary.max_table_load.below(),
        2.0 * summary.max_table_load,
        1e300,
    ];
    let (nearest, farthest) = (summary.min_table_load - pull_off, summary.max_table_load - pull_off);
    let any = |random: &mut SplitMix| match random.below(20) {
        0..=2 => corners[random.below(corners.len())],
        3 => -sigma * random.log_between(1e2, 1e11),
        4..=8 => sigma * random.between(-6.0, 14.0),
        _ => pull_off + random.log_between(nearest, farthest),
    };
    (0..count).map(|_| any(random)).collect()
}

#[test]
fn a_batch_of_one_has_the_bits_of_the_call_for_one() {
    let named = |name: &str| CALLS.iter().find(|call| call.name == name).expect("a function");
    let mut random = SplitMix(SEED);
    for model in models() {
        let loads = mixed(&mut random, &model, 400);
        for (batch, one) in [
            ("asperity_friction_at_loads", "asperity_friction_at_load"),
            ("asperity_friction_at_loads", "asperity_friction_and_slope_at_load"),
            ("asperity_friction_force_at_loads", "asperity_friction_force_at_load"),
            ("asperity_friction_force_at_loads", "asperity_friction_force_and_slope_at_load"),
            ("asperity_friction_force_at_loads_of", "asperity_friction_force_and_slope_at_load"),
            ("asperity_tangential_stiffness_at_loads", "asperity_tangential_stiffness_at_load"),
            ("asperity_loads_at_gaps", "asperity_load_and_slope_at_gap"),
        ] {
            let (batch, one) = (named(batch), named(one));
            let read = batch.at(|is| matches!(is, In(1, _))).next().expect("an array");
            let outputs = |call: &Call| call.at(|is| is == MayOut(1)).collect::<Vec<_>>();
            for load in &loads {
                let (mut of_batch, mut of_one) = (batch.prepare(&model, 1), one.prepare(&model, 1));
                of_batch.places[read][0] = load.to_bits();
                of_one.words[1].bits = load.to_bits();
                batch.run(&of_batch);
                let told = one.run(&of_one);
                let (values, slopes) = (outputs(batch), outputs(one));
                let (value, context) = (of_batch.places[values[0]][0], (one.name, load));
                assert_eq!(Told::Number(value), told, "{context:?}");
                for slope in slopes {
                    assert_eq!(of_batch.places[values[1]][0], of_one.places[slope][0], "{context:?}");
                }
            }
        }
    }
}

/// Arrays of any length at odd addresses, and outputs in place of what is read, give the bits that each element gives alone.
#[test]
fn elements_of_a_batch_have_the_bits_that_they_have_alone() {
    let mut random = SplitMix(SEED ^ 1);
    let is_batch = |call: &&Call| call.is_batch() && call.at(|is| matches!(is, Text(_) | Names(_))).next().is_none();
    for model in models() {
        for call in CALLS.iter().filter(is_batch) {
            let read = call.at(|is| matches!(is, In(1, _))).next().expect("an array");
            let outputs: Vec<(usize, usize)> = call
                .at(|is| matches!(is, MayOut(_)))
                .map(|i| match call.arguments[i].1 {
                    MayOut(width) => (i, width),
                    _ => unreachable!(),
                })
                .collect();
            let answer = |loads: &[f64], odd: usize, in_place: Option<usize>| -> Vec<Vec<u64>> {
                let mut prepared = call.prepare(&model, loads.len());
                for (to, load) in prepared.places[read].iter_mut().zip(loads) {
                    *to = load.to_bits();
                }
                // The same memory, so many bytes further.
                let mut moved: Vec<Vec<u8>> = Vec::new();
                for (word, place) in
                    prepared.words.iter_mut().zip(&prepared.places).filter(|(_, place)| !place.is_empty())
                {
                    let bytes = std::iter::repeat_n(0, odd).chain(place.iter().flat_map(|word| word.to_ne_bytes()));
                    moved.push(bytes.collect());
                    word.pointer = moved.last_mut().expect("it").as_mut_ptr().wrapping_add(odd).cast();
                }
                if let Some(i) = in_place {
                    prepared.words[i].pointer = prepared.words[read].pointer;
                }
                call.run(&prepared);
                let count = |width: usize| width * loads.len();
                let written = |&(i, width): &(usize, usize)| {
                    let at: *const u64 = prepared.words[i].pointer.cast_const().cast();
                    // SAFETY: so many numbers lie there.
                    (0..count(width)).map(|k| unsafe { at.add(k).read_unaligned() }).collect()
                };
                outputs.iter().map(written).collect()
            };
            for n in (1..=9).chain([17, 135]) {
                let loads = mixed(&mut random, &model, n);
                let alone: Vec<Vec<Vec<u64>>> = loads.iter().map(|load| answer(&[*load], 0, None)).collect();
                let places =
                    [None].into_iter().chain(outputs.iter().filter(|(_, width)| *width == 1).map(|(i, _)| Some(*i)));
                for (odd, in_place) in places.flat_map(|place| [(0, place), (1, place), (8, place)]) {
                    let found = answer(&loads, odd, in_place);
                    for (o, (i, width)) in outputs.iter().enumerate() {
                        for k in 0..n {
                            let (here, there) = (&found[o][k * width..(k + 1) * width], &alone[k][o]);
                            let name = call.arguments[*i].0;
                            assert_eq!(
                                here, there,
                                "{}: {name} of load {:e}, {k} of {n}, {odd}, {in_place:?}",
                                call.name, loads[k]
                            );
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn a_text_is_cut_to_any_room_and_ends() {
    let model = Handle::new(&soonest_made());
    reset_message();
    for call in CALLS {
        let Some(room) = call.at(|is| is == Room).next() else { continue };
        let whole = call.prepare(&model, 1);
        let Told::Length(length) = call.run(&whole) else { panic!("{}", call.name) };
        let all: Vec<u8> = whole.places[room - 1].iter().flat_map(|word| word.to_ne_bytes()).collect();
        for size in [0, 1, 2, 7, length, length + 1, length + 9] {
            let mut prepared = call.prepare(&model, 1);
            prepared.words[room].bits = size as u64;
            assert_eq!(call.run(&prepared), Told::Length(length), "{}", call.name);
            let found: Vec<u8> = prepared.places[room - 1].iter().flat_map(|word| word.to_ne_bytes()).collect();
            let end = length.min(size.max(1) - 1);
            let ends = size == 0 || found[end] == 0;
            assert!(found[..end] == all[..end] && ends, "{}: {size} of {length}", call.name);
            assert!(found[size..].chunks(1).zip(size..).all(|(byte, at)| byte[0] == UNTOUCHED.to_ne_bytes()[at % 8]));
        }
    }
}

#[test]
fn any_number_stands_for_a_constant_or_for_none() {
    for status in [OK, NULL_POINTER, NOT_CONVERGED, 7, 255, -1, i32::MIN, i32::MAX] {
        // SAFETY: a constant string.
        assert!(!unsafe { CStr::from_ptr(asperity_status_string(status)) }.is_empty());
    }
    for warnings in [0, 1, 3, 512, 1024, u64::MAX] {
        // SAFETY: NULL asks for the length.
        assert!(unsafe { asperity_warnings_text(warnings, null_mut(), 16) } > 0);
    }
    for kind in [-1, 6, i32::MIN, i32::MAX] {
        assert!(asperity_name(kind, 0).is_null());
        // SAFETY: NULL asks for the length.
        assert_eq!(unsafe { asperity_describe(kind, c"Si".as_ptr(), null_mut(), 0) }, 0);
    }
    assert!((0..6).all(|kind| !asperity_name(kind, 0).is_null() && asperity_name(kind, usize::MAX).is_null()));
    let model = Handle::new(&soonest_made());
    for kind in [-1, 2, i32::MIN, i32::MAX] {
        // SAFETY: a model and a struct.
        assert_eq!(unsafe { asperity_table_of(model.0, kind, &mut asperity_table::empty()) }, INVALID_PARAMETER);
    }
}
