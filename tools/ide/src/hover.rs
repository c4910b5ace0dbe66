//! What is known of a word, as Markdown.

mod facts;

use crate::Document;
use crate::message::Editing;
use crate::word::{What, Word};
use tipc::code::Code;
use tipc::language::commands::{self, Command, Cycles, Robots};
use tipc::language::functions::{self, Operation};
use tipc::language::{Bilingual, Keyword, flags, inputs, reserved};
use tipc::message::list::Each;
use tipc::message::{Lang, Message};
use tipc::source::Span;

/// What is known of a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// The word.
    pub span: Span,
    /// What is known of it, as Markdown.
    pub text: String,
}

/// The parts of a text, each a paragraph or an item of a list.
struct Card {
    lang: Lang,
    text: String,
}

impl Document {
    /// What is known of the word at a byte of the text: its row of the language's tables, or what the program does with its name.
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
        match word.what {
            What::Command(command) => self.command(command, card),
            What::Keyword(keyword) => self.keyword_card(keyword, card),
            What::Function(row) => function(row, card),
            What::Flag(row) => self.flag(row, self.slice(word.span), card),
            What::Input(row) => self.input(row, self.slice(word.span), card),
            What::Target(row) | What::MotionFlag(row) | What::Member(row) => {
                reserved(row, self.slice(word.span), card);
            }
            What::Constant(value, row) => {
                reserved(row, self.slice(word.span), card);
                card.item(Editing::Value { value });
            }
            What::Name(named) => return self.name_card(&named, card),
            What::Version
            | What::Text
            | What::Comment
            | What::Number
            | What::Operator
            | What::Unknown => return None,
        }
        self.add_place(word, card);
        Some(())
    }

    /// What the program adds at a command or keyword: its step, and what its loop takes.
    fn add_place(&self, word: &Word, card: &mut Card) {
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
        card.code(&command.usage(self.robot()).join("\n"));
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
        if let Some(command) = commands::find(keyword.word()) {
            return self.command(command, card);
        }
        let row = keyword.row();
        card.code(row.word);
        card.paragraph(row.description);
        card.reference(row.section, row.clause);
    }

    fn flag(&self, row: &flags::Row, word: &str, card: &mut Card) {
        card.code(&word.to_ascii_uppercase());
        card.paragraph(row.description);
        card.robots(row.robots);
        card.reference(row.section, row.clause);
    }

    fn input(&self, row: &inputs::Row, word: &str, card: &mut Card) {
        card.code(&word.to_ascii_uppercase());
        card.paragraph(row.description);
        card.robots(row.robots);
        card.reference(row.section, row.clause);
    }
}

fn function(row: &functions::Row, card: &mut Card) {
    card.code(&usage(row));
    card.paragraph(row.description);
    card.reference(row.section, row.clause);
}

fn reserved(row: &reserved::Row, word: &str, card: &mut Card) {
    card.code(&word.to_ascii_uppercase());
    card.paragraph(row.description);
    card.reference(row.section, row.clause);
}

/// How a function is written.
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

impl Card {
    fn code(&mut self, text: &str) {
        self.text += &format!("```tip\n{text}\n```\n\n");
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
