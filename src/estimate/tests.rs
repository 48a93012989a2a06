//! What an estimate says, and how often it is right.

use super::known::{deviation, DEFAULT_FACTOR, PROCESSES, SLOPE_FACTOR};
use super::{write, Answer, Estimate};
use crate::by_name::{describe, Case};
use crate::materials::PAIRS;
use crate::model::Model;
use crate::params::{ContactLawKind, Params};

/// Nothing is measured on this pair of the table of interfaces.
const GROUND: &str = "pair = \"stainless/stainless\"\nnominal_area = 1e-4\n";
const STEEL: &str = "pair = \"steel/steel\"\nnominal_area = 1e-4\n";
const SILICON: &str = "pair = \"Si/Si\"\nnominal_area = 1e-8\n";
const ROUGH: &str = "[roughness]\nprocess = \"ground\"\nRa = 0.8e-6\n";
const SMOOTH: &str = "[roughness]\nSq = 5e-9\nSdq = 0.08\n";

fn estimate(text: &str, loads: &[f64]) -> (Estimate, Vec<Answer>) {
    let estimate = Estimate::new(text.as_bytes(), loads).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let answers = loads.iter().map(|&load| estimate.at_load(load).expect("an answer")).collect();
    (estimate, answers)
}

fn answer(text: &str, load: f64) -> Answer {
    estimate(text, &[load]).1[0]
}

fn written(text: &str, loads: &[f64]) -> String {
    let (estimate, answers) = estimate(text, loads);
    let mut out = String::new();
    write(&estimate, text.as_bytes(), &answers, estimate.warnings(loads).expect("warnings"), &mut out).expect("a text");
    out
}

fn refused(text: &str) -> String {
    match Estimate::new(text.as_bytes(), &[1.0]) {
        Ok(_) => panic!("taken: {text}"),
        Err(error) => error.to_string(),
    }
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found}, not {expected}");
}

#[test]
fn ground_steel_at_another_load_than_the_measured_one() {
    let found = answer(&format!("{STEEL}measured = [1000, 0.16]\n{ROUGH}"), 10.0);
    assert!((found.friction_coefficient - 0.194).abs() < 5e-4, "{found:?}");
    assert!(found.low > 0.16 && found.low < found.friction_coefficient && found.high < 0.23, "{found:?}");
    assert!(found.roughness_share > 0.3 && found.measurement_share > 0.3 && found.strength_share < 0.01, "{found:?}");
}

