//! What can be wrong, in the user's words: which quantity, its value, and what is allowed.

use crate::materials::Interface;
use std::borrow::Cow;
use thiserror::Error;

/// Why the library refuses.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A parameter has no meaning.
    #[error("{name} = {value}: {allowed}")]
    InvalidParameter {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: Value,
        /// What it may be.
        allowed: &'static str,
    },
    /// A parameter was never set.
    #[error("{name}: must be set; {}", sets(name))]
    Unset {
        /// The parameter.
        name: &'static str,
    },
    /// A number that goes together with others was not given with them.
    #[error("{name}: {says}")]
    Missing {
        /// The parameter.
        name: &'static str,
        /// With what it goes.
        says: &'static str,
    },
    /// An entry of a table has no meaning.
    #[error("{name}[{index}] = {}: {allowed}", Real(*value))]
    InvalidEntry {
        /// The table.
        name: &'static str,
        /// Which of its entries, from 0.
        index: usize,
        /// Its value.
        value: f64,
        /// What it may be.
        allowed: &'static str,
    },
    /// A load is NaN or infinite.
    #[error("{name} = {}: must be finite", Real(*value))]
    InvalidLoad {
        /// Which load.
        name: &'static str,
        /// The load.
        value: f64,
    },
    /// Nothing holds the surfaces together at this load.
    #[error(
        "{name} = {}: below the pull-off load {}, the surfaces are apart and there is no friction",
        Real(*load),
        Real(*pull_off)
    )]
    Separated {
        /// Which load.
        name: &'static str,
        /// The load.
        load: f64,
        /// The pull-off load.
        pull_off: f64,
    },
    /// Nothing holds the surfaces together at this gap.
    #[error(
        "gap = {}: the surfaces part at {}, beyond which they carry no load",
        Real(*gap),
        Real(*end)
    )]
    Open {
        /// The gap.
        gap: f64,
        /// The smallest at which they are apart.
        end: f64,
    },
    /// A quantity is meaningful, but outside what the model can be evaluated for.
    #[error("{name} = {value}: {allowed}")]
    OutOfRange {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: Value,
        /// What it may be.
        allowed: &'static str,
    },
    /// No strength of the interface gives a measured friction force.
    #[error(
        "friction_force = {} at load = {}: {}{}{}",
        Real(*friction_force),
        Real(*load),
        reason.texts().0,
        Real(*number),
        reason.texts().1
    )]
    Uncalibrated {
        /// The load of the measurement.
        load: f64,
        /// The measured force.
        friction_force: f64,
        /// What is wrong.
        reason: CalibrationFailure,
        /// The number that the reason is about: a force, or a slip stress.
        number: f64,
    },
    /// An interface has only a friction coefficient, which no parameter is.
    #[error("{}", Calibrate(interface))]
    NoStrength {
        /// The interface.
        interface: &'static Interface,
    },
    /// A text that describes a surface has something that is refused.
    #[error("line {line}: {error}")]
    InText {
        /// Which of its lines, from 1.
        line: usize,
        /// What is wrong with it.
        error: Box<Error>,
    },
    /// What was given together, or how it was written, has no meaning.
    #[error("{0}")]
    Meaningless(Cow<'static, str>),
    /// An iteration failed to converge.
    #[error("{what} = {value}: no solution was found to full accuracy; please report the parameters")]
    NotConverged {
        /// What was solved for.
        what: &'static str,
        /// At which value.
        value: f64,
    },
}

impl Error {
    /// A parameter that has no meaning.
    pub(crate) fn invalid(name: &'static str, value: impl Into<Value>, allowed: &'static str) -> Self {
        Self::InvalidParameter { name, value: value.into(), allowed }
    }

    /// The parameter that it is about, by the name it has in the message.
    pub(crate) fn name(&self) -> Option<&'static str> {
        match self {
            Self::InvalidParameter { name, .. }
            | Self::OutOfRange { name, .. }
            | Self::Unset { name }
            | Self::Missing { name, .. }
            | Self::InvalidEntry { name, .. }
            | Self::InvalidLoad { name, .. } => Some(name),
            Self::NoStrength { .. } => Some("interface"),
            _ => None,
        }
    }

    /// The same of a load that the caller knows by another name.
    pub(crate) fn of_load(mut self, called: &'static str) -> Self {
        if let Self::InvalidLoad { name, .. } | Self::Separated { name, .. } | Self::OutOfRange { name, .. } = &mut self
        {
            if *name == LOAD {
                *name = called;
            }
        }
        self
    }

    /// A quantity that the model cannot be evaluated for.
    pub(crate) fn out_of_range(name: &'static str, value: impl Into<Value>, allowed: &'static str) -> Self {
        Self::OutOfRange { name, value: value.into(), allowed }
    }
}

