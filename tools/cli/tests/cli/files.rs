//! Files that a checkout may hold to do harm, and files that others edit while a command works.

use crate::dap::Client;
use crate::support::{Folder, Outcome};
use serde_json::json;
use std::fs::{self, File};
use std::io::Write;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Stdio};

fn pipe(path: &Path) {
    let made = Command::new("mkfifo").arg(path).status();
    assert!(made.expect("mkfifo starts").success());
}

/// Each file of a program: read through a link to an endless device, a pipe that nobody writes, a terminal, a folder.
#[test]
fn what_is_no_regular_file_is_refused_wherever_it_is_named() {
    let program = "3.1\ntest\nEND\n";
    let folder = Folder::new("files-hostile")
        .file("robot/tip.toml", "robot = \"bad.toml\"\n")
        .file("robot/walk.prg", program)
        .file("scene/tip.toml", "scene = \"bad.toml\"\n")
        .file("scene/walk.prg", program)
        .file("config/walk.prg", program)
        .file("walk.prg", program);
    pipe(&folder.path("pipe"));
    for target in ["/dev/zero", "/dev/stdin", "../pipe"] {
        for link in [
            "robot/bad.toml",
            "scene/bad.toml",
            "config/tip.toml",
            "config/bad.prg",
        ] {
            let path = folder.path(link);
            let _ = fs::remove_file(&path);
            symlink(target, path).expect("writable");
        }
        let refused: [&[&str]; 9] = [
            &["check", "robot/walk.prg"],
            &["run", "scene/walk.prg"],
            &["check", "config/walk.prg"],
            &["check", "--robot", "robot/bad.toml", "walk.prg"],
            &["run", "--scene", "scene/bad.toml", "walk.prg"],
            &[
                "check",
                "--robot",
                "titan8",
                "--encoding",
                "utf8",
                "robot/../config/bad.prg",
            ],
            &["migrate", "config/bad.prg"],
            &["robot", "check", "robot/bad.toml"],
            &["robot", "import", "config/bad.prg"],
        ];
        for arguments in refused {
            // A pipe that stays open: whoever reads it waits for ever.
            let mut command = folder.command(arguments);
            command.stdin(Stdio::piped()).stdout(Stdio::piped());
            let child = command.stderr(Stdio::piped()).spawn().expect("it starts");
            let (stdin, output) = ended(child);
            drop(stdin);
            let outcome = Outcome::of(output).expect(1);
            let said = outcome.out + &outcome.err;
            assert!(
                said.contains("a device, a pipe or a socket"),
                "{target}: {arguments:?}: {said}"
            );
        }
    }
}

/// Waits for the end of a process, the other end of whose standard input stays open.
fn ended(
    mut child: std::process::Child,
) -> (Option<std::process::ChildStdin>, std::process::Output) {
    let stdin = child.stdin.take();
    (stdin, child.wait_with_output().expect("it ends"))
}

#[test]
fn a_file_beyond_the_limit_is_refused_with_the_limit() {
    let folder = Folder::new("files-large");
    let large = File::create(folder.path("large.prg")).expect("writable");
    large.set_len((16 << 20) + 1).expect("it is sparse");
    for arguments in [
        ["check", "large.prg"],
        ["fmt", "large.prg"],
        ["run", "large.prg"],
    ] {
        let outcome = folder.tip(&arguments).expect(1);
        let said = outcome.out + &outcome.err;
        assert!(said.contains("larger than 16 MiB"), "{said}");
    }
    // A stream that somebody names is read as far.
    for stream in ["-", "/dev/stdin"] {
        let mut command = folder.command(&["check", stream]);
        command.stdin(File::open("/dev/zero").expect("a device"));
        let outcome = Outcome::of(command.output().expect("it starts")).expect(1);
        assert!(outcome.err.contains("larger than 16 MiB"), "{outcome:#?}");
    }
}

#[test]
fn a_stream_that_the_command_line_names_is_read() {
    let folder = Folder::new("files-stream");
    for stream in ["-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"] {
        let mut command = folder.command(&["check", stream]);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.stderr(Stdio::piped()).spawn().expect("it starts");
        let input = child.stdin.take();
        let written = input.expect("piped").write_all(b"3.1\ntest\nEND\n");
        written.expect("it reads");
        let output = child.wait_with_output().expect("it ends");
        Outcome::of(output).expect(0);
    }
}

#[test]
fn a_debugger_does_not_read_its_own_connection() {
    for program in [
        "-",
        "/dev/stdin",
        "/dev/fd/0",
        "/dev/zero",
        "/proc/self/fd/0",
    ] {
        let mut client = Client::new();
        client.ask("initialize", json!({ "adapterID": "tip" }));
        let refused = client.refusal("launch", json!({ "program": program }));
        assert!(refused.contains(program), "{refused}");
        // It still answers.
        client.ask("disconnect", json!({}));
    }
}

