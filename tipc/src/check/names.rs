//! Declared variables and what stands for a number (T.I.P. 3.1 §4-4, §4-5, §7-10-1).

use crate::code::Code;
use crate::diagnostic::MOST;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::foreign;
use crate::language::commands::{self, Form, Meaning};
use crate::language::reserved::{self, JOINT, POSITION, VAR_KEY, is_motion_flag, is_reserved};
use crate::language::{Edition, Keyword, flags, functions, inputs, names};
use crate::message::{ForeignWord, Message, Naming, Suggestion};
use crate::program::{self, Scalar, Variable, VariableId};
use crate::robot::Robot;
use crate::source::Span;
use crate::suggest::nearest;
use crate::syntax::{Module, Operand, OperandKind, Statement, StatementKind, VariableKind, Word};
use smol_str::SmolStr;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use tip_runtime::command::{CONSTANT, Target};

/// The most unknown names that are compared with declared ones.
const COMPARED: usize = MOST;

/// `VAR_KEY` is the first of all variables.
pub(super) const VAR_KEY_ID: VariableId = 0;

/// Every variable of a program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    pub(crate) variables: Vec<Variable>,
    /// Declaration of each variable; `None` for VAR_KEY.
    pub(crate) declared: Vec<Option<Span>>,
    ids: HashMap<String, VariableId>,
    /// Known names nearest to unknown ones, so that each is compared once.
    near: RefCell<HashMap<String, Option<String>>>,
    /// Names whose declaration was refused: their uses are not reported again.
    refused: HashSet<String>,
    joints: usize,
    /// Whose words are reserved.
    pub(crate) edition: Edition,
}

/// Meaning of an operand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ResolvedOperand {
    Constant(f64),
    Scalar {
        scalar: Scalar,
        negative: bool,
        member: bool,
    },
    Struct {
        variable: VariableId,
        kind: VariableKind,
        negative: bool,
    },
}

impl ResolvedOperand {
    /// Returns the number, unless this is a struct.
    pub(crate) fn number(self) -> Option<program::Operand> {
        match self {
            ResolvedOperand::Constant(value) => Some(program::Operand::Constant(value)),
            ResolvedOperand::Scalar {
                scalar, negative, ..
            } => Some(program::Operand::Scalar { scalar, negative }),
            ResolvedOperand::Struct { .. } => None,
        }
    }
}

impl Names {
    /// Reads every declaration.
    pub(crate) fn collect(module: &Module, robot: Robot, found: &mut Diagnostics) -> Self {
        let mut names = Names {
            joints: usize::from(robot.signature().joints),
            edition: module.edition,
            ..Names::default()
        };
        names.insert(VAR_KEY, VariableKind::Var, None);
        for statement in &module.statements {
            if let StatementKind::Define {
                kind, names: words, ..
            } = &statement.kind
            {
                for word in words {
                    names.declare(*kind, word, found);
                }
            }
        }
        names.warn_of_flags(module, found);
        names
    }

    /// Warns of variables called `R`, `A` or `HS`; a motion that has the word means its flag.
    fn warn_of_flags(&self, module: &Module, found: &mut Diagnostics) {
        for (variable, declared) in self.variables.iter().zip(&self.declared) {
            let name = variable.name.as_str();
            let is_flag = is_motion_flag(name, self.edition);
            let used = is_flag.then(|| used_in_motion(module, name)).flatten();
            if let (Some(declared), Some(used)) = (*declared, used) {
                let warning = Diagnostic::new(Code::FlagName, declared, Naming::ReadAsFlag)
                    .about(name)
                    .label(used, Naming::FlagHere)
                    .help(Naming::ChooseAnother);
                found.push(warning);
            }
        }
    }

    fn insert(&mut self, name: &str, kind: VariableKind, location: Option<Span>) {
        let first = self
            .variables
            .last()
            .map_or(0, |last| last.first + last.size());
        self.ids.insert(name.to_owned(), self.variables.len());
        self.declared.push(location);
        self.variables.push(Variable {
            name: name.to_owned(),
            kind,
            first,
            joints: self.joints,
        });
    }

    fn declare(&mut self, kind: VariableKind, word: &Word, found: &mut Diagnostics) {
        let name = word.node.as_str();
        if let Some(fault) = self.refusal(word) {
            found.push(fault);
            let array = name.split_once(['(', '[', '.']);
            self.refused
                .insert(array.map_or(name, |(name, _)| name).to_owned());
            return;
        }
        self.insert(name, kind, Some(word.span));
    }

