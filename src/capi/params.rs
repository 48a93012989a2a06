//! Parameters, as C sees them.

use super::boundary::{not_null, reference, wrong_struct_size, Failure};
use crate::by_name::{with_fields, Draft, Number, FIELDS};
use crate::distribution::tabulated;
use crate::params::{HeightFamily, Params};
use std::mem::size_of;
use std::sync::Arc;

/// Gaussian heights, eq (17): the default.
pub const ASPERITY_HEIGHTS_GAUSSIAN: i32 = 0;
/// Weibull heights, eqs (18)-(21): their skew follows from `weibull_shape`.
pub const ASPERITY_HEIGHTS_WEIBULL: i32 = 1;
/// Heights of Johnson's system: `skew` and `kurtosis` are set independently.
pub const ASPERITY_HEIGHTS_JOHNSON: i32 = 2;
/// Heights of a measured density: `table_height`, `table_density` and `table_length`.
pub const ASPERITY_HEIGHTS_TABULATED: i32 = 3;
/// Summit heights and radii of a surface that is not Gaussian, by its heights and slopes at 13 normal scores, -3 to 3.
pub const ASPERITY_HEIGHTS_AT_SCORES: i32 = 4;

/// Elastic asperities with adhesion after Maugis, or Hertz' law without adhesion: the default.
pub const ASPERITY_CONTACT_MAUGIS: i32 = 0;
/// Asperities that yield, after Zhao, Maietta and Chang (2000): needs `hardness` > 0 and `work_of_adhesion` = 0.
pub const ASPERITY_CONTACT_ELASTIC_PLASTIC: i32 = 1;

/// Before gross slip each contact slips from its rim inwards, after Cattaneo (1938) and Mindlin (1949).
pub const ASPERITY_SLIP_PARTIAL: i32 = 0;
/// Before gross slip each contact sticks until all of it slips: contacts so small that one dislocation moves them.
pub const ASPERITY_SLIP_WHOLE: i32 = 1;

/// Waves whose shape is not known: there may be none.
pub const ASPERITY_WAVINESS_UNKNOWN: i32 = 0;
/// Waves with long crests side by side, as turning and grinding leave: cos x.
pub const ASPERITY_WAVINESS_RIDGES: i32 = 1;
/// Waves in two directions, as lapping and scraping leave: cos x + cos y.
pub const ASPERITY_WAVINESS_HILLS: i32 = 2;

