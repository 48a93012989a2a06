//! Sobol's sequence with the direction numbers of Joe and Kuo (SIAM J. Sci. Comput. 30, 2008, 2635-2654), which fills a
//! box evenly: any 2^k consecutive points that start at a multiple of 2^k have one in each 2^k-th of every axis.

/// Degree, coefficients and initial numbers of the primitive polynomials of dimensions 2 to 10.
const POLYNOMIALS: [(u32, u32, &[u32]); 9] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
];

pub struct Sobol {
    directions: Vec<[u32; 32]>,
    state: Vec<u32>,
    count: u32,
}

impl Sobol {
    /// In up to ten dimensions.
    pub fn new(dimensions: usize) -> Self {
        let mut directions = vec![std::array::from_fn(|i| 1 << (31 - i))];
        for &(degree, coefficients, initial) in POLYNOMIALS.iter().take(dimensions - 1) {
            let s = degree as usize;
            let mut v = [0_u32; 32];
            for i in 0..32 {
                v[i] = if i < s {
                    initial[i] << (31 - i)
                } else {
                    let mut next = v[i - s] ^ (v[i - s] >> s);
                    for k in 1..s {
                        if coefficients >> (s - 1 - k) & 1 == 1 {
                            next ^= v[i - k];
                        }
                    }
                    next
                };
            }
            directions.push(v);
        }
        Self { state: vec![0; directions.len()], directions, count: 0 }
    }

    /// The next point of [0, 1)^n, by Antonov and Saleev's Gray code, each number in the middle of its cell of 2^-32.
    pub fn next_point(&mut self) -> Vec<f64> {
        let point = self.state.iter().map(|&x| (f64::from(x) + 0.5) / 4_294_967_296.0).collect();
        let bit = self.count.trailing_ones() as usize;
        for (state, directions) in self.state.iter_mut().zip(&self.directions) {
            *state ^= directions[bit];
        }
        self.count += 1;
        point
    }
}
