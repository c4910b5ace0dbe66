//! Diagrams on a page, one below the other.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use tip_sim::urdf::frame::foot;
use tip_sim::urdf::xml::permitted;

/// From one value to another.
pub(super) type Span = (f64, f64);

/// A part of the page.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

type Failed<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

/// Result of drawing.
pub(super) type Drawn = Result<(), Box<dyn std::error::Error>>;

const WIDTH: u32 = 960;
const HEADING: u32 = 64;
const FONT: &str = "sans-serif";
const SMALL: i32 = 12;
const TITLE: i32 = 15;
const LARGE: i32 = 20;
/// Left of the axes, where the numbers are.
const LEFT: u32 = 64;

/// An empty page.
pub(super) struct Page<'a>(Area<'a>);

/// Draws diagrams of these heights on a page.
pub(super) fn svg(
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
    pub(super) fn split(
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
pub(super) fn padded(values: impl Iterator<Item = f64> + Clone) -> Span {
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
pub(super) fn lines(
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
pub(super) struct View {
    pub(super) title: String,
    /// Names of its axes.
    pub(super) names: [&'static str; 2],
    /// True if a unit is as long across as up.
    pub(super) is_true: bool,
    pub(super) legs: Vec<Vec<(f64, f64)>>,
}

/// Views side by side.
pub(super) fn planes(area: &Area<'_>, views: &[View]) -> Drawn {
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
pub(super) fn bars(
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
pub(super) fn ground() -> RGBColor {
    light(GROUND)
}

/// Returns the color of texts and axes.
pub(super) fn ink() -> RGBColor {
    light(INK)
}

/// Returns the color of lines that only guide the eye.
pub(super) fn grid() -> RGBColor {
    light(GRID)
}

/// Returns the color of falls.
pub(super) fn alarm() -> RGBColor {
    light(ALARM)
}

/// Returns the color of a leg, from 0.
pub(super) fn leg(number: usize) -> RGBColor {
    LEGS.get(number).copied().map_or(ink(), light)
}

/// Returns the drawing with a name for those who hear it, and other colours where the reader's
/// ground is dark.
pub(super) fn themed(svg: &str, name: &str) -> String {
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
