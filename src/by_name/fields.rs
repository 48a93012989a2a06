//! The parameters that are one number each, by their names. A new one is a line here.

use super::draft::{Draft, NO_FAMILY};
use crate::asperity::slip::SlipOnset;
use crate::error::Error;
use crate::materials::names::c_string;
use crate::params::{ContactLawKind, WavinessShape};
use std::ffi::CStr;

/// A parameter that is one number.
pub struct Field {
    pub name: &'static str,
    /// The same, for C.
    pub c_name: &'static CStr,
    /// Its dimension, as the header writes it: "1" of a number without one.
    pub unit: &'static str,
    /// The words for 0, 1, ... where it is a choice.
    pub words: &'static [&'static str],
    allowed: &'static str,
    of: fn(&mut Draft) -> &mut dyn Number,
}

/// The words of what is true or false.
pub const FLAG: &[&str] = &["false", "true"];

/// Hands the parameters that are one number to a macro, with their units, places in a draft, words, and what is said of a number
/// without a word. Shape, kurtosis and skew choose the heights; in this order, with the choice itself last, setting one after
/// another what another surface has copies that surface.
macro_rules! with_fields {
    ($then:ident) => {
        $then! {
            length_unit: params.length_unit;
            force_unit: params.force_unit;
            composite_modulus "stress": params.composite_modulus;
            effective_shear_modulus "stress": params.effective_shear_modulus;
            work_of_adhesion "force/length": params.work_of_adhesion;
            adhesion_range "length": params.adhesion_range;
            burgers_vector "length": params.burgers_vector;
            height_std "length": params.height_std;
            summit_radius "length": params.summit_radius;
            asperity_count: params.asperity_count;
            attraction: params.attraction as FLAG, "must be 0 or 1";
            radius_amplitude: params.radius_amplitude;
            radius_rate: params.radius_rate;
            slip_radius_1: params.slip.radius_1;
            slip_stress_1: params.slip.stress_1;
            slip_radius_2: params.slip.radius_2;
            slip_stress_2: params.slip.stress_2;
            max_friction_coefficient: params.max_friction_coefficient;
            hardness "stress": params.hardness;
            tangential_modulus "stress": params.tangential_modulus;
            nominal_area "length^2": params.nominal_area;
            pressure_coefficient: params.pressure_coefficient;
            bandwidth: params.bandwidth;
            calibration_error: params.calibration_error;
            summit_mean_height "length": params.summit_mean_height;
            rms_slope: params.rms_slope;
            waviness_height "length": params.waviness.height;
            waviness_width "length": params.waviness.width;
            waviness_shape: params.waviness.shape as &["unknown", "ridges", "hills"],
                    "must be one of ASPERITY_WAVINESS_: UNKNOWN (0), RIDGES (1), HILLS (2)";
            taken_as_gaussian: params.taken_as_gaussian as FLAG, "must be 0 or 1";
            contact_law: params.contact_law as &["maugis", "elastic-plastic"],
                    "must be one of ASPERITY_CONTACT_: MAUGIS (0), ELASTIC_PLASTIC (1)";
            slip_onset: params.slip_onset as &["partial", "whole"],
                    "must be one of ASPERITY_SLIP_: PARTIAL (0), WHOLE (1)";
            weibull_shape: weibull_shape;
            kurtosis: kurtosis;
            skew: skew;
            height_distribution: height_distribution as &["gaussian", "weibull", "johnson", "tabulated", "at-scores"], NO_FAMILY;
        }
    };
}
pub(crate) use with_fields;

macro_rules! fields {
    (@ $default:expr) => { $default };
    (@ $default:expr, $given:expr) => { $given };
    ($($name:ident $($unit:literal)?: $($place:ident).+ $(as $words:expr, $allowed:expr)?;)*) => {
        &[$(Field {
            name: stringify!($name),
            c_name: c_string!(stringify!($name)),
            unit: fields!(@ "1" $(, $unit)?),
            words: fields!(@ &[] $(, $words)?),
            allowed: fields!(@ "" $(, $allowed)?),
            of: |draft| &mut draft.$($place).+,
        }),*]
    };
}

pub static FIELDS: &[Field; 36] = with_fields!(fields);

/// A number of a parameter, whatever its type.
pub trait Number {
    fn get(&self) -> f64;
    /// Whether it can have the value, which it then has.
    fn set(&mut self, value: f64) -> bool;
}

impl Number for f64 {
    fn get(&self) -> f64 {
        *self
    }
    fn set(&mut self, value: f64) -> bool {
        *self = value;
        true
    }
}

impl Number for i32 {
    fn get(&self) -> f64 {
        (*self).into()
    }
    fn set(&mut self, value: f64) -> bool {
        *self = value as i32;
        self.get() == value
    }
}

/// What has a word, by its number.
macro_rules! choice {
    ($kind:ty: $($value:expr),*) => {
        impl Number for $kind {
            fn get(&self) -> f64 {
                [$($value),*].iter().position(|value| value == self).unwrap_or_default() as f64
            }
            fn set(&mut self, value: f64) -> bool {
                let found = [$($value),*].into_iter().enumerate().find(|(number, _)| *number as f64 == value);
                found.map(|(_, value)| *self = value).is_some()
            }
        }
    };
}

choice! { bool: false, true }
choice! { ContactLawKind: ContactLawKind::Maugis, ContactLawKind::ElasticPlastic }
choice! { WavinessShape: WavinessShape::Unknown, WavinessShape::Ridges, WavinessShape::Hills }
choice! { SlipOnset: SlipOnset::Partial, SlipOnset::Whole }

impl Field {
    pub fn get(&self, draft: &mut Draft) -> f64 {
        (self.of)(draft).get()
    }

    /// Whether its words are more than false and true.
    pub fn is_choice(&self) -> bool {
        !self.words.is_empty() && self.words != FLAG
    }

    /// # Errors
    /// [`Error::InvalidParameter`] of a choice that is none.
    pub fn set(&self, draft: &mut Draft, value: f64) -> Result<(), Error> {
        match (self.of)(draft).set(value) {
            true => Ok(()),
            false => Err(Error::invalid(self.name, value, self.allowed)),
        }
    }
}
