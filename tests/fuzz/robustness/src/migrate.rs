//! Older programs: every byte given back, a result or questions, and a result that needs no second migration.

use crate::lossless::given_back;
use tip_lint::migrate::{migrate, render_human, render_json, render_short};
use tipc::message::Lang;
use tipc::source::{Encoding, Source};

/// Migrates the bytes in each encoding.
///
/// # Panics
/// Bytes are lost, there is neither a result nor a question, or the result is not of the present version.
pub fn examine(bytes: &[u8]) {
    for encoding in [Encoding::Auto, Encoding::Utf8, Encoding::ShiftJis] {
        let (source, _) = Source::decode("old.prg", bytes, encoding);
        assert!(given_back(&source) == bytes, "{bytes:x?}");
        let Ok(migration) = migrate("old.prg", bytes, encoding) else {
            continue;
        };
        let seen = String::from_utf8_lossy(bytes);
        for note in migration.notes() {
            assert!(note.line >= 1 && note.column >= 1, "{note:?}: {seen}");
        }
        let asks = migration.questions().next().is_some();
        assert_eq!(migration.bytes().is_none(), asks, "{seen}");
        for lang in Lang::ALL {
            render_human(&migration, *lang);
            render_json(&migration, *lang);
            render_short(&migration, *lang);
        }
        if let Some(new) = migration.bytes() {
            let again = migrate("new.prg", new, encoding).expect("text stays text");
            assert_eq!(again.notes(), [], "{seen}");
            assert_eq!(again.bytes(), Some(new), "{seen}");
        }
    }
}
