//! Placeholders in full-width characters: `％N％`.

use super::Judged;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::message::Warning;
use crate::parse::narrow;
use crate::program::VariableKind;
use crate::source::Span;
use crate::syntax::upper_case;

const SIGNS: [char; 2] = ['%', '％'];

/// Warns of the first one that would show a VAR, were it half-width.
pub(super) fn warn(judged: &Judged<'_>, place: Span, found: &mut Findings) {
    let text = judged.source.slice(place);
    if text.is_ascii() {
        return;
    }
    let signs: Vec<(usize, &str)> = text.match_indices(SIGNS).collect();
    let wide = signs.windows(2).find_map(|pair| {
        let ((at, sign), (end, last)) = (pair[0], pair[1]);
        let whole = at..end + last.len();
        let inner = narrow(&text[at + sign.len()..end]);
        let name = upper_case(inner.split('.').next().unwrap_or_default());
        let mut vars = judged.program.variables().iter();
        let is_var = vars.any(|one| one.kind == VariableKind::Var && one.name == *name);
        (is_var && !text[whole.clone()].is_ascii()).then_some((whole, name))
    });
    if let Some((whole, name)) = wide {
        let span = Span::new(place.start + whole.start, place.start + whole.end);
        let is_told =
            |it: &Diagnostic| it.code == Code::ForeignValue && it.span.start == span.start;
        if found.iter().any(is_told) {
            return;
        }
        let finding = Diagnostic::new(Code::ForeignValue, span, Warning::NoFormat);
        found.push(
            finding
                .about(name.as_str())
                .help(Warning::ShowValue { name }),
        );
    }
}
