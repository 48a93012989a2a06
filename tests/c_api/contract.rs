//! The contract of the C interface: what the head of asperity.h says of all functions, asked of each through one description of it.

use crate::common::neighbours::Neighbours;
use crate::common::splitmix::SplitMix;
use crate::fuzz_calls::table::*;
use crate::interface::*;
use std::ffi::CStr;
use std::ptr::null_mut;

const SEED: u64 = 0x5eed_ba7c;

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
        for i in call.at(|is| !matches!(is, Number(_) | Whole(_) | Times(_) | Count | Length | Room)) {
            let (name, is) = call.arguments[i];
            let mut prepared = call.prepare(&model, 1);
            let before = prepared.places.clone();
            prepared.words[i].pointer = null_mut();
            reset_message();
            let told = call.run(&prepared);
            let what = format!("{}: {name} = NULL: {told:?}: {}", call.name, message());
            if matches!(is, MayOut(_) | Buffer | FreedModel) {
                assert!(told == expected || call.name == "asperity_last_error", "{what}");
                let others = call.at(|is| is_output(is) && is != Buffer).filter(|&other| other != i);
                let same = others.into_iter().all(|other| prepared.places[other] == whole.places[other]);
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
    for call in CALLS {
        for i in call.at(|is| matches!(is, Number(_) | In(..))) {
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
                check(call, &prepared, &before, told, &what);
                if let Told::Number(bits) = told {
                    assert!(value.is_finite() || f64::from_bits(bits).is_nan(), "{what}");
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
        for i in call.at(|is| matches!(is, In(..) | MayOut(_) | Out(_) | Struct(_) | Which | Names(_))) {
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
    let is_batch =
        |call: &&Call| call.is_batch() && call.at(|is| matches!(is, Text(_) | Names(_) | Times(_))).next().is_none();
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
    for kind in 0..6 {
        for name in (0..).map(|index| asperity_name(kind, index)).take_while(|name| !name.is_null()) {
            // SAFETY: a name that ends; NULL asks for the length.
            assert!(unsafe { asperity_describe(kind, name, null_mut(), 0) } > 0, "{}", message());
        }
    }
    let model = Handle::new(&soonest_made());
    for kind in [-1, 2, i32::MIN, i32::MAX] {
        // SAFETY: a model and a struct.
        assert_eq!(unsafe { asperity_table_of(model.0, kind, &mut asperity_table::empty()) }, INVALID_PARAMETER);
    }
}
