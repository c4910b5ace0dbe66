//! A run as data, and the geometry of the robot in it.

use serde::Serialize;
use std::borrow::Cow;
use std::fmt;
use tip_runtime::command::{Flag, Target};
use tip_runtime::controller::Mode;
use tip_runtime::kinematics;
use tip_runtime::model::{Body, Inverse, Part, Point, Slider, TorqueUnit};
use tip_runtime::plant::{Gap, Pose, Scene};
use tip_sim::{FallKind, IssuedCommand, Limb, Robot, Summary, Timed, Wait};

/// The run of a program, from its first cycle to its last.
///
/// It has poses at 50 Hz at most, and everything else in its cycle. Lists are in the order of their cycles.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Recording {
    /// The robot.
    pub robot: Skeleton,
    /// Its surroundings.
    pub scene: Scene,
    /// The program.
    pub script: Script,
    /// Number of cycles that ran without a fault.
    pub cycles: u64,
    /// Cycles at which the control period changed.
    pub clock: Vec<Tick>,
    /// Motion of the robot, at 50 Hz at most; the last cycle has one.
    pub frames: Vec<Frame>,
    /// Everything that happened besides the motion.
    pub log: Vec<LogEntry>,
    /// Events from outside: keys, halts, inputs. A trace lacks them.
    pub events: Vec<Timed>,
    /// End of the run.
    pub outcome: Outcome,
    /// The figures of the run.
    pub summary: Summary,
    /// The wait during which the run was ended from outside, if it was. A trace lacks it.
    pub wait: Option<Wait>,
}

/// An occurrence and its cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct LogEntry {
    /// The cycle, counted from 0.
    pub cycle: u64,
    /// The occurrence.
    pub what: Occurrence,
}

/// Something that happened in a cycle, or a state that began in it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Occurrence {
    /// Another step ran than in the cycle before.
    Step(u32),
    /// A thread, counted from 1, ran another step than before; none where the thread was over.
    Thread(u8, Option<u32>),
    /// A timer did not go on as before. A trace lacks it.
    Timer {
        /// Its number.
        number: u8,
        /// It grows with the time of the robot.
        runs: bool,
        /// Its time if it stands, else the time of the robot at which it was 0, ms.
        time: f64,
    },
    /// These joints were locked, and no others. A trace lacks it.
    Locks(Vec<Target>),
    /// A message; an empty one cleared the line.
    Message(String),
    /// A variable was assigned another value.
    Assigned {
        /// Its place among [`Script::scalars`].
        scalar: usize,
        /// The value that was assigned.
        value: f64,
    },
    /// A step, not a message, read a variable for the first time after an event had set it. A trace lacks it.
    Read {
        /// Its place among [`Script::scalars`].
        scalar: usize,
        /// The line of the step, from 1.
        line: u32,
    },
    /// A lamp was switched on (true) or off.
    Lamp(u8, bool),
    /// A command was accepted.
    Command(IssuedCommand),
    /// The feet or fingertips that touched something changed; the first entry is that of cycle 0.
    Contacts(Vec<bool>),
    /// The flags of conditions that were up changed; the first entry is that of cycle 0. A trace lacks it.
    Flags(Vec<Flag>),
    /// The control modes of feet or joints, and of a slider, changed; the first entry is that of cycle 0. A trace lacks it.
    Modes(Vec<(Target, Mode)>),
    /// The robot fell.
    Fall {
        /// Number of falls so far.
        count: u32,
        /// Distance of the centre of mass from the edge of the support polygon, mm; negative outside.
        margin: f64,
        /// The kind. A trace lacks it.
        kind: Option<FallKind>,
    },
    /// These two parts of the robot overlapped; `None` where no parts did any more.
    Collision(Option<[Part; 2]>),
    /// A foot that stood had slipped by more than 5 mm, for the first time in this stance.
    Slip {
        /// The leg, from 0.
        leg: usize,
        /// Its slip in this cycle, mm.
        distance: f64,
    },
}

impl Occurrence {
    /// Returns the name of the state that this changes. An entry holds until the next one of its key.
    pub(crate) fn key(&self) -> Cow<'static, str> {
        let numbered = |kind, of: &dyn fmt::Display| Cow::Owned(format!("{kind}.{of}"));
        match self {
            Occurrence::Step(_) => "step".into(),
            Occurrence::Thread(thread, _) => numbered("thread", thread),
            Occurrence::Timer { number, .. } => numbered("timer", number),
            Occurrence::Locks(_) => "locks".into(),
            Occurrence::Message(_) => "message".into(),
            Occurrence::Assigned { scalar, .. } => numbered("set", scalar),
            Occurrence::Read { scalar, .. } => numbered("read", scalar),
            Occurrence::Lamp(device, _) => numbered("lamp", device),
            Occurrence::Command(command) => numbered("command", &command.target),
            Occurrence::Contacts(_) => "contacts".into(),
            Occurrence::Flags(_) => "flags".into(),
            Occurrence::Modes(_) => "modes".into(),
            Occurrence::Fall { .. } => "fall".into(),
            Occurrence::Collision(_) => "collision".into(),
            Occurrence::Slip { leg, .. } => numbered("slip", leg),
        }
    }
}

