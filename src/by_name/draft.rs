//! Parameters while they are set by name: the numbers of all families of heights are kept, whichever is chosen in the end.

use crate::distribution::{tabulated, weibull::Weibull};
use crate::error::Error;
use crate::params::{HeightFamily, Params};

/// The families of heights as numbers.
pub const GAUSSIAN: i32 = 0;
pub const WEIBULL: i32 = 1;
pub const JOHNSON: i32 = 2;
pub const TABULATED: i32 = 3;
pub const AT_SCORES: i32 = 4;

/// What is said of a number that is none of them.
pub const NO_FAMILY: &str =
    "must be one of ASPERITY_HEIGHTS_: GAUSSIAN (0), WEIBULL (1), JOHNSON (2), TABULATED (3), AT_SCORES (4)";

/// The shape of Weibull heights without skew (Table 1 of the paper).
const DEFAULT_SHAPE: f64 = 3.602;

/// Parameters with the choice of their heights side by side.
#[derive(Debug, Clone)]
pub struct Draft {
    /// All other parameters. Of the heights only a table is here, where there is one.
    pub params: Params,
    pub height_distribution: i32,
    pub weibull_shape: f64,
    pub skew: f64,
    pub kurtosis: f64,
}

impl Default for Draft {
    fn default() -> Self {
        Self::of(&Params::default())
    }
}

impl Draft {
    pub fn of(params: &Params) -> Self {
        let mut draft = Self {
            params: params.clone(),
            height_distribution: GAUSSIAN,
            weibull_shape: DEFAULT_SHAPE,
            skew: 0.0,
            kurtosis: 3.0,
        };
        match params.heights {
            HeightFamily::Gaussian => {}
            HeightFamily::Weibull { shape } => draft.choose_weibull(shape),
            HeightFamily::Johnson { skew, kurtosis } => {
                (draft.height_distribution, draft.skew, draft.kurtosis) = (JOHNSON, skew, kurtosis);
            }
            HeightFamily::Tabulated { .. } => draft.height_distribution = TABULATED,
            HeightFamily::AtScores { .. } => draft.height_distribution = AT_SCORES,
        }
        draft
    }

    /// The parameters, with the heights that are chosen.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a family that is none, and for a skew or a kurtosis that the heights do not read.
    pub fn into_params(self) -> Result<Params, Error> {
        let heights = match self.height_distribution {
            GAUSSIAN => HeightFamily::Gaussian,
            WEIBULL => HeightFamily::Weibull { shape: self.weibull_shape },
            JOHNSON => HeightFamily::Johnson { skew: self.skew, kurtosis: self.kurtosis },
            TABULATED | AT_SCORES => match self.table(self.height_distribution) {
                Some(table) => table,
                None => return Err(tabulated::check_length(0).err().unwrap_or(Error::Unset { name: "table_height" })),
            },
            other => return Err(Error::invalid("height_distribution", other, NO_FAMILY)),
        };
        self.check_shape()?;
        Ok(Params { heights, ..self.params })
    }

    /// The heights of a table, read as one family of them or the other.
    fn table(&self, family: i32) -> Option<HeightFamily> {
        let (height, values) = self.params.heights.table()?;
        Some(HeightFamily::of_table(family == AT_SCORES, height.clone(), values.clone()))
    }

    /// Refuses a skew or a kurtosis that the heights do not read.
    fn check_shape(&self) -> Result<(), Error> {
        if self.height_distribution == JOHNSON {
            return Ok(());
        }
        if self.skew != 0.0 {
            let allowed = "must be 0 unless heights are Johnson's: choose those, or the weibull_shape of this skew";
            return Err(Error::invalid("skew", self.skew, allowed));
        }
        if self.kurtosis != 3.0 {
            let allowed = "must be 3 unless heights are Johnson's: choose those, with skew and kurtosis";
            return Err(Error::invalid("kurtosis", self.kurtosis, allowed));
        }
        Ok(())
    }

    pub fn choose_weibull(&mut self, shape: f64) {
        (self.height_distribution, self.weibull_shape) = (WEIBULL, shape);
        (self.skew, self.kurtosis) = (0.0, 3.0);
    }

    /// As [`Params::set_skew`].
    pub fn set_skew(&mut self, skew: f64) -> Result<(), Error> {
        self.choose_weibull(Weibull::shape_of_skew(skew)?);
        Ok(())
    }
}
