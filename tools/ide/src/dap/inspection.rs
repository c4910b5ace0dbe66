//! The state of a paused program: call stack, variables and robot, expressions, and changes of it from variables and the console.

use super::protocol::{
    Evaluate, SetVariable, SourceFile, StackFrame, StackTrace, Variable, Variables,
};
use super::{Answer, Launcher, MAIN, Session};
use crate::message::DebugAdapter;
use serde_json::{Value, json};
use tip_runtime::command::{Reading, TIMERS, Target};
use tip_runtime::controller::Setpoint;
use tip_sim::Event;
use tip_sim::debug::{self, DebugError, Debugger, Discard, Move, Value as Evaluated, control};
use tip_sim::message::Debugging;
use tipc::message::{Lang, Message};
use tipc::program::VariableKind;
use tipc::source::{Position, Source, Unit};

/// Number of frame ids of a thread.
const FRAMES: i64 = 100;

/// Returns the number of a thread of the program by its id; 0 is the main program.
pub(super) fn thread(id: Option<i64>) -> u8 {
    let thread = id.unwrap_or(MAIN) - MAIN;
    u8::try_from(thread).unwrap_or(0)
}

/// The references of lists of variables.
const PROGRAM: i64 = 1;
const ROBOT: i64 = 2;
const LEGS: i64 = 3;
/// The reference of the members of the first variable; the index of the variable is added.
const MEMBERS: i64 = 1000;

/// The prefix of a change that may discard later cycles.
const DISCARD: &str = "discard ";

impl<L: Launcher> Session<L> {
    pub(super) fn threads(&mut self) -> Answer {
        let Some(debuggee) = &self.debuggee else {
            return Ok(Some(
                json!({ "threads": [{ "id": MAIN, "name": "T.I.P." }] }),
            ));
        };
        let debugger = &debuggee.debugger;
        let main = debugger.program().source_name();
        let threads = debugger.threads().into_iter().map(|thread| {
            let name = debugger.thread_name(thread).unwrap_or(main);
            json!({ "id": MAIN + i64::from(thread), "name": name })
        });
        let threads: Vec<Value> = threads.collect();
        Ok(Some(json!({ "threads": threads })))
    }

    pub(super) fn stack_trace(&mut self, asked: &StackTrace) -> Answer {
        let (first_line, first_column) = (self.first_line(), self.first_column());
        let debuggee = self.paused()?;
        let file = SourceFile {
            name: Some(debuggee.debugger.program().source_name().to_owned()),
            path: Some(debuggee.path.clone()),
        };
        let thread = thread(asked.thread_id);
        let all = debuggee.debugger.frames(thread);
        let total = all.len();
        let debugger = &debuggee.debugger;
        let outermost = debugger.thread_name(thread);
        let outermost = outermost.unwrap_or(debugger.program().title());
        let first = i64::from(thread) * FRAMES + 1;
        let units = [Unit::Character, Unit::Utf16];
        let column_of = |line, of| i64::from(column(&debuggee.source, line, of, units));
        let frames = (first..).zip(all).map(|(id, frame)| StackFrame {
            id,
            name: frame.name.unwrap_or_else(|| outermost.to_owned()),
            source: file.clone(),
            line: i64::from(frame.line) - 1 + first_line,
            column: column_of(frame.line, frame.column) - 1 + first_column,
        });
        let from = usize::try_from(asked.start_frame.unwrap_or(0)).unwrap_or(0);
        let levels = asked.levels.filter(|levels| *levels > 0);
        let levels = levels.map_or(usize::MAX, |levels| {
            usize::try_from(levels).unwrap_or(usize::MAX)
        });
        let frames: Vec<StackFrame> = frames.skip(from).take(levels).collect();
        Ok(Some(json!({ "stackFrames": frames, "totalFrames": total })))
    }

    pub(super) fn scopes(&mut self) -> Answer {
        self.paused()?;
        let debuggee = self.debuggee.as_ref();
        let count = debuggee.map(|it| it.debugger.program().variables().len());
        let scope = |name: Message, reference: i64| {
            let name = self.text(name);
            json!({ "name": name, "variablesReference": reference, "expensive": false })
        };
        let mut variables = scope(Debugging::Variables.into(), PROGRAM);
        variables["presentationHint"] = json!("locals");
        // A client may ask for some of them.
        variables["namedVariables"] = json!(count);
        let robot = scope(DebugAdapter::Robot.into(), ROBOT);
        let legs = scope(Debugging::Legs.into(), LEGS);
        Ok(Some(json!({ "scopes": [variables, robot, legs] })))
    }

