//! The state of a session: requests are dispatched, and responses and events are queued. It does no input or output.

use super::protocol::{
    Capabilities, Client, Event, Filter, Launch, Request, Response, Restart, Sent,
};
use super::{Debuggee, Launcher};
use crate::message::DebugAdapter;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use tip_sim::debug::{Move, Work};
use tipc::message::{Lang, Message};

/// The id of the main program among the threads; the THREADs of the program follow.
pub(super) const MAIN: i64 = 1;

/// Number of control cycles that are run between two looks for requests.
const PORTION: u64 = 500;

/// The numbers of a breakpoint.
#[derive(Clone, Copy, Debug)]
pub(super) struct BreakpointNumbers {
    /// The number that the client knows; a restart keeps it.
    pub(super) client: u32,
    /// The number in the debugger, if the breakpoint could be placed.
    pub(super) debugger: Option<u32>,
}

/// A session with one client.
#[derive(Debug)]
pub struct Session<L> {
    pub(super) launcher: L,
    /// The number of the last message that was queued.
    seq: i64,
    output: Vec<String>,
    pub(super) client: Client,
    pub(super) launch: Launch,
    pub(super) debuggee: Option<Debuggee>,
    /// The numbers of breakpoints by kind, in the order of the request that set them.
    pub(super) breakpoints: [Vec<BreakpointNumbers>; 3],
    /// Those of before a restart, until they are set again.
    pub(super) kept: [Vec<BreakpointNumbers>; 3],
    /// The last number that a breakpoint was given.
    pub(super) numbered: u32,
    /// The last request of each kind that set breakpoints.
    pub(super) wanted: BTreeMap<String, Value>,
    /// The cycle and text of a change that would discard later cycles; repeating it confirms it.
    pub(super) unconfirmed: Option<(u64, String)>,
    /// True while the progress of a search is reported.
    pub(super) has_progress: bool,
    /// True if a line of the console has moved the program.
    pub(super) has_moved: bool,
    /// The progress that was last reported, %.
    pub(super) percentage: u64,
    /// The cycle of the end of the program, once it was reported.
    pub(super) reported_end: Option<u64>,
    is_over: bool,
}

/// The body of a response, or the error message.
pub(super) type Answer = Result<Option<Value>, String>;

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
            has_progress: false,
            has_moved: false,
            percentage: 0,
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
                body(&self.capabilities())
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

    fn capabilities(&self) -> Capabilities {
        Capabilities {
            supports_configuration_done_request: true,
            supports_function_breakpoints: true,
            supports_conditional_breakpoints: true,
            supports_hit_conditional_breakpoints: true,
            supports_log_points: true,
            supports_evaluate_for_hovers: true,
            supports_step_back: true,
            supports_set_variable: true,
            supports_exception_info_request: true,
            supports_data_breakpoints: true,
            supports_stepping_granularity: true,
            supports_terminate_request: true,
            supports_restart_request: true,
            supports_cancel_request: true,
            exception_breakpoint_filters: vec![Filter {
                filter: "fall",
                label: self.text(DebugAdapter::FallsStop),
                default: false,
            }],
        }
    }

    fn start(&mut self, launch: Launch) -> Answer {
        if self.debuggee.is_some() {
            return Err(self.text(DebugAdapter::AlreadyDebugged));
        }
        let mut debuggee = self.launcher.launch(&launch, self.lang())?;
        debuggee.debugger.stop_at_fall(launch.stop_on_fall);
        self.debuggee = Some(debuggee);
        self.launch = launch;
        Ok(None)
    }

    /// Loads the program again, perhaps with other arguments, and sets all breakpoints in it. If it has errors now, the
    /// program of before stays.
    fn restart(&mut self, restart: Restart) -> Answer {
        self.debuggee()?;
        let launch = restart.arguments.unwrap_or_else(|| self.launch.clone());
        let mut debuggee = self.launcher.launch(&launch, self.lang())?;
        debuggee.debugger.stop_at_fall(launch.stop_on_fall);
        self.debuggee = Some(debuggee);
        self.launch = launch;
        self.unconfirmed = None;
        self.reported_end = None;
        self.set_all_again()?;
        Ok(None)
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
    pub(super) fn text(&self, message: impl Into<Message>) -> String {
        message.into().in_lang(self.lang()).to_string()
    }

    /// Returns the language of messages.
    pub(super) fn lang(&self) -> Lang {
        match &self.client.locale {
            Some(locale) if locale.starts_with("ja") => Lang::Japanese,
            _ => Lang::English,
        }
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

    pub(super) fn debuggee(&mut self) -> Result<&mut Debuggee, String> {
        let lang = self.lang();
        let nothing = || DebugAdapter::NothingDebugged.in_lang(lang).to_string();
        self.debuggee.as_mut().ok_or_else(nothing)
    }

    /// Returns the program if it is paused.
    pub(super) fn paused(&mut self) -> Result<&mut Debuggee, String> {
        let running = self.text(DebugAdapter::IsRunning);
        let debuggee = self.debuggee()?;
        match debuggee.debugger.is_going() {
            true => Err(running),
            false => Ok(debuggee),
        }
    }

    pub(super) fn event(&mut self, event: &'static str, body: Option<Value>) {
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
pub(super) fn read<T: DeserializeOwned>(arguments: Value) -> Result<T, String> {
    let arguments = match arguments {
        Value::Null => json!({}),
        object @ Value::Object(_) => object,
        _ => return Err("wrong arguments: they must be an object".to_owned()),
    };
    serde_json::from_value(arguments).map_err(|error| format!("wrong arguments: {error}"))
}

/// Serialises the body of a response.
pub(super) fn body(of: &impl Serialize) -> Answer {
    serde_json::to_value(of)
        .map(Some)
        .map_err(|error| error.to_string())
}
