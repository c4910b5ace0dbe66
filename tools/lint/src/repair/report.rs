//! What was put right, for tools.

use super::{Applied, Repaired};
use tip_runtime::printable::Printable;
use tipc::message::Lang;
use tipc::render::{push_member, push_number, push_string};

/// What stands for the level of a finding.
const LEVEL: &str = "fixed";

/// `FILE:LINE:COLUMN: fixed[CODE]: <what was done>`, one line each.
pub fn render_short(repaired: &Repaired, lang: Lang) -> String {
    let name = repaired.loaded.source.name();
    let line = |one: &Applied| {
        let (code, title) = (one.finding.id(), one.fix.title.in_lang(lang));
        let (line, column) = (one.line, one.column);
        let text = format_args!("{name}:{line}:{column}: {LEVEL}[{code}]: {title}");
        Printable::line(text).to_string() + "\n"
    };
    repaired.applied.iter().map(line).collect()
}

/// One object a line: `level` (`fixed`), `message` (what was done), `applicability`, `code`, `file`, `line`, `column`.
pub fn render_json(repaired: &Repaired, lang: Lang) -> String {
    let name = repaired.loaded.source.name();
    let object = |one: &Applied| {
        let mut out = String::from("{\"level\":");
        push_string(&mut out, LEVEL);
        push_member(
            &mut out,
            "message",
            &one.fix.title.in_lang(lang).to_string(),
        );
        push_member(&mut out, "applicability", one.fix.applicability.name());
        push_member(&mut out, "code", one.finding.id());
        push_member(&mut out, "file", name);
        push_number(&mut out, "line", one.line);
        push_number(&mut out, "column", one.column);
        out + "}\n"
    };
    repaired.applied.iter().map(object).collect()
}
