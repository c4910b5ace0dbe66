//! Prints how long the front end and the formatter take, and rustc over emitted code, as the tables of docs/performance.md;
//! or loads or formats one program, for instructions to be counted: `compiler mixed 20000`, `compiler format mixed 20000`.

mod formatter;
mod front_end;
mod long;
mod rustc;

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.as_slice() {
        [] => {
            front_end::print();
            formatter::print();
            rustc::print()
        }
        [kind] if kind == "format" => {
            formatter::print();
            Ok(())
        }
        [kind, lines] => {
            front_end::seconds(&long::program(kind, lines.parse()?)?);
            Ok(())
        }
        [format, kind, lines] if format == "format" => {
            formatter::seconds(&long::program(kind, lines.parse()?)?);
            Ok(())
        }
        _ => Err("give nothing, format, a kind of program and its lines, or both".into()),
    }
}
