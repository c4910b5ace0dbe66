//! Decoder, parser and checker: every byte given back, places inside the text, a program exactly when nothing is wrong.

use crate::lossless::given_back;
use tip_lint::{listing, load};
use tipc::code::Level;
use tipc::message::Lang;
use tipc::render::{self, Style};
use tipc::{Options, Robot};

/// Loads the bytes for each robot.
///
/// # Panics
/// Contradiction in the compiler's answer.
pub fn examine(bytes: &[u8]) {
    for robot in Robot::ALL {
        let options = Options {
            robot: *robot,
            ..Options::default()
        };
        let loaded = load("random.prg", bytes, &options);
        let text = loaded.source.text();
        let seen = String::from_utf8_lossy(bytes);
        assert!(given_back(&loaded.source) == bytes, "{seen}");
        let mut last = 0;
        for diagnostic in &loaded.diagnostics {
            assert!(diagnostic.span.start >= last, "order: {seen}");
            last = diagnostic.span.start;
            let labels = diagnostic.labels.iter().map(|label| label.span);
            for span in [diagnostic.span].into_iter().chain(labels) {
                assert!(text.get(span.start..span.end).is_some(), "{span:?}: {seen}");
            }
            for lang in Lang::ALL {
                let style = Style::default().lang(*lang);
                assert!(!render::short(&loaded.source, diagnostic, *lang).is_empty());
                assert!(!render::json(&loaded.source, diagnostic, loaded.robot, *lang).is_empty());
                assert!(!render::human(&loaded.source, diagnostic, style).is_empty());
            }
        }
        let wrong = loaded
            .diagnostics
            .iter()
            .any(|one| one.level() == Level::Error);
        assert_eq!(loaded.program.is_none(), wrong, "{seen}");
        if let Some(program) = loaded.program {
            let lines = listing::formal(&loaded.source, &loaded.module)
                .lines()
                .count();
            assert_eq!(lines, program.steps().len(), "{seen}");
        }
    }
}
