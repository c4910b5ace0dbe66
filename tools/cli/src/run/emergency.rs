//! The report of an emergency stop as a diagnostic: its statement, its reason, and the values that led to it.

use crate::choices::{Format, OutputOptions};
use crate::message::Stopping;
use crate::output;
use crate::run::summary::seconds;
use serde_json::{Map, Value, json};
use tip_lint::load;
use tip_runtime::command::Target;
use tip_runtime::fault::Fault;
use tip_runtime::machine::Emergency;
use tip_runtime::program::Program as _;
use tip_sim::{Interpreter, Robot, RobotDescription, Run};
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::message::list::List;
use tipc::message::{Message, Structuring};
use tipc::source::{Encoding, Span};
use tipc::symbols::{Access, DefinitionKind, Use};
use tipc::{Loaded, Options, render};

/// A run after an emergency stop.
pub(super) struct Stopped<'a> {
    pub(super) emergency: Emergency,
    pub(super) run: &'a Run,
    pub(super) program: &'a Interpreter,
    /// The program as it was loaded.
    pub(super) loaded: &'a Loaded,
    pub(super) options: Options,
    pub(super) robot: &'a Robot,
    pub(super) description: &'a RobotDescription,
}

/// The last measured state of a joint, deg.
pub(super) struct JointState {
    pub(super) joint: Target,
    pub(super) angle: f64,
    pub(super) min: f64,
    pub(super) max: f64,
}

