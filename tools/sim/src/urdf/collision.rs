//! What links collide with, as shapes of a description.

use super::chain::Chain;
use super::frame;
use super::pose::Pose;
use super::robot::{Geometry, Link, Origin, Piece};
use super::values::printed;
use crate::message::Importing;
use tip_runtime::model::{Point, Range};
use tipc::description::{Form, Shape};
use tipc::message::list::List;

/// Sizes that descriptions have, and how far away anything may be: mm.
const LEAST: f64 = frame::LEAST;
const MOST: f64 = 1e6;

/// The shapes of links that move as one, seen from `at` (mm), in a frame that is parallel to the robot frame.
pub(super) fn shapes(links: &[(&Link, Pose)], at: Point) -> Vec<Shape> {
    let all = all(links, at).map(|(_, shape)| shape);
    all.filter(is_possible).collect()
}

/// What is not kept of the legs and of the base, a line for each kind.
pub(super) fn dropped(
    legs: &[Chain<'_>],
    base: &[(&Link, Pose)],
    has_body: bool,
) -> Vec<Importing> {
    const HERE: Point = [0.0; 3];
    let joints = legs.iter().flat_map(|leg| &leg.joints);
    let mut rigid: Vec<(&[(&Link, Pose)], Point)> = Vec::new();
    if has_body {
        rigid.push((base, HERE));
    }
    rigid.extend(joints.map(|turning| (turning.links.as_slice(), turning.at)));
    let is_mesh = |piece: &Piece| piece.geometry == Geometry::Mesh;
    let links = rigid.iter().flat_map(|(links, _)| *links);
    let meshes = links.filter(|(link, _)| link.collisions.iter().any(is_mesh));
    let shapes = rigid.iter().flat_map(|(links, at)| all(links, *at));
    let impossible = shapes.filter(|(_, shape)| !is_possible(shape));
    let of_base = !has_body && !self::shapes(base, HERE).is_empty();
    [
        some(meshes.map(|(link, _)| *link)).map(|links| Importing::Meshes { links }),
        some(impossible.map(|(link, _)| link)).map(|links| Importing::NoSize { links }),
        of_base.then_some(Importing::BaseShapes),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The names of links, each once, if there are any.
fn some<'a>(links: impl Iterator<Item = &'a Link>) -> Option<List> {
    let mut names: Vec<String> = links.map(|link| printed(&link.name)).collect();
    names.dedup();
    (!names.is_empty()).then_some(List(names))
}

/// The box around shapes, of which one at least has to be a block: a body is hardly made of others alone.
pub(super) fn extents(shapes: &[Shape]) -> Option<[Range; 3]> {
    let is_block = |shape: &Shape| matches!(shape.form, Form::Block(_));
    shapes.iter().any(is_block).then(|| {
        [0, 1, 2].map(|axis| {
            let ends = shapes
                .iter()
                .map(|shape| (shape.at[axis], half(shape, axis)));
            ends.fold(
                Range::new(f64::INFINITY, f64::NEG_INFINITY),
                |range, (at, half)| Range::new(range.min.min(at - half), range.max.max(at + half)),
            )
        })
    })
}

/// How far a shape reaches from its middle along an axis of the robot frame: mm.
fn half(shape: &Shape, axis: usize) -> f64 {
    let [x, y, z] = shape.axes.map(|own| own[axis].abs());
    match shape.form {
        Form::Block([a, b, c]) => (a * x + b * y + c * z) / 2.0,
        // The rim of its end, seen from the side.
        Form::Cylinder { radius, length } => length * z / 2.0 + radius * (x * x + y * y).sqrt(),
        Form::Sphere { radius } => radius,
    }
}

/// Each link's shapes, also those that no description can have.
fn all<'a>(links: &[(&'a Link, Pose)], at: Point) -> impl Iterator<Item = (&'a Link, Shape)> {
    let pieces = links.iter().flat_map(|(link, pose)| {
        let pieces = link.collisions.iter();
        pieces.map(|piece| (*link, pose.then(&piece.origin), piece))
    });
    pieces.flat_map(move |(link, pose, piece)| {
        let parts = parts(&piece.geometry).into_iter();
        parts.map(move |(form, up)| (link, placed(form, &pose, up, at)))
    })
}

/// Lengths in mm.
fn is_possible(shape: &Shape) -> bool {
    let sizes = match shape.form {
        Form::Block(sides) => sides.to_vec(),
        Form::Cylinder { radius, length } => vec![radius, length],
        Form::Sphere { radius } => vec![radius],
    };
    let is_size = |size: &f64| (LEAST..=MOST).contains(size);
    let is_near = |part: &f64| (-MOST..=MOST).contains(part);
    sizes.iter().all(is_size) && shape.at.iter().all(is_near)
}

/// The forms that a part is made of, each with its place on the part's z: m. A block has x to the right, as the robot frame has.
fn parts(geometry: &Geometry) -> Vec<(Form, f64)> {
    let mm = |metres: &f64| metres * 1000.0;
    let cylinder = |radius, length| Form::Cylinder {
        radius: mm(radius),
        length: mm(length),
    };
    let sphere = |radius| Form::Sphere { radius: mm(radius) };
    match geometry {
        Geometry::Box([x, y, z]) => vec![(Form::Block([y, x, z].map(mm)), 0.0)],
        Geometry::Cylinder { radius, length } => vec![(cylinder(radius, length), 0.0)],
        Geometry::Capsule { radius, length } => vec![
            (cylinder(radius, length), 0.0),
            (sphere(radius), length / 2.0),
            (sphere(radius), -length / 2.0),
        ],
        Geometry::Sphere { radius } => vec![(sphere(radius), 0.0)],
        Geometry::Mesh => Vec::new(),
    }
}

/// A form in a frame of URDF, so far up its z (m).
fn placed(form: Form, pose: &Pose, up: f64, from: Point) -> Shape {
    let place = Origin {
        xyz: [0.0, 0.0, up],
        ..Origin::default()
    };
    let at = pose.then(&place).origin();
    Shape {
        form,
        at: [0, 1, 2].map(|axis| at[axis] - from[axis]),
        // To the right is what is not to the left, forward is x.
        axes: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(|own| pose.direction(own)),
    }
}
