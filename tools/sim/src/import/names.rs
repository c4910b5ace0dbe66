//! Names of links and joints: lists of them, the words in them, and names of legs that contradict their places.

use super::transform::{Forward, Transform, cross, dot};
use super::xml::printed;
use crate::message::Importing;
use tipc::message::list::List;

/// Share of the greatest distance between first joints below which a side is undecided.
const NEAR: f64 = 0.01;

/// Returns printable names, each once, if there are any. Equal names have to be neighbours.
pub(super) fn listed<'a>(names: impl Iterator<Item = &'a String>) -> Option<List> {
    let mut names: Vec<String> = names.map(|name| printed(name)).collect();
    names.dedup();
    (!names.is_empty()).then_some(List(names))
}

/// Returns the words of a name in lower case, whatever separates them: `FL_footSite1` has `fl`, `foot`
/// and `site`.
pub(super) fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut was_lower = false;
    for letter in name.chars() {
        let starts = letter.is_uppercase() && was_lower;
        if starts || !letter.is_alphabetic() {
            words.push(String::new());
        }
        if letter.is_alphabetic()
            && let Some(word) = words.last_mut()
        {
            word.extend(letter.to_lowercase());
        }
        was_lower = letter.is_lowercase();
    }
    words.retain(|word| !word.is_empty());
    words
}

/// The sides that a name states: true for front and left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Sides {
    front: Option<bool>,
    left: Option<bool>,
}

impl Sides {
    fn of(name: &str) -> Self {
        let mut sides = Sides::default();
        for word in words(name) {
            let (front, left) = match word.as_str() {
                "front" | "fore" => (Some(true), None),
                "rear" | "back" | "hind" => (Some(false), None),
                "left" | "l" => (None, Some(true)),
                "right" | "r" => (None, Some(false)),
                "fl" | "lf" => (Some(true), Some(true)),
                "fr" | "rf" => (Some(true), Some(false)),
                "rl" | "lr" | "hl" | "lh" | "bl" | "lb" => (Some(false), Some(true)),
                "rr" | "hr" | "rh" | "br" | "rb" => (Some(false), Some(false)),
                "ml" | "lm" => (None, Some(true)),
                "mr" | "rm" => (None, Some(false)),
                _ => (None, None),
            };
            sides.front = sides.front.or(front);
            sides.left = sides.left.or(left);
        }
        sides
    }
}

/// Returns a remark if the names of legs state other sides than the places of their first joints; with
/// the axis of the file that is forward by the names, if there is one. `root` is the pose of the file's
/// root link.
pub(super) fn contradiction(legs: &[(&str, [f64; 3])], root: &Transform) -> Option<Importing> {
    let hips = legs.iter().map(|(name, at)| (Sides::of(name), *at));
    let hips: Vec<(Sides, [f64; 3])> = hips.collect();
    let count = hips.len().max(1) as f64;
    let middle = [0, 1, 2].map(|axis| hips.iter().map(|(_, at)| at[axis]).sum::<f64>() / count);
    let away: Vec<(Sides, [f64; 3])> = hips
        .iter()
        .map(|(sides, at)| (*sides, [0, 1, 2].map(|axis| at[axis] - middle[axis])))
        .collect();
    let far = |(_, at): &(Sides, [f64; 3])| dot(*at, *at).sqrt();
    let near = NEAR * away.iter().map(far).fold(0.0, f64::max);
    let up = [0.0, 0.0, 1.0];
    // With which legs a direction of forward agrees.
    let contradicts = |forward: [f64; 3], (sides, at): &(Sides, [f64; 3])| {
        let is_against = |stated: Option<bool>, along: f64| match stated {
            Some(true) => along < -near,
            Some(false) => along > near,
            None => false,
        };
        is_against(sides.front, dot(*at, forward))
            || is_against(sides.left, dot(*at, cross(up, forward)))
    };
    let agrees = |forward: &[f64; 3]| away.iter().all(|leg| !contradicts(*forward, leg));
    const AHEAD: [f64; 3] = [0.0, 1.0, 0.0];
    if agrees(&AHEAD) {
        return None;
    }
    let pairs = legs.iter().zip(&away);
    let joints = pairs.filter(|(_, away)| contradicts(AHEAD, away));
    let joints = List(joints.map(|((name, _), _)| printed(name)).collect());
    let others = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]];
    Some(match others.into_iter().find(agrees) {
        Some(forward) => Importing::NamesTurned {
            joints,
            forward: Forward::nearest(root.inward(forward)).name(),
        },
        None => Importing::NamesContradict { joints },
    })
}
