//! A sweep that is ready to run.

use crate::columns::{self, Column, LIMIT, Measure, Row};
use crate::error::{SweepError, Sweeping, Texts};
use crate::measure::{Figures, Schema};
use crate::quantity::{Noise, Override, Push, Quantity, Settings};
use crate::spec::{Draw, PlantSpec, Spec, Values, noise_seed};
use std::collections::HashMap;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};
use tip_runtime::machine::Status;
use tip_runtime::plant::{self, Scene};
use tip_runtime::program::{End, Program as _};
use tip_sim::{Event, Events, Interpreter, ProgramRunner, Replacement, Robot, Run, Timed};
use tipc::Loaded;
use tipc::analysis::access;
use tipc::description::Part;
use tipc::language::Keyword;
use tipc::program::Program;

/// Largest number of cases.
const CASE_LIMIT: u64 = 1_000_000_000;

/// Largest number of robots that are kept for cases with the same one.
const KEPT_ROBOTS: usize = 100;

/// Start of a push that does not vary, s.
const PUSH_AT: f64 = 1.0;
/// Duration of a push that does not vary, s.
const PUSH_FOR: f64 = 0.2;

/// A checked specification: program, robot and axes. Copies share what is large; each thread has its own.
#[derive(Clone)]
pub struct Sweep {
    spec: Spec,
    program: Arc<Program>,
    engine: Engine,
    names: Vec<String>,
    events: Events,
    robot: Robot,
    /// The description of the robot, if one of its numbers varies.
    description: Option<Settings>,
    /// Some robots of descriptions with other numbers, by the bits of these numbers.
    described: Arc<Mutex<HashMap<Vec<u64>, Robot>>>,
    /// The scene file, if one of its numbers varies.
    scene: Option<Settings>,
    axes: Vec<Axis>,
    cases: u64,
    /// The columns of the table.
    schema: Schema,
    /// True if the robot walks without mass.
    is_massless: bool,
}

/// Makes the program of a run.
type Engine = Arc<dyn Fn() -> ProgramRunner + Send + Sync>;

#[derive(Clone, Debug)]
struct Axis {
    name: String,
    quantity: Quantity,
    /// The listed values; none for a random axis.
    list: Option<Vec<f64>>,
    values: Values,
    start: Override,
}

impl Axis {
    /// Returns the least and the greatest value, if there are such.
    fn bounds(&self) -> Option<(f64, f64)> {
        match (&self.values, &self.list) {
            (Values::Uniform { low, high }, _) => Some((*low, *high)),
            (_, Some(list)) => {
                let wider =
                    |(low, high): (f64, f64), value: &f64| (value.min(low), value.max(high));
                Some(list.iter().fold((list[0], list[0]), wider))
            }
            _ => None,
        }
    }

    /// Returns true if a deviation or a time is below 0.
    fn is_below_zero(&self) -> bool {
        let is_length = matches!(
            self.quantity,
            Quantity::Noise(_) | Quantity::Push(Push::At | Push::For)
        );
        is_length && self.bounds().is_some_and(|(low, _)| low < 0.0)
    }
}

/// A case: the values of all axes, and the robot in its scene.
#[derive(Clone, Debug)]
pub struct Case {
    /// The number of the case, from 0.
    pub number: u64,
    /// The value of each axis.
    pub values: Vec<f64>,
    /// The robot.
    pub robot: Robot,
}

