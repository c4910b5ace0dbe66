//! Arguments of commands against their forms in the command table, and first words that are no command.

use super::resolve::Resolver;
use super::targets::word;
use crate::code::{Code, Level};
use crate::diagnostic::{Diagnostic, Handle};
use crate::language::commands::{Arguments, Command, Form, Limit, Meaning};
use crate::language::{Edition, Keyword, commands, flags, keywords, names};
use crate::lex::DELIMITERS;
use crate::message::list::{Alternatives, Both};
use crate::message::phrase::Lacking;
use crate::message::{Commanding, Message, Parsing, Structuring, Suggestion};
use crate::program::Action;
use crate::robot::Robot;
use crate::source::Span;
use crate::suggest::nearest;
use crate::syntax::{Operand, Word, upper_case};
use smol_str::SmolStr;
use tip_runtime::command::{FAST, Flag, Op, Target};

/// Maximum number of words that are joined to find a command whose name was written in several words.
const MAX_PARTS: usize = 4;

impl Resolver<'_> {
    pub(super) fn command(
        &mut self,
        name: &Word,
        arguments: &[Operand],
        malformed: Option<&Diagnostic>,
    ) -> Option<Action> {
        let command = self.known(name, malformed)?;
        if let Some(fault) = malformed {
            self.report(fault.clone());
            return None;
        }
        let mark = self.found.mark();
        let action = self.action(command, name, arguments);
        self.say_usage(mark, command);
        action
    }

    /// Adds the usage of a command to the errors without help that were reported since a mark.
    fn say_usage(&mut self, mark: Handle, command: &Command) {
        let edition = self.names.edition;
        let silent = |fault: &&mut Diagnostic| {
            fault.help.is_none() && fault.code.level(edition) == Level::Error
        };
        for fault in self.found.since_mut(mark).iter_mut().filter(silent) {
            let forms = Alternatives(command.usage(self.robot, edition));
            fault.help = Some(Commanding::Write { forms }.into());
        }
    }

    fn action(&mut self, command: &Command, name: &Word, arguments: &[Operand]) -> Option<Action> {
        match (command.form_in(self.names.edition), command.meaning) {
            (Form::Robot(form), Meaning::Robot(op)) => self.robot(name, op, form, arguments),
            (Form::Robot(_), _) => {
                self.no_more(name, arguments)?;
                Some(Action::Message { parts: Vec::new() })
            }
            (Form::Special, _) => self.special(name, arguments),
            (Form::Teach(targets), Meaning::Teach(what)) => {
                self.teach(name, what, targets, arguments)
            }
            (Form::AdIn, _) => self.ad_in(name, arguments),
            (Form::KeyIn, _) => self.key_in(name, arguments),
            (Form::Words(_) | Form::Teach(_), _) => self.unknown_command(name, None),
        }
    }

    fn known(&mut self, name: &Word, malformed: Option<&Diagnostic>) -> Option<&'static Command> {
        let command = commands::find_in(&name.node, self.names.edition);
        let command = command.filter(|command| !matches!(command.meaning, Meaning::Keyword(_)));
        let Some(command) = command else {
            return self.unknown_command(name, malformed);
        };
        if !command.robots.contains(self.robot) {
            let robot = self.robot.name();
            let reason = Commanding::RobotLacks {
                robot,
                command: command.name,
            };
            let help = self.who_has(command);
            self.report(
                Diagnostic::new(Code::UnknownCommand, name.span, reason)
                    .about(name.node.as_str())
                    .help(help),
            );
            return None;
        }
        Some(command)
    }

    /// Returns the help for a command that the robot lacks.
    fn who_has(&self, command: &Command) -> Commanding {
        let name = command.name;
        match self.robot {
            Robot::Described(_) if command.robots.misses_forces(self.robot) => {
                Commanding::NeedsForces { command: name }
            }
            _ => Commanding::CommandOf {
                command: name,
                robots: Both(command.robots.names()),
            },
        }
    }

    fn unknown_command<T>(&mut self, name: &Word, malformed: Option<&Diagnostic>) -> Option<T> {
        let word = name.node.as_str();
        if let Some(jumps) = self.jumps_here() {
            let name_of = word.trim_end_matches(['.', '-']).into();
            let mut fault =
                Diagnostic::new(Code::UnknownCommand, name.span, Parsing::LabelColonMissing);
            for jump in jumps {
                fault = fault.label(*jump, Structuring::JumpsHere);
            }
            self.report(
                fault
                    .about(word)
                    .help(Parsing::WriteLabel { name: name_of }),
            );
            return None;
        }
        if self.add_to_line_before(name) {
            return None;
        }
        let (reason, help) = match self.names.find(word) {
            Some(_) => {
                let name = name.node.clone();
                let help = Commanding::OperatorBehindVariable { name: name.clone() };
                (Commanding::VariableNotCommand { name }, help)
            }
            None => {
                let reason = Commanding::NoCommand {
                    word: name.node.clone(),
                };
                let mut fault =
                    Diagnostic::new(Code::UnknownCommand, name.span, reason).about(word);
                // `DIM A(3)` is one mistake: the array is not reported again.
                fault.once = malformed.and_then(|malformed| malformed.once.clone());
                if let Some(block) = self.closes_here() {
                    let (opener, closer) = (block.kind.opener(), block.kind.closer());
                    let location = self.keyword_of(block.opener);
                    self.report(
                        fault
                            .label(location, Structuring::Open { opener })
                            .guess(Suggestion::Closes { opener, closer }),
                    );
                    return None;
                }
                let (help, is_known) = self.suggest_for(name);
                self.report(match is_known {
                    true => fault.help(help),
                    false => fault.guess(help),
                });
                return None;
            }
        };
        let fault = Diagnostic::new(Code::UnknownCommand, name.span, reason);
        self.report(fault.about(word).help(help));
        None
    }

    /// Returns true if a `;` ended a text of MESSAGE or REM right before this location.
    fn is_after_text(&self, location: Span) -> bool {
        let before = self.source_before(location).map(str::trim_end);
        let Some(before) = before.and_then(|before| before.strip_suffix(';')) else {
            return false;
        };
        let last = before.rsplit(';').next().unwrap_or_default();
        let first = last.split_whitespace().next().unwrap_or_default();
        keywords::find(first, self.names.edition).is_some_and(Keyword::takes_text)
    }

    fn robot(
        &mut self,
        name: &Word,
        op: Op,
        form: Arguments,
        arguments: &[Operand],
    ) -> Option<Action> {
        let hs = form.hs && arguments.first().and_then(word) == Some(FAST);
        let arguments = &arguments[usize::from(hs)..];
        if op == Op::OutputVariables {
            self.uses.dump();
        }
        let has_target = form.targets != commands::Targets::NONE;
        let target = match has_target {
            true => self.target(name, form.targets, arguments)?,
            false => Target::None,
        };
        let operands = &arguments[usize::from(has_target)..];
        let arguments = self.values(name, form, target, operands)?;
        self.warn_of_range(name, form, operands, &arguments);
        if form.limit == Limit::Angles {
            self.warn_of_limits(name, target, operands, &arguments);
        }
        Some(Action::Command {
            op,
            hs,
            target,
            arguments,
        })
    }

    pub(super) fn missing<T>(&mut self, location: Span, what: Lacking) -> Option<T> {
        self.refuse(Code::Argument, location, Commanding::Missing { what })
    }

    /// Returns the help for an unknown first word, and false if that is a guess.
    fn suggest_for(&self, name: &Word) -> (Message, bool) {
        match self.known_mistake(name) {
            Some(help) => (help, true),
            None => (self.near_command(&name.node), false),
        }
    }

    fn known_mistake(&self, name: &Word) -> Option<Message> {
        if self.found.are_many() {
            return None;
        }
        let word = name.node.as_str();
        if self.is_after_text(name.span) {
            return Some(Suggestion::SemicolonEndsText.into());
        }
        if let Some(command) = self.in_one_word(name) {
            let word = command.into();
            return Some(Suggestion::InOneWord { word }.into());
        }
        if let Some(help) = self.call_of(word) {
            return Some(help);
        }
        if let Some(command) = commands::renamed(word) {
            return Some(Commanding::CalledNow { command }.into());
        }
        if let Ok(target) = word.parse::<Target>() {
            let target = target.to_string().into();
            return Some(Suggestion::TargetFirst { target }.into());
        }
        if flags::find(word, self.names.edition).is_some() {
            return Some(Suggestion::FlagAlone { flag: word.into() }.into());
        }
        if let Some(command) = called(word, self.names.edition) {
            return Some(Suggestion::Glued { command }.into());
        }
        glued(word, self.names.edition).map(|command| Suggestion::BlankAfter { command }.into())
    }

    /// Returns the command that an unknown word is near to, or what such a word may be.
    fn near_command(&self, word: &str) -> Message {
        let edition = self.names.edition;
        let mut later = Edition::ALL.iter();
        let later = later.find_map(|later| commands::find_in(word, *later));
        if let Some(Command { name, since, .. }) = later {
            let (word, edition) = ((*name).into(), *since);
            return Suggestion::OfEdition { word, edition }.into();
        }
        let names = || commands::names(edition);
        let is_searched = !self.found.are_many();
        let near = || {
            let near = nearest(word, names()).or_else(|| turned(word, edition));
            near.or_else(|| begun(word, edition))
                .or_else(|| cut_short(word, edition))
        };
        match is_searched.then(near).flatten() {
            Some(near) => Suggestion::DidYouMean { near: near.into() }.into(),
            None => match word.split_once('(') {
                Some((name, rest)) if names::is_variable(name) && !rest.is_empty() => {
                    Suggestion::NoParameters { name: name.into() }.into()
                }
                _ => Commanding::LabelOrEquation.into(),
            },
        }
    }

    /// Returns the command whose name is written in several words, such as `ALL STOP`.
    pub(super) fn in_one_word(&self, first: &Word) -> Option<&'static str> {
        let rest = self.rest_of_statement(first.span);
        let rest = rest.split(DELIMITERS).filter(|word| !word.is_empty());
        let words: Vec<&str> = rest.take(MAX_PARTS - 1).collect();
        let mut counts = (1..=words.len()).rev();
        counts.find_map(|count| {
            let parts = [first.node.as_str()].into_iter();
            let whole: Vec<&str> = parts.chain(words[..count].iter().copied()).collect();
            let command = commands::find_in(&upper_case(&whole.join("_")), self.names.edition)?;
            Some(command.name)
        })
    }

    /// Suggests a CALL or GOTO to a SUBROUTINE or label of that name.
    fn call_of(&self, word: &str) -> Option<Message> {
        let (name, rest) = word.split_once('(').unwrap_or((word, ")"));
        let is_subroutine = self.is_subroutine(name)?;
        let name = name.into();
        if rest != ")" {
            return Some(Suggestion::NoParameters { name }.into());
        }
        Some(match is_subroutine {
            true => Suggestion::Call { name }.into(),
            false => Suggestion::JumpTo { name }.into(),
        })
    }
}

