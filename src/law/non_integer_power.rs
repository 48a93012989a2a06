//! Where a panel of the curve begins or ends at a non-integer power of the distance: its nodes lie in the fourth root of that
//! distance, in which the power is a high one and polynomials converge.

/// What is nearer, as a part of the panel, is taken to be that near: slopes have no digits there.
const NEAREST: f64 = 1e-12;

/// The end of a panel at which the curve is a non-integer power of the distance. s falls from the beginning to the end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NonIntegerPower {
    Nowhere,
    AtBegin,
    AtEnd,
}

impl NonIntegerPower {
    /// Where s lies among the nodes of a panel from `highest` to `lowest`, and d(that)/ds.
    pub fn place(self, (lowest, highest): (f64, f64), s: f64) -> (f64, f64) {
        let (distance, sign) = match self {
            Self::Nowhere => return (s, 1.0),
            Self::AtBegin => (highest - s, -1.0),
            Self::AtEnd => (s - lowest, 1.0),
        };
        let distance = distance.max(NEAREST * (highest - lowest));
        let root = distance.sqrt().sqrt();
        (root, 0.25 * sign * root / distance)
    }

    /// The s of a place.
    pub fn s_at(self, (lowest, highest): (f64, f64), place: f64) -> f64 {
        match self {
            Self::Nowhere => place,
            Self::AtBegin => highest - fourth_power(place),
            Self::AtEnd => lowest + fourth_power(place),
        }
    }

    /// Whether s is that end of the panel.
    pub fn is_at(self, (lowest, highest): (f64, f64), s: f64) -> bool {
        match self {
            Self::Nowhere => false,
            Self::AtBegin => s == highest,
            Self::AtEnd => s == lowest,
        }
    }

    /// The part of a panel, from -1 to 1, at the same part of the root.
    pub fn part(self, part: f64) -> f64 {
        match self {
            Self::Nowhere => part,
            Self::AtBegin => 2.0 * fourth_power(0.5 + 0.5 * part) - 1.0,
            Self::AtEnd => 1.0 - 2.0 * fourth_power(0.5 - 0.5 * part),
        }
    }
}

fn fourth_power(x: f64) -> f64 {
    let square = x * x;
    square * square
}

#[cfg(test)]
mod tests {
    use super::*;

    const RANGE: (f64, f64) = (2.0, 2.5);

    #[test]
    fn places_are_fourth_roots_of_the_distance_and_have_its_slopes() {
        for (non_integer_power, distance) in
            [(NonIntegerPower::AtBegin, |s: f64| RANGE.1 - s), (NonIntegerPower::AtEnd, |s: f64| s - RANGE.0)]
                as [(NonIntegerPower, fn(f64) -> f64); 2]
        {
            for s in [2.001, 2.1, 2.4, 2.499] {
                let (place, slope) = non_integer_power.place(RANGE, s);
                assert!((place - distance(s).powf(0.25)).abs() < 1e-15, "{place}");
                let step = 1e-6;
                let difference =
                    non_integer_power.place(RANGE, s + step).0 - non_integer_power.place(RANGE, s - step).0;
                assert!((slope - difference / (2.0 * step)).abs() < 1e-5 * slope.abs(), "{slope} at {s}");
                assert!((non_integer_power.s_at(RANGE, place) - s).abs() < 1e-15);
                assert!(!non_integer_power.is_at(RANGE, s));
            }
            let end = if non_integer_power == NonIntegerPower::AtBegin { RANGE.1 } else { RANGE.0 };
            let (place, slope) = non_integer_power.place(RANGE, end);
            assert!(non_integer_power.is_at(RANGE, end) && place > 0.0 && slope.is_finite());
        }
        assert_eq!(NonIntegerPower::Nowhere.place(RANGE, 2.2), (2.2, 1.0));
        assert_eq!(NonIntegerPower::Nowhere.s_at(RANGE, 2.2), 2.2);
        assert!(!NonIntegerPower::Nowhere.is_at(RANGE, RANGE.0));
    }

    #[test]
    fn parts_are_dense_next_to_the_non_integer_power() {
        for (non_integer_power, parts) in [
            (NonIntegerPower::Nowhere, [-1.0, 0.0, 1.0]),
            (NonIntegerPower::AtBegin, [-1.0, -0.875, 1.0]),
            (NonIntegerPower::AtEnd, [-1.0, 0.875, 1.0]),
        ] {
            assert_eq!([-1.0, 0.0, 1.0].map(|part| non_integer_power.part(part)), parts);
        }
    }
}
