//! `tipc explain`: what a code means, with a wrong and a right program.

mod pages;

use super::choices::LangName;
use super::error::Error;
use super::{Status, output, shown};
use clap::Args;
use tipc::message::Lang;

/// `tipc explain`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  tipc explain E205
  tipc explain W109 --lang ja

Exit status: 0 if there is such a code, 2 otherwise.")]
pub(super) struct Explain {
    /// The code of a finding, as E205 or W109
    #[arg(value_name = "CODE")]
    code: String,

    /// The language of the page, if not that of the locale
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

/// Prints the page of a code.
pub(super) fn explain(arguments: &Explain) -> Result<Status, Error> {
    let code = arguments.code.to_ascii_uppercase();
    let page = pages::PAGES.iter().find(|page| page.code == code);
    let Some(page) = page else {
        let codes: Vec<&str> = pages::PAGES.iter().map(|page| page.code).collect();
        let codes = codes.join(", ");
        let text = format!("no finding has the code {code}; the codes are {codes}");
        return Err(Error::Usage(text));
    };
    output::print(match shown::lang(arguments.lang) {
        Lang::Japanese => page.japanese,
        _ => page.english,
    })?;
    Ok(Status::Success)
}
