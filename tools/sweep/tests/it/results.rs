//! Results: rows of cases.

use crate::{LIFT, cells, numbers, refused, rows, spec, texts};
use tip_sim::{Limit, Robot, Run, load};
use tip_sweep::{
    Cell, Kind, Outcome, PlantSpec, Ranking, RobotSpec, Saved, Spec, Sweep, run_chunk,
};
use tipc::message::Lang;

fn recorded(text: &str, axes: &[&str], record: &str) -> Vec<f64> {
    let spec = Spec {
        record: vec![record.to_owned()],
        ..spec(text, axes)
    };
    numbers(&rows(spec), &format!("final_{record}"))
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
    assert_eq!(whole.rows.len(), 6);
    let parts = [(0, 1), (1, 3), (4, 2)]
        .into_iter()
        .flat_map(|(first, count)| {
            let part = run_chunk(&spec, first, count).expect("it runs");
            part.rows
        });
    let lines = |rows: Vec<tip_sweep::Row>| rows.iter().map(|row| row.line()).collect::<Vec<_>>();
    assert_eq!(lines(parts.collect()), lines(whole.rows));
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
        let Cell::Count(line) = cells(&columns, "line")[0] else {
            panic!("it is a count");
        };
        (texts(&columns, "end")[0].to_owned(), *line)
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

/// A reader of tables takes nothing but numbers for numbers: hashes of digits and one `e` are not infinite.
#[test]
fn no_text_reads_as_a_number() {
    let table = rows(spec(LIFT, &["Z=1..40"]));
    for column in table
        .columns
        .iter()
        .filter(|column| column.kind == Kind::Text)
    {
        for text in texts(&table, &column.name) {
            assert!(
                text.starts_with(|c: char| c.is_ascii_alphabetic()),
                "{text}"
            );
            assert!(text.parse::<f64>().is_err(), "{text}");
        }
    }
    assert!(
        texts(&table, "hash")
            .iter()
            .all(|hash| hash.starts_with('h') && hash.len() == 17)
    );
}

#[test]
fn a_row_reads_back_and_belongs_to_its_specification() {
    let make = |axes: &[&str]| Sweep::new(spec(LIFT, axes)).expect("a sweep");
    let (sweep, other) = (make(&["Z=10,20"]), make(&["Z=10,30"]));
    assert_eq!(sweep.header(), other.header());
    let row = sweep.run_case(0).expect("it runs");
    let line = row.line();
    let read = sweep.read_row(&line).expect("it is its own");
    assert_eq!(read.line(), line);
    assert_eq!((read.case(), read.outcome()), (0, row.outcome()));
    assert_eq!(read.values().collect::<Vec<_>>(), [("Z", 10.0)]);
    // Case 0 is the same run in both, but its row is that of one sweep.
    let same = other.run_case(0).expect("it runs");
    let hash = |row: &tip_sweep::Row| row.cells()[row.cells().len() - 2].clone();
    assert_eq!(hash(&same), hash(&row));
    assert!(other.read_row(&line).is_none());
    // Any other cell than the last one is as it was written, too.
    let fields = line.trim_end().split(',').count();
    for field in 0..fields {
        let mut parts: Vec<&str> = line.trim_end().split(',').collect();
        let changed = format!("{}1", parts[field]);
        parts[field] = &changed;
        assert!(
            sweep.read_row(&(parts.join(",") + "\n")).is_none(),
            "{parts:?}"
        );
    }
    for changed in [
        line.trim_end().to_owned() + ",\n",
        line.replace(",10,", ",10.0,"),
        "\n".to_owned(),
    ] {
        assert!(sweep.read_row(&changed).is_none(), "{changed}");
    }
}

#[test]
fn outcomes_are_ordered_from_the_worst() {
    let worse = [
        Outcome::Fell(3.0),
        Outcome::Fell(5.0),
        Outcome::Stopped(4.0),
        Outcome::Walked(-10.0),
        Outcome::Walked(900.0),
    ];
    assert!(worse.is_sorted_by(|one, other| one.order(other).is_lt()));
}

#[test]
fn the_saved_columns_have_units_and_meanings() {
    let sweep = Sweep::new(Spec {
        scene: Some("[floor]\nslope = [0, 0]\n".to_owned()),
        ..spec(LIFT, &["Z=10", "scene.floor.slope.1=0"])
    });
    let sweep = sweep.expect("a sweep");
    let saved: serde_json::Value =
        serde_json::from_str(&Saved::of(&sweep, Ranking::default()).text()).expect("JSON");
    let columns = saved["columns"].as_array().expect("a list");
    assert_eq!(columns.len(), sweep.columns().len());
    let column = |name: &str| {
        let found = columns.iter().find(|column| column["name"] == name);
        found.expect("a column").clone()
    };
    assert_eq!(column("forward")["unit"], "mm");
    assert_eq!(column("forward")["type"], "number");
    assert_eq!(
        column("forward")["meaning"]["en"],
        "travel of the body forward"
    );
    assert_eq!(
        column("Z")["meaning"]["en"],
        "value of the program's variable"
    );
    let slope = sweep.columns()[2].meaning.text(Lang::Japanese);
    assert!(slope.contains("傾き"), "{slope}");
    let read = Saved::read(Saved::of(&sweep, Ranking::default()).text().as_bytes())
        .expect("it is its own");
    assert!(read.is_of(&sweep));
    assert!(!read.is_of(&Sweep::new(spec(LIFT, &["Z=10"])).expect("a sweep")));
}

#[test]
fn a_thread_that_assigns_a_constant_takes_the_value() {
    let program = |main: &str, thread: &str| {
        format!(
            "3.2\nt\nDEF_VAR A B\n{main}\nWAIT_THREAD T:\nEXIT\nTHREAD T:\n{thread}\nTHREADEND\nEND\n"
        )
    };
    // The thread assigns and uses it; the main program does not know it.
    let own = program("START_THREAD T:", "A = 500\nB = A");
    assert_eq!(recorded(&own, &["A=100,1000"], "B"), [100.0, 1000.0]);
    // The thread assigns it for the main program.
    let given = program("START_THREAD T:\nWAIT_THREAD T:\nB = A", "A = 500");
    assert_eq!(recorded(&given, &["A=100,1000"], "B"), [100.0, 1000.0]);
    // The main program assigns it for the thread.
    let taken = program("A = 500\nSTART_THREAD T:", "B = A");
    assert_eq!(recorded(&taken, &["A=100,1000"], "B"), [100.0, 1000.0]);
    // A subroutine of the thread assigns it.
    let called = program("START_THREAD T:", "CALL S:\nB = A").replace(
        "THREAD T:\nCALL",
        "SUBROUTINE S:\nA = 500\nSUBEND\nTHREAD T:\nCALL",
    );
    assert_eq!(recorded(&called, &["A=100,1000"], "B"), [100.0, 1000.0]);
    // One that computes it is named.
    let computed = program("A = 500\nSTART_THREAD T:", "A = 1 + 1");
    assert_eq!(
        refused(&computed, &["A=100"]),
        "cannot vary 'A': line 9 computes it before its first use; vary what it is computed from"
    );
}

/// Falls of a robot without mass are counted, and a hand has none.
#[test]
fn a_row_says_whether_falls_are_counted() {
    let row = |spec: Spec| rows(spec).rows.remove(0);
    let walk = row(spec(LIFT, &["Z=0"]));
    assert!(walk.counts_falls() && !walk.has_fallen());
    assert!(matches!(walk.outcome(), Outcome::Walked(_)));
    let hand = row(Spec {
        robot: RobotSpec::Name("hand".to_owned()),
        scene: Some("cylinder".to_owned()),
        ..spec("3.1\nt\nEND\n", &[])
    });
    assert!(!hand.counts_falls());
    assert!(matches!(hand.outcome(), Outcome::Lifted(_)));
}
