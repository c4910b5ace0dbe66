//! Measurement of a run: the columns of a sweep, and the cells of a case.

use crate::columns::{Cell, Column, Measure, ObjectMeasure, Row};
use crate::spec::{Spec, hash};
use std::sync::Arc;
use tip_runtime::model::TorqueUnit;
use tip_runtime::plant::Clearance;
use tip_sim::{
    Energy, FallFigures, Grasp, Peak, Robot, Run, Summary, SummaryBuilder, TravelFigures,
};

/// The columns of a sweep, and the data that their cells need besides the run.
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
        let forces = robot.description().forces;
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
            measures.push(Measure::Speed);
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
            if run.travel().is_some() {
                measures.push(Measure::Cost);
            }
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
            summary: figures.summary.summary(),
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

/// The data of a run that has ended, from which its row is made.
struct Finished<'a> {
    schema: &'a Schema,
    run: &'a Run,
    case: u64,
    values: &'a [f64],
    end: &'a str,
    figures: &'a Figures,
    summary: &'a Summary,
    grasp: Option<Grasp>,
    clearance: Option<Clearance>,
}

impl Finished<'_> {
    fn cell(&self, measure: Measure) -> Cell {
        let (run, figures, summary) = (self.run, self.figures, self.summary);
        let number = |number: Option<f64>| measured(number.unwrap_or(f64::NAN));
        let travel = |of: fn(TravelFigures) -> f64| number(summary.travel.map(of));
        let falls = |of: fn(FallFigures) -> u32| Cell::Count(summary.falls.map_or(0, of).into());
        let peak = |peak: &Option<Peak>| number(peak.as_ref().map(|peak| peak.value));
        let energy = |of: fn(Energy) -> Option<f64>| number(summary.energy.and_then(of));
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
            Measure::Forward => travel(|travel| travel.forward_mm),
            Measure::Right => travel(|travel| travel.right_mm),
            Measure::Up => travel(|travel| travel.up_mm),
            Measure::Turn => travel(|travel| travel.turn_deg),
            Measure::Speed => travel(|travel| travel.speed_mm_s),
            Measure::Falls => falls(|falls| falls.count),
            Measure::UprightFalls => falls(|falls| falls.upright),
            Measure::FirstFall => {
                let first = summary.falls.and_then(|falls| falls.first);
                number(first.map(|first| first.time_s))
            }
            Measure::Slip => peak(&summary.slip),
            Measure::LeastMargin => peak(&summary.margin),
            Measure::Tilt => measured(figures.tilt),
            Measure::Clearance => number(self.clearance.map(|clearance| clearance.least.distance)),
            Measure::Collisions => {
                let count = self.clearance.map_or(0, |clearance| clearance.collisions);
                Cell::Count(count.into())
            }
            Measure::PeakSpeed => peak(&summary.rate),
            Measure::PeakTorque => {
                let torque = summary.torque.as_ref();
                number(torque.map(|torque| torque.value / self.schema.torque_unit))
            }
            Measure::Energy => energy(|energy| Some(energy.work_j)),
            Measure::Cost => energy(|energy| energy.cost_of_transport),
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
            // It depends on the other cells, so the row adds it.
            Measure::Check => Cell::Text(String::new()),
        }
    }
}

/// Smallest measured number, in mm, deg, s, N·m or J. Smaller ones are rounding errors.
const MIN_MEASURED: f64 = 1e-9;

/// Returns the cell of a measured number.
fn measured(number: f64) -> Cell {
    Cell::Number(if libm::fabs(number) < MIN_MEASURED {
        0.0
    } else {
        number
    })
}

/// Figures that are gathered cycle by cycle: those of the summary of a run, and those of tables alone.
#[derive(Debug)]
pub(crate) struct Figures {
    summary: SummaryBuilder,
    hash: u64,
    /// Greatest angle between the body's z axis and the vertical, deg.
    tilt: f64,
}

impl Figures {
    pub(crate) fn new(robot: &Robot) -> Self {
        Figures {
            summary: SummaryBuilder::new(robot),
            hash: 0,
            tilt: 0.0,
        }
    }

    pub(crate) fn after(&mut self, run: &Run) {
        self.summary.after(run, None);
        let step = u64::from(run.program().at());
        self.hash = hash([self.hash, step, run.state_hash(), 0]);
        if let Some(pose) = run.pose() {
            let cosine = libm::cos(pose.roll.to_radians()) * libm::cos(pose.pitch.to_radians());
            self.tilt = self
                .tilt
                .max(libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees());
        }
    }
}
