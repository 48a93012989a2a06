//! Every function of the C interface with every kind of pointer that its contract allows: valid, NULL, unaligned, to the
//! input itself, to memory without values, to shorter and longer structs, from two threads.
//!
//! Places are as long as a call may use, and no longer: `make miri` runs this in Miri, which knows what each pointer may
//! be used for. The surfaces are those whose models are soonest made, by instructions counted.

use crate::interface::*;
use std::alloc::{alloc, dealloc, Layout};
use std::ffi::{c_char, CStr};
use std::mem::size_of;
use std::ptr::{null, null_mut};

type BatchCall = unsafe extern "C" fn(*const asperity_model, usize, *const f64, *mut f64, *mut f64) -> i32;
type SlopeCall = unsafe extern "C" fn(*const asperity_model, f64, *mut f64) -> f64;

/// The laws: batch, and one contact with its slope.
const LAWS: [(BatchCall, SlopeCall); 3] = [
    (asperity_friction_at_loads, asperity_friction_and_slope_at_load),
    (asperity_friction_force_at_loads, asperity_friction_force_and_slope_at_load),
    (asperity_contact_radius_sum_at_loads, radius_sum_and_slope),
];
/// What memory holds that a call must leave as it is.
const BEFORE: u64 = 0x5eed_5eed_5eed_5eed;
/// Two blocks of vectors of four lanes, one of eight, and a rest.
const LONGEST: usize = 16 * 4 * 2 + 7;
/// alpha, beta, gamma and b/h of the surface whose model is soonest made.
const SOONEST_MADE: [f64; 4] = [1.0, 0.1, 0.01, 40.0];

/// One contact by the call that answers for one, with the slope of a batch of one.
unsafe extern "C" fn radius_sum_and_slope(model: *const asperity_model, load: f64, slope: *mut f64) -> f64 {
    // SAFETY: those of the caller.
    unsafe {
        asperity_contact_radius_sum_at_loads(model, 1, &load, null_mut(), slope);
        asperity_contact_radius_sum_at_load(model, load)
    }
}

/// Memory of a caller, of so many bytes, at an address that is a multiple of 8 or odd. It holds nothing until it is filled.
struct Place {
    start: *mut u8,
    layout: Layout,
    odd: usize,
}

impl Place {
    fn aligned(size: usize) -> Self {
        Self::at(size, 0)
    }

    fn at(size: usize, odd: usize) -> Self {
        let layout = Layout::from_size_align(size + odd, 8).expect("a size");
        // SAFETY: the size is not zero.
        Self { start: unsafe { alloc(layout) }, layout, odd }
    }

    /// With these words.
    fn of(words: impl IntoIterator<Item = u64, IntoIter: ExactSizeIterator>, odd: usize) -> Self {
        let words = words.into_iter();
        let place = Self::at(8 * words.len(), odd);
        for (i, word) in words.enumerate() {
            // SAFETY: as many words.
            unsafe { place.pointer::<u64>().add(i).write_unaligned(word) };
        }
        place
    }

    /// Numbers that a call only writes to: memory without values.
    fn numbers(n: usize, odd: usize) -> Self {
        Self::at(8 * n.max(1), odd)
    }

    /// A struct that is to be filled: its size, and memory.
    fn sized(size: u64, words: usize) -> Self {
        Self::of((0..words).map(|i| if i == 0 { size } else { BEFORE }), 0)
    }

    fn pointer<T>(&self) -> *mut T {
        // SAFETY: within the memory.
        unsafe { self.start.add(self.odd).cast() }
    }

    /// A word that has a value.
    fn word(&self, i: usize) -> u64 {
        // SAFETY: within the memory.
        unsafe { self.pointer::<u64>().add(i).read_unaligned() }
    }

    fn words(&self, count: usize) -> Vec<u64> {
        (0..count).map(|i| self.word(i)).collect()
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        // SAFETY: allocated so.
        unsafe { dealloc(self.start, self.layout) }
    }
}

fn soonest_made() -> asperity_params {
    let [alpha, beta, gamma, b_over_h] = SOONEST_MADE;
    asperity_params::dimensionless(alpha, beta, gamma, b_over_h)
}

/// Loads in the table, and some for the exact evaluation or none.
fn loads(model: &Handle, n: usize) -> Vec<f64> {
    let s = model.summary();
    let (nearest, farthest) = (s.min_table_load - s.pull_off_load, s.max_table_load - s.pull_off_load);
    let at = |i: usize| s.pull_off_load + nearest * (farthest / nearest).powf((i % 37) as f64 / 37.0);
    (0..n)
        .map(|i| match i {
            18 => 2.0 * s.max_table_load,
            9 => 2.0 * s.pull_off_load,
            11 => f64::from_bits(0x7ff0_0000_0000_0001),
            13 => 0.0,
            _ => at(i),
        })
        .collect()
}

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|x| x.to_bits()).collect()
}

#[test]
#[cfg_attr(miri, ignore = "reads text, which takes half a minute there")]
fn every_function_of_the_header_is_called_here() {
    let header = include_str!("../../include/asperity.h");
    let here = include_str!("pointers.rs");
    let mut functions = 0;
    for line in header.lines().filter(|line| !line.starts_with([' ', '#', '/', '*', '}'])) {
        let Some((before, _)) = line.split_once('(') else { continue };
        let name = before.rsplit([' ', '*']).next().expect("a name");
        functions += 1;
        let is_whole = |(at, _): (usize, &str)| !here[at + name.len()..].starts_with(['_', ' ']);
        assert!(here.match_indices(name).any(is_whole), "{name} is not called");
    }
    assert!(functions >= 27, "{functions} functions found in the header");
}

