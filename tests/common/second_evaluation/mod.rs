//! The sums over the surface a second time, by another formulation and another quadrature: nothing of `src/` is used.
//!
//! Lengths of contact are in L = (beta g/(alpha b/h))^(1/2) b, overlaps in h, so that one summit depends on one number,
//! kappa = 4 gamma (b/h)^2 L/b. Each summit is solved for by bracketed Newton in ln(theta). The integrals over height are
//! tanh-sinh (Takahasi and Mori 1974) on pieces that are halved until two levels agree. Checked against the 80-bit rows
//! of `reference/` by the test that uses it.

pub mod heights;
mod quadrature;
pub mod scores;

use heights::Heights;
use quadrature::{integrate, Values, COMPONENTS};
use std::f64::consts::{FRAC_PI_2, PI};

/// The model in dimensionless groups, with its slip law.
#[derive(Debug, Clone)]
pub struct Surface {
    pub alpha: f64,
    pub beta: f64,
    pub gamma: f64,
    pub b_over_h: f64,
    pub heights: Heights,
    pub epsilon: f64,
    pub rho: f64,
    pub attraction: bool,
    /// a_1/b, tau_1/G*, a_2/b, tau_2/G*.
    pub slip: [f64; 4],
    /// The pressure coefficient, times E*/G*.
    pub pressure: f64,
}

/// Sums per summit: loads in E* b^2, friction in G* b^2, area in b^2, all to be multiplied by exp(`log_scale`).
#[derive(Debug, Clone, Copy)]
pub struct Sums {
    pub log_scale: f64,
    pub contacting: f64,
    pub attracted: f64,
    pub area: f64,
    pub friction: f64,
    pub load_contacting: f64,
    pub load_attracted: f64,
    /// The sum of the magnitudes of all loads.
    pub load_absolute: f64,
    /// Whether every integral met its tolerance.
    pub converged: bool,
}

impl Sums {
    /// The load of all summits, not scaled.
    pub fn load(&self) -> f64 {
        self.log_scale.exp() * (self.load_contacting + self.load_attracted)
    }
}

/// x sin x + cos x - 1 and sin x - x cos x, by series where they cancel.
fn first_bracket(x: f64) -> f64 {
    if x > 1.0 {
        return x * x.sin() + x.cos() - 1.0;
    }
    // sum of (-1)^(k+1) (2k-1)/(2k)! x^2k
    let (mut sum, mut power, mut factorial) = (0.0, 1.0, 1.0);
    for k in 1..12 {
        let n = 2.0 * f64::from(k);
        power *= -x * x;
        factorial *= n * (n - 1.0);
        sum -= (n - 1.0) * power / factorial;
    }
    sum
}

fn sine_less_cosine(x: f64) -> f64 {
    if x > 1.0 {
        return x.sin() - x * x.cos();
    }
    // sum of (-1)^(k+1) 2k/(2k+1)! x^(2k+1)
    let (mut sum, mut power, mut factorial) = (0.0, x, 1.0);
    for k in 1..12 {
        let n = 2.0 * f64::from(k);
        power *= -x * x;
        factorial *= n * (n + 1.0);
        sum -= n * power / factorial;
    }
    sum
}

/// One summit at theta: c/L, w = u/h, dw/dtheta.
#[derive(Clone, Copy)]
struct Ring {
    theta: f64,
    c: f64,
    w: f64,
    w_rate: f64,
}

fn ring(theta: f64, kappa: f64) -> Ring {
    let (s, q) = theta.sin_cos();
    let f2 = 0.5 * sine_less_cosine(2.0 * theta) / PI;
    let f1 = kappa * first_bracket(theta) / PI;
    let c = 2.0 / (f1 + (f1 * f1 + 4.0 * f2).sqrt());
    // f2 c^2 + f1 c = 1; df2/dtheta = 2 theta sin(2 theta)/pi, df1/dtheta = kappa theta cos(theta)/pi
    let c_rate = -c * (4.0 * theta * s * q * c + kappa * theta * q) / (PI * (2.0 * f2 * c + f1));
    let w = c * c * q * q - 0.5 * kappa * c * s;
    let w_rate = 2.0 * c * q * (c_rate * q - c * s) - 0.5 * kappa * (c_rate * s + c * q);
    Ring { theta, c, w, w_rate }
}

