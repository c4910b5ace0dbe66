//! Reads MJCF, the format of MuJoCo's models, into the links and joints of the other formats.
//! Elements that only concern looks, sensors, contacts or simulation are ignored.

mod bodies;
mod elements;
mod geoms;
mod motors;

use super::ImportError;
use super::transform::{Forward, Transform, cross, dot};
use super::tree::{Posture, RobotFile};
use crate::message::Importing;
use bodies::Bodies;
use elements::{Classes, Element, Files, Merged};
use roxmltree::Document;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use tipc::message::list::List;

/// Name and value of the custom text in files of this project's export.
pub(crate) const EXPORTED: (&str, &str) = ("tip", "x right, y forward");
/// The class of shapes in files of this project's export.
pub(crate) const SHAPE_CLASS: &str = "tip_shape";
/// The custom number of the standard OMEGA_MAX in files of this project's export, deg/s.
pub(crate) const OMEGA_MAX: &str = "omega_max";
/// The names of keyframes that are preferred as initial posture.
const POSTURES: [&str; 3] = ["initial", "home", "stand"];
/// Sections that do not change how joints move.
const SECTIONS: [&str; 17] = [
    "compiler",
    "option",
    "size",
    "visual",
    "statistic",
    "default",
    "custom",
    "asset",
    "worldbody",
    "contact",
    "equality",
    "tendon",
    "actuator",
    "sensor",
    "keyframe",
    "extension",
    "deformable",
];

/// Reads a robot from an MJCF file. Included files are below `folder`.
pub(super) fn robot(
    document: &Document<'_>,
    folder: Option<&Path>,
) -> Result<RobotFile, ImportError> {
    let mut files = Files::default();
    let root = files.read(document, folder)?;
    let classes = Classes::read(&root, &files)?;
    let compiler = Compiler::read(&root, &classes, &files)?;
    let mut bodies = Bodies::new(&classes, &files, &compiler, is_exported(&root));
    bodies.world(&root)?;
    let motors = motors::read(&root, &classes, &files, &compiler)?;
    bodies.limit_efforts(&motors);
    couple(&root, &mut bodies, &classes, &files)?;
    let posture = posture(&root, &bodies, &classes, &files)?;
    let omega_max = omega_max(&root, &classes, &files)?;
    let sections = root.children.iter().map(|section| section.name.as_str());
    let unknown = sections.filter(|name| !SECTIONS.contains(name));
    bodies.ignored.extend(unknown.map(str::to_owned));
    let mut robot = bodies.finish(compiler.total_mass)?;
    robot.name = root.value("model").unwrap_or_default().to_owned();
    robot.posture = posture;
    robot.forward = is_exported(&root).then_some(Forward::Y);
    robot.omega_max = omega_max;
    Ok(robot)
}

/// Returns true if a file was written by this project's export.
fn is_exported(root: &Element) -> bool {
    let (name, data) = EXPORTED;
    let mut custom = root.section("custom");
    custom.any(|one| {
        one.name == "text" && one.value("name") == Some(name) && one.value("data") == Some(data)
    })
}

fn omega_max(
    root: &Element,
    classes: &Classes<'_>,
    files: &Files,
) -> Result<Option<f64>, ImportError> {
    let mut custom = root.section("custom");
    let named = |one: &&Element| one.name == "numeric" && one.value("name") == Some(OMEGA_MAX);
    let Some(element) = custom.find(named).filter(|_| is_exported(root)) else {
        return Ok(None);
    };
    Merged {
        element,
        class: 0,
        classes,
        files,
    }
    .number("data", "90")
}

/// The settings of `<compiler>` that matter for kinematics and masses.
struct Compiler {
    /// Factor from the unit of angles to rad.
    angle: f64,
    /// Axes of Euler angles; upper case for fixed ones.
    euler: [u8; 3],
    /// True if a range alone makes a limit.
    auto_limits: bool,
    /// True to take inertias from geometries only, false to never do so, `None` where a body has none.
    inertia_from_geoms: Option<bool>,
    /// Groups of the geometries that have mass.
    inertia_groups: [f64; 2],
    /// Total mass of the model, kg.
    total_mass: Option<f64>,
}

