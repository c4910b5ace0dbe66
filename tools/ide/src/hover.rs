//! Hovers: facts about the word under the cursor, as Markdown. A word of the language shows its row of the tables, a name what the
//! program does with it.

use crate::Document;
use crate::message::Editing;
use crate::word::{Word, WordKind};
use tip_lint::cycles::{Part, Span as PartSpan};
use tipc::code::Code;
use tipc::language::commands::{self, Command, Cycles, Robots};
use tipc::language::functions::{self, Operation};
use tipc::language::{Bilingual, Keyword};
use tipc::message::list::{Each, List};
use tipc::message::{Lang, Message};
use tipc::program::StepId;
use tipc::source::Span;
use tipc::symbols::{Access, Definition, DefinitionKind, Use};
use tipc::syntax::{Counting, Expression, OperandKind, StatementKind, VariableKind};

/// Maximum number of values that are listed.
const MAX_VALUES: usize = 8;

/// Facts about a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// The word.
    pub span: Span,
    /// The facts, as Markdown.
    pub text: String,
}

/// The Markdown of a hover while it is written: code, a paragraph, and a list.
struct Card {
    lang: Lang,
    text: String,
}

impl Document {
    /// Returns the facts about the word at a byte of the text.
    pub fn hover(&self, offset: usize, lang: Lang) -> Option<Hover> {
        let word = self.word_at(offset)?;
        let mut card = Card {
            lang,
            text: String::new(),
        };
        self.describe(&word, &mut card)?;
        Some(Hover {
            span: word.span,
            text: card.text.trim_end().to_owned(),
        })
    }

    fn describe(&self, word: &Word, card: &mut Card) -> Option<()> {
        let upper = || self.slice(word.span).to_ascii_uppercase();
        match word.kind {
            WordKind::Command(command) => self.command(command, card),
            WordKind::Keyword(keyword) => self.keyword_card(keyword, card),
            WordKind::Function(row) => {
                card.row(
                    &usage(row),
                    row.description,
                    Robots::ALL,
                    (row.section, row.clause),
                );
            }
            WordKind::Flag(row) => {
                card.row(
                    &upper(),
                    row.description,
                    row.robots,
                    (row.section, row.clause),
                );
            }
            WordKind::Input(row) => {
                card.row(
                    &upper(),
                    row.description,
                    row.robots,
                    (row.section, row.clause),
                );
            }
            WordKind::Target(row)
            | WordKind::Reading(row)
            | WordKind::MotionFlag(row)
            | WordKind::Member(row) => {
                card.row(
                    &upper(),
                    row.description,
                    Robots::ALL,
                    (row.section, row.clause),
                );
            }
            WordKind::Constant(value, row) => {
                card.row(
                    &upper(),
                    row.description,
                    Robots::ALL,
                    (row.section, row.clause),
                );
                card.item(Editing::Value { value });
            }
            WordKind::Name(named) => return self.name_card(&named, card),
            WordKind::Version
            | WordKind::Text
            | WordKind::Comment
            | WordKind::Number
            | WordKind::Operator
            | WordKind::Unknown => return None,
        }
        self.add_step(word, card);
        Some(())
    }

    /// Adds the step of a command or keyword, and the duration of the loop that it opens.
    fn add_step(&self, word: &Word, card: &mut Card) {
        let module = &self.loaded.module;
        let Some(index) = module.statement_at(word.span.start) else {
            return;
        };
        let statement = &module.statements[index];
        if statement.span.start != word.span.start || !statement.is_step() {
            return;
        }
        card.item(Editing::Step {
            step: statement.step,
        });
        if let Some(turns) = self.turns_of(statement.step) {
            card.item(turns);
        }
    }

