//! Completion: the words that can be written at the cursor, with snippets for their arguments. What fits there depends on the text
//! before it on its line ([`context`]), and on the blocks around it ([`blocks`]). Each word that is offered passes the checker once
//! the statement is complete.

mod blocks;
mod context;

use crate::hover::{declaring, usage};
use crate::{Document, word};
use context::{Context, Written, reading_kind};
use smol_str::SmolStr;
use tip_runtime::command::{ABSOLUTE, FAST, Flag, Port, RELATIVE, Reading, TIMERS, Target, Teach};
use tip_runtime::program::Signature;
use tipc::Robot;
use tipc::language::commands::{
    Arguments, COMMANDS, Command, Form, Joints, Meaning, Targets, Values, senses,
};
use tipc::language::flags::{self, FLAGS};
use tipc::language::functions::{FUNCTIONS, Operation};
use tipc::language::inputs::INPUTS;
use tipc::language::reserved::{self, JOINT, LOOP, POSITION, RESERVED, motion_flags};
use tipc::language::{Bilingual, Edition, Keyword};
use tipc::source::Span;
use tipc::symbols::{Definition, DefinitionKind};
use tipc::syntax::{StatementKind, VariableKind};

const SCALARS: &[VariableKind] = &[VariableKind::Var, VariableKind::Pos, VariableKind::Joint];

/// A word that can be written at the cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompletionItem {
    /// The word.
    pub label: String,
    /// Its kind.
    pub kind: CompletionKind,
    /// Its form or type.
    pub detail: String,
    /// Its description, in one line.
    pub description: Bilingual,
    /// The span that it replaces: the word under the cursor.
    pub span: Span,
    /// The text that replaces it.
    pub text: String,
    /// The text with placeholders, if there are any, as a snippet of the Language Server Protocol.
    pub snippet: Option<String>,
}

/// The kind of a completion item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CompletionKind {
    /// A keyword.
    Keyword,
    /// A command of the robot.
    Command,
    /// A function.
    Function,
    /// A flag of conditions.
    Flag,
    /// A target or an input.
    Target,
    /// `HS`, `R` or `A`.
    MotionFlag,
    /// A constant.
    Constant,
    /// A variable.
    Variable,
    /// A member of a POS or JOINT.
    Member,
    /// A label or SUBROUTINE.
    Label,
}

impl CompletionItem {
    fn new(label: impl Into<String>, kind: CompletionKind, description: Bilingual) -> Self {
        let label = label.into();
        CompletionItem {
            text: label.clone(),
            label,
            kind,
            detail: String::new(),
            description,
            span: Span::default(),
            snippet: None,
        }
    }

    fn detail(self, detail: impl Into<String>) -> Self {
        CompletionItem {
            detail: detail.into(),
            ..self
        }
    }

    fn snippet(self, snippet: String) -> Self {
        let snippet = Some(snippet).filter(|snippet| *snippet != self.text);
        CompletionItem { snippet, ..self }
    }
}

impl Document {
    /// Returns what can be written at a byte of the text. Each item replaces the word under the cursor, and is offered whether or
    /// not it matches the letters of that word.
    pub fn complete(&self, offset: usize) -> Vec<CompletionItem> {
        let Some((context, span)) = self.completion_context(offset) else {
            return Vec::new();
        };
        let mut items = self.items(&context);
        for item in &mut items {
            item.span = span;
        }
        items
    }

    /// Returns at most `most` items; of more than that, those that contain the typed letters in their order. Also returns true if
    /// none was left out.
    pub fn complete_with(&self, offset: usize, most: usize) -> (Vec<CompletionItem>, bool) {
        let mut items = self.complete(offset);
        let are_all = items.len() <= most;
        if !are_all {
            items.retain(|item| {
                let typed = Span::new(item.span.start, offset.max(item.span.start));
                has_letters(&item.label, self.slice(typed))
            });
            items.truncate(most);
        }
        (items, are_all)
    }

