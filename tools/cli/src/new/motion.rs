//! Motions for described robots: a crawling gait that was tried in simulation, or else legs that bend their joints in turn.

use crate::message::Making;
use crate::new::fill;
use std::fmt::Write as _;
use tip_lint::format::format;
use tip_runtime::command::Target;
use tip_runtime::model::Point;
use tip_sim::{Limb, Limit, Plant, Robot, RobotDescription, Run, load};

/// Strides that are tried, relative to the longest leg.
const STRIDES: [f64; 3] = [0.2, 0.12, 0.06];
/// Heights of the body that are tried, relative to the initial posture.
const HEIGHTS: [f64; 4] = [1.0, 0.85, 1.1, 0.7];
/// Height of a step, relative to the longest leg.
const LIFT: f64 = 0.08;
/// Minimum number of strides beyond the starting point.
const AHEAD: f64 = 4.0;
/// Minimum travel of a robot that walks, relative to the commanded way.
const COMES: f64 = 0.9;
/// Maximum number of control cycles of a gait.
const MAX_CYCLES: u64 = 20_000;
/// Number of gaits that work without mass and are tried with it.
const WITH_MASS: usize = 3;

/// A gait that was tried.
pub(super) struct Gait {
    pub(super) program: String,
    /// Travel of the body, mm.
    pub(super) travel: f64,
    /// True if it works with mass, too.
    pub(super) has_mass: bool,
}

/// Finds a gait on which the robot does not fall.
///
/// # Errors
/// Why there is none.
pub(super) fn find_gait(robot: &Robot) -> Result<Gait, Making> {
    let anatomy = robot.anatomy();
    if anatomy.legs.len() < 4 {
        return Err(Making::TooFewLegs);
    }
    let length = |limb: &tip_sim::Limb| {
        limb.joints
            .iter()
            .map(|joint| size(joint.link))
            .sum::<f64>()
    };
    let leg = anatomy.legs.iter().map(length).fold(0.0, f64::max);
    let (mut without_mass, mut tried) = (None, 0);
    let mut why = Making::OutOfReach;
    for height in HEIGHTS {
        for stride in STRIDES {
            let plan = Plan::new(&anatomy, round(stride * leg), round(LIFT * leg), height);
            let program = plan.program(robot);
            match plan.walks(&program, robot) {
                Ok(travel) => {
                    let massive = robot.clone().with_plant(Plant::Dynamic);
                    let has_mass = plan.walks(&program, &massive).is_ok();
                    let gait = Gait {
                        program,
                        travel,
                        has_mass,
                    };
                    tried += 1;
                    if has_mass {
                        return Ok(gait);
                    }
                    let gait = without_mass.get_or_insert(gait);
                    if tried == WITH_MASS {
                        return Ok(Gait {
                            program: gait.program.clone(),
                            ..*gait
                        });
                    }
                }
                // The shortest and lowest gait comes last.
                Err(reason) => why = reason,
            }
        }
    }
    without_mass.ok_or(why)
}

/// Positions of the feet and of the body, mm.
struct Plan {
    /// Footholds relative to the start of the body.
    feet: Vec<Point>,
    /// The order of steps: from rear to front on the left, then on the right.
    order: Vec<usize>,
    middle: Point,
    /// Offset of the body from the middle of the feet, which puts the centre of mass above it.
    offset: Point,
    strides: f64,
    stride: f64,
    lift: f64,
}

impl Plan {
    fn new(anatomy: &RobotDescription, stride: f64, lift: f64, height: f64) -> Self {
        let floor = anatomy
            .feet
            .iter()
            .map(|foot| foot[2])
            .fold(f64::INFINITY, f64::min);
        let feet: Vec<Point> = anatomy
            .feet
            .iter()
            .map(|[x, y, _]| [round(*x), round(*y), 0.0])
            .collect();
        let count = feet.len() as f64;
        let mean = |axis: usize| feet.iter().map(|foot| foot[axis]).sum::<f64>() / count;
        let middle = [mean(0), mean(1), 0.0].map(round);
        let [x, y] = centre_of_mass(anatomy);
        let offset = [-x, -y, -floor * height].map(round);
        let is_left = |leg: &usize| feet[*leg][0] < middle[0];
        let mut order: Vec<usize> = (0..feet.len()).collect();
        order.sort_by(|a, b| {
            let sides = is_left(b).cmp(&is_left(a));
            sides.then(feet[*a][1].total_cmp(&feet[*b][1]))
        });
        // Standing up may take the body back.
        let back = (-(middle[1] + offset[1]) / stride).max(0.0);
        Plan {
            feet,
            order,
            middle,
            offset,
            strides: (AHEAD + back).ceil(),
            stride,
            lift,
        }
    }

