//! The bodies of an MJCF file as links and joints. A body with several joints becomes a link for each
//! of them; bodies of the world that carry no joint are scenery.

use super::super::ImportError;
use super::super::transform::Transform;
use super::super::tree::{Joint, JointLimit, JointType, Link, Piece, RobotFile, Tip, TipKind};
use super::super::xml::printed;
use super::elements::{Classes, Element, Files, Merged, Spot};
use super::geoms::{self, Geom, Shape};
use super::{Compiler, Ignored, SHAPE_CLASS, motors};
use crate::message::Importing;
use crate::urdf::frame::{self, BODY, WORLD};
use std::collections::BTreeMap;
use tip_runtime::command::MAX;
use tipc::message::list::List;

/// Maximum number of bodies, geometries, sites and joints, copies among them.
const MAX_PARTS: usize = 20_000;
/// Maximum number of copies of one element.
const MAX_COPIES: f64 = 1000.0;
/// Words of sites at feet and fingertips.
const FEET: [&str; 5] = ["foot", "feet", "toe", "tip", "fingertip"];
/// Elements of a body that neither move nor weigh anything.
const UNSEEN: [&str; 4] = ["camera", "light", "plugin", "user"];
/// Elements that make bodies which this reader does not know.
const MAKERS: [&str; 3] = ["attach", "composite", "flexcomp"];

/// The links and joints that have been read so far.
pub(super) struct Bodies<'a, 'c> {
    classes: &'c Classes<'a>,
    files: &'c Files,
    compiler: &'c Compiler,
    /// True for files of this project's export.
    is_exported: bool,
    /// The class of collision shapes in such files.
    shape_class: Option<usize>,
    /// Links with the index of the body of the world that carries them.
    links: Vec<(Link, usize)>,
    joints: Vec<(Joint, usize)>,
    names: BTreeMap<String, Spot>,
    joint_names: BTreeMap<String, Spot>,
    /// The torque that each joint takes, N·m.
    efforts: Vec<f64>,
    /// Names and numbers of values of all joints, in the order of `qpos`.
    pub(super) places: Vec<(String, usize)>,
    /// Names of elements that were ignored.
    pub(super) ignored: Ignored,
    /// Bodies of which a mesh without stated mass is a part.
    unweighed: Vec<String>,
    parts: usize,
    /// The body of the world that is read.
    top: usize,
}

/// The frame, class and names of elements inside a body.
#[derive(Clone, Copy)]
struct Scope<'s> {
    frame: Transform,
    class: usize,
    /// The suffix that `<replicate>` adds to names.
    suffix: &'s str,
}

/// The contents of a body.
#[derive(Default)]
struct Contents<'a> {
    joints: Vec<MovingJoint>,
    is_free: bool,
    inertial: Option<(f64, Transform, [f64; 6])>,
    geoms: Vec<Geom>,
    body_box: Vec<Piece>,
    tips: Vec<Tip>,
    children: Vec<Child<'a>>,
}

/// A body inside another one.
struct Child<'a> {
    element: &'a Element,
    frame: Transform,
    class: usize,
    suffix: String,
}

struct MovingJoint {
    name: String,
    kind: JointType,
    anchor: [f64; 3],
    axis: [f64; 3],
    /// The value in the pose of the file, rad or m.
    reference: f64,
    limit: [Option<f64>; 2],
    effort: f64,
}

impl<'a, 'c> Bodies<'a, 'c> {
    pub(super) fn new(
        classes: &'c Classes<'a>,
        files: &'c Files,
        compiler: &'c Compiler,
        is_exported: bool,
    ) -> Self {
        Bodies {
            classes,
            files,
            compiler,
            is_exported,
            shape_class: is_exported.then(|| classes.index(SHAPE_CLASS)).flatten(),
            links: vec![(link(WORLD), 0)],
            joints: Vec::new(),
            names: BTreeMap::new(),
            joint_names: BTreeMap::new(),
            efforts: Vec::new(),
            places: Vec::new(),
            ignored: Ignored::new(),
            unweighed: Vec::new(),
            parts: 0,
            top: 0,
        }
    }

