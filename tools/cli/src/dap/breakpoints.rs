//! Breakpoints on lines, by name and on variables.

use super::message::{
    Breakpoint, DataBreakpointInfo, SetBreakpoints, SetDataBreakpoints, SetExceptionBreakpoints,
    SetFunctionBreakpoints, SourceBreakpoint,
};
use super::session::{Answer, Debuggee, Host, Session};
use super::shown;
use serde_json::{Value, json};
use tip_sim::debug::{Placed, Refused, When};
use tip_sim::message::Debugging;
use tipc::message::Lang;

/// Which kind of breakpoints a client replaces together.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Line,
    Name,
    Watch,
}

impl<H: Host> Session<H> {
    pub(super) fn set_breakpoints(&mut self, wanted: SetBreakpoints) -> Answer {
        let path = wanted.source.path.as_deref();
        let program = &self.debuggee()?.path;
        if path.is_some_and(|path| !same(path, program)) {
            return self.of_another_file(&wanted.breakpoints);
        }
        self.clear(Kind::Line)?;
        let (lang, base) = (self.lang(), self.first_line());
        let first_column = self.first_column();
        let debuggee = self.debuggee()?;
        let mut answers = Vec::new();
        for one in &wanted.breakpoints {
            let when = When {
                condition: text(&one.condition),
                hits: text(&one.hit_condition),
            };
            let placed = place(debuggee, one, (base, first_column), &when);
            let line = placed
                .as_ref()
                .map_or(one.line, |placed| i64::from(placed.line) - 1 + base);
            answers.push(answer(placed, lang, Some(line)));
        }
        self.keep(Kind::Line, answers)
    }

    /// Breakpoints of a file that does not run: those of the program stay.
    fn of_another_file(&self, wanted: &[SourceBreakpoint]) -> Answer {
        let reason = self.text(Debugging::OtherFile);
        let answers = wanted
            .iter()
            .map(|one| unverified(reason.clone(), Some(one.line)));
        Ok(Some(json!({ "breakpoints": values(answers) })))
    }

    pub(super) fn set_function_breakpoints(&mut self, wanted: SetFunctionBreakpoints) -> Answer {
        self.clear(Kind::Name)?;
        let (lang, base) = (self.lang(), self.first_line());
        let debuggee = self.debuggee()?;
        let place = |one: &super::message::FunctionBreakpoint| {
            let when = When {
                condition: text(&one.condition),
                hits: text(&one.hit_condition),
            };
            let placed = debuggee.debugger.break_at_name(&one.name, &when);
            let line = placed
                .as_ref()
                .ok()
                .map(|placed| i64::from(placed.line) - 1 + base);
            answer(placed, lang, line)
        };
        let answers = wanted.breakpoints.iter().map(place).collect();
        self.keep(Kind::Name, answers)
    }

    pub(super) fn set_exception_breakpoints(&mut self, wanted: SetExceptionBreakpoints) -> Answer {
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
                json!({ "dataId": null, "description": self.text(Debugging::OnlyVariables) })
            }
        }))
    }

    pub(super) fn set_data_breakpoints(&mut self, wanted: SetDataBreakpoints) -> Answer {
        self.clear(Kind::Watch)?;
        let (lang, reason) = (self.lang(), self.text(Debugging::WatchHasNoCondition));
        let debuggee = self.debuggee()?;
        let watch = |one: &super::message::DataBreakpoint| {
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
        self.keep(Kind::Watch, answers)
    }

    /// Takes the breakpoints of a kind away.
    fn clear(&mut self, kind: Kind) -> Result<(), String> {
        let ids = std::mem::take(&mut self.placed[kind as usize]);
        let debugger = &mut self.debuggee()?.debugger;
        for id in ids {
            debugger.remove_breakpoint(id);
            debugger.unwatch(id);
        }
        Ok(())
    }

    fn keep(&mut self, kind: Kind, answers: Vec<Breakpoint>) -> Answer {
        let ids = answers.iter().filter_map(|one| one.id);
        self.placed[kind as usize] = ids.collect();
        Ok(Some(json!({ "breakpoints": values(answers) })))
    }

    /// The number of the first column, as the client counts.
    pub(super) fn first_column(&self) -> i64 {
        i64::from(self.client.columns_start_at1)
    }

    /// The number of the first line, as the client counts.
    pub(super) fn first_line(&self) -> i64 {
        i64::from(self.client.lines_start_at1)
    }
}

fn place(
    debuggee: &mut Debuggee,
    wanted: &SourceBreakpoint,
    (base, first_column): (i64, i64),
    when: &When<'_>,
) -> Result<Placed, Refused> {
    let line = wanted.line.saturating_sub(base).saturating_add(1);
    let line = u32::try_from(line.max(1)).unwrap_or(u32::MAX);
    let column = wanted.column.map_or(1, |column| {
        let units = column.saturating_sub(first_column);
        shown::character(&debuggee.source, line, units)
    });
    let debugger = &mut debuggee.debugger;
    match text(&wanted.log_message) {
        Some(message) => debugger.log_at(line, column, when, message),
        None => debugger.break_at(line, column, when),
    }
}

fn answer(placed: Result<Placed, Refused>, lang: Lang, line: Option<i64>) -> Breakpoint {
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

fn values(answers: impl IntoIterator<Item = Breakpoint>) -> Vec<Value> {
    let answers = answers.into_iter();
    answers
        .filter_map(|one| serde_json::to_value(one).ok())
        .collect()
}

fn unverified(message: String, line: Option<i64>) -> Breakpoint {
    Breakpoint {
        message: Some(message),
        line,
        ..Breakpoint::default()
    }
}

/// A text that is there and says something.
fn text(of: &Option<String>) -> Option<&str> {
    of.as_deref().filter(|text| !text.trim().is_empty())
}

/// Whether two paths name one file, as far as their texts say.
fn same(one: &str, other: &str) -> bool {
    let parts = |path: &str| -> Vec<String> {
        let parts = path
            .split(['/', '\\'])
            .filter(|part| !matches!(*part, "" | "."));
        parts.map(str::to_owned).collect()
    };
    let (one, other) = (parts(one), parts(other));
    one.ends_with(&other) || other.ends_with(&one)
}