/// With what is said to be unknown drawn as it is said to be, 95 % of the bands have the friction of the surface drawn.
#[test]
fn bands_have_the_coverage_that_they_say() {
    const REPEATS: u32 = 1000;
    const LOADS: [f64; 2] = [10.0, 1000.0];
    let mut random = 20261126_u64;
    let mut uniform = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((random >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    };
    let mut normal = || (-2.0 * uniform().ln()).sqrt() * (2.0 * std::f64::consts::PI * uniform()).cos();
    let text = format!("{GROUND}{ROUGH}");
    let unmeasured = answer(&text, LOADS[0]);
    let (mut without, mut with) = (0, 0);
    for _ in 0..REPEATS {
        let case = Case { slope: (deviation(SLOPE_FACTOR) * normal()).exp(), ..Case::MIDDLE };
        let mut params = describe(text.as_bytes(), case).expect("a surface").params;
        params.contact_law = ContactLawKind::ElasticPlastic;
        params.work_of_adhesion = 0.0;
        // The slip stress of a stronger one would be above the shear modulus of the bodies.
        let factor = (deviation(DEFAULT_FACTOR) * normal()).exp().min(20.0);
        params.slip.stress_1 *= factor;
        params.slip.stress_2 *= factor;
        let model = Model::between(&params, LOADS).expect("a model");
        let [truth, there] = LOADS.map(|load| model.friction_force_at_load(load) / load);
        without += u32::from(unmeasured.low < truth && truth < unmeasured.high);
        let seen = there * (0.05 * normal()).exp();
        let found = answer(&format!("{GROUND}measured = [{}, {seen}]\n{ROUGH}", LOADS[1]), LOADS[0]);
        with += u32::from(found.low < truth && truth < found.high);
    }
    println!("covered: {without} and {with} of {REPEATS}");
    assert!((930..=970).contains(&without), "{without}");
    assert!((930..=970).contains(&with), "{with}");
}

/// A default strength is a factor of 10 either way, whatever else; a strength that is given is known.
#[test]
fn a_default_strength_is_an_order_of_magnitude() {
    let text = format!("{SILICON}{SMOOTH}");
    let found = answer(&text, 1e-3);
    assert_near(found.low, found.friction_coefficient / 10.0, 1e-7);
    assert_near(found.high, found.friction_coefficient * 10.0, 1e-7);
    assert_eq!((found.strength_share, found.roughness_share, found.measurement_share), (1.0, 0.0, 0.0));
    let shown = written(&text, &[1e-3]);
    assert!(shown.starts_with("mu(0.001 N) = 0.43") && shown.contains(" to an order of magnitude, 0.043"), "{shown}");
    let half = answer(&format!("coverage = 0.5\n{text}"), 1e-3);
    assert_near(half.high, half.friction_coefficient * 10.0_f64.powf(0.674_489_75 / 1.959_963_98), 1e-7);
    let given = answer(&format!("slip_stress_1 = 0.02\n{text}"), 1e-3);
    assert_eq!((given.low, given.high), (given.friction_coefficient, given.friction_coefficient));
    assert!(written(&format!("slip_stress_1 = 0.02\n{text}"), &[1e-3]).contains("no band: all inputs count as known"));
}

#[test]
fn what_was_measured_on_the_pair_is_the_first_line() {
    let text = written(&format!("{STEEL}{ROUGH}"), &[10.0]);
    let first = text.lines().next().expect("a line");
    for row in ["steel/steel dry 0.57 at 12 N", "clean 0.78", "oxidised 0.27"] {
        assert!(first.contains(row), "{text}");
    }
    assert!(!first.contains("grease") && !first.contains("ZDDP") && text.contains("from the 3 rows"), "{text}");
    let found = answer(&format!("{STEEL}{ROUGH}"), 10.0);
    assert!(found.low > 0.1 && found.low < 0.27 && found.high > 0.78 && found.high < 2.0, "{found:?}");
    // That which is named stands alone, at its load.
    let dry = format!("interface = \"steel/steel dry\"\n{STEEL}{ROUGH}");
    assert_near(answer(&dry, 12.0).friction_coefficient, 0.57, 1e-7);
    assert!(written(&dry, &[12.0])
        .starts_with("measured on other specimens: steel/steel dry 0.57 at 12 N\nmu(12 N) = 0.57, "));
    // Those of a shear strength are a strength.
    let film = format!("interface = \"MoS2 film in dry air\"\n{STEEL}{ROUGH}");
    let params = Params::from_toml(&film).expect("a surface");
    assert!(params.pressure_coefficient == 0.001 && params.slip.stress_1 == params.slip.stress_2);
    assert!(written(&film, &[12.0]).contains("shear strength 24.8 MPa"));
    // A measurement here is worth more than any of them.
    assert!(!written(&format!("{STEEL}measured = [10, 0.1]\n{ROUGH}"), &[10.0]).contains("other specimens"));
}

/// Whatever an estimate chose beside its text, a text of its parameters has it.
#[test]
fn the_parameters_of_an_estimate_have_its_friction_its_strength_and_its_law() {
    let rough = PROCESSES.iter().map(|process| format!("process = \"{}\"\n", process.name));
    let rough: Vec<_> = rough.chain(["Ra = 0.2e-6\nRSm = 40e-6\n".into(), SMOOTH[12..].into()]).collect();
    let (mut yielding, mut calibrated) = (0, 0);
    for (pair, rough) in PAIRS.iter().zip(rough.iter().cycle()) {
        let name = pair.name.to_str().expect("UTF-8");
        // An elastomer has no Burgers vector.
        let slip = if name.contains("PDMS") { "burgers_vector = 50e-9\n" } else { "" };
        for points in ["", "measured = [1, 0.2]\n", "measured = [[1, 0.2], [100, 0.17]]\n"] {
            let text = format!("pair = \"{name}\"\n{slip}nominal_area = 1e-4\n{points}[roughness]\n{rough}");
            let (estimate, answers) = estimate(&text, &[0.5, 100.0]);
            let params = Params::from_toml(&estimate.params().to_toml()).expect("a surface");
            assert_eq!(&params, estimate.params(), "{text}");
            assert_eq!(estimate.described.yields, params.contact_law == ContactLawKind::ElasticPlastic, "{text}");
            yielding += u32::from(estimate.described.yields);
            calibrated += u32::from(params.calibration_friction_force > 0.0);
            let model = Model::new(&params).expect("a model");
            for found in answers {
                let off = model.friction_force_at_load(found.load) / found.friction_force - 1.0;
                assert!(off.abs() < 3e-8, "{off:e}, {text}");
            }
        }
    }
    assert!(yielding > 10 && calibrated >= PAIRS.len() as u32, "{yielding} {calibrated}");
}

/// The summits that are expected, and what single specimens of them have.
#[test]
fn few_contacts_are_counted_and_told() {
    let text = format!("{SILICON}{SMOOTH}");
    let loads = [1e-2, 2e-5, 3e-7, 0.0];
    let (estimate, found) = estimate(&text, &loads);
    let model = Model::new(estimate.params()).expect("a model");
    for one in &found[..3] {
        assert_near(one.contacts, model.state_at_load(one.load).expect("a state").contacting, 1e-12);
    }
    assert!(!found[0].is_few && found[1..].iter().all(|one| one.is_few), "{found:?}");
    assert_near(found[0].specimen_force, found[0].friction_force, 2e-3);
    assert!(found[1].contacts > 1.0 && found[1].specimen_force > 1.05 * found[1].friction_force, "{found:?}");
    assert!(found[1].specimen_scatter > 0.1 && found[1].specimen_scatter < 0.5, "{found:?}");
    assert!(found[2].contacts < 1.0 && found[2].specimen_scatter.is_nan(), "{found:?}");
    // Without a load a summit adheres, however far off the mean of all surfaces is.
    assert!(found[2].specimen_force > found[3].specimen_force && found[3].specimen_force > 1e-7, "{found:?}");
    let shown = written(&text, &loads);
    for says in [
        " summits touch at 2e-5 N: single specimens have ",
        " on average, with a standard deviation of ",
        " summits touch at 3e-7 N: one specimen stands on one or two, with ",
        "mu(0 N) has no limit: a specimen adheres by its tallest summits, with a friction force of ",
    ] {
        assert!(shown.contains(says), "{shown}");
    }
    assert_eq!(shown.matches("few contacts: ").count(), 2, "{shown}");
    // One specimen is as far off as the strength, and its own scatter.
    let [least, most] = ["band of one ", " to "].map(|before| {
        let line = shown.lines().find(|line| line.contains("band of one")).expect("a line");
        let number = line[line.find("band of one").expect("it")..].split(before).nth(1).expect("a number");
        number.split(' ').next().and_then(|number| number.parse::<f64>().ok()).expect("a number")
    });
    let reach = (10.0_f64.ln().powi(2) + (1.959_964 * found[1].specimen_scatter).powi(2)).sqrt();
    let mean = found[1].specimen_force / found[1].load;
    assert_near(least, mean * (-reach).exp(), 5e-3);
    assert_near(most, mean * reach.exp(), 5e-3);
    // The same holds for surfaces so rough that the mean has no number.
    let rough = answer(&format!("work_of_adhesion = 1e-4\n{text}"), 0.0);
    assert!(rough.friction_force == 0.0 && rough.friction_coefficient == f64::INFINITY, "{rough:?}");
    assert!(rough.specimen_force > 1e-10 && rough.specimen_force < found[3].specimen_force, "{rough:?}");
    // A point measured on few summits is asked for.
    let measured = |load: f64| written(&format!("{SILICON}measured = [{load}, 0.4]\n{SMOOTH}"), &[1e-2]);
    assert!(!measured(1e-2).contains("check"), "{}", measured(1e-2));
    let few = measured(3e-7);
    assert!(few.contains(" summits touch at the measured 3e-7 N: the point is of one specimen"), "{few}");
    // One summit is itself, and metal that yields does not adhere.
    let tip = "pair = \"Si/Si\"\nheight_std = 3e-13\nsummit_radius = 30e-9\nasperity_count = 1\n";
    let found = answer(tip, 1e-8);
    assert_eq!((found.specimen_force, found.specimen_scatter, found.is_few), (found.friction_force, 0.0, false));
    let found = answer(&format!("{STEEL}{ROUGH}"), 0.0);
    assert_eq!((found.friction_force, found.specimen_force, found.contacts), (0.0, 0.0, 0.0));
}

#[test]
fn without_an_area_loads_are_pressures_and_are_called_so() {
    let at = |area: &str, load: f64| format!("pair = \"steel/steel\"\n{area}measured = [{load}, 0.16]\n{ROUGH}");
    let (by_pressure, by_load) = (answer(&at("", 1e7), 1e5), answer(&at("nominal_area = 1e-4\n", 1e3), 10.0));
    assert_near(by_pressure.friction_coefficient, by_load.friction_coefficient, 1e-7);
    assert!(by_pressure.contacts.is_nan() && by_pressure.specimen_force.is_nan(), "{by_pressure:?}");
    let shown = written(&at("", 1e7), &[1e5, 0.0, -1.0]);
    assert!(shown.starts_with("mu(100000 Pa) = 0.19") && !shown.contains(" N"), "{shown}");
    assert!(
        shown.contains("rests on: loads are nominal pressures in Pa") && shown.contains("0.16 at 1e7 Pa"),
        "{shown}"
    );
    assert!(written(&at("", 1.0), &[10.0]).contains("is load in Pa? Give nominal_area"));
    let adheres = written(&format!("pair = \"Si/Si\"\n{SMOOTH}"), &[0.0]);
    assert!(adheres.starts_with("mu(0 Pa) has no limit: the tallest summits adhere, how many depends"), "{adheres}");
    // A number of summits is an area too.
    let counted = "pair = \"Si/Si\"\nheight_std = 5e-9\nsummit_radius = 1e-6\nasperity_count = 1e5\n";
    assert!(written(counted, &[1e-3]).contains("mu(0.001 N)"));
}

#[test]
fn at_no_load_the_limit_is_said_and_no_cap() {
    let loads = [1e-3, 0.0, -1e-12, -1.0];
    let rubber =
        "composite_modulus = 1e6\neffective_shear_modulus = 1e6\nwork_of_adhesion = 0.05\nadhesion_range = 0.5e-9\n\
                  burgers_vector = 10e-9\nheight_std = 10e-9\nsummit_radius = 1e-6\nasperity_count = 1e6\n";
    let found = estimate(rubber, &loads).1;
    assert!(found[1].friction_coefficient == f64::INFINITY && found[1].friction_force > 0.0, "{found:?}");
    assert!(found[2].high == f64::INFINITY && found[3].friction_coefficient == 0.0, "{found:?}");
    let text = written(rubber, &loads);
    assert!(text.contains("mu(0 N) has no limit: adhesion gives a friction force of"), "{text}");
    assert!(text.contains("mu(-1 N) = 0: the surfaces are apart"), "{text}");
    let text = written(&format!("{STEEL}{ROUGH}"), &[0.0, -1.0]);
    assert!(text.contains("mu(0 N) has no limit: it grows as the load goes to 0"), "{text}");
    let light = answer(&format!("{SILICON}max_friction_coefficient = 0.1\n{SMOOTH}"), 1e-3);
    assert!(light.friction_coefficient > 0.4, "capped: {light:?}");
}

#[test]
fn metal_that_yields_takes_the_law_that_knows_it() {
    let yields = "asperities yield, plasticity index";
    assert!(written(&format!("{STEEL}{ROUGH}"), &[10.0]).contains(yields));
    for own in ["contact_law = \"maugis\"\n", "work_of_adhesion = 0.1\n"] {
        assert!(!written(&format!("{own}{STEEL}{ROUGH}"), &[10.0]).contains(yields), "{own}");
    }
    assert!(!written(&format!("{SILICON}{SMOOTH}"), &[1e-3]).contains(yields));
}

#[test]
fn what_is_known_of_a_process_makes_the_band_narrower() {
    let points = "measured = [1000, 0.16]\n";
    let width = |rough: &str| {
        let found = answer(&format!("{GROUND}{points}[roughness]\n{rough}"), 1.0);
        found.high / found.low
    };
    let nothing = width("process = \"ground\"\n");
    let height = width("process = \"ground\"\nRa = 0.8e-6\n");
    let both = width("process = \"ground\"\nRa = 0.8e-6\nRSm = 80e-6\n");
    assert!(nothing > height && height > both, "{nothing} {height} {both}");
    assert_eq!(both, width("Ra = 0.8e-6\nRSm = 80e-6\n"));
    for process in PROCESSES {
        let text = format!("{GROUND}[roughness]\nprocess = \"{}\"\n", process.name);
        let (found, _) = estimate(&text, &[10.0]);
        assert!(found.cases.len() == 5 && written(&text, &[10.0]).contains(process.name), "{text}");
    }
    let text = written(&format!("{GROUND}[roughness]\nprocess = \"ground\"\nRa = 10e-6\n"), &[10.0]);
    assert!(text.contains("check: Ra = 10 um: ground surfaces have 0.1 to 1.6 um: is it of this process"), "{text}");
    // Two rough surfaces: their mean squares add.
    let two = answer(&format!("{GROUND}[roughness]\nprocess = \"ground\"\nRa = [0.8e-6, 0.4e-6]\n"), 10.0);
    assert!(two.friction_coefficient > 0.0);
}

/// Points at loads far apart tell how much of friction goes with pressure; at one load they do not.
#[test]
fn several_points_tell_the_pressure_coefficient_where_they_reach_over_loads() {
    let text = |points: &str| format!("{STEEL}measured = {points}\n{ROUGH}");
    let kappa = |points: &str| Params::from_toml(&text(points)).expect("a surface").pressure_coefficient;
    // Amontons' law, but for what of the strength is left.
    let constant = kappa("[[1000, 0.16], [10, 0.16], [0.1, 0.16]]");
    assert!(constant > 0.1 && constant < 0.16, "{constant}");
    assert_eq!(kappa("[[1000, 0.16], [1000, 0.18], [1000, 0.15]]"), 0.0);
    assert_eq!(kappa("[[1000, 0.16]]"), 0.0);
    // Points made with a pressure coefficient lead to it.
    let made = format!("pressure_coefficient = 0.08\n{}", text("[1000, 0.16]"));
    let model = Model::new(&Params::from_toml(&made).expect("a surface")).expect("a model");
    let at = |load: f64| format!("[{load}, {}, 0.001]", model.friction_at_load(load));
    let points = format!("[{}, {}, {}]", at(1e3), at(10.0), at(0.1));
    assert!((kappa(&points) - 0.08).abs() < 2e-3, "{}", kappa(&points));
    let found = answer(&text(&points), 1.0);
    assert_near(found.friction_coefficient, model.friction_at_load(1.0), 2e-3);
    assert!(found.low < model.friction_at_load(1.0) && model.friction_at_load(1.0) < found.high, "{found:?}");
    // One that is given stays.
    let given = format!("pressure_coefficient = 0.01\n{}", text(&points));
    assert_eq!(Params::from_toml(&given).expect("a surface").pressure_coefficient, 0.01);
}

#[test]
fn a_trend_that_the_law_cannot_follow_is_told() {
    let rising = format!("{STEEL}measured = [[1, 0.1], [30, 0.2], [1000, 0.4]]\n{ROUGH}");
    let (found, answers) = estimate(&rising, &[30.0]);
    assert!(found.misfit > 5.0, "{}", found.misfit);
    assert!(answers[0].high / answers[0].low > 1.3, "{answers:?}");
    assert!(written(&rising, &[30.0]).contains("off the law, which cannot follow their trend"));
    let falling = format!("{STEEL}measured = [[1, 0.2], [30, 0.18], [1000, 0.16]]\n{ROUGH}");
    let (found, _) = estimate(&falling, &[30.0]);
    assert!(found.misfit < 1.0 && !written(&falling, &[30.0]).contains("off the law"), "{}", found.misfit);
    // A point more is a narrower band, in whichever order they come.
    let one = answer(&format!("{STEEL}measured = [1000, 0.16]\n{ROUGH}"), 1000.0);
    let two = answer(&format!("{STEEL}measured = [[1000, 0.16], [1000, 0.16]]\n{ROUGH}"), 1000.0);
    assert_near((two.high / two.low).ln() * 2.0_f64.sqrt(), (one.high / one.low).ln(), 1e-2);
    let [first, other] = ["[[1000, 0.16], [10, 0.18]]", "[[10, 0.18], [1000, 0.16]]"]
        .map(|points| answer(&format!("{STEEL}measured = {points}\n{ROUGH}"), 1.0));
    assert_near(first.low, other.low, 1e-9);
    assert_near(first.friction_coefficient, other.friction_coefficient, 1e-9);
}

#[test]
fn slips_of_units_that_no_contact_has_are_asked_for() {
    let at = |text: &str, load: f64| written(&format!("{text}{ROUGH}"), &[load]);
    for good in [at(STEEL, 10.0), at(STEEL, 1.0), at("pair = \"steel/steel\"\nnominal_area = 1\n", 78.0)] {
        assert!(!good.contains("check"), "{good}");
    }
    // In mm^2; a load without an area; a load in GN.
    let in_square_mm = at("pair = \"steel/steel\"\nnominal_area = 100\n", 1000.0);
    let says = "check: the nominal pressure is 10 Pa, and a steel sheet of 1 mm has 77 Pa: is load in N, and nominal_area in m^2?";
    assert!(in_square_mm.contains(says), "{in_square_mm}");
    assert!(at(STEEL, 1e6).contains("above the hardness, which no contact bears: is load in N"), "{}", at(STEEL, 1e6));
    // The heaviest counts, of the measured points too.
    assert!(!at(&format!("{STEEL}measured = [10, 0.2]\n"), 1e-3).contains("check"));
    for (text, says) in [
        (
            format!("{SILICON}[roughness]\nSq = 5e-9\nSdq = 1.5\n"),
            "check: the slope of the surface is 1.5: is it in degrees",
        ),
        (format!("{SILICON}work_of_adhesion = 6.3\n{SMOOTH}"), "check: work_of_adhesion is 6.3: is it in mJ/m^2?"),
        (
            format!("{SILICON}pressure_coefficient = 24\n{SMOOTH}"),
            "check: pressure_coefficient is 24: is it in per cent?",
        ),
    ] {
        assert!(written(&text, &[1e-3]).contains(says), "{}", written(&text, &[1e-3]));
    }
    // In per cent: more than the bodies bear, than any surfaces have, or to be asked for.
    assert!(refused(&format!("{STEEL}measured = [1000, 16]\n{ROUGH}"))
        .contains("is the coefficient in per cent (16 for 0.16)"));
    assert!(refused(&format!("{STEEL}measured = [1000, 30]\n{ROUGH}")).contains("or is it in per cent?"));
    let measured = |points: &str| written(&format!("{SILICON}measured = {points}\n{SMOOTH}"), &[1e-2]);
    let sticky = written(&format!("{SILICON}measured = [1e-6, 6]\n{SMOOTH}"), &[1e-6]);
    assert!(sticky.contains("check: the measured friction coefficient is 6: is it in per cent (0.06)?"), "{sticky}");
    assert!(
        !sticky.contains("is it the load")
            && measured("[0.1, 6]").contains("(0.06)? Or is it the load? A point is [load")
    );
    assert!(!written(&format!("{SILICON}measured = [1e-6, 4]\n{SMOOTH}"), &[1e-6]).contains("per cent"));
    // Load and coefficient swapped, of one point and of several.
    let says = "check: the measured friction coefficient is 0.001, dry surfaces have more: is it the load? A point is [load, coefficient]";
    for points in ["[0.3, 1e-3]", "[[0.3, 0.16], [0.3, 1e-3]]"] {
        assert!(measured(points).contains(says), "{}", measured(points));
    }
    let says = "check: friction coefficients of 0.1 to 1 at 0.16 to 0.19 N: are the two swapped?";
    assert!(measured("[[0.19, 0.1], [0.16, 1]]").contains(says));
    for right in ["[0.3, 0.011]", "[[0.1, 0.19], [1, 0.16]]", "[[0.3, 0.1], [0.3, 0.4]]", "[[2.1, 0.1], [2.2, 0.4]]"] {
        assert!(!measured(right).contains("A point is"), "{}", measured(right));
    }
    // What adheres has friction at light loads; a count is that of an area too, and may be a density.
    let light = |text: &str, load: f64| written(&format!("{text}{SMOOTH}"), &[load]);
    assert!(
        !light(SILICON, 1.1e-8).contains("check") && light(SILICON, 0.9e-8).contains("check: the nominal pressure")
    );
    let summits = "pair = \"Si/Si\"\nheight_std = 5e-9\nsummit_radius = 1e-6\n";
    let counted = |count: f64| written(&format!("{summits}asperity_count = {count}\n"), &[1e-3]);
    assert!(!counted(1e5).contains("check") && !counted(1.0).contains("check"));
    let says = "check: the nominal pressure is 0.001 Pa, and a steel sheet of 1 mm has 77 Pa: is load in N, and asperity_count a number";
    assert!(counted(1e13).contains(says), "{}", counted(1e13));
}

/// What makes the answer is told of the bodies, with what another makes of it; nothing is told of what is given.
#[test]
fn what_is_taken_of_materials_is_told() {
    let told = |text: &str| {
        let text = written(text, &[10.0]);
        let lines = text.lines().filter_map(|line| line.strip_prefix("rests on: "));
        let of = ["E = ", "hardness = ", "work of adhesion ", "elastic asperities: "];
        lines.filter(|line| of.iter().any(|of| line.starts_with(of))).map(str::to_owned).collect::<Vec<_>>()
    };
    let hard = format!("measured = [1000, 0.16]\n{STEEL}{ROUGH}");
    let soft = format!("hardness = 2e9\n{hard}");
    let with_soft = answer(&soft, 10.0).friction_coefficient;
    let steel = "E = 205 GPa and nu = 0.3 of steel";
    let hardness =
        format!("hardness = 7.5 GPa of steel, AISI 52100 hardened to 60-64 HRC: with 2 GPa mu(10 N) is {with_soft:.2}");
    assert!((0.175..0.185).contains(&with_soft), "{with_soft}");
    assert_eq!(told(&hard), [steel, &hardness]);
    assert_eq!(told(&soft), [steel]);
    let moduli = "[materials]\nE1 = 200e9\nnu1 = 0.29\n";
    assert_eq!(told(&format!("{soft}{moduli}")), [""; 0]);
    // Where the strength is not measured, friction goes as one over the hardness; half and twice it are told of a body without a range.
    let [_, stainless] = &told(&format!("{GROUND}{ROUGH}"))[..] else { panic!("two lines") };
    let begins = "hardness = 1.27 GPa of stainless, AISI 304 annealed: with 635 MPa mu(10 N) is 0.19";
    assert!(stainless.starts_with(begins) && stainless.contains(", with 2.54 GPa 0.05"), "{stainless}");
    // The hardness of silicon that does not yield is nothing to the answer.
    let silicon = "E = 160 GPa and nu = 0.22 of Si";
    let adhesion = "work of adhesion 0.063 J/m^2 of Si/Si, measured and estimated 0.03 to 0.144";
    assert_eq!(told(&format!("{SILICON}{SMOOTH}")), [silicon, adhesion]);
    assert_eq!(told(&format!("work_of_adhesion = 0.1\n{SILICON}{SMOOTH}")), [silicon]);
    // Smooth steel does not, but softer steel does.
    let smooth = told(&format!("{STEEL}measured = [1000, 0.16]\n[roughness]\nRa = 0.2e-6\nRSm = 80e-6\n"));
    assert!(smooth.len() == 3 && smooth[2].contains(": with 2 GPa mu(10 N) is 0.203"), "{smooth:?}");
    let [bodies, _, unknown] = &told(&format!("pair = \"Au/mica\"\nnominal_area = 1e-4\n{SMOOTH}"))[..] else {
        panic!("three lines")
    };
    assert_eq!(bodies, "E = 78 GPa and nu = 0.44 of Au, E = 54 GPa and nu = 0.1 of mica");
    assert!(unknown.starts_with("elastic asperities: the hardness of mica is not known"), "{unknown}");
    let own = "work_of_adhesion = 0\nadhesion_range = 0.25e-9\nburgers_vector = 0.25e-9\nnominal_area = 1e-4\n";
    let alone = format!("{own}{ROUGH}[materials]\nE1 = 200e9\nnu1 = 0.29\nE2 = 200e9\nnu2 = 0.29\n");
    assert_eq!(told(&alone), ["elastic asperities: the hardness is not known, give it if they yield"]);
    assert_eq!(told(&format!("hardness = 2e9\n{alone}")), [""; 0]);
}

#[test]
fn what_cannot_be_read_is_refused_where_it_is() {
    for (text, says) in [
        ("measured = 0.16\n", "line 1: measured = 0.16: must be points [load, coefficient] or"),
        ("measured = []\n", "line 1: measured = [...]: must be points"),
        ("measured = [1000]\n", "line 1: measured: point 1: must be [load, coefficient] or"),
        ("measured = [[1000, 0.16], [10]]\n", "line 1: measured: point 2: must be [load, coefficient] or"),
        (
            "measured = [[1000, 160]]\n",
            "line 1: measured: point 1: coefficient = 160: must be > 0 and at most 20; is it a force?",
        ),
        ("measured = [[-1, 0.16]]\n", "line 1: measured: point 1: load = -1: must be > 0"),
        (
            "measured = [0.3, 1e-5]\n",
            "line 1: measured: point 1: coefficient = 1e-5: most are between 0.001 and 10, as the load",
        ),
        (
            "measured = [0.16, 12]\n",
            "line 1: measured: point 1: coefficient = 12: most are between 0.001 and 10, as the load is",
        ),
        ("measured = [[1000, 0.16, 5]]\n", "line 1: measured: point 1: error = 5: must be > 0 and at most 1"),
        ("measured = [[1000, 0.16], 3]\n", "line 1: measured: must be an array of numbers, or of arrays of numbers"),
        ("measured = [[[1]]]\n", "line 1: measured: must be an array of numbers, or of arrays of numbers"),
        ("coverage = 95\n", "line 1: coverage = 95: must be between 0 and 1: is it in per cent?"),
        ("coverage = 0\n", "line 1: coverage = 0: must be between 0 and 1"),
        (
            "measured = [1, 0.1]\ncalibration_load = 1\ncalibration_friction_force = 1\n",
            "line 1: measured: calibration_load",
        ),
        (
            "mu = 0.3\n",
            "line 1: mu: no such key; give calibration_friction_coefficient with calibration_load, in a text also",
        ),
        (
            "slip_stress_1 = 0\nslip_stress_2 = 0\npressure_coefficient = 0.1\n",
            "slip_stress_1: must be > 0 for an estimate",
        ),
    ] {
        let found = refused(&format!("{text}{STEEL}{ROUGH}"));
        assert!(found.starts_with(says), "{found}\nnot\n{says}");
    }
    // The message names the point that is wrong.
    for [wrong, right] in [[1, 0], [0, 1]].map(|order| order.map(|i| ["[1000, 0.16]", "[10, 15]"][i])) {
        let found = refused(&format!("{STEEL}measured = [{wrong}, {right}]\n{ROUGH}"));
        assert!(found.starts_with("line 3: friction_force = 150 at load = 10: must be at most 12.4"), "{found}");
    }
    for (rough, says) in [
        (
            "process = \"grund\"",
            "[roughness] process = \"grund\": must be one of superfinished, lapped, honed, ground,",
        ),
        ("process = 3", "[roughness] process = 3: must be one of superfinished"),
        ("process = \"ground\"\nSq = 1e-6\nSdq = 0.1", "[roughness] process: is not for areal parameters, as Sq is"),
        ("Ra = 0.8e-6", "[roughness] Ra: give with it RSm or Rdq, or process, or Sdq, or m2"),
        ("Ra = 0.8e-6\nRSm = 0.08", "line 5: [roughness] RSm = 0.08: must be in m, and at most 4e-3; is it in mm or um?"),
        ("Ra = [0.8e-6, 0.4e-6]\nRSm = [80e-6, 60]", "line 5: [roughness] RSm = 60: must be in m, and at most 4e-3; is it in um or nm?"),
        ("Sq = 0.8\nSdq = 0.1", "line 4: [roughness] Sq = 0.8: must be in m, and at most 1e-3; is it in um or nm?"),
        ("Sq = 5\nSdq = 0.1", "line 4: [roughness] Sq = 5: must be in m, and at most 1e-3; is it in um or nm?"),
        ("Sq = 800\nSdq = 0.1", "[roughness] Sq = 800: must be in m, and at most 1e-3; is it in nm?"),
        ("Sq = 0.005\nSdq = 0.1", "[roughness] Sq = 0.005: must be in m, and at most 1e-3; is it in mm or um?"),
        ("Sq = 1e9\nSdq = 0.1", "[roughness] Sq = 1000000000: must be in m, and at most 1e-3"),
        ("Sq = 5e-9\nSdq = 3", "line 5: [roughness] Sdq: makes a slope of 2.12"),
        ("Rq = 5e-9\nRdq = 3", "line 5: [roughness] Rdq: makes a slope of 3 along a profile, which no surface has; is it in degrees or per cent?"),
        ("Rq = 5e-9\nRSm = 1e-9", "line 5: [roughness] RSm: makes a slope of 31.4"),
        ("m0 = 25e-18\nm2 = 9", "line 5: [roughness] m2: makes a slope of 3 along a profile, which no surface has; is it the square"),
        ("process = \"ground\"\nRa = 0.8e-3", "line 5: [roughness] Ra: makes a slope of 4.4"),
        ("Sq = 5e-9", "line 3: [roughness] Sdq: must be set, the slope of the map; if it is not known, give Rq with RSm or process in"),
        ("Rq = 5e-9", "line 3: [roughness] RSm: must be set, or Rdq, or process if neither was measured"),
        ("process = \"ground\"\nRa = 0.8", "line 5: [roughness] Ra = 0.8: must be in m, and at most 1e-3; is it in um or nm?"),
    ] {
        let found = refused(&format!("{STEEL}[roughness]\n{rough}\n"));
        assert!(found.contains(says), "{found}\nnot\n{says}");
    }
    let (found, _) = estimate(&format!("{STEEL}{ROUGH}"), &[1.0]);
    for load in [f64::NAN, f64::INFINITY, 1e300] {
        assert!(found.at_load(load).is_err(), "{load}");
    }
}

/// Points that lie on one curve leave the error of their mean; points that disagree leave their scatter, and never more than 1.
#[test]
fn the_error_of_several_points_is_that_of_the_curve() {
    let error = |points: &str| {
        let text = format!("{STEEL}measured = {points}\n{ROUGH}");
        Params::from_toml(&text).expect("a surface").calibration_error
    };
    assert_eq!(error("[[1000, 0.16, 0.03]]"), 0.03);
    assert_near(error("[[1000, 0.16, 0.03], [1000, 0.16, 0.04]]"), 0.024, 1e-12);
    // ln 2 apart: each is off by half of that, and one is left of the two.
    let scatter = 0.5 * 2_f64.ln() / 0.03 * 2_f64.sqrt();
    assert_near(error("[[1000, 0.16, 0.03], [1000, 0.32, 0.03]]"), scatter * 0.03 / 2_f64.sqrt(), 1e-9);
    assert_eq!(error("[[1000, 0.16, 0.9], [1000, 0.05, 0.9], [1000, 0.00002, 0.5]]"), 1.0);
}
