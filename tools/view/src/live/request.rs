//! Requests of viewers and the answers, among them language features of the page's editor: diagnostics, hovers and completions.

use super::MOST_BYTES;
use super::driver::Sign;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use tip_ide::Document;
use tip_sim::Event;
use tipc::Loaded;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::source::{Position, Source, Span, Unit};

/// The key that stops a robot.
const RETURN_KEY: u8 = 0x0D;

/// A request that was read.
#[derive(Clone, Debug)]
pub struct ClientRequest {
    pub(super) id: Option<u32>,
    pub(super) request: Result<Request, Refusal>,
}

impl ClientRequest {
    /// Reads a request, a JSON object. Nothing that is sent does harm: what is no request will be refused.
    pub fn read(text: &str) -> Self {
        let (id, request) = read(text);
        ClientRequest { id, request }
    }

    /// Returns true for an emergency stop, which nothing may keep waiting.
    pub fn is_stop(&self) -> bool {
        matches!(&self.request, Ok(Request::Event { event }) if is_stop(event))
    }

    /// Returns true if the robot may move again because of it: not after an emergency stop that
    /// came later.
    pub fn moves(&self) -> bool {
        matches!(
            self.request,
            Ok(Request::Play {}
                | Request::Step { .. }
                | Request::Go { .. }
                | Request::Restart {}
                | Request::Reload {})
        )
    }

    /// Returns what a viewer of a robot on servos does as its driver, if it is such a request.
    pub fn driving(&self) -> Option<Driving> {
        match self.request.as_ref().ok()? {
            Request::Take {} => Some(Driving::Take),
            Request::Give {} => Some(Driving::Give),
            Request::Drive(sign) => Some(Driving::Sign(*sign)),
            Request::Pause {} => Some(Driving::Pause),
            Request::Play {} => Some(Driving::Resume),
            _ => None,
        }
    }

    /// Answers that it was done.
    pub fn done(&self) -> String {
        Answer::new(self.id, Ok(None)).text()
    }

    /// Answers without doing it: the viewer does not drive the robot.
    pub fn refused_watching(&self) -> String {
        Answer::new(self.id, refuse("watching")).text()
    }

    /// Answers without doing it: the robot moves only while the button is held.
    pub fn refused_hold(&self) -> String {
        Answer::new(self.id, refuse("hold")).text()
    }

    /// Answers without doing it: there are too many requests.
    pub fn refused_many(&self) -> String {
        Answer::new(self.id, refuse("many")).text()
    }

    /// Answers without doing it: the robot was stopped after it was asked for.
    pub fn refused_stopped(&self) -> String {
        Answer::new(self.id, refuse("over")).text()
    }
}

/// A request of a driver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Driving {
    /// Takes the robot, or asks its holder for it.
    Take,
    /// Hands the robot to the viewer that asks for it.
    Give,
    /// A sign of life.
    Sign(Sign),
    /// Pauses the robot.
    Pause,
    /// Ends a pause.
    Resume,
}

/// Returns true if an event is an emergency stop.
pub(super) fn is_stop(event: &Event) -> bool {
    *event == Event::Key(RETURN_KEY)
}

/// A request without its number.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(tag = "do", rename_all = "lowercase", deny_unknown_fields)]
pub(super) enum Request {
    /// The run goes on.
    Play {},
    /// The run rests.
    Pause {},
    /// Steps a number of cycles forward, or back if negative; then the run rests.
    Step { cycles: i64 },
    /// Goes to the end of a cycle that has been; then it rests.
    Go { cycle: u64 },
    /// Sets the speed, as a multiple of the robot's own.
    Speed { times: f64 },
    /// Something happens before the next step.
    Event { event: Event },
    /// Runs the text of the editor from the beginning.
    Restart {},
    /// Another text in the place of the version `base`, by the viewer who calls itself `by`.
    Edit { text: String, base: u64, by: String },
    /// Writes the text to the file.
    Save {},
    /// Takes the text of the file.
    Reload {},
    /// Asks for the documentation of the word at a place.
    Hover { at: Place },
    /// Asks for the completions at a place.
    Complete { at: Place },
    /// Takes the robot, or asks its holder for it.
    Take {},
    /// Hands the robot to the viewer that asks for it.
    Give {},
    /// A sign of life of the page that drives.
    Drive(Sign),
}

/// The reason why a request is refused: a word that the page translates, and perhaps its subject.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Refusal {
    pub(super) error: &'static str,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub(super) detail: String,
}

/// Refuses without details.
pub(super) fn refuse<T>(error: &'static str) -> Result<T, Refusal> {
    refuse_since(error, "")
}

/// Refuses, with the subject.
pub(super) fn refuse_since<T>(error: &'static str, detail: impl ToString) -> Result<T, Refusal> {
    let detail = detail.to_string();
    Err(Refusal { error, detail })
}

/// An answer to one viewer.
#[derive(Serialize)]
pub(super) struct Answer {
    r#type: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<u32>,
    ok: bool,
    #[serde(flatten)]
    known: Option<LanguageAnswer>,
    #[serde(flatten)]
    refusal: Option<Refusal>,
}

impl Answer {
    pub(super) fn new(id: Option<u32>, result: Result<Option<LanguageAnswer>, Refusal>) -> Self {
        let ok = result.is_ok();
        let (known, refusal) = match result {
            Ok(known) => (known, None),
            Err(refusal) => (None, Some(refusal)),
        };
        Answer {
            r#type: "answer",
            id,
            ok,
            known,
            refusal,
        }
    }

