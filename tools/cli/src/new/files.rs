//! The files of a crate.

use super::kit::Kit;
use super::name::Place;
use super::origin::Origin;
use super::template::fill;
use crate::project::real;
use std::path::Path;
use tipc::Robot;
use tipc::embed::{LIMIT, read_file};
use tipc::emit::type_name;

/// A file, and its place in the crate.
#[derive(Debug)]
pub(super) struct File {
    pub(super) name: String,
    pub(super) content: Vec<u8>,
}

/// The text of a template.
macro_rules! template {
    ($name:literal) => {
        include_str!(concat!("../../templates/", $name))
    };
}

/// All files of the crate.
pub(super) fn of(place: &Place, kit: &Kit, origin: &Origin, with_hardware: bool) -> Vec<File> {
    let stem = kit.motion.stem;
    let holes = Holes::of(place, kit, origin, with_hardware);
    let mut files = vec![
        (".editorconfig".to_owned(), template!("editorconfig")),
        (".gitignore".to_owned(), template!("gitignore")),
        (".helix/languages.toml".to_owned(), template!("helix.toml")),
        (
            ".vscode/launch.json".to_owned(),
            template!("vscode/launch.json"),
        ),
        (
            ".vscode/settings.json".to_owned(),
            template!("vscode/settings.json"),
        ),
        ("Cargo.toml".to_owned(), template!("manifest.toml")),
        ("README.md".to_owned(), template!("README.md")),
        (format!("motions/{stem}.prg"), &*kit.motion.program),
        ("src/lib.rs".to_owned(), template!("lib.rs")),
        ("src/main.rs".to_owned(), kit.motion.main),
        (format!("tests/{stem}.rs"), kit.motion.test),
        ("tip.toml".to_owned(), template!("project.toml")),
    ];
    if with_hardware {
        files.extend([
            ("src/bin/drive.rs".to_owned(), template!("drive.rs")),
            ("src/hardware.rs".to_owned(), template!("hardware.rs")),
            (
                "tests/hardware.rs".to_owned(),
                template!("test_hardware.rs"),
            ),
        ]);
    }
    files.extend(kit.scene.map(|text| ("scene.toml".to_owned(), text)));
    let filled = |(name, text): (String, &str)| File {
        name,
        content: holes.fill(text).into_bytes(),
    };
    let mut files: Vec<File> = files.into_iter().map(filled).collect();
    let given = |name: &str, content: &Option<Vec<u8>>| {
        let name = name.to_owned();
        content.clone().map(|content| File { name, content })
    };
    files.extend(given("robot.toml", &kit.description));
    files.extend(given("Cargo.lock", &origin.lock()));
    files.sort_by(|one, other| one.name.cmp(&other.name));
    files
}

/// What code of the crate calls a described robot.
const DESCRIBED: &str = "ROBOT";

/// What templates leave open.
struct Holes(Vec<(&'static str, String)>);

impl Holes {
    fn of(place: &Place, kit: &Kit, origin: &Origin, with_hardware: bool) -> Self {
        let is_inside = is_inside_a_workspace(place.folder());
        let default_run = format!("default-run = \"{}\"\n", place.name());
        let has_scene = kit.scene.is_some();
        let mut holes = vec![
            // These have holes themselves.
            ("lib_scene", when(has_scene, template!("lib_scene.rs"))),
            (
                "lib_hardware",
                when(with_hardware, template!("lib_hardware.rs")),
            ),
            (
                "readme_hardware",
                when(with_hardware, template!("README_hardware.md")),
            ),
            (
                "workspace",
                when(is_inside, template!("manifest_workspace.toml")),
            ),
            ("default_run", when(with_hardware, &default_run)),
            ("macros", origin.macros()),
            ("runtime", origin.runtime()),
            ("sim", origin.sim()),
            ("rust", env!("CARGO_PKG_RUST_VERSION").to_owned()),
            ("name", place.name().to_owned()),
            ("crate", place.crate_name()),
            ("motion", kit.motion.stem.to_owned()),
            ("Program", type_name(kit.motion.stem)),
            ("scene", when(has_scene, "scene = \"scene.toml\"\n")),
            ("travel", format!("{:?}", kit.motion.travel)),
            ("legs", kit.legs.to_string()),
            ("joints", kit.joints.to_string()),
        ];
        holes.extend(match kit.description {
            Some(_) => of_description(&type_name(kit.motion.stem)),
            None => of_runtime(&type_name(kit.motion.stem), &kit.robot),
        });
        Holes(holes)
    }

    fn fill(&self, text: &str) -> String {
        let holes = self.0.iter().map(|(name, value)| (*name, &**value));
        fill(text, &holes.collect::<Vec<_>>())
    }
}

fn when(is_so: bool, text: &str) -> String {
    if is_so {
        text.to_owned()
    } else {
        String::new()
    }
}

/// How the robot is written that `robot.toml` describes.
fn of_description(program: &str) -> Vec<(&'static str, String)> {
    let mut items = [program, DESCRIBED];
    items.sort_unstable();
    vec![
        ("features", ", features = [\"robot-files\"]".to_owned()),
        (
            "lib_description",
            template!("lib_description.rs").to_owned(),
        ),
        ("option", ", robot = \"robot.toml\"".to_owned()),
        ("items", format!("{{{}}}", items.join(", "))),
        ("own", format!("use crate::{DESCRIBED};\n\n")),
        ("model", String::new()),
        ("MODEL", DESCRIBED.to_owned()),
        ("simulated", format!("Robot::of(&{DESCRIBED})")),
        ("robot", "robot.toml".to_owned()),
    ]
}

/// How a robot of the runtime is written.
fn of_runtime(program: &str, robot: &str) -> Vec<(&'static str, String)> {
    let is_default = robot == Robot::default().name();
    vec![
        ("features", String::new()),
        ("lib_description", String::new()),
        ("option", when(!is_default, &format!(", robot = {robot}"))),
        ("items", program.to_owned()),
        ("own", String::new()),
        (
            "model",
            format!("use tip_runtime::model::{robot}::MODEL;\n"),
        ),
        ("MODEL", "MODEL".to_owned()),
        ("simulated", format!("Robot::named(\"{robot}\").unwrap()")),
        ("robot", robot.to_owned()),
    ]
}

/// Whether cargo would take the crate for a member of a workspace around it.
fn is_inside_a_workspace(folder: &Path) -> bool {
    let folder = real(folder);
    let manifests = folder
        .ancestors()
        .skip(1)
        .map(|around| around.join("Cargo.toml"));
    let texts = manifests.filter_map(|manifest| read_file(&manifest, LIMIT).ok());
    let is_workspace = |line: &[u8]| line.trim_ascii() == b"[workspace]";
    texts
        .into_iter()
        .any(|text| text.split(|byte| *byte == b'\n').any(is_workspace))
}
