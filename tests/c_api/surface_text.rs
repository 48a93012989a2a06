//! A text makes the parameters that its keys say, and what is wrong with it is named with line and key; written, it reads back bit
//! for bit.

use crate::common::assert_near;
use crate::common::processor_time::{processor_time, LONGEST_CALL};
use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::ffi::{c_char, CStr, CString};
use std::path::Path;
use std::ptr::{null, null_mut};

/// The normal scores of a table.
const SCORES: [f64; 13] = [-3.0, -2.5, -2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0];
/// A text of heights and slopes at scores, and more of the roughness.
fn at_scores(height: &[f64], slope: &[f64], more: &str) -> String {
    format!("nominal_area = 1\n[roughness]\nheights_at_scores = {height:?}\nslopes_at_scores = {slope:?}\n{more}")
}

/// Hard carbon on hard carbon.
const CARBON: &str = "nominal_area = 1e-6
work_of_adhesion = 0.06
adhesion_range = 0.25e-9
burgers_vector = 0.25e-9
hardness = 51e9

[materials]
E1 = 493e9
nu1 = 0.25
E2 = 493e9
nu2 = 0.25

[roughness]
m0 = 9.604e-17
m2 = 1.8e-3
m4 = 3.3736e11
";
/// As long as a text may be.
const MIB: usize = 1 << 20;

fn set(params: &mut asperity_params, text: &[u8]) -> i32 {
    // SAFETY: an initialised struct, and so many bytes.
    unsafe { asperity_params_set_text(params, text.as_ptr().cast(), text.len()) }
}

#[track_caller]
fn surface(text: &str) -> asperity_params {
    let mut params = asperity_params::unset();
    assert_eq!(set(&mut params, text.as_bytes()), OK, "{}\n{text}", message());
    params
}

/// Refuses a text, and leaves the parameters as they were.
#[track_caller]
fn refused(text: impl AsRef<[u8]>, says: &str) {
    let mut params = asperity_params { hardness: 1e9, ..asperity_params::unset() };
    let before = bytes(&params).to_vec();
    let status = set(&mut params, text.as_ref());
    assert!([INVALID_PARAMETER, OUT_OF_RANGE].contains(&status), "{status}: {says}");
    assert_eq!(bytes(&params), before, "{says}: changed");
    assert!(message().starts_with(says), "{}\nnot\n{says}", message());
}

/// The parameters as a text.
fn written(params: &asperity_params) -> String {
    // SAFETY: NULL asks for the length; then the buffer has it.
    unsafe {
        let length = asperity_params_text(params, null_mut(), 0);
        let mut buffer = vec![0_u8; length + 1];
        assert_eq!(asperity_params_text(params, buffer.as_mut_ptr().cast(), buffer.len()), length);
        assert_eq!(buffer.pop(), Some(0));
        String::from_utf8(buffer).expect("a text")
    }
}

/// The same as other parameters, each bit of each number; a table of the same numbers.
#[track_caller]
fn assert_same(params: &asperity_params, other: &asperity_params, what: &str) {
    let table = |params: &asperity_params| -> Vec<u64> {
        let columns = [params.table_height, params.table_density];
        // SAFETY: as many as it says.
        let numbers = |column| unsafe { std::slice::from_raw_parts(column, params.table_length as usize) };
        columns.into_iter().filter(|column| !column.is_null()).flat_map(numbers).map(|x: &f64| x.to_bits()).collect()
    };
    assert_eq!(table(params), table(other), "{what}");
    let without = |params| asperity_params { table_height: null(), table_density: null(), ..params };
    assert_eq!(bytes(&without(*params)), bytes(&without(*other)), "{what}\n{params:?}\n{other:?}");
}

#[test]
fn materials_and_moments_are_those_of_the_setters() {
    let mut expected = asperity_params::unset();
    (expected.work_of_adhesion, expected.hardness) = (0.06, 51e9);
    (expected.adhesion_range, expected.burgers_vector) = (0.25e-9, 0.25e-9);
    // SAFETY: an initialised struct.
    unsafe {
        assert_eq!(asperity_params_set_materials(&mut expected, 493e9, 0.25, 493e9, 0.25), OK);
        assert_eq!(asperity_params_set_spectral_moments(&mut expected, 9.604e-17, 1.8e-3, 3.3736e11, 1e-6), OK);
    }
    // A text that is whole has its strength too, of other materials here.
    let found = surface(CARBON);
    (expected.slip_stress_1, expected.slip_stress_2) = (found.slip_stress_1, found.slip_stress_2);
    (expected.pressure_coefficient, expected.calibration_error) = (found.pressure_coefficient, 1.0);
    assert!(found.slip_stress_1 > found.slip_stress_2 && found.slip_stress_2 > 0.3 * found.slip_stress_1, "{found:?}");
    assert_same(&found, &expected, "carbon");
    // A byte order mark, the ends of lines of Windows, comments, whole numbers with underscores, tables in braces, and no order.
    assert_same(&surface(&format!("\u{feff}{}", CARBON.replace('\n', " # of carbon\r\n"))), &expected, "Windows");
    assert_same(&surface(&CARBON.replace("493e9", "493_000_000_000")), &expected, "whole numbers");
    let mut lines: Vec<_> = CARBON.split("\n\n").flat_map(str::lines).take(5).collect();
    lines.reverse();
    let braces = "materials = { E2 = 493e9, nu2 = 0.25, E1 = 493e9, nu1 = 0.25 }\nroughness = {m0=9.604e-17,m4=3.3736e11,m2=1.8e-3}\n";
    assert_same(&surface(&format!("{braces}{}", lines.join("\n"))), &expected, "braces");
    // What a text does not give stays, the caller's table too.
    let table = expected.table(&[0.0, 1.0, 2.0], &[0.0, 1.0, 0.0]);
    let mut params = table;
    assert_eq!(set(&mut params, b"hardness = 1e9"), OK);
    assert_eq!(bytes(&params), bytes(&asperity_params { hardness: 1e9, ..table }));
    // A table that is not there is no failure if other heights are chosen.
    for (table_height, table_density, table_length) in [
        (null(), table.table_density, 3),
        (table.table_height, null(), 3),
        (table.table_height, table.table_density, 2),
    ] {
        reset_message();
        let before = message();
        let mut params = asperity_params { table_height, table_density, table_length, ..table };
        assert_eq!(set(&mut params, b"heights = \"gaussian\""), OK);
        assert_eq!(message(), before);
    }
    let mut params = expected;
    assert_eq!(set(&mut params, b"hardness = 1e9\nslip_onset = 'whole'"), OK);
    assert_same(&params, &asperity_params { hardness: 1e9, slip_onset: ASPERITY_SLIP_WHOLE, ..expected }, "others");
    assert_eq!(set(&mut params, b""), OK);
}

#[test]
fn names_of_materials_bring_what_is_known_of_them() {
    let mut expected = asperity_params::unset();
    // SAFETY: an initialised struct, and a name that ends.
    assert_eq!(unsafe { asperity_params_set_pair(&mut expected, c"Si/Si".as_ptr()) }, OK);
    assert_same(&surface("pair = \"Si/Si\""), &expected, "a pair");
    assert_same(&surface("[materials]\nfirst = \"Si\"\nsecond = \"Si\""), &expected, "two names");
    // What is given beside them counts.
    let own = asperity_params { work_of_adhesion: 0.1, ..expected };
    assert_same(&surface("work_of_adhesion = 0.1\npair = \"Si/Si\""), &own, "its own adhesion");
    assert_eq!(surface("pair = \"Si/Au\"").work_of_adhesion, 0.05, "what is usual, where none is known");
    assert!(surface("work_of_adhesion = 0\npair = \"Si/Au\"").hardness > 1e8);
    // Moduli of one's own replace those of a pair, all or some.
    let mut stiff = expected;
    // SAFETY: an initialised struct.
    let set_stiff = |stiff: &mut _| unsafe { asperity_params_set_materials(stiff, 493e9, 0.25, 160e9, 0.22) };
    assert_eq!(set_stiff(&mut stiff), OK);
    for own in ["E1 = 493e9\nnu1 = 0.25", "E1 = 493e9\nnu1 = 0.25\nE2 = 160e9\nnu2 = 0.22"] {
        assert_same(&surface(&format!("pair = \"Si/Si\"\n[materials]\n{own}\n")), &stiff, own);
    }
    // A name for one body, numbers for the other, which is rigid.
    let mut expected = asperity_params::unset();
    // SAFETY: an initialised struct.
    let status = unsafe { asperity_params_set_materials(&mut expected, 160e9, 0.22, f64::INFINITY, 0.3) };
    assert_eq!(status, OK);
    assert_same(&surface("[materials]\nfirst = \"Si\"\nE2 = inf\nnu2 = 0.3"), &expected, "a rigid body");
}

