//! Robots that cannot be imported: names, reasons and ways out.

use crate::urdf::robots::{ARM, Joint, PLAIN, TIP, fixed, revolute, urdf};
use tip_sim::import::import;

/// Asserts that a robot of these joints is refused with these parts of a message.
#[track_caller]
fn refused(joints: &[Joint], parts: &[&str]) {
    let error = import("test.urdf", &urdf(joints))
        .expect_err("it is refused")
        .to_string();
    for part in parts {
        assert!(error.contains(part), "{error}: {part}");
    }
}

#[test]
fn what_is_no_leg_is_refused_by_name() {
    let one = || revolute("a", "base", "one", PLAIN);
    let foot = || fixed("one", "foot", TIP);
    refused(
        &[fixed("base", "one", TIP)],
        &[
            "no joint turns on link `base`",
            "one chain of revolute joints",
        ],
    );
    refused(
        &[one()],
        &["link `one` after joint `a`", "`--foot one=X,Y,Z`"],
    );
    refused(
        &[one(), foot(), fixed("one", "lamp", TIP)],
        &["ends in the links", "`foot`", "`lamp`"],
    );
    refused(
        &[
            one(),
            revolute("b", "one", "two", PLAIN),
            revolute("c", "one", "three", PLAIN),
        ],
        &[
            "branches at link `one`",
            "`b` and `c`",
            "make one of them fixed",
        ],
    );
    for kind in ["prismatic", "floating", "planar"] {
        let sliding = Joint {
            kind,
            ..revolute("b", "one", "two", PLAIN)
        };
        refused(
            &[one(), sliding, fixed("two", "foot", TIP)],
            &["joint `b` on link `one`", kind, "make it fixed"],
        );
    }
    let still = revolute("b", "one", "two", [[0.0; 3], [0.0; 3], [0.0; 3]]);
    refused(
        &[one(), still, fixed("two", "foot", TIP)],
        &["joint `b`", "length 0"],
    );
    refused(
        &[
            one(),
            foot(),
            revolute("b", "base", "two", PLAIN),
            revolute("c", "two", "three", PLAIN),
            fixed("three", "toe", TIP),
        ],
        &[
            "the leg of joint `b` has 2 joints, that of joint `a` has 1",
            "same number",
        ],
    );
}

#[test]
fn what_is_no_tree_is_refused_by_name() {
    let joint = |name, parent, child| revolute(name, parent, child, PLAIN);
    refused(
        &[joint("a", "nowhere", "one")],
        &["joint `a` names link `nowhere`"],
    );
    let text =
        urdf(&[joint("a", "base", "one")]).replace("</robot>", "<link name=\"lost\"/></robot>");
    let error = import("test.urdf", &text)
        .expect_err("two bases")
        .to_string();
    assert!(error.contains("`base` and `lost`"), "{error}");
    let circle = [joint("a", "two", "one"), joint("b", "one", "two")];
    refused(&circle, &["does not hang on the base `base`", "circle"]);
}

#[test]
fn a_name_is_given_once_to_links_and_once_to_joints() {
    let joint = |name, parent, child| revolute(name, parent, child, PLAIN);
    let whole = urdf(&[
        joint("one", "base", "one"),
        joint("two", "one", "two"),
        fixed("two", "foot", TIP),
    ]);
    assert!(
        import("test.urdf", &whole).is_ok(),
        "a link may be called as a joint"
    );
    says(
        &whole.replace("</robot>", "<link name=\"one\"/></robot>"),
        "link `one` is defined twice, at line 4, column 1 and at line 13, column 1: give each its own name",
    );
    says(
        &whole.replace("<joint name=\"two\"", "<joint name=\"one\""),
        "joint `one` is defined twice, at line 5, column 1 and at line 8, column 1: give each its own name",
    );
}