impl Sweep {
    /// Checks a specification.
    ///
    /// # Errors
    /// The first thing that is wrong: a program or robot with errors, an unknown axis, an empty range, too many cases.
    pub fn new(spec: Spec) -> Result<Self, SweepError> {
        let (robot, description) = spec.robot.load()?;
        let loaded = tip_sim::load(&spec.program.name, &spec.program.text, &robot);
        let loaded = loaded.map_err(|error| SweepError::found(error.loaded()))?;
        let program = Arc::clone(loaded.program());
        let names: Vec<String> = program.scalar_names().collect();
        let events: Events = spec.events.parse().map_err(SweepError::says)?;
        let mut axes: Vec<Axis> = Vec::new();
        for axis in &spec.vary {
            let new = axis_of(axis, &program)?;
            if axes.iter().any(|other| other.quantity == new.quantity) {
                return Err(SweepError::axis(&axis.name, Sweeping::VariedTwice));
            }
            if new.is_below_zero() {
                return Err(SweepError::axis(&axis.name, Sweeping::Negative));
            }
            axes.push(new);
        }
        let varies = |kind: fn(&Quantity) -> bool| axes.iter().any(|axis| kind(&axis.quantity));
        let description = match (varies(|of| matches!(of, Quantity::Robot(_))), description) {
            (false, _) => None,
            (true, Some(text)) => Some(Settings::read(&text, Part::ALL)?),
            (true, None) => {
                let robot = robot.name().to_owned();
                return Err(Sweeping::NoDescription { robot }.into());
            }
        };
        let text = spec.scene.as_deref().unwrap_or_default();
        let robot = with_scene(robot, text, spec.plant, SweepError::found)?;
        let scene = match varies(|of| matches!(of, Quantity::Scene(_))) {
            true if Scene::by_name(text).is_some() => {
                let scene = text.to_owned();
                return Err(Sweeping::NoSceneFile { scene }.into());
            }
            true => Some(Settings::read(text, Part::SCENE)?),
            false => None,
        };
        let mut record = Vec::new();
        for name in &spec.record {
            let wanted = name.to_ascii_uppercase();
            let scalar = names.iter().position(|known| *known == wanted);
            let scalar = scalar.ok_or_else(|| {
                let known = names.iter().map(String::as_str);
                let name = name.clone();
                SweepError::from(Sweeping::UnknownVariable { name: name.clone() })
                    .suggest(&name, known)
            })?;
            record.push((scalar, wanted));
        }
        if !(spec.until > 0.0 && spec.until.is_finite()) {
            return Err(Sweeping::NoTime.into());
        }
        let cases = count(&axes, spec.repeat)?;
        let interpreted = Interpreter::new(Arc::clone(&program));
        let schema = Schema::new(&spec, &robot);
        let mut sweep = Sweep {
            spec,
            program,
            engine: Arc::new(move || ProgramRunner::new(interpreted.clone())),
            names,
            events,
            robot,
            description,
            described: Arc::default(),
            scene,
            axes,
            cases,
            schema,
            is_massless: false,
        };
        // Refuses what only a run can refuse: keys of files, values out of range, inputs that the robot lacks.
        let first = sweep.case(0)?;
        let run = sweep.start(&first)?;
        let axes = sweep.axes.iter().enumerate();
        let axes = axes.map(|(index, axis)| axis.quantity.column(index, &axis.name));
        sweep.schema = sweep
            .schema
            .clone()
            .with_columns(&run, axes.collect(), &record);
        let motion = run.motion();
        sweep.is_massless = motion.is_some_and(|motion| motion.unmodelled.is_some());
        sweep.try_bounds(&first.values)?;
        Ok(sweep)
    }

