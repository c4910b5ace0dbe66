//! Drawings of the robot from above and from the side.

use super::app::App;
use crate::message::DebugText;
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Color;
use ratatui::symbols::Marker;
use ratatui::widgets::canvas::{Canvas, Circle, Line};
use ratatui::widgets::{Block, Borders};
use tip_runtime::model::Point;
use tip_runtime::plant::{ObjectState, Shape};
use tip_sim::message::Debugging;
use tip_view::robot_frame;

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Margin around a walking robot, mm.
const MARGIN: f64 = 80.0;

/// Margin around a hand, mm.
const HAND_MARGIN: f64 = 30.0;

/// Step in which views of hands move and all views grow, mm.
const STEP: f64 = 50.0;

/// Radius of a foot, mm.
const DOT: f64 = 14.0;

/// Number of corners of a disc.
const CORNERS: u16 = 24;

/// A projection: the axes to the right and up.
#[derive(Clone, Copy)]
struct View {
    right: usize,
    up: usize,
    is_from_side: bool,
}

impl View {
    const fn from_above(right: usize, up: usize) -> Self {
        View {
            right,
            up,
            is_from_side: false,
        }
    }

    const fn from_side(right: usize, up: usize) -> Self {
        View {
            right,
            up,
            is_from_side: true,
        }
    }
}

/// The drawn points in the world frame, mm.
struct Figure {
    legs: Vec<Vec<Point>>,
    /// The corners of each object.
    objects: Vec<Vec<Point>>,
    /// Height of the floor under the middle; the floor under a hand moves.
    floor: Option<f64>,
    is_planar: bool,
    /// Centre of the view.
    centre: Point,
}

/// Returns a pane with a title and a rule above it.
pub(super) fn block(title: String) -> Block<'static> {
    Block::new().borders(Borders::TOP).title(title)
}

/// Draws both views.
pub(super) fn draw_robot(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let [above, side] =
        Layout::horizontal([Constraint::Percentage(50), Constraint::Percentage(50)])
            .spacing(1)
            .areas(area);
    let figure = Figure::of(app);
    let (from_above, from_side) = match app.skeleton.is_planar {
        // A hand's fingers move in a plane whose height is y.
        true => (View::from_above(0, 2), View::from_side(0, 1)),
        false => (View::from_above(0, 1), View::from_side(1, 2)),
    };
    let title = |name: String, view: View| {
        let (right, up) = (AXES[view.right], AXES[view.up]);
        format!("{name} {right}→ {up}↑")
    };
    figure.draw(
        frame,
        above,
        from_above,
        title(app.say(Debugging::Above), from_above),
    );
    figure.draw(
        frame,
        side,
        from_side,
        title(app.say(DebugText::Side), from_side),
    );
}

impl Figure {
    fn of(app: &App) -> Self {
        let run = app.debugger.run();
        let place = run.motion().map(|motion| robot_frame(&motion.pose));
        let in_world = |point: Point| place.as_ref().map_or(point, |frame| frame.point(point));
        let joints = app
            .skeleton
            .legs
            .first()
            .map_or(1, |leg| leg.joints.len().max(1));
        let legs = run
            .angles()
            .chunks(joints)
            .enumerate()
            .map(|(leg, angles)| {
                let points = app.skeleton.points(leg, angles);
                points.into_iter().map(in_world).collect()
            });
        let legs: Vec<Vec<Point>> = legs.collect();
        let is_planar = app.skeleton.is_planar;
        let grasp = run.grasp();
        let floor = match (is_planar, &grasp) {
            (true, None) => None,
            (true, Some(grasp)) => Some(grasp.slider[1] + app.scene.floor.height),
            (false, _) => Some(app.scene.floor.height),
        };
        let states = grasp.map_or(Vec::new(), |grasp| grasp.objects);
        let objects = app.scene.objects.iter().flatten().zip(&states);
        Figure {
            objects: objects
                .map(|(object, state)| outline(&object.shape, state))
                .collect(),
            centre: match is_planar {
                true => middle(&legs),
                false => in_world([0.0; 3]),
            },
            legs,
            floor,
            is_planar,
        }
    }

    /// Returns the position of a point on the way around the body, from 0 to 4.
    fn around(&self, point: &Point) -> f64 {
        let (x, y) = (point[0] - self.centre[0], point[1] - self.centre[1]);
        let right = x / (x.abs() + y.abs()).max(f64::MIN_POSITIVE);
        if y < 0.0 { 3.0 + right } else { 1.0 - right }
    }

