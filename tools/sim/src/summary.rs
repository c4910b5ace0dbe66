//! The summary of a run: its figures, each with the moment at which it was reached. It is computed here for the terminal, for
//! JSON and for the page.

use crate::message::Awaited;
use crate::motion::FallKind;
use crate::robot::Robot;
use crate::run::Run;
use crate::wait_detector::Wait;
use serde::{Serialize, Serializer};
use tip_runtime::command::Target;
use tip_runtime::model::TorqueUnit;
use tip_runtime::plant::{Gap, ServoDynamics, Travel};

/// Standard gravity, m/s² (3rd CGPM, 1901).
const GRAVITY: f64 = 9.806_65;
/// Number of waits in a summary.
const WAITS: usize = 3;
/// Least travel along the floor that has a cost of transport, mm.
const LEAST_TRAVEL: f64 = 1.0;

/// The figures of a run so far. Figures that a robot or a trace lacks are `None`, or empty lists.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Summary {
    /// Number of cycles.
    pub cycles: u64,
    /// Time of the robot, s.
    pub time_s: f64,
    /// Travel of the body.
    pub travel: Option<TravelFigures>,
    /// Falls.
    pub falls: Option<FallFigures>,
    /// Least stability margin.
    pub margin: Option<Peak>,
    /// Least distance of two parts of the robot after a cycle, negative where they overlap.
    pub clearance: Option<Peak>,
    /// Collisions of the robot with itself.
    pub collisions: Option<CollisionFigures>,
    /// Largest slip of a foot in one stance, at the end of a cycle.
    pub slip: Option<Peak>,
    /// Largest rate of a joint, from the end of one cycle to that of the next.
    pub rate: Option<Peak>,
    /// Largest torque of a joint at the end of a cycle.
    pub torque: Option<Peak>,
    /// Work of the joints of a robot whose plant has forces.
    pub energy: Option<Energy>,
    /// Greatest clearance of each object in a hand.
    pub lifts: Vec<Peak>,
    /// Greatest contact force of each fingertip.
    pub forces: Vec<Peak>,
    /// The longest waits, each of other lines; the longest first.
    pub waits: Vec<WaitFigure>,
}

/// Travel of the body from its start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TravelFigures {
    /// Forward, mm.
    pub forward_mm: f64,
    /// To the right, mm.
    pub right_mm: f64,
    /// Up, mm.
    pub up_mm: f64,
    /// To the left, whole turns included, deg.
    pub turn_deg: f64,
    /// Travel forward divided by the time of the run, mm/s.
    pub speed_mm_s: f64,
}

/// Falls of a robot.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FallFigures {
    /// Number of falls.
    pub count: u32,
    /// Number of these that left the body upright.
    pub upright: u32,
    /// Kind of the first fall.
    pub first_kind: Option<FallKind>,
    /// Moment of the first fall.
    pub first: Option<Moment>,
}

/// Collisions of a robot with itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CollisionFigures {
    /// Number of cycles after which two parts overlapped.
    pub cycles: u32,
    /// Moment of the first one.
    pub first: Option<Moment>,
}

/// A cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Moment {
    /// The cycle, from 0.
    pub cycle: u64,
    /// Time at which it began, s.
    pub time_s: f64,
    /// The line of the step that ran, from 1.
    pub line: u32,
}

/// An extreme value, and the moment at which it was reached first.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Peak {
    /// The value.
    pub value: f64,
    /// Unit of the value.
    pub unit: &'static str,
    /// The largest value that is possible, if there is one.
    pub limit: Option<f64>,
    /// The foot, joint, finger, object or pair of parts; none of the whole robot.
    pub of: Option<String>,
    /// The moment.
    #[serde(flatten)]
    pub at: Moment,
}

/// Work of the joints.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Energy {
    /// Sum over joints and cycles of |torque · rotation|, J.
    pub work_j: f64,
    /// Work divided by weight and travel along the floor. None for a robot that stays where it is.
    pub cost_of_transport: Option<f64>,
}

/// A wait of the program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WaitFigure {
    /// Length, s.
    pub length_s: f64,
    /// The first and the last line that run meanwhile.
    pub lines: [u32; 2],
    /// The condition that ends it.
    #[serde(serialize_with = "in_english")]
    pub until: Option<Awaited>,
    /// Moment at which the wait began.
    #[serde(flatten)]
    pub at: Moment,
}

fn in_english<S: Serializer>(until: &Option<Awaited>, to: S) -> Result<S::Ok, S::Error> {
    let text = until.as_ref().map(ToString::to_string);
    text.serialize(to)
}

/// The state of a robot at the end of a cycle, as a summary needs it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sample<'a> {
    /// The cycle and the line that ran in it.
    pub at: Moment,
    /// Time at which the cycle ended, ms.
    pub ended: f64,
    /// Travel of the body.
    pub travel: Option<Travel>,
    /// Least margin so far, mm.
    pub least_margin: Option<f64>,
    /// The least distance of two parts, if it is known.
    pub gap: Option<Gap>,
    /// Number of cycles so far after which two parts overlapped.
    pub collisions: u32,
    /// Slip of each foot, mm.
    pub slips: &'a [f64],
    /// Joint angles, leg by leg, deg.
    pub angles: &'a [Vec<f64>],
    /// Torques of the joints, leg by leg, in the unit of the robot.
    pub torques: &'a [Vec<f64>],
    /// The plant has forces, so that the work of the joints counts.
    pub has_forces: bool,
}

