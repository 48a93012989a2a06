//! Second names give what first names give.

use crate::interface::*;
use std::ffi::c_char;
use std::mem::{size_of, zeroed};
use std::ptr::{null, null_mut};

/// What both functions write into a struct that begins with its size, as words.
fn same<T>(what: &str, one: impl FnOnce(*mut T) -> i32, other: impl FnOnce(*mut T) -> i32) {
    let words = |call: Box<dyn FnOnce(*mut T) -> i32 + '_>| {
        // SAFETY: structs of numbers and pointers.
        let mut out: T = unsafe { zeroed() };
        let at = std::ptr::from_mut(&mut out);
        // SAFETY: the struct begins with its size, and has whole words.
        unsafe {
            at.cast::<u64>().write(size_of::<T>() as u64);
            assert_eq!(call(at), OK, "{what}");
            std::slice::from_raw_parts(at.cast::<u64>(), size_of::<T>() / 8).to_vec()
        }
    };
    let found = words(Box::new(one));
    assert!(found[1..].iter().any(|&word| word != 0), "{what}");
    assert_eq!(found, words(Box::new(other)), "{what}");
}

#[test]
fn second_names_give_what_first_names_give() {
    let handle = Handle::new(&asperity_params::initial());
    let model = handle.0;
    // SAFETY: a model, structs of their sizes, and strings that end.
    unsafe {
        same("summary", |out| asperity_summary_of(model, out), |out| asperity_get_summary(model, out));
        same("table", |out| asperity_table_of(model, out), |out| asperity_get_table(model, out));
        let [steel, pair, film] = [c"steel", c"Si/Si", c"MoS2 film in dry air"].map(|name| name.as_ptr());
        same("material", |out| asperity_material(steel, out), |out| asperity_get_material(steel, out));
        same("pair", |out| asperity_pair(pair, out), |out| asperity_get_pair(pair, out));
        same("interface", |out| asperity_interface(film, out), |out| asperity_get_interface(film, out));
        for (load, rate) in [(5.0, 0.3), (0.0, -2.0), (f64::NAN, 1.0)] {
            let mut slopes = [0.0; 4];
            let [a, b, c, d] = slopes.each_mut().map(std::ptr::from_mut);
            let force = asperity_slip_force(model, load, rate, 1.0, a, b);
            let again = asperity_friction_force_at_slip_rate(model, load, rate, 1.0, c, d);
            assert_eq!(force.to_bits(), again.to_bits());
            assert_eq!(slopes.map(f64::to_bits)[..2], slopes.map(f64::to_bits)[2..]);
        }
        let mut out = [0.0; 4];
        let [a, b, c, d] = out.each_mut().map(std::ptr::from_mut);
        assert_eq!(asperity_tangential_at_load(model, 5.0, 0.1, a, b), OK);
        assert_eq!(asperity_tangential_force_at_displacement(model, 5.0, 0.1, c, d), OK);
        assert!(out[0] > 0.0 && out[..2] == out[2..]);
    }
}

#[test]
fn second_names_refuse_what_first_names_refuse() {
    let none: *const c_char = null();
    // SAFETY: NULL is refused.
    unsafe {
        assert_eq!(asperity_get_summary(null(), null_mut()), NULL_POINTER);
        assert_eq!(asperity_get_table(null(), null_mut()), NULL_POINTER);
        assert_eq!(asperity_get_material(none, null_mut()), NULL_POINTER);
        assert_eq!(asperity_get_pair(none, null_mut()), NULL_POINTER);
        assert_eq!(asperity_get_interface(none, null_mut()), NULL_POINTER);
        assert!(asperity_friction_force_at_slip_rate(null(), 1.0, 1.0, 1.0, null_mut(), null_mut()).is_nan());
        let status = asperity_tangential_force_at_displacement(null(), 1.0, 1.0, null_mut(), null_mut());
        assert_eq!(status, NULL_POINTER);
    }
}