#[test]
fn constants_are_strings_that_end() {
    // SAFETY: constants.
    unsafe {
        assert_eq!(asperity_abi_version(), 1);
        assert_eq!(CStr::from_ptr(asperity_version()).to_str(), Ok(env!("CARGO_PKG_VERSION")));
        for status in [OK, NULL_POINTER, NOT_CONVERGED, 255, -1, i32::MIN, i32::MAX] {
            assert!(!CStr::from_ptr(asperity_status_string(status)).to_bytes().is_empty());
        }
        for warning in [0, 1, 2, 4, 8, 16, 32, 64, 128, 256, 3, u64::MAX] {
            assert!(!CStr::from_ptr(asperity_warning_string(warning)).to_bytes().is_empty());
        }
        let text = Place::aligned(16);
        assert!(asperity_warnings_text(u64::MAX, text.pointer(), 16) > 1000);
        assert!(asperity_warnings_text(u64::MAX, null_mut(), 16) > 1000);
        assert_eq!(CStr::from_ptr(asperity_material_name(0)), c"Si");
        assert_eq!(CStr::from_ptr(asperity_pair_name(0)), c"Si/Si");
        assert_eq!(CStr::from_ptr(asperity_interface_name(0)), c"MoS2 film in dry air");
        assert!(asperity_material_name(usize::MAX).is_null() && asperity_pair_name(usize::MAX).is_null());
        assert!(asperity_interface_name(usize::MAX).is_null());
    }
}

#[test]
fn a_message_fits_any_buffer() {
    reset_message();
    // SAFETY: NULL asks for the length.
    let whole = unsafe { asperity_last_error(null_mut(), 0) };
    assert_eq!(whole, "model is NULL: pass a valid pointer".len());
    // SAFETY: NULL is not written to, whatever the length.
    assert_eq!(unsafe { asperity_last_error(null_mut(), usize::MAX) }, whole);
    for room in [0, 1, 2, whole, whole + 1, whole + 9] {
        let buffer = Place::at(room.max(1), 1);
        // SAFETY: so much room.
        assert_eq!(unsafe { asperity_last_error(buffer.pointer::<c_char>(), room) }, whole);
        if room > 0 {
            // SAFETY: it ends within the buffer.
            let text = unsafe { CStr::from_ptr(buffer.pointer()) };
            assert_eq!(text.to_bytes(), &message().as_bytes()[..whole.min(room - 1)]);
        }
    }
}

#[test]
fn materials_are_written_no_further_than_they_may() {
    for words in 2..=13 {
        let [material, pair, interface] = [0; 3].map(|_| Place::sized(8 * words, 13));
        // SAFETY: memory of the size that is told, and names that end.
        unsafe {
            assert_eq!(asperity_material(c"steel".as_ptr(), material.pointer()), OK);
            assert_eq!(asperity_pair(c"Si/Si".as_ptr(), pair.pointer()), OK);
            assert_eq!(asperity_interface(c"graphite layers".as_ptr(), interface.pointer()), OK);
        }
        for (place, length) in [(&material, 11), (&pair, 8), (&interface, 9)] {
            let written = (words as usize).min(length);
            assert!((written..13).all(|i| place.word(i) == BEFORE) && place.word(1) != BEFORE, "{words} words");
        }
    }
}

