//! What runs in CI and makes a release is fixed and proved: each action is named by the hash of its commit, a release is checked
//! against known faults of crates, has sums, and is signed by the workflow that built it.

use std::fs::read_to_string;
use std::path::Path;

/// What is wrong with the lines of a workflow.
fn faults(text: &str) -> Vec<String> {
    let code = text.lines().map(|line| line.split(" #").next().unwrap_or_default().trim()).collect::<Vec<_>>();
    // A command may go on in the next line.
    let whole = code.join(" ");
    let mut faults: Vec<String> = code.iter().filter_map(|line| unpinned(line)).collect();
    for (pattern, why) in
        [("--privileged", "a container with all rights"), ("--cap-add", "a container with more rights")]
    {
        faults.extend(whole.contains(pattern).then(|| format!("{pattern}: {why}")));
    }
    let fetchers = ["curl", "wget"];
    let pipes = whole.split('|').collect::<Vec<_>>();
    let is_shell = |command: &str| {
        let mut words = command.split_whitespace().skip_while(|word| ["sudo", "env"].contains(word));
        words.next().is_some_and(|word| ["sh", "bash", "python", "python3"].contains(&word))
    };
    let into_shell = pipes.windows(2).any(|two| fetchers.iter().any(|name| two[0].contains(name)) && is_shell(two[1]));
    faults.extend(into_shell.then(|| "what is fetched is run unseen".to_string()));
    faults
}

/// An action that is not named by a commit, with its version beside it.
fn unpinned(line: &str) -> Option<String> {
    let action = line.trim_start_matches("- ").strip_prefix("uses:")?.trim();
    let hash = action.split_once('@').map_or("", |(_, at)| at);
    let is_hash = hash.len() == 40 && hash.bytes().all(|byte| byte.is_ascii_hexdigit());
    (!is_hash && !action.starts_with("./")).then(|| format!("{action} is not a commit of 40 hexadecimal digits"))
}

fn read(path: &str) -> String {
    read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect(path)
}

#[test]
fn workflows_run_what_is_fixed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(".github/workflows");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("workflows") {
        let path = entry.expect("an entry").path();
        let text = read_to_string(&path).expect("a workflow");
        assert_eq!(faults(&text), Vec::<String>::new(), "{}", path.display());
        for line in text.lines().filter(|line| line.contains("uses:")) {
            assert!(line.contains(" # v"), "{}: the version of {line}", path.display());
        }
        count += 1;
    }
    assert!(count >= 3, "{count} workflows");
    let found = faults(
        "- uses: actions/checkout@v4\n- uses: a/b@0123456789abcdef0123456789abcdef01234567 # v1\n\
         options: --privileged # for tests\nrun: |\n  curl -sSf https://sh.rustup.rs |\n    sudo sh -s -- -y",
    );
    assert_eq!(found.len(), 3, "{found:?}");
    assert_eq!(faults("- run: curl https://x.org | jq . # curl | sh\n"), Vec::<String>::new());
}

#[test]
fn a_release_is_checked_and_signed_and_has_sums() {
    for (file, parts) in [
        (
            ".github/workflows/release.yml",
            &[
                "make release",
                "in_debian.sh release",
                "sha256sum --strict -c SHA256SUMS",
                "uses: actions/attest@",
                "subject-path: dist/*",
                "id-token: write",
                "attestations: write",
            ][..],
        ),
        ("packaging/release.py", &["\"supply-chain\", "]),
        ("tests/harden/harden.mk", &["deny --locked check advisories"]),
        ("deny.toml", &["\n[advisories]\n"]),
        ("packaging/dist.py", &["write_sums(out)"]),
    ] {
        let text = read(file);
        parts.iter().for_each(|part| assert!(text.contains(part), "{file} has no '{part}'"));
    }
}

#[test]
fn ci_looks_for_known_faults_every_week() {
    let ci = read(".github/workflows/ci.yml");
    let cron = ci.lines().find_map(|line| line.trim().strip_prefix("- cron: \"")).expect("a schedule");
    let day = cron.split('"').next().and_then(|cron| cron.split_whitespace().nth(4)).expect("a day of the week");
    assert!(day != "*" && ci.contains("run: make supply-chain"), "{cron}");
}
