//! The Debug Adapter Protocol over any transport: a debugger for editors. This module serves a connection and states what it needs
//! of the machine. A [`Session`] dispatches requests, queues responses and events, and does no input or output; the requests are in
//! `breakpoints`, `execution` and `inspection`, which alone use the debugger of `tip-sim`. Programs are loaded by the [`Launcher`] alone.

mod breakpoints;
mod execution;
mod inspection;
mod protocol;

pub use protocol::Launch;

use crate::message::DebugAdapter;
use crate::transport::{Connection, Frame};
use protocol::{Client, Event, Request, Response, Restart, Sent};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt;
use std::io::{self, Write};
use std::sync::mpsc::TryRecvError;
use tip_sim::debug::{Debugger, Move, Work};
use tipc::message::{Lang, Message};
use tipc::source::Source;

/// A loaded program on its robot.
pub struct Debuggee {
    /// The debugger of the program.
    pub debugger: Debugger,
    /// The source of the program.
    pub source: Source,
    /// The path of its file, as the client gave it.
    pub path: String,
    /// The warnings about it, one line each.
    pub warnings: String,
}

impl fmt::Debug for Debuggee {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debuggee = f.debug_struct("Debuggee");
        debuggee.field("path", &self.path).finish_non_exhaustive()
    }
}

/// Loads programs for a session.
pub trait Launcher {
    /// Loads a program.
    ///
    /// # Errors
    /// The reason why it cannot be run, in `lang`.
    fn launch(&mut self, launch: &Launch, lang: Lang) -> Result<Debuggee, String>;

    /// Returns true if two paths lead to the same file.
    fn is_same_file(&self, one: &str, other: &str) -> bool;
}

/// Serves a client until it disconnects or closes the stream.
///
/// # Errors
/// The client cannot be answered.
pub fn serve<W: Write>(mut connection: Connection<W>, launcher: impl Launcher) -> io::Result<()> {
    let mut session = Session::new(launcher);
    while !session.is_over() {
        let next = match session.is_running() {
            // The program runs on while no request is waiting.
            true => connection.poll(),
            false => connection.wait().ok_or(TryRecvError::Disconnected),
        };
        match next {
            Ok(Frame::Message(message)) => session.handle(&message),
            Ok(Frame::Malformed(_)) => session.handle_malformed(),
            Err(TryRecvError::Empty) => session.work(),
            Err(TryRecvError::Disconnected) => return Ok(()),
        }
        for message in session.take_output() {
            connection.send(&message)?;
        }
    }
    Ok(())
}

/// The id of the main program among the threads; the THREADs of the program follow.
const MAIN: i64 = 1;

/// Number of control cycles that are run between two looks for requests.
const PORTION: u64 = 500;

/// The numbers of a breakpoint.
#[derive(Clone, Copy, Debug)]
struct BreakpointNumbers {
    /// The number that the client knows; a restart keeps it.
    client: u32,
    /// The number in the debugger, if the breakpoint could be placed.
    debugger: Option<u32>,
}

/// A session with one client.
#[derive(Debug)]
pub struct Session<L> {
    launcher: L,
    /// The number of the last message that was queued.
    seq: i64,
    output: Vec<String>,
    client: Client,
    launch: Launch,
    debuggee: Option<Debuggee>,
    /// The numbers of breakpoints by kind, in the order of the request that set them.
    breakpoints: [Vec<BreakpointNumbers>; 3],
    /// Those of before a restart, until they are set again.
    kept: [Vec<BreakpointNumbers>; 3],
    /// The last number that a breakpoint was given.
    numbered: u32,
    /// The last request of each kind that set breakpoints.
    wanted: BTreeMap<String, Value>,
    /// The cycle and text of a change that would discard later cycles; repeating it confirms it.
    unconfirmed: Option<(u64, String)>,
    /// The progress of a search that was last reported, %; `None` while none is.
    progress: Option<u64>,
    /// True if a line of the console has moved the program.
    has_moved: bool,
    /// The cycle of the end of the program, once it was reported.
    reported_end: Option<u64>,
    is_over: bool,
}

/// The body of a response, or the error message.
type Answer = Result<Option<Value>, String>;

impl<L: Launcher> Session<L> {
    /// Returns a session before its first message.
    pub fn new(launcher: L) -> Self {
        Session {
            launcher,
            seq: 0,
            output: Vec::new(),
            client: Client::default(),
            launch: Launch::default(),
            debuggee: None,
            breakpoints: Default::default(),
            kept: Default::default(),
            numbered: 0,
            wanted: BTreeMap::new(),
            unconfirmed: None,
            progress: None,
            has_moved: false,
            reported_end: None,
            is_over: false,
        }
    }

