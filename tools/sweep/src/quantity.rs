//! Quantities that a sweep varies: their names, and the ways to apply a value to a run.

use crate::columns::{Column, Meaning, Measure};
use crate::error::{SweepError, Sweeping, Texts};
use tip_runtime::command::Port;
use tipc::analysis::{access, flow::Flow};
use tipc::description::{Key, Part};
use tipc::message::Lang;
use tipc::program::{Action, Operand, Program, ScalarExpression, StepId};
use toml::{Table, Value};

/// A quantity that varies.
///
/// | name | quantity | unit |
/// |---|---|---|
/// | `STRIDE`, `P.X` | a scalar of the program | as the program uses it |
/// | `friction` | the floor's coefficient of friction, short for `scene.floor.friction` | |
/// | `scene.KEY` | a number of the scene file, such as `scene.floor.slope.1` or `scene.block.1.height`; elements of lists count from 1 | as in the file |
/// | `robot.KEY` | a number of the robot's description, such as `robot.body.mass` | as in the file |
/// | `push.x`, `push.y`, `push.z` | a force on the body, along an axis of the world | N |
/// | `push.at`, `push.for` | start and duration of that force; 1 s and 0.2 s if they do not vary | s |
/// | `noise.angle`, `noise.sole` | standard deviation of measured joint angles, and of soles | deg, V |
/// | `sensor.VR1` | the reading of an input from the first cycle on | V |
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// A scalar of the program, by its place among all scalars.
    Variable(usize),
    /// A number of the scene file, by its path.
    Scene(Vec<String>),
    /// A number of the robot's description, by its path.
    Robot(Vec<String>),
    /// A push.
    Push(Push),
    /// Noise of a kind of sensor.
    Noise(Noise),
    /// The reading of an input.
    Sensor(Port),
}

/// A property of a push.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Push {
    /// Force along an axis of the world (0 is x), N.
    Force(usize),
    /// Start, s.
    At,
    /// Duration, s.
    For,
}

/// A kind of sensor that has noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Noise {
    /// Joint angles, deg.
    Angle,
    /// Soles, V.
    Sole,
}

/// Names of quantities that every robot has.
const NAMES: [(&str, Quantity); 7] = [
    ("push.x", Quantity::Push(Push::Force(0))),
    ("push.y", Quantity::Push(Push::Force(1))),
    ("push.z", Quantity::Push(Push::Force(2))),
    ("push.at", Quantity::Push(Push::At)),
    ("push.for", Quantity::Push(Push::For)),
    ("noise.angle", Quantity::Noise(Noise::Angle)),
    ("noise.sole", Quantity::Noise(Noise::Sole)),
];

impl Quantity {
    /// Finds a quantity by its name.
    ///
    /// # Errors
    /// There is no such quantity; the error suggests the nearest name.
    pub(crate) fn find(name: &str, program: &Program) -> Result<Self, SweepError> {
        if let Some((_, quantity)) = NAMES.iter().find(|(known, _)| *known == name) {
            return Ok(quantity.clone());
        }
        if name == "friction" {
            return Ok(Quantity::Scene(keys("floor.friction")));
        }
        if let Some(path) = name.strip_prefix("scene.") {
            return Ok(Quantity::Scene(keys(path)));
        }
        if let Some(path) = name.strip_prefix("robot.") {
            return Ok(Quantity::Robot(keys(path)));
        }
        if let Some(input) = name.strip_prefix("sensor.") {
            let input = input.to_owned();
            let unknown = |_| {
                let input = input.clone();
                SweepError::axis(name, Sweeping::NotAnInput { input })
            };
            let port = input.to_ascii_uppercase().parse().map_err(unknown)?;
            return Ok(Quantity::Sensor(port));
        }
        let scalars: Vec<String> = program.scalar_names().collect();
        let wanted = name.to_ascii_uppercase();
        if let Some(scalar) = scalars.iter().position(|scalar| *scalar == wanted) {
            return Ok(Quantity::Variable(scalar));
        }
        if program.constants().iter().any(|(name, _)| *name == wanted) {
            return Err(SweepError::axis(name, Sweeping::IsConstant));
        }
        let known = scalars
            .iter()
            .map(String::as_str)
            .chain(NAMES.iter().map(|(known, _)| *known))
            .chain(["friction"]);
        // The name may be a key without the name of its file.
        if name == "floor.friction" {
            let near = SweepError::from(Sweeping::UnknownQuantity).near("friction".to_owned());
            return Err(SweepError::axis(name, near));
        }
        for (file, parts) in [("scene", Part::SCENE), ("robot", Part::ALL)] {
            if name.contains('.') && key(parts, &keys(name)).is_some() {
                let near =
                    SweepError::from(Sweeping::UnknownQuantity).near(format!("{file}.{name}"));
                return Err(SweepError::axis(name, near));
            }
        }
        let unknown = SweepError::from(Sweeping::UnknownQuantity).suggest(name, known);
        Err(SweepError::axis(name, unknown))
    }
}

