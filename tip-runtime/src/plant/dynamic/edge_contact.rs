//! Contacts between the edges of the body and blocks, where neither has a corner inside.

use super::Vector;
use super::contact::Touch;
use super::spatial::MovingFrame;
use super::terrain::Terrain;
use crate::plant::cuboid::{Cuboid, middle};

/// Height of the first lift of a body over a block that is wholly under it, m.
const CLIMB: f64 = 1e4;

/// Calls `meet` for each place where an edge of the body passes through a block, or an edge of a
/// block through the body: the midpoint of the part inside, from the body's origin (m). Corners of
/// the body are handled elsewhere.
pub(super) fn for_each_edge_contact(
    extent: &Cuboid,
    frame: &MovingFrame,
    terrain: &Terrain,
    mut meet: impl FnMut(Vector, Touch),
) {
    let corners = extent.corners();
    let reach = corners.iter().map(Vector::norm).fold(0.0, f64::max);
    let near = Vector::repeat(reach);
    for block in terrain.blocks() {
        let around = Cuboid {
            low: block.low - near,
            high: block.high + near,
        };
        if around.depth(frame.position).is_none() {
            continue;
        }
        for edge in extent.edges() {
            let edge = edge.map(|corner| frame.point(corner));
            let place = block.through(edge).map(|part| middle(edge, part));
            if let Some((place, (depth, side))) =
                place.and_then(|place| Some((place, block.depth(place)?)))
            {
                meet(place - frame.position, terrain.touching(depth, side));
            }
        }
        let inverse = frame.rotation.inverse();
        for edge in block.edges() {
            let edge = edge.map(|corner| inverse * (corner - frame.position));
            let place = extent.inside(edge).map(|part| middle(edge, part));
            if let Some((place, (depth, side))) =
                place.and_then(|place| Some((place, extent.depth(place)?)))
            {
                let touch = terrain.touching(depth, frame.rotation * -side);
                meet(frame.rotation * place, touch);
            }
        }
    }
}

/// Returns the rise of the body that clears the top of every block, m.
pub(super) fn rise_over_blocks(extent: &Cuboid, frame: &MovingFrame, terrain: &Terrain) -> f64 {
    let edges = extent.edges();
    let edges = edges.map(|edge| terrain.rise(edge.map(|corner| frame.point(corner))));
    let rise = edges.into_iter().fold(0.0, f64::max);
    let inverse = frame.rotation.inverse();
    let tops = terrain.blocks().flat_map(|block| {
        let [_, _, _, _, tops @ ..] = block.corners();
        tops
    });
    // From deep below a top straight up to it: what is left of that where the body begins.
    let ups = tops.filter_map(|top| {
        let below = Vector::new(top.x, top.y, top.z - CLIMB);
        let [from, _] = extent.inside([below, top].map(|end| inverse * (end - frame.position)))?;
        Some(CLIMB * (1.0 - from))
    });
    ups.fold(rise, f64::max)
}
