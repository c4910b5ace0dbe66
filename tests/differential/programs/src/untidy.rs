//! A program as a careless hand writes it: other blanks, letters, line ends and encodings, and comments, but the same steps.

use crate::{Specimen, pick};
use tip_runtime::random::Random;

/// Words that want a line of their own.
const LONE: &[&str] = &["ELSE", "ENDIF", "WEND", "REPEAT"];
/// Signs that need no blanks around them.
const SIGNS: &[&str] = &[
    "=", "+=", "-=", "*=", "/=", "==", "<>", "<", ">", "<=", ">=", "+", "-", "*", "/",
];

/// The bytes of a random program, written carelessly.
pub fn untidy(specimen: &Specimen) -> Vec<u8> {
    let mut hand = Hand {
        random: Random::new(!specimen.seed),
        shift_jis: false,
        out: Vec::new(),
    };
    hand.shift_jis = hand.random.once_in(2);
    hand.file(&specimen.source);
    hand.out
}

struct Hand {
    random: Random,
    shift_jis: bool,
    out: Vec<u8>,
}

impl Hand {
    fn file(&mut self, source: &str) {
        if !self.shift_jis && self.random.once_in(8) {
            self.put("\u{feff}");
        }
        let mut lines = source.lines().skip(2).peekable();
        for line in source.lines().take(2) {
            self.put(line);
            self.end();
        }
        while let Some(line) = lines.next() {
            self.line(line, lines.peek().copied());
        }
        if self.random.once_in(4) {
            self.put("what follows END  \n\n\n");
        }
        if self.random.once_in(4) {
            self.out.push(0x1A);
        }
    }

    /// A statement or label, and the end of its line unless the next one follows on it.
    fn line(&mut self, line: &str, next: Option<&str>) {
        self.blanks();
        let mut words = line.split_whitespace().peekable();
        let mut first = words.peek().copied().unwrap_or_default();
        if let Some(label) = first.strip_suffix(':') {
            self.word(label);
            self.blanks();
            self.put(":");
            self.blanks();
            words.next();
            first = words.peek().copied().unwrap_or_default();
        }
        if matches!(first, "MESSAGE" | "F_MESSAGE" | "REM") {
            self.word(first);
            let text = line.split_once(first).map_or("", |(_, text)| text);
            self.put(text);
            self.blanks();
        } else {
            self.words(words);
        }
        let is_lone = |word: &str| LONE.contains(&word);
        let next_is_lone = next.is_none_or(|next| next.split_whitespace().any(is_lone));
        if !is_lone(first) && !next_is_lone && self.random.once_in(6) {
            let separator = pick(&mut self.random, &[";", " ; ;", " ;\t"]);
            return self.put(separator);
        }
        if self.random.once_in(4) {
            let note = pick(&mut self.random, &["//", "// note ; x  ", "//\t"]);
            self.put(note);
            self.foreign();
        }
        self.end();
        if next.is_some() && self.random.once_in(5) {
            self.blanks();
            self.end();
        }
    }

    /// Words with any delimiter between them, and none around signs.
    fn words<'a>(&mut self, words: impl Iterator<Item = &'a str>) {
        let mut before = "";
        for word in words {
            let glued = SIGNS.contains(&word) || SIGNS.contains(&before);
            let is_glued = glued && self.random.once_in(2);
            if !before.is_empty() && !is_glued {
                self.delimiter();
            }
            self.word(word);
            before = word;
        }
        self.blanks();
    }

    /// A word in capital letters or not.
    fn word(&mut self, word: &str) {
        let word = match self.random.once_in(3) {
            true => word.to_ascii_lowercase(),
            false => word.to_owned(),
        };
        self.put(&word);
    }

    fn delimiter(&mut self) {
        match self.random.below(6) {
            0 => self.put(", "),
            1 => self.put("\t \t"),
            2 => self.wide_blank(),
            _ => self.put(" "),
        }
    }

    fn blanks(&mut self) {
        match self.random.below(8) {
            0 => self.put("    "),
            1 => self.put("\t"),
            2 => self.wide_blank(),
            _ => {}
        }
    }

    fn wide_blank(&mut self) {
        match self.shift_jis {
            true => self.out.extend_from_slice(b"\x81\x40"),
            false => self.put("\u{3000}"),
        }
    }

    /// A comment's words: `\u{6b69}\u{304f}` and a sign that Shift_JIS has twice, so that encoding it again would change it.
    fn foreign(&mut self) {
        match self.shift_jis {
            true => self
                .out
                .extend_from_slice(b"\x95\xE0\x82\xAD\xFA\x5B\x81\xE6"),
            false => self.put("\u{6b69}\u{304f}"),
        }
    }

    fn end(&mut self) {
        let end = pick(&mut self.random, &["\n", "\n", "\r\n"]);
        self.put(end);
    }

    fn put(&mut self, text: &str) {
        self.out.extend_from_slice(text.as_bytes());
    }
}
