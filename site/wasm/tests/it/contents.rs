//! The examples and lessons of the playground: each program is there, in both languages, and does what its lesson says.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use tip_playground::{Text, Wanted};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{Interpreter, Limit, Run};

type Texts<T> = (T, T);
type Range = (f64, f64);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Contents {
    robots: BTreeMap<String, Setting>,
    examples: Vec<Example>,
    lessons: Vec<Lesson>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Setting {
    title: Texts<String>,
    robot: Text,
    scene: Option<Text>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Example {
    program: String,
    robot: String,
    #[serde(default)]
    events: String,
    title: Texts<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Lesson {
    program: String,
    robot: String,
    #[serde(default)]
    events: String,
    title: Texts<String>,
    text: Texts<Vec<String>>,
    r#try: Texts<String>,
    /// Expected result of the unchanged program.
    shows: Shows,
    /// Replacements that the lesson asks for, made everywhere in the text.
    #[serde(default)]
    change: Vec<(String, String)>,
    changed_events: Option<String>,
    /// Expected result after the replacements.
    changed: Shows,
}

/// Expected results of a run. Lengths in mm, from the least to the greatest.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Shows {
    says: Option<Vec<String>>,
    cycles: Option<u64>,
    ends: Option<String>,
    #[serde(default)]
    errors: Vec<String>,
    falls: Option<u64>,
    forward: Option<Range>,
    up: Option<Range>,
    slip: Option<Range>,
    margin: Option<Range>,
    lifted: Option<Range>,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn file(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn contents() -> Contents {
    serde_json::from_str(&file("site/contents.json")).expect("contents as the page reads them")
}

/// A name that is a path is that of a file.
fn filled(text: &Text) -> Text {
    Text {
        name: text.name.clone(),
        text: text.name.contains('/').then(|| file(&text.name)),
    }
}

fn wanted(contents: &Contents, robot: &str, program: &str, events: &str) -> Wanted {
    let setting = &contents.robots[robot];
    Wanted {
        program: Text {
            name: "program.prg".to_owned(),
            text: Some(program.to_owned()),
        },
        robot: filled(&setting.robot),
        scene: setting.scene.as_ref().map(filled),
        events: events.to_owned(),
        cycles: None,
    }
}

fn is_within(value: f64, range: Option<Range>) -> bool {
    range.is_none_or(|(least, most)| (least..=most).contains(&value))
}

#[track_caller]
fn holds(lesson: &str, wanted: &Wanted, shows: &Shows) {
    let bench = wanted.bench();
    let bench = bench.unwrap_or_else(|error| panic!("{lesson}: {error}"));
    let diagnostics = bench.loaded.diagnostics.iter();
    let found: Vec<&str> = diagnostics.map(|diagnostic| diagnostic.id()).collect();
    assert_eq!(found, shows.errors, "{lesson}");
    let Some(program) = bench.loaded.program.clone() else {
        return;
    };
    let run = Run::new(Interpreter::new(program), bench.robot.clone()).expect("for this robot");
    let mut run = run.with_events(&bench.events).expect("events that happen");
    let limit = 100_000;
    let mut said = Vec::new();
    while run.ending().is_none() && run.cycles() < limit {
        said.extend(run.cycle().messages);
    }
    let ends = match run.ending() {
        Some(Ending::Program(End::End)) => "END",
        Some(Ending::Program(End::Exit)) => "EXIT",
        ending => panic!("{lesson}: {ending:?}"),
    };
    assert!(
        shows.ends.as_ref().is_none_or(|shown| shown == ends),
        "{lesson}: {ends}"
    );
    assert!(
        shows.cycles.is_none_or(|cycles| cycles == run.cycles()),
        "{lesson}: {}",
        run.cycles()
    );
    assert!(
        shows.says.as_ref().is_none_or(|shown| *shown == said),
        "{lesson}: {said:?}"
    );
    let grasp = run.grasp();
    let object = grasp.as_ref().and_then(|grasp| grasp.objects.first());
    let lifted = object.map_or(0.0, |object| object.highest);
    assert!(
        is_within(lifted, shows.lifted),
        "{lesson}: lifted by {lifted}"
    );
    let Some(motion) = run.motion() else {
        return;
    };
    assert!(
        shows
            .falls
            .is_none_or(|falls| falls == u64::from(motion.falls)),
        "{lesson}: {motion:?}"
    );
    let figures = [
        (motion.travel.y, shows.forward),
        (motion.travel.z, shows.up),
        (motion.slip, shows.slip),
        (motion.least_margin, shows.margin),
    ];
    assert!(
        figures
            .iter()
            .all(|(value, range)| is_within(*value, *range)),
        "{lesson}: {motion:?}"
    );
}

#[test]
fn each_lesson_does_what_it_says_and_what_it_asks_for_does_too() {
    let contents = contents();
    assert_eq!(contents.lessons.len(), 11);
    for lesson in &contents.lessons {
        let text = file(&lesson.program);
        let first = wanted(&contents, &lesson.robot, &text, &lesson.events);
        holds(&lesson.program, &first, &lesson.shows);

        let changed = lesson.change.iter().fold(text.clone(), |text, (from, to)| {
            assert!(text.contains(from), "{}: {from}", lesson.program);
            text.replace(from, to)
        });
        let events = lesson.changed_events.as_ref().unwrap_or(&lesson.events);
        assert!(
            changed != text || *events != lesson.events,
            "{}",
            lesson.program
        );
        let second = wanted(&contents, &lesson.robot, &changed, events);
        holds(&lesson.program, &second, &lesson.changed);
    }
}

#[test]
fn every_text_is_there_in_english_and_japanese() {
    fn check((english, japanese): &Texts<String>) {
        assert!(
            english.is_ascii() || english.contains(['−', '×']),
            "{english}"
        );
        assert!(
            japanese.chars().any(|letter| letter > '\u{3000}'),
            "{japanese}"
        );
    }
    let contents = contents();
    contents
        .robots
        .values()
        .for_each(|robot| check(&robot.title));
    contents
        .examples
        .iter()
        .for_each(|example| check(&example.title));
    for lesson in &contents.lessons {
        check(&lesson.title);
        check(&lesson.r#try);
        let (english, japanese) = &lesson.text;
        assert_eq!(english.len(), japanese.len(), "{}", lesson.program);
        for pair in english.iter().zip(japanese) {
            check(&(pair.0.clone(), pair.1.clone()));
        }
    }
}

#[test]
fn each_example_runs_without_a_finding() {
    let contents = contents();
    for Example {
        program,
        robot,
        events,
        ..
    } in &contents.examples
    {
        let wanted = wanted(&contents, robot, &file(program), events);
        let bench = wanted
            .bench()
            .unwrap_or_else(|error| panic!("{program}: {error}"));
        let found: Vec<_> = bench.loaded.diagnostics.iter().map(|it| it.id()).collect();
        assert_eq!(found, [""; 0], "{program}");
        let run = Run::new(
            Interpreter::new(bench.loaded.program.expect("a program")),
            bench.robot,
        );
        let run = run.expect("for this robot").with_events(&bench.events);
        let mut run = run.expect("events that happen");
        let ending = run.to_end(Limit::cycles(100_000));
        assert!(
            matches!(ending, Ending::Program(_)),
            "{program}: {ending:?}"
        );
    }
}
