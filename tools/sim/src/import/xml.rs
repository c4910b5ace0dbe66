//! The text of XML files that are read: encodings, limits of size, xacro and positions.

use super::ImportError;
use crate::message::Importing;
use crate::message::Place;
use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE};
use roxmltree::{Document, Error, Node};
use std::borrow::Cow;

/// Maximum nesting depth. URDF needs six levels; additions of simulators, a few more.
const DEEPEST: u32 = 100;
/// Maximum number of attributes of an element. URDF needs four; additions of simulators, a few
/// more.
const MOST_ATTRIBUTES: u32 = 100;
/// The start of an XML declaration.
const DECLARATION: &str = "<?xml";
/// Starts and ends of markup that is not an element.
const PASSED_OVER: [(&str, &str); 4] = [
    ("<!--", "-->"),
    ("<![CDATA[", "]]>"),
    ("<?", "?>"),
    ("</", ">"),
];

/// The namespace prefix of xacro.
const PREFIX: &str = "xacro";
/// The start of an expression.
const EXPRESSION: &str = "${";

/// Decodes the bytes of a file: by their byte order mark, else by the encoding that its XML declaration names, else as UTF-8.
///
/// ```
/// let bytes = b"<?xml version='1.0' encoding='ISO-8859-1'?><robot name='b\xE9b\xE9'/>";
/// assert!(tip_sim::import::decode(bytes)?.contains("bébé"));
/// # Ok::<(), tip_sim::import::ImportError>(())
/// ```
///
/// # Errors
/// An encoding that is not known, and bytes that are none of it.
pub fn decode(bytes: &[u8]) -> Result<String, ImportError> {
    let (encoding, mark) = match Encoding::for_bom(bytes) {
        // The mark of UTF-32 begins as that of UTF-16 does.
        Some(_) if bytes.starts_with(b"\xFF\xFE\0\0") => return Err(unknown("UTF-32")),
        Some(marked) => marked,
        None => (unmarked(bytes)?, 0),
    };
    let (text, is_broken) = encoding.decode_without_bom_handling(&bytes[mark..]);
    if !is_broken {
        return Ok(text.into_owned());
    }
    let broken = text.find(char::REPLACEMENT_CHARACTER).unwrap_or_default();
    Err(ImportError::new(Importing::NotInEncoding {
        at: position(&text, broken),
        encoding: encoding.name(),
    }))
}

/// Returns the encoding of bytes without a byte order mark.
fn unmarked(bytes: &[u8]) -> Result<&'static Encoding, ImportError> {
    match bytes {
        [0, 0, 0, ..] | [0, 0, 0xFE, 0xFF, ..] | [_, 0, 0, 0, ..] => return Err(unknown("UTF-32")),
        [0, _, ..] => return Ok(UTF_16BE),
        [_, 0, ..] => return Ok(UTF_16LE),
        _ => {}
    }
    // Every encoding that a declaration can name in readable letters has these letters of ASCII.
    let Some(label) = declared(bytes) else {
        return Ok(UTF_8);
    };
    match Encoding::for_label_no_replacement(label) {
        None => Err(unknown(&String::from_utf8_lossy(label))),
        // Were it so, its letters would not be readable.
        Some(wide) if wide == UTF_16LE || wide == UTF_16BE => Ok(UTF_8),
        Some(encoding) => Ok(encoding),
    }
}

fn unknown(encoding: &str) -> ImportError {
    ImportError::new(Importing::UnknownEncoding {
        encoding: encoding.to_owned(),
    })
}

/// Returns the encoding that an XML declaration names.
fn declared(bytes: &[u8]) -> Option<&[u8]> {
    let rest = bytes
        .trim_ascii_start()
        .strip_prefix(DECLARATION.as_bytes())?;
    let rest = &rest[..rest.iter().position(|byte| *byte == b'>')?];
    let name = b"encoding";
    let at = rest.windows(name.len()).position(|window| window == name)?;
    let value = rest[at + name.len()..]
        .trim_ascii_start()
        .strip_prefix(b"=")?;
    let (quote, value) = value.trim_ascii_start().split_first()?;
    let end = value.iter().position(|byte| byte == quote)?;
    matches!(quote, b'"' | b'\'').then_some(&value[..end])
}

/// Replaces blank lines and a late XML declaration by blanks, so that the text can be parsed and
/// every position stays.
pub(super) fn without_late_declaration(text: &str) -> Cow<'_, str> {
    let text = text.trim_start_matches('\u{FEFF}');
    let declaration = text.trim_start();
    let before = text.len() - declaration.len();
    let end = declaration.find("?>").map(|end| before + end + 2);
    match end {
        Some(end) if before > 0 && declaration.starts_with(DECLARATION) => {
            let blank = |c: char| if c.is_whitespace() { c } else { ' ' };
            let blanks: String = text[..end].chars().map(blank).collect();
            Cow::Owned(blanks + &text[end..])
        }
        _ => Cow::Borrowed(text),
    }
}

