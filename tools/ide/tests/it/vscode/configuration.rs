//! The language configuration: comments, words, and the lines that indent.

use serde::Serialize;
use tipc::language::Keyword;
use tipc::syntax::{Edge, Shape};

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
    // The block of these begins behind a condition and THEN.
    let is_asking = |keyword| matches!(keyword, Keyword::If | Keyword::ElseIf);
    let any = |is_meant: &dyn Fn(Shape, Keyword) -> bool| -> String {
        let shapes = Shape::ALL.iter().copied();
        let words = shapes.filter_map(|shape| Some((shape, shape.keyword()?)));
        let words = words.filter(|(shape, keyword)| is_meant(*shape, *keyword));
        let words: Vec<&str> = words.map(|(_, keyword)| keyword.word()).collect();
        words.join("|")
    };
    let asking = any(&|_, keyword| is_asking(keyword));
    let opening = any(&|shape, keyword| shape.opens() && !is_asking(keyword));
    let parting = any(&|shape, _| matches!(shape.edge(), Edge::Parts(_)));
    let closing = any(&|shape, _| matches!(shape.edge(), Edge::Closes(_)));
    let then = Keyword::Then;
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
