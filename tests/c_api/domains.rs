//! What the header says that a parameter may be, in a fixed form after its unit, is what the library takes: "omega [-], 1 to 200:
//! ...". A domain is "> a", ">= a", "at least a", "a to b" or "> a and at most b", where bounds are numbers, or sums of products
//! of numbers and symbols of other fields, "1.87 + 1.25 skew^2". Every language and page has its domains from there.

use crate::common::neighbours::Neighbours;
use crate::interface::*;
use std::ffi::CString;

const HEADER: &str = include_str!("../../include/asperity.h");

/// A field of the parameters, the symbol that its comment begins with, and its domain.
struct Field {
    name: &'static str,
    symbol: &'static str,
    domain: &'static str,
}

/// One end of a domain: whether the bound belongs to it, and its text.
type End = (bool, &'static str);

fn fields() -> Vec<Field> {
    let body = HEADER.split("typedef struct asperity_params {").nth(1).expect("the struct");
    let body = body.split("} asperity_params;").next().expect("its end");
    let field = |part: &'static str| {
        let (comment, declaration) = part.split_once("*/")?;
        let name = declaration.split(';').next()?.rsplit([' ', '*']).next()?;
        let (symbol, rest) = comment.trim_start_matches(['*', ' ', '\n']).split_once(" [")?;
        let domain = rest.split_once("], ")?.1;
        // It ends at a colon, a comma or the like, which in a number has no space after it.
        let ends = domain.char_indices().filter(|&(_, c)| [':', ';', ',', '.'].contains(&c));
        let mut ends = ends.map(|(i, _)| i).filter(|&i| domain[i + 1..].starts_with(char::is_whitespace));
        let domain = &domain[..ends.next()?];
        (!declaration.contains('*')).then_some(Field { name, symbol, domain })
    };
    body.split("/**").filter_map(field).collect()
}

/// The lower and the upper end of a domain; none of what is no domain.
fn ends(domain: &'static str) -> [Option<End>; 2] {
    if let Some((lower, upper)) = domain.split_once(" to ") {
        return [Some((true, lower)), Some((true, upper))];
    }
    let (lower, upper) = domain.split_once(" and at most ").map_or((domain, None), |(low, high)| (low, Some(high)));
    let at_least = lower.strip_prefix(">= ").or(lower.strip_prefix("at least "));
    let above = lower.strip_prefix("> ");
    [at_least.map(|bound| (true, bound)).or(above.map(|bound| (false, bound))), upper.map(|bound| (true, bound))]
}

fn set(params: &mut asperity_params, name: &str, value: f64) {
    let name = CString::new(name).unwrap();
    // SAFETY: initialised parameters and a string.
    assert_eq!(unsafe { asperity_params_set_value(params, name.as_ptr(), value) }, OK, "{name:?}: {}", message());
}

fn get(params: &asperity_params, name: &str) -> f64 {
    let (name, mut value) = (CString::new(name).unwrap(), 0.0);
    // SAFETY: initialised parameters and a string.
    assert_eq!(unsafe { asperity_params_get_value(params, name.as_ptr(), &mut value) }, OK, "{name:?}: {}", message());
    value
}

/// A bound as a number: terms with " + " between, of factors with spaces between.
fn bound(text: &str, fields: &[Field], params: &asperity_params) -> f64 {
    let factor = |factor: &str| {
        let symbol = factor.strip_suffix("^2");
        let other = fields.iter().find(|other| [other.symbol, other.name].contains(&symbol.unwrap_or(factor)));
        let value = other.map(|other| get(params, other.name)).or_else(|| factor.parse().ok());
        let value = value.unwrap_or_else(|| panic!("'{factor}' of '{text}' is no number and no symbol of a field"));
        if symbol.is_some() {
            value * value
        } else {
            value
        }
    };
    text.split(" + ").map(|term| term.split(' ').map(factor).product::<f64>()).sum()
}

/// Why a model with this value is refused; none if it is made.
fn refusal(params: &asperity_params, name: &str, value: f64) -> Option<String> {
    let mut params = *params;
    set(&mut params, name, value);
    let mut model = std::ptr::null_mut();
    // SAFETY: initialised parameters; the model is freed once, NULL where there is none.
    let status = unsafe {
        let status = asperity_create(&params, &mut model);
        asperity_free(model);
        status
    };
    assert!([OK, INVALID_PARAMETER, OUT_OF_RANGE].contains(&status), "{name} = {value:e}: {}", message());
    (status != OK).then(message)
}

#[test]
fn parameters_are_taken_where_the_header_says_and_no_further() {
    let fields = fields();
    let mut checked = 0;
    for field in &fields {
        let mut params = asperity_params::initial();
        // What others must be where this one is at its end.
        match field.name {
            "skew" => set(&mut params, "kurtosis", 50.0),
            "slip_radius_2" => set(&mut params, "slip_stress_2", 1.0),
            _ => {}
        }
        let ends = ends(field.domain);
        checked += usize::from(ends[0].is_some());
        for (is_upper, end) in ends.into_iter().enumerate().filter_map(|(i, end)| Some((i == 1, end?))) {
            let (belongs, text) = end;
            let at = bound(text, &fields, &params);
            let is_number = text.parse::<f64>().is_ok();
            // Bounds that are computed are met but for rounding.
            let step = |outwards: bool| match (is_number, outwards == is_upper) {
                (true, true) => at.above(),
                (true, false) => at.below(),
                (false, true) => at + 1e-9 * at.abs(),
                (false, false) => at - 1e-9 * at.abs(),
            };
            let outside = if belongs { step(true) } else { at };
            let inside = match (belongs, is_number) {
                (true, true) => at,
                (true, false) => step(false),
                (false, true) => get(&params, field.name),
                (false, false) => at * (1.0 + 1e-8),
            };
            let (name, domain) = (field.name, field.domain);
            let refused = refusal(&params, name, inside);
            assert!(refused.is_none(), "{name}, {domain}: {inside:e} is refused: {refused:?}");
            let said = refusal(&params, name, outside);
            let said = said.unwrap_or_else(|| panic!("{name}, {domain}: {outside:e} is taken"));
            assert!(said.starts_with(name), "{name} = {outside:e}: {said}");
            // The refusal has the bound in the words of the header.
            assert!(!is_number || said.contains(text), "{name}, {domain}: the refusal does not say {text}: {said}");
        }
    }
    assert!(checked >= 20, "{checked} domains are understood");
}