/// Why a measured friction force cannot be met.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum CalibrationFailure {
    /// It is not a positive number.
    NotPositive,
    /// Both slip stresses are 0.
    NoStress,
    /// The pressure coefficient alone gives as much.
    Pressure,
    /// There is no friction at this load that could be scaled.
    NoFriction,
    /// The slip stresses would exceed G*.
    Strength,
    /// The slip stresses would be no numbers.
    Weakness,
}

impl CalibrationFailure {
    /// What is allowed, before the number, and behind it what to do.
    fn texts(self) -> (&'static str, &'static str) {
        match self {
            Self::NotPositive => ("must be finite and above ", ""),
            Self::NoStress => (
                "there is no strength to scale: slip_stress_1 and slip_stress_2 are ",
                "; with pressure_coefficient alone, set that to friction_force/load",
            ),
            Self::Pressure => (
                "must be above ",
                ", which pressure_coefficient alone gives at this load; use a smaller pressure_coefficient, or check load and \
                 friction_force",
            ),
            Self::NoFriction => ("cannot be met: at this load the friction force is ", "; measure at a heavier load"),
            Self::Strength => (
                "must be at most ",
                ", where a slip stress is the shear modulus of the bodies; is the coefficient in per cent (16 for 0.16), are load \
                 and friction_force totals over asperity_count, and roughness and moduli those of the surfaces that were measured?",
            ),
            Self::Weakness => ("must be at least ", "; are load and friction_force in the units of the parameters?"),
        }
    }
}

/// What sets a parameter that was never set.
fn sets(name: &str) -> &'static str {
    match name {
        "composite_modulus" | "effective_shear_modulus" => {
            "two materials set it, by their names or by E1, nu1, E2 and nu2"
        }
        "work_of_adhesion" => "it is 0 without adhesion, and the name of a pair of materials sets it",
        "adhesion_range" | "burgers_vector" => "the name of a pair of materials sets it",
        _ => "a roughness with a nominal_area sets it: Ra or Rq with RSm or a process, Sq with Sdq, m0 with m2",
    }
}

/// The name of a load in messages.
pub(crate) const LOAD: &str = "load";

/// A value in a message.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A number, in the shortest form that reads back as itself.
    Real(f64),
    /// A whole number.
    Integer(i64),
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Value::Real(x) => write!(f, "{}", Real(*x)),
            Value::Integer(i) => write!(f, "{i}"),
        }
    }
}

impl From<f64> for Value {
    fn from(x: f64) -> Self {
        Value::Real(x)
    }
}

impl From<i32> for Value {
    fn from(i: i32) -> Self {
        Value::Integer(i.into())
    }
}

/// What to do with the friction coefficient of an interface.
struct Calibrate<'a>(&'a Interface);

impl std::fmt::Display for Calibrate<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Interface { name, friction_coefficient, load, conditions, .. } = self.0;
        let text = |text: &'static std::ffi::CStr| text.to_str().unwrap_or_default();
        let (name, conditions) = (text(name), text(conditions));
        write!(f, "{name}: its shear strength is not known, only a friction coefficient of {friction_coefficient}")?;
        if *load > 0.0 {
            write!(f, " at {load} N")?;
        }
        write!(
            f,
            " ({conditions}): for surfaces like these calibrate with a friction force of {friction_coefficient} times the load, \
             or make an estimate, which takes it"
        )
    }
}

/// A float as a person writes it: 0.3, 1.6e11, not three hundred digits.
struct Real(f64);

impl std::fmt::Display for Real {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let exponent = (self.0.to_bits() >> 52 & 0x7ff) as i32 - 1023;
        if self.0.to_bits() << 1 == 0 || (-14..54).contains(&exponent) || exponent == 1024 {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}