/// Returns the command of a word that has the form of a call in another language: `PTP(F1`, `MESSAGE"…"`,
/// `robot.ptp(1`.
fn called(word: &str, edition: Edition) -> Option<&'static str> {
    let end = word.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.'));
    let name = &word[..end.unwrap_or(word.len())];
    let last = name.rsplit('.').next().unwrap_or(name);
    let command = commands::find_in(last, edition).filter(|_| last.len() < word.len())?;
    Some(command.name)
}

/// Returns the command whose parts stand in another order: `PTP_REL`.
fn turned(word: &str, edition: Edition) -> Option<&'static str> {
    let parts = |name: &str| {
        let mut parts: Vec<SmolStr> = name
            .split('_')
            .take(MAX_PARTS + 1)
            .map(SmolStr::from)
            .collect();
        parts.sort_unstable();
        parts
    };
    let wanted = parts(word);
    let mut names = commands::names(edition);
    names.find(|name| name.len() == word.len() && parts(name) == wanted)
}

/// Returns the command that is the first parts of a word: `TORQUE_CONTROL`.
fn begun(word: &str, edition: Edition) -> Option<&'static str> {
    let longest = commands::names(edition).map(str::len).max();
    let ends = word.match_indices('_').map(|(at, _)| at);
    let ends = ends.take_while(|end| Some(*end) <= longest);
    let ends: Vec<usize> = ends.collect();
    let mut parts = ends
        .into_iter()
        .rev()
        .filter_map(|end| commands::find_in(&word[..end], edition));
    parts.next().map(|command| command.name)
}

/// Returns the only command that a word is the first part of: `SIT`.
fn cut_short(word: &str, edition: Edition) -> Option<&'static str> {
    let goes_on = |name: &&str| {
        name.strip_prefix(word)
            .is_some_and(|rest| rest.starts_with('_'))
    };
    let mut longer = commands::names(edition).filter(goes_on);
    longer.next().filter(|_| longer.next().is_none())
}

/// Returns the command that a word begins with, if an argument follows it without a space: `SLEEP100`, `PTPF1`.
fn glued(word: &str, edition: Edition) -> Option<&'static str> {
    let is_argument = |rest: &str| {
        let is_number = !rest.is_empty() && rest.bytes().all(|it| it.is_ascii_digit());
        is_number || rest == FAST || rest.parse::<Target>().is_ok() || rest.parse::<Flag>().is_ok()
    };
    let begins = |name: &&str| word.strip_prefix(*name).is_some_and(is_argument);
    let names = commands::names(edition);
    names.filter(begins).max_by_key(|name| name.len())
}
