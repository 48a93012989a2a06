//! What neighbours change where the nominal area is known: stiffness, conductance, and the gap between the mean planes.

use crate::common::surfaces::{crowded, dimensionless, model};
use asperity::{Model, Params, SpectralMoments, State};
use statrs::function::erf::erf;
use std::f64::consts::PI;

/// Of the same summits without neighbours, counted from their mean.
fn lone(params: &Params) -> Params {
    Params { nominal_area: 0.0, summit_mean_height: 0.0, ..params.clone() }
}

fn surfaces() -> Vec<Params> {
    let yielding = Params {
        work_of_adhesion: 0.0,
        hardness: 0.02 * Params::paper().composite_modulus,
        contact_law: asperity::ContactLawKind::ElasticPlastic,
        ..Params::paper()
    };
    let varying = Params { radius_amplitude: -0.61, radius_rate: 0.9, ..dimensionless(0.01, 1000.0, 0.0, 1.0) };
    [Params::paper(), dimensionless(0.006, 5e4, 0.01, 1.0), varying, yielding].map(|params| crowded(params, 0.1)).into()
}

/// Loads over the decades that surfaces are pressed with, in that at which half of the summits touch.
fn loads(lone: &Model) -> Vec<f64> {
    let half = lone.state_at_gap(0.0).expect("a state").load;
    (0..40).map(|i| half * 1e-8 * 1e11_f64.powf(f64::from(i) / 39.0)).collect()
}

/// psi as the summits of a lone state have it, from its area.
fn psi(state: &State, params: &Params) -> f64 {
    let share = state.real_area / params.nominal_area;
    let share = share / (1.0 + (2.0 * share).powi(4)).powf(0.25);
    (1.0 - share.sqrt()).powf(1.8)
}

/// What the surface gives way by where summits approach by 1: what neighbours share is elastic, whatever the contacts are.
fn given_way(alone: &State, params: &Params) -> f64 {
    let elastic = 2.0 * params.composite_modulus * alone.contact_radius_sum;
    (1.0 - psi(alone, params)) * (-alone.dload_dgap).max(0.0) / elastic
}

#[test]
fn stiffness_along_and_conductance_are_those_of_lone_contacts_over_psi_and_normal_compliance_lacks_what_is_shared() {
    for params in surfaces() {
        let (model, lone) = (model(&params), model(&lone(&params)));
        for load in loads(&lone) {
            let [state, alone] = [&model, &lone].map(|model| model.state_at_load(load).expect("a state"));
            let psi = psi(&alone, &params);
            let elastic = 2.0 * params.composite_modulus * alone.contact_radius_sum;
            let compliance = -1.0 / alone.dload_dgap - (1.0 - psi) / elastic;
            assert!((state.dload_dgap * compliance + 1.0).abs() < 1e-9, "{load:e}: {}", state.dload_dgap);
            let unloading = match params.hardness > 0.0 {
                true => elastic / psi,
                false => -state.dload_dgap,
            };
            assert!((state.unloading_stiffness / unloading - 1.0).abs() < 1e-9, "{load:e}: {state:?}");
            if params.work_of_adhesion == 0.0 && params.hardness == 0.0 {
                assert!((state.dload_dgap * psi / alone.dload_dgap - 1.0).abs() < 1e-12, "{load:e}: Hertz");
            }
            for (name, found, of_lone) in [
                ("tangential", state.tangential_stiffness, alone.tangential_stiffness),
                ("conductance", state.contact_radius_sum, alone.contact_radius_sum),
                ("at once", model.tangential_at_load(load, 0.0).expect("a force").1, alone.tangential_stiffness),
                ("compiled", model.tangential_stiffness_at_load(load), alone.tangential_stiffness),
            ] {
                assert!(
                    (found * psi / of_lone - 1.0).abs() < if name == "compiled" { 1e-6 } else { 1e-9 },
                    "{name} at {load:e}: {found:e}, {of_lone:e}, {psi}"
                );
            }
            for (found, of_lone) in [(state.friction_force, alone.friction_force), (state.real_area, alone.real_area)] {
                assert!((found / of_lone - 1.0).abs() < 1e-10, "{load:e}: {found:e}, not {of_lone:e}");
            }
        }
    }
}

