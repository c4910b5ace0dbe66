//! Measurement of a run: which columns a sweep has, and the cells of a case.

use crate::columns::{Cell, Column, Measure, ObjectMeasure, Row};
use crate::spec::{Spec, hash};
use std::sync::Arc;
use tip_runtime::model::TorqueUnit;
use tip_runtime::plant::{Clearance, Motion, Travel};
use tip_sim::{Grasp, Robot, Run};

/// The columns of a sweep, and what their cells depend on besides the run.
#[derive(Clone, Debug)]
pub(crate) struct Schema {
    pub(crate) columns: Arc<[Column]>,
    pub(crate) spec_hash: u64,
    /// Number of the robot's units of torque in 1 N·m.
    torque_unit: f64,
    /// Scalars whose last values are recorded.
    record: Vec<usize>,
}

impl Schema {
    /// Returns a schema without columns.
    pub(crate) fn new(spec: &Spec, robot: &Robot) -> Self {
        let forces = robot.anatomy().forces;
        let unit = forces.map_or(TorqueUnit::NewtonMetre, |forces| forces.unit);
        Schema {
            columns: Arc::default(),
            spec_hash: spec.hash(),
            torque_unit: unit.per_newton_metre(),
            record: Vec::new(),
        }
    }

    /// Adds the columns of a sweep whose runs are like this one. `axes` are the columns of its axes; `record` are the scalars that
    /// are recorded, and their names.
    pub(crate) fn with_columns(
        self,
        run: &Run,
        axes: Vec<Column>,
        record: &[(usize, String)],
    ) -> Self {
        let mut measures = vec![Measure::End, Measure::Line, Measure::Cycles, Measure::Time];
        if run.travel().is_some() {
            measures.extend([Measure::Forward, Measure::Right, Measure::Up, Measure::Turn]);
        }
        if run.motion().is_some() {
            measures.extend([Measure::Falls, Measure::UprightFalls, Measure::FirstFall]);
            measures.extend([Measure::Slip, Measure::LeastMargin, Measure::Tilt]);
        }
        if run.clearance().is_some() {
            measures.extend([Measure::Clearance, Measure::Collisions]);
        }
        measures.push(Measure::PeakSpeed);
        if has_forces(run) {
            measures.extend([Measure::PeakTorque, Measure::Energy]);
        }
        let objects = run.grasp().map_or(0, |grasp| grasp.objects.len());
        for object in 0..objects {
            measures.extend(ObjectMeasure::ALL.map(|of| Measure::Object(object, of)));
        }
        let mut columns = vec![Measure::Case.column("")];
        columns.extend(axes);
        columns.extend(measures.iter().map(|measure| measure.column("")));
        let finals = record.iter().enumerate();
        columns.extend(finals.map(|(index, (_, name))| Measure::Final(index).column(name)));
        columns.extend([Measure::Hash, Measure::Check].map(|measure| measure.column("")));
        Schema {
            columns: columns.into(),
            record: record.iter().map(|(scalar, _)| *scalar).collect(),
            ..self
        }
    }

    /// Returns the row of a case whose run has ended.
    pub(crate) fn row(
        &self,
        run: &Run,
        case: u64,
        values: &[f64],
        end: &str,
        figures: &Figures,
    ) -> Row {
        let finished = Finished {
            schema: self,
            run,
            case,
            values,
            end,
            figures,
            travel: run.travel(),
            motion: run.motion(),
            grasp: run.grasp(),
            clearance: run.clearance(),
        };
        let measures = self.columns.iter().map(|column| column.measure);
        let measures = measures.filter(|measure| *measure != Measure::Check);
        let cells = measures.map(|measure| finished.cell(measure));
        Row::new(&self.columns, cells.collect(), self.spec_hash)
    }
}

/// Returns true if the simulation has torques.
fn has_forces(run: &Run) -> bool {
    run.limbs().is_some_and(|limbs| !limbs.forces.is_empty()) || run.grasp().is_some()
}

/// A run that has ended, as its row sees it.
struct Finished<'a> {
    schema: &'a Schema,
    run: &'a Run,
    case: u64,
    values: &'a [f64],
    end: &'a str,
    figures: &'a Figures,
    travel: Option<Travel>,
    motion: Option<Motion>,
    grasp: Option<Grasp>,
    clearance: Option<Clearance>,
}