/// From this cycle on each takes so long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    /// The cycle.
    pub cycle: u64,
    /// Time at which it began, ms.
    pub time: f64,
    /// Control period from here on, ms.
    pub period: f64,
}

/// The program that ran, as its author sees it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Script {
    /// The name of its file, without folders.
    pub name: String,
    /// Its second line.
    pub title: String,
    /// Its text.
    pub text: String,
    /// The line of each step, from 1.
    pub lines: Vec<u32>,
    /// The names of its scalars, in order of declaration.
    pub scalars: Vec<String>,
    /// The names of its threads, in order of its text.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub threads: Vec<String>,
}

/// State of the robot at the end of a cycle.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Frame {
    /// The cycle.
    pub cycle: u64,
    /// Time at which it ended, ms.
    pub time: f64,
    /// Pose of the body in the world; none for a robot that stays where it is.
    pub pose: Option<Pose>,
    /// Angle of each joint, leg by leg, deg.
    pub angles: Vec<Vec<f64>>,
    /// Angle that each joint is commanded to be at, leg by leg, deg; that of the joint where torque drives it. Empty in a trace.
    pub setpoints: Vec<Vec<f64>>,
    /// Load of each foot, or push of each fingertip, N. Empty if it is not known.
    pub loads: Vec<f64>,
    /// Force of the ground on each foot, friction included, in the world, N. Empty where only loads
    /// are known. A trace lacks it.
    pub forces: Vec<[f64; 3]>,
    /// Slip of each foot since its touchdown, mm. Empty for a robot that does not walk. That of a trace is computed from
    /// pose, angles and loads.
    pub slips: Vec<f64>,
    /// Torque of each motor, leg by leg, in the robot's torque unit, in N·m if it has none. A trace
    /// lacks it.
    pub torques: Vec<Vec<f64>>,
    /// Distance of the centre of mass inside the support polygon, mm; negative outside.
    pub margin: Option<f64>,
    /// The least distance of two parts of the robot; none if it is not measured.
    pub gap: Option<Gap>,
    /// Force of each fingertip on floor and objects, N. Empty for a robot that is not a hand.
    pub pushes: Vec<[f64; 3]>,
    /// Place of the slider that carries the floor, mm.
    pub slider: Option<Point>,
    /// The objects, in the order of the scene. A trace does not say.
    pub objects: Vec<ObjectPose>,
    /// The flags of conditions that are up, for all joints and for each foot. A trace does not say.
    pub flags: Vec<Flag>,
    /// The joints that are driven by torque; the others are by angle. A trace does not say.
    pub torque_joints: Vec<Target>,
}

/// Pose of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectPose {
    /// Its centre, mm.
    pub position: Point,
    /// Its turn about z, deg.
    pub angle: f64,
}

/// The end of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The program ended by END or EXIT.
    Program(String),
    /// The run was interrupted.
    Interrupted,
    /// The end is not known: the trace lacks its last record.
    Unknown,
    /// The cycles were used up.
    Limit,
    /// An emergency stop.
    Emergency(Stop),
}

/// The cause of a stop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stop {
    /// The classical message.
    pub error: String,
    /// The kind of fault.
    pub kind: String,
    /// The step that failed.
    pub step: u32,
}

impl Outcome {
    /// Returns true if something went wrong.
    pub fn is_emergency(&self) -> bool {
        matches!(self, Outcome::Emergency(_))
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Outcome::Program(word) => f.write_str(word),
            Outcome::Interrupted => f.write_str("interrupted"),
            Outcome::Unknown => f.write_str("the trace was cut short"),
            Outcome::Limit => f.write_str("the cycles were used up"),
            Outcome::Emergency(stop) => write!(f, "emergency stop: {} ({})", stop.error, stop.kind),
        }
    }
}

/// Rate at which the motion is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrameRate {
    /// At 50 Hz at most, and in the last cycle.
    #[default]
    Smooth,
    /// In one cycle out of this number; in each for 0.
    Every(u64),
}

impl Recording {
    /// Returns the time at which a cycle began, ms.
    pub fn time(&self, cycle: u64) -> f64 {
        let after = self.clock.partition_point(|tick| tick.cycle <= cycle);
        let tick = after.checked_sub(1).and_then(|at| self.clock.get(at));
        tick.map_or(0.0, |tick| {
            tick.time + (cycle - tick.cycle) as f64 * tick.period
        })
    }

    /// Returns the occurrences that `of` selects, each with its cycle.
    pub fn entries<'a, T>(
        &'a self,
        of: impl Fn(&'a Occurrence) -> Option<T> + 'a,
    ) -> impl Iterator<Item = (u64, T)> + 'a {
        let log = self.log.iter();
        log.filter_map(move |entry| Some((entry.cycle, of(&entry.what)?)))
    }

    /// Returns the cycles in which the robot fell.
    pub fn falls(&self) -> impl Iterator<Item = u64> {
        let is_fall = |what: &Occurrence| matches!(what, Occurrence::Fall { .. }).then_some(());
        self.entries(is_fall).map(|(cycle, ())| cycle)
    }
}

