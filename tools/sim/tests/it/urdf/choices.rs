//! Which chains become legs, in which order, and where they end.

use crate::urdf::robots::{Joint, PLAIN, TIP, fixed, quadruped, revolute, urdf};
use tip_sim::urdf::{Choices, Foot, Import, import_with};

fn words(words: &[&str]) -> Vec<String> {
    words.iter().copied().map(str::to_owned).collect()
}

/// Of feet, chains to skip, and chains in order.
fn choices([feet, skip, order]: [&[&str]; 3]) -> Choices {
    Choices {
        feet: feet.iter().copied().map(Foot::from).collect(),
        skip: words(skip),
        order: words(order),
        stand: None,
    }
}

#[track_caller]
fn taken(joints: &[Joint], chosen: [&[&str]; 3]) -> Import {
    let import = import_with("test.urdf", &urdf(joints), &choices(chosen));
    import.unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn refused(joints: &[Joint], chosen: [&[&str]; 3], parts: &[&str]) {
    let import = import_with("test.urdf", &urdf(joints), &choices(chosen));
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
        let line = "left out, as asked: the chains of head_pan_joint";
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
    let choices = Choices {
        feet: feet.to_vec(),
        ..Choices::default()
    };
    import_with("test.urdf", &urdf(&joints), &choices).map_err(|error| error.to_string())
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