    /// Returns the travel of the body if no foot slips, mm.
    fn way(&self) -> f64 {
        self.strides * self.stride + self.middle[1] + self.offset[1]
    }

    /// Runs the gait; returns the travel, mm, if the robot does not fall.
    fn walks(&self, program: &str, robot: &Robot) -> Result<f64, Making> {
        let fails = |_| Making::OutOfReach;
        let loaded = load("walk.prg", program, robot).map_err(|_| Making::OutOfReach)?;
        let mut run = Run::new(loaded, robot.clone()).map_err(fails)?;
        run.to_end(Limit::cycles(MAX_CYCLES));
        let Some(motion) = run.motion().filter(|_| run.emergency().is_none()) else {
            return Err(Making::OutOfReach);
        };
        let (ahead, aside) = (motion.travel.y, motion.travel.x.abs());
        let comes = ahead >= COMES * self.way()
            && aside <= (1.0 - COMES) * self.way() + self.offset[0].abs();
        // A robot that lies on its belly does not fall.
        let stays_up = motion.falls == 0 && motion.least_margin >= 0.0;
        match (stays_up, comes && run.cycles() < MAX_CYCLES) {
            (true, true) => Ok(ahead),
            (true, false) => Err(Making::OutOfReach),
            (false, _) => Err(Making::Falls),
        }
    }