    fn command(&self, command: &Command, card: &mut Card) {
        card.code(
            &command
                .usage(self.robot(), self.loaded.module.edition)
                .join("\n"),
        );
        card.paragraph(command.description);
        if !command.unit.is_empty() {
            card.item(Editing::Unit { unit: command.unit });
        }
        card.item(match command.cycles {
            Cycles::Zero => Editing::NoStep,
            Cycles::One => Editing::OneCycle,
            Cycles::Until(what) => Editing::Waits { what },
        });
        card.robots(command.robots);
        for (fault, when) in command.failures() {
            let fault = Code::of_fault(&fault).template().replace(" {}", "");
            card.item(Editing::Stops { fault, when });
        }
        card.reference(command.section, command.clause);
    }

    fn keyword_card(&self, keyword: Keyword, card: &mut Card) {
        if let Some(command) = commands::find_in(keyword.word(), self.loaded.module.edition) {
            return self.command(command, card);
        }
        let row = keyword.row();
        card.row(
            row.word,
            row.description,
            Robots::ALL,
            (row.section, row.clause),
        );
    }

    fn name_card(&self, named: &Use, card: &mut Card) -> Option<()> {
        let definition = self.definition_of(named);
        card.code(&declaration(definition));
        match definition.span {
            Some(place) => card.item(Editing::DeclaredOn {
                line: self.line_of(place.start),
            }),
            None => card.item(Editing::Predeclared),
        }
        match definition.kind {
            DefinitionKind::Variable(_) => self.variable(named, card),
            DefinitionKind::Label | DefinitionKind::Subroutine | DefinitionKind::Thread => {
                self.label(named, card);
            }
            DefinitionKind::Constant => {}
        }
        Some(())
    }

    fn variable(&self, named: &Use, card: &mut Card) {
        let uses = || self.loaded.symbols.uses(named.definition);
        let count = |wanted: &[Access]| uses().filter(|it| wanted.contains(&it.access)).count();
        card.item(Editing::Touched {
            assigned: count(&[Access::Assign, Access::Update, Access::Count]),
            read: count(&[Access::Read, Access::Update, Access::Count]),
        });
        let same: Vec<&Use> = uses().filter(|it| overlaps(named, it)).collect();
        if let Some(counting) = self.counting(&same) {
            card.item(counting);
        }
        if let Some(values) = self.constants(&same).filter(|values| !values.is_empty()) {
            card.item(Editing::Given {
                values: List(values),
            });
        }
    }

    /// Returns the numbers that are assigned, unless other values are assigned, too, or there are too many.
    fn constants(&self, uses: &[&Use]) -> Option<Vec<String>> {
        let mut values = Vec::new();
        for it in uses {
            match it.access {
                Access::Assign => {
                    let value = self.constant(it)?.to_string();
                    if !values.contains(&value) {
                        values.push(value);
                    }
                    if values.len() > MAX_VALUES {
                        return None;
                    }
                }
                Access::Update | Access::Count | Access::Unclear => return None,
                _ => {}
            }
        }
        Some(values)
    }

    /// Returns the number that the equation at a use assigns.
    fn constant(&self, named: &Use) -> Option<f64> {
        let module = &self.loaded.module;
        let statement = &module.statements[module.statement_at(named.span.start)?];
        let StatementKind::Equation(equation) = &statement.kind else {
            return None;
        };
        match &equation.value {
            Expression::Operand(operand) if equation.update.is_none() => match operand.kind {
                OperandKind::Number(value) => Some(value),
                _ => None,
            },
            _ => None,
        }
    }

    /// Returns the range of the FOR that alone changes a variable.
    fn counting(&self, uses: &[&Use]) -> Option<Editing> {
        let mut updates = uses.iter().filter(|it| it.access == Access::Update);
        let (update, None) = (updates.next()?, updates.next()) else {
            return None;
        };
        let module = &self.loaded.module;
        let statement = &module.statements[module.statement_at(update.span.start)?];
        let StatementKind::For { counting, .. } = &statement.kind else {
            return None;
        };
        let Counting { from, to, .. } = &**counting;
        match (&from.kind, &to.kind) {
            (OperandKind::Number(from), OperandKind::Number(to)) => Some(Editing::Counted {
                from: *from,
                to: *to,
            }),
            _ => None,
        }
    }

