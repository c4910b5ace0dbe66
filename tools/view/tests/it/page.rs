//! Contents of a page.

use base64::Engine as _;
use serde_json::{Value, json};
use tip_sim::{Events, Robot, tipc};
use tip_view::{DurationLimit, Occurrence, Recording, SweepTable, sweep_page};

fn record(text: &str) -> Recording {
    let robot = Robot::named("titan8").expect("it has a name");
    let loaded = tipc::load("folder/x<y>.prg", text.as_bytes(), &robot.options());
    assert!(loaded.program.is_some(), "{:?}", loaded.diagnostics);
    let events: Events = "3:key F, 4:halt".parse().expect("events");
    Recording::of(&loaded, &robot, &events, DurationLimit::cycles(500), || {
        true
    })
    .expect("it runs")
}

/// The updates as they are packed.
fn unpacked(recording: &Recording) -> Vec<Value> {
    lines(&recording.packed())
}

fn lines(packed: &[u8]) -> Vec<Value> {
    let bytes = miniz_oxide::inflate::decompress_to_vec(packed).expect("deflated");
    let text = String::from_utf8(bytes).expect("UTF-8");
    let updates = text.lines().map(serde_json::from_str);
    updates.collect::<Result<_, _>>().expect("JSON")
}

const WALKS: &str = "3.1\nWalks\nDEF_VAR HEIGHT\nHEIGHT = 0.1\nSTAND_UP 60\nWAIT_INPOS ALL\nHEIGHT = -1000.7\nMESSAGE up\nEND\n";

#[test]
fn a_stop_is_told_with_its_line_and_the_time_that_passed_until_then() {
    // Two cycles of 20 ms run; the clock stands still in the third.
    let recording = record("3.1\nStops\nREM\nREM\nPTP F1 0 0 0\nEND\n");
    let outcome = &unpacked(&recording)[2]["outcome"];
    assert_eq!(outcome["how"], "emergency");
    assert_eq!(
        (&outcome["time"], &outcome["line"]),
        (&40.0.into(), &5.into())
    );
}

#[test]
fn what_is_packed_is_what_was_recorded() {
    let recording = record(WALKS);
    let updates = unpacked(&recording);
    let [run, more, status] = updates.as_slice() else {
        panic!("{updates:?}");
    };
    assert_eq!(status["outcome"]["how"], "END");
    let messages = recording.entries(|what| matches!(what, Occurrence::Message(_)).then_some(()));
    let said: Vec<u64> = messages.map(|(cycle, ())| cycle).collect();
    assert_eq!(more["log"]["message"], json!([said, ["up"]]));
    // Columns of cycles hold differences.
    assert_eq!(more["log"]["event"], json!([[3, 1], ["key F", "halt"]]));
    assert_eq!(
        run["script"]["name"], "x<y>.prg",
        "folders are nobody's business"
    );
    assert_eq!(
        run["robot"]["legs"][3]["base"],
        serde_json::json!([101.0, -201.0, 0.0])
    );
    let scalars = recording.script.scalars.iter();
    let height = scalars.zip(0..).find(|(name, _)| *name == "HEIGHT");
    let key = format!("set.{}", height.expect("it is declared").1);
    assert_eq!(more["log"][key][1], json!([0.1, -1000.7]), "exact");
    // So do those of motion: cycles first, then each channel, within half of 0.01 at the end as at the beginning.
    let sums = |column: &Value| {
        let numbers = column.as_array().expect("a column").iter();
        let mut sum = 0;
        let sums = numbers.map(|number| {
            sum += number.as_i64().expect("a whole number");
            sum
        });
        sums.collect::<Vec<_>>()
    };
    let channels = run["channels"].as_array().expect("names");
    let height = channels.iter().position(|name| name == "pose.2");
    let heights = sums(&more["frames"][1 + height.expect("it walks")]);
    let cycles = sums(&more["frames"][0]);
    assert_eq!(
        (cycles.len(), heights.len()),
        (recording.frames.len(), cycles.len())
    );
    for (frame, (cycle, height)) in recording.frames.iter().zip(cycles.into_iter().zip(heights)) {
        assert_eq!(cycle as u64, frame.cycle);
        let expected = frame.pose.expect("it walks").position[2];
        assert!((height as f64 * 0.01 - expected).abs() < 0.0051, "{cycle}");
    }
    let steps = recording.entries(|what| match what {
        Occurrence::Step(step) => Some(json!(step)),
        _ => None,
    });
    let (cycles, steps): (Vec<u64>, Vec<Value>) = steps.unzip();
    let told = sums(&more["log"]["step"][0]).into_iter();
    assert!(told.eq(cycles.into_iter().map(|cycle| cycle as i64)));
    assert_eq!(more["log"]["step"][1], json!(steps));
}

