//! The statements that are not commands with arguments: control, equations, conditions, labels, texts.

use super::equation;
use super::written::Names;
use tipc::language::commands::{COMMANDS, Form};
use tipc::syntax::{Condition, Operand, OperandKind, Relation, StatementKind, Then, VariableKind};

/// A form as text.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Sentence {
    /// The command, or what the statement is called.
    pub name: &'static str,
    /// Part after the name; the whole for others.
    pub text: String,
}

/// Names of equations, conditions and labels in the table.
pub const EQUATION: &str = "equation";
pub const CONDITION: &str = "condition";
pub const LABEL: &str = "label";
/// Names of the hand's native commands, which SPECIAL runs.
pub const NATIVE: &str = "native command";

/// Their numbers ([7.48]).
const NUMBERS: [u8; 12] = [1, 2, 5, 6, 10, 11, 12, 13, 14, 15, 16, 20];

fn sentence(name: &'static str, text: impl Into<String>) -> Sentence {
    Sentence {
        name,
        text: text.into(),
    }
}

/// Every form.
pub fn all() -> Vec<Sentence> {
    let mut all: Vec<Sentence> = Vec::new();
    for command in COMMANDS {
        if let Form::Words(text) = command.form {
            all.extend(expanded(text).map(|text| sentence(command.name, text)));
        }
    }
    all.extend(["MESSAGE", "F_MESSAGE"].map(|name| sentence(name, "text with %VAR%")));
    all.extend(NUMBERS.map(native));
    all.push(sentence(LABEL, "name:"));
    all.extend(conditions());
    all.extend(
        equation::all()
            .into_iter()
            .map(|text| sentence(EQUATION, text)),
    );
    all
}

/// The forms of what the table says in one line: `a [b]` is two, and so is `a B | C`.
fn expanded(text: &str) -> impl Iterator<Item = String> {
    let mut alternatives = text.split(" | ");
    let first = alternatives.next().unwrap_or_default();
    let shared = first.rsplit_once(' ').map_or("", |(shared, _)| shared);
    let joined: Vec<String> = alternatives
        .map(|rest| format!("{shared} {rest}"))
        .collect();
    std::iter::once(first.to_owned())
        .chain(joined)
        .flat_map(|form| match form.split_once('[') {
            Some((before, rest)) => vec![
                before.trim().to_owned(),
                format!("{before}{}", rest.replace(']', "")),
            ],
            None => vec![form],
        })
}

const RELATIONS: [(Relation, &str); 6] = [
    (Relation::Eq, "S == S"),
    (Relation::Ne, "S <> S"),
    (Relation::Lt, "S < S"),
    (Relation::Gt, "S > S"),
    (Relation::Le, "S <= S"),
    (Relation::Ge, "S >= S"),
];

/// Event flags, each of a family for all of its kind.
const FLAGS: [&str; 10] = [
    "HALT_REQUEST",
    "KB_HIT",
    "INPOS_F",
    "INPOS_J",
    "INPOS_ALL",
    "NEAR_F",
    "NEAR_J",
    "NEAR_ALL",
    "SPECIAL_FLAG",
    "ANTENNA_ON",
];

fn conditions() -> impl Iterator<Item = Sentence> {
    let relations = RELATIONS.map(|(_, text)| text.to_owned());
    let flags = FLAGS
        .iter()
        .flat_map(|flag| [(*flag).to_owned(), format!("!{flag}")]);
    relations
        .into_iter()
        .chain(flags)
        .map(|text| sentence(CONDITION, text))
}

