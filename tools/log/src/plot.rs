//! A recording as diagrams over time: one SVG file for paper, slides and web pages.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::fmt;
use tip_sim::urdf::frame::foot;
use tip_sim::urdf::xml::permitted;
use tip_view::{Frame, Occurrence, Recording};
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
    let names: Vec<String> = (1..).take(recording.robot.legs.len()).map(foot).collect();
    let draw = |page: Page<'_>| -> Drawn {
        // Its characters are not looked at by what writes SVG.
        let heading = permitted(&format!(
            "{}: {}",
            recording.robot.name, recording.script.title
        ));
        let areas = page.split(&heading, &names, &heights)?;
        for (panel, area) in panels.iter().zip(areas) {
            panel.draw(&area, &Axis::Time.in_lang(lang).to_string())?;
        }
        Ok(())
    };
    let text = svg(&heights, draw).map_err(|_| NothingToPlot)?;
    let title = Title::Page.in_lang(lang);
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
        /// The name of the axis that points up, with its unit.
        axis: String,
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

    fn draw(&self, area: &Area<'_>, time_axis: &str) -> Drawn {
        match self {
            Panel::Bars {
                title,
                time,
                legs,
                marks,
            } => bars(area, title, time_axis, *time, legs, marks),
            Panel::Lines {
                title,
                time,
                axis,
                legs,
            } => {
                let values = legs.iter().flatten().map(|(_, value)| *value);
                let (names, spans) = (
                    [&*format!("{time_axis} [s]"), axis],
                    (*time, padded(values)),
                );
                lines(area, title, names, spans, legs)
            }
            Panel::Planes(views) => planes(area, views),
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

    fn panels(&self, diagram: Diagram) -> Vec<Panel> {
        let robot = &self.recording.robot;
        let (is_hand, unit) = (robot.is_planar, robot.torque_unit.symbol());
        let limb = || if is_hand { Limb::Finger } else { Limb::Leg };
        match diagram {
            Diagram::Gait => self.gait().into_iter().collect(),
            Diagram::Feet => self.feet().into_iter().collect(),
            Diagram::Angles => {
                let limb = limb();
                let title = |joint| Title::Angle {
                    joint,
                    limb: limb.clone(),
                };
                self.each_joint(title, (Axis::Angle, "deg"), |frame| &frame.angles)
            }
            Diagram::Torques => {
                let limb = limb();
                let title = |joint| Title::Torque {
                    joint,
                    limb: limb.clone(),
                };
                self.each_joint(title, (Axis::Torque, unit), |frame| &frame.torques)
            }
            Diagram::Forces => {
                let title = if is_hand { Title::Pushes } else { Title::Loads };
                let legs = self.over_time(|frame, leg| frame.loads.get(leg).copied());
                let panel = self.lines(&title, &(Axis::Force, "N"), legs);
                panel.into_iter().collect()
            }
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
        let contacts = recording.entries(|what| match what {
            Occurrence::Contacts(touch) => Some(touch),
            _ => None,
        });
        let contacts: Vec<_> = contacts.collect();
        let ends = contacts.iter().skip(1).map(|(next, _)| begin(*next));
        for ((cycle, touch), end) in contacts.iter().zip(ends.chain([self.time.1])) {
            let touches = bars.iter_mut().zip(*touch);
            for (bar, _) in touches.filter(|(_, touches)| **touches) {
                bar.push((begin(*cycle), end));
            }
        }
        let title = match recording.robot.is_planar {
            true => Title::Contacts,
            false => Title::Gait,
        };
        Some(Panel::Bars {
            title: title.in_lang(self.lang).to_string(),
            time: self.time,
            legs: bars,
            marks: recording.falls().map(begin).collect(),
        })
    }

    fn feet(&self) -> Option<Panel> {
        let robot = &self.recording.robot;
        let view = |title: Title, names: [&'static str; 2], axes: [usize; 2]| {
            let legs = self.each_leg(|frame, leg| {
                let foot = robot.feet(frame).nth(leg)?;
                Some((foot[axes[0]], foot[axes[1]]))
            });
            View {
                title: title.in_lang(self.lang).to_string(),
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

    fn each_joint(
        &self,
        title: impl Fn(usize) -> Title,
        axis: (Axis, &str),
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
            self.lines(&title(joint + 1), &axis, legs)
        });
        panels.collect()
    }

    /// Returns the panel of some lines, if there are values.
    fn lines(&self, title: &Title, (axis, unit): &(Axis, &str), legs: Lines) -> Option<Panel> {
        let has_values = legs.iter().any(|leg| !leg.is_empty());
        has_values.then(|| Panel::Lines {
            title: title.in_lang(self.lang).to_string(),
            time: self.time,
            axis: format!("{} [{unit}]", axis.in_lang(self.lang)),
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

tipc::message_table! {
    /// Titles of the page and of diagrams; joints count from 1.
    Title;

    Page
        "Motion of a robot",
        "ロボットの動作";
    Contacts
        "Contacts: fingertips that touch something",
        "接触図 (何かに触れている指先)";
    Gait
        "Gait diagram: feet on the ground",
        "歩容線図 (接地している脚)";
    FeetFromAbove
        "Foot paths from above (world)",
        "足先軌跡・上面図 (世界座標系)";
    FeetFromTheSide
        "Foot paths from the side (world)",
        "足先軌跡・側面図 (世界座標系)";
    Fingertips
        "Fingertip paths",
        "指先軌跡";
    Angle { joint: usize, limb: Limb }
        "Angle of joint {joint} of each {limb}",
        "各{limb}の第{joint}関節の角度";
    Torque { joint: usize, limb: Limb }
        "Torque of joint {joint} of each {limb}",
        "各{limb}の第{joint}関節のトルク";
    Pushes
        "Force of each fingertip",
        "各指先の力";
    Loads
        "Load on each foot",
        "各脚の荷重";
}

tipc::message_table! {
    /// Parts of robots.
    Limb;

    Finger "finger", "指";
    Leg "leg", "脚";
}

tipc::message_table! {
    /// Labels of axes.
    Axis;

    Time "time", "時間";
    Angle "angle", "角度";
    Torque "torque", "トルク";
    Force "force", "力";
}

/// From one value to another.
type Span = (f64, f64);

/// A part of the page.
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

type Failed<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

/// Result of drawing.
type Drawn = Result<(), Box<dyn std::error::Error>>;

const WIDTH: u32 = 960;
const HEADING: u32 = 64;
const FONT: &str = "sans-serif";
const SMALL: i32 = 12;
const TITLE: i32 = 15;
const LARGE: i32 = 20;
/// Left of the axes, where the numbers are.
const LEFT: u32 = 64;

/// An empty page.
struct Page<'a>(Area<'a>);

/// Draws diagrams of these heights on a page.
fn svg(
    heights: &[u32],
    draw: impl FnOnce(Page<'_>) -> Drawn,
) -> Result<String, Box<dyn std::error::Error>> {
    let mut text = String::new();
    let height = HEADING + heights.iter().sum::<u32>();
    let area = SVGBackend::with_string(&mut text, (WIDTH, height)).into_drawing_area();
    area.fill(&ground()).map_err(said)?;
    draw(Page(area))?;
    Ok(text)
}

fn said(failed: Failed<'_>) -> Box<dyn std::error::Error> {
    failed.to_string().into()
}

impl<'a> Page<'a> {
    /// Writes the heading and the names of the legs, and gives the parts below.
    fn split(
        self,
        heading: &str,
        names: &[String],
        heights: &[u32],
    ) -> Result<Vec<Area<'a>>, Box<dyn std::error::Error>> {
        let (head, mut rest) = self.0.split_vertically(HEADING);
        head.draw(&Text::new(
            heading.to_owned(),
            (16, 12),
            (FONT, LARGE).into_font().color(&ink()),
        ))
        .map_err(said)?;
        for (number, name) in names.iter().enumerate() {
            let x = LEFT as i32 + 64 * number as i32;
            let line = PathElement::new([(x, 50), (x + 20, 50)], leg(number).stroke_width(4));
            head.draw(&line).map_err(said)?;
            let style = (FONT, SMALL + 1).into_font().color(&ink());
            head.draw(&Text::new(name.clone(), (x + 26, 44), style))
                .map_err(said)?;
        }
        let mut areas = Vec::new();
        for height in heights {
            let (area, below) = rest.split_vertically(*height);
            areas.push(area);
            rest = below;
        }
        Ok(areas)
    }
}

/// Returns the range of all values, with some room.
fn padded(values: impl Iterator<Item = f64> + Clone) -> Span {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let most = values.fold(f64::NEG_INFINITY, f64::max);
    match least <= most {
        true => {
            let room = (0.05 * (most - least)).max(0.5);
            (least - room, most + room)
        }
        false => (0.0, 1.0),
    }
}

/// Widens an empty range, so that it can be an axis.
fn open((from, to): Span) -> std::ops::Range<f64> {
    from..if to > from { to } else { from + 1.0 }
}

fn chart<'a, 'b>(area: &'b Area<'a>, title: &str) -> ChartBuilder<'b, 'b, SVGBackend<'a>> {
    let mut builder = ChartBuilder::on(area);
    builder
        .caption(title, (FONT, TITLE).into_font().color(&ink()))
        .margin(8)
        .margin_right(20)
        .x_label_area_size(38)
        .y_label_area_size(LEFT - 8);
    builder
}

/// Draws a line for each leg.
fn lines(
    area: &Area<'_>,
    title: &str,
    [across, up]: [&str; 2],
    (x, y): (Span, Span),
    legs: &[Vec<(f64, f64)>],
) -> Drawn {
    let mut chart = chart(area, title)
        .build_cartesian_2d(open(x), open(y))
        .map_err(said)?;
    let style = (FONT, SMALL).into_font().color(&ink());
    chart
        .configure_mesh()
        .x_desc(across)
        .y_desc(up)
        .label_style(style.clone())
        .axis_desc_style(style)
        .axis_style(ink())
        .bold_line_style(grid())
        .light_line_style(TRANSPARENT)
        .x_labels(10)
        .y_labels(5)
        .x_label_formatter(&|value| rounded(*value))
        .y_label_formatter(&|value| rounded(*value))
        .draw()
        .map_err(said)?;
    for (number, points) in legs.iter().enumerate() {
        let series = LineSeries::new(points.iter().copied(), leg(number).stroke_width(2));
        chart.draw_series(series).map_err(said)?;
    }
    Ok(())
}

/// Returns a number of an axis without the dust of its steps.
fn rounded(value: f64) -> String {
    let value = (value * 1e6).round() / 1e6 + 0.0;
    value.to_string()
}

/// Paths in a plane, mm.
struct View {
    title: String,
    /// Names of its axes.
    names: [&'static str; 2],
    /// True if a unit is as long across as up.
    is_true: bool,
    legs: Vec<Vec<(f64, f64)>>,
}

/// Views side by side.
fn planes(area: &Area<'_>, views: &[View]) -> Drawn {
    let areas = area.split_evenly((1, views.len().max(1)));
    for (area, view) in areas.iter().zip(views) {
        let points = || view.legs.iter().flatten();
        let x = padded(points().map(|point| point.0));
        let y = padded(points().map(|point| point.1));
        let spans = if view.is_true {
            true_to_scale(area, x, y)
        } else {
            (x, y)
        };
        let names = view.names.map(|name| format!("{name} [mm]"));
        lines(area, &view.title, [&names[0], &names[1]], spans, &view.legs)?;
    }
    Ok(())
}

/// Spans that hold these, as long across as up.
fn true_to_scale(area: &Area<'_>, x: Span, y: Span) -> (Span, Span) {
    let (width, height) = area.dim_in_pixel();
    // What margins, title and numbers take.
    let [width, height] =
        [width.saturating_sub(92), height.saturating_sub(76)].map(|side| f64::from(side.max(1)));
    let scale = ((x.1 - x.0) / width).max((y.1 - y.0) / height);
    let wide = |(from, to): Span, pixels: f64| {
        let (middle, half) = ((from + to) / 2.0, scale * pixels / 2.0);
        (middle - half, middle + half)
    };
    (wide(x, width), wide(y, height))
}

/// Draws a row of bars for each leg, the first one on top, and a line at each mark.
fn bars(
    area: &Area<'_>,
    title: &str,
    across: &str,
    time: Span,
    legs: &[Vec<(f64, f64)>],
    marks: &[f64],
) -> Drawn {
    let count = legs.len() as f64;
    let mut chart = chart(area, title)
        .build_cartesian_2d(open(time), 0.0..count)
        .map_err(said)?;
    let style = (FONT, SMALL).into_font().color(&ink());
    chart
        .configure_mesh()
        .x_desc(format!("{across} [s]"))
        .label_style(style.clone())
        .axis_desc_style(style.clone())
        .axis_style(ink())
        .bold_line_style(grid())
        .light_line_style(TRANSPARENT)
        .disable_y_mesh()
        .x_labels(10)
        .y_labels(0)
        .x_label_formatter(&|value| rounded(*value))
        .draw()
        .map_err(said)?;
    for (number, bars) in (1..).zip(legs) {
        let middle = count - f64::from(number) + 0.5;
        let rectangles = bars.iter().map(|(from, to)| {
            Rectangle::new(
                [(*from, middle - 0.35), (*to, middle + 0.35)],
                leg(usize::from(number) - 1).filled(),
            )
        });
        chart.draw_series(rectangles).map_err(said)?;
        let (x, y) = chart.backend_coord(&(time.0, middle));
        let (left, top) = area.get_base_pixel();
        let beside = style.pos(Pos::new(HPos::Right, VPos::Center));
        let name = Text::new(foot(number), (x - left - 8, y - top), beside);
        area.draw(&name).map_err(said)?;
    }
    let falls = marks
        .iter()
        .map(|at| PathElement::new([(*at, 0.0), (*at, count)], alarm().stroke_width(2)));
    chart.draw_series(falls).map_err(said)?;
    Ok(())
}

/// Colors on a light and on a dark background.
type Pair = [u32; 2];

const GROUND: Pair = [0xFFFFFF, 0x0D1117];
const INK: Pair = [0x24292F, 0xE6EDF3];
const GRID: Pair = [0xD8DEE4, 0x30363D];
const ALARM: Pair = [0xCF222E, 0xFF7B72];
/// Told apart by most who do not see all colours; a tenth leg does not exist.
const LEGS: [Pair; 9] = [
    [0xC2570C, 0xFF9E57],
    [0x0B6BAB, 0x58B5F0],
    [0x0A7F5A, 0x3DD6A3],
    [0xA0307A, 0xEE8FCB],
    [0x8A6A00, 0xE5C54B],
    [0x5350A8, 0xABA8FF],
    [0x7A4A3A, 0xDBA791],
    [0x48720D, 0xA9DB5A],
    [0x57606A, 0xB7BFC8],
];

fn light([light, _]: Pair) -> RGBColor {
    let [_, red, green, blue] = light.to_be_bytes();
    RGBColor(red, green, blue)
}

/// Returns the color of the background.
fn ground() -> RGBColor {
    light(GROUND)
}

/// Returns the color of texts and axes.
fn ink() -> RGBColor {
    light(INK)
}

/// Returns the color of lines that only guide the eye.
fn grid() -> RGBColor {
    light(GRID)
}

/// Returns the color of falls.
fn alarm() -> RGBColor {
    light(ALARM)
}

/// Returns the color of a leg, from 0.
fn leg(number: usize) -> RGBColor {
    LEGS.get(number).copied().map_or(ink(), light)
}

/// Returns the drawing with a name for those who hear it, and other colours where the reader's
/// ground is dark.
fn themed(svg: &str, name: &str) -> String {
    let rule = |[light, dark]: Pair| {
        format!(
            "[fill=\"#{light:06X}\"]{{fill:#{dark:06X}}}[stroke=\"#{light:06X}\"]{{stroke:#{dark:06X}}}"
        )
    };
    let pairs = [GROUND, INK, GRID, ALARM].into_iter().chain(LEGS);
    let rules: String = pairs.map(rule).collect();
    let name = permitted(name).replace('&', "&amp;").replace('<', "&lt;");
    let head = format!(
        "<title>{name}</title>\n<style>@media (prefers-color-scheme: dark){{{rules}}}</style>\n"
    );
    match svg.split_once(">\n") {
        Some((element, rest)) => format!("{element}>\n{head}{rest}"),
        None => svg.to_owned(),
    }
}
