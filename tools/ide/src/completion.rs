//! Completion: the words that can be written at the cursor, with snippets for their arguments. What fits there is told by the text
//! before it on its line.

use crate::hover::{declaring, usage};
use crate::{Document, word};
use tip_runtime::command::{Flag, Port, Reading, TIMERS, Target, Teach};
use tipc::Robot;
use tipc::language::commands::{
    self, Arguments, COMMANDS, Command, Form, Joints, Meaning, Targets, Values, senses,
};
use tipc::language::flags::{self, FLAGS};
use tipc::language::functions::FUNCTIONS;
use tipc::language::inputs::INPUTS;
use tipc::language::reserved::{
    self, JOINT, LOOP, POSITION, RESERVED, is_motion_flag, motion_flags,
};
use tipc::language::{Bilingual, Edition, Keyword, keywords};
use tipc::lex::{self, Kind, Piece, Pieces, Token, split_comment};
use tipc::source::{Span, Unit};
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
        let mut items = self.items(&context, span.start);
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

    fn items(&self, context: &Context, at: usize) -> Vec<CompletionItem> {
        match context {
            Context::Version => {
                let editions = Edition::ALL.iter().map(Edition::to_string);
                let kind = CompletionKind::Constant;
                editions
                    .map(|version| CompletionItem::new(version, kind, Bilingual::EMPTY))
                    .collect()
            }
            Context::Start => self.starts(),
            Context::Member(name) => self.members(name),
            Context::Label(keyword) => self.labels(*keyword, at),
            Context::Declaration => Vec::new(),
            Context::Condition(keyword) => self.condition(*keyword),
            Context::Counting(particle) => {
                let mut items = self.variables(SCALARS);
                items.extend(particle.map(keyword_item));
                items
            }
            Context::Counter => self.declared(&[VariableKind::Var]),
            Context::Placeholder if self.loaded.module.edition >= Edition::V3_2 => {
                self.variables(SCALARS)
            }
            Context::Placeholder => self.declared(&[VariableKind::Var]),
            Context::Right => {
                let mut items = self.variables(SCALARS);
                items.extend(functions());
                items.extend(constants());
                items
            }
            Context::Argument(command, written) => self.arguments(command, *written),
        }
    }

    /// Returns the words that begin a statement.
    fn starts(&self) -> Vec<CompletionItem> {
        let robot = self.robot();
        let edition = self.loaded.module.edition;
        let rows = COMMANDS.iter();
        let rows = rows.filter(|row| row.since <= edition && row.robots.contains(robot));
        let mut items: Vec<CompletionItem> = rows.map(|row| command_item(row, self)).collect();
        items.extend(self.declared(SCALARS));
        items
    }

    /// Returns the variables of some types, special ones too.
    fn variables(&self, kinds: &[VariableKind]) -> Vec<CompletionItem> {
        let mut items = self.declared(kinds);
        if self.loaded.module.edition >= Edition::V3_2 {
            items.extend(readings(self.robot(), kinds));
        }
        items
    }

    /// Returns the variables of some types that the program declares or names, and its constants.
    fn declared(&self, kinds: &[VariableKind]) -> Vec<CompletionItem> {
        let definitions = self.loaded.symbols.definitions().iter();
        let mut items = Vec::new();
        for definition in definitions {
            let (kind, item) = match definition.kind {
                DefinitionKind::Variable(kind) => (kind, CompletionKind::Variable),
                DefinitionKind::Constant => (VariableKind::Var, CompletionKind::Constant),
                _ => continue,
            };
            if kinds.contains(&kind) {
                let name = definition.name.as_str();
                let description = match definition.span {
                    None => reserved_line(name.trim_end_matches(|it: char| it.is_ascii_digit())),
                    Some(_) => Bilingual::EMPTY,
                };
                let detail = match definition.kind {
                    DefinitionKind::Constant => Keyword::Define,
                    _ => declaring(kind),
                };
                let item = CompletionItem::new(name, item, description);
                items.push(item.detail(detail.word()));
            }
        }
        items
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

    /// Returns the labels that a jump at an offset can lead to, with their colons.
    fn labels(&self, keyword: Keyword, at: usize) -> Vec<CompletionItem> {
        let definitions = self.loaded.symbols.definitions().iter();
        let subroutines = self.subroutines();
        let around = |at: usize| {
            let after = subroutines.partition_point(|inside| inside.start < at);
            let last = after.checked_sub(1)?;
            (at <= subroutines[last].end).then_some(last)
        };
        let here = around(at);
        let names_thread = matches!(
            keyword,
            Keyword::StartThread | Keyword::StopThread | Keyword::WaitThread
        );
        let fits = |it: &Definition| match it.kind {
            DefinitionKind::Variable(_) | DefinitionKind::Constant => false,
            DefinitionKind::Thread => names_thread,
            DefinitionKind::Label => {
                let there = it.span.and_then(|place| around(place.start));
                match keyword {
                    Keyword::Goto => there == here,
                    Keyword::Gosub => it.name != LOOP && (there.is_none() || there == here),
                    _ => false,
                }
            }
            DefinitionKind::Subroutine => keyword != Keyword::Goto && !names_thread,
        };
        let mut names: Vec<&str> = definitions
            .filter(|it| fits(it))
            .map(|it| it.name.as_str())
            .collect();
        names.dedup();
        let items = names.into_iter().map(|name| {
            let item = CompletionItem::new(name, CompletionKind::Label, Bilingual::EMPTY);
            CompletionItem {
                text: format!("{name}:"),
                ..item
            }
        });
        items.collect()
    }

    fn condition(&self, keyword: Keyword) -> Vec<CompletionItem> {
        let mut items: Vec<CompletionItem> = robot_flags(self.robot())
            .into_iter()
            .map(|(flag, row)| {
                CompletionItem::new(flag.to_string(), CompletionKind::Flag, row.description)
            })
            .collect();
        items.extend(self.variables(SCALARS));
        items.extend(constants());
        let after: &[Keyword] = match keyword {
            Keyword::If => &[Keyword::Then, Keyword::Goto, Keyword::Gosub],
            Keyword::ElseIf => &[Keyword::Then],
            _ => &[],
        };
        items.extend(after.iter().copied().map(keyword_item));
        items
    }

    /// Returns the next arguments of a command after some that are written.
    fn arguments(&self, command: &Command, written: usize) -> Vec<CompletionItem> {
        match (command.form, written) {
            (Form::Robot(arguments), _) => self.robot_arguments(arguments, written),
            (Form::Teach(of), 0) => self.target_items(of),
            (Form::Teach(_), _) => match command.meaning {
                Meaning::Teach(Teach::Angle | Teach::Torque) => {
                    self.variables(&[VariableKind::Var, VariableKind::Joint])
                }
                _ => self.variables(&[VariableKind::Pos]),
            },
            (Form::AdIn, 0) => {
                let inputs = robot_inputs(self.robot()).into_iter();
                inputs
                    .map(|(name, description)| {
                        CompletionItem::new(name, CompletionKind::Target, description)
                    })
                    .collect()
            }
            (Form::KeyIn | Form::AdIn | Form::Special, _) => self.variables(&[VariableKind::Var]),
            (Form::Words(_), _) => Vec::new(),
        }
    }

    fn robot_arguments(&self, arguments: Arguments, written: usize) -> Vec<CompletionItem> {
        let has_target = arguments.targets != Targets::NONE;
        let mut items = Vec::new();
        if has_target && written == 0 {
            items.extend(self.target_items(arguments.targets));
        } else if arguments.values != Values::None {
            let kinds: &[VariableKind] = match arguments.values {
                Values::None | Values::One | Values::Three => &[VariableKind::Var],
                Values::Position | Values::ThreeOrPos => &[VariableKind::Var, VariableKind::Pos],
                Values::Angles | Values::PerJoint | Values::PerLeg | Values::Limits => {
                    &[VariableKind::Var, VariableKind::Joint]
                }
            };
            items.extend(self.variables(kinds));
        }
        let flags = motion_flags().filter(|flag| match *flag {
            tip_runtime::command::FAST => arguments.hs && written == 0,
            _ => arguments.relative && written > 0,
        });
        items.extend(flags.map(|flag| {
            CompletionItem::new(flag, CompletionKind::MotionFlag, reserved_line(flag))
        }));
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
    let usage = row.usage(robot, document.loaded.module.edition);
    let detail = usage.first().map_or("", String::as_str);
    CompletionItem::new(row.name, kind, row.description)
        .detail(detail)
        .snippet(snippet(row, robot))
}

fn keyword_item(keyword: Keyword) -> CompletionItem {
    CompletionItem::new(
        keyword.word(),
        CompletionKind::Keyword,
        keyword.row().description,
    )
}

fn functions() -> impl Iterator<Item = CompletionItem> {
    let rows = FUNCTIONS.iter();
    rows.map(|row| {
        CompletionItem::new(row.word, CompletionKind::Function, row.description).detail(usage(row))
    })
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
    let signature = robot.signature();
    let mut all: Vec<(Reading, VariableKind)> = Vec::new();
    for kind in Reading::KINDS {
        match kind {
            Reading::Timer(_) => {
                let timers = (0..TIMERS).map(Reading::Timer);
                all.extend(timers.map(|timer| (timer, VariableKind::Var)));
            }
            Reading::Measured(what, _) if !senses(robot, what) => {}
            Reading::Measured(what, Target::Joint(..)) => {
                for leg in 1..=signature.legs {
                    let joints = 1..=signature.joints;
                    let joints = joints.map(|joint| Target::Joint(leg, joint));
                    let joints = joints.map(|joint| Reading::Measured(what, joint));
                    all.extend(joints.map(|reading| (reading, VariableKind::Var)));
                }
            }
            Reading::Measured(what, _) => {
                let kind = match what {
                    Teach::Position | Teach::Force => VariableKind::Pos,
                    Teach::Angle | Teach::Torque => VariableKind::Joint,
                };
                let feet = (1..=signature.legs).map(Target::Foot);
                all.extend(feet.map(|foot| (Reading::Measured(what, foot), kind)));
            }
        }
    }
    all.into_iter()
        .filter(|(_, kind)| kinds.contains(kind))
        .map(|(reading, _)| {
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
pub fn snippet(command: &Command, robot: Robot) -> String {
    match command.meaning {
        Meaning::Keyword(keyword) => block(keyword),
        _ => {
            let usage = command.usage(robot, command.since);
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
    let facts = robot.facts();
    let signature = facts.signature;
    let feet = (1..=signature.legs).map(Target::Foot);
    let mut found: Vec<Target> = if of.foot { feet.collect() } else { Vec::new() };
    let joint = match of.joints {
        Joints::None => None,
        Joints::Every => Some(1..=signature.joints),
        Joints::Second => Some(2..=2),
        Joints::Third => Some(3..=3),
        Joints::ThirdOfHand => facts.has_slider.then_some(3..=3),
    };
    for leg in 1..=signature.legs {
        let joints = joint.clone().into_iter().flatten();
        let joints = joints.filter(|joint| *joint <= signature.joints);
        found.extend(joints.map(|joint| Target::Joint(leg, joint)));
    }
    found.extend((of.floor && facts.has_slider).then_some(Target::Floor));
    found.extend(of.all.then_some(Target::All));
    found
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

/// The syntactic position of the cursor.
enum Context {
    /// Line 1, the version of the language.
    Version,
    /// The beginning of a statement.
    Start,
    /// A member of this variable.
    Member(String),
    /// A label that this jump leads to.
    Label(Keyword),
    /// A new name.
    Declaration,
    /// A condition of this statement.
    Condition(Keyword),
    /// A number of FOR, and the particle that may follow.
    Counting(Option<Keyword>),
    /// The variable of FOR or NEXT.
    Counter,
    /// The right side of an equation.
    Right,
    /// A variable between percent signs.
    Placeholder,
    /// An argument of a command; the number of arguments before it.
    Argument(&'static Command, usize),
}

impl Document {
    /// Returns the position of a byte of the text, and the span of the word there; `None` in comments, texts and after END.
    fn completion_context(&self, offset: usize) -> Option<(Context, Span)> {
        let source = &self.loaded.source;
        let text = source.text();
        let offset = (0..=offset.min(text.len()))
            .rev()
            .find(|at| text.is_char_boundary(*at))?;
        // The end of a text that ends in a line end is on a line of its own.
        let number = source.position(offset, Unit::Utf8).line;
        let line = source.line(number).span;
        let before = Span::new(line.start, offset.clamp(line.start, line.end));
        let word = self.letters_around(before.end, line);
        match number {
            1 => return Some((Context::Version, Span::new(line.start, line.end))),
            2 => return None,
            _ => {}
        }
        if split_comment(text, before).1.is_some() || self.is_after_end(offset) {
            return None;
        }
        let done = Span::new(line.start, word.start);
        if let Some(rest) = self.slice(done).strip_suffix('.') {
            let name = &rest[rest.trim_end_matches(is_letter).len()..];
            return Some((Context::Member(name.to_owned()), word));
        }
        let last = Pieces::new(text, done, false)
            .in_edition(self.loaded.module.edition)
            .last();
        let context = match last {
            Some(Piece::Statement {
                word: head, span, ..
            }) if !self.is_ended(span.end, done.end) => self.in_statement(head, span, done)?,
            _ => Context::Start,
        };
        Some((context, word))
    }

    fn is_after_end(&self, offset: usize) -> bool {
        let last = self.statements().last();
        last.is_some_and(|last| last.kind == StatementKind::End && offset > last.span.end)
    }

    /// Returns the span of the letters around an offset.
    fn letters_around(&self, at: usize, line: Span) -> Span {
        let before = self.slice(Span::new(line.start, at));
        let after = self.slice(Span::new(at, line.end));
        let start = before.trim_end_matches(is_letter).len() + line.start;
        let end = at + (after.len() - after.trim_start_matches(is_letter).len());
        Span::new(start, end)
    }

    /// Returns true if a `;` ends the statement before an offset.
    fn is_ended(&self, from: usize, to: usize) -> bool {
        from <= to && self.slice(Span::new(from, to)).contains(';')
    }

    fn in_statement(&self, head: Span, span: Span, done: Span) -> Option<Context> {
        let text = self.loaded.source.text();
        let mut tokens = Vec::new();
        lex::lex(
            text,
            Span::new(span.start, done.end.max(span.start)),
            &mut tokens,
        );
        let keyword = keywords::find(self.slice(head), self.loaded.module.edition);
        if let Some(keyword) = keyword {
            return self.after_keyword(keyword, &tokens, Span::new(head.end, done.end));
        }
        if tokens
            .iter()
            .any(|token| matches!(token.kind, Kind::Assign(_)))
        {
            return Some(Context::Right);
        }
        let command = commands::find_in(self.slice(head), self.loaded.module.edition)?;
        let written = tokens.get(1..).unwrap_or_default();
        Some(Context::Argument(
            command,
            self.argument_count(command, written),
        ))
    }

    fn after_keyword(&self, keyword: Keyword, tokens: &[Token], rest: Span) -> Option<Context> {
        let has = |wanted: Keyword| {
            let is_it = |token: &Token| self.slice(token.span).eq_ignore_ascii_case(wanted.word());
            tokens.iter().skip(1).any(is_it)
        };
        Some(match keyword {
            Keyword::Goto
            | Keyword::Gosub
            | Keyword::Call
            | Keyword::StartThread
            | Keyword::StopThread
            | Keyword::WaitThread => Context::Label(keyword),
            Keyword::Define if tokens.is_empty() => Context::Declaration,
            Keyword::Define => Context::Counting(None),
            Keyword::If if has(Keyword::Goto) => Context::Label(Keyword::Goto),
            Keyword::If if has(Keyword::Gosub) => Context::Label(Keyword::Gosub),
            Keyword::If | Keyword::ElseIf if has(Keyword::Then) => return None,
            Keyword::If | Keyword::ElseIf | Keyword::While | Keyword::Until => {
                Context::Condition(keyword)
            }
            Keyword::For if tokens.len() < 2 => Context::Counter,
            Keyword::For if has(Keyword::Step) => Context::Counting(None),
            Keyword::For if has(Keyword::To) => Context::Counting(Some(Keyword::Step)),
            Keyword::For => Context::Counting(Some(Keyword::To)),
            Keyword::Next => Context::Counter,
            Keyword::DefVar
            | Keyword::DefPos
            | Keyword::DefJoint
            | Keyword::Subroutine
            | Keyword::Thread => Context::Declaration,
            Keyword::Message | Keyword::FileMessage
                if self.slice(rest).matches('%').count() % 2 == 1 =>
            {
                Context::Placeholder
            }
            _ => return None,
        })
    }

    /// Returns the number of arguments among tokens; flags of motions and signs do not count.
    pub(crate) fn argument_count(&self, command: &Command, tokens: &[Token]) -> usize {
        let has_flags =
            matches!(command.form, Form::Robot(arguments) if arguments.hs || arguments.motion);
        let edition = self.loaded.module.edition;
        let counts = |token: &&Token| {
            let word = self.slice(token.span).to_ascii_uppercase();
            token.kind == Kind::Word && !(has_flags && is_motion_flag(&word, edition))
        };
        tokens.iter().filter(counts).count()
    }
}

fn is_letter(char: char) -> bool {
    char.is_ascii_alphanumeric() || char == '_'
}
