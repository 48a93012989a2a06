//! A contact whose load changes against an exact one: springs side by side, each of which touches at a separation of its own,
//! sticks and slips by Coulomb's law (V. L. Popov and M. Hess, Method of Dimensionality Reduction, 2015; J. Jaeger, Arch. Appl.
//! Mech. 65 (1995) 478; M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349). It is the surface itself where friction is
//! Amontons', contacts are elastic and nothing adheres. It shares with the library's step the load and the stiffness against
//! separation, and nothing else.

use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{dimensionless, johnson, model, table};
use crate::microslip::assert_told;
use asperity::{Model, Params, SlipConstants, MICROSLIP_LENGTH};

const FRICTION: f64 = 0.3;
const SPRINGS: usize = 2000;

/// Elastic summits with friction in proportion to load: heights of several families, equal radii and others, one sphere.
fn surfaces() -> Vec<Params> {
    let slip = SlipConstants { stress_1: 0.0, stress_2: 0.0, ..SlipConstants::default() };
    let amontons = Params { slip, pressure_coefficient: FRICTION, ..dimensionless(0.01, 1000.0, 0.0, 1.0) };
    let humps = table(&[-2.0, -1.0, 0.3, 1.0, 3.0], &[0.0, 0.4, 0.3, 0.5, 0.0]);
    vec![
        amontons.clone(),
        Params { heights: johnson(-0.6, 3.5), ..amontons.clone() },
        Params { heights: humps, ..amontons.clone() },
        Params { radius_amplitude: -0.9, radius_rate: 0.9, ..amontons },
    ]
}

/// Load and stiffness against separation, between two separations.
struct Curve {
    top: f64,
    step: f64,
    load: Vec<f64>,
    stiffness: Vec<f64>,
}

impl Curve {
    fn new(model: &Model, top: f64, bottom: f64) -> Self {
        let step = (top - bottom) / SPRINGS as f64;
        let load: Vec<f64> =
            (0..=SPRINGS).map(|i| model.state_at_gap(top - step * i as f64).expect("a state").load).collect();
        let stiffness = load.iter().map(|&load| model.tangential_stiffness_at_load(load)).collect();
        Self { top, step, load, stiffness }
    }

    fn load_at(&self, separation: f64) -> f64 {
        let place = ((self.top - separation) / self.step).clamp(0.0, SPRINGS as f64 - 1e-9);
        let (i, t) = (place as usize, place.fract());
        self.load[i] + t * (self.load[i + 1] - self.load[i])
    }

    fn separation_of(&self, load: f64) -> f64 {
        let i = self.load.partition_point(|&there| there < load).clamp(1, SPRINGS);
        let t = (load - self.load[i - 1]) / (self.load[i] - self.load[i - 1]);
        self.top - self.step * (i as f64 - 1.0 + t)
    }
}

/// Springs that touch below the separations in the middle between those of the curve.
struct Foundation {
    height: Vec<f64>,
    stiffness: Vec<f64>,
    stretch: Vec<[f64; 2]>,
    separation: f64,
    /// Of a spring, at its limit: displacement by how far below its height the surfaces are.
    slope: f64,
}

impl Foundation {
    fn new(params: &Params, curve: &Curve, separation: f64) -> Self {
        // Mindlin's stiffness is 8 G^ a, Hertz' 2 E* a: 4 G^/E* = 2 G*/(E* + G*) for two bodies of one material.
        let (normal, shear) = (params.composite_modulus, params.effective_shear_modulus);
        let ratio = 2.0 * shear / (normal + shear);
        Self {
            height: (0..SPRINGS).map(|i| curve.top - curve.step * (i as f64 + 0.5)).collect(),
            // The first holds what touches above, too.
            stiffness: (0..SPRINGS)
                .map(|i| curve.stiffness[i + 1] - if i > 0 { curve.stiffness[i] } else { 0.0 })
                .collect(),
            stretch: vec![[0.0; 2]; SPRINGS],
            separation,
            slope: FRICTION / ratio,
        }
    }

