//! Tanh-sinh quadrature of several functions at once: the piece with the largest error is halved, again and again.

use std::f64::consts::PI;

/// Functions that are integrated together.
pub const COMPONENTS: usize = 7;
pub type Values = [f64; COMPONENTS];

/// Two levels of each piece agree; the sum of what they differ by, relative to the sum of all, is brought below this.
const WANTED: f64 = 1e-10;
/// And is good enough below this: the finer level is better than its difference from the coarser.
const ENOUGH: f64 = 2e-9;
/// Halvings of one integral.
const MOST: usize = 600;
/// The step of the finer level.
const STEP: f64 = 0.0625;

struct Piece {
    from: f64,
    to: f64,
    kind: bool,
    value: Values,
    /// By how much the two levels differ.
    difference: Values,
}

impl Piece {
    fn new(from: f64, to: f64, kind: bool, f: &impl Fn(f64, bool) -> Values) -> Self {
        let coarse = level(from, to, 2.0 * STEP, 0, |z| f(z, kind));
        let between = level(from, to, 2.0 * STEP, 1, |z| f(z, kind));
        let value: Values = std::array::from_fn(|i| 0.5 * (coarse[i] + between[i]));
        let difference = std::array::from_fn(|i| (value[i] - coarse[i]).abs());
        Self { from, to, kind, value, difference }
    }

    /// The largest difference relative to the scale.
    fn error(&self, scale: &Values) -> f64 {
        let relative = |(difference, scale): (&f64, &f64)| if *scale > 0.0 { difference / scale } else { 0.0 };
        self.difference.iter().zip(scale).map(relative).fold(0.0, |worst, x| if x <= worst { worst } else { x })
    }
}

/// The integral over pieces, whose kind the integrand is told, and whether it met the tolerance.
pub fn integrate(pieces: &[(f64, f64, bool)], f: impl Fn(f64, bool) -> Values) -> (Values, bool) {
    let mut pieces: Vec<Piece> = pieces.iter().map(|&(from, to, kind)| Piece::new(from, to, kind, &f)).collect();
    let sum = |pieces: &[Piece], of: fn(f64) -> f64| -> Values {
        std::array::from_fn(|i| pieces.iter().map(|piece| of(piece.value[i])).sum())
    };
    let mut error = f64::INFINITY;
    for _ in 0..MOST {
        let scale = sum(&pieces, f64::abs);
        let errors: Vec<f64> = pieces.iter().map(|piece| piece.error(&scale)).collect();
        error = errors.iter().sum();
        let worst = (0..pieces.len()).max_by(|&i, &j| errors[i].total_cmp(&errors[j]));
        let Some(worst) = worst.filter(|_| error > WANTED) else { break };
        let Piece { from, to, kind, .. } = pieces[worst];
        let middle = 0.5 * (from + to);
        if middle <= from || middle >= to {
            break;
        }
        pieces[worst] = Piece::new(from, middle, kind, &f);
        pieces.push(Piece::new(middle, to, kind, &f));
    }
    (sum(&pieces, |x| x), error <= ENOUGH || pieces.is_empty())
}

/// The trapezium sum with a step in t, where z = a + (b - a)/(1 + exp(-pi sinh t)); `offset` 1 shifts it by half a step.
fn level(a: f64, b: f64, step: f64, offset: i32, f: impl Fn(f64) -> Values) -> Values {
    const END: f64 = 3.25;
    let mut sum = [0.0; COMPONENTS];
    let count = (END / step).ceil() as i32;
    for i in -count..=count {
        let t = (f64::from(i) + 0.5 * f64::from(offset)) * step;
        if t.abs() > END {
            continue;
        }
        let decay = (-PI * t.abs().sinh()).exp();
        let near = decay / (1.0 + decay);
        let z = if t < 0.0 { a + (b - a) * near } else { b - (b - a) * near };
        let weight = step * (b - a) * PI * t.cosh() * near / (1.0 + decay);
        if z <= a || z >= b {
            continue;
        }
        for (sum, x) in sum.iter_mut().zip(f(z)) {
            *sum += weight * x;
        }
    }
    sum
}
