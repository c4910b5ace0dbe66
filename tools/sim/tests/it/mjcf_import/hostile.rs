//! Files that are broken, or made to take time, memory or other files: each is refused at its place.

use super::{HINGE, finger};
use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use tip_sim::import::{ImportOptions, import, import_with};

/// Time in which a file has to be refused, on a busy machine.
const PROMPT: Duration = Duration::from_secs(20);

#[track_caller]
fn refused(text: &str, parts: &[&str]) {
    let start = Instant::now();
    let error = import("test.xml", text)
        .expect_err("it is refused")
        .to_string();
    assert!(start.elapsed() < PROMPT, "{error}");
    for part in parts {
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn nesting_is_bounded() {
    let deep = |element: &str| {
        let (open, close) = (format!("<{element}>"), format!("</{element}>"));
        format!(
            "<mujoco><worldbody>{}{}</worldbody></mujoco>",
            open.repeat(100_000),
            close.repeat(100_000)
        )
    };
    for element in ["body", "frame", "replicate", "default"] {
        refused(&deep(element), &["is nested deeper than 100 levels"]);
    }
}

#[test]
fn copies_are_bounded() {
    let copies = |count: &str| {
        finger(
            "",
            &format!("<replicate count=\"{count}\">{HINGE}</replicate>"),
        )
    };
    for count in ["1e9", "1001", "-1", "2.5", "1e300"] {
        refused(&copies(count), &["line 1, column ", "from 0 to 1000"]);
    }
    refused(&copies("nan"), &["line 1, column ", "`count`"]);
    // Copies of copies.
    let open = "<replicate count=\"1000\">".repeat(5);
    let close = "</replicate>".repeat(5);
    refused(
        &finger("", &format!("{HINGE}{open}<geom size=\"1\"/>{close}")),
        &["line 1, column ", "more than 20000 parts"],
    );
    // Copies of nothing.
    refused(
        &finger("", &format!("{HINGE}{open}{close}")),
        &["more than 20000 parts"],
    );
}

#[test]
fn elements_are_counted() {
    let many = "<x/>".repeat(150_000);
    refused(
        &format!("<mujoco>{many}</mujoco>"),
        &["line 1, column ", "more than 100000 elements"],
    );
}

#[test]
fn numbers_are_finite_and_as_many_as_needed() {
    for (from, to) in [
        ("0.3 0 0", "nan 0 0"),
        ("0.3 0 0", "inf 0 0"),
        ("0.3 0 0", "0.3 0"),
        ("0.3 0 0", "0.3 0 0 0"),
        ("0.3 0 0", "0.3 0 O"),
        ("-90 90", "-90"),
        ("size=\"0.01\"", "size=\"NaN\""),
        ("size=\"0.01\"", "size=\"0.01\" mass=\"-nan\""),
    ] {
        let text = finger("", HINGE).replace(from, to);
        refused(
            &text,
            &["line 1, column ", "numbers: write them with blanks between"],
        );
    }
    for wrong in [
        "size=\"-1\"",
        "size=\"1\" mass=\"-1\"",
        "size=\"1\" density=\"-1\"",
    ] {
        let text = finger("", HINGE).replace("size=\"0.01\"", wrong);
        refused(&text, &["line 1, column ", "is below 0"]);
    }
    let parallel = "<body name=\"finger\" xyaxes=\"1 0 0 2 0 0\"";
    refused(
        &finger("", HINGE).replace("<body name=\"finger\"", parallel),
        &["line 1, column ", "gives no direction"],
    );
    let twice = "<body name=\"finger\" quat=\"1 0 0 0\" euler=\"0 0 0\"";
    refused(
        &finger("", HINGE).replace("<body name=\"finger\"", twice),
        &["line 1, column ", "more than once how it is turned"],
    );
}

#[test]
fn names_are_unique_and_classes_known() {
    let twice = format!("{HINGE}<body name=\"finger\"/>");
    refused(
        &finger("", &twice),
        &["link `finger` is defined twice, at line 1, column "],
    );
    let joints = format!("{HINGE}<joint name=\"a\"/>");
    refused(
        &finger("", &joints),
        &["joint `a` is defined twice, at line 1, column "],
    );
    for unknown in [
        "<geom class=\"no\" size=\"1\"/>",
        "<body childclass=\"no\"/>",
        "<frame childclass=\"no\"/>",
    ] {
        refused(
            &finger(
                "<default class=\"all\"><default class=\"leg\"/></default>",
                &format!("{HINGE}{unknown}"),
            ),
            &[
                "line 1, column ",
                "no default class is called `no`: the classes are all, leg, main",
            ],
        );
    }
    let classes = "<default><default class=\"a\"/><default class=\"a\"/></default>";
    refused(
        &finger(classes, HINGE),
        &["line 1, column ", "default class `a`"],
    );
}

#[test]
fn what_would_change_the_kinematics_is_refused() {
    let with =
        |section: &str| finger("", HINGE).replace("</mujoco>", &format!("{section}</mujoco>"));
    refused(
        &with("<equality><connect body1=\"finger\" anchor=\"0 0 0\"/></equality>"),
        &["line 1, column ", "the constraint `connect` closes a loop"],
    );
    let off =
        with("<equality><connect body1=\"finger\" anchor=\"0 0 0\" active=\"false\"/></equality>");
    assert!(import("test.xml", &off).is_ok());
    refused(
        &with("<equality><joint joint1=\"a\"/></equality>"),
        &["joint `a` on link `base` mimics"],
    );
    for maker in ["composite", "flexcomp", "attach"] {
        refused(
            &finger("", &format!("{HINGE}<{maker}/>")),
            &["line 1, column ", "makes bodies"],
        );
    }
    refused(
        &finger("<compiler coordinate=\"global\"/>", HINGE),
        &["line 1, column ", "global coordinates"],
    );
    for kind in ["slide", "ball"] {
        let text = finger(
            "",
            &HINGE.replace("name=", &format!("type=\"{kind}\" name=")),
        );
        refused(&text, &["joint `a` on link `base` is "]);
    }
    refused(
        &finger(
            "",
            &format!("{HINGE}<body name=\"b\"><joint/></body><body name=\"c\"><joint/></body>"),
        ),
        &["branches at link `finger`"],
    );
    refused(
        &finger("", &HINGE.replace("name=", "type=\"screw\" name=")),
        &["write one of hinge, slide, ball, free"],
    );
    refused(
        &with("<keyframe><key qpos=\"0 0\"/></keyframe>"),
        &["line 1, column ", "is not 1 numbers"],
    );
}

/// A folder of its own for a test.
fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("tip-mjcf-{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

#[test]
fn files_are_included_from_the_folder_alone() {
    let folder = folder("include");
    let main = "<mujoco>\n <worldbody><body name=\"base\">\n  <include file=\"FILE\"/></body></worldbody></mujoco>";
    let import = |file: &str| {
        let options = ImportOptions {
            folder: Some(folder.clone()),
            ..ImportOptions::default()
        };
        let import = import_with("test.xml", &main.replace("FILE", file), &options);
        import.map_err(|error| error.to_string())
    };
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("a file");
    let body = format!("<mujocoinclude><body name=\"f\">\n{HINGE}</body></mujocoinclude>");
    fs::create_dir_all(folder.join("sub")).expect("a folder");
    write("sub/leg.xml", &body);
    write(
        "loop.xml",
        "<mujocoinclude>\n<include file=\"./loop.xml\"/></mujocoinclude>",
    );
    write(
        "one.xml",
        "<mujocoinclude><include file=\"two.xml\"/></mujocoinclude>",
    );
    write(
        "two.xml",
        "<mujocoinclude><include file=\"one.xml\"/></mujocoinclude>",
    );
    write("bad.xml", &body.replace("0.3 0 0", "x 0 0"));
    write("open.xml", "<mujocoinclude><body>");
    assert!(import("sub/leg.xml").is_ok());
    let outside = std::env::temp_dir().join(format!("tip-mjcf-{}-outside.xml", std::process::id()));
    fs::write(&outside, &body).expect("a file");
    for (file, part) in [
        (
            "loop.xml",
            "`loop.xml`, line 2, column 1: `./loop.xml` is included for the second time",
        ),
        ("one.xml", "is included for the second time"),
        ("bad.xml", "`bad.xml`, line 2, column "),
        ("open.xml", "included file `open.xml`"),
        (
            "none.xml",
            "line 3, column 3: `none.xml` cannot be included",
        ),
        ("sub", "line 3, column 3: `sub` cannot be included"),
        ("/dev/zero", "line 3, column 3: `/dev/zero` is outside"),
        ("../x.xml", "`../x.xml` is outside"),
    ] {
        let error = import(file).expect_err(file);
        assert!(error.contains(part), "{error}");
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::symlink;
        symlink("/dev/zero", folder.join("zero.xml")).expect("a link");
        symlink(&outside, folder.join("out.xml")).expect("a link");
        for link in ["zero.xml", "out.xml"] {
            let error = import(link).expect_err(link);
            assert!(error.contains("is outside of the folder"), "{error}");
        }
    }
    let error = tip_sim::import::import("test.xml", &main.replace("FILE", "sub/leg.xml"));
    let error = error.expect_err("no folder").to_string();
    assert!(
        error.contains("line 3, column 3: `sub/leg.xml` is not included"),
        "{error}"
    );
    fs::remove_dir_all(&folder).expect("it is removed");
    fs::remove_file(&outside).expect("it is removed");
}
