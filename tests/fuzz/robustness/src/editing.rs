//! Answers to editors: positions inside the text, and changes after which the program is what it was or better.

use tip_ide::{Document, Edit};
use tipc::language::names;
use tipc::message::Lang;
use tipc::source::Span;
use tipc::{Options, Robot};

/// The most places at which a text is asked about.
const PLACES: usize = 20;

/// Asks everything at places all over the text.
///
/// # Panics
/// A place is not of the text, changes overlap, or a change has a new finding.
pub fn examine(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    for robot in [Robot::Titan8, Robot::Hand] {
        let options = Options {
            robot,
            ..Options::default()
        };
        let document = Document::new("random.prg", &text, &options);
        whole(&document, &options);
        let length = text.len();
        let step = length / PLACES + 1;
        for offset in (0..=length).step_by(step) {
            asked(&document, &options, offset);
        }
    }
}

fn whole(document: &Document, options: &Options) {
    let text = document.source().text();
    let all = Span::new(0, text.len());
    for one in document.outline() {
        inside(text, one.span);
        inside(text, one.name_span);
    }
    let lines = document.source().line_count();
    for fold in document.folds() {
        assert!(fold.first < fold.last && fold.last <= lines, "{fold:?}");
    }
    let mut end = 0;
    for token in document.semantic_tokens(all) {
        inside(text, token.span);
        assert!(end <= token.span.start, "{token:?}");
        assert!(!document.source().slice(token.span).contains(['\n', '\r']));
        end = token.span.end;
    }
    for hint in document.inlay_hints(all) {
        inside(text, Span::new(hint.at, hint.at));
    }
    if let Ok(edits) = document.format() {
        let formatted = changed(document, &edits, options);
        assert_eq!(formatted.format(), Ok(Vec::new()), "{text}");
    }
    if let Some(action) = document.fix_all() {
        changed(document, &action.edits, options);
    }
}

fn asked(document: &Document, options: &Options, offset: usize) {
    let text = document.source().text();
    for lang in Lang::ALL {
        if let Some(hover) = document.hover(offset, *lang) {
            inside(text, hover.span);
        }
    }
    for offer in document.complete(offset) {
        inside(text, offer.span);
        assert!(offer.span.start <= offset, "{offer:?}");
    }
    if let Some(found) = document.signatures(offset) {
        for form in &found.forms {
            form.arguments
                .iter()
                .for_each(|span| inside(&form.text, *span));
        }
    }
    document
        .definition(offset)
        .into_iter()
        .for_each(|span| inside(text, span));
    let references = document.references(offset, true);
    references.iter().for_each(|it| inside(text, it.span));
    if let Ok(edits) = document.rename(offset, "Another_Name") {
        assert_eq!(edits.len(), references.len(), "{text}");
        let after = changed(document, &edits, options);
        let (before, after) = (document.loaded(), after.loaded());
        let is_same = before.program.is_some() == after.program.is_some();
        // A name that was too long may be all that was wrong.
        let was_long = edits
            .iter()
            .any(|it| it.span.end - it.span.start > names::LIMIT);
        assert!(is_same || was_long && after.program.is_some(), "{text}");
    }
    let before = document.loaded().diagnostics.len();
    for action in document.code_actions(Span::new(offset, offset)) {
        let after = changed(document, &action.edits, options);
        let is_sound = document.loaded().program.is_some();
        assert!(!is_sound || after.loaded().program.is_some(), "{text}");
        assert!(action.diagnostic.is_some_and(|index| index < before));
    }
}

/// The program after a change.
fn changed(document: &Document, edits: &[Edit], options: &Options) -> Document {
    let text = document.source().text();
    let mut out = String::new();
    let mut at = 0;
    for edit in edits {
        inside(text, edit.span);
        assert!(at <= edit.span.start, "{edits:?}");
        out += &text[at..edit.span.start];
        out += &edit.text;
        at = edit.span.end;
    }
    out += &text[at..];
    Document::new("random.prg", &out, options)
}

fn inside(text: &str, span: Span) {
    assert!(text.get(span.start..span.end).is_some(), "{span:?}");
}
