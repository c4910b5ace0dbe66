//! Files that are not URDF: place, reason and way out. Each is tested with a similar file that is sound.

use tip_sim::import::import;

/// A leg of one joint, which takes a line for each element.
const SOUND: &str = r#"<robot name="leg" VERSION>
<link name="base"><inertial>
<mass value="2"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
</inertial></link>
<link name="rod"><visual>
<geometry><sphere radius="1"/></geometry>
</visual></link>
<link name="tip"/>
<joint name="hinge" type="revolute">
<parent link="base"/>
<child link="rod"/>
<origin xyz="0 0 1" rpy="0 0 0"/>
<axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="2" velocity="3"/>
</joint>
<joint name="end" type="fixed"><parent link="rod"/><child link="tip"/><origin xyz="0 0 -0.5"/></joint>
</robot>
"#;

/// Returns the sound file with one text replaced, in a version of URDF.
#[track_caller]
fn file(version: &str, from: &str, to: &str) -> String {
    assert_eq!(SOUND.matches(from).count(), 1, "{from}");
    let version = format!("version=\"{version}\"");
    SOUND.replace(from, to).replace("VERSION", &version)
}

#[track_caller]
fn refused(version: &str, from: &str, to: &str, reason: &str) {
    let error = import("test.urdf", &file(version, from, to)).expect_err("it is refused");
    assert_eq!(error.to_string(), reason);
}