/// Contacts are displaced by more than the mean planes are, and slip as they would alone.
#[test]
fn contacts_slip_at_the_displacement_of_lone_ones_times_psi() {
    for params in surfaces() {
        let (model, lone) = (model(&params), model(&lone(&params)));
        for load in loads(&lone).into_iter().step_by(7) {
            let alone = lone.state_at_load(load).expect("a state");
            let psi = psi(&alone, &params);
            for part in [0.01, 0.5, 2.0, 30.0] {
                let displacement = part * alone.friction_force / alone.tangential_stiffness;
                let (force, stiffness) = model.tangential_at_load(load, psi * displacement).expect("a force");
                let (expected, of_lone) = lone.tangential_at_load(load, displacement).expect("a force");
                assert!((force / expected - 1.0).abs() < 1e-9, "{part} at {load:e}: {force:e}, not {expected:e}");
                assert!((stiffness * psi - of_lone).abs() <= 1e-9 * alone.tangential_stiffness, "{part} at {load:e}");
            }
        }
    }
}

/// By Simpson's rule over lone states, from where neighbours no longer matter.
#[test]
fn the_gap_is_what_the_summits_are_apart_and_the_integral_of_what_the_surface_gives_way_by() {
    const STEPS: u32 = 2000;
    for params in surfaces() {
        let (model, lone) = (model(&params), model(&lone(&params)));
        let sigma = params.height_std;
        let (near, far) = (-6.0, 14.0);
        let lacks = |d: f64| given_way(&lone.state_at_gap(d * sigma).expect("a state"), &params);
        let step = (far - near) / f64::from(STEPS);
        let mut integral = 0.0;
        for i in (0..STEPS).rev().step_by(2) {
            let d = near + step * f64::from(i - 1);
            let whole = lacks(d) + 4.0 * lacks(d + step) + lacks(d + 2.0 * step);
            integral += step / 3.0 * whole;
            if i % 250 == 1 {
                let load = lone.state_at_gap(d * sigma).expect("a state").load;
                let gap = params.summit_mean_height + (d + integral) * sigma;
                let found = model.state_at_gap(gap).expect("a state").load;
                let slope = lone.state_at_gap(d * sigma).expect("a state").dload_dgap;
                let off = (found - load) / (slope * sigma);
                assert!(off.abs() < 1e-6, "{d}: off by {off:e} sigma; {params:?}");
            }
        }
    }
}

/// However small the nominal area: stiffness is finite, and rises with load up to 9.1 times that of lone contacts.
#[test]
fn stiffness_rises_with_any_load_and_stays_finite() {
    for share in [1e-3, 0.1, 10.0, 1e6, 1e30] {
        let params = crowded(dimensionless(0.01, 1000.0, 0.0, 1.0), share);
        let (model, lone) = (model(&params), model(&lone(&params)));
        let table = model.summary();
        let mut before = (0.0, f64::INFINITY);
        for i in 0..900 {
            let load = 1e-30 * 10_f64.powf(0.1 * f64::from(i));
            let [stiffness, of_lone] = [&model, &lone].map(|model| model.tangential_stiffness_at_load(load));
            let rises = stiffness > before.0 && stiffness.is_finite();
            assert!(rises, "{share:e}: {stiffness:e} at {load:e}, {:e} before", before.0);
            // Beyond the table both go on as powers.
            let is_tabulated = (table.min_table_load..table.max_table_load).contains(&load);
            let is_within = (1.0 - 1e-6..9.2).contains(&(stiffness / of_lone));
            assert!(is_within || !is_tabulated, "{share:e}, {load:e}: {stiffness:e}, {of_lone:e}");
            let gap =
                if load < 1e30 { model.state_at_load(load).map_or(f64::NAN, |state| state.gap) } else { f64::NAN };
            assert!(gap.is_nan() || gap <= before.1, "{share:e}: {gap:e} at {load:e}");
            before = (stiffness, if gap.is_nan() { before.1 } else { gap });
        }
        let (load, slope) = model.load_and_slope_at_gap(-1e9 * params.height_std);
        assert!(load.is_finite() && slope.is_finite() && slope < 0.0, "{load:e}, {slope:e}");
    }
}