/// Two rough surfaces in contact, as one equivalent rough surface against a flat.
///
/// Start from `asperity_params_init`, which sets `struct_size` and every default. Then set the eight physical inputs,
/// `composite_modulus` to `asperity_count`, directly or through the functions `asperity_params_set_...`. All quantities are in one
/// consistent system of units of your choice. Loads, forces and areas are totals over `asperity_count` asperities.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_params {
    /// Size of this struct [bytes]; set by `asperity_params_init`.
    pub struct_size: u64,
    /// E* [stress], > 0: reduced modulus, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2. No default: set it, or call
    /// `asperity_params_set_materials`.
    pub composite_modulus: f64,
    /// G* [stress], > 0: 2 G1 G2/(G1 + G2). No default: set it, or call `asperity_params_set_materials`.
    pub effective_shear_modulus: f64,
    /// w [force/length], >= 0: work of adhesion; 0 is Hertzian contact. No default.
    pub work_of_adhesion: f64,
    /// h [length], > 0: range of adhesion, within which surfaces attract with the stress w/h. No default; the paper takes b.
    pub adhesion_range: f64,
    /// b [length], > 0: Burgers vector, the length in which the slip radii are given. No default.
    pub burgers_vector: f64,
    /// sigma [length], > 0: standard deviation of the asperity heights. No default.
    pub height_std: f64,
    /// R [length], > 0: mean radius of curvature of the asperities. No default.
    pub summit_radius: f64,
    /// N [-], > 0: number of asperities, i.e. their density times the nominal area; need not be an integer. No default.
    pub asperity_count: f64,
    /// Family of the asperity heights, one of `ASPERITY_HEIGHTS_`; Gaussian by default.
    pub height_distribution: i32,
    /// 1: asperities out of contact attract (the default, as in the paper); 0: they do not.
    pub attraction: i32,
    /// omega [-], 1 to 200: shape of the Weibull heights; 3.602, the default, has no skew. Read only for `ASPERITY_HEIGHTS_WEIBULL`.
    pub weibull_shape: f64,
    /// epsilon [-], -1 to 1: how the radius grows with height, R (1 + epsilon tanh(rho z/sigma)); 0 by default.
    pub radius_amplitude: f64,
    /// rho [-], > 0, per standard deviation of height: how fast the radius changes; 0.5 by default. 1e-6 to 1000 where
    /// `radius_amplitude` is not 0.
    pub radius_rate: f64,
    /// a_1/b [-], at least 1: contact radius up to which the shear strength is `slip_stress_1`, eq (13); 28 by default.
    pub slip_radius_1: f64,
    /// tau_1/G* [-], > 0 and at most 1; 1/43 by default, which was not measured on your interface: call `asperity_params_calibrate`.
    pub slip_stress_1: f64,
    /// a_2/b [-], > a_1/b: contact radius from which the shear strength is `slip_stress_2`; 8e4 by default.
    pub slip_radius_2: f64,
    /// tau_2/G* [-], > 0 and at most 1; 1/1290 by default. tau_2 a_2^2 must not be below tau_1 a_1^2.
    pub slip_stress_2: f64,
    /// Upper bound of every friction coefficient returned [-], > 0; 1000 by default, INFINITY allowed. F/P grows
    /// without bound towards zero load.
    pub max_friction_coefficient: f64,
    /// Skew of Johnson's asperity heights [-], -3 to 3; 0 by default. Other `height_distribution`s refuse any other
    /// value; by its name it also chooses Weibull heights: `asperity_params_set_values`.
    pub skew: f64,
    /// Kurtosis of Johnson's asperity heights [-], 1.87 + 1.25 skew^2 to 100; 3 by default, which with skew 0 is
    /// Gaussian. Other `height_distribution`s refuse any other value.
    pub kurtosis: f64,
    /// H [stress], 1e-5 E* to 100 E*: indentation hardness of the softer body; 0, the default, means not known. Warnings compare pressures
    /// with it; the friction of elastic asperities does not depend on it, that of `ASPERITY_CONTACT_ELASTIC_PLASTIC` does.
    pub hardness: f64,
    /// `table_length` asperity heights in ascending order, in any unit and from any origin: the library standardises
    /// them. Each exceeds the one before by at least 1e-12 of their range. Read only for `ASPERITY_HEIGHTS_TABULATED`,
    /// and copied when a model is made. NULL by default.
    pub table_height: *const f64,
    /// The density at each of these heights, >= 0; it need not be normalised. NULL by default.
    pub table_density: *const f64,
    /// Number of heights in the table, 3 to 256; 0 by default.
    pub table_length: u64,
    /// G^ [stress], >= 0: 1/G^ = (2 - nu1)/G1 + (2 - nu2)/G2, for the stiffness of contacts that stick; 0, the default, means E* G* / (2
    /// (E* + G*)). `asperity_params_set_materials` sets it.
    pub tangential_modulus: f64,
    /// Nominal area A_0 of contact [length^2], >= 0; 0, the default, means not known. Warnings compare the real area A with it. Where it is
    /// known, neighbours share the elastic compliance: stiffness and the sum of contact radii are those of lone contacts over chi = (1 -
    /// (A/A_0)^(1/2))^1.8, and the gap changes less (docs/model.md). A/A_0 counts as 0.5 at most.
    pub nominal_area: f64,
    /// Law of one asperity in contact, one of `ASPERITY_CONTACT_`; Maugis' by default.
    pub contact_law: i32,
    /// How a contact begins to slip, one of `ASPERITY_SLIP_`; partial slip by default. Friction does not depend on it, the
    /// tangential force before gross slip does: `asperity_tangential_at_load`, `asperity_microslip_step`.
    pub slip_onset: i32,
    /// kappa [-], 0 to 1000: the pressure coefficient of the interface; 0, the default, is a strength that does not grow with pressure. The
    /// friction force of a contact is pi a^2 tau(a) + kappa P_H. P_H is the load that Hertz' contact of the
    /// same radius carries. Boundary films have 0.02 to 0.2. Where it is > 0, both slip stresses may be 0: Amontons' law.
    pub pressure_coefficient: f64,
    /// Nayak's bandwidth m0 m4/m2^2 of a surface whose summits were counted [-], at least 1.5, with which warnings judge whether
    /// they act independently; 0, the default, means not known. The library then takes it from `nominal_area`, if that is known.
    pub bandwidth: f64,
    /// Load of the measurement that set the strength of the interface [force]; 0 if there was none. `asperity_params_calibrate` sets it.
    pub calibration_load: f64,
    /// Friction force measured at that load [force], >= 0; 0, the default: not calibrated. `asperity_params_calibrate` sets it.
    pub calibration_friction_force: f64,
    /// Relative standard error of that measurement [-], > 0 and at most 1; 0.05 by default.
    pub calibration_error: f64,
    /// Height of the mean of the asperities above the mean plane of the surface [length], >= 0; 0, the default, means not known.
    pub summit_mean_height: f64,
    /// Root mean square slope of the surface [-], Sdq, 0 to 5, with which warnings judge; 0, the default, means not known.
    pub rms_slope: f64,
    /// Wq [length], >= 0: root mean square height of the waves on which the roughness stands, of both surfaces together; 0, the default,
    /// means none. A solver whose mesh carries the waves leaves it 0. From 0.01 to 30 `height_std`, with `waviness_width`,
    /// `waviness_shape` and `nominal_area`, and without adhesion.
    pub waviness_height: f64,
    /// WSm [length], the width of a wave, with which the bodies give way; 0 by default. At least 10 Wq, 4 times the distance of
    /// asperities, and the mean wave of the roughness; at most the root of `nominal_area`.
    pub waviness_width: f64,
    /// What the waves are like, one of `ASPERITY_WAVINESS_`; unknown by default, and then the height must be 0.
    pub waviness_shape: i32,
    /// 1: Gaussian heights stand for those of a surface that is known not to have them, as where honing left plateaus; 0: not so (the
    /// default). States then have the warning `ASPERITY_WARNING_NOT_GAUSSIAN`. A text that names such a process sets it.
    pub taken_as_gaussian: i32,
    /// Unit of all lengths, in metres [-], > 0; 1 by default. `asperity_params_set_units` sets it.
    pub length_unit: f64,
    /// Unit of all forces, in newtons [-], > 0; 1 by default. `asperity_params_set_units` sets it.
    pub force_unit: f64,
}

