//! Each function of the C interface with its arguments: what the contract and the fuzzer call, and what holds of any call.

use super::TABLE_AT;
use crate::interface::*;
use std::ffi::{c_char, c_void, CStr};
use std::ptr::null_mut;
use std::sync::OnceLock;

/// What an argument is, with the value that it has in an ordinary call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Is {
    Model,
    /// One whose summits yield, without adhesion.
    YieldingModel,
    /// A model that the call changes; one that it frees.
    ChangedModel,
    FreedModel,
    Params,
    ChangedParams,
    Number(f64),
    /// A size, an index or a choice.
    Whole(u64),
    /// How many times there is room for what is written of each element.
    Times(u64),
    /// How many elements there are.
    Count,
    /// So many numbers for each element to read.
    In(usize, f64),
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
pub use Is::*;

/// A function, with its arguments in order.
pub struct Call {
    pub name: &'static str,
    pub needs: Needs,
    pub arguments: &'static [(&'static str, Is)],
    run: fn(&[Word]) -> Told,
}

/// What a call takes of the system, in its dearest form: `docs/dev/reliability.md`, `SECURITY.md` and `tests/c/stack.c` have it from here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needs {
    /// Free stack [KiB] of x86-64 Linux.
    pub stack: usize,
    pub allocates: bool,
    pub opens_files: bool,
}

const fn needs(stack: usize) -> Needs {
    Needs { stack, allocates: false, opens_files: false }
}

/// What answers one number, or tells what is there.
const ANSWER: Needs = needs(8);
/// The same where a list is made on the way.
const LIST: Needs = Needs { allocates: true, ..ANSWER };
/// What answers for many.
const BATCH: Needs = needs(32);
const SORTED: Needs = needs(64);
/// What integrates over the summits; what makes a model, or calibrates.
const EXACT: Needs = Needs { allocates: true, ..BATCH };
const MAKE: Needs = Needs { allocates: true, ..SORTED };
const READ: Needs = Needs { opens_files: true, ..ESTIMATE };
const ESTIMATE: Needs = Needs { allocates: true, ..needs(112) };