impl Compiler {
    fn read(root: &Element, classes: &Classes<'_>, files: &Files) -> Result<Self, ImportError> {
        let mut compiler = Compiler {
            angle: 1_f64.to_radians(),
            euler: *b"xyz",
            auto_limits: true,
            inertia_from_geoms: None,
            inertia_groups: [f64::NEG_INFINITY, f64::INFINITY],
            total_mass: None,
        };
        for element in root.children.iter().filter(|one| one.name == "compiler") {
            let own = Merged {
                element,
                class: 0,
                classes,
                files,
            };
            match own.word("angle", &["degree", "radian"])? {
                Some(0) => compiler.angle = 1_f64.to_radians(),
                Some(_) => compiler.angle = 1.0,
                None => {}
            }
            if let Some(sequence) = own.value("eulerseq") {
                let axes: Option<[u8; 3]> = sequence.as_bytes().try_into().ok();
                let axes = axes.filter(|axes| axes.iter().all(|axis| b"xyzXYZ".contains(axis)));
                compiler.euler = axes.ok_or_else(|| {
                    ImportError::new(Importing::NotAWord {
                        at: own.place("eulerseq"),
                        element: element.name.clone(),
                        attribute: "eulerseq",
                        value: sequence.to_owned(),
                        known: List(["xyz", "XYZ", "zyx", "ZYX"].map(str::to_owned).to_vec()),
                    })
                })?;
            }
            if let Some(word) = own.word("autolimits", &["false", "true"])? {
                compiler.auto_limits = word == 1;
            }
            if let Some(word) = own.word("inertiafromgeom", &["false", "true", "auto"])? {
                compiler.inertia_from_geoms = (word < 2).then_some(word == 1);
            }
            if let Some(groups) = own.vector("inertiagrouprange", "0 5")? {
                compiler.inertia_groups = groups;
            }
            if let Some(mass) = own.number("settotalmass", "12")? {
                compiler.total_mass = (mass > 0.0).then_some(mass);
            }
            if own.word("coordinate", &["local", "global"])? == Some(1) {
                return Err(ImportError::new(Importing::GlobalCoordinates {
                    at: own.place("coordinate"),
                }));
            }
        }
        Ok(compiler)
    }

    /// Returns the pose that an element states by `pos` and one form of orientation.
    fn pose(&self, of: &Merged<'_, '_>) -> Result<Transform, ImportError> {
        let at = of.vector("pos", "0 0 0.1")?.unwrap_or_default();
        const FORMS: [&str; 5] = ["quat", "axisangle", "xyaxes", "zaxis", "euler"];
        // An orientation of the element replaces that of its class, whatever its form.
        let own = FORMS.map(|form| of.element.attribute(form).is_some());
        let stated = match own.contains(&true) {
            true => own,
            false => FORMS.map(|form| of.attribute(form).is_some()),
        };
        let mut forms = (0..FORMS.len()).filter(|form| stated[*form]);
        let (form, second) = (forms.next(), forms.next());
        if second.is_some() {
            return Err(ImportError::new(Importing::TwoOrientations {
                at: of.files.place(of.element.at),
                element: of.element.name.clone(),
            }));
        }
        let degenerate = |attribute: &'static str, example| {
            ImportError::new(Importing::NotADirection {
                at: of.place(attribute),
                element: of.element.name.clone(),
                attribute,
                value: of.value(attribute).unwrap_or_default().to_owned(),
                example,
            })
        };
        let turn = match form {
            Some(0) => Transform::of_quaternion(of.vector("quat", "1 0 0 0")?.unwrap_or_default()),
            Some(1) => {
                let [x, y, z, angle] = of.vector("axisangle", "0 0 1 90")?.unwrap_or_default();
                Transform::turned([x, y, z], angle * self.angle)
            }
            Some(2) => {
                let numbers = of.vector("xyaxes", "1 0 0 0 1 0")?;
                let [a, b, c, d, e, f] = numbers.unwrap_or_default();
                let wrong = || degenerate("xyaxes", "1 0 0 0 1 0");
                let x = unit([a, b, c]).ok_or_else(wrong)?;
                let y = [d, e, f];
                let along = dot(x, y);
                let y = unit([0, 1, 2].map(|i| y[i] - along * x[i])).ok_or_else(wrong)?;
                Transform::of_axes([x, y, cross(x, y)])
            }
            Some(3) => {
                let z = of.vector("zaxis", "0 0 1")?.unwrap_or_default();
                upright(unit(z).ok_or_else(|| degenerate("zaxis", "0 0 1"))?)
            }
            Some(_) => self.euler(of.vector("euler", "0 0 90")?.unwrap_or_default()),
            None => Transform::default(),
        };
        Ok(turn.moved(at))
    }

    fn euler(&self, angles: [f64; 3]) -> Transform {
        let mut turned = Transform::default();
        for (axis, angle) in self.euler.iter().zip(angles) {
            let along = match axis.to_ascii_lowercase() {
                b'x' => [1.0, 0.0, 0.0],
                b'y' => [0.0, 1.0, 0.0],
                _ => [0.0, 0.0, 1.0],
            };
            let next = Transform::turned(along, angle * self.angle);
            turned = match axis.is_ascii_uppercase() {
                true => next.then(&turned),
                false => turned.then(&next),
            };
        }
        turned
    }
}