#[test]
fn parameters_are_set_in_memory_without_values() {
    let whole = size_of::<asperity_params>();
    let place = Place::aligned(whole);
    let params = place.pointer::<asperity_params>();
    // SAFETY: memory of the size that is told.
    unsafe {
        assert_eq!(asperity_params_init(params, whole), OK);
        assert_eq!(place.word(0), whole as u64);
        assert_eq!(asperity_params_set_dimensionless(params, 0.1, 4.0, 1e-3, 1.0, 0.3), OK);
        assert_eq!(asperity_params_set_materials(params, 2e11, 0.3, f64::INFINITY, 0.2), OK);
        assert_eq!(asperity_params_set_spectral_moments(params, 1e-16, 1e-4, 1e10, 1e-6), OK);
        assert_eq!(asperity_params_set_mccool_summits(params, 1e-16, 1e-4, 1e10, 1e-6), OK);
        assert_eq!(asperity_params_set_skew(params, 0.5), OK);
        assert_eq!(asperity_params_set_elastic_plastic(params, 1e9), OK);
        assert_eq!(asperity_params_set_pair(params, c"steel/steel".as_ptr()), OK);
        assert_eq!(asperity_params_set_interface(params, c"MoS2 film in dry air".as_ptr()), OK);
        // Names that may lie anywhere, and a number that may.
        let (name, mut value) = (asperity_params_name(0), 0.0);
        assert_eq!(asperity_params_set_value(params, name, 3e11), OK);
        assert_eq!(asperity_params_set_values(params, 2, [name; 2].as_ptr(), [1e11, 2e11].as_ptr()), OK);
        assert_eq!((asperity_params_get_value(params, name, &mut value), value), (OK, 2e11));
        // A text that ends where it says, at any address, and a file that there is not.
        let text = b"hardness = 1e9";
        let bytes = Place::at(text.len(), 1);
        bytes.pointer::<u8>().copy_from_nonoverlapping(text.as_ptr(), text.len());
        assert_eq!(asperity_params_set_text(params, bytes.pointer(), text.len()), OK);
        // Loads may lie anywhere, too.
        let load = Place::at(8, 1);
        load.pointer::<f64>().write_unaligned(10.0);
        let surface = b"pair = \"Si/Si\"\nheight_std = 5e-9\nsummit_radius = 1e-6\nasperity_count = 1e5\n";
        let surface_bytes = Place::at(surface.len(), 1);
        surface_bytes.pointer::<u8>().copy_from_nonoverlapping(surface.as_ptr(), surface.len());
        let mut found: asperity_estimate = std::mem::zeroed();
        found.struct_size = size_of::<asperity_estimate>() as u64;
        let (at, load) = (surface_bytes.pointer(), load.pointer());
        assert_eq!(asperity_estimate_at_loads(at, surface.len(), 1, load, &mut found), OK);
        let written = asperity_estimate_text(at, surface.len(), 1, load, null_mut(), 0);
        let buffer = Place::at(written + 1, 1);
        assert_eq!(asperity_estimate_text(at, surface.len(), 1, load, buffer.pointer(), written + 1), written);
        assert_eq!(CStr::from_ptr(buffer.pointer()).count_bytes(), written);
        assert_eq!(asperity_params_set_estimate(params, at, surface.len()), OK);
        assert_eq!(asperity_params_set_units(params, 1e-3, 1.0), OK);
        let written = asperity_params_text(params, null_mut(), 0);
        let buffer = Place::at(written + 1, 1);
        assert_eq!(asperity_params_text(params, buffer.pointer(), written + 1), written);
        assert_eq!(CStr::from_ptr(buffer.pointer()).count_bytes(), written);
        // Refused: the memory stays as it is.
        let before = place.words(whole / 8);
        assert_eq!(asperity_params_set_dimensionless(params, -1.0, 4.0, 1e-3, 1.0, 0.3), INVALID_PARAMETER);
        assert_eq!(asperity_params_set_materials(params, 2e11, 0.7, 1e11, 0.2), INVALID_PARAMETER);
        assert_eq!(asperity_params_set_spectral_moments(params, 1.0, 1.0, 1.0, 1.0), INVALID_PARAMETER);
        assert_eq!(asperity_params_set_mccool_summits(params, 1.0, 1.0, 1.0, 1.0), INVALID_PARAMETER);
        assert_eq!(asperity_params_set_skew(params, -9.0), INVALID_PARAMETER);
        assert_eq!(asperity_params_set_elastic_plastic(params, 0.0), INVALID_PARAMETER);
        assert_eq!(asperity_params_calibrate(params, 1.0, -0.3), INVALID_PARAMETER);
        assert_eq!(asperity_params_calibrate_force(params, 1.0, -0.3), INVALID_PARAMETER);
        assert_eq!(asperity_params_set_interface(params, c"steel/steel dry".as_ptr()), INVALID_PARAMETER);
        assert_eq!(asperity_params_set_text(params, bytes.pointer(), 11), INVALID_PARAMETER); // "hardness = "
        assert_eq!(asperity_params_set_units(params, 0.0, 1.0), INVALID_PARAMETER);
        assert_eq!(place.words(whole / 8), before);
    }
    // A size that is none: no more than it is read, and nothing is written.
    for size in [0, 8, whole as u64 - 8, whole as u64 + 4, whole as u64 + 8, u64::MAX] {
        let place = Place::of([size], 0);
        let params = place.pointer::<asperity_params>();
        let mut model = null_mut();
        // SAFETY: the size is refused.
        unsafe {
            assert_eq!(asperity_params_init(params, size as usize), INVALID_PARAMETER);
            assert_eq!(asperity_params_set_skew(params, 0.0), INVALID_PARAMETER);
            assert_eq!(asperity_create(params, &mut model), INVALID_PARAMETER);
        }
        assert!(model.is_null() && place.word(0) == size);
    }
}

