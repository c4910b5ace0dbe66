//! Generated code as a file that people read.
//!
//! Tokens and their syntax tree take many times what their text takes. Those of a long program are therefore made, laid out and
//! dropped a few steps at a time; the text is the same as of all at once.

use super::step::GeneratedStep;
use super::{Emitter, Options, emit, header};
use crate::program::{Program, StepId};
use proc_macro2::TokenStream;
use quote::quote;
use std::fmt::Write;

/// Number of steps in memory at once. The tables of a longer program fit on no line.
const STEPS: usize = 64;

/// The columns of a line, and those before a number of a table in an `impl`.
const COLUMNS: usize = 89;
const INDENT: usize = 8;

/// Returns the items of [`emit`](super::emit) as formatted source text under a header comment.
///
/// # Errors
/// They are not a Rust file; a visibility or runtime path that is none can cause it.
pub fn pretty(program: &Program, options: &Options) -> Result<String, syn::Error> {
    let header = header(program);
    match program.steps.len() > STEPS {
        true => Ok(format!("// {header}\n\n{}", piecewise(program, options)?)),
        false => under(&header, emit(program, options)),
    }
}

/// Tokens as formatted source text under a header.
pub(crate) fn under(header: &str, tokens: TokenStream) -> Result<String, syn::Error> {
    Ok(format!("// {header}\n\n{}", laid_out(tokens)?))
}

fn laid_out(tokens: TokenStream) -> Result<String, syn::Error> {
    Ok(prettyplease::unparse(&syn::parse2(tokens)?))
}

/// Returns the outline of the program with its steps put in.
fn piecewise(program: &Program, options: &Options) -> Result<String, syn::Error> {
    let emitter = Emitter::new(program, options);
    let outline = emitter.items(&emitter.outline(quote!(Step::run(Self::rows))));
    let outline = laid_out(outline)?;
    let (before, behind) = split(&outline, "    const LINES: &'static [u32] = &[];\n");
    let (between, behind) = split(
        behind,
        "        const STEPS: &'static [Step<Self>] = &[Step::run(Self::rows)];\n",
    );
    let mut out = before.to_owned();
    out += "    const LINES: &'static [u32] = &[\n";
    fill(&mut out, program.steps.iter().map(|step| step.line));
    out += "    ];\n";
    out += between;
    out += "        const STEPS: &'static [Step<Self>] = &[\n";
    emitter.each(&mut out, |GeneratedStep { row, .. }| row, rows)?;
    out += "        ];\n";
    emitter.each(
        &mut out,
        |GeneratedStep { function, .. }| function,
        functions,
    )?;
    out += behind;
    Ok(out)
}

/// Returns the text before and after a line.
fn split<'a>(text: &'a str, line: &str) -> (&'a str, &'a str) {
    text.split_once(line).unwrap_or((text, ""))
}

impl Emitter<'_> {
    /// Writes a part of each step, a few steps at a time.
    fn each(
        &self,
        out: &mut String,
        part: impl Fn(GeneratedStep) -> TokenStream,
        lay_out: impl Fn(TokenStream) -> Result<String, syn::Error>,
    ) -> Result<(), syn::Error> {
        let ids: Vec<StepId> = self
            .program
            .steps
            .iter()
            .zip(0..)
            .map(|(_, id)| id)
            .collect();
        for ids in ids.chunks(STEPS) {
            *out += &lay_out(ids.iter().map(|id| part(self.generate_step(*id))).collect())?;
        }
        Ok(())
    }
}

/// Rows in the layout of a table of several lines: the comment of the last one sees to that.
fn rows(rows: TokenStream) -> Result<String, syn::Error> {
    let text = laid_out(quote! {
        const _: () = {
            impl P {
                const STEPS: &'static [Step<Self>] = &[#rows #[doc = ""] Step::go(0)];
            }
        };
    })?;
    let (_, rows) = split(&text, "= &[\n");
    let end = rows.rfind("            ///\n").unwrap_or(rows.len());
    Ok(rows[..end].to_owned())
}

/// Functions in the layout of an `impl`.
fn functions(functions: TokenStream) -> Result<String, syn::Error> {
    let text = laid_out(quote!(const _: () = { impl P { #functions } };))?;
    let (_, functions) = split(&text, "    impl P {\n");
    let end = functions.rfind("    }\n};\n").unwrap_or(0);
    Ok(functions[..end].to_owned())
}

/// Numbers of a table, as many on a line as it takes.
fn fill(out: &mut String, numbers: impl Iterator<Item = u32>) {
    let mut numbers = numbers.peekable();
    let mut column = 0;
    while let Some(number) = numbers.next() {
        let word = number.to_string();
        // The comma after the last one is there only because the table takes several lines, and counts for nothing.
        let comma = usize::from(numbers.peek().is_some());
        let is_first = column == 0;
        if !is_first && column + " ".len() + word.len() + comma <= COLUMNS {
            out.push(' ');
            column += " ".len();
        } else {
            if !is_first {
                out.push('\n');
            }
            out.push_str(&" ".repeat(INDENT));
            column = INDENT;
        }
        // Writing to a string cannot fail.
        let _ = write!(out, "{word},");
        column += word.len() + ",".len();
    }
    out.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::{self, load};
    use std::fmt::Write;

    /// Returns every kind of row and function, in programs of such lengths.
    fn program(steps: usize) -> Program {
        let mut text = "3.1\nlong\nDEF_VAR V W\nDEF_POS P\n".to_owned();
        for step in 0..steps / 8 {
            let turn = step % 7;
            _ = writeln!(
                text,
                "L{step}: V = {step}\nIF V > {turn} THEN ; W = V + 1.5\nELSE\nPTP F1 {turn} 0 V\nENDIF\n\
                 MESSAGE \"%V% of {step} and a text that is long enough for a line\nPTP_ANGLE J11 {turn}\nTEACH_POSITION F1 P"
            );
        }
        text += "END\n";
        let loaded = load("long.prg", text.as_bytes(), &load::Options::default());
        loaded
            .program
            .unwrap_or_else(|| panic!("{:#?}", loaded.diagnostics))
    }

    #[test]
    fn a_long_program_reads_like_all_of_it_laid_out_at_once() {
        let options = Options::default();
        for steps in [8, 40, 64, 72, 200, 640] {
            let program = program(steps);
            let whole = under(&header(&program), emit(&program, &options)).unwrap();
            assert!(pretty(&program, &options).unwrap() == whole, "{steps}");
        }
    }

    #[test]
    fn numbers_fill_lines_as_the_printer_fills_them() {
        for start in (0..40).chain([95, 980, 9_990, 99_950]) {
            let numbers: Vec<u32> = (start..start + 70 + start % 50).collect();
            let literals = numbers
                .iter()
                .map(|n| proc_macro2::Literal::u32_unsuffixed(*n));
            let whole =
                laid_out(quote!(impl P { const LINES: &'static [u32] = &[#(#literals),*]; }))
                    .unwrap();
            let mut filled = "impl P {\n    const LINES: &'static [u32] = &[\n".to_owned();
            fill(&mut filled, numbers.into_iter());
            filled += "    ];\n}\n";
            assert_eq!(filled, whole);
        }
    }
}
