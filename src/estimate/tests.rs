//! What an estimate says, and how often it is right.

use super::known::{deviation, DEFAULT_FACTOR, PROCESSES, SLOPE_FACTOR};
use super::{write, Answer, Estimate};
use crate::by_name::{describe, Case};
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

/// A default strength is a factor of 10 either way, whatever else.
#[test]
fn a_default_strength_is_an_order_of_magnitude() {
    let text = format!("{SILICON}{SMOOTH}");
    let found = answer(&text, 1e-3);
    assert_near(found.low, found.friction_coefficient / 10.0, 1e-7);
    assert_near(found.high, found.friction_coefficient * 10.0, 1e-7);
    assert_eq!((found.strength_share, found.roughness_share, found.measurement_share), (1.0, 0.0, 0.0));
    let half = answer(&format!("coverage = 0.5\n{text}"), 1e-3);
    assert_near(half.high, half.friction_coefficient * 10.0_f64.powf(0.674_489_75 / 1.959_963_98), 1e-7);
    let light = answer(&format!("max_friction_coefficient = 0.1\n{text}"), 1e-3);
    assert!(light.friction_coefficient > 0.4, "capped: {light:?}");
}

/// What the text of an estimate has, and has not where "no " is before it.
#[test]
fn texts_say_what_was_found_what_it_rests_on_and_what_to_check() {
    let yields = "asperities yield, plasticity index";
    let rubber =
        "composite_modulus = 1e6\neffective_shear_modulus = 1e6\nwork_of_adhesion = 0.05\nadhesion_range = 0.5e-9\n\
                  burgers_vector = 10e-9\nheight_std = 10e-9\nsummit_radius = 1e-6\nasperity_count = 1e6\n";
    let (steel, silicon, summits) =
        ("pair = \"steel/steel\"\n", "pair = \"Si/Si\"\n", "height_std = 5e-9\nsummit_radius = 1e-6\n");
    let is_load = "check: the measured friction coefficient is 0.001, dry surfaces have more: is it the load? A point is [load, coefficient]";
    type Row<'a> = (&'a str, &'a str, &'a str, &'a [f64], &'a [&'a str]);
    let rows: &[Row] = &[
        ("", SILICON, SMOOTH, &[1e-3], &["mu(0.001 N) = 0.43", " to an order of magnitude, 0.043", "no asperities yield"]),
        ("slip_stress_1 = 0.02\n", SILICON, SMOOTH, &[1e-3], &["no band: all inputs count as known"]),
        ("", STEEL, ROUGH, &[10.0], &["steel/steel dry 0.57 at 12 N", "clean 0.78", "oxidised 0.27", "from the 3 rows", "no grease", "no ZDDP", yields]),
        // That which is named stands alone, at its load; a measurement here is worth more than any.
        ("interface = \"steel/steel dry\"\n", STEEL, ROUGH, &[12.0], &["measured on other specimens: steel/steel dry 0.57 at 12 N\nmu(12 N) = 0.57, "]),
        ("interface = \"MoS2 film in dry air\"\n", STEEL, ROUGH, &[12.0], &["shear strength 24.8 MPa"]),
        ("measured = [10, 0.1]\n", STEEL, ROUGH, &[10.0], &["no other specimens"]),
        ("contact_law = \"maugis\"\n", STEEL, ROUGH, &[10.0], &["no asperities yield"]),
        ("work_of_adhesion = 0.1\n", STEEL, ROUGH, &[10.0], &["no asperities yield"]),
        // Without an area loads are pressures; a number of summits is an area too.
        ("measured = [1e7, 0.16]\n", steel, ROUGH, &[1e5, 0.0, -1.0], &["mu(100000 Pa) = 0.19", "no  N", "loads are nominal pressures in Pa", "0.16 at 1e7 Pa"]),
        ("measured = [1, 0.16]\n", steel, ROUGH, &[10.0], &["is load in Pa? Give nominal_area"]),
        ("", silicon, SMOOTH, &[0.0], &["mu(0 Pa) has no limit: the tallest summits adhere, how many depends"]),
        ("asperity_count = 1e5\n", silicon, summits, &[1e-3], &["mu(0.001 N)", "no check"]),
        ("", rubber, "", &[0.0, -1.0], &["mu(0 N) has no limit: adhesion gives a friction force of", "mu(-1 N) = 0: the surfaces are apart"]),
        ("", STEEL, ROUGH, &[0.0], &["mu(0 N) has no limit: it grows as the load goes to 0"]),
        // The law cannot follow friction that rises so with load.
        ("measured = [[1, 0.1], [30, 0.2], [1000, 0.4]]\n", STEEL, ROUGH, &[30.0], &["off the law, which cannot follow their trend"]),
        ("measured = [[1, 0.2], [30, 0.18], [1000, 0.16]]\n", STEEL, ROUGH, &[30.0], &["no off the law"]),
        // Units: loads and areas, of which the heaviest load counts, of the measured points too.
        ("", STEEL, ROUGH, &[1.0], &["no check"]),
        ("nominal_area = 1\n", steel, ROUGH, &[78.0], &["no check"]),
        ("nominal_area = 100\n", steel, ROUGH, &[1000.0], &["check: the nominal pressure is 10 Pa, and a steel sheet of 1 mm has 77 Pa: is load in N, and nominal_area in m^2?"]),
        ("", STEEL, ROUGH, &[1e6], &["above the hardness, which no contact bears: is load in N"]),
        ("measured = [10, 0.2]\n", STEEL, ROUGH, &[1e-3], &["no check"]),
        ("", SILICON, SMOOTH, &[1.1e-8], &["no check"]),
        ("", SILICON, SMOOTH, &[0.9e-8], &["check: the nominal pressure"]),
        ("asperity_count = 1\n", silicon, summits, &[1e-3], &["no check"]),
        ("asperity_count = 1e13\n", silicon, summits, &[1e-3], &["check: the nominal pressure is 0.001 Pa, and a steel sheet of 1 mm has 77 Pa: is load in N, and asperity_count a number"]),
        ("", GROUND, "[roughness]\nprocess = \"ground\"\nRa = 10e-6\n", &[10.0], &["check: Ra = 10 um: ground surfaces have 0.1 to 1.6 um: is it of this process"]),
        ("", SILICON, "[roughness]\nSq = 5e-9\nSdq = 1.5\n", &[1e-3], &["check: the slope of the surface is 1.5: is it in degrees"]),
        ("work_of_adhesion = 6.3\n", SILICON, SMOOTH, &[1e-3], &["check: work_of_adhesion is 6.3: is it in mJ/m^2?"]),
        ("pressure_coefficient = 24\n", SILICON, SMOOTH, &[1e-3], &["check: pressure_coefficient is 24: is it in per cent?"]),
        // A measured coefficient in per cent, of few summits, or swapped with its load.
        ("measured = [1e-6, 4]\n", SILICON, SMOOTH, &[1e-6], &["no per cent"]),
        ("measured = [1e-6, 6]\n", SILICON, SMOOTH, &[1e-6], &["check: the measured friction coefficient is 6: is it in per cent (0.06)?", "no is it the load"]),
        ("measured = [0.1, 6]\n", SILICON, SMOOTH, &[1e-2], &["(0.06)? Or is it the load? A point is [load"]),
        ("measured = [1e-2, 0.4]\n", SILICON, SMOOTH, &[1e-2], &["no check"]),
        ("measured = [3e-7, 0.4]\n", SILICON, SMOOTH, &[1e-2], &[" summits touch at the measured 3e-7 N: the point is of one specimen"]),
        ("measured = [0.3, 1e-3]\n", SILICON, SMOOTH, &[1e-2], &[is_load]),
        ("measured = [[0.3, 0.16], [0.3, 1e-3]]\n", SILICON, SMOOTH, &[1e-2], &[is_load]),
        ("measured = [[0.19, 0.1], [0.16, 1]]\n", SILICON, SMOOTH, &[1e-2], &["check: friction coefficients of 0.1 to 1 at 0.16 to 0.19 N: are the two swapped?"]),
        ("measured = [0.3, 0.011]\n", SILICON, SMOOTH, &[1e-2], &["no A point is"]),
        ("measured = [[0.1, 0.19], [1, 0.16]]\n", SILICON, SMOOTH, &[1e-2], &["no A point is"]),
        ("measured = [[0.3, 0.1], [0.3, 0.4]]\n", SILICON, SMOOTH, &[1e-2], &["no A point is"]),
        ("measured = [[2.1, 0.1], [2.2, 0.4]]\n", SILICON, SMOOTH, &[1e-2], &["no A point is"]),
    ];
    for (before, bodies, rough, loads, parts) in rows {
        let shown = written(&format!("{before}{bodies}{rough}"), loads);
        for part in *parts {
            let absent = part.strip_prefix("no ").filter(|part| !part.starts_with("band"));
            assert!(absent.map_or(shown.contains(part), |absent| !shown.contains(absent)), "{part}\nin\n{shown}");
        }
    }
    let film = format!("interface = \"MoS2 film in dry air\"\n{STEEL}{ROUGH}");
    let params = Params::from_toml(&film).expect("a surface");
    assert!(params.pressure_coefficient == 0.001 && params.slip.stress_1 == params.slip.stress_2);
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
    // One summit is itself, and metal that yields does not adhere.
    let tip = "pair = \"Si/Si\"\nheight_std = 3e-13\nsummit_radius = 30e-9\nasperity_count = 1\n";
    let found = answer(tip, 1e-8);
    assert_eq!((found.specimen_force, found.specimen_scatter, found.is_few), (found.friction_force, 0.0, false));
    let found = answer(&format!("{STEEL}{ROUGH}"), 0.0);
    assert_eq!((found.friction_force, found.specimen_force, found.contacts), (0.0, 0.0, 0.0));
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
        assert!(
            estimate(&text, &[10.0]).0.cases.len() == 5 && written(&text, &[10.0]).contains(process.name),
            "{text}"
        );
    }
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

/// A point more is a narrower band, in whichever order they come; points off the law make it wider.
#[test]
fn points_narrow_the_band_unless_they_scatter() {
    let of = |points: &str, load: f64| answer(&format!("{STEEL}measured = {points}\n{ROUGH}"), load);
    let [one, two] = ["[1000, 0.16]", "[[1000, 0.16], [1000, 0.16]]"].map(|points| of(points, 1000.0));
    assert_near((two.high / two.low).ln() * 2.0_f64.sqrt(), (one.high / one.low).ln(), 1e-2);
    let [first, other] = ["[[1000, 0.16], [10, 0.18]]", "[[10, 0.18], [1000, 0.16]]"].map(|points| of(points, 1.0));
    assert_near(first.low, other.low, 1e-9);
    assert_near(first.friction_coefficient, other.friction_coefficient, 1e-9);
    let rising = of("[[1, 0.1], [30, 0.2], [1000, 0.4]]", 30.0);
    assert!(rising.high / rising.low > 1.3, "{rising:?}");
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
    let rows = [
        ("measured = 0.16\n", ROUGH, "line 1: measured = 0.16: must be points [load, coefficient] or"),
        ("measured = []\n", ROUGH, "line 1: measured = [...]: must be points"),
        ("measured = [1000]\n", ROUGH, "line 1: measured: point 1: must be [load, coefficient] or"),
        ("measured = [[1000, 0.16], [10]]\n", ROUGH, "line 1: measured: point 2: must be [load, coefficient] or"),
        ("measured = [[1000, 160]]\n", ROUGH, "line 1: measured: point 1: coefficient = 160: must be > 0 and at most 20; is it a force?"),
        ("measured = [[-1, 0.16]]\n", ROUGH, "line 1: measured: point 1: load = -1: must be > 0"),
        ("measured = [0.3, 1e-5]\n", ROUGH, "line 1: measured: point 1: coefficient = 1e-5: most are between 0.001 and 10, as the load"),
        ("measured = [0.16, 12]\n", ROUGH, "line 1: measured: point 1: coefficient = 12: most are between 0.001 and 10, as the load is"),
        ("measured = [[1000, 0.16, 5]]\n", ROUGH, "line 1: measured: point 1: error = 5: must be > 0 and at most 1"),
        ("measured = [[1000, 0.16], 3]\n", ROUGH, "line 1: measured: must be an array of numbers, or of arrays of numbers"),
        ("measured = [[[1]]]\n", ROUGH, "line 1: measured: must be an array of numbers, or of arrays of numbers"),
        ("measured = [1000, 16]\n", ROUGH, "is the coefficient in per cent (16 for 0.16)"),
        ("measured = [1000, 30]\n", ROUGH, "or is it in per cent?"),
        // The point that is wrong is named, whichever it is.
        ("measured = [[10, 15], [1000, 0.16]]\n", ROUGH, "line 1: friction_force = 150 at load = 10: must be at most 12.4"),
        ("measured = [[1000, 0.16], [10, 15]]\n", ROUGH, "line 1: friction_force = 150 at load = 10: must be at most 12.4"),
        ("coverage = 95\n", ROUGH, "line 1: coverage = 95: must be between 0 and 1: is it in per cent?"),
        ("coverage = 0\n", ROUGH, "line 1: coverage = 0: must be between 0 and 1"),
        ("measured = [1, 0.1]\ncalibration_load = 1\ncalibration_friction_force = 1\n", ROUGH, "line 1: measured: calibration_load"),
        ("slip_stress_1 = 0\nslip_stress_2 = 0\npressure_coefficient = 0.1\n", ROUGH, "slip_stress_1: must be > 0 for an estimate"),
        ("", "[roughness]\nprocess = \"grund\"", "[roughness] process = \"grund\": must be one of superfinished, lapped, honed, ground,"),
        ("", "[roughness]\nprocess = 3", "[roughness] process = 3: must be one of superfinished"),
        ("", "[roughness]\nprocess = \"ground\"\nSq = 1e-6\nSdq = 0.1", "[roughness] process: is not for areal parameters, as Sq is"),
        ("", "[roughness]\nRa = 0.8e-6\nRSm = 0.08", "line 5: [roughness] RSm = 0.08: must be in m, and at most 4e-3; is it in mm or um?"),
        ("", "[roughness]\nRa = [0.8e-6, 0.4e-6]\nRSm = [80e-6, 60]", "line 5: [roughness] RSm = 60: must be in m, and at most 4e-3; is it in um or nm?"),
        ("", "[roughness]\nSq = 5\nSdq = 0.1", "line 4: [roughness] Sq = 5: must be in m, and at most 1e-3; is it in um or nm?"),
        ("", "[roughness]\nSq = 800\nSdq = 0.1", "[roughness] Sq = 800: must be in m, and at most 1e-3; is it in nm?"),
        ("", "[roughness]\nSq = 1e9\nSdq = 0.1", "[roughness] Sq = 1000000000: must be in m, and at most 1e-3"),
        ("", "[roughness]\nRq = 5e-9\nRdq = 3", "line 5: [roughness] Rdq: makes a slope of 3 along a profile, which no surface has; is it in degrees or per cent?"),
        ("", "[roughness]\nRq = 5e-9\nRSm = 1e-9", "line 5: [roughness] RSm: makes a slope of 31.4"),
        ("", "[roughness]\nm0 = 25e-18\nm2 = 9", "line 5: [roughness] m2: makes a slope of 3 along a profile, which no surface has; is it the square"),
        ("", "[roughness]\nprocess = \"ground\"\nRa = 0.8e-3", "line 5: [roughness] Ra: makes a slope of 4.4"),
    ];
    for (before, rough, says) in rows {
        let found = refused(&format!("{before}{STEEL}{rough}\n"));
        assert!(found.contains(says), "{found}\nnot\n{says}");
    }
    let (found, _) = estimate(&format!("{STEEL}{ROUGH}"), &[1.0]);
    for load in [f64::NAN, f64::INFINITY, 1e300] {
        assert!(found.at_load(load).is_err(), "{load}");
    }
}
