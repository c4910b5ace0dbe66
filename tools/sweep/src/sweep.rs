//! A sweep that is ready to run.

use crate::columns::{Cell, Columns};
use crate::error::SweepError;
use crate::quantity::{Noise, Override, Push, Quantity, Settings};
use crate::sampling::{Draw, hash, noise_seed};
use crate::spec::{PlantSpec, RobotSpec, Spec, Values};
use std::sync::Arc;
use tip_runtime::machine::Status;
use tip_runtime::plant::{self, Scene};
use tip_runtime::program::End;
use tip_sim::{Event, Events, Interpreter, Plant, Robot, Run, Timed};
use tipc::analysis::access;
use tipc::language::Keyword;
use tipc::program::Program;
use tipc::published;

/// Largest number of cases.
const CASE_LIMIT: u64 = 1_000_000_000;

/// Start of a push that does not vary, s.
const PUSH_AT: f64 = 1.0;
/// Duration of a push that does not vary, s.
const PUSH_FOR: f64 = 0.2;

/// A checked specification: program, robot and axes.
///
/// It is not sent between threads; each thread makes its own from the same [`Spec`].
#[derive(Debug)]
pub struct Sweep {
    spec: Spec,
    program: Arc<Program>,
    names: Vec<String>,
    events: Events,
    robot: Robot,
    /// The description of the robot, if one of its numbers varies.
    description: Option<Settings>,
    /// The scene file, if one of its numbers varies.
    scene: Option<Settings>,
    axes: Vec<Axis>,
    /// Scalars that are recorded.
    record: Vec<usize>,
    cases: u64,
}

#[derive(Debug)]
struct Axis {
    name: String,
    quantity: Quantity,
    /// The listed values; none for a random axis.
    list: Option<Vec<f64>>,
    values: Values,
    start: Override,
}

/// A case: the values of all axes, and the run they determine.
#[derive(Debug)]
pub struct Case {
    /// The number of the case, from 0.
    pub number: u64,
    /// The value of each axis.
    pub values: Vec<f64>,
    robot: Robot,
}

