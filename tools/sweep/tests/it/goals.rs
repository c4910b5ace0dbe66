//! Goals and conditions: which runs are the best ones.

use crate::surroundings::{HEXAPOD, TRIPOD};
use crate::{numbers, rows, spec};
use tip_sweep::{Condition, Front, Goal, PlantSpec, Ranking, RobotSpec, Saved, Spec, Sweep, Table};

/// `C` is the product of two variables.
const PRODUCT: &str = "3.1\nt\nDEF_VAR A B C\nA = 1\nB = 1\nC = A * B\nEND\n";
/// It stops in an emergency where `A` is 2.
const QUOTIENT: &str = "3.1\nt\nDEF_VAR A B C\nA = 1\nB = 1\nC = A - 2\nC = B / C\nEND\n";

/// No case.
const NONE: [u64; 0] = [];

fn products(text: &str) -> Table {
    rows(Spec {
        record: vec!["C".to_owned()],
        ..spec(text, &["A=1,2,3", "B=1,2"])
    })
}

fn maximize(name: &str) -> Goal {
    Goal::Maximize(name.to_owned())
}

fn minimize(name: &str) -> Goal {
    Goal::Minimize(name.to_owned())
}

/// The cases of the front.
fn front(table: &Table, goals: &[Goal], conditions: &[&str]) -> Vec<u64> {
    let conditions = conditions.iter().map(|text| text.parse().expect(text));
    let ranking = Ranking {
        goals: goals.to_vec(),
        conditions: conditions.collect(),
    };
    let mut front = Front::new(ranking.of(&table.columns).expect("names of columns"));
    table.rows.iter().for_each(|row| front.add(row));
    front.rows().iter().map(|row| row.case()).collect()
}

/// Cases 0 to 5 have A = 1, 1, 2, 2, 3, 3 and B = 1, 2, 1, 2, 1, 2.
#[test]
fn one_goal_gives_the_best_run_and_several_the_pareto_front() {
    let table = products(PRODUCT);
    assert_eq!(front(&table, &[maximize("final_C")], &[]), [5]);
    // Of equal runs the first one counts.
    assert_eq!(front(&table, &[minimize("B")], &[]), [0]);
    assert_eq!(front(&table, &[maximize("A"), minimize("B")], &[]), [4]);
    // A larger A costs a larger product, and a larger B gains nothing.
    let both = [maximize("A"), minimize("final_C")];
    assert_eq!(front(&table, &both, &[]), [4, 2, 0]);
    assert_eq!(front(&table, &both, &["A<3"]), [2, 0]);
    assert_eq!(front(&table, &both, &["A<3", "final_C>=2"]), [2]);
    assert_eq!(front(&table, &both, &["A>3"]), NONE);
}

#[test]
fn a_run_that_stopped_is_not_ranked() {
    // 1 / (3 − 2) is the largest quotient but for those of A = 2, which stop.
    let table = products(QUOTIENT);
    assert!(table.rows[2].has_failed() && !table.rows[4].has_failed());
    assert_eq!(front(&table, &[maximize("final_C")], &[]), [5]);
    assert_eq!(front(&table, &[minimize("B")], &["A=2"]), NONE);
}

#[test]
fn a_run_without_the_number_is_not_ranked() {
    // No run falls: there is no time of a first fall.
    assert_eq!(
        front(&products(PRODUCT), &[maximize("first_fall")], &[]),
        NONE
    );
    assert_eq!(
        front(&products(PRODUCT), &[maximize("A")], &["first_fall>0"]),
        NONE
    );
}

#[test]
fn conditions_have_a_name_an_operator_and_a_number() {
    for (text, below, at, above) in [
        ("a<2", true, false, false),
        ("a<=2", true, true, false),
        ("a>2", false, false, true),
        ("a>=2", false, true, true),
        ("a = 2", false, true, false),
    ] {
        let condition: Condition = text.parse().expect(text);
        let held = [1.0, 2.0, 3.0].map(|value| condition.holds(value));
        assert_eq!(held, [below, at, above], "{text}");
        assert!(!condition.holds(f64::NAN), "{text}");
        assert_eq!(condition.to_string(), text.replace(' ', ""));
    }
    assert_eq!(
        "a>-1e-3".parse::<Condition>().expect("it is one").value,
        -1e-3
    );
    for text in ["", "a", "a=", "=2", "a=b", "a==2", "a<inf", "a!2", "2<a"] {
        let refused = text.parse::<Condition>().expect_err(text).to_string();
        assert!(refused.contains("is not a condition"), "{refused}");
    }
}

#[test]
fn names_that_the_table_lacks_are_refused() {
    let columns = products(PRODUCT).columns;
    let refused = |ranking: Ranking| {
        let refused = ranking.of(&columns).expect_err("there is no such column");
        refused.to_string()
    };
    let goals = vec![maximize("sped")];
    let unknown = refused(Ranking {
        goals,
        ..Ranking::default()
    });
    assert!(
        unknown.starts_with("the table has no numbers `sped`; it has case, A, B, line, "),
        "{unknown}"
    );
    assert!(unknown.ends_with("did you mean speed?"), "{unknown}");
    // Text cannot be ranked.
    let conditions = vec!["end=1".parse().expect("it is one")];
    refused(Ranking {
        conditions,
        ..Ranking::default()
    });
    // Without mass there is no energy.
    refused(Ranking {
        goals: vec![minimize("energy")],
        ..Ranking::default()
    });
}

#[test]
fn a_walking_robot_is_ranked_by_speed() {
    let columns = products(PRODUCT).columns;
    let ranking = Ranking::default().of(&columns).expect("a ranking");
    assert_eq!(ranking.goals, [maximize("speed")]);
}

#[test]
fn goals_are_saved_and_bind_no_row() {
    let sweep = Sweep::new(spec(PRODUCT, &["A=1,2"])).expect("a sweep");
    let ranking = Ranking {
        goals: vec![maximize("A"), minimize("time")],
        conditions: vec!["falls=0".parse().expect("it is one")],
    };
    let text = Saved::of(&sweep, ranking.clone()).text();
    let read = Saved::read(text.as_bytes()).expect("it is its own");
    assert_eq!(read.ranking, ranking);
    assert!(read.is_of(&sweep));
    // An older file has none.
    let mut json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    json.as_object_mut().expect("an object").remove("ranking");
    let read = Saved::read(json.to_string().as_bytes()).expect("an older file");
    assert_eq!(read.ranking, Ranking::default());
}

/// The masses of the description are 8 kg for the body and 0.3 + 0.3 + 0.2 kg for each of six legs.
#[test]
fn speed_and_cost_of_transport_follow_from_the_other_columns() {
    let table = rows(Spec {
        robot: RobotSpec::Description(HEXAPOD.to_owned()),
        plant: PlantSpec::Dynamic,
        until: 3.0,
        ..spec(TRIPOD, &[])
    });
    let number = |name: &str| numbers(&table, name)[0];
    let near =
        |one: f64, other: f64| assert!((one - other).abs() < 1e-9 * other.abs(), "{one} {other}");
    assert!(number("forward") > 10.0);
    near(number("speed"), number("forward") / number("time"));
    let way = number("forward").hypot(number("right")) / 1000.0;
    near(number("cost"), number("energy") / (12.8 * 9.80665 * way));
}
