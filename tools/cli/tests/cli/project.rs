//! `tip.toml` beside programs: the nearest one counts, options win, and a broken one is an error at its place.

use crate::support::Folder;
use serde_json::{Value, json};

/// A program that only a hand understands.
const HAND: &str = "DEF_VAR T\nTEACH_TORQUE J11 T\nSLEEP T\nEND";

#[test]
fn the_nearest_file_counts_and_options_win() {
    let folder = Folder::new("project-nearest")
        .file("tip.toml", "robot = \"hand\"\n")
        .program("grasp.prg", HAND)
        .program("far/away/grasp.prg", HAND)
        .file("walker/tip.toml", "robot = \"titan8\"\n")
        .program("walker/grasp.prg", HAND);
    folder
        .tip(&["check", "grasp.prg", "far/away/grasp.prg"])
        .expect(0);
    folder.tip(&["check", "walker/grasp.prg"]).expect(1);
    folder
        .tip(&["check", "--robot", "titan8", "grasp.prg"])
        .expect(1);
    folder
        .tip(&["check", "--robot", "hand", "walker/grasp.prg"])
        .expect(0);
    // Each program of one call has its own.
    let outcome = folder.tip(&[
        "check",
        "--message-format",
        "short",
        "grasp.prg",
        "walker/grasp.prg",
    ]);
    let outcome = outcome.expect(1);
    assert!(
        outcome
            .out
            .starts_with("walker/grasp.prg:4:1: error[E204-02]: titan8 has no TEACH_TORQUE"),
        "{outcome:#?}"
    );
    folder.tip(&["cycles", "grasp.prg"]).expect(0);
    folder.tip(&["emit", "rust", "grasp.prg"]).expect(0);
    folder.tip(&["fmt", "--check", "grasp.prg"]).expect(0);
    folder
        .tip(&["fmt", "--check", "walker/grasp.prg"])
        .expect(1);
}

#[test]
fn a_run_names_it() {
    let folder = Folder::new("project-run")
        .file(
            "tip.toml",
            "[[programs]]\nfiles = \"grasp*.prg\"\nrobot = \"hand\"\nscene = \"cylinder\"\n",
        )
        .program("grasp1.prg", HAND)
        .program("grasp2.prg", "END")
        .program("rise.prg", "END");
    let outcome = folder.tip(&["run", "grasp1.prg"]).expect(0);
    assert_eq!(
        outcome.err.lines().next(),
        Some("tip.toml: robot hand, scene cylinder"),
        "{outcome:#?}"
    );
    // What an option says is not taken from it, and a scene is there for its robot.
    let hand = ["run", "--robot", "hand", "grasp1.prg"];
    let outcome = folder.tip(&hand).expect(0);
    let first = outcome.err.lines().next();
    assert_eq!(first, Some("tip.toml: scene cylinder"), "{outcome:#?}");
    let walker = ["run", "--robot", "titan8", "grasp2.prg"];
    let outcome = folder.tip(&walker).expect(0);
    assert!(!outcome.err.contains("tip.toml"), "{outcome:#?}");
    let outcome = folder.tip(&["run", "--quiet", "grasp1.prg"]).expect(0);
    assert!(!outcome.err.contains("tip.toml"), "{outcome:#?}");
    // Nothing is said where nothing is given.
    let outcome = folder.tip(&["run", "rise.prg"]).expect(0);
    assert!(!outcome.err.contains("tip.toml"), "{outcome:#?}");
}

#[test]
fn files_are_found_from_its_folder_on() {
    let robot = include_str!("../../../../tipc/tests/robots/hexapod.toml");
    let folder = Folder::new("project-files")
        .file("tip.toml", "robot = \"robots/hexapod.toml\"\n")
        .file("robots/hexapod.toml", robot)
        .program("motions/march.prg", "WAIT_INPOS F6\nEND");
    folder.tip(&["check", "motions/march.prg"]).expect(0);
}

#[test]
fn the_encoding_of_old_files_is_given_by_a_pattern() {
    // Valid UTF-8 by chance: two half-width kana of Shift_JIS.
    let text = b"3.1\n\xC3\xA9\nEND\n";
    let folder = Folder::new("project-encoding")
        .file(
            "tip.toml",
            "[[programs]]\nfiles = \"old/**\"\nencoding = \"shift_jis\"\n",
        )
        .file("old/a.prg", text)
        .file("new/a.prg", text);
    let title = |file: &str| {
        let outcome = folder.tip(&["emit", "rust", file]).expect(0);
        outcome.out.contains("\u{FF83}\u{FF69}")
    };
    assert!(title("old/a.prg"));
    assert!(!title("new/a.prg"));
}

