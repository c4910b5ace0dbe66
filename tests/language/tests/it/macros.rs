//! Programs that the macros compile, by path and in place.

use tip_runtime::program::Program;
use tip_tests::{Settings, run};

tip_macros::include_tip!("../../../codegen/golden/counting.prg");
tip_macros::include_tip!(pub(crate) "../codegen/golden/counting.prg" as FromPackage, robot = generic, tip_version = 3.1);
tip_macros::tip!(
    Inline,
    r#"3.1
inline
DEF_VAR N
N = 2
MESSAGE %N%
END"#
);

#[test]
fn invocations_name_robot_and_type() {
    assert_eq!(Counting::new().signature().robot, "titan8");
    assert_eq!(Counting::new().name(), "counting.prg");
    assert_eq!(FromPackage::new().signature().robot, "generic");
    assert_eq!(Inline::new().name(), "Inline");
    assert_eq!(Inline::new().title(), "inline");
}

// clauses: 2.12 2.13 7.35 7.47
#[test]
fn an_included_program_runs() {
    let trace = run(Counting::new(), &Settings::default()).unwrap();
    let said: Vec<&str> = trace
        .lines()
        .filter_map(|line| line.split_once("\"say\":\"")?.1.split_once('"'))
        .map(|(text, _)| text)
        .collect();
    assert_eq!(said, ["{1} makes 1.0", "{2} makes 3.0", "{3} makes 6.0"]);
    assert!(
        trace.ends_with("{\"end\":\"END\",\"cycles\":14}\n"),
        "{trace}"
    );
}