    /// Moves along a straight path, in small steps.
    fn step(&mut self, separation: f64, increment: [f64; 2]) -> [f64; 2] {
        const PARTS: u32 = 4;
        let from = self.separation;
        for part in 1..=PARTS {
            self.separation = from + (separation - from) * f64::from(part) / f64::from(PARTS);
            for (height, stretch) in self.height.iter().zip(&mut self.stretch) {
                let limit = (self.slope * (height - self.separation)).max(0.0);
                for axis in 0..2 {
                    stretch[axis] += increment[axis] / f64::from(PARTS);
                }
                let size = stretch[0].hypot(stretch[1]);
                if size > limit {
                    *stretch = stretch.map(|x| x * limit / size);
                }
            }
        }
        let force = |axis: usize| self.stiffness.iter().zip(&self.stretch).map(|(k, u)| k * u[axis]).sum();
        [force(0), force(1)]
    }
}

/// The surface by the library and exactly, side by side.
struct Both<'a> {
    model: &'a Model,
    curve: &'a Curve,
    state: [f64; MICROSLIP_LENGTH],
    exact: Foundation,
    force: [[f64; 2]; 2],
    work: [f64; 2],
    dissipated: f64,
}

impl<'a> Both<'a> {
    fn at_rest(params: &Params, model: &'a Model, curve: &'a Curve, load: f64) -> Self {
        let exact = Foundation::new(params, curve, curve.separation_of(load));
        let mut both = Self {
            model,
            curve,
            state: [0.0; MICROSLIP_LENGTH],
            exact,
            force: [[0.0; 2]; 2],
            work: [0.0; 2],
            dissipated: 0.0,
        };
        both.go(load, [0.0; 2], 1);
        both
    }

    /// Along a path that is straight in separation and displacement.
    fn go(&mut self, load: f64, path: [f64; 2], steps: u32) {
        let (from, to) = (self.exact.separation, self.curve.separation_of(load));
        let increment = path.map(|along| along / f64::from(steps));
        for i in 1..=steps {
            let separation = from + (to - from) * f64::from(i) / f64::from(steps);
            self.step(separation, increment);
        }
    }

    fn step(&mut self, separation: f64, increment: [f64; 2]) {
        let load = self.curve.load_at(separation);
        let found = self.model.microslip_step(load, increment, &mut self.state).expect("a step");
        self.dissipated += found.dissipated;
        for (i, force) in [found.force, self.exact.step(separation, increment)].into_iter().enumerate() {
            self.work[i] += (0..2).map(|axis| 0.5 * (force[axis] + self.force[i][axis]) * increment[axis]).sum::<f64>();
            self.force[i] = force;
        }
    }

    /// How far the force is from the exact one.
    fn error(&self) -> f64 {
        (self.force[0][0] - self.force[1][0]).hypot(self.force[0][1] - self.force[1][1])
    }
}

/// What is checked of each surface, with F and F/K at a middling load.
fn each_surface(mut check: impl FnMut(&str, &Params, &Model, &Curve, f64)) {
    for params in surfaces() {
        let model = model(&params);
        let sigma = params.height_std;
        let touches = |height: f64| model.state_at_gap(height * sigma).is_ok_and(|state| state.load > 0.0);
        let highest = (0..10).map(|i| 3.4 - 0.2 * f64::from(i)).find(|&height| touches(height)).expect("a contact");
        let curve = Curve::new(&model, highest * sigma, -sigma);
        let load = curve.load_at(0.8 * sigma);
        check(&format!("{:?}, epsilon {}", params.heights, params.radius_amplitude), &params, &model, &curve, load);
    }
}

fn length_at(model: &Model, load: f64) -> f64 {
    model.friction_force_at_load(load) / model.tangential_stiffness_at_load(load)
}

#[test]
fn oblique_loading_is_that_of_the_exact_foundation() {
    each_surface(|name, params, model, curve, load| {
        for (path, steps, most) in [(0.3, 200, 4e-3), (1.2, 200, 4e-3), (0.3, 20, 0.012), (1.2, 20, 0.012)] {
            let mut both = Both::at_rest(params, model, curve, 1e-3 * load);
            both.go(load, [path * length_at(model, load), 0.0], steps);
            let error = both.error() / (FRICTION * load);
            assert!(error < most, "{name}: {path} in {steps} steps: {error}");
        }
    });
}

