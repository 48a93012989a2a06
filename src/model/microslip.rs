//! A contact that remembers: what resists a displacement at a load, after all that came before.
//!
//! The law of the elements is that of `jenkins`, their shares that of `law`; strength and stiffness are the compiled friction force
//! and tangential stiffness.

use super::Model;
use crate::error::{Error, LOAD};
use crate::float_bits::{finite, infinite};
use crate::jenkins::{Elements, Response, Sloped, STATE};
use crate::law::Quantity;
use crate::neighbours::Neighbours;

/// What resists a displacement of the surfaces along each other, in the caller's units.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MicroslipStep {
    /// T, along both directions [force].
    pub force: [f64; 2],
    /// dT/d(increment) [force/length], row by row.
    pub stiffness: [f64; 4],
    /// dT/d(load).
    pub dforce_dload: [f64; 2],
    /// Work of the sliders in this step, >= 0 [force length].
    pub dissipated: f64,
    /// Fraction of the strength that slips.
    pub slipping: f64,
}

impl Model {
    /// Displaces a contact under a load; its state, all 0 if it has just closed, becomes what it is after.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] of an increment or a state that is not finite; those of [`Model::validate_load`]. The state is
    /// then as before, but all 0 where the surfaces are apart.
    pub fn microslip_step(
        &self,
        load: f64,
        increment: [f64; 2],
        state: &mut [f64; STATE],
    ) -> Result<MicroslipStep, Error> {
        self.step::<true>(load, increment, state, &mut Elements::default())
    }

    /// The same; without `DETAILS` only force and stiffness are told. `elements` become those at the load.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub(crate) fn step<const DETAILS: bool>(
        &self,
        load: f64,
        increment: [f64; 2],
        state: &mut [f64; STATE],
        elements: &mut Elements,
    ) -> Result<MicroslipStep, Error> {
        self.elements_at::<DETAILS>(load, increment, state, elements)?;
        Ok(MicroslipStep::new(&elements.step::<DETAILS>(increment, state)))
    }

    /// Makes the elements those at a load, with their slopes if `DETAILS` are asked for, if all is in order.
    #[inline(always)]
    fn elements_at<const DETAILS: bool>(
        &self,
        load: f64,
        increment: [f64; 2],
        state: &mut [f64; STATE],
        elements: &mut Elements,
    ) -> Result<(), Error> {
        const FINITE: &str = "must be finite";
        if !finite(load) {
            return Err(Error::InvalidLoad { name: LOAD, value: load });
        }
        if let Some((index, value)) = increment.into_iter().enumerate().find(|(_, value)| !finite(*value)) {
            return Err(Error::InvalidEntry { name: "increment", index, value, allowed: FINITE });
        }
        // What is not finite is no number when it is multiplied by 0.
        let mut nothing = [0.0; 4];
        for four in state.chunks_exact(4) {
            for i in 0..4 {
                nothing[i] += 0.0 * four[i];
            }
        }
        if nothing != [0.0; 4] {
            let found = state.iter().copied().enumerate().find(|(_, value)| !finite(*value));
            let (index, value) = found.unwrap_or_default();
            return Err(Error::InvalidEntry { name: "before", index, value, allowed: FINITE });
        }
        let (strength, stiffness) = (self.sloped(Quantity::Friction, load), self.sloped(Quantity::Radius, load));
        let pull_off = self.law.table(Quantity::Friction).pull_off;
        // Also of a load that is too heavy.
        let known = strength.value >= 0.0 && stiffness.value >= 0.0;
        if load < pull_off || !known {
            self.validate_load(load).inspect_err(|error| {
                if matches!(error, Error::Separated { .. }) {
                    state.fill(0.0);
                }
            })?;
            return Err(Self::not_evaluated(load));
        }
        (elements.strength, elements.stiffness) = (strength, stiffness);
        let (shares, slopes) = (&mut elements.shares, &mut elements.share_slopes);
        self.law.shares().at_excess::<DETAILS>(load - pull_off, shares, slopes);
        Ok(())
    }

    /// A quantity and its slope; at the pull-off load, where that is infinite, the slope at the next load.
    #[inline]
    fn sloped(&self, quantity: Quantity, load: f64) -> Sloped {
        let (value, slope) = self.value_and_slope(quantity, load);
        let slope = if infinite(slope) { self.value_and_slope(quantity, load.above()).1.min(f64::MAX) } else { slope };
        Sloped { value, slope }
    }
}

impl MicroslipStep {
    fn new(response: &Response) -> Self {
        let [xx, xy, yy] = response.stiffness;
        Self {
            force: response.force,
            stiffness: [xx, xy, xy, yy],
            dforce_dload: response.by_load,
            dissipated: response.dissipated,
            slipping: response.slipping,
        }
    }
}