/// Returns a direction of length 1.
fn unit(direction: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(direction, direction).sqrt();
    (length > 1e-14).then(|| direction.map(|part| part / length))
}

/// Returns the frame whose z axis is a direction of length 1, by the shortest turn.
fn upright(z: [f64; 3]) -> Transform {
    let across = cross([0.0, 0.0, 1.0], z);
    let sin = dot(across, across).sqrt();
    match sin > 1e-14 {
        true => Transform::turned(across, libm::atan2(sin, z[2])),
        false if z[2] < 0.0 => Transform::turned([1.0, 0.0, 0.0], std::f64::consts::PI),
        false => Transform::default(),
    }
}

/// Couples the joints that `<equality>` couples, and refuses closed loops.
fn couple<'a>(
    root: &'a Element,
    bodies: &mut Bodies<'a, '_>,
    classes: &Classes<'a>,
    files: &Files,
) -> Result<(), ImportError> {
    let mut couples = BTreeMap::new();
    for element in root.section("equality") {
        let of = Merged {
            element,
            class: classes.named(element.attribute("class"), 0, files)?,
            classes,
            files,
        };
        if of.value("active") == Some("false") {
            continue;
        }
        match element.name.as_str() {
            "connect" | "weld" => {
                return Err(ImportError::new(Importing::ClosedLoop {
                    at: files.place(element.at),
                    element: element.name.clone(),
                }));
            }
            "joint" => {
                let joint = of.value("joint1").unwrap_or_default();
                let other = of.value("joint2").unwrap_or_default();
                couples.insert(joint, other);
            }
            other => {
                bodies.ignored.insert(other.to_owned());
            }
        }
    }
    bodies.couple(&couples);
    Ok(())
}

/// Returns the posture of the keyframe that is preferred.
fn posture(
    root: &Element,
    bodies: &Bodies<'_, '_>,
    classes: &Classes<'_>,
    files: &Files,
) -> Result<Option<Posture>, ImportError> {
    let keys: Vec<&Element> = root
        .section("keyframe")
        .filter(|key| key.name == "key" && key.attribute("qpos").is_some())
        .collect();
    let named = |name: &&str| keys.iter().find(|key| key.value("name") == Some(name));
    let Some(key) = POSTURES.iter().find_map(named).or_else(|| keys.first()) else {
        return Ok(None);
    };
    let of = Merged {
        element: key,
        class: 0,
        classes,
        files,
    };
    let size = bodies.places.iter().map(|(_, size)| size).sum();
    let values = of.numbers("qpos", size, size, "0 0 0.3 1 0 0 0 0 0.9 -1.8")?;
    let mut values = values.unwrap_or_default().into_iter();
    let mut joints = BTreeMap::new();
    for (name, size) in &bodies.places {
        let own: Vec<f64> = values.by_ref().take(*size).collect();
        if let [value] = own.as_slice() {
            joints.insert(name.clone(), *value);
        }
    }
    Ok(Some(Posture {
        name: key.value("name").unwrap_or_default().to_owned(),
        joints,
    }))
}

/// Elements that were ignored, and that a report lists.
type Ignored = BTreeSet<String>;
