//! The sections of an MJCF file, filled in parallel.

use crate::urdf::xml;

const HEAD: &str = r#"<!-- Made by `tip robot export`. m, rad, kg, N·m; z up, x to the robot's right, y ahead.
     J11 to Jnm are the joints of the language, with its signs and zeros, and the position motors that turn them: what is commanded
     goes to their controls. link11 to linknm is what they carry; the sites F1 to Fn are the feet or fingertips, the sensors
     of that name what these carry (N). The keyframe `initial` is the initial posture. -->
"#;

/// Common settings of the plants: steps of 0.5 ms, friction of the touched surface, no contact of
/// the robot with itself. MuJoCo does not allow links without mass or thickness.
const SETTINGS: &str = r#"  <compiler angle="radian" autolimits="true" boundmass="1e-9" boundinertia="1e-12"/>
  <option timestep="0.0005" integrator="implicitfast" cone="elliptic" impratio="10" gravity="0 0 -9.80665"/>
  <default>
    <geom condim="3" friction="0 0 0" solref="0.004 1" contype="1" conaffinity="0" rgba="0.35 0.4 0.45 1"/>
    <pair condim="3" solref="0.004 1"/>
    <default class="ground"><geom contype="0" conaffinity="1" rgba="0.7 0.7 0.7 1"/></default>
    <default class="drawn"><geom contype="0" conaffinity="0" group="2" rgba="0.9 0.55 0.15 1"/></default>
  </default>
"#;

/// A MuJoCo model.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) world: Lines,
    /// Contact pairs whose friction differs from that of both geometries.
    pub(super) pairs: Lines,
    pub(super) motors: Lines,
    pub(super) sensors: Lines,
    /// The initial values of all joints, in the order of the file.
    pub(super) places: Vec<f64>,
    /// The initial values of all motors.
    pub(super) controls: Vec<f64>,
}

impl Parts {
    /// Returns the text of the file.
    pub(super) fn text(&self, name: &str) -> String {
        let name = xml::escaped(name);
        let mut text = format!("{HEAD}<mujoco model=\"{name}\">\n{SETTINGS}");
        let sections = [
            ("worldbody", &self.world),
            ("contact", &self.pairs),
            ("actuator", &self.motors),
            ("sensor", &self.sensors),
        ];
        for (section, lines) in sections {
            text.push_str(&format!("  <{section}>\n{}  </{section}>\n", lines.text));
        }
        let [places, controls] =
            [&self.places, &self.controls].map(|of| xml::vector(of.iter().copied()));
        text.push_str(&format!(
            "  <keyframe>\n    <key name=\"initial\" qpos=\"{places}\" ctrl=\"{controls}\"/>\n  </keyframe>\n</mujoco>\n"
        ));
        text
    }
}

/// Lines of a section, indented by the number of open elements.
#[derive(Default)]
pub(super) struct Lines {
    text: String,
    open: usize,
}

impl Lines {
    /// Adds an element without children: its name and attributes.
    pub(super) fn add(&mut self, element: &str) {
        self.line(&format!("<{element}/>"));
    }

    /// Begins an element with children.
    pub(super) fn open(&mut self, element: &str) {
        self.line(&format!("<{element}>"));
        self.open += 1;
    }

    /// Ends an element with children.
    pub(super) fn close(&mut self, name: &str) {
        self.open = self.open.saturating_sub(1);
        self.line(&format!("</{name}>"));
    }

    fn line(&mut self, line: &str) {
        self.text.push_str(&"  ".repeat(2 + self.open));
        self.text.push_str(line);
        self.text.push('\n');
    }
}