/// A robot as links and joints, whatever its size.
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton {
    /// Name of the robot.
    pub name: String,
    /// Its body, if it walks; its frame stays where it is if not.
    pub body: Option<Body>,
    /// Its legs or fingers, F1 first.
    pub legs: Vec<Limb>,
    /// The slider that carries the floor under a hand, if it has one.
    pub slider: Option<Slider>,
    /// Unit of torques.
    pub torque_unit: TorqueUnit,
    /// All its joints turn about z, and y is the height: it is a hand.
    pub is_planar: bool,
}

impl Skeleton {
    /// Returns the skeleton of a robot.
    pub fn of(robot: &Robot) -> Self {
        let description = robot.description();
        Skeleton {
            name: robot.name().to_owned(),
            body: description.body,
            legs: description.legs,
            slider: description.slider,
            torque_unit: description
                .forces
                .map_or(TorqueUnit::NewtonMetre, |forces| forces.unit),
            is_planar: description.inverse == Inverse::Planar,
        }
    }

    /// Returns the joints of a leg, counted from 0, and then its foot, at these angles (deg), in
    /// the robot's frame, mm. A leg that does not exist has no points.
    pub fn points(&self, leg: usize, angles: &[f64]) -> Vec<Point> {
        let Some(limb) = self.legs.get(leg) else {
            return Vec::new();
        };
        let joints = limb.frames(angles).into_iter().map(|frame| frame.at);
        joints.chain([limb.foot(angles)]).collect()
    }

    /// Returns the feet in a frame, in the world if the robot walks, else in its own frame, mm.
    pub fn feet<'a>(&'a self, frame: &'a Frame) -> impl Iterator<Item = Point> + 'a {
        let body = frame.pose.as_ref().map(robot_frame);
        let legs = self.legs.iter().zip(&frame.angles);
        legs.map(move |(leg, angles)| {
            let foot = leg.foot(angles);
            body.map_or(foot, |body| body.point(foot))
        })
    }
}

/// Returns the robot's frame in the world: turned by yaw about z first, then by pitch about x, then
/// by roll about y.
pub fn robot_frame(pose: &Pose) -> kinematics::Frame {
    let sin_cos = |angle: f64| libm::sincos(angle.to_radians());
    let ((sr, cr), (sp, cp), (sy, cy)) =
        (sin_cos(pose.roll), sin_cos(pose.pitch), sin_cos(pose.yaw));
    kinematics::Frame {
        at: pose.position,
        axes: [
            [cy * cr - sy * sp * sr, sy * cr + cy * sp * sr, -cp * sr],
            [-sy * cp, cy * cp, sp],
            [cy * sr + sy * sp * cr, sy * sr - cy * sp * cr, cp * cr],
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(one: Point, other: Point) -> bool {
        let far = one
            .iter()
            .zip(other)
            .map(|(one, other)| (one - other).abs());
        far.fold(0.0, f64::max) < 1e-9
    }

    #[test]
    fn a_leg_of_titan_stands_where_its_links_lead() {
        let titan = Skeleton::of(&Robot::named("titan8").expect("it has a name"));
        // Base, 50 and 240 mm outwards, 200 mm down.
        let points = titan.points(1, &[0.0, 0.0, 90.0]);
        let expected = [
            [101.0, 201.0, 0.0],
            [151.0, 201.0, 0.0],
            [391.0, 201.0, 0.0],
            [391.0, 201.0, -200.0],
        ];
        assert_eq!(points.len(), expected.len());
        assert!(
            points.iter().zip(expected).all(|(at, to)| near(*at, to)),
            "{points:?}"
        );
        assert!(titan.points(4, &[0.0; 3]).is_empty(), "it has no fifth leg");
    }

    #[test]
    fn a_pose_turns_as_its_angles_say() {
        let placed = |[roll, pitch, yaw]: [f64; 3], point| {
            let position = [1.0, 2.0, 3.0];
            robot_frame(&Pose {
                position,
                roll,
                pitch,
                yaw,
            })
            .point(point)
        };
        let (right, forward) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        // A yaw of 90 deg turns forward to the left, a pitch raises the front, a roll lowers the right side.
        assert!(near(placed([0.0, 0.0, 90.0], forward), [0.0, 2.0, 3.0]));
        assert!(near(placed([0.0, 90.0, 0.0], forward), [1.0, 2.0, 4.0]));
        assert!(near(placed([90.0, 0.0, 0.0], right), [1.0, 2.0, 2.0]));
        // The pitch is about the x axis that the yaw has turned, the roll about the y axis that both have.
        assert!(near(placed([0.0, 90.0, 90.0], forward), [1.0, 2.0, 4.0]));
        assert!(near(placed([90.0, 90.0, 0.0], right), [1.0, 3.0, 3.0]));
    }
}