#[test]
fn a_command_is_told_to_each_leg_that_it_moves() {
    let recording =
        record("3.1\nMoves\nSET_A_MAX ALL 1200\nPTP_ANGLE J21 5\nPTP F3 -391 -201 0\nEND\n");
    let log = &unpacked(&recording)[1]["log"];
    let all = "SET_A_MAX ALL 1200.0";
    assert_eq!(log["command.1"], json!([[0], [all]]));
    assert_eq!(
        log["command.2"],
        json!([[0, 1], [all, "PTP_ANGLE J21 5.0"]])
    );
    let foot = "PTP F3 -391.0 -201.0 0.0";
    assert_eq!(log["command.3"], json!([[0, 2], [all, foot]]));
    assert_eq!(log["command.4"], json!([[0], [all]]));
}

#[test]
fn a_page_is_whole_and_always_the_same() {
    let recording = record(WALKS);
    let page = recording.to_page();
    assert_eq!(page, recording.to_page());
    assert!(page.starts_with("<!DOCTYPE html>") && page.trim_end().ends_with("</html>"));
    for (mark, count) in [
        ("TIP-", 0),
        ("BUILD-", 0),
        ("<script", 4),
        ("</script", 4),
        ("default-src 'none'", 1),
    ] {
        assert_eq!(page.matches(mark).count(), count, "{mark}");
    }
    assert!(
        page.contains("Permission is hereby granted"),
        "licences of what it holds"
    );
    assert_eq!(part(&page, "recording"), recording.packed());
}

/// The bytes of a script element.
fn part(page: &str, id: &str) -> Vec<u8> {
    let (_, rest) = page
        .split_once(&format!("id=\"{id}\">"))
        .expect("it is there");
    let base64 = rest.split('<').next().expect("its end");
    let bytes = base64::engine::general_purpose::STANDARD.decode(base64);
    bytes.expect("base64")
}

#[test]
fn a_comparison_holds_the_other_run_and_the_lines_in_which_the_programs_differ() {
    let (one, other) = (
        record(WALKS),
        record(&WALKS.replace("STAND_UP 60", "STAND_UP 50")),
    );
    let page = one.to_comparison(&other);
    assert_eq!(part(&page, "recording"), one.packed());
    let held = lines(&part(&page, "compared"));
    assert_eq!(held[..3], unpacked(&other));
    let diff = "--- x<y>.prg\n+++ x<y>.prg\n@@ -5 +5 @@\n-STAND_UP 60\n+STAND_UP 50\n";
    assert_eq!(held[3], json!(diff));
    assert_eq!(one.program_diff(&one), "");
}

#[test]
fn nothing_that_a_program_says_is_markup() {
    let hostile = "3.1\n</title><script>alert(1)</script>&<b a='\"'>\nMESSAGE </script><script>alert(2)</script><!--\n\
                   // </script><img src=x onerror=alert(3)>\nEND\n";
    let page = record(hostile).to_page();
    let title = "<title>&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt;&amp;&lt;b a=&#39;&quot;&#39;&gt;</title>";
    assert!(page.contains(title));
    assert_eq!(page.matches("alert(").count(), 1, "all else is packed");
    assert_eq!(page.matches("<script").count(), 4);
}

/// The data of the page of a table.
fn data(page: &str) -> Value {
    let (_, rest) = page.split_once("id=\"data\">").expect("data");
    let (data, _) = rest.split_once("</script>").expect("its end");
    serde_json::from_str(data).expect("JSON")
}

#[test]
fn no_table_leaves_its_place() {
    let rows = [["</script><script>alert(1)</script><!--"]];
    let table = SweepTable {
        columns: [json!({ "name": "</script>", "unit": "", "type": "text" })],
        rows,
        kinds: ".".to_owned(),
        ranking: json!({ "goals": [], "where": [] }),
        command: "tip view '<b>.csv'".to_owned(),
        every: 2,
        is_served: true,
    };
    let page = sweep_page("TIP-DATA</title>.csv", &table);
    assert_eq!(page.matches("<script").count(), 2);
    assert_eq!(page.matches("</script").count(), 2);
    assert!(page.contains("<title>TIP-DATA&lt;/title&gt;.csv</title>"));
    assert!(!page.contains("http:") && !page.contains("https:"));
    let expected = json!({
        "columns": [{ "name": "</script>", "unit": "", "type": "text" }],
        "rows": rows,
        "kinds": ".",
        "ranking": { "goals": [], "where": [] },
        "command": "tip view '<b>.csv'",
        "every": 2,
        "is_served": true,
    });
    assert_eq!(data(&page), expected);
}