    fn items(&self, context: &Context) -> Vec<CompletionItem> {
        match context {
            Context::Version => {
                let editions = Edition::ALL.iter().map(Edition::to_string);
                let kind = CompletionKind::Constant;
                editions
                    .map(|version| CompletionItem::new(version, kind, Bilingual::EMPTY))
                    .collect()
            }
            Context::Start(at) => self.starts(*at),
            Context::Member(name) => self.members(name),
            Context::Label(keyword, at) => self.labels(*keyword, *at),
            Context::Condition => {
                let mut items = self.flag_items();
                items.extend(self.scalars());
                items
            }
            Context::Flag => self.flag_items(),
            Context::Scalar => self.scalars(),
            Context::Plain => self.variables(&[VariableKind::Var]),
            Context::Whole(kinds) => self.variables(kinds),
            Context::Constant(at) => self.constants_above(*at),
            Context::Keywords(keywords) => keywords.iter().copied().map(keyword_item).collect(),
            Context::Counter => self.assignable(&[VariableKind::Var]),
            Context::Counted(at) => self.counted(*at),
            Context::Placeholder if self.edition() >= Edition::V3_2 => self.variables(SCALARS),
            Context::Placeholder => self.assignable(&[VariableKind::Var]),
            Context::Right(kind) => {
                let mut items = match kind {
                    VariableKind::Var => self.scalars(),
                    kind => self.variables(&[*kind]),
                };
                items.extend(functions(*kind));
                items
            }
            Context::Argument(command, written) => self.arguments(command, written),
        }
    }

    /// Returns the words that begin a statement.
    fn starts(&self, at: usize) -> Vec<CompletionItem> {
        let robot = self.robot();
        let edition = self.edition();
        let place = self.place_in_blocks(at);
        let fits = |row: &&Command| match row.meaning {
            Meaning::Keyword(keyword) => place.fits(keyword),
            _ => true,
        };
        let rows = COMMANDS.iter();
        let rows = rows.filter(|row| row.since <= edition && row.robots.contains(robot));
        let rows = rows.filter(fits);
        let mut items: Vec<CompletionItem> = rows.map(|row| command_item(row, self)).collect();
        items.extend(self.assignable(SCALARS));
        items
    }

    /// Returns what stands for a number: variables, those whose members are numbers too, and constants.
    fn scalars(&self) -> Vec<CompletionItem> {
        let mut items = self.variables(SCALARS);
        items.extend(constants());
        items
    }

    /// Returns the constants that are defined before an offset.
    fn constants_above(&self, at: usize) -> Vec<CompletionItem> {
        let definitions = self.loaded.symbols.definitions().iter();
        let above = definitions.filter(|it| {
            it.kind == DefinitionKind::Constant && it.span.is_some_and(|span| span.end <= at)
        });
        let mut items: Vec<CompletionItem> = above.map(definition_item).collect();
        items.extend(constants());
        items
    }

    /// Returns the variable of the FOR that a NEXT at an offset closes.
    fn counted(&self, at: usize) -> Vec<CompletionItem> {
        let place = self.place_in_blocks(at);
        let variable = place.opener().and_then(|opener| match &opener.kind {
            StatementKind::For { counting, .. } => counting.variable.name().map(SmolStr::as_str),
            _ => None,
        });
        let mut items = self.assignable(&[VariableKind::Var]);
        items.retain(|item| Some(item.label.as_str()) == variable);
        items
    }

    /// Returns the variables of some types, special ones and, as VAR, constants too.
    fn variables(&self, kinds: &[VariableKind]) -> Vec<CompletionItem> {
        let mut items = self.assignable(kinds);
        if kinds.contains(&VariableKind::Var) {
            let definitions = self.loaded.symbols.definitions().iter();
            let constants = definitions.filter(|it| it.kind == DefinitionKind::Constant);
            items.extend(constants.map(definition_item));
        }
        if self.edition() >= Edition::V3_2 {
            items.extend(readings(self.robot(), kinds));
        }
        items
    }

    /// Returns the variables of some types that the program declares or names.
    fn assignable(&self, kinds: &[VariableKind]) -> Vec<CompletionItem> {
        let definitions = self.loaded.symbols.definitions().iter();
        let fits = |definition: &&Definition| match definition.kind {
            DefinitionKind::Variable(kind) => kinds.contains(&kind),
            _ => false,
        };
        definitions.filter(fits).map(definition_item).collect()
    }

    fn members(&self, name: &str) -> Vec<CompletionItem> {
        let upper = name.to_ascii_uppercase();
        let mut definitions = self.loaded.symbols.definitions().iter();
        let kind = definitions.find(|it| it.name == upper).map(|it| it.kind);
        let names: Vec<String> = match kind {
            Some(DefinitionKind::Variable(VariableKind::Pos)) => {
                POSITION.map(str::to_owned).to_vec()
            }
            Some(DefinitionKind::Variable(VariableKind::Joint)) => {
                let joints = self.robot().signature().joints;
                (1..=joints)
                    .map(|joint| format!("{JOINT}{joint}"))
                    .collect()
            }
            _ => Vec::new(),
        };
        let items = names.into_iter().map(|name| {
            let description =
                word::member_row(&name).map_or(Bilingual::EMPTY, |row| row.description);
            CompletionItem::new(name, CompletionKind::Member, description)
        });
        items.collect()
    }

