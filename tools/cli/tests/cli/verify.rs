//! `tip verify`: one program, built with a fault in its emitted code and without.

use crate::support::{Folder, Outcome};
#[cfg(unix)]
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;
#[cfg(unix)]
use std::{env, fs};

/// Counts keys up to 5.
///
/// In the first turn of the loop KEY_IN runs in cycle 2, IF SPEED > 5 in cycle 7; in the second one nine cycles later. KEY_IN
/// empties the keyboard buffer, so a second key has to come after cycle 2.
const COUNTER: &str = "DEF_VAR SPEED
SPEED = 3
LOOP: KEY_IN
IF VAR_KEY == CHAR_F THEN
SPEED += 1
ELSEIF VAR_KEY == CHAR_Q THEN
EXIT
ENDIF
IF SPEED > 5 THEN
SPEED = 5
ENDIF
GOTO LOOP:
END";

/// Stands in for cargo: the emitted code asks for `>=` where the program says `>`. A copy that keeps its time is built once.
#[cfg(unix)]
const FAULTY_CARGO: &str = r#"#!/bin/sh
planted=$(dirname "$0")/planted.rs
for word; do
  case $word in
    */Cargo.toml)
      code=${word%Cargo.toml}src/program.rs
      [ -e "$planted" ] || sed 's/value() > /value() >= /' "$code" >"$planted"
      cp -p "$planted" "$code" ;;
  esac
done
exec "$SOUND_CARGO" "$@"
"#;

/// The command on the program with the runtime of this workspace. What it builds runs for moments here, and is not optimised.
fn command(folder: &Folder, program: &str, arguments: &[&str]) -> Command {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../Cargo.toml");
    let workspace = workspace.to_str().expect("a path in UTF-8");
    let all = [
        &["verify", program, "--manifest-path", workspace],
        arguments,
    ]
    .concat();
    let mut command = folder.command(&all);
    command.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "0");
    command
}

/// The result.
fn outcome(mut command: Command) -> Outcome {
    Outcome::of(command.output().expect("tip starts"))
}

/// The planted fault takes `>` for `>=`: it shows when SPEED is 5, which two keys make it.
#[cfg(unix)]
#[test]
fn a_planted_fault_is_found_and_shrunk() {
    let folder = Folder::new("verify-planted")
        .program("faulty.prg", COUNTER)
        .file("faulty-cargo", FAULTY_CARGO);
    let cargo = folder.path("faulty-cargo");
    fs::set_permissions(&cargo, PermissionsExt::from_mode(0o755)).expect("the file is ours");
    let faulty = |arguments: &[&str]| {
        let mut command = command(&folder, "faulty.prg", arguments);
        let sound = env::var_os("CARGO").expect("cargo runs the tests");
        command.env("SOUND_CARGO", sound).env("CARGO", &cargo);
        outcome(command)
    };
    let outcome = faulty(&["--cycles", "200"]).expect(1);
    let shortest = "--keys 0:F,3:F --cycles 17";
    for part in [
        "DIFFER in cycle 16, step 8\n",
        "--> faulty.prg:11:1\n",
        "IF SPEED > 5 THEN\n",
        "interpreter  {\"cycle\":16,\"step\":8,\"next\":10,",
        "compiled     {\"cycle\":16,\"step\":8,\"next\":9,",
        &format!(" {shortest}\n"),
    ] {
        assert!(outcome.out.contains(part), "{part} in {outcome:#?}");
    }
    let words: Vec<_> = shortest.split(' ').collect();
    let again = faulty(&words).expect(1);
    assert_eq!(again.out, outcome.out);
    faulty(&["--keys", "0:F,2:F", "--cycles", "17"]).expect(0);
}

/// Stands in for cargo, and builds a process that says of a few runs that they agreed. Then Ctrl-C is pressed.
#[cfg(unix)]
const INTERRUPTED_CARGO: &str = r#"#!/bin/sh
case $1 in
  build) ;;
  *) exec "$SOUND_CARGO" "$@" ;;
esac
if [ "$STAGE" = build ]; then
  kill -INT $PPID
  sleep 0.5
  exit 1
fi
echo "{\"executable\":\"$PWD/engines\"}"
"#;

#[cfg(unix)]
const ENGINES: &str = r#"#!/bin/sh
for answer in 1 2 3; do
  read -r request
  echo '{"Agreed":{"cycles":10,"end":"Limit","new":[],"chances":[0]}}'
done
read -r request
kill -INT $PPID
exec sleep 20
"#;

