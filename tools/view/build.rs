//! Packs the pages, which would otherwise be a tenth of the command.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = env::var("OUT_DIR").map_err(io::Error::other)?;
    for name in ["page.html", "live.html"] {
        let page = format!("page/dist/{name}");
        println!("cargo::rerun-if-changed={page}");
        let packed = miniz_oxide::deflate::compress_to_vec(&fs::read(page)?, 9);
        fs::write(Path::new(&folder).join(name), packed)?;
    }
    Ok(())
}
