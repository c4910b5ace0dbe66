//! Legs: their bases and their joints, which are described once and turned or mirrored for each leg. Joints and the
//! body have inertial properties, and shapes that only exported files use.

use super::Leg;
use super::keys::Part;
use super::section::{Found, SMALLEST, Section, Sign, fault};
use crate::message::{Describing, Letter};
use crate::source::Span;
use tip_runtime::command::MAX;
use tip_runtime::model::{InertialProperties, Joint, Point, Range};

/// Default distance from the working limits to those of the potentiometers, deg.
const POTENTIOMETER_MARGIN: f64 = 5.0;

/// A joint as the file describes it, before it is turned or mirrored, and the shapes of the link after it.
struct Drawn {
    joint: Joint,
    shapes: Vec<Shape>,
}

/// Reads every leg of the robot, F1 first; `None` after a fault that leaves none.
pub(super) fn read(robot: Section<'_>, found: &mut Found) -> Option<Vec<Leg>> {
    let common = joints(robot, found);
    let sections = robot.tables("leg", Part::Leg, found)?;
    if !(1..=MAX).contains(&sections.len()) {
        let reason = Describing::NumberOfLegs {
            most: MAX,
            found: sections.len(),
        };
        return robot.refuse("leg", robot.location_of("leg"), reason, found);
    }
    let initial = robot
        .list("initial", Sign::Any, found)
        .map(|(_, initial)| initial);
    let mut legs = Vec::new();
    for (number, section) in (1..).zip(&sections) {
        let own = joints(*section, found);
        let drawn = own.as_deref().or(common.as_deref());
        // Refused joints are reported already.
        if drawn.is_none() && !robot.has("joint") && !section.has("joint") {
            let reason = Describing::NoJoints { leg: number };
            let help = Describing::DescribeJoints;
            found.push(fault(section.part, section.location, reason, help));
        }
        let leg = leg(*section, drawn, initial.as_deref(), found);
        if leg.as_ref().is_some_and(Leg::is_point) {
            let reason = Describing::NoLength { leg: number };
            let help = Describing::OneLinkNotZero;
            found.push(fault(section.part, section.location, reason, help));
        }
        legs.extend(leg);
    }
    let whole = legs.len() == sections.len();
    (whole && same_size(&sections, &legs, found)).then_some(legs)
}

