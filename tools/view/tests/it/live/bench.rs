//! A session and what asks of it.

use serde_json::{Value, json};
use tip_sim::Robot;
use tip_view::live::{Host, NoFile, Session, Setup};

/// Counts its cycles, and says which key was pressed; a step of it is a cycle of 20 ms.
pub(crate) const COUNTS: &str = "3.1\ncounts\nDEF_VAR N\nDEF_VAR K\nDEF_VAR V\nN = 0\nLOOP:\nN = N + 1\nAD_IN VR1 V\nIF KB_HIT THEN\nKEY_IN K\nMESSAGE key\nENDIF\nGOTO LOOP:\nEND\n";

pub(crate) fn session_of(text: &str) -> Session {
    let robot = Robot::named("titan8").expect("it has a name");
    Session::new(Setup::new("counts.prg", text.as_bytes(), robot)).expect("a program")
}

/// A file in memory, which may refuse.
pub(crate) struct Memory {
    pub(crate) bytes: Vec<u8>,
    pub(crate) refuses: bool,
}

impl Host for Memory {
    fn write(&mut self, bytes: &[u8]) -> Result<(), String> {
        match self.refuses {
            true => Err("the disk is full".to_owned()),
            false => {
                self.bytes = bytes.to_owned();
                Ok(())
            }
        }
    }

    fn read(&mut self) -> Result<Vec<u8>, String> {
        Ok(self.bytes.clone())
    }
}

pub(crate) fn ask(session: &mut Session, request: Value) -> Value {
    answer(session, &request.to_string(), &mut NoFile)
}

pub(crate) fn answer(session: &mut Session, request: &str, host: &mut dyn Host) -> Value {
    serde_json::from_str(&session.request(request, host)).expect("JSON")
}

#[track_caller]
pub(crate) fn does(session: &mut Session, request: Value) {
    let answer = ask(session, request);
    assert_eq!(answer, json!({"type": "answer", "ok": true}));
}

#[track_caller]
pub(crate) fn refuses(session: &mut Session, request: Value, error: &str) {
    let answer = ask(session, request.clone());
    assert_eq!(
        (&answer["ok"], &answer["error"]),
        (&json!(false), &json!(error)),
        "{request}"
    );
}
