//! Xacro, and what only looks like it.

use crate::urdf::robots::{ARM, urdf};
use tip_sim::import::import;

const NAMESPACE: &str = "xmlns:xacro=\"http://www.ros.org/wiki/xacro\"";

/// The arm with a text put in before the end, on a line of its own.
fn arm(namespace: &str, before_end: &str) -> String {
    let text = urdf(ARM).replace("<robot", &format!("<robot {namespace}"));
    text.replace("</robot>", &format!("{before_end}\n</robot>"))
}

#[track_caller]
fn is_xacro(text: &str, column: usize) {
    let line = text.lines().count() - 1;
    let error = import("arm.urdf", text).expect_err("xacro").to_string();
    let expected = format!(
        "line {line}, column {column}: this is xacro, of which URDF is made: expand it first, as `xacro robot.xacro > \
         robot.urdf` (the tool comes with ROS, and by `pip install xacro`)"
    );
    assert_eq!(error, expected);
}

#[test]
fn elements_and_expressions_of_xacro_are_refused_with_what_expands_them() {
    for element in [
        "<xacro:property name=\"a\" value=\"1\"/>",
        "<xacro:include filename=\"leg.xacro\"/>",
    ] {
        is_xacro(&arm(NAMESPACE, element), 1);
        // Its namespace is not declared, as in a part that was cut out.
        is_xacro(&arm("", element), 1);
    }
    is_xacro(&arm(NAMESPACE, "<link name=\"${side}_foot\"/>"), 7);
}

#[test]
fn what_xacro_left_in_expanded_files_is_no_xacro() {
    for (namespace, last) in [
        (NAMESPACE, ""),
        (
            NAMESPACE,
            "<!-- <xacro:include filename=\"leg.xacro\"/> -->",
        ),
        ("", "<material name=\"5$ {grey}\"/>"),
        ("", "<xacro/>"),
    ] {
        import("arm.urdf", &arm(namespace, last)).unwrap_or_else(|error| panic!("{error}"));
    }
    // Another namespace that is not declared is no URDF.
    let other = import("arm.urdf", &arm("", "<ros:node/>")).expect_err("unknown");
    assert!(
        other
            .to_string()
            .starts_with("this is neither URDF nor MJCF"),
        "{other}"
    );
}
