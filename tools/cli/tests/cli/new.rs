//! `tip new`: crates that are whole or not there. That they build, walk and pass their tests is tried in `guides`.

use crate::support::Folder;
use std::fs;
use std::path::Path;

/// The folder of the crates of this project.
const TIP: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The files below a folder, sorted.
fn tree(folder: &Folder, name: &str) -> Vec<String> {
    fn collect(root: &Path, here: &Path, found: &mut Vec<String>) {
        for entry in fs::read_dir(here).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                collect(root, &path, found);
            } else {
                let name = path.strip_prefix(root).expect("it is below");
                found.push(name.to_str().expect("UTF-8").to_owned());
            }
        }
    }
    let (root, mut found) = (folder.path(name), Vec::new());
    collect(&root, &root, &mut found);
    found.sort();
    found
}

const PLAIN: [&str; 13] = [
    ".editorconfig",
    ".gitignore",
    ".helix/languages.toml",
    ".vscode/launch.json",
    ".vscode/settings.json",
    "Cargo.lock",
    "Cargo.toml",
    "README.md",
    "motions/walk.prg",
    "src/lib.rs",
    "src/main.rs",
    "tests/walk.rs",
    "tip.toml",
];

#[test]
fn a_crate_has_all_that_it_says() {
    let folder = Folder::new("new-tree");
    let outcome = folder.tip(&["new", "first-walk"]).expect(0);
    assert_eq!(tree(&folder, "first-walk"), PLAIN);
    let listed: String = PLAIN.map(|name| format!("  {name}\n")).concat();
    let checkout = Path::new(TIP).canonicalize().expect("it exists");
    let depends = format!(
        "Cargo.toml depends on the crates of the checkout `{}`\n",
        checkout.display()
    );
    let said = format!(
        "made first-walk, a crate for titan8:\n{listed}{depends}next:\n  cd first-walk\n  tip serve motions/walk.prg\n  cargo run\n"
    );
    assert_eq!(outcome.out, said);
    assert_eq!(outcome.err, "");
    assert_eq!(folder.names(), ["first-walk"], "nothing else is left");
    let main = folder.read("first-walk/src/main.rs");
    assert!(main.contains("use first_walk::Walk;"), "{main}");
    for name in PLAIN {
        let text = folder.read(&format!("first-walk/{name}"));
        assert!(!text.contains("<<"), "{name}:\n{text}");
    }
}

#[test]
fn drives_of_our_own_are_a_file_to_fill_in() {
    let folder = Folder::new("new-hardware");
    let made = folder.tip(&["new", "demo", "--hardware"]).expect(0);
    let reason = "there is no bus of servos for titan8: fill in src/hardware.rs";
    assert!(made.out.contains(reason), "{}", made.out);
    let mut expected = PLAIN.to_vec();
    expected.extend(["src/bin/drive.rs", "src/hardware.rs", "tests/hardware.rs"]);
    expected.sort_unstable();
    assert_eq!(tree(&folder, "demo"), expected);
    let manifest = folder.read("demo/Cargo.toml");
    assert!(manifest.contains("default-run = \"demo\""), "{manifest}");
}

/// A described robot gets a program that holds the guard of torque; one that no bus can measure gets a skeleton.
#[test]
fn a_described_robot_has_its_bus_and_the_guard_of_its_torque() {
    let forces = format!("{OURS}\n[forces]\ntorque_max = 2\n");
    let folder = Folder::new("new-bus")
        .file("ours.toml", OURS)
        .file("forces.toml", forces);
    folder
        .tip(&["new", "six", "--robot", "ours.toml", "--hardware"])
        .expect(0);
    let files = tree(&folder, "six");
    for name in ["robot.toml", "src/bin/drive.rs", "tests/hardware.rs"] {
        assert!(files.iter().any(|file| file == name), "{files:?}");
    }
    assert!(
        !files.iter().any(|file| file == "src/hardware.rs"),
        "{files:?}"
    );
    assert!(folder.read("six/robot.toml").contains("[bus]"));
    assert!(folder.read("six/Cargo.toml").contains("tip-drives = { "));
    let drive = folder.read("six/src/bin/drive.rs");
    assert!(
        drive.contains("operator::open(") && !drive.contains("<<"),
        "{drive}"
    );
    let forces = ["new", "grip", "--robot", "forces.toml", "--hardware"];
    folder.tip(&forces).expect(0);
    assert!(
        tree(&folder, "grip")
            .iter()
            .any(|file| file == "src/hardware.rs")
    );
    assert!(!folder.read("grip/robot.toml").contains("[bus]"));
}

