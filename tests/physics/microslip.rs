//! A contact that remembers: against the exact tangential force, and what springs and sliders must do on any path.

use crate::common::assert_near;
use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{dimensionless, johnson, model, of_the_benchmark, table};
use asperity::{ContactLawKind, MicroslipStep, Model, Params, SlipConstants, SlipOnset, MICROSLIP_LENGTH};

type State = [f64; MICROSLIP_LENGTH];

/// Those of the benchmark, and others that are far from them: summits that yield, strengths that grow with pressure, heights of
/// other families.
fn surfaces() -> Vec<Params> {
    let default = Params::paper();
    let yielding = |eta: f64| Params {
        contact_law: ContactLawKind::ElasticPlastic,
        hardness: eta * default.composite_modulus,
        ..dimensionless(0.02, 1000.0, 0.0, 1.0)
    };
    let no_stress = SlipConstants { stress_1: 0.0, stress_2: 0.0, ..SlipConstants::default() };
    let heights = table(&[-2.0, -1.0, 0.3, 1.0, 3.0], &[0.0, 0.4, 0.3, 0.5, 0.0]);
    let two_humps = table(&[-1.2, -1.0, -0.8, 0.8, 1.0, 1.2], &[0.0, 2.0, 0.01, 0.01, 2.0, 0.0]);
    let others = [
        yielding(0.01),
        yielding(0.05),
        Params { slip: no_stress, pressure_coefficient: 0.2, ..dimensionless(0.01, 1000.0, 0.0, 1.0) },
        Params { pressure_coefficient: 0.1, ..default.clone() },
        Params { heights: johnson(0.5, 4.0), ..dimensionless(0.02, 300.0, 1e-3, 0.5) },
        Params { heights, ..dimensionless(0.01, 1000.0, 0.0, 1.0) },
        Params { heights: two_humps, ..dimensionless(0.01, 1000.0, 0.0, 1.0) },
        Params { radius_amplitude: -1.0, ..dimensionless(0.01, 1000.0, 0.0, 1.0) },
    ];
    of_the_benchmark().into_iter().chain(others).collect()
}

/// Six decades about the load at which half of the summits touch, and loads that adhesion rules.
fn loads(model: &Model) -> Vec<f64> {
    let half = model.state_at_gap(0.0).expect("a state").load;
    let mut loads: Vec<f64> = (-5..=2).map(|decade| 0.3 * half * 10_f64.powi(decade)).collect();
    let pulling = 0.5 * model.summary().pull_off_load;
    // Of a surface that hardly adheres these are lighter than the law's.
    if pulling < 0.0 && pulling >= model.summary().min_table_load {
        loads.extend([0.0, pulling]);
    }
    loads
}

/// F and F/K_t.
fn strength_and_length(model: &Model, load: f64) -> (f64, f64) {
    let strength = model.friction_force_at_load(load);
    (strength, strength / model.tangential_stiffness_at_load(load))
}

fn step(model: &Model, load: f64, increment: [f64; 2], state: &mut State) -> MicroslipStep {
    model.microslip_step(load, increment, state).unwrap_or_else(|error| panic!("{load}, {increment:?}: {error}"))
}

/// The force along a straight path of a contact that has just closed.
fn first_loading(model: &Model, load: f64, displacement: f64) -> f64 {
    step(model, load, [displacement, 0.0], &mut [0.0; MICROSLIP_LENGTH]).force[0]
}

/// The numbers of a row of the tables of docs/stiffness-and-microslip.md are these.
pub fn assert_told(row: &str, found: &[f64]) {
    const PAGE: &str = include_str!("../../docs/stiffness-and-microslip.md");
    let begin = format!("| {row} |");
    let rest = PAGE.lines().find_map(|line| line.strip_prefix(&begin)).unwrap_or_else(|| panic!("no row {row}"));
    let number = |c: char| c.is_ascii_digit() || c == '.';
    let told: Vec<f64> = rest.split(|c| !number(c)).filter_map(|word| word.parse().ok()).collect();
    let near = |(told, found): (&f64, &f64)| (told - found).abs() < 0.03 * found + 6e-4;
    assert!(told.len() == found.len() && told.iter().zip(found).all(near), "{row}: {told:?}, found {found:.4?}");
}