impl Finished<'_> {
    fn cell(&self, measure: Measure) -> Cell {
        let (run, figures) = (self.run, self.figures);
        let travel = |of: fn(Travel) -> f64| measured(self.travel.map_or(f64::NAN, of));
        let motion = |of: fn(Motion) -> f64| measured(self.motion.map_or(f64::NAN, of));
        let falls = |of: fn(Motion) -> u32| Cell::Count(self.motion.map_or(0, of).into());
        match measure {
            Measure::Case => Cell::Count(self.case),
            Measure::Axis(axis) => Cell::Number(self.values[axis]),
            Measure::End => Cell::Text(self.end.to_owned()),
            Measure::Line => {
                let emergency = run.emergency();
                let step = emergency.map_or(run.program().at(), |emergency| emergency.step);
                Cell::Count(run.program().line(step).into())
            }
            Measure::Cycles => Cell::Count(run.cycles()),
            Measure::Time => Cell::Number(run.time() / 1000.0),
            Measure::Forward => travel(|travel| travel.y),
            Measure::Right => travel(|travel| travel.x),
            Measure::Up => travel(|travel| travel.z),
            Measure::Turn => travel(|travel| travel.turn),
            Measure::Falls => falls(|motion| motion.falls),
            Measure::UprightFalls => falls(|motion| motion.upright_falls),
            Measure::FirstFall => {
                let fall = run.first_fall();
                Cell::Number(fall.map_or(f64::NAN, |fall| fall.time / 1000.0))
            }
            Measure::Slip => motion(|motion| motion.slip),
            Measure::LeastMargin => motion(|motion| motion.least_margin),
            Measure::Tilt => measured(figures.tilt),
            Measure::Clearance => {
                let least = self.clearance.map(|clearance| clearance.least.distance);
                measured(least.unwrap_or(f64::NAN))
            }
            Measure::Collisions => {
                let count = self.clearance.map_or(0, |clearance| clearance.collisions);
                Cell::Count(count.into())
            }
            Measure::PeakSpeed => measured(figures.speed),
            Measure::PeakTorque => measured(figures.torque / self.schema.torque_unit),
            Measure::Energy => measured(figures.energy / self.schema.torque_unit),
            Measure::Object(index, of) => {
                let objects = self.grasp.as_ref().map(|grasp| &grasp.objects);
                let object = objects.and_then(|objects| objects.get(index));
                measured(object.map_or(f64::NAN, |object| match of {
                    ObjectMeasure::X => object.position[0],
                    ObjectMeasure::Y => object.position[1],
                    ObjectMeasure::Angle => object.angle,
                    ObjectMeasure::Highest => object.highest,
                }))
            }
            Measure::Final(index) => {
                let scalar = run.program().scalar(self.schema.record[index]);
                Cell::Number(scalar.and_then(|(_, value)| value).unwrap_or(f64::NAN))
            }
            // The letter keeps a reader of tables from taking 7588677e37186226 for a number.
            Measure::Hash => Cell::Text(format!("h{:016x}", figures.hash)),
            // It depends on the other cells: the row adds it.
            Measure::Check => Cell::Text(String::new()),
        }
    }
}

/// Least size of a measured number, in mm, deg, s, N·m or J. What is smaller is an error of rounding.
const MIN_MEASURED: f64 = 1e-9;

/// Returns the cell of a measured number.
fn measured(number: f64) -> Cell {
    Cell::Number(if libm::fabs(number) < MIN_MEASURED {
        0.0
    } else {
        number
    })
}

/// Figures that are gathered cycle by cycle.
#[derive(Debug, Default)]
pub(crate) struct Figures {
    hash: u64,
    angles: Vec<f64>,
    /// Greatest speed of a joint, deg/s.
    speed: f64,
    /// Greatest angle between the body's z axis and the vertical, deg.
    tilt: f64,
    has_mass: bool,
    /// Greatest torque of a joint, in the robot's unit.
    torque: f64,
    /// Sum over joints and cycles of |torque · rotation|, in the robot's unit of torque.
    energy: f64,
}

impl Figures {
    pub(crate) fn new(run: &Run) -> Self {
        Figures {
            has_mass: has_forces(run),
            ..Figures::default()
        }
    }

    pub(crate) fn after(&mut self, run: &Run) {
        let step = u64::from(run.program().at());
        self.hash = hash([self.hash, step, run.state_hash(), 0]);
        if let Some(pose) = run.pose() {
            let cosine = libm::cos(pose.roll.to_radians()) * libm::cos(pose.pitch.to_radians());
            self.tilt = self
                .tilt
                .max(libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees());
        }
        // Measured angles have the errors of sensors; those of a robot with mass are at hand without.
        let limbs = self.has_mass.then(|| run.limbs()).flatten();
        match limbs {
            Some(limbs) => self.moved(run, &limbs.angles.concat(), &limbs.torques.concat()),
            None => self.moved(run, run.angles(), &[]),
        }
    }

    fn moved(&mut self, run: &Run, angles: &[f64], torques: &[f64]) {
        let seconds = run.period() / 1000.0;
        for (now, before) in angles.iter().zip(&self.angles) {
            self.speed = self.speed.max(libm::fabs(now - before) / seconds);
        }
        for ((torque, now), before) in torques.iter().zip(angles).zip(&self.angles) {
            self.torque = self.torque.max(libm::fabs(*torque));
            self.energy += libm::fabs(torque * (now - before).to_radians());
        }
        self.angles.clear();
        self.angles.extend_from_slice(angles);
    }
}