#[test]
fn a_broken_one_is_an_error_at_its_place() {
    let folder = Folder::new("project-broken")
        .file("tip.toml", "robot = \"hnad\"\n")
        .program("grasp.prg", "END");
    let place = "tip.toml:1:9: error[E408]: `robot` cannot be this";
    for command in ["check", "run", "cycles", "fmt"] {
        let outcome = folder
            .tip(&[command, "--message-format", "short", "grasp.prg"])
            .expect(1);
        let said = format!("{}{}", outcome.out, outcome.err);
        assert!(said.contains(place), "{command}: {outcome:#?}");
    }
    let outcome = folder.tip(&["run", "--lang", "ja", "grasp.prg"]).expect(1);
    for said in [
        "`robot` にこの値は使えません",
        "`hand` の間違いではありませんか?",
    ] {
        assert!(outcome.err.contains(said), "{outcome:#?}");
    }
    // What is near no robot is answered with how robots are written.
    let folder = Folder::new("project-no-robot")
        .file("tip.toml", "robot = \"rover\"\n")
        .program("grasp.prg", "END");
    let outcome = folder.tip(&["run", "--lang", "ja", "grasp.prg"]).expect(1);
    let help = "`robot` にはロボットの名前";
    assert!(outcome.err.contains(help), "{outcome:#?}");
    let help = "`robot` is a robot's name, or a description's";
    let outcome = folder.tip(&["run", "grasp.prg"]).expect(1);
    assert!(outcome.err.contains(help), "{outcome:#?}");
}

#[test]
fn a_file_that_it_names_must_be_there() {
    let folder = Folder::new("project-missing")
        .file(
            "motions/tip.toml",
            "scene = \"../step.toml\"\nrobot = \"six.toml\"\n",
        )
        .file("step.toml", "floor = 5\n")
        .program("motions/walk.prg", "END");
    for command in ["check", "run"] {
        let outcome = folder
            .tip(&[command, "--message-format", "short", "motions/walk.prg"])
            .expect(1);
        let said = format!("{}{}", outcome.out, outcome.err);
        let place = "motions/tip.toml:2:9: error[E408]: there is no file `six.toml`";
        assert!(said.contains(place), "{command}: {outcome:#?}");
        assert!(!said.contains("step.toml"), "{command}: {outcome:#?}");
    }
}

/// A crate around `motions/grasp.prg` for a hand: what is said about it, with the texts of its sources.
fn around(name: &str, sources: &[(&str, &str)]) -> String {
    let mut folder = Folder::new(name)
        .file("Cargo.toml", "[package]\nname = \"around\"\n")
        .file("tip.toml", "robot = \"hand\"\n")
        .file(
            "target/debug/build/out.rs",
            "include_tip!(\"motions/grasp.prg\");",
        )
        .program("motions/grasp.prg", HAND);
    for (file, text) in sources {
        folder = folder.file(file, text);
    }
    let check = ["check", "--message-format", "json", "motions/grasp.prg"];
    let asked = folder.tip(&[
        "check",
        "--deny",
        "W125",
        "--robot",
        "hand",
        "motions/grasp.prg",
    ]);
    asked.expect(0);
    folder.tip(&check).expect(0).out
}

#[test]
fn a_crate_that_compiles_for_another_robot_is_warned_of_with_both_places() {
    let said_of = |said: &str, place: &str, robot: &str| {
        let finding: Value = serde_json::from_str(said).expect("one finding");
        assert_eq!(
            (&finding["code"], &finding["line"]),
            (&json!("W125"), &json!(1))
        );
        let reason = format!("tip.toml says hand, {place} compiles it for {robot}");
        assert_eq!(finding["reason"], json!(reason));
    };
    let said = around(
        "embedded-macro",
        &[(
            "src/lib.rs",
            "//! Motions.\n\ntip_macros::include_tip!(pub \"motions/grasp.prg\");\n",
        )],
    );
    said_of(&said, "src/lib.rs:3", "titan8");
    // Beside the source, as the macro finds it, and below folders.
    let said = around(
        "embedded-deep",
        &[(
            "src/a/b.rs",
            "include_tip!(\"../../motions/grasp.prg\", robot = \"generic\");",
        )],
    );
    said_of(&said, "src/a/b.rs:1", "generic");
    let said = around(
        "embedded-script",
        &[(
            "build.rs",
            "fn main() {\n    tipc::compile(\"motions/grasp.prg\").unwrap();\n}",
        )],
    );
    said_of(&said, "build.rs:2", "titan8");
    let said = around(
        "embedded-described",
        &[
            (
                "robot.toml",
                include_str!("../../../../tipc/tests/robots/hexapod.toml"),
            ),
            (
                "src/lib.rs",
                "include_tip!(\"motions/grasp.prg\", robot = \"robot.toml\");",
            ),
        ],
    );
    said_of(&said, "src/lib.rs:1", "robot.toml");
}

