//! A contact that remembers: what resists a displacement at a load, after all that came before.
//!
//! The levels of stiffness and their limits are those of `memory`; strength and stiffness are the compiled friction force and
//! tangential stiffness.

use super::after::After;
use super::Model;
use crate::error::{Error, LOAD};
use crate::law::Quantity;
use crate::memory::{stuck, within, Cells, Levels, MicroslipStep, PerLevel, Sloped};
use crate::memory::{LARGEST, LAST, MOST_SLIP_LENGTHS, REACH, STATE};
use crate::numerics::float_bits::{finite, infinite};
use crate::numerics::four::{Four, Portable};
use crate::numerics::neighbours::Neighbours;

impl Model {
    /// Displaces a contact under a load; its state, all 0 if it has just closed, becomes what it is after.
    ///
    /// # Errors
    /// [`Error::InvalidEntry`] of an increment or a state that is not finite, or a state that is none of a contact; those of
    /// [`Model::validate_load`]. The state is then as before, but all 0 where the surfaces are apart.
    pub fn microslip_step(
        &self,
        load: f64,
        increment: [f64; 2],
        state: &mut [f64; STATE],
    ) -> Result<MicroslipStep, Error> {
        if self.is_after(load, state) {
            if let Some(step) = self.step_after(load, increment, state) {
                return step;
            }
        }
        self.step_of_any(None, load, self.strength_and_stiffness(load), increment, state)
    }

