//! Names of files and paths, in generated code, in what is reported, and in what a build script tells Cargo.

use tip_lint::migrate;
use tip_runtime::printable::is_control;
use tipc::emit::{self, pretty};
use tipc::message::Lang;
use tipc::render::Style;
use tipc::source::Encoding;
use tipc::{Options, load, render};

const GOOD: &[u8] =
    b"3.1\ntitle\nDEF_VAR V\nL1: V = 1\nPTP_ANGLE J11 V\nMESSAGE %V%\nGOTO L1:\nEND\n";
const BAD: &[u8] = b"3.1\ntitle\nFOO\nL1:\nL1:\nEND\n";
const OLD: &[u8] = b"2.0\ntitle\nVAR1 = - VAR2\nFOO\nEND\n";

/// Calls files by the bytes: a program, one with errors, and one of an older version.
///
/// # Panics
/// The name changes the code, or what is reported has something in it that acts or forges a line.
pub fn examine(bytes: &[u8]) {
    let name = String::from_utf8_lossy(bytes);
    compiled(&name);
    let loaded = load(&name, BAD, &Options::default());
    for finding in &loaded.diagnostics {
        require_plain(
            &render::human(&loaded.source, finding, Style::default()),
            &name,
        );
        let short = render::short(&loaded.source, finding, Lang::English);
        assert!(!short.contains('\n'), "{name:?}: {short:?}");
        require_plain(&short, &name);
        let json = render::json(&loaded.source, finding, loaded.robot, Lang::English);
        assert!(!json.contains('\n'), "{name:?}: {json:?}");
    }
    if let Ok(migration) = migrate::migrate(&name, OLD, Encoding::Utf8) {
        let short = migrate::render_short(&migration, Lang::English);
        assert_eq!(short.lines().count(), migration.notes().len(), "{name:?}");
        require_plain(&short, &name);
        require_plain(&migrate::render_human(&migration, Lang::English), &name);
    }
}

/// The code is that of a plain name but for the lines that spell the name.
fn compiled(name: &str) {
    let code = |name: &str| {
        let program = load(name, GOOD, &Options::default()).program;
        let program = program.expect("a program loads by any name");
        let spelling = emit::Options {
            name: Some(emit::Options::default().name_for("plain.prg")),
            ..emit::Options::default()
        };
        // What a name becomes as a type has to be an identifier.
        assert!(
            !emit::Options::default()
                .name_for(name)
                .to_string()
                .is_empty()
        );
        let text = pretty(&program, &spelling);
        text.unwrap_or_else(|error| panic!("{error}: {name:?}"))
    };
    let (code, plain) = (code(name), code("plain.prg"));
    require_plain(&code, name);
    assert_eq!(
        code.lines().count(),
        plain.lines().count(),
        "{name:?}: {code}"
    );
    for (line, plain) in code.lines().zip(plain.lines()) {
        let spells = plain.contains("plain.prg") || plain.contains("source hash");
        let is_comment = |line: &str| line.trim_start().starts_with("//");
        assert!(line == plain || spells, "{name:?}: {line}");
        assert_eq!(is_comment(line), is_comment(plain), "{name:?}: {line}");
    }
}

fn require_plain(text: &str, name: &str) {
    let found = text
        .chars()
        .find(|char| is_control(*char) && !matches!(char, '\n' | '\t'));
    assert_eq!(found, None, "{name:?}: {text:?}");
}