#[cfg(unix)]
#[test]
fn ctrl_c_ends_each_stage_and_says_how_far_it_came() {
    let mut folder = Folder::new("verify-interrupted").program("p.prg", COUNTER);
    let fake = INTERRUPTED_CARGO.replace("$PWD/engines", &folder.path("engines").to_string_lossy());
    folder = folder.file("cargo", fake).file("engines", ENGINES);
    for name in ["cargo", "engines"] {
        let mode = PermissionsExt::from_mode(0o755);
        fs::set_permissions(folder.path(name), mode).expect("the file is ours");
    }
    let interrupted = |stage: &str| {
        let mut command = command(&folder, "p.prg", &[]);
        let sound = env::var_os("CARGO").expect("cargo runs the tests");
        command.env("SOUND_CARGO", sound).env("STAGE", stage);
        command.env("CARGO", folder.path("cargo"));
        outcome(command)
    };
    let outcome = interrupted("build").expect(130);
    assert_eq!(
        (&*outcome.out, &*outcome.err),
        ("", "interrupted while cargo built: nothing was compared\n")
    );
    let outcome = interrupted("compare").expect(130);
    assert_eq!(
        (&*outcome.out, &*outcome.err),
        (
            "",
            "interrupted after 3 of 256 runs, 30 cycles: no difference so far\n"
        )
    );
}

#[test]
fn engines_that_agree_get_a_certificate() {
    let folder = Folder::new("verify").program("p.prg", COUNTER);
    let verify = |arguments: &[&str]| outcome(command(&folder, "p.prg", arguments));
    let outcome = verify(&["--cycles", "200"]).expect(0);
    for part in [
        "p.prg: compiled code and interpreter agree\n",
        "robot        titan8, 4 x 3 joints, level floor\n",
        "runs         256: ",
        "steps        12 of 12\n",
        "branch edges 7 of 7\n",
        "  p.prg:15: no way leads here: END\n",
    ] {
        assert!(outcome.out.contains(part), "{part} in {outcome:#?}");
    }
    // Given inputs are one run; what it did not reach is reported.
    let outcome = verify(&["--keys", "0:Q"]).expect(0);
    for part in [
        "runs         1: 1 to END or EXIT, 0 ",
        "steps        6 of 12\n",
        "  p.prg:6: never true: IF VAR_KEY == CHAR_F THEN\n",
        "  p.prg:7: not reached: SPEED += 1\n",
    ] {
        assert!(outcome.out.contains(part), "{part} in {outcome:#?}");
    }
    let outcome = verify(&["--sensor", "J99=1@0"]).expect(2);
    assert!(outcome.err.contains("no input J99"), "{outcome:#?}");
}

#[test]
fn what_keeps_a_program_from_being_built_is_named() {
    let project = "[package]\nname = \"p\"\nversion = \"0.0.0\"\n[workspace]\n";
    let folder = Folder::new("verify-project")
        .program("p.prg", "END")
        .program("bad.prg", "FOO\nEND")
        .file("Cargo.toml", project)
        .file("src/lib.rs", "");
    let outcome = folder.tip(&["verify", "p.prg"]).expect(1);
    assert!(
        outcome.err.contains("does not depend on tip-runtime"),
        "{outcome:#?}"
    );
    let outcome = folder
        .tip(&["verify", "p.prg", "--manifest-path", "none/Cargo.toml"])
        .expect(1);
    assert!(outcome.err.contains("--manifest-path"), "{outcome:#?}");
    let mut command = folder.command(&["verify", "p.prg"]);
    let outcome = command
        .env("CARGO", "no-such-cargo")
        .output()
        .expect("tip starts");
    let outcome = Outcome::of(outcome).expect(1);
    assert!(outcome.err.contains("cargo is not there"), "{outcome:#?}");
    let outcome = folder.tip(&["verify", "bad.prg"]).expect(1);
    assert!(outcome.err.contains("bad.prg:3:1"), "{outcome:#?}");
    folder.tip(&["verify", "p.prg", "--runs", "many"]).expect(2);
}

#[test]
fn a_comparison_of_nothing_is_refused() {
    let folder = Folder::new("verify-nothing").program("p.prg", "END");
    for option in ["--runs", "--cycles"] {
        let outcome = folder.tip(&["verify", "p.prg", option, "0"]).expect(2);
        assert!(
            outcome.err.contains("is not a number of runs or cycles"),
            "{outcome:#?}"
        );
    }
}

#[test]
fn outside_of_a_project_it_says_what_it_needs() {
    let folder = Folder::new("verify-nowhere").program("p.prg", "END");
    // The folder of tests is in a workspace; the root of the system is in none.
    let manifest = ["verify", "p.prg", "--manifest-path", "/Cargo.toml"];
    let outcome = folder.tip(&manifest).expect(1);
    assert_eq!(
        outcome.err,
        "error: the program is compiled in a Cargo project that depends on tip-runtime, and / is in none: \
         `tip new demo` makes one; run it in the folder of a project that depends on tip-runtime, \
         or name its Cargo.toml by --manifest-path\n"
    );
}
