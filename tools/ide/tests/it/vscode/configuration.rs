//! The language configuration: comments, words, and the lines that indent.

use serde::Serialize;
use tipc::language::Keyword;

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Configuration {
    comments: Comments,
    /// Words of the language, and runs of other characters in texts.
    word_pattern: &'static str,
    indentation_rules: Indentation,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Comments {
    line_comment: &'static str,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Indentation {
    increase_indent_pattern: Pattern,
    decrease_indent_pattern: Pattern,
}

#[derive(Serialize)]
struct Pattern {
    pattern: String,
    flags: &'static str,
}

pub(crate) fn configuration() -> Configuration {
    let any = |words: &[Keyword]| -> String {
        let words: Vec<&str> = words.iter().map(|word| word.word()).collect();
        words.join("|")
    };
    let closing = [
        Keyword::EndIf,
        Keyword::Wend,
        Keyword::Until,
        Keyword::Next,
        Keyword::SubEnd,
        Keyword::ThreadEnd,
    ];
    let parting = any(&[Keyword::ElseIf, Keyword::Else]);
    let asking = any(&[Keyword::If, Keyword::ElseIf]);
    let opening = any(&[
        Keyword::Else,
        Keyword::While,
        Keyword::Repeat,
        Keyword::For,
        Keyword::Subroutine,
        Keyword::Thread,
    ]);
    let (closing, then) = (any(&closing), Keyword::Then);
    // A block may also be on one line.
    let open = format!(
        "^\\s*(?:\\w+\\s*:\\s*)*(?:(?:{asking})\\b.*\\b{then}|(?:{opening})\\b(?!.*\\b(?:{closing})\\b).*)\\s*(?://.*)?$"
    );
    let closed = format!("^\\s*(?:{parting}|{closing})\\b.*$");
    let pattern = |pattern| Pattern {
        pattern,
        flags: "i",
    };
    Configuration {
        comments: Comments { line_comment: "//" },
        word_pattern: "[A-Za-z0-9_]+|[^\\x00-\\x7F]+",
        indentation_rules: Indentation {
            increase_indent_pattern: pattern(open),
            decrease_indent_pattern: pattern(closed),
        },
    }
}
