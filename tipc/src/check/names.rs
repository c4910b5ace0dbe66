//! Declared variables and what stands for a number (T.I.P. 3.1 §4-4, §4-5, §7-10-1).

use crate::code::Code;
use crate::diagnostic::MOST;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::language::commands::{self, COMMANDS, Form, Meaning};
use crate::language::reserved::{self, JOINT, POSITION, VAR_KEY, is_motion_flag, is_reserved};
use crate::language::{Edition, Keyword, flags, functions, inputs, keywords, names};
use crate::message::{Message, Naming, Suggestion};
use crate::program::{self, Scalar, Variable, VariableId};
use crate::robot::Robot;
use crate::source::{Source, Span};
use crate::suggest::nearest;
use crate::syntax::{
    Module, Operand, OperandKind, Statement, StatementKind, VariableKind, Word, upper_case,
};
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
    /// Names in statements that could not be read, and may declare them: their uses are not reported.
    perhaps: HashSet<SmolStr>,
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
    pub(crate) fn collect(
        source: &Source,
        module: &Module,
        robot: Robot,
        found: &mut Diagnostics,
    ) -> Self {
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
        names.perhaps = declared_perhaps(source, module);
        names
    }

    /// Warns of variables called `R`, `A` or `HS`; a motion that has the word means its flag. Those that a fault
    /// explains are known.
    pub(crate) fn warn_of_flags(
        &self,
        module: &Module,
        known: &HashMap<VariableId, Span>,
        found: &mut Diagnostics,
    ) {
        for (id, (variable, declared)) in self.variables.iter().zip(&self.declared).enumerate() {
            let name = variable.name.as_str();
            let is_flag = is_motion_flag(name, self.edition);
            let used = is_flag.then(|| used_in_motion(module, name)).flatten();
            let used = used.filter(|used| known.get(&id) != Some(used));
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
            // Of a name that is declared again the type is not known.
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
                None if name.ends_with('$') => (name, Suggestion::NoText.into()),
                Some((array, _)) if names::is_variable(array) => {
                    (array, Suggestion::NoArray { name: array.into() }.into())
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

    /// Returns true if the declaration of a name was refused, which is reported.
    pub(crate) fn is_refused(&self, name: &str) -> bool {
        self.refused.contains(name)
    }

    /// Returns true if a statement that could not be read may declare a name.
    pub(crate) fn may_declare(&self, name: &str) -> bool {
        self.perhaps.contains(name)
    }

    /// Returns true if a name was suggested in the place of one that is not declared.
    pub(crate) fn was_suggested(&self) -> impl Fn(&str) -> bool {
        let near = self.near.borrow();
        let suggested: HashSet<String> = near.values().flatten().cloned().collect();
        move |name| suggested.contains(name)
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
        if self.is_refused(name) {
            return Ok(None);
        }
        let Some(variable) = self.find(name) else {
            if self.may_declare(name) {
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
            return Suggestion::FlagAlone { flag: word.into() }.into();
        }
        if functions::find(word, self.edition).is_some() {
            let function = word.into();
            return Suggestion::FunctionInEquation { function }.into();
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
            Some((Meaning::KeyIn, _)) => Suggestion::KeyIn.into(),
            Some((Meaning::AdIn, _)) => Suggestion::AdIn.into(),
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
            None => match digits(name).filter(|_| guess == Some(VariableKind::Var)) {
                Some(number) => Suggestion::NumberOrVariable {
                    name: name.into(),
                    number,
                }
                .into(),
                None => declare(name, guess).into(),
            },
        };
        let reason = match is_reserved(name, self.edition) {
            true => Naming::NoNumber { word: name.into() },
            false => Naming::NotDeclared { name: name.into() },
        };
        let is_guess = help == declare(name, guess).into();
        let fault = Diagnostic::new(Code::UnknownVariable, span, reason)
            .about(name)
            .once(format!("variable {name}"));
        match is_guess {
            true => fault.guess(help),
            false => fault.help(help),
        }
    }
}

/// Returns the names in statements whose first word the language lacks: `INT N`, `VAR A, B`.
fn declared_perhaps(source: &Source, module: &Module) -> HashSet<SmolStr> {
    let mut compared = 0;
    let mut all = HashSet::new();
    for statement in &module.statements {
        let StatementKind::Command { name, .. } = &statement.kind else {
            continue;
        };
        if commands::find(&name.node).is_some() {
            continue;
        }
        // A misspelt command declares nothing, unless it is that of a declaration.
        compared += 1;
        let near = || nearest(&name.node, COMMANDS.iter().map(|command| command.name));
        let keyword = |near: &str| keywords::find(near, module.edition);
        let declares = |near: &str| {
            let declarations = [Keyword::DefVar, Keyword::DefPos, Keyword::DefJoint];
            keyword(near).is_some_and(|it| declarations.contains(&it))
        };
        if compared > COMPARED || near().is_none_or(declares) {
            // Also the first word: `DEF_VAR A; B`.
            let is_outside = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
            let words = source.slice(statement.span).split(is_outside);
            all.extend(
                words
                    .map(upper_case)
                    .filter(|word| names::is_variable(word)),
            );
        }
    }
    all
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
