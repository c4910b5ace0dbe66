//! Keys and screens of the debugger.

use super::{App, press as press_key, screen as view};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tip_sim::Robot;
use tip_sim::debug::{DebugError, Debugger, Reason};
use tipc::message::Lang;

const PROGRAM: &str = "3.1
歩く練習
DEF_VAR N
DEF_POS P
N = 0
L:
GOSUB COUNT:
MESSAGE 歩数 %N%
PTP F1 R 0 0 10
IF N < 5 GOTO L:
EXIT
COUNT:
N += 1
TEACH_POS F1 P
RETURN
END
";

fn app(robot: &str, lang: Lang) -> App {
    app_of(robot, PROGRAM, lang)
}

fn app_of(robot: &str, text: &str, lang: Lang) -> App {
    let robot = Robot::named(robot).expect("it has a name");
    let mut loaded = tip_lint::load("walk.prg", text.as_bytes(), &robot.options());
    let program = loaded.program.take().expect("it is right");
    let debugger = Debugger::new(program, &robot).expect("it is for this robot");
    App::new(debugger, loaded.source, &robot, lang)
}

fn screen(app: &App, width: u16, height: u16) -> String {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).expect("memory");
    terminal
        .draw(|frame| view::draw(app, frame))
        .expect("memory");
    let shown = terminal.backend().to_string();
    // A blank follows each wide character.
    shown.replace(' ', "")
}

fn line_and_n(app: &App) -> (u32, Result<Option<f64>, DebugError>) {
    (app.debugger.line(), app.debugger.value("N"))
}

fn press(app: &mut App, keys: &str) {
    for char in keys.chars() {
        let code = match char {
            '\n' => KeyCode::Enter,
            '\u{1B}' => KeyCode::Esc,
            other => KeyCode::Char(other),
        };
        press_key(app, KeyEvent::new(code, KeyModifiers::NONE));
        while app.is_going() {
            app.work(1000);
        }
    }
}

#[test]
fn keys_go_forwards_and_back() {
    let mut app = app("titan8", Lang::English);
    assert_eq!((app.debugger.line(), app.cursor), (5, 5));
    press(&mut app, "nns");
    assert_eq!((app.debugger.line(), app.cursor), (12, 12));
    press(&mut app, "oN");
    assert_eq!(app.debugger.line(), 7);
    press(&mut app, "g20\n");
    assert_eq!(app.debugger.now(), 20);
    press(&mut app, "cC");
    assert_eq!(app.debugger.now(), 20);
    // To the line of the cursor, both ways.
    app.cursor = 14;
    press(&mut app, "l");
    assert_eq!(app.debugger.line(), 14);
    app.cursor = 9;
    press(&mut app, "L");
    assert_eq!(app.debugger.line(), 9);
    press(&mut app, "r");
    assert!(matches!(app.debugger.stop().reason, Reason::Ended(_)));
    press(&mut app, "R");
    assert_eq!(app.debugger.now(), 0);
    press(&mut app, "q");
    assert!(app.is_over);
}

#[test]
fn breakpoints_watches_and_values_are_asked_for() {
    let mut app = app("titan8", Lang::English);
    app.cursor = 13;
    press(&mut app, "BN >= 3\n\nr");
    assert_eq!(line_and_n(&app), (13, Ok(Some(3.0))));
    assert!(screen(&app, 80, 24).contains("breakpoint"));
    press(&mut app, "eN * 2\n");
    assert_eq!(app.answer.as_deref(), Some("N * 2 = 6"));
    press(&mut app, "b");
    assert!(app.breakpoints.is_empty());
    press(&mut app, "wn\nR");
    assert_eq!(line_and_n(&app), (13, Ok(Some(2.0))));
    press(&mut app, "W p\n");
    assert_eq!(line_and_n(&app), (14, Ok(Some(2.0))));
    assert!(screen(&app, 80, 24).contains("assignedbyline14"));
    press(&mut app, "wHEIGHT\n");
    assert!(app.answer.is_some());
    // A question that is not answered changes nothing.
    press(&mut app, "g99\u{1B}");
    assert_eq!(app.question, None);
    press(&mut app, "gx\n");
    assert_eq!(app.answer.as_deref(), Some("`x` is not a cycle"));
}

