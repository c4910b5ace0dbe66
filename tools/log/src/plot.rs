//! A recording as diagrams over time: one SVG file for paper, slides and web pages.

mod page;

use page::{Drawn, Page, Span, View, padded, themed};
use std::fmt;
use tip_runtime::model::Point;
use tip_sim::urdf::frame;
use tip_sim::urdf::xml::permitted;
use tip_view::{Frame, Recording, robot_frame};
use tipc::message::Lang;

/// A kind of diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Diagram {
    /// Feet that carry the robot, or fingertips that touch something.
    Gait,
    /// Paths of the feet, mm; in the world for a robot that walks.
    Feet,
    /// The angle of each joint, deg.
    Angles,
    /// Torque of each motor, in the robot's unit of torque.
    Torques,
    /// Load of each foot, or push of each fingertip, N.
    Forces,
}

impl Diagram {
    /// All of them, from top to bottom.
    pub const ALL: [Diagram; 5] = [
        Diagram::Gait,
        Diagram::Feet,
        Diagram::Angles,
        Diagram::Torques,
        Diagram::Forces,
    ];
}

/// There is nothing that these diagrams could show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NothingToPlot;

impl fmt::Display for NothingToPlot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the run has nothing that these diagrams show")
    }
}

impl std::error::Error for NothingToPlot {}

/// The height of a diagram of lines over time, and of one in the plane: pixels.
const LINES: u32 = 180;
const PLANE: u32 = 360;
/// The height of a gait diagram but for its legs, and that of each leg.
const GAIT: u32 = 76;
const ROW: u32 = 26;

/// Draws diagrams of a recording as SVG, readable on light and dark grounds. The same recording gives the same text.
///
/// # Errors
/// There is nothing to show, such as of a run without a cycle.
pub fn plot(
    recording: &Recording,
    diagrams: &[Diagram],
    lang: Lang,
) -> Result<String, NothingToPlot> {
    let plot = Plot::new(recording, lang).ok_or(NothingToPlot)?;
    let wanted = Diagram::ALL
        .into_iter()
        .filter(|one| diagrams.contains(one));
    let panels: Vec<Panel> = wanted.flat_map(|diagram| plot.panels(diagram)).collect();
    if panels.is_empty() {
        return Err(NothingToPlot);
    }
    let heights: Vec<u32> = panels.iter().map(Panel::height).collect();
    let names: Vec<String> = (1..)
        .take(recording.robot.legs.len())
        .map(frame::foot)
        .collect();
    let draw = |page: Page<'_>| -> Drawn {
        // Its characters are not looked at by what writes SVG.
        let heading = permitted(&format!(
            "{}: {}",
            recording.robot.name, recording.script.title
        ));
        let areas = page.split(&heading, &names, &heights)?;
        for (panel, area) in panels.iter().zip(areas) {
            panel.draw(&area, lang)?;
        }
        Ok(())
    };
    let text = page::svg(&heights, draw).map_err(|_| NothingToPlot)?;
    let title = Title::Page.in_lang(lang, recording.robot.is_planar);
    Ok(themed(&text, &format!("{title}: {}", recording.robot.name)))
}

/// Points of lines, leg by leg; a leg may have none.
type Lines = Vec<Vec<(f64, f64)>>;

/// A diagram with its data.
enum Panel {
    Bars {
        title: String,
        time: Span,
        /// Intervals in which each leg has contact, s.
        legs: Vec<Vec<(f64, f64)>>,
        /// Times of falls, s.
        marks: Vec<f64>,
    },
    Lines {
        title: String,
        time: Span,
        axis: (Axis, &'static str),
        legs: Lines,
    },
    /// Views side by side.
    Planes(Vec<View>),
}

impl Panel {
    fn height(&self) -> u32 {
        match self {
            Panel::Bars { legs, .. } => GAIT + ROW * legs.len() as u32,
            Panel::Lines { .. } => LINES,
            Panel::Planes(_) => PLANE,
        }
    }

