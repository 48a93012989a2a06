//! Data goes one way through the sources (docs/dev/architecture.md): no file imports, by whatever detour, what imports it. A
//! `mod.rs` is its folder's front: the files beside it may use what it declares.
//!
//! Answers depend on arguments alone: no file asks the system for anything but memory, but for the one that reads a surface
//! file.

mod workflows;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Modules by their paths, as "law::table", and what they import.
type Imports = BTreeMap<String, BTreeSet<String>>;

#[test]
fn no_file_imports_in_a_circle() {
    let mut imports = imports();
    assert!(imports["capi::model"].contains("model") && imports["params::checks"].contains("params::numbers"));
    for _ in 0..imports.len() {
        // What imports nothing that is left, and what nothing that is left imports, is in no circle.
        let used: BTreeSet<_> = imports.values().flatten().cloned().collect();
        let left: BTreeSet<_> = imports.keys().filter(|module| used.contains(*module)).cloned().collect();
        imports.retain(|module, uses| left.contains(module) && uses.iter().any(|used| left.contains(used)));
        imports.values_mut().for_each(|uses| uses.retain(|used| left.contains(used)));
    }
    assert!(imports.is_empty(), "imports in a circle: {imports:#?}");
}

#[test]
fn one_file_reads_files_and_none_the_environment_or_a_clock() {
    const OF_THE_SYSTEM: [&str; 8] = ["env", "fs", "io", "net", "os", "process", "thread", "time"];
    let asks = |path: &Vec<String>| path.len() > 1 && path[0] == "std" && OF_THE_SYSTEM.contains(&&*path[1]);
    assert!(
        paths("", "std::env::var(x)").iter().any(asks) && paths("", "\nuse std::{fmt, fs::File};").iter().any(asks)
    );
    let reads = |path: &Vec<String>| ["fs", "io", "os"].contains(&&*path[1]);
    for (module, text) in sources() {
        let asks = |path: &Vec<String>| asks(path) && !(module == "capi::surface_file" && reads(path));
        let found: Vec<_> = paths("", &text).into_iter().filter(asks).collect();
        assert!(found.is_empty(), "{module}: {found:?}");
    }
}

fn sources() -> BTreeMap<String, String> {
    let mut sources = BTreeMap::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), "", &mut sources);
    sources
}

fn imports() -> Imports {
    let sources = sources();
    let imports_of = |(module, text): (&String, &String)| {
        let used = paths(module, text).into_iter().filter_map(|path| {
            let is_module = |end: &usize| sources.contains_key(&path[..*end].join("::"));
            let end = (0..=path.len()).rev().find(is_module)?;
            Some(path[..end].join("::"))
        });
        (module.clone(), used.filter(|used| !is_front_of(used, module)).collect())
    };
    sources.iter().map(imports_of).collect()
}

/// Whether a module is another itself, or the front of its folder.
fn is_front_of(front: &str, module: &str) -> bool {
    front.is_empty() || module.strip_prefix(front).is_some_and(|rest| rest.is_empty() || rest.starts_with("::"))
}

/// The sources of a folder, without comments and tests.
fn read(folder: &Path, module: &str, sources: &mut BTreeMap<String, String>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().and_then(|stem| stem.to_str()).expect("a name");
        let inner = if module.is_empty() { name.to_string() } else { format!("{module}::{name}") };
        if path.is_dir() {
            read(&path, &inner, sources);
        } else if name != "tests" {
            let text = std::fs::read_to_string(&path).expect("a source");
            let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
            let code: Vec<_> = code.lines().map(|line| line.split("//").next().unwrap_or_default().trim()).collect();
            let module = if ["mod", "lib"].contains(&name) { module.to_string() } else { inner };
            sources.insert(module, format!("\n{}", code.join("\n")));
        }
    }
}

/// The paths that a module names, from the root of the crate.
fn paths(module: &str, text: &str) -> Vec<Vec<String>> {
    let is_path = |letter: char| letter.is_alphanumeric() || "_:".contains(letter);
    let in_code = text.split(|letter| !is_path(letter)).filter(|word| word.contains("::")).map(String::from);
    let text = text.replace("pub use ", "use ");
    let uses = text.split("\nuse ").skip(1).filter_map(|rest| Some(rest.split_once(';')?.0));
    let named = in_code.chain(uses.flat_map(branches));
    let from_root = |path: String| {
        let mut place: Vec<_> = module.split("::").filter(|part| !part.is_empty()).map(String::from).collect();
        for part in path.split("::").map(|part| part.split_whitespace().next().unwrap_or_default()) {
            match part {
                "crate" => place.clear(),
                "super" => drop(place.pop()),
                "" | "self" => {}
                _ => place.push(part.to_string()),
            }
        }
        place
    };
    named.map(from_root).collect()
}

/// The paths of a tree: `a::b` and `a::c::d` of `a::{b, c::{d}}`.
fn branches(tree: &str) -> Vec<String> {
    let Some((stem, list)) = tree.split_once('{') else { return vec![tree.to_string()] };
    let mut depth = 0;
    let at_comma = |letter: char| {
        depth += i32::from(letter == '{') - i32::from(letter == '}');
        letter == ',' && depth == 0
    };
    let list = list.rsplit_once('}').expect("a closing brace").0;
    let twigs = list.split(at_comma).flat_map(branches);
    twigs.map(|twig| format!("{}{}", stem.trim(), twig.trim())).collect()
}