#[test]
fn null_is_refused_or_skipped() {
    let mut params = soonest_made();
    let size = size_of::<asperity_params>();
    let (mut state, mut summary) = (asperity_state::empty(), asperity_summary::empty());
    let mut slope = 7.0;
    let untouched: *mut asperity_model = std::ptr::without_provenance_mut(8);
    let mut model = untouched;
    // SAFETY: NULL is allowed or refused.
    unsafe {
        asperity_free(null_mut());
        for refused in [
            asperity_params_init(null_mut(), size),
            asperity_params_set_dimensionless(null_mut(), 0.1, 4.0, 1e-3, 1.0, 0.3),
            asperity_params_set_materials(null_mut(), 1.0, 0.3, 1.0, 0.3),
            asperity_params_set_spectral_moments(null_mut(), 1e-16, 1e-4, 1e10, 1e-6),
            asperity_params_set_mccool_summits(null_mut(), 1e-16, 1e-4, 1e10, 1e-6),
            asperity_params_set_skew(null_mut(), 0.0),
            asperity_params_set_elastic_plastic(null_mut(), 1.0),
            asperity_params_calibrate(null_mut(), 1.0, 1.0),
            asperity_params_calibrate_force(null_mut(), 1.0, 1.0),
            asperity_params_set_value(null_mut(), c"skew".as_ptr(), 0.0),
            asperity_params_set_value(&mut params, null(), 0.0),
            asperity_params_set_values(&mut params, 1, null(), &slope),
            asperity_params_set_values(&mut params, 1, &c"hardness".as_ptr(), null()),
            asperity_params_get_value(null(), c"skew".as_ptr(), &mut slope),
            asperity_params_get_value(&params, null(), &mut slope),
            asperity_params_get_value(&params, c"skew".as_ptr(), null_mut()),
            asperity_params_set_text(null_mut(), c"".as_ptr(), 0),
            asperity_params_set_text(&mut params, null(), 0),
            asperity_params_set_estimate(null_mut(), c"".as_ptr(), 0),
            asperity_params_set_estimate(&mut params, null(), 0),
            asperity_estimate_at_loads(null(), 0, 0, null(), null_mut()),
            asperity_estimate_at_loads(c"".as_ptr(), 0, 1, null(), null_mut()),
            asperity_params_read(null_mut(), c"".as_ptr()),
            asperity_params_read(&mut params, null()),
            asperity_params_set_units(null_mut(), 1.0, 1.0),
            asperity_params_set_pair(null_mut(), c"Si/Si".as_ptr()),
            asperity_params_set_pair(&mut params, null()),
            asperity_params_set_interface(null_mut(), c"graphite layers".as_ptr()),
            asperity_params_set_interface(&mut params, null()),
            asperity_material(c"Si".as_ptr(), null_mut()),
            asperity_material(null(), null_mut()),
            asperity_pair(c"Si/Si".as_ptr(), null_mut()),
            asperity_pair(null(), null_mut()),
            asperity_interface(c"graphite layers".as_ptr(), null_mut()),
            asperity_interface(null(), null_mut()),
            asperity_create(null(), &mut model),
            asperity_create(&params, null_mut()),
            asperity_set_params(null_mut(), &params),
            asperity_get_params(null(), &mut params),
            asperity_state_at_load(null(), 1.0, &mut state),
            asperity_state_at_gap(null(), 1.0, &mut state),
            asperity_check_loads(null(), 1.0, 2.0, &mut 0),
            asperity_warning_loads(null(), 16, &mut 0.0, &mut 0.0),
            asperity_summits_at_overlaps(null(), 1, &1.0, null(), &mut slope, null_mut(), null_mut()),
            asperity_summary_of(null(), &mut summary),
            asperity_table_of(null(), null_mut()),
            asperity_tangential_stiffness_at_loads(null(), 1, &1.0, &mut slope),
            asperity_loads_at_gaps(null(), 1, &1.0, &mut slope, null_mut()),
            asperity_friction_at_pressures(null(), 1, &1.0, 1.0, &mut slope, null_mut()),
            asperity_shear_stresses_at_pressures(null(), 1, &1.0, 1.0, &mut slope, null_mut()),
            asperity_slip_forces(null(), 1, &1.0, &1.0, 1.0, &mut slope, null_mut(), null_mut()),
            asperity_friction_force_at_loads_of(null(), 1, 1, &0, &1.0, &mut slope, null_mut()),
            asperity_load_table_of(null(), null_mut()),
            asperity_tangential_at_load(null(), 1.0, 1.0, &mut slope, null_mut()),
            asperity_microslip_step(null(), 1.0, &0.0, &0.0, null_mut(), &mut asperity_microslip::empty()),
            asperity_microslip_steps(null(), 1, &1.0, &0.0, &0.0, null_mut(), null_mut(), null_mut()),
            asperity_microslip_turn(null_mut(), 1.0, 0.0),
            asperity_sensitivities_at_load(null(), 1.0, &mut asperity_sensitivities::empty()),
        ] {
            assert_eq!(refused, NULL_POINTER);
        }
        assert!(asperity_friction_at_load(null(), 1.0).is_nan());
        assert!(asperity_friction_force_at_load(null(), 1.0).is_nan());
        assert!(asperity_tangential_stiffness_at_load(null(), 1.0).is_nan());
        assert_eq!(asperity_microslip_length(null()), 0);
        assert!(asperity_load_at_gap(null(), 1.0).is_nan());
        for (batch, one) in LAWS {
            assert_eq!(batch(null(), 1, &1.0, &mut slope, null_mut()), NULL_POINTER);
            assert!(slope == 7.0 && one(null(), 1.0, null_mut()).is_nan());
        }
        assert!(asperity_friction_at_pressure(null(), 1.0, 1.0, null_mut()).is_nan());
        assert!(asperity_shear_stress_at_pressure(null(), 1.0, 1.0, null_mut()).is_nan());
        assert!(asperity_slip_force(null(), 1.0, 1.0, 1.0, &mut slope, null_mut()).is_nan() && slope.is_nan());
    }
    assert_eq!(model, untouched);

    // A table of heights without one of its columns, or longer than any; of the columns nothing is read then.
    let one = Place::of(bits(&[1.0]), 0);
    for ([table_height, table_density], table_length, status) in [
        ([null(), one.pointer()], 3, NULL_POINTER),
        ([one.pointer(), null()], 2, INVALID_PARAMETER),
        ([one.pointer::<f64>().cast_const(); 2], u64::MAX, OUT_OF_RANGE),
    ] {
        let params = asperity_params {
            height_distribution: ASPERITY_HEIGHTS_TABULATED,
            table_height,
            table_density,
            table_length,
            ..params
        };
        // SAFETY: refused before a column is read.
        assert_eq!(unsafe { asperity_create(&params, &mut model) }, status);
        assert_eq!(model, untouched);
    }
}

/// Calibrating makes a model.
#[test]
fn parameters_are_calibrated() {
    for by_force in [false, true] {
        let mut params = soonest_made();
        let before = params.slip_stress_1;
        // SAFETY: initialised parameters.
        let status = unsafe {
            match by_force {
                false => asperity_params_calibrate(&mut params, 1e-3, 0.1),
                true => asperity_params_calibrate_force(&mut params, 1e-3, 1e-4),
            }
        };
        assert_eq!(status, OK, "{}", message());
        assert!(params.slip_stress_1 > 0.0 && params.slip_stress_1 != before, "{params:?}");
        assert_eq!((params.calibration_load, params.calibration_friction_force), (1e-3, 1e-4));
    }
}

/// One model, since making it takes the most time by far.
#[test]
fn a_model_answers_to_every_place_and_from_every_thread() {
    let handle = Handle::new(&soonest_made());
    one_contact(&handle);
    batches(&handle);
    stiffnesses(&handle);
    summits(&handle);
    structs(&handle);
    the_table_is_the_law(&handle);
    threads_share_it(&handle);
}