#[test]
fn load_that_falls_takes_its_force_along_and_does_not_bring_it_back() {
    each_surface(|name, params, model, curve, load| {
        for (path, part) in [(0.2, 0.7), (0.6, 0.7), (0.6, 0.2), (0.2, 0.05), (2.0, 0.05)] {
            let mut both = Both::at_rest(params, model, curve, load);
            both.go(load, [path * length_at(model, load), 0.0], 20);
            both.go(part * load, [0.0; 2], 40);
            let down = both.error() / (FRICTION * load);
            both.go(load, [0.0; 2], 40);
            let back = both.error() / (FRICTION * load);
            assert!(down < 0.02 && back < 0.02, "{name}: {path}, {part}: {down}, {back}");
        }
    });
}

#[test]
fn cycles_of_displacement_and_load_take_the_work_that_they_should() {
    each_surface(|name, params, model, curve, load| {
        for (path, part) in [(0.1, 0.3), (0.5, 0.3), (0.5, 0.7), (1.5, 0.1)] {
            let length = length_at(model, load);
            let mut both = Both::at_rest(params, model, curve, load);
            for (load, path) in [(load, path), (part * load, 0.0), (part * load, -path), (load, 0.0)] {
                both.go(load, [path * length, 0.0], 50);
            }
            let unit = 0.5 * model.tangential_stiffness_at_load(load) * (path * length).powi(2);
            let [found, exact] = both.work.map(|work| work / unit);
            assert!((found - exact).abs() < 0.03 && found > 0.0, "{name}: {path}, {part}: {found}, not {exact}");
            // Nothing is held in the end but what the lowest load kept.
            assert!(both.dissipated / unit < found + 0.02, "{name}: told {}", both.dissipated / unit);
        }
    });
}

/// Legs to random loads and displacements in the plane, each straight in separation and displacement.
#[test]
fn forces_on_random_paths_are_as_near_as_the_page_says() {
    for (least, row) in [(0.5, "a half"), (0.1, "a tenth"), (0.02, "a fiftieth"), (1.0 / 280.0, "a 280th")] {
        // In ten steps or more a leg, over the friction force of the present load and of the heaviest; in one step, over the latter.
        let mut most = [0.0_f64; 3];
        each_surface(|_, params, model, curve, load| {
            let mut random = SplitMix(7);
            for steps in [1, 10, 40] {
                for _ in 0..15 {
                    let mut both = Both::at_rest(params, model, curve, load);
                    let length = length_at(model, load);
                    for _ in 0..6 {
                        let now = load * random.log_between(least, 1.0);
                        let by = [0, 1].map(|_| random.between(-2.0, 2.0) * random.log_between(0.01, 1.0) * length);
                        both.go(now, by, steps);
                        let error = both.error() / FRICTION;
                        let whole = if steps == 1 { 2 } else { 1 };
                        most[whole] = most[whole].max(error / load);
                        most[0] = most[0].max(if steps == 1 { 0.0 } else { error / now });
                    }
                }
            }
        });
        assert_told(row, &most);
    }
}

/// Vibration between a load and seven tenths of it, of a contact that is held displaced.
#[test]
fn vibrating_load_does_not_wear_the_force_away() {
    each_surface(|name, params, model, curve, load| {
        let mut both = Both::at_rest(params, model, curve, load);
        both.go(load, [0.5 * length_at(model, load), 0.0], 20);
        both.go(0.7 * load, [0.0; 2], 5);
        for _ in 0..200 {
            both.go(load, [0.0; 2], 2);
            both.go(0.7 * load, [0.0; 2], 2);
        }
        let error = both.error() / (FRICTION * load);
        assert!(error < 0.035, "{name}: {error}");
    });
}

