//! Breakpoints on lines, on names and on variables.

use super::inspection::column;
use super::protocol::{
    Breakpoint, DataBreakpointInfo, SetBreakpoints, SetDataBreakpoints, SetExceptionBreakpoints,
    SetFunctionBreakpoints, SourceBreakpoint,
};
use super::{Answer, BreakpointNumbers, Debuggee, Launcher, Session, read};
use crate::message::DebugAdapter;
use serde_json::{Value, json};
use tip_sim::debug::{DebugError, Placed, When};
use tipc::message::Lang;
use tipc::source::Unit;

/// A kind of breakpoints; a client replaces all of a kind together.
#[derive(Clone, Copy)]
enum Kind {
    /// On a line.
    Line,
    /// On a command, label or routine.
    Name,
    /// On a variable.
    Watch,
}

impl<L: Launcher> Session<L> {
    fn set_breakpoints(&mut self, wanted: SetBreakpoints) -> Answer {
        self.clear(Kind::Line)?;
        let (lang, base) = (self.lang(), self.first_line());
        let first_column = self.first_column();
        let debuggee = self.debuggee()?;
        let mut answers = Vec::new();
        for one in &wanted.breakpoints {
            let when = when(&one.condition, &one.hit_condition);
            let placed = place(debuggee, one, (base, first_column), &when);
            let line = placed
                .as_ref()
                .map_or(one.line, |placed| i64::from(placed.line) - 1 + base);
            answers.push(answer(placed, lang, Some(line)));
        }
        self.answer_with(Kind::Line, answers)
    }

    /// Rejects breakpoints in a file that is not debugged; those of the program stay.
    fn reject_other_file(&self, wanted: &[SourceBreakpoint]) -> Answer {
        let reason = self.text(DebugAdapter::OtherFile);
        let answers = wanted.iter();
        let answers = answers.map(|one| unverified(reason.clone(), Some(one.line)));
        Ok(Some(json!({ "breakpoints": answers.collect::<Vec<_>>() })))
    }

    fn set_function_breakpoints(&mut self, wanted: SetFunctionBreakpoints) -> Answer {
        self.clear(Kind::Name)?;
        let (lang, base) = (self.lang(), self.first_line());
        let debuggee = self.debuggee()?;
        let place = |one: &super::protocol::FunctionBreakpoint| {
            let when = when(&one.condition, &one.hit_condition);
            let placed = debuggee.debugger.break_at_name(&one.name, &when);
            let line = placed
                .as_ref()
                .ok()
                .map(|placed| i64::from(placed.line) - 1 + base);
            answer(placed, lang, line)
        };
        let answers = wanted.breakpoints.iter().map(place).collect();
        self.answer_with(Kind::Name, answers)
    }

    fn set_exception_breakpoints(&mut self, wanted: SetExceptionBreakpoints) -> Answer {
        let falls =
            self.launch.stop_on_fall || wanted.filters.iter().any(|filter| filter == "fall");
        self.debuggee()?.debugger.stop_at_fall(falls);
        Ok(None)
    }

    pub(super) fn data_breakpoint_info(&mut self, asked: &DataBreakpointInfo) -> Answer {
        let debuggee = self.debuggee()?;
        let name = asked.name.trim().to_ascii_uppercase();
        let mut names = debuggee.debugger.program().variables().iter();
        let is_variable = names.any(|variable| {
            variable.name == name || variable.scalar_names().any(|member| member == name)
        });
        Ok(Some(match is_variable {
            true => json!({
                "dataId": name,
                "description": name,
                "accessTypes": ["write"],
                "canPersist": true,
            }),
            false => {
                json!({ "dataId": null, "description": self.text(DebugAdapter::OnlyVariables) })
            }
        }))
    }

    fn set_data_breakpoints(&mut self, wanted: SetDataBreakpoints) -> Answer {
        self.clear(Kind::Watch)?;
        let (lang, reason) = (self.lang(), self.text(DebugAdapter::WatchHasNoCondition));
        let debuggee = self.debuggee()?;
        let watch = |one: &super::protocol::DataBreakpoint| {
            if text(&one.condition).or(text(&one.hit_condition)).is_some() {
                return unverified(reason.clone(), None);
            }
            match debuggee.debugger.watch(&one.data_id) {
                Ok(id) => Breakpoint {
                    id: Some(id),
                    verified: true,
                    ..Breakpoint::default()
                },
                Err(refused) => unverified(refused.text(lang), None),
            }
        };
        let answers = wanted.breakpoints.iter().map(watch).collect();
        self.answer_with(Kind::Watch, answers)
    }

    /// Sets the breakpoints that the client last asked for again, in a program that has been loaded again. They keep their
    /// numbers; the client is told where they are now.
    pub(super) fn set_all_again(&mut self) -> Result<(), String> {
        self.kept = std::mem::take(&mut self.breakpoints);
        for (command, arguments) in self.wanted.clone() {
            let answer = self.set(&command, arguments)?.unwrap_or_default();
            for breakpoint in answer["breakpoints"].as_array().into_iter().flatten() {
                let body = json!({ "reason": "changed", "breakpoint": breakpoint });
                self.event("breakpoint", Some(body));
            }
        }
        Ok(())
    }

