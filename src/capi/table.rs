//! The compiled table handed out, for code that cannot call out of a kernel.

use super::boundary::{self, Failure};
use super::model::{self, asperity_model};
use super::output::fill;
use super::status::asperity_status;
use crate::law::{Quantity, Table};
use crate::model::Model;
use std::mem::size_of;

/// Layout of the table that this header describes: rows of 8 doubles, c[0] + c[1] t + ... + c[7] t^7.
pub const ASPERITY_TABLE_LAYOUT: u32 = 1;

/// A read-only view of a compiled law, for GPU kernels, OpenMP target regions and vectorised loops.
///
/// `asperity_eval.h` evaluates it.
///
/// A row is a polynomial for one fraction of a binade of x = load - pull_off_load. Its index is (bits(x) >> shift) - base, as unsigned
/// 64-bit integers. If that is not below `row_count`, the table does not answer. Its variable is t = (bits of x below `shift` | bits of
/// 1.0) - 1.0. Its value is F. Its derivative by t, times 2^-(exponent of x), is dF/d(load).
///
/// A row whose first coefficient is NaN is a link to its parts. The last 51 bits of that NaN are the offset of the first part in bytes
/// from `rows`, 0 of a row that is left out. The last six numbers of the row are the t at which the next parts begin. The part in which
/// t lies, which may be a link too, is a row whose variable is t minus the t at which it begins. For another memory copy `total_count`
/// rows and change the pointer.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_table {
    /// Set it to `sizeof(asperity_table)`; no more is written.
    pub struct_size: u64,
    /// `row_count` rows of 8 doubles, aligned to 64 bytes.
    pub rows: *const f64,
    /// Number of rows found from x; parts of rows follow them.
    pub row_count: u64,
    /// Shifted bits of x at which the first row begins.
    pub base: u64,
    /// How far the bits of x are shifted.
    pub shift: u32,
    /// `ASPERITY_TABLE_LAYOUT`.
    pub layout_version: u32,
    /// The pull-off load [force].
    pub pull_off_load: f64,
    /// Upper bound of the friction coefficient [-].
    pub max_friction_coefficient: f64,
    /// Loads up to this times F have the coefficient `max_friction_coefficient` [-].
    pub inverse_cap: f64,
    /// Number of rows and parts.
    pub total_count: u64,
    /// Friction force at the pull-off load [force].
    pub pull_off_force: f64,
    /// dF/d(load) [-] of the straight line that replaces F between pull-off and the first row.
    pub light_slope: f64,
    /// Friction force at zero load [force].
    pub zero_force: f64,
    /// dF/d(load) at zero load [-].
    pub zero_slope: f64,
    /// dF/d(load) below the pull-off load [-]: 0.
    pub separated_slope: f64,
    /// Friction force at the end of the last row [force], which `asperity_eval.h` takes for all heavier loads.
    pub heavy_force: f64,
}

/// `kind` of a table: friction force against load.
pub const ASPERITY_TABLE_FRICTION: i32 = 0;
/// `kind` of a table: load against gap. In its rows minus the gap stands in place of a load and the load in place of the friction
/// force: F at -gap is the load, and minus dF/d(load) there its slope by gap. Between the lightest load of the rows and the
/// end it is 0.
pub const ASPERITY_TABLE_LOAD_AT_GAP: i32 = 1;

/// Fills a view of a compiled law of a model.
///
/// @param kind   `ASPERITY_TABLE_FRICTION` or `ASPERITY_TABLE_LOAD_AT_GAP`
/// @param table  receives the view, valid until `asperity_set_params` or `asperity_free` of the model
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`kind`, `struct_size`)
#[no_mangle]
pub unsafe extern "C" fn asperity_table_of(
    model: *const asperity_model,
    kind: i32,
    table: *mut asperity_table,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        fill(table, "table", || match kind {
            ASPERITY_TABLE_FRICTION => Ok(friction(model)),
            ASPERITY_TABLE_LOAD_AT_GAP => Ok(load_at_gap(model)),
            _ => Err(Failure::invalid(format_args!(
                "kind = {kind}: must be 0 (ASPERITY_TABLE_FRICTION) or 1 (ASPERITY_TABLE_LOAD_AT_GAP)"
            ))),
        })
    })
}

fn friction(model: &Model) -> asperity_table {
    let known = model.known(Quantity::Friction);
    asperity_table {
        max_friction_coefficient: model.params().max_friction_coefficient,
        inverse_cap: model.inverse_cap(),
        pull_off_force: known.at_pull_off.0,
        light_slope: known.light_slope,
        zero_force: known.at_zero.0,
        zero_slope: known.at_zero.1,
        separated_slope: known.apart,
        heavy_force: known.heavy,
        ..rows_of(model.table(Quantity::Friction))
    }
}

fn load_at_gap(model: &Model) -> asperity_table {
    let view = model.load_table();
    let heaviest = view.pull_off + view.begin_of(view.row_count);
    let (at_zero, zero_slope) = model.load_and_slope_at_gap(0.0);
    asperity_table {
        zero_force: at_zero,
        zero_slope: 0.0 - zero_slope,
        heavy_force: model.load_at_gap(-heaviest),
        ..rows_of(view)
    }
}

/// The rows of a table, and nothing of what lies beside them.
fn rows_of(table: &Table) -> asperity_table {
    asperity_table {
        struct_size: size_of::<asperity_table>() as u64,
        rows: table.rows.as_ptr().cast(),
        row_count: table.row_count as u64,
        base: table.base,
        shift: table.shift,
        layout_version: ASPERITY_TABLE_LAYOUT,
        pull_off_load: table.pull_off,
        max_friction_coefficient: 0.0,
        inverse_cap: 0.0,
        total_count: table.rows.len() as u64,
        pull_off_force: 0.0,
        light_slope: 0.0,
        zero_force: 0.0,
        zero_slope: 0.0,
        separated_slope: 0.0,
        heavy_force: 0.0,
    }
}

const _: () = assert!(size_of::<crate::law::Row>() == 64);
