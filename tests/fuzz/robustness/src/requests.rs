//! Requests to a live run, one a line: each is answered, and the updates that viewers receive fit together.

use serde_json::Value;
use tip_sim::Robot;
use tip_view::live::{Host, Session, Setup, Viewer};
use tipc::source::{Encoding, Source};

/// In Shift_JIS, with a character that it spells twice, and the line ends of DOS.
const PROGRAM: &[u8] = b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\nDEF_VAR N\r\nDEF_VAR V\r\nN = 0\r\nLOOP:\r\nN = N + 1\r\nAD_IN VR1 V\r\nIF KB_HIT THEN\r\nMESSAGE %f03N%\r\nENDIF\r\nGOTO LOOP:\r\nEND\r\n\x1A";

/// One update has at most so many bytes.
const MOST: usize = 16 << 20;

/// Asks a live run for each line.
///
/// # Panics
/// An answer or an update is no JSON, or viewers disagree.
pub fn examine(bytes: &[u8]) {
    let robot = Robot::named("titan8").expect("it has a name");
    let mut session = Session::new(Setup::new("a.prg", PROGRAM, robot)).expect("it loads");
    let mut file = Memory(PROGRAM.to_vec());
    let mut often = Seen::default();
    for line in bytes.split(|byte| *byte == b'\n').take(200) {
        let text = String::from_utf8_lossy(line);
        let answer: Value = serde_json::from_str(&session.request(&text, &mut file)).expect("JSON");
        assert_eq!(answer["type"], "answer");
        assert!(answer["ok"].is_boolean(), "{answer}");
        session.advance(20.0, || true);
        often.look(&session);
        if answer["ok"] == true && text.contains("\"save\"") {
            let encodings = [Encoding::ShiftJis, Encoding::Utf8];
            let texts = encodings.map(|encoding| spelled(&file.0, encoding));
            assert!(texts.contains(&often.text), "what is saved is the text");
        }
    }
    let mut once = Seen::default();
    once.look(&session);
    assert_eq!((once.cycles, &once.text), (often.cycles, &often.text));
    assert_eq!(once.cycles, session.cycles());
}

/// Returns the text of the bytes, with LF between lines.
fn spelled(bytes: &[u8], encoding: Encoding) -> String {
    let (source, _) = Source::decode("a.prg", bytes, encoding);
    source.text().replace("\r\n", "\n").replace('\r', "\n")
}

/// A file that is only here.
struct Memory(Vec<u8>);

impl Host for Memory {
    fn write(&mut self, bytes: &[u8]) -> Result<(), String> {
        self.0 = bytes.to_vec();
        Ok(())
    }

    fn read(&mut self) -> Result<Vec<u8>, String> {
        Ok(self.0.clone())
    }
}

/// State of a viewer.
#[derive(Default)]
struct Seen {
    viewer: Viewer,
    cycles: u64,
    text: String,
}

impl Seen {
    fn look(&mut self, session: &Session) {
        while let Some(update) = session.update(&mut self.viewer) {
            assert!(update.len() < MOST, "{} bytes", update.len());
            let update: Value = serde_json::from_str(&update).expect("JSON");
            match update["type"].as_str().expect("a type") {
                "more" => self.cycles = update["cycles"].as_u64().expect("a number"),
                "text" => self.text = update["text"].as_str().expect("text").to_owned(),
                "run" | "findings" | "status" => {}
                other => panic!("{other}"),
            }
        }
    }
}
