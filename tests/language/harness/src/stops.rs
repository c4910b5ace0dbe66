//! Runtime faults, many per file: each line that asks for its own number is a fault of its own.
//!
//! A fault ends a run, so a program that shows many of them is run once for each. The knob VR1 reads the number of
//! the line that is wanted, from the first cycle on; the program reads it and jumps over every other line:
//! `IF LINE <> 12 GOTO L12:; SET_V_MAX F1 LOW; L12:`.

use case_files::Settings;

/// A line of the expectation: `LINE: TIP_ERR:<message> (<kind>)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop<'a> {
    /// The line of the program.
    pub line: u32,
    /// The classical line of the error.
    pub error: &'a str,
}

impl<'a> Stop<'a> {
    /// Reads a line of an expectation.
    pub fn parse(text: &'a str) -> Option<Self> {
        let (line, error) = text.split_once(": ")?;
        let line = line.parse().ok()?;
        Some(Stop { line, error })
    }

    /// The settings of the run that this line is wanted in.
    pub fn settings(&self, settings: &Settings) -> Settings {
        wanting(self.line, settings)
    }
}

/// The settings of a run in which a line is wanted; no line has the number 0.
pub fn wanting(line: u32, settings: &Settings) -> Settings {
    let mut settings = settings.clone();
    settings.add_input("--sensor", format_args!("VR1={line}@0"));
    settings
}

/// The step and the classical line of the emergency that ends a trace.
pub fn emergency(trace: &str) -> Option<(u32, String)> {
    let last = trace.lines().last()?;
    let value = |key: &str| Some(last.split_once(&format!("\"{key}\":"))?.1);
    let text = |key: &str| {
        value(key)?
            .strip_prefix('"')?
            .split_once('"')
            .map(|(text, _)| text)
    };
    let step = value("step")?.split([',', '}']).next()?.parse().ok()?;
    Some((
        step,
        format!("TIP_ERR:{} ({})", text("error")?, text("kind")?),
    ))
}