    fn refusal(&self, word: &Word) -> Option<Diagnostic> {
        let name = word.node.as_str();
        let fault = |reason: Naming| Diagnostic::new(Code::Argument, word.span, reason);
        if !names::is_variable(name) {
            let (mistake, help): (_, Message) = match name.split_once(['(', '[']) {
                None if name.ends_with('$') => (name, ForeignWord::NoText.into()),
                Some((array, _)) if names::is_variable(array) => {
                    (array, ForeignWord::NoArray { name: array.into() }.into())
                }
                _ => (name, Naming::VariableCharacters.into()),
            };
            let fault = fault(Naming::NoVariableName { word: name.into() });
            return Some(fault.once(mistake).help(help));
        }
        if is_reserved(name, self.edition) {
            let help = Naming::ChooseAnother;
            return Some(fault(Naming::WordOfLanguage { word: name.into() }).help(help));
        }
        let first = *self.ids.get(name)?;
        let again = fault(Naming::DeclaredAgain { name: name.into() }).help(Naming::DeclareOnce);
        Some(match self.declared[first] {
            Some(location) => again.label(location, Naming::FirstDeclared),
            None => again,
        })
    }

    /// Returns the variable of that name.
    pub(crate) fn find(&self, name: &str) -> Option<VariableId> {
        self.ids.get(name).copied()
    }

    /// Resolves an operand. `shape` is the code of a member that the variable lacks, `guess` the type that an
    /// unknown variable is used as.
    ///
    /// `None` if the name's declaration was refused, which is reported already.
    pub(crate) fn operand(
        &self,
        operand: &Operand,
        shape: Code,
        guess: Option<VariableKind>,
    ) -> Result<Option<ResolvedOperand>, Box<Diagnostic>> {
        let (name, member) = match &operand.kind {
            OperandKind::Number(value) => return Ok(Some(ResolvedOperand::Constant(*value))),
            OperandKind::Name(name) => (name, None),
            OperandKind::Member(words) => (&words.0, Some(words.1.as_str())),
        };
        if member.is_none()
            && let Some(value) = reserved::constant(name, self.edition)
        {
            let value = if operand.negative { -value } else { value };
            return Ok(Some(ResolvedOperand::Constant(value)));
        }
        let Some(variable) = self.find(name) else {
            if self.refused.contains(name.as_str()) {
                return Ok(None);
            }
            let guess = member.map_or(guess, type_with);
            return Err(Box::new(self.unknown(name, operand.span, guess)));
        };
        let Some(member) = member else {
            return Ok(Some(self.whole(variable, operand.negative)));
        };
        match self.member(variable, member) {
            Some(index) => Ok(Some(ResolvedOperand::Scalar {
                scalar: Scalar {
                    variable,
                    member: index,
                },
                negative: operand.negative,
                member: true,
            })),
            None => Err(Box::new(self.no_member(
                variable,
                member,
                operand.span,
                shape,
            ))),
        }
    }

    fn whole(&self, variable: VariableId, negative: bool) -> ResolvedOperand {
        match self.variables[variable].kind {
            VariableKind::Var => ResolvedOperand::Scalar {
                scalar: Scalar {
                    variable,
                    member: 0,
                },
                negative,
                member: false,
            },
            kind => ResolvedOperand::Struct {
                variable,
                kind,
                negative,
            },
        }
    }

    fn member(&self, variable: VariableId, member: &str) -> Option<usize> {
        let variable = &self.variables[variable];
        match variable.kind {
            VariableKind::Var => None,
            VariableKind::Pos => POSITION.iter().position(|name| *name == member),
            VariableKind::Joint => {
                (0..variable.size()).find(|index| member == format!("{JOINT}{}", index + 1))
            }
        }
    }

    fn no_member(&self, id: VariableId, member: &str, span: Span, shape: Code) -> Diagnostic {
        let variable = &self.variables[id];
        let name: SmolStr = variable.name.as_str().into();
        let reason = Naming::NoMember {
            name: name.clone(),
            member: member.into(),
        };
        let help = match variable.kind {
            VariableKind::Var => Naming::VarMembers { name },
            VariableKind::Pos => Naming::PosMembers { name },
            VariableKind::Joint => Naming::JointMembers {
                name,
                last: variable.size(),
            },
        };
        let mistake = format!("{} {}.{member}", shape.id(), variable.name);
        Diagnostic::new(shape, span, reason)
            .once(mistake)
            .help(help)
    }

    /// Returns what to write in place of a word of the language where a number belongs.
    fn suggest_for_word(&self, word: &str) -> Message {
        if flags::find(word, self.edition).is_some() {
            return ForeignWord::FlagAlone { flag: word.into() }.into();
        }
        if functions::find(word, self.edition).is_some() {
            let function = word.into();
            return ForeignWord::FunctionInEquation { function }.into();
        }
        let target = SmolStr::from(word);
        match word.parse() {
            Ok(Target::Joint(..)) => return Suggestion::OfJoint { target }.into(),
            Ok(Target::Foot(_)) => return Suggestion::OfFoot { target }.into(),
            _ => {}
        }
        if inputs::find(word, self.edition).is_some() {
            return Suggestion::ReadInput { input: target }.into();
        }
        let command = commands::find(word);
        match command.map(|command| (command.meaning, command.name)) {
            Some((Meaning::KeyIn, _)) => ForeignWord::KeyIn.into(),
            Some((Meaning::AdIn, _)) => ForeignWord::AdIn.into(),
            Some((Meaning::Robot(_), command)) => Suggestion::CommandFirst { command }.into(),
            _ => Naming::NumberBelongsHere.into(),
        }
    }

