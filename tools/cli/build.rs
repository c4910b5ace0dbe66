//! Packs the playground that `.ci/release` names by TIP_PLAYGROUND. Other builds, which have no compiler for WebAssembly, have none.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-env-changed=TIP_PLAYGROUND");
    let folder = env::var("OUT_DIR").map_err(io::Error::other)?;
    let page = match env::var("TIP_PLAYGROUND") {
        Ok(page) => {
            println!("cargo::rerun-if-changed={page}");
            miniz_oxide::deflate::compress_to_vec(&fs::read(page)?, 9)
        }
        Err(_) => Vec::new(),
    };
    fs::write(Path::new(&folder).join("playground"), page)
}