/// Computes a [`Summary`] cycle by cycle.
#[derive(Clone, Debug)]
pub struct SummaryBuilder {
    summary: Summary,
    unit: TorqueUnit,
    /// Weight, N, of a robot with a body.
    weight: Option<f64>,
    /// Largest torque of each joint, in the unit of the robot.
    torques: Vec<f64>,
    /// Largest rate of a joint of a simulated robot, deg/s.
    rate: Option<f64>,
    /// The step that comes next.
    next: u32,
    angles: Vec<Vec<f64>>,
    ended: f64,
    work: f64,
}

impl SummaryBuilder {
    /// Creates the summary of a run that has not begun.
    pub fn new(robot: &Robot) -> Self {
        let description = robot.description();
        let unit = description
            .forces
            .map_or(TorqueUnit::NewtonMetre, |forces| forces.unit);
        let joints = || description.legs.iter().flat_map(|leg| &leg.joints);
        let weight = description.body.map(|body| {
            let links = joints().map(|joint| joint.mass).sum::<f64>();
            (body.mass + links) * GRAVITY
        });
        SummaryBuilder {
            summary: Summary::default(),
            unit,
            weight,
            torques: joints()
                .map(|joint| joint.torque * unit.per_newton_metre())
                .collect(),
            rate: None,
            next: 0,
            angles: Vec::new(),
            ended: 0.0,
            work: 0.0,
        }
    }

    /// Takes the cycle that a run has just finished, and its present wait.
    pub fn after(&mut self, run: &Run, wait: Option<Wait>) {
        let (step, cycle) = (self.next, run.cycles().saturating_sub(1));
        self.next = run.program().at();
        let line = |step| run.program().line(step);
        let at = Moment {
            cycle: if run.emergency().is_some() {
                run.cycles()
            } else {
                cycle
            },
            time_s: self.ended / 1000.0,
            line: line(step),
        };
        let (motion, limbs, clearance) = (run.motion(), run.limbs(), run.clearance());
        let own;
        let (angles, torques, slips) = match &limbs {
            Some(limbs) => (&*limbs.angles, &*limbs.torques, &*limbs.slips),
            None => {
                own = vec![run.angles().to_vec()];
                (&*own, &[][..], &[][..])
            }
        };
        let grasp = run.grasp();
        self.rate = motion.map(|_| ServoDynamics::default().speed);
        let has_forces = limbs.as_ref().is_some_and(|limbs| !limbs.forces.is_empty());
        self.add(&Sample {
            at,
            ended: run.time(),
            travel: run.travel(),
            least_margin: motion.map(|motion| motion.least_margin),
            gap: clearance.map(|clearance| clearance.now),
            collisions: clearance.map_or(0, |clearance| clearance.collisions),
            slips,
            angles,
            torques,
            has_forces: has_forces || grasp.is_some(),
        });
        self.summary.cycles = run.cycles();
        if let Some(motion) = motion {
            let first = run.first_fall();
            self.summary.falls = Some(FallFigures {
                count: motion.falls,
                upright: motion.upright_falls,
                first_kind: first.map(|fall| FallKind::of(&motion, fall.is_upright)),
                first: first.map(|fall| Moment {
                    cycle: fall.cycle,
                    time_s: fall.time / 1000.0,
                    line: line(fall.step),
                }),
            });
        }
        if let Some(grasp) = grasp {
            let objects = (1..).zip(&grasp.objects);
            let lifts = objects.map(|(n, object)| (format!("object {n}"), object.highest));
            raise(&mut self.summary.lifts, lifts, "mm", at);
            let tips = (1..).zip(&grasp.fingertips);
            let forces = tips.map(|(n, tip)| (Target::Foot(n).to_string(), tip.greatest));
            raise(&mut self.summary.forces, forces, "N", at);
        }
        if let Some(wait) = wait {
            self.waits(wait, at, run.time(), run.period());
        }
    }