/// Returns true if each leg has as many joints as the first one.
fn same_size(sections: &[Section<'_>], legs: &[Leg], found: &mut Found) -> bool {
    let first = legs.first().map_or(0, |leg| leg.joints.len());
    let mut same = true;
    for (number, (section, leg)) in (1..).zip(sections.iter().zip(legs)) {
        let count = leg.joints.len();
        if count != first {
            let reason = Describing::OtherNumberOfJoints {
                leg: number,
                joints: count.into(),
                first,
            };
            let help = Describing::SameNumberOfJoints;
            found.push(fault(section.part, section.location, reason, help));
            same = false;
        }
    }
    same
}

/// Reads the `joint` tables of a leg, or of all legs; `None` if there are none, or none that can be used.
fn joints(section: Section<'_>, found: &mut Found) -> Option<Vec<Drawn>> {
    let sections = section.tables("joint", Part::Joint, found)?;
    if !(1..=MAX).contains(&sections.len()) {
        let reason = Describing::NumberOfJoints {
            most: MAX,
            found: sections.len(),
        };
        return section.refuse("joint", section.location_of("joint"), reason, found);
    }
    let joints: Vec<Option<Drawn>> = sections.iter().map(|own| joint(*own, found)).collect();
    joints.into_iter().collect()
}

fn joint(section: Section<'_>, found: &mut Found) -> Option<Drawn> {
    let axis = axis(section, found);
    let link = section.numbers("link", Sign::Any, found);
    let limits = section.range("limits", Sign::Any, found);
    let limits = limits.unwrap_or(Range::new(-180.0, 180.0));
    let outer = section.range("outer", Sign::Any, found);
    let outer = outer.unwrap_or(limits.widened(POTENTIOMETER_MARGIN));
    if !(outer.min <= limits.min && limits.max <= outer.max) {
        let reason = Describing::OuterContainsLimits {
            min: limits.min,
            max: limits.max,
        };
        section.refuse::<()>("outer", section.location_of("outer"), reason, found);
    }
    let mass = section.number("mass", Sign::NotNegative, found);
    let mass = mass.unwrap_or(0.1);
    let even = InertialProperties::rod(link.unwrap_or_default(), mass);
    let inertial = read_inertial(section, even, found);
    let torque = section.number("torque", Sign::Positive, found);
    let shapes = read_shapes(section, found);
    let radius = section.number("radius", Sign::Size, found);
    let joint = Joint {
        axis: axis?,
        link: link?,
        limits,
        outer,
        mass,
        inertial,
        torque: torque.unwrap_or(10.0),
        radius: radius.or_else(|| radius_of(&shapes, link?)),
    };
    Some(Drawn { joint, shapes })
}

/// Cosine of the greatest angle between a link and a shape along it: 30 deg.
const ALONG: f64 = 0.866_025_403_784_438_6;

/// Returns the radius of the longest shape along a link, mm. For a block, that is half of its smaller side across the
/// link.
fn radius_of(shapes: &[Shape], link: [f64; 3]) -> Option<f64> {
    let length = libm::sqrt(link.iter().map(|part| part * part).sum());
    let rods = shapes.iter().filter_map(|shape| {
        let (axis, long, radius) = match shape.form {
            Form::Cylinder { radius, length } => (2, length, radius),
            Form::Block(sides) => {
                let axis = (0..3).max_by(|a, b| sides[*a].total_cmp(&sides[*b]))?;
                let across = (0..3).filter(|other| *other != axis);
                let least = across.fold(f64::INFINITY, |least, other| least.min(sides[other]));
                (axis, sides[axis], least / 2.0)
            }
            Form::Sphere { .. } => return None,
        };
        let along: f64 = shape.axes[axis].iter().zip(link).map(|(a, b)| a * b).sum();
        (libm::fabs(along) >= ALONG * length && length > 0.0).then_some((long, radius))
    });
    let longest = rods.max_by(|(one, _), (other, _)| one.total_cmp(other));
    longest.map(|(_, radius)| radius)
}

/// Reads a unit vector: `"z"`, `"-y"` or any direction.
fn axis(section: Section<'_>, found: &mut Found) -> Option<[f64; 3]> {
    if section.is_text("axis") {
        let words = [
            ("x", [1.0, 0.0, 0.0]),
            ("y", [0.0, 1.0, 0.0]),
            ("z", [0.0, 0.0, 1.0]),
            ("-x", [-1.0, 0.0, 0.0]),
            ("-y", [0.0, -1.0, 0.0]),
            ("-z", [0.0, 0.0, -1.0]),
        ];
        return section.choice("axis", &words, found);
    }
    let axis: [f64; 3] = section.numbers("axis", Sign::Any, found)?;
    let length = axis.iter().map(|part| part * part).sum::<f64>().sqrt();
    if length < 1e-6 {
        let reason = Describing::NoDirection;
        return section.refuse("axis", section.location_of("axis"), reason, found);
    }
    Some(axis.map(|part| part / length))
}

impl Leg {
    /// Returns true if all links have length 0, so that the foot is always at the base.
    fn is_point(&self) -> bool {
        self.joints.iter().all(|joint| {
            let squares = joint.link.map(|part| part * part);
            squares.iter().sum::<f64>().sqrt() < SMALLEST
        })
    }
}

/// Creates a leg with the joints of `drawn`, turned and mirrored as the leg's table demands.
fn leg(
    section: Section<'_>,
    drawn: Option<&[Drawn]>,
    common: Option<&[f64]>,
    found: &mut Found,
) -> Option<Leg> {
    let base = section.numbers("base", Sign::Any, found);
    let turn = section.number("turn", Sign::Any, found).unwrap_or(0.0);
    let mirror = mirror(section, found).unwrap_or([1.0; 3]);
    let own = section.list("initial", Sign::Any, found);
    let drawn = drawn?;
    let initial = initial(section, drawn, own, common, found);
    let placed = drawn.iter().map(|drawn| placed(drawn, turn, mirror));
    let (joints, shapes) = placed.unzip();
    Some(Leg {
        base: base?,
        joints,
        initial: initial?,
        shapes,
    })
}

/// Turns a joint and its shapes about z, then mirrors them.
fn placed(drawn: &Drawn, turn: f64, mirror: [f64; 3]) -> (Joint, Vec<Shape>) {
    let Drawn { joint, shapes } = drawn;
    let [sin, cos] = sin_cos(turn);
    let turned = |[x, y, z]: [f64; 3]| [cos * x - sin * y, sin * x + cos * y, z];
    let (axis, link) = (turned(joint.axis), turned(joint.link));
    // An axis is a pseudovector: a mirror also reverses it.
    let side: f64 = mirror.iter().product();
    let shapes = shapes.iter().map(|shape| shape.placed(turned, mirror));
    let joint = Joint {
        axis: [0, 1, 2].map(|i| side * mirror[i] * axis[i]),
        link: [0, 1, 2].map(|i| mirror[i] * link[i]),
        inertial: joint
            .inertial
            .map(|of| placed_inertial(&of, turned, mirror)),
        ..*joint
    };
    (joint, shapes.collect())
}

/// Reads the sign that a mirror gives each coordinate.
fn mirror(section: Section<'_>, found: &mut Found) -> Option<[f64; 3]> {
    let (location, letters) = section.text("mirror", found)?;
    let mut signs = [1.0; 3];
    for letter in letters.chars() {
        let sign = "xyz".find(letter).and_then(|axis| signs.get_mut(axis));
        match sign {
            Some(sign) if *sign > 0.0 => *sign = -1.0,
            _ => {
                let reason = Describing::NoCoordinate {
                    letter: Letter(letter),
                };
                return section.refuse("mirror", location, reason, found);
            }
        }
    }
    Some(signs)
}

/// Reads the leg's own initial posture, that of all legs, or the middle of all limits.
fn initial(
    section: Section<'_>,
    joints: &[Drawn],
    own: Option<(Span, Vec<f64>)>,
    common: Option<&[f64]>,
    found: &mut Found,
) -> Option<Vec<f64>> {
    let location = own
        .as_ref()
        .map_or(section.location, |(location, _)| *location);
    let middle = |Drawn { joint, .. }: &Drawn| (joint.limits.min + joint.limits.max) / 2.0;
    let angles = match (own, common) {
        (Some((_, own)), _) => own,
        (None, Some(common)) => common.to_vec(),
        (None, None) => joints.iter().map(middle).collect(),
    };
    if angles.len() != joints.len() {
        let reason = Describing::OtherNumberOfAngles {
            angles: angles.len(),
            joints: joints.len().into(),
        };
        return section.refuse("initial", location, reason, found);
    }
    for (number, (angle, Drawn { joint, .. })) in (1..).zip(angles.iter().zip(joints)) {
        let Range { min, max } = joint.limits;
        if !joint.limits.contains(*angle) {
            let reason = Describing::InitialOutside {
                angle: *angle,
                joint: number,
                min,
                max,
            };
            return section.refuse("initial", location, reason, found);
        }
    }
    Some(angles)
}

/// The shapes of a description; empty for links and bodies without shapes.
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

/// A solid around the origin, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// A block with these sides along its own x, y and z.
    Block([f64; 3]),
    /// A cylinder along its own z.
    Cylinder {
        /// Radius, mm.
        radius: f64,
        /// Length, mm.
        length: f64,
    },
    /// A ball.
    Sphere {
        /// Radius, mm.
        radius: f64,
    },
}