    /// Returns true once the client has disconnected.
    pub fn is_over(&self) -> bool {
        self.is_over
    }

    /// Returns true while the program runs, so that [`Session::work`] continues it.
    pub fn is_running(&self) -> bool {
        let debuggee = self.debuggee.as_ref();
        !self.is_over && debuggee.is_some_and(|debuggee| debuggee.debugger.is_going())
    }

    /// Returns the queued messages, and empties the queue.
    pub fn take_output(&mut self) -> Vec<String> {
        std::mem::take(&mut self.output)
    }

    /// Handles a message.
    pub fn handle(&mut self, message: &[u8]) {
        let value: Value = match serde_json::from_slice(message) {
            Ok(value) => value,
            Err(error) => return self.refuse(0, "", format!("not a message: {error}")),
        };
        match value.get("type").and_then(Value::as_str) {
            Some("request") => {}
            // The session sends no requests.
            Some("response" | "event") => return,
            _ => return self.refuse(0, "", "not a request".to_owned()),
        }
        match serde_json::from_value::<Request>(value) {
            Ok(request) => self.serve(request),
            Err(error) => self.refuse(0, "", format!("not a request: {error}")),
        }
    }

    /// Handles a header without a usable length.
    pub fn handle_malformed(&mut self) {
        self.refuse(
            0,
            "",
            "not a message: its header has no valid Content-Length".to_owned(),
        );
    }

    fn serve(&mut self, request: Request) {
        let Request {
            seq,
            command,
            arguments,
        } = request;
        match self.answer(&command, arguments) {
            Ok(body) => self.respond(seq, &command, body),
            Err(reason) => return self.refuse(seq, &command, reason),
        }
        self.follow(&command);
    }

    fn answer(&mut self, command: &str, arguments: Value) -> Answer {
        match command {
            "initialize" => {
                self.client = read(arguments)?;
                Ok(Some(self.capabilities()))
            }
            "launch" => self.start(read(arguments)?),
            "restart" => self.restart(read(arguments)?),
            "attach" => Err(self.text(DebugAdapter::NothingToAttach)),
            "configurationDone" | "cancel" => Ok(None),
            "disconnect" | "terminate" => {
                self.is_over = command == "disconnect";
                Ok(None)
            }
            "setBreakpoints"
            | "setFunctionBreakpoints"
            | "setExceptionBreakpoints"
            | "setDataBreakpoints" => self.set(command, arguments),
            "dataBreakpointInfo" => self.data_breakpoint_info(&read(arguments)?),
            "threads" => self.threads(),
            "stackTrace" => self.stack_trace(&read(arguments)?),
            "scopes" => self.scopes(),
            "variables" => self.variables(&read(arguments)?),
            "setVariable" => self.set_variable(&read(arguments)?),
            "evaluate" => self.evaluate(&read(arguments)?),
            "exceptionInfo" => self.exception_info(),
            "continue" => self.go(Move::Continue),
            "reverseContinue" => self.go(Move::ReverseContinue),
            "next" => self.step(Move::Over, Move::Cycle, arguments),
            "stepIn" => self.step(Move::Step, Move::Cycle, arguments),
            "stepOut" => self.step(Move::Out, Move::Cycle, arguments),
            "stepBack" => self.step(Move::OverBack, Move::CycleBack, arguments),
            "pause" => self.debuggee().map(|_| None),
            _ => Err(format!("'{command}' is not supported")),
        }
    }

    /// Does what follows the response to a request.
    fn follow(&mut self, command: &str) {
        match command {
            "launch" => {
                self.warn();
                self.event("initialized", None);
            }
            "configurationDone" => self.begin(),
            "restart" => {
                self.warn();
                self.begin();
            }
            "pause" | "cancel" => self.interrupt(),
            "terminate" => self.end(0),
            _ if self.debuggee.is_some() => self.follow_move(command),
            _ => {}
        }
    }

    /// Returns the optional features of the protocol that are supported.
    fn capabilities(&self) -> Value {
        let falls = self.text(DebugAdapter::FallsStop);
        json!({
            "supportsConfigurationDoneRequest": true,
            "supportsFunctionBreakpoints": true,
            "supportsConditionalBreakpoints": true,
            "supportsHitConditionalBreakpoints": true,
            "supportsLogPoints": true,
            "supportsEvaluateForHovers": true,
            "supportsStepBack": true,
            "supportsSetVariable": true,
            "supportsExceptionInfoRequest": true,
            "supportsDataBreakpoints": true,
            "supportsSteppingGranularity": true,
            "supportsTerminateRequest": true,
            "supportsRestartRequest": true,
            "supportsCancelRequest": true,
            "exceptionBreakpointFilters": [{ "filter": "fall", "label": falls, "default": false }],
        })
    }