/// What the page says of forces, and of the work of a cycle.
#[test]
fn forces_and_work_are_those_of_the_contacts() {
    const STEPS: u32 = 16;
    const AMPLITUDES: [(f64, &str); 4] = [
        (0.1, "work over exact work, amplitude 0.02 to 0.1 F/K_t"),
        (0.3, "0.1 to 0.3 F/K_t"),
        (1.0, "0.3 to 1 F/K_t"),
        (f64::INFINITY, "above 1 F/K_t"),
    ];
    let (mut errors, mut works, mut ratios) = ([0.0_f64; 2], [0.0_f64; 2], [[1.0_f64; 2]; 4]);
    for onset in [SlipOnset::Partial, SlipOnset::Whole] {
        for params in surfaces() {
            let model = model(&Params { slip_onset: onset, ..params.clone() });
            for load in loads(&model) {
                let (strength, length) = strength_and_length(&model, load);
                let exact = |x: f64| model.tangential_at_load(load, x * length).expect("a force").0 / strength;
                for i in 0..26 {
                    let x = 0.03 * 1.22_f64.powi(i);
                    let error = (first_loading(&model, load, x * length) / strength - exact(x)).abs();
                    // Of two humps that slip as a whole the strength changes within a few per cent of load.
                    errors[onset as usize] = errors[onset as usize].max(error);
                }
                for i in 0..40 {
                    let amplitude = 0.02 * 1.13_f64.powi(i);
                    let width = amplitude / f64::from(STEPS);
                    let simpson = |i: u32| if i == 0 || i == STEPS { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
                    let area: f64 =
                        (0..=STEPS).map(|i| simpson(i) * exact(width * f64::from(i))).sum::<f64>() * width / 3.0;
                    let expected = 8.0 * area - 4.0 * amplitude * exact(amplitude);
                    let mut state = [0.0; MICROSLIP_LENGTH];
                    let path = [1.0, -2.0, 2.0].map(|part| [part * amplitude * length, 0.0]);
                    let work = path.map(|increment| step(&model, load, increment, &mut state).dissipated);
                    let ratio = (work[1] + work[2]) / (expected * strength * length);
                    // As a whole hardly any contact slips at small amplitude: what is lost is measured by 4 T x.
                    let most = 4.0 * amplitude * exact(amplitude) * strength * length;
                    let off = (work[1] + work[2] - expected * strength * length) / most;
                    works[onset as usize] = works[onset as usize].max(off.abs());
                    if onset == SlipOnset::Partial {
                        let range = AMPLITUDES.iter().position(|(end, _)| amplitude < *end).expect("a range");
                        let [low, high] = ratios[range];
                        ratios[range] = [low.min(ratio), high.max(ratio)];
                    }
                }
            }
        }
    }
    assert_told("force of a first loading, error over F", &errors);
    assert_told("work of a cycle, error over 4 T x", &works);
    for ((_, row), range) in AMPLITUDES.iter().zip(ratios) {
        assert_told(row, &range);
    }
}

#[test]
fn at_constant_load_loops_are_masings() {
    for params in surfaces() {
        let model = model(&params);
        for load in loads(&model) {
            let (strength, length) = strength_and_length(&model, load);
            for amplitude in [0.2, 0.9, 3.0] {
                let mut state = [0.0; MICROSLIP_LENGTH];
                let top = step(&model, load, [amplitude * length, 0.0], &mut state).force[0];
                let (mut reversal, mut force_there) = (amplitude, top);
                for direction in [-1.0, 1.0, -1.0] {
                    for part in [0.1, 0.3, 0.7, 1.0] {
                        let back = 2.0 * amplitude * part;
                        let mut there = state;
                        let found = step(&model, load, [direction * back * length, 0.0], &mut there).force[0];
                        let expected = force_there + direction * 2.0 * first_loading(&model, load, 0.5 * back * length);
                        assert!((found - expected).abs() < 1e-13 * strength, "{params:?} at {load}, {part}: {found}");
                    }
                    force_there = step(&model, load, [direction * 2.0 * amplitude * length, 0.0], &mut state).force[0];
                    reversal = -reversal;
                    assert!((force_there - reversal.signum() * top).abs() < 1e-13 * strength);
                }
            }
        }
    }
}

/// It does not depend on time: ten steps along a straight path are as one, and so are the work and the state.
#[test]
fn a_straight_path_may_be_taken_in_any_number_of_steps() {
    let mut random = SplitMix(3);
    for params in surfaces() {
        let model = model(&params);
        for load in loads(&model) {
            let (strength, length) = strength_and_length(&model, load);
            let (mut once, mut often) = ([0.0; MICROSLIP_LENGTH], [0.0; MICROSLIP_LENGTH]);
            let angle = random.between(0.0, 6.3);
            for _ in 0..5 {
                let by = random.between(-2.5, 2.5) * length;
                let increment = [by * angle.cos(), by * angle.sin()];
                let one = step(&model, load, increment, &mut once);
                let tenth = increment.map(|x| 0.1 * x);
                let ten: Vec<_> = (0..10).map(|_| step(&model, load, tenth, &mut often)).collect();
                let work: f64 = ten.iter().map(|one| one.dissipated).sum();
                for axis in [0, 1] {
                    assert!((ten[9].force[axis] - one.force[axis]).abs() < 1e-12 * strength, "{params:?} at {load}");
                }
                assert!((work - one.dissipated).abs() < 1e-12 * strength * length, "{params:?} at {load}: {work}");
            }
        }
    }
}

#[test]
fn tangents_are_those_of_differences() {
    let mut random = SplitMix(17);
    let (mut compared, mut slipped) = (0, 0);
    for params in surfaces() {
        let model = model(&params);
        let half = model.state_at_gap(0.0).expect("a state").load;
        let mut state = [0.0; MICROSLIP_LENGTH];
        for _ in 0..120 {
            let load = half * random.log_between(1e-5, 1e2);
            let (strength, length) = strength_and_length(&model, load);
            let size = length * random.log_between(1e-2, 4.0);
            let increment = [0, 1].map(|_| random.between(-1.0, 1.0) * size);
            let before = state;
            let found = step(&model, load, increment, &mut state);
            let at = |load: f64, increment: [f64; 2]| step(&model, load, increment, &mut before.clone()).force;
            let small = 1e-6 * length;
            for along in [0, 1] {
                let moved = |by: f64| {
                    let mut increment = increment;
                    increment[along] += by;
                    at(load, increment)
                };
                let (less, more) = (moved(-small), moved(small));
                for axis in [0, 1] {
                    let slope = (more[axis] - less[axis]) / (2.0 * small);
                    let error = (found.stiffness[2 * axis + along] - slope).abs();
                    assert!(
                        error < 1e-6 * strength / length,
                        "{slope}, load {load}, {compared}: {found:?}; {params:?}"
                    );
                }
            }
            let (less, more) = (at(load * (1.0 - 1e-5), increment), at(load * (1.0 + 1e-5), increment));
            for axis in [0, 1] {
                let slope = (more[axis] - less[axis]) / (2e-5 * load);
                let error = (found.dforce_dload[axis] - slope).abs() * load / strength;
                // How far cells are linear when they are laid anew depends on load, too.
                let most = if state[MICROSLIP_LENGTH - 2] > before[MICROSLIP_LENGTH - 2] { 2e-3 } else { 1e-6 };
                assert!(error < most, "{error:e}, {slope}, load {load}, {compared}: {found:?}; {params:?}");
            }
            compared += 1;
            slipped += usize::from(found.slipping > 0.0 && found.slipping < 1.0);
        }
    }
    assert!(slipped > compared / 4, "{slipped} of {compared} slipped in part");
}

/// Any path in the plane, with loads that jump over six decades: no force above the strength, no work gained by slip.
#[test]
fn no_path_exceeds_the_strength_or_gains_from_slip() {
    let mut random = SplitMix(23);
    for params in surfaces() {
        let model = model(&params);
        let half = model.state_at_gap(0.0).expect("a state").load;
        let mut state = [0.0; MICROSLIP_LENGTH];
        for _ in 0..2000 {
            let load = half * random.log_between(1e-4, 1e2);
            let (strength, length) = strength_and_length(&model, load);
            let size = length * random.log_between(1e-3, 10.0);
            let found = step(&model, load, [0, 1].map(|_| random.between(-1.0, 1.0) * size), &mut state);
            let force = found.force[0].hypot(found.force[1]);
            assert!(force <= strength * (1.0 + 1e-14), "{params:?} at {load}: {force}, {strength}");
            assert!(found.dissipated >= 0.0 && (0.0..=1.0).contains(&found.slipping), "{found:?}");
            // Positive semidefinite, no stiffer than all contacts that stick.
            let [xx, xy, yx, yy] = found.stiffness;
            let (mean, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
            let stiffest = strength / length;
            assert!(
                xy == yx && mean - half >= -1e-13 * stiffest && mean + half <= stiffest * (1.0 + 1e-13),
                "{found:?}"
            );
        }
    }
}

/// The work that closed cycles at one load take is the area of the loop.
#[test]
fn the_work_of_a_closed_cycle_is_the_area_of_its_loop() {
    const STEPS: usize = 4000;
    for params in surfaces().into_iter().step_by(3) {
        let model = model(&params);
        let load = model.state_at_gap(0.0).expect("a state").load;
        let (strength, length) = strength_and_length(&model, load);
        let mut state = [0.0; MICROSLIP_LENGTH];
        step(&model, load, [1.3 * length, 0.0], &mut state);
        let (mut area, mut work) = (0.0, 0.0);
        let mut last = step(&model, load, [0.0; 2], &mut state).force[0];
        for i in 0..2 * STEPS {
            let by = if i < STEPS { -2.6 } else { 2.6 } * length / STEPS as f64;
            let found = step(&model, load, [by, 0.0], &mut state);
            area += 0.5 * (last + found.force[0]) * by;
            work += found.dissipated;
            last = found.force[0];
        }
        assert_near(work, area, 1e-5, &format!("{params:?}, {}", strength * length));
    }
}

#[test]
fn more_load_adds_stiffness_and_no_force_and_less_takes_away_what_separates() {
    for params in surfaces() {
        let model = model(&params);
        let load = model.state_at_gap(1.0 * params.height_std).expect("a state").load;
        let (_, length) = strength_and_length(&model, load);
        let stiffness = |load: f64| model.tangential_stiffness_at_load(load);
        let small = 1e-4 * length;
        let mut state = [0.0; MICROSLIP_LENGTH];
        let stuck = step(&model, load, [small, 0.0], &mut state);
        let pressed = step(&model, 8.0 * load, [0.0; 2], &mut state);
        assert_near(pressed.force[0], stuck.force[0], 1e-12, &format!("{params:?}"));
        let more = step(&model, 8.0 * load, [small, 0.0], &mut state.clone());
        assert_near(more.stiffness[0], stiffness(8.0 * load), 1e-12, &format!("{params:?}"));
        // What touches at the lowest load is sheared by all of the displacement: the only elastic solution.
        let back = step(&model, load, [0.0; 2], &mut state);
        assert_near(back.force[0], stuck.force[0], 0.25, &format!("{params:?}"));
        let mut state = [0.0; MICROSLIP_LENGTH];
        step(&model, load, [small, 0.0], &mut state);
        let lower = step(&model, 0.1 * load, [0.0; 2], &mut state);
        let expected = stiffness(0.1 * load) * small;
        assert_near(lower.force[0], expected, 1e-12, &format!("{params:?}"));
        // Its energy is what went in less what is held.
        let held = 0.5 * small * (stuck.force[0] - expected);
        assert_near(lower.dissipated, held, 1e-9, &format!("{params:?}"));
    }
}

/// Any path in the plane under a load that wanders over decades: no more is given back than was put in, and when nothing
/// touches any more all of it has been told.
#[test]
fn no_path_gains_energy_and_all_that_is_lost_is_told() {
    let mut random = SplitMix(31);
    for params in surfaces() {
        for slip_onset in [SlipOnset::Partial, SlipOnset::Whole] {
            let params = Params { slip_onset, ..params.clone() };
            let first = model(&params);
            let half = first.state_at_gap(0.0).expect("a state").load;
            // Contacts of a joint that was tightened lightly unload each from its own largest load.
            let joint = (params.work_of_adhesion == 0.0).then(|| first.unloaded(1e-3 * half).expect("a model"));
            for model in [Some(&first), joint.as_ref()].into_iter().flatten().cycle().take(6) {
                let mut state = [0.0; MICROSLIP_LENGTH];
                let (mut work, mut lost, mut before) = (0.0, 0.0, [0.0; 2]);
                let (mut load, mut log_rate, mut direction) = (half * random.log_between(1e-2, 1.0), 0.0, [0.0; 2]);
                for i in 0..3000 {
                    if i % 100 == 0 {
                        log_rate = random.between(-0.02, 0.02) - 2e-3 * (load / half).ln();
                        direction = [0, 1].map(|_| random.between(-0.02, 0.02));
                    }
                    load *= f64::exp(log_rate);
                    let (strength, length) = strength_and_length(model, load);
                    let increment = direction.map(|along| along * length);
                    let found = step(model, load, increment, &mut state);
                    let mean = |axis: usize| 0.5 * (before[axis] + found.force[axis]) * increment[axis];
                    work += mean(0) + mean(1);
                    lost += found.dissipated;
                    before = found.force;
                    let close = 1e-3 * (strength * length + work);
                    assert!(lost <= work + close, "{params:?}, step {i}: {lost} of {work}");
                }
                // Down to a load at which next to nothing touches.
                for _ in 0..200 {
                    load *= 0.9;
                    lost += step(model, load, [0.0; 2], &mut state).dissipated;
                }
                assert_near(lost, work, 0.01, &format!("{params:?}"));
            }
        }
    }
}

/// A contact that slides is displaced while its load changes to a part or a multiple, then it opens: what it lost is the work, by
/// the trapezoidal rule, which one long step leaves between those of its two forces.
#[test]
fn all_work_is_lost_when_a_contact_opens_however_long_the_steps() {
    for params in surfaces().into_iter().filter(|params| params.work_of_adhesion == 0.0) {
        let model = model(&params);
        let load = model.state_at_gap(0.0).expect("a state").load;
        let (strength, length) = strength_and_length(&model, load);
        let mut slid = [0.0; MICROSLIP_LENGTH];
        let (mut work_before, mut lost_before, mut force_before) = (0.0, 0.0, 0.0);
        for _ in 0..300 {
            let by = 0.01 * length;
            let found = step(&model, load, [by, 0.0], &mut slid);
            work_before += 0.5 * (force_before + found.force[0]) * by;
            (lost_before, force_before) = (lost_before + found.dissipated, found.force[0]);
        }
        for ratio in [0.01, 0.1, 0.5, 0.9, 1.0, 1.1, 2.0, 10.0, 100.0] {
            for path in [0.01, 0.1, 1.0, 10.0, 1e3, 1e6, -0.1, -1e3] {
                let what = format!("{params:?}, load by {ratio}, displaced by {path}");
                let mut state = slid;
                let (mut work, mut lost, mut force) = (work_before, lost_before, force_before);
                let steps = 200;
                for i in 1..=steps {
                    let by = path * length / f64::from(steps);
                    let now = load * f64::powf(ratio, f64::from(i) / f64::from(steps));
                    let found = step(&model, now, [by, 0.0], &mut state);
                    work += 0.5 * (force + found.force[0]) * by;
                    (lost, force) = (lost + found.dissipated, found.force[0]);
                }
                lost += step(&model, 0.0, [0.0; 2], &mut state).dissipated;
                // The rule takes the step in which the contact turns for one of half the force.
                let turns = if path < 0.0 { 1.0 / f64::from(steps) * path.abs() * strength * length } else { 0.0 };
                assert!((lost - work).abs() < 0.01 * work.abs() + turns, "{what}: {lost} of {work}");

                let mut state = slid;
                let long = step(&model, ratio * load, [path * length, 0.0], &mut state);
                let all = lost_before + long.dissipated + step(&model, 0.0, [0.0; 2], &mut state).dissipated;
                let forces = [strength, model.friction_force_at_load(ratio * load)];
                let most = work_before + forces[0].max(forces[1]) * path.abs() * length;
                let least = 0.9 * forces[0].min(forces[1]) * path.abs() * length;
                assert!(all < 1.001 * most && (all > least || path < 0.0), "{what}: {all}, not {least} to {most}");
            }
        }
    }
}

#[test]
fn load_that_falls_at_rest_takes_what_was_stored_in_any_number_of_steps() {
    for params in surfaces().into_iter().filter(|params| params.work_of_adhesion == 0.0) {
        let model = model(&params);
        let load = model.state_at_gap(0.0).expect("a state").load;
        let (_, length) = strength_and_length(&model, load);
        for path in [0.02, 0.3, 2.0, 1e4] {
            let mut moved = [0.0; MICROSLIP_LENGTH];
            step(&model, load, [path * length, 0.0], &mut moved);
            let stored = step(&model, 0.0, [0.0; 2], &mut moved.clone()).dissipated;
            for steps in [1, 3, 30, 300] {
                for evenly in [false, true] {
                    let mut state = moved;
                    let mut lost = 0.0;
                    for i in 1..=steps {
                        let part = f64::from(i) / f64::from(steps);
                        let now = load * if evenly { 1.0 - part } else { 1e-6_f64.powf(part) };
                        lost += step(&model, now, [0.0; 2], &mut state).dissipated;
                    }
                    lost += step(&model, 0.0, [0.0; 2], &mut state).dissipated;
                    assert_near(lost, stored, 1e-9, &format!("{params:?}, {path}, {steps} steps"));
                }
            }
        }
    }
}

/// The load rises while the surfaces are displaced, by little, so that nothing slips.
#[test]
fn a_path_may_be_taken_in_any_number_of_steps_while_the_load_rises() {
    for params in surfaces() {
        let model = model(&params);
        let half = model.state_at_gap(0.0).expect("a state").load;
        let separation = |load: f64| model.state_at_load(load).expect("a state").gap / params.height_std;
        let at = |height: f64| model.state_at_gap(height * params.height_std).expect("a state").load;
        let (high, low) = (separation(0.1 * half), separation(0.3 * half));
        let (_, length) = strength_and_length(&model, at(high));
        let by = 1e-4 * length;
        let parts = 2000;
        let place = |part: f64| at(high + (low - high) * part);
        let exact = (0..parts)
            .map(|i| {
                model.tangential_stiffness_at_load(place((f64::from(i) + 0.5) / f64::from(parts))) * by
                    / f64::from(parts)
            })
            .sum::<f64>();
        for (steps, tolerance) in [(1, 0.1), (2, 0.03), (8, 5e-3), (64, 5e-4)] {
            let mut state = [0.0; MICROSLIP_LENGTH];
            step(&model, at(high), [0.0; 2], &mut state);
            let mut force = 0.0;
            for i in 1..=steps {
                let load = place(f64::from(i) / f64::from(steps));
                force = step(&model, load, [by / f64::from(steps), 0.0], &mut state).force[0];
            }
            assert_near(force, exact, tolerance, &format!("{params:?}, {steps} steps"));
        }
    }
}

/// The displacement of polished steel back and forth while the load falls and rises (a closed cycle of both).
#[test]
fn a_cycle_of_yielding_steel_takes_work() {
    let bodies = asperity::materials::Bodies::find("steel/steel").expect("a pair");
    let mut params = Params::default();
    params.set_bodies(&bodies).expect("bodies");
    (params.height_std, params.summit_radius, params.asperity_count) = (0.3e-6, 10e-6, 1.2e6);
    (params.work_of_adhesion, params.contact_law) = (0.0, ContactLawKind::ElasticPlastic);
    params.calibrate(10.0, 1.6).expect("a calibration");
    let model = model(&params);
    let (strength, length) = strength_and_length(&model, 10.0);
    for amplitude in [0.02, 0.1, 0.3] {
        for low in [7.0, 3.0, 1.0] {
            let mut state = [0.0; MICROSLIP_LENGTH];
            let (mut work, mut lost, mut before) = (0.0, 0.0, 0.0);
            for (load, path) in [(10.0, amplitude), (low, 0.0), (low, -amplitude), (10.0, 0.0)] {
                for _ in 0..200 {
                    let by = path * length / 200.0;
                    let found = step(&model, load, [by, 0.0], &mut state);
                    work += 0.5 * (before + found.force[0]) * by;
                    before = found.force[0];
                    lost += found.dissipated;
                }
            }
            let unit = 0.5 * strength / length * (amplitude * length).powi(2);
            let gone = 1.0 - model.tangential_stiffness_at_load(low) / model.tangential_stiffness_at_load(10.0);
            // At small amplitude all that is lost is what the contacts held that separated.
            assert!(work / unit > 0.9 * gone && work / unit < 2.0, "{amplitude}, {low}: {}, {gone}", work / unit);
            assert!(lost <= work * (1.0 + 1e-3) && lost > 0.9 * work, "{amplitude}, {low}: {lost} of {work}");
        }
    }
}

#[test]
fn a_contact_that_opens_forgets_and_one_at_zero_load_begins_anew() {
    let hertz = model(&dimensionless(0.01, 1000.0, 0.0, 1.0));
    let mut state = [0.0; MICROSLIP_LENGTH];
    let pushed = step(&hertz, 1.0, [1.0, 2.0], &mut state);
    assert!(pushed.force[0] > 0.0 && state != [0.0; MICROSLIP_LENGTH]);
    let mut open = state;
    assert!(hertz.microslip_step(-1.0, [1.0, 0.0], &mut open).is_err());
    assert_eq!(open, [0.0; MICROSLIP_LENGTH]);
    let none = step(&hertz, 0.0, [1.0, 0.0], &mut state);
    assert_eq!((none.force, none.stiffness, state), ([0.0; 2], [0.0; 4], open));
    // What the contact held.
    assert!(none.dissipated > 0.0 && none.dissipated < 0.5 * pushed.force[0].hypot(pushed.force[1]) * 5.0_f64.sqrt());
    // The next load gives this slope.
    let tiny = hertz.summary().min_table_load;
    for displacement in [1e-3, 1e3] {
        let zero = step(&hertz, 0.0, [displacement, 0.0], &mut [0.0; MICROSLIP_LENGTH]);
        let next = step(&hertz, tiny, [displacement, 0.0], &mut [0.0; MICROSLIP_LENGTH]);
        assert_near(zero.dforce_dload[0], next.force[0] / tiny, 0.1, &format!("{displacement}"));
    }
    // With adhesion zero load is as any other, and so is the pull-off load itself.
    let adhesive = model(&Params::paper());
    for load in [0.0, adhesive.summary().pull_off_load] {
        let (strength, length) = strength_and_length(&adhesive, load);
        let found = step(&adhesive, load, [0.5 * length, 0.0], &mut [0.0; MICROSLIP_LENGTH]);
        assert!(found.force[0] > 0.4 * strength && found.force[0] < 0.5 * strength, "{found:?}");
        assert!(found.dforce_dload[0] > 0.0 && found.dforce_dload[0].is_finite(), "{found:?}");
    }
}

/// As it is after a heavy load: springs far longer than the farthest slip of the light one.
#[test]
fn what_was_moved_far_under_a_heavy_load_is_at_most_the_friction_of_a_light_one() {
    for params in surfaces() {
        let model = model(&params);
        let half = model.state_at_gap(0.0).expect("a state").load;
        let (heavy, light) = (100.0 * half, 1e-3 * half);
        let [(_, long), (strength, _)] = [heavy, light].map(|load| strength_and_length(&model, load));
        for times in [1e3, 1e9, 1e300] {
            let mut state = [0.0; MICROSLIP_LENGTH];
            step(&model, heavy, [times * long, 0.0], &mut state);
            let left = step(&model, light, [0.0, 0.0], &mut state).force;
            assert!((0.0..=strength * (1.0 + 1e-12)).contains(&left[0]) && left[1] == 0.0, "{left:?} of {strength}");
            let moved = step(&model, light, [times * long, 0.0], &mut state).force;
            assert_near(moved[0], strength, 1e-9, "all slip");
        }
    }
}
