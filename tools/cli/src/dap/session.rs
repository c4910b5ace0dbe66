//! A session: what a client asks for, and what it is answered. Nothing here reads or writes.

use super::message::{Capabilities, Client, Event, Filter, Launch, Request, Response, Sent};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use tip_sim::debug::{Debugger, Move, Work};
use tip_sim::message::Debugging;
use tipc::message::Lang;
use tipc::source::Source;

/// The one thread of a program.
pub(super) const THREAD: i64 = 1;

/// How many cycles are done between two looks at what the client wants.
const PORTION: u64 = 500;

/// A program that was loaded, on its robot.
pub(crate) struct Debuggee {
    pub(crate) debugger: Debugger,
    /// Of which it was made.
    pub(crate) source: Source,
    /// Its file, as the client calls it.
    pub(crate) path: String,
}

/// Who loads programs.
pub(crate) trait Host {
    /// Loads a program; an error says what is wrong, in this language.
    fn launch(&mut self, launch: &Launch, lang: Lang) -> Result<Debuggee, String>;
}

/// A client's session.
pub(crate) struct Session<H> {
    pub(super) host: H,
    seq: i64,
    out: Vec<String>,
    pub(super) client: Client,
    pub(super) launch: Launch,
    pub(super) debuggee: Option<Debuggee>,
    /// Numbers of the breakpoints on lines, of those by name, and of watches.
    pub(super) placed: [Vec<u32>; 3],
    /// A change of the past that was refused once; a second time it is confirmed.
    pub(super) refused: Option<(u64, String)>,
    /// Whether a long search has been announced.
    pub(super) has_progress: bool,
    /// Whether a line of the console has moved the program.
    pub(super) has_moved: bool,
    /// The progress that was last reported: %.
    pub(super) percentage: u64,
    /// The end of the program, once it has been reported.
    pub(super) told_end: Option<u64>,
    is_over: bool,
}

/// An answer to a request.
pub(super) type Answer = Result<Option<Value>, String>;

impl<H: Host> Session<H> {
    pub(crate) fn new(host: H) -> Self {
        Session {
            host,
            seq: 0,
            out: Vec::new(),
            client: Client::default(),
            launch: Launch::default(),
            debuggee: None,
            placed: Default::default(),
            refused: None,
            has_progress: false,
            has_moved: false,
            percentage: 0,
            told_end: None,
            is_over: false,
        }
    }

    /// Whether the client has said goodbye.
    pub(crate) fn is_over(&self) -> bool {
        self.is_over
    }

    /// Whether there is work to do.
    pub(crate) fn is_going(&self) -> bool {
        let debuggee = self.debuggee.as_ref();
        !self.is_over && debuggee.is_some_and(|debuggee| debuggee.debugger.is_going())
    }

    /// What is to be sent since the last time.
    pub(crate) fn sent(&mut self) -> Vec<String> {
        std::mem::take(&mut self.out)
    }

    /// A message came.
    pub(crate) fn handle(&mut self, message: &[u8]) {
        let value: Value = match serde_json::from_slice(message) {
            Ok(value) => value,
            Err(error) => return self.refuse(0, "", format!("not a message: {error}")),
        };
        match value.get("type").and_then(Value::as_str) {
            Some("request") => {}
            // Nothing is asked of clients.
            Some("response" | "event") => return,
            _ => return self.refuse(0, "", "not a request".to_owned()),
        }
        match serde_json::from_value::<Request>(value) {
            Ok(request) => self.serve(request),
            Err(error) => self.refuse(0, "", format!("not a request: {error}")),
        }
    }

    /// Something came that is no message.
    pub(crate) fn broken(&mut self) {
        self.refuse(0, "", "not a message: its header says no length".to_owned());
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
            "attach" => Err(self.text(Debugging::NothingToAttach)),
            "configurationDone" | "cancel" => Ok(None),
            "disconnect" | "terminate" => {
                self.is_over = command == "disconnect";
                Ok(None)
            }
            "setBreakpoints" => self.set_breakpoints(read(arguments)?),
            "setFunctionBreakpoints" => self.set_function_breakpoints(read(arguments)?),
            "setExceptionBreakpoints" => self.set_exception_breakpoints(read(arguments)?),
            "dataBreakpointInfo" => self.data_breakpoint_info(&read(arguments)?),
            "setDataBreakpoints" => self.set_data_breakpoints(read(arguments)?),
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
            "stepOut" => self.go(Move::Out),
            "stepBack" => self.step(Move::OverBack, Move::CycleBack, arguments),
            "pause" => self.debuggee().map(|_| None),
            _ => Err(format!("'{command}' is not supported")),
        }
    }

    /// What comes after the answer.
    fn follow(&mut self, command: &str) {
        match command {
            "launch" => self.event("initialized", None),
            "configurationDone" => self.begin(),
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
            supports_cancel_request: true,
            exception_breakpoint_filters: vec![Filter {
                filter: "fall",
                label: self.text(Debugging::FallsStop),
                default: false,
            }],
        }
    }

    fn start(&mut self, launch: Launch) -> Answer {
        if self.debuggee.is_some() {
            return Err(self.text(Debugging::AlreadyDebugged));
        }
        let mut debuggee = self.host.launch(&launch, self.lang())?;
        debuggee.debugger.stop_at_fall(launch.stop_on_fall);
        self.debuggee = Some(debuggee);
        self.launch = launch;
        Ok(None)
    }

    /// A message in the language of the client.
    pub(super) fn text(&self, message: Debugging) -> String {
        message.in_lang(self.lang()).to_string()
    }

    /// The language of messages.
    pub(super) fn lang(&self) -> Lang {
        match &self.client.locale {
            Some(locale) if locale.starts_with("ja") => Lang::Japanese,
            _ => Lang::English,
        }
    }

    /// Does a portion of what is under way.
    pub(crate) fn work(&mut self) {
        let Some(debuggee) = &mut self.debuggee else {
            return;
        };
        let work = debuggee.debugger.work(PORTION);
        self.say();
        match work {
            Work::Going(progress) => self.report(progress),
            Work::Stopped(_) => self.stopped(),
        }
    }

    pub(super) fn debuggee(&mut self) -> Result<&mut Debuggee, String> {
        let lang = self.lang();
        let nothing = || Debugging::NothingDebugged.in_lang(lang).to_string();
        self.debuggee.as_mut().ok_or_else(nothing)
    }

    /// The same where it stands; what moves is nowhere.
    pub(super) fn standing(&mut self) -> Result<&mut Debuggee, String> {
        let running = self.text(Debugging::IsRunning);
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
        // What is sent has no maps with keys that are not text.
        self.out.extend(serde_json::to_string(message).ok());
    }
}

/// The arguments of a request; none at all stand for none of them.
pub(super) fn read<T: DeserializeOwned>(arguments: Value) -> Result<T, String> {
    let arguments = match arguments {
        Value::Null => json!({}),
        object @ Value::Object(_) => object,
        _ => return Err("wrong arguments: they are an object".to_owned()),
    };
    serde_json::from_value(arguments).map_err(|error| format!("wrong arguments: {error}"))
}

/// The body of an answer.
pub(super) fn body(of: &impl Serialize) -> Answer {
    serde_json::to_value(of)
        .map(Some)
        .map_err(|error| error.to_string())
}
