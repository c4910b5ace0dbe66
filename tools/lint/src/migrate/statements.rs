//! The rules for labels and statements: commands that got another name or another form, values in MESSAGE, names that
//! became words of the language, and the DEF lines that version 3.0 asks for.

use super::lines::{Piece, Statement};
use super::variables::{Variables, old_placeholders};
use super::{Migrator, free_name};
use crate::message::{Declared, Migrating};
use std::collections::{BTreeSet, HashMap, HashSet};
use tipc::diagnostic::Edit;
use tipc::language::Edition;
use tipc::language::commands::{COMMANDS, find};
use tipc::language::reserved::{LOOP, is_reserved};
use tipc::lex::{Kind, Token};
use tipc::source::{Source, Span};
use tipc::syntax::{Arithmetic, VariableKind};

/// Suffixes after the name of a parameter.
const SUFFIXES: &[&str] = &["_RATE", "_SLOW", "_FAST", "_NORMAL", "_FIRMLY", "_SOFT"];

/// The parameters, as old programs call them and as they are called now.
const PARAMETERS: &[(&str, &str)] = &[
    ("A_MAX", "A_MAX"),
    ("V_MAX", "V_MAX"),
    ("OMEGA_MAX", "OMEGA_MAX"),
    ("OMEGA_DOT_MAX", "OMEGA_DOT_MAX"),
    ("TORQUE_MAX", "TORQUE_MAX"),
    ("T_MAX", "TORQUE_MAX"),
];

/// Maximum number of names in a declaration line.
const NAMES_PER_LINE: usize = 8;

/// Number of decimals of `%fnn%`: as C's `%f`, whose letter it is.
const DECIMALS: u8 = 6;

/// Commands that put their target under position control.
const POSITIONS: &[&str] = &[
    "PTP",
    "REL_PTP",
    "COMPLIANCE_POSITION",
    "REL_COMPLIANCE_POSITION",
];
/// Commands that put every foot under position control.
const WHOLE_BODY: &[&str] = &["INITIAL_POSTURE", "STAND_UP", "SIT_DOWN"];
/// Commands that put their target under angle control.
const ANGLES: &[&str] = &[
    "PTP_ANGLE",
    "REL_PTP_ANGLE",
    "COMPLIANCE",
    "COMPLIANCE_ANGLE",
    "REL_COMPLIANCE_ANGLE",
];

