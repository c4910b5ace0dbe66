//! `tip explain`: what a code means, with a wrong and a right program.

mod pages;

use super::choices::LangName;
use super::error::Error;
use super::{Status, output, shown};
use crate::message::Using;
use clap::Args;
use std::fmt::Write as _;
use tipc::code::{Code, Mistake};
use tipc::message::Lang;
use tipc::message::list::Each;

/// `tip explain`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tip explain E205           with a list of the finer codes
  tip explain E205-03
  tip explain W109 --lang ja

Exit status: 0 if there is such a code, 2 otherwise.")]
pub(super) struct Explain {
    /// The code of a finding, as E205-03 or W109, or the class of one, as E205
    #[arg(value_name = "CODE")]
    code: String,

    /// The language of the page, if not that of the locale
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

/// Prints the page of a code.
pub(super) fn explain(arguments: &Explain) -> Result<Status, Error> {
    let code = arguments.code.to_ascii_uppercase();
    let lang = shown::lang(arguments.lang);
    let Some(text) = page(&code, lang) else {
        let codes = Code::ALL.iter().map(|code| code.id().to_owned());
        let codes = Each(codes.collect());
        let text = Using::NoCode { code, codes };
        return Err(Error::Usage(text.in_lang(lang).to_string()));
    };
    output::print(format!("{text}{}", related(&code, lang)))?;
    Ok(Status::Success)
}

/// The page of a code.
pub(super) fn page(code: &str, lang: Lang) -> Option<&'static str> {
    let page = pages::PAGES.iter().find(|page| page.code == code)?;
    Some(match lang {
        Lang::Japanese => page.japanese,
        _ => page.english,
    })
}

/// The codes that have to do with one: the finer ones of a class, the class of a finer one.
fn related(code: &str, lang: Lang) -> String {
    let is_japanese = lang == Lang::Japanese;
    if let Some(mistake) = Mistake::ALL.iter().find(|mistake| mistake.id == code) {
        let class = mistake.class.id();
        return match is_japanese {
            true => format!("\n`tip explain {class}` に、{class}のほかのコードがあります。\n"),
            false => format!("\n`tip explain {class}` lists the other codes of {class}.\n"),
        };
    }
    let class = Code::ALL.iter().find(|class| class.id() == code);
    let finer = class
        .into_iter()
        .flat_map(|class| Mistake::of_class(*class));
    let mut text = String::new();
    for mistake in finer {
        if text.is_empty() {
            text += match is_japanese {
                true => "\n## 細かいコード\n\n",
                false => "\n## Its finer codes\n\n",
            };
        }
        // Writing to a String cannot fail.
        let _ = writeln!(text, "- `{}`: {}", mistake.id, mistake.title(lang));
    }
    text
}