#[test]
fn parameters_of_roughness_are_moments() {
    let (area, pi) = (1e-6, std::f64::consts::PI);
    let with = |roughness: &str| surface(&format!("nominal_area = {area}\n{roughness}"));
    let by_moments = |m0: f64, m2: f64, m4: f64| {
        let mut params = asperity_params::unset();
        // SAFETY: an initialised struct.
        assert_eq!(unsafe { asperity_params_set_spectral_moments(&mut params, m0, m2, m4, area) }, OK);
        params
    };
    let near = |roughness: &str, [m0, m2, m4]: [f64; 3]| {
        let (found, expected) = (with(roughness), by_moments(m0, m2, m4));
        for (found, expected) in [
            (found.height_std, expected.height_std),
            (found.summit_radius, expected.summit_radius),
            (found.asperity_count, expected.asperity_count),
            (found.summit_mean_height, expected.summit_mean_height),
            (found.rms_slope, expected.rms_slope),
        ] {
            assert_near(found, expected, 1e-13, roughness);
        }
        found
    };
    let (rq, slope, density, curvature) = (5e-9_f64, 0.08_f64, 2e13_f64, 2.6e6_f64);
    let ra = rq / (pi / 2.0).sqrt();
    let by_density = |rq: f64, slope: f64, density: f64| {
        let m2 = slope * slope / 2.0;
        [rq * rq, m2, 6.0 * pi * 3.0_f64.sqrt() * m2 * density]
    };
    let by_curvature = [rq * rq, slope * slope / 2.0, 9.0 * pi / 64.0 * curvature * curvature];
    near("[roughness]\nSq = 5e-9\nSdq = 0.08\nSds = 2e13", by_density(rq, slope, density));
    near("[roughness]\nSq = 5e-9\nSdq = 0.08\nSsc = 2.6e6", by_curvature);
    near(&format!("[roughness]\nRa = {ra}\nSdq = 0.08\nSsc = 2.6e6"), by_curvature);
    near(&format!("[roughness]\nRa = {ra}\nm2 = 0.0032\nm4 = 3e12"), [rq * rq, 0.0032, 3e12]);
    // Height and slope are enough; a bandwidth may be known.
    let of_bandwidth = |m2: f64, bandwidth: f64| [rq * rq, m2, bandwidth * m2 * m2 / (rq * rq)];
    let unknown = |m2: f64| of_bandwidth(m2, 0.0);
    near("[roughness]\nSq = 5e-9\nSdq = 0.08", unknown(0.0032));
    near(&format!("[roughness]\nRa = {ra}\nSdq = 0.08"), unknown(0.0032));
    near("[roughness]\nm0 = 25e-18\nm2 = 0.0032", unknown(0.0032));
    near("bandwidth = 5.0\n[roughness]\nSq = 5e-9\nSdq = 0.08", of_bandwidth(0.0032, 5.0));
    near("[roughness]\nRq = 5e-9\nRdq = 0.06", unknown(0.0036));
    let by_width = |width: f64| rq * rq * (2.0 * pi / width).powi(2);
    near("bandwidth = 5.0\n[roughness]\nRq = 5e-9\nRSm = 400e-9", of_bandwidth(by_width(400e-9), 5.0));
    near(&format!("[roughness]\nRa = {ra}\nRSm = 400e-9"), unknown(by_width(400e-9)));
    // Of a density beside the curvature McCool's summits are as many, and the asperities of moments are not.
    let both = "[roughness]\nSq = 5e-9\nSdq = 0.08\nSsc = 2.6e6\nSds = 1e13";
    assert_eq!(with(&format!("{both}\nsummits = \"mccool\"")).asperity_count, 1e13 * area);
    near(both, by_curvature);
    // Two rough surfaces: mean squares add.
    let (one, other) = (by_density(4e-9, 0.06, 2e13), by_density(3e-9, 0.08, 1e13));
    let sum = std::array::from_fn(|i| one[i] + other[i]);
    near("[roughness]\nSq = [4e-9, 3e-9]\nSdq = [0.06, 0.08]\nSds = [2e13, 1e13]", sum);
    near("[roughness]\nm0 = [1e-17, 2e-17]\nm2 = [1e-3, 2e-3]\nm4 = [1e12, 3e12]", [3e-17, 3e-3, 4e12]);
    let two = 0.8e-6_f64.hypot(0.4e-6);
    let (m0, wave_number) = (pi / 2.0 * two * two, 2.0 * pi / 80e-6);
    near("[roughness]\nRa = [0.8e-6, 0.4e-6]\nRSm = [80e-6, 80e-6]", [m0, m0 * wave_number * wave_number, 0.0]);
    // Heights and radii beside them.
    for (roughness, nearness) in [
        ("Sq = 5e-9\nSdq = 0.08\nSsk = 0\nSku = 3", 1e-2),
        ("Sq = 5e-9\nSdq = 0.08\nSsk = 0.1\nSku = 3.02", 0.1),
        ("Spq = 5e-9\nSvq = 5e-9\nSmq = 0.7\nSdq = 0.08", 1e-2),
        (&format!("heights_at_scores = {:?}\nSdq = 0.08", SCORES.map(|g| 5e-9 * g)), 1e-2),
        (&format!("heights_at_scores = {:?}\nSdq = 0.08\nSdq_top = 0.08", SCORES.map(|g| 5e-9 * g)), 1e-2),
        (&format!("heights_at_scores = {:?}\nslopes_at_scores = {:?}", SCORES.map(|g| 5e-9 * g), [0.08; 13]), 1e-2),
    ] {
        let (found, gaussian) =
            (with(&format!("[roughness]\n{roughness}")), with("[roughness]\nSq = 5e-9\nSdq = 0.08"));
        assert_eq!((found.height_distribution, found.table_length), (ASPERITY_HEIGHTS_AT_SCORES, 13), "{roughness}");
        for (found, expected) in [
            (found.height_std, gaussian.height_std),
            (found.summit_radius, gaussian.summit_radius),
            (found.asperity_count, gaussian.asperity_count),
            (found.summit_mean_height, gaussian.summit_mean_height),
        ] {
            assert_near(found, expected, nearness, roughness);
        }
    }
    // A lay makes fewer and blunter asperities, whichever way it is given.
    let plain = with("[roughness]\nRq = 5e-9\nRdq = 0.08");
    for lay in ["lay = 3", "Rdq_along = 0.0266666666666666666", "Rdq_along = 0.24"] {
        let along = with(&format!("[roughness]\nRq = 5e-9\nRdq = 0.08\n{lay}"));
        let factor = 1.0 + 0.17 * (0.5 * (3.0 + 1.0 / 3.0_f64)).ln();
        let slope =
            if lay.ends_with("24") { (0.5_f64 * (1.0 + 9.0)).sqrt() } else { (0.5_f64 * (1.0 + 1.0 / 9.0)).sqrt() };
        assert_near(along.rms_slope, plain.rms_slope * slope, 1e-9, lay);
        let factors = [
            along.asperity_count / plain.asperity_count / (slope * slope),
            along.summit_radius / plain.summit_radius * (slope * slope),
        ];
        assert_near(factors[0], 1.0 / factor, 1e-9, lay);
        assert_near(factors[1], factor * factor, 1e-9, lay);
    }
    let moments = "[roughness]\nm0 = 4e-18\nm2 = 2e-3\nm4 = 8e12";
    // McCool (1987): all radii are 3 pi^(1/2)/(8 m4^(1/2)).
    let mccool = with(&format!("{moments}\nsummits = \"mccool\""));
    assert_near(mccool.summit_radius, 3.0 * pi.sqrt() / (8.0 * 8e12_f64.sqrt()), 1e-15, "McCool's summits");
    assert_eq!((mccool.radius_amplitude, mccool.bandwidth), (0.0, 8.0));
    assert_same(&with(&format!("{moments}\nsummits = \"moments\"")), &by_moments(4e-18, 2e-3, 8e12), "asperities");
    assert_same(&with(moments), &by_moments(4e-18, 2e-3, 8e12), "asperities by default");
    // Summits per area.
    assert_eq!(surface("summit_density = 2e12\nnominal_area = 1e-6").asperity_count, 2e6);
}