    /// Sets breakpoints of a kind, and remembers the request for a restart.
    pub(super) fn set(&mut self, command: &str, arguments: Value) -> Answer {
        let asked = arguments.clone();
        let answer = match command {
            "setBreakpoints" => {
                let wanted: SetBreakpoints = read(arguments)?;
                if !self.is_program(wanted.source.path.as_deref())? {
                    return self.reject_other_file(&wanted.breakpoints);
                }
                self.set_breakpoints(wanted)
            }
            "setFunctionBreakpoints" => self.set_function_breakpoints(read(arguments)?),
            "setExceptionBreakpoints" => self.set_exception_breakpoints(read(arguments)?),
            _ => self.set_data_breakpoints(read(arguments)?),
        }?;
        self.wanted.insert(command.to_owned(), asked);
        Ok(answer)
    }

    /// Returns true if a path leads to the program; the client may leave it out.
    fn is_program(&mut self, path: Option<&str>) -> Result<bool, String> {
        let program = self.debuggee()?.path.clone();
        let leads = |path| is_end_of(path, &program) || self.launcher.is_same_file(path, &program);
        Ok(path.is_none_or(leads))
    }

    /// Removes the breakpoints of a kind.
    fn clear(&mut self, kind: Kind) -> Result<(), String> {
        let all = std::mem::take(&mut self.breakpoints[kind as usize]);
        let debugger = &mut self.debuggee()?.debugger;
        for id in all.into_iter().filter_map(|one| one.debugger) {
            debugger.remove_breakpoint(id);
            debugger.unwatch(id);
        }
        Ok(())
    }

    /// Numbers new breakpoints for the client, and returns the body of the response.
    fn answer_with(&mut self, kind: Kind, mut answers: Vec<Breakpoint>) -> Answer {
        let mut kept = std::mem::take(&mut self.kept[kind as usize]).into_iter();
        let mut all = Vec::new();
        for answer in &mut answers {
            let client = kept
                .next()
                .map_or_else(|| self.new_number(), |one| one.client);
            let debugger = answer.id.replace(client);
            all.push(BreakpointNumbers { client, debugger });
        }
        self.breakpoints[kind as usize] = all;
        Ok(Some(json!({ "breakpoints": answers })))
    }

    fn new_number(&mut self) -> u32 {
        self.numbered += 1;
        self.numbered
    }

    /// Returns the client's number of a breakpoint of the debugger, and true if it is on a name.
    pub(super) fn known_breakpoint(&self, id: u32) -> Option<(u32, bool)> {
        let of = |kind: usize| {
            let mut all = self.breakpoints[kind].iter();
            let found = all.find(|one| one.debugger == Some(id))?;
            Some((found.client, kind == Kind::Name as usize))
        };
        (0..self.breakpoints.len()).find_map(of)
    }

    /// Returns the number that the client gives to the first column.
    pub(super) fn first_column(&self) -> i64 {
        i64::from(self.client.columns_start_at1)
    }

    /// Returns the number that the client gives to the first line.
    pub(super) fn first_line(&self) -> i64 {
        i64::from(self.client.lines_start_at1)
    }
}

fn place(
    debuggee: &mut Debuggee,
    wanted: &SourceBreakpoint,
    (base, first_column): (i64, i64),
    when: &When<'_>,
) -> Result<Placed, DebugError> {
    let from_one = |number: i64, base| {
        let number = number.saturating_sub(base).saturating_add(1);
        u32::try_from(number.max(1)).unwrap_or(u32::MAX)
    };
    let line = from_one(wanted.line, base);
    let column = wanted.column.map_or(1, |wanted| {
        let wanted = from_one(wanted, first_column);
        column(
            &debuggee.source,
            line,
            wanted,
            [Unit::Utf16, Unit::Character],
        )
    });
    let debugger = &mut debuggee.debugger;
    match text(&wanted.log_message) {
        Some(message) => debugger.log_at(line, column, when, message),
        None => debugger.break_at(line, column, when),
    }
}

fn answer(placed: Result<Placed, DebugError>, lang: Lang, line: Option<i64>) -> Breakpoint {
    match placed {
        Ok(placed) => Breakpoint {
            id: Some(placed.id),
            verified: true,
            line,
            ..Breakpoint::default()
        },
        Err(refused) => unverified(refused.text(lang), line),
    }
}

fn unverified(message: String, line: Option<i64>) -> Breakpoint {
    Breakpoint {
        message: Some(message),
        line,
        ..Breakpoint::default()
    }
}

fn when<'a>(condition: &'a Option<String>, hits: &'a Option<String>) -> When<'a> {
    When {
        condition: text(condition),
        hits: text(hits),
    }
}

/// Returns a text unless it is missing or blank.
fn text(of: &Option<String>) -> Option<&str> {
    of.as_deref().filter(|text| !text.trim().is_empty())
}

/// Returns true if one path is the end of the other, so that they probably name the same file.
fn is_end_of(one: &str, other: &str) -> bool {
    let parts = |path: &str| -> Vec<String> {
        let parts = path
            .split(['/', '\\'])
            .filter(|part| !matches!(*part, "" | "."));
        parts.map(str::to_owned).collect()
    };
    let (one, other) = (parts(one), parts(other));
    one.ends_with(&other) || other.ends_with(&one)
}
