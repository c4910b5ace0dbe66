//! Which chains become legs, in which order, and where they end.

use crate::urdf::robots::{Joint, PLAIN, TIP, fixed, quadruped, revolute, urdf};
use tip_sim::import::{Foot, Import, ImportOptions, Up, import_with};

fn words(words: &[&str]) -> Vec<String> {
    words.iter().copied().map(str::to_owned).collect()
}

/// Of feet, chains to skip, and chains in order.
fn options([feet, skip, order]: [&[&str]; 3]) -> ImportOptions {
    ImportOptions {
        feet: feet.iter().copied().map(Foot::from).collect(),
        skip: words(skip),
        order: words(order),
        up: None,
        stand: None,
        ..ImportOptions::default()
    }
}

#[track_caller]
fn taken(joints: &[Joint], chosen: [&[&str]; 3]) -> Import {
    let import = import_with("test.urdf", &urdf(joints), &options(chosen));
    import.unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn refused(joints: &[Joint], chosen: [&[&str]; 3], parts: &[&str]) {
    let import = import_with("test.urdf", &urdf(joints), &options(chosen));
    let error = import.expect_err("it is refused").to_string();
    for part in parts {
        assert!(error.contains(part), "{error}: {part}");
    }
}

/// From which joint to which link each leg goes.
fn legs(import: &Import) -> Vec<String> {
    let legs = import.toml.lines();
    let legs = legs.filter_map(|line| line.strip_prefix("[[leg]] # "));
    legs.map(str::to_owned).collect()
}

/// Two legs, and a head without a foot.
fn animal() -> Vec<Joint> {
    vec![
        revolute("head_pan_joint", "base", "head", PLAIN),
        revolute("front_left_hip", "base", "fl_thigh", PLAIN),
        fixed("fl_thigh", "fl_toe", TIP),
        revolute("front_right_hip", "base", "fr_thigh", PLAIN),
        fixed("fr_thigh", "fr_toe", TIP),
    ]
}

#[test]
fn chains_that_are_skipped_are_no_legs() {
    // As it is, its head has no foot.
    refused(
        &animal(),
        [&[], &[], &[]],
        &[
            "link `head`",
            "leave the chain out with `--skip head_pan_joint`",
        ],
    );
    for name in ["head_pan_joint", "head", "pan", "HEAD-PAN"] {
        let import = taken(&animal(), [&[], &[name], &[]]);
        let expected = [
            "F1: joint front_left_hip to link fl_toe",
            "F2: joint front_right_hip to link fr_toe",
        ];
        assert_eq!(legs(&import), expected, "{name}");
        let said: Vec<String> = import.report.iter().map(ToString::to_string).collect();
        let line = "left out, as asked: the chains of head_pan_joint, which weigh 1 kg";
        assert!(said.iter().any(|it| it == line), "{said:?}");
    }
    let all = ["head", "front_left", "front_right"];
    refused(&animal(), [&[], &all, &[]], &["every chain is left out"]);
}

#[test]
fn chains_become_legs_in_the_order_that_is_asked_for() {
    let import = taken(&animal(), [&[], &["head"], &["front_right", "fl_toe"]]);
    let expected = [
        "F1: joint front_right_hip to link fr_toe",
        "F2: joint front_left_hip to link fl_toe",
    ];
    assert_eq!(legs(&import), expected);
    let order = ["h4", "h3", "h2", "h1"];
    let import = taken(&quadruped(), [&[], &[], &order]);
    assert_eq!(legs(&import)[0], "F1: joint h4 to link e4");
    assert_eq!(legs(&import)[3], "F4: joint h1 to link e1");
    refused(
        &quadruped(),
        [&[], &[], &["h4", "h3"]],
        &["the order lacks the chains of h1, h2"],
    );
    refused(
        &quadruped(),
        [&[], &[], &["h4", "e4", "h2", "h1"]],
        &["`e4` names the chain of joint `h4` for the second time"],
    );
}

#[test]
fn names_of_no_chain_and_of_several_are_refused_with_those_that_there_are() {
    for chosen in [[&[][..], &["tail"], &[]], [&[], &["head"], &["tail"]]] {
        refused(
            &animal(),
            chosen,
            &[
                "no chain is called `tail`",
                "the first joints are head_pan_joint, front_left_hip, front_right_hip",
            ],
        );
    }
    for word in ["front", "hip"] {
        refused(
            &animal(),
            [&[], &[word], &[]],
            &["is in the names of several chains: front_left_hip, front_right_hip"],
        );
    }
    // A part of a word is no word.
    refused(
        &animal(),
        [&[], &["hea"], &[]],
        &["no chain is called `hea`"],
    );
}

#[test]
fn a_foot_that_is_chosen_ends_its_chain() {
    let mut two = animal();
    two.push(fixed("fr_thigh", "lamp", TIP));
    refused(
        &two,
        [&[], &["head"], &[]],
        &["`fr_toe`", "`lamp`", "with `--foot`"],
    );
    let import = taken(&two, [&["fr_toe"], &["head"], &[]]);
    assert_eq!(legs(&import)[1], "F2: joint front_right_hip to link fr_toe");

    // A gripper after the foot: neither its joint nor its link is of the leg.
    let mut grips = animal();
    grips.push(revolute("grip", "fr_toe", "finger", PLAIN));
    refused(
        &grips,
        [&[], &["head"], &[]],
        &["link `finger` after joint `grip`"],
    );
    let import = taken(&grips, [&["fr_toe"], &["head"], &[]]);
    assert_eq!(legs(&import)[1], "F2: joint front_right_hip to link fr_toe");
    assert!(!import.toml.contains("# grip"), "{}", import.toml);

    for no_foot in ["fr_tow", "base", "head"] {
        refused(
            &animal(),
            [&[no_foot], &["head"], &[]],
            &[no_foot, "ends no leg", "fl_toe, fr_toe"],
        );
    }
}

/// A quadruped whose last links have no links on them, and what its feet are at.
fn footless(feet: &[Foot]) -> Result<Import, String> {
    let mut joints = quadruped();
    joints.retain(|joint| !joint.child.starts_with('e'));
    let options = ImportOptions {
        feet: feet.to_vec(),
        ..ImportOptions::default()
    };
    import_with("test.urdf", &urdf(&joints), &options).map_err(|error| error.to_string())
}

#[test]
fn a_place_on_the_last_link_is_as_good_as_a_link_there() {
    let whole = taken(&quadruped(), [&[], &[], &[]]);
    let at = quadruped();
    let at = at.iter().find(|joint| joint.child == "e1").expect("a foot");
    let feet = ["s1", "s2", "s3", "s4"].map(|link| Foot {
        link: link.to_owned(),
        at: at.xyz,
    });
    let placed = footless(&feet).unwrap_or_else(|error| panic!("{error}"));
    let links = |import: &Import| -> Vec<String> {
        let lines = import.toml.lines();
        let links = lines.filter_map(|line| Some(line.split_once("link = ")?.1));
        links
            .map(|link| link[..=link.find(']').expect("an end")].to_owned())
            .collect()
    };
    assert_eq!(links(&placed), links(&whole));
    assert_eq!(links(&placed).len(), 12);
    let end = format!("to link {}", feet[0]);
    assert!(legs(&placed)[0].ends_with(&end), "{end}");
}

#[test]
fn a_leg_without_foot_is_refused_with_the_option_that_says_where_it_is() {
    let error = footless(&[]).expect_err("no feet");
    assert!(error.contains("link `s1` after joint `k1`"), "{error}");
    assert!(error.contains("`--foot s1=X,Y,Z`"), "{error}");
    // Three of four are not enough.
    let feet = ["s1", "s2", "s3"].map(Foot::from);
    let error = footless(&feet).expect_err("one is missing");
    assert!(error.contains("`--foot s4=X,Y,Z`"), "{error}");
    let feet = ["s1", "s2", "s3", "s4", "s2"].map(Foot::from);
    let error = footless(&feet).expect_err("one is there twice");
    assert!(error.contains("names link `s2` twice"), "{error}");
}

/// A leg at a place of the root link: a joint, its link and its foot.
fn placed(name: [&'static str; 3], at: [f64; 3], foot: [f64; 3]) -> [Joint; 2] {
    let [joint, link, end] = name;
    [
        revolute(joint, "base", link, [at, [0.0; 3], [1.0, 0.0, 0.0]]),
        fixed(link, end, [foot, [0.0; 3]]),
    ]
}

const LEGS: [[&str; 3]; 6] = [
    ["a", "al", "af"],
    ["b", "bl", "bf"],
    ["c", "cl", "cf"],
    ["d", "dl", "df"],
    ["e", "el", "ef"],
    ["f", "fl", "ff"],
];

/// Returns the first joints of the legs in their order, and the lines of the report on the order.
fn ordered(places: &[[f64; 2]]) -> (String, Vec<String>) {
    let legs = LEGS.into_iter().zip(places);
    let joints = legs.flat_map(|(name, [x, y])| placed(name, [*x, *y, 0.0], [0.0, 0.0, -0.2]));
    let joints: Vec<Joint> = joints.collect();
    let import = taken(&joints, [&[], &[], &[]]);
    let names: Vec<String> = legs_of(&import);
    let said = import.report.iter().map(ToString::to_string);
    (
        names.join(" "),
        said.filter(|line| line.contains("`--order`")).collect(),
    )
}

fn legs_of(import: &Import) -> Vec<String> {
    let name = |line: &String| line.split(' ').nth(2).unwrap_or_default().to_owned();
    legs(import).iter().map(name).collect()
}

/// x is forward and y to the left.
#[test]
fn legs_are_numbered_from_front_to_rear_and_left_before_right() {
    let by_place = |joints: &str| {
        vec![format!(
            "the legs are numbered by where they are, from front to rear and left before right: {joints}; `--order` chooses \
             another order"
        )]
    };
    // Front right first, as some files have it.
    let fr_first = [[0.2, -0.1], [0.2, 0.1], [-0.2, -0.1], [-0.2, 0.1]];
    assert_eq!(
        ordered(&fr_first),
        ("b a d c".to_owned(), by_place("b, a, d, c"))
    );
    // Rear legs first, sides that are not quite side by side, and a middle that is not at y = 0.
    let askew = [[-0.2, 0.4], [-0.17, 0.6], [0.2, 0.4], [0.15, 0.6]];
    assert_eq!(
        ordered(&askew),
        ("d c b a".to_owned(), by_place("d, c, b, a"))
    );
    let hexapod = [
        [0.0, -0.2],
        [-0.2, -0.1],
        [0.2, -0.1],
        [0.0, 0.2],
        [-0.2, 0.1],
        [0.2, 0.1],
    ];
    assert_eq!(ordered(&hexapod).0, "f c d a e b");
    // One leg ahead and one behind, as in a star.
    let star = [
        [-0.2, 0.0],
        [0.1, 0.17],
        [0.1, -0.17],
        [0.2, 0.0],
        [-0.1, 0.17],
        [-0.1, -0.17],
    ];
    assert_eq!(ordered(&star).0, "d b c e f a");
    let five = [
        [-0.1, -0.1],
        [-0.1, 0.1],
        [0.1, -0.1],
        [0.1, 0.1],
        [0.2, 0.0],
    ];
    assert_eq!(ordered(&five).0, "e d c b a");
}

#[test]
fn an_order_that_places_do_not_tell_is_that_of_the_file() {
    // All first joints are at one place; the feet are as well.
    let (order, said) = ordered(&[[0.0, 0.0]; 4]);
    assert_eq!(order, "a b c d");
    let line = "doubtful: where the legs are does not tell front from rear and left from right, so that they are numbered in the \
                order of the file: a, b, c, d; say it with `--order`";
    assert_eq!(said, [line]);
    // Feet tell it where first joints do not.
    let feet = [[0.2, -0.1], [0.2, 0.1], [-0.2, -0.1], [-0.2, 0.1]];
    let joints: Vec<Joint> = LEGS
        .into_iter()
        .zip(feet)
        .flat_map(|(name, [x, y])| placed(name, [0.0; 3], [x, y, -0.2]))
        .collect();
    assert_eq!(
        legs_of(&taken(&joints, [&[], &[], &[]])),
        ["b", "a", "d", "c"]
    );
    // An order that is asked for needs no word.
    let asked = taken(&joints, [&[], &[], &["c", "a", "b", "d"]]);
    assert_eq!(legs_of(&asked), ["c", "a", "b", "d"]);
    let said: Vec<String> = asked.report.iter().map(ToString::to_string).collect();
    assert!(
        !said.iter().any(|line| line.contains("--order")),
        "{said:?}"
    );
}

/// Files with another axis up, made of the one with z up: legs, limits and all are those of that one.
#[test]
fn a_robot_that_lies_on_its_side_is_refused_until_it_is_said_what_is_up() {
    let places = [
        [0.2, 0.1, 0.0],
        [0.2, -0.1, 0.0],
        [-0.2, 0.1, 0.0],
        [-0.2, -0.1, 0.0],
    ];
    // Forward, left and up as the file has them.
    let upright: fn([f64; 3]) -> [f64; 3] = |all| all;
    let y_up: fn([f64; 3]) -> [f64; 3] = |[forward, left, up]| [forward, up, -left];
    let x_up: fn([f64; 3]) -> [f64; 3] = |[forward, left, up]| [up, left, -forward];
    let robot = |turned: fn([f64; 3]) -> [f64; 3], up: Option<Up>| {
        let legs = LEGS.into_iter().zip(places).flat_map(|(name, at)| {
            let [joint, link, end] = name;
            [
                revolute(
                    joint,
                    "base",
                    link,
                    [turned(at), [0.0; 3], turned([0.0, 1.0, 0.0])],
                ),
                fixed(link, end, [turned([0.0, 0.0, -0.2]), [0.0; 3]]),
            ]
        });
        let joints: Vec<Joint> = legs.collect();
        let options = ImportOptions {
            up,
            ..ImportOptions::default()
        };
        import_with("test.urdf", &urdf(&joints), &options).map_err(|error| error.to_string())
    };
    let kinematics = |import: Result<Import, String>| -> Vec<String> {
        let toml = import.unwrap_or_else(|error| panic!("{error}")).toml;
        let lines = toml.lines().filter(|line| {
            ["base", "    {", "x", "y", "z"]
                .iter()
                .any(|start| line.starts_with(start))
        });
        lines
            .map(|line| line.split(", mass").next().unwrap_or_default().to_owned())
            .collect()
    };
    let stands = kinematics(robot(upright, None));
    assert_eq!(stands[0], "base = [-100, 200, 0]");
    assert_eq!(kinematics(robot(y_up, Some(Up::Y))), stands);
    assert_eq!(kinematics(robot(x_up, Some(Up::X))), stands);
    for (turned, up) in [(y_up, "y"), (x_up, "x")] {
        let error = robot(turned, None).expect_err("it lies on its side");
        let reason = format!(
            "the first joints of all legs are in one upright plane, so that the robot lies on its side: import it with `--up {up}` \
             if {up} is up in the file, or with `--up z` if it really is like that"
        );
        assert_eq!(error, reason);
        // If it really is, no size is 0.
        let import = robot(turned, Some(Up::Z)).unwrap_or_else(|error| panic!("{error}"));
        let axis = if up == "y" { "x" } else { "y" };
        assert!(
            import.toml.contains(&format!("\n{axis} = [-50, 50]\n")),
            "{}",
            import.toml
        );
        let said: Vec<String> = import.report.iter().map(ToString::to_string).collect();
        let line = format!(
            "doubtful: the first joints are in one plane, and the body is taken to be 100 mm thick there: set `{axis}`"
        );
        assert!(said.contains(&line), "{said:?}");
    }
}
