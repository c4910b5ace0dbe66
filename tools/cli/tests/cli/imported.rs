//! `tip robot import`.

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
        .tip(&["robot", "import", "pendulum.urdf", "-o", "pendulum.toml"])
        .expect(0);
    assert!(
        imported.err.contains("F1: joint hinge to link tip"),
        "{}",
        imported.err
    );
    assert!(folder.read("pendulum.toml").contains("link = [0, 0, -500]"));
    let checked = folder.tip(&["robot", "check", "pendulum.toml"]).expect(0);
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
        folder.tip(&all).expect(status)
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
        ("broken.urdf", "this is neither URDF nor MJCF"),
        ("gone.urdf", "there is no such file"),
    ] {
        let outcome = folder
            .tip(&["robot", "import", file, "-o", "out.toml"])
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
        folder.tip(&words).expect(status)
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
    let exported = folder.tip(&[
        "robot", "export", "--urdf", "--robot", "sdf.urdf", "--lang", "ja",
    ]);
    let refused = exported.expect(1).err;
    assert!(
        refused.contains("sdf.urdf") && refused.contains("ルート要素が `sdf` ですが"),
        "{refused}"
    );
}

/// A URDF file is the robot that its description is, wherever a robot is chosen.
#[test]
fn a_urdf_file_is_a_robot() {
    let folder = Folder::new("urdf-robot")
        .file("pendulum.urdf", URDF)
        .file("sdf.urdf", "<sdf/>")
        .program(
            "turn.prg",
            "DEF_VAR ANGLE\nANGLE = 10\nPTP_ANGLE J11 ANGLE\nWAIT_INPOS J11\nEND",
        );
    folder
        .tip(&["robot", "import", "pendulum.urdf", "-o", "pendulum.toml"])
        .expect(0);
    let with = |file: &str, arguments: &[&str]| {
        let all = [arguments, &["--robot", file]].concat();
        folder.tip(&all).expect(0).out
    };
    for arguments in [
        &["run", "turn.prg", "--trace", "-"][..],
        &[
            "sweep",
            "turn.prg",
            "--vary",
            "ANGLE=10,20",
            "--vary",
            "robot.leg.1.joint.1.limits.2=30,50",
            "-q",
            "-o",
            "-",
        ],
    ] {
        let described = with("pendulum.toml", arguments);
        assert!(described.lines().count() > 4, "{described}");
        assert_eq!(with("pendulum.urdf", arguments), described);
    }
    let refused = folder
        .tip(&["run", "turn.prg", "--robot", "sdf.urdf"])
        .expect(1)
        .err;
    assert!(
        refused.contains("sdf.urdf") && refused.contains("the root element is `sdf`"),
        "{refused}"
    );
}

/// Four legs of three joints about x, y and y, in a file whose y is up; front right comes first, as in many files.
fn quadruped() -> String {
    let mut text = "<robot name=\"dog\"><link name=\"base\"><inertial><mass value=\"5\"/>\
                    <inertia ixx=\"0.02\" ixy=\"0\" ixz=\"0\" iyy=\"0.08\" iyz=\"0\" izz=\"0.06\"/></inertial></link>\n"
        .to_owned();
    for (name, x, z) in [
        ("FR", 0.2, 0.1),
        ("FL", 0.2, -0.1),
        ("RR", -0.2, 0.1),
        ("RL", -0.2, -0.1),
    ] {
        let place = [
            format!("{x} 0 {z}"),
            format!("0 0 {}", 0.5 * z),
            "0 -0.2 0".to_owned(),
        ];
        let axes = [
            ("1 0 0", -0.8, 0.8),
            ("0 0 1", -1.0, 1.8),
            ("0 0 1", -2.4, -0.6),
        ];
        let mut parent = "base".to_owned();
        for ((part, at), (axis, lower, upper)) in
            ["hip", "thigh", "calf"].into_iter().zip(place).zip(axes)
        {
            let child = format!("{name}_{part}");
            text.push_str(&format!(
                "<link name=\"{child}\"><inertial><mass value=\"0.3\"/><inertia ixx=\"0.001\" ixy=\"0\" ixz=\"0\" iyy=\"0.001\" \
                 iyz=\"0\" izz=\"0.001\"/></inertial></link>\n<joint name=\"{child}_joint\" type=\"revolute\"><parent \
                 link=\"{parent}\"/><child link=\"{child}\"/><origin xyz=\"{at}\"/><axis xyz=\"{axis}\"/><limit lower=\"{lower}\" \
                 upper=\"{upper}\" effort=\"40\" velocity=\"20\"/></joint>\n"
            ));
            parent = child;
        }
        text.push_str(&format!(
            "<link name=\"{name}_foot\"/><joint name=\"{name}_end\" type=\"fixed\"><parent link=\"{parent}\"/>\
             <child link=\"{name}_foot\"/><origin xyz=\"0 -0.2 0\"/></joint>\n"
        ));
    }
    text + "</robot>\n"
}