/// A sphere that hits obliquely and leaves: what tangential velocity it keeps, for ratios of its effective masses.
#[test]
fn an_oblique_elastic_impact_returns_the_tangential_energy_that_it_should() {
    each_surface(|name, params, model, curve, load| {
        // So fast that the load rises to about this one, in so many steps.
        let top = curve.top - 0.02 * params.height_std;
        let (deepest, steps) = (curve.separation_of(load), 1500.0);
        let mut energy = 0.0;
        let parts = 2000;
        for i in 0..parts {
            energy += curve.load_at(top + (deepest - top) * f64::from(i) / f64::from(parts)) * (top - deepest)
                / f64::from(parts);
        }
        for (ratio, angle) in [(2.0 / 7.0, 0.2), (2.0 / 7.0, 1.0), (1.0, 0.5), (0.4, 3.0)] {
            let approach = (2.0 * energy).sqrt();
            let time = 3.5 * (top - deepest) / approach / steps;
            let mut both = Both::at_rest(params, model, curve, curve.load_at(top));
            let (mut separation, mut normal) = (top, -approach);
            let slide = angle * FRICTION * approach;
            // Both have the same normal motion, and a tangential one of their own.
            let (mut exact, mut found) = (slide, slide);
            let mut other = Both::at_rest(params, model, curve, curve.load_at(top));
            while separation <= top {
                normal += curve.load_at(separation) * time;
                separation += normal * time;
                let place = separation.min(top);
                both.step(place, [found * time, 0.0]);
                other.step(place, [exact * time, 0.0]);
                found -= both.force[0][0] / ratio * time;
                exact -= other.force[1][0] / ratio * time;
            }
            assert!(
                (found - exact).abs() < 0.05 * slide,
                "{name}: {ratio}, {angle}: {}, not {}",
                found / slide,
                exact / slide
            );
            assert!(found.abs() < slide, "{name}");
        }
    });
}

/// A box on an incline whose load vibrates: where the lightest load holds it, it stays; where it does not, it walks down as far as
/// the exact foundation does in each cycle.
#[test]
fn a_box_on_an_incline_under_vibrating_load_walks_as_the_exact_foundation() {
    const STEPS: u32 = 60;
    const CYCLES: usize = 12;
    each_surface(|name, params, model, curve, load| {
        for (pull, lightest) in [(0.3, 0.6), (0.5, 0.2), (0.5, 0.45), (0.8, 0.7)] {
            let length = length_at(model, load);
            let stiffness = model.tangential_stiffness_at_load(load);
            // Quasi-static: the displacement at which the pull is carried, as far as it can be, with some viscous drag.
            let drag = 0.2 * stiffness;
            let mut both = [0, 1].map(|_| Both::at_rest(params, model, curve, load));
            let mut walked = [Vec::new(), Vec::new()];
            for _ in 0..CYCLES {
                let mut cycle = [0.0; 2];
                for i in 0..STEPS {
                    let phase = std::f64::consts::TAU * f64::from(i + 1) / f64::from(STEPS);
                    let now = load * (0.5 * (1.0 + lightest) + 0.5 * (1.0 - lightest) * phase.cos());
                    let separation = curve.separation_of(now);
                    for which in 0..2 {
                        let missing = pull * FRICTION * load - both[which].force[which][0];
                        let by = missing / (stiffness + drag * f64::from(STEPS) * 0.1);
                        both[which].step(separation, [by, 0.0]);
                        cycle[which] += by / length;
                    }
                }
                walked.iter_mut().zip(cycle).for_each(|(walked, by)| walked.push(by));
            }
            let [last, all] = [|walked: &Vec<f64>| walked[CYCLES - 1], |walked: &Vec<f64>| walked.iter().sum()]
                .map(|of| [of(&walked[0]), of(&walked[1])]);
            let what = format!("{name}: {pull}, {lightest}: {last:?}, {all:?}");
            assert!((last[0] - last[1]).abs() < 0.03 * last[1].abs() + 2e-3, "{what}");
            assert!((all[0] - all[1]).abs() < 0.05 * all[1].abs() + 0.02, "{what}");
        }
    });
}