#[test]
fn words_and_numbers_choose() {
    for (text, law, onset, attraction) in [
        ("contact_law = \"elastic-plastic\"\nattraction = false", 1, 0, 0),
        ("slip_onset = \"whole\"\nattraction = true", 0, 1, 1),
        ("contact_law = 1\nslip_onset = 1.0\nattraction = 0", 1, 1, 0),
    ] {
        let params = surface(text);
        assert_eq!((params.contact_law, params.slip_onset, params.attraction), (law, onset, attraction), "{text}");
    }
    let heights = |text: &str| {
        let params = surface(text);
        (params.height_distribution, params.weibull_shape, params.skew, params.kurtosis)
    };
    assert_eq!(heights("heights = \"weibull\"\nweibull_shape = 5"), (ASPERITY_HEIGHTS_WEIBULL, 5.0, 0.0, 3.0));
    assert_eq!(heights("weibull_shape = 5"), heights("height_distribution = \"weibull\"\nweibull_shape = 5"));
    assert_eq!(heights("skew = 0.1\nkurtosis = 3.5"), (ASPERITY_HEIGHTS_JOHNSON, 3.602, 0.1, 3.5));
    assert_eq!(heights("heights = \"johnson\"\nskew = 0.1"), (ASPERITY_HEIGHTS_JOHNSON, 3.602, 0.1, 3.0));
    let (skew, value) = (c"skew".as_ptr(), -0.5);
    let mut expected = asperity_params::unset();
    // SAFETY: an initialised struct, and a name that ends.
    assert_eq!(unsafe { asperity_params_set_values(&mut expected, 1, &skew, &value) }, OK);
    assert_eq!(expected.height_distribution, ASPERITY_HEIGHTS_WEIBULL);
    assert_same(&surface("skew = -0.5"), &expected, "a skew alone");
    assert_same(&surface("heights = \"weibull\"\nskew = -0.5"), &expected, "a skew of Weibull heights");
    let table = surface("table_height = [0, 1, 2.5]\ntable_density = [\n  0.0,  # lowest\n  1,\n  0.5,\n]");
    assert_eq!((table.height_distribution, table.table_length), (ASPERITY_HEIGHTS_TABULATED, 3));
    // SAFETY: three numbers each.
    let columns = [table.table_height, table.table_density].map(|at| unsafe { std::slice::from_raw_parts(at, 3) });
    assert_eq!(columns, [[0.0, 1.0, 2.5], [0.0, 1.0, 0.5]]);
    // A text of something else leaves it as it is.
    let mut harder = table;
    assert_eq!(set(&mut harder, b"hardness = 1e9"), OK);
    assert_same(&harder, &asperity_params { hardness: 1e9, ..table }, "a table, and a hardness");
    // The same table is kept once, another beside it.
    let again = surface("table_density = [0, 1, 0.5]\ntable_height = [0, 1, 2.5]");
    assert_eq!((again.table_height, again.table_density), (table.table_height, table.table_density));
    assert_ne!(surface("table_height = [0, 1, 3]\ntable_density = [0, 1, 0.5]").table_height, table.table_height);
}

#[test]
fn one_measured_point_sets_the_strength_and_is_kept() {
    for measured in ["calibration_friction_coefficient = 0.4", "calibration_friction_force = 4e-4"] {
        let params = surface(&format!("calibration_load = 1e-3\n{measured}\ncalibration_error = 0.1\n{CARBON}"));
        assert_eq!((params.calibration_load, params.calibration_error), (1e-3, 0.1));
        assert_near(params.calibration_friction_force, 4e-4, 1e-15, measured);
        let mut state = asperity_state::empty();
        let model = Handle::new(&params);
        // SAFETY: a model, and a struct of its size.
        assert_eq!(unsafe { asperity_state_at_load(model.0, 1e-3, &mut state) }, OK);
        assert_near(state.friction_force, 4e-4, 1e-12, measured);
    }
    let film = surface(&format!("interface = \"KCl film on iron in vacuum\"\n{CARBON}"));
    let mut expected = surface(CARBON);
    let strength = film.slip_stress_1;
    assert!(strength > 0.0 && strength == film.slip_stress_2 && strength != expected.slip_stress_1);
    assert_eq!(set(&mut expected, b"interface = \"KCl film on iron in vacuum\""), OK);
    assert_same(&film, &expected, "an interface");
    // SAFETY: an initialised struct.
    assert_eq!(unsafe { asperity_params_calibrate(&mut expected, 1e-3, 0.4) }, OK);
    let point =
        "calibration_load = 1e-3\ncalibration_friction_coefficient = 0.4\ninterface = \"KCl film on iron in vacuum\"\n";
    assert_same(&surface(&format!("{point}{CARBON}")), &expected, "a point on an interface");
}

/// Honing leaves plateaus, of which Ra says nothing: until another roughness is given.
#[test]
fn a_process_that_leaves_plateaus_is_known_not_to_be_gaussian() {
    let text = |rough: &str| format!("pair = \"steel/steel\"\nnominal_area = 4e-4\n[roughness]\n{rough}");
    let mut params = asperity_params::unset();
    let honed = "Ra = 0.3e-6\nprocess = \"honed\"\n";
    for (rough, taken) in [
        ("Ra = 0.3e-6\nprocess = \"ground\"\n", 0),
        (honed, 1),
        ("Spq = 0.1e-6\nSvq = 0.6e-6\nSmq = 0.7\nSdq = 0.1\n", 0),
        (honed, 1),
        ("Sq = 0.4e-6\nSdq = 0.1\n", 0),
    ] {
        assert_eq!(set(&mut params, text(rough).as_bytes()), OK, "{rough}: {}", message());
        assert_eq!(params.taken_as_gaussian, taken, "{rough}");
    }
    let said = text(honed).replacen("nominal", "taken_as_gaussian = false\nnominal", 1);
    assert_eq!((set(&mut params, said.as_bytes()), params.taken_as_gaussian), (OK, 0));
}

