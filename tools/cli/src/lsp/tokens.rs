//! Classes of words as the protocol packs them.

use super::places::Places;
use gen_lsp_types::SemanticToken;
use tip_ide::{Paint, Painted};

/// What each class is called in the protocol.
pub(crate) fn legend() -> Vec<&'static str> {
    Paint::ALL.map(name).to_vec()
}

/// What may be said of a word besides.
pub(crate) const MODIFIERS: [&str; 2] = ["declaration", "modification"];

const fn name(paint: Paint) -> &'static str {
    match paint {
        Paint::Keyword => "keyword",
        Paint::Command => "function",
        Paint::Function => "method",
        Paint::Flag => "event",
        Paint::Constant => "enumMember",
        Paint::Modifier => "modifier",
        Paint::Variable => "variable",
        Paint::Member => "property",
        Paint::Label => "label",
        Paint::Number => "number",
        Paint::Text => "string",
        Paint::Comment => "comment",
        Paint::Operator => "operator",
    }
}

/// Each token counts from the one before.
pub(crate) fn tokens(painted: &[Painted], places: Places) -> Vec<SemanticToken> {
    let mut line = 0;
    let mut start = 0;
    let tokens = painted.iter().map(|it| {
        let range = places.range(it.span);
        let delta_line = range.start.line - line;
        let before = if delta_line == 0 { start } else { 0 };
        (line, start) = (range.start.line, range.start.character);
        let place = Paint::ALL.iter().position(|paint| *paint == it.paint);
        SemanticToken {
            delta_line,
            delta_start: start - before,
            length: range.end.character - range.start.character,
            token_type: place.unwrap_or_default() as u32,
            token_modifiers_bitset: u32::from(it.declares) | u32::from(it.assigns) << 1,
        }
    });
    tokens.collect()
}
