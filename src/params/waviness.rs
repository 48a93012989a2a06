//! Waves of the surfaces, longer than their roughness, and what they may be.

use super::numbers::{not_negative, positive};
use super::Params;
use crate::equilibrium::{hills, ridges};
use crate::error::Error;
use std::f64::consts::PI;

/// What waves are like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WavinessShape {
    /// Not known: there may be none.
    Unknown,
    /// Long crests side by side, as of turning and grinding: cos x.
    Ridges,
    /// Crests in two directions, as of lapping and of scraped or flattened faces: cos x + cos y.
    Hills,
}

/// Waves on which the roughness stands, of both surfaces together: heights add as squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waviness {
    /// Wq [length], root mean square height; 0 is a surface without waves.
    pub height: f64,
    /// WSm [length], the mean width of a wave; read only where there are some.
    pub width: f64,
    /// What they are like.
    pub shape: WavinessShape,
}

impl Default for Waviness {
    fn default() -> Self {
        Self { height: 0.0, width: 0.0, shape: WavinessShape::Unknown }
    }
}

/// Waves are at least this part of `height_std` high, and at most so many times it; and no steeper than this.
const LOWEST: f64 = 0.01;
const HIGHEST: f64 = 30.0;
const STEEPEST: f64 = 0.1;

impl Waviness {
    /// Heights in sigma from the crests down with their part of the surface, and WSm/pi in sigma.
    pub(crate) fn places(self, height_std: f64) -> (Vec<(f64, f64)>, f64) {
        let of = if self.shape == WavinessShape::Hills { hills } else { ridges };
        (of(self.height / height_std), self.width / (PI * height_std))
    }

    /// Each number by itself.
    pub(super) fn check(self) -> Result<(), Error> {
        not_negative("waviness_height", self.height, "must be finite and >= 0; 0 means no waves")?;
        not_negative("waviness_width", self.width, "must be finite and >= 0; it is read where waviness_height is > 0")
    }

    /// Together with the surface that they carry.
    pub(super) fn check_on(self, params: &Params) -> Result<(), Error> {
        if self.height == 0.0 {
            return Ok(());
        }
        if self.shape == WavinessShape::Unknown {
            let allowed = "must be ridges (1) or hills (2) where waviness_height is > 0, since a height alone changes no law: measure the \
                           waves along two directions; ridges have their width in one alone, hills in both";
            return Err(Error::invalid("waviness_shape", 0, allowed));
        }
        positive("waviness_width", self.width)?;
        let refuse = |is_outside: bool, name, value, allowed| match is_outside {
            true => Err(Error::out_of_range(name, value, allowed)),
            false => Ok(()),
        };
        let with_waves = "must be 0 where waviness_height is > 0: adhesion of wavy surfaces is not modelled";
        refuse(params.work_of_adhesion > 0.0, "work_of_adhesion", params.work_of_adhesion, with_waves)?;
        let ratio = self.height / params.height_std;
        let low = "must be 0, or at least 0.01 height_std: lower waves change nothing; are both in one unit?";
        refuse(ratio < LOWEST, "waviness_height", self.height, low)?;
        let high = "must be at most 30 height_std: higher waves are the form of a body, for the mesh of the solver; are both in one unit?";
        refuse(ratio > HIGHEST, "waviness_height", self.height, high)?;
        let steep = "must be at least 10 waviness_height; are both in one unit?";
        refuse(self.height > STEEPEST * self.width, "waviness_width", self.width, steep)?;
        let unknown = "must be known where waviness_height is > 0";
        refuse(params.nominal_area == 0.0, "nominal_area", params.nominal_area, unknown)?;
        let short = "must be at least 4 times the distance of asperities, and the mean wave of the roughness, 2 pi height_std/rms_slope: shorter \
                     waves are roughness; is it in the unit of height_std?";
        let roughness = 2.0 * PI * params.height_std / params.rms_slope.max(f64::MIN_POSITIVE);
        let roughness = if params.rms_slope > 0.0 { roughness } else { 0.0 };
        let distance = 4.0 * (params.nominal_area / params.asperity_count).sqrt();
        refuse(self.width < distance.max(roughness), "waviness_width", self.width, short)?;
        let small = "must be at least waviness_width^2, so that a wave fits it; are lengths and area in one unit? Waves as wide as the body are \
                     its form, for the mesh of the solver";
        refuse(params.nominal_area < self.width * self.width, "nominal_area", params.nominal_area, small)
    }
}