    /// The same with both at the load; without `DETAILS` only force and stiffness are told. `room` is for the levels at the load, made
    /// where they are needed.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub(crate) fn step<V: Cells, const DETAILS: bool>(
        &self,
        load: f64,
        all: [Sloped; 2],
        increment: [f64; 2],
        state: &mut [f64; STATE],
        room: &mut Option<Levels>,
    ) -> Result<MicroslipStep, Error> {
        if self.is_after(load, state) {
            if let Some(step) = self.step_after(load, increment, state) {
                return step;
            }
        }
        self.step_by::<V, DETAILS>(None, load, all, increment, state, room)
    }

    /// The same for any processor, once for all that are after a larger load.
    #[inline(never)]
    fn step_of_any(
        &self,
        after: Option<&After>,
        load: f64,
        all: [Sloped; 2],
        increment: [f64; 2],
        state: &mut [f64; STATE],
    ) -> Result<MicroslipStep, Error> {
        self.step_by::<Portable, true>(after, load, all, increment, state, &mut None)
    }

    /// Whether a contact has borne more, on a model that knows what that does.
    #[inline(always)]
    fn is_after(&self, load: f64, state: &[f64; STATE]) -> bool {
        load < state[LARGEST] && self.largest_load > 0.0
    }

    /// The step of a contact that has borne a larger load, if it has another law by that.
    #[cold]
    #[inline(never)]
    fn step_after(
        &self,
        load: f64,
        increment: [f64; 2],
        state: &mut [f64; STATE],
    ) -> Option<Result<MicroslipStep, Error>> {
        let after = self.after(state[LARGEST])?;
        Some(self.step_of_any(Some(&after), load, after.sloped(load), increment, state))
    }

    /// A step by the law of this model, or of contacts after a larger load.
    #[inline(always)]
    fn step_by<V: Cells, const DETAILS: bool>(
        &self,
        after: Option<&After>,
        load: f64,
        all: [Sloped; 2],
        increment: [f64; 2],
        state: &mut [f64; STATE],
        room: &mut Option<Levels>,
    ) -> Result<MicroslipStep, Error> {
        let (reach, last, largest) = (state[REACH], state[LAST], state[LARGEST]);
        let is_given = finite(load) && finite(increment[0]) && finite(increment[1]);
        let [strength, stiffness] = all.map(|all| all.value);
        let farthest = MOST_SLIP_LENGTHS * (strength / stiffness);
        let resists = strength > 0.0 && finite(farthest);
        let excess = if is_given { load - self.law.table(Quantity::Friction).pull_off } else { 0.0 };
        // At the load of the step before most contacts stick in all their levels, and need nothing else.
        let is_as_before = is_given && resists && last == stiffness && reach == stiffness;
        let is_as_before = is_as_before && (load == largest || (load < largest && finite(largest)));
        if is_as_before && excess >= 0.0 && after.is_none() {
            if let Some(step) = stuck::<V>(all, &self.law.limits().around(excess), increment, state) {
                return Ok(step);
            }
        }
        let square = square_of::<V>(state);
        let is_sound = finite(square) && 0.0 <= last && last <= reach && finite(reach);
        let is_sound = is_sound && 0.0 <= largest && largest <= self.heaviest;
        if !(is_sound && is_given) {
            validate(load, increment, state, self.heaviest)?;
        }
        // Also of a load that is too heavy.
        let known = strength >= 0.0 && stiffness >= 0.0;
        if excess < 0.0 || !known {
            self.validate_load(load).inspect_err(|error| {
                if matches!(error, Error::Separated { .. }) {
                    state.fill(0.0);
                }
            })?;
            return Err(Self::not_evaluated(load));
        }
        let levels = room.get_or_insert_with(Levels::default);
        [levels.strength, levels.stiffness] = all;
        if !resists {
            self.limits::<V, false>(after, load, None, &mut levels.shares, &mut levels.share_slopes);
            return Ok(levels.step_of_none(increment, state));
        }
        let increment = within(increment, farthest);
        if square.sqrt() > farthest {
            state[..REACH].iter_mut().for_each(|x| *x = x.clamp(-farthest, farthest));
        }
        let cut = levels.cut::<V, DETAILS>(increment, state);
        self.limits::<V, DETAILS>(after, load, cut.of_limits, &mut levels.shares, &mut levels.share_slopes);
        state[LARGEST] = if load > largest { load } else { largest };
        Ok(levels.step::<V, DETAILS>(increment, cut, state))
    }

    /// The limits of the levels at a load, as [`Limits::at_excess`](crate::memory::Limits::at_excess).
    #[inline(always)]
    fn limits<V: Four, const SLOPES: bool>(
        &self,
        after: Option<&After>,
        load: f64,
        cut: Option<[f64; 2]>,
        shares: &mut PerLevel,
        slopes: &mut PerLevel,
    ) {
        match after {
            Some(after) => after.limits(load, cut, shares, slopes),
            None => {
                let excess = load - self.law.table(Quantity::Friction).pull_off;
                self.law.limits().at_excess::<V, SLOPES>(excess, cut, shares, slopes);
            }
        }
    }

    /// Friction force and tangential stiffness.
    #[inline(always)]
    pub(crate) fn strength_and_stiffness(&self, load: f64) -> [Sloped; 2] {
        [self.sloped(Quantity::Friction, load), self.sloped(Quantity::Radius, load)]
    }

    /// A quantity and its slope; at the pull-off load, where that is infinite, the slope at the next load.
    #[inline(always)]
    fn sloped(&self, quantity: Quantity, load: f64) -> Sloped {
        if let Some((value, slope)) = self.tabulated(quantity, load) {
            return Sloped { value, slope };
        }
        let (value, slope) = self.value_and_slope(quantity, load);
        let slope = if infinite(slope) { self.value_and_slope(quantity, load.above()).1.min(f64::MAX) } else { slope };
        Sloped { value, slope }
    }
}

/// The sum of the squares of all displacements of a state; not finite if one of them is not, or is so large that it has no
/// square.
#[inline(always)]
fn square_of<V: Four>(state: &[f64; STATE]) -> f64 {
    let mut squares = [V::splat(0.0); 2];
    for j in (0..REACH).step_by(8) {
        let (some, others) = (V::read(state, j), V::read(state, j + 4));
        squares = [squares[0] + some * some, squares[1] + others * others];
    }
    (squares[0] + squares[1]).sum()
}