    /// Returns half of the visible width, mm; it grows in steps, so that the view does not jitter.
    fn reach(&self, view: View) -> f64 {
        let far = |point: &Point| {
            let away = |axis: usize| (point[axis] - self.centre[axis]).abs();
            away(view.right).max(away(view.up))
        };
        let points = self.legs.iter().chain(&self.objects).flatten();
        let margin = if self.is_planar { HAND_MARGIN } else { MARGIN };
        let most = points.map(far).fold(100.0, f64::max) + margin;
        (most / STEP).ceil() * STEP
    }

    fn draw(&self, frame: &mut Frame<'_>, area: Rect, view: View, title: String) {
        let reach = self.reach(view);
        // Each cell has two columns and four rows of dots, all at the same distance.
        let inner = area.height.saturating_sub(1).max(1);
        let (across, high) = (2.0 * f64::from(area.width.max(1)), 4.0 * f64::from(inner));
        let (half_x, half_y) = match across > high {
            true => (reach * across / high, reach),
            false => (reach, reach * high / across),
        };
        let (x, y) = (self.centre[view.right], self.centre[view.up]);
        let canvas = Canvas::default()
            .block(block(title))
            .marker(Marker::Braille)
            .x_bounds([x - half_x, x + half_x])
            .y_bounds([y - half_y, y + half_y])
            .paint(|context| {
                let line = |from: &Point, to: &Point, color| Line {
                    x1: from[view.right],
                    y1: from[view.up],
                    x2: to[view.right],
                    y2: to[view.up],
                    color,
                };
                if let Some(floor) = self.floor.filter(|_| view.is_from_side) {
                    context.draw(&Line {
                        x1: x - half_x,
                        y1: floor,
                        x2: x + half_x,
                        y2: floor,
                        color: Color::DarkGray,
                    });
                }
                let mut bases: Vec<&Point> =
                    self.legs.iter().filter_map(|leg| leg.first()).collect();
                bases.sort_by(|one, other| self.around(one).total_cmp(&self.around(other)));
                for (base, next) in bases.iter().zip(bases.iter().cycle().skip(1)) {
                    context.draw(&line(base, next, Color::Gray));
                }
                for leg in &self.legs {
                    for (from, to) in leg.iter().zip(leg.iter().skip(1)) {
                        context.draw(&line(from, to, Color::Cyan));
                    }
                    if let Some(foot) = leg.last() {
                        context.draw(&dot(foot, view, Color::Yellow));
                    }
                }
                for object in &self.objects {
                    for (from, to) in object.iter().zip(object.iter().cycle().skip(1)) {
                        context.draw(&line(from, to, Color::Green));
                    }
                }
            });
        frame.render_widget(canvas, area);
    }
}

/// Returns the middle of the fingers, mm; it moves in steps, so that the view is steady.
fn middle(legs: &[Vec<Point>]) -> Point {
    std::array::from_fn(|axis| {
        let along = || legs.iter().flatten().map(|point| point[axis]);
        let (low, high) = (
            along().fold(f64::MAX, f64::min),
            along().fold(f64::MIN, f64::max),
        );
        ((low + high) / 2.0 / STEP).round() * STEP
    })
}

/// Returns the corners of an object in its plane, mm.
fn outline(shape: &Shape, state: &ObjectState) -> Vec<Point> {
    let corners: Vec<[f64; 2]> = match *shape {
        Shape::Disc { radius } => (0..CORNERS)
            .map(|corner| {
                let turn = 360.0 * f64::from(corner) / f64::from(CORNERS);
                let (sin, cos) = turn.to_radians().sin_cos();
                [radius * cos, radius * sin]
            })
            .collect(),
        Shape::Box { width, height } => {
            let (x, y) = (width / 2.0, height / 2.0);
            vec![[-x, -y], [x, -y], [x, y], [-x, y]]
        }
    };
    let (sin, cos) = state.angle.to_radians().sin_cos();
    let [x, y, z] = state.position;
    let placed =
        |[along, up]: [f64; 2]| [x + along * cos - up * sin, y + along * sin + up * cos, z];
    corners.into_iter().map(placed).collect()
}

fn dot(point: &Point, view: View, color: Color) -> Circle {
    Circle {
        x: point[view.right],
        y: point[view.up],
        radius: DOT,
        color,
    }
}