#[test]
fn without_a_nominal_area_nothing_changes_but_where_gaps_count_from() {
    let params = Params::paper();
    let [from_summits, from_plane] =
        [params.clone(), Params { summit_mean_height: 7.0, ..params }].map(|params| model(&params));
    for d in [-50.0, -3.0, 0.0, 4.0, 31.0] {
        let [a, b] = [from_summits.load_and_slope_at_gap(d), from_plane.load_and_slope_at_gap(d + 7.0)];
        assert!((a.0 / b.0 - 1.0).abs() < 1e-9 && (a.1 / b.1 - 1.0).abs() < 1e-7, "{d}: {a:?}, {b:?}");
    }
    let state = from_plane.state_at_load(3.0).expect("a state");
    assert!((state.gap - from_summits.state_at_load(3.0).expect("a state").gap - 7.0).abs() < 1e-9);
}

/// On the branch and beyond pull-off, up to where nothing is left.
#[test]
fn states_are_found_at_their_gaps_also_beyond_pull_off() {
    for (gamma, share) in [(1e-3, 0.1), (0.02, 0.5), (0.3, 5.0)] {
        let params = crowded(dimensionless(0.01, 1000.0, gamma, 1.0), share);
        let model = model(&params);
        let sigma = params.height_std;
        let end = model.state_at_load(model.summary().pull_off_load).expect("a state").gap;
        let mut before: Option<State> = None;
        for i in 0..400 {
            let gap = end + sigma * (0.02 * f64::from(i) - 4.0);
            let state = model.state_at_gap(gap).expect("a state");
            assert!((state.gap - gap).abs() < 1e-8 * sigma, "{gap}: {}", state.gap);
            if let Some(before) = before {
                let steepest = before.dload_dgap.abs().max(state.dload_dgap.abs());
                let most = 1.01 * steepest * (gap - before.gap) + 1e-9 * state.load.abs();
                assert!((state.load - before.load).abs() <= most, "{gap}: {state:?} after {before:?}");
            }
            before = Some(state);
        }
    }
}

// ---- Persson's theory ----

/// A self-affine spectrum between the wavenumbers 1 and `last`, constant up to `roll_off`.
struct Spectrum {
    hurst: f64,
    roll_off: f64,
    last: f64,
}

impl Spectrum {
    fn power(&self, q: f64) -> f64 {
        (q / self.roll_off).max(1.0).powf(-2.0 * (1.0 + self.hurst))
    }

    /// At wavenumbers q: q, the length of the step in ln q, and the mean square slope of all waves up to there.
    fn waves(&self) -> Vec<(f64, f64, f64)> {
        const STEPS: u32 = 400;
        let step = self.last.ln() / f64::from(STEPS);
        let mut square_slope = 0.0;
        let waves = (0..STEPS).map(|i| {
            let q = (step * (f64::from(i) + 0.5)).exp();
            let part = 2.0 * PI * q.powi(4) * self.power(q) * step;
            square_slope += part;
            (q, step, square_slope - 0.5 * part)
        });
        waves.collect()
    }

    fn moments(&self) -> SpectralMoments {
        let sum = |power: i32| {
            self.waves().iter().map(|(q, step, _)| 2.0 * PI * q.powi(power) * self.power(*q) * step).sum::<f64>()
        };
        SpectralMoments { m0: sum(2), m2: 0.5 * sum(4), m4: 0.375 * sum(6) }
    }

