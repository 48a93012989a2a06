//! What each call takes of the system is what `fuzz_calls/table.rs` says of it, and so do the pages; its statuses are those of the header.

use crate::common::c_compiler::root;
use crate::fuzz_calls::table::*;
use crate::interface::*;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The allocator of this program and of the library in it, counting what each thread asks for.
struct Counting;

thread_local! {
    static ASKED: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: that of the system; a thread that ends has no count any more.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = ASKED.try_with(|asked| asked.set(asked.get() + 1));
        System.alloc(layout)
    }
    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        System.dealloc(place, layout);
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// A text that names nothing, longer than those that the table has.
const NOTHING: &std::ffi::CStr = c"no such thing = 1 # and nothing like it and nothing like it and nothing like it and nothing like it and nothing like it and nothing like it and nothing like it and nothing like it and nothing like it and nothing like it ";

/// How often a call allocates.
fn asked<T>(call: impl FnOnce() -> T) -> usize {
    let before = ASKED.get();
    call();
    ASKED.get() - before
}

/// How often numbers by their names do, of which some calibrate.
fn asked_by_a_calibration() -> usize {
    let (mut params, names) = (soonest_made(), [c"calibration_load".as_ptr(), c"calibration_friction_force".as_ptr()]);
    // SAFETY: an initialised struct, and names that end.
    asked(|| assert_eq!(unsafe { asperity_params_set_values(&mut params, 2, names.as_ptr(), [1.0, 0.3].as_ptr()) }, OK))
}

/// A call as it is, for many and for none, with parameters that are calibrated, and with numbers, words and places that are refused.
fn forms(call: &Call, model: &Handle) -> Vec<Prepared> {
    let counts: &[usize] = if call.is_batch() { &[0, 1, 40] } else { &[1] };
    let mut forms: Vec<_> = counts.iter().map(|&n| call.prepare(model, n)).collect();
    let mut calibrated = soonest_made();
    // SAFETY: an initialised struct.
    assert_eq!(unsafe { asperity_params_calibrate(&mut calibrated, 1.0, 0.3) }, OK);
    for i in 0..call.arguments.len() {
        let mut other = call.prepare(model, 1);
        match call.arguments[i].1 {
            Params | ChangedParams => {
                let words =
                    bytes(&calibrated).chunks(8).map(|word| u64::from_ne_bytes(word.try_into().expect("8 bytes")));
                other.places[i].iter_mut().zip(words).for_each(|(place, word)| *place = word);
                forms.push(other);
                other = call.prepare(model, 1);
                other.places[i][1] = f64::NAN.to_bits();
            }
            Number(_) => {
                for number in [f64::NAN, 0.0, -1e300, 1e300, 1e30] {
                    other.words[i].bits = number.to_bits();
                    forms.push(other);
                    other = call.prepare(model, 1);
                }
                continue;
            }
            In(..) => other.places[i][0] = f64::NAN.to_bits(),
            Text(_) => other.words[i].pointer = NOTHING.as_ptr().cast_mut().cast(),
            Whole(_) if !call.is_batch() => other.words[i].bits = 77,
            _ => continue,
        }
        forms.push(other);
    }
    forms
}

