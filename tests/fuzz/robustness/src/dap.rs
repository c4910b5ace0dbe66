//! Messages to the debug adapter, a line each.

use serde_json::{Value, json};
use tip_ide::dap::{Debuggee, Launch, Launcher, Session};
use tip_ide::transport::{self, Frame};
use tip_sim::debug::Debugger;
use tip_sim::{Events, Plant, Robot};
use tipc::message::Lang;

const PROGRAM: &str = "3.1
debugged
DEF_VAR N
DEF_POS P
N = 0
L:
GOSUB S:
MESSAGE %N%
PTP_ANGLE J11 R 1
IF N < 30 GOTO L:
KEY_IN
N = 1 / N
EXIT
S:
N += 1
TEACH_POS F1 P
RETURN
END
";

/// First messages of a client.
const BEGIN: [&str; 3] = [
    r#"{"seq":1,"type":"request","command":"initialize","arguments":{"adapterID":"tip","supportsProgressReporting":true,"supportsInvalidatedEvent":true}}"#,
    r#"{"seq":2,"type":"request","command":"launch","arguments":{"program":"debugged.prg","stopOnEntry":true}}"#,
    r#"{"seq":3,"type":"request","command":"configurationDone"}"#,
];

/// Loads one program, on any robot that has a name.
struct OneProgram(String);

impl Launcher for OneProgram {
    fn is_same_file(&self, one: &str, other: &str) -> bool {
        one == other
    }

    fn launch(&mut self, launch: &Launch, _: Lang) -> Result<Debuggee, String> {
        let name = launch.robot.as_deref().unwrap_or("titan8");
        let robot = Robot::named(name).map_err(|error| error.to_string())?;
        let robot = robot.with_plant(Plant::Echo);
        let events = launch.events.as_deref().unwrap_or_default();
        let events: Events = events.parse().map_err(|error| format!("{error}"))?;
        let others = [&launch.scene, &launch.plant, &launch.encoding];
        if others.iter().any(|given| given.is_some()) {
            return Err("there is one scene, one plant and one encoding".to_owned());
        }
        let mut loaded = tipc::load("debugged.prg", self.0.as_bytes(), &robot.options());
        let program = loaded.program.take().ok_or("it is wrong")?;
        let debugger = Debugger::new(program, &robot).map_err(|error| error.to_string())?;
        let debugger = debugger.with_events(&events);
        Ok(Debuggee {
            debugger: debugger.map_err(|refused| refused.to_string())?,
            source: loaded.source,
            path: launch.program.clone(),
            warnings: String::new(),
        })
    }
}

/// No message stops the adapter, and all that it sends are messages.
///
/// # Panics
/// Error for output that is no message.
pub fn examine(bytes: &[u8]) {
    let mut session = Session::new(OneProgram(PROGRAM.to_owned()));
    let begin = BEGIN.iter().map(|message| message.as_bytes());
    for message in begin.chain(bytes.split(|byte| *byte == b'\n')) {
        session.handle(message);
        for _ in 0..4 {
            if session.is_running() {
                session.work();
            }
        }
        judge(&session.take_output());
        if session.is_over() {
            break;
        }
    }
    let mut stream = bytes;
    while let Ok(Some(frame)) = transport::read(&mut stream) {
        match frame {
            Frame::Message(message) => session.handle(&message),
            Frame::Malformed(_) => session.handle_malformed(),
        }
        judge(&session.take_output());
    }
    let mut whole = Vec::new();
    let written = transport::write(&mut whole, "{}");
    assert!(written.is_ok() && transport::read(&mut &whole[..]).is_ok());
}

fn judge(sent: &[String]) {
    for message in sent {
        let message: Value = serde_json::from_str(message).expect("what is sent is JSON");
        let kind = message["type"].as_str();
        assert!(matches!(kind, Some("response" | "event")), "{message}");
        assert!(message["seq"].is_i64(), "{message}");
    }
}

/// Debugs a program: sets a breakpoint with a condition on every line, runs, and asks about each text. Returns false if the
/// program has errors.
///
/// # Panics
/// Error for output that is no message.
pub fn debug(program: &str, asked: &[&str]) -> bool {
    let mut session = Session::new(OneProgram(program.to_owned()));
    for message in BEGIN {
        session.handle(message.as_bytes());
    }
    let lines = 1..=program.lines().count();
    let breakpoints = lines.map(|line| json!({ "line": line, "condition": asked.first() }));
    let breakpoints: Vec<Value> = breakpoints.collect();
    let set = json!({ "source": { "path": "debugged.prg" }, "breakpoints": breakpoints });
    let list = json!({ "variablesReference": 1 });
    let mut requests = vec![("setBreakpoints", set.clone()), ("setBreakpoints", set)];
    requests.extend([
        ("variables", list),
        ("stackTrace", json!({ "threadId": 1 })),
    ]);
    requests.push(("continue", json!({ "threadId": 1 })));
    requests.extend(
        asked
            .iter()
            .map(|text| ("evaluate", json!({ "expression": text }))),
    );
    let mut is_loaded = true;
    for (command, arguments) in requests {
        let request =
            json!({ "seq": 9, "type": "request", "command": command, "arguments": arguments });
        session.handle(request.to_string().as_bytes());
        if session.is_running() {
            session.work();
        }
        let sent = session.take_output();
        is_loaded &= !sent.iter().any(|message| message.contains("it is wrong"));
        judge(&sent);
    }
    is_loaded
}