/// Every robot's program is without findings, runs to its end by what `tip.toml` says alone, and is laid out in the one style.
#[test]
fn the_programs_of_every_robot_are_sound() {
    let folder = Folder::new("new-robots").file("ours.toml", OURS);
    for (robot, motion, said) in [
        ("titan8", "walk", "travel  639.9 mm forward"),
        ("generic", "walk", "travel  639.9 mm forward"),
        ("hand", "grasp", "lifted"),
        ("hexapod", "walk", "travel  1320.0 mm forward"),
        ("ours.toml", "bend", "F2"),
    ] {
        let name = format!("a-{}", robot.trim_end_matches(".toml"));
        for edition in ["3.1", "3.2"] {
            sound(&folder, &name, robot, motion, edition, said);
        }
    }
}

fn sound(folder: &Folder, name: &str, robot: &str, motion: &str, edition: &str, said: &str) {
    let name = format!("{name}-{}", edition.replace('.', ""));
    folder
        .tip(&["new", &name, "--robot", robot, "--edition", edition])
        .expect(0);
    let program = format!("{name}/motions/{motion}.prg");
    let check = ["check", "--deny", "warnings", &program];
    folder.tip(&check).expect(0);
    let outcome = folder.tip(&["run", &program]).expect(0);
    let all = format!("{}{}", outcome.out, outcome.err);
    assert!(all.contains(said), "{robot}: {all}");
    for fell in ["falls   1", "would fall"] {
        assert!(!all.contains(fell), "{robot}: {all}");
    }
    let fmt = ["fmt", "--check", &program];
    folder.tip(&fmt).expect(0);
    assert!(folder.read(&program).starts_with(edition));
}

/// The gait of a robot of six legs is a tripod. tests/external/gaits tries those of all robots.
#[test]
fn a_robot_that_walks_gets_a_gait_that_sticks_steer() {
    let folder = Folder::new("new-gait");
    let made = folder
        .tip(&["new", "hexa", "--robot", "phantomx"])
        .expect(0);
    for said in ["the motion was tried: a tripod; ", "VR1 (ahead)"] {
        assert!(made.out.contains(said), "{}", made.out);
    }
    let program = "hexa/motions/walk.prg";
    let text = folder.read(program);
    assert!(text.starts_with("3.2\n"), "{text}");
    for line in text.lines() {
        assert!(line.chars().count() <= 120, "{line}");
    }
    folder
        .tip(&["check", "--deny", "warnings", program])
        .expect(0);
    folder.tip(&["fmt", "--check", program]).expect(0);
    let steer = ["--sensor", "VR1=10@4s..8s", "--halt", "450"];
    let run = ["run", program, "--plant", "dynamic"];
    let outcome = folder.tip(&[&run[..], &steer].concat()).expect(0);
    assert!(outcome.err.contains("mm forward"), "{}", outcome.err);
    assert!(outcome.err.contains("falls   none"), "{}", outcome.err);
}