impl Sweep {
    /// Checks a specification.
    ///
    /// # Errors
    /// The first thing that is wrong: a program or robot with errors, an unknown axis, an empty range, too many cases.
    pub fn new(spec: Spec) -> Result<Self, SweepError> {
        let (robot, description) = robot(&spec)?;
        let robot = match spec.plant {
            PlantSpec::Scene => robot,
            PlantSpec::Dynamic => robot.with_plant(Plant::Dynamic),
        };
        let loaded = tip_sim::load(&spec.program.name, &spec.program.text, &robot);
        let loaded = loaded.map_err(|errors| SweepError::new(errors.to_string().trim_end()))?;
        let program = Arc::clone(loaded.program());
        let names: Vec<String> = program.scalar_names().collect();
        let events: Events = spec
            .events
            .parse()
            .map_err(|error| SweepError::new(format!("events: {error}")))?;
        let mut axes: Vec<Axis> = Vec::new();
        for axis in &spec.vary {
            let new = axis_of(axis, &program)?;
            if axes.iter().any(|other| other.quantity == new.quantity) {
                return Err(SweepError::axis(&axis.name, "it is varied twice"));
            }
            axes.push(new);
        }
        let varies = |kind: fn(&Quantity) -> bool| axes.iter().any(|axis| kind(&axis.quantity));
        let description = match (varies(|of| matches!(of, Quantity::Robot(_))), description) {
            (false, _) => None,
            (true, Some(text)) => Some(Settings::read(&text)?),
            (true, None) => {
                let name = robot.name();
                return Err(SweepError::new(format!(
                    "the numbers of {name} cannot vary, because it has no description"
                ))
                .with_help("use a robot with a description, such as a1, or --robot FILE.toml"));
            }
        };
        let text = spec.scene.as_deref().unwrap_or_default();
        let scene = match varies(|of| matches!(of, Quantity::Scene(_))) {
            true => Some(Settings::read(text)?),
            false => None,
        };
        let robot = with_scene(robot, text)?;
        let mut record = Vec::new();
        for name in &spec.record {
            let wanted = name.to_ascii_uppercase();
            let scalar = names.iter().position(|known| *known == wanted);
            record.push(scalar.ok_or_else(|| {
                let known = names.iter().map(String::as_str);
                SweepError::unknown(name, "not a variable of the program", known)
            })?);
        }
        if !(spec.until > 0.0 && spec.until.is_finite()) {
            return Err(SweepError::new(
                "the longest time of a run must be above 0 s",
            ));
        }
        let cases = count(&axes, spec.repeat)?;
        let sweep = Sweep {
            spec,
            program,
            names,
            events,
            robot,
            description,
            scene,
            axes,
            record,
            cases,
        };
        // Refuses what only a run can refuse: keys of files, values out of range, inputs that the robot lacks.
        let first = sweep.case(0)?;
        sweep.start(&first)?;
        Ok(sweep)
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

    /// Returns a case by its number. It depends on the specification and the number alone.
    ///
    /// # Errors
    /// Robot or scene do not allow a value.
    pub fn case(&self, number: u64) -> Result<Case, SweepError> {
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
        let robot = self.robot_of(&values)?;
        Ok(Case {
            number,
            values,
            robot,
        })
    }

    /// Returns the robot of a case in its scene.
    fn robot_of(&self, values: &[f64]) -> Result<Robot, SweepError> {
        let set = |settings: &Settings, is_of: fn(&Quantity) -> Option<&[String]>| {
            let mut settings = settings.clone();
            for (axis, value) in self.axes.iter().zip(values) {
                if let Some(path) = is_of(&axis.quantity) {
                    settings.set(path, *value)?;
                }
            }
            Ok::<String, SweepError>(settings.text())
        };
        let mut robot = self.robot.clone();
        if let Some(description) = &self.description {
            let text = set(description, |of| match of {
                Quantity::Robot(path) => Some(path),
                _ => None,
            })?;
            let described = Robot::description(&text);
            let described = described.map_err(|errors| {
                SweepError::new(format!(
                    "the robot does not allow a value: {}",
                    errors.to_string().trim_end()
                ))
            })?;
            robot = match self.spec.plant {
                PlantSpec::Scene => described,
                PlantSpec::Dynamic => described.with_plant(Plant::Dynamic),
            };
            robot = with_scene(robot, self.spec.scene.as_deref().unwrap_or_default())?;
        }
        if let Some(scene) = &self.scene {
            let text = set(scene, |of| match of {
                Quantity::Scene(path) => Some(path),
                _ => None,
            })?;
            robot = with_scene(robot, &text)?;
        }
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

    /// Starts the run of a case, before its first cycle, on the interpreter.
    ///
    /// # Errors
    /// The robot lacks an input, or the body cannot be pushed.
    pub fn start(&self, case: &Case) -> Result<Run, SweepError> {
        let program = Interpreter::new(Arc::clone(&self.program));
        let run = Run::new(program, case.robot.clone());
        let run = run.map_err(|error| SweepError::new(error.to_string()))?;
        let events = self.events(case, run.period());
        run.with_events(&events)
            .map_err(|refused| SweepError::new(refused.to_string()))
    }

    /// Runs one cycle of a case's run. A step that assigns a constant to a varied variable assigns the case's value.
    pub fn advance(&self, run: &mut Run, case: &Case) -> Status {
        let step = run.program().at();
        let cycles = run.cycles();
        let status = run.advance(None);
        if status == Status::Running && run.cycles() > cycles {
            for (axis, value) in self.axes.iter().zip(&case.values) {
                if let Quantity::Variable(scalar) = axis.quantity
                    && axis.start.steps.binary_search(&step).is_ok()
                {
                    // The program has the scalar, and the value is finite.
                    let _ = run.set(&self.names[scalar], *value);
                }
            }
        }
        status
    }

    /// Runs cases one after the other.
    ///
    /// # Errors
    /// Robot or scene do not allow a value of a case.
    pub fn run(&self, first: u64, count: u64) -> Result<Columns, SweepError> {
        let mut columns = Columns::default();
        for number in first..first.saturating_add(count).min(self.cases) {
            let case = self.case(number)?;
            let run = self.start(&case)?;
            self.measure(run, &case, &mut columns);
        }
        Ok(columns)
    }

    /// Runs a case to its end, and adds its row.
    fn measure(&self, mut run: Run, case: &Case, columns: &mut Columns) {
        let limit = self.spec.until * 1000.0;
        let mut figures = Figures::new(&run);
        let end = loop {
            if run.time() >= limit {
                break "limit".to_owned();
            }
            let status = self.advance(&mut run, case);
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
        self.row(&run, case, end, &figures, columns);
    }

    fn row(&self, run: &Run, case: &Case, end: String, figures: &Figures, columns: &mut Columns) {
        let mut index = 0;
        let mut add = |name: &str, unit: &'static str, cell: Cell| {
            columns.push(index, name, unit, cell);
            index += 1;
        };
        add("case", "", Cell::Count(case.number));
        for (axis, value) in self.axes.iter().zip(&case.values) {
            add(&axis.name, axis.quantity.unit(), Cell::Number(*value));
        }
        let step = run
            .emergency()
            .map_or(run.program().at(), |emergency| emergency.step);
        add("end", "", Cell::Text(end));
        add("line", "", Cell::Count(u64::from(run.program().line(step))));
        add("cycles", "", Cell::Count(run.cycles()));
        add("time", "s", Cell::Number(run.time() / 1000.0));
        if let Some(travel) = run.travel() {
            add("forward", "mm", Cell::Number(travel.y));
            add("right", "mm", Cell::Number(travel.x));
            add("up", "mm", Cell::Number(travel.z));
            add("turn", "deg", Cell::Number(travel.turn));
        }
        if let Some(motion) = run.motion() {
            let fall = run.first_fall().map_or(f64::NAN, |fall| fall.time / 1000.0);
            add("falls", "", Cell::Count(u64::from(motion.falls)));
            add(
                "upright_falls",
                "",
                Cell::Count(u64::from(motion.upright_falls)),
            );
            add("first_fall", "s", Cell::Number(fall));
            add("slip", "mm", Cell::Number(motion.slip));
            add("least_margin", "mm", Cell::Number(motion.least_margin));
        }
        add("peak_speed", "deg/s", Cell::Number(figures.speed));
        if figures.has_mass {
            add("peak_torque", "N·m", Cell::Number(figures.torque));
            add("energy", "J", Cell::Number(figures.energy));
        }
        if let Some(grasp) = run.grasp() {
            for (number, object) in (1..).zip(&grasp.objects) {
                let name = |of: &str| format!("object{number}_{of}");
                add(&name("x"), "mm", Cell::Number(object.position[0]));
                add(&name("y"), "mm", Cell::Number(object.position[1]));
                add(&name("angle"), "deg", Cell::Number(object.angle));
                add(&name("highest"), "mm", Cell::Number(object.highest));
            }
        }
        for scalar in &self.record {
            let value = run.program().scalar(*scalar).and_then(|(_, value)| value);
            add(
                &format!("final_{}", self.names[*scalar]),
                "",
                Cell::Number(value.unwrap_or(f64::NAN)),
            );
        }
        add("hash", "", Cell::Text(format!("{:016x}", figures.hash)));
    }
}

/// Figures that are gathered cycle by cycle.
#[derive(Debug)]
struct Figures {
    hash: u64,
    angles: Vec<f64>,
    /// Greatest speed of a joint, deg/s.
    speed: f64,
    has_mass: bool,
    /// Greatest torque of a joint, N·m.
    torque: f64,
    /// Mechanical work of the motors, without what they take back, J.
    energy: f64,
}

impl Figures {
    fn new(run: &Run) -> Self {
        let has_mass =
            run.limbs().is_some_and(|limbs| !limbs.forces.is_empty()) || run.grasp().is_some();
        Figures {
            hash: 0,
            angles: run.angles().to_vec(),
            speed: 0.0,
            has_mass,
            torque: 0.0,
            energy: 0.0,
        }
    }

    fn after(&mut self, run: &Run) {
        let step = u64::from(run.program().at());
        self.hash = hash([self.hash, step, run.state_hash(), 0]);
        let seconds = run.period() / 1000.0;
        let angles = run.angles();
        if run.cycles() > 1 {
            for (now, before) in angles.iter().zip(&self.angles) {
                self.speed = self.speed.max(libm::fabs(now - before) / seconds);
            }
            if self.has_mass
                && let Some(limbs) = run.limbs()
            {
                let torques = limbs.torques.iter().flatten();
                for ((torque, now), before) in torques.zip(angles).zip(&self.angles) {
                    self.torque = self.torque.max(libm::fabs(*torque));
                    self.energy += libm::fabs(torque * (now - before).to_radians());
                }
            }
        }
        self.angles.copy_from_slice(angles);
    }
}

/// Makes the robot, and returns the text of its description if it has one.
fn robot(spec: &Spec) -> Result<(Robot, Option<String>), SweepError> {
    let described = |text: &str| {
        Robot::description(text).map_err(|errors| SweepError::new(errors.to_string().trim_end()))
    };
    match &spec.robot {
        RobotSpec::Description(text) => Ok((described(text)?, Some(text.clone()))),
        RobotSpec::Name(name) => match published::find(name) {
            Some(published) => Ok((described(published.text)?, Some(published.text.to_owned()))),
            None => {
                let robot = Robot::named(name);
                let robot = robot.map_err(|error| SweepError::new(error.to_string()))?;
                Ok((robot, None))
            }
        },
    }
}

fn with_scene(robot: Robot, text: &str) -> Result<Robot, SweepError> {
    let scene = match text {
        "" => Ok(Scene::EMPTY),
        text => tipc::description::parse_scene("scene.toml", text.as_bytes()),
    };
    let scene = scene.map_err(|loaded| {
        let lines = loaded.diagnostics.iter();
        let lines = lines.map(|one| tipc::render::classical(&loaded.source, one));
        SweepError::new(format!(
            "the scene does not allow a value: {}",
            lines.collect::<String>().trim_end()
        ))
    })?;
    robot
        .with_scene(&scene)
        .map_err(|error| SweepError::new(error.to_string()))
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
                return Err(SweepError::axis(&axis.name, "the program does not use it"));
            }
            Override::of(program, scalar).map_err(|line| {
                SweepError::axis(
                    &axis.name,
                    format!("line {line} computes it before its first use"),
                )
                .with_help("vary what it is computed from")
            })?
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
        return Err(SweepError::new("the number of repeats is 0"));
    }
    let lists = axes.iter().filter_map(|axis| axis.list.as_ref());
    let count = lists.fold(u128::from(repeat), |count, list| {
        count.saturating_mul(list.len() as u128)
    });
    match u64::try_from(count) {
        Ok(count) if count <= CASE_LIMIT => Ok(count),
        _ => Err(
            SweepError::new(format!("these are {count} cases, more than {CASE_LIMIT}"))
                .with_help("take wider steps, or random values: NAME=uniform(LOW,HIGH)"),
        ),
    }
}