impl Stopped<'_> {
    /// Returns the report in the chosen format and language, with its line end.
    pub(super) fn report(&self, output_options: OutputOptions) -> String {
        let (source, lang) = (&self.loaded.source, output_options.lang());
        let values = Values::of(self.loaded, self.statement(), self.program);
        let diagnostic = self.diagnostic(&values);
        match output_options.message_format {
            Format::Short => render::short(source, &diagnostic, lang) + "\n",
            Format::Json => {
                let robot = Some(self.options.robot);
                let object = render::json(source, &diagnostic, robot, lang);
                let object = object.strip_suffix('}').unwrap_or(&object);
                format!("{object}{}}}\n", self.members(&values))
            }
            Format::Human | Format::Sarif => {
                let Emergency { step, cycle, .. } = self.emergency;
                let moment = Stopping::Moment {
                    step,
                    cycle: cycle.to_string().into(),
                    time: seconds(self.run.time()).into(),
                };
                let text = render::human(source, &diagnostic, output_options.style());
                format!("{text}{}\n", moment.in_lang(lang))
            }
        }
    }

    fn statement(&self) -> Option<usize> {
        self.loaded.module.statement_of(self.emergency.step)
    }

    fn place(&self) -> Span {
        span(self.loaded, self.statement())
    }

    fn diagnostic(&self, values: &Values) -> Diagnostic {
        let fault = self.emergency.fault;
        let code = Code::of_fault(&fault);
        let (reason, help) = self.reason(values);
        let mut diagnostic = Diagnostic::new(code, self.place(), reason);
        let (before, _) = code.template().split_once("{}").unwrap_or_default();
        if let Some(subject) = fault
            .to_string()
            .strip_prefix(before)
            .filter(|_| !before.is_empty())
        {
            diagnostic = diagnostic.about(subject);
        }
        let not_stopped = self.emergency.stop_fault.map(|fault| {
            let what = fault.to_string().into();
            Stopping::NotStopped { what }.into()
        });
        if let Some(help) = not_stopped.or(help) {
            diagnostic = diagnostic.help(help);
        }
        for (place, text) in values.at_places() {
            diagnostic = diagnostic.label(place, Stopping::Values { values: List(text) });
        }
        diagnostic
    }

    /// Returns the reason and the help.
    fn reason(&self, values: &Values) -> (Message, Option<Message>) {
        match self.emergency.fault {
            Fault::Domain => values
                .refused(self.loaded, self.statement(), &self.options)
                .unwrap_or((Stopping::NoResult.into(), None)),
            Fault::InvalidReturn => (
                Stopping::NoCall.into(),
                Some(Structuring::PutJumpAbove.into()),
            ),
            Fault::Unassigned(index) => {
                let scalar = self.program.scalar(index as usize);
                let name = scalar.map_or_else(Default::default, |(name, _)| name.into());
                let reason = Stopping::NoValue { name };
                (reason.into(), Some(Stopping::AssignFirst.into()))
            }
            Fault::InvalidMode => self.refused_mode(),
            Fault::TooDeep => (
                Stopping::TooDeep.into(),
                Some(Stopping::LeaveSubroutines.into()),
            ),
            Fault::WrongStep => (Stopping::NoStep.into(), None),
            Fault::JointLimit(leg, joint) => (self.at_limit(Target::Joint(leg, joint)), None),
            Fault::OutOfReach(target) => self.out_of_reach(target),
            Fault::Hardware(fault) => match self.run.plant_error() {
                Some(trouble) => (trouble.message().into(), None),
                None => {
                    let what = fault.to_string().into();
                    (Stopping::Broken { what }.into(), None)
                }
            },
            Fault::EmergencyKey => (Stopping::KeyPressed.into(), None),
            // Sensors: the message names the one that it is about.
            fault => {
                let text = fault.to_string();
                let sensor = text.rsplit(' ').next().unwrap_or_default().into();
                (Stopping::Nonsense { sensor }.into(), None)
            }
        }
    }

    /// Returns the last measured states of all joints, leg by leg.
    pub(super) fn joints(&self) -> impl Iterator<Item = JointState> {
        let joints = (1..).zip(&self.description.legs).flat_map(|(leg, limb)| {
            let joints = (1..).zip(&limb.joints);
            joints.map(move |(joint, _)| Target::Joint(leg, joint))
        });
        let states = joints.zip(self.run.limits()).zip(self.run.angles());
        states.map(|((joint, limits), angle)| JointState {
            joint,
            angle: rounded(*angle),
            min: limits.min,
            max: limits.max,
        })
    }

    fn at_limit(&self, joint: Target) -> Message {
        let Some(state) = self.joints().find(|state| state.joint == joint) else {
            return Stopping::OutOfReach { target: joint }.into();
        };
        let JointState {
            angle, min, max, ..
        } = state;
        Stopping::AtLimit {
            joint,
            angle,
            min,
            max,
        }
        .into()
    }

    /// Returns the angles of the leg of a target.
    pub(super) fn joints_of(&self, target: Target) -> Option<Message> {
        let (Target::Foot(leg) | Target::Joint(leg, _)) = target else {
            return None;
        };
        let is_of_leg = |it: &JointState| matches!(it.joint, Target::Joint(of, _) if of == leg);
        let states = self.joints().filter(is_of_leg);
        let joints = states.map(|it| format!("{} {} ({}…{})", it.joint, it.angle, it.min, it.max));
        let joints = List(joints.collect());
        Some(Stopping::JointsAre { joints }.into())
    }

    /// Returns the members of the JSON report beyond those of a diagnostic.
    fn members(&self, values: &Values) -> String {
        let Emergency { step, cycle, .. } = self.emergency;
        let joints = self.joints().map(|it| {
            let joint = it.joint.to_string();
            json!({ "joint": joint, "angle": it.angle, "min": it.min, "max": it.max })
        });
        let text = self.loaded.source.slice(self.place());
        let values: Map<String, Value> = values
            .scalars()
            .map(|(name, value)| (name.to_owned(), json!(value)))
            .collect();
        let members = [
            ("step", json!(step)),
            ("cycle", json!(cycle)),
            ("time", json!(self.run.time())),
            ("text", json!(text)),
            ("values", Value::Object(values)),
            ("joints", joints.collect()),
        ];
        let members = members.map(|(key, value)| format!(",{}:{value}", json!(key)));
        output::escaped(&members.concat())
    }
}

/// Rounds an angle for people.
fn rounded(angle: f64) -> f64 {
    (angle * 1000.0).round() / 1000.0
}

/// The values of the operands of a statement.
#[derive(Debug, Default)]
struct Values(Vec<Operand>);

