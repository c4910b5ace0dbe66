//! The names of a program: what defines them, and every location that names them.

use crate::program::VariableId;
use crate::source::{Source, Span};
use crate::syntax::VariableKind;
use smol_str::SmolStr;

/// All names of a program that it defines itself, and `VAR_KEY`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Symbols {
    definitions: Vec<Definition>,
    uses: Vec<Use>,
}

/// A definition, by its index among [`Symbols::definitions`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DefinitionId(u32);

/// A variable, label, SUBROUTINE, THREAD or constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Definition {
    /// Its name, upper case.
    pub name: SmolStr,
    /// Kind of the definition.
    pub kind: DefinitionKind,
    /// The name where it is defined; `VAR_KEY` is defined nowhere.
    pub span: Option<Span>,
}

/// Kind of a definition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DefinitionKind {
    /// A variable of this type.
    Variable(VariableKind),
    /// A label.
    Label,
    /// A label that SUBROUTINE declares.
    Subroutine,
    /// A label that THREAD declares.
    Thread,
    /// A constant that DEFINE names.
    Constant,
}

/// A location that names a definition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Use {
    /// The name alone, without sign, member and colon. It is empty where the name is left out, after KEY_IN, NEXT and GOTO.
    pub span: Span,
    /// Definition that it names.
    pub definition: DefinitionId,
    /// Access by the statement.
    pub access: Access,
    /// The member of a POS or JOINT that is meant, from 0; none means the whole.
    pub member: Option<u8>,
    /// A minus precedes it.
    pub negative: bool,
}

/// Access of a statement to what it names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// Defines it. A second definition is refused.
    Define,
    /// Reads it.
    Read,
    /// Assigns it.
    Assign,
    /// Assigns and reads it: `A += 1`, or FOR.
    Update,
    /// NEXT: assigns and reads the variable of its FOR.
    Count,
    /// GOTO leads there.
    Jump,
    /// GOSUB or CALL leads there and comes back.
    Call,
    /// START_THREAD starts it.
    Start,
    /// STOP_THREAD or WAIT_THREAD names it.
    Control,
    /// Unknown, since the statement is wrong.
    Unclear,
}

impl DefinitionId {
    /// Returns the index among [`Symbols::definitions`].
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Creates the definition of a variable: they come first.
    pub const fn of_variable(variable: VariableId) -> Self {
        DefinitionId(variable as u32)
    }

    /// Creates the definition of a label, by its index among all labels. They come after all variables.
    pub(crate) const fn of_label(label: usize, variables: usize) -> Self {
        DefinitionId((variables + label) as u32)
    }

    /// Creates the definition of a constant, by its index among all constants. They come after variables and labels.
    pub(crate) const fn of_constant(constant: usize, before: usize) -> Self {
        DefinitionId((before + constant) as u32)
    }
}

impl Symbols {
    /// Creates the table. The uses have to be in the order of their locations.
    pub(crate) const fn new(definitions: Vec<Definition>, uses: Vec<Use>) -> Self {
        Symbols { definitions, uses }
    }

    /// Returns the variables in the order of [`Program::variables`](crate::program::Program::variables), `VAR_KEY`
    /// first; then the labels in the order of [`Program::labels`](crate::program::Program::labels), then the constants.
    /// Only the first of several definitions of a name is included, but each LOOP is a label of its own.
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// Returns every location that names one of the definitions, and every definition, in the order of the text.
    pub fn all_uses(&self) -> &[Use] {
        &self.uses
    }

    /// Returns one of the definitions.
    ///
    /// # Panics
    ///
    /// The id is of other symbols.
    pub fn definition(&self, id: DefinitionId) -> &Definition {
        &self.definitions[id.index()]
    }

    /// Returns the locations that name a definition, itself among them.
    pub fn uses(&self, id: DefinitionId) -> impl Iterator<Item = &Use> {
        self.uses.iter().filter(move |it| it.definition == id)
    }

    /// Returns the use at a byte of the text: in the name, in the member after it, or right after them.
    pub fn at(&self, offset: usize) -> Option<&Use> {
        let behind = self.uses.partition_point(|it| it.span.start <= offset);
        let last = self.uses[..behind].last()?;
        let is_named = last.span.start < last.span.end;
        (is_named && offset <= self.end(last)).then_some(last)
    }

    /// Returns the uses inside a stretch of the text, such as a statement.
    pub fn within(&self, span: Span) -> &[Use] {
        let start = self.uses.partition_point(|it| it.span.start < span.start);
        let rest = &self.uses[start..];
        &rest[..rest.partition_point(|it| it.span.end <= span.end)]
    }

    /// Returns the operand of a statement that reads a scalar of this name; the whole statement if none names it.
    pub fn read_in(
        &self,
        source: &Source,
        statement: Span,
        variable: VariableId,
        scalar: &str,
    ) -> Span {
        let named = self.within(statement).iter();
        let named = named.filter(|it| it.definition == DefinitionId::of_variable(variable));
        // An updated variable is read after the operands of the right side.
        let first = named.clone().filter(|it| it.access == Access::Read);
        let last = named.filter(|it| it.access == Access::Update);
        let operands: Vec<Span> = first.chain(last).map(|it| it.operand(source)).collect();
        let names_it = |location: &&Span| {
            let operand = source.slice(**location).to_ascii_uppercase();
            operand.trim_start_matches('-') == scalar
        };
        let operand = operands.iter().find(names_it).or(operands.first());
        operand.copied().unwrap_or(statement)
    }

    /// Returns the end of a name, with its member.
    fn end(&self, named: &Use) -> usize {
        let point_and_member = match (named.member, self.definition(named.definition).kind) {
            (None, _) => 0,
            (Some(_), DefinitionKind::Variable(VariableKind::Joint)) => ".J1".len(),
            (Some(_), _) => ".X".len(),
        };
        named.span.end + point_and_member
    }
}

impl Use {
    /// Returns the operand that the name is part of: with its sign and member, and in a MESSAGE with its percent
    /// signs.
    pub fn operand(&self, source: &Source) -> Span {
        let Span { start, end } = self.span;
        let text = source.text();
        let before = text.get(..start).unwrap_or_default();
        let behind = text.get(end..).unwrap_or_default();
        if before.ends_with('%')
            && let Some(length) = behind.find('%')
        {
            return Span::new(start - 1, end + length + 1);
        }
        let length = match self.member {
            None => 0,
            Some(_) => {
                let is_outside = |char: char| char != '.' && !char.is_ascii_alphanumeric();
                behind.find(is_outside).unwrap_or(behind.len())
            }
        };
        Span::new(start - usize::from(self.negative), end + length)
    }
}
