//! What an editor says of itself at the beginning, however much or little.

use serde_json::Value;
use tipc::message::Lang;
use tipc::source::Unit;

/// What the client wants, and can show.
#[derive(Clone, Debug)]
pub(crate) struct Client {
    /// What its columns count.
    pub(crate) unit: Unit,
    pub(crate) lang: Lang,
    /// Places to fill in completions.
    pub(crate) has_snippets: bool,
    pub(crate) has_related: bool,
    pub(crate) has_pages: bool,
    /// It says when files change, if it is asked to.
    pub(crate) can_watch: bool,
    /// The robot of its options.
    pub(crate) robot: Option<String>,
}

/// The encodings of columns that can be asked for, the best first.
const UNITS: [(&str, Unit); 3] = [
    ("utf-8", Unit::Utf8),
    ("utf-32", Unit::Character),
    ("utf-16", Unit::Utf16),
];

impl Client {
    /// Reads the parameters of `initialize`; what is missing or odd counts as not wanted.
    pub(crate) fn new(params: &Value) -> Self {
        let can = |place: &str| {
            let found = params.pointer(&format!("/capabilities/{place}"));
            found.and_then(Value::as_bool).unwrap_or_default()
        };
        let asked = params.pointer("/capabilities/general/positionEncodings");
        let asked: Vec<&str> = asked
            .and_then(Value::as_array)
            .map(|all| all.iter().filter_map(Value::as_str).collect())
            .unwrap_or_default();
        // The client names them in the order of its liking.
        let unit = asked.iter().find_map(|name| unit(name));
        let locale = params.get("locale").and_then(Value::as_str);
        let publish = "textDocument/publishDiagnostics";
        Client {
            unit: unit.unwrap_or(Unit::Utf16),
            lang: locale.map_or(Lang::English, Lang::of),
            has_snippets: can("textDocument/completion/completionItem/snippetSupport"),
            has_related: can(&format!("{publish}/relatedInformation")),
            has_pages: can(&format!("{publish}/codeDescriptionSupport")),
            can_watch: can("workspace/didChangeWatchedFiles/dynamicRegistration"),
            robot: params.get("initializationOptions").and_then(robot),
        }
    }

    /// The name of its encoding.
    pub(crate) fn encoding(&self) -> &'static str {
        let mut units = UNITS.iter();
        let found = units.find(|(_, unit)| *unit == self.unit);
        found.map_or("utf-16", |(name, _)| name)
    }
}

fn unit(name: &str) -> Option<Unit> {
    let mut units = UNITS.iter();
    units
        .find(|(known, _)| *known == name)
        .map(|(_, unit)| *unit)
}

/// The robot that settings name: `robot`, or the same in a section `tip`.
pub(crate) fn robot(settings: &Value) -> Option<String> {
    let found = ["/robot", "/tip/robot"];
    let mut found = found
        .iter()
        .filter_map(|place| settings.pointer(place)?.as_str());
    found
        .next()
        .filter(|name| !name.is_empty())
        .map(str::to_owned)
}