    /// Reads all bodies of the world.
    pub(super) fn world(&mut self, root: &'a Element) -> Result<(), ImportError> {
        let worlds = root.children.iter().filter(|one| one.name == "worldbody");
        let mut contents = Contents::default();
        for world in worlds {
            let scope = Scope {
                frame: Transform::default(),
                class: self.class(world, "childclass", 0)?,
                suffix: "",
            };
            self.collect(world, scope, true, &mut contents)?;
        }
        for child in contents.children {
            self.top += 1;
            self.body(&child, 0)?;
        }
        Ok(())
    }

    fn class(&self, element: &'a Element, name: &str, scope: usize) -> Result<usize, ImportError> {
        self.classes
            .named(element.attribute(name), scope, self.files)
    }

    fn merged(&self, element: &'a Element, class: usize) -> Merged<'a, 'c> {
        Merged {
            element,
            class,
            classes: self.classes,
            files: self.files,
        }
    }

    fn count(&mut self, element: &Element) -> Result<(), ImportError> {
        self.parts += 1;
        match self.parts > MAX_PARTS {
            false => Ok(()),
            true => Err(ImportError::new(Importing::TooManyParts {
                at: self.files.place(element.at),
                most: MAX_PARTS,
            })),
        }
    }

    /// Collects what is in a body, through frames and copies. The depth is bounded by that of the file.
    fn collect(
        &mut self,
        element: &'a Element,
        scope: Scope<'_>,
        is_world: bool,
        into: &mut Contents<'a>,
    ) -> Result<(), ImportError> {
        for child in &element.children {
            self.count(child)?;
            match child.name.as_str() {
                "body" => into.children.push(Child {
                    element: child,
                    frame: scope.frame,
                    class: scope.class,
                    suffix: scope.suffix.to_owned(),
                }),
                "frame" => {
                    let class = self.class(child, "childclass", scope.class)?;
                    let pose = self.compiler.pose(&self.merged(child, class))?;
                    let frame = scope.frame.then(&pose);
                    let inner = Scope {
                        frame,
                        class,
                        ..scope
                    };
                    self.collect(child, inner, is_world, into)?;
                }
                "replicate" => self.replicate(child, scope, is_world, into)?,
                // Other elements of the world are not part of a robot.
                _ if is_world => {}
                "inertial" => {
                    let of = self.merged(child, scope.class);
                    let (mass, pose, tensor) = self.inertial(&of)?;
                    into.inertial = Some((mass, scope.frame.then(&pose), tensor));
                }
                "geom" => {
                    let class = self.class(child, "class", scope.class)?;
                    let of = self.merged(child, class);
                    let geom = Geom::read(&of, self.compiler, &scope.frame)?;
                    if child.value("name") == Some(BODY) && matches!(geom.shape, Shape::Box(_)) {
                        into.body_box.push(piece(&geom));
                    }
                    into.geoms.push(geom);
                }
                "site" => self.site(child, scope, into)?,
                "freejoint" => self.free(child, scope, into)?,
                "joint" => {
                    let class = self.class(child, "class", scope.class)?;
                    let of = self.merged(child, class);
                    const TYPES: [&str; 4] = ["hinge", "slide", "ball", "free"];
                    match of.word("type", &TYPES)? {
                        Some(3) => self.free(child, scope, into)?,
                        kind => {
                            let joint = self.moving(&of, scope, kind.unwrap_or_default())?;
                            into.joints.push(joint);
                        }
                    }
                }
                maker if MAKERS.contains(&maker) => {
                    return Err(ImportError::new(Importing::MakesBodies {
                        at: self.files.place(child.at),
                        element: maker.to_owned(),
                    }));
                }
                unseen if UNSEEN.contains(&unseen) => {}
                other => {
                    self.ignored.insert(printed(other));
                }
            }
        }
        Ok(())
    }

