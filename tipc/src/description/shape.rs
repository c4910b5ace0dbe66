//! Shapes of links and bodies, for exported files. No plant of this project looks at them, and no `Model` holds them.

use super::keys::Part;
use super::rotation::sin_cos;
use super::section::{Found, Section, Sign, fault};
use crate::message::Describing;
use tip_runtime::model::Point;

/// The shapes that a description gives; what has none is empty.
///
/// ```
/// let text = br#"
/// name = "arm"
/// leg = [{ base = [0, 0, 0] }]
/// joint = [{ axis = "z", link = [0, 90, 0], shape = [{ sphere = 12, at = [0, 90, 0] }] }]
/// "#;
/// let description = tipc::description::parse("arm.toml", text).unwrap();
/// let shapes = description.shapes();
/// assert_eq!(shapes.of(1, 1)[0].at, [0.0, 90.0, 0.0]);
/// assert!(shapes.body.is_empty());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shapes {
    /// Shapes of the body, in the robot frame.
    pub body: Vec<Shape>,
    /// Shapes of the link after each joint of each leg, from the joint on.
    pub legs: Vec<Vec<Vec<Shape>>>,
}

impl Shapes {
    /// Returns the shapes of the link after a joint of a leg, both counted from 1 as the language has them.
    pub fn of(&self, leg: u8, joint: u8) -> &[Shape] {
        let [leg, joint] = [leg, joint].map(|number| usize::from(number).checked_sub(1));
        let links = leg.and_then(|leg| self.legs.get(leg));
        let of = links.zip(joint).and_then(|(links, joint)| links.get(joint));
        of.map_or(&[], Vec::as_slice)
    }
}

/// A part of what a link or a body looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Geometric form.
    pub form: Form,
    /// Its middle, from its joint or in the robot frame: mm.
    pub at: Point,
    /// The directions of its own axes x, y and z, as the robot frame sees them while all joints are at 0.
    pub axes: [Point; 3],
}

/// A body around the origin: mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// With these sides along its own x, y and z.
    Block([f64; 3]),
    /// Along its own z.
    Cylinder {
        /// From its axis to its wall.
        radius: f64,
        /// From end to end.
        length: f64,
    },
    /// A ball.
    Sphere {
        /// From its middle to its surface.
        radius: f64,
    },
}

/// Reads the key `shape` of a table.
pub(super) fn read(section: Section<'_>, found: &mut Found) -> Vec<Shape> {
    let sections = section.tables("shape", Part::Shape, found);
    let sections = sections.unwrap_or_default().into_iter();
    sections.filter_map(|own| shape(own, found)).collect()
}

fn shape(section: Section<'_>, found: &mut Found) -> Option<Shape> {
    let form = form(section, found);
    let at = section.numbers("at", Sign::Any, found);
    let turned = section.numbers("turned", Sign::Any, found);
    Some(Shape {
        form: form?,
        at: at.unwrap_or_default(),
        axes: axes(turned.unwrap_or_default()),
    })
}

/// Reads the form from the one key of three that is present.
fn form(section: Section<'_>, found: &mut Found) -> Option<Form> {
    let given = ["block", "cylinder", "sphere"].map(|key| section.has(key));
    match given {
        [true, false, false] => {
            let sides = section.numbers("block", Sign::Size, found)?;
            Some(Form::Block(sides))
        }
        [false, true, false] => {
            let [radius, length] = section.numbers("cylinder", Sign::Size, found)?;
            Some(Form::Cylinder { radius, length })
        }
        [false, false, true] => {
            let radius = section.number("sphere", Sign::Size, found)?;
            Some(Form::Sphere { radius })
        }
        _ => {
            let reason = match given.contains(&true) {
                true => Describing::SeveralForms,
                false => Describing::NoForm,
            };
            let help = Describing::Forms;
            found.push(fault(section.part, section.location, reason, help));
            None
        }
    }
}

/// Returns the axes of what is turned about the fixed x, y and z, one after the other: deg.
fn axes(turned: [f64; 3]) -> [Point; 3] {
    let [[sr, cr], [sp, cp], [sy, cy]] = turned.map(sin_cos);
    [
        [cy * cp, sy * cp, -sp],
        [cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr],
        [cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr],
    ]
}

impl Shape {
    /// Returns the shape on a link that is turned and mirrored: `turned` gives the turn of a direction, `mirror` the
    /// sign of each coordinate.
    pub(super) fn placed(&self, turned: impl Fn([f64; 3]) -> [f64; 3], mirror: [f64; 3]) -> Shape {
        let put = |of: Point| {
            let of = turned(of);
            [0, 1, 2].map(|i| mirror[i] * of[i])
        };
        let axis = |i: usize| put(self.axes[i]).map(|part| mirror[i] * part);
        Shape {
            form: self.form,
            at: put(self.at),
            // A mirror makes left-handed axes. Every form is its own mirror image, so that one of them may point the other way.
            axes: [axis(0), axis(1), axis(2)],
        }
    }
}