/// Slopes go to memory without values, at odd addresses, or nowhere.
fn one_contact(handle: &Handle) {
    for load in loads(handle, 14) {
        for (i, (batch, one)) in LAWS.into_iter().enumerate() {
            let (value, slope) = (Place::numbers(1, 1), Place::numbers(1, 1));
            // SAFETY: the model lives, the places have room.
            unsafe {
                let plain =
                    [asperity_friction_at_load, asperity_friction_force_at_load, asperity_contact_radius_sum_at_load]
                        [i](handle.0, load);
                batch(handle.0, 1, &load, value.pointer(), null_mut());
                let both = [one(handle.0, load, slope.pointer()), one(handle.0, load, null_mut())];
                assert_eq!(both.map(f64::to_bits), [plain.to_bits(); 2]);
                assert_eq!(value.word(0), plain.to_bits());
                batch(handle.0, 1, &load, null_mut(), value.pointer());
                assert_eq!(value.word(0), slope.word(0));
            }
        }
    }
    let (load, area) = (1e-3, 2.0);
    let (one, other) = (Place::numbers(1, 1), Place::numbers(1, 1));
    // SAFETY: the model lives, the places have room, or NULL.
    unsafe {
        for call in [asperity_friction_at_pressure, asperity_shear_stress_at_pressure] {
            assert_eq!(call(handle.0, load / area, area, one.pointer()), call(handle.0, load / area, area, null_mut()));
            assert!(f64::from_bits(one.word(0)).is_finite());
            assert!(call(handle.0, load, 0.0, one.pointer()).is_nan() && f64::from_bits(one.word(0)).is_nan());
        }
        let force = asperity_slip_force(handle.0, load, 0.5, 1.0, one.pointer(), other.pointer());
        assert!(force > 0.0 && [&one, &other].iter().all(|place| f64::from_bits(place.word(0)) > 0.0));
        assert_eq!(asperity_slip_force(handle.0, load, 0.5, 1.0, null_mut(), null_mut()), force);
        assert!(asperity_slip_force(handle.0, load, 0.5, 0.0, one.pointer(), other.pointer()).is_nan());
        let (found, value) = (f64::from_bits, load);
        assert_eq!(asperity_friction_at_pressures(handle.0, 1, &value, 1.0, one.pointer(), other.pointer()), OK);
        assert_eq!(found(one.word(0)), asperity_friction_at_pressure(handle.0, load, 1.0, null_mut()));
        assert_eq!(asperity_shear_stresses_at_pressures(handle.0, 1, &value, 1.0, one.pointer(), null_mut()), OK);
        assert_eq!(found(one.word(0)), asperity_shear_stress_at_pressure(handle.0, load, 1.0, null_mut()));
        let third = Place::numbers(1, 1);
        let (sliding, slopes) = (one.pointer(), [other.pointer(), third.pointer()]);
        assert_eq!(asperity_slip_forces(handle.0, 1, &value, &0.5, 1.0, sliding, slopes[0], slopes[1]), OK);
        assert_eq!(found(one.word(0)), force);
        let models = [handle.0.cast_const()];
        let (which, force) = (0_u32, asperity_friction_force_at_load(handle.0, load));
        let forces = |to, slope| asperity_friction_force_at_loads_of(models.as_ptr(), 1, 1, &which, &value, to, slope);
        assert_eq!(forces(one.pointer(), other.pointer()), OK);
        assert_eq!((found(one.word(0)), forces(null_mut(), null_mut())), (force, OK));
        let separation = 0.0;
        let pressed = asperity_load_and_slope_at_gap(handle.0, separation, one.pointer());
        assert!(pressed > 0.0 && found(one.word(0)) < 0.0);
        assert_eq!(asperity_load_at_gap(handle.0, separation), pressed);
        assert_eq!(asperity_loads_at_gaps(handle.0, 1, &separation, other.pointer(), third.pointer()), OK);
        assert_eq!((found(other.word(0)), third.word(0)), (pressed, one.word(0)));
        let mut table: asperity_table = std::mem::zeroed();
        table.struct_size = size_of::<asperity_table>() as u64;
        assert_eq!(asperity_load_table_of(handle.0, &mut table), OK);
        assert!(table.row_count > 0 && !table.rows.is_null());
        let heaviest = table.pull_off_load + f64::from_bits((table.base + table.row_count) << table.shift);
        assert_eq!(table.heavy_force, asperity_load_at_gap(handle.0, -heaviest));
        assert!(table.heavy_force > pressed);
        // The rows are by minus the gap.
        assert_eq!(
            (table.zero_force, table.zero_slope),
            (f64::from_bits(pressed.to_bits()), -f64::from_bits(third.word(0)))
        );
        let stiffness = asperity_tangential_stiffness_at_load(handle.0, load);
        assert_eq!(asperity_tangential_stiffness_at_loads(handle.0, 1, &load, one.pointer()), OK);
        assert_eq!(one.word(0), stiffness.to_bits());
        assert_eq!(asperity_tangential_at_load(handle.0, load, 1e-9, one.pointer(), other.pointer()), OK);
        assert!([&one, &other].iter().all(|place| f64::from_bits(place.word(0)) > 0.0));
    }
}

/// Stiffnesses of every number of loads up to two vectors, and some more, to a place of their own, in place, or nowhere.
fn stiffnesses(handle: &Handle) {
    let all = loads(handle, LONGEST);
    // SAFETY: the model lives.
    let expected = all.iter().map(|&load| unsafe { asperity_tangential_stiffness_at_load(handle.0, load) });
    let expected = bits(&expected.collect::<Vec<_>>());
    for n in (0..=4).chain([7, 8, 9, 17, LONGEST]) {
        let status = if n > 9 { SEPARATED } else { OK };
        for odd in [0, 1] {
            let (load, value) = (Place::of(bits(&all[..n.max(1)]), odd), Place::numbers(n, odd));
            // SAFETY: n elements each; the input may be the output.
            unsafe {
                let stiffnesses = |to| asperity_tangential_stiffness_at_loads(handle.0, n, load.pointer(), to);
                assert_eq!(stiffnesses(value.pointer()), status);
                assert_eq!(stiffnesses(null_mut()), status);
                assert_eq!(value.words(n), expected[..n]);
                assert_eq!(stiffnesses(load.pointer()), status);
            }
            assert_eq!(load.words(n), expected[..n]);
        }
    }
}

