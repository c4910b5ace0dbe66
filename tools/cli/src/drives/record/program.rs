//! The program of a motion that was taught by hand, as a person would write it.

use super::thin::{Sample, on_cycles, thin};
use std::fmt::Write as _;
use tip_runtime::command::Target;
use tip_runtime::model::{Range, Standards};

/// Limits of the robot that the program moves.
#[derive(Clone, Debug)]
pub(super) struct Limits {
    /// Joints of each leg.
    pub(super) of_leg: usize,
    /// The limits of each joint, deg.
    pub(super) joints: Vec<Range>,
    /// Sampling time, ms.
    pub(super) period: f64,
    /// Speed of the way to the first pose, and the lowest one between poses, deg/s.
    pub(super) slow: f64,
    /// The highest speed of each joint, deg/s.
    pub(super) speeds: Vec<f64>,
    /// The parameters at the start of a program.
    pub(super) standards: Standards,
}

/// A pose that was taught.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Pose {
    /// The beginning of the names of its variables, in capital letters.
    pub(super) name: String,
    pub(super) sample: Sample,
}

impl Pose {
    /// Returns the name of the variable of a leg, from 1.
    pub(super) fn variable(name: &str, leg: usize) -> String {
        format!("{name}_{}", Target::Foot(leg as u8))
    }
}

/// The program of a motion.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Motion {
    pub(super) text: String,
    /// Number of set points.
    pub(super) points: usize,
    /// A joint that a hand has turned faster than it can turn, the fastest one, and its speed, deg/s.
    pub(super) fastest: Option<(usize, f64)>,
}

/// The first lines of a program behind its title. All joints of a pose set off in one cycle.
const HEAD: &str = "TIP_SPEED_UP 255  // all legs set off in one cycle\n";

impl Limits {
    /// Returns angles as a program has them: in tenths, and within the limits.
    fn written(&self, angles: &[f64]) -> Vec<f64> {
        let joints = angles.iter().zip(&self.joints);
        let tenths = |(angle, limits): (&f64, &Range)| {
            let inside = ((limits.min * 10.0).ceil(), (limits.max * 10.0).floor());
            ((angle * 10.0).round().max(inside.0).min(inside.1) / 10.0) + 0.0
        };
        joints.map(tenths).collect()
    }

    /// Returns the program that goes from pose to pose and stops at each. A way takes the time between the poses, but is neither
    /// slower than the way to the first pose nor faster than the joints can turn.
    pub(super) fn poses(&self, poses: &[Pose]) -> Motion {
        let count = match poses.len() {
            1 => "1 pose".to_owned(),
            count => format!("{count} poses"),
        };
        let mut text = format!("3.2\nTaught by hand: {count}\n");
        let written: Vec<Vec<f64>> = poses
            .iter()
            .map(|pose| self.written(&pose.sample.angles))
            .collect();
        let legs = |pose: usize| (1..).zip(written[pose].chunks(self.of_leg));
        let name = |pose: usize, leg| Pose::variable(&poses[pose].name, leg);
        // Writing to a String cannot fail.
        for pose in 0..poses.len() {
            let names: Vec<String> = legs(pose).map(|(leg, _)| name(pose, leg)).collect();
            let _ = writeln!(text, "DEF_JOINT {}", names.join(", "));
        }
        text += HEAD;
        for pose in 0..poses.len() {
            text.push('\n');
            for (leg, angles) in legs(pose) {
                let name = name(pose, leg);
                let joints = (1..).zip(angles);
                let members: Vec<String> = joints
                    .map(|(joint, angle)| format!("{name}.J{joint} = {angle}"))
                    .collect();
                let _ = writeln!(text, "{}", members.join(" ; "));
            }
        }
        for pose in 0..poses.len() {
            let (speed, comment) = match pose.checked_sub(1) {
                None => (self.slow, "slowly to the first pose".to_owned()),
                Some(before) => {
                    let way = farthest(&written[before], &written[pose]);
                    let time = (poses[pose].sample.time - poses[before].sample.time) / 1000.0;
                    let speed = self.speed(way, time);
                    (
                        speed,
                        format!(
                            "{:.1} s",
                            duration(way, speed, self.standards.omega_dot_max)
                        ),
                    )
                }
            };
            let _ = writeln!(text, "\nSET_OMEGA_MAX ALL {speed}  // {comment}");
            for (leg, _) in legs(pose) {
                let _ = writeln!(text, "PTP_ANGLE F{leg} {}", name(pose, leg));
            }
            text += "WAIT_INPOS ALL\n";
        }
        Motion {
            text: text + "END\n",
            points: poses.len(),
            fastest: None,
        }
    }