    fn replicate(
        &mut self,
        element: &'a Element,
        scope: Scope<'_>,
        is_world: bool,
        into: &mut Contents<'a>,
    ) -> Result<(), ImportError> {
        let class = self.class(element, "childclass", scope.class)?;
        let of = self.merged(element, class);
        let count = of.number("count", "4")?.unwrap_or_default();
        if !(0.0..=MAX_COPIES).contains(&count) || count.fract() != 0.0 {
            return Err(ImportError::new(Importing::TooManyCopies {
                at: of.place("count"),
                most: MAX_COPIES as usize,
            }));
        }
        let count = count as usize;
        let separator = of.value("sep").unwrap_or_default();
        let offset = of.vector("offset", "0.1 0 0")?.unwrap_or_default();
        let turn = self
            .compiler
            .euler(of.vector("euler", "0 0 90")?.unwrap_or_default());
        let (step, width) = (turn.moved(offset), count.to_string().len());
        let mut frame = scope.frame;
        for copy in 0..count {
            // Copies count even if they are empty, since they take time.
            self.count(element)?;
            let suffix = format!("{separator}{copy:0width$}{}", scope.suffix);
            let suffix = suffix.as_str();
            let inner = Scope {
                frame,
                class,
                suffix,
            };
            self.collect(element, inner, is_world, into)?;
            frame = frame.then(&step);
        }
        Ok(())
    }

    fn site(
        &mut self,
        element: &'a Element,
        scope: Scope<'_>,
        into: &mut Contents<'a>,
    ) -> Result<(), ImportError> {
        let class = self.class(element, "class", scope.class)?;
        let of = self.merged(element, class);
        if !is_foot(element.value("name").unwrap_or_default()) {
            return Ok(());
        }
        let pose = match of.vector::<6>("fromto", "0 0 0 0 0 -0.1")? {
            Some([a, b, c, d, e, f]) => {
                Transform::shifted([(a + d) / 2.0, (b + e) / 2.0, (c + f) / 2.0])
            }
            None => self.compiler.pose(&of)?,
        };
        into.tips.push(Tip {
            kind: TipKind::Site,
            at: scope.frame.then(&pose).at,
        });
        Ok(())
    }

    /// Returns mass, pose and tensor of an `<inertial>`.
    fn inertial(&self, of: &Merged<'_, '_>) -> Result<(f64, Transform, [f64; 6]), ImportError> {
        let mass = of.number("mass", "1.2")?.unwrap_or_default();
        if mass < 0.0 {
            return Err(ImportError::new(Importing::NegativeSize {
                at: of.place("mass"),
                element: of.element.name.clone(),
                attribute: "mass",
            }));
        }
        let pose = self.compiler.pose(of)?;
        let full = of.vector("fullinertia", "0.01 0.01 0.01 0 0 0")?;
        let own = of.vector("diaginertia", "0.01 0.01 0.01")?;
        let [xx, yy, zz] = own.unwrap_or_default();
        Ok((mass, pose, full.unwrap_or([xx, yy, zz, 0.0, 0.0, 0.0])))
    }

    fn free(
        &mut self,
        element: &'a Element,
        scope: Scope<'_>,
        into: &mut Contents<'a>,
    ) -> Result<(), ImportError> {
        let name = self.joint_name(element, scope)?;
        self.places.push((name, 7));
        into.is_free = true;
        Ok(())
    }

    /// Returns the name of a joint, which no other has.
    fn joint_name(&mut self, element: &Element, scope: Scope<'_>) -> Result<String, ImportError> {
        let Some(name) = element.value("name").filter(|name| !name.is_empty()) else {
            return Ok(format!("joint{}", self.places.len() + 1));
        };
        let name = format!("{name}{}", scope.suffix);
        match self.joint_names.insert(name.clone(), element.at) {
            None => Ok(name),
            Some(first) => Err(ImportError::new(Importing::JointTwice {
                joint: name,
                first: self.files.place(first),
                second: self.files.place(element.at),
            })),
        }
    }