/// Arrays of every length up to two vectors, and some longer; each output to a place of its own, in place, or nowhere.
fn batches(handle: &Handle) {
    let all = loads(handle, LONGEST);
    for (batch, one) in LAWS {
        let expected: Vec<(u64, u64)> = all
            .iter()
            .map(|&load| {
                let mut slope = 0.0;
                // SAFETY: the model lives.
                let value = unsafe { one(handle.0, load, &mut slope) };
                (value.to_bits(), slope.to_bits())
            })
            .collect();
        // SAFETY: nothing is read or written.
        assert_eq!(unsafe { batch(handle.0, 0, null(), null_mut(), null_mut()) }, OK);
        // SAFETY: NULL is refused.
        assert_eq!(unsafe { batch(handle.0, 1, null(), null_mut(), null_mut()) }, NULL_POINTER);
        for n in (0..=4).chain([7, 8, 9, 17, LONGEST]) {
            let status = if n > 9 { SEPARATED } else { OK };
            for odd in [0, 1] {
                let load = Place::of(bits(&all[..n.max(1)]), odd);
                let (value, slope) = (Place::numbers(n, odd), Place::numbers(n, odd));
                // SAFETY: n elements each.
                let told = unsafe { batch(handle.0, n, load.pointer(), value.pointer(), slope.pointer()) };
                assert_eq!(told, status, "{}", message());
                for (i, expected) in expected[..n].iter().enumerate() {
                    assert_eq!((value.word(i), slope.word(i)), *expected, "element {i} of {n}");
                }
                // SAFETY: n elements each; the input may be an output.
                unsafe {
                    assert_eq!(batch(handle.0, n, load.pointer(), null_mut(), slope.pointer()), status);
                    assert_eq!(batch(handle.0, n, load.pointer(), null_mut(), null_mut()), status);
                    assert_eq!(batch(handle.0, n, load.pointer(), load.pointer(), null_mut()), status);
                }
                assert_eq!(load.words(n), value.words(n));
                let load = Place::of(bits(&all[..n.max(1)]), odd);
                // SAFETY: as before.
                unsafe { assert_eq!(batch(handle.0, n, load.pointer(), value.pointer(), load.pointer()), status) };
                assert_eq!(load.words(n), slope.words(n));
            }
        }
    }
}

/// Single summits: outputs to places of their own, in place, or nowhere; heights told or not.
fn summits(handle: &Handle) {
    let sigma = asperity_params::of(handle).height_std;
    let overlaps = [-4.0, 0.0, 0.1, 3.0].map(|u| u * sigma);
    let n = overlaps.len();
    for odd in [0, 1] {
        let overlap = Place::of(bits(&overlaps), odd);
        let [load, force, radius] = [0, 1, 2].map(|_| Place::numbers(n, odd));
        let at = |height: *const f64, load: *mut f64, force: *mut f64, radius: *mut f64| {
            // SAFETY: n elements each, or NULL; the input may be an output.
            unsafe { asperity_summits_at_overlaps(handle.0, n, overlap.pointer(), height, load, force, radius) }
        };
        assert_eq!(at(null(), load.pointer(), force.pointer(), radius.pointer()), OK);
        let expected = load.words(n);
        assert!(f64::from_bits(expected[3]) > 0.0 && f64::from_bits(radius.word(3)) > 0.0);
        assert_eq!(f64::from_bits(force.word(0)), 0.0);
        assert_eq!(at(null(), null_mut(), null_mut(), null_mut()), OK);
        // Radii are equal here: heights change nothing.
        assert_eq!(at(overlap.pointer(), load.pointer(), null_mut(), null_mut()), OK);
        assert_eq!(load.words(n), expected);
        assert_eq!(at(null(), overlap.pointer(), null_mut(), null_mut()), OK);
        assert_eq!(overlap.words(n), expected);
    }
    let (odd_one, load) = (Place::of(bits(&[1.0, f64::NAN, 1e300]), 0), Place::numbers(3, 0));
    // SAFETY: three elements each; nothing is read of none; NULL is refused.
    unsafe {
        let at = asperity_summits_at_overlaps;
        assert_eq!(
            at(handle.0, 3, odd_one.pointer(), null(), load.pointer(), null_mut(), null_mut()),
            INVALID_PARAMETER
        );
        assert_eq!(message(), "element 1: overlap = NaN: must be finite");
        assert!(f64::from_bits(load.word(0)) > 0.0 && [1, 2].iter().all(|&i| f64::from_bits(load.word(i)).is_nan()));
        assert_eq!(at(handle.0, 0, null(), null(), null_mut(), null_mut(), null_mut()), OK);
        assert_eq!(at(handle.0, 1, null(), null(), null_mut(), null_mut(), null_mut()), NULL_POINTER);
    }
}