    pub(super) fn variables(&mut self, asked: &Variables) -> Answer {
        let lang = self.lang();
        let no_such_list = self.text(DebugAdapter::NoSuchList);
        let debugger = &self.paused()?.debugger;
        let from = usize::try_from(asked.start.unwrap_or(0)).unwrap_or(usize::MAX);
        let count = asked.count.filter(|count| *count > 0).unwrap_or(u64::MAX);
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        let all = match asked.variables_reference {
            PROGRAM => {
                let all = (0..).zip(debugger.variables());
                all.map(|(place, it)| variable(place, &it, lang)).collect()
            }
            ROBOT => robot(debugger, lang),
            LEGS => {
                let setpoints = debugger.run().setpoints();
                setpoints.iter().map(|it| aim(it, lang)).collect()
            }
            reference => {
                let place = reference.saturating_sub(MEMBERS);
                members(debugger, place, lang).ok_or(no_such_list)?
            }
        };
        let shown: Vec<Variable> = all.into_iter().skip(from).take(count).collect();
        Ok(Some(json!({ "variables": shown })))
    }

    pub(super) fn set_variable(&mut self, asked: &SetVariable) -> Answer {
        let debugger = &self.paused()?.debugger;
        let value = match asked.value.trim().parse::<f64>() {
            Ok(value) => value,
            Err(_) => match debugger.evaluate(&asked.value) {
                Ok(Evaluated::Number(value)) => value,
                Ok(Evaluated::Truth(_)) => {
                    let text = asked.value.trim().to_owned().into();
                    return Err(self.text(DebugAdapter::Truth { text }));
                }
                Err(refused) => return Err(refused.text(self.lang())),
            },
        };
        let name = asked.name.trim().to_ascii_uppercase();
        self.change(Event::Set(name.clone(), value), Discard::Nothing)?;
        let lang = self.lang();
        let debugger = &self.paused()?.debugger;
        let value = debugger.value(&name).ok().flatten();
        Ok(Some(json!({ "value": number(value, lang) })))
    }

    /// Applies an event. One that would discard later cycles is refused at first; repeating it confirms it.
    fn change(&mut self, event: Event, discard: Discard) -> Result<(), String> {
        let lang = self.lang();
        let confirmed = self.unconfirmed.take();
        let debugger = &mut self.paused()?.debugger;
        let this = (debugger.now(), event.to_string());
        let discard = match confirmed.as_ref() == Some(&this) {
            true => Discard::Later,
            false => discard,
        };
        match debugger.happens(event, discard) {
            Ok(()) => {
                if self.client.supports_invalidated_event {
                    self.event("invalidated", Some(json!({ "areas": ["all"] })));
                }
                Ok(())
            }
            Err(refused @ DebugError::WouldDiscard(_)) => {
                self.unconfirmed = Some(this);
                let refused = refused.text(lang).into();
                let again = DebugAdapter::AgainConfirms { refused };
                Err(again.in_lang(lang).to_string())
            }
            Err(refused) => Err(refused.text(lang)),
        }
    }

    /// Evaluates an expression; in the console, also applies an event, `N = 5`, or goes to a cycle, `to 300`.
    pub(super) fn evaluate(&mut self, asked: &Evaluate) -> Answer {
        let text = asked.expression.trim();
        if asked.context.as_deref() == Some("repl")
            && let Some(done) = self.command(text)
        {
            done?;
            return Ok(Some(json!({ "result": "", "variablesReference": 0 })));
        }
        let lang = self.lang();
        let debugger = &self.paused()?.debugger;
        let name = text.to_ascii_uppercase();
        let variables = debugger.variables();
        if let Some((place, variable)) = (0..).zip(&variables).find(|(_, it)| it.name == name) {
            return Ok(Some(json!({
                "result": value(variable, lang),
                "variablesReference": reference(place, variable),
            })));
        }
        let result = match debugger.value(text) {
            Ok(value) => number(value, lang),
            Err(_) => match debugger.evaluate(text) {
                Ok(Evaluated::Number(value)) => value.to_string(),
                Ok(Evaluated::Truth(truth)) => truth.to_string(),
                Err(refused) => return Err(refused.text(lang)),
            },
        };
        Ok(Some(json!({ "result": result, "variablesReference": 0 })))
    }

    /// Runs a line of the console; `None` if it is not a command.
    fn command(&mut self, text: &str) -> Option<Result<(), String>> {
        if let Some(cycle) = text.strip_prefix("to ") {
            let cycle = cycle.trim().parse().ok()?;
            self.has_moved = true;
            return Some(self.go(Move::To(cycle)).map(|_| ()));
        }
        let (discard, rest) = match text.strip_prefix(DISCARD) {
            Some(rest) => (Discard::Later, rest.trim()),
            None => (Discard::Nothing, text),
        };
        let event = match rest.parse() {
            Ok(event) => event,
            Err(_) => self.paused().ok()?.debugger.assignment(rest)?,
        };
        Some(self.change(event, discard))
    }
}

