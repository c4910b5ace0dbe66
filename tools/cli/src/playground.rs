//! `tip playground`: writes the page with compiler, simulated robots and lessons, if this command was built with it.

use crate::choices::LangName;
use crate::error::Error;
use crate::message::Using;
use crate::{Action, Status, choices, output};
use clap::Args;
use miniz_oxide::inflate::decompress_to_vec;
use std::path::PathBuf;

/// The page, deflated; empty if this command was built without it.
const PAGE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/playground"));

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip playground
  tip playground -o class.html

The page holds the compiler, simulated robots, examples and a guided tour. A browser opens it by double click,
without a server or a network.

Exit status: 0 written, 1 the file cannot be written, or this command was built without the page.")]
pub(super) struct Playground {
    /// The page
    #[arg(
        short,
        long,
        value_name = "FILE.html",
        default_value = "playground.html"
    )]
    out: PathBuf,

    /// The language of messages; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

impl Action for Playground {
    fn execute(&self) -> Result<Status, Error> {
        let lang = choices::lang(self.lang);
        let page = unpack(PAGE).ok_or_else(|| Error::failed(Using::NoPlayground, lang))?;
        output::refuse_inputs(&self.out, &[])?;
        output::replace(&self.out, page)?;
        Ok(Status::Success)
    }
}

/// Returns the page, or `None` if there is none.
fn unpack(page: &[u8]) -> Option<Vec<u8>> {
    match page {
        [] => None,
        // The build script has packed it.
        page => decompress_to_vec(page).ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::unpack;

    #[test]
    fn a_page_comes_out_as_it_went_in() {
        // A stored block of three bytes: last block, length, complement of the length.
        let packed = [1, 3, 0, 0xfc, 0xff, b'<', b'p', b'>'];
        assert_eq!(unpack(&packed).as_deref(), Some(&b"<p>"[..]));
        assert_eq!(unpack(&[]), None);
    }
}
