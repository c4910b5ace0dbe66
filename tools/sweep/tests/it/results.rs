//! Results: rows of cases.

use crate::{LIFT, spec};
use tip_sim::{Limit, Robot, Run, load};
use tip_sweep::{Columns, Data, PlantSpec, Spec, Sweep, run_chunk};

fn numbers<'a>(columns: &'a Columns, name: &str) -> &'a [f64] {
    match &columns.column(name).expect("a column").data {
        Data::Number(values) => values,
        other => panic!("{name} has {other:?}"),
    }
}

fn recorded(text: &str, axes: &[&str], record: &str) -> Vec<f64> {
    let spec = Spec {
        record: vec![record.to_owned()],
        ..spec(text, axes)
    };
    let sweep = Sweep::new(spec).expect("a sweep");
    let columns = sweep.run(0, sweep.cases()).expect("it runs");
    numbers(&columns, &format!("final_{record}")).to_vec()
}

#[test]
fn chunks_of_any_size_give_the_same_rows() {
    let spec = Spec {
        repeat: 3,
        seed: 7,
        plant: PlantSpec::Dynamic,
        until: 0.2,
        ..spec(LIFT, &["Z=10,20", "noise.angle=uniform(0,0.2)"])
    };
    let whole = run_chunk(&spec, 0, 6).expect("it runs");
    assert_eq!(whole.len(), 6);
    let mut parts = Columns::default();
    for (first, count) in [(0, 1), (1, 3), (4, 2)] {
        parts.append(run_chunk(&spec, first, count).expect("it runs"));
    }
    assert_eq!(parts.to_string(), whole.to_string());
}

#[test]
fn a_case_that_the_sweep_lacks_is_refused() {
    let spec = spec(LIFT, &["Z=10,20"]);
    let refused = run_chunk(&spec, 1, 2).expect_err("there is no case 2");
    assert_eq!(
        refused.to_string(),
        "there is no case 2; the sweep has 2, which count from 0"
    );
}

/// A case is the run of a program that has the case's number in place of its own constant.
#[test]
fn a_varied_constant_is_as_if_the_program_had_the_other_number() {
    let columns = run_chunk(&spec(LIFT, &["Z=10,35"]), 0, 2).expect("it runs");
    for (row, height) in ["10", "35"].iter().enumerate() {
        let robot = Robot::named("titan8").expect("it is built in");
        let text = LIFT.replace("Z = 20", &format!("Z = {height}"));
        let program = load("p.prg", &text, &robot).expect("it loads");
        let mut run = Run::new(program, robot).expect("it fits");
        run.to_end(Limit::cycles(1000));
        assert_eq!(numbers(&columns, "time")[row], run.time() / 1000.0);
        let motion = run.motion().expect("a body");
        assert_eq!(numbers(&columns, "least_margin")[row], motion.least_margin);
    }
    assert_ne!(numbers(&columns, "time")[0], numbers(&columns, "time")[1]);
}

#[test]
fn constants_before_the_first_use_are_replaced_on_every_path() {
    // Both branches assign before the first use; the last assignment comes after it and stays.
    let branches = "3.1\nt\nDEF_VAR A B C\nC = 1\nIF C == 1 THEN\nA = 2\nELSE\nA = 3\nENDIF\nB = A\nA = 4\nEND\n";
    assert_eq!(recorded(branches, &["A=50,60"], "B"), [50.0, 60.0]);
    assert_eq!(recorded(branches, &["A=50,60"], "A"), [4.0, 4.0]);
    let subroutine =
        "3.1\nt\nDEF_VAR A B\nCALL INIT:\nB = A\nEXIT\nSUBROUTINE INIT:\nA = 2\nSUBEND\nEND\n";
    assert_eq!(recorded(subroutine, &["A=5"], "B"), [5.0]);
    // In a loop the constant is replaced each time.
    let again = "3.1\nt\nDEF_VAR A B N\nB = 0\nFOR N = 1 TO 3\nA = 2\nB += A\nNEXT N\nEND\n";
    assert_eq!(recorded(again, &["A=10"], "B"), [30.0]);
}

#[test]
fn a_variable_that_a_path_leaves_unassigned_has_its_value_from_the_start() {
    // No key is pressed: the step that assigns is skipped.
    let skipped = "3.1\nt\nDEF_VAR A B\nIF !KB_HIT GOTO SKIP:\nA = 1\nSKIP:\nB = A\nEND\n";
    assert_eq!(recorded(skipped, &["A=7,8"], "B"), [7.0, 8.0]);
}

#[test]
fn rows_say_how_and_where_a_run_ended() {
    let ends = |text: &str, until: f64| {
        let spec = Spec {
            until,
            ..spec(text, &[])
        };
        let columns = run_chunk(&spec, 0, 1).expect("it runs");
        let Data::Text(end) = &columns.column("end").expect("a column").data else {
            panic!("it is text");
        };
        let Data::Count(line) = &columns.column("line").expect("a column").data else {
            panic!("it is a count");
        };
        (end[0].clone(), line[0])
    };
    assert_eq!(ends(LIFT, 60.0), ("END".to_owned(), 7));
    assert_eq!(ends("3.1\nt\nEXIT\nEND\n", 60.0), ("EXIT".to_owned(), 3));
    let forever = "3.1\nt\nAGAIN:\nGOTO AGAIN:\nEND\n";
    assert_eq!(ends(forever, 1.0).0, "limit");
    let (end, line) = ends("3.1\nt\nDEF_VAR A\nA = 0\nA = 1 / A\nEND\n", 60.0);
    assert!(end.contains("Domain error"), "{end}");
    assert_eq!(line, 5);
}

#[test]
fn a_csv_file_has_units_and_reads_back_to_the_same_bits() {
    let columns = run_chunk(&spec(LIFT, &["push.x=0.1,0.2"]), 0, 2);
    assert!(columns.is_err(), "a robot without mass cannot be pushed");
    let spec = Spec {
        plant: PlantSpec::Dynamic,
        until: 0.2,
        ..spec(LIFT, &["push.x=0.1,0.2"])
    };
    let columns = run_chunk(&spec, 0, 2).expect("it runs");
    let text = columns.to_string();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    assert_eq!(header[..3], ["case", "push.x [N]", "end"]);
    let energy = header
        .iter()
        .position(|name| *name == "energy [J]")
        .expect("with mass");
    for (row, line) in lines.enumerate() {
        let cell: f64 = line
            .split(',')
            .nth(energy)
            .expect("a cell")
            .parse()
            .expect("a number");
        assert_eq!(cell.to_bits(), numbers(&columns, "energy")[row].to_bits());
        assert!(cell > 0.0);
    }
}
