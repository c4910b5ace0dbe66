//! Lints about MESSAGE texts that do not show a value as intended (T.I.P. 3.1 §7-9-4).

use super::LintContext;
use crate::message::Linting;
use smol_str::SmolStr;
use std::collections::{HashMap, HashSet};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::Edition;
use tipc::language::reserved::{JOINT, POSITION, reading};
use tipc::message::phrase::Type;
use tipc::parse::narrow;
use tipc::program::{Variable, VariableId, VariableKind};
use tipc::source::Span;
use tipc::suggest::nearest;
use tipc::symbols::{Access, DefinitionId, DefinitionKind};
use tipc::syntax::{StatementKind, upper_case};

/// The variables of a program by their names.
struct Names<'a> {
    variables: &'a [Variable],
    /// The names of constants.
    constants: HashSet<&'a str>,
    edition: Edition,
    /// Number of joints of a leg.
    joints: usize,
    ids: HashMap<&'a str, VariableId>,
    /// For each definition, true if something reads it.
    is_read: Vec<bool>,
}

impl<'a> Names<'a> {
    fn of(context: &LintContext<'a>) -> Self {
        let variables = context.program.variables();
        let mut is_read = vec![false; context.symbols.definitions().len()];
        for it in context.symbols.all_uses() {
            is_read[it.definition.index()] |= !matches!(it.access, Access::Define | Access::Assign);
        }
        let definitions = context.symbols.definitions().iter();
        let constants = definitions.filter(|it| it.kind == DefinitionKind::Constant);
        Names {
            constants: constants.map(|it| it.name.as_str()).collect(),
            edition: context.module.edition,
            joints: usize::from(context.program.signature().joints),
            variables,
            ids: variables
                .iter()
                .map(|it| it.name.as_str())
                .zip(0..)
                .collect(),
            is_read,
        }
    }

    /// Returns the variable of a name in capitals.
    fn find(&self, name: &str) -> Option<&'a Variable> {
        self.ids.get(name).map(|id| &self.variables[*id])
    }

    /// Returns true if the text between percent signs is a value of edition 3.2: a constant, a special variable, a POS or
    /// JOINT, or a member of one.
    fn is_later(&self, inner: &str) -> bool {
        if self.edition < Edition::V3_2 {
            return false;
        }
        let upper = upper_case(inner);
        let mut parts = upper.split('.');
        let name = parts.next().unwrap_or_default();
        let kind = match (self.find(name), reading(name, self.edition)) {
            (Some(variable), _) => variable.kind,
            (None, Some(reading)) => VariableKind::of_reading(reading),
            (None, None) if self.constants.contains(name) => VariableKind::Var,
            (None, None) => return false,
        };
        let is_member = |word: &str| match kind {
            VariableKind::Var => false,
            VariableKind::Pos => POSITION.contains(&word),
            VariableKind::Joint => word.strip_prefix(JOINT).is_some_and(|it| {
                let joint = it.parse::<usize>().unwrap_or(0);
                (1..=self.joints).contains(&joint) && !it.starts_with('0')
            }),
        };
        let is_digit = |word: &str| matches!(word.as_bytes(), [b'0'..=b'7']);
        let rest: Vec<&str> = parts.collect();
        match rest[..] {
            [] => true,
            [one] => is_digit(one) || is_member(one),
            [member, digits] => is_member(member) && is_digit(digits),
            _ => false,
        }
    }

    /// Returns true if the name is that of a VAR, in letters of any case.
    fn is_var(&self, name: &str) -> bool {
        let variable = self.find(&upper_case(name));
        variable.is_some_and(|one| one.kind == VariableKind::Var)
    }
}

/// Values that texts were meant to show and do not.
#[derive(Default)]
pub(super) struct MeantValues {
    /// The variables.
    pub(super) names: HashSet<SmolStr>,
    /// True if a text was meant to show a value of an unknown variable.
    pub(super) any: bool,
}

/// Warns of texts, and returns the values that they were meant to show.
pub(super) fn warn(context: &LintContext<'_>, found: &mut Diagnostics) -> MeantValues {
    let mut meant = MeantValues::default();
    let mut names = None;
    for statement in context.module.steps() {
        let (text, is_shown) = match &statement.kind {
            StatementKind::Message { text } => (text, true),
            StatementKind::FileMessage { text } => (text, false),
            _ => continue,
        };
        let names = names.get_or_insert_with(|| Names::of(context));
        if is_shown {
            found.extend(quoted(
                context.source.slice(text.span),
                text.span,
                &mut meant,
            ));
        }
        placeholders(context, names, text.span, &mut meant, found);
        foreign_values(context, names, text.span, &mut meant, found);
        wide_placeholder(context, names, text.span, &mut meant, found);
    }
    meant
}

