//! Variables and constants that a program declares, and the meaning of its operands (T.I.P. 3.1 §4-4, §4-5, §7-10-1).

use crate::code::Code;
use crate::diagnostic::{Diagnostic, Diagnostics, MAX_DIAGNOSTICS, MistakeId};
use crate::language::commands::{self, Form, Meaning};
use crate::language::reserved::{self, JOINT, POSITION, VAR_KEY, is_motion_flag, is_reserved};
use crate::language::{Edition, Keyword, flags, functions, inputs, keywords, names};
use crate::message::list::List;
use crate::message::phrase::Inventory;
use crate::message::{Commanding, Message, Naming, Suggestion};
use crate::program::{self, Scalar, StructOperand, Variable, VariableId};
use crate::robot::Robot;
use crate::source::{Source, Span};
use crate::suggest::{digit_like, nearest};
use crate::syntax::{
    Module, Operand, OperandKind, Statement, StatementKind, VariableKind, Word, upper_case,
};
use smol_str::SmolStr;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use tip_runtime::command::{CONSTANT, READING, Reading, Target};

/// Maximum number of unknown names that are compared with declared ones.
const MAX_COMPARED: usize = MAX_DIAGNOSTICS;

/// `VAR_KEY` is the first of all variables.
pub(super) const VAR_KEY_ID: VariableId = 0;

/// Every variable and constant of a program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    pub(crate) variables: Vec<Variable>,
    /// Declaration of each variable; `None` for VAR_KEY and those that are shared with native code.
    pub(crate) declared: Vec<Option<Span>>,
    ids: HashMap<String, VariableId>,
    /// The constants that DEFINE names, in order of the text.
    pub(crate) constants: Vec<NamedConstant>,
    constant_ids: HashMap<SmolStr, usize>,
    /// Known names nearest to unknown ones, so that each is compared once.
    near: RefCell<HashMap<String, Option<String>>>,
    /// Names whose declaration was refused: their uses are not reported again.
    refused: HashSet<String>,
    /// Names in statements that could not be read. Such a statement may declare them, so their uses are not reported.
    perhaps: HashSet<SmolStr>,
    joints: usize,
    robot: Robot,
    /// The edition of the program, which decides what words are reserved.
    pub(crate) edition: Edition,
}