fn keys(path: &str) -> Vec<String> {
    path.split('.').map(str::to_owned).collect()
}

impl Quantity {
    /// Returns the column of an axis that varies the quantity.
    pub(crate) fn column(&self, axis: usize, name: &str) -> Column {
        let mut column = Measure::Axis(axis).column(name);
        let (unit, meaning) = match self {
            Quantity::Variable(_) => ("", Meaning::Variable),
            Quantity::Push(Push::Force(_)) => ("N", Meaning::Force),
            Quantity::Push(Push::At) => ("s", Meaning::ForceStart),
            Quantity::Push(Push::For) => ("s", Meaning::ForceTime),
            Quantity::Noise(Noise::Angle) => ("deg", Meaning::AngleNoise),
            Quantity::Noise(Noise::Sole) => ("V", Meaning::SoleNoise),
            Quantity::Sensor(_) => ("V", Meaning::Reading),
            Quantity::Scene(path) => return of_file(column, key(Part::SCENE, path)),
            Quantity::Robot(path) => return of_file(column, key(Part::ALL, path)),
        };
        column.unit = unit;
        column.meaning = meaning.into();
        column
    }
}

/// Gives a column unit and meaning of a key of a file.
fn of_file(mut column: Column, key: Option<&Key>) -> Column {
    if let Some(key) = key {
        column.unit = key.unit();
        let of = |lang: Lang| lang.pick(key.meaning.english, key.meaning.japanese);
        column.meaning = Texts::of(|lang| of(lang).to_owned());
    }
    column
}

/// Returns the key at a path of a file with these tables.
fn key(tables: &[Part], path: &[String]) -> Option<&'static Key> {
    // Numbers are indices in lists, not keys.
    let is_key = |word: &&String| word.parse::<usize>().is_err();
    let mut keys = path.iter().rev().filter(is_key);
    let (key, table) = (keys.next()?, keys.next().map_or("", String::as_str));
    let is_table = |part: &&Part| part.name().trim_matches(['[', ']']) == table;
    let mut keys = tables.iter().find(is_table)?.keys();
    keys.find(|known| *key == known.name)
}

/// The places where a varied scalar gets its value.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Override {
    /// Steps that assign a constant to it before any step reads it.
    pub(crate) steps: Vec<StepId>,
    /// True if a path reads the scalar before any step assigns it: then it gets the value at the start.
    pub(crate) at_start: bool,
}