    fn moving(
        &mut self,
        of: &Merged<'a, '_>,
        scope: Scope<'_>,
        kind: usize,
    ) -> Result<MovingJoint, ImportError> {
        let kind = [
            JointType::Revolute,
            JointType::Prismatic,
            JointType::Spherical,
        ][kind.min(2)];
        let name = self.joint_name(of.element, scope)?;
        let size = if kind == JointType::Spherical { 4 } else { 1 };
        self.places.push((name.clone(), size));
        let unit = if kind == JointType::Prismatic {
            1.0
        } else {
            self.compiler.angle
        };
        let anchor = of.vector("pos", "0 0 0")?.unwrap_or_default();
        let axis = of.vector("axis", "0 0 1")?.unwrap_or([0.0, 0.0, 1.0]);
        let range: Option<[f64; 2]> = of.vector("range", "-90 90")?;
        let is_limited = match of.word("limited", &["false", "true", "auto"])? {
            Some(0) => false,
            Some(1) => true,
            _ => self.compiler.auto_limits && range.is_some_and(|[from, to]| from != to),
        };
        // The range of a ball joint is a cone.
        let range = range.filter(|_| is_limited && kind != JointType::Spherical);
        // Files of this project have their soft limits there.
        let soft: Option<[f64; 2]> = match self.is_exported {
            true => of.vector("user", "-1 1")?,
            false => None,
        };
        let range = soft.or(range.map(|ends| ends.map(|end| end * unit)));
        let [lower, upper] = range.map_or([None; 2], |ends| ends.map(Some));
        let reference = of.number("ref", "0")?.unwrap_or_default() * unit;
        let limits = ("actuatorfrcrange", "actuatorfrclimited");
        Ok(MovingJoint {
            name,
            kind,
            anchor: scope.frame.then(&Transform::shifted(anchor)).at,
            axis: scope.frame.direction(axis),
            reference,
            limit: [lower, upper],
            effort: motors::strongest(of, limits.0, limits.1, self.compiler)?,
        })
    }

    /// Reads a body on the link with an index. The depth is bounded by that of the file.
    fn body(&mut self, child: &Child<'a>, parent: usize) -> Result<(), ImportError> {
        let element = child.element;
        let name = match element.value("name").filter(|name| !name.is_empty()) {
            Some(name) => format!("{name}{}", child.suffix),
            None => format!("body{}{}", self.links.len(), child.suffix),
        };
        if let Some(first) = self.names.insert(name.clone(), element.at) {
            return Err(ImportError::new(Importing::LinkTwice {
                link: name,
                first: self.files.place(first),
                second: self.files.place(element.at),
            }));
        }
        let class = self.class(element, "childclass", child.class)?;
        let pose = self.compiler.pose(&self.merged(element, child.class))?;
        let pose = child.frame.then(&pose);
        let scope = Scope {
            frame: Transform::default(),
            class,
            suffix: &child.suffix,
        };
        let mut contents = Contents::default();
        self.collect(element, scope, false, &mut contents)?;
        let index = self.add(&name, pose, parent, &contents);
        for child in &contents.children {
            self.body(child, index)?;
        }
        Ok(())
    }

