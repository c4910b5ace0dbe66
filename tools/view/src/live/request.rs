//! Requests of viewers.

use super::language_service::{LanguageAnswer, Place};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use tip_sim::Event;

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

    /// Answers without doing it: there are too many requests.
    pub fn refused_many(&self) -> String {
        Answer::new(self.id, refuse("many")).text()
    }

    /// Answers without doing it: the robot was stopped after it was asked for.
    pub fn refused_stopped(&self) -> String {
        Answer::new(self.id, refuse("over")).text()
    }
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
    if text.len() > super::MOST_BYTES {
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
