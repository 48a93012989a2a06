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
const STEPS_TO_TURN: u32 = 8;
/// Between two scores of a table, or less, so many summits are looked at for being nearest to a kink.
const LOOKS_FOR_TURNS: usize = 9;
type Looks = [(f64, f64, f64); LOOKS_FOR_TURNS];

impl Population {
    /// The same panel, or its first part up to a kink. Where radii vary with height it ends at an extremum of the contact
    /// radius too, so that each radius within shows at its ends.
    pub(super) fn cut_at_kink(&self, separation: f64, panel: &mut SummitPanel, start_kink: Option<usize>) {
        self.cut_at_kink_of_contact(separation, panel, start_kink);
        if self.radius.may_fall() && (self.ends_at_extrema || self.is_near_kink(panel)) {
            let is_cut = self.cut_where(separation, panel, Point::radius_change, None);
            let turn = if is_cut { None } else { self.between_extrema(separation, panel) };
            if let Some(turn) = turn {
                panel.to = self.on_panel(separation, panel, turn, &panel.guess());
                panel.kink = None;
                self.cut_where(separation, panel, Point::radius_change, None);
            }
        }
        for (index, kink) in self.radius_kinks.into_iter().enumerate().filter(|&(index, _)| start_kink != Some(index)) {
            self.cut_where(separation, panel, |point| point.contact.radius - kink, Some(index));
        }
        if let Some(ratio) = self.onset_ratio {
            if !self.slip.is_of_radius() {
                self.cut_at_friction_over_radius(separation, panel, ratio, start_kink);
            }
            if self.has_onset() && !self.is_onset(start_kink) {
                self.cut_near_onset(separation, panel, ratio);
            }
        }
    }

    /// Whether the contact radius may be one at which friction has a kink, by how it is and changes at the ends.
    fn is_near_kink(&self, panel: &SummitPanel) -> bool {
        let reach: f64 = [panel.from, panel.to].iter().map(|end| panel.radius_change_at(end).abs()).sum();
        let (a, b) = (panel.from.contact.radius, panel.to.contact.radius);
        // No number where the end was not found.
        self.radius_kinks.iter().any(|kink| (a.min(b) - reach..a.max(b) + reach).contains(kink))
    }

