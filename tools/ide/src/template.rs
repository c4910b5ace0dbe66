//! Commands as templates: what an editor puts in, with places to fill.

use tipc::Robot;
use tipc::language::Keyword;
use tipc::language::commands::{Command, Meaning};

/// A command as a snippet of the Language Server Protocol: `PTP ${1|F1,J11|} ${2:x} ${3:y} ${4:z}`. A word that opens a
/// block brings the words that close it.
pub fn template(command: &Command, robot: Robot) -> String {
    match command.meaning {
        Meaning::Keyword(keyword) => block(keyword),
        _ => {
            let usage = command.usage(robot);
            let first = usage.first().map_or(command.name, String::as_str);
            arguments(first)
        }
    }
}

fn block(keyword: Keyword) -> String {
    let inside = "\n\t$0\n";
    match keyword {
        Keyword::If => format!(
            "{keyword} ${{1:condition}} {}{inside}{}",
            Keyword::Then,
            Keyword::EndIf
        ),
        Keyword::ElseIf => format!("{keyword} ${{1:condition}} {}", Keyword::Then),
        Keyword::While => format!("{keyword} ${{1:condition}}{inside}{}", Keyword::Wend),
        Keyword::Repeat => format!("{keyword}{inside}{} ${{1:condition}}", Keyword::Until),
        Keyword::Until => format!("{keyword} ${{1:condition}}"),
        Keyword::For => {
            let (to, next) = (Keyword::To, Keyword::Next);
            format!("{keyword} ${{1:VAR}} = ${{2:1}} {to} ${{3:10}}{inside}{next}")
        }
        Keyword::Subroutine => format!("{keyword} ${{1:name}}:{inside}{}", Keyword::SubEnd),
        Keyword::Call | Keyword::Goto | Keyword::Gosub => format!("{keyword} ${{1:label}}:"),
        Keyword::DefVar | Keyword::DefPos | Keyword::DefJoint => format!("{keyword} ${{1:name}}"),
        Keyword::Message | Keyword::Rem => format!("{keyword} ${{1:text}}"),
        Keyword::Then
        | Keyword::Else
        | Keyword::EndIf
        | Keyword::Wend
        | Keyword::To
        | Keyword::Step
        | Keyword::Next
        | Keyword::SubEnd
        | Keyword::Return
        | Keyword::End
        | Keyword::Exit => keyword.word().to_owned(),
    }
}

/// The words of a usage as places to fill, without those that may be left out.
fn arguments(usage: &str) -> String {
    let mut words = usage.split(' ');
    let mut out = words.next().unwrap_or_default().to_owned();
    let needed = words.filter(|word| !word.starts_with('['));
    for (place, word) in (1..).zip(needed) {
        out += &match word.contains('|') {
            true => format!(" ${{{place}|{}|}}", word.replace('|', ",")),
            false => format!(" ${{{place}:{word}}}"),
        };
    }
    out
}
