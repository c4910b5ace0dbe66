//! What a client is shown where the program stands: calls, variables, the robot.

use super::message::{Scope, SourceFile, StackFrame, StackTrace, Variable, Variables};
use super::session::{Answer, Host, Session, THREAD};
use serde_json::{Value, json};
use tip_runtime::controller::Aim;
use tip_sim::debug::{self, Debugger, control};
use tip_sim::message::Debugging;
use tipc::message::Lang;
use tipc::program::VariableKind;
use tipc::source::Source;

/// What the numbers of lists of variables stand for.
const PROGRAM: i64 = 1;
const ROBOT: i64 = 2;
const LEGS: i64 = 3;
/// A variable of the program with members; its place is added.
const MEMBERS: i64 = 1000;

impl<H: Host> Session<H> {
    pub(super) fn threads(&mut self) -> Answer {
        let debuggee = self.debuggee.as_ref();
        let name = debuggee.map_or("T.I.P.", |debuggee| {
            debuggee.debugger.program().source_name()
        });
        Ok(Some(json!({ "threads": [{ "id": THREAD, "name": name }] })))
    }

    pub(super) fn stack_trace(&mut self, asked: &StackTrace) -> Answer {
        let (first_line, first_column) = (self.first_line(), self.first_column());
        let debuggee = self.standing()?;
        let file = SourceFile {
            name: Some(debuggee.debugger.program().source_name().to_owned()),
            path: Some(debuggee.path.clone()),
        };
        let all = debuggee.debugger.frames();
        let total = all.len();
        let frames = (1..).zip(all).map(|(id, frame)| StackFrame {
            id,
            name: frame
                .name
                .unwrap_or_else(|| debuggee.debugger.program().title().to_owned()),
            source: file.clone(),
            line: i64::from(frame.line) - 1 + first_line,
            column: column(&debuggee.source, frame.line, frame.column) - 1 + first_column,
        });
        let from = usize::try_from(asked.start_frame.unwrap_or(0)).unwrap_or(0);
        let levels = asked.levels.filter(|levels| *levels > 0);
        let levels = levels.map_or(usize::MAX, |levels| {
            usize::try_from(levels).unwrap_or(usize::MAX)
        });
        let frames: Vec<Value> = frames
            .skip(from)
            .take(levels)
            .filter_map(|frame| serde_json::to_value(frame).ok())
            .collect();
        Ok(Some(json!({ "stackFrames": frames, "totalFrames": total })))
    }

    pub(super) fn scopes(&mut self) -> Answer {
        self.standing()?;
        let debuggee = self.debuggee.as_ref();
        let count = debuggee.map(|it| it.debugger.program().variables().len());
        let scope = |name, variables_reference, presentation_hint| Scope {
            name: self.text(name),
            presentation_hint,
            variables_reference,
            // A client may ask for some of them.
            named_variables: count.filter(|_| variables_reference == PROGRAM),
            expensive: false,
        };
        let scopes = [
            scope(Debugging::Variables, PROGRAM, Some("locals")),
            scope(Debugging::Robot, ROBOT, None),
            scope(Debugging::Legs, LEGS, None),
        ];
        let scopes: Vec<Value> = scopes
            .iter()
            .filter_map(|scope| serde_json::to_value(scope).ok())
            .collect();
        Ok(Some(json!({ "scopes": scopes })))
    }

    pub(super) fn variables(&mut self, asked: &Variables) -> Answer {
        let lang = self.lang();
        let no_such_list = self.text(Debugging::NoSuchList);
        let debugger = &self.standing()?.debugger;
        let from = usize::try_from(asked.start.unwrap_or(0)).unwrap_or(usize::MAX);
        let count = asked.count.filter(|count| *count > 0).unwrap_or(u64::MAX);
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        let all = match asked.variables_reference {
            PROGRAM => {
                let all = (0..).zip(debugger.variables());
                let asked = all.skip(from).take(count);
                let shown = asked.filter_map(|(place, it)| {
                    serde_json::to_value(variable(place, &it, lang)).ok()
                });
                let shown: Vec<Value> = shown.collect();
                return Ok(Some(json!({ "variables": shown })));
            }
            ROBOT => robot(debugger, lang),
            LEGS => {
                let aims = debugger.run().aims();
                aims.iter().map(|it| aim(it, lang)).collect()
            }
            reference => {
                let place = reference.saturating_sub(MEMBERS);
                members(debugger, place, lang).ok_or(no_such_list)?
            }
        };
        let shown: Vec<Value> = all
            .iter()
            .skip(from)
            .take(count)
            .filter_map(|it| serde_json::to_value(it).ok())
            .collect();
        Ok(Some(json!({ "variables": shown })))
    }
}