/// The parser's time grows with the square of the attributes of an element, and of what is around it.
#[test]
fn an_element_of_very_many_attributes_is_refused_before_it_is_parsed() {
    let robot = |count: usize| {
        let attributes: String = (0..count)
            .map(|number| format!(" a{number}='>\"'"))
            .collect();
        let text = urdf(ARM).replace(
            "<link name=\"base\"/>",
            &format!("<!-- <x> -->\n <link{attributes} name=\"base\"/>"),
        );
        import("wide.urdf", &text).map_err(|error| error.to_string())
    };
    assert!(robot(99).is_ok());
    let refused =
        "line 4, column 2: element `link` has more than 100 attributes: no robot needs so many";
    for count in [100, 100_000] {
        assert_eq!(robot(count).map(|_| ()), Err(refused.to_owned()), "{count}");
    }
}

#[test]
fn legs_and_joints_are_nine_at_most() {
    const NAMES: [&str; 10] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];
    const FEET: [&str; 10] = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"];
    let legs: Vec<Joint> = NAMES
        .iter()
        .zip(FEET)
        .flat_map(|(name, foot)| [revolute(name, "base", name, PLAIN), fixed(name, foot, TIP)])
        .collect();
    refused(&legs, &["10 chains", "9 legs at most"]);
    let mut parent = "base";
    let mut joints = Vec::new();
    for name in NAMES {
        joints.push(revolute(name, parent, name, PLAIN));
        parent = name;
    }
    joints.push(fixed(parent, "foot", TIP));
    refused(&joints, &["10 joints, and 9 are the most"]);
}

#[test]
fn text_that_is_no_urdf_is_refused() {
    for text in [
        "",
        "hello",
        "<robot",
        "<robot name=\"a\"><link/></robot>",
        "<robot></robot>",
        "\0\u{FFFD}",
    ] {
        assert!(import("bad.urdf", text).is_err(), "{text:?}");
    }
    let whole = urdf(ARM);
    for end in (0..whole.trim_end().len()).step_by(7) {
        assert!(
            import("cut.urdf", &whole[..end]).is_err(),
            "{}",
            &whole[..end]
        );
    }
    for number in ["nan", "inf", "1e300", "1e999", "x"] {
        let text = whole.replace("0.25 0 0.05", &format!("{number} 0 0"));
        assert!(import("huge.urdf", &text).is_err(), "{number}");
    }
}

#[track_caller]
fn says(text: &str, part: &str) {
    let error = import("bad.urdf", text).expect_err("it is refused");
    assert!(error.to_string().contains(part), "{error}");
}

#[test]
fn other_files_and_robots_of_nothing_are_named() {
    says("<sdf version=\"1.9\"/>", "the root element is `sdf`");
    says("<robot name=\"a\"/>", "the robot has no link");
    let circle = [
        revolute("a", "two", "one", PLAIN),
        revolute("b", "one", "two", PLAIN),
    ];
    let text = urdf(&circle).replace("<link name=\"base\"/>", "");
    says(&text, "no link is the base");
}

#[test]
fn numbers_that_are_none_are_shown_where_they_are() {
    let whole = urdf(ARM);
    let [origin, mass] = ["xyz=\"0.25 0 0.05\"", "value=\"2\""];
    for bad in ["nan", "inf", "-inf", "1e999"] {
        let text = whole.replace(origin, &format!("xyz=\"0.25 {bad} 0.05\""));
        says(&text, "attribute `xyz` of element `origin` is `0.25");
        let text = whole.replace(mass, &format!("value=\"{bad}\""));
        says(
            &text,
            &format!("element `mass` is `{bad}`, which is not a number"),
        );
    }
    // A number that no robot can have is shown as it was converted.
    let text = whole.replace(mass, "value=\"-20\"");
    says(
        &text,
        "it cannot be below 0; see what comes of them: `mass = -17, torque = 7 }, # shoulder`",
    );
}

/// A reader that calls itself for each level overflows its stack.
#[test]
fn elements_nested_without_end_are_refused() {
    let nested = |depth: usize| {
        let (open, close) = ("<x>".repeat(depth), "</x>".repeat(depth));
        let error = import(
            "deep.urdf",
            &format!("<robot name=\"r\">{open}{close}<link name=\"a\"/></robot>"),
        );
        error.expect_err("it has no leg").to_string()
    };
    assert!(nested(99).contains("no joint turns"), "{}", nested(99));
    assert!(
        nested(100).contains("element `x` is nested deeper than 100 levels"),
        "{}",
        nested(100)
    );
    assert_eq!(nested(100), nested(100_000));
}
