//! Movements forwards and backwards, and the events that report their progress and where they stop.

use super::inspection::thread;
use super::protocol::Step;
use super::{Answer, Launcher, MAIN, Session, read};
use crate::message::DebugAdapter;
use serde_json::{Value, json};
use tip_runtime::program::End;
use tip_sim::debug::{Move, Progress, Reason};
use tip_sim::message::Debugging;
use tipc::language::Keyword;

/// The id of the progress of a search.
const PROGRESS: &str = "search";

/// Number of cycles from which the progress of a search is reported.
const LONG_SEARCH: u64 = 20_000;

impl<L: Launcher> Session<L> {
    /// Starts the program after the configuration.
    pub(super) fn begin(&mut self) {
        match self.launch.stop_on_entry && !self.launch.no_debug {
            true => self.stopped_because("entry", None),
            false => {
                if self.go(Move::Continue).is_ok() {
                    self.report_if_stopped();
                }
            }
        }
    }

    pub(super) fn go(&mut self, movement: Move) -> Answer {
        let debuggee = self.paused()?;
        debuggee.debugger.start(movement);
        Ok(match movement {
            Move::Continue => Some(json!({ "allThreadsContinued": true })),
            _ => None,
        })
    }

    /// Steps a thread by a statement, or with the finest granularity all by a control cycle.
    pub(super) fn step(&mut self, step: Move, cycle: Move, arguments: Value) -> Answer {
        let Step {
            granularity,
            thread_id,
        } = read(arguments)?;
        let thread = thread(thread_id);
        self.paused()?.debugger.select(thread);
        match granularity.as_deref() {
            Some("instruction") => self.go(cycle),
            _ => self.go(step),
        }
    }

    /// Reports a movement that ends as soon as it begins.
    pub(super) fn follow_move(&mut self, command: &str) {
        match command {
            "continue" | "next" | "stepIn" | "stepOut" if self.is_at_end() => self.end_as_program(),
            "continue" | "next" | "stepIn" | "stepOut" | "stepBack" | "reverseContinue" => {
                self.report_if_stopped();
            }
            _ if std::mem::take(&mut self.has_moved) => self.report_if_stopped(),
            _ => {}
        }
    }

    /// Reports the stop of a program that does not run.
    fn report_if_stopped(&mut self) {
        if !self.is_running() {
            self.report_stop();
        }
    }

    /// Returns true if the program had stopped at its end already, so that it cannot continue.
    fn is_at_end(&self) -> bool {
        self.debuggee.as_ref().is_some_and(|debuggee| {
            let stop = debuggee.debugger.stop();
            let is_end = matches!(stop.reason, Reason::Ended(_) | Reason::Fault(_));
            is_end && self.reported_end == Some(stop.at) && !debuggee.debugger.is_going()
        })
    }

    fn end_as_program(&mut self) {
        let fault = self
            .debuggee
            .as_ref()
            .is_some_and(|debuggee| matches!(debuggee.debugger.stop().reason, Reason::Fault(_)));
        self.end(if fault { 3 } else { 0 });
    }

    /// Reports the end of the program and of the session.
    pub(super) fn end(&mut self, code: i64) {
        if let Some(debuggee) = &mut self.debuggee {
            debuggee.debugger.cancel();
            self.event("exited", Some(json!({ "exitCode": code })));
        }
        self.event("terminated", None);
    }

    pub(super) fn interrupt(&mut self) {
        let Some(debuggee) = self.debuggee.as_mut() else {
            return;
        };
        if debuggee.debugger.is_going() {
            debuggee.debugger.cancel();
            self.report_stop();
        }
    }

    /// Sends new messages of the program and of log points.
    pub(super) fn report_output(&mut self) {
        let Some(debuggee) = &mut self.debuggee else {
            return;
        };
        // A log point at a cycle comes before the message of that cycle.
        let debugger = &mut debuggee.debugger;
        let logged = debugger.logged().into_iter();
        let logged = logged.map(|(at, text)| (at, "console", text));
        let messages = debugger.take_messages().into_iter();
        let messages = messages.map(|(at, text)| (at, "stdout", text));
        let mut all: Vec<_> = logged.chain(messages).collect();
        all.sort_by_key(|(at, ..)| *at);
        for (_, category, text) in all {
            if !text.is_empty() {
                let body = json!({ "category": category, "output": format!("{text}\n") });
                self.event("output", Some(body));
            }
        }
    }