/// Warns of values in the form of other languages: `%d`, `$N`, `{N}`, `%N`. A name must be that of a VAR.
fn foreign_values(
    context: &LintContext<'_>,
    names: &Names<'_>,
    location: Span,
    meant: &mut MeantValues,
    found: &mut Diagnostics,
) {
    let text = context.source.slice(location);
    let is_var = |name: &str| names.is_var(name);
    let mut signs = text.match_indices(['%', '$', '{']);
    let first = signs.find_map(|(at, sign)| {
        let rest = &text[at + 1..];
        let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.'));
        let (name, after) = rest.split_at(end.unwrap_or(rest.len()));
        let shown = match sign {
            "%" if after.starts_with('%') || text[..at].ends_with(is_word_end) => return None,
            "%" if is_format(name) && !is_var(name) => return Some((at, 1 + name.len(), None)),
            "{" if !after.starts_with('}') => return None,
            "{" => 2 + name.len(),
            _ => 1 + name.len(),
        };
        is_var(name).then(|| (at, shown, Some(upper_case(name))))
    });
    let whole = || is_unread_var(names, text).then(|| (0, text.len(), Some(upper_case(text))));
    let Some((at, length, name)) = first.or_else(whole) else {
        return;
    };
    let span = Span::new(location.start + at, location.start + at + length);
    let diagnostic = Diagnostic::new(Code::ForeignValue, span, Linting::NoFormat);
    found.push(match name {
        Some(name) => {
            meant.names.insert(name.clone());
            diagnostic
                .about(name.as_str())
                .help(Linting::ShowValue { name })
        }
        None => {
            meant.any = true;
            diagnostic.help(Linting::ShowAnyValue)
        }
    });
}

/// Returns true if a text is the name of a VAR that nothing reads: `MESSAGE COUNT`.
fn is_unread_var(names: &Names<'_>, text: &str) -> bool {
    let id = names.ids.get(&*upper_case(text));
    let is_read = |id: VariableId| names.is_read[DefinitionId::of_variable(id).index()];
    names.is_var(text) && id.is_some_and(|id| !is_read(*id))
}

/// Returns true if the character may stand before a percent sign that is text: `50%`, `%A%`.
fn is_word_end(char: char) -> bool {
    char.is_ascii_alphanumeric() || char == '_' || char == '%'
}

/// Returns true for a format of C without its percent sign: `d`, `5.2f`.
fn is_format(text: &str) -> bool {
    let kind = text.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
    matches!(kind, "d" | "i" | "f" | "lf" | "g" | "s" | "u" | "x" | "ld")
}

/// Returns the warning about a text that is in quotes or parentheses as a whole. Quoted words inside a text are left
/// alone.
fn quoted(text: &str, location: Span, meant: &mut MeantValues) -> Option<Diagnostic> {
    let mut inside = text.chars().skip(1);
    if text.starts_with('(')
        && inside.position(|it| it == ')') == text.chars().count().checked_sub(2)
    {
        let diagnostic = Diagnostic::new(Code::QuotedMessage, location, Linting::ParenthesesShown);
        return Some(diagnostic.help(Linting::LeaveParenthesesOut));
    }
    let quotes = [
        ("\"\"\"", "\"\"\""),
        ("\"", "\""),
        ("'", "'"),
        ("“", "”"),
        ("”", "”"),
        ("＂", "＂"),
    ];
    let mut after = quotes.into_iter().filter_map(|(opens, closes)| {
        let (_, after) = text.strip_prefix(opens)?.split_once(closes)?;
        Some(after.trim_start())
    });
    let help = match after.next()? {
        "" => Linting::LeaveQuotesOut,
        // `"N=" + N`
        after if after.starts_with(['+', ',']) => {
            meant.any = true;
            Linting::ShowAnyValue
        }
        _ => return None,
    };
    let reason = Linting::QuotesShown;
    Some(Diagnostic::new(Code::QuotedMessage, location, reason).help(help))
}

/// Warns of each `%NAME%` that shows no value. The text is read from left to right, as at runtime.
fn placeholders(
    context: &LintContext<'_>,
    names: &Names<'_>,
    location: Span,
    meant: &mut MeantValues,
    found: &mut Diagnostics,
) {
    let text = context.source.slice(location);
    let mut from = 0;
    while let Some(at) = text[from..].find('%').map(|at| from + at) {
        from = at + 1;
        let Some(length) = text[from..].find('%') else {
            return;
        };
        let inner = &text[from..from + length];
        let Some(fault) = fault(names, inner) else {
            from += if is_placeholder(names, inner) {
                length + 1
            } else {
                0
            };
            continue;
        };
        let end = from + length + 1;
        let next = text[end..].split_once('%').map(|(next, _)| next);
        if next.is_some_and(|next| is_placeholder(names, next)) {
            // The second percent sign begins a value, so the first one is text.
            continue;
        }
        from = end;
        let span = Span::new(location.start + at, location.start + end);
        let diagnostic = Diagnostic::new(Code::Placeholder, span, fault.reason);
        found.push(diagnostic.about(inner).help(fault.help));
        meant.names.extend(fault.meant);
    }
}