/// The bits of an argument.
#[derive(Clone, Copy, Debug)]
pub struct Word {
    pub pointer: *mut c_void,
    pub bits: u64,
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
pub enum Told {
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
    ($($function:ident[$needs:ident]($($argument:ident: $is:expr),*);)*) => {
        &[$(Call {
            name: stringify!($function),
            needs: $needs,
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
pub const STATE: usize = 43;

#[rustfmt::skip]
pub const CALLS: &[Call] = calls! {
    asperity_estimate_at_loads[ESTIMATE](surface: Text(SURFACE), length: Length, n: Count, load: In(1, 10.0), estimates: Struct(size_of::<asperity_estimate>()));
    asperity_estimate_text[ESTIMATE](surface: Text(SURFACE), length: Length, n: Count, load: In(1, 10.0), buffer: Buffer, buffer_length: Room);
    asperity_params_init[ANSWER](params: ChangedParams, struct_size: Whole(size_of::<asperity_params>() as u64));
    asperity_params_set_dimensionless[ANSWER](params: ChangedParams, alpha: Number(0.1), beta: Number(4.0), gamma: Number(1e-3), b_over_h: Number(1.0), poisson: Number(0.3));
    asperity_params_set_materials[ANSWER](params: ChangedParams, E1: Number(2e11), nu1: Number(0.3), E2: Number(1e11), nu2: Number(0.2));
    asperity_params_set_spectral_moments[ANSWER](params: ChangedParams, m0: Number(1e-16), m2: Number(1e-4), m4: Number(1e10), nominal_area: Number(1e-6));
    asperity_params_set_pair[LIST](params: ChangedParams, name: Text(c"Si/Si"));
    asperity_params_set_units[ANSWER](params: ChangedParams, length: Number(1e-3), force: Number(1.0));
    asperity_params_set_values[MAKE](params: ChangedParams, count: Count, names: Names(c"rms_slope"), values: In(1, 0.2));
    asperity_params_get_value[LIST](params: Params, name: Text(c"rms_slope"), value: Out(1));
    asperity_params_calibrate[MAKE](params: ChangedParams, load: Number(1.0), friction_coefficient: Number(0.3));
    asperity_params_calibrate_force[MAKE](params: ChangedParams, load: Number(1.0), friction_force: Number(0.3));
    asperity_params_set_text[ESTIMATE](params: ChangedParams, text: Text(c"rms_slope = 0.2"), length: Length);
    asperity_params_text[MAKE](params: Params, buffer: Buffer, length: Room);
    asperity_params_read[READ](params: ChangedParams, path: Text(c"hosts/surface.toml"));
    asperity_create[MAKE](params: Params, model: NewModel);
    asperity_unloaded[MAKE](model: YieldingModel, largest_load: Number(LOAD), unloaded: NewModel);
    asperity_set_params[MAKE](model: ChangedModel, params: Params);
    asperity_get_params[ANSWER](model: Model, params: Struct(size_of::<asperity_params>()));
    asperity_free[ANSWER](model: FreedModel);
    asperity_name[ANSWER](kind: Whole(1), index: Whole(0));
    asperity_describe[LIST](kind: Whole(1), name: Text(c"Si"), buffer: Buffer, length: Room);
    asperity_friction_at_load[ANSWER](model: Model, load: Number(LOAD));
    asperity_friction_force_at_load[ANSWER](model: Model, load: Number(LOAD));
    asperity_friction_at_loads[BATCH](model: Model, n: Count, load: In(1, LOAD), mu: MayOut(1), dmu_dload: MayOut(1));
    asperity_friction_force_at_loads[BATCH](model: Model, n: Count, load: In(1, LOAD), force: MayOut(1), dforce_dload: MayOut(1));
    asperity_friction_and_slope_at_load[ANSWER](model: Model, load: Number(LOAD), dmu_dload: MayOut(1));
    asperity_friction_force_and_slope_at_load[ANSWER](model: Model, load: Number(LOAD), dforce_dload: MayOut(1));
    asperity_friction_force_at_loads_of[SORTED](models: Models, models_length: Whole(1), n: Count, which: Which, load: In(1, LOAD), force: MayOut(1), dforce_dload: MayOut(1));
    asperity_tangential_stiffness_at_load[ANSWER](model: Model, load: Number(LOAD));
    asperity_tangential_stiffness_at_loads[BATCH](model: Model, n: Count, load: In(1, LOAD), stiffness: MayOut(1));
    asperity_tangential_at_load[EXACT](model: Model, load: Number(LOAD), displacement: Number(1e-3), force: MayOut(1), stiffness: MayOut(1));
    asperity_microslip_length[ANSWER](model: Model);
    asperity_microslip_step[BATCH](model: Model, load: Number(LOAD), increment: In(2, 1e-3), before: In(STATE, 0.0), after: MayOut(STATE), out: Struct(size_of::<asperity_microslip>()));
    asperity_microslip_steps[BATCH](model: Model, n: Count, load: In(1, LOAD), increment: In(2, 1e-3), before: In(STATE, 0.0), after: MayOut(STATE), force: MayOut(2), stiffness: MayOut(4));
    asperity_microslip_turn[ANSWER](state: Out(STATE), cosine: Number(1.0), sine: Number(0.5));
    asperity_load_and_slope_at_gap[ANSWER](model: Model, gap: Number(1e-2), dload_dgap: MayOut(1));
    asperity_loads_at_gaps[BATCH](model: Model, n: Count, gap: In(1, 1e-2), load: MayOut(1), dload_dgap: MayOut(1));
    asperity_state_at_load[EXACT](model: Model, load: Number(LOAD), state: Struct(size_of::<asperity_state>()));
    asperity_state_at_gap[EXACT](model: Model, gap: Number(1e-2), state: Struct(size_of::<asperity_state>()));
    asperity_summary_of[ANSWER](model: Model, summary: Struct(size_of::<asperity_summary>()));
    asperity_specimens_at_loads[EXACT](model: Model, specimens: Times(2), seed: Whole(1), n: Count, load: In(1, LOAD), found: Struct(size_of::<asperity_specimens>()));
    asperity_each_specimen_at_loads[EXACT](model: Model, sphere_radius: Number(0.0), first: Whole(0), specimens: Times(2), seed: Whole(1), n: Count, load: In(1, LOAD), friction_force: MayOut(2), tangential_stiffness: MayOut(2), normal_stiffness: MayOut(2), gap: MayOut(2), contacts: MayOut(2), pull_off_force: MayOut(2));
    asperity_check_loads[EXACT](model: Model, lightest: Number(1e-3), heaviest: Number(1e-2), warnings: Out(1));
    asperity_warnings_text[ANSWER](warnings: Whole(u64::MAX), buffer: Buffer, length: Room);
    asperity_last_error[ANSWER](buffer: Buffer, length: Room);
    asperity_status_string[ANSWER](status: Whole(5));
    asperity_abi_version[ANSWER]();
    asperity_version[ANSWER]();
    asperity_table_of[ANSWER](model: Model, kind: Whole(1), table: Struct(size_of::<asperity_table>()));
};

/// What memory holds that a call must leave as it is.
pub const UNTOUCHED: u64 = 0x5eed_5eed_5eed_5eed;
/// Room for a text [bytes].
pub const ROOM: usize = 1 << 13;

/// Arguments of a call with the memory that they point to.
#[derive(Debug)]
pub struct Prepared {
    pub words: Vec<Word>,
    pub places: Vec<Vec<u64>>,
    /// Pointers and names that arrays point to.
    _pointers: Vec<Box<[*const c_void]>>,
}

impl Call {
    /// An ordinary call of n elements.
    pub fn prepare(&self, model: &Handle, n: usize) -> Prepared {
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
                YieldingModel => {
                    static MADE: OnceLock<usize> = OnceLock::new();
                    let made = MADE.get_or_init(|| {
                        let contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC;
                        let elastic = asperity_params::dimensionless(0.6, 0.3, 0.0, 40.0);
                        let hardness = 0.1 * elastic.composite_modulus;
                        let mut own = null_mut();
                        // SAFETY: a place for a handle.
                        let status =
                            unsafe { asperity_create(&asperity_params { contact_law, hardness, ..elastic }, &mut own) };
                        assert_eq!(status, OK);
                        own.expose_provenance()
                    });
                    pointer = Some(std::ptr::with_exposed_provenance_mut(*made));
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
                Whole(whole) | Times(whole) => number(whole),
                Count => number(n as u64),
                In(width, value) => array(width, value),
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
    pub fn run(&self, prepared: &Prepared) -> Told {
        let (told, complaint) = flags::watch(|| std::hint::black_box(self.run)(&prepared.words));
        assert_eq!(complaint, None, "{}", self.name);
        told
    }

    pub fn at(&self, is: impl Fn(Is) -> bool) -> impl Iterator<Item = usize> {
        let found: Vec<usize> = (0..self.arguments.len()).filter(|&i| is(self.arguments[i].1)).collect();
        found.into_iter()
    }

    pub fn is_batch(&self) -> bool {
        self.at(|is| is == Count).next().is_some()
    }
}

/// Whether something is written there.
pub fn is_output(is: Is) -> bool {
    matches!(is, MayOut(_) | Out(_) | NewModel | Struct(_) | Buffer | ChangedParams)
}

fn word_of(bytes: &[u8]) -> u64 {
    u64::from_ne_bytes(bytes.try_into().expect("8 bytes"))
}

/// The surface whose model is soonest made.
pub fn soonest_made() -> asperity_params {
    asperity_params::dimensionless(0.6, 0.3, 2.0, 40.0)
}

pub fn free_what_was_made(call: &Call, prepared: &Prepared) {
    for i in call.at(|is| is == NewModel) {
        if prepared.places[i][0] != UNTOUCHED {
            // SAFETY: a model that the call made.
            unsafe { asperity_free(std::ptr::with_exposed_provenance_mut(prepared.places[i][0] as usize)) };
        }
    }
}

pub fn is_success(told: Told) -> bool {
    match told {
        Told::Status(status) => status == OK,
        Told::Number(bits) => f64::from_bits(bits).is_finite(),
        Told::Length(length) => length > 0,
        Told::String(at) => at != 0,
        Told::Version(version) => version == 1,
        Told::Nothing => true,
    }
}

/// The bits of a parameter that nothing has set.
const UNSET: u64 = 0x7ff8_0000_756e_7365;

/// What holds of any call of which so much was there before: a status that is known, with a message where it refuses; no
/// signalling NaN; outputs of what is refused as they were, parameters of what is taken finite.
pub fn check(call: &Call, prepared: &Prepared, before: &[Vec<u64>], told: Told, what: &str) {
    const KNOWN: [i32; 7] = [OK, NULL_POINTER, INVALID_PARAMETER, INVALID_LOAD, SEPARATED, OUT_OF_RANGE, NOT_CONVERGED];
    match told {
        Told::Status(status) => {
            assert!(KNOWN.contains(&status), "{what}");
            let has_message = !message().is_empty() && !message().starts_with("model is NULL");
            assert!(has_message == (status != OK) || status == NULL_POINTER, "{what}");
            // Batches fill all elements; without contact a step has forces of 0.
            let fills = call.is_batch() || status == SEPARATED;
            for output in call.at(|is| is_output(is) && !fills && status != OK) {
                assert!(prepared.places[output] == before[output], "{what}: yet written");
            }
            // Set first, they lack the physical inputs.
            let is_set = status == OK && call.name != "asperity_params_init";
            for output in call.at(|is| is == ChangedParams && is_set) {
                // What is not known of two materials stays unset.
                let is_known = |word: &u64| {
                    f64::from_bits(*word).is_finite() || call.name == "asperity_params_set_pair" && *word == UNSET
                };
                assert!(prepared.places[output][1..TABLE_AT].iter().all(is_known), "{what}: {prepared:?}");
            }
        }
        Told::Number(bits) => {
            assert!(!f64::from_bits(bits).is_nan() || bits >> 51 & 1 == 1, "{what}: a signalling NaN");
        }
        _ => {}
    }
}