    /// Returns the labels that a jump whose statement begins at an offset can lead to, with their colons.
    fn labels(&self, keyword: Keyword, at: usize) -> Vec<CompletionItem> {
        let definitions = self.loaded.symbols.definitions();
        let here = self.place_in_blocks(at);
        let is_goto = keyword == Keyword::Goto;
        let is_reached = |it: &Definition| {
            let there = it.span.map(|span| here.statement_at(span.start));
            there.is_none_or(|there| here.reaches(there, is_goto))
        };
        // GOTO LOOP leads to the nearest one above.
        let is_above = |it: &&Definition| it.name == LOOP && it.span.is_some_and(|it| it.end <= at);
        let nearest_loop = definitions.iter().rfind(is_above);
        let names_thread = matches!(
            keyword,
            Keyword::StartThread | Keyword::StopThread | Keyword::WaitThread
        );
        let fits = |it: &Definition| match it.kind {
            DefinitionKind::Variable(_) | DefinitionKind::Constant => false,
            DefinitionKind::Thread => names_thread,
            DefinitionKind::Subroutine => keyword != Keyword::Goto && !names_thread,
            DefinitionKind::Label if it.name == LOOP => {
                keyword == Keyword::Goto
                    && nearest_loop.is_some_and(|nearest| nearest.span == it.span)
                    && is_reached(it)
            }
            DefinitionKind::Label => {
                matches!(keyword, Keyword::Goto | Keyword::Gosub) && is_reached(it)
            }
        };
        let items = definitions.iter().filter(|it| fits(it)).map(|it| {
            let name = it.name.as_str();
            let item = CompletionItem::new(name, CompletionKind::Label, Bilingual::EMPTY);
            CompletionItem {
                text: format!("{name}:"),
                ..item
            }
        });
        items.collect()
    }

    fn flag_items(&self) -> Vec<CompletionItem> {
        let flags = robot_flags(self.robot()).into_iter();
        let items = flags.map(|(flag, row)| {
            CompletionItem::new(flag.to_string(), CompletionKind::Flag, row.description)
        });
        items.collect()
    }

    /// Returns the next arguments of a command after some that are written.
    fn arguments(&self, command: &Command, written: &Written) -> Vec<CompletionItem> {
        let words: Vec<&str> = written.words.iter().map(String::as_str).collect();
        match (command.form_in(self.edition()), words.as_slice()) {
            (Form::Robot(arguments), words) => {
                self.robot_arguments(arguments, words, written.is_signed)
            }
            (_, _) if written.is_signed => Vec::new(),
            (Form::Teach(of), []) => self.target_items(of),
            (Form::Teach(_), [target]) => match (command.meaning, target.parse()) {
                (Meaning::Teach(Teach::Angle | Teach::Torque), Ok(Target::Joint(..))) => {
                    self.assignable(&[VariableKind::Var, VariableKind::Joint])
                }
                (Meaning::Teach(Teach::Angle | Teach::Torque), _) => {
                    self.assignable(&[VariableKind::Joint])
                }
                _ => self.assignable(&[VariableKind::Pos]),
            },
            (Form::AdIn, []) => {
                let inputs = robot_inputs(self.robot()).into_iter();
                inputs
                    .map(|(name, description)| {
                        CompletionItem::new(name, CompletionKind::Target, description)
                    })
                    .collect()
            }
            // A board has a channel.
            (Form::AdIn, [board]) if board.starts_with(|it: char| it.is_ascii_digit()) => {
                Vec::new()
            }
            (Form::AdIn, [_]) | (Form::KeyIn, []) => self.assignable(&[VariableKind::Var]),
            (Form::AdIn, [board, _]) if board.starts_with(|it: char| it.is_ascii_digit()) => {
                self.assignable(&[VariableKind::Var])
            }
            (Form::Special, [_] | [_, _]) => self.variables(&[VariableKind::Var]),
            _ => Vec::new(),
        }
    }