    /// Checks a specification, and runs it on compiled code: `make` is the constructor that `include_tip!` writes.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new), or the code was compiled from another text.
    pub fn of<P: tip_runtime::program::Program + Clone + Send + 'static>(
        spec: Spec,
        make: impl Fn() -> P + Send + Sync + 'static,
    ) -> Result<Self, SweepError> {
        let mut sweep = Self::new(spec)?;
        let (interpreted, compiled) = (Interpreter::new(Arc::clone(&sweep.program)), make());
        let names = (0..=sweep.names.len()).all(|scalar| {
            let name = interpreted.scalar(scalar).map(|(name, _)| name);
            name == compiled.scalar(scalar).map(|(name, _)| name)
        });
        let steps = 0..=sweep.program.steps().len() as u32;
        let lines = steps.map(|step| (interpreted.line(step), compiled.line(step)));
        let is_same = interpreted.signature() == compiled.signature()
            && names
            && interpreted.title() == compiled.title()
            && lines.into_iter().all(|(one, other)| one == other);
        if !is_same {
            return Err(Sweeping::OtherProgram.into());
        }
        sweep.engine = Arc::new(move || ProgramRunner::new(make()));
        Ok(sweep)
    }

    /// Tries the least and the greatest value of each axis with the first ones of the others.
    fn try_bounds(&self, first: &[f64]) -> Result<(), SweepError> {
        for (index, axis) in self.axes.iter().enumerate() {
            let Some((low, high)) = axis.bounds() else {
                continue;
            };
            for bound in [low, high] {
                let mut values = first.to_vec();
                values[index] = bound;
                self.robot_of(&values)
                    .map_err(|error| SweepError::axis(&axis.name, error))?;
            }
        }
        Ok(())
    }

    /// The specification.
    pub fn spec(&self) -> &Spec {
        &self.spec
    }

    /// Number of cases.
    pub fn cases(&self) -> u64 {
        self.cases
    }

    /// Names of the axes.
    pub fn axes(&self) -> impl Iterator<Item = &str> {
        self.axes.iter().map(|axis| axis.name.as_str())
    }

    /// Returns the axis that changes no run: friction, if the robot walks without mass.
    pub fn idle_axis(&self) -> Option<&str> {
        let is_friction = |axis: &&Axis| match &axis.quantity {
            Quantity::Scene(path) => path == &["floor", "friction"],
            _ => false,
        };
        let idle = self.axes.iter().find(is_friction);
        let idle = idle.filter(|_| self.is_massless);
        idle.map(|axis| axis.name.as_str())
    }

    /// Returns a case by its number. It depends on the specification and the number alone.
    ///
    /// # Errors
    /// There is no such case, or robot or scene do not allow a value.
    pub fn case(&self, number: u64) -> Result<Case, SweepError> {
        if number >= self.cases {
            let (case, count) = (number.to_string(), self.cases.to_string());
            return Err(Sweeping::NoCase { case, count }.into());
        }
        let repeats = self.spec.repeat;
        let (combination, repeat) = (number / repeats, number % repeats);
        let mut rest = combination;
        let mut values = vec![0.0; self.axes.len()];
        // The last axis varies fastest.
        for (index, (axis, value)) in self.axes.iter().zip(&mut values).enumerate().rev() {
            let draw = Draw {
                seed: self.spec.seed,
                combination,
                repeat,
                repeats,
                axis: index as u64,
            };
            *value = match &axis.list {
                Some(list) => {
                    let place = rest % list.len() as u64;
                    rest /= list.len() as u64;
                    list[place as usize]
                }
                None => draw
                    .sample(&axis.values, self.spec.sampling)
                    .unwrap_or(f64::NAN),
            };
        }
        let robot = self.robot_of(&values).map_err(|error| {
            let values = self.axes.iter().zip(&values);
            let values = values.map(|(axis, value)| format!("{}={value}", axis.name));
            error.in_case(number, values.collect::<Vec<_>>().join(", "))
        })?;
        Ok(Case {
            number,
            values,
            robot,
        })
    }

    /// Returns the robot of a case in its scene.
    fn robot_of(&self, values: &[f64]) -> Result<Robot, SweepError> {
        let mut robot = self.robot.clone();
        if let Some(description) = &self.description {
            robot = self.described(description, values)?;
            let scene = self.spec.scene.as_deref().unwrap_or_default();
            robot = with_scene(robot, scene, self.spec.plant, SweepError::found)?;
        }
        if let Some(scene) = &self.scene {
            let of_scene = |axis: &Axis| match &axis.quantity {
                Quantity::Scene(path) => Some(path.clone()),
                _ => None,
            };
            let set = self.set(scene, values, of_scene)?;
            let refused = |loaded: &Loaded| {
                let errors = Texts::reasons(loaded);
                Sweeping::SceneRefuses { errors }.into()
            };
            robot = with_scene(robot, &set.text(), self.spec.plant, refused)?;
        }
        Ok(robot)
    }

    /// Returns a file with the numbers of a case.
    fn set(
        &self,
        settings: &Settings,
        values: &[f64],
        path: impl Fn(&Axis) -> Option<Vec<String>>,
    ) -> Result<Settings, SweepError> {
        let mut settings = settings.clone();
        for (axis, value) in self.axes.iter().zip(values) {
            if let Some(path) = path(axis) {
                let set = settings.set(&path, *value);
                set.map_err(|reason| SweepError::axis(&axis.name, reason))?;
            }
        }
        Ok(settings)
    }

    /// Returns the robot of a description with the numbers of a case.
    fn described(&self, description: &Settings, values: &[f64]) -> Result<Robot, SweepError> {
        let of_robot = |axis: &Axis| match &axis.quantity {
            Quantity::Robot(path) => Some(path.clone()),
            _ => None,
        };
        let of_case = self.axes.iter().zip(values);
        let of_case = of_case.filter(|(axis, _)| matches!(axis.quantity, Quantity::Robot(_)));
        let key: Vec<u64> = of_case.map(|(_, value)| value.to_bits()).collect();
        let described = || {
            let described = self.described.lock();
            described.unwrap_or_else(PoisonError::into_inner)
        };
        if let Some(robot) = described().get(&key) {
            return Ok(robot.clone());
        }
        // Not locked: other threads go on meanwhile.
        let text = self.set(description, values, of_robot)?.text();
        let robot = Robot::from_description(&text).map_err(|errors| {
            let errors = Texts::reasons(errors.loaded());
            SweepError::from(Sweeping::RobotRefuses { errors })
        })?;
        let mut described = described();
        if described.len() == KEPT_ROBOTS {
            described.clear();
        }
        described.insert(key, robot.clone());
        Ok(robot)
    }

    /// Returns the events of a case on a robot with this sampling time, ms.
    fn events(&self, case: &Case, period: f64) -> Events {
        let mut events: Vec<Timed> = self.events.all().to_vec();
        let (mut force, mut at, mut lasts, mut pushes) = ([0.0; 3], PUSH_AT, PUSH_FOR, false);
        let mut noise: Option<plant::Noise> = None;
        for (axis, &value) in self.axes.iter().zip(&case.values) {
            match &axis.quantity {
                Quantity::Variable(scalar) if axis.start.at_start => {
                    events.push(Event::Set(self.names[*scalar].clone(), value).at(0));
                }
                Quantity::Variable(_) | Quantity::Scene(_) | Quantity::Robot(_) => {}
                Quantity::Push(of) => {
                    pushes = true;
                    match of {
                        Push::Force(along) => force[*along] = value,
                        Push::At => at = value,
                        Push::For => lasts = value,
                    }
                }
                Quantity::Noise(of) => {
                    let noise = noise.get_or_insert(plant::Noise {
                        angle: 0.0,
                        volts: 0.0,
                        seed: noise_seed(self.spec.seed, case.number),
                    });
                    match of {
                        Noise::Angle => noise.angle = value,
                        Noise::Sole => noise.volts = value,
                    }
                }
                Quantity::Sensor(port) => events.push(Event::Sensor(*port, value).at(0)),
            }
        }
        if pushes {
            let cycles = |seconds: f64| libm::round(seconds * 1000.0 / period).max(0.0);
            events.push(Event::Push(force, cycles(lasts) as u32).at(cycles(at) as u64));
        }
        events.extend(noise.map(|noise| Event::Noise(noise).at(0)));
        Events::new(events)
    }

    /// Starts the run of a case, before its first cycle.
    ///
    /// # Errors
    /// The robot lacks an input, or the body cannot be pushed.
    pub fn start(&self, case: &Case) -> Result<Run, SweepError> {
        let replaced = self.axes.iter().zip(&case.values);
        let replaced = replaced.filter_map(|(axis, value)| match axis.quantity {
            Quantity::Variable(scalar) => Some(Replacement {
                scalar,
                value: *value,
                steps: axis.start.steps.clone(),
            }),
            _ => None,
        });
        let program = (self.engine)().with_replacements(replaced.collect::<Vec<_>>());
        let run = Run::of(program, &case.robot).map_err(SweepError::says)?;
        let events = self.events(case, run.period());
        run.with_events(&events).map_err(|refused| {
            let text = Texts::of(|lang| refused.text(lang));
            Sweeping::Says { text }.into()
        })
    }

    /// Runs cases one after the other.
    ///
    /// # Errors
    /// There is no such case, or robot or scene do not allow its values.
    pub fn run(&self, first: u64, count: u64) -> Result<Vec<Row>, SweepError> {
        let cases = first..first.saturating_add(count);
        cases.map(|number| self.run_case(number)).collect()
    }

    /// Runs a case to its end.
    ///
    /// # Errors
    /// There is no such case, or robot or scene do not allow its values.
    pub fn run_case(&self, number: u64) -> Result<Row, SweepError> {
        let case = self.case(number)?;
        let mut run = self.start(&case)?;
        let limit = self.spec.until * 1000.0;
        let cycles = self.spec.cycles.unwrap_or(u64::MAX);
        let mut figures = Figures::new(&case.robot);
        let end = loop {
            if run.time() >= limit || run.cycles() >= cycles {
                break LIMIT.to_owned();
            }
            let status = run.advance(None);
            figures.after(&run);
            match status {
                Status::Running => {}
                Status::Finished(End::End) => break Keyword::End.word().to_owned(),
                Status::Finished(End::Exit) => break Keyword::Exit.word().to_owned(),
                Status::Emergency => {
                    let fault = run.emergency().map(|emergency| emergency.fault.to_string());
                    break fault.unwrap_or_default();
                }
            }
        };
        let values = &case.values;
        Ok(self.schema.row(&run, number, values, &end, &figures))
    }

    /// Returns the columns of the table.
    pub fn columns(&self) -> &Arc<[Column]> {
        &self.schema.columns
    }

    /// Returns the first line of the table as a CSV file, with its end.
    pub fn header(&self) -> String {
        columns::header(self.columns())
    }

    /// Reads a line of the table as a CSV file. Returns `None` if this sweep has not written it so.
    pub fn read_row(&self, line: &str) -> Option<Row> {
        Row::read(self.columns(), line, self.schema.spec_hash)
    }

    /// Returns true if the robot's simulation has torques.
    pub fn has_forces(&self) -> bool {
        let torque = |column: &Column| column.measure == Measure::PeakTorque;
        self.columns().iter().any(torque)
    }
}

