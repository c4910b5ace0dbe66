//! The words of a line with their kinds: what each means where it is written. Hovers, semantic tokens and signatures are made from
//! them.

use crate::Document;
use tip_runtime::command::Target;
use tipc::language::commands::{self, Command, Form};
use tipc::language::reserved::{self, RESERVED};
use tipc::language::{Edition, Keyword, flags, functions, inputs, keywords};
use tipc::lex::{self, Kind, Piece, Pieces, Token, split_comment};
use tipc::source::{Line, Span};
use tipc::symbols::Use;
use tipc::syntax::StatementKind;

/// A word of the text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Word {
    pub(crate) span: Span,
    pub(crate) kind: WordKind,
}

/// The meaning of a word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum WordKind {
    /// Line 1.
    Version,
    /// Line 2, and the text of MESSAGE and REM.
    Text,
    Comment,
    Keyword(Keyword),
    Command(&'static Command),
    Function(&'static functions::Row),
    Flag(&'static flags::Row),
    Input(&'static inputs::Row),
    Target(&'static reserved::Row),
    /// `HS`, `R` or `A` among the arguments of a motion.
    MotionFlag(&'static reserved::Row),
    Constant(f64, &'static reserved::Row),
    /// A special variable, as `@POS_F1`.
    Reading(&'static reserved::Row),
    Member(&'static reserved::Row),
    /// A name of the program.
    Name(Use),
    Number,
    Operator,
    /// Neither a word of the language nor a name of the program.
    Unknown,
}

impl Document {
    /// Returns the word at a byte of the text, or right before it.
    pub(crate) fn word_at(&self, offset: usize) -> Option<Word> {
        let line = self.loaded.source.line(self.line_of(offset));
        let words = self.words(line);
        let holds = |word: &&Word| word.span.start <= offset && offset <= word.span.end;
        let starts = |word: &&Word| word.span.start == offset;
        let holding = || words.iter().filter(holds);
        let of_letters = |word: &&Word| word.kind != WordKind::Operator;
        let best = holding().filter(of_letters).find(starts);
        best.or_else(|| holding().find(of_letters)).copied()
    }

    /// Returns the words of a line from left to right; none after END.
    pub(crate) fn words(&self, line: Line) -> Vec<Word> {
        let mut words = Vec::new();
        let text = self.loaded.source.text();
        let end = self.end();
        if end.is_some_and(|end| line.span.start > end) {
            return words;
        }
        if line.number == 2 {
            push(&mut words, line.span, WordKind::Text);
            return words;
        }
        let (code, comment) = split_comment(text, line.span);
        if line.number == 1 {
            push(&mut words, trimmed(text, code), WordKind::Version);
        } else {
            for piece in Pieces::new(text, code, false).in_edition(self.edition()) {
                if end.is_some_and(|end| start(&piece) > end) {
                    break;
                }
                self.piece(&piece, &mut words);
            }
        }
        if let Some(comment) = comment {
            push(&mut words, comment, WordKind::Comment);
        }
        words
    }

    /// Returns the offset of END.
    fn end(&self) -> Option<usize> {
        let last = self.statements().last()?;
        (last.kind == StatementKind::End).then_some(last.span.start)
    }

    fn piece(&self, piece: &Piece, words: &mut Vec<Word>) {
        match *piece {
            Piece::Label { name, .. } => {
                let kind = self.name_in(name).map_or(WordKind::Unknown, WordKind::Name);
                push(words, name, kind);
            }
            Piece::Statement {
                word,
                span,
                text_end,
            } => match self.keyword(word) {
                Some(keyword) if keyword.takes_text() => {
                    push(words, word, WordKind::Keyword(keyword));
                    let text = Span::new(word.end, text_end);
                    self.text(trimmed(self.loaded.source.text(), text), words);
                }
                // What follows END on its line is not read.
                Some(Keyword::End) => push(words, word, WordKind::Keyword(Keyword::End)),
                _ => self.statement(word, span, words),
            },
        }
    }

    /// Adds a text, and the variables between its percent signs.
    fn text(&self, text: Span, words: &mut Vec<Word>) {
        let mut at = text.start;
        for named in self.loaded.symbols.within(text) {
            let place = named.span;
            self.text_without_names(Span::new(at, place.start), words);
            push(words, place, WordKind::Name(*named));
            at = place.end;
        }
        self.text_without_names(Span::new(at, text.end), words);
    }

    /// Adds a text, and the special variables between its percent signs, as `%@POS_F1.0%`.
    fn text_without_names(&self, text: Span, words: &mut Vec<Word>) {
        let mut at = text.start;
        for (percent, _) in self.slice(text).match_indices("%@") {
            let start = text.start + percent + 1;
            let inside = self.slice(Span::new(start, text.end));
            let Some((inside, _)) = inside.split_once('%') else {
                break;
            };
            let name = inside.split('.').next().unwrap_or_default();
            if let Some(row) = reading(&name.to_ascii_uppercase(), self.edition()) {
                let place = Span::new(start, start + name.len());
                push(words, Span::new(at, start), WordKind::Text);
                push(words, place, WordKind::Reading(row));
                at = place.end;
            }
        }
        push(words, Span::new(at, text.end), WordKind::Text);
    }

    fn statement(&self, word: Span, span: Span, words: &mut Vec<Word>) {
        let mut tokens = Vec::new();
        lex::lex(self.loaded.source.text(), span, &mut tokens);
        let command = commands::find_in(self.slice(word), self.edition());
        for token in &tokens {
            let is_first = token.span.start == span.start;
            self.token(token, command, is_first, words);
        }
    }

    fn token(
        &self,
        token: &Token,
        command: Option<&'static Command>,
        is_first: bool,
        words: &mut Vec<Word>,
    ) {
        match token.kind {
            Kind::Colon => {}
            Kind::Word => match self.name_in(token.span) {
                Some(named) => {
                    self.name(token.span, named.span, WordKind::Name(named), words);
                }
                None => {
                    let word = self.slice(token.span);
                    let kind = self.meaning(word, command, is_first);
                    let name = match kind {
                        WordKind::Reading(_) => word.split('.').next().unwrap_or(word),
                        _ => word,
                    };
                    let start = token.span.start;
                    let name = Span::new(start, start + name.len());
                    self.name(token.span, name, kind, words);
                }
            },
            _ => push(words, token.span, WordKind::Operator),
        }
    }

    /// Adds a name and the member after it, up to the end of a token.
    fn name(&self, span: Span, name: Span, kind: WordKind, words: &mut Vec<Word>) {
        push(words, name, kind);
        let rest = Span::new(name.end, span.end);
        if let Some(member) = self.slice(rest).strip_prefix('.') {
            let place = Span::new(rest.start + 1, rest.end);
            push(
                words,
                place,
                member_row(member).map_or(WordKind::Unknown, WordKind::Member),
            );
        }
    }

    /// Returns the first name of the program inside a word.
    fn name_in(&self, span: Span) -> Option<Use> {
        let named = self.loaded.symbols.within(span);
        named.iter().find(|it| it.span.start < it.span.end).copied()
    }

    fn keyword(&self, word: Span) -> Option<Keyword> {
        keywords::find(self.slice(word), self.edition())
    }

    /// Returns the kind of a word that is not a name of the program.
    fn meaning(&self, word: &str, command: Option<&'static Command>, is_first: bool) -> WordKind {
        let edition = self.edition();
        let upper = word.to_ascii_uppercase();
        if let Some(keyword) = keywords::find(word, edition) {
            return WordKind::Keyword(keyword);
        }
        if let Some(row) = commands::find_in(word, edition).filter(|_| is_first) {
            return WordKind::Command(row);
        }
        if word.parse::<f64>().is_ok() && word.starts_with(|c: char| c == '.' || c.is_ascii_digit())
        {
            return WordKind::Number;
        }
        if let Some(row) = reading(&upper, edition) {
            return WordKind::Reading(row);
        }
        let form = command.map(|command| command.form_in(edition));
        if let Some(Form::Robot(arguments)) = form
            && (arguments.hs || arguments.motion)
            && let Some(row) = motion_flag(&upper)
        {
            return WordKind::MotionFlag(row);
        }
        let input = || inputs::find(&upper, edition).map(|(_, row)| WordKind::Input(row));
        if form == Some(Form::AdIn)
            && let Some(input) = input()
        {
            return input;
        }
        let target = || upper.parse::<Target>().ok().and_then(target_row);
        let flag = || flags::find(&upper, edition).map(|(_, row)| WordKind::Flag(row));
        let function = || functions::find(word, edition).and_then(function_row);
        target()
            .map(WordKind::Target)
            .or_else(flag)
            .or_else(|| function().map(WordKind::Function))
            .or_else(|| constant(&upper, edition))
            .or_else(input)
            .or_else(|| commands::find_in(word, edition).map(WordKind::Command))
            .unwrap_or(WordKind::Unknown)
    }
}

fn push(words: &mut Vec<Word>, span: Span, kind: WordKind) {
    if span.start < span.end {
        words.push(Word { span, kind });
    }
}

fn start(piece: &Piece) -> usize {
    match piece {
        Piece::Label { span, .. } | Piece::Statement { span, .. } => span.start,
    }
}

fn trimmed(text: &str, span: Span) -> Span {
    let inside = &text[span.start..span.end];
    let start = span.start + (inside.len() - inside.trim_start().len());
    Span::new(start, start + inside.trim().len())
}

/// Returns the row of a member of a POS or JOINT.
pub(crate) fn member_row(member: &str) -> Option<&'static reserved::Row> {
    let upper = member.to_ascii_uppercase();
    let is_it = |row: &&reserved::Row| {
        let is_numbered = row.word == reserved::JOINT
            && upper
                .strip_prefix(row.word)
                .is_some_and(|rest| rest.parse::<u8>().is_ok());
        row.kind == reserved::Kind::Member && (row.word == upper || is_numbered)
    };
    RESERVED.iter().find(is_it)
}

fn motion_flag(word: &str) -> Option<&'static reserved::Row> {
    let is_it = |row: &&reserved::Row| row.kind == reserved::Kind::MotionFlag && row.word == word;
    RESERVED.iter().find(is_it)
}

fn target_row(target: Target) -> Option<&'static reserved::Row> {
    let is_it = |row: &&reserved::Row| {
        matches!(row.kind, reserved::Kind::Target(_)) && row.word == target.stem()
    };
    RESERVED.iter().find(is_it)
}

fn function_row(operation: functions::Operation) -> Option<&'static functions::Row> {
    let mut rows = functions::FUNCTIONS.iter();
    rows.find(|row| row.operation == operation)
}

/// Returns the row of a special variable, with or without a member.
fn reading(word: &str, edition: Edition) -> Option<&'static reserved::Row> {
    let name = word.split('.').next()?;
    let reading = reserved::reading(name, edition)?;
    let is_it = |row: &&reserved::Row| {
        matches!(row.kind, reserved::Kind::Reading(_)) && row.word == reading.stem()
    };
    RESERVED.iter().find(is_it)
}

fn constant(word: &str, edition: Edition) -> Option<WordKind> {
    let value = reserved::constant(word, edition)?;
    let is_it = |row: &&reserved::Row| match row.kind {
        reserved::Kind::Constant(_) => row.word == word,
        reserved::Kind::Characters => word.starts_with(row.word),
        _ => false,
    };
    let row = RESERVED.iter().find(is_it)?;
    Some(WordKind::Constant(value, row))
}
