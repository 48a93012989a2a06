//! What an estimate takes for granted, as numbers: one table, with the reason of each. `known` has what is usual of processes.
//!
//! Factors are of 95 %: a true value is within so many times either way with that probability.

/// What may be between two surfaces, which decides how their friction leaves the law between loads.
#[derive(Debug, PartialEq)]
pub struct Class {
    /// By which `interface_kind` names it; the first is what it is called.
    pub words: &'static [&'static str],
    pub called: &'static str,
    /// Probabilities of the size effects 0, 1/4, 1/2, 3/4 and 1: slip stresses are 30^s apart.
    pub size: [f64; 5],
    /// Half of the probability is without a pressure coefficient; the other half falls off with this deviation, or is even up to it.
    pub pressure: f64,
    pub pressure_is_even: bool,
    /// Deviation of ln(F/P) a decade of load, and of its wandering over the root of a decade.
    pub drift: f64,
    pub wander: f64,
    /// Times as much of both, a rise of ln(F/P) a decade towards heavier loads, and how probable that is.
    pub more: &'static [(f64, f64, f64)],
    /// Whether a strength that was measured on one roughness is that of another.
    pub carries_over: bool,
}

/// Two of seven comparisons of rough contacts are off by more than 0.4 a decade.
const MORE: &[(f64, f64, f64)] = &[(1.0, 0.0, 0.8), (3.0, 0.0, 0.19), (10.0, 0.0, 0.009), (30.0, 0.0, 0.001)];
/// Copper rose from 0.4 to 1.8 over three decades, as its oxide broke.
const BREAKING: &[(f64, f64, f64)] =
    &[(1.0, 0.0, 0.6), (3.0, 0.0, 0.19), (1.0, 0.5, 0.2), (10.0, 0.0, 0.009), (30.0, 0.0, 0.001)];

/// MoS2 and hard carbon show a constant stress, antimony particles a force in proportion to their area; Hurtado and Kim's law was matched
/// to mica, and silicon has an oxide.
const SIZE_OF_FILMS: [f64; 5] = [0.62, 0.16, 0.10, 0.07, 0.05];

/// The first is taken where a text says nothing.
pub static CLASSES: [Class; 4] = [
    Class { words: &["film", "oxide", "ball"], called: "film or oxide", ..FILM },
    Class { words: &["clean", "clean crystal"], called: "clean crystals", size: [0.2; 5], ..FILM },
    Class { words: &["dry metal"], called: "dry metal", drift: 0.15, wander: 0.15, more: BREAKING, ..FILM },
    Class {
        words: &["rock", "glass", "grain", "grains"],
        called: "rock, glass or grains",
        // Of dry minerals anything up to it was measured.
        pressure: 0.5,
        pressure_is_even: true,
        carries_over: false,
        ..FILM
    },
];
const FILM: Class = Class {
    words: &[],
    called: "",
    size: SIZE_OF_FILMS,
    // The table of interfaces has 0.001 and 0.14.
    pressure: 0.1,
    pressure_is_even: false,
    drift: 0.04,
    wander: 0.07,
    more: MORE,
    carries_over: true,
};

/// What is told of heights and slopes, and how far the law is off boundary elements of such surfaces (docs/validation.md): in ln of the
/// real area at a load, and, of friction that is measured at another, in ln(F/P) over the root of a decade between the loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shape {
    pub called: &'static str,
    pub area: f64,
    pub wander: f64,
}

const fn shape(called: &'static str, area: f64, wander: f64) -> Shape {
    Shape { called, area, wander }
}

/// Summits that are given one by one, and machined surfaces that are Gaussian.
pub static SUMMITS: Shape = shape("", 0.0, 0.0);
/// As 13 measured maps have it: surfaces that are made are nearer, as grooves and lines do not become long by chance. Who tells less knows no
/// better.
pub static TABLE: Shape = shape("heights and slopes at normal scores", 0.11, 0.13);
pub static TOP: Shape = shape("heights at normal scores, and the slope of the top", 0.11, 0.13);
pub static HEIGHTS: Shape = shape("heights that are not Gaussian, and one slope", 0.2, 0.13);
/// 31 surfaces of boundary elements of which height and slope are known: Gaussian ones, with a lay, skewed ones, plateaus, but no flat tops.
pub static ALONE: Shape = shape("height and slope alone", 0.49, 0.26);

/// Slopes of machined surfaces where only the process is known (docs/when-to-use.md), and slopes that were measured.
pub const SLOPE: f64 = 4.0;
pub const MEASURED_SLOPE: f64 = 1.5;
/// Hardness of a material by its name: steel has 2 to 9 GPa.
pub const HARDNESS: f64 = 2.0;
/// A work of adhesion of the table of pairs: half of the probability; the other half is none. Polished wafers in air adhere far less than
/// their pair does, and F/(P + adhesion) of silicon is nearly constant (Ando and others, 1995).
pub const WORK: f64 = 3.0;
/// The work of adhesion [J/m^2] of a pair that the table does not have: what adsorbs in air, as on steel.
pub const USUAL_WORK: f64 = 0.05;
/// Of E nothing is taken to be unknown: it moves friction at all loads alike, which a measured point removes.
pub const YOUNG: f64 = 1.0;
/// Stiffness of joints that are flat is that of boundary elements to 10 %; that of real ones is not.
pub const STIFFNESS: f64 = 1.5;

/// Friction before it is measured, as a median of F/P and a factor. Twelve values of four pairs of dry metals scatter by 0.32 within a
/// pair and by 0.44 between pairs, in ln(F/P); their median is 0.74.
pub const PAIR_FACTOR: f64 = 3.0;
pub const FAMILY_FACTOR: f64 = 4.0;
pub const METALS: (f64, f64) = (0.74, 5.0);
/// Metals, where a lubricant may be: told, not taken.
pub const MAYBE_LUBRICATED: (f64, f64) = (0.29, 24.0);
/// Wafers have 0.16 and 0.38, dry minerals 0.12 to 0.53.
pub const OTHERS: (f64, f64) = (0.3, 10.0);
/// The nominal pressure [Pa] that is taken for a coefficient without a load, and the largest where its load, which is one of other
/// specimens, is known.
pub const ROW_PRESSURE: f64 = 1e6;
pub const LARGEST_ROW_PRESSURE: f64 = 1e8;
/// Before the points of these surfaces.
pub const MEASURED_FACTOR: f64 = 100.0;

/// Plasticity indices between which elastic contacts that adhere become contacts that yield.
pub const YIELDING: [f64; 2] = [0.7, 1.0 / 0.7];

impl Class {
    pub fn find(word: &str) -> Option<&'static Self> {
        CLASSES.iter().find(|class| class.words.contains(&word))
    }
}

/// The probability that asperities of a surface with this plasticity index yield, without a step.
pub fn yields(plasticity_index: f64) -> f64 {
    let [from, to] = YIELDING.map(crate::numerics::elementary::log);
    if plasticity_index <= YIELDING[0] {
        return 0.0;
    }
    let part = ((crate::numerics::elementary::log(plasticity_index) - from) / (to - from)).clamp(0.0, 1.0);
    part * part * (3.0 - 2.0 * part)
}