    /// Returns the program, formatted as by `tip fmt`.
    fn program(&self, robot: &Robot) -> String {
        let legs = || {
            (1..)
                .zip(&self.feet)
                .map(|(leg, foot)| (Target::Foot(leg), leg, foot))
        };
        let names = |letter: &str| -> String {
            let names: Vec<String> = legs().map(|(_, leg, _)| format!("{letter}{leg}")).collect();
            names.join(", ")
        };
        let share = round(1.0 / self.feet.len() as f64);
        let Plan {
            strides,
            stride,
            lift,
            ..
        } = self;
        let mut text = format!(
            "3.1\nCrawls: one foot at a time, the body over the others\n\n\
             DEF_VAR STRIDES, STRIDE, GAIN, LIFT, SETTLE, N\n\
             DEF_POS {}  // where each foot stands on the floor\n\
             DEF_POS {}  // where each foot is, seen from the body\n\
             DEF_POS MIDDLE, OFFSET, BODY  // of the feet; from there to the body; where that is\n\
             DEF_POS FOOT, AWAY, SHARE  // the foot to lift; where the body leans, and how far\n\n\
             STRIDES = {strides}\n\
             STRIDE = {stride}  // mm\n\
             GAIN = STRIDE / {}\n\
             LIFT = {lift}  // mm\n\
             SETTLE = 60  // ms for feet to take their load\n\
             SHARE.X = {share} ; SHARE.Y = {share} ; SHARE.Z = 0\n\n\
             // As in the initial posture, but for the body: its centre of mass is above the middle.\n",
            names("G"),
            names("P"),
            self.feet.len(),
        );
        // Writing to a String cannot fail.
        for (_, leg, [x, y, _]) in legs() {
            let _ = writeln!(text, "G{leg}.X = {x} ; G{leg}.Y = {y} ; G{leg}.Z = 0");
        }
        for (name, [x, y, z]) in [("MIDDLE", self.middle), ("OFFSET", self.offset)] {
            let _ = writeln!(text, "{name}.X = {x} ; {name}.Y = {y} ; {name}.Z = {z}");
        }
        text.push_str("BODY = MIDDLE + OFFSET\nCALL MOVE_BODY:\n\nFOR N = 1 TO STRIDES\n  IF HALT_REQUEST GOTO HALT:\n  MESSAGE stride %N% of %STRIDES%\n");
        for leg in &self.order {
            let _ = writeln!(text, "  CALL STEP_{}:", leg + 1);
        }
        text.push_str(
            "NEXT N\n\nHALT:\nBODY = MIDDLE + OFFSET\nCALL MOVE_BODY:\nMESSAGE_CLEAR\nEXIT\n",
        );
        for (target, leg, _) in legs() {
            let _ = write!(
                text,
                "\nSUBROUTINE STEP_{leg}:\n  FOOT = G{leg}\n  CALL LEAN:\n  REL_PTP {target} 0 0 LIFT\n  WAIT_INPOS {target}\n  \
                 REL_PTP {target} 0 STRIDE 0\n  WAIT_INPOS {target}\n  REL_PTP {target} 0 0 -LIFT\n  WAIT_INPOS {target}\n  \
                 G{leg}.Y += STRIDE\n  MIDDLE.Y += GAIN\nSUBEND\n"
            );
        }
        text.push_str(
            "\n// The body leans away from the foot that is to lift.\nSUBROUTINE LEAN:\n  AWAY = MIDDLE - FOOT\n  AWAY *= SHARE\n  BODY = MIDDLE + OFFSET\n  \
             BODY += AWAY\n  CALL MOVE_BODY:\nSUBEND\n\n// All feet start together: the hold keeps those that are first from dragging.\nSUBROUTINE MOVE_BODY:\n",
        );
        for (_, leg, _) in legs() {
            let _ = writeln!(text, "  P{leg} = G{leg} - BODY");
        }
        text.push_str("  ALL_STOP\n");
        for (target, leg, _) in legs() {
            let _ = writeln!(text, "  PTP {target} P{leg}");
        }
        text.push_str("  ALL_STOP_RELEASE\n  WAIT_INPOS ALL\n  SLEEP SETTLE\nSUBEND\n\nEND\n");
        let laid_out = format("walk.prg", text.as_bytes(), &robot.options());
        let laid_out = laid_out
            .ok()
            .and_then(|bytes| String::from_utf8(bytes).ok());
        laid_out.unwrap_or(text)
    }
}

/// Returns x and y of the centre of mass in the initial posture, in the robot frame, mm.
fn centre_of_mass(anatomy: &RobotDescription) -> [f64; 2] {
    let mut all = Vec::new();
    if let Some(body) = &anatomy.body {
        let centre = body.spread.map_or([0.0; 3], |spread| spread.centre);
        all.push((body.mass, centre));
    }
    for limb in &anatomy.legs {
        for (frame, joint) in limb.frames(&limb.initial).iter().zip(&limb.joints) {
            let centre = joint.spread.map(|spread| spread.centre);
            let centre = centre.unwrap_or(joint.link.map(|part| part / 2.0));
            all.push((joint.mass, frame.point(centre)));
        }
    }
    let mass: f64 = all.iter().map(|(mass, _)| mass).sum();
    [0, 1].map(|axis| all.iter().map(|(own, at)| own * at[axis]).sum::<f64>() / mass)
}

fn size([x, y, z]: Point) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// Rounds a number for people: to a tenth, or to two digits below 1.
fn round(value: f64) -> f64 {
    let parts = if value.abs() < 1.0 { 100.0 } else { 10.0 };
    // Adding 0 turns −0 into 0.
    (value * parts).round() / parts + 0.0
}

/// Angle that joints turn, if they can, deg.
pub(super) const BEND_ANGLE: f64 = 15.0;
/// Angles that are tried on a robot that may fall, deg.
pub(super) const BEND_ANGLES: [f64; 3] = [BEND_ANGLE, 6.0, 3.0];
/// Maximum share of the way to a limit.
const SHARE: f64 = 0.8;