    fn draw(&self, area: &page::Area<'_>, lang: Lang) -> Drawn {
        let time_axis = Axis::Time.in_lang(lang);
        match self {
            Panel::Bars {
                title,
                time,
                legs,
                marks,
            } => page::bars(area, title, time_axis, *time, legs, marks),
            Panel::Lines {
                title,
                time,
                axis,
                legs,
            } => {
                let name = format!("{} [{}]", axis.0.in_lang(lang), axis.1);
                let values = legs.iter().flatten().map(|(_, value)| *value);
                let spans = (*time, padded(values));
                page::lines(
                    area,
                    title,
                    [&format!("{time_axis} [s]"), &name],
                    spans,
                    legs,
                )
            }
            Panel::Planes(views) => page::planes(area, views),
        }
    }
}

/// A recording that is being plotted.
struct Plot<'a> {
    recording: &'a Recording,
    lang: Lang,
    time: Span,
    /// Frames to draw, not more than can be told apart.
    frames: Vec<&'a Frame>,
}

/// More points than a line of the page has pixels, and not many more.
const POINTS: usize = 2000;

impl<'a> Plot<'a> {
    fn new(recording: &'a Recording, lang: Lang) -> Option<Self> {
        let last = recording.frames.last()?;
        let stride = recording.frames.len().div_ceil(POINTS);
        Some(Plot {
            recording,
            lang,
            time: (0.0, last.time / 1000.0),
            frames: recording
                .frames
                .iter()
                .step_by(stride)
                .chain([last])
                .collect(),
        })
    }

    fn title(&self, title: Title) -> String {
        title.in_lang(self.lang, self.recording.robot.is_planar)
    }

    fn panels(&self, diagram: Diagram) -> Vec<Panel> {
        match diagram {
            Diagram::Gait => self.gait().into_iter().collect(),
            Diagram::Feet => self.feet().into_iter().collect(),
            Diagram::Angles => {
                let axis = (Axis::Angle, "deg");
                self.each_joint(axis, Title::Angle, |frame| &frame.angles)
            }
            Diagram::Torques => {
                let unit = self.recording.robot.torque_unit.symbol();
                let axis = (Axis::Torque, unit);
                self.each_joint(axis, Title::Torque, |frame| &frame.torques)
            }
            Diagram::Forces => self.forces().into_iter().collect(),
        }
    }

    fn gait(&self) -> Option<Panel> {
        let recording = self.recording;
        let legs = recording.robot.legs.len();
        if recording.frames.iter().all(|frame| frame.loads.is_empty()) {
            return None;
        }
        let begin = |cycle| recording.time(cycle) / 1000.0;
        let mut bars = vec![Vec::new(); legs];
        let ends = recording
            .contacts
            .iter()
            .skip(1)
            .map(|next| begin(next.cycle));
        for (contact, end) in recording.contacts.iter().zip(ends.chain([self.time.1])) {
            let touches = bars.iter_mut().zip(&contact.what);
            for (bar, _) in touches.filter(|(_, touches)| **touches) {
                bar.push((begin(contact.cycle), end));
            }
        }
        Some(Panel::Bars {
            title: self.title(Title::Gait),
            time: self.time,
            legs: bars,
            marks: recording
                .falls
                .iter()
                .map(|fall| begin(fall.cycle))
                .collect(),
        })
    }

    fn feet(&self) -> Option<Panel> {
        let robot = &self.recording.robot;
        let view = |title, names: [&'static str; 2], axes: [usize; 2]| {
            let legs = self.each_leg(|frame, leg| {
                let foot = self.foot(frame, leg)?;
                Some((foot[axes[0]], foot[axes[1]]))
            });
            View {
                title: self.title(title),
                names,
                // Lifts are small against strides.
                is_true: axes == [0, 1],
                legs,
            }
        };
        if self.frames.iter().all(|frame| frame.angles.is_empty()) {
            return None;
        }
        Some(Panel::Planes(match robot.is_planar {
            true => vec![view(Title::Fingertips, ["x", "y"], [0, 1])],
            false => vec![
                view(Title::FeetFromAbove, ["x", "y"], [0, 1]),
                view(Title::FeetFromTheSide, ["y", "z"], [1, 2]),
            ],
        }))
    }

    /// Returns the place of a foot, in the world if the robot walks, mm.
    fn foot(&self, frame: &Frame, leg: usize) -> Option<Point> {
        let limb = self.recording.robot.legs.get(leg)?;
        let foot = limb.foot(frame.angles.get(leg)?);
        let body = frame.pose.as_ref().map(robot_frame);
        Some(body.map_or(foot, |body| body.point(foot)))
    }