/// Whoever edits a file while a command works on it does not lose the edit.
#[test]
fn an_edit_while_a_command_works_is_not_overwritten() {
    let edit = "3.1\ntest\nsleep 6\nEND\n";
    let lines = 20_000;
    let before = format!(
        "3.1\ntest\n{}IF KB_HIT\nEND IF\nEND\n",
        "sleep 5\n".repeat(lines)
    );
    let fine = before.replace("IF KB_HIT\nEND IF\n", "");
    let folder = Folder::new("files-edited");
    let path = folder.path("walk.prg");
    // True if the edit came before the command wrote, as it nearly always does: so many lines take a while.
    let is_refused = |arguments: &[&str], before: &str| {
        fs::write(&path, before).expect("writable");
        let mut command = folder.command(arguments);
        command.stdout(Stdio::null()).stderr(Stdio::piped());
        let child = command.spawn().expect("it starts");
        let io = format!("/proc/{}/io", child.id());
        let bytes_read = || {
            let io = fs::read_to_string(&io).unwrap_or_default();
            let bytes = io.lines().find_map(|line| line.strip_prefix("rchar: "));
            bytes.and_then(|bytes| bytes.parse().ok()).unwrap_or(0)
        };
        while bytes_read() < before.len() {}
        let is_untouched = fs::read_to_string(&path).is_ok_and(|now| now == *before);
        fs::write(&path, edit).expect("writable");
        let output = child.wait_with_output().expect("it ends");
        let now = fs::read_to_string(&path).expect("it is there");
        assert!(now == edit, "the edit is lost");
        let said = String::from_utf8_lossy(&output.stderr);
        is_untouched && said.contains("has changed since it was read")
    };
    for (arguments, before) in [
        (&["fmt", "walk.prg"][..], &fine),
        (&["check", "--fix", "walk.prg"], &before),
    ] {
        let mut tries = 0..10;
        assert!(
            tries.any(|_| is_refused(arguments, before)),
            "{arguments:?}"
        );
        assert_eq!(folder.names(), ["walk.prg"], "nothing is left beside it");
    }
}

/// A file keeps what it is besides its content: links to it, its permissions without set-user-ID, its owner.
#[test]
fn a_file_that_is_rewritten_stays_the_same_file_to_others() {
    let ugly = "3.1\ntest\nsleep 5\nEND\n";
    let folder = Folder::new("files-kept")
        .file("real.prg", ugly)
        .file("one.prg", ugly)
        .file("mode.prg", ugly);
    symlink("real.prg", folder.path("link.prg")).expect("writable");
    fs::hard_link(folder.path("one.prg"), folder.path("two.prg")).expect("writable");
    let mode = PermissionsExt::from_mode(0o6750);
    fs::set_permissions(folder.path("mode.prg"), mode).expect("ours");
    let owner = |name: &str| {
        let found = fs::metadata(folder.path(name)).expect("it is there");
        (found.uid(), found.gid())
    };
    // Only the system administrator can give a file away.
    let _ = std::os::unix::fs::chown(folder.path("mode.prg"), Some(4711), Some(4712));
    let mode = PermissionsExt::from_mode(0o6750);
    fs::set_permissions(folder.path("mode.prg"), mode).expect("ours");
    let before = owner("mode.prg");
    folder
        .tip(&["fmt", "link.prg", "one.prg", "mode.prg"])
        .expect(0);
    let link = fs::symlink_metadata(folder.path("link.prg")).expect("it is there");
    assert!(link.is_symlink());
    for name in ["real.prg", "one.prg", "two.prg", "mode.prg"] {
        assert!(folder.read(name).contains("SLEEP 5"), "{name}");
    }
    let inode = |name: &str| fs::metadata(folder.path(name)).expect("it is there").ino();
    assert_eq!(inode("one.prg"), inode("two.prg"));
    let found = fs::metadata(folder.path("mode.prg")).expect("it is there");
    assert_eq!((found.mode() & 0o7777, owner("mode.prg")), (0o750, before));
}

#[test]
fn a_file_that_may_not_become_as_long_is_an_error_and_leaves_nothing() {
    let folder = Folder::new("files-limited").program("p.prg", "PTP_ANGLE J11 10\nSLEEP 8000\nEND");
    for arguments in [
        "plot p.prg -o out.svg",
        "view p.prg -o out.html",
        "log p.prg -o out.csv",
        "run p.prg -q --trace out.jsonl --trace-motion",
    ] {
        // Two kilobytes, or four: the unit depends on the shell.
        let script = format!(
            "ulimit -f 4; exec '{}' {arguments}",
            env!("CARGO_BIN_EXE_tip")
        );
        let mut shell = Command::new("sh");
        let shell = shell.args(["-c", &script]).current_dir(folder.path(""));
        let outcome = Outcome::of(shell.output().expect("a shell")).expect(1);
        assert!(outcome.err.contains("out."), "{arguments}: {outcome:#?}");
        assert_eq!(folder.names(), ["p.prg"], "{arguments}");
    }
}

/// Pages, diagrams, code and traces are no programs: none takes the place of one, but of a page from before.
#[test]
fn no_output_replaces_a_program() {
    let mine = "3.1\nmine\nEND\n";
    let folder = Folder::new("files-mine")
        .file("walk.prg", "3.1\ntest\nEND\n")
        .file("mine.prg", mine)
        .file("OLD.PRG", mine)
        .file("old.html", "old");
    let outputs: [&[&str]; 4] = [
        &["view", "walk.prg", "--quiet", "-o"],
        &["plot", "walk.prg", "-o"],
        &["emit", "rust", "walk.prg", "-o"],
        &["run", "walk.prg", "--quiet", "--trace"],
    ];
    for output in outputs {
        for program in ["mine.prg", "OLD.PRG"] {
            let outcome = folder.tip(&[output, &[program]].concat()).expect(1);
            let said = format!("cannot write {program}: this is a program");
            assert!(outcome.err.contains(&said), "{output:?}\n{}", outcome.err);
            let kept = folder.read(program);
            assert_eq!(kept, mine, "{output:?}");
        }
    }
    folder
        .tip(&["view", "walk.prg", "--quiet", "-o", "old.html"])
        .expect(0);
    let page = folder.read("old.html");
    assert!(
        page.ends_with("</html>\n"),
        "the page from before is replaced"
    );
    // A program takes the place of a program, such as at a second try.
    folder
        .tip(&["migrate", "walk.prg", "-o", "mine.prg"])
        .expect(0);
    let migrated = folder.read("mine.prg");
    assert!(migrated.contains("test"), "{migrated}");
}