    /// Sends the progress of a long search.
    pub(super) fn report_progress(&mut self, progress: Progress) {
        let Some(of) = progress.of.filter(|of| *of >= LONG_SEARCH) else {
            return;
        };
        if !self.client.supports_progress_reporting {
            return;
        }
        let percentage = progress.done.saturating_mul(100) / of;
        let last = self.progress.unwrap_or_else(|| {
            let title = self.text(DebugAdapter::Searches);
            self.event(
                "progressStart",
                Some(json!({ "progressId": PROGRESS, "title": title, "cancellable": true, "percentage": 0 })),
            );
            0
        });
        self.progress = Some(percentage.max(last));
        if percentage > last {
            self.event(
                "progressUpdate",
                Some(json!({ "progressId": PROGRESS, "percentage": percentage })),
            );
        }
    }

    /// Reports where and why the program has stopped.
    pub(super) fn report_stop(&mut self) {
        if self.progress.take().is_some() {
            self.event("progressEnd", Some(json!({ "progressId": PROGRESS })));
        }
        self.report_output();
        let Some(debuggee) = &self.debuggee else {
            return;
        };
        let stop = debuggee.debugger.stop().clone();
        let is_end = matches!(stop.reason, Reason::Ended(_) | Reason::Fault(_));
        if is_end && self.launch.no_debug {
            return self.end_as_program();
        }
        self.reported_end = is_end.then_some(stop.at);
        match &stop.reason {
            Reason::Start => self.stopped_because("entry", Some(self.text(Debugging::Start))),
            Reason::Step => self.stopped_because("step", None),
            Reason::There => self.stopped_because("goto", None),
            Reason::Breakpoint(id) => {
                let known = self.known_breakpoint(*id);
                let reason = match known {
                    Some((_, true)) => "function breakpoint",
                    _ => "breakpoint",
                };
                self.stopped_at(reason, None, known.map(|(id, _)| id));
            }
            Reason::Watch { id, .. } => {
                let known = self.known_breakpoint(*id);
                self.stopped_at("data breakpoint", None, known.map(|(id, _)| id));
            }
            Reason::Fall(fall) => {
                let text = self.text(DebugAdapter::FellIn {
                    cycle: count(fall.cycle),
                });
                self.stopped_because("exception", Some(text));
            }
            Reason::Fault(emergency) => {
                self.stopped_because("exception", Some(emergency.to_string()));
            }
            Reason::Ended(end) => {
                let end = match end {
                    End::End => Keyword::End,
                    End::Exit => Keyword::Exit,
                };
                let word = end.word();
                let text = self.text(DebugAdapter::EndedBy { word });
                self.stopped_because("pause", Some(text));
            }
            _ => self.stopped_because("pause", None),
        }
    }

    fn stopped_because(&mut self, reason: &str, text: Option<String>) {
        self.stopped_at(reason, text, None);
    }

    fn stopped_at(&mut self, reason: &str, text: Option<String>, id: Option<u32>) {
        let debuggee = self.debuggee.as_ref();
        let thread = debuggee.map_or(0, |debuggee| debuggee.debugger.thread());
        let thread = MAIN + i64::from(thread);
        let mut body = json!({ "reason": reason, "threadId": thread, "allThreadsStopped": true });
        if let Some(text) = text {
            body["description"] = text.clone().into();
            body["text"] = text.into();
        }
        if let Some(id) = id {
            body["hitBreakpointIds"] = json!([id]);
        }
        self.event("stopped", Some(body));
    }

    /// Returns the emergency or the fall that stopped the program.
    pub(super) fn exception_info(&mut self) -> Answer {
        let lang = self.lang();
        let debuggee = self.paused()?;
        let (id, text) = match &debuggee.debugger.stop().reason {
            Reason::Fault(emergency) => (emergency.fault.kind().to_string(), emergency.to_string()),
            Reason::Fall(fall) => {
                let cycle = count(fall.cycle);
                let fell = if fall.margin < 0.0 {
                    let outside = format!("{:.1}", -fall.margin).into();
                    DebugAdapter::FellBy { cycle, outside }
                } else {
                    DebugAdapter::FellIn { cycle }
                };
                ("fall".to_owned(), fell.in_lang(lang).to_string())
            }
            _ => return Err(self.text(DebugAdapter::NothingHappened)),
        };
        Ok(Some(
            json!({ "exceptionId": id, "description": text, "breakMode": "always" }),
        ))
    }
}

/// Converts the number of a cycle for messages.
fn count(cycle: u64) -> usize {
    usize::try_from(cycle).unwrap_or(usize::MAX)
}
