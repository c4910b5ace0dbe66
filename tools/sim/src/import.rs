//! Robots from URDF files and from MuJoCo's models (MJCF). [`import`] makes a leg of a description of
//! each serial chain of joints that turn.
//!
//! Kinematics survive to the last digit that is written, and so do centres of mass, inertias that a
//! body can have, and collision shapes other than meshes. Properties that descriptions lack are
//! dropped, and missing ones are assumed. The report lists both.
//!
//! ```
//! let urdf = r#"<robot name="pendulum">
//!   <link name="base"/>
//!   <link name="arm"/>
//!   <link name="tip"/>
//!   <joint name="swing" type="revolute">
//!     <parent link="base"/><child link="arm"/>
//!     <axis xyz="0 0 1"/>
//!     <limit lower="-1.5" upper="1.5" effort="2" velocity="1"/>
//!   </joint>
//!   <joint name="end" type="fixed">
//!     <parent link="arm"/><child link="tip"/>
//!     <origin xyz="0.25 0 0"/>
//!   </joint>
//! </robot>"#;
//!
//! let import = tip_sim::import::import("pendulum.urdf", urdf)?;
//! let robot = tip_sim::Robot::from_description(&import.toml)?;
//! assert_eq!(robot.name(), "pendulum");
//! assert!(!import.report.is_empty(), "masses had to be assumed");
//!
//! let error = tip_sim::import::import("pendulum.urdf", "<robot/>").unwrap_err();
//! assert!(!error.to_string().is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod chains;
mod describe;
pub(crate) mod mjcf;
mod names;
mod rigid_links;
mod stand;
mod transform;
mod tree;
mod urdf;
mod xml;

pub use chains::{Foot, ImportOptions};
pub use transform::{Forward, Up};
pub use xml::decode;

use crate::Robot;
use crate::message::Importing;
use chains::Chain;
use describe::{InitialPosture, RobotParts};
use std::fmt;
use tip_runtime::command::MAX;
use tip_runtime::plant::Gap;
use tipc::description::{self, Description};
use tipc::message::list::{Faults, List};
use transform::Transform;
use tree::LinkTree;
use xml::printed;

/// A description that was made from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The text of the description; [`tipc::description::parse`] takes it.
    pub toml: String,
    /// The assumptions and omissions, a line each.
    pub report: Vec<Importing>,
}

/// The reason why a file is not a robot with legs; it names the link, the joint or the place,
/// and a way out.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportError(Box<Importing>);

impl fmt::Display for ImportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl std::error::Error for ImportError {}

impl ImportError {
    fn new(message: Importing) -> Self {
        ImportError(Box::new(message))
    }

    /// Returns the reason as data; [`Importing::in_lang`] gives its text in a language.
    pub fn message(&self) -> &Importing {
        &self.0
    }
}

/// Makes a description from the text of a file: URDF or MJCF, by its root element. `source_name` is the
/// name of the file in the description. Without options no other files are included.
///
/// # Errors
/// Text that is neither, or nested too deep; joints that are not a tree; a leg that branches or
/// has a joint that does not turn; legs that differ in their number of joints, or have too many.
pub fn import(source_name: &str, text: &str) -> Result<Import, ImportError> {
    import_with(source_name, text, &ImportOptions::default())
}

/// Like [`import`], with options.
///
/// # Errors
/// As [`import`]; names of chains or feet that the file does not have, or that leave no leg; a
/// height at which the robot cannot stand.
pub fn import_with(
    source_name: &str,
    text: &str,
    options: &ImportOptions,
) -> Result<Import, ImportError> {
    let text = xml::without_late_declaration(text);
    let document = xml::parse(&text)?;
    let file = match document.root_element().tag_name().name() {
        "robot" => urdf::robot(&document)?,
        "mujoco" => mjcf::robot(&document, options.folder.as_deref())?,
        other => {
            return Err(ImportError::new(Importing::NotARobot {
                element: other.to_owned(),
            }));
        }
    };
    let tree = LinkTree::new(&file)?;
    let forward = options.forward.or(file.forward);
    let root = Transform::of_root(options.up.unwrap_or_default(), forward)?;
    let base = tree.rigid(tree.base(), root);
    let mut first_joints = tree.movable(&base);
    first_joints.retain(|(joint, pose)| !rigid_links::is_slider(&tree, joint, *pose));
    if first_joints.is_empty() {
        return Err(ImportError::new(Importing::NoTurningJoint {
            link: tree.base().to_owned(),
        }));
    }
    let (first_joints, left_out) = options.legs(&tree, first_joints)?;
    let mut legs = first_joints
        .into_iter()
        .map(|(joint, pose)| Chain::follow(&tree, joint, pose, &options.feet))
        .collect::<Result<Vec<_>, _>>()?;
    check_feet(&legs, &options.feet)?;
    check_sizes(&legs)?;
    let extents = rigid_links::body_extents(&base);
    let is_bolted_down = tree.is_bolted_down();
    let is_free = file.is_free || legs.len() >= 3 || extents.is_some();
    let walks = !is_bolted_down && is_free;
    if let (true, None, Some(up)) = (walks, options.up, chains::on_its_side(&legs)) {
        return Err(ImportError::new(Importing::OnItsSide { up }));
    }
    let order =
        (options.order.is_empty() && legs.len() > 1).then(|| chains::order(&mut legs, walks));
    let mut found = RobotParts {
        name: &file.name,
        walks,
        base: &base,
        extents,
        slider: rigid_links::slider(&tree, &base),
        legs: &legs,
        stands: InitialPosture::Middle,
        omega_max: file.omega_max,
    };
    let mut falls = None;
    if let Some(posture) = file.posture.as_ref().filter(|_| options.stand.is_none()) {
        let postures = legs.iter().map(|leg| leg.posture(posture)).collect();
        let name = posture.name.clone();
        found.stands = InitialPosture::OfFile { name, postures };
    }
    let (mut import, robot) = described(source_name, &found)?;
    if let Some(height) = options.stand {
        if !walks {
            return Err(ImportError::new(Importing::StandIsForWalkers));
        }
        let postures = stand::postures(&robot, height)?;
        found.stands = InitialPosture::AsAsked { height, postures };
        (import, _) = described(source_name, &found)?;
    } else if walks && !stand::stays_up(&robot) {
        falls = file
            .posture
            .as_ref()
            .map(|posture| Importing::PostureFalls {
                name: printed(&posture.name),
            });
        let stands = stand::heights(&robot).find_map(|height| {
            let postures = stand::postures(&robot, height).ok()?;
            found.stands = InitialPosture::Assumed { height, postures };
            let (import, robot) = described(source_name, &found).ok()?;
            stand::stays_up(&robot).then_some(import)
        });
        match stands {
            Some(stands) => import = stands,
            None => import.report.push(Importing::DoesNotStand),
        }
    }
    import.report.extend(falls);
    if walks {
        let hips = legs.iter();
        let hips: Vec<(&str, [f64; 3])> = hips
            .filter_map(|leg| Some((leg.name(), leg.joints.first()?.at)))
            .collect();
        import.report.extend(names::contradiction(&hips, &root));
    }
    import.report.extend(left_out);
    import.report.extend(order);
    import.report.extend(file.notes);
    if let Ok(robot) = description::parse(source_name, import.toml.as_bytes()) {
        let robot = Robot::described(&robot);
        import
            .report
            .extend(not_compared(robot.distances().left_out()));
    }
    Ok(import)
}