/// Returns the reference of the members of a variable; 0 if it is a number.
fn reference(place: i64, variable: &debug::Variable) -> i64 {
    match variable.kind {
        VariableKind::Var => 0,
        VariableKind::Pos | VariableKind::Joint => MEMBERS + place,
    }
}

/// Returns the value of a variable, or the values of its members.
fn value(variable: &debug::Variable, lang: Lang) -> String {
    let scalars = variable.scalars.iter();
    let mut scalars = scalars.map(|(_, value)| number(*value, lang));
    match variable.kind {
        VariableKind::Var => scalars.next().unwrap_or_default(),
        VariableKind::Pos | VariableKind::Joint => {
            format!("({})", scalars.collect::<Vec<_>>().join(", "))
        }
    }
}

fn number(value: Option<f64>, lang: Lang) -> String {
    let unassigned = || Debugging::Unassigned.in_lang(lang).to_string();
    value.map_or_else(unassigned, |value| value.to_string())
}

fn variable(place: i64, it: &debug::Variable, lang: Lang) -> Variable {
    Variable {
        name: it.name.clone(),
        value: value(it, lang),
        kind: Some(match it.kind {
            VariableKind::Var => "VAR",
            VariableKind::Pos => "POS",
            VariableKind::Joint => "JOINT",
        }),
        evaluate_name: Some(it.name.clone()),
        variables_reference: reference(place, it),
    }
}

fn members(debugger: &Debugger, place: i64, lang: Lang) -> Option<Vec<Variable>> {
    let variables = debugger.variables();
    let variable = variables.get(usize::try_from(place).ok()?)?;
    let member = |(name, value): &(String, Option<f64>)| Variable {
        evaluate_name: Some(name.clone()),
        ..plain(name.clone(), number(*value, lang))
    };
    Some(variable.scalars.iter().map(member).collect())
}

fn plain(name: String, value: String) -> Variable {
    Variable {
        name,
        value,
        kind: None,
        evaluate_name: None,
        variables_reference: 0,
    }
}

/// Returns time, pose, falls, angles and loads.
fn robot(debugger: &Debugger, lang: Lang) -> Vec<Variable> {
    let plain = |name: DebugAdapter, value| plain(name.in_lang(lang).to_string(), value);
    let run = debugger.run();
    let mut shown = vec![
        plain(DebugAdapter::Cycle, debugger.now().to_string()),
        plain(DebugAdapter::Time, format!("{} ms", run.time())),
    ];
    for n in (0..TIMERS).filter(|n| run.timer(*n) > 0.0) {
        let timer = Reading::Timer(n).to_string();
        shown.push(self::plain(timer, format!("{} ms", run.timer(n))));
    }
    let locked: Vec<String> = run.locked().iter().map(Target::to_string).collect();
    if !locked.is_empty() {
        shown.push(plain(DebugAdapter::Locked, locked.join(" ")));
    }
    if let Some(motion) = run.motion() {
        let pose = motion.pose;
        let [x, y, z] = pose.position;
        let place = format!("({x:.1}, {y:.1}, {z:.1}) mm");
        shown.push(plain(DebugAdapter::Pose, place));
        let (roll, pitch, yaw) = (pose.roll, pose.pitch, pose.yaw);
        let lean = format!("({roll:.2}, {pitch:.2}, {yaw:.2}) deg");
        shown.push(plain(DebugAdapter::Lean, lean));
        shown.push(plain(DebugAdapter::Falls, motion.falls.to_string()));
    }
    if let Some(limbs) = run.limbs() {
        for (leg, angles) in (1..).zip(&limbs.angles) {
            let angles = format!("{} deg", list(angles));
            shown.push(plain(DebugAdapter::Angles { leg }, angles));
        }
        if !limbs.loads.is_empty() {
            let loads = format!("{} N", list(&limbs.loads));
            shown.push(plain(DebugAdapter::Loads, loads));
        }
    }
    shown
}

fn list(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|value| format!("{value:.2}")).collect();
    format!("({})", values.join(", "))
}

fn aim(aim: &Setpoint, lang: Lang) -> Variable {
    let mode = control(aim.mode);
    let mode = mode.in_lang(lang);
    let goal = match aim.goal() {
        [] => String::new(),
        [one] => format!(" {one}"),
        several => format!(" {}", list(several)),
    };
    plain(aim.of.to_string(), format!("{mode}{goal}"))
}

/// Converts a column from one unit to another; both count from 1.
pub(super) fn column(source: &Source, line: u32, column: u32, [from, to]: [Unit; 2]) -> u32 {
    let offset = source.offset(Position { line, column }, from);
    source.position(offset, to).column
}