/// Refuses elements that are nested too deep for any robot or have too many attributes: the
/// parser's time grows with the square of both.
fn check_size(text: &str) -> Result<(), ImportError> {
    let mut depth = 0;
    let mut at = 0;
    while let Some(next) = text[at..].find('<') {
        at += next;
        let rest = &text[at..];
        if let Some((open, close)) = PASSED_OVER.iter().find(|(open, _)| rest.starts_with(open)) {
            let Some(end) = rest[open.len()..].find(close) else {
                // The parser refuses it.
                return Ok(());
            };
            depth -= u32::from(*open == "</" && depth > 0);
            at += open.len() + end + close.len();
            continue;
        }
        if rest.starts_with("<!") {
            // A DTD, which the parser refuses.
            return Ok(());
        }
        let tag = Tag::of(rest);
        let element = || tag.name.to_owned();
        if tag.attributes > MOST_ATTRIBUTES {
            return Err(ImportError::new(Importing::TooManyAttributes {
                at: position(text, at),
                element: element(),
                most: MOST_ATTRIBUTES,
            }));
        }
        if depth == DEEPEST {
            return Err(ImportError::new(Importing::TooDeep {
                element: element(),
                most: DEEPEST,
            }));
        }
        depth += u32::from(!tag.is_empty);
        at += tag.length;
    }
    Ok(())
}

/// The tag at the start of an element.
struct Tag<'a> {
    name: &'a str,
    attributes: u32,
    /// True if it ends the element as well.
    is_empty: bool,
    /// Length, bytes.
    length: usize,
}

impl<'a> Tag<'a> {
    /// Returns the tag at the start of a text.
    fn of(text: &'a str) -> Self {
        let mut quote = None;
        let mut attributes = 0;
        let mut end = text.len();
        for (at, byte) in text.bytes().enumerate() {
            match quote {
                Some(open) if byte == open => quote = None,
                Some(_) => {}
                None if byte == b'>' => {
                    end = at;
                    break;
                }
                None if byte == b'"' || byte == b'\'' => {
                    quote = Some(byte);
                    attributes += 1;
                }
                None => {}
            }
        }
        let inside = &text[1..end];
        let name = inside.find(|c: char| c.is_whitespace() || "/=\"'".contains(c));
        Tag {
            name: &inside[..name.unwrap_or(inside.len())],
            attributes,
            is_empty: inside.ends_with('/'),
            length: (end + 1).min(text.len()),
        }
    }
}

/// Returns the line and column of a byte of a text.
pub(super) fn position(text: &str, byte: usize) -> Place {
    let before = &text[..byte];
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    Place::At {
        line: 1 + before.matches('\n').count() as u32,
        column: 1 + before[line..].chars().count() as u32,
    }
}

/// Parses the text of a file that has no late declaration.
pub(super) fn parse(text: &str) -> Result<Document<'_>, ImportError> {
    check_size(text)?;
    let document = Document::parse(text).map_err(|error| {
        ImportError::new(match error {
            Error::DtdDetected => Importing::Doctype,
            Error::UnknownNamespace(prefix, at) if prefix == PREFIX => Importing::Xacro {
                // The position is that of the prefix, after the bracket.
                at: Place::At {
                    line: at.row,
                    column: at.col.saturating_sub(1),
                },
            },
            error => Importing::NotXml {
                error: error.to_string().into(),
            },
        })
    })?;
    refuse_xacro(&document)?;
    Ok(document)
}

/// Refuses elements of xacro, and attributes that are expressions: the file was not expanded. The
/// namespace alone is accepted.
fn refuse_xacro(document: &Document<'_>) -> Result<(), ImportError> {
    let mut elements = document.descendants().filter(Node::is_element);
    match elements.find_map(find_xacro) {
        None => Ok(()),
        Some(at) => Err(ImportError::new(Importing::Xacro { at })),
    }
}

/// Returns the place of an element, or of an attribute, that is xacro.
fn find_xacro(node: Node<'_, '_>) -> Option<Place> {
    let namespace = node.tag_name().namespace();
    if namespace.is_some() && namespace == node.lookup_namespace_uri(Some(PREFIX)) {
        return Some(start(node));
    }
    let mut attributes = node.attributes();
    let expression = attributes.find(|attribute| attribute.value().contains(EXPRESSION))?;
    Some(place(node, expression.range().start))
}

/// Returns the place of a byte of the file.
pub(super) fn place(node: Node<'_, '_>, byte: usize) -> Place {
    let at = node.document().text_pos_at(byte);
    Place::At {
        line: at.row,
        column: at.col,
    }
}

/// Returns the place of an element.
pub(super) fn start(node: Node<'_, '_>) -> Place {
    place(node, node.range().start)
}

/// Returns a name without control characters, for comments and reports.
pub(super) fn printed(name: &str) -> String {
    name.replace(char::is_control, "?")
}