/// Reads the key `shape` of a table.
pub(super) fn read_shapes(section: Section<'_>, found: &mut Found) -> Vec<Shape> {
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

/// Returns the axes of a shape after rotations about the fixed x, y and z axes, in this order, deg.
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
    fn placed(&self, turned: impl Fn([f64; 3]) -> [f64; 3], mirror: [f64; 3]) -> Shape {
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

/// Reads the keys `centre` and `inertia` of a table, with a default for the one that it leaves out; `None` if it has
/// neither.
pub(super) fn read_inertial(
    section: Section<'_>,
    even: InertialProperties,
    found: &mut Found,
) -> Option<InertialProperties> {
    let centre = section.numbers("centre", Sign::Any, found);
    let inertia = section.numbers("inertia", Sign::Any, found);
    if centre.is_none() && inertia.is_none() {
        return None;
    }
    let inertial = InertialProperties {
        centre: centre.unwrap_or(even.centre),
        inertia: inertia.unwrap_or(even.inertia),
    };
    if inertial.is_sound() {
        return Some(inertial);
    }
    let location = section.location_of("inertia");
    section.refuse("inertia", location, Describing::NoBodysInertia, found)
}

/// Returns the distribution for a link that is turned and mirrored: `turned` gives the turn of a direction, `mirror`
/// the sign of each coordinate.
fn placed_inertial(
    inertial: &InertialProperties,
    turned: impl Fn([f64; 3]) -> [f64; 3],
    mirror: [f64; 3],
) -> InertialProperties {
    let [xx, yy, zz, xy, xz, yz] = inertial.inertia;
    // The rows are turned first, then the columns of the result.
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(&turned);
    let column = |axis: usize| turned(rows.map(|row| row[axis]));
    let columns = [column(0), column(1), column(2)];
    let at = |i: usize, j: usize| mirror[i] * mirror[j] * columns[i][j];
    let centre = turned(inertial.centre);
    InertialProperties {
        centre: [0, 1, 2].map(|axis| mirror[axis] * centre[axis]),
        inertia: [at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(0, 2), at(1, 2)],
    }
}

/// Returns sine and cosine of an angle in degrees, exact at every quarter turn.
fn sin_cos(angle: f64) -> [f64; 2] {
    let quarters = (angle / 90.0).floor();
    let (sin, cos) = libm::sincos((angle - quarters * 90.0).to_radians());
    match quarters.rem_euclid(4.0) as u8 {
        0 => [sin, cos],
        1 => [cos, -sin],
        2 => [-sin, -cos],
        _ => [-cos, sin],
    }
}