#[test]
fn a_gait_that_cannot_be_is_refused_with_the_reason() {
    let folder = Folder::new("new-no-gait");
    for (robot, gait, said) in [
        ("phantomx", "trot", "needs four legs exactly"),
        ("solo12", "tripod", "which needs six legs"),
        (
            "solo12",
            "wave",
            "the centre of mass is 0 mm inside the other feet",
        ),
        (
            "generic",
            "wave",
            "the centre of mass is 0 mm inside the other feet",
        ),
        ("hand", "crawl", "it has no body"),
    ] {
        let new = ["new", "demo", "--robot", robot, "--gait", gait];
        let outcome = folder.tip(&new).expect(1);
        let begins = format!("error: {robot} cannot walk by `--gait {gait}`: ");
        assert!(outcome.err.starts_with(&begins), "{}", outcome.err);
        assert!(outcome.err.contains(said), "{robot}: {}", outcome.err);
    }
    let old = [
        "new",
        "demo",
        "--robot",
        "solo12",
        "--gait",
        "trot",
        "--edition",
        "3.1",
    ];
    let outcome = folder.tip(&old).expect(1);
    assert!(
        outcome.err.contains("a gait needs edition 3.2"),
        "{}",
        outcome.err
    );
    assert!(folder.names().is_empty());
}

#[test]
fn another_edition_is_refused() {
    let folder = Folder::new("new-edition");
    let outcome = folder.tip(&["new", "demo", "--edition", "3.3"]).expect(2);
    assert!(
        outcome.err.contains("there are 3.1 and 3.2"),
        "{}",
        outcome.err
    );
    assert!(folder.names().is_empty());
}

