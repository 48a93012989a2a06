//! How long a panel of 16 Gauss points may be for its sum to give the integral of a density to some ten digits.
//!
//! One rule for all families: a panel is short beside the distance to where the density is singular, ln phi changes little
//! over it, and no breakpoint lies within.

use super::HeightDistribution;
use crate::numerics::elementary::pow;
use crate::numerics::quadrature::{self, POINTS};
use crate::numerics::root;

/// The largest length times the change of the slope of ln phi over either half, that of 3.5 sigma of a Gaussian density: over
/// more, 16 points do not resolve its parabola.
const MOST_DENSITY_BEND: f64 = 9.0;
/// The largest length times the slope of ln phi at either end: over more, 16 points do not resolve an exponential function.
const MOST_DENSITY_E_FOLDS: f64 = 18.0;
/// The largest length over the distance to a singularity, for which the error of 16 points is some 1e-12.
const OVER_DISTANCE: f64 = 1.8;
/// No panel is shorter, in sigma: what lies within it of a singularity is negligible.
pub const SHORTEST_PANEL: f64 = 1e-8;
/// What is nearer to a breakpoint, or to where a stretch ends, than this, relative to 1 or to its height, counts as at it.
const AT_BREAKPOINT: f64 = 4e-15;
/// Densities below exp(-MOST_LOG_FALL) of the largest are left out of sums.
const MOST_LOG_FALL: f64 = 31.0;
/// Densities below exp of this are no numbers.
const SMALLEST_LOG_DENSITY: f64 = -700.0;
/// The upper tail is summed by panels of one length as far as ln phi falls by this: the steeper rest is hardly ever summed.
const TAIL: f64 = 20.0;
/// It begins so far above the mode, in sigma.
const TAIL_BEGINS: f64 = 0.5;
/// The first panel above a lower end where the density is a power, in sigma and in lengths over which what is summed is smooth: both
/// are power series in the height above the end over so small a part.
const LOWER_END: f64 = 0.1;
/// No sum needs as many panels; it bounds the time of a call. A sum that does is no number.
pub const MOST_PANELS_OF_SUM: usize = 6000;

/// How far above z one panel of 16 Gauss points may reach, never past the next breakpoint.
pub fn panel_length(heights: &dyn HeightDistribution, z: f64) -> f64 {
    let length = next_breakpoint(heights, z) - z;
    match heights.outline().is_piecewise_polynomial
        || length < f64::INFINITY && is_smooth(heights, z, smoothness(heights, z), z + length, 1.0)
    {
        true => length,
        false => length.min(smooth_length(heights, z)),
    }
}

/// The panels from one height up to another, by their ends.
pub fn panels(heights: &dyn HeightDistribution, from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
    let mut z = from;
    let next = move || {
        (z < to).then(|| {
            let start = z;
            z = (z + panel_length(heights, z)).min(to);
            (start, z)
        })
    };
    std::iter::from_fn(next).take(MOST_PANELS_OF_SUM)
}

/// Whether one panel may reach from one height to another, if panels may be longer by a factor.
pub fn is_one_panel(heights: &dyn HeightDistribution, from: f64, to: f64, longer: f64) -> bool {
    if to > next_breakpoint(heights, from) + slack(to) {
        return false;
    }
    heights.outline().is_piecewise_polynomial
        || to - from <= SHORTEST_PANEL
        || is_smooth(heights, from, smoothness(heights, from), to, longer)
}

/// Below this height, what is left of the density is less than exp(-41) of its largest value: sums begin there. It is the
/// lower end of the support where the density is a power or a polynomial that begins there.
pub fn lower_cut(heights: &dyn HeightDistribution) -> f64 {
    lower_cut_at(heights, MOST_LOG_FALL)
}

fn lower_cut_at(heights: &dyn HeightDistribution, fall: f64) -> f64 {
    let (lowest, _) = heights.outline().support;
    if heights.outline().is_piecewise_polynomial {
        return lowest;
    }
    let mode = heights.outline().last_mode;
    let cut = root::beyond(log_density_above(heights, fall), mode, -1.0, lowest);
    match heights.outline().power_at_lower_end {
        Some(_) if cut < lowest + LOWER_END => lowest,
        _ => cut,
    }
}