#[test]
fn a_breakpoint_stops_at_the_passes_that_count() {
    let mut app = app("titan8", Lang::English);
    app.cursor = 13;
    // Among the turns with N of 1 to 4 the second is that with 2.
    press(&mut app, "BN >= 1\n2\nr");
    assert_eq!(app.debugger.value("N"), Ok(Some(2.0)));
    press(&mut app, "r");
    assert!(matches!(app.debugger.stop().reason, Reason::Ended(_)));
    // An invalid count is refused, and the breakpoint stays.
    app.cursor = 13;
    press(&mut app, "B\noften\n");
    assert!(app.answer.as_deref().is_some_and(|it| it.contains("often")));
    press(&mut app, "R");
    assert_eq!(app.debugger.value("N"), Ok(Some(2.0)));
}

#[test]
fn a_name_stops_before_each_of_its_steps_until_it_is_given_again() {
    let mut app = app("titan8", Lang::English);
    press(&mut app, "fptp\nr");
    assert_eq!(line_and_n(&app), (9, Ok(Some(1.0))));
    // Line 9 is marked wherever the program is paused.
    assert!(screen(&app, 80, 24).contains("●▶9"));
    press(&mut app, "r");
    assert_eq!(line_and_n(&app), (9, Ok(Some(2.0))));
    press(&mut app, "fPTP\nr");
    assert!(matches!(app.debugger.stop().reason, Reason::Ended(_)));
    press(&mut app, "fdance\n");
    assert!(app.answer.as_deref().is_some_and(|it| it.contains("DANCE")));
}

#[test]
fn every_variable_can_be_seen_however_many_there_are() {
    let names: Vec<String> = (10..70).map(|number| format!("V{number}")).collect();
    let text = format!("3.1\nmany\nDEF_VAR {}\nV69 = 7\nEND\n", names.join(", "));
    let mut app = app_of("titan8", &text, Lang::English);
    press(&mut app, "n");
    let mut seen = String::new();
    for page in 1..=7 {
        let shown = screen(&app, 80, 24);
        assert!(shown.contains("(Tab)"), "page {page} in\n{shown}");
        seen += &shown;
        press_key(&mut app, KeyEvent::new(KeyCode::Tab, KeyModifiers::NONE));
    }
    for name in &names {
        assert!(seen.contains(name.as_str()), "{name} in\n{seen}");
    }
    assert!(seen.contains("V697"), "{seen}");
    // With room for all of them there are no pages.
    assert!(!screen(&app, 200, 80).contains("(Tab)"));
}

#[test]
fn a_watched_variable_is_on_the_first_page() {
    let names: Vec<String> = (10..70).map(|number| format!("V{number}")).collect();
    let text = format!("3.1\nmany\nDEF_VAR {}\nV69 = 7\nEND\n", names.join(", "));
    let mut app = app_of("titan8", &text, Lang::English);
    press(&mut app, "n");
    assert!(!screen(&app, 80, 24).contains("V697"));
    press(&mut app, "wV69\n");
    assert!(screen(&app, 80, 24).contains("V697"));
}

#[test]
fn a_question_mark_explains_the_keys_until_the_next_key() {
    for lang in [Lang::English, Lang::Japanese] {
        let mut app = app("titan8", lang);
        press(&mut app, "?");
        let shown = screen(&app, 80, 24);
        // Each key that moves, sets or asks for something, and nothing of the program.
        for key in "rRnNsSoOcCtlLgbBfwWieq".chars() {
            assert!(shown.contains(key), "{key} in\n{shown}");
        }
        assert!(!shown.contains("歩数"), "{shown}");
        press(&mut app, "n");
        assert_eq!(app.debugger.now(), 0);
        assert!(screen(&app, 80, 24).contains("歩数"));
    }
}