    fn each_joint(
        &self,
        axis: (Axis, &'static str),
        title: fn(usize) -> Title,
        of: impl Fn(&Frame) -> &Vec<Vec<f64>>,
    ) -> Vec<Panel> {
        let joints = self
            .recording
            .robot
            .legs
            .first()
            .map_or(0, |leg| leg.joints.len());
        let panels = (0..joints).filter_map(|joint| {
            let legs = self.over_time(|frame, leg| of(frame).get(leg)?.get(joint).copied());
            let has_values = legs.iter().any(|leg| !leg.is_empty());
            has_values.then(|| Panel::Lines {
                title: self.title(title(joint + 1)),
                time: self.time,
                axis,
                legs,
            })
        });
        panels.collect()
    }

    fn forces(&self) -> Option<Panel> {
        let legs = self.over_time(|frame, leg| frame.loads.get(leg).copied());
        let has_values = legs.iter().any(|leg| !leg.is_empty());
        has_values.then(|| Panel::Lines {
            title: self.title(Title::Force),
            time: self.time,
            axis: (Axis::Force, "N"),
            legs,
        })
    }

    fn over_time(&self, of: impl Fn(&Frame, usize) -> Option<f64>) -> Lines {
        self.each_leg(|frame, leg| Some((frame.time / 1000.0, of(frame, leg)?)))
    }

    fn each_leg(&self, of: impl Fn(&Frame, usize) -> Option<(f64, f64)>) -> Lines {
        let legs = 0..self.recording.robot.legs.len();
        let points = |leg| {
            self.frames
                .iter()
                .filter_map(|frame| of(frame, leg))
                // What has diverged has no place.
                .filter(|(x, y)| x.is_finite() && y.is_finite())
                .collect()
        };
        legs.map(points).collect()
    }
}

/// Title of a diagram; joints count from 1.
#[derive(Clone, Copy)]
enum Title {
    Page,
    Gait,
    FeetFromAbove,
    FeetFromTheSide,
    Fingertips,
    Angle(usize),
    Torque(usize),
    Force,
}

impl Title {
    /// Hands have fingers, other robots legs.
    fn in_lang(self, lang: Lang, is_hand: bool) -> String {
        match lang {
            Lang::Japanese => self.japanese(if is_hand { "指" } else { "脚" }, is_hand),
            _ => self.english(if is_hand { "finger" } else { "leg" }, is_hand),
        }
    }

    fn english(self, limb: &str, is_hand: bool) -> String {
        match self {
            Title::Page => "Motion of a robot".to_owned(),
            Title::Gait if is_hand => "Contacts: fingertips that touch something".to_owned(),
            Title::Gait => "Gait diagram: feet on the ground".to_owned(),
            Title::FeetFromAbove => "Foot paths from above (world)".to_owned(),
            Title::FeetFromTheSide => "Foot paths from the side (world)".to_owned(),
            Title::Fingertips => "Fingertip paths".to_owned(),
            Title::Angle(joint) => format!("Angle of joint {joint} of each {limb}"),
            Title::Torque(joint) => format!("Torque of joint {joint} of each {limb}"),
            Title::Force if is_hand => "Force of each fingertip".to_owned(),
            Title::Force => "Load on each foot".to_owned(),
        }
    }

    fn japanese(self, limb: &str, is_hand: bool) -> String {
        match self {
            Title::Page => "ロボットの動作".to_owned(),
            Title::Gait if is_hand => "接触図 (何かに触れている指先)".to_owned(),
            Title::Gait => "歩容線図 (接地している脚)".to_owned(),
            Title::FeetFromAbove => "足先軌跡・上面図 (世界座標系)".to_owned(),
            Title::FeetFromTheSide => "足先軌跡・側面図 (世界座標系)".to_owned(),
            Title::Fingertips => "指先軌跡".to_owned(),
            Title::Angle(joint) => format!("各{limb}の第{joint}関節の角度"),
            Title::Torque(joint) => format!("各{limb}の第{joint}関節のトルク"),
            Title::Force if is_hand => "各指先の力".to_owned(),
            Title::Force => "各脚の荷重".to_owned(),
        }
    }
}

/// Label of an axis.
#[derive(Clone, Copy)]
enum Axis {
    Time,
    Angle,
    Torque,
    Force,
}

impl Axis {
    fn in_lang(self, lang: Lang) -> &'static str {
        let [english, japanese] = match self {
            Axis::Time => ["time", "時間"],
            Axis::Angle => ["angle", "角度"],
            Axis::Torque => ["torque", "トルク"],
            Axis::Force => ["force", "力"],
        };
        match lang {
            Lang::Japanese => japanese,
            _ => english,
        }
    }
}