/// Structs of sizes that a caller may have: no more than that is written, and none of what the library does not know.
fn structs(handle: &Handle) {
    let at_load = |place: &Place| {
        // SAFETY: room for the size that is told.
        unsafe { asperity_state_at_load(handle.0, 1e-3, place.pointer()) }
    };
    let at_separation = |place: &Place| {
        // SAFETY: as before.
        unsafe { asperity_state_at_gap(handle.0, 0.3, place.pointer()) }
    };
    // SAFETY: as before.
    let summary_of = |place: &Place| unsafe { asperity_summary_of(handle.0, place.pointer()) };
    // SAFETY: as before.
    let table_of = |place: &Place| unsafe { asperity_table_of(handle.0, place.pointer()) };
    // SAFETY: as before.
    let sensitivities = |place: &Place| unsafe { asperity_sensitivities_at_load(handle.0, 1e-3, place.pointer()) };
    type Fill<'a> = &'a dyn Fn(&Place) -> i32;
    let fills: [(Fill, usize); 5] = [
        (&at_load, size_of::<asperity_state>()),
        (&at_separation, size_of::<asperity_state>()),
        (&summary_of, size_of::<asperity_summary>()),
        (&table_of, size_of::<asperity_table>()),
        (&sensitivities, size_of::<asperity_sensitivities>()),
    ];
    for (fill, whole) in fills {
        let answers: Vec<Place> = [16, whole, whole + 24]
            .into_iter()
            .map(|size| {
                let place = Place::sized(size as u64, size / 8);
                assert_eq!(fill(&place), OK, "{}", message());
                assert_eq!(place.word(0), size as u64);
                place
            })
            .collect();
        assert_ne!(answers[0].word(1), BEFORE);
        for i in 1..whole / 8 {
            assert_eq!(answers[1].word(i), answers[2].word(i));
        }
        assert_eq!(answers[0].word(1), answers[1].word(1));
        assert_eq!(answers[2].words(whole / 8 + 3)[whole / 8..], [BEFORE; 3]);
        for size in [0, 8, 12, 17, u64::MAX] {
            let place = Place::sized(size, 1);
            assert_eq!(fill(&place), INVALID_PARAMETER);
            assert_eq!(place.word(0), size);
        }
    }
    for load in [f64::NAN, -1e9, 1e300] {
        let place = Place::sized(16, 2);
        // SAFETY: room for the size that is told.
        assert_ne!(unsafe { asperity_state_at_load(handle.0, load, place.pointer()) }, OK);
        assert_eq!(place.words(2), [16, BEFORE]);
    }
    // SAFETY: NULL is refused.
    unsafe {
        assert_eq!(asperity_state_at_load(handle.0, 1.0, null_mut()), NULL_POINTER);
        assert_eq!(asperity_state_at_gap(handle.0, 1.0, null_mut()), NULL_POINTER);
        assert_eq!(asperity_check_loads(handle.0, 1.0, 2.0, null_mut()), NULL_POINTER);
        let warnings = Place::aligned(size_of::<u64>());
        assert_eq!(asperity_check_loads(handle.0, 1.0, 2.0, warnings.pointer()), OK);
        assert_eq!(asperity_warning_loads(handle.0, 16, null_mut(), &mut 0.0), NULL_POINTER);
        let loads = [8, 8].map(Place::aligned);
        assert_eq!(asperity_warning_loads(handle.0, 16, loads[0].pointer(), loads[1].pointer()), OK);
        assert_eq!(asperity_summary_of(handle.0, null_mut()), NULL_POINTER);
        assert_eq!(asperity_table_of(handle.0, null_mut()), NULL_POINTER);
        assert_eq!(asperity_sensitivities_at_load(handle.0, 1.0, null_mut()), NULL_POINTER);
        assert_eq!(asperity_get_params(handle.0, null_mut()), NULL_POINTER);
    }
    // Parameters into memory that has a size and no other value, and none where the size is none.
    let words = size_of::<asperity_params>() / 8;
    let (whole, short) = (Place::sized(8 * words as u64, words), Place::sized(8, 1));
    // SAFETY: room for the sizes that are told.
    unsafe {
        assert_eq!(asperity_get_params(handle.0, whole.pointer()), OK);
        assert_eq!(asperity_get_params(handle.0, short.pointer()), INVALID_PARAMETER);
    }
    assert_eq!(whole.word(1), asperity_params::of(handle).composite_modulus.to_bits());
}

/// The rows are read through the pointer that the view has, while the model is called.
fn the_table_is_the_law(handle: &Handle) {
    let place = Place::sized(size_of::<asperity_table>() as u64, size_of::<asperity_table>() / 8);
    // SAFETY: room for the view.
    let view = unsafe {
        assert_eq!(asperity_table_of(handle.0, place.pointer()), OK);
        place.pointer::<asperity_table>().read()
    };
    for row in 0..view.row_count {
        let load = view.pull_off_load + f64::from_bits((view.base + row) << view.shift);
        // SAFETY: the model lives, and the view within it.
        let (force, first) =
            unsafe { (asperity_friction_force_at_load(handle.0, load), *view.rows.add(8 * row as usize)) };
        let last = 8 * row as usize + 7;
        // SAFETY: a row has eight numbers.
        assert!(unsafe { *view.rows.add(last) }.is_finite());
        assert!(first.is_nan() || (force / first - 1.0).abs() < 1e-3, "row {row}: {force:e}, {first:e}");
    }
}

/// Calls on one model at once, each thread with its own places and its own last message.
fn threads_share_it(handle: &Handle) {
    let expected = {
        let mut forces = loads(handle, 11);
        let at = forces.as_mut_ptr();
        // SAFETY: as many elements; in place.
        unsafe { asperity_friction_force_at_loads(handle.0, forces.len(), at, at, null_mut()) };
        bits(&forces)
    };
    std::thread::scope(|scope| {
        for thread in 0..2_usize {
            let expected = &expected;
            scope.spawn(move || {
                assert_eq!(message(), "");
                let mut forces = loads(handle, 11);
                let (n, at) = (forces.len(), forces.as_mut_ptr());
                let mut state = asperity_state::empty();
                // SAFETY: the model lives, the places are this thread's.
                unsafe {
                    assert_eq!(asperity_friction_force_at_loads(handle.0, n, at, at, null_mut()), SEPARATED);
                    assert!(message().starts_with("element 9: load = "), "{}", message());
                    let (load, status) = if thread == 0 { (1e-3, OK) } else { (f64::NAN, INVALID_LOAD) };
                    assert_eq!(asperity_state_at_load(handle.0, load, &mut state), status);
                }
                assert_eq!(message().starts_with("element 9"), thread == 0);
                assert_eq!(bits(&forces), *expected);
                let table = asperity_params::of(handle);
                assert_eq!(table.height_distribution, 0);
            });
        }
    });
}

/// The first exact state of a model makes a table that stays with it.
#[test]
fn threads_that_ask_for_the_first_state_at_once_get_the_same() {
    let state_of = |handle: &Handle| {
        let mut state = asperity_state::empty();
        // SAFETY: the model lives.
        assert_eq!(unsafe { asperity_state_at_load(handle.0, 1e-3, &mut state) }, OK);
        bits(&[state.gap, state.friction_force, state.real_area, state.contacting, state.friction_scatter])
    };
    for _ in 0..if cfg!(miri) { 1 } else { 20 } {
        let handle = Handle::new(&soonest_made());
        let found = std::thread::scope(|scope| {
            [(); 4].map(|()| scope.spawn(|| state_of(&handle))).map(|thread| thread.join().expect("a state"))
        });
        assert!(found.iter().all(|found| *found == state_of(&handle)));
    }
}

