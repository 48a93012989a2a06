//! The rows of `reference/*.json`: sums at separations, computed without the library.

use serde::de::DeserializeOwned;
use serde::Deserialize;

/// A surface with its rows.
#[derive(Deserialize)]
pub struct Case {
    pub name: String,
    pub params: CaseParams,
    pub rows: Vec<Row>,
}

/// Its parameters; of the heights, those of one family.
#[derive(Debug, Deserialize)]
pub struct CaseParams {
    pub alpha: f64,
    pub beta: f64,
    pub gamma: f64,
    pub b_over_h: f64,
    pub epsilon: f64,
    pub rho: f64,
    pub weibull_shape: Option<f64>,
    pub skew: Option<f64>,
    pub kurtosis: Option<f64>,
    pub table_height: Option<Vec<f64>>,
    pub table_density: Option<Vec<f64>>,
    pub noncontacting: bool,
    pub a1: f64,
    pub tau1: f64,
    pub a2: f64,
    pub tau2: f64,
}

/// Sums at a separation in sigma, in E* b^2, G* b^2, b^2.
#[derive(Deserialize)]
pub struct Row {
    pub separation: f64,
    pub load: f64,
    pub load_contacting: f64,
    pub load_attracted: f64,
    pub friction: f64,
    pub contacting: f64,
    pub area: f64,
    pub dload_dseparation: f64,
    pub dfriction_dload: f64,
    pub attracted: Option<f64>,
    pub load_absolute: Option<f64>,
}

/// The surfaces of a file.
pub fn read<C: DeserializeOwned>(file: &str) -> Vec<C> {
    let path = format!("{}/tests/reference/{file}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).expect(file)).expect(file)
}