/// Returns a message about pairs of parts that overlap in the initial posture, if there are any, with the depths.
pub fn not_compared(left_out: &[Gap]) -> Option<Importing> {
    let pair = |gap: &Gap| {
        let [one, other] = gap.parts;
        format!("{one}/{other} ({:.1} mm)", -gap.distance)
    };
    let pairs = List(left_out.iter().map(pair).collect());
    (!left_out.is_empty()).then_some(Importing::NotCompared { pairs })
}

/// Returns the description as text and parsed.
fn described(
    source_name: &str,
    found: &RobotParts<'_>,
) -> Result<(Import, Description), ImportError> {
    let (toml, report) = describe::description(source_name, found);
    match description::parse(source_name, toml.as_bytes()) {
        Ok(robot) => Ok((Import { toml, report }, robot)),
        Err(loaded) => {
            // Those after the first are like it, or follow from it.
            let first = loaded.diagnostics.into_iter().next();
            let place = first.as_ref().map_or(0, |fault| fault.span.start);
            Err(ImportError::new(Importing::NoRobot {
                line: rest_of_line(&toml, place).to_owned(),
                faults: Faults(first.into_iter().map(|fault| fault.reason).collect()),
            }))
        }
    }
}

/// Returns the line from the key on whose value is at `place`: lines are long, and long words are
/// cut.
fn rest_of_line(toml: &str, place: usize) -> &str {
    let (before, after) = toml.split_at_checked(place).unwrap_or((toml, ""));
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    let key = before[line..]
        .rfind(" = ")
        .map_or("", |end| &before[line..][..end]);
    let start = line + key.rfind([' ', '{']).map_or(0, |blank| blank + 1);
    let end = place + after.find('\n').unwrap_or(after.len());
    toml[start..end].trim()
}

/// Checks that every named foot ends a leg, and that each is named once.
fn check_feet(legs: &[Chain<'_>], feet: &[Foot]) -> Result<(), ImportError> {
    let ends = || legs.iter().map(|leg| leg.end.link.as_str());
    if let Some(foot) = feet.iter().find(|foot| ends().all(|end| end != foot.link)) {
        return Err(ImportError::new(Importing::NoSuchFoot {
            link: printed(&foot.link),
            ends: List(ends().map(printed).collect()),
        }));
    }
    let twice = |foot: &&Foot| feet.iter().filter(|it| it.link == foot.link).count() > 1;
    match feet.iter().find(twice) {
        None => Ok(()),
        Some(foot) => Err(ImportError::new(Importing::FootTwice {
            link: printed(&foot.link),
        })),
    }
}

/// Checks that all legs have the same number of joints, and that the language can name all legs and
/// joints.
fn check_sizes(legs: &[Chain<'_>]) -> Result<(), ImportError> {
    if legs.len() > MAX {
        return Err(ImportError::new(Importing::TooManyChains {
            chains: legs.len(),
            most: MAX,
        }));
    }
    let Some(first) = legs.first() else {
        return Ok(());
    };
    for leg in legs {
        let count = leg.joints.len();
        if count > MAX {
            return Err(ImportError::new(Importing::TooManyJoints {
                leg: leg.name().to_owned(),
                joints: count,
                most: MAX,
            }));
        }
        if count != first.joints.len() {
            return Err(ImportError::new(Importing::OtherNumberOfJoints {
                leg: leg.name().to_owned(),
                joints: count,
                first: first.name().to_owned(),
                wanted: first.joints.len(),
            }));
        }
    }
    Ok(())
}