impl Migrator<'_> {
    pub(super) fn statement(
        &mut self,
        statement: &Statement,
        is_typed: bool,
        variables: &Variables,
        moves: &Moves,
    ) {
        match statement.keyword.as_str() {
            "MESSAGE" if is_typed => self.message(statement, variables),
            "MESSAGE" => {}
            "REM" if is_typed => self.remark(statement),
            "REM" => {}
            "DEF_VAR" | "DEF_POS" | "DEF_JOINT" => self.clashes(statement),
            "FOR" => self.for_statement(statement),
            "WAIT_NEAR" => self.wait_near(statement, variables, moves),
            _ if statement.is_equation() => self.sign(statement),
            _ => self.command(statement),
        }
    }

    /// Renames labels whose names became words of the language, at all their locations. LOOP is still allowed.
    pub(super) fn labels(&mut self, pieces: &[Piece]) {
        let upper = |span: Span| self.source.slice(span).to_ascii_uppercase();
        let declared: Vec<Span> = pieces.iter().filter_map(Piece::label).collect();
        let names: HashSet<String> = declared.iter().map(|span| upper(*span)).collect();
        let statements = pieces.iter().filter_map(Piece::statement);
        let jumps = statements.flat_map(|statement| statement.jumps());
        let mut free: HashMap<String, String> = HashMap::new();
        for span in jumps.chain(declared).collect::<Vec<Span>>() {
            let name = self.source.slice(span).to_ascii_uppercase();
            let clashes =
                names.contains(&name) && name != LOOP && is_reserved(&name, Edition::V3_1);
            if clashes {
                let new = free.entry(name.clone());
                let new = new.or_insert_with(|| free_name(&name, &names)).clone();
                self.rename(span, &new);
                self.change(span, Migrating::Label { name, new });
            }
        }
    }

    /// Migrates a command that is neither of the special ones nor an equation.
    fn command(&mut self, statement: &Statement) {
        match statement.keyword.as_str() {
            "SET_INPOS" => self.tolerance(statement, "SET_JUST_POSITION"),
            "SET_NEAR" => self.tolerance(statement, "SET_NEAR_POSITION"),
            "COMPLIANCE" => self.compliance(statement),
            keyword => {
                if let Some(name) = parameter_command(keyword) {
                    self.rename(statement.word, &name);
                    let old = keyword.to_owned();
                    self.change(statement.word, Migrating::IsSince2_0 { old, new: name });
                }
            }
        }
    }

    fn tolerance(&mut self, statement: &Statement, name: &str) {
        let target = statement.words().nth(1).unwrap_or(statement.word);
        let target_name = self.slice(target).to_ascii_uppercase();
        let keyword = &statement.keyword;
        if target_name.starts_with('J') {
            let text = Migrating::TwoSuccessors {
                old: keyword.clone(),
                target: target_name,
                feet: name.to_owned(),
                joints: name.replace("POSITION", "ANGLE"),
            };
            return self.question(target, text);
        }
        self.rename(statement.word, name);
        let (old, new) = (keyword.clone(), name.to_owned());
        self.change(statement.word, Migrating::IsSince3_1 { old, new });
    }

    fn compliance(&mut self, statement: &Statement) {
        let words = statement.words().skip(1);
        let words: Vec<String> = words
            .map(|word| self.slice(word).to_ascii_uppercase())
            .collect();
        let values = words
            .iter()
            .skip(1)
            .filter(|word| !["R", "A", "HS"].contains(&word.as_str()));
        let fits = match (words.first(), values.count()) {
            (Some(target), 1) => target.starts_with(['F', 'J', 'A']),
            (Some(target), 3) => target.starts_with(['F', 'A']),
            _ => false,
        };
        if !fits {
            return self.question(statement.word, Migrating::NotTheAngles);
        }
        self.rename(statement.word, "COMPLIANCE_ANGLE");
        self.change(statement.word, Migrating::Compliance);
    }

    /// Migrates `FOR A B TO C` to `FOR A = B TO C`.
    fn for_statement(&mut self, statement: &Statement) {
        let [_, variable, from, _, ..] = statement.tokens.as_slice() else {
            return;
        };
        let has_sign = matches!(from.kind, Kind::Assign(_));
        let is_operand = matches!(
            from.kind,
            Kind::Word | Kind::Arithmetic(Arithmetic::Sub | Arithmetic::Add)
        );
        if variable.kind != Kind::Word || has_sign || !is_operand {
            return;
        }
        if self.slice(from.span).eq_ignore_ascii_case("TO") {
            return;
        }
        self.edits.push(Edit::insert(from.span.start, "= "));
        let variable = self.slice(variable.span).to_ascii_uppercase();
        self.change(from.span, Migrating::AssignmentBehindFor { variable });
    }

    /// Migrates `A = - B` to `A = -B`.
    fn sign(&mut self, statement: &Statement) {
        let [_, _, sign, operand, ..] = statement.tokens.as_slice() else {
            return;
        };
        let is_split = sign.kind == Kind::Arithmetic(Arithmetic::Sub)
            && operand.kind == Kind::Word
            && operand.spaced;
        if is_split {
            let blanks = Span::new(sign.span.end, operand.span.start);
            self.edits.push(Edit::replace(blanks, ""));
            let operand = self.slice(operand.span).to_ascii_uppercase();
            self.change(sign.span, Migrating::Sign { operand });
        }
    }

    /// Migrates REM to a comment: it was no step before 3.0; a comment is none now.
    fn remark(&mut self, statement: &Statement) {
        self.edits.push(Edit::replace(statement.word, "//"));
        self.change(statement.word, Migrating::Remark);
    }

    /// Migrates the placeholders of a MESSAGE, and texts that version 3.1 reads in another way.
    fn message(&mut self, statement: &Statement, variables: &Variables) {
        let text = self.slice(statement.text).to_owned();
        let location =
            |start, end| Span::new(statement.text.start + start, statement.text.start + end);
        if let Some(at) = text.find(';') {
            self.question(location(at, at + 1), Migrating::Semicolon);
        }
        let old = old_placeholders(&text);
        let behind = old
            .iter()
            .map(|placeholder| placeholder.start)
            .chain([text.len()]);
        let before = [0]
            .into_iter()
            .chain(old.iter().map(|placeholder| placeholder.end));
        for (start, end) in before.zip(behind) {
            if let Some(name) = names_a_variable(&text[start..end], variables) {
                self.question(location(start, end), Migrating::PlainText { name });
            }
        }
        for placeholder in &old {
            let span = location(placeholder.start, placeholder.end);
            let name = variables.var(&placeholder.digits).unwrap_or_default();
            let new = if placeholder.real {
                format!("%{name}.{DECIMALS}%")
            } else {
                format!("%{name}%")
            };
            self.edits.push(Edit::replace(span, new.as_str()));
            let old = text[placeholder.start..placeholder.end].to_owned();
            self.change(span, Migrating::Placeholder { old, new });
        }
    }

    /// Sets the tolerance in a step of its own, on the same line.
    fn wait_near(&mut self, statement: &Statement, variables: &Variables, moves: &Moves) {
        let [word, target, values @ ..] = statement.tokens.as_slice() else {
            return;
        };
        let [
            value @ Token {
                kind: Kind::Word, ..
            },
        ] = values
        else {
            if !values.is_empty() {
                let location = values[0].span;
                self.question(location, Migrating::OneTolerance);
            }
            return;
        };
        let name = self.slice(target.span).to_ascii_uppercase();
        let is_plain = self.slice(value.span).is_ascii();
        if target.kind != Kind::Word || !is_target(&name) || !is_plain {
            return;
        }
        let measure = moves.measure(&name);
        if measure == Measure::Both {
            return self.question(value.span, Migrating::WhichMeasure { target: name });
        }
        if measure == Measure::Position
            && let Some(leg) = leg_of_joint(&name)
        {
            let text = Migrating::WholeLeg {
                leg: leg.to_owned(),
                target: name,
            };
            return self.question(value.span, text);
        }
        let setting = match measure {
            Measure::Angle => "SET_NEAR_ANGLE",
            Measure::Position | Measure::Both => "SET_NEAR_POSITION",
        };
        let mut behind = String::new();
        if measure == Measure::Angle && name.starts_with('F') {
            // A leg takes a tolerance for each of its three joints.
            let spelt = variables.spelt(self.slice(value.span));
            behind = format!(" {spelt} {spelt}");
        }
        let waiting = format!("{} {}", self.slice(word.span), self.slice(target.span));
        self.edits.push(Edit::insert(
            statement.end(),
            format!("{behind} ; {waiting}"),
        ));
        self.rename(word.span, setting);
        self.change(word.span, Migrating::TwoSteps { setting });
    }

    /// Declares every variable after the title, which is put in if it is missing.
    pub(super) fn declare(&mut self, variables: &Variables, first_line: u32) {
        let above = self.source.line(first_line - 1).span;
        let mut lines = Vec::new();
        if first_line == 2 {
            lines.push(String::new());
            self.change(above, Migrating::EmptyTitle);
        }
        for (kind, keyword, declared) in [
            (VariableKind::Var, "DEF_VAR", Declared::Plainly),
            (VariableKind::Pos, "DEF_POS", Declared::Plainly),
            (VariableKind::Joint, "DEF_JOINT", Declared::OneType),
        ] {
            let names = variables.to_declare(kind);
            for names in names.chunks(NAMES_PER_LINE) {
                let line = format!("{keyword} {}", names.join(", "));
                lines.push(line.clone());
                let (line, declared) = (line.into(), declared.clone());
                self.change(above, Migrating::Declares { line, declared });
            }
        }
        let end = match self.slice(self.source.line(1).end) {
            "" => "\n",
            end => end,
        };
        let text: String = lines.iter().map(|line| format!("{end}{line}")).collect();
        if !text.is_empty() {
            self.edits.push(Edit::insert(above.end, text));
        }
    }

    /// Asks for another name of a variable whose name is a word of the language now.
    fn clashes(&mut self, statement: &Statement) {
        for name in statement.words().skip(1) {
            let word = self.slice(name).to_ascii_uppercase();
            if is_reserved(&word, Edition::V3_1) {
                self.question(name, Migrating::WordOfLanguage { word });
            }
        }
    }
}