#[test]
fn calls_allocate_if_the_table_says_so() {
    let models = [soonest_made(), asperity_params::dimensionless(0.01, 1000.0, 0.001, 1.0)];
    let mut wrong = Vec::new();
    for call in CALLS {
        let mut most = if call.name == "asperity_params_set_values" { asked_by_a_calibration() } else { 0 };
        for params in models {
            for form in forms(call, &Handle::new(&params)) {
                most = most.max(asked(|| call.run(&form)));
                free_what_was_made(call, &form);
            }
        }
        if (most > 0) != call.needs.allocates {
            wrong.push(format!("{} allocates {most} times", call.name));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

/// Names of functions, in the order of the table.
fn names(which: impl Fn(&Call) -> bool) -> String {
    CALLS.iter().filter(|call| which(call)).map(|call| format!("`{}`", call.name)).collect::<Vec<_>>().join(", ")
}

/// What a page says between two comments, which name this part of it.
fn compare_page(page: &str, part: &str, expected: &str) {
    let path = root().join(page);
    let text = std::fs::read_to_string(&path).expect(page).replace("\r\n", "\n");
    let (begin, end) = (format!("<!-- tests/c_api: {part} -->\n\n"), format!("\n<!-- end of {part} -->"));
    let (before, rest) = text.split_once(&begin).expect(part);
    let (found, after) = rest.split_once(&end).expect(part);
    if std::env::var_os("ASPERITY_WRITE_PAGES").is_some() {
        std::fs::write(&path, format!("{before}{begin}{expected}{end}{after}")).expect(page);
    } else {
        assert_eq!(found, expected, "{page}: `ASPERITY_WRITE_PAGES=1 cargo test --test c_api pages_say` writes it");
    }
}

#[test]
#[cfg_attr(miri, ignore = "there are no files")]
fn pages_say_what_the_table_says() {
    let mut sizes: Vec<usize> = CALLS.iter().map(|call| call.needs.stack).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let row = |&size: &usize| match size {
        size if size == sizes[0] => format!("| all others | {size} KiB |\n"),
        size => format!("| {} | {size} KiB |\n", names(|call| call.needs.stack == size)),
    };
    let rows: String = sizes.iter().rev().map(row).collect();
    compare_page("docs/dev/reliability.md", "stack", &format!("| Calls | Stack |\n|---|---|\n{rows}"));
    let memory = format!("These calls allocate memory: {}.\n", names(|call| call.needs.allocates));
    compare_page("docs/dev/reliability.md", "memory", &memory);
    let files = format!("It opens no file but the one that {} names.\n", names(|call| call.needs.opens_files));
    compare_page("SECURITY.md", "files", &format!("{memory}\n{files}"));
}

/// The one module that asks the system for anything but memory is that of the call that says so.
#[test]
#[cfg_attr(miri, ignore = "there are no files")]
fn one_call_opens_a_file() {
    let mut folders = vec![root().join("src")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).expect("a source");
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            let asks =
                ["std::fs", "std::net", "std::env", "std::process", "std::thread", "std::os::unix::net", "std::io"];
            let asks = asks.into_iter().find(|module| code.contains(module));
            assert!(asks.is_none() || path.ends_with("capi/surface_file.rs"), "{}: {asks:?}", path.display());
        }
    }
}

/// The statuses that the header says of a function, with those of the functions that it refers to.
fn documented(header: &str, name: &str, seen: &mut Vec<String>) -> Vec<&'static str> {
    const STATUSES: [&str; 6] =
        ["NULL_POINTER", "INVALID_PARAMETER", "INVALID_LOAD", "SEPARATED", "OUT_OF_RANGE", "NOT_CONVERGED"];
    seen.push(name.to_owned());
    let declares = |line: &&str| line.starts_with("asperity_status ") && line.contains(&format!(" {name}("));
    let Some(line) = header.lines().find(declares) else { return Vec::new() };
    let declared = line.as_ptr() as usize - header.as_ptr() as usize;
    let comment = &header[header[..declared].rfind("/**").expect("a comment")..declared];
    let returned = comment.find("@return").map_or(comment, |at| &comment[at..]);
    let mut found: Vec<_> =
        STATUSES.into_iter().filter(|status| returned.contains(&format!("ASPERITY_{status}"))).collect();
    let words = returned.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
    for other in words.filter(|word| CALLS.iter().any(|call| call.name == *word)) {
        if !seen.iter().any(|one| one == other) {
            found.extend(documented(header, other, seen));
        }
    }
    found
}

#[test]
fn statuses_are_those_of_the_header() {
    let header = include_str!("../../include/asperity.h");
    let name = |status: i32| {
        let values = [NULL_POINTER, INVALID_PARAMETER, INVALID_LOAD, SEPARATED, OUT_OF_RANGE, NOT_CONVERGED];
        let names = ["NULL_POINTER", "INVALID_PARAMETER", "INVALID_LOAD", "SEPARATED", "OUT_OF_RANGE", "NOT_CONVERGED"];
        values.iter().position(|value| *value == status).map(|at| names[at])
    };
    let model = Handle::new(&soonest_made());
    let mut wrong = Vec::new();
    for call in CALLS {
        for form in forms(call, &model) {
            let Told::Status(status) = call.run(&form) else { continue };
            free_what_was_made(call, &form);
            if name(status).is_some_and(|name| !documented(header, call.name, &mut Vec::new()).contains(&name)) {
                wrong.push(format!("{}: {}", call.name, message()));
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}
