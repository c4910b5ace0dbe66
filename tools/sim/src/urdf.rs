//! Robots from URDF files, and as URDF files. [`import`] makes of each serial chain of revolute joints a leg of a
//! description; [`export`] writes any robot.
//!
//! What URDF says of the kinematics survives to the last digit that is written, and so do centres of mass and inertias that a body can
//! have, and collision shapes other than meshes; what the language has no use for is dropped, and what it needs and URDF lacks is assumed. The report lists both.
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
//! let import = tip_sim::urdf::import("pendulum.urdf", urdf)?;
//! let robot = tip_sim::Robot::description(&import.toml)?;
//! assert_eq!(robot.name(), "pendulum");
//! assert!(!import.report.is_empty(), "masses had to be assumed");
//!
//! let error = tip_sim::urdf::import("pendulum.urdf", "<robot/>").unwrap_err();
//! assert!(!error.to_string().is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod body;
mod chain;
mod check;
mod choices;
mod collision;
mod doubt;
mod export;
mod foot;
pub mod frame;
mod given;
mod node;
mod pose;
mod read;
mod robot;
mod schema;
pub(crate) mod shape;
mod stand;
mod tree;
mod values;
mod version;
mod weight;
mod write;
mod xacro;
pub mod xml;

pub use choices::Choices;
pub use export::export;
pub use foot::Foot;
pub use pose::Up;
pub use xml::decode;

use crate::message::Importing;
use chain::Chain;
use pose::Pose;
use std::fmt;
use tip_runtime::command::MAX;
use tipc::description::{self, Description};
use tipc::message::list::{Faults, List};
use tree::Tree;
use values::printed;
use write::{Found, Stands};

/// A description that was made of a URDF file.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The text of the description; [`tipc::description::parse`] takes it.
    pub toml: String,
    /// What was assumed and what was dropped, a line each.
    pub report: Vec<Importing>,
}

/// Why a URDF file is not a robot with legs; it names the link, the joint or the place, and says what to do.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportError(Importing);

impl fmt::Display for ImportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl std::error::Error for ImportError {}

impl ImportError {
    fn new(message: Importing) -> Self {
        ImportError(message)
    }

    /// What it says, as data; [`Importing::in_lang`] gives its text in a language.
    pub fn message(&self) -> &Importing {
        &self.0
    }
}

/// Makes a description of a URDF file's text. `source_name` is how the description calls the file.
///
/// # Errors
/// Text that is not URDF, or nested too deep; joints that are not a tree; a leg that branches or has a joint that does not turn; legs
/// that differ in their number of joints, or have too many.
pub fn import(source_name: &str, text: &str) -> Result<Import, ImportError> {
    import_with(source_name, text, &Choices::default())
}

/// The same, with what is chosen about the file's chains.
///
/// # Errors
/// As [`import`]; names of chains or feet that the file does not have, or that leave no leg; a height at which it cannot stand.
pub fn import_with(
    source_name: &str,
    text: &str,
    choices: &Choices,
) -> Result<Import, ImportError> {
    let file = read::robot(text)?;
    let tree = Tree::new(&file)?;
    let base = tree.rigid(tree.base(), Pose::of_root(choices.up.unwrap_or_default()));
    let mut first_joints = tree.movable(&base);
    first_joints.retain(|(joint, pose)| !body::is_slider(&tree, joint, *pose));
    if first_joints.is_empty() {
        return Err(ImportError::new(Importing::NoTurningJoint {
            link: tree.base().to_owned(),
        }));
    }
    let (first_joints, left_out) = choices.legs(&tree, first_joints)?;
    let mut legs = first_joints
        .into_iter()
        .map(|(joint, pose)| Chain::follow(&tree, joint, pose, &choices.feet))
        .collect::<Result<Vec<_>, _>>()?;
    check_feet(&legs, &choices.feet)?;
    check_sizes(&legs)?;
    let extents = body::extents(&base);
    let is_bolted_down = tree.is_bolted_down();
    let walks = !is_bolted_down && (legs.len() >= 3 || extents.is_some());
    if let (true, None, Some(up)) = (walks, choices.up, chain::on_its_side(&legs)) {
        return Err(ImportError::new(Importing::OnItsSide { up }));
    }
    let order =
        (choices.order.is_empty() && legs.len() > 1).then(|| chain::order(&mut legs, walks));
    let mut found = Found {
        name: &file.name,
        walks,
        base: &base,
        extents,
        slider: body::slider(&tree, &base),
        legs: &legs,
        stands: Stands::Middle,
    };
    let (mut import, robot) = described(source_name, &found)?;
    if let Some(height) = choices.stand {
        if !walks {
            return Err(ImportError::new(Importing::StandIsForWalkers));
        }
        let postures = stand::postures(&robot, height)?;
        found.stands = Stands::AsAsked { height, postures };
        (import, _) = described(source_name, &found)?;
    } else if walks && !stand::stays_up(&robot) {
        let stands = stand::heights(&robot).find_map(|height| {
            let postures = stand::postures(&robot, height).ok()?;
            found.stands = Stands::Assumed { height, postures };
            let (import, robot) = described(source_name, &found).ok()?;
            stand::stays_up(&robot).then_some(import)
        });
        match stands {
            Some(stands) => import = stands,
            None => import.report.push(Importing::DoesNotStand),
        }
    }
    import.report.extend(left_out);
    import.report.extend(order);
    import.report.extend(file.notes);
    Ok(import)
}

/// The description of what was found, as text and as it is read.
fn described(source_name: &str, found: &Found<'_>) -> Result<(Import, Description), ImportError> {
    let (toml, report) = write::description(source_name, found);
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

/// A line from the key on whose value is at `place`: lines are long, and long words are cut.
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

/// Every foot that is named has to end a leg, and each leg has one.
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

/// Every leg needs the same number of joints, and the language can name nine of each.
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
