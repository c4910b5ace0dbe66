//! Placeholders in files: figures that no robot has.

use crate::urdf::robots::{PLAIN, TIP, fixed, revolute, urdf};
use crate::urdf::{imported, reported};

const LIMIT: &str = "lower=\"-1.5\" upper=\"2\" effort=\"7\" velocity=\"3\"";

/// Returns a robot of one joint `a` and link `one` with the given limits.
fn leg(limit: &str) -> String {
    let text = urdf(&[
        revolute("a", "base", "one", PLAIN),
        fixed("one", "foot", TIP),
    ]);
    text.replace(LIMIT, limit)
}

/// Returns the doubtful lines of the report.
fn doubts(text: &str) -> Vec<String> {
    let said = reported(&imported(text).0);
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
}

/// Returns `limits` of the description, and the report on them.
fn limited(version: &str, ends: &str) -> (Option<String>, Vec<String>) {
    let text = leg(&format!("{ends} effort=\"7\" velocity=\"3\""));
    let text = text.replace("<robot ", &format!("<robot version=\"{version}\" "));
    let (import, _) = imported(&text);
    let limits = import.toml.split_once("limits = ");
    let limits = limits.map(|(_, rest)| rest[..=rest.find(']').expect("an end")].to_owned());
    let said = reported(&import);
    let said = said
        .lines()
        .filter(|line| line.contains(": a"))
        .filter(|line| line.contains("limits") || line.contains("`lower`"));
    (limits, said.map(str::to_owned).collect())
}

/// 0.5, 1 and 1.5 rad are 28.647890 deg, 57.295780 deg and 85.943669 deg, 4 rad are 229.183118 deg.
#[test]
fn limits_that_the_file_states_are_kept_and_told_as_they_are() {
    let swapped = |name: &str| {
        format!("doubtful: `lower` is above `upper`, and the two were swapped: {name}")
    };
    let locked = |name: &str| {
        format!("locked: `lower` and `upper` are equal, and the joint stays there: {name}")
    };
    let open = |name: &str| {
        format!(
            "assumed: one end of the limits, which is not stated or infinite; the other one is kept: {name}"
        )
    };
    for (version, ends, limits, line) in [
        (
            "1.0",
            "lower=\"-1.5\" upper=\"1\"",
            "[-85.943669, 57.29578]",
            None,
        ),
        (
            "1.0",
            "lower=\"1\" upper=\"-1.5\"",
            "[-85.943669, 57.29578]",
            Some(swapped("a [-85.943669, 57.29578]")),
        ),
        (
            "1.0",
            "lower=\"1\" upper=\"1\"",
            "[57.29578, 57.29578]",
            Some(locked("a [57.29578, 57.29578]")),
        ),
        (
            "1.2",
            "lower=\"0\" upper=\"0\"",
            "[0, 0]",
            Some(locked("a [0, 0]")),
        ),
        // What is not stated is 0 before 1.2, if that is on the right side, and without limit since 1.2.
        (
            "1.0",
            "lower=\"-1\"",
            "[-57.29578, 0]",
            Some(open("a [-57.29578, 0]")),
        ),
        (
            "1.1",
            "upper=\"1\"",
            "[0, 57.29578]",
            Some(open("a [0, 57.29578]")),
        ),
        (
            "1.0",
            "lower=\"0.5\"",
            "[28.64789, 180]",
            Some(open("a [28.64789, 180]")),
        ),
        (
            "1.0",
            "upper=\"-0.5\"",
            "[-180, -28.64789]",
            Some(open("a [-180, -28.64789]")),
        ),
        (
            "1.2",
            "lower=\"-1\"",
            "[-57.29578, 180]",
            Some(open("a [-57.29578, 180]")),
        ),
        (
            "1.2",
            "upper=\"1\"",
            "[-180, 57.29578]",
            Some(open("a [-180, 57.29578]")),
        ),
        (
            "1.0",
            "lower=\"-1\" upper=\"inf\"",
            "[-57.29578, 180]",
            Some(open("a [-57.29578, 180]")),
        ),
        (
            "1.0",
            "lower=\"-inf\" upper=\"1\"",
            "[-180, 57.29578]",
            Some(open("a [-180, 57.29578]")),
        ),
        // A whole turn from an end that is beyond half a turn.
        (
            "1.2",
            "lower=\"4\"",
            "[229.183118, 589.183118]",
            Some(open("a [229.183118, 589.183118]")),
        ),
        (
            "1.2",
            "upper=\"-4\"",
            "[-589.183118, -229.183118]",
            Some(open("a [-589.183118, -229.183118]")),
        ),
        (
            "1.0",
            "lower=\"inf\" upper=\"1\"",
            "[57.29578, 180]",
            Some(swapped("a [57.29578, 180]")),
        ),
    ] {
        let (found, said) = limited(version, ends);
        assert_eq!(found.as_deref(), Some(limits), "{version}: {ends}");
        assert_eq!(said, Vec::from_iter(line), "{version}: {ends}");
    }
}

#[test]
fn joints_that_turn_all_round_do_so_for_a_reason_that_is_told() {
    let none = "assumed: limits of -180 and 180 deg, since the file gives none: a";
    let infinite = "assumed: limits of -180 and 180 deg in place of infinite ones: a";
    for (version, ends, line) in [
        ("1.0", "", none),
        ("1.2", "", none),
        ("1.0", "lower=\"-inf\" upper=\"inf\"", infinite),
        ("1.0", "lower=\"-INF\" upper=\"1e999\"", infinite),
        ("1.2", "lower=\"-inf\"", infinite),
    ] {
        assert_eq!(
            limited(version, ends),
            (None, vec![line.to_owned()]),
            "{version}: {ends}"
        );
    }
    let turns = leg(LIMIT).replace("type=\"revolute\"", "type=\"continuous\"");
    let said = reported(&imported(&turns).0);
    let line = "dropped: what continuous joints say of `lower` and `upper`, since they turn without end; their limits are -180 \
                and 180 deg: a";
    assert!(said.lines().any(|it| it == line), "{said}");
    assert!(!said.contains("since the file gives none"), "{said}");
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
        "an inertia of 0 about some axis; they count as point masses, and where they are most of the mass that moves as one, its inertia is that of a uniform rod or box: one",
    );
}