#[test]
fn both_views_name_their_axes() {
    let shown = screen(&app("titan8", Lang::English), 80, 24);
    for title in ["Fromabovex→y↑", "Sidey→z↑"] {
        assert!(shown.contains(title), "{title} in\n{shown}");
    }
}

#[test]
fn a_change_of_the_past_asks_first() {
    let mut app = app("titan8", Lang::English);
    press(&mut app, "rg20\niN = 1\n");
    assert!(screen(&app, 120, 40).contains("wouldbediscarded"));
    let known = app.debugger.known();
    press(&mut app, "n");
    assert_eq!(app.debugger.known(), known, "no is no, and no step");
    press(&mut app, "iN = 1\ny");
    assert_eq!(
        (app.debugger.known(), app.debugger.value("N")),
        (20, Ok(Some(1.0)))
    );
    press(&mut app, "ijump\n");
    assert!(app.answer.is_some());
    press(&mut app, "ikey F\n");
    assert_eq!(app.debugger.changes().to_string(), "20:set N=1, 20:key F");
}

#[test]
fn the_screen_shows_the_program_and_the_robot_in_both_sizes_and_languages() {
    for (lang, words) in [
        (
            Lang::English,
            [
                "Variables",
                "Calls",
                "Modesandtargets",
                "Fromabove",
                "Side",
                "Messages",
            ],
        ),
        (
            Lang::Japanese,
            [
                "変数",
                "呼び出し",
                "制御モードと目標",
                "上面図",
                "側面図",
                "メッセージ",
            ],
        ),
    ] {
        for (width, height) in [(80, 24), (120, 40)] {
            for robot in ["titan8", "generic"] {
                let mut app = app(robot, lang);
                press(&mut app, "g12\n");
                let shown = screen(&app, width, height);
                for word in words {
                    assert!(shown.contains(word), "{word} in\n{shown}");
                }
                for seen in ["walk.prg", "12/12", "240ms", "▶", "歩数", "F1", "COUNT"] {
                    assert!(shown.contains(seen), "{seen} in\n{shown}");
                }
                // The figure is made of braille.
                assert!(
                    shown
                        .chars()
                        .any(|char| ('\u{2801}'..='\u{28FF}').contains(&char))
                );
            }
        }
    }
}

#[test]
fn hardly_any_room_is_no_reason_to_fail() {
    let mut app = app("generic", Lang::Japanese);
    press(&mut app, "r");
    for (width, height) in [(1, 1), (2, 3), (10, 5), (200, 4), (5, 80)] {
        screen(&app, width, height);
    }
}

#[test]
fn control_c_ends_whatever_is_asked() {
    let mut app = app("titan8", Lang::English);
    press(&mut app, "e");
    press_key(
        &mut app,
        KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL),
    );
    assert!(app.is_over);
}

#[test]
fn threads_timers_and_locks_are_shown_and_t_looks_at_the_next_thread() {
    // After four cycles: main program at line 8, thread at line 11.
    let text = "3.2\ntwo\nDEF_VAR N\nSTART_TIMER 3\nSTART_THREAD SIDE:\nN = 1\nN = 2\nEXIT\nTHREAD SIDE:\nLOCK F1\nN = 5\nTHREADEND\nEND\n";
    let mut app = app_of("titan8", text, Lang::English);
    press(&mut app, "nnnn");
    let shown = screen(&app, 120, 40);
    assert!(shown.contains("▶8"), "{shown}");
    assert!(shown.contains("▷11"), "{shown}");
    assert!(shown.contains("11SIDE"), "{shown}");
    assert!(shown.contains("locked:J11J12J13"), "{shown}");
    assert!(shown.contains("timers3:80ms"), "{shown}");
    press(&mut app, "t");
    assert_eq!((app.debugger.thread(), app.cursor), (1, 11));
    let shown = screen(&app, 120, 40);
    assert!(shown.contains("▶11") && shown.contains("▷8"), "{shown}");
    press(&mut app, "t");
    assert_eq!(app.debugger.thread(), 0);
}