    /// Returns a program that sets the parameters that it has changed back to their values at the start of a program, for the lines
    /// that are to follow.
    pub(super) fn with_standards(&self, text: &str) -> String {
        let speed = self.standards.omega_max;
        format!(
            "{}\nSET_OMEGA_MAX ALL {speed}  // as at the start of a program\nTIP_SPEED_UP 1\nEND\n",
            text.trim_end_matches("END\n")
        )
    }

    /// Returns the speed limit with which a joint takes a time, s, for a way, deg: in tenths, and one that this robot can have.
    fn speed(&self, way: f64, time: f64) -> f64 {
        let acceleration = self.standards.omega_dot_max;
        let reach = acceleration * time;
        let left = reach * reach - 4.0 * acceleration * way;
        let fits = match left >= 0.0 {
            true => (reach - left.sqrt()) / 2.0,
            false => f64::INFINITY,
        };
        let fast = self.speeds.iter().copied().fold(f64::INFINITY, f64::min);
        let speed = fits.max(self.slow).min(fast);
        (speed * 10.0).round().max(1.0) / 10.0
    }

    /// Returns the program that follows samples with as few set points as keep every joint within `error` deg. It does not stop at
    /// them: each way takes its own number of cycles.
    pub(super) fn motion(&self, samples: &[Sample], error: f64) -> Motion {
        let cycles = on_cycles(samples, self.period);
        let played: Vec<Vec<f64>> = cycles.iter().map(|angles| self.written(angles)).collect();
        let kept = thin(&cycles, &played, error);
        let time = cycles.len().saturating_sub(1) as f64 * self.period / 1000.0;
        let mut fastest: Option<(usize, f64)> = None;
        let mut text = format!(
            "3.2\nTaught by hand: a motion of {time:.1} s, within {error} deg\n{HEAD}\n\
             SET_OMEGA_MAX ALL {}  // slowly to the beginning\n",
            self.slow
        );
        let legs = |cycle: usize| (1..).zip(played[cycle].chunks(self.of_leg));
        // Writing to a String cannot fail.
        for (leg, angles) in kept.first().into_iter().flat_map(|first| legs(*first)) {
            let _ = writeln!(text, "PTP_ANGLE F{leg} {}", words(angles));
        }
        text += "WAIT_INPOS ALL\n";
        let mut speeds = vec![self.slow; self.joints.len()];
        for pair in kept.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let time = (to - from) as f64 * self.period;
            text.push('\n');
            let before = played[from].chunks(self.of_leg);
            for ((leg, angles), before) in legs(to).zip(before) {
                if angles == before {
                    continue;
                }
                let first = (leg - 1) * self.of_leg;
                for (joint, (angle, before)) in angles.iter().zip(before).enumerate() {
                    // Rounded up, so that the joint is there before it is sent on.
                    let speed = ((angle - before).abs() / time * 1e5 - 1e-6).ceil() / 100.0;
                    let place = first + joint;
                    if speed > fastest.map_or(self.speeds[place], |(_, speed)| speed) {
                        fastest = Some((place, speed));
                    }
                    let last = &mut speeds[place];
                    if angle != before && *last != speed {
                        *last = speed;
                        let _ = writeln!(text, "SET_OMEGA_MAX J{leg}{} {speed}", joint + 1);
                    }
                }
                let _ = writeln!(text, "PTP_ANGLE HS F{leg} {}", words(angles));
            }
            let _ = writeln!(text, "SLEEP {time}");
        }
        Motion {
            text: text + "WAIT_INPOS ALL\nEND\n",
            points: kept.len(),
            fastest,
        }
    }
}

