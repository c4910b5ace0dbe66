//! The files of a new crate from templates, and the folder, which appears with all of them or not at all.

use crate::message::Making;
use crate::new::fill;
use crate::new::name::CratePath;
use crate::new::origin::Origin;
use crate::new::template::Template;
use crate::project::real;
use std::path::{Path, PathBuf};
use std::{fs, io, process};
use tipc::Robot;
use tipc::embed::{LIMIT, read_file};
use tipc::emit::type_name;

/// A file and its path in the crate.
#[derive(Debug)]
pub(super) struct File {
    pub(super) name: String,
    pub(super) content: Vec<u8>,
}

/// Includes a template.
macro_rules! template_text {
    ($name:literal) => {
        include_str!(concat!("../../templates/", $name))
    };
}

/// Returns all files of the crate.
pub(super) fn crate_files(
    place: &CratePath,
    template: &Template,
    origin: &Origin,
    with_hardware: bool,
) -> Vec<File> {
    let stem = template.motion.stem;
    let placeholders = Placeholders::of(place, template, origin, with_hardware);
    let mut files = vec![
        (".editorconfig".to_owned(), template_text!("editorconfig")),
        (".gitignore".to_owned(), template_text!("gitignore")),
        (
            ".helix/languages.toml".to_owned(),
            template_text!("helix.toml"),
        ),
        (
            ".vscode/launch.json".to_owned(),
            template_text!("vscode/launch.json"),
        ),
        (
            ".vscode/settings.json".to_owned(),
            template_text!("vscode/settings.json"),
        ),
        ("Cargo.toml".to_owned(), template_text!("manifest.toml")),
        ("README.md".to_owned(), template_text!("README.md")),
        (format!("motions/{stem}.prg"), &*template.motion.program),
        ("src/lib.rs".to_owned(), template_text!("lib.rs")),
        ("src/main.rs".to_owned(), template.motion.main),
        (format!("tests/{stem}.rs"), template.motion.test),
        ("tip.toml".to_owned(), template_text!("project.toml")),
    ];
    if with_hardware {
        files.extend([
            ("src/bin/drive.rs".to_owned(), template_text!("drive.rs")),
            ("src/hardware.rs".to_owned(), template_text!("hardware.rs")),
            (
                "tests/hardware.rs".to_owned(),
                template_text!("test_hardware.rs"),
            ),
        ]);
    }
    files.extend(template.scene.map(|text| ("scene.toml".to_owned(), text)));
    let filled = |(name, text): (String, &str)| File {
        name,
        content: placeholders.fill(text).into_bytes(),
    };
    let mut files: Vec<File> = files.into_iter().map(filled).collect();
    let given = |name: &str, content: &Option<Vec<u8>>| {
        let name = name.to_owned();
        content.clone().map(|content| File { name, content })
    };
    files.extend(given("robot.toml", &template.description));
    files.extend(given("Cargo.lock", &origin.lock()));
    files.sort_by(|one, other| one.name.cmp(&other.name));
    files
}

/// The name of a described robot in code.
const DESCRIBED: &str = "ROBOT";

/// The placeholders of templates with their values.
struct Placeholders(Vec<(&'static str, String)>);

impl Placeholders {
    fn of(place: &CratePath, template: &Template, origin: &Origin, with_hardware: bool) -> Self {
        let is_inside = is_inside_a_workspace(place.folder());
        let default_run = format!("default-run = \"{}\"\n", place.name());
        let has_scene = template.scene.is_some();
        let mut placeholders = vec![
            // These have placeholders themselves.
            ("lib_scene", when(has_scene, template_text!("lib_scene.rs"))),
            (
                "lib_hardware",
                when(with_hardware, template_text!("lib_hardware.rs")),
            ),
            (
                "readme_hardware",
                when(with_hardware, template_text!("README_hardware.md")),
            ),
            (
                "workspace",
                when(is_inside, template_text!("manifest_workspace.toml")),
            ),
            ("default_run", when(with_hardware, &default_run)),
            ("macros", origin.macros()),
            ("runtime", origin.runtime()),
            ("sim", origin.sim()),
            ("rust", env!("CARGO_PKG_RUST_VERSION").to_owned()),
            ("name", place.name().to_owned()),
            ("crate", place.crate_name()),
            ("motion", template.motion.stem.to_owned()),
            ("Program", type_name(template.motion.stem)),
            ("scene", when(has_scene, "scene = \"scene.toml\"\n")),
            ("travel", format!("{:?}", template.motion.travel)),
            ("legs", template.legs.to_string()),
            ("joints", template.joints.to_string()),
        ];
        placeholders.extend(match template.description {
            Some(_) => of_description(&type_name(template.motion.stem)),
            None => of_runtime(&type_name(template.motion.stem), &template.robot),
        });
        Placeholders(placeholders)
    }

    fn fill(&self, text: &str) -> String {
        let placeholders = self.0.iter().map(|(name, value)| (*name, &**value));
        fill(text, &placeholders.collect::<Vec<_>>())
    }
}

fn when(is_so: bool, text: &str) -> String {
    if is_so {
        text.to_owned()
    } else {
        String::new()
    }
}

/// Returns the placeholders for a robot that `robot.toml` describes.
fn of_description(program: &str) -> Vec<(&'static str, String)> {
    let mut items = [program, DESCRIBED];
    items.sort_unstable();
    vec![
        ("features", ", features = [\"robot-files\"]".to_owned()),
        (
            "lib_description",
            template_text!("lib_description.rs").to_owned(),
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

/// Returns the placeholders for a robot of the runtime.
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

/// Returns true if cargo would take the crate for a member of an enclosing workspace.
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

/// Writes the files into a new folder.
///
/// # Errors
/// The folder is taken, has nowhere to be, or cannot be written; then there is none.
pub(super) fn write_crate(place: &CratePath, files: &[File]) -> Result<(), Making> {
    let folder = place.folder();
    let named = |path: &Path| path.display().to_string().into();
    if !is_free(folder) {
        return Err(Making::FolderTaken {
            folder: named(folder),
        });
    }
    let parent = match folder.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    if !parent.is_dir() {
        return Err(Making::NoFolder {
            folder: named(parent),
        });
    }
    let temporary = TemporaryFolder(parent.join(format!(".{}-{}", place.name(), process::id())));
    temporary
        .fill(files, folder)
        .map_err(|error| Making::NotMade {
            folder: named(folder),
            error: error.to_string().into(),
            name: place.name().to_owned(),
        })
}

/// Returns true if the folder does not exist or is empty.
fn is_free(folder: &Path) -> bool {
    match fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) => error.kind() == io::ErrorKind::NotFound && folder.symlink_metadata().is_err(),
    }
}

/// A temporary folder next to the final one; it is removed unless it was renamed.
struct TemporaryFolder(PathBuf);

impl TemporaryFolder {
    fn fill(&self, files: &[File], folder: &Path) -> io::Result<()> {
        fs::create_dir(&self.0)?;
        for file in files {
            let path = self.0.join(&file.name);
            path.parent().map_or(Ok(()), fs::create_dir_all)?;
            fs::write(path, &file.content)?;
        }
        // An empty folder in its place is removed only now.
        match fs::remove_dir(folder) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => fs::rename(&self.0, folder),
        }
    }
}

impl Drop for TemporaryFolder {
    fn drop(&mut self) {
        // It does not exist any more after its renaming.
        let _ = fs::remove_dir_all(&self.0);
    }
}
