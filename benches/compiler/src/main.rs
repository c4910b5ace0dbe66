//! Prints how long the front end and the formatter take, and rustc over emitted code, as the tables of docs/performance.md;
//! or loads one program, for instructions to be counted: `compiler mixed 20000`.

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
        [kind, lines] => front_end::load_one(kind, lines.parse()?),
        _ => Err("give nothing, format, or a kind of program and its lines".into()),
    }
}