/// A table of heights goes in through the caller's pointers and comes out through the model's own, which may be given back.
#[test]
fn a_table_of_heights_is_copied_and_given_back() {
    let mut params = asperity_params::dimensionless(0.6, 0.3, 2.0, 40.0);
    let (height, density) = (Place::of(bits(&[0.0, 1.0, 2.0]), 0), Place::of(bits(&[0.0, 0.0, 1.0]), 0));
    params.height_distribution = ASPERITY_HEIGHTS_TABULATED;
    (params.table_height, params.table_density) = (height.pointer(), density.pointer());
    params.table_length = 3;
    let handle = Handle::new(&params);
    drop((height, density));

    let size = size_of::<asperity_params>() as u64;
    let mut own = asperity_params::of(&handle);
    // SAFETY: the model's own columns.
    assert_eq!(unsafe { [own.table_height.add(2).read(), own.table_density.add(2).read()] }, [2.0, 1.0]);

    // Refused: the model and its columns are as before.
    let pull_off = handle.summary().pull_off_load;
    let refused = asperity_params { attraction: 2, ..own };
    // SAFETY: the parameters and their columns live.
    assert_eq!(unsafe { asperity_set_params(handle.0, &refused) }, INVALID_PARAMETER);
    assert_eq!(handle.summary().pull_off_load, pull_off);
    // Taken, from its own columns, which then are gone.
    own.hardness = 1.0;
    // SAFETY: the parameters live, and their columns until the model is changed.
    assert_eq!(unsafe { asperity_set_params(handle.0, &own) }, OK, "{}", message());
    assert_eq!(handle.summary().pull_off_load, pull_off);
    let again = asperity_params::of(&handle);
    // SAFETY: the model's own columns.
    assert_eq!(unsafe { std::slice::from_raw_parts(again.table_height, 3) }, [0.0, 1.0, 2.0]);
    assert_eq!((again.struct_size, again.hardness), (size, 1.0));
    // A handle kept in memory without a value before, and heights that need no table.
    let place = Place::aligned(size_of::<*mut asperity_model>());
    // SAFETY: memory for a handle.
    unsafe {
        assert_eq!(asperity_create(&soonest_made(), place.pointer()), OK, "{}", message());
        asperity_free(place.pointer::<*mut asperity_model>().read());
    }
}

/// Letters with nothing behind them: no NUL, and no memory that may be read.
#[cfg(all(unix, not(miri)))]
struct Letters {
    pages: *mut u8,
    page: usize,
    count: usize,
}

#[cfg(all(unix, not(miri)))]
impl Letters {
    fn new(count: usize) -> Self {
        // SAFETY: two pages of our own, of which the second is closed.
        unsafe {
            let page = usize::try_from(libc::sysconf(libc::_SC_PAGESIZE)).expect("a page has a size");
            let (open, own) = (libc::PROT_READ | libc::PROT_WRITE, libc::MAP_PRIVATE | libc::MAP_ANON);
            let pages = libc::mmap(null_mut(), 2 * page, open, own, -1, 0);
            assert_ne!(pages, libc::MAP_FAILED);
            let pages = pages.cast::<u8>();
            pages.add(page - count).write_bytes(b'x', count);
            assert_eq!(libc::mprotect(pages.add(page).cast(), page, libc::PROT_NONE), 0);
            Self { pages, page, count }
        }
    }

    fn pointer(&self) -> *const c_char {
        // SAFETY: within the first page.
        unsafe { self.pages.add(self.page - self.count).cast() }
    }
}

#[cfg(all(unix, not(miri)))]
impl Drop for Letters {
    fn drop(&mut self) {
        // SAFETY: mapped so.
        unsafe { libc::munmap(self.pages.cast(), 2 * self.page) };
    }
}

/// In Miri nothing is behind them as they are allocated so.
#[cfg(any(not(unix), miri))]
struct Letters(Place);

#[cfg(any(not(unix), miri))]
impl Letters {
    fn new(count: usize) -> Self {
        let place = Place::aligned(count);
        // SAFETY: as many bytes.
        unsafe { place.pointer::<u8>().write_bytes(b'x', count) };
        Self(place)
    }

    fn pointer(&self) -> *const c_char {
        self.0.pointer()
    }
}

/// The header's promise to a caller whose field of letters may have no NUL; more letters than that are not told of either.
#[test]
fn no_more_than_64_bytes_of_a_name_are_read() {
    let mut params = asperity_params::unset();
    let told = "x".repeat(64);
    // First the longer ones, to be told of a limit that is too long before it is the end of the process.
    for letters in [Letters::new(70), Letters::new(64)] {
        let name = letters.pointer();
        let mut value = 0.0;
        let calls: [&mut dyn FnMut() -> i32; 7] = [
            // SAFETY: initialised parameters, and names of 64 bytes; what is refused writes nothing.
            &mut || unsafe { asperity_material(name, null_mut()) },
            &mut || unsafe { asperity_pair(name, null_mut()) },
            &mut || unsafe { asperity_interface(name, null_mut()) },
            &mut || unsafe { asperity_params_get_value(&soonest_made(), name, &mut value) },
            &mut || unsafe { asperity_params_set_pair(&mut soonest_made(), name) },
            &mut || unsafe { asperity_params_set_value(&mut soonest_made(), name, 1.0) },
            &mut || unsafe { asperity_params_set_values(&mut params, 1, &name, &1.0) },
        ];
        for (i, call) in calls.into_iter().enumerate() {
            assert_eq!(call(), INVALID_PARAMETER, "{i}: {}", message());
            let others = message().strip_prefix(&told).map(|others| others.starts_with('x'));
            assert_eq!(others, Some(false), "{i}: {}", message());
        }
    }
}
