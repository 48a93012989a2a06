//! What the header says that a parameter may be, in a fixed form after its unit, is what the library takes: "omega [-], 1 to 200:
//! ...". A domain is "> a", ">= a", "at least a", "a to b" or "> a and at most b", where bounds are numbers, or sums of products
//! of numbers and symbols of other fields, "1.87 + 1.25 skew^2". Every language and page has its domains from there.

use crate::common::neighbours::Neighbours;
use crate::interface::*;
use std::mem::size_of;

const HEADER: &str = include_str!("../../include/asperity.h");

/// A number of the parameters, where it lies in them, the symbol that its comment begins with, its unit, and its domain, empty
/// where there is none.
struct Field {
    name: &'static str,
    offset: usize,
    symbol: &'static str,
    unit: &'static str,
    domain: &'static str,
}

/// One end of a domain: whether the bound belongs to it, and its text.
type End = (bool, &'static str);

fn body() -> &'static str {
    let body = HEADER.split("typedef struct asperity_params {").nth(1).expect("the struct");
    body.split("} asperity_params;").next().expect("its end")
}

fn fields() -> Vec<Field> {
    let mut end = 0;
    let field = |part: &'static str| {
        let (comment, declaration) = part.split_once("*/")?;
        let (kind, name) = declaration.trim().split(';').next()?.rsplit_once([' ', '*'])?;
        let size = match kind {
            "int32_t" => 4,
            "double" | "uint64_t" => 8,
            _ => size_of::<*const f64>(),
        };
        let offset = usize::next_multiple_of(end, size);
        end = offset + size;
        let (symbol, rest) = comment.trim_start_matches(['*', ' ', '\n']).split_once(" [")?;
        let (unit, rest) = rest.split_once(']')?;
        let domain = rest.strip_prefix(", ").unwrap_or(".");
        // It ends at a colon, a comma or the like, which in a number has no space after it.
        let ends = domain.char_indices().filter(|&(_, c)| [':', ';', ',', '.'].contains(&c));
        let mut ends = ends.map(|(i, _)| i).filter(|&i| domain[i + 1..].starts_with(char::is_whitespace));
        let domain = &domain[..ends.next().unwrap_or_default()];
        (kind == "double").then_some(Field { name, offset, symbol, unit, domain })
    };
    body().split("/**").filter_map(field).collect()
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

impl Field {
    fn read(&self, params: &asperity_params) -> f64 {
        // SAFETY: the header says that a double lies there.
        unsafe { *std::ptr::from_ref(params).byte_add(self.offset).cast::<f64>() }
    }

    fn write(&self, params: &mut asperity_params, value: f64) {
        // SAFETY: the header says that a double lies there.
        unsafe { *std::ptr::from_mut(params).byte_add(self.offset).cast::<f64>() = value };
    }
}

/// A bound as a number: terms with " + " between, of factors with spaces between.
fn bound(text: &str, fields: &[Field], params: &asperity_params) -> f64 {
    let factor = |factor: &str| {
        let symbol = factor.strip_suffix("^2");
        let other = fields.iter().find(|other| [other.symbol, other.name].contains(&symbol.unwrap_or(factor)));
        let value = other.map(|other| other.read(params)).or_else(|| factor.parse().ok());
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
fn refusal(params: &asperity_params, field: &Field, value: f64) -> Option<String> {
    let mut params = *params;
    field.write(&mut params, value);
    let mut model = std::ptr::null_mut();
    // SAFETY: initialised parameters; the model is freed once, NULL where there is none.
    let status = unsafe {
        let status = asperity_create(&params, &mut model);
        asperity_free(model);
        status
    };
    assert!([OK, INVALID_PARAMETER, OUT_OF_RANGE].contains(&status), "{} = {value:e}: {}", field.name, message());
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
            "weibull_shape" => params = params.weibull(3.602),
            "skew" => params = params.johnson(0.0, 50.0),
            "kurtosis" => params = params.johnson(0.0, 3.0),
            "slip_radius_2" => params.slip_stress_2 = 1.0,
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
                (false, true) => field.read(&params),
                (false, false) => at * (1.0 + 1e-8),
            };
            let (name, domain) = (field.name, field.domain);
            let refused = refusal(&params, field, inside);
            assert!(refused.is_none(), "{name}, {domain}: {inside:e} is refused: {refused:?}");
            let said = refusal(&params, field, outside);
            let said = said.unwrap_or_else(|| panic!("{name}, {domain}: {outside:e} is taken"));
            assert!(said.starts_with(name), "{name} = {outside:e}: {said}");
            // The refusal has the bound in the words of the header.
            assert!(!is_number || said.contains(text), "{name}, {domain}: the refusal does not say {text}: {said}");
        }
    }
    assert!(checked >= 20, "{checked} domains are understood");
}

#[test]
fn other_units_convert_every_parameter_by_the_unit_that_the_header_says() {
    let (length, force) = (1e-3, 10.0);
    let fields = fields();
    assert_eq!(
        fields.len(),
        body().lines().filter(|line| line.starts_with("  double ") || line.contains(" */ double ")).count()
    );
    let mut params = asperity_params::initial();
    fields.iter().for_each(|field| field.write(&mut params, 1.0));
    // SAFETY: an initialised struct.
    assert_eq!(unsafe { asperity_params_set_units(&mut params, length, force) }, OK, "{}", message());
    for field in &fields {
        let unit = match field.unit {
            "-" if field.name == "length_unit" => 1.0 / length,
            "-" if field.name == "force_unit" => 1.0 / force,
            "-" => 1.0,
            "length" => length,
            "length^2" => length * length,
            "force" => force,
            "force/length" => force / length,
            "stress" => force / (length * length),
            other => panic!("{}: [{other}] is no unit that is converted", field.name),
        };
        let found = field.read(&params);
        assert!((found * unit - 1.0).abs() < 1e-14, "{} [{}]: {found}", field.name, field.unit);
    }
}
