//! Figures that stand in files for want of better ones.

use crate::urdf::robots::{PLAIN, TIP, fixed, revolute, urdf};
use crate::urdf::{imported, told};

const LIMIT: &str = "lower=\"-1.5\" upper=\"2\" effort=\"7\" velocity=\"3\"";

/// A robot of one joint `a` and link `one`, whose limits are others.
fn leg(limit: &str) -> String {
    let text = urdf(&[
        revolute("a", "base", "one", PLAIN),
        fixed("one", "foot", TIP),
    ]);
    text.replace(LIMIT, limit)
}

/// What the report doubts.
fn doubts(text: &str) -> Vec<String> {
    let said = told(&imported(text).0);
    let doubts = said.lines().filter(|line| line.starts_with("doubtful: "));
    doubts.map(str::to_owned).collect()
}

#[track_caller]
fn doubted(text: &str, about: &str) {
    let doubts = doubts(text);
    assert!(
        matches!(doubts.as_slice(), [one] if one.contains(about)),
        "{doubts:?}"
    );
}

#[test]
fn sound_figures_are_not_doubted() {
    assert_eq!(doubts(&leg(LIMIT)), [""; 0]);
    let strong = "lower=\"-3.1\" upper=\"9\" effort=\"999\" velocity=\"999\"";
    assert_eq!(doubts(&leg(strong)), [""; 0]);
}

#[test]
fn efforts_that_no_motor_has_are_doubted_and_kept() {
    for effort in ["1000", "1e5"] {
        let text = leg(&LIMIT.replace("effort=\"7\"", &format!("effort=\"{effort}\"")));
        doubted(&text, "set `torque`: a");
        let kept = format!("torque = {}", effort.parse::<f64>().expect("a number"));
        assert!(imported(&text).0.toml.contains(&kept));
    }
}

#[test]
fn velocities_that_say_nothing_are_no_part_of_omega_max() {
    for velocity in ["0", "-1", "1000", "1e9"] {
        let text = leg(&LIMIT.replace("velocity=\"3\"", &format!("velocity=\"{velocity}\"")));
        doubted(&text, "set `omega_max`: a");
        assert!(!imported(&text).0.toml.contains("omega_max"), "{velocity}");
    }
    assert!(imported(&leg(LIMIT)).0.toml.contains("omega_max"));
}

#[test]
fn limits_of_half_a_turn_on_both_sides_are_doubted() {
    for (lower, upper) in [("-3.14", "3.14"), ("-10", "10"), ("-3.14159265", "9.4")] {
        let limit = format!("lower=\"{lower}\" upper=\"{upper}\" effort=\"7\" velocity=\"3\"");
        doubted(&leg(&limit), "set `limits`: a");
    }
    // Equal ones are none at all.
    let equal = leg(&LIMIT.replace("\"-1.5\"", "\"2\""));
    assert_eq!(doubts(&equal), [""; 0]);
    let said = told(&imported(&equal).0);
    assert!(
        said.contains("limits of -180 and 180 deg, for want of any: a"),
        "{said}"
    );
}

#[test]
fn masses_and_inertias_of_nothing_are_doubted() {
    let sound = leg(LIMIT);
    let light = sound.replace("<mass value=\"1\"/>", "<mass value=\"0\"/>");
    // The foot that is fixed to it weighs 2 kg.
    assert_eq!(doubts(&light), [""; 0]);
    doubted(
        &light.replace("<mass value=\"2\"/>", "<mass value=\"0\"/>"),
        "carry 0 kg; set `mass`, or the plant with mass moves motors only: a",
    );
    doubted(
        &sound.replacen("iyy=\"0.01\"", "iyy=\"0\"", 1),
        "an inertia of 0 about some axis; what moves with them is taken to be a uniform rod or box: one",
    );
}