/// Returns the name of today of a parameter command, if it has another one (§1-1, 2.0).
fn parameter_command(keyword: &str) -> Option<String> {
    let bare = keyword.strip_prefix("SET_").unwrap_or(keyword);
    let suffix = SUFFIXES.iter().find(|suffix| bare.ends_with(**suffix));
    let suffix = suffix.copied().unwrap_or_default();
    let base = &bare[..bare.len() - suffix.len()];
    let (_, now) = PARAMETERS.iter().find(|(old, _)| *old == base)?;
    let name = format!("SET_{now}{suffix}");
    (name != keyword && find(&name).is_some()).then_some(name)
}

/// Returns true if an old statement may start with this word.
pub(super) fn is_statement_word(keyword: &str) -> bool {
    let renamed = ["COMPLIANCE", "SET_INPOS", "SET_NEAR"];
    COMMANDS
        .iter()
        .any(|command| command.name == keyword || command.alias == Some(keyword))
        || renamed.contains(&keyword)
        || parameter_command(keyword).is_some()
}

fn names_a_variable(text: &str, variables: &Variables) -> Option<String> {
    let words = text.split('%').skip(1);
    let closed = text.matches('%').count().saturating_sub(1);
    words
        .take(closed)
        .map(|word| {
            word.split('.')
                .next()
                .unwrap_or_default()
                .to_ascii_uppercase()
        })
        .find(|name| variables.is_var(name))
}

