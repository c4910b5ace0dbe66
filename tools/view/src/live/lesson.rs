//! A robot that is taught by hand, which people watch. Viewers can neither teach nor move it. The emergency stop is for everybody.
//!
//! The lesson itself is elsewhere. Its host passes on the posture and the [`LessonState`] ([`LessonSession::show`]), and obeys the
//! emergency stops that [`LessonSession::ask`] reports. A viewer gets the last posture alone, as the first cycle of a run: each one
//! replaces the one before.

use super::driven::ServoState;
use super::request::{Answer, ClientRequest, refuse};
use super::viewer::Viewer;
use crate::recorder::Recorder;
use crate::recording::{Frame, Recording, Script};
use crate::updates::{self, Part, json};
use serde::Serialize;
use tip_sim::Robot;

/// The phase of a lesson.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum LessonPhase {
    /// It has no torque, so that a hand can turn its joints.
    #[default]
    Limp,
    /// It has torque, and goes to a pose.
    Goes,
    /// It has torque, and holds a pose.
    Holds,
}

/// The state of a lesson.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LessonState {
    /// The phase of the lesson.
    pub phase: LessonPhase,
    /// The names of the poses so far.
    pub poses: Vec<String>,
    /// The place of the chosen pose, or of the one to which the robot goes, or which it holds.
    pub chosen: usize,
    /// Number of samples of a motion; `None` where poses are recorded.
    pub samples: Option<usize>,
    /// Leg by leg.
    pub servos: Vec<ServoState>,
    /// The reason why the robot cannot be measured, in words for people.
    pub problem: Option<String>,
}

/// A robot that is taught by hand, which people watch: see the [module](crate::live).
#[derive(Debug)]
pub struct LessonSession {
    recording: Recording,
    /// Number of postures so far.
    postures: u64,
    state: LessonState,
}

impl LessonSession {
    /// Creates the session of a robot in its initial posture; `name` is the file of the program that will be written.
    pub fn new(robot: &Robot, name: &str) -> Self {
        let script = Script {
            name: name.to_owned(),
            ..Script::default()
        };
        let mut recording = Recorder::new(robot, script).recording;
        let legs = recording.robot.legs.iter();
        let angles = legs.map(|leg| leg.initial.clone()).collect();
        recording.frames = vec![Frame {
            angles,
            ..Frame::default()
        }];
        LessonSession {
            recording,
            postures: 1,
            state: LessonState::default(),
        }
    }

    /// Shows a posture, the angle of each joint, leg by leg, deg, and a state. Angles of joints that the robot lacks are ignored.
    pub fn show(&mut self, angles: &[f64], state: LessonState) {
        self.state = state;
        let shown = self.recording.frames.iter_mut();
        let joints = shown.flat_map(|frame| frame.angles.iter_mut().flatten());
        let mut is_new = false;
        for (shown, angle) in joints.zip(angles) {
            is_new |= *shown != *angle;
            *shown = *angle;
        }
        self.postures += u64::from(is_new);
    }

    /// Answers a request. Only the emergency stop, which the host has to obey, is not refused.
    pub fn ask(&self, asked: &ClientRequest) -> String {
        match (&asked.request, asked.is_stop()) {
            (_, true) => asked.done(),
            (Err(refusal), _) => Answer::new(asked.id, Err(refusal.clone())).text(),
            (Ok(_), _) => Answer::new(asked.id, refuse("taught")).text(),
        }
    }

    /// Returns the next update for a viewer; none if it has everything.
    pub fn update(&self, viewer: &mut Viewer) -> Option<String> {
        if viewer.run == 0 {
            viewer.run = 1;
            return Some(updates::begin(&self.recording, 1, &[]));
        }
        if viewer.cuts != self.postures {
            viewer.cuts = self.postures;
            let part = Part {
                run: 1,
                first: 0,
                from: 0,
                until: 1,
                cycles: 1,
                now: None,
            };
            return Some(updates::more(&self.recording, &part));
        }
        let update = json(&LessonUpdate {
            r#type: "lesson",
            state: &self.state,
        });
        if viewer.robot == update {
            return None;
        }
        viewer.robot.clone_from(&update);
        Some(update)
    }
}

#[derive(Serialize)]
struct LessonUpdate<'a> {
    r#type: &'static str,
    #[serde(flatten)]
    state: &'a LessonState,
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    fn session() -> LessonSession {
        LessonSession::new(&Robot::named("titan8").expect("it has a name"), "wave.prg")
    }

    fn updates(session: &LessonSession, viewer: &mut Viewer) -> Vec<Value> {
        let texts = std::iter::from_fn(|| session.update(viewer));
        let updates = texts.map(|text| serde_json::from_str(&text).expect("JSON"));
        updates.collect()
    }

    fn types(updates: &[Value]) -> Vec<&str> {
        let types = updates.iter().map(|update| update["type"].as_str());
        types.map(|kind| kind.expect("a type")).collect()
    }

    /// A column of motion has hundredths of a degree; the joints of leg F1 come first.
    #[test]
    fn each_posture_replaces_the_one_before() {
        let (mut session, mut viewer) = (session(), Viewer::default());
        let first = updates(&session, &mut viewer);
        assert_eq!(types(&first), ["run", "more", "lesson"]);
        assert_eq!(first[0]["script"]["name"], "wave.prg");
        let joint = |name: &str| {
            let channels = first[0]["channels"].as_array().expect("names");
            channels.iter().position(|it| it == name).expect("a joint") + 1
        };
        session.show(&[12.5, -3.0], LessonState::default());
        let next = updates(&session, &mut viewer);
        assert_eq!(types(&next), ["more"]);
        assert_eq!(
            (&next[0]["from"], &next[0]["cycles"]),
            (&0.into(), &1.into())
        );
        assert_eq!(next[0]["frames"][0], serde_json::json!([0]));
        for (name, hundredths) in [("angle.0.0", 1250), ("angle.0.1", -300)] {
            assert_eq!(
                next[0]["frames"][joint(name)],
                serde_json::json!([hundredths])
            );
        }
        session.show(&[12.5, -3.0], LessonState::default());
        assert!(
            updates(&session, &mut viewer).is_empty(),
            "nothing has changed"
        );
        let state = LessonState {
            phase: LessonPhase::Holds,
            poses: vec!["UP".to_owned()],
            ..LessonState::default()
        };
        session.show(&[12.5, -3.0], state);
        let next = updates(&session, &mut viewer);
        assert_eq!(types(&next), ["lesson"]);
        assert_eq!(
            (&next[0]["phase"], &next[0]["poses"][0]),
            (&"holds".into(), &"UP".into())
        );
    }

    #[test]
    fn a_viewer_stops_the_robot_and_does_nothing_else() {
        let session = session();
        for (request, answer) in [
            (
                r#"{"do":"event","event":"key 0x0D","id":1}"#,
                r#""id":1,"ok":true"#,
            ),
            (
                r#"{"do":"event","event":"halt","id":2}"#,
                r#""error":"taught""#,
            ),
            (r#"{"do":"take","id":3}"#, r#""error":"taught""#),
            (
                r#"{"do":"edit","text":"","base":1,"by":"me"}"#,
                r#""error":"taught""#,
            ),
            (r#"{"do":"dance"}"#, r#""error":"unknown""#),
        ] {
            let told = session.ask(&ClientRequest::read(request));
            assert!(told.contains(answer), "{told}");
        }
    }
}
