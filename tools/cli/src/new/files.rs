//! The files of a new crate from templates, its name, the source of its dependencies, and the folder, which appears with all files
//! or not at all.

use crate::input::real;
use crate::message::{Making, Using};
use crate::new::{Template, fill};
use std::path::{Component, Path, PathBuf, absolute};
use std::str::FromStr;
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
    hardware: Option<Drives>,
) -> Vec<File> {
    let stem = template.motion.stem;
    let placeholders = placeholders(place, template, origin, hardware);
    let placeholders: Vec<_> = placeholders
        .iter()
        .map(|(name, value)| (*name, &**value))
        .collect();
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
    let drives: &[(&str, &str)] = match hardware {
        None => &[],
        Some(Drives::Own) => &[
            ("src/bin/drive.rs", template_text!("drive.rs")),
            ("src/hardware.rs", template_text!("hardware.rs")),
            ("tests/hardware.rs", template_text!("test_hardware.rs")),
        ],
        Some(Drives::Bus) => &[
            ("src/bin/drive.rs", template_text!("drive_bus.rs")),
            ("tests/hardware.rs", template_text!("test_bus.rs")),
        ],
    };
    files.extend(
        drives
            .iter()
            .map(|(name, text)| ((*name).to_owned(), *text)),
    );
    let scene = template.motion.scene;
    files.extend(scene.map(|scene| ("scene.toml".to_owned(), scene.text)));
    let filled = |(name, text): (String, &str)| File {
        name,
        content: fill(text, &placeholders).into_bytes(),
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

/// The drives for which a crate has code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Drives {
    /// A skeleton to be filled in.
    Own,
    /// The servos of the description.
    Bus,
}

/// The name of a described robot in code.
const DESCRIBED: &str = "ROBOT";

/// A placeholder of templates with its value.
type Placeholder = (&'static str, String);

fn placeholders(
    place: &CratePath,
    template: &Template,
    origin: &Origin,
    hardware: Option<Drives>,
) -> Vec<Placeholder> {
    let is_inside = is_inside_a_workspace(place.folder());
    let default_run = format!("default-run = \"{}\"\n", place.name());
    let scene = template.motion.scene;
    let is_in_code = scene.is_some_and(|scene| scene.is_in_code);
    let mut placeholders = vec![
        // These have placeholders themselves.
        (
            "lib_scene",
            when(is_in_code, template_text!("lib_scene.rs")),
        ),
        (
            "lib_hardware",
            when(hardware == Some(Drives::Own), "\npub mod hardware;\n"),
        ),
        (
            "readme_hardware",
            match hardware {
                None => String::new(),
                Some(Drives::Own) => template_text!("README_hardware.md").to_owned(),
                Some(Drives::Bus) => template_text!("README_bus.md").to_owned(),
            },
        ),
        (
            "bus",
            when(
                hardware == Some(Drives::Bus),
                "tip-drives = { <<drives>>, features = [\"std\"] }\n",
            ),
        ),
        (
            "sticks",
            when(template.motion.is_steered, template_text!("sticks.rs")),
        ),
        ("drives", origin.dependency(DRIVES)),
        (
            "workspace",
            when(is_inside, template_text!("manifest_workspace.toml")),
        ),
        ("default_run", when(hardware.is_some(), &default_run)),
        ("macros", origin.dependency(MACROS)),
        ("runtime", origin.dependency(RUNTIME)),
        ("sim", origin.dependency(SIM)),
        ("rust", env!("CARGO_PKG_RUST_VERSION").to_owned()),
        ("name", place.name().to_owned()),
        ("crate", place.crate_name()),
        ("motion", template.motion.stem.to_owned()),
        ("Program", type_name(template.motion.stem)),
        ("scene", when(scene.is_some(), "scene = \"scene.toml\"\n")),
        ("travel", format!("{:?}", template.motion.travel)),
        ("legs", template.legs.to_string()),
        ("joints", template.joints.to_string()),
    ];
    placeholders.extend(match template.description {
        Some(_) => of_description(&type_name(template.motion.stem)),
        None => of_runtime(&type_name(template.motion.stem), &template.robot),
    });
    placeholders
}

fn when(is_so: bool, text: &str) -> String {
    if is_so {
        text.to_owned()
    } else {
        String::new()
    }
}

/// Returns the placeholders for a robot that `robot.toml` describes.
fn of_description(program: &str) -> Vec<Placeholder> {
    let mut items = [program, DESCRIBED];
    items.sort_unstable();
    vec![
        ("features", ", features = [\"robot-files\"]".to_owned()),
        (
            "lib_description",
            format!(
                "\n// The robot as data, from its description.\n\
                 tip_macros::include_robot!(pub \"robot.toml\" as {DESCRIBED});\n"
            ),
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
fn of_runtime(program: &str, robot: &str) -> Vec<Placeholder> {
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

/// The version of this command and of the crates.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The folder that this command was built from, which may no longer exist. A release, which `.ci/release` builds, has none: its crates
/// depend on the registry, and no path of the machine that built it is in the executable.
const BUILT_FROM: Option<&str> = match option_env!("TIP_RELEASE") {
    Some(_) => None,
    None => Some(env!("CARGO_MANIFEST_DIR")),
};

/// Folders of a checkout.
const MACROS: &str = "tip-macros";
const RUNTIME: &str = "tip-runtime";
const SIM: &str = "tools/sim";
const DRIVES: &str = "tools/drives";

/// The source of the dependencies.
#[derive(Debug)]
pub(super) enum Origin {
    /// A checkout, and its path in the manifest.
    Checkout { folder: PathBuf, named: PathBuf },
    /// The registry.
    Published,
}

impl Origin {
    /// Returns the checkout that is given, else the one that this command was built from, else the registry.
    ///
    /// # Errors
    /// The folder that was asked for is not a checkout of this version.
    pub(super) fn find(asked: Option<&Path>, place: &CratePath) -> Result<Self, Making> {
        if let Some(folder) = asked {
            let refused = || Making::NotACheckout {
                folder: folder.display().to_string().into(),
                version: VERSION.to_owned(),
            };
            let named = seen_from(place.folder(), folder);
            let checkout = Self::checkout(folder, named);
            return checkout.ok_or_else(refused)?.nameable();
        }
        let built_from = BUILT_FROM.and_then(|folder| Path::new(folder).ancestors().nth(2));
        let found = built_from.and_then(|folder| Self::checkout(folder, folder.to_owned()));
        found.unwrap_or(Origin::Published).nameable()
    }

    /// Refuses a checkout with a path that a manifest cannot name.
    fn nameable(self) -> Result<Self, Making> {
        match &self {
            Origin::Checkout { named, .. }
                if named
                    .to_str()
                    .is_none_or(|path| path.contains(char::is_control)) =>
            {
                let folder = named.display().to_string().into();
                Err(Making::NotForManifest { folder })
            }
            _ => Ok(self),
        }
    }

    fn checkout(folder: &Path, named: PathBuf) -> Option<Self> {
        let manifest =
            String::from_utf8(read_file(&folder.join("Cargo.toml"), LIMIT).ok()?).ok()?;
        let version = format!("version = \"{VERSION}\"");
        let has = |name: &&str| folder.join(name).join("Cargo.toml").is_file();
        let is_ours =
            manifest.lines().any(|line| line == version) && [MACROS, RUNTIME, SIM].iter().all(has);
        is_ours.then(|| Origin::Checkout {
            folder: folder.to_owned(),
            named,
        })
    }

    /// Returns the dependency on the crate in a folder of a checkout, without braces.
    fn dependency(&self, folder: &str) -> String {
        match self {
            Origin::Checkout { named, .. } => {
                let path = named.join(folder).to_string_lossy().into_owned();
                // A string of JSON is one of TOML too.
                format!("path = {}", serde_json::Value::from(path))
            }
            Origin::Published => format!("version = \"={VERSION}\""),
        }
    }

    /// Returns the line of the report that names the source.
    pub(super) fn message(&self) -> Making {
        match self {
            Origin::Checkout { named, .. } => Making::DependsOnCheckout {
                folder: named.display().to_string().into(),
            },
            Origin::Published => Making::DependsOnPublished {
                version: VERSION.to_owned(),
            },
        }
    }

    /// Returns the lock file of the checkout.
    pub(super) fn lock(&self) -> Option<Vec<u8>> {
        match self {
            Origin::Checkout { folder, .. } => read_file(&folder.join("Cargo.lock"), LIMIT).ok(),
            Origin::Published => None,
        }
    }
}

/// Returns the path from a new folder to another one, so that both can be moved together. It is relative if they share a folder below
/// the root, and no link leads to the new one: `..` after a link leads elsewhere.
fn seen_from(place: &Path, path: &Path) -> PathBuf {
    let is_linked = absolute(place).ok().as_ref() != Some(&real(place));
    let (place, path) = (real(place), real(path));
    let both = place.components().zip(path.components());
    let shared = both.take_while(|(one, other)| one == other).count();
    let mut folders = place.components().take(shared);
    let is_below_root = folders.any(|part| matches!(part, Component::Normal(_)));
    if is_linked || !is_below_root {
        return path;
    }
    let up = place
        .components()
        .skip(shared)
        .map(|_| Component::ParentDir);
    up.chain(path.components().skip(shared)).collect()
}

/// Maximum length of a name in registries.
const MAX_NAME_CHARS: usize = 64;

/// Names that mean something else: to Rust, to cargo, to Windows, or in the crate that is made.
const TAKEN: [&str; 5] = [
    // Keywords, also those that are kept for later.
    "abstract as async await become box break const continue crate do dyn else enum extern false final fn for gen if impl in let \
     loop macro match mod move mut override priv pub ref return self static struct super trait true try type typeof unsafe \
     unsized use virtual where while yield",
    // Crates that every build has.
    "alloc core proc-macro proc_macro std test",
    // Folders that cargo writes next to an executable.
    "build deps examples incremental",
    // Devices of Windows.
    "aux com1 com2 com3 com4 com5 com6 com7 com8 com9 con lpt1 lpt2 lpt3 lpt4 lpt5 lpt6 lpt7 lpt8 lpt9 nul prn",
    // What the crate depends on, and its other executable.
    "drive tip-drives tip-macros tip-runtime tip-sim tip_drives tip_macros tip_runtime tip_sim tipc",
];

fn is_taken(name: &str) -> bool {
    let mut words = TAKEN.iter().flat_map(|words| words.split(' '));
    words.any(|word| word == name)
}

/// The name and the folder of a new crate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct CratePath {
    folder: PathBuf,
    name: String,
}

impl CratePath {
    /// Returns the folder, which has the name of the crate.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Returns the name in Rust code.
    pub(super) fn crate_name(&self) -> String {
        self.name.replace('-', "_")
    }
}

impl FromStr for CratePath {
    type Err = Using;

    fn from_str(text: &str) -> Result<Self, Using> {
        let folder = PathBuf::from(text);
        let name = folder.file_name().unwrap_or_default();
        let name = name.to_string_lossy().into_owned();
        if !is_plain_name(&name) {
            let near = near(&name);
            return Err(Using::NotACrateName { name, near });
        }
        if is_taken(&name) {
            let near = near(&name);
            return Err(Using::CrateNameTaken { name, near });
        }
        Ok(CratePath { folder, name })
    }
}

/// Returns true for small letters and digits with single `-` or `_` between them, a letter first: cargo or registries refuse other
/// names, or the compiler warns of them.
fn is_plain_name(name: &str) -> bool {
    let is_word = |word: &str| {
        !word.is_empty()
            && word
                .bytes()
                .all(|b| b.is_ascii_lowercase() || b.is_ascii_digit())
    };
    name.starts_with(|first: char| first.is_ascii_lowercase())
        && name.len() <= MAX_NAME_CHARS
        && name.split(['-', '_']).all(is_word)
}

/// Returns a similar name that is accepted.
fn near(name: &str) -> String {
    let small = name.to_lowercase();
    let words = small.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let near: String = words.join("-").chars().take(MAX_NAME_CHARS / 2).collect();
    let near = near.trim_end_matches('-');
    match near.chars().next() {
        None => "demo".to_owned(),
        Some(first) if first.is_ascii_digit() || is_taken(near) => format!("my-{near}"),
        Some(_) => near.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tipc::message::Lang;

    #[test]
    fn a_checkout_keeps_its_place_beside_the_crate() {
        for (place, path, seen) in [
            ("demo", "tip", "../tip"),
            ("demo", "../tip", "../../tip"),
            ("robots/demo", "./tip", "../../tip"),
            ("./demo", ".", ".."),
            ("demo", "/src/tip", "/src/tip"),
        ] {
            let seen_from = seen_from(Path::new(place), Path::new(path));
            assert_eq!(seen_from, Path::new(seen), "{place}: {path}");
        }
        let here = std::env::current_dir().expect("it exists");
        assert_eq!(
            seen_from(&here.join("demo"), &here.join("tip")),
            Path::new("../tip")
        );
        let far = seen_from(Path::new("/demo"), Path::new("tip"));
        assert!(far.is_absolute(), "{far:?}");
    }

    #[test]
    fn published_crates_are_those_of_this_version() {
        let expected = format!("version = \"={VERSION}\"");
        assert_eq!(Origin::Published.dependency(SIM), expected);
        let said = Origin::Published
            .message()
            .in_lang(Lang::English)
            .to_string();
        assert!(said.contains(VERSION), "{said}");
    }

    #[test]
    fn names_that_cargo_and_rust_take_are_taken() {
        let longest = "a".repeat(MAX_NAME_CHARS);
        for name in [
            "demo",
            "first-walk",
            "walk_2",
            "a",
            "x86",
            "tests",
            "new",
            "testing",
            "move-it",
            "r2d2",
            "com10",
            "tip",
            "main",
            "hardware",
            &longest,
        ] {
            let place: CratePath = name.parse().expect(name);
            assert_eq!((place.name(), place.folder()), (name, Path::new(name)));
        }
        let place: CratePath = "robots/first-walk/".parse().expect("a folder");
        assert_eq!(place.name(), "first-walk");
        assert_eq!(place.crate_name(), "first_walk");
    }

    #[test]
    fn other_names_are_refused_with_one_that_is_taken() {
        let too_long = "a".repeat(MAX_NAME_CHARS + 1);
        for (name, better) in [
            ("", "demo"),
            (".", "demo"),
            ("..", "demo"),
            ("歩く", "demo"),
            ("2fast", "my-2fast"),
            ("Demo", "demo"),
            ("first walk", "first-walk"),
            ("first.walk", "first-walk"),
            ("first--walk", "first-walk"),
            ("_demo", "demo"),
            ("demo-", "demo"),
            ("wälk", "w-lk"),
            ("match", "my-match"),
            ("test", "my-test"),
            ("Test", "my-test"),
            ("std", "my-std"),
            ("deps", "my-deps"),
            ("nul", "my-nul"),
            ("tip-runtime", "my-tip-runtime"),
            ("tip_runtime", "my-tip_runtime"),
            (&too_long, &"a".repeat(MAX_NAME_CHARS / 2)),
        ] {
            let refused = name.parse::<CratePath>().expect_err(name);
            let (Using::NotACrateName { near, .. } | Using::CrateNameTaken { near, .. }) = refused
            else {
                panic!("{name}: {refused}");
            };
            assert_eq!(near, better.replace('_', "-"), "{name}");
            near.parse::<CratePath>().expect("it is taken");
        }
    }
}