    fn robot_arguments(
        &self,
        arguments: Arguments,
        words: &[&str],
        is_signed: bool,
    ) -> Vec<CompletionItem> {
        let has_target = arguments.targets != Targets::NONE;
        let mut items = Vec::new();
        let words = match words {
            [FAST, rest @ ..] if arguments.hs => rest,
            [] if arguments.hs && !is_signed => {
                items.push(motion_flag_item(FAST));
                words
            }
            words => words,
        };
        let (target, operands) = match words {
            operands if !has_target => (Target::None, operands),
            [] if is_signed => return Vec::new(),
            [] => {
                items.extend(self.target_items(arguments.targets));
                return items;
            }
            [target, operands @ ..] => match target.parse() {
                Ok(target) => (target, operands),
                Err(_) => return Vec::new(),
            },
        };
        let is_flag = |word: &&&str| arguments.motion && matches!(**word, RELATIVE | ABSOLUTE);
        let is_flagged = operands.last().as_ref().is_some_and(is_flag);
        let given: Vec<&str> = operands
            .iter()
            .filter(|word| !is_flag(word))
            .copied()
            .collect();
        let wanted = Operands::of(
            arguments.values,
            target,
            self.robot().signature().joints.into(),
        );
        let is_whole = given
            .first()
            .is_some_and(|first| wanted.whole.is_some() && self.kind_of(first) == wanted.whole);
        let is_number = |word: &&str| self.kind_of(word) == Some(VariableKind::Var);
        let left = match is_whole {
            true => wanted.wholes.saturating_sub(given.len()),
            false if !given.iter().all(is_number) => 0,
            false if given.is_empty() => wanted.scalars.max(wanted.wholes),
            false => wanted.scalars.saturating_sub(given.len()),
        };
        if left == 0 {
            return Vec::new();
        }
        let accepts_whole = !is_signed && (given.is_empty() || is_whole);
        let whole = wanted.whole.filter(|_| accepts_whole);
        items.extend(match (is_whole || wanted.scalars == 0, wanted.plain) {
            (true, _) => whole.map_or(Vec::new(), |kind| self.variables(&[kind])),
            (false, true) => {
                let mut items = self.variables(&[VariableKind::Var]);
                items.extend(whole.map_or(Vec::new(), |kind| self.variables(&[kind])));
                items
            }
            (false, false) => self.variables(SCALARS),
        });
        if arguments.relative && !is_flagged && !is_signed && !is_whole {
            items.extend(
                motion_flags()
                    .filter(|flag| *flag != FAST)
                    .map(motion_flag_item),
            );
        }
        items
    }

    fn target_items(&self, of: Targets) -> Vec<CompletionItem> {
        let found = robot_targets(of, self.robot()).into_iter();
        found
            .map(|target| {
                CompletionItem::new(
                    target.to_string(),
                    CompletionKind::Target,
                    reserved_line(target.stem()),
                )
            })
            .collect()
    }
}

/// Returns true if a word contains letters in their order, regardless of case and of letters between them.
fn has_letters(word: &str, letters: &str) -> bool {
    let mut word = word.chars();
    letters
        .chars()
        .all(|letter| word.any(|one| one.eq_ignore_ascii_case(&letter)))
}

fn command_item(row: &Command, document: &Document) -> CompletionItem {
    let kind = match row.meaning {
        Meaning::Keyword(_) => CompletionKind::Keyword,
        _ => CompletionKind::Command,
    };
    let robot = document.robot();
    let usage = row.usage(robot, document.edition());
    let detail = usage.first().map_or("", String::as_str);
    CompletionItem::new(row.name, kind, row.description)
        .detail(detail)
        .snippet(snippet(row, robot, document.edition()))
}

fn keyword_item(keyword: Keyword) -> CompletionItem {
    CompletionItem::new(
        keyword.word(),
        CompletionKind::Keyword,
        keyword.row().description,
    )
}

/// Returns the functions whose result is of a type.
fn functions(kind: VariableKind) -> impl Iterator<Item = CompletionItem> {
    let result = |operation: Operation| match operation {
        Operation::Scalar(_) | Operation::Atan2 | Operation::Norm => VariableKind::Var,
        Operation::UnitVect | Operation::Rotate(_) => VariableKind::Pos,
    };
    let rows = FUNCTIONS
        .iter()
        .filter(move |row| result(row.operation) == kind);
    rows.map(|row| {
        CompletionItem::new(row.word, CompletionKind::Function, row.description).detail(usage(row))
    })
}

