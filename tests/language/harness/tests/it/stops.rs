//! Lines that stop a program.

use tip_harness::stops::{Stop, emergency};

#[test]
fn the_last_record_says_what_stopped_the_program() {
    let trace = "{\"cycle\":0,\"step\":0,\"next\":1}\n{\"end\":\"EMERGENCY\",\"error\":\"Domain error\",\
        \"kind\":\"RuntimeError\",\"step\":12,\"cycles\":1}\n";
    let error = "TIP_ERR:Domain error (RuntimeError)".to_owned();
    assert_eq!(emergency(trace), Some((12, error)));
    assert_eq!(emergency("{\"end\":\"END\",\"cycles\":1}"), None);
}

#[test]
fn a_stop_names_a_line_and_an_error() {
    let error = "TIP_ERR:Out of reach F1 (RobotError)";
    let text = format!("12: {error}");
    assert_eq!(Stop::parse(&text), Some(Stop { line: 12, error }));
    assert_eq!(Stop::parse(error), None);
}