/// Puts a robot into a scene; `error` makes the error of a wrong text.
fn with_scene(
    robot: Robot,
    text: &str,
    plant: PlantSpec,
    error: impl Fn(&Loaded) -> SweepError,
) -> Result<Robot, SweepError> {
    let scene = match Scene::by_name(text) {
        Some(scene) => Ok(scene),
        None if text.is_empty() => Ok(Scene::EMPTY),
        None => tipc::description::parse_scene("scene.toml", text.as_bytes()),
    };
    let mut scene = scene.map_err(|loaded| error(&loaded))?;
    scene.plant = plant.simulation().or(scene.plant);
    robot.with_scene(&scene).map_err(SweepError::says)
}

fn axis_of(axis: &crate::spec::Axis, program: &Program) -> Result<Axis, SweepError> {
    let quantity = Quantity::find(&axis.name, program)?;
    let list = axis.values.listed();
    let list = list.map_err(|reason| SweepError::axis(&axis.name, reason))?;
    let start = match quantity {
        Quantity::Variable(scalar) => {
            let is_used = program.steps().iter().any(|step| {
                let mut found = access::assigns(program, &step.action).contains(&scalar);
                access::reads(program, &step.action, |read| found |= read == scalar);
                found
            });
            if !is_used {
                return Err(SweepError::axis(&axis.name, Sweeping::Unused));
            }
            Override::of(program, scalar)
                .map_err(|line| SweepError::axis(&axis.name, Sweeping::ComputedFirst { line }))?
        }
        _ => Override::default(),
    };
    Ok(Axis {
        name: axis.name.clone(),
        quantity,
        list,
        values: axis.values.clone(),
        start,
    })
}

fn count(axes: &[Axis], repeat: u64) -> Result<u64, SweepError> {
    if repeat == 0 {
        return Err(Sweeping::NoRepeat.into());
    }
    let lists = axes.iter().filter_map(|axis| axis.list.as_ref());
    let count = lists.fold(u128::from(repeat), |count, list| {
        count.saturating_mul(list.len() as u128)
    });
    match u64::try_from(count) {
        Ok(count) if count <= CASE_LIMIT => Ok(count),
        _ => Err(Sweeping::ManyCases {
            count: count.to_string(),
            limit: CASE_LIMIT.to_string(),
        }
        .into()),
    }
}

impl fmt::Debug for Sweep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Sweep")
            .field("axes", &self.axes)
            .field("cases", &self.cases)
            .finish_non_exhaustive()
    }
}
