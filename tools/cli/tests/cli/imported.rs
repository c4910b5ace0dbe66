//! `tipc robot import`.

use crate::support::Folder;

/// A leg of one joint.
pub(crate) const URDF: &str = r#"<robot name="pendulum">
<link name="base"/><link name="rod"/><link name="tip"/>
<joint name="hinge" type="revolute"><parent link="base"/><child link="rod"/>
<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="2" velocity="3"/></joint>
<joint name="end" type="fixed"><parent link="rod"/><child link="tip"/><origin xyz="0 0 -0.5"/></joint>
</robot>"#;

#[test]
fn a_urdf_file_becomes_a_description_that_can_be_checked() {
    let folder = Folder::new("imported").file("pendulum.urdf", URDF);
    let imported = folder
        .tipc(&["robot", "import", "pendulum.urdf", "-o", "pendulum.toml"])
        .expect(0);
    assert!(
        imported.err.contains("F1: joint hinge to link tip"),
        "{}",
        imported.err
    );
    assert!(folder.read("pendulum.toml").contains("link = [0, 0, -500]"));
    let checked = folder.tipc(&["robot", "check", "pendulum.toml"]).expect(0);
    assert!(
        checked
            .out
            .contains("pendulum: 1 leg of 1 joint, bolted down"),
        "{}",
        checked.out
    );
    assert!(
        checked.out.contains("F1  0.0 0.0 -500.0"),
        "{}",
        checked.out
    );
}

#[test]
fn chains_of_a_urdf_file_are_chosen() {
    let folder = Folder::new("import-chosen").file("pendulum.urdf", URDF);
    let import = |more: &[&str], status| {
        let all = [&["robot", "import", "pendulum.urdf"], more].concat();
        folder.tipc(&all).expect(status)
    };
    let chosen = import(&["--order", "hinge", "--foot", "tip"], 0);
    assert!(
        chosen.err.contains("F1: joint hinge to link tip"),
        "{}",
        chosen.err
    );
    let none = import(&["--skip", "arm"], 1).err;
    assert!(none.contains("no chain is called `arm`"), "{none}");
    assert!(none.contains("first joints are hinge"), "{none}");
    let foot = import(&["--foot", "toe"], 1).err;
    assert!(foot.contains("link `toe` ends no leg"), "{foot}");
    let placed = import(&["--foot", "rod=0.1,0,-0.25"], 0);
    // URDF's x is ahead, the language's y.
    assert!(
        placed.out.contains("link = [0, 100, -250]"),
        "{}",
        placed.out
    );
    let wrong = import(&["--foot", "rod=0.1,0"], 2).err;
    assert!(wrong.contains("`rod=0.1,0` is not a foot"), "{wrong}");
    let hangs = import(&["--stand", "300"], 1).err;
    assert!(hangs.contains("this one is bolted down"), "{hangs}");
    for wrong in ["0", "-5", "high"] {
        let option = format!("--stand={wrong}");
        let wrong = import(&[&option], 2).err;
        assert!(wrong.contains("is not a height"), "{wrong}");
    }
}

#[test]
fn a_urdf_file_that_cannot_be_imported_leaves_nothing() {
    let folder = Folder::new("not-imported")
        .file("sliding.urdf", URDF.replace("revolute", "prismatic"))
        .file("broken.urdf", &URDF[..100]);
    for (file, reason) in [
        ("sliding.urdf", "joint `hinge` on link `base` is prismatic"),
        ("broken.urdf", "this is not URDF"),
        ("gone.urdf", "there is no such file"),
    ] {
        let outcome = folder
            .tipc(&["robot", "import", file, "-o", "out.toml"])
            .expect(1);
        assert!(outcome.err.contains(reason), "{}", outcome.err);
        assert!(outcome.err.contains(file), "{}", outcome.err);
        assert!(!folder.has("out.toml"));
    }
}

#[test]
fn imports_speak_japanese() {
    let folder = Folder::new("import-japanese")
        .file("pendulum.urdf", URDF)
        .file("sdf.urdf", "<sdf/>");
    let import = |file: &str, status| {
        let words = ["robot", "import", file, "--lang", "ja"];
        folder.tipc(&words).expect(status)
    };
    let report = import("pendulum.urdf", 0);
    assert!(
        report.err.contains("F1: 関節hingeからリンクtipまで"),
        "{}",
        report.err
    );
    let refused = import("sdf.urdf", 1).err;
    assert!(
        refused.starts_with("エラー: sdf.urdf: ルート要素が `sdf` ですが"),
        "{refused}"
    );
    let exported = folder.tipc(&[
        "robot", "export", "--urdf", "--robot", "sdf.urdf", "--lang", "ja",
    ]);
    assert!(exported.expect(1).err.starts_with("エラー: sdf.urdf"));
}