    /// Adds the links and joints of a body; returns the index of its last link.
    fn add(
        &mut self,
        name: &str,
        pose: Transform,
        parent: usize,
        contents: &Contents<'a>,
    ) -> usize {
        let mut parent = self.links[parent].0.name.clone();
        let mut pose = pose;
        let count = contents.joints.len();
        for (number, own) in (1..).zip(&contents.joints) {
            let child = match number == count {
                true => name.to_owned(),
                // The links between the joints of a body have no name in the file.
                false => format!("{name} ({})", own.name),
            };
            let placed = pose.then(&Transform::shifted(own.anchor));
            // Values are 0 off the pose of the file by the reference.
            let origin = match own.kind {
                JointType::Prismatic => {
                    let axis = super::unit(own.axis).unwrap_or_default();
                    placed.then(&Transform::shifted(axis.map(|part| -own.reference * part)))
                }
                _ => placed.then(&Transform::turned(own.axis, -own.reference)),
            };
            self.join(&own.name, own.kind, &parent, &child, origin);
            if let Some((joint, _)) = self.joints.last_mut() {
                joint.anchor = own.anchor;
                joint.axis = own.axis;
                [joint.limit.lower, joint.limit.upper] = own.limit;
            }
            if let Some(effort) = self.efforts.last_mut() {
                *effort = own.effort;
            }
            if number < count {
                self.links.push((link(&child), self.top));
            }
            parent = child;
            pose = Transform::default();
        }
        if count == 0 {
            let kind = match contents.is_free {
                true => JointType::Floating,
                false => JointType::Fixed,
            };
            self.join(&format!("{name} (fixed)"), kind, &parent, name, pose);
        }
        let link = self.filled(link(name), contents);
        self.links.push((link, self.top));
        self.links.len() - 1
    }

    fn join(&mut self, name: &str, kind: JointType, parent: &str, child: &str, origin: Transform) {
        let joint = Joint {
            name: name.to_owned(),
            kind,
            origin,
            parent: parent.to_owned(),
            child: child.to_owned(),
            axis: [0.0, 0.0, 1.0],
            anchor: [0.0; 3],
            limit: JointLimit {
                lower: None,
                upper: None,
                unstated: f64::INFINITY,
                effort: 0.0,
                velocity: None,
            },
            mimic: None,
        };
        self.joints.push((joint, self.top));
        self.efforts.push(f64::INFINITY);
    }

    /// Fills a link with the mass, the shapes and the possible feet of its body.
    fn filled(&mut self, mut link: Link, contents: &Contents<'a>) -> Link {
        let from_geoms = match self.compiler.inertia_from_geoms {
            Some(true) => true,
            Some(false) => false,
            None => contents.inertial.is_none(),
        };
        if from_geoms {
            let (mass, centre, tensor) = geoms::inertia(&contents.geoms);
            (link.mass, link.inertia) = (mass, tensor);
            link.centre = Transform::shifted(centre);
            let weights = contents.geoms.iter().filter(|geom| geom.has_weight);
            if weights.into_iter().any(|geom| geom.mass.is_none()) {
                self.unweighed.push(printed(&link.name));
            }
        } else if let Some((mass, pose, tensor)) = contents.inertial {
            (link.mass, link.centre, link.inertia) = (mass, pose, tensor);
        }
        let shaped = |geom: &&Geom| match self.shape_class {
            Some(class) => geom.class == class,
            None => geom.collides,
        };
        link.collisions = contents.geoms.iter().filter(shaped).map(piece).collect();
        link.visuals = contents.body_box.clone();
        link.tips = contents.geoms.iter().filter_map(tip).collect();
        link.tips.extend(&contents.tips);
        link
    }

    /// Sets the torque of each joint: what its actuators and itself allow.
    pub(super) fn limit_efforts(&mut self, motors: &BTreeMap<&str, f64>) {
        for ((joint, _), own) in self.joints.iter_mut().zip(&self.efforts) {
            let motors = motors.get(joint.name.as_str()).copied();
            let effort = motors.unwrap_or(f64::INFINITY).min(*own);
            joint.limit.effort = if effort.is_finite() { effort } else { 0.0 };
        }
    }

    /// Couples joints to others.
    pub(super) fn couple(&mut self, couples: &BTreeMap<&str, &str>) {
        for (joint, _) in &mut self.joints {
            let other = couples.get(joint.name.as_str());
            joint.mimic = other.map(|other| (*other).to_owned());
        }
    }