/// Where unloading ends: theta = pi/2, or the first minimum of w before it.
fn break_away(kappa: f64) -> Ring {
    // Near pi/2 the rate is -n cos(theta): n < 0 there means that w rises already.
    let before = |theta: f64| ring(theta, kappa).w_rate / theta.cos();
    let mut upper = FRAC_PI_2 - 1e-5;
    if before(upper) <= 0.0 {
        return ring(FRAC_PI_2, kappa);
    }
    let mut lower = 0.5 * upper;
    while before(lower) > 0.0 && lower > 1e-9 {
        (upper, lower) = (lower, 0.5 * lower);
    }
    for _ in 0..60 {
        let middle = 0.5 * (lower + upper);
        if before(middle) > 0.0 {
            upper = middle;
        } else {
            lower = middle;
        }
    }
    ring(0.5 * (lower + upper), kappa)
}

/// The summit on the unloading branch with this w, at least that at break-away.
fn at_overlap(w: f64, kappa: f64, end: Ring) -> Ring {
    if w <= end.w {
        return end;
    }
    let heavy = w.max(1e-30);
    let guess = (0.75 * PI / heavy).cbrt().min((2.0 * PI / (kappa.max(1e-100) * heavy.sqrt())).sqrt());
    let mut here = ring(guess.min(0.7 * end.theta), kappa);
    let (mut lower, mut upper) = (0.0, end.theta);
    for _ in 0..200 {
        if here.w > w && here.w_rate < 0.0 {
            lower = here.theta;
        } else {
            upper = here.theta;
        }
        // Newton in ln(theta).
        let step = -(here.w - w) / (here.w_rate * here.theta);
        let newton = here.theta * step.clamp(-1.0, 1.0).exp();
        let inside = here.w_rate < 0.0 && newton > lower && newton < upper;
        let next = match inside {
            true => newton,
            false if lower > 0.0 => 0.5 * (lower + upper),
            false => 0.5 * upper,
        };
        let change = (next - here.theta).abs();
        here = ring(next, kappa);
        if change <= 1e-14 * next || upper - lower <= 1e-16 * upper {
            break;
        }
    }
    here
}

impl Surface {
    /// alpha, beta, gamma and b/h; heights; epsilon and rho; with the slip law of the paper, and attraction.
    pub fn new([alpha, beta, gamma, b_over_h]: [f64; 4], heights: Heights, [epsilon, rho]: [f64; 2]) -> Self {
        let slip = [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0];
        Self { alpha, beta, gamma, b_over_h, heights, epsilon, rho, attraction: true, slip, pressure: 0.0 }
    }

    /// Whether radii vary with height.
    fn has_radii(&self) -> bool {
        self.epsilon != 0.0 || matches!(self.heights, Heights::Scores(_))
    }

    /// h/sigma.
    fn reach(&self) -> f64 {
        1.0 / (self.alpha * self.beta * self.b_over_h)
    }

    /// g(z), without cancellation where it goes to 0.
    fn radius_factor(&self, z: f64) -> f64 {
        let (z, factor) = match &self.heights {
            Heights::Scores(scores) => scores.radius(z),
            _ => (z, 1.0),
        };
        let decay = (-2.0 * self.rho * z.abs()).exp();
        let size = if z >= 0.0 { self.epsilon } else { -self.epsilon };
        (factor * ((1.0 + size) + (1.0 - size) * decay) / (1.0 + decay)).max(1e-60)
    }

    /// L/b and kappa at a height.
    fn scale(&self, z: f64) -> (f64, f64) {
        let length = (self.beta / (self.alpha * self.b_over_h) * self.radius_factor(z)).sqrt();
        (length, 4.0 * self.gamma * self.b_over_h * self.b_over_h * length)
    }

    fn friction(&self, a: f64) -> f64 {
        let [a1, tau1, a2, tau2] = self.slip;
        let exponent = (tau2 / tau1).ln() / (a2 / a1).ln();
        let stress = if a <= a1 {
            tau1
        } else if a >= a2 {
            tau2
        } else {
            tau1 * (exponent * (a / a1).ln()).exp()
        };
        PI * a * a * stress
    }

