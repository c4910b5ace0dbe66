//! Diagrams of runs.

use std::fs;
use std::path::Path;
use tip_log::{Diagram, plot};
use tip_runtime::plant::Scene;
use tip_sim::tipc::message::Lang;
use tip_sim::{Events, Robot, tipc};
use tip_view::{DurationLimit, Recording};

fn record(path: &str, robot: &Robot) -> Recording {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let text = fs::read(root.join(path)).expect("the example is there");
    let loaded = tipc::load("test.prg", &text, &robot.options());
    Recording::of(
        &loaded,
        robot,
        &Events::NONE,
        DurationLimit::cycles(1000),
        || true,
    )
    .expect("it runs")
}

fn walk() -> Recording {
    let robot = Robot::named("titan8").expect("it has a name");
    record("walk/motions/walk.prg", &robot)
}

fn grasp() -> Recording {
    let hand = Robot::named("hand").expect("it has a name");
    let hand = hand.with_scene(&Scene::CYLINDER).expect("it grasps");
    record("grasp/motions/grasp.prg", &hand)
}

fn texts(svg: &str) -> Vec<&str> {
    let after = svg.split("<text").skip(1);
    let inside = after.filter_map(|text| text.split_once('>')?.1.split("</text>").next());
    inside.map(str::trim).collect()
}

#[test]
fn each_diagram_says_what_it_shows_and_in_which_unit() {
    let svg = plot(&walk(), &Diagram::ALL, Lang::English).expect("it moved");
    let texts = texts(&svg);
    for text in [
        "Gait diagram: feet on the ground",
        "Foot paths from above (world)",
        "Angle of joint 3 of each leg",
        "Torque of joint 1 of each leg",
        "Load on each foot",
        "time [s]",
        "x [mm]",
        "z [mm]",
        "angle [deg]",
        "torque [N·m]",
        "force [N]",
        "F4",
    ] {
        assert!(texts.contains(&text), "{text}: {texts:?}");
    }
}

#[test]
fn a_hand_has_fingers_and_japanese_titles() {
    let svg = plot(&grasp(), &Diagram::ALL, Lang::Japanese).expect("it moved");
    let texts = texts(&svg);
    for text in [
        "指先軌跡",
        "各指の第2関節の角度",
        "各指先の力",
        "時間 [s]",
        "トルク [mN·m]",
    ] {
        assert!(texts.contains(&text), "{text}: {texts:?}");
    }
}

#[test]
fn only_what_is_asked_for_is_drawn_in_its_order() {
    let wanted = [Diagram::Forces, Diagram::Gait];
    let svg = plot(&walk(), &wanted, Lang::English).expect("it moved");
    let texts = texts(&svg);
    let place = |text| texts.iter().position(|known| *known == text);
    assert!(place("Gait diagram: feet on the ground") < place("Load on each foot"));
    assert_eq!(place("Angle of joint 1 of each leg"), None);
    assert!(
        plot(&walk(), &[], Lang::English).is_err(),
        "nothing is asked for"
    );
}

#[test]
fn colours_follow_the_ground_of_the_reader() {
    let svg = plot(&walk(), &[Diagram::Gait], Lang::English).expect("it moved");
    assert!(svg.contains("@media (prefers-color-scheme: dark)"));
    let (style, drawing) = svg.split_once("</style>").expect("a style");
    for part in drawing
        .split(['"', ' '])
        .filter(|part| part.starts_with('#') && part.len() == 7)
    {
        assert!(
            style.contains(&format!("\"{part}\"")),
            "{part} has a dark counterpart"
        );
    }
    // Quotes in the heading of a program do not end an attribute, and the file is one element.
    assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"));
    assert_eq!(
        svg,
        plot(&walk(), &[Diagram::Gait], Lang::English).expect("the same")
    );
}

#[test]
fn what_xml_cannot_hold_is_not_in_a_diagram() {
    let text = "3.1\na\u{1}b\u{1b}[31m<c>\u{fffe}&\u{ffff}\nSLEEP 100\nEND\n";
    let robot = Robot::named("titan8").expect("it has a name");
    let loaded = tipc::load("t.prg", text.as_bytes(), &robot.options());
    let recording = Recording::of(
        &loaded,
        &robot,
        &Events::NONE,
        DurationLimit::cycles(9),
        || true,
    );
    let recording = recording.expect("it runs");
    let svg = plot(&recording, &Diagram::ALL, Lang::English).expect("it stood");
    let is_char = |c: char| matches!(c, '\t' | '\n' | '\r' | ' '..='\u{fffd}' | '\u{10000}'..);
    assert!(svg.chars().all(is_char));
    assert!(
        svg.contains("a\u{fffd}b\u{fffd}[31m&lt;c&gt;\u{fffd}&amp;\u{fffd}"),
        "{svg:.600}"
    );
    let page = recording.to_page();
    let title = page.split("</title>").next().expect("a title");
    assert!(title.chars().all(is_char), "{title:.200}");
}

#[test]
fn legs_have_the_colours_of_the_page() {
    let css = Path::new(env!("CARGO_MANIFEST_DIR")).join("../view/page/src/style.css");
    let css = fs::read_to_string(css).expect("the styles of the page");
    let svg = plot(&walk(), &[Diagram::Gait], Lang::English).expect("it moved");
    for leg in 1..=9 {
        let name = format!("--leg-{leg}: #");
        let values: Vec<String> = css
            .split(&name)
            .skip(1)
            .map(|rest| rest[..6].to_uppercase())
            .collect();
        let [light, dark] = values.as_slice() else {
            panic!("{name} is there in two schemes: {values:?}");
        };
        let rule = format!("[fill=\"#{light}\"]{{fill:#{dark}}}");
        assert!(svg.contains(&rule), "{rule}");
    }
}