impl Override {
    /// Finds the constant assignments to a scalar that come before its first use on some path of the program or of a thread.
    ///
    /// # Errors
    /// A path assigns a computed value first; the error names its line.
    pub(crate) fn of(program: &Program, scalar: usize) -> Result<Self, u32> {
        let flow = Flow::of(program);
        let returns: Vec<usize> = flow.calls().map(|call| call.back).collect();
        // For each node, true if it was reached with the scalar unassigned, and with it assigned.
        let mut seen = vec![[false; 2]; flow.nodes().len()];
        // A thread may come to its first use before or after an assignment of another one.
        let starts = flow.starts().iter();
        let mut open: Vec<_> = starts.map(|start| (*start, false)).collect();
        let mut found = Override::default();
        while let Some((id, mut is_assigned)) = open.pop() {
            let node = &flow.nodes()[id];
            if std::mem::replace(&mut seen[id][usize::from(is_assigned)], true) {
                continue;
            }
            let step = &program.steps()[node.step as usize];
            let mut is_read = false;
            if !node.is_passed {
                access::reads(program, &step.action, |read| is_read |= read == scalar);
            }
            if is_read {
                found.at_start |= !is_assigned;
                continue;
            }
            if access::assigns(program, &step.action).contains(&scalar) {
                let Action::SetScalar {
                    update: None,
                    value: ScalarExpression::Operand(Operand::Constant(_)),
                    ..
                } = &step.action
                else {
                    return Err(step.line);
                };
                found.steps.push(node.step);
                is_assigned = true;
            }
            let called = node.call.iter().map(|call| call.entry);
            let returned = returns.iter().filter(|_| node.returns);
            let next = node.next.iter().chain(returned).copied().chain(called);
            open.extend(next.map(|id| (id, is_assigned)));
        }
        found.steps.sort_unstable();
        found.steps.dedup();
        Ok(found)
    }
}

/// A TOML file whose numbers vary.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    table: Table,
    /// The tables that the file may have.
    parts: &'static [Part],
}

impl Settings {
    /// Reads a file with these tables.
    ///
    /// # Errors
    /// It is not TOML.
    pub(crate) fn read(text: &str, parts: &'static [Part]) -> Result<Self, SweepError> {
        let table = text.parse().map_err(SweepError::says)?;
        Ok(Settings { table, parts })
    }

    /// Sets the number at a path; elements of lists count from 1. A list that is missing in the file gets its default.
    ///
    /// # Errors
    /// The path leads through a number or beyond a list's end.
    pub(crate) fn set(&mut self, path: &[String], number: f64) -> Result<(), Sweeping> {
        let mut file = Value::Table(std::mem::take(&mut self.table));
        let default = || default_list(self.parts, path);
        let done = put(&mut file, path, number, &default);
        if let Value::Table(table) = file {
            self.table = table;
        }
        done
    }

    /// Writes the file.
    pub(crate) fn text(&self) -> String {
        self.table.to_string()
    }
}

/// Returns the default of the list at a path; `None` if the key is required or no list.
fn default_list(parts: &[Part], path: &[String]) -> Option<Value> {
    let text = key(parts, path)?.default?;
    let list: Value = toml::from_str::<Table>(&format!("list = {text}"))
        .ok()?
        .remove("list")?;
    list.is_array().then_some(list)
}

fn put(
    value: &mut Value,
    path: &[String],
    number: f64,
    default: &dyn Fn() -> Option<Value>,
) -> Result<(), Sweeping> {
    let Some((key, rest)) = path.split_first() else {
        *value = Value::Float(number);
        return Ok(());
    };
    match value {
        Value::Table(table) => {
            let in_list = rest.first().filter(|word| word.parse::<usize>().is_ok());
            let new = match in_list.filter(|_| !table.contains_key(key)) {
                None => Value::Table(Table::new()),
                Some(index) if rest.len() > 1 => {
                    return Err(Sweeping::NoElement {
                        index: index.clone(),
                    });
                }
                Some(index) => {
                    let missing = || Sweeping::NoElement {
                        index: index.clone(),
                    };
                    default().ok_or_else(missing)?
                }
            };
            let value = table.entry(key.clone()).or_insert(new);
            put(value, rest, number, default)
        }
        Value::Array(list) => {
            let index = key.parse::<usize>().ok();
            let index = index.and_then(|index| index.checked_sub(1));
            match index.and_then(|index| list.get_mut(index)) {
                Some(element) => put(element, rest, number, default),
                None => Err(Sweeping::NoElement { index: key.clone() }),
            }
        }
        _ => Err(Sweeping::NoKey { key: key.clone() }),
    }
}