    /// z - d - u_break: positive where a summit is in contact.
    fn depth(&self, z: f64, separation: f64) -> f64 {
        z - separation - self.reach() * break_away(self.scale(z).1).w
    }

    /// The least d(z - u_break)/dz among heights that any summit has: below 0 taller summits part before lower ones.
    pub fn least_break_away_rate(&self) -> f64 {
        const STEPS: i32 = 4000;
        const SMALLEST_LOG_DENSITY: f64 = -700.0;
        let least = |from: f64, to: f64| {
            let step = (to - from) / f64::from(STEPS);
            (0..STEPS)
                .map(|i| from + f64::from(i) * step)
                .filter(|&z| self.heights.log_density(z) > SMALLEST_LOG_DENSITY)
                .map(|z| (self.depth(z + step, 0.0) - self.depth(z, 0.0)) / step)
                .fold(1.0, f64::min)
        };
        // tanh is level beyond.
        let reach = 10.0 / self.rho;
        match &self.heights {
            // There it is one of the score.
            Heights::Scores(scores) => least(scores.beyond(-14.0), scores.beyond(14.0))
                .min(least(scores.height_of(-reach), scores.height_of(reach))),
            _ => least(-reach, reach),
        }
    }

    /// What a summit of a height adds, without the density.
    fn summit(&self, z: f64, separation: f64, contact: bool) -> Values {
        let (length, kappa) = self.scale(z);
        let w = (z - separation) / self.reach();
        if contact {
            let here = at_overlap(w, kappa, break_away(kappa));
            let (s, q) = here.theta.sin_cos();
            let (c, a) = (here.c, length * here.c * q);
            let hertz = 4.0 / 3.0 * (c * q).powi(3);
            let load = length / self.b_over_h * (hertz - 0.5 * kappa * c * c * (s * q + here.theta));
            let friction = self.friction(a) + self.pressure * (length / self.b_over_h * hertz);
            [1.0, 0.0, PI * a * a, friction, load, 0.0, load.abs()]
        } else {
            let root = (kappa / PI).hypot((2.0 * (1.0 + w).max(0.0)).sqrt());
            let c = kappa / PI + root;
            let load = -length / self.b_over_h * 0.25 * PI * kappa * c * c;
            [0.0, 1.0, 0.0, 0.0, 0.0, load, -load]
        }
    }