    /// Returns the robot: the bodies of the world that carry joints.
    pub(super) fn finish(self, total_mass: Option<f64>) -> Result<RobotFile, ImportError> {
        let moves = |joint: &Joint| !matches!(joint.kind, JointType::Fixed | JointType::Floating);
        let mut kept = vec![false; self.top + 1];
        kept[0] = true;
        for (joint, top) in &self.joints {
            kept[*top] |= moves(joint);
        }
        let is_first = |joint: &Joint| joint.parent == WORLD;
        let roots = || {
            let firsts = self.joints.iter().filter(|(joint, _)| is_first(joint));
            firsts.filter(|(_, top)| kept[*top]).map(|(joint, _)| joint)
        };
        let free = roots().find(|joint| joint.kind == JointType::Floating);
        if let Some(free) = free
            && let Some(other) = roots().find(|joint| joint.child != free.child)
        {
            return Err(ImportError::new(Importing::TwoRobots {
                one: free.child.clone(),
                other: other.child.clone(),
            }));
        }
        let is_free = free.is_some();
        let scenery = self.joints.iter().filter(|(_, top)| !kept[*top]);
        let scenery: Vec<String> = scenery
            .filter(|(joint, _)| is_first(joint))
            .map(|(joint, _)| printed(&joint.child))
            .collect();
        let mut notes = Vec::new();
        if !scenery.is_empty() {
            notes.push(Importing::Scenery {
                bodies: List(scenery),
            });
        }
        if !self.ignored.is_empty() {
            let elements = List(self.ignored.iter().cloned().collect());
            notes.push(Importing::IgnoredElements { elements });
        }
        if !self.unweighed.is_empty() {
            let bodies = List(self.unweighed.clone());
            notes.push(Importing::UnweighedMeshes { bodies });
        }
        let of_robot = |(link, top): (Link, usize)| kept[top].then_some(link);
        let mut links: Vec<Link> = self.links.iter().cloned().filter_map(of_robot).collect();
        let joints = self.joints.iter().filter(|(_, top)| kept[*top]);
        let joints = joints.map(|(joint, _)| joint.clone()).collect();
        let mass: f64 = self.links.iter().map(|(link, _)| link.mass).sum();
        if let Some(total) = total_mass.filter(|_| mass > 0.0) {
            for link in &mut links {
                link.mass *= total / mass;
                link.inertia = link.inertia.map(|element| element * total / mass);
            }
        }
        Ok(RobotFile {
            name: String::new(),
            links,
            joints,
            is_free,
            posture: None,
            forward: None,
            omega_max: None,
            notes,
        })
    }
}

fn link(name: &str) -> Link {
    Link {
        name: name.to_owned(),
        mass: 0.0,
        centre: Transform::default(),
        inertia: [0.0; 6],
        visuals: Vec::new(),
        collisions: Vec::new(),
        tips: Vec::new(),
    }
}

fn piece(geom: &Geom) -> Piece {
    Piece {
        origin: geom.pose,
        geometry: geom.geometry(),
    }
}

/// Returns the point of a geometry that may be a foot: the centre of a sphere, or the end of a capsule
/// that is farther from the body's origin.
fn tip(geom: &Geom) -> Option<Tip> {
    let [one, other] = match geom.shape {
        _ if !geom.collides => return None,
        Shape::Sphere { .. } => {
            return Some(Tip {
                kind: TipKind::Sphere,
                at: geom.pose.at,
            });
        }
        Shape::Capsule { half, .. } => [half, -half],
        _ => return None,
    }
    .map(|z| geom.pose.then(&Transform::shifted([0.0, 0.0, z])).at);
    let away = |at: [f64; 3]| at.iter().map(|part| part * part).sum::<f64>();
    let at = if away(one) >= away(other) { one } else { other };
    Some(Tip {
        kind: TipKind::Capsule,
        // Halving and rotations leave rounding errors.
        at: at.map(|part| (part * 1e12).round() / 1e12 + 0.0),
    })
}

/// Returns true if a site is called foot, toe or tip, or F1 as those of this project's export are.
fn is_foot(name: &str) -> bool {
    let is_ours = (1..=MAX as u8).any(|leg| name == frame::foot(leg));
    is_ours
        || super::super::names::words(name)
            .iter()
            .any(|word| FEET.contains(&word.as_str()))
}