/// A joint of two lapped faces, at the line of what is wrong with its waves; metal that yields on them has no adhesion of its pair.
#[test]
fn waves_are_given_whole_or_refused_at_their_line() {
    let joint = |waves: &str| {
        format!("pair = \"steel/steel\"\nnominal_area = 4e-4\n{waves}\n[roughness]\nRa = 1e-6\nRdq = 0.1\n")
    };
    let good = "waviness_height = 1e-6\nwaviness_width = 4e-3\nwaviness_shape = \"hills\"";
    let found = surface(&joint(good));
    assert_eq!((found.waviness_height, found.waviness_width, found.waviness_shape), (1e-6, 4e-3, 2));
    assert_eq!(found.work_of_adhesion, 0.0);
    let mut params = asperity_params::unset();
    for (from, to, told) in [
        ("\"hills\"", "\"waves\"", "line 5: waviness_shape = \"waves\": must be "),
        ("waviness_shape = \"hills\"", "", "measure the waves along two directions"),
        ("1e-6", "1", "line 3: waviness_height = 1: must be at most 30 height_std"),
        ("1e-6", "-1e-6", "line 3: waviness_height = -1e-6: must be "),
        ("4e-3", "4", "line 2: nominal_area = 0.0004: must be at least waviness_width^2"),
        ("4e-3", "4e-6", "line 4: waviness_width = "),
        ("waviness_width = 4e-3", "", "waviness_width = 0"),
        (
            "waviness_width = 4e-3",
            "waviness_width = 4e-3\nwaviness_width = 4e-3",
            "line 5: waviness_width: given twice",
        ),
        ("waviness_shape", "work_of_adhesion = 0.05\nwaviness_shape", "line 5: work_of_adhesion = 0.05: must be 0"),
    ] {
        let text = joint(&good.replacen(from, to, 1));
        assert_ne!(set(&mut params, text.as_bytes()), OK, "{text}");
        assert!(message().contains(told), "{}, not {told}", message());
    }
}

#[test]
fn what_is_wrong_is_named_with_line_and_key() {
    let changed = |from: &str, to: &str| CARBON.replacen(from, to, 1);
    for (text, says) in [
        (changed("hardness", "hardnes"), "line 5: hardnes: no such key; the nearest is hardness"),
        (changed("E2", "e2"), "line 10: [materials] e2: no such key; the nearest is E2"),
        (changed("m4", "M_4"), "line 16: [roughness] M_4: no such key; the nearest is m4"),
        (changed("[roughness]", "[roughnes]"), "line 13: [roughnes]: no such table; there are [materials], [roughness], [measured_on] and [known_to]"),
        (changed("nominal_area = 1e-6", ""), "line 13: nominal_area: must be set, since [roughness] gives"),
        (changed("m4", "Sq"), "line 16: [roughness] Sq: is not for spectral moments, as m0 is"),
        (changed("m2 =", "#"), "line 13: [roughness] m2: must be set"),
        (changed("m4 =", "summits = \"mccool\"#"), "line 16: [roughness] summits: \"mccool\" needs the curvature of the surface: give m4, Ssc, Sds or bandwidth"),
        (changed("m4 =", "summits = \"equal\"#"), "line 16: [roughness] summits = \"equal\": must be \"moments\" or \"mccool\""),
        (format!("radius_amplitude = 0.5\n{CARBON}"), "line 1: radius_amplitude: [roughness] sets it already"),
        (changed("nu2 =", "#"), "line 7: [materials] gives no name as second, so nu2 must be set there"),
        (changed("nu2 = 0.25", "nu2 = 0.6"), "line 11: nu2 = 0.6: must be > -1 and <= 0.5"),
        (changed("51e9", "true"), "line 5: hardness = true: must be a number"),
        (changed("51e9", "\"hard\""), "line 5: hardness = \"hard\": must be a number"),
        (changed("51e9", "\"51e9\""), "line 5: hardness = \"51e9\": must be a number, without quotes"),
        (changed("51e9", "51 GPa"), "line 5: hardness: 51 GPa is neither a number without unit nor a word in quotes"),
        (changed("51e9", "[51e9, 1e9]"), "line 5: hardness = [51000000000, 1000000000]: must be a number"),
        (changed("51e9", "1e400"), "line 5: hardness: 1e400 is too large for a number"),
        (changed("51e9", "-1"), "line 5: hardness = -1: must be finite and >= 0"),
        (changed("51e9", "1979-05-27"), "line 5: hardness: 1979-05-27 must be a number or a word in quotes"),
        (changed("3.3736e11", "3.3736"), "line 13: bandwidth m0 m4/m2^2 = "),
        ("nominal_area = 1\n[roughness]\nSq = 1e-6\nSdq = 12.5".into(), "line 4: [roughness] Sdq: makes a slope of 8.83"),
        (format!("height_std = 1e-9\n{CARBON}"), "line 1: height_std: [roughness] sets it already"),
        (format!("bandwidth = 3\n{CARBON}"), "line 1: bandwidth: [roughness] sets it already"),
        (format!("\ncomposite_modulus = 1e11\n{CARBON}"), "line 2: composite_modulus: [materials] sets it already"),
        (format!("pair = \"Si/Si\"\n{}", changed("E1 = 493e9\nnu1 = 0.25", "first = \"DLC\"")), "line 9: [materials] first: pair sets it already"),
        (changed("E1 = 493e9\nnu1 = 0.25\nE2 = 493e9", "E1 = 493\nnu1 = 0.25\nE2 = 493"), "line 8: composite_modulus = 262.9"),
        ("pair = \"Si/Si\"\ncomposite_modulus = 1e11\n".into(), "line 2: composite_modulus: pair sets it already, leave one out; E1, nu1, E2 and nu2 replace the"),
        (format!("calibration_load = 1\n{CARBON}"), "line 1: calibration_load: must be given together with"),
        (changed("E1 = 493e9", "first = \"Stahl\""), "line 9: [materials] nu1: first sets it already"),
        (changed("E1 = 493e9\nnu1 = 0.25", "first = \"Stahl\""), "line 8: [materials] first: Stahl: no material has this name; the nearest is steel"),
        ("slip_onset = \"hole\"".into(), "line 1: slip_onset = \"hole\": must be \"partial\" or \"whole\""),
        ("heights = \"gauss\"".into(), "line 1: height_distribution = \"gauss\": must be \"gaussian\", \"weibull\", \"johnson\", \"tabulated\" or \"at-scores\""),
        (at_scores(&SCORES[..12], &[0.1; 13], ""), "line 3: [roughness] heights_at_scores: 12 numbers for 13: one for each"),
        (at_scores(&SCORES, &[0.1; 14], ""), "line 4: [roughness] slopes_at_scores: 14 numbers for 13: one for each"),
        (at_scores(&[0.0; 13], &[0.1; 13], ""), "line 3: heights_at_scores[1]"),
        (at_scores(&SCORES, &[0.0; 13], ""), "line 4: slopes_at_scores[0]"),
        (at_scores(&SCORES, &[0.1; 13], "lay = 100"), "line 5: [roughness] lay: lay = 100: must be between"),
        ("nominal_area = 1\n[roughness]\nRq = 1\nRdq = 0.1\nRdq_along = 0.001".into(), "line 5: [roughness] Rdq_along: lay = 100"),
        ("nominal_area = 1\n[roughness]\nRq = 1\nRdq = 0.1\nRdq_along = 0.02\nlay = 4".into(), "line 5: [roughness] Rdq_along: must not be given together with lay"),
        (at_scores(&SCORES, &[0.1; 13], "Sq = 1"), "line 3: [roughness] heights_at_scores: heights are given by"),
        (at_scores(&SCORES, &[0.1; 13], "Sdq = 1"), "line 5: [roughness] Sdq: must not be given together with slopes_at_scores"),
        (format!("pair = \"Si/Si\"\n{}", at_scores(&SCORES, &[0.1; 13], "")), "line 4: [roughness] heights_at_scores = -3: must be in m, and at most 1e-3; is it in um or nm?"),
        ("nominal_area = 1\n[roughness]\nSq = 1\nSdq = 0.1\nSsk = -2\nSku = 4".into(), "line 6: [roughness] Sku: kurtosis = 4: must be"),
        ("nominal_area = 1\n[roughness]\nSq = 1\nSdq = 0.1\nSsk = -4\nSku = 40".into(), "line 5: [roughness] Ssk: skew = -4: must be between -3 and 3"),
        (at_scores(&SCORES, &[5.7; 13], ""), "line 4: [roughness] slopes_at_scores: makes a slope of 4."),
        ("nominal_area = 1\n[roughness]\nSpq = 1\nSvq = 3\nSmq = 70\nSdq = 0.1".into(), "line 5: [roughness] Smq: must be below 1: it is a part of the surface; is it in per cent?"),
        ("contact_law = 2".into(), "line 1: contact_law = 2: must be \"maugis\" or \"elastic-plastic\""),
        ("attraction = \"no\"".into(), "line 1: attraction = \"no\": must be false or true"),
        ("heights = 0\nheight_distribution = 0".into(), "line 2: height_distribution: given twice, also in line 1"),
        ("[materials]\n[roughness]\n[materials]".into(), "line 3: [materials]: given twice, also in line 1"),
        ("E1 = 1e9".into(), "line 1: E1: belongs in [materials]"),
        ("[materials]\nhardness = 1e9".into(), "line 2: [materials] hardness: belongs above the first table"),
        ("materials = 3".into(), "line 1: materials = 3: must be a table, [materials]"),
        ("Rz = 3e-6".into(), "line 1: Rz: no such key; a height from peak to valley"),
        ("mu = 0.3".into(), "line 1: mu: no such key; give calibration_friction_coefficient with calibration_load"),
        ("nominal_area = 1\n[roughness]\nRz = 3e-6".into(), "line 3: [roughness] Rz: no such key; a height from peak to valley, which grows with the length measured: give Ra or Rq"),
        ("nominal_area = 1\n[roughness]\nRa = 3e-6".into(), "line 3: [roughness] Ra: give with it RSm"),
        ("nominal_area = 1\n[roughness]\nRa = 1\nm0 = 1\nm2 = 1\nm4 = 1".into(), "line 3: [roughness] Ra: must not be given together with m0, which it replaces"),
        ("nominal_area = 1\n[roughness]\nSq = [1, 2]\nSdq = 0.1\nSds = [1, 2]".into(), "line 4: [roughness] Sdq: must be as many numbers as Sq has"),
        (
            "pair = \"steel/steel\"\nnominal_area = 1e-4\nwaviness_height = 1e-6\n[roughness]\nprocess = \"ground\"".into(),
            "line 3: waviness_height: waviness_shape = 0: must be ridges (1) or hills (2)",
        ),
        ("nominal_area = 1\n[roughness]\nSq = 1".into(), "line 2: [roughness] Sdq: must be set, the slope of the map; if it is not known, give Rq with RSm or process"),
        ("nominal_area = 1\n[roughness]\nRq = 1".into(), "line 2: [roughness] RSm: must be set, or Rdq"),
        ("nominal_area = 1\n[roughness]\nRq = 1\nRSm = 1\nRdq = 1".into(), "line 5: [roughness] Rdq: must not be given together with RSm, which it replaces"),
        ("nominal_area = 1\n[roughness]\nRa = -1\nRSm = 1".into(), "line 3: Ra = -1: must be finite and > 0"),
        ("summit_density = 1".into(), "line 1: nominal_area: must be set, since summit_density gives"),
        ("interface = 3".into(), "line 1: interface = 3: must be the name of an interface, in quotes"),
        ("interface = \"KCl film\"".into(), "line 1: interface: KCl film: no interface has this name; the nearest is "),
        (format!("slip_stress_1 = 1\ninterface = \"KCl film on iron in vacuum\"\n{CARBON}"), "line 1: slip_stress_1: interface sets it already"),
        ("skew = 0.1\nweibull_shape = 3".into(), "line 1: skew: chooses the heights by itself: do not give weibull_shape too"),
        ("kurtosis = 3\nweibull_shape = 3".into(), "line 2: weibull_shape: means other heights than kurtosis"),
        ("table_height = [1, 2]\ntable_density = [1, 2]".into(), "line 1: table_height: table_length = 2: must be between 3 and 256"),
        ("table_height = [1, 2, 3]\ntable_density = [1, 2]".into(), "line 2: table_density: 2 numbers for 3 heights"),
        ("table_height = [1, 2, 3]".into(), "line 1: table_height: table_height and table_density go together"),
        (
            "heights = \"weibull\"\ntable_height = [0, 1, 2]\ntable_density = [0.5, 1, 0]".into(),
            "line 2: table_height: the heights are of another family: leave the table out",
        ),
        ("table_height = [[1], 2]".into(), "line 1: table_height: must be an array of numbers, or of arrays of numbers"),
        (format!("table_height = [{}]", "1,".repeat(257)), "line 1: table_height: more than 256 numbers"),
        ("height_std =\n".into(), "line 1: height_std: has no value"),
        ("height_std: 3".into(), "line 1: not TOML: invalid unquoted key"),
        ("height_std = .5e-9".into(), "line 1: not TOML: invalid mantissa, expected digits; numbers are written as 0.15, 10.0 or 1e-4"),
        ("height_std = 1.".into(), "line 1: not TOML: invalid fraction, expected digits; numbers are written as 0.15, 10.0 or 1e-4"),
        ("height_std = 010".into(), "line 1: not TOML: unexpected leading zero; numbers are written as 0.15, 10.0 or 1e-4"),
        ("height_std = 1,5e-9".into(), "line 1: not TOML: unexpected key or value, expected a new line or `#`; is it the point of a number?"),
        ("contact_law = maugis".into(), "line 1: contact_law: maugis is neither a number without unit nor a word in quotes"),
        ("height_std".into(), "line 1: not TOML: key with no value, expected `=`"),
        ("\ntable_height = [1,\n2".into(), "line 2: not TOML: unclosed array, expected `]`"),
        ("a.b = 3".into(), "line 1: a: keys with dots are not read here"),
        ("[a.b]".into(), "line 1: a: there are no tables in tables here"),
        ("[[materials]]".into(), "line 1: a table is given once, in single brackets"),
        ("[vary]\nheight_std = 0.1".into(), "line 1: [vary]: no such table; there are [materials], [roughness], [measured_on] and [known_to]"),
        (format!("{} = 1", "k".repeat(99)), &format!("line 1: {}...: no such key", "k".repeat(40))),
        ("calibration_load = 1e-3\ncalibration_friction_coefficient = 0.4".into(), "line 1: composite_modulus: must be set"),
        (format!("calibration_load = 1e-3\ncalibration_friction_coefficient = 40\n{CARBON}"), "line 2: calibration_friction_coefficient = 40: must be > 0 and at most 20"),
    ] {
        refused(text, says);
    }
    refused(
        b"# a comment\nheight_distribution = \"gau\xdfian\"",
        "line 2: must be UTF-8: save the text in this encoding",
    );
    refused(vec![b'#'; MIB + 1], "longer than 1 MiB: must be a surface file");
    surface(&format!("{CARBON}#{}", "x".repeat(MIB - CARBON.len() - 1)));
}

