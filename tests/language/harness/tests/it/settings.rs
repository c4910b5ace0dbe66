//! The options in the header of a case.

use std::path::Path;
use tip_harness::Settings;
use tipc::Robot;
use tipc::source::Encoding;

#[test]
fn every_option_is_read() {
    let header = "# clauses: 2.4\n# args: --robot generic --keys 3:a,4:0x1B --halt 5 --cycles 100\n\
        # args: --sensor VR1=8@3 --tip-version 2.5 --encoding shift_jis --scene cylinder --plant dynamic\n{\"end\":\"END\"}\n# args: --no\n";
    let [settings] = &Settings::of_header(header, Path::new("")).unwrap()[..] else {
        panic!("one robot");
    };
    assert_eq!(settings.load.robot, Robot::Generic);
    assert_eq!(settings.load.tip_version, Some(2.5));
    assert_eq!(settings.load.encoding, Encoding::ShiftJis);
    assert_eq!(
        settings.inputs,
        "--keys 3:a,4:0x1B --halt 5 --cycles 100 --sensor VR1=8@3"
    );
    assert_eq!(settings.scene.as_deref(), Some("cylinder"));
    assert!(settings.has_mass);
}

#[test]
fn a_case_may_be_for_several_robots() {
    let header = "# clauses: 2.4\n# robots: hand titan8\n# args: --cycles 5\n";
    let settings = Settings::of_header(header, Path::new("")).unwrap();
    let robots: Vec<Robot> = settings.iter().map(|one| one.load.robot).collect();
    assert_eq!(robots, [Robot::Hand, Robot::Titan8]);
    assert!(settings.iter().all(|one| one.inputs == "--cycles 5"));
    assert!(Settings::of_header("# robots: arm\n", Path::new("")).is_err());
}

#[test]
fn nonsense_is_refused() {
    for args in [
        "--robot arm",
        "--robot no/such/file.toml",
        "--cycles",
        "--speed 3",
    ] {
        assert!(
            Settings::of_header(&format!("# args: {args}"), Path::new("")).is_err(),
            "{args}"
        );
    }
}