fn motion_flag_item(flag: &str) -> CompletionItem {
    CompletionItem::new(flag, CompletionKind::MotionFlag, reserved_line(flag))
}

/// Returns a variable or constant of the program.
fn definition_item(definition: &Definition) -> CompletionItem {
    let name = definition.name.as_str();
    let (kind, detail) = match definition.kind {
        DefinitionKind::Variable(kind) => (CompletionKind::Variable, declaring(kind)),
        _ => (CompletionKind::Constant, Keyword::Define),
    };
    let description = match definition.span {
        None => reserved_line(name.trim_end_matches(|it: char| it.is_ascii_digit())),
        Some(_) => Bilingual::EMPTY,
    };
    CompletionItem::new(name, kind, description).detail(detail.word())
}

/// The operands that a command takes after its target.
struct Operands {
    /// The number of scalars.
    scalars: usize,
    /// Each is a constant or VAR, no member.
    plain: bool,
    /// The type of a variable in their place.
    whole: Option<VariableKind>,
    /// The number of such variables.
    wholes: usize,
}

impl Operands {
    fn of(values: Values, target: Target, joints: usize) -> Self {
        let is_joint = matches!(target, Target::Joint(..));
        let (scalars, plain, whole) = match values {
            Values::None => (0, true, None),
            Values::One => (1, true, None),
            Values::Three => (3, true, None),
            Values::ThreeOrPos => (3, true, Some(VariableKind::Pos)),
            Values::Position => (3, false, Some(VariableKind::Pos)),
            Values::Limits if is_joint => (2, false, None),
            Values::Limits => (0, false, Some(VariableKind::Joint)),
            Values::Angles if is_joint => (1, false, None),
            Values::PerJoint | Values::PerLeg if is_joint => (1, true, None),
            Values::PerLeg if target == Target::All => (1, true, None),
            Values::Angles | Values::PerJoint | Values::PerLeg => {
                (joints, false, Some(VariableKind::Joint))
            }
        };
        let wholes = match (values, whole) {
            (_, None) => 0,
            (Values::Limits, Some(_)) => 2,
            (_, Some(_)) => 1,
        };
        Operands {
            scalars,
            plain,
            whole,
            wholes,
        }
    }
}

fn constants() -> impl Iterator<Item = CompletionItem> {
    RESERVED.iter().filter_map(|row| match row.kind {
        reserved::Kind::Constant(_) => Some(CompletionItem::new(
            row.word,
            CompletionKind::Constant,
            row.description,
        )),
        _ => None,
    })
}

/// Returns the special variables of some types that a robot has and senses.
fn readings(robot: Robot, kinds: &[VariableKind]) -> Vec<CompletionItem> {
    let Signature { legs, joints, .. } = robot.signature();
    let all = Reading::KINDS.iter().flat_map(|kind| -> Vec<Reading> {
        match *kind {
            Reading::Timer(_) => (0..TIMERS).map(Reading::Timer).collect(),
            Reading::Measured(what, _) if !senses(robot, what) => Vec::new(),
            Reading::Measured(what, Target::Joint(..)) => {
                let legs = (1..=legs).flat_map(|leg| (1..=joints).map(move |joint| (leg, joint)));
                legs.map(|(leg, joint)| Reading::Measured(what, Target::Joint(leg, joint)))
                    .collect()
            }
            Reading::Measured(what, _) => {
                let feet = (1..=legs).map(Target::Foot);
                feet.map(|foot| Reading::Measured(what, foot)).collect()
            }
        }
    });
    all.filter(|reading| kinds.contains(&reading_kind(*reading)))
        .map(|reading| {
            let description = reserved_line(reading.stem());
            CompletionItem::new(reading.to_string(), CompletionKind::Variable, description)
        })
        .collect()
}

fn reserved_line(word: &str) -> Bilingual {
    let row = RESERVED.iter().find(|row| row.word == word);
    row.map_or(Bilingual::EMPTY, |row| row.description)
}

/// Returns a command as a snippet of the Language Server Protocol: `PTP ${1|F1,J11|} ${2:x} ${3:y} ${4:z}`. A word that opens a
/// block brings the words that close it.
pub fn snippet(command: &Command, robot: Robot, edition: Edition) -> String {
    match command.meaning {
        Meaning::Keyword(keyword) => block(keyword),
        _ => {
            let usage = command.usage(robot, edition);
            let first = usage.first().map_or(command.name, String::as_str);
            arguments(first)
        }
    }
}