/// Returns true if the text between percent signs is shown as a value.
fn is_placeholder(names: &Names<'_>, inner: &str) -> bool {
    names.is_later(inner) || split(inner).is_some() && fault(names, inner).is_none()
}

/// Returns the name between percent signs, and the text after its point. A text with blanks or signs is no name.
fn split(inner: &str) -> Option<(&str, Option<&str>)> {
    let (name, rest) = match inner.split_once('.') {
        Some((name, rest)) => (name, Some(rest)),
        None => (inner, None),
    };
    let is_word = |text: &str| {
        text.bytes()
            .all(|byte| byte == b'_' || byte.is_ascii_alphanumeric())
    };
    let starts = name.starts_with(|first: char| first == '_' || first.is_ascii_alphabetic());
    (starts && is_word(name) && rest.is_none_or(is_word)).then_some((name, rest))
}

/// A text that looks like a placeholder and shows no value.
struct Fault {
    reason: Linting,
    help: Linting,
    /// The variable that it was meant to show.
    meant: Option<SmolStr>,
}

/// Returns the reason why a text that looks like a placeholder shows no value.
fn fault(names: &Names<'_>, inner: &str) -> Option<Fault> {
    if names.is_later(inner) {
        return None;
    }
    let (name, rest) = split(inner)?;
    let name = || upper_case(name);
    let Some(variable) = names.find(&name()) else {
        let meant = meant_variable(names, &name());
        return Some(Fault {
            reason: Linting::NoVar { name: name() },
            help: match meant.clone() {
                Some(near) => Linting::MeantPlaceholder { near },
                None => Linting::DeclareOrLeaveOut { name: name() },
            },
            meant,
        });
    };
    let found = match (variable.kind, rest) {
        (VariableKind::Var, None | Some("0" | "1" | "2" | "3" | "4" | "5" | "6" | "7")) => {
            return None;
        }
        (VariableKind::Var, Some(_)) => {
            return Some(Fault {
                reason: Linting::Decimals { name: name() },
                help: Linting::SevenAtMost { name: name() },
                meant: Some(name()),
            });
        }
        (VariableKind::Pos, _) => Type::Pos,
        (VariableKind::Joint, _) => Type::Joint,
    };
    let is_named = |member: &String| inner.eq_ignore_ascii_case(member);
    let named = variable.scalar_names().find(is_named);
    let member = named.or_else(|| variable.scalar_names().next());
    let member = member.unwrap_or_default();
    Some(Fault {
        reason: Linting::StructInMessage {
            name: name(),
            found,
        },
        help: Linting::ShowCopy { member },
        meant: Some(name()),
    })
}

/// Returns the VAR that an undeclared name probably means.
fn meant_variable(names: &Names<'_>, name: &str) -> Option<SmolStr> {
    if let Some(near) = numbered(name).filter(|near| names.is_var(near)) {
        return Some(near);
    }
    let vars = names.variables.iter();
    let vars = vars.filter(|one| one.kind == VariableKind::Var);
    nearest(name, vars.map(|one| one.name.as_str())).map(SmolStr::from)
}

/// Returns `VAR01` for `%d01%` or `%f01%`, which versions before 3.0 have.
fn numbered(name: &str) -> Option<SmolStr> {
    let number = name.strip_prefix(|kind: char| "DF".contains(kind))?;
    let is_number = !number.is_empty() && number.bytes().all(|it| it.is_ascii_digit());
    is_number.then(|| format!("VAR{number}").into())
}

const SIGNS: [char; 2] = ['%', '％'];

/// Warns of the first full-width placeholder whose half-width form shows a VAR.
fn wide_placeholder(
    context: &LintContext<'_>,
    names: &Names<'_>,
    location: Span,
    meant: &mut MeantValues,
    found: &mut Diagnostics,
) {
    let text = context.source.slice(location);
    if text.is_ascii() {
        return;
    }
    let signs: Vec<(usize, &str)> = text.match_indices(SIGNS).collect();
    let wide = signs.windows(2).find_map(|pair| {
        let ((at, sign), (end, last)) = (pair[0], pair[1]);
        let whole = at..end + last.len();
        let inner = narrow(&text[at + sign.len()..end]);
        let name = upper_case(inner.split('.').next().unwrap_or_default());
        (names.is_var(&name) && !text[whole.clone()].is_ascii()).then_some((whole, name))
    });
    if let Some((whole, name)) = wide {
        let span = Span::new(location.start + whole.start, location.start + whole.end);
        let is_told =
            |it: &Diagnostic| it.code == Code::ForeignValue && it.span.start == span.start;
        if found.iter().any(is_told) {
            return;
        }
        let diagnostic = Diagnostic::new(Code::ForeignValue, span, Linting::NoFormat);
        meant.names.insert(name.clone());
        found.push(
            diagnostic
                .about(name.as_str())
                .help(Linting::ShowValue { name }),
        );
    }
}