/// Above this height the density is no number.
pub fn upper_cut(heights: &dyn HeightDistribution) -> f64 {
    let ((_, highest), mode) = (heights.outline().support, heights.outline().last_mode);
    if highest.is_finite() {
        return highest;
    }
    let above = |z: f64| (heights.log_density(z) - SMALLEST_LOG_DENSITY).max(-1e3);
    root::beyond(above, mode, 1.0, highest)
}

/// A panel length that serves the upper tail, from half a sigma above the mode to where ln phi is 20 below its largest
/// value, wherever it lies. It is as short as the steepest part needs: next to the upper end of a support very short.
pub fn tail_panel_length(heights: &dyn HeightDistribution) -> f64 {
    let (lowest, highest) = heights.outline().support;
    if heights.outline().is_piecewise_polynomial {
        return highest - lowest;
    }
    let mode = heights.outline().last_mode;
    let top = root::beyond(log_density_above(heights, TAIL), mode, 1.0, highest);
    let (mut z, mut shortest) = (top.min(mode + TAIL_BEGINS), smooth_length(heights, top));
    while z < top {
        let length = smooth_length(heights, z);
        shortest = shortest.min(length);
        z += 0.5 * length;
    }
    shortest
}

/// ln phi over that so far below its largest value.
fn log_density_above(heights: &dyn HeightDistribution, fall: f64) -> impl Fn(f64) -> f64 + '_ {
    let least = heights.log_density(heights.outline().last_mode) - fall;
    // Finite where the density is 0.
    move |z| (heights.log_density(z) - least).max(-1e3)
}

/// The first panel above a lower end where the density is a power, in the variable v of z = lower end + length v^power.
///
/// With it phi dz ~ v^(power (p + 1) - 1) is at least v^8, and what is a power series in z - lower end stays one.
#[derive(Debug, Clone, Copy)]
pub struct LowerEndPanel {
    /// Its length in z.
    pub length: f64,
    lower_end: f64,
    power: f64,
}

impl LowerEndPanel {
    /// The panel of these heights where a range of some length begins, over which what is summed is smooth as far as `smooth`;
    /// `None` unless that is a lower end at which the density is a power.
    pub fn new(heights: &dyn HeightDistribution, from: f64, range: f64, smooth: f64) -> Option<Self> {
        let (lower_end, exponent) = (heights.outline().support.0, heights.outline().power_at_lower_end?);
        let panel = Self {
            length: range.min(LOWER_END * smooth.min(1.0)),
            lower_end,
            power: (9.0 / (exponent + 1.0)).max(1.0),
        };
        (from <= lower_end).then_some(panel)
    }

    /// The same panel, ending at another height above the lower end.
    pub fn shortened(self, length: f64) -> Self {
        Self { length, ..self }
    }

    /// Its nodes: heights above the lower end, with the fraction of all summits that each stands for.
    pub fn nodes(&self, heights: &dyn HeightDistribution) -> [(f64, f64); POINTS] {
        let nodes = quadrature::panel(0.0, 1.0);
        let rises = nodes.map(|(v, _)| self.length * pow(v, self.power));
        let densities = heights.densities(rises.map(|rise| self.lower_end + rise));
        std::array::from_fn(|i| {
            let (v, weight) = nodes[i];
            (rises[i], weight * (self.power * rises[i] / v) * densities[i])
        })
    }
}

/// How far above z one panel may reach, breakpoints apart.
pub fn smooth_length(heights: &dyn HeightDistribution, z: f64) -> f64 {
    if heights.outline().is_piecewise_polynomial {
        return f64::INFINITY;
    }
    let begin @ [distance, slope] = smoothness(heights, z);
    // Far from the mode densities change over lengths like the distance from there.
    let far = (z - heights.outline().last_mode).abs().max(4.0);
    let longest = far.min(OVER_DISTANCE * distance).min(MOST_DENSITY_E_FOLDS / slope.abs());
    let mut length = longest.max(SHORTEST_PANEL);
    while length > SHORTEST_PANEL && !is_smooth(heights, z, begin, z + length, 1.0) {
        length *= 0.75;
    }
    length
}

