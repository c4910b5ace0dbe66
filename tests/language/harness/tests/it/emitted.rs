//! Golden output, to the byte. The test `golden` of `tip-tests` compiles the files in `golden`; after
//! a wanted change `TIP_BLESS=1` writes them anew, for a person to read.
#![expect(clippy::disallowed_methods, reason = "goldens are files")]

use std::fs;
use tip_harness::root;

fn generated(name: &str) -> String {
    let folder = std::env::temp_dir().join(format!("tip-golden-{}-{name}", std::process::id()));
    let source = root().join("../codegen/golden").join(format!("{name}.prg"));
    tipc::Config::new()
        .out_dir(&folder)
        .compile(&[source])
        .unwrap_or_else(|error| panic!("{error}"));
    let text = fs::read_to_string(folder.join(format!("{name}.rs"))).unwrap();
    fs::remove_dir_all(folder).unwrap();
    text
}

fn check(name: &str) {
    let path = root().join("../codegen/golden").join(format!("{name}.rs"));
    let text = generated(name);
    if std::env::var_os("TIP_BLESS").is_some() {
        fs::write(path, text).unwrap();
        return;
    }
    let golden = fs::read_to_string(path).unwrap();
    let differs = golden.lines().zip(text.lines()).position(|(a, b)| a != b);
    assert!(
        golden == text,
        "line {:?} of {name}.rs is another one",
        differs.map(|n| n + 1)
    );
}

#[test]
fn counting_looks_as_agreed() {
    check("counting");
}

#[test]
fn branches_look_as_agreed() {
    check("branches");
}

#[test]
fn motion_looks_as_agreed() {
    check("motion");
}