/// A constant that DEFINE names.
#[derive(Clone, Debug)]
pub(crate) struct NamedConstant {
    pub(crate) name: SmolStr,
    /// Its name in the definition.
    pub(crate) span: Span,
    /// Its value; `None` if the definition has none, which is reported.
    pub(crate) value: Option<f64>,
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
    /// A special variable of this type, or a member of it.
    Reading {
        reading: Reading,
        kind: VariableKind,
        member: Option<usize>,
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
            ResolvedOperand::Reading {
                reading,
                kind,
                member,
                negative,
            } if kind == VariableKind::Var || member.is_some() => Some(program::Operand::Reading {
                reading,
                member: member.unwrap_or(0),
                negative,
            }),
            ResolvedOperand::Reading { .. } | ResolvedOperand::Struct { .. } => None,
        }
    }

    /// Returns the whole POS or JOINT, its type, and true if a minus precedes it; `None` for a number.
    pub(crate) fn structure(self) -> Option<(StructOperand, VariableKind, bool)> {
        match self {
            ResolvedOperand::Struct {
                variable,
                kind,
                negative,
            } => Some((StructOperand::Variable(variable), kind, negative)),
            ResolvedOperand::Reading {
                reading,
                kind: kind @ (VariableKind::Pos | VariableKind::Joint),
                member: None,
                negative,
            } => Some((StructOperand::Reading(reading), kind, negative)),
            _ => None,
        }
    }

    /// Returns true for a member of a POS or JOINT.
    pub(crate) fn is_member(self) -> bool {
        matches!(
            self,
            ResolvedOperand::Scalar { member: true, .. }
                | ResolvedOperand::Reading {
                    member: Some(_),
                    ..
                }
        )
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
        let shared = match module.edition >= Edition::V3_2 {
            true => {
                let all = Names::with(
                    module,
                    robot,
                    &shared_variables(|_| true),
                    &mut Diagnostics::default(),
                );
                let used = all.used_in(source, module);
                shared_variables(|name| used.contains(name))
            }
            false => Vec::new(),
        };
        let mut names = Names::with(module, robot, &shared, found);
        names.perhaps = declared_perhaps(source, module);
        names
    }

    /// Reads every declaration. The variables of `shared`, which are shared with native code, come before the declared
    /// ones.
    fn with(
        module: &Module,
        robot: Robot,
        shared: &[(String, VariableKind, u8)],
        found: &mut Diagnostics,
    ) -> Self {
        let mut names = Names {
            joints: usize::from(robot.signature().joints),
            robot,
            edition: module.edition,
            ..Names::default()
        };
        names.insert(VAR_KEY, VariableKind::Var, None, None);
        for (name, kind, number) in shared {
            names.insert(name, *kind, None, Some(*number));
        }
        for statement in &module.statements {
            match &statement.kind {
                StatementKind::Define {
                    kind, names: words, ..
                } => {
                    for word in words {
                        names.declare(*kind, word, found);
                    }
                }
                StatementKind::Constant { name, .. } => names.define(name, found),
                _ => {}
            }
        }
        // A value may name a variable that is declared below it, so values are read after all names.
        for statement in &module.statements {
            if let StatementKind::Constant { name, value, .. } = &statement.kind {
                names.evaluate(name, value, found);
            }
        }
        names
    }

    /// Returns the names of variables shared with native code that the program uses.
    fn used_in(&self, source: &Source, module: &Module) -> HashSet<String> {
        let mut used = HashSet::new();
        let mut note = |id: VariableId| {
            let variable = &self.variables[id];
            if variable.special.is_some() {
                used.insert(variable.name.clone());
            }
        };
        for statement in &module.statements {
            statement.kind.each_operand(&mut |operand| {
                let named = operand.name().and_then(|name| self.find(name));
                named.into_iter().for_each(&mut note);
            });
            if let StatementKind::Message { text } | StatementKind::FileMessage { text } =
                &statement.kind
            {
                self.each_shown(source.slice(text.span), &mut note);
            }
        }
        used
    }

    /// Warns of variables and constants called `R`, `A` or `HS` that a motion uses: it reads them as flags. `known` has
    /// the use of each variable that an error explains already.
    pub(crate) fn warn_of_flags(
        &self,
        module: &Module,
        known: &HashMap<VariableId, Span>,
        found: &mut Diagnostics,
    ) {
        let variables = self.variables.iter().map(|variable| variable.name.as_str());
        let variables = variables.zip(self.declared.iter().copied());
        let variables = variables.enumerate().map(|(id, it)| (known.get(&id), it));
        let constants = self.constants.iter();
        let constants = constants.map(|constant| (constant.name.as_str(), Some(constant.span)));
        let constants = constants.map(|it| (None, it));
        for (explained, (name, declared)) in variables.chain(constants) {
            let is_flag = is_motion_flag(name, self.edition);
            let used = is_flag.then(|| used_in_motion(module, name)).flatten();
            let used = used.filter(|used| explained != Some(used));
            if let (Some(declared), Some(used)) = (declared, used) {
                let warning = Diagnostic::new(Code::FlagName, declared, Naming::ReadAsFlag)
                    .about(name)
                    .label(used, Naming::FlagHere)
                    .help(Naming::ChooseAnother);
                found.push(warning);
            }
        }
    }

    fn insert(
        &mut self,
        name: &str,
        kind: VariableKind,
        location: Option<Span>,
        special: Option<u8>,
    ) {
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
            special,
        });
    }

    fn declare(&mut self, kind: VariableKind, word: &Word, found: &mut Diagnostics) {
        let name = word.node.as_str();
        if let Some(fault) = self.refusal(word) {
            found.push(fault);
            // The type that was meant is not known, so uses of the name are not reported.
            let array = name.split_once(['(', '[', '.']);
            self.refused
                .insert(array.map_or(name, |(name, _)| name).to_owned());
            return;
        }
        self.insert(name, kind, Some(word.span), None);
    }

    /// Reads the name of a DEFINE.
    fn define(&mut self, word: &Word, found: &mut Diagnostics) {
        if let Some(fault) = self.refusal(word) {
            found.push(fault);
            self.refused.insert(word.node.to_string());
            return;
        }
        self.constant_ids
            .insert(word.node.clone(), self.constants.len());
        self.constants.push(NamedConstant {
            name: word.node.clone(),
            span: word.span,
            value: None,
        });
    }

    /// Evaluates a DEFINE. Those above it must be evaluated before.
    fn evaluate(&mut self, name: &Word, value: &Operand, found: &mut Diagnostics) {
        let number = self.constant_of(name, value);
        let id = self.constant_ids.get(&name.node).copied();
        let own = id.filter(|id| self.constants[*id].span == name.span);
        match (number, own) {
            (Ok(number), Some(own)) => self.constants[own].value = number,
            (Ok(_), None) => {}
            (Err(fault), _) => {
                found.push(*fault);
            }
        }
    }

    fn constant_of(&self, name: &Word, value: &Operand) -> Result<Option<f64>, Box<Diagnostic>> {
        if let OperandKind::Name(used) = &value.kind
            && let Some(constant) = self.find_constant(used)
            && self.constants[constant].span.start >= name.span.start
        {
            let reason = Naming::DefinedBelow { name: used.clone() };
            let fault = Diagnostic::new(Code::UnknownVariable, value.span, reason);
            return Err(Box::new(
                fault.about(used.as_str()).help(Naming::DefineAbove),
            ));
        }
        match self.operand(value, Code::Argument, Some(VariableKind::Var))? {
            Some(ResolvedOperand::Constant(value)) => Ok(Some(value)),
            None => Ok(None),
            Some(_) => {
                let name = match &value.kind {
                    OperandKind::Name(name) => name.clone(),
                    OperandKind::Member(words) => format!("{}.{}", words.0, words.1).into(),
                    OperandKind::Number(_) => SmolStr::default(),
                };
                let fault =
                    Diagnostic::new(Code::Argument, value.span, Naming::NotConstant { name });
                Err(Box::new(fault.help(Naming::ConstantIs)))
            }
        }
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
            return Some(fault.once(MistakeId::Word(mistake.into())).help(help));
        }
        if is_reserved(name, self.edition) {
            let help = Naming::ChooseAnother;
            return Some(fault(Naming::WordOfLanguage { word: name.into() }).help(help));
        }
        let constant = self.find_constant(name);
        let first = match (self.ids.get(name), constant) {
            (Some(variable), _) => self.declared[*variable],
            (None, constant) => Some(self.constants[constant?].span),
        };
        let again = fault(Naming::DeclaredAgain { name: name.into() }).help(Naming::DeclareOnce);
        Some(match first {
            Some(location) => again.label(location, Naming::FirstDeclared),
            None => again,
        })
    }

    /// Returns the number of variables that are not declared: they come first.
    pub(crate) fn predeclared(&self) -> usize {
        let mut all = self.declared.iter();
        all.position(Option::is_some).unwrap_or(self.declared.len())
    }

    /// Returns true if the declaration of a name was refused, which is reported.
    pub(crate) fn is_refused(&self, name: &str) -> bool {
        self.refused.contains(name)
    }

    /// Returns true if a statement that could not be read may declare a name.
    pub(crate) fn may_declare(&self, name: &str) -> bool {
        self.perhaps.contains(name)
    }

    /// Returns a predicate that is true for names that were suggested in place of undeclared ones.
    pub(crate) fn was_suggested(&self) -> impl Fn(&str) -> bool {
        let near = self.near.borrow();
        let suggested: HashSet<String> = near.values().flatten().cloned().collect();
        move |name| suggested.contains(name)
    }

    /// Returns the variable of that name.
    pub(crate) fn find(&self, name: &str) -> Option<VariableId> {
        self.ids.get(name).copied()
    }

    /// Returns the type of a variable, special variable or constant; a constant has the type VAR.
    pub(crate) fn kind_of(&self, name: &str) -> Option<VariableKind> {
        if name.starts_with(READING) {
            return reserved::reading(name, self.edition).map(VariableKind::of_reading);
        }
        let constant = || self.find_constant(name).map(|_| VariableKind::Var);
        let variable = self.find(name).map(|id| self.variables[id].kind);
        variable.or_else(constant)
    }

    /// Returns the value of an operand that is a constant.
    pub(crate) fn constant(&self, operand: &Operand) -> Option<f64> {
        match self.operand(operand, Code::Argument, None) {
            Ok(Some(ResolvedOperand::Constant(value))) => Some(value),
            _ => None,
        }
    }

    /// Returns the index of the constant of that name.
    pub(crate) fn find_constant(&self, name: &str) -> Option<usize> {
        self.constant_ids.get(name).copied()
    }

    /// Returns true if the program declares a variable or defines a constant of that name.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.find(name).is_some() || self.find_constant(name).is_some()
    }

    /// Resolves an operand. `mistake` is the code to report for a member that the variable lacks; `guess` is the type
    /// that an unknown variable is used as.
    ///
    /// `None` if the name's declaration was refused, which is reported already.
    pub(crate) fn operand(
        &self,
        operand: &Operand,
        mistake: Code,
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
        if name.starts_with(READING) {
            return self.reading(operand, name, member, mistake).map(Some);
        }
        if let Some(constant) = self.find_constant(name) {
            return match (member, self.constants[constant].value) {
                (Some(member), _) => {
                    let reason = Naming::NoMember {
                        name: name.clone(),
                        member: member.into(),
                    };
                    let help = Naming::ConstantMembers { name: name.clone() };
                    Err(Box::new(
                        Diagnostic::new(mistake, operand.span, reason).help(help),
                    ))
                }
                (None, value) => {
                    let sign = if operand.negative { -1.0 } else { 1.0 };
                    Ok(value.map(|value| ResolvedOperand::Constant(sign * value)))
                }
            };
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
                mistake,
            ))),
        }
    }

    /// Resolves a special variable, which the robot has to sense.
    fn reading(
        &self,
        operand: &Operand,
        name: &SmolStr,
        member: Option<&str>,
        mistake: Code,
    ) -> Result<ResolvedOperand, Box<Diagnostic>> {
        let Some(reading) = reserved::reading(name, self.edition) else {
            let reason = Naming::NoReading { word: name.clone() };
            let fault = Diagnostic::new(Code::UnknownVariable, operand.span, reason);
            let fault = fault
                .about(name.as_str())
                .once(MistakeId::Variable(name.clone()));
            return Err(Box::new(fault.help(Naming::Readings)));
        };
        if let Some(fault) = self.not_sensed(reading, operand.span) {
            return Err(fault);
        }
        let kind = VariableKind::of_reading(reading);
        let index = match member {
            None => None,
            Some(member) => match self.member_of(kind, member) {
                Some(index) => Some(index),
                None => {
                    let reason = Naming::NoMember {
                        name: name.clone(),
                        member: member.into(),
                    };
                    let help = Naming::ReadingMembers { word: name.clone() };
                    return Err(Box::new(
                        Diagnostic::new(mistake, operand.span, reason).help(help),
                    ));
                }
            },
        };
        Ok(ResolvedOperand::Reading {
            reading,
            kind,
            member: index,
            negative: operand.negative,
        })
    }

    /// Returns what is wrong with a special variable that the robot cannot sense.
    pub(crate) fn not_sensed(&self, reading: Reading, span: Span) -> Option<Box<Diagnostic>> {
        let Reading::Measured(what, target) = reading else {
            return None;
        };
        let (robot, word) = (self.robot.name(), SmolStr::from(reading.to_string()));
        let reason: Message = match () {
            () if !self.robot.has(target) => Commanding::RobotHasNo { robot, target }.into(),
            () if !commands::senses(self.robot, what) => Naming::NotSensed { robot, word }.into(),
            () => return None,
        };
        let inventory = inventory(self.robot);
        let fault = Diagnostic::new(Code::Argument, span, reason);
        Some(Box::new(fault.help(Commanding::RobotHas { inventory })))
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
        self.member_of(self.variables[variable].kind, member)
    }

    /// Returns the number of scalars of a whole variable or special variable.
    pub(crate) fn size_of(&self, whole: StructOperand) -> usize {
        match whole {
            StructOperand::Variable(variable) => self.variables[variable].size(),
            StructOperand::Reading(reading) => match VariableKind::of_reading(reading) {
                VariableKind::Var => 1,
                VariableKind::Pos => POSITION.len(),
                VariableKind::Joint => self.joints,
            },
        }
    }

    /// Returns the index of a member of a type.
    pub(crate) fn member_of(&self, kind: VariableKind, member: &str) -> Option<usize> {
        match kind {
            VariableKind::Var => None,
            VariableKind::Pos => POSITION.iter().position(|name| *name == member),
            VariableKind::Joint => {
                (0..self.joints).find(|index| member == format!("{JOINT}{}", index + 1))
            }
        }
    }

    fn no_member(&self, id: VariableId, member: &str, span: Span, code: Code) -> Diagnostic {
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
        let mistake = MistakeId::Member {
            code,
            variable: variable.name.as_str().into(),
            member: member.into(),
        };
        Diagnostic::new(code, span, reason).once(mistake).help(help)
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
        let command = commands::find_in(word, self.edition);
        match command.map(|command| (command.meaning, command.name)) {
            Some((Meaning::KeyIn, _)) => Suggestion::KeyIn.into(),
            Some((Meaning::AdIn, _)) => Suggestion::AdIn.into(),
            Some((Meaning::Robot(_), command)) => Suggestion::CommandFirst { command }.into(),
            _ => Naming::NumberBelongsHere.into(),
        }
    }

    /// Returns `P.X` for `P_X`, if `P` is a variable with that member.
    fn suggest_member(&self, name: &str) -> Option<String> {
        let (base, member) = name.rsplit_once('_')?;
        let variable = self.find(base)?;
        self.member(variable, member)
            .map(|_| format!("{base}.{member}"))
    }

    /// Returns the declared name that is nearest to an unknown one.
    fn nearest(&self, name: &str) -> Option<String> {
        let mut near = self.near.borrow_mut();
        if near.len() >= MAX_COMPARED && !near.contains_key(name) {
            return None;
        }
        let known = || {
            let variables = self.variables.iter().map(|variable| variable.name.as_str());
            let constants = self.constants.iter();
            variables.chain(constants.map(|constant| constant.name.as_str()))
        };
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
            .once(MistakeId::Variable(name.into()));
        match is_guess {
            true => fault.guess(help),
            false => fault.help(help),
        }
    }
}

