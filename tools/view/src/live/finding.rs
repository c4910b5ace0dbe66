//! What is found in the program, for an editor.

use serde::Serialize;
use tipc::Loaded;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::source::{Position, Source, Unit};

/// More are of no use to anyone.
const MOST: usize = 200;

/// One finding. Places are lines and columns from 1, columns in units of UTF-16. Texts are in English and Japanese.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Finding {
    level: &'static str,
    code: &'static str,
    from: [u32; 2],
    to: [u32; 2],
    text: [String; 2],
    help: Option<[String; 2]>,
    classical: String,
}

/// All of a program, but for the last of very many.
pub(super) fn findings(loaded: &Loaded) -> Vec<Finding> {
    let found = loaded.diagnostics.iter().take(MOST);
    found.map(|one| Finding::of(one, &loaded.source)).collect()
}

impl Finding {
    fn of(diagnostic: &Diagnostic, source: &Source) -> Self {
        let place = |offset| {
            let Position { line, column } = source.position(offset, Unit::Utf16);
            [line, column]
        };
        let both = |text: &dyn Fn(Lang) -> String| [Lang::English, Lang::Japanese].map(text);
        Finding {
            level: diagnostic.level().name(),
            code: diagnostic.id(),
            from: place(diagnostic.span.start),
            to: place(diagnostic.span.end),
            text: both(&|lang| diagnostic.headline(lang)),
            help: diagnostic
                .help
                .as_ref()
                .map(|help| both(&|lang| help.in_lang(lang).to_string())),
            classical: diagnostic.message(),
        }
    }
}