    fn label(&self, named: &Use, card: &mut Card) {
        let uses = || self.loaded.symbols.uses(named.definition);
        let count = |wanted: Access| uses().filter(|it| it.access == wanted).count();
        card.item(Editing::Jumped {
            jumps: count(Access::Jump),
            calls: count(Access::Call),
        });
        let Some(step) = self.step_of(self.definition_of(named)) else {
            return;
        };
        card.item(Editing::Step { step });
        let of_it = |part: &&Part| part.span == PartSpan::Subroutine { entry: step };
        if let Some(part) = self.parts().iter().find(of_it) {
            let duration = Box::new(self.duration(part.cycles));
            card.item(Editing::Returns { duration });
        }
        if let Some(turns) = self.turns_of(step) {
            card.item(turns);
        }
    }

    fn step_of(&self, definition: &Definition) -> Option<StepId> {
        let module = &self.loaded.module;
        let index = module.statement_at(definition.span?.start)?;
        Some(module.statements[index].step)
    }
}

/// Returns the form of a function, as `NORM POS|JOINT`.
pub(crate) fn usage(row: &functions::Row) -> String {
    let operands = match row.operation {
        Operation::Scalar(_) => "number",
        Operation::Atan2 => "y x",
        Operation::Norm => "POS|JOINT",
        Operation::UnitVect => "POS",
        Operation::Rotate(_) => "POS degrees",
    };
    format!("{} {operands}", row.word)
}

/// Returns the keyword that declares variables of a type.
pub(crate) const fn declaring(kind: VariableKind) -> Keyword {
    match kind {
        VariableKind::Var => Keyword::DefVar,
        VariableKind::Pos => Keyword::DefPos,
        VariableKind::Joint => Keyword::DefJoint,
    }
}

impl Card {
    fn code(&mut self, text: &str) {
        self.text += &format!("```tip\n{text}\n```\n\n");
    }

    /// Adds what the tables of the language say of a word.
    fn row(
        &mut self,
        code: &str,
        description: Bilingual,
        robots: Robots,
        (section, clause): (&'static str, &'static str),
    ) {
        self.code(code);
        self.paragraph(description);
        self.robots(robots);
        self.reference(section, clause);
    }

    fn paragraph(&mut self, text: Bilingual) {
        self.text += &format!("{}\n\n", text.in_lang(self.lang));
    }

    fn item(&mut self, message: impl Into<Message>) {
        let message = message.into();
        self.text += &format!("- {}\n", message.in_lang(self.lang));
    }

    fn robots(&mut self, robots: Robots) {
        if robots != Robots::ALL {
            let names = robots.names().into_iter().map(str::to_owned);
            self.item(Editing::OnlyFor {
                robots: Each(names.collect()),
            });
        }
    }

    fn reference(&mut self, section: &'static str, clause: &'static str) {
        self.item(Editing::Reference { section, clause });
    }
}

/// Returns true if two uses may mean the same number: the same member, or a whole variable.
fn overlaps(one: &Use, other: &Use) -> bool {
    one.member.is_none() || other.member.is_none() || one.member == other.member
}

/// Returns the declaration of a name as it is written.
fn declaration(definition: &Definition) -> String {
    let name = &definition.name;
    let keyword = match definition.kind {
        DefinitionKind::Variable(kind) => declaring(kind),
        DefinitionKind::Subroutine => return format!("{} {name}:", Keyword::Subroutine),
        DefinitionKind::Thread => return format!("{} {name}:", Keyword::Thread),
        DefinitionKind::Constant => Keyword::Define,
        DefinitionKind::Label => return format!("{name}:"),
    };
    format!("{keyword} {name}")
}