    fn start(&mut self, launch: Launch) -> Answer {
        if self.debuggee.is_some() {
            return Err(self.text(DebugAdapter::AlreadyDebugged));
        }
        self.load(launch)?;
        Ok(None)
    }

    /// Loads the program again, perhaps with other arguments, and sets all breakpoints in it. If it has errors now, the
    /// program of before stays.
    fn restart(&mut self, restart: Restart) -> Answer {
        self.debuggee()?;
        let launch = restart.arguments.unwrap_or_else(|| self.launch.clone());
        self.load(launch)?;
        self.unconfirmed = None;
        self.reported_end = None;
        self.set_all_again()?;
        Ok(None)
    }

    fn load(&mut self, launch: Launch) -> Result<(), String> {
        let mut debuggee = self.launcher.launch(&launch, self.lang())?;
        debuggee.debugger.stop_at_fall(launch.stop_on_fall);
        self.debuggee = Some(debuggee);
        self.launch = launch;
        Ok(())
    }

    /// Sends the warnings about the program.
    fn warn(&mut self) {
        let warnings = self.debuggee.as_ref().map(|it| it.warnings.clone());
        if let Some(warnings) = warnings.filter(|text| !text.is_empty()) {
            let output = format!("{warnings}\n");
            let body = json!({ "category": "console", "output": output });
            self.event("output", Some(body));
        }
    }

    /// Returns a message in the language of the client.
    fn text(&self, message: impl Into<Message>) -> String {
        message.into().in_lang(self.lang()).to_string()
    }

    /// Returns the language of messages.
    fn lang(&self) -> Lang {
        let locale = self.client.locale.as_deref();
        locale.map_or(Lang::English, Lang::of)
    }

    /// Runs the program for some cycles.
    pub fn work(&mut self) {
        let Some(debuggee) = &mut self.debuggee else {
            return;
        };
        let work = debuggee.debugger.work(PORTION);
        self.report_output();
        match work {
            Work::Going(progress) => self.report_progress(progress),
            Work::Stopped(_) => self.report_stop(),
        }
    }

    fn debuggee(&mut self) -> Result<&mut Debuggee, String> {
        let lang = self.lang();
        let nothing = || DebugAdapter::NothingDebugged.in_lang(lang).to_string();
        self.debuggee.as_mut().ok_or_else(nothing)
    }

    /// Returns the program if it is paused.
    fn paused(&mut self) -> Result<&mut Debuggee, String> {
        let running = self.text(DebugAdapter::IsRunning);
        let debuggee = self.debuggee()?;
        match debuggee.debugger.is_going() {
            true => Err(running),
            false => Ok(debuggee),
        }
    }

    fn event(&mut self, event: &'static str, body: Option<Value>) {
        self.seq += 1;
        let seq = self.seq;
        self.send(&Sent::Event(Event { seq, event, body }));
    }

    fn respond(&mut self, request_seq: i64, command: &str, body: Option<Value>) {
        self.seq += 1;
        self.send(&Sent::Response(Response {
            seq: self.seq,
            request_seq,
            success: true,
            command: command.to_owned(),
            message: None,
            body,
        }));
    }

    fn refuse(&mut self, request_seq: i64, command: &str, reason: String) {
        self.seq += 1;
        // In a format, braces hold the names of variables.
        let format = reason.replace(['{', '}'], "");
        self.send(&Sent::Response(Response {
            seq: self.seq,
            request_seq,
            success: false,
            command: command.to_owned(),
            message: Some(reason),
            body: Some(json!({ "error": { "id": 1, "format": format, "showUser": true } })),
        }));
    }

    fn send(&mut self, message: &Sent) {
        // It cannot fail: all keys of maps are strings.
        self.output.extend(serde_json::to_string(message).ok());
    }
}

/// Parses the arguments of a request; without any, all of them are absent.
fn read<T: DeserializeOwned>(arguments: Value) -> Result<T, String> {
    let arguments = match arguments {
        Value::Null => json!({}),
        object @ Value::Object(_) => object,
        _ => return Err("wrong arguments: they must be an object".to_owned()),
    };
    serde_json::from_value(arguments).map_err(|error| format!("wrong arguments: {error}"))
}