    /// `P_X` where `P.X` was meant.
    fn suggest_member(&self, name: &str) -> Option<String> {
        let (base, member) = name.rsplit_once('_')?;
        let variable = self.find(base)?;
        self.member(variable, member)
            .map(|_| format!("{base}.{member}"))
    }

    /// Returns the declared name that is nearest to an unknown one.
    fn nearest(&self, name: &str) -> Option<String> {
        let mut near = self.near.borrow_mut();
        if near.len() >= COMPARED && !near.contains_key(name) {
            return None;
        }
        let known = || self.variables.iter().map(|variable| variable.name.as_str());
        let nearest = || nearest(name, known()).map(str::to_owned);
        near.entry(name.to_owned()).or_insert_with(nearest).clone()
    }

    fn unknown(&self, name: &str, span: Span, guess: Option<VariableKind>) -> Diagnostic {
        let near = self.suggest_member(name).or_else(|| self.nearest(name));
        let help: Message = match near {
            _ if name.starts_with(CONSTANT) => Suggestion::Keys.into(),
            Some(near) => Suggestion::DidYouMean { near: near.into() }.into(),
            None if is_reserved(name, self.edition) => self.suggest_for_word(name),
            None => match foreign::constant(name) {
                Some(value) => ForeignWord::Number {
                    word: name.into(),
                    value,
                }
                .into(),
                None => match number_in(name).filter(|_| guess == Some(VariableKind::Var)) {
                    Some(number) => Suggestion::NumberOrVariable {
                        name: name.into(),
                        number,
                    }
                    .into(),
                    None => declare(name, guess).into(),
                },
            },
        };
        let reason = match is_reserved(name, self.edition) {
            true => Naming::NoNumber { word: name.into() },
            false => Naming::NotDeclared { name: name.into() },
        };
        Diagnostic::new(Code::UnknownVariable, span, reason)
            .about(name)
            .once(format!("variable {name}"))
            .help(help)
    }
}

/// `L00`, `X100`: the number that was meant, if there is one.
fn number_in(name: &str) -> Option<SmolStr> {
    foreign::axis_value(name).map_or_else(|| digits(name), |value| Some(value.into()))
}

/// `L00`: the number, if letters were typed that look like its digits.
fn digits(name: &str) -> Option<SmolStr> {
    let is_letter = |c: char| matches!(c, 'O' | 'I' | 'L');
    let is_number = name.len() > 2 && name.chars().all(|c| is_letter(c) || c.is_ascii_digit());
    let digit = |c: char| match c {
        'O' => '0',
        'I' | 'L' => '1',
        other => other,
    };
    let ends = name.ends_with(|c: char| c.is_ascii_digit());
    (is_number && ends).then(|| name.chars().map(digit).collect())
}

/// Returns the type that has a member of this name.
fn type_with(member: &str) -> Option<VariableKind> {
    let is_joint = |rest: &str| rest.parse::<u8>().is_ok();
    if POSITION.contains(&member) {
        return Some(VariableKind::Pos);
    }
    let joint = member.strip_prefix(JOINT).filter(|rest| is_joint(rest));
    joint.map(|_| VariableKind::Joint)
}

/// Returns the declaration of a variable, of one type if that is known.
fn declare(name: &str, kind: Option<VariableKind>) -> Naming {
    let keyword = match kind {
        Some(VariableKind::Var) => Keyword::DefVar,
        Some(VariableKind::Pos) => Keyword::DefPos,
        Some(VariableKind::Joint) => Keyword::DefJoint,
        None => return Naming::Declare { name: name.into() },
    };
    let declaration = format!("{keyword} {name}").into();
    Naming::DeclareAs { declaration }
}

/// Finds a motion command that has the word first.
fn used_in_motion(module: &Module, word: &str) -> Option<Span> {
    let motions = module.statements.iter().filter_map(motion_arguments);
    let is_word =
        |operand: &&Operand| matches!(&operand.kind, OperandKind::Name(name) if name == word);
    let used = motions.flatten().find(is_word);
    used.map(|operand| operand.span)
}

fn motion_arguments(statement: &Statement) -> Option<&[Operand]> {
    let StatementKind::Command {
        name, arguments, ..
    } = &statement.kind
    else {
        return None;
    };
    let Form::Robot(form) = commands::find(&name.node)?.form else {
        return None;
    };
    form.motion.then_some(arguments)
}