/// The forms that a parsed statement shows, if it is one of these.
pub fn shown(kind: &StatementKind, names: &Names) -> Vec<Sentence> {
    use StatementKind as Kind;
    let one = |name, text: &str| vec![sentence(name, text)];
    match kind {
        Kind::Define { kind, .. } => one(define(*kind), "name, name, …"),
        Kind::Label(_) => one(LABEL, "name:"),
        Kind::Equation(equation) => vec![sentence(EQUATION, equation::of(equation, names))],
        Kind::If {
            condition, then, ..
        } => {
            let text = match then {
                Then::Block => "condition THEN",
                Then::Goto(jump) if jump.label.is_none() => "condition GOTO",
                Then::Goto(_) => "condition GOTO label:",
                Then::Gosub(_) => "condition GOSUB label:",
            };
            vec![sentence("IF", text), of_condition(condition)]
        }
        Kind::ElseIf { condition, .. } => {
            vec![
                sentence("ELSEIF", "condition THEN"),
                of_condition(condition),
            ]
        }
        Kind::While { condition, .. } => {
            vec![sentence("WHILE", "condition"), of_condition(condition)]
        }
        Kind::Until { condition, .. } => {
            vec![sentence("UNTIL", "condition"), of_condition(condition)]
        }
        Kind::For { counting, .. } if counting.step.is_none() => one("FOR", "VAR = S TO S"),
        Kind::For { .. } => one("FOR", "VAR = S TO S STEP S"),
        Kind::Next { variable: None, .. } => one("NEXT", ""),
        Kind::Next { .. } => one("NEXT", "VAR"),
        Kind::Subroutine { .. } => one("SUBROUTINE", "name:"),
        Kind::Call(_) => one("CALL", "name:"),
        Kind::Gosub(_) => one("GOSUB", "label:"),
        Kind::Goto(jump) if jump.label.is_none() => one("GOTO", ""),
        Kind::Goto(_) => one("GOTO", "label:"),
        Kind::Message { text } => one("MESSAGE", of_text(&text.node)),
        Kind::FileMessage { text } => one("F_MESSAGE", of_text(&text.node)),
        // Its text is not kept.
        Kind::Rem => vec![sentence("REM", ""), sentence("REM", "text")],
        Kind::Else => one("ELSE", ""),
        Kind::EndIf => one("ENDIF", ""),
        Kind::Wend => one("WEND", ""),
        Kind::Repeat => one("REPEAT", ""),
        Kind::SubEnd => one("SUBEND", ""),
        Kind::Return => one("RETURN", ""),
        Kind::End => one("END", ""),
        Kind::Exit => one("EXIT", ""),
        Kind::Constant { .. } => one("DEFINE", "name constant"),
        Kind::Thread { .. } => one("THREAD", "name:"),
        Kind::ThreadEnd => one("THREADEND", ""),
        Kind::StartThread(_) => one("START_THREAD", "name:"),
        Kind::StopThread(_) => one("STOP_THREAD", "name:"),
        Kind::WaitThread(_) => one("WAIT_THREAD", "name:"),
        Kind::Command { .. } | Kind::Broken(_) => Vec::new(),
    }
}

/// Returns the form of a message's text.
fn of_text(text: &str) -> &'static str {
    match text.matches('%').count() {
        _ if text.is_empty() => "",
        0 | 1 => "text",
        _ => "text with %VAR%",
    }
}

fn define(kind: VariableKind) -> &'static str {
    match kind {
        VariableKind::Var => "DEF_VAR",
        VariableKind::Pos => "DEF_POS",
        VariableKind::Joint => "DEF_JOINT",
    }
}

/// Returns true if a place is in a statement's condition.
pub fn condition_holds(kind: &StatementKind, place: usize) -> bool {
    use StatementKind::{ElseIf, If, Until, While};
    let (If { condition, .. }
    | ElseIf { condition, .. }
    | While { condition, .. }
    | Until { condition, .. }) = kind
    else {
        return false;
    };
    let span = match &**condition {
        Condition::Compare { left, right, .. } => left.span.to(right.span),
        Condition::Flag { name, .. } => name.span,
    };
    (span.start..span.end).contains(&place)
}

fn of_condition(condition: &Condition) -> Sentence {
    let text = match condition {
        Condition::Compare { relation, .. } => RELATIONS
            .iter()
            .find(|(known, _)| known == relation)
            .map(|(_, text)| (*text).to_owned()),
        Condition::Flag { name, negated } => {
            let not = if *negated { "!" } else { "" };
            let family = FLAGS
                .iter()
                .rev()
                .find(|flag| name.node.starts_with(**flag));
            family.map(|flag| format!("{not}{flag}"))
        }
    };
    sentence(CONDITION, text.unwrap_or_default())
}

fn native(number: u8) -> Sentence {
    sentence(NATIVE, format!("SPECIAL {number}"))
}

/// The native command that a SPECIAL with these arguments runs.
pub fn native_shown(arguments: &[Operand]) -> Option<Sentence> {
    match arguments.first()?.kind {
        OperandKind::Number(number) => Some(native(number as u8)),
        OperandKind::Name(_) | OperandKind::Member(_) => None,
    }
}

/// END.
pub fn end() -> Sentence {
    sentence("END", "")
}

/// The forms that a statement was going to be, which the parser has refused.
pub fn meant(text: &str, names: &Names) -> Vec<Sentence> {
    let text = text.to_ascii_uppercase();
    if text.contains('=') && !all().iter().any(|form| text.starts_with(form.name)) {
        let forms = equation::meant(&text, names).into_iter();
        return forms.map(|text| sentence(EQUATION, text)).collect();
    }
    let mut words = text.split_whitespace();
    let keyword = words.next().unwrap_or_default();
    let words: Vec<&str> = words.collect();
    let mut forms: Vec<Sentence> = all()
        .into_iter()
        .filter(|form| form.name == keyword)
        .collect();
    for particle in ["THEN", "GOTO", "GOSUB", "STEP"] {
        if words.contains(&particle) {
            forms.retain(|form| form.text.contains(particle));
        }
    }
    if words.is_empty() || !words.contains(&"STEP") {
        forms.retain(|form| !form.text.contains("STEP"));
    }
    if !words.is_empty() && forms.len() > 1 {
        forms.retain(|form| !form.text.is_empty());
    }
    forms
}