    /// Where within a panel the contact radius falls though it rises at both ends, or the other way: it turns back on either side.
    /// A panel that begins at an extremum begins with next to no change, of either sign.
    fn between_extrema(&self, separation: f64, panel: &SummitPanel) -> Option<f64> {
        let [start, end] = [panel.from, panel.to].map(|end| panel.radius_change_at(&end));
        let guess = panel.guess();
        let sign = (start + end).signum();
        let change = |x: f64| sign * self.on_panel(separation, panel, x, &guess).radius_change();
        let (from, to) = (panel.variable(&panel.from), panel.variable(&panel.to));
        let at = |quarter: f64| from + 0.25 * quarter * (to - from);
        // Five equally far apart: parabolas through three neighbours mostly tell that none is near 0.
        let looks = [sign * start, change(at(1.0)), change(at(2.0)), change(at(3.0)), sign * end];
        if looks.windows(3).all(|looks| lowest_of_parabola(looks) > 0.5 * looks[0].min(looks[1]).min(looks[2])) {
            return None;
        }
        // The smallest change of the radius is looked for on both sides of the best place so far, ever nearer.
        let best = (1..4).fold(1, |best, i| if looks[i] < looks[best] { i } else { best });
        let (mut place, mut least, mut step) = (at(best as f64), looks[best], 0.25 * (to - from));
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
    fn cut_at_kink_of_contact(&self, separation: f64, panel: &mut SummitPanel, start_kink: Option<usize>) {
        let has_kinks = self.kinks_of_contact[0].is_finite();
        let looks = self.radius.scores.as_ref().filter(|_| has_kinks).map(|_| self.looks(panel));
        for (index, kink) in self.kinks_of_contact.into_iter().enumerate().filter(|(_, kink)| kink.is_finite()) {
            if let Some(looks) = &looks {
                self.cut_at_turn(separation, panel, kink, looks);
            } else if !self.radius.is_constant() {
                self.cut_where(separation, panel, |point| 1.0 - kink * point.g_rate, None);
            }
            if start_kink != Some(RADII + index) {
                let residual = |point: &Point| point.contact.overlap + self.lost - kink * self.radius.factor(point.z);
                self.cut_where(separation, panel, residual, Some(RADII + index));
            }
        }
    }

    /// The same where there may be more of them, since radii are cubics: at the first that shows between looks, each at a height with
    /// the radius there and its slope, if a summit may be at the kink.
    fn cut_at_turn(&self, separation: f64, panel: &mut SummitPanel, kink: f64, looks: &Looks) {
        let step = looks[1].0 - looks[0].0;
        let away = |&(z, g, _): &(f64, f64, f64)| z - separation + self.lost - kink * g;
        let rate = |&(_, _, g_rate): &(f64, f64, f64)| 1.0 - kink * g_rate;
        let is_above = away(&looks[0]) > 0.0;
        if looks.iter().all(|look| (away(look) > 0.0) == is_above && away(look).abs() > step * rate(look).abs()) {
            return;
        }
        let turns = looks.windows(2).filter(|looks| (rate(&looks[0]) < 0.0) != (rate(&looks[1]) < 0.0));
        let rate = |z: f64| 1.0 - kink * self.radius.at(z).1;
        let turns = turns.map(|looks| root::bracketed(rate, looks[0].0, looks[1].0));
        // A panel that begins at one may show it again.
        if let Some(turn) = turns.into_iter().find(|&turn| is_inside(turn, panel.from.z, panel.to.z)) {
            panel.to = self.at_height(separation, turn, panel.to.contact.parameter);
            panel.kink = None;
        }
    }

    fn looks(&self, panel: &SummitPanel) -> Looks {
        let (from, to) = (panel.from.z, panel.to.z);
        std::array::from_fn(|i| {
            let z = from + (to - from) * i as f64 / (LOOKS_FOR_TURNS - 1) as f64;
            let (g, g_rate) = self.radius.at(z);
            (z, g, g_rate)
        })
    }

    /// Ends a panel where a function of its summits changes sign: at a kink, or near enough to an extremum. Returns whether it does.
    #[inline]
    fn cut_where(
        &self,
        separation: f64,
        panel: &mut SummitPanel,
        f: impl Fn(&Point) -> f64,
        kink: Option<usize>,
    ) -> bool {
        let at_ends = [f(&panel.from), f(&panel.to)];
        (at_ends[0] < 0.0) != (at_ends[1] < 0.0) && self.cut_between(separation, panel, &f, at_ends, kink)
    }

    /// The same where it does, with its values at the ends; compiled once for all functions.
    fn cut_between(
        &self,
        separation: f64,
        panel: &mut SummitPanel,
        f: &dyn Fn(&Point) -> f64,
        at_ends: [f64; 2],
        kink: Option<usize>,
    ) -> bool {
        let [from, to] = [panel.from, panel.to].map(|end| panel.variable(&end));
        // An end that was not found tells nothing: the panel will be tried again shorter.
        if to.is_nan() {
            return false;
        }
        let guess = panel.guess();
        let f = |x| f(&self.on_panel(separation, panel, x, &guess));
        let root = root::between(f, (from, at_ends[0]), (to, at_ends[1]));
        let cut = self.on_panel(separation, panel, root, &guess);
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

/// The least value between the outer ones of three equally far apart of the parabola through them.
fn lowest_of_parabola(values: &[f64]) -> f64 {
    let [before, here, after] = [values[0], values[1], values[2]];
    let (tilt, bend) = (0.5 * (after - before), before + after - 2.0 * here);
    match tilt.abs() < bend {
        true => here - 0.5 * tilt * tilt / bend,
        false => before.min(after),
    }
}

/// Whether a cut leaves a panel on both sides, rounding apart.
fn is_inside(x: f64, from: f64, to: f64) -> bool {
    let part = (x - from) / (to - from);
    part > 1e-12 && part < 1.0 - 1e-12
}