/// A robot of two legs that is bolted down; one of its joints has little room.
const OURS: &str = "name = \"ours\"
joint = [
    { axis = \"z\", link = [50, 0, 0], limits = [-60, 60] },
    { axis = \"-y\", link = [120, 0, 0], limits = [-60, 75] },
    { axis = \"y\", link = [140, 0, 0], limits = [88, 150] },
]
leg = [{ base = [-120, 0, 0], mirror = \"x\" }, { base = [120, 0, 0] }]
initial = [0, 0, 90]
";

#[test]
fn the_hexapod_is_that_of_the_example() {
    let folder = Folder::new("new-hexapod");
    folder.tip(&["new", "six", "--robot", "hexapod"]).expect(0);
    let example = |name: &str| {
        let path = Path::new(TIP).join("examples/six-legs").join(name);
        fs::read_to_string(path).expect("the example")
    };
    assert_eq!(folder.read("six/robot.toml"), example("hexapod.toml"));
    let program = folder.read("six/motions/walk.prg");
    assert_eq!(program, example("motions/tripod.prg"));
}

#[test]
fn names_that_cargo_or_rust_refuse_are_refused_with_a_better_one() {
    let folder = Folder::new("new-names");
    for (name, said) in [
        ("2fast", "as in `my-2fast`"),
        ("Demo", "as in `demo`"),
        ("first walk", "as in `first-walk`"),
        ("歩く", "as in `demo`"),
        (
            "match",
            "cannot be the name of a crate, since it means something else to Rust or cargo: use `my-match`",
        ),
        ("test", "use `my-test`"),
        ("tip-runtime", "use `my-tip-runtime`"),
    ] {
        let outcome = folder.tip(&["new", name]).expect(2);
        assert!(outcome.err.contains(said), "{name}: {outcome:#?}");
        assert!(outcome.err.contains("`tip help new`"), "{outcome:#?}");
    }
    let outcome = folder.tip(&["new", "2fast", "--lang", "ja"]).expect(2);
    assert!(
        outcome.err.contains("`2fast` はクレート名にできません"),
        "{outcome:#?}"
    );
    assert!(folder.names().is_empty());
}

#[test]
fn what_is_there_is_left_alone() {
    let folder = Folder::new("new-taken")
        .file("full/mine.txt", "mine")
        .file("plain", "a file");
    for name in ["full", "plain"] {
        let outcome = folder.tip(&["new", name]).expect(1);
        let said = format!("error: `{name}` already exists: choose another name");
        assert!(outcome.err.starts_with(&said), "{outcome:#?}");
    }
    assert_eq!(tree(&folder, "full"), ["mine.txt"]);
    assert_eq!(folder.read("plain"), "a file");
    assert_eq!(folder.names(), ["full", "plain"]);
    let outcome = folder.tip(&["new", "full", "--lang", "ja"]).expect(1);
    assert!(
        outcome.err.contains("`full` はすでにあります"),
        "{outcome:#?}"
    );
    // An empty folder is as good as none.
    fs::create_dir(folder.path("empty")).expect("a folder");
    folder.tip(&["new", "empty"]).expect(0);
    assert_eq!(tree(&folder, "empty"), PLAIN);
}

#[test]
fn a_crate_that_cannot_be_made_leaves_nothing() {
    let folder = Folder::new("new-nowhere").file("broken.toml", "name = \"broken\"\nlegs = 4\n");
    let outcome = folder.tip(&["new", "far/away/demo"]).expect(1);
    let said = "error: there is no folder `far/away`: create it with `mkdir -p far/away`";
    assert!(outcome.err.starts_with(said), "{outcome:#?}");
    let outcome = folder
        .tip(&["new", "demo", "--robot", "gone.toml"])
        .expect(1);
    assert!(outcome.err.contains("gone.toml"), "{outcome:#?}");
    let outcome = folder
        .tip(&["new", "demo", "--robot", "broken.toml"])
        .expect(1);
    assert!(outcome.err.contains("`legs`"), "{outcome:#?}");
    let outcome = folder.tip(&["new", "demo", "--robot", "titan9"]).expect(2);
    assert!(
        outcome.err.contains("did you mean `titan8`?"),
        "{outcome:#?}"
    );
    let outcome = folder.tip(&["new", "demo", "--robot", "hexapd"]).expect(2);
    assert!(
        outcome.err.contains("did you mean `hexapod`?"),
        "{outcome:#?}"
    );
    let outcome = folder.tip(&["new", "demo", "--workspace", "."]).expect(1);
    assert!(
        outcome
            .err
            .contains("`.` is not a checkout of this project"),
        "{outcome:#?}"
    );
    assert_eq!(folder.names(), ["broken.toml"]);
}

/// The kernel's own folder takes none, whoever asks.
#[test]
#[cfg(target_os = "linux")]
fn a_folder_that_nobody_may_write_is_named_with_a_way_out() {
    let folder = Folder::new("new-read-only");
    let outcome = folder.tip(&["new", "/proc/demo"]).expect(1);
    assert!(
        outcome
            .err
            .starts_with("error: `/proc/demo` cannot be made: "),
        "{outcome:#?}"
    );
    assert!(
        outcome.err.contains("as in `tip new ~/demo`"),
        "{outcome:#?}"
    );
}

#[test]
fn a_checkout_that_is_named_stays_where_it_is_beside_the_crate() {
    let folder = Folder::new("new-checkout")
        .file(
            "tip/Cargo.toml",
            format!(
                "[workspace.package]\nversion = \"{}\"\n",
                env!("CARGO_PKG_VERSION")
            ),
        )
        .file("tip/tip-macros/Cargo.toml", "")
        .file("tip/tip-runtime/Cargo.toml", "")
        .file("tip/tools/sim/Cargo.toml", "")
        .file("tip/Cargo.lock", "# versions\n");
    folder.tip(&["new", "demo", "--workspace", "tip"]).expect(0);
    let manifest = folder.read("demo/Cargo.toml");
    for line in [
        "tip-macros = { path = \"../tip/tip-macros\" }",
        "tip-runtime = { path = \"../tip/tip-runtime\", features = [\"terminal\"] }",
        "tip-sim = { path = \"../tip/tools/sim\" }",
    ] {
        assert!(
            manifest.lines().any(|found| found == line),
            "{line}: {manifest}"
        );
    }
    assert_eq!(folder.read("demo/Cargo.lock"), "# versions\n");
    let old = folder.file("tip/Cargo.toml", "version = \"0.0.1\"\n");
    let outcome = old.tip(&["new", "other", "--workspace", "tip"]).expect(1);
    assert!(
        outcome
            .err
            .contains("is not a checkout of this project in version"),
        "{outcome:#?}"
    );
}

#[test]
fn a_crate_inside_a_workspace_is_one_of_its_own() {
    let folder = Folder::new("new-inside").file("around/Cargo.toml", "[workspace]\nmembers = []\n");
    folder.tip(&["new", "around/demo"]).expect(0);
    let manifest = folder.read("around/demo/Cargo.toml");
    assert!(manifest.ends_with("\n[workspace]\n"), "{manifest}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_checkout_that_a_manifest_cannot_name_is_refused_before_anything_is_written() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let names: [&[u8]; 4] = [b"a\x7Fb", b"a\nb", b"a\xFFb", "a\u{85}b".as_bytes()];
    for (n, name) in names.into_iter().enumerate() {
        let folder = Folder::new(&format!("new-unnameable-{n}"));
        let checkout = folder.path("").join(OsStr::from_bytes(name));
        let version = format!("version = \"{}\"\n", env!("CARGO_PKG_VERSION"));
        for (file, text) in [
            ("Cargo.toml", &*version),
            ("tip-macros/Cargo.toml", ""),
            ("tip-runtime/Cargo.toml", ""),
            ("tools/sim/Cargo.toml", ""),
        ] {
            let path = checkout.join(file);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
            std::fs::write(path, text).expect("writable");
        }
        let mut command = folder.command(&["new", "demo", "--workspace"]);
        let output = command.arg(OsStr::from_bytes(name)).output();
        let outcome = crate::support::Outcome::of(output.expect("it starts")).expect(1);
        assert!(
            outcome.err.contains("cannot be written in a Cargo.toml"),
            "{outcome:#?}"
        );
        assert!(!folder.has("demo"));
    }
}

/// The way back from a folder behind a link is not the way there.
#[cfg(unix)]
#[test]
fn a_crate_behind_a_link_names_the_whole_path_of_the_checkout() {
    let folder = Folder::new("new-behind")
        .file("real/deep/keep", "")
        .file("tip/tip-macros/Cargo.toml", "")
        .file("tip/tip-runtime/Cargo.toml", "")
        .file("tip/tools/sim/Cargo.toml", "")
        .file(
            "tip/Cargo.toml",
            format!("version = \"{}\"\n", env!("CARGO_PKG_VERSION")),
        );
    std::os::unix::fs::symlink("real/deep", folder.path("link")).expect("writable");
    folder
        .tip(&["new", "link/demo", "--workspace", "tip"])
        .expect(0);
    let manifest = folder.read("link/demo/Cargo.toml");
    let expected = format!("path = \"{}\"", folder.path("tip/tip-macros").display());
    assert!(manifest.contains(&expected), "{manifest}");
}

#[test]
fn programs_have_short_numbers_and_pages_are_not_for_git() {
    let folder = Folder::new("new-short");
    for robot in ["trifinger", "solo12", "spotmicro"] {
        folder.tip(&["new", robot, "--robot", robot]).expect(0);
        for name in tree(&folder, robot)
            .iter()
            .filter(|name| name.ends_with(".prg"))
        {
            let text = folder.read(&format!("{robot}/{name}"));
            let numbers = text.split(|char: char| !char.is_ascii_digit() && char != '.');
            let decimals =
                |number: &str| number.split_once('.').map_or(0, |(_, after)| after.len());
            for number in numbers {
                assert!(decimals(number) <= 2, "{robot}/{name}: {number}");
            }
        }
    }
    let ignored = folder.read("solo12/.gitignore");
    for pattern in ["*.html", "*.svg", "*.jsonl"] {
        assert!(ignored.lines().any(|line| line == pattern), "{ignored}");
    }
    let readme = folder.read("solo12/README.md");
    assert!(readme.contains("tip serve motions/walk.prg"), "{readme}");
}