fn block(keyword: Keyword) -> String {
    let inside = "\n\t$0\n";
    match keyword {
        Keyword::If => format!(
            "{keyword} ${{1:condition}} {}{inside}{}",
            Keyword::Then,
            Keyword::EndIf
        ),
        Keyword::ElseIf => format!("{keyword} ${{1:condition}} {}", Keyword::Then),
        Keyword::While => format!("{keyword} ${{1:condition}}{inside}{}", Keyword::Wend),
        Keyword::Repeat => format!("{keyword}{inside}{} ${{1:condition}}", Keyword::Until),
        Keyword::Until => format!("{keyword} ${{1:condition}}"),
        Keyword::For => {
            let (to, next) = (Keyword::To, Keyword::Next);
            format!("{keyword} ${{1:VAR}} = ${{2:1}} {to} ${{3:10}}{inside}{next}")
        }
        Keyword::Subroutine => format!("{keyword} ${{1:name}}:{inside}{}", Keyword::SubEnd),
        Keyword::Thread => format!("{keyword} ${{1:name}}:{inside}{}", Keyword::ThreadEnd),
        Keyword::Call | Keyword::Goto | Keyword::Gosub => format!("{keyword} ${{1:label}}:"),
        Keyword::StartThread | Keyword::StopThread | Keyword::WaitThread => {
            format!("{keyword} ${{1:name}}:")
        }
        Keyword::Define => format!("{keyword} ${{1:name}} ${{2:constant}}"),
        Keyword::DefVar | Keyword::DefPos | Keyword::DefJoint => format!("{keyword} ${{1:name}}"),
        Keyword::Message | Keyword::FileMessage | Keyword::Rem => format!("{keyword} ${{1:text}}"),
        _ => keyword.word().to_owned(),
    }
}

/// Returns the required words of a form as placeholders.
fn arguments(usage: &str) -> String {
    let mut words = usage.split(' ');
    let mut out = words.next().unwrap_or_default().to_owned();
    let needed = words.filter(|word| !word.starts_with('['));
    for (number, word) in (1..).zip(needed) {
        out += &match word.contains('|') {
            true => format!(" ${{{number}|{}|}}", word.replace('|', ",")),
            false => format!(" ${{{number}:{word}}}"),
        };
    }
    out
}

/// Returns the targets of a robot that a command accepts.
fn robot_targets(of: Targets, robot: Robot) -> Vec<Target> {
    let Signature { legs, joints, .. } = robot.signature();
    let feet = (1..=legs).map(Target::Foot);
    let joints =
        (1..=legs).flat_map(|leg| (1..=joints).map(move |joint| Target::Joint(leg, joint)));
    let all = feet.chain(joints).chain([Target::Floor, Target::All]);
    all.filter(|target| robot.has(*target) && of.accept(*target, robot))
        .collect()
}

/// Returns the flags of a robot with their rows.
fn robot_flags(robot: Robot) -> Vec<(Flag, &'static flags::Row)> {
    let rows = FLAGS.iter().filter(|row| row.robots.contains(robot));
    let all = || robot_targets(Targets::ANY, robot).into_iter();
    let each = |row: &'static flags::Row| -> Vec<(Flag, &'static flags::Row)> {
        let flags: Vec<Flag> = match row.flag {
            Flag::Inpos(_) => all().map(Flag::Inpos).collect(),
            Flag::Near(_) => all().map(Flag::Near).collect(),
            Flag::Special(_) => (0..10).map(Flag::Special).collect(),
            flag => vec![flag],
        };
        flags.into_iter().map(|flag| (flag, row)).collect()
    };
    rows.flat_map(each).collect()
}

/// Returns the inputs of a robot with their descriptions.
fn robot_inputs(robot: Robot) -> Vec<(String, Bilingual)> {
    let rows = INPUTS.iter().filter(|row| row.robots.contains(robot));
    let mut found = Vec::new();
    for row in rows {
        let joints = Targets {
            joints: Joints::Every,
            ..Targets::NONE
        };
        let names: Vec<String> = match row.port {
            Port::Joint(..) => robot_targets(joints, robot)
                .iter()
                .map(Target::to_string)
                .collect(),
            port => port.named().map(|port| port.to_string()).collect(),
        };
        found.extend(names.into_iter().map(|name| (name, row.description)));
    }
    found
}

fn is_letter(char: char) -> bool {
    char.is_ascii_alphanumeric() || char == '_'
}