#[test]
fn a_crate_that_agrees_or_cannot_be_read_is_not_warned_of() {
    let other = "include_tip!(\"motions/grasp.prg\");";
    let cases: [(&str, &[(&str, &str)]); 9] = [
        (
            "embedded-same",
            &[(
                "src/lib.rs",
                "include_tip!(\"motions/grasp.prg\", robot = hand);",
            )],
        ),
        // One of two is enough.
        (
            "embedded-both",
            &[
                ("src/a.rs", other),
                (
                    "src/b.rs",
                    "include_tip!(\"motions/grasp.prg\", robot = hand);",
                ),
            ],
        ),
        (
            "embedded-comment",
            &[(
                "src/lib.rs",
                "// include_tip!(\"motions/grasp.prg\");\n/// include_tip!(\"motions/grasp.prg\");\nfn f() {}",
            )],
        ),
        (
            "embedded-text",
            &[(
                "src/lib.rs",
                "const TEXT: &str = \"include_tip!(\\\"motions/grasp.prg\\\")\";",
            )],
        ),
        (
            "embedded-broken",
            &[("src/lib.rs", "include_tip!(\"motions/grasp.prg\"")],
        ),
        (
            "embedded-unclear",
            &[(
                "build.rs",
                "fn main() { settings().compile(&[\"motions/grasp.prg\"]).unwrap() }",
            )],
        ),
        (
            "embedded-gone",
            &[("src/lib.rs", "include_tip!(\"motions/other.prg\");")],
        ),
        ("embedded-elsewhere", &[("tests/a.rs", other)]),
        ("embedded-none", &[]),
    ];
    for (name, sources) in cases {
        assert_eq!(around(name, sources), "", "{name}");
    }
}

/// Each command takes the configuration around the file, as the system finds it, and none of a folder that only the path passes.
#[cfg(unix)]
#[test]
fn the_folder_is_that_of_the_file_and_not_of_the_path() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new("project-real")
        .file("hand/tip.toml", "robot = \"hand\"\n")
        .program("hand/grasp.prg", HAND)
        .program("walker/grasp.prg", HAND);
    let link = |to: &str, at: &str| symlink(to, folder.path(at)).expect("writable");
    link("../walker/grasp.prg", "hand/other.prg");
    link("../hand/grasp.prg", "walker/other.prg");
    link("../walker", "hand/walker");
    link("hand", "linked");
    let absolute = folder.path("hand/../walker/grasp.prg");
    let walkers = [
        "hand/../walker/grasp.prg",
        absolute.to_str().expect("UTF-8"),
        "hand/other.prg",
        "hand/walker/grasp.prg",
        "linked/../walker/grasp.prg",
    ];
    let commands: [&[&str]; 9] = [
        &["check"],
        &["run", "--quiet"],
        &["fmt", "--check", "--robot", "titan8"],
        &["cycles"],
        &["emit", "rust"],
        &["log", "-o", "out.csv"],
        &["plot", "-o", "out.svg"],
        &["view"],
        &["serve"],
    ];
    for path in walkers {
        for command in commands {
            let outcome = folder.tip(&[command, &[path]].concat()).expect(1);
            let said = outcome.out + &outcome.err;
            assert!(
                said.contains("titan8 has no TEACH_TORQUE"),
                "{path}: {said}"
            );
        }
    }
    for path in [
        "walker/other.prg",
        "linked/grasp.prg",
        "walker/../hand/grasp.prg",
    ] {
        folder.tip(&["check", path]).expect(0);
        folder.tip(&["cycles", path]).expect(0);
    }
    let outcome = folder.tip(&["check", "hand/../walker/none.prg"]).expect(1);
    assert!(
        outcome.err.contains("there is no such file"),
        "{outcome:#?}"
    );
    // Servers of editors do as the commands do.
    let mut client = crate::dap::Client::new();
    client.ask("initialize", json!({ "adapterID": "tip" }));
    let program = absolute.display().to_string();
    let refused = client.refusal("launch", json!({ "program": program }));
    assert!(refused.contains("titan8 has no TEACH_TORQUE"), "{refused}");
}

/// Patterns of files mean the file's own path below the folder, and a stream is in the working directory.
#[cfg(unix)]
#[test]
fn patterns_and_streams_have_their_folder() {
    use std::os::unix::fs::symlink;
    let said = "[[programs]]\nfiles = \"old/*.prg\"\nrobot = \"hand\"\n";
    let folder = Folder::new("project-patterns")
        .file("tip.toml", said)
        .program("old/grasp.prg", HAND);
    symlink("old/grasp.prg", folder.path("grasp.prg")).expect("writable");
    folder.tip(&["check", "grasp.prg"]).expect(0);
    folder.tip(&["check", "old/../old/grasp.prg"]).expect(0);
    let folder = folder.file("tip.toml", "robot = \"hand\"\n");
    for stream in ["-", "/dev/stdin", "/dev/fd/0"] {
        let mut command = folder.command(&["check", stream]);
        let text = std::fs::File::open(folder.path("old/grasp.prg")).expect("it is there");
        let output = command.stdin(text).output().expect("tip starts");
        assert!(output.status.success(), "{stream}: {output:?}");
    }
}

/// Something of that name that is no file is an error, and not passed over for a farther one.
#[test]
fn one_that_is_a_folder_is_an_error() {
    let folder = Folder::new("project-folder")
        .file("tip.toml", "robot = \"hand\"\n")
        .file("near/tip.toml/empty", "")
        .program("near/grasp.prg", HAND);
    let outcome = folder.tip(&["check", "near/grasp.prg"]).expect(1);
    assert!(outcome.err.contains("this is a folder"), "{outcome:#?}");
}