#[track_caller]
fn taken(version: &str, from: &str, to: &str) -> String {
    match import("test.urdf", &file(version, from, to)) {
        Ok(import) => import.toml,
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn an_attribute_that_is_missing_is_asked_for() {
    refused(
        "1.0",
        "<link name=\"tip\"/>",
        "  <link/>",
        "line 9, column 3: element `link` has no attribute `name`: write it, as `name=\"foot\"`",
    );
    refused(
        "1.0",
        " velocity=\"3\"",
        "",
        "line 15, column 1: element `limit` has no attribute `velocity`: write it, as `velocity=\"2\"`",
    );
    refused(
        "1.0",
        "<axis xyz=\"0 1 0\"/>",
        "<axis/>",
        "line 14, column 1: element `axis` has no attribute `xyz`: write it, as `xyz=\"1 0 0\"`",
    );
    taken("1.2", " velocity=\"3\"", "");
    taken("1.0", " name=\"leg\"", "");
    // Without an axis a joint turns about its x axis, which is the robot frame's y axis.
    assert!(taken("1.0", "<axis xyz=\"0 1 0\"/>", "").contains("axis = [0, 1, 0]"));
    assert!(taken("1.0", "name=\"leg\"", "name=\"leg\"").contains("axis = [-1, 0, 0]"));
}

#[test]
fn an_element_that_is_missing_is_asked_for() {
    for (line, name, example) in [
        (
            "<parent link=\"base\"/>",
            "parent",
            "<parent link=\"thigh\"/>",
        ),
        (
            "<child link=\"rod\"/>\n",
            "child",
            "<child link=\"shank\"/>",
        ),
    ] {
        let reason = format!(
            "line 10, column 1: element `joint` holds no element `{name}`: write it, as `{example}`"
        );
        refused("1.0", line, "", &reason);
    }
    refused(
        "1.0",
        "<mass value=\"2\"/>",
        "",
        "line 2, column 19: element `inertial` holds no element `mass`: write it, as `<mass value=\"1\"/>`",
    );
    taken("1.0", "<origin xyz=\"0 0 1\" rpy=\"0 0 0\"/>", "");
}

#[test]
fn an_element_stands_once() {
    refused(
        "1.0",
        "<child link=\"rod\"/>\n",
        "<child link=\"rod\"/><child link=\"tip\"/>\n",
        "line 12, column 20: element `joint` holds element `child` twice: leave one out",
    );
    taken(
        "1.0",
        "<child link=\"rod\"/>\n",
        "<child link=\"rod\"/><!-- <child link=\"tip\"/> -->\n",
    );
    // Exporters give a mesh of several parts several materials; a link has one inertia all the same.
    taken(
        "1.0",
        "</visual>",
        "<material name=\"a\"/><material name=\"a\"><color rgba=\"1 0 0 1\"/></material></visual>",
    );
    refused(
        "1.0",
        "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>\n</inertial>",
        "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>\n</inertial><inertial/>",
        "line 5, column 12: element `link` holds element `inertial` twice: leave one out",
    );
}

#[test]
fn unknown_attributes_and_elements_are_ignored() {
    let plain = taken("1.0", "name=\"leg\"", "name=\"leg\"");
    let joint = "name=\"hinge\"";
    let axis = "<axis xyz=\"0 1 0\"/>";
    for (from, to) in [
        (joint, "name=\"hinge\" mimics=\"end\""),
        (axis, "<axis xyz=\"0 1 0\"><abc>0 1 0</abc></axis>"),
    ] {
        assert_eq!(taken("1.0", from, to), plain, "{to}");
    }
    refused(
        "1.0",
        axis,
        "<axis><xyz>0 1 0</xyz></axis>",
        "line 14, column 1: element `axis` has no attribute `xyz`: write it, as `xyz=\"1 0 0\"`",
    );
}

#[test]
fn a_kind_of_joint_is_one_of_urdf() {
    refused(
        "1.0",
        "type=\"fixed\"",
        "type=\"welded\"",
        "line 17, column 19: attribute `type` of element `joint` is `welded`, which is not a kind of joint: write one of \
         revolute, continuous, prismatic, fixed, floating, planar, spherical",
    );
    taken("1.0", "type=\"revolute\"", "type=\"continuous\"");
}

#[test]
fn numbers_are_numbers() {
    refused(
        "1.0",
        "effort=\"2\"",
        "effort=\"2 Nm\"",
        "line 15, column 29: attribute `effort` of element `limit` is `2 Nm`, which is not a number: write one, as `effort=\"5\"`",
    );
    refused(
        "1.0",
        "ixx=\"1\"",
        "ixx=\"one\"",
        "line 4, column 10: attribute `ixx` of element `inertia` is `one`, which is not a number: write one, as `ixx=\"1\"`",
    );
    refused(
        "1.0",
        "0 0 1",
        "0,0,1",
        "line 13, column 9: attribute `xyz` of element `origin` is `0,0,1`, which is not 3 numbers: write them with blanks \
         between, as `xyz=\"0 0 0\"`",
    );
    taken("1.0", "effort=\"2\"", "effort=\" 2e0 \"");
    taken("1.0", "0 0 1", "0\n\t0  1.");
}

/// Imports the sound file with one text replaced, and collision geometry in place of visuals.
fn colliding(version: &str, from: &str, to: &str) -> Result<String, String> {
    let text = file(version, from, to).replace("visual>", "collision>");
    match import("test.urdf", &text) {
        Ok(import) => Ok(import.toml),
        Err(error) => Err(error.to_string()),
    }
}

#[test]
fn a_collision_geometry_is_one_shape() {
    const REASON: &str = "element `geometry` holds one shape and nothing else: write one of the elements box, cylinder, \
                          capsule, sphere, mesh";
    let sphere = "<sphere radius=\"1\"/>";
    let plain = taken("1.0", sphere, sphere);
    for (to, column) in [
        (String::new(), 1),
        ("<cone/>".to_owned(), 11),
        (format!("{sphere}{sphere}"), 31),
        (format!("ball{sphere}"), 15),
        (format!("{sphere}ball"), 31),
    ] {
        let reason = format!("line 7, column {column}: {REASON}");
        assert_eq!(colliding("1.0", sphere, &to), Err(reason));
        // Visuals are dropped anyway.
        assert_eq!(taken("1.0", sphere, &to), plain, "{to}");
    }
    assert!(
        colliding(
            "1.0",
            sphere,
            "<!-- a ball --><mesh filename=\"ball.stl\"/>"
        )
        .is_ok()
    );
}

#[test]
fn since_1_2_numbers_are_possible() {
    let radius = ("radius=\"1\"", "radius=\"0\"");
    assert_eq!(
        colliding("1.2", radius.0, radius.1),
        Err(
            "line 7, column 19: attribute `radius` of element `sphere` is `0`, and URDF 1.2 takes lengths above 0: write such, \
             as `radius=\"1\"`"
                .to_owned()
        )
    );
    assert!(colliding("1.1", radius.0, radius.1).is_ok());
    refused(
        "1.2",
        "effort=\"2\"",
        "effort=\"-2\"",
        "line 15, column 29: attribute `effort` of element `limit` is `-2`, and URDF 1.2 takes 0 or more: write such, as \
         `effort=\"5\"`",
    );
    refused(
        "1.2",
        "upper=\"1\"",
        "upper=\"-2\"",
        "line 15, column 1: attribute `upper` of element `limit` is -2, less than attribute `lower`, -1: write the smaller as \
         `lower`",
    );
    for (from, to) in [
        ("effort=\"2\"", "effort=\"-2\""),
        ("upper=\"1\"", "upper=\"-2\""),
    ] {
        taken("1.1", from, to);
    }
    taken("1.2", "upper=\"1\"", "upper=\"-1\"");
}

#[test]
fn nan_is_no_number_in_any_version() {
    for version in ["1.0", "1.1", "1.2"] {
        refused(
            version,
            "lower=\"-1\"",
            "lower=\"nan\"",
            "line 15, column 8: attribute `lower` of element `limit` is `nan`, which is not a number: write one, as \
             `lower=\"-1\"`",
        );
        refused(
            version,
            "effort=\"2\"",
            "effort=\"NaN\"",
            "line 15, column 29: attribute `effort` of element `limit` is `NaN`, which is not a number: write one, as \
             `effort=\"5\"`",
        );
    }
}

/// Returns the report of a file in a version.
fn said(version: &str, from: &str, to: &str) -> String {
    let import = import("test.urdf", &file(version, from, to));
    crate::urdf::reported(&import.unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn a_quaternion_that_does_not_count_is_reported_at_its_place() {
    let dropped = said(
        "1.0",
        "rpy=\"0 0 0\"",
        "rpy=\"0 0 0\" quat_xyzw=\"0 0 2 2\"",
    );
    let line = "dropped: `quat_xyzw`, which URDF has since 1.1, 1 times, first at line 13, column 33: write \
                `version=\"1.1\"` in `<robot>`, or `rpy`, if it is to count";
    assert!(dropped.lines().any(|it| it == line), "{dropped}");
    let counts = said("1.1", "rpy=\"0 0 0\"", "quat_xyzw=\"0 0 2 2\"");
    assert!(!counts.contains("quat_xyzw"), "{counts}");
}

#[test]
fn a_version_that_is_not_known_is_reported_with_the_one_it_is_read_as() {
    let version = |version| said(version, "name=\"leg\"", "name=\"leg\"");
    for (text, read_as) in [
        ("2.0", "1.2"),
        ("1.3", "1.2"),
        ("0.9", "1.0"),
        ("1", "1.0"),
        ("new", "1.0"),
    ] {
        let line = format!(
            "doubtful: `{text}` is no version of URDF that is known, so that the file was read as {read_as}"
        );
        let said = version(text);
        assert!(said.lines().any(|it| it == line), "{text}: {said}");
    }
    for known in ["1.0", "1.1", "1.2"] {
        assert!(!version(known).contains("version"), "{known}");
    }
}

#[test]
fn what_is_dropped_anyway_need_not_be_whole() {
    let plain = taken("1.0", "</robot>", "</robot>");
    for more in [
        "<material name=\"a\"><texture/></material>",
        "<material><color/></material>",
        "<material name=\"a\"><color rgba=\"red\"/><color/></material>",
    ] {
        assert_eq!(taken("1.0", "</robot>", &format!("{more}</robot>")), plain);
        assert_eq!(
            taken("1.0", "</visual>", &format!("{more}</visual>")),
            plain
        );
    }
    for more in [
        "<calibration rising=\"?\"/>",
        "<dynamics/><dynamics/>",
        "<safety_controller/>",
    ] {
        assert_eq!(taken("1.0", "<axis", &format!("{more}<axis")), plain);
    }
    for (version, from, to) in [
        ("1.2", "<sphere radius=\"1\"/>", "<mesh/>"),
        ("1.2", "radius=\"1\"", "radius=\"0\""),
        ("1.0", "radius=\"1\"", "radius=\"one\""),
    ] {
        assert_eq!(taken(version, from, to), plain, "{to}");
    }
    let effort = "effort=\"2\"";
    let more = "effort=\"2\" jerk=\"x\" acceleration=\"-1\"";
    assert_eq!(taken("1.2", effort, more), taken("1.2", effort, effort));
}

#[test]
fn since_1_1_a_quaternion_turns() {
    // A quarter turn about z: the axis y of the joint points back, along the robot frame's -y.
    let turned = taken("1.1", "rpy=\"0 0 0\"", "quat_xyzw=\"0 0 2 2\"");
    assert!(turned.contains("axis = [0, -1, 0]"), "{turned}");
    let ignored = taken("1.0", "rpy=\"0 0 0\"", "quat_xyzw=\"0 0 2 2\"");
    assert!(ignored.contains("axis = [-1, 0, 0]"), "{ignored}");
    // A quarter turn about y, where roll and yaw are one: it leaves the axis.
    let upright = taken("1.1", "rpy=\"0 0 0\"", "quat_xyzw=\"0 1 0 1\"");
    assert!(upright.contains("axis = [-1, 0, 0]"), "{upright}");
    refused(
        "1.1",
        "rpy=\"0 0 0\"",
        "rpy=\"0 0 0\" quat_xyzw=\"0 0 0 1\"",
        "line 13, column 1: attributes `rpy` and `quat_xyzw` of element `origin` both say how it is turned: leave one out",
    );
    refused(
        "1.1",
        "rpy=\"0 0 0\"",
        "quat_xyzw=\"0 0 x 0 1\"",
        "line 13, column 21: attribute `quat_xyzw` of element `origin` is `0 0 x 0 1`, which is not 4 numbers: write them with \
         blanks between, as `quat_xyzw=\"0 0 0 1\"`",
    );
    taken(
        "1.0",
        "rpy=\"0 0 0\"",
        "rpy=\"0 0 0\" quat_xyzw=\"0 0 0 1\"",
    );
}

#[test]
fn what_is_not_xml_is_refused_at_its_place() {
    let text = SOUND.replace("VERSION", "").replace("</robot>", "</rabot>");
    let error = import("test.urdf", &text).expect_err("it is refused");
    assert_eq!(
        error.to_string(),
        "this is neither URDF nor MJCF: expected 'robot' tag, not 'rabot' at 18:1"
    );
}

#[test]
fn a_dtd_is_refused() {
    let sound = SOUND.replace("VERSION", "");
    for dtd in [
        "<!DOCTYPE robot>",
        "<!DOCTYPE robot [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;\">]>",
        "<!DOCTYPE robot SYSTEM \"file:///etc/passwd\">",
    ] {
        let error = import("test.urdf", &format!("{dtd}\n{sound}")).expect_err("it is refused");
        assert_eq!(
            error.to_string(),
            "the file has a DTD, and entities of its own are not read: leave `<!DOCTYPE …>` out, and write what its entities \
             stand for"
        );
    }
    assert!(import("test.urdf", &format!("<!-- DOCTYPE -->\n{sound}")).is_ok());
    assert!(import("test.urdf", &sound.replace("leg", "&lt;&#65;&gt;")).is_ok());
}

#[test]
fn what_others_add_is_passed_over() {
    let plain = taken("1.0", "</robot>", "</robot>");
    let more = "<material name=\"red\"><color rgba=\"1 0 0 1\"/></material>
<transmission name=\"t\"><joint name=\"hinge\"><hardwareInterface/></joint></transmission>
<gazebo reference=\"rod\"><material>Gazebo/Red</material><link/></gazebo>
<!-- <link/> --></robot>";
    assert_eq!(taken("1.0", "</robot>", more), plain);
    let namespace = "xmlns:xacro=\"http://ros.org/wiki/xacro\" name=\"leg\"";
    assert_eq!(taken("1.0", "name=\"leg\"", namespace), plain);
    let split = "<visual><geometry><box size=\"1 1 1\"/></geometry></visual><collision><geometry><box size=\"1 1 1\"/></geometry></collision>\
                 <visual><geometry><box size=\"1 1 1\"/></geometry></visual></link>\n<joint name=\"hinge\"";
    assert_eq!(
        taken(
            "1.0",
            "<link name=\"tip\"/>\n<joint name=\"hinge\"",
            &format!("<link name=\"tip\">{split}"),
        ),
        // The tip is 500 mm below its joint.
        plain.replace(
            "torque = 2",
            "torque = 2, shape = [{ block = [1000, 1000, 1000], at = [0, 0, -500] }]"
        )
    );
    let between = "<inertial><mass value=\"0\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>\
                   <visual><geometry><box size=\"1 1 1\"/></geometry></visual>";
    let visuals = format!("</visual>{between}</link>");
    assert_eq!(taken("1.0", "</visual></link>", &visuals), plain);
}