/// A mebibyte of anything.
#[test]
#[cfg_attr(miri, ignore = "takes hours there")]
fn no_text_takes_long() {
    const UNITS: [(&str, &str); 34] = [
        ("", "\0"),
        ("", "\n"),
        ("", "\r\n"),
        ("", " "),
        ("", "#"),
        ("", "#\n"),
        ("", "="),
        ("", "["),
        ("", "]"),
        ("", "[a]\n"),
        ("", "[materials]\n"),
        ("", "\""),
        ("", "'"),
        ("", "k"),
        ("", "%a"),
        ("", "é"),
        ("", "a.a = 1\n"),
        ("a", ".a"),
        ("[a", ".a"),
        ("a = ", "["),
        ("a = ", "{a="),
        ("a = [", "1,"),
        ("table_height = [", "1,"),
        ("table_height = [", "[1],"),
        ("table_height = [", "\n"),
        ("hardness = ", "1"),
        ("hardness = 0.", "1"),
        ("hardness = 1e", "1"),
        ("hardness = 1", "_1"),
        ("hardness = ", "-"),
        ("hardness = 0x", "f"),
        ("pair = \"", "\\u0041"),
        ("pair = \"", "\\"),
        ("pair = \"\"\"", "\"\n"),
    ];
    for (begin, unit) in UNITS {
        // As long as it may be, and as it is below the limit of words and signs.
        for length in [MIB, 120_000] {
            let text = format!("{begin}{}", unit.repeat((length - begin.len()) / unit.len()));
            let mut params = asperity_params::unset();
            let before = processor_time();
            let status = set(&mut params, text.as_bytes());
            let took = processor_time() - before;
            assert!([OK, INVALID_PARAMETER, OUT_OF_RANGE].contains(&status), "{begin}{unit}: {status}");
            assert!(took < LONGEST_CALL, "{begin}{unit}...: {took:?}");
        }
    }
}

