//! Where a panel ends before it is as long as it may be: at the kinks of the laws, where a contact radius is one of the slip
//! law's or an overlap one of the law of contact's, and at extrema, so that no kink is passed twice within a panel.

use super::panels::SummitPanel;
use super::{Point, Population, ONSET, RADII};
use crate::asperity::contact::KINKS;
use crate::asperity::slip::SlipOnset;
use crate::numerics::root;

/// Over no panel does the distance from there grow by more than this.
const MOST_DISTANCE_GROWTH: f64 = 4.0;
/// Between two extrema of the contact radius friction is hardly changed by passing a kink if they are nearer to each other than a panel
/// halved so often.
const STEPS_TO_TURN: u32 = 9;
/// Between two scores of a table, or less, a summit is looked at so often for being nearest to a kink.
const LOOKS_FOR_TURNS: u32 = 8;

impl Population {
    /// The same panel, or its first part up to a kink. Where radii vary with height it ends at an extremum of the contact
    /// radius too, so that each radius within shows at its ends.
    pub(super) fn cut_at_kink(&self, separation: f64, panel: SummitPanel, start_kink: Option<usize>) -> SummitPanel {
        let mut panel = self.cut_at_kink_of_contact(separation, panel, start_kink);
        if !self.radius.is_constant() {
            let is_cut = self.cut_where(separation, &mut panel, Point::radius_change, None);
            let turn = if is_cut { None } else { self.between_extrema(separation, &panel) };
            if let Some(turn) = turn {
                panel.to = self.on_panel(separation, &panel, turn);
                panel.kink = None;
                self.cut_where(separation, &mut panel, Point::radius_change, None);
            }
        }
        for (index, kink) in self.radius_kinks.into_iter().enumerate().filter(|&(index, _)| start_kink != Some(index)) {
            self.cut_where(separation, &mut panel, |point| point.contact.radius - kink, Some(index));
        }
        if let Some(ratio) = self.onset_ratio {
            if !self.slip.is_of_radius() {
                self.cut_at_friction_over_radius(separation, &mut panel, ratio, start_kink);
            }
            if self.has_onset() && !self.is_onset(start_kink) {
                self.cut_near_onset(separation, &mut panel, ratio);
            }
        }
        panel
    }

    /// Where within a panel the contact radius falls though it rises at both ends, or the other way: it turns back on either side.
    /// A panel that begins at an extremum begins with next to no change, of either sign. `None` also where the radius is far from
    /// where friction has a kink, and where radii do not fall with height.
    fn between_extrema(&self, separation: f64, panel: &SummitPanel) -> Option<f64> {
        if !self.radius.may_fall() {
            return None;
        }
        let [start, end] = [panel.from, panel.to].map(|end| panel.radius_change_at(&end));
        let (a, b) = (panel.from.contact.radius, panel.to.contact.radius);
        let reach = start.abs() + end.abs();
        let near = a.min(b) - reach..a.max(b) + reach;
        if !self.radius_kinks.iter().any(|kink| near.contains(kink)) {
            return None;
        }
        // The smallest change of the radius is looked for on both sides of the best place so far, ever nearer.
        let change = |x: f64| (start + end).signum() * self.on_panel(separation, panel, x).radius_change();
        let (from, to) = (panel.variable(&panel.from), panel.variable(&panel.to));
        let (mut place, mut step) = (0.5 * (from + to), 0.5 * (to - from));
        let mut least = change(place);
        for _ in 0..STEPS_TO_TURN {
            if least < 0.0 {
                break;
            }
            step *= 0.5;
            for x in [place - step, place + step] {
                let there = change(x);
                if there < least {
                    (place, least) = (x, there);
                }
            }
        }
        (least < 0.0).then_some(place)
    }

    /// Ends a panel where its summits are much farther from the onset of slip, or much nearer, than where it begins: what they
    /// resist is singular there, also where no summit is of that height.
    fn cut_near_onset(&self, separation: f64, panel: &mut SummitPanel, ratio: f64) {
        let left = |point: &Point| 1.0 - ratio * point.contact.radius / self.slip.friction(&point.contact).force;
        let [from, to] = [panel.from, panel.to].map(|point| left(&point));
        if from > 0.0 && !self.is_onset(panel.kink) {
            let limit = if to > from { MOST_DISTANCE_GROWTH * from } else { from / MOST_DISTANCE_GROWTH };
            self.cut_where(separation, panel, |point| left(point) - limit, None);
        }
    }

