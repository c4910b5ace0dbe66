//! Programs in which a form of the language is repeated, and all that reads programs.

use crate::units::{FORMS, HEAD, PIECES, statements};
use crate::{dap, lsp};
use tip_lint::cycles::{Sampling, human, parts};
use tip_lint::migrate::migrate_to;
use tip_lint::repair::{confirm, preview};
use tip_lint::{format, load};
use tipc::diagnostic::Applicability;
use tipc::emit;
use tipc::language::Edition;
use tipc::source::Encoding;
use tipc::{Options, Robot};

/// A reader of programs and its name. It returns false if it has nothing to do with a program.
pub type Reader = (&'static str, fn(&str) -> bool);

/// `tip check`.
pub const CHECK: Reader = ("check", check);
const FMT: Reader = ("fmt", fmt);
const LSP: Reader = ("lsp", edit);
/// `tip cycles`.
pub const CYCLES: Reader = ("cycles", cycles);
const MIGRATE: Reader = ("migrate", migrate);
const DAP: Reader = ("dap", debug);
const EMIT: Reader = ("emit", emit);

/// All readers.
pub const ALL: [Reader; 7] = [CHECK, FMT, LSP, CYCLES, MIGRATE, DAP, EMIT];

fn options() -> Options {
    Options::default()
}

fn check(text: &str) -> bool {
    drop(load("test.prg", text.as_bytes(), &options()));
    true
}

/// Tries all fixes. Their number is bounded by the bytes that are read again, not by the text (`bounded` of tip-lint).
pub fn fix(text: &str) {
    let loaded = load("test.prg", text.as_bytes(), &options());
    if !loaded.diagnostics.is_empty() {
        drop(confirm(loaded.clone(), &options()));
        drop(preview(loaded, &options(), Applicability::Likely));
    }
}

fn fmt(text: &str) -> bool {
    drop(format::format("test.prg", text.as_bytes(), &options()));
    true
}

fn cycles(text: &str) -> bool {
    let program = tipc::load("test.prg", text.as_bytes(), &options()).program;
    let Some(program) = program else {
        return false;
    };
    let sampling = Sampling::of(Robot::default());
    drop(human(&program, &parts(&program, sampling), sampling));
    true
}

fn emit(text: &str) -> bool {
    let program = tipc::load("test.prg", text.as_bytes(), &options()).program;
    let Some(program) = program else {
        return false;
    };
    assert!(emit::pretty(&program, &emit::Options::default()).is_ok());
    true
}

fn migrate(text: &str) -> bool {
    let Some(rest) = text.strip_prefix("3.1") else {
        return false;
    };
    drop(migrate_to(
        Edition::V3_2,
        "test.prg",
        text.as_bytes(),
        Encoding::Auto,
    ));
    let older = format!("2.0{rest}");
    drop(migrate_to(
        Edition::V3_1,
        "test.prg",
        older.as_bytes(),
        Encoding::Auto,
    ));
    true
}

fn edit(text: &str) -> bool {
    lsp::edit(text);
    true
}

fn debug(text: &str) -> bool {
    dap::debug(text, &["V > 3", "V + 1", "C1 + C2", "NONE"])
}

/// A form that is repeated.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Edition of the program.
    pub edition: Edition,
    /// The form. `{n}` is the number of the repetition.
    pub text: String,
    /// Text between two repetitions.
    pub between: &'static str,
    /// Number of repetitions of the shorter program.
    pub count: usize,
}

impl Unit {
    /// Returns edition, form and separator.
    pub fn name(&self) -> String {
        format!("{} {:?} {:?}", self.edition, self.text, self.between)
    }

    /// Returns a program with so many repetitions.
    pub fn program(&self, count: usize) -> String {
        let mut text = format!("{}\nT\n{HEAD}", self.edition);
        for number in 0..count {
            let scattered = number * 7_919 % count;
            let one = self.text.replace("{n}", &number.to_string());
            let one = one.replace("{m}", &scattered.to_string());
            text += &one.replace("{t}", &(number + 1).to_string());
            text += self.between;
        }
        text + "\nEND\n"
    }
}

fn unit(edition: Edition, text: &str, between: &'static str, count: usize) -> Unit {
    Unit {
        edition,
        text: text.to_owned(),
        between,
        count,
    }
}

/// Returns every form on lines of its own. Each reader has it in one edition; what 3.1 lacks is an unknown word there.
pub fn forms() -> Vec<(Unit, Reader)> {
    let units = FORMS.iter().enumerate().flat_map(|(index, text)| {
        ALL.into_iter().enumerate().map(move |(turn, reader)| {
            let edition = match (index + turn) % 2 {
                0 => Edition::V3_1,
                _ => Edition::V3_2,
            };
            (unit(edition, text, "\n", 30), reader)
        })
    });
    units.collect()
}

/// Returns the statements of both editions. They are many, so each goes through one reader on lines and one along a line.
pub fn all_statements() -> Vec<(Unit, Reader)> {
    let of = |edition: &Edition| {
        let statements = statements(*edition).into_iter().enumerate();
        let units = statements.flat_map(|(index, text)| {
            let turn = index + usize::from(*edition == Edition::V3_2);
            let lines = unit(*edition, &text, "\n", 3);
            let between = if index % 2 == 0 { "; " } else { " " };
            let line = unit(*edition, &text, between, 8);
            [
                (lines, ALL[turn % ALL.len()]),
                (line, [CHECK, FMT][turn % 2]),
            ]
        });
        units.collect::<Vec<_>>()
    };
    Edition::ALL.iter().flat_map(of).collect()
}

/// Returns pieces that are repeated along a line.
pub fn pieces() -> Vec<(Unit, Reader)> {
    let of = |edition: &Edition| {
        let units = PIECES
            .iter()
            .flat_map(|piece| [CHECK, FMT].map(|reader| (unit(*edition, piece, "", 300), reader)));
        units.collect::<Vec<_>>()
    };
    Edition::ALL.iter().flat_map(of).collect()
}

/// Returns forms whose cost shows in long programs only.
pub fn long_programs() -> Vec<(Unit, Reader)> {
    let [first, next] = [Edition::V3_1, Edition::V3_2];
    let units = [
        (unit(first, "SET_A_MAX F1 -1", "\n", 2_000), vec![MIGRATE]),
        (unit(first, "A_", "", 15_000), vec![CHECK, FMT]),
        (unit(first, "A\u{FF1A}", "", 5_000), vec![CHECK, FMT]),
        (unit(first, "DEF_VAR A ", "", 5_000), vec![CHECK, FMT]),
        (unit(first, "IF V > -1 GOTO L:", "\n", 120), vec![CHECK]),
        (
            unit(first, "L{n}:\nIF V > 1 GOSUB L{m}:", "\n", 120),
            vec![CHECK],
        ),
        (
            unit(first, "L{n}: REM\nIF KB_HIT GOTO L{m}:", "\n", 400),
            vec![CYCLES],
        ),
        (
            unit(first, "FOR V = 0.5 TO 999{n}.7 STEP 0.01\nNEXT", "\n", 100),
            vec![CYCLES],
        ),
        (unit(next, "DEFINE C{n} {n}", "\n", 500), vec![CHECK]),
        (
            unit(next, "DEFINE C{n} {n} ; SLEEP C{n}", "\n", 500),
            vec![DAP],
        ),
    ];
    let pairs = units
        .into_iter()
        .flat_map(|(unit, readers)| readers.into_iter().map(move |it| (unit.clone(), it)));
    pairs.collect()
}