/// Texts that were good, with bytes changed, moved and left out: set or refused, and read back if they are set.
#[test]
#[cfg_attr(miri, ignore = "takes hours there")]
fn any_text_is_set_or_refused() {
    let tabulated =
        "table_height = [0.0, 1.0, 2.0, 3.0]\ntable_density = [1.0, 2.0, 1.5, 0.5]\nheights = 'tabulated'\n";
    let texts =
        [CARBON.into(), format!("{tabulated}{CARBON}"), "[roughness]\nRa = [1e-6, 2e-6]\nRSm = [1e-4, 1e-4]".into()];
    let mut random = SplitMix(0x5eed);
    let mut set_ones = 0;
    for _ in 0..20_000 {
        let mut text = texts[random.below(texts.len())].clone().into_bytes();
        for _ in 0..1 + random.below(4) {
            let (at, from) = (random.below(text.len()), random.below(text.len()));
            match random.below(4) {
                0 => text[at] = random.below(256) as u8,
                1 => drop(text.drain(at..(at + random.below(20)).min(text.len()))),
                2 => {
                    let part = text[from..(from + random.below(20)).min(text.len())].to_vec();
                    drop(text.splice(at..at, part));
                }
                _ => text.insert(at, b"[]{}\"'=.,\n#"[random.below(11)]),
            }
            if text.is_empty() {
                text.push(b' ');
            }
        }
        let mut params = asperity_params::unset();
        let before = bytes(&params).to_vec();
        let status = set(&mut params, &text);
        let shown = String::from_utf8_lossy(&text).into_owned();
        assert!([OK, INVALID_PARAMETER, OUT_OF_RANGE].contains(&status), "{status}: {shown}");
        if status == OK {
            set_ones += 1;
            assert_same(&surface(&written(&params)), &params, &shown);
        } else {
            assert_eq!(bytes(&params), before, "{shown}: refused, yet changed");
            assert!(message().contains("line "), "{}: {shown}", message());
        }
    }
    assert!(set_ones > 100, "{set_ones}");
}

#[test]
fn what_is_written_reads_back_bit_for_bit() {
    let carbon = surface(CARBON);
    let third = 0.1 + 0.2;
    for params in [
        asperity_params::unset(),
        asperity_params::initial(),
        carbon,
        asperity_params { max_friction_coefficient: f64::INFINITY, attraction: 0, radius_amplitude: third, ..carbon },
        asperity_params { contact_law: 1, slip_onset: 1, work_of_adhesion: -0.0, tangential_modulus: 1e-30, ..carbon },
        asperity_params { weibull_shape: 5.0, ..carbon },
        carbon.weibull(7.1),
        carbon.weibull(3.602),
        carbon.johnson(-0.5, 4.0),
        carbon.johnson(0.0, 3.0),
        carbon.table(&[-1.0, 0.0, 2.0 / 3.0], &[0.0, 1.0, 5e-324]),
        asperity_params { height_distribution: 4, ..carbon.table(&SCORES, &[0.1; 13]) },
    ] {
        let text = written(&params);
        assert!(text.starts_with("# Two rough surfaces in contact"), "{text}");
        assert_same(&surface(&text), &params, &text);
    }
    // Choices that are none have no words.
    let none = asperity_params { contact_law: 7, ..carbon };
    let mut buffer: [c_char; 9] = [1; 9];
    // SAFETY: so much room.
    assert_eq!(unsafe { asperity_params_text(&none, buffer.as_mut_ptr(), 9) }, 0);
    assert!(buffer[0] == 0 && message().starts_with("contact_law = 7"), "{}", message());
    for (wrong, says) in [
        (asperity_params { height_distribution: 9, ..carbon }, "height_distribution = 9: must be one of"),
        (asperity_params { skew: 0.5, ..carbon }, "skew = 0.5: must be 0 unless heights are Johnson's"),
    ] {
        // SAFETY: NULL asks for the length.
        assert_eq!(unsafe { asperity_params_text(&wrong, null_mut(), 0) }, 0);
        assert!(message().starts_with(says), "{}", message());
    }
    let part = asperity_params { calibration_load: 2.0, calibration_friction_force: 0.3, ..asperity_params::unset() };
    let says = "# The strength was calibrated on surfaces of which composite_modulus is not set here: a friction force of 0.3 at";
    assert!(written(&part).contains(says), "{}", written(&part));
}

#[test]
fn a_calibration_is_written_if_it_is_of_these_surfaces() {
    let mut params = surface(CARBON);
    // SAFETY: an initialised struct.
    assert_eq!(unsafe { asperity_params_calibrate(&mut params, 2e-3, 0.37) }, OK);
    let text = written(&params);
    assert!(text.contains("\ncalibration_load = 0.002\ncalibration_friction_force = 0.00074\n"), "{text}");
    assert_same(&surface(&text), &params, &text);
    // In other units it is the same measurement.
    // SAFETY: an initialised struct.
    assert_eq!(unsafe { asperity_params_set_units(&mut params, 1e-3, 1.0) }, OK);
    assert_same(&surface(&written(&params)), &params, "in mm");
    params.height_std *= 2.0;
    let text = written(&params);
    let comment = "# The strength was calibrated on other surfaces: a friction force of 0.00074 at a load of 0.002.\n";
    assert!(text.ends_with(comment) && !text.contains("\ncalibration_load"), "{text}");
    let expected = asperity_params { calibration_load: 0.0, calibration_friction_force: 0.0, ..params };
    assert_same(&surface(&text), &expected, &text);
}

#[test]
fn units_are_converted_together() {
    let mut params = surface(&format!("calibration_load = 1e-3\ncalibration_friction_coefficient = 0.4\n{CARBON}"));
    let before = params;
    // SAFETY: an initialised struct.
    unsafe {
        for (length, force) in [(0.0, 1.0), (1.0, -1.0), (f64::NAN, 1.0), (1.0, f64::INFINITY)] {
            assert_eq!(asperity_params_set_units(&mut params, length, force), INVALID_PARAMETER);
        }
        assert_eq!(bytes(&params), bytes(&before));
        assert_eq!(asperity_params_set_units(&mut params, 1e-6, 1e-3), OK); // um, mN: GPa
    }
    for (name, found, expected) in [
        ("E*", params.composite_modulus, before.composite_modulus / 1e9),
        ("G*", params.effective_shear_modulus, before.effective_shear_modulus / 1e9),
        ("H", params.hardness, 51.0),
        ("G^", params.tangential_modulus, before.tangential_modulus / 1e9),
        ("w", params.work_of_adhesion, 0.06 / 1e3),
        ("h", params.adhesion_range, 0.25e-3),
        ("b", params.burgers_vector, 0.25e-3),
        ("sigma", params.height_std, before.height_std * 1e6),
        ("R", params.summit_radius, before.summit_radius * 1e6),
        ("N", params.asperity_count, before.asperity_count),
        ("A", params.nominal_area, 1e6),
        ("P", params.calibration_load, 1.0),
        ("F", params.calibration_friction_force, 0.4),
        ("tau", params.slip_stress_1, before.slip_stress_1),
    ] {
        assert_near(found, expected, 1e-14, name);
    }
    let [metres, micrometres] = [(before, 1e-2), (params, 10.0)].map(|(params, load)| {
        let model = Handle::new(&params);
        // SAFETY: a model.
        unsafe { asperity_friction_at_load(model.0, load) }
    });
    // Rows begin at other loads in other units.
    assert_near(micrometres, metres, 1e-9, "the friction coefficient");
    // What is unset stays so.
    let mut unset = asperity_params::unset();
    // SAFETY: an initialised struct.
    assert_eq!(unsafe { asperity_params_set_units(&mut unset, 1e-3, 1.0) }, OK);
    assert_eq!(bytes(&unset), bytes(&asperity_params { length_unit: 1e-3, ..asperity_params::unset() }));
}