    /// Heights where contact begins or ends at a separation, from low to high.
    fn edges(&self, separation: f64) -> Vec<f64> {
        let reach = self.reach();
        if !self.has_radii() {
            return vec![separation + reach * break_away(self.scale(0.0).1).w];
        }
        // No summit breaks away at a smaller overlap than that of the largest radius.
        let ends = self.heights.cuts();
        let spread = (0..=1000).map(|i| ends[0] + (ends[ends.len() - 1] - ends[0]) * f64::from(i) / 1000.0);
        let largest = match self.heights {
            Heights::Scores(_) => {
                1.05 * spread.chain(ends.iter().copied()).map(|z| self.scale(z).1).fold(0.0, f64::max)
            }
            _ if self.epsilon > 0.0 => self.scale(1e9).1,
            _ => self.scale(-1e9).1,
        };
        let lowest = separation + 1.001 * reach * break_away(largest).w - 1e-9 * (1.0 + separation.abs());
        let highest = separation + 1e-9 * (1.0 + separation.abs());
        let mut points: Vec<f64> = (0..=300).map(|i| lowest + (highest - lowest) * f64::from(i) / 300.0).collect();
        let near = (-120..=120).map(|i| f64::from(i) * 0.05 / self.rho).chain(ends.iter().copied());
        points.extend(near.filter(|z| *z > lowest && *z < highest));
        points.sort_by(f64::total_cmp);
        let mut depths: Vec<(f64, f64)> = points.iter().map(|&z| (z, self.depth(z, separation))).collect();
        // Where the depth turns without changing sign there may be two edges close to each other.
        for _ in 0..2 {
            let mut finer = Vec::new();
            for three in depths.windows(3) {
                let [a, b, c] = [three[0], three[1], three[2]];
                let turns = (b.1 - a.1) * (c.1 - b.1) < 0.0 && a.1 * b.1 > 0.0 && b.1 * c.1 > 0.0;
                if turns && (b.1 < a.1) == (b.1 > 0.0) {
                    finer.extend((1..16).map(|i| a.0 + (c.0 - a.0) * f64::from(i) / 16.0));
                }
            }
            depths.extend(finer.into_iter().map(|z| (z, self.depth(z, separation))));
            depths.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        let mut edges = Vec::new();
        for pair in depths.windows(2) {
            if (pair[0].1 > 0.0) != (pair[1].1 > 0.0) {
                let positive = pair[0].1 > 0.0;
                edges.push(bisect(pair[0].0, pair[1].0, |z| (self.depth(z, separation) > 0.0) == positive));
            }
        }
        edges
    }

    /// Heights between two at which the contact radius is one of the slip law's.
    fn kinks(&self, separation: f64, lower: f64, upper: f64) -> Vec<f64> {
        let radius = |z: f64| {
            let (length, kappa) = self.scale(z);
            let here = at_overlap((z - separation) / self.reach(), kappa, break_away(kappa));
            length * here.c * here.theta.cos()
        };
        let points: Vec<(f64, f64)> =
            (0..=24).map(|i| lower + (upper - lower) * (f64::from(i) / 24.0).powi(2)).map(|z| (z, radius(z))).collect();
        let mut kinks = Vec::new();
        for pair in points.windows(2) {
            for kink in [self.slip[0], self.slip[2]] {
                if (pair[0].1 < kink) != (pair[1].1 < kink) {
                    let below = pair[0].1 < kink;
                    kinks.push(bisect(pair[0].0, pair[1].0, |z| (radius(z) < kink) == below));
                }
            }
        }
        kinks
    }

    /// The sums at a separation in sigma.
    pub fn at_separation(&self, separation: f64) -> Sums {
        let attracts = self.attraction && self.gamma > 0.0;
        let edges = self.edges(separation);
        let begin = separation - self.reach();
        let below_all = edges.first().copied().unwrap_or(separation) - 1.0;
        let starts_in_contact = self.depth(self.heights.foot().max(below_all - 60.0), separation) > 0.0;
        let lowest = if starts_in_contact {
            f64::NEG_INFINITY
        } else {
            let first = edges.first().copied().unwrap_or(f64::INFINITY);
            if attracts {
                first.min(begin)
            } else {
                first
            }
        };
        let (lower, upper, log_scale) = self.heights.range(lowest);
        let mut cuts = vec![lower, upper];
        let inside = |z: &f64| *z > lower && *z < upper;
        cuts.extend(edges.iter().copied().chain([begin, 0.0]).chain(self.heights.cuts()).filter(inside));
        if self.has_radii() {
            cuts.extend([-3.0, -0.7, 0.7, 3.0].map(|x| x / self.rho).into_iter().filter(inside));
        }
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let mut pieces = Vec::new();
        for pair in cuts.windows(2) {
            let middle = 0.5 * (pair[0] + pair[1]);
            if self.depth(middle, separation) > 0.0 {
                let mut ends = vec![pair[0], pair[1]];
                ends.extend(self.kinks(separation, pair[0], pair[1]));
                ends.sort_by(f64::total_cmp);
                pieces.extend(ends.windows(2).map(|ends| (ends[0], ends[1], true)));
            } else if attracts && middle > begin {
                pieces.push((pair[0], pair[1], false));
            }
        }
        let (values, converged) = integrate(&pieces, |z, contact| {
            let density = (self.heights.log_density(z) - log_scale).exp();
            if density == 0.0 {
                return [0.0; COMPONENTS];
            }
            self.summit(z, separation, contact).map(|value| value * density)
        });
        let [contacting, attracted, area, friction, load_contacting, load_attracted, load_absolute] = values;
        Sums {
            log_scale,
            contacting,
            attracted,
            area,
            friction,
            load_contacting,
            load_attracted,
            load_absolute,
            converged,
        }
    }
}

/// Where a property that holds at one end ceases to, towards the other.
fn bisect(mut holds: f64, mut fails: f64, property: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..80 {
        let middle = 0.5 * (holds + fails);
        if property(middle) {
            holds = middle;
        } else {
            fails = middle;
        }
    }
    0.5 * (holds + fails)
}
