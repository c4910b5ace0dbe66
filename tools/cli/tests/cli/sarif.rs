//! `tip check --message-format sarif`: what the standard asks of a document, and where its places are.

use crate::support::Folder;
use serde_json::{Value, json};

/// The document about files.
fn document(folder: &Folder, arguments: &[&str]) -> Value {
    let all = [&["check", "--message-format", "sarif"], arguments].concat();
    let outcome = folder.tip(&all);
    assert_eq!(outcome.err, "", "{outcome:#?}");
    serde_json::from_str(&outcome.out).expect("one document")
}

#[test]
fn diagnostics_that_are_omitted_are_a_note_about_the_run() {
    let folder =
        Folder::new("sarif-omitted").program("wrong.prg", &("FOO\n".repeat(1_500) + "END"));
    let run = &document(&folder, &["wrong.prg"])["runs"][0];
    assert_eq!(run["results"].as_array().map(Vec::len), Some(1_000));
    let note = &run["invocations"][0]["toolExecutionNotifications"][0];
    assert_eq!(note["message"]["text"], "... and 500 more findings");
    let place = &note["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "wrong.prg");
}

#[test]
fn all_files_are_one_run_of_one_document() {
    let folder = Folder::new("sarif-all")
        .program("good.prg", "END")
        .program("a b{}.prg", "SLEEP 1,000\nDEF_VAR N\nEND")
        .program("wrong.prg", "SLEEP N\nSLEEP N\nEND");
    let found = document(&folder, &["good.prg", "a b{}.prg", "wrong.prg", "nope.prg"]);
    assert_eq!(found["version"], "2.1.0");
    assert!(
        found["$schema"]
            .as_str()
            .is_some_and(|it| it.ends_with("sarif-schema-2.1.0.json"))
    );
    let [run] = found["runs"].as_array().expect("runs").as_slice() else {
        panic!("{found:#}");
    };
    assert_eq!(run["columnKind"], "unicodeCodePoints");
    let driver = &run["tool"]["driver"];
    assert_eq!(
        (&driver["name"], &driver["semanticVersion"]),
        (&json!("tip"), &json!(env!("CARGO_PKG_VERSION")))
    );
    let uris = run["artifacts"].as_array().expect("artifacts").iter();
    let uris: Vec<&Value> = uris.map(|it| &it["location"]["uri"]).collect();
    assert_eq!(
        uris,
        ["good.prg", "a%20b%7B%7D.prg", "wrong.prg", "nope.prg"]
    );
    let rules = driver["rules"].as_array().expect("rules");
    let ids: Vec<&Value> = rules.iter().map(|rule| &rule["id"]).collect();
    assert_eq!(ids, ["E103", "E205-02", "E206", "W101"]);
    let results = run["results"].as_array().expect("results");
    assert_eq!(results.len(), 4);
    for result in results {
        let rule = &rules[result["ruleIndex"].as_u64().expect("an index") as usize];
        assert_eq!(rule["id"], result["ruleId"]);
        assert_eq!(rule["defaultConfiguration"]["level"], result["level"]);
        assert!(rule["shortDescription"]["text"].is_string());
        assert!(rule["help"]["markdown"].is_string());
        let place = &result["locations"][0]["physicalLocation"];
        let index = place["artifactLocation"]["index"]
            .as_u64()
            .expect("an index") as usize;
        assert_eq!(&place["artifactLocation"]["uri"], uris[index]);
        assert!(result["message"]["text"].is_string());
    }
    let levels: Vec<&Value> = results.iter().map(|result| &result["level"]).collect();
    assert_eq!(levels, ["error", "warning", "error", "error"]);
    // The second use of the name is a place of the same result.
    let related = &results[2]["relatedLocations"];
    assert_eq!(related[0]["physicalLocation"]["region"]["startLine"], 4);
    assert_eq!(related[0]["message"]["text"], "used here too");
    // A file that cannot be read has no place inside.
    assert!(results[3]["locations"][0]["physicalLocation"]["region"].is_null());
}

#[test]
fn columns_are_characters_and_bytes_are_those_of_the_file() {
    // 歩 is 2 bytes of Shift_JIS. Line 3 begins at byte 7, its MESSAGE text at byte 15.
    let text = b"3.1\n\x95\xE0\nMESSAGE \x95\xE0; FOO // \x95\xE0\nEND\n";
    let folder = Folder::new("sarif-places").file("sjis.prg", text);
    let found = document(&folder, &["sjis.prg", "--lang", "ja"]);
    let run = &found["runs"][0];
    assert_eq!(run["language"], "ja");
    assert_eq!(run["artifacts"][0]["encoding"], "Shift_JIS");
    assert_eq!(
        run["results"][0]["locations"][0]["physicalLocation"]["region"],
        json!({
            "startLine": 3, "startColumn": 12, "endLine": 3, "endColumn": 15,
            "byteOffset": 19, "byteLength": 3,
        })
    );
    let text = run["results"][0]["message"]["text"]
        .as_str()
        .expect("a text");
    assert!(
        text.starts_with("`FOO` というコマンドはありません"),
        "{text}"
    );
}

#[test]
fn no_brace_begins_a_placeholder_and_nothing_acts_on_a_terminal() {
    let folder = Folder::new("sarif-odd").program("p.prg", "{0} 1\nFOO\u{9b}\nEND");
    let all = ["check", "--message-format", "sarif", "p.prg"];
    let out = folder.tip(&all).expect(1).out;
    assert!(!out.contains('\u{9b}'), "{out}");
    let found: Value = serde_json::from_str(&out).expect("one document");
    let text = found["runs"][0]["results"][0]["message"]["text"]
        .as_str()
        .expect("a text");
    assert!(text.contains("`{{0}}`"), "{text}");
}

#[test]
fn a_description_that_cannot_be_used_is_in_the_document_too() {
    let folder = Folder::new("sarif-robot")
        .program("p.prg", "END")
        .file("bad.toml", "name = 1\n");
    let found = document(&folder, &["--robot", "bad.toml", "p.prg"]);
    assert_eq!(found["runs"][0]["results"][0]["ruleId"], "E401");
    assert_eq!(
        found["runs"][0]["artifacts"][0]["location"]["uri"],
        "bad.toml"
    );
}

#[test]
fn what_can_be_put_right_has_its_replacement() {
    let folder = Folder::new("sarif-fix").program("p.prg", "  SLEEP １００\nEND");
    let found = document(&folder, &["p.prg"]);
    let change = &found["runs"][0]["results"][0]["fixes"][0]["artifactChanges"][0];
    assert_eq!(change["artifactLocation"]["uri"], "p.prg");
    let replacement = &change["replacements"][0];
    let region = &replacement["deletedRegion"];
    let columns = (&region["startColumn"], &region["endColumn"]);
    assert_eq!(columns, (&json!(9), &json!(12)), "{found:#}");
    assert_eq!(replacement["insertedContent"]["text"], "100");
}

#[test]
fn only_check_writes_sarif() {
    let folder = Folder::new("sarif-run").program("p.prg", "END");
    for verb in ["run", "cycles", "migrate"] {
        let outcome = folder
            .tip(&[verb, "--message-format", "sarif", "p.prg"])
            .expect(2);
        assert!(
            outcome.err.contains("tip check writes SARIF"),
            "{outcome:#?}"
        );
    }
}