/// Returns the targets that a robot has.
pub(super) fn inventory(robot: Robot) -> Inventory {
    Inventory::Has {
        robot: robot.name(),
        targets: List(robot.inventory()),
    }
}

/// Returns name, type and number of the variables that programs share with native code and whose names pass a test.
fn shared_variables(is_used: impl Fn(&str) -> bool) -> Vec<(String, VariableKind, u8)> {
    let kinds = [VariableKind::Var, VariableKind::Pos, VariableKind::Joint];
    let all = reserved::SPECIALS.into_iter().zip(kinds);
    let all = all.flat_map(|(stem, kind)| (0..10).map(move |n| (format!("{stem}{n}"), kind, n)));
    all.filter(|(name, ..)| is_used(name)).collect()
}

/// Returns the names in statements whose first word the language lacks: `INT N`, `VAR A, B`.
fn declared_perhaps(source: &Source, module: &Module) -> HashSet<SmolStr> {
    let mut compared = 0;
    let mut all = HashSet::new();
    for statement in &module.statements {
        let StatementKind::Command { name, .. } = &statement.kind else {
            continue;
        };
        if commands::find_in(&name.node, module.edition).is_some() {
            continue;
        }
        // A misspelt command declares nothing, unless it is the command of a declaration.
        compared += 1;
        let near = || nearest(&name.node, commands::names(module.edition));
        let keyword = |near: &str| keywords::find(near, module.edition);
        let declares = |near: &str| {
            let declarations = [Keyword::DefVar, Keyword::DefPos, Keyword::DefJoint];
            keyword(near).is_some_and(|it| declarations.contains(&it))
        };
        if compared > MAX_COMPARED || near().is_none_or(declares) {
            // The first word counts as well: `DEF_VAR A; B`.
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

/// Returns the number that a name such as `L00` was meant to be, if its letters look like digits.
fn digits(name: &str) -> Option<SmolStr> {
    let is_number = name.len() > 2 && name.chars().all(|c| digit_like(c).is_ascii_digit());
    let ends = name.ends_with(|c: char| c.is_ascii_digit());
    (is_number && ends).then(|| name.chars().map(digit_like).collect())
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

/// Returns the location of the first operand of a motion that is this word.
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
