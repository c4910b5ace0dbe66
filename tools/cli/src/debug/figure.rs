//! The robot from above and from the side.

use super::app::App;
use super::panes::block;
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Color;
use ratatui::symbols::Marker;
use ratatui::widgets::canvas::{Canvas, Circle, Line};
use tip_runtime::model::Point;
use tip_view::robot_frame;
use tipc::message::Debugging;

/// Around the robot: mm.
const MARGIN: f64 = 80.0;

/// How far the view of a hand moves at once: mm.
const STEP: f64 = 50.0;

/// How a foot or the centre of an object is drawn: mm.
const DOT: f64 = 14.0;

/// A plane to look at: which axes go to the right and up.
#[derive(Clone, Copy)]
struct View {
    right: usize,
    up: usize,
}

/// Everything that is drawn: mm, in the world.
struct Figure {
    legs: Vec<Vec<Point>>,
    objects: Vec<Point>,
    /// Where the view is centred.
    centre: Point,
}

/// Both views.
pub(super) fn robot(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let [above, side] =
        Layout::horizontal([Constraint::Percentage(50), Constraint::Percentage(50)])
            .spacing(1)
            .areas(area);
    let figure = Figure::of(app);
    let (from_above, from_side) = match app.skeleton.is_planar {
        // A hand's fingers move in a plane whose height is y.
        true => (View { right: 0, up: 2 }, View { right: 0, up: 1 }),
        false => (View { right: 0, up: 1 }, View { right: 1, up: 2 }),
    };
    figure.draw(frame, above, from_above, app.say(Debugging::Above));
    figure.draw(frame, side, from_side, app.say(Debugging::Side));
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
        let objects = run.grasp().map_or(Vec::new(), |grasp| grasp.objects);
        let legs: Vec<Vec<Point>> = legs.collect();
        let centre = match app.skeleton.is_planar {
            true => middle(&legs),
            false => in_world([0.0; 3]),
        };
        Figure {
            legs,
            objects: objects.iter().map(|object| object.position).collect(),
            centre,
        }
    }

    /// Where a point is on the way around the body, from 0 to 4.
    fn around(&self, point: &Point) -> f64 {
        let (x, y) = (point[0] - self.centre[0], point[1] - self.centre[1]);
        let right = x / (x.abs() + y.abs()).max(f64::MIN_POSITIVE);
        if y < 0.0 { 3.0 + right } else { 1.0 - right }
    }

    /// Half of what has to be seen, so that it does not jump about: mm.
    fn reach(&self, view: View) -> f64 {
        let far = |point: &Point| {
            let away = |axis: usize| (point[axis] - self.centre[axis]).abs();
            away(view.right).max(away(view.up))
        };
        let points = self.legs.iter().flatten().chain(&self.objects);
        let most = points.map(far).fold(100.0, f64::max) + MARGIN;
        (most / 100.0).ceil() * 100.0
    }

    fn draw(&self, frame: &mut Frame<'_>, area: Rect, view: View, title: String) {
        let reach = self.reach(view);
        // Each cell has two dots beside each other and four above each other, all at one distance.
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
                if view.up == 2 && view.right == 1 {
                    context.draw(&Line {
                        x1: x - half_x,
                        y1: 0.0,
                        x2: x + half_x,
                        y2: 0.0,
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
                    context.draw(&dot(object, view, Color::Green));
                }
            });
        frame.render_widget(canvas, area);
    }
}

/// The middle of what fingers take up, in steps, so that the view seldom moves: mm.
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

fn dot(point: &Point, view: View, color: Color) -> Circle {
    Circle {
        x: point[view.right],
        y: point[view.up],
        radius: DOT,
        color,
    }
}