/// Unit of a tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Measure {
    /// mm
    Position,
    /// deg
    Angle,
    /// The program moves the target under both kinds of control.
    Both,
}

/// Targets that the commands of a program move, and how.
#[derive(Debug, Default)]
pub(super) struct Moves {
    /// The targets of commands of [`POSITIONS`].
    positions: BTreeSet<String>,
    /// The targets of commands of [`ANGLES`].
    angles: BTreeSet<String>,
    /// True if the program has a command of [`WHOLE_BODY`].
    whole_body: bool,
}

impl Moves {
    pub(super) fn of(source: &Source, pieces: &[Piece]) -> Self {
        let mut moves = Moves::default();
        for statement in pieces.iter().filter_map(Piece::statement) {
            let words = statement.words().skip(1);
            let words = words.map(|word| source.slice(word).to_ascii_uppercase());
            match statement.keyword.as_str() {
                keyword if POSITIONS.contains(&keyword) => moves.positions.extend(words),
                keyword if ANGLES.contains(&keyword) => moves.angles.extend(words),
                keyword => moves.whole_body |= WHOLE_BODY.contains(&keyword),
            }
        }
        moves
    }

    /// Returns the unit of the tolerance of a WAIT_NEAR by the commands that move its target, or by the kind of the
    /// target if none does.
    fn measure(&self, target: &str) -> Measure {
        let is_joint = target.starts_with('J');
        let moves = |words: &BTreeSet<String>| match target {
            "ALL" => !words.is_empty(),
            _ => words.contains(target),
        };
        let positions = moves(&self.positions) || (!is_joint && self.whole_body);
        match (positions, moves(&self.angles)) {
            (true, true) => Measure::Both,
            (true, false) => Measure::Position,
            (false, true) => Measure::Angle,
            (false, false) if is_joint => Measure::Angle,
            (false, false) => {
                let joints = target.replacen('F', "J", 1);
                let mut of_leg = self.angles.range(joints.clone()..);
                match of_leg.next().is_some_and(|word| word.starts_with(&joints)) {
                    true => Measure::Angle,
                    false => Measure::Position,
                }
            }
        }
    }
}

fn leg_of_joint(target: &str) -> Option<&str> {
    target.strip_prefix('J')?.get(..1)
}

/// Returns true if WAIT_NEAR can wait for this.
fn is_target(name: &str) -> bool {
    let is_number = |digits: &str| digits.bytes().all(|byte| matches!(byte, b'1'..=b'9'));
    match (name.strip_prefix('F'), name.strip_prefix('J')) {
        (Some(leg), _) => leg.len() == 1 && is_number(leg),
        (_, Some(joint)) => joint.len() == 2 && is_number(joint),
        (None, None) => name == "ALL",
    }
}
