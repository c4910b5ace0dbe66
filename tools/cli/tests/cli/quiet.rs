//! `tip check --quiet`.

use crate::support::Folder;

#[test]
fn quiet_says_nothing_of_programs_in_order() {
    let folder = Folder::new("quiet")
        .program("good.prg", "SLEEP 100\nEND")
        .program("fine.prg", "ALL_STOP\nEND")
        .program("bad.prg", "FOO\nEND");
    let sound = folder.tip(&["check", "--quiet", "good.prg", "fine.prg"]);
    let sound = sound.expect(0);
    assert_eq!((sound.out.as_str(), sound.err.as_str()), ("", ""));
    let said = folder.tip(&["check", "-q", "good.prg", "bad.prg", "fine.prg"]);
    let said = said.expect(1);
    assert!(
        !said.err.contains("good.prg") && !said.err.contains("fine.prg"),
        "{}",
        said.err
    );
    assert!(
        said.err.contains("bad.prg: 1 error, 0 warnings"),
        "{}",
        said.err
    );
    assert!(said.err.contains("3 files"), "{}", said.err);
    let loud = folder.tip(&["check", "good.prg"]).expect(0);
    assert!(loud.err.contains("good.prg"), "{}", loud.err);
}