/// Size of the struct.
const SIZE: u64 = size_of::<asperity_params>() as u64;

/// The numbers that have a name, in the order of `FIELDS`.
macro_rules! numbers {
    ($($name:ident $($unit:literal)?: $($place:ident).+ $(as $words:expr, $allowed:expr)?;)*) => {
        impl asperity_params {
            fn numbers(&mut self) -> [&mut dyn Number; FIELDS.len()] {
                [$(&mut self.$name),*]
            }
        }
    };
}
with_fields!(numbers);

impl asperity_params {
    /// The parameters of a caller.
    ///
    /// # Safety
    /// `params` is NULL or points to a struct of the size that its first field says.
    pub(super) unsafe fn read(params: *const Self) -> Result<Self, Failure> {
        check_size(*reference(params.cast::<u64>(), "params")?)?;
        Ok(*params)
    }

    /// The C form of parameters; a table is pointed to where it is.
    pub(super) fn from_params(params: &Params) -> Self {
        // SAFETY: numbers and pointers, which may all be 0.
        let mut whole = Self { struct_size: SIZE, ..unsafe { std::mem::zeroed() } };
        whole.take(Draft::of(params));
        if let Some((height, values)) = params.heights.table() {
            (whole.table_height, whole.table_density) = (height.as_ptr(), values.as_ptr());
            whole.table_length = height.len() as u64;
        }
        whole
    }

