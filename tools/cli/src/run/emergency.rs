//! An emergency stop, reported as findings are: its place, its reason, and the values that led to it.

use super::super::choices::Format;
use super::super::output;
use super::super::shown::Shown;
use super::summary::seconds;
use super::values::Values;
use crate::message::Stopping;
use serde_json::{Map, Value, json};
use tip_runtime::command::Target;
use tip_runtime::fault::Fault;
use tip_runtime::machine::Emergency;
use tip_runtime::program::Program as _;
use tip_sim::{Anatomy, Interpreter, Run};
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::message::list::List;
use tipc::message::{Message, Structuring};
use tipc::render;
use tipc::source::Span;
use tipc::{Loaded, Options};

/// A run that an emergency stop has ended, and what is known of it.
pub(super) struct Stopped<'a> {
    pub(super) emergency: Emergency,
    pub(super) run: &'a Run,
    pub(super) program: &'a Interpreter,
    /// The program as it was loaded.
    pub(super) loaded: &'a Loaded,
    pub(super) options: Options,
    pub(super) anatomy: &'a Anatomy,
}

/// A joint as it was measured last: deg.
struct JointState {
    joint: Target,
    angle: f64,
    min: f64,
    max: f64,
}

impl Stopped<'_> {
    /// The report, in the form and the language that are asked for, with its line end.
    pub(super) fn report(&self, shown: Shown) -> String {
        let (source, lang) = (&self.loaded.source, shown.lang());
        let values = Values::of(self.loaded, self.statement(), self.program);
        let finding = self.finding(&values);
        match shown.message_format {
            Format::Short => render::short(source, &finding, lang) + "\n",
            Format::Json => {
                let robot = Some(self.options.robot);
                let object = render::json(source, &finding, robot, lang);
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
                let text = render::human(source, &finding, shown.style());
                format!("{text}{}\n", moment.in_lang(lang))
            }
        }
    }

    fn statement(&self) -> Option<usize> {
        self.loaded.module.statement_of(self.emergency.step)
    }

    fn place(&self) -> Span {
        let statements = &self.loaded.module.statements;
        let statement = self.statement().and_then(|at| statements.get(at));
        statement
            .map(|statement| statement.span)
            .unwrap_or_default()
    }

    fn finding(&self, values: &Values) -> Diagnostic {
        let fault = self.emergency.fault;
        let code = Code::of_fault(&fault);
        let (reason, help) = self.reason(values);
        let mut finding = Diagnostic::new(code, self.place(), reason);
        let (before, _) = code.template().split_once("{}").unwrap_or_default();
        if let Some(subject) = fault
            .to_string()
            .strip_prefix(before)
            .filter(|_| !before.is_empty())
        {
            finding = finding.about(subject);
        }
        if let Some(help) = help {
            finding = finding.help(help);
        }
        for (place, text) in values.at_places() {
            finding = finding.label(place, Stopping::Values { values: List(text) });
        }
        finding
    }

    /// What is wrong, and what to do about it.
    fn reason(&self, values: &Values) -> (Message, Option<Message>) {
        match self.emergency.fault {
            Fault::Domain => match values.refused(self.loaded, self.statement(), &self.options) {
                Some((reason, help)) => (reason, help),
                None => (Stopping::NoResult.into(), None),
            },
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
            Fault::InvalidMode => (Stopping::OtherMode.into(), None),
            Fault::TooDeep => (
                Stopping::TooDeep.into(),
                Some(Stopping::LeaveSubroutines.into()),
            ),
            Fault::WrongStep => (Stopping::NoStep.into(), None),
            Fault::JointLimit(leg, joint) => (self.at_limit(Target::Joint(leg, joint)), None),
            Fault::OutOfReach(target) => (
                Stopping::OutOfReach { target }.into(),
                self.joints_of(target),
            ),
            Fault::Hardware(what) => match self.run.plant_error() {
                Some(trouble) => (trouble.message().into(), None),
                None => (Stopping::Broken { what }.into(), None),
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
}

impl Stopped<'_> {
    /// The joints as they were measured last, leg by leg.
    fn joints(&self) -> impl Iterator<Item = JointState> {
        let limits = (1..).zip(&self.anatomy.legs).flat_map(|(leg, limb)| {
            let joints = (1..).zip(&limb.joints);
            joints.map(move |(joint, of)| (Target::Joint(leg, joint), of.limits))
        });
        let states = limits.zip(self.run.angles());
        states.map(|((joint, limits), angle)| JointState {
            joint,
            angle: rounded(*angle),
            min: limits.min,
            max: limits.max,
        })
    }

    fn at_limit(&self, joint: Target) -> Message {
        let state = self.joints().find(|state| state.joint == joint);
        state.map_or(
            Stopping::OutOfReach { target: joint }.into(),
            |JointState {
                 angle, min, max, ..
             }| {
                Stopping::AtLimit {
                    joint,
                    angle,
                    min,
                    max,
                }
                .into()
            },
        )
    }

    /// How the leg of a target stands.
    fn joints_of(&self, target: Target) -> Option<Message> {
        let (Target::Foot(leg) | Target::Joint(leg, _)) = target else {
            return None;
        };
        let is_of_leg =
            |state: &JointState| matches!(state.joint, Target::Joint(of, _) if of == leg);
        let states = self.joints().filter(is_of_leg);
        let joints = states.map(
            |JointState {
                 joint,
                 angle,
                 min,
                 max,
             }| format!("{joint} {angle} ({min}…{max})"),
        );
        Some(
            Stopping::JointsAre {
                joints: List(joints.collect()),
            }
            .into(),
        )
    }

    /// What the report says beside a finding.
    fn members(&self, values: &Values) -> String {
        let Emergency { step, cycle, .. } = self.emergency;
        let joints = self.joints().map(
            |JointState {
                 joint,
                 angle,
                 min,
                 max,
             }| {
                json!({ "joint": joint.to_string(), "angle": angle, "min": min, "max": max })
            },
        );
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

/// Of an angle, as much as is worth reading.
fn rounded(angle: f64) -> f64 {
    (angle * 1000.0).round() / 1000.0
}
