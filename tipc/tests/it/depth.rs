//! The readers do not recurse with the length of a line or a file: they run with a small stack, which a file of some
//! kilobytes would otherwise overflow. No panic handler catches that.

use std::thread;
use tipc::description::{parse, parse_project, parse_scene};
use tipc::{Options, emit, load};

/// Stack of a reader, bytes: a few times what it takes for a short file.
const STACK: usize = 128 << 10;

/// Number of repetitions; a recursion over them takes several times the stack.
const REPEATED: usize = 2_000;

/// Reads in a thread with a small stack. An overflow ends the test binary.
fn with_stack(size: usize, read: impl FnOnce() + Send + 'static) {
    let thread = thread::Builder::new().stack_size(size).spawn(read);
    thread.expect("a thread starts").join().expect("no panic");
}

/// Returns pieces of programs, good and bad, which follow each other on a line or along lines.
fn pieces() -> Vec<&'static str> {
    vec![
        // Labels, with the colons of either width.
        "A:",
        "A：",
        "Ａ：",
        "A： ",
        ":",
        "：",
        // Declarations.
        "DEF_VAR A ",
        "DEF_POS P,",
        "DEF_VAR A DEF_JOINT Q ",
        "DEF VAR A ",
        "DEF_VAR A-B ",
        "DEFINE A 1 ",
        "DEFINE A B ",
        // Statements.
        "A=1;",
        "A=A+1 ",
        "A+=1",
        "A++ ",
        "A,B=1 ",
        "PTP F1 1 2 3;",
        "PTP F1 1 2 3 ",
        "SLEEP -",
        "SLEEP 1+",
        "MESSAGE %A%;",
        "MESSAGE %",
        "REM;",
        "GOTO A:",
        "CALL A: ;",
        "SUBROUTINE A:;",
        "SUBEND ",
        "THREAD A: ;",
        "END.",
        "unknown ",
        "10 ",
        "# ",
        "/* ",
        "{ ",
        "} ELSE {",
        // Blocks and conditions.
        "IF A == 1 THEN;",
        "IF A = 1 ",
        "IF A > = 1 ",
        "IF A = = ",
        "IF (A) {",
        "ELSEIF KB_HIT THEN;",
        "ELSE IF ",
        "ELSE;",
        "ENDIF;",
        "WHILE !KB_HIT;",
        "WHILE (KB_HIT",
        "WEND;",
        "REPEAT;",
        "UNTIL KB_HIT;",
        "FOR A=1 TO 3;",
        "FOR (A=0;A<3;A++) ",
        "NEXT A ",
        "AND ",
        "NOT ",
        // Characters.
        "(",
        "-",
        "=",
        "!",
        "\"",
        "%",
        "あ",
        "あ ",
        "\u{3000}",
        "\0",
    ]
}

// clauses: 1.2
#[test]
fn a_program_is_read_with_a_small_stack_however_long_its_lines() {
    for (edition, end) in [("3.1", ""), ("3.1", "\n"), ("3.2", ""), ("3.2", "\n")] {
        with_stack(STACK, move || {
            for piece in pieces() {
                let body = format!("{piece}{end}").repeat(REPEATED);
                let text = format!("{edition}\ntitle\n{body}\nEND\n");
                let loaded = load("long.prg", text.as_bytes(), &Options::default());
                if let Some(program) = &loaded.program {
                    assert!(!emit::emit(program, &emit::Options::default()).is_empty());
                }
            }
        });
    }
}

// clauses: 1.2
#[test]
fn each_of_many_labels_and_declarations_on_a_line_is_read() {
    with_stack(STACK, || {
        let labels: String = (0..REPEATED).map(|n| format!("L{n}：")).collect();
        let declared: String = (0..REPEATED).map(|n| format!("DEF_VAR V{n} ")).collect();
        let text = format!("3.1\ntitle\n{declared}\n{labels}\nEND\n");
        let loaded = load("long.prg", text.as_bytes(), &Options::default());
        let defined = |start: &str| {
            let names = loaded
                .symbols
                .definitions()
                .iter()
                .map(|it| it.name.as_str());
            names
                .filter(|name| name.starts_with(start) && *name != "VAR_KEY")
                .count()
        };
        assert_eq!((defined("L"), defined("V")), (REPEATED, REPEATED));
    });
}

#[test]
fn a_file_of_toml_is_read_with_a_small_stack_however_deep() {
    // The library goes 80 levels deep, with large frames when it is not optimised.
    let deep = |open: &str, middle: &str, close: &str| {
        let (opens, closes) = (open.repeat(10 * REPEATED), close.repeat(10 * REPEATED));
        format!("{opens}{middle}{closes}\n")
    };
    let texts = [
        deep("a.", "a = 1", ""),
        format!("[{}", deep("a.", "a]", "")),
        format!("[[{}", deep("a .\t", "a]]", "")),
        format!("a = {{ {}", deep("b.", "b = 1 }", "")),
        format!("a = {}", deep("[", "", "]")),
        format!("a = {}", deep("{b = ", "1", "}")),
        deep("a = [", "", "]"),
        deep("[", "a", "]"),
        deep("[a]\n", "", ""),
        deep("[[leg]]\n", "", ""),
    ];
    with_stack(16 * STACK, move || {
        for text in texts {
            let bytes = text.as_bytes();
            assert!(parse("robot.toml", bytes).is_err());
            assert!(parse_scene("scene.toml", bytes).is_err());
            assert!(parse_project("tip.toml", bytes, |_| true).is_err());
        }
    });
}
