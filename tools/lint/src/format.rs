//! Programs in the one style of docs/style.md: blanks, capital letters, indentation, comments in columns.
//!
//! Lines are neither joined nor parted nor moved, and no byte of a comment, of a text, of the first two lines or of what
//! follows END changes, whatever the encoding. **What is written back is the same program**: each call reads it again and
//! compares the statements.
//!
//! ```
//! use tip_lint::{Options, format::format};
//!
//! let written = "3.1\nlift a foot\nfor n=1 to 3\nptp f1 r 0,r 0,r 50//mm\nnext\ndef_var n\nend";
//! let formatted = format("lift.prg", written.as_bytes(), &Options::default()).expect("a program");
//! assert_eq!(
//!     String::from_utf8(formatted).expect("UTF-8, as before"),
//!     "3.1\nlift a foot\nFOR N = 1 TO 3\n  PTP F1 R 0 R 0 R 50  //mm\nNEXT\nDEF_VAR N\nEND\n"
//! );
//! ```

mod equivalence;
mod layout;
mod rows;

use crate::message::Formatting;
use crate::{Loaded, Options, load};
use tipc::Robot;
use tipc::load::{Parsed, parsed};

/// Reasons why a file is left as it is.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// It does not load; what is wrong with it.
    Diagnostics(Box<Loaded>),
    /// It loads, and cannot be written in the style.
    Because(Formatting),
}

/// Formats a program in the style. `name` is the file's name in diagnostics.
///
/// # Errors
///
/// The file does not load; a line would be too long; or, which would be a defect here, the result would not be the same program.
pub fn format(name: &str, bytes: &[u8], options: &Options) -> Result<Vec<u8>, Refusal> {
    format_for(name, bytes, options, &[options.robot])
}

/// Returns the bytes of a program in the style, for the first of some robots that it loads for. `name` and `options` are
/// those of [`format()`].
///
/// # Errors
///
/// The program loads for none of them: the diagnostics are those for the robot with the fewest errors. Else as in [`format()`].
pub fn format_for(
    name: &str,
    bytes: &[u8],
    options: &Options,
    robots: &[Robot],
) -> Result<Vec<u8>, Refusal> {
    let before = parsed(name, bytes, options);
    let mut best = *options;
    let mut fewest = usize::MAX;
    for robot in robots {
        let options = Options {
            robot: *robot,
            ..*options
        };
        let errors = before.errors(&options);
        if errors == 0 {
            return laid_out(&before, bytes, &options).map_err(Refusal::Because);
        }
        if errors < fewest {
            (best, fewest) = (options, errors);
        }
    }
    Err(Refusal::Diagnostics(Box::new(load(name, bytes, &best))))
}

/// Formats a program in the style; checks that the result is the same program.
fn laid_out(before: &Parsed, bytes: &[u8], options: &Options) -> Result<Vec<u8>, Formatting> {
    let rows = layout::rows(&before.source, &before.module);
    let formatted = rows.write(&before.source)?;
    if formatted != bytes {
        equivalence::check(before, &formatted, options)?;
    }
    Ok(formatted)
}