#[test]
fn a_quadruped_with_y_up_is_imported_and_walks_in_its_new_crate() {
    let folder = Folder::new("import-walks").file("dog.urdf", quadruped());
    let refused = folder
        .tip(&["robot", "import", "dog.urdf", "-o", "dog.toml"])
        .expect(1);
    assert!(
        refused.err.contains("import it with `--up y`"),
        "{}",
        refused.err
    );
    assert!(!folder.has("dog.toml"));
    let import = ["robot", "import", "dog.urdf", "--up", "y", "-o", "dog.toml"];
    let imported = folder.tip(&import).expect(0);
    let order = "front to rear and left before right: FL_hip_joint, FR_hip_joint, RL_hip_joint, RR_hip_joint";
    assert!(imported.err.contains(order), "{}", imported.err);
    let made = folder
        .tip(&["new", "walker", "--robot", "dog.toml"])
        .expect(0);
    let said = "and does not fall";
    assert!(made.out.contains(said), "{}", made.out);
    let program = "walker/motions/walk.prg";
    folder
        .tip(&["check", "--deny", "warnings", program])
        .expect(0);
    folder.tip(&["fmt", "--check", program]).expect(0);
    let steer = [
        "--sensor",
        "VR1=10@4s..8s",
        "--halt",
        "600",
        "--plant",
        "dynamic",
    ];
    let run = folder
        .tip(&[&["run", program][..], &steer].concat())
        .expect(0);
    assert!(run.err.contains("falls   none"), "{}", run.err);
    assert!(run.err.contains("mm forward"), "{}", run.err);
    let test = folder.read("walker/tests/walk.rs");
    assert!(
        test.contains("motion.travel.y > ") && !test.contains("<<"),
        "{test}"
    );
}

#[test]
fn a_robot_that_cannot_walk_gets_another_motion_and_is_told_why() {
    let legs: String = [[-100, 100], [100, 100], [0, -100]]
        .map(|[x, y]| format!("{{ base = [{x}, {y}, 0] }}, "))
        .concat();
    let tripod = format!(
        "name = \"tripod\"\nleg = [{legs}]\njoint = [{{ axis = \"x\", link = [0, 0, -90], limits = [-30, 30] }}]\n\
         [body]\nx = [-100, 100]\ny = [-100, 100]\nz = [-20, 20]\n"
    );
    let folder = Folder::new("new-tripod").file("tripod.toml", tripod);
    let made = folder
        .tip(&["new", "three", "--robot", "tripod.toml"])
        .expect(0);
    assert!(
        made.out
            .contains("no gait was found; the motion bends one leg after the other instead"),
        "{}",
        made.out
    );
    assert!(made.out.contains("a robot needs four legs"), "{}", made.out);
    assert!(folder.has("three/motions/bend.prg"));
}

#[test]
fn a_file_in_utf_16_is_read_and_one_in_an_unknown_encoding_named() {
    let declared = URDF.replace(
        "<robot",
        "<?xml version=\"1.0\" encoding=\"EBCDIC\"?>\n<robot",
    );
    let wide: Vec<u8> = format!("\u{feff}{}", URDF.replace("hinge", "\u{8db3}"))
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    let folder = Folder::new("import-encodings")
        .file("wide.urdf", wide)
        .file("unknown.urdf", declared);
    let imported = folder.tip(&["robot", "import", "wide.urdf"]).expect(0);
    assert!(
        imported.err.contains("F1: joint \u{8db3} to link tip"),
        "{}",
        imported.err
    );
    let refused = folder.tip(&["robot", "import", "unknown.urdf"]).expect(1);
    assert!(
        refused.err.contains("its encoding is `EBCDIC`"),
        "{}",
        refused.err
    );
}
