//! Tables of runs.

use tip_sim::{Events, Robot, tipc};
use tip_view::{DurationLimit, FrameRate, Recording};

const TEXT: &str = "3.1\nTable\nDEF_VAR COUNT\nCOUNT = 1\nMESSAGE one, \"two\"\nLAMP_ON 2\nREL_PTP_ANGLE HS J11 1\nCOUNT = 2\nREM\nEND\n";

fn table(every: u64) -> Vec<Vec<String>> {
    rows(&record(TEXT, every))
}

fn record(text: &str, every: u64) -> Recording {
    let robot = Robot::named("titan8").expect("it has a name");
    let loaded = tipc::load("test.prg", text.as_bytes(), &robot.options());
    let (extent, pace) = (DurationLimit::cycles(100), FrameRate::Every(every));
    let recording = Recording::paced(&loaded, &robot, &Events::NONE, extent, pace, || true);
    recording.expect("it runs")
}

fn rows(recording: &Recording) -> Vec<Vec<String>> {
    let mut bytes = Vec::new();
    tip_log::csv(recording, &mut bytes).expect("memory takes it");
    let text = String::from_utf8(bytes).expect("it is UTF-8");
    assert!(text.ends_with("\r\n"));
    text.lines().map(split).collect()
}

/// The fields of a line, after RFC 4180.
fn split(line: &str) -> Vec<String> {
    let (mut fields, mut quoted) = (vec![String::new()], false);
    let mut characters = line.chars().peekable();
    while let Some(character) = characters.next() {
        let field = fields.last_mut().expect("one at least");
        match character {
            '"' if quoted && characters.next_if_eq(&'"').is_some() => field.push('"'),
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(String::new()),
            other => field.push(other),
        }
    }
    fields
}

fn column(table: &[Vec<String>], name: &str) -> Vec<String> {
    let place = table[0].iter().position(|known| known == name);
    let place = place.unwrap_or_else(|| panic!("{name} is none of {:?}", table[0]));
    table[1..].iter().map(|row| row[place].clone()).collect()
}

#[test]
fn each_cycle_is_a_row_of_figures_with_units() {
    let table = table(1);
    assert!(
        table.iter().all(|row| row.len() == table[0].len()),
        "{table:?}"
    );
    assert_eq!(column(&table, "cycle"), ["0", "1", "2", "3", "4", "5", "6"]);
    // At the end of each cycle of 20 ms.
    assert_eq!(column(&table, "time_ms")[..2], ["20", "40"]);
    assert_eq!(column(&table, "line"), ["4", "5", "6", "7", "8", "9", "10"]);
    assert_eq!(column(&table, "COUNT"), ["1", "1", "1", "1", "2", "2", "2"]);
    assert_eq!(column(&table, "message")[..2], ["", "one, \"two\""]);
    assert_eq!(column(&table, "lamps")[1..3], ["", "2"]);
    assert_eq!(
        column(&table, "command")[2..5],
        ["", "REL_PTP_ANGLE HS J11 1.0", ""]
    );
    // It stands on its belly at first, 200 mm below its middle, and sinks a little.
    let height: Vec<f64> = column(&table, "z_mm")
        .iter()
        .map(|z| z.parse().expect("a number"))
        .collect();
    assert!((height[0] - 200.0).abs() < 1.0, "{height:?}");
    assert_eq!(column(&table, "J13_deg")[0], "90");
    assert_eq!(
        column(&table, "F2_x_mm")[0].parse::<f64>().map(f64::round),
        Ok(391.0)
    );
    for name in ["J43_Nm", "F4_N", "margin_mm", "falls", "flags", "yaw_deg"] {
        column(&table, name);
    }
}

#[test]
fn rows_may_be_farther_apart() {
    let table = table(3);
    assert_eq!(column(&table, "cycle"), ["0", "3", "6"]);
    // What the program shows stays; what it asked for between two rows is the last of it.
    assert_eq!(
        column(&table, "message")[1..],
        ["one, \"two\"", "one, \"two\""]
    );
    assert_eq!(
        column(&table, "command"),
        ["", "REL_PTP_ANGLE HS J11 1.0", ""]
    );
    assert_eq!(column(&table, "COUNT"), ["1", "1", "2"]);
}

#[test]
fn no_text_is_a_formula_and_each_figure_is_a_number() {
    let said = [
        ("=1+1", "'=1+1"),
        ("+A1", "'+A1"),
        ("-1+A1", "'-1+A1"),
        ("@SUM(A1)", "'@SUM(A1)"),
        ("-inf", "'-inf"),
        ("-0.5", "-0.5"),
        ("+3", "+3"),
        ("a=1", "a=1"),
        ("'=1", "'=1"),
    ];
    let lines: String = said
        .iter()
        .map(|(text, _)| format!("MESSAGE {text}\n"))
        .collect();
    let mut recording = record(&format!("3.1\nt\n{lines}END\n"), 1);
    recording.frames[1].angles[0] = vec![f64::NAN, f64::INFINITY, -0.5];
    let table = rows(&recording);
    let expected: Vec<_> = said.iter().map(|(_, shown)| *shown).collect();
    assert_eq!(column(&table, "message")[..said.len()], expected);
    let joints = ["J11_deg", "J12_deg", "J13_deg"].map(|name| column(&table, name)[1].clone());
    assert_eq!(joints, ["", "", "-0.5"]);
}
