//! Sweeps of compiled programs.

use crate::{LIFT, spec};
use tip_sweep::{Row, Spec, Sweep};

tip_macros::tip!(
    Lift,
    r#"3.1
Lifts a foot
DEF_VAR Z
Z = 20
REL_PTP F1 0 0 Z
WAIT_INPOS F1
END
"#
);

#[test]
fn a_compiled_program_gives_the_rows_of_the_interpreter() {
    let spec = || Spec {
        record: vec!["Z".to_owned()],
        ..spec(LIFT, &["Z=10,20,35"])
    };
    let compiled = Sweep::of(spec(), Lift::new).expect("it is the same program");
    let interpreted = Sweep::new(spec()).expect("a sweep");
    let rows = |sweep: &Sweep| {
        let rows = sweep.run(0, 3).expect("it runs");
        rows.iter().map(Row::line).collect::<String>()
    };
    assert_eq!(rows(&compiled), rows(&interpreted));
}

#[test]
fn code_of_another_text_is_refused() {
    for other in [
        LIFT.replace("DEF_VAR Z", "DEF_VAR Z A"),
        LIFT.replace("END", "\nEND"),
    ] {
        let refused = Sweep::of(spec(&other, &["Z=1"]), Lift::new).expect_err("it differs");
        assert!(refused.to_string().contains("not compiled from the text"));
    }
}