/// Whether a step can be taken of these.
#[cold]
fn validate(load: f64, increment: [f64; 2], state: &[f64; STATE], heaviest: f64) -> Result<(), Error> {
    const ALLOWED: &str = "must be finite";
    if !finite(load) {
        return Err(Error::InvalidLoad { name: LOAD, value: load });
    }
    for (name, numbers) in [("increment", &increment[..]), ("before", state)] {
        if let Some((index, value)) = numbers.iter().copied().enumerate().find(|(_, value)| !finite(*value)) {
            return Err(Error::InvalidEntry { name, index, value, allowed: ALLOWED });
        }
    }
    let (reach, last) = (state[REACH], state[LAST]);
    let largest = state[LARGEST];
    if !(0.0 <= largest && largest <= heaviest) {
        let allowed = "must be the largest load that the contact has borne, or 0";
        return Err(Error::InvalidEntry { name: "before", index: LARGEST, value: largest, allowed });
    }
    if 0.0 <= last && last <= reach {
        return Ok(());
    }
    Err(Error::InvalidEntry {
        name: "before",
        index: LAST,
        value: last,
        allowed: "must be from 0 to the number before it",
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;
    use crate::params::Params;

    /// A step by all that it may need.
    fn the_long_way(model: &Model, load: f64, increment: [f64; 2], state: &mut [f64; STATE]) -> MicroslipStep {
        let mut levels = Levels::default();
        [levels.strength, levels.stiffness] = model.strength_and_stiffness(load);
        let cut = levels.cut::<Portable, true>(increment, state);
        model.limits::<Portable, true>(None, load, cut.of_limits, &mut levels.shares, &mut levels.share_slopes);
        state[LARGEST] = state[LARGEST].max(load);
        levels.step::<Portable, true>(increment, cut, state)
    }

    #[test]
    fn contacts_that_stick_slip_and_stick_again_are_stepped_the_short_way_as_the_long_way() {
        let mut random = Random(7);
        for params in [Params::paper(), Params { work_of_adhesion: 0.0, ..Params::paper() }] {
            let model = Model::new(&params).expect("a model");
            let (mut load, mut size, mut factor) = (10.0, 0.0, 1.0);
            let (mut state, mut other) = ([0.0; STATE], [0.0; STATE]);
            let [mut stuck_as_before, mut slipped, mut fallen, mut farther] = [0; 4];
            for i in 0..4000 {
                let [strength, stiffness] = model.strength_and_stiffness(load);
                let length = strength.value / stiffness.value;
                if i % 8 == 0 {
                    size = length * 10_f64.powf(random.between(-7.0, 0.5));
                    factor = [1.0, 1.0, 1.2, 0.8][random.between(0.0, 4.0) as usize];
                }
                load = (load * factor).clamp(1e-2, 1e3);
                let increment = [random.between(-1.0, 1.0) * size, random.between(-1.0, 1.0) * size];
                let before = state;
                let found = model.microslip_step(load, increment, &mut state).expect("a step");
                let expected = the_long_way(&model, load, increment, &mut other);
                let near = |a: f64, b: f64, unit: f64| (a - b).abs() <= 1e-13 * unit;
                let (force, work) = (model.friction_force_at_load(load), model.friction_force_at_load(load) * length);
                for axis in 0..2 {
                    assert!(near(found.force[axis], expected.force[axis], force), "{i}: {found:?}, not {expected:?}");
                    assert!(near(found.dforce_dload[axis] * load, expected.dforce_dload[axis] * load, force), "{i}");
                    assert!(near(found.stiffness[3 * axis], expected.stiffness[3 * axis], force / length), "{i}");
                }
                assert!(near(found.dissipated, expected.dissipated, work), "{i}: {found:?}, not {expected:?}");
                assert!(near(found.slipping, expected.slipping, 1.0), "{i}");
                assert!((0..REACH).all(|j| near(state[j], other[j], size.max(length))), "{i}");
                assert_eq!(state[REACH..], other[REACH..], "{i}");
                let is_as_before = before[LAST] == state[LAST] && before[REACH] == state[REACH];
                stuck_as_before += u32::from(is_as_before && found.slipping == 0.0);
                slipped += u32::from(found.slipping > 0.0);
                fallen += u32::from(state[LAST] < before[LAST]);
                farther += u32::from(state[REACH] > before[REACH]);
            }
            let counts = [stuck_as_before, slipped, fallen, farther];
            assert!(counts.iter().all(|&count| count > 200), "{counts:?}");
        }
    }
}