    /// Takes a cycle of a run or of a trace.
    pub fn add(&mut self, sample: &Sample<'_>) {
        let (summary, at) = (&mut self.summary, sample.at);
        let seconds = (sample.ended - self.ended) / 1000.0;
        (summary.cycles, summary.time_s) = (at.cycle + 1, sample.ended / 1000.0);
        if let Some(Travel { x, y, z, turn, .. }) = sample.travel {
            let time = sample.ended / 1000.0;
            summary.travel = Some(TravelFigures {
                forward_mm: y,
                right_mm: x,
                up_mm: z,
                turn_deg: turn,
                speed_mm_s: if time > 0.0 { y / time } else { 0.0 },
            });
        }
        if let Some(value) = sample.least_margin.filter(|margin| margin.is_finite())
            && (summary.margin.as_ref()).is_none_or(|margin| value < margin.value)
        {
            summary.margin = Some(Peak::new(value, "mm", None, None, at));
        }
        if let Some(gap) = sample.gap {
            let least = summary.clearance.as_ref();
            if least.is_none_or(|least| gap.distance < least.value) {
                let of = Some(gap.to_string());
                summary.clearance = Some(Peak::new(gap.distance, "mm", None, of, at));
            }
            let first = summary.collisions.and_then(|before| before.first);
            summary.collisions = Some(CollisionFigures {
                cycles: sample.collisions,
                first: first.or((sample.collisions > 0).then_some(at)),
            });
        }
        for (leg, slip) in (1..).zip(sample.slips) {
            let foot = || Target::Foot(leg).to_string();
            keep(&mut summary.slip, *slip, "mm", None, foot, at);
        }
        let torque_unit = match self.unit {
            TorqueUnit::NewtonMetre => "N·m",
            TorqueUnit::MillinewtonMetre => "mN·m",
        };
        let mut limits = self.torques.iter();
        for (leg, angles) in sample.angles.iter().enumerate() {
            for (joint, angle) in angles.iter().enumerate() {
                let name = || Target::Joint(leg as u8 + 1, joint as u8 + 1).to_string();
                let limit = limits.next().copied();
                let before = self.angles.get(leg).and_then(|angles| angles.get(joint));
                let turn = before.map_or(0.0, |before| libm::fabs(angle - before));
                if seconds > 0.0 && before.is_some() {
                    let rate = turn / seconds;
                    keep(&mut summary.rate, rate, "deg/s", self.rate, name, at);
                }
                let torque = sample
                    .torques
                    .get(leg)
                    .and_then(|torques| torques.get(joint));
                if let Some(torque) = torque.map(|torque| libm::fabs(*torque)) {
                    self.work += torque * turn.to_radians();
                    keep(&mut summary.torque, torque, torque_unit, limit, name, at);
                }
            }
        }
        if sample.has_forces {
            let work_j = self.work / self.unit.per_newton_metre();
            let travel = sample.travel.map(|travel| libm::hypot(travel.x, travel.y));
            let travel = travel.filter(|travel| *travel >= LEAST_TRAVEL);
            let cost = self.weight.zip(travel);
            summary.energy = Some(Energy {
                work_j,
                cost_of_transport: cost.map(|(weight, travel)| work_j / (weight * travel / 1000.0)),
            });
        }
        self.angles.clear();
        self.angles.extend_from_slice(sample.angles);
        self.ended = sample.ended;
    }

    /// Sets the number of falls of a trace, which has no other data about them.
    pub fn count_falls(&mut self, count: u32, at: Moment) {
        let falls = &mut self.summary.falls;
        let first = falls.and_then(|falls| falls.first);
        *falls = Some(FallFigures {
            count,
            upright: 0,
            first_kind: None,
            first: first.or((count > 0).then_some(at)),
        });
    }

    /// Returns the summary so far.
    pub fn summary(&self) -> &Summary {
        &self.summary
    }

    /// Keeps the longest wait of each place.
    fn waits(&mut self, wait: Wait, now: Moment, time: f64, period: f64) {
        let waits = &mut self.summary.waits;
        let passed = libm::round((time - wait.since) / period.max(f64::MIN_POSITIVE)) as u64;
        let figure = WaitFigure {
            length_s: wait.time / 1000.0,
            lines: wait.lines,
            until: wait.on,
            at: Moment {
                cycle: (now.cycle + 1).saturating_sub(passed),
                time_s: wait.since / 1000.0,
                line: wait.lines[0],
            },
        };
        match waits.iter_mut().find(|other| other.lines == figure.lines) {
            Some(other) if other.length_s >= figure.length_s => return,
            Some(other) => *other = figure,
            None => waits.push(figure),
        }
        waits.sort_by(|one, other| other.length_s.total_cmp(&one.length_s));
        waits.truncate(WAITS);
    }
}

impl Peak {
    fn new(
        value: f64,
        unit: &'static str,
        limit: Option<f64>,
        of: Option<String>,
        at: Moment,
    ) -> Self {
        Peak {
            value,
            unit,
            limit,
            of,
            at,
        }
    }
}

/// Keeps the larger of two values, the first one of equal ones.
fn keep(
    peak: &mut Option<Peak>,
    value: f64,
    unit: &'static str,
    limit: Option<f64>,
    of: impl FnOnce() -> String,
    at: Moment,
) {
    if value.is_finite() && peak.as_ref().is_none_or(|peak| value > peak.value) {
        *peak = Some(Peak::new(value, unit, limit, Some(of()), at));
    }
}

/// Keeps the larger value of each part, which the plant has measured.
fn raise(
    peaks: &mut Vec<Peak>,
    values: impl Iterator<Item = (String, f64)>,
    unit: &'static str,
    at: Moment,
) {
    for (place, (of, value)) in values.enumerate() {
        match peaks.get_mut(place) {
            Some(peak) if value > peak.value => (peak.value, peak.at) = (value, at),
            Some(_) => {}
            None => peaks.push(Peak::new(value, unit, None, Some(of), at)),
        }
    }
}