/// In whatever order, numbers of two systems of units do not meet.
#[test]
fn units_are_kept_and_not_mixed() {
    let mut params = surface(CARBON);
    let metres = written(&params);
    assert!(metres.starts_with("# Two rough surfaces in contact, for asperity: SI units"), "{metres}");
    // SAFETY: an initialised struct.
    assert_eq!(unsafe { asperity_params_set_units(&mut params, 1e-3, 1.0) }, OK);
    let millimetres = written(&params);
    assert!(millimetres.contains("\nlength_unit = 0.001\n") && !millimetres.contains("SI units"), "{millimetres}");
    let again = surface(&millimetres);
    assert_same(&again, &params, "read back");
    type Call<'a> = &'a dyn Fn(&mut asperity_params) -> i32;
    // SAFETY: initialised structs, and names that end.
    let (convert, pair): (Call, Call) = unsafe {
        (&|params| asperity_params_set_units(params, 1e-3, 1.0), &|params| {
            asperity_params_set_pair(params, c"Si/Si".as_ptr())
        })
    };
    let text = |text: &'static str| move |params: &mut asperity_params| set(params, text.as_bytes());
    let calls: [(Call, &str); 9] = [
        (convert, "length_unit = 0.001: must be 1"),
        (pair, "length_unit = 0.001: must be 1"),
        (&|params| set(params, metres.as_bytes()), "line 1: length_unit = 1: must be 0.001"),
        (&text("hardness = 51e9"), "line 1: length_unit = 1: must be 0.001"),
        (&text("\nforce_unit = 1000\nlength_unit = 0.001"), "line 2: force_unit = 1000: must be 1"),
        (&text("length_unit = 1e-6"), "line 1: length_unit = 1e-6: must be 0.001"),
        (&text("length_unit = 1e-3\npair = 'steel/steel'"), "line 1: length_unit = 0.001: must be 1"),
        (&text("length_unit = 1e-3\ninterface = 'MoS2 film in dry air'"), "line 1: length_unit = 0.001: must be 1"),
        (
            &text("length_unit = 1e-3\n[roughness]\nRa = 1e-6\nprocess = 'ground'"),
            "line 4: length_unit = 0.001: must be 1",
        ),
    ];
    for (number, (call, says)) in calls.iter().enumerate() {
        for before in [params, again] {
            let mut params = before;
            assert_eq!(call(&mut params), INVALID_PARAMETER, "{number}: {says}");
            assert!(message().starts_with(says), "{number}: {}\nnot {says}", message());
            assert_same(&params, &before, says);
        }
    }
    assert_eq!(set(&mut params, b"length_unit = 1e-3\nrms_slope = 0.1"), OK, "{}", message());
    // Units alone are none of SI either.
    let mut metres = surface(CARBON);
    assert_eq!(set(&mut metres, millimetres.as_bytes()), INVALID_PARAMETER);
    // SAFETY: a text of this length, and a struct of its size.
    unsafe {
        let load = 1e-3;
        let mut found = asperity_estimate::empty();
        assert_eq!(
            asperity_estimate_at_loads(millimetres.as_ptr().cast(), millimetres.len(), 1, &load, &mut found),
            INVALID_PARAMETER
        );
        assert!(message().contains("length_unit = 0.001: must be 1"), "{}", message());
    }
}

#[test]
fn summits_per_area_are_set_by_name_too() {
    let mut params = asperity_params::unset();
    let (names, values) = ([c"summit_density".as_ptr(), c"nominal_area".as_ptr()], [2e12, 1e-6]);
    // SAFETY: an initialised struct, and names that end.
    unsafe {
        assert_eq!(asperity_params_set_values(&mut params, 1, names.as_ptr(), &2e12), INVALID_PARAMETER);
        assert_eq!(asperity_params_set_values(&mut params, 2, names.as_ptr(), values.as_ptr()), OK);
        assert_eq!((params.asperity_count, params.nominal_area), (2e6, 1e-6));
        assert_eq!(asperity_params_set_values(&mut params, 1, names.as_ptr(), &3e12), OK);
        assert_eq!(params.asperity_count, 3e12 * 1e-6);
        let both = [c"summit_density".as_ptr(), c"asperity_count".as_ptr()];
        assert_eq!(asperity_params_set_values(&mut params, 2, both.as_ptr(), values.as_ptr()), INVALID_PARAMETER);
        assert!(
            message().starts_with("summit_density: must not be given together with asperity_count"),
            "{}",
            message()
        );
    }
}

fn read(params: &mut asperity_params, path: &Path) -> i32 {
    let path = CString::new(path.to_str().expect("a path in UTF-8")).expect("no NUL");
    // SAFETY: an initialised struct, and a path that ends.
    unsafe { asperity_params_read(params, path.as_ptr()) }
}

#[test]
#[cfg_attr(miri, ignore = "there are no files")]
fn a_file_is_read_and_named() {
    let folder = std::env::temp_dir().join(format!("asperity surface {}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("film.toml");
    std::fs::write(&file, CARBON.replace('\n', "\r\n")).expect("a file");
    let mut params = asperity_params::unset();
    assert_eq!(read(&mut params, &file), OK, "{}", message());
    assert_same(&params, &surface(CARBON), "the file");
    let mut refused = |path: &Path, says: &str| {
        let before = bytes(&params).to_vec();
        assert_eq!(read(&mut params, path), INVALID_PARAMETER, "{}", path.display());
        assert_eq!(bytes(&params), before);
        let (found, name) = (message(), path.file_name().and_then(|name| name.to_str()).unwrap_or_default());
        assert!(found.contains(name) && found.contains(says), "{found}");
    };
    std::fs::write(&file, "\n\nslip_onset = \"hole\"\n").expect("a file");
    refused(&file, ": line 3: slip_onset = \"hole\": must be \"partial\" or \"whole\"");
    std::fs::write(&file, vec![b'\n'; MIB + 1]).expect("a file");
    refused(&file, ": longer than 1 MiB: must be a surface file");
    refused(&folder, ": must be a file with a surface");
    refused(&folder.join("none.toml"), ": ");
    refused(&folder.join("x".repeat(200)).join("none.toml"), "none.toml: ");
    assert!(message().starts_with("none.toml: "), "the end of a long path: {}", message());
    std::fs::write(&file, "").expect("a file");
    refused(&file, ": is empty: must be a file with a surface");
    std::fs::File::create(&file).and_then(|file| file.set_len(1 << 40)).expect("a huge file");
    refused(&file, ": longer than 1 MiB: must be a surface file");
    if cfg!(unix) {
        let pipe = folder.join("pipe.toml");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().expect("mkfifo").success());
        refused(&pipe, ": must be a file with a surface");
        let socket = folder.join("socket.toml");
        #[cfg(unix)]
        let _listens = std::os::unix::net::UnixListener::bind(&socket).expect("a socket");
        refused(&socket, ": must be a file with a surface");
        for device in ["/dev/zero", "/dev/null", "/dev/tty"] {
            refused(Path::new(device), ": must be a file with a surface");
        }
    }
    if cfg!(target_os = "linux") {
        // The first waits for the messages of the kernel, the next has no end that the system says.
        for shown in
            ["/proc/kmsg", "/proc/self/pagemap", "/proc/version", "/proc/self/environ", "/sys/kernel/uevent_seqnum"]
        {
            refused(Path::new(shown), ": ");
        }
    }
    std::fs::remove_dir_all(&folder).expect("the folder");
}

/// A file that someone writes while it is read is a surface of one of the lengths that it has had, or refused.
#[test]
#[cfg_attr(miri, ignore = "there are no files")]
fn a_file_that_grows_is_read_to_an_end() {
    let file = std::env::temp_dir().join(format!("asperity growing {}.toml", std::process::id()));
    std::fs::write(&file, "hardness = 51e9\n").expect("a file");
    let is_read = std::sync::atomic::AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            use std::io::Write;
            let mut file = std::fs::OpenOptions::new().append(true).open(&file).expect("the file");
            for _ in 0..MIB / 4096 {
                if !is_read.load(std::sync::atomic::Ordering::Relaxed) {
                    file.write_all(&[b'\n'; 4096]).expect("more of it");
                }
            }
        });
        for _ in 0..50 {
            let mut params = asperity_params::unset();
            match read(&mut params, &file) {
                OK => assert_eq!(params.hardness, 51e9),
                status => {
                    let says = ["another length", "longer than 1 MiB"];
                    assert!(
                        status == INVALID_PARAMETER && says.iter().any(|says| message().contains(says)),
                        "{}",
                        message()
                    );
                }
            }
        }
        is_read.store(true, std::sync::atomic::Ordering::Relaxed);
    });
    std::fs::remove_file(&file).expect("the file");
}