/// Returns a program that turns each joint by an angle, deg.
pub(super) fn bend_program(anatomy: &RobotDescription, turn: f64) -> String {
    let numbered = (1..).zip(&anatomy.legs);
    let legs = numbered.map(|(number, limb)| bend_leg(Target::Foot(number), limb, turn));
    let begin = include_str!("../../templates/motions/bend.prg");
    let end = include_str!("../../templates/motions/bend_end.prg");
    format!("{begin}{}{end}", legs.collect::<String>())
}

/// Runs the program; returns the number of falls.
pub(super) fn count_falls(program: &str, robot: &Robot) -> u32 {
    /// Maximum number of control cycles.
    const MAX_CYCLES: u64 = 20_000;
    let Ok(loaded) = load("bend.prg", program, robot) else {
        return 0;
    };
    let Ok(mut run) = Run::new(loaded, robot.clone()) else {
        return 0;
    };
    run.to_end(Limit::cycles(MAX_CYCLES));
    run.motion().map_or(0, |motion| motion.falls)
}

/// Returns the lines for a leg.
fn bend_leg(leg: Target, limb: &Limb, turn: f64) -> String {
    let placeholders = [
        ("leg", &*leg.to_string()),
        ("bent", &degrees(&bent_angles(limb, turn))),
        ("initial", &degrees(&limb.initial)),
    ];
    fill(
        include_str!("../../templates/motions/bend_leg.prg"),
        &placeholders,
    )
}

fn degrees(angles: &[f64]) -> String {
    // A program that people read has hundredths.
    let rounded = angles.iter().map(|angle| (angle * 100.0).round() / 100.0);
    let words: Vec<String> = rounded.map(|angle| angle.to_string()).collect();
    words.join(" ")
}

/// Returns the bent angles of a leg: each joint turns to the side that raises the foot, else to the side with more room.
fn bent_angles(limb: &Limb, turn: f64) -> Vec<f64> {
    let turned = |place: usize, angle: f64| {
        let mut angles = limb.initial.clone();
        angles[place] = angle;
        angles
    };
    let height = |place, angle| limb.foot(&turned(place, angle))[2];
    let joints = limb.joints.iter().zip(&limb.initial).enumerate();
    let bent = joints.map(|(place, (joint, initial))| {
        let [down, up] = [joint.limits.min - initial, joint.limits.max - initial];
        let [down, up] = [down, up].map(|room| room.clamp(-turn / SHARE, turn / SHARE) * SHARE);
        let [down, up] = [initial + down, initial + up];
        let gain = height(place, up) - height(place, down);
        let has_room = (up - initial) >= (initial - down);
        let is_up = if gain.abs() > 1e-6 {
            gain > 0.0
        } else {
            has_room
        };
        let angle = if is_up { up } else { down };
        // A program that people read has tenths.
        (angle * 10.0).round() / 10.0
    });
    bent.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn anatomy(joints: &str, initial: &str) -> RobotDescription {
        let text = format!(
            "name = \"ours\"\njoint = [{joints}]\nleg = [{{ base = [0, 100, 0] }}]\ninitial = [{initial}]\n"
        );
        Robot::description(&text).expect("a description").anatomy()
    }

    #[test]
    fn joints_turn_to_where_the_foot_rises() {
        // A positive turn about -y raises what points along x; at the limit of 5 deg there is only the other side.
        let limb = &anatomy(
            "{ axis = \"-y\", link = [100, 0, 0], limits = [-60, 60] },
             { axis = \"y\", link = [100, 0, 0], limits = [-60, 60] },
             { axis = \"z\", link = [100, 0, 0], limits = [-60, 5] }",
            "0, 0, 0",
        )
        .legs[0];
        assert_eq!(bent_angles(limb, 15.0), [15.0, -15.0, -15.0]);
        assert_eq!(bent_angles(limb, 2.0), [2.0, -2.0, 2.0]);
    }

    #[test]
    fn a_joint_stays_within_its_limits() {
        let limb = &anatomy(
            "{ axis = \"z\", link = [100, 0, 0], limits = [-10, 2] }",
            "0",
        )
        .legs[0];
        assert_eq!(bent_angles(limb, 15.0), [-8.0]);
    }
}
