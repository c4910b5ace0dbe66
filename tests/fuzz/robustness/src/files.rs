//! Files of any name that replace others: whole or not at all, and nothing beside them.

use std::ffi::OsStr;
use std::io::Write;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};
use std::{env, fs, process, thread};
use tip_runtime::record::AtomicFile;

/// Writes a file by the name that the bytes are, up to the first slash, beside a file that is in everybody's way; given up
/// first, then twice.
///
/// # Panics
/// Part of a file is left, or one has not what was written.
pub fn examine(bytes: &[u8]) {
    let name = bytes.split(|byte| *byte == b'/').next().unwrap_or_default();
    if matches!(name, b"" | b"." | b"..") {
        return;
    }
    let folder = folder();
    let other = folder.join("other");
    fs::write(&other, "other").expect("the folder is writable");
    let path = folder.join(OsStr::from_bytes(name));
    let is_other = path == other;
    let Ok(given_up) = AtomicFile::create(&path) else {
        assert!(!path.exists() || is_other, "{path:?}");
        return clear(&folder);
    };
    drop(given_up);
    assert_eq!(path.exists(), is_other, "{path:?}");
    for text in ["one", "two"] {
        let written = write(&path, text);
        assert!(written.is_ok(), "{path:?}: {written:?}");
        assert_eq!(
            fs::read(&path).ok().as_deref(),
            Some(text.as_bytes()),
            "{path:?}"
        );
    }
    let count = fs::read_dir(&folder).expect("it is there").count();
    assert_eq!(count, if is_other { 1 } else { 2 }, "{path:?}");
    if !is_other {
        assert_eq!(
            fs::read(&other).ok().as_deref(),
            Some(&b"other"[..]),
            "{path:?}"
        );
    }
    clear(&folder);
}

fn write(path: &Path, text: &str) -> std::io::Result<()> {
    let mut file = AtomicFile::create(path)?;
    file.write_all(text.as_bytes())?;
    file.commit()
}

/// An empty folder for this thread.
fn folder() -> PathBuf {
    let thread = format!("{:?}", thread::current().id());
    let folder = env::temp_dir().join(format!("tip-files-{}-{thread}", process::id()));
    clear(&folder);
    fs::create_dir_all(&folder).expect("the temporary folder is writable");
    folder
}

fn clear(folder: &Path) {
    let _ = fs::remove_dir_all(folder);
}
