//! What a page holds.

use base64::Engine as _;
use serde_json::Value;
use tip_sim::{Events, Robot, tipc};
use tip_view::{Extent, Recording};

fn record(text: &str) -> Recording {
    let robot = Robot::named("titan8").expect("it has a name");
    let loaded = tipc::load("folder/x<y>.prg", text.as_bytes(), &robot.options());
    assert!(loaded.program.is_some(), "{:?}", loaded.diagnostics);
    let events: Events = "3:key F, 4:halt".parse().expect("events");
    Recording::of(&loaded, &robot, &events, Extent::cycles(500), || true).expect("it runs")
}

/// The header, and the columns as they are packed.
fn unpacked(recording: &Recording) -> (Value, Vec<(Value, Vec<u8>)>) {
    let bytes = miniz_oxide::inflate::decompress_to_vec(&recording.packed()).expect("deflated");
    let length = u32::from_le_bytes(bytes[..4].try_into().expect("4 bytes")) as usize;
    let header: Value = serde_json::from_slice(&bytes[4..4 + length]).expect("JSON");
    let mut rest = &bytes[4 + length..];
    let mut columns = Vec::new();
    for column in header["columns"].as_array().expect("columns") {
        let (own, after) = rest.split_at(column["bytes"].as_u64().expect("a size") as usize);
        columns.push((column.clone(), own.to_vec()));
        rest = after;
    }
    assert!(rest.is_empty());
    (header, columns)
}

const WALKS: &str = "3.1\nWalks\nDEF_VAR HEIGHT\nHEIGHT = 0.1\nSTAND_UP 60\nWAIT_INPOS ALL\nHEIGHT = -1000.7\nMESSAGE up\nEND\n";

#[test]
fn what_is_packed_is_what_was_recorded() {
    let recording = record(WALKS);
    let (header, columns) = unpacked(&recording);
    let column = |name: &str| {
        let found = columns.iter().find(|(column, _)| column["name"] == name);
        found.unwrap_or_else(|| panic!("no column {name}"))
    };
    assert_eq!(
        header["messages"],
        serde_json::json!([[recording.messages[0].cycle, "up"]])
    );
    assert_eq!(
        header["events"],
        serde_json::json!([[3, "key F"], [4, "halt"]])
    );
    assert_eq!(
        header["script"]["name"], "x<y>.prg",
        "folders are nobody's business"
    );
    assert_eq!(
        header["robot"]["legs"][3]["base"],
        serde_json::json!([101.0, -201.0, 0.0])
    );
    // Exact: all first bytes, then all second ones.
    let (_, bytes) = column("set.value");
    let value = |n: usize| f64::from_le_bytes(std::array::from_fn(|plane| bytes[2 * plane + n]));
    assert_eq!([value(0), value(1)], [0.1, -1000.7]);
    // Within half a grid, at the end as at the beginning.
    let (listed, bytes) = column("pose.2");
    let (grid, count) = (
        listed["grid"].as_f64().expect("a grid"),
        recording.frames.len(),
    );
    assert_eq!((grid, bytes.len()), (0.01, 2 * count));
    let mut place = listed["first"].as_i64().expect("a place");
    for (n, frame) in recording.frames.iter().enumerate() {
        place += i64::from(i16::from_le_bytes([bytes[n], bytes[count + n]]));
        let height = frame.pose.expect("it walks").position[2];
        assert!((place as f64 * grid - height).abs() < 0.0051, "frame {n}");
    }
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
        ("<script", 2),
        ("</script", 2),
        ("default-src 'none'", 1),
    ] {
        assert_eq!(page.matches(mark).count(), count, "{mark}");
    }
    assert!(
        page.contains("Permission is hereby granted"),
        "licences of what it holds"
    );
    let begin = page.find("id=\"recording\">").expect("the recording") + "id=\"recording\">".len();
    let base64 = page[begin..].split('<').next().expect("its end");
    let bytes = base64::engine::general_purpose::STANDARD.decode(base64);
    assert_eq!(bytes.expect("base64"), recording.packed());
}

#[test]
fn nothing_that_a_program_says_is_markup() {
    let hostile = "3.1\n</title><script>alert(1)</script>&<b a='\"'>\nMESSAGE </script><script>alert(2)</script><!--\n\
                   // </script><img src=x onerror=alert(3)>\nEND\n";
    let page = record(hostile).to_page();
    let title = "<title>&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt;&amp;&lt;b a=&#39;&quot;&#39;&gt;</title>";
    assert!(page.contains(title));
    assert_eq!(page.matches("alert(").count(), 1, "all else is packed");
    assert_eq!(page.matches("<script").count(), 2);
}