    /// -p du/dp at a pressure over E*: C. Yang and B. N. J. Persson, J. Phys.: Condens. Matter 20 (2008) 215214, eq. of u(p), with
    /// gamma = 0.42 as in A. Almqvist and others, J. Mech. Phys. Solids 59 (2011) 2355. B. N. J. Persson, Phys. Rev. Lett. 99 (2007) 125502
    /// has gamma = 1.
    fn compliance(&self, pressure: f64) -> f64 {
        const GAMMA: f64 = 0.42;
        let of_wave = |&(q, step, square_slope): &(f64, f64, f64)| {
            let w = (2.0 / square_slope).sqrt();
            let area = erf(w * pressure);
            let energy = GAMMA + 3.0 * (1.0 - GAMMA) * area * area;
            PI.sqrt() * q.powi(3) * self.power(q) * step * w * energy * (-(w * pressure).powi(2)).exp()
        };
        self.waves().iter().map(of_wave).sum()
    }

    /// u at a pressure over E*.
    fn gap(&self, pressure: f64) -> f64 {
        const STEPS: u32 = 60;
        let step = (1e3_f64).ln() / f64::from(STEPS);
        (0..STEPS).map(|i| step * self.compliance(pressure * (step * (f64::from(i) + 0.5)).exp())).sum()
    }
}

/// A surface of these moments, with E* = 1 and a nominal area of 1e6.
fn surface(moments: SpectralMoments) -> Model {
    let mut params = Params { work_of_adhesion: 0.0, ..Params::paper() };
    let moduli = params.composite_modulus;
    (params.composite_modulus, params.effective_shear_modulus) = (1.0, params.effective_shear_modulus / moduli);
    let length = 1e-3 * moments.m0.sqrt();
    (params.burgers_vector, params.adhesion_range) = (length, length);
    params.set_spectral_moments(moments, 1e6).expect("asperities");
    model(&params)
}

/// Between p = .005 and .045 E* h'. The theory's K h/p is 1.8 to 2.2 there, which is its exponential law p = exp(-u/u_0) with u_0 near
/// h/2; the asperities follow boundary elements, which are stiffer under light loads.
#[test]
fn stiffness_and_gap_are_those_of_perssons_theory() {
    for (hurst, roll_off, last) in
        [(0.8, 1.0, 32.0), (0.8, 4.0, 64.0), (0.8, 1.0, 128.0), (0.5, 1.0, 32.0), (0.3, 1.0, 8.0)]
    {
        let spectrum = Spectrum { hurst, roll_off, last };
        let moments = spectrum.moments();
        let (height, slope) = (moments.m0.sqrt(), (2.0 * moments.m2).sqrt());
        let scale = 0.05 / slope;
        // Shallower, so that the slope is moderate: heights and gaps scale with it.
        let (m0, m2, m4) = (moments.m0 * scale * scale, moments.m2 * scale * scale, moments.m4 * scale * scale);
        let model = surface(SpectralMoments { m0, m2, m4 });
        for x in [0.005, 0.015, 0.045] {
            let state = model.state_at_load(x * 0.05 * 1e6).expect("a state");
            let found = -state.dload_dgap * m0.sqrt() / state.load;
            let expected = height / spectrum.compliance(x * slope);
            let gap = state.gap / m0.sqrt();
            let expected_gap = spectrum.gap(x * slope) / height;
            println!("H {hurst}, {roll_off} to {last}, x {x}: K h/p {found:.3}, {expected:.3}; u/h {gap:.3}, {expected_gap:.3}");
            let (stiffer, off) = (found / expected - 1.0, gap - expected_gap);
            let (most, most_off) = if x > 0.04 { (0.17, 0.13) } else { (0.25, 0.24) };
            assert!(
                stiffer > 0.0 && stiffer < most && off.abs() < most_off,
                "H {hurst}, {last} at {x}: {stiffer}, {off}"
            );
        }
    }
}
