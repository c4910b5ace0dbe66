//! The program in the page, and in its file.

use super::client::Server;
use super::counts;
use crate::support::Folder;
use serde_json::json;
use std::fs;

#[test]
fn an_error_is_found_put_right_and_the_program_saved_and_run() {
    let folder = counts("serve-edit");
    let server = Server::begin(&folder, &["counts.prg"]);
    let mut viewer = server.viewer();
    viewer.until(|viewer| viewer.version == 1);
    let wrong = viewer.text.replace("MESSAGE key", "MESAGE key");
    let line = 1 + wrong
        .lines()
        .position(|line| line.contains("MESAGE"))
        .expect("a line");
    viewer.does(json!({"do": "edit", "text": wrong, "base": 1, "by": "test"}));
    viewer.until(|viewer| viewer.findings["version"] == 2);
    assert_eq!(viewer.findings["good"], false);
    let found = viewer.findings["findings"].as_array().expect("a list");
    let error = found
        .iter()
        .find(|one| one["level"] == "error")
        .expect("an error");
    assert_eq!(error["from"], json!([line, 1]));
    assert_eq!(viewer.ask(json!({"do": "restart"}))["error"], "errors");
    let right = wrong.replace("MESAGE key", "MESSAGE typed");
    viewer.does(json!({"do": "edit", "text": right, "base": 2, "by": "test"}));
    viewer.until(|viewer| viewer.findings["version"] == 3);
    assert_eq!(viewer.findings["good"], true);
    assert!(
        !folder.read("counts.prg").contains("typed"),
        "nobody has saved it"
    );
    viewer.does(json!({"do": "save"}));
    assert_eq!(folder.read("counts.prg"), right);
    assert_eq!(folder.names(), ["counts.prg"], "nothing is left beside it");
    viewer.does(json!({"do": "restart"}));
    viewer.until(|viewer| viewer.run == 2);
    viewer.does(json!({"do": "event", "event": "key F"}));
    viewer.until(|viewer| viewer.messages == ["typed"]);
}

#[test]
fn two_who_edit_are_told_of_each_other() {
    let server = Server::begin(&counts("serve-edit-two"), &["counts.prg", "--paused"]);
    let (mut one, mut other) = (server.viewer(), server.viewer());
    one.until(|viewer| viewer.version == 1);
    other.until(|viewer| viewer.version == 1);
    let (mine, theirs) = (one.text.clone() + "// 1\n", one.text.clone() + "// 2\n");
    one.does(json!({"do": "edit", "text": mine, "base": 1, "by": "one"}));
    let refused = other.ask(json!({"do": "edit", "text": theirs, "base": 1, "by": "other"}));
    assert_eq!(refused["error"], "stale");
    other.until(|viewer| viewer.version == 2);
    assert_eq!(other.text, mine);
}

#[test]
fn shift_jis_stays_what_it_is() {
    let bytes = b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\nREM\r\nEND\r\n\x1A";
    let folder = Folder::new("serve-sjis").file("sjis.prg", bytes);
    let server = Server::begin(&folder, &["sjis.prg", "--paused"]);
    let mut viewer = server.viewer();
    viewer.until(|viewer| viewer.version == 1);
    let edited = viewer.text.replace("REM\n", "REM\n// 歩\n");
    viewer.does(json!({"do": "edit", "text": edited, "base": 1, "by": "test"}));
    viewer.does(json!({"do": "save"}));
    let expected = b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\nREM\r\n// \x95\xE0\r\nEND\r\n\x1A";
    let saved = fs::read(folder.path("sjis.prg")).expect("it is there");
    assert_eq!(saved, expected);
}

#[test]
fn a_change_of_the_file_runs_and_an_edited_text_is_not_lost() {
    let folder = counts("serve-reload");
    let server = Server::begin(&folder, &["counts.prg"]);
    let mut viewer = server.viewer();
    viewer.until(|viewer| viewer.version == 1);
    let path = folder.path("counts.prg");
    fs::write(&path, "3.1\nother\nREM\nSLEEP 60000\nEND\n").expect("writable");
    viewer.until(|viewer| viewer.run == 2 && viewer.text.contains("other"));
    let (version, mine) = (viewer.version, "3.1\nmine\nREM\nSLEEP 60000\nEND\n");
    viewer.does(json!({"do": "edit", "text": mine, "base": version, "by": "test"}));
    fs::write(&path, "3.1\ntheirs\nREM\nSLEEP 60000\nEND\n").expect("writable");
    viewer.until(|viewer| viewer.status["overtaken"] == true);
    assert_eq!((viewer.run, viewer.text.as_str()), (2, mine));
    viewer.does(json!({"do": "reload"}));
    viewer.until(|viewer| viewer.run == 3 && viewer.text.contains("theirs"));
}

#[test]
fn a_file_that_cannot_be_written_is_said() {
    let folder = counts("serve-gone");
    let server = Server::begin(&folder, &["counts.prg", "--paused"]);
    let mut viewer = server.viewer();
    fs::remove_file(folder.path("counts.prg")).expect("it is there");
    fs::create_dir(folder.path("counts.prg")).expect("writable");
    let answer = viewer.ask(json!({"do": "save"}));
    assert_eq!(answer["error"], "unsaved", "{answer}");
    assert_eq!(viewer.ask(json!({"do": "reload"}))["error"], "unread");
}

/// A link in the place of the file, or of its folder, is not followed; an edit that nobody has seen is not overwritten.
#[test]
fn a_link_that_takes_the_place_of_the_file_shows_and_overwrites_nothing() {
    use std::os::unix::fs::symlink;
    let folder = counts("serve-swapped")
        .file("secret.txt", "nobody's")
        .file("other/counts.prg", "3.1\nother\nEND\n");
    fs::create_dir(folder.path("here")).expect("writable");
    fs::rename(folder.path("counts.prg"), folder.path("here/counts.prg")).expect("writable");
    let server = Server::begin(&folder, &["here/counts.prg", "--paused"]);
    let mut viewer = server.viewer();
    viewer.until(|viewer| viewer.version == 1);
    let own = viewer.text.clone();
    fs::remove_file(folder.path("here/counts.prg")).expect("it is there");
    for target in ["../secret.txt", "/dev/zero", "missing.txt"] {
        symlink(target, folder.path("here/counts.prg")).expect("writable");
        assert_eq!(viewer.ask(json!({"do": "reload"}))["error"], "unread");
        assert_eq!(viewer.ask(json!({"do": "save"}))["error"], "unsaved");
        fs::remove_file(folder.path("here/counts.prg")).expect("it is there");
    }
    assert_eq!(folder.read("secret.txt"), "nobody's");
    assert!(!folder.has("here/missing.txt"));
    fs::rename(folder.path("here"), folder.path("moved")).expect("writable");
    symlink("other", folder.path("here")).expect("writable");
    assert_eq!(viewer.ask(json!({"do": "reload"}))["error"], "unread");
    assert_eq!(viewer.ask(json!({"do": "save"}))["error"], "unsaved");
    assert_eq!(folder.read("other/counts.prg"), "3.1\nother\nEND\n");
    assert_eq!(viewer.text, own);
}