/// An operand that names a variable or a member.
#[derive(Debug)]
struct Operand {
    /// Its sign and its name.
    place: Span,
    negative: bool,
    /// True if it is only read, so that its value could replace it.
    is_read: bool,
    /// The scalars that it stands for.
    scalars: Vec<(String, f64)>,
}

impl Values {
    /// Returns the values that a statement reads. A step that fails changes nothing, so that they are still there.
    fn of(loaded: &Loaded, statement: Option<usize>, program: &Interpreter) -> Self {
        let uses = loaded.symbols.within(span(loaded, statement)).iter();
        Values(
            uses.filter_map(|one| operand(loaded, one, program))
                .collect(),
        )
    }

    /// Returns every scalar once, with its value.
    fn scalars(&self) -> impl Iterator<Item = (&str, f64)> {
        let scalars = || self.0.iter().flat_map(|operand| &operand.scalars);
        let is_first = move |(at, (name, _)): &(usize, &(String, f64))| {
            !scalars().take(*at).any(|(other, _)| other == name)
        };
        let all = scalars().enumerate().filter(is_first);
        all.map(|(_, (name, value))| (name.as_str(), *value))
    }

    /// Returns the span of each operand with its values.
    fn at_places(&self) -> impl Iterator<Item = (Span, Vec<String>)> {
        self.0.iter().map(|operand| {
            let texts = operand
                .scalars
                .iter()
                .map(|(name, value)| format!("{name} = {value}"));
            (operand.place, texts.collect())
        })
    }

    /// Returns reason and help of the error that the compiler reports for the statement with these values as constants.
    fn refused(
        &self,
        loaded: &Loaded,
        statement: Option<usize>,
        options: &Options,
    ) -> Option<(Message, Option<Message>)> {
        let place = span(loaded, statement);
        let text = loaded.source.text();
        let mut constant = text.get(..place.start)?.to_owned();
        let mut at = place.start;
        for operand in self.0.iter().filter(|operand| operand.is_read) {
            if let [(_, value)] = operand.scalars.as_slice() {
                let sign = if operand.negative { -1.0 } else { 1.0 };
                constant += text.get(at..operand.place.start)?;
                constant += &(sign * value).to_string();
                at = operand.place.end;
            }
        }
        constant += text.get(at..place.end)?;
        let judged = place.start..constant.len() + 1;
        constant += text.get(place.end..)?;
        let options = Options {
            encoding: Encoding::Utf8,
            ..*options
        };
        let found = load(loaded.source.name(), constant.as_bytes(), &options).diagnostics;
        let refused =
            |one: &Diagnostic| one.code == Code::OutOfRange && judged.contains(&one.span.start);
        let diagnostic = found.into_iter().find(refused)?;
        Some((diagnostic.reason, diagnostic.help))
    }
}

fn span(loaded: &Loaded, statement: Option<usize>) -> Span {
    let statement = statement.and_then(|at| loaded.module.statements.get(at));
    statement
        .map(|statement| statement.span)
        .unwrap_or_default()
}

fn operand(loaded: &Loaded, one: &Use, program: &Interpreter) -> Option<Operand> {
    let definition = loaded.symbols.definition(one.definition);
    let is_value = matches!(definition.kind, DefinitionKind::Variable(_))
        && matches!(one.access, Access::Read | Access::Update | Access::Count);
    let place = is_value.then(|| one.operand(&loaded.source))?;
    let name = loaded
        .source
        .slice(place)
        .trim_matches(['-', '%'])
        .to_ascii_uppercase();
    let whole = format!("{name}.");
    let known = (0..).map_while(|at| program.scalar(at));
    let named = known.filter(|(scalar, _)| *scalar == name || scalar.starts_with(&whole));
    let scalars: Vec<_> = named
        .filter_map(|(name, value)| Some((name.to_owned(), value?)))
        .collect();
    (!scalars.is_empty()).then_some(Operand {
        place,
        negative: one.negative,
        is_read: one.access == Access::Read,
        scalars,
    })
}