    /// Ends a panel where the friction force of its summits is this times the contact radius, and where their ratio turns
    /// back, so that each ratio within shows at the ends.
    fn cut_at_friction_over_radius(
        &self,
        separation: f64,
        panel: &mut SummitPanel,
        ratio: f64,
        start_kink: Option<usize>,
    ) {
        const KINK: Option<usize> = Some(RADII + KINKS);
        let turn = |point: &Point| {
            let friction = self.slip.friction(&point.contact);
            point.change(|rates| friction.rate(rates)) * point.contact.radius - friction.force * point.radius_change()
        };
        self.cut_where(separation, panel, turn, None);
        if start_kink != KINK {
            let excess = |point: &Point| match point.contact.radius {
                // Force over radius is 0 at 0.
                0.0 => -ratio,
                radius => self.slip.friction(&point.contact).force / radius - ratio,
            };
            self.cut_where(separation, panel, excess, KINK);
        }
    }

    /// The same for the kinks of the law of contact, which move with the radius: where a summit is nearest to or farthest
    /// from one a panel ends too. There is no more than one such place as far as radii change ever faster or ever slower.
    fn cut_at_kink_of_contact(
        &self,
        separation: f64,
        mut panel: SummitPanel,
        start_kink: Option<usize>,
    ) -> SummitPanel {
        for (index, kink) in self.kinks_of_contact.into_iter().enumerate().filter(|(_, kink)| kink.is_finite()) {
            if self.radius.scores.is_some() {
                self.cut_at_turn(separation, &mut panel, kink);
            } else if !self.radius.is_constant() {
                self.cut_where(separation, &mut panel, |point| 1.0 - kink * point.g_rate, None);
            }
            if start_kink != Some(RADII + index) {
                let residual = |point: &Point| point.contact.overlap + self.lost - kink * self.radius.factor(point.z);
                self.cut_where(separation, &mut panel, residual, Some(RADII + index));
            }
        }
        panel
    }

    /// The same where there may be more of them, since radii are cubics: at the first that shows in steps.
    fn cut_at_turn(&self, separation: f64, panel: &mut SummitPanel, kink: f64) {
        let rate = |z: f64| 1.0 - kink * self.radius.at(z).1;
        let (from, to) = (panel.from.z, panel.to.z);
        let place = |step: u32| from + (to - from) * f64::from(step) / f64::from(LOOKS_FOR_TURNS);
        let steps = (1..=LOOKS_FOR_TURNS).map(|step| (place(step - 1), place(step)));
        let turns = steps
            .filter(|&(lower, upper)| (rate(lower) < 0.0) != (rate(upper) < 0.0))
            .map(|(lower, upper)| root::bracketed(rate, lower, upper));
        // A panel that begins at one may show it again.
        if let Some(turn) = turns.into_iter().find(|&turn| is_inside(turn, from, to)) {
            panel.to = self.at_height(separation, turn, panel.to.contact.parameter);
            panel.kink = None;
        }
    }

    /// Ends a panel where a function of its summits changes sign: at a kink, or near enough to an extremum. Returns whether it does.
    fn cut_where(
        &self,
        separation: f64,
        panel: &mut SummitPanel,
        f: impl Fn(&Point) -> f64,
        kink: Option<usize>,
    ) -> bool {
        let ends = [panel.from, panel.to].map(|end| (panel.variable(&end), f(&end)));
        let [(from, at_from), (to, at_to)] = ends;
        // An end that was not found tells nothing: the panel will be tried again shorter.
        if (at_from < 0.0) == (at_to < 0.0) || to.is_nan() {
            return false;
        }
        let root = root::between(|x| f(&self.on_panel(separation, panel, x)), ends[0], ends[1]);
        let cut = self.on_panel(separation, panel, root);
        // Two kinks at one height are not passed in turn for ever.
        let is_cut = is_inside(root, from, to) && cut.z > panel.from.z;
        if is_cut {
            panel.to = cut;
            panel.kink = kink;
        }
        is_cut
    }

    /// Whether panels end where contacts are about to slip as a whole, after they have slipped in part.
    pub(super) fn has_onset(&self) -> bool {
        self.onset_ratio.is_some() && self.slip.onset == SlipOnset::Partial
    }

    /// Whether a kink is where they are.
    pub(super) fn is_onset(&self, kink: Option<usize>) -> bool {
        let is_one = kink.is_some_and(|kink| (ONSET..RADII).contains(&kink) || kink == RADII + KINKS);
        is_one && self.slip.onset == SlipOnset::Partial
    }
}

/// Whether a cut leaves a panel on both sides, rounding apart.
fn is_inside(x: f64, from: f64, to: f64) -> bool {
    let part = (x - from) / (to - from);
    part > 1e-12 && part < 1.0 - 1e-12
}
