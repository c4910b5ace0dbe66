//! Checks of the editor's text and answers about it, which may take long and so are kept out of the run.

use super::language_service::{self, LanguageAnswer, PageDiagnostic, findings};
use super::request::{Answer, ClientRequest, Request};
use tip_ide::Document;
use tip_sim::Robot;
use tipc::{Loaded, Options};

/// A text that is still to be checked.
#[derive(Debug)]
pub struct UncheckedText {
    pub(super) version: u64,
    pub(super) name: String,
    pub(super) bytes: Vec<u8>,
    pub(super) options: Options,
}

/// Result of reading a text.
#[derive(Debug, Default)]
pub struct CheckedText {
    pub(super) version: u64,
    pub(super) findings: Vec<PageDiagnostic>,
    /// None if there are errors in it.
    pub(super) program: Option<Box<Loaded>>,
}

/// A checker of texts, which keeps the last one.
#[derive(Debug)]
pub struct TextChecker {
    robot: Robot,
    document: Option<Document>,
}

impl TextChecker {
    /// Creates a checker for programs of a robot.
    pub fn new(robot: Robot) -> Self {
        TextChecker {
            robot,
            document: None,
        }
    }

    /// Checks a text.
    pub fn read(&mut self, unchecked: UncheckedText) -> CheckedText {
        let UncheckedText {
            version,
            name,
            bytes,
            options,
        } = unchecked;
        let mut loaded = tip_lint::load(&name, &bytes, &options);
        self.robot.warn(&mut loaded);
        let reading = CheckedText {
            version,
            findings: findings(&loaded),
            program: loaded.program.is_some().then(|| Box::new(loaded.clone())),
        };
        self.document = Some(Document::of(loaded, &options));
        reading
    }

    /// Answers what an editor asks about the last text; none if something else is asked.
    pub fn answer(&self, asked: &ClientRequest) -> Option<String> {
        let document = self.document.as_ref();
        let known: Option<LanguageAnswer> = match &asked.request {
            Ok(Request::Hover { at }) => document.map(|it| language_service::hover(it, *at)),
            Ok(Request::Complete { at }) => {
                document.map(|it| language_service::completions(it, *at))
            }
            _ => return None,
        };
        Some(Answer::new(asked.id, Ok(known)).text())
    }
}