    /// Returns it as JSON.
    pub(super) fn text(&self) -> String {
        // No value of it can fail to be written.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// Reads a request; its number is there if any could be found.
fn read(text: &str) -> (Option<u32>, Result<Request, Refusal>) {
    if text.len() > MOST_BYTES {
        return (None, refuse("long"));
    }
    let mut members: Map<String, Value> = match serde_json::from_str(text) {
        Ok(members) => members,
        Err(error) => return (None, refuse_since("malformed", error)),
    };
    let id = match members.remove("id").map(serde_json::from_value) {
        None => None,
        Some(Ok(id)) => Some(id),
        Some(Err(error)) => return (None, refuse_since("malformed", error)),
    };
    let request = serde_json::from_value(Value::Object(members));
    (id, request.or_else(|error| refuse_since("unknown", error)))
}

/// Maximum number of completions in one answer.
const MAX_COMPLETIONS: usize = 2000;

/// A line and a column from 1, the column in units of UTF-16.
pub(super) type Place = [u32; 2];

/// An answer about the text, under the name of the question.
#[derive(Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum LanguageAnswer {
    /// Documentation of a word, if there is one.
    Hover(Option<Hover>),
    /// Completions.
    Offers(Vec<CompletionItem>),
}

#[derive(Debug, Serialize)]
pub(super) struct Hover {
    from: Place,
    to: Place,
    /// Markdown, in English and Japanese.
    text: [String; 2],
}

#[derive(Debug, Serialize)]
pub(super) struct CompletionItem {
    label: String,
    detail: String,
    /// Description in English and Japanese.
    description: [&'static str; 2],
    /// Start of the text that is replaced.
    from: Place,
    to: Place,
    /// Replacement, as a snippet of the Language Server Protocol if it has places to fill.
    text: String,
    fills: bool,
}

/// Returns the documentation of the word at a place.
pub(super) fn hover(document: &Document, place: Place) -> LanguageAnswer {
    let at = offset(document.source(), place);
    let [english, japanese] = [Lang::English, Lang::Japanese].map(|lang| document.hover(at, lang));
    LanguageAnswer::Hover(english.zip(japanese).map(|(english, japanese)| {
        let [from, to] = ends(document.source(), english.span);
        Hover {
            from,
            to,
            text: [english.text, japanese.text],
        }
    }))
}

/// Returns the completions at a place.
pub(super) fn completions(document: &Document, place: Place) -> LanguageAnswer {
    let source = document.source();
    let completions = document.complete(offset(source, place)).into_iter();
    let shown = completions.take(MAX_COMPLETIONS).map(|offer| {
        let [from, to] = ends(source, offer.span);
        CompletionItem {
            label: offer.label,
            detail: offer.detail,
            description: [offer.description.english, offer.description.japanese],
            from,
            to,
            fills: offer.snippet.is_some(),
            text: offer.snippet.unwrap_or(offer.text),
        }
    });
    LanguageAnswer::Offers(shown.collect())
}

fn offset(source: &Source, [line, column]: Place) -> usize {
    source.offset(Position { line, column }, Unit::Utf16)
}

fn ends(source: &Source, span: Span) -> [Place; 2] {
    [span.start, span.end].map(|offset| {
        let Position { line, column } = source.position(offset, Unit::Utf16);
        [line, column]
    })
}

/// Maximum number of diagnostics.
const MAX_DIAGNOSTICS: usize = 200;

/// One diagnostic. Places are lines and columns from 1, columns in units of UTF-16. Texts are in English and Japanese.
#[derive(Clone, Debug, Serialize)]
pub(super) struct PageDiagnostic {
    level: &'static str,
    code: &'static str,
    from: Place,
    to: Place,
    text: [String; 2],
    help: Option<[String; 2]>,
    classical: String,
}

/// Returns all diagnostics of a program, but for the last of very many.
pub(super) fn findings(loaded: &Loaded) -> Vec<PageDiagnostic> {
    let found = loaded.diagnostics.iter().take(MAX_DIAGNOSTICS);
    found
        .map(|one| PageDiagnostic::of(one, &loaded.source))
        .collect()
}

impl PageDiagnostic {
    fn of(diagnostic: &Diagnostic, source: &Source) -> Self {
        let [from, to] = ends(source, diagnostic.span);
        let both = |text: &dyn Fn(Lang) -> String| [Lang::English, Lang::Japanese].map(text);
        PageDiagnostic {
            level: diagnostic.level().name(),
            code: diagnostic.id(),
            from,
            to,
            text: both(&|lang| diagnostic.headline(lang)),
            help: diagnostic
                .help
                .as_ref()
                .map(|help| both(&|lang| help.in_lang(lang).to_string())),
            classical: diagnostic.message(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_of_life_is_read() {
        let asked = ClientRequest::read(r#"{"do":"drive","press":3,"sticks":[5,0,10]}"#);
        let sign = Sign {
            press: 3,
            sticks: [5.0, 0.0, 10.0],
        };
        assert_eq!(asked.driving(), Some(Driving::Sign(sign)), "{asked:?}");
        for wrong in [
            r#"{"do":"drive","press":-1,"sticks":[5,5,5]}"#,
            r#"{"do":"drive","press":1,"sticks":[5,5]}"#,
            r#"{"do":"drive","press":1,"sticks":[5,5,null]}"#,
            r#"{"do":"drive","press":1,"sticks":[5,5,5],"arm":true}"#,
            r#"{"do":"drive","press":1}"#,
        ] {
            assert_eq!(ClientRequest::read(wrong).driving(), None, "{wrong}");
        }
    }
}
