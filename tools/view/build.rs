//! Packs the script of the page, which would otherwise be a tenth of the command.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = env::var("OUT_DIR").map_err(io::Error::other)?;
    let script = "page/dist/page.js";
    println!("cargo::rerun-if-changed={script}");
    let text = fs::read(script)?;
    // Browsers refuse a script of other bytes than those that the page was built with.
    if text.contains(&b'\r') {
        return Err(io::Error::other(format!(
            "{script} has other line ends than in the repository"
        )));
    }
    let packed = miniz_oxide::deflate::compress_to_vec(&text, 9);
    fs::write(Path::new(&folder).join("page.js"), packed)
}
