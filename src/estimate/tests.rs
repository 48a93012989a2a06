//! What an estimate says, and how often it is right.

use super::{write, Estimate};
use crate::by_name::Case;
use std::time::Instant;

fn show(text: &str, loads: &[f64]) {
    let start = Instant::now();
    let estimate = match Estimate::new(text.as_bytes(), loads) {
        Ok(estimate) => estimate,
        Err(error) => return println!("{error}\n"),
    };
    let made = start.elapsed();
    let answers: Vec<_> = loads.iter().map(|&load| estimate.at_load(load).unwrap()).collect();
    let asked = start.elapsed() - made;
    let warnings = estimate.warnings(loads).unwrap();
    let checked = start.elapsed() - made - asked;
    let mut out = String::new();
    write(&estimate, &answers, warnings, &mut out).unwrap();
    println!("{out}{made:?} {asked:?} {checked:?} {} models\n", estimate.cases.len());
}

#[test]
fn shown() {
    let g = "pair = \"steel/steel\"\nnominal_area = 1e-4\n";
    let r = "[roughness]\nprocess = \"ground\"\nRa = 0.8e-6\n";
    show(&format!("{g}measured = [[1000, 0.16]]\n{r}"), &[10.0]);
    show(&format!("{g}measured = [[1000, 0.16], [10, 0.19, 0.03]]\n{r}"), &[10.0, 1.0, 1000.0]);
    show(&format!("{g}measured = [[1000, 0.16], [10, 0.12, 0.03], [100, 0.14]]\n{r}"), &[10.0, 1.0, 1000.0]);
    show(&format!("{g}measured = [[1000, 0.16], [10, 0.16, 0.03]]\n{r}"), &[10.0, 1.0, 1000.0]);
    show(&format!("{g}{r}"), &[10.0, 1000.0]);
    show(&format!("{g}interface = \"steel/steel dry\"\n{r}"), &[10.0, 1000.0]);
    show(&format!("{g}interface = \"MoS2 film in dry air\"\n{r}"), &[10.0, 1000.0]);
    show(&format!("{g}[roughness]\nprocess = \"ground\"\n"), &[10.0, 0.0, -1.0]);
    show(&format!("{g}[roughness]\nRa = 0.8e-6\nRSm = 80e-6\n"), &[10.0]);
    show(&format!("pair = \"Si/Si\"\nnominal_area = 1e-8\n[roughness]\nSq = 5e-9\nSdq = 0.08\n"), &[1e-3, 0.0, -1e-9, -1.0]);
    show(&format!("pair = \"Si/Si\"\nmeasured = [1e-3, 0.4]\nnominal_area = 1e-8\n[roughness]\nSq = 5e-9\nSdq = 0.08\n"), &[1e-3, 0.0, -1e-9, -1.0]);
    show(&format!("pair = \"mica/mica\"\nnominal_area = 1e-8\n[roughness]\nSq = 5e-9\nSdq = 0.08\n"), &[1e-3, 0.0, -1e-9, -1.0]);
    show(&format!("pair = \"Si/Si\"\nmeasured = [1e-3, 0.4, 5]\nnominal_area = 1e-8\n[roughness]\nSq = 5e-9\nSdq = 0.08\n"), &[1e-3, 0.0, -1e-9, -1.0]);
    show(&format!("{g}[roughness]\nRa = 0.8\nprocess = \"grund\"\n"), &[10.0]);
    let _ = Case::default();
}