/// What can be set is refused where it is set: a text alone, or one after another, in any order.
#[test]
fn what_no_surface_has_is_refused_at_its_key() {
    const STEEL: &str = "pair = 'steel/steel'\nnominal_area = 1e-4\n[roughness]\nRq = 1e-6\nprocess = 'ground'\n";
    let changed = |key: &str, line: &str| {
        let changed = |old: &str| if old.starts_with(&format!("{key} ")) { line.to_owned() } else { old.to_owned() };
        STEEL.lines().map(changed).collect::<Vec<_>>().join("\n")
    };
    surface(STEEL);
    refused(
        changed("nominal_area", "nominal_area = 9223372036854775807"),
        "line 2: nominal_area, [roughness] Rq, [roughness] process: asperity_count = ",
    );
    refused(changed("nominal_area", "nominal_area = 1e-300"), "line 2: nominal_area = ");
    refused(changed("Rq", "Rq = 1e-16"), "line 4: [roughness] Rq, [roughness] process: ");
    refused(changed("Rq", "Rq = 1e-3"), "line 4: [roughness] Rq: makes a slope of ");
    for (text, says) in [
        ("nominal_area = 1e300", "line 1: nominal_area = 1e300: must be between 1e-40 and 1e40"),
        ("nominal_area = -1", "line 1: nominal_area = -1: must be finite and >= 0"),
        ("\nslip_stress_1 = 5e9", "line 2: slip_stress_1 = 5000000000: must be at most 1"),
        ("slip_radius_2 = 1e-9", "line 1: slip_radius_2 = 1e-9: must be at least 1"),
        ("pressure_coefficient = inf", "line 1: pressure_coefficient = inf: must be finite"),
        ("height_std = 0", "line 1: height_std = 0: must be finite and > 0"),
        ("height_std = 1e-6\nsummit_radius = 1e9", "line 1: height_std, summit_radius: alpha = "),
        ("bandwidth = 1.2", "line 1: bandwidth = 1.2: must be at least 1.5"),
        ("radius_rate = -1", "line 1: radius_rate = -1: must be finite and > 0"),
        ("weibull_shape = 1e3", "line 1: weibull_shape = 1000: must be"),
        ("length_unit = 0", "line 1: length_unit = 0: must be finite and > 0"),
        ("force_unit = nan", "line 1: force_unit = NaN: must be finite and > 0"),
    ] {
        refused(text, says);
    }
}

/// A key with what people may give it.
fn drawn_key(random: &mut SplitMix) -> String {
    // SAFETY: names that end.
    let name = |kind, index| unsafe { CStr::from_ptr(asperity_name(kind, index)) }.to_str().expect("a name");
    let names = (0..).take_while(|&index| !asperity_name(ASPERITY_NAMES_PARAMETERS, index).is_null()).count();
    let name = name(ASPERITY_NAMES_PARAMETERS, random.below(names));
    let powers = [-300, -41, -16, -9, -7, -6, -5, -4, -2, -1, 0, 1, 2, 4, 9, 11, 18, 41, 300];
    let number = format!("{}e{}", 1 + random.below(9), powers[random.below(powers.len())]);
    let numbers =
        ["0", "1", "2", "-1", "inf", "nan", "true", "false", "9223372036854775807", &number, &number, &number];
    format!("{name} = {}\n", numbers[random.below(numbers.len())])
}

/// A text of a surface with some keys changed, added and left out.
fn drawn_text(random: &mut SplitMix) -> String {
    let bodies =
        ["pair = 'steel/steel'\n", "pair = 'Si/Si'\n", "", &CARBON.split("\n\n").next().expect("numbers")[21..]];
    let areas = ["nominal_area = 1e-4\n", "nominal_area = 1e-6\n", "nominal_area = 9223372036854775807\n", ""];
    let summits =
        ["", "height_std = 1e-6\nsummit_radius = 1e-5\nasperity_count = 1e5\n", "heights = 'gaussian'\nskew = 0\n"];
    let tables = [
        "",
        "table_height = [0, 1, 3, 4]\ntable_density = [0, 1, 0.5, 0]\n",
        "measured = [10, 0.2]\n",
        "interface = 'MoS2 film in dry air'\n",
    ];
    let mut text = bodies[random.below(4)].to_owned()
        + areas[random.below(4)]
        + summits[random.below(3)]
        + tables[random.below(4)];
    (0..random.below(2)).for_each(|_| text += &("\n".to_owned() + &drawn_key(random)));
    let powers = [-16, -8, -7, -7, -6, -5, -5];
    let mut length = || format!("{}e{}", 1 + random.below(9), powers[random.below(7)]);
    let (height, width) = (length(), length());
    let roughness = [
        String::new(),
        format!("[roughness]\nRq = {height}\nRSm = {width}\n"),
        format!("[roughness]\nRa = {height}\nprocess = 'ground'\n"),
    ];
    text + &roughness[random.below(3)]
}

/// What a text sets can be written, read again and made a model of, or no key alone is at fault.
#[test]
fn what_is_set_is_written_read_again_and_made() {
    // Numbers that one text may give and another complete; what only the search for an equilibrium finds.
    const OF_MORE_THAN_A_KEY: [&str; 2] = ["must be set", "did not converge"];
    let mut random = SplitMix(20_261_128);
    let (mut set_at_once, mut made) = (0, 0);
    for _ in 0..if cfg!(miri) { 20 } else { 2000 } {
        let mut params = asperity_params::unset();
        let texts: Vec<_> = (0..1 + random.below(2)).map(|_| drawn_text(&mut random)).collect();
        for text in &texts {
            if set(&mut params, text.as_bytes()) != OK {
                assert!(message().starts_with("line "), "{}\n{text}", message());
                continue;
            }
            set_at_once += 1;
            let written = written(&params);
            assert!(!written.is_empty(), "{}\n{texts:?}", message());
            let again = surface(&written);
            // A measurement of other surfaces is a comment, and a table that is not read is left out.
            let kept = |mut params: asperity_params| {
                if written.contains("# The strength was calibrated") {
                    (params.calibration_load, params.calibration_friction_force) = (0.0, 0.0);
                }
                if ![ASPERITY_HEIGHTS_TABULATED, ASPERITY_HEIGHTS_AT_SCORES].contains(&params.height_distribution) {
                    (params.table_height, params.table_density, params.table_length) = (null(), null(), 0);
                }
                params
            };
            assert_same(&kept(again), &kept(params), &format!("{texts:?}\n{written}"));
            let mut model = null_mut();
            // SAFETY: parameters of a text, and a place for a handle.
            match unsafe { asperity_create(&params, &mut model) } {
                OK => made += 1,
                _ => {
                    assert!(OF_MORE_THAN_A_KEY.iter().any(|says| message().contains(says)), "{}\n{texts:?}", message())
                }
            }
            // SAFETY: a model, or NULL.
            unsafe { asperity_free(model) };
        }
    }
    assert!(cfg!(miri) || set_at_once > 300 && made > 100, "{set_at_once} set, {made} made");
}