    /// Takes all that a draft has, but for a table: that stays.
    pub(super) fn take(&mut self, mut draft: Draft) {
        for (field, number) in FIELDS.iter().zip(self.numbers()) {
            number.set(field.get(&mut draft));
        }
        self.calibration_load = draft.params.calibration_load;
        self.calibration_friction_force = draft.params.calibration_friction_force;
    }

    /// What is set by name, without the table; only what is an enum in spirit is checked here, the numbers where they are used.
    pub(super) fn draft(mut self) -> Result<Draft, Failure> {
        let mut draft = Draft::default();
        draft.params.calibration_load = self.calibration_load;
        draft.params.calibration_friction_force = self.calibration_friction_force;
        for (field, number) in FIELDS.iter().zip(self.numbers()) {
            field.set(&mut draft, number.get())?;
        }
        Ok(draft)
    }

    /// The same with the table, where the heights are one.
    ///
    /// # Safety
    /// The table, where the heights are one, has the length it says.
    pub(super) unsafe fn whole_draft(self) -> Result<Draft, Failure> {
        let mut draft = self.draft()?;
        if self.has_table() {
            draft.params.heights = self.table()?;
        }
        Ok(draft)
    }

    /// The table, where the heights are one and it is there.
    ///
    /// # Safety
    /// As that of `whole_draft`.
    pub(super) unsafe fn readable_table(&self) -> Option<HeightFamily> {
        let is_there = !self.table_height.is_null() && !self.table_density.is_null();
        let length = usize::try_from(self.table_length).is_ok_and(|length| tabulated::check_length(length).is_ok());
        (self.has_table() && is_there && length).then(|| self.table().ok())?
    }

    fn has_table(&self) -> bool {
        [ASPERITY_HEIGHTS_TABULATED, ASPERITY_HEIGHTS_AT_SCORES].contains(&self.height_distribution)
    }

    /// The library's form.
    ///
    /// # Safety
    /// As that of `whole_draft`.
    pub(super) unsafe fn to_params(self) -> Result<Params, Failure> {
        Ok(self.whole_draft()?.into_params()?)
    }

    /// A copy of the caller's table.
    unsafe fn table(&self) -> Result<HeightFamily, Failure> {
        let length = usize::try_from(self.table_length).unwrap_or(usize::MAX);
        tabulated::check_length(length)?;
        not_null(self.table_height, "table_height")?;
        not_null(self.table_density, "table_density")?;
        // SAFETY: the caller says that there are so many.
        let copy = |first| Arc::from(unsafe { std::slice::from_raw_parts(first, length) });
        let is_at_scores = self.height_distribution == ASPERITY_HEIGHTS_AT_SCORES;
        Ok(HeightFamily::of_table(is_at_scores, copy(self.table_height), copy(self.table_density)))
    }
}

/// Refuses the size of a struct that this library does not know.
pub(super) fn check_size(size: u64) -> Result<(), Failure> {
    match size {
        SIZE => Ok(()),
        _ if size > SIZE && size % 8 == 0 && size < 2 * SIZE => Err(wrong_struct_size(
            size,
            format_args!("must be {SIZE}: the header is newer than the library; install the library of that header"),
        )),
        _ => Err(wrong_struct_size(
            size,
            format_args!("must be sizeof(asperity_params), {SIZE}: call asperity_params_init first"),
        )),
    }
}