/// The number of the list of a variable's members; 0 if it is a number itself.
pub(super) fn reference(place: i64, variable: &debug::Variable) -> i64 {
    match variable.kind {
        VariableKind::Var => 0,
        VariableKind::Pos | VariableKind::Joint => MEMBERS + place,
    }
}

/// A variable's value, or the values of its members.
pub(super) fn value(variable: &debug::Variable, lang: Lang) -> String {
    let scalars = variable.scalars.iter();
    let mut scalars = scalars.map(|(_, value)| number(*value, lang));
    match variable.kind {
        VariableKind::Var => scalars.next().unwrap_or_default(),
        VariableKind::Pos | VariableKind::Joint => {
            format!("({})", scalars.collect::<Vec<_>>().join(", "))
        }
    }
}

pub(super) fn number(value: Option<f64>, lang: Lang) -> String {
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
        name: name.clone(),
        value: number(*value, lang),
        kind: None,
        evaluate_name: Some(name.clone()),
        variables_reference: 0,
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

/// The time, and how the robot is.
fn robot(debugger: &Debugger, lang: Lang) -> Vec<Variable> {
    let plain = |name: Debugging, value| plain(name.in_lang(lang).to_string(), value);
    let run = debugger.run();
    let mut shown = vec![
        plain(Debugging::Cycle, debugger.now().to_string()),
        plain(Debugging::Time, format!("{} ms", run.time())),
    ];
    if let Some(motion) = run.motion() {
        let pose = motion.pose;
        let [x, y, z] = pose.position;
        let place = format!("({x:.1}, {y:.1}, {z:.1}) mm");
        shown.push(plain(Debugging::Pose, place));
        let (roll, pitch, yaw) = (pose.roll, pose.pitch, pose.yaw);
        let lean = format!("({roll:.2}, {pitch:.2}, {yaw:.2}) deg");
        shown.push(plain(Debugging::Lean, lean));
        shown.push(plain(Debugging::Falls, motion.falls.to_string()));
    }
    if let Some(limbs) = run.limbs() {
        for (leg, angles) in (1..).zip(&limbs.angles) {
            let angles = format!("{} deg", list(angles));
            shown.push(plain(Debugging::Angles { leg }, angles));
        }
        if !limbs.loads.is_empty() {
            let loads = format!("{} N", list(&limbs.loads));
            shown.push(plain(Debugging::Loads, loads));
        }
    }
    shown
}

fn list(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|value| format!("{value:.2}")).collect();
    format!("({})", values.join(", "))
}

fn aim(aim: &Aim, lang: Lang) -> Variable {
    let mode = control(aim.mode);
    let mode = mode.in_lang(lang);
    let goal = match aim.goal() {
        [] => String::new(),
        [one] => format!(" {one}"),
        several => format!(" {}", list(several)),
    };
    plain(aim.of.to_string(), format!("{mode}{goal}"))
}

/// A column in UTF-16 code units of one in characters; both from 1.
fn column(source: &Source, line: u32, column: u32) -> i64 {
    let line = source.line_text(line);
    let before = line.chars().take((column as usize).saturating_sub(1));
    let units: usize = before.map(char::len_utf16).sum();
    i64::try_from(units).unwrap_or(0) + 1
}

/// The column in characters, from 1, that so many UTF-16 code units come before.
pub(super) fn character(source: &Source, line: u32, units: i64) -> u32 {
    let mut left = usize::try_from(units).unwrap_or(0);
    let mut column = 1;
    for char in source.line_text(line).chars() {
        match left.checked_sub(char.len_utf16()) {
            Some(rest) => left = rest,
            None => break,
        }
        column += 1;
    }
    column
}
