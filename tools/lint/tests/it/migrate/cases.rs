//! Whole programs: `NAME.old.prg` becomes `NAME.new.prg`, which loads for the robots that `NAME.report` names in its
//! first line, with the changes that the other lines list.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use tip_lint::migrate::{migrate, render_short};
use tipc::message::Lang;
use tipc::source::Encoding;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/migrate/cases")
}

fn read(name: &str, end: &str) -> Vec<u8> {
    let path = folder().join(format!("{name}.{end}"));
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn names() -> BTreeSet<String> {
    let entries = fs::read_dir(folder()).expect("the cases exist");
    let files = entries.map(|entry| entry.expect("readable").file_name());
    let name = |file: std::ffi::OsString| {
        let file = file.into_string().expect("plain names");
        file.split('.').next().map(str::to_owned)
    };
    files.filter_map(name).collect()
}

// clauses: 10.1
#[test]
fn whole_programs() {
    let names = names();
    assert!(names.len() >= 4, "{names:?}");
    for name in &names {
        case(name);
    }
}

fn case(name: &str) {
    let report = String::from_utf8(read(name, "report")).expect("UTF-8");
    let (robots, report) = report.split_once('\n').expect("a first line");
    let migration = migrate(name, &read(name, "old.prg"), Encoding::Auto).expect("this is text");
    assert_eq!(
        render_short(&migration, Lang::English).replace(&format!("{name}:"), ""),
        report,
        "{name}"
    );
    let new = read(name, "new.prg");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert_eq!(
        text(migration.bytes().unwrap_or_default()),
        text(&new),
        "{name}"
    );
    let loads: Vec<&str> = migration
        .robots()
        .iter()
        .map(|robot| robot.name())
        .collect();
    assert_eq!(format!("# {}", loads.join(" ")), robots, "{name}");
    let again = migrate(name, &new, Encoding::Auto).expect("this is text");
    assert_eq!(again.notes(), [], "{name}");
    assert_eq!(again.bytes(), Some(&new[..]), "{name}");
}