/// How far a height is from where the density is singular, and the slope of ln phi there.
fn smoothness(heights: &dyn HeightDistribution, z: f64) -> [f64; 2] {
    [heights.distance_to_singularity(z), heights.log_density_slope(z)]
}

fn is_smooth(heights: &dyn HeightDistribution, from: f64, begin: [f64; 2], to: f64, longer: f64) -> bool {
    let length = (to - from) / (longer * heights.outline().part_of_panel);
    let is_gentle = |&[distance, slope]: &[f64; 2]| {
        length <= OVER_DISTANCE * distance && length * slope.abs() <= MOST_DENSITY_E_FOLDS
    };
    let is_straight = |from: [f64; 2], to: [f64; 2]| length * (to[1] - from[1]).abs() <= MOST_DENSITY_BEND;
    let gentle = |z: f64| Some(smoothness(heights, z)).filter(is_gentle);
    let ends = || {
        let end = is_gentle(&begin).then(|| gentle(to))??;
        let middle = gentle(0.5 * (from + to))?;
        Some((middle, end))
    };
    // A slope that only falls changes over either half by no more than over both.
    ends().is_some_and(|(middle, end)| {
        heights.outline().is_log_concave && is_straight(begin, end)
            || is_straight(begin, middle) && is_straight(middle, end)
    })
}

/// The next height at which the density or a derivative of it jumps.
pub fn next_breakpoint(heights: &dyn HeightDistribution, z: f64) -> f64 {
    let breakpoints = heights.breakpoints();
    let z = z + slack(z);
    breakpoints.get(breakpoints.partition_point(|&point| point <= z)).copied().unwrap_or(f64::INFINITY)
}

/// How near to a height what lies beside it counts as at it.
pub fn slack(z: f64) -> f64 {
    AT_BREAKPOINT * (1.0 + z.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::distribution::tests::families;
    use crate::numerics::elementary::exp;
    use crate::numerics::quadrature::nodes;

    /// The integrals of the density times powers of the height above the mean, by panels; and how many panels.
    fn moments(heights: &dyn HeightDistribution) -> ([f64; 5], usize) {
        let (mut moments, mut count) = ([0.0; 5], 0);
        let mut add = |z: f64, fraction: f64| {
            let mut term = fraction;
            for moment in &mut moments {
                *moment += term;
                term *= z + heights.outline().origin;
            }
        };
        let (_, highest) = heights.outline().support;
        // The fourth moment needs more of a heavy tail than other sums.
        let is_left = log_density_above(heights, 3.0 * MOST_LOG_FALL);
        let mut z = lower_cut_at(heights, 3.0 * MOST_LOG_FALL);
        if let Some(lower_end) = LowerEndPanel::new(heights, z, f64::MAX, f64::MAX) {
            lower_end.nodes(heights).into_iter().for_each(|(rise, fraction)| add(z + rise, fraction));
            z += lower_end.length;
            count += 1;
        }
        let counts = |&(z, _): &(f64, f64)| z < heights.outline().last_mode || is_left(z) > 0.0;
        for (from, to) in panels(heights, z, highest).take_while(counts) {
            nodes(from, to).for_each(|(x, weight)| add(x, weight * exp(heights.log_density(x))));
            count += 1;
        }
        (moments, count)
    }

    /// Down to exp(-123) of the largest density.
    #[test]
    fn panels_give_the_moments_of_heights() {
        for heights in families() {
            let (found, count) = moments(&*heights);
            for (power, expected) in
                [1.0, 0.0, 1.0, heights.outline().skew, heights.outline().kurtosis].into_iter().enumerate()
            {
                let error = (found[power] - expected) / expected.abs().max(1.0);
                assert!(error.abs() < 1e-11, "moment {power}: {error:e} in {count} panels of {heights:?}");
            }
        }
    }
}
