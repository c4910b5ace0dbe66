//! Prints how long the front end takes, and rustc over emitted code, as the tables of docs/performance.md; or loads one
//! program, for instructions to be counted: `compiler mixed 20000`.

mod front_end;
mod long;
mod rustc;

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.as_slice() {
        [] => {
            front_end::print();
            rustc::print()
        }
        [kind, lines] => front_end::load_one(kind, lines.parse()?),
        _ => Err("give nothing, or a kind of program and its lines".into()),
    }
}