fn words(angles: &[f64]) -> String {
    let words: Vec<String> = angles.iter().map(f64::to_string).collect();
    words.join(" ")
}

/// Returns the longest way of a joint between two poses, deg.
fn farthest(from: &[f64], to: &[f64]) -> f64 {
    let ways = from.iter().zip(to).map(|(from, to)| (to - from).abs());
    ways.fold(0.0, f64::max)
}

/// Returns the time of a way from rest to rest, s.
fn duration(way: f64, speed: f64, acceleration: f64) -> f64 {
    match way * acceleration >= speed * speed {
        true => way / speed + speed / acceleration,
        false => 2.0 * (way / acceleration).sqrt(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tip_sim::{Robot, Run, load};

    const ROBOT: &str = "name = \"two\"
joint = [
    { axis = \"z\", link = [50, 0, 0], limits = [-90, 90] },
    { axis = \"y\", link = [100, 0, 0], limits = [-90, 90] },
]
leg = [{ base = [80, 0, 0] }, { base = [-80, 0, 0] }]
";

    /// Two legs of two joints, in cycles of 20 ms.
    fn limits() -> Limits {
        Limits {
            of_leg: 2,
            joints: vec![Range::new(-90.0, 90.0); 4],
            period: 20.0,
            slow: 30.0,
            speeds: vec![180.0, 90.0, 180.0, 180.0],
            standards: Standards {
                omega_dot_max: 360.0,
                ..Robot::from_description(ROBOT)
                    .expect("a description")
                    .description()
                    .standards
            },
        }
    }

    fn sample(time: f64, angles: [f64; 4]) -> Sample {
        let angles = angles.to_vec();
        Sample { time, angles }
    }

    /// Derives the speeds by hand. For 50 deg in 2 s, 50 / v + v / 360 = 2 gives 26.0 deg/s; the lowest speed is 30 deg/s, with which
    /// the motion takes 1.75 s. For 60 deg in 1 s it gives 76.1 deg/s. For 90 deg in 0.5 s no speed is high enough; at 180 deg/s the
    /// motion takes 1 s.
    #[test]
    fn poses_have_names_and_the_times_of_the_lesson() {
        let poses = [
            sample(0.0, [0.0, 10.0, 0.0, -20.0]),
            sample(2000.0, [50.0, 10.04, 0.0, -20.0]),
            sample(3000.0, [50.0, 70.0, -0.02, -20.0]),
            sample(3500.0, [50.0, 70.0, 90.04, -20.0]),
        ];
        let poses: Vec<Pose> = (1..)
            .zip(poses)
            .map(|(number, sample)| Pose {
                name: format!("POSE{number}"),
                sample,
            })
            .collect();
        let mut limits = limits();
        limits.speeds = vec![180.0; 4];
        let text = limits.poses(&poses).text;
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[..16],
            [
                "3.2",
                "Taught by hand: 4 poses",
                "DEF_JOINT POSE1_F1, POSE1_F2",
                "DEF_JOINT POSE2_F1, POSE2_F2",
                "DEF_JOINT POSE3_F1, POSE3_F2",
                "DEF_JOINT POSE4_F1, POSE4_F2",
                "TIP_SPEED_UP 255  // all legs set off in one cycle",
                "",
                "POSE1_F1.J1 = 0 ; POSE1_F1.J2 = 10",
                "POSE1_F2.J1 = 0 ; POSE1_F2.J2 = -20",
                "",
                "POSE2_F1.J1 = 50 ; POSE2_F1.J2 = 10",
                "POSE2_F2.J1 = 0 ; POSE2_F2.J2 = -20",
                "",
                "POSE3_F1.J1 = 50 ; POSE3_F1.J2 = 70",
                "POSE3_F2.J1 = 0 ; POSE3_F2.J2 = -20",
            ]
        );
        let speeds: Vec<&str> = lines
            .into_iter()
            .filter(|line| line.starts_with("SET_"))
            .collect();
        assert_eq!(
            speeds,
            [
                "SET_OMEGA_MAX ALL 30  // slowly to the first pose",
                "SET_OMEGA_MAX ALL 30  // 1.8 s",
                "SET_OMEGA_MAX ALL 76.1  // 1.0 s",
                "SET_OMEGA_MAX ALL 180  // 1.0 s",
            ]
        );
        assert!(text.contains("POSE4_F2.J1 = 90 ; "), "within its limits");
        let robot = Robot::from_description(ROBOT).expect("a description");
        assert!(load("taught.prg", &text, &robot).is_ok());
    }

    /// J11 goes to 20 deg in 10 cycles of 20 ms and back in 20; J22 goes from 0 to 30 all the while. At the corner it is at 10.
    #[test]
    fn a_motion_is_lines_between_its_corners() {
        let corners = [
            sample(0.0, [0.0, 5.0, 0.0, 0.0]),
            sample(200.0, [20.0, 5.0, 0.0, 10.0]),
            sample(600.0, [0.0, 5.0, 0.0, 30.0]),
        ];
        let Motion {
            text,
            points,
            fastest,
        } = limits().motion(&corners, 1.0);
        assert_eq!((points, fastest), (3, None));
        assert_eq!(
            text,
            "3.2
Taught by hand: a motion of 0.6 s, within 1 deg
TIP_SPEED_UP 255  // all legs set off in one cycle

SET_OMEGA_MAX ALL 30  // slowly to the beginning
PTP_ANGLE F1 0 5
PTP_ANGLE F2 0 0
WAIT_INPOS ALL

SET_OMEGA_MAX J11 100
PTP_ANGLE HS F1 20 5
SET_OMEGA_MAX J22 50
PTP_ANGLE HS F2 0 10
SLEEP 200

SET_OMEGA_MAX J11 50
PTP_ANGLE HS F1 0 5
PTP_ANGLE HS F2 0 30
SLEEP 400
WAIT_INPOS ALL
END
"
        );
    }

    /// 20 deg in 0.2 s are 100 deg/s, and J12 can turn at 90.
    #[test]
    fn a_joint_that_was_turned_too_fast_is_known() {
        let ends = [
            sample(0.0, [0.0, 5.0, 0.0, 0.0]),
            sample(200.0, [21.0, 25.0, 0.0, 0.0]),
        ];
        assert_eq!(limits().motion(&ends, 1.0).fastest, Some((1, 100.0)));
    }

    /// Played by the simulation, every joint is within the error of each sample at its time, but for the rounding of speeds.
    #[test]
    fn a_motion_is_played_in_its_time() {
        let samples: Vec<Sample> = (0..200)
            .map(|cycle| {
                let time = f64::from(cycle) * 20.0;
                let wave = |speed: f64, size: f64| size * (speed * time / 1000.0).sin();
                sample(
                    time,
                    [wave(2.0, 50.0), wave(0.7, 30.0), wave(3.0, 10.0), 12.0],
                )
            })
            .collect();
        let Motion { text, points, .. } = limits().motion(&samples, 1.0);
        assert!((10..40).contains(&points), "{points}");
        let robot = Robot::from_description(ROBOT).expect("a description");
        let program = load("taught.prg", &text, &robot).expect("a program");
        let mut run = Run::new(program, robot).expect("its robot");
        let mut played = vec![];
        while run.ending().is_none() {
            run.advance(None);
            let angle = |command: &tip_runtime::hardware::JointCommand| match *command {
                tip_runtime::hardware::JointCommand::Angle { angle, .. } => angle,
                _ => f64::NAN,
            };
            played.push(run.commands().iter().map(angle).collect::<Vec<f64>>());
        }
        let away = |delay: usize| {
            let pairs = samples.iter().zip(&played[delay..]);
            let joints = pairs.flat_map(|(sample, played)| sample.angles.iter().zip(played));
            joints
                .map(|(one, other)| (one - other).abs())
                .fold(0.0, f64::max)
        };
        // The way to the first pose comes before it.
        let least = (0..played.len() - samples.len())
            .map(away)
            .fold(f64::INFINITY, f64::min);
        assert!(least <= 1.1, "{least} deg");
    }
}
