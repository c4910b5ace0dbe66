//! Files that appear complete or not at all.

use std::fs::{self, Permissions};
use std::io::Write;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::Command;
use tip_runtime::record::AtomicFile;

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("whole")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the target folder is writable");
    folder
}

fn write(path: &Path, text: &str) -> std::io::Result<()> {
    let mut file = AtomicFile::create(path)?;
    file.write_all(text.as_bytes())?;
    file.commit()
}

fn mode(path: &Path) -> u32 {
    fs::metadata(path)
        .expect("it is there")
        .permissions()
        .mode()
        & 0o7777
}

#[test]
fn a_replaced_file_keeps_its_mode_and_a_new_one_has_the_usual() {
    let folder = folder("mode");
    let (kept, new, usual) = (
        folder.join("kept"),
        folder.join("new"),
        folder.join("usual"),
    );
    for mode in [0o600, 0o640, 0o755] {
        fs::write(&kept, "old").expect("the folder is writable");
        fs::set_permissions(&kept, Permissions::from_mode(mode)).expect("it is ours");
        write(&kept, "new").expect("it can be replaced");
        assert_eq!(self::mode(&kept), mode);
    }
    fs::write(&usual, "").expect("the folder is writable");
    write(&new, "new").expect("the folder is writable");
    assert_eq!(mode(&new), mode(&usual));
}

#[test]
fn a_name_of_the_greatest_length_can_be_written() {
    let path = folder("long").join("n".repeat(255));
    for text in ["one", "two"] {
        write(&path, text).expect("the folder is writable");
        assert_eq!(fs::read_to_string(&path).expect("it is there"), text);
    }
    let longer = path.with_file_name("n".repeat(256));
    let refused = AtomicFile::create(&longer).expect_err("no name is so long");
    assert_eq!(refused.kind(), std::io::ErrorKind::InvalidFilename);
}

#[test]
fn a_folder_that_is_missing_is_the_systems_error() {
    let path = folder("missing").join("no/file");
    let error = AtomicFile::create(&path).expect_err("there is no folder");
    // ENOENT.
    assert_eq!(error.raw_os_error(), Some(2));
}

#[test]
fn no_two_files_share_a_part_and_none_is_left() {
    let folder = folder("parts");
    let path = folder.join("one");
    let files = [(); 8].map(|()| AtomicFile::create(&path).expect("the folder is writable"));
    let mut parts: Vec<_> = files
        .iter()
        .map(|file| file.part().map(Path::to_owned))
        .collect();
    parts.sort();
    parts.dedup();
    assert_eq!(parts.len(), files.len());
    let old_name = format!(".one.{}.part", std::process::id());
    assert!(
        !parts.contains(&Some(folder.join(old_name))),
        "a name that can be guessed"
    );
    drop(files);
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 0);
}

#[test]
fn a_pipe_without_a_reader_is_refused_at_once_and_one_with_a_reader_is_written() {
    let pipe = folder("pipe").join("pipe");
    let made = Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo starts").success());
    let refused = AtomicFile::create(&pipe).expect_err("nobody reads it");
    // ENXIO.
    assert_eq!(refused.raw_os_error(), Some(6));
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::read_to_string(pipe)
    });
    let mut file = loop {
        match AtomicFile::create(&pipe) {
            Ok(file) => break file,
            Err(_) => std::thread::yield_now(),
        }
    };
    // More than a pipe holds: it waits for its reader.
    let text = "0123456789".repeat(20_000);
    file.write_all(text.as_bytes()).expect("someone reads it");
    file.commit().expect("nothing to be put in its place");
    assert_eq!(reader.join().expect("it ends").expect("text"), text);
}

#[test]
fn a_file_keeps_its_names_and_loses_set_user_id() {
    let folder = folder("names");
    let (one, two) = (folder.join("one"), folder.join("two"));
    fs::write(&one, "a longer text").expect("the folder is writable");
    fs::hard_link(&one, &two).expect("the folder is writable");
    fs::set_permissions(&one, Permissions::from_mode(0o6754)).expect("it is ours");
    for text in ["short", "", "a text that is longer than all before it"] {
        write(&one, text).expect("it can be replaced");
        assert_eq!(fs::read_to_string(&two).expect("it is there"), text);
    }
    assert_eq!(mode(&two), 0o754);
    fs::remove_file(&two).expect("it is there");
    fs::set_permissions(&one, Permissions::from_mode(0o4700)).expect("it is ours");
    write(&one, "alone").expect("it can be replaced");
    assert_eq!(mode(&one), 0o700);
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 1);
}

#[test]
fn what_a_link_leads_to_is_written_and_the_link_stays() {
    use std::os::unix::fs::symlink;
    let folder = folder("links");
    let link = folder.join("link");
    symlink("chain", &link).expect("the folder is writable");
    fs::write(folder.join("target"), "old").expect("the folder is writable");
    symlink("target", folder.join("chain")).expect("the folder is writable");
    for text in ["new", "again"] {
        write(&link, text).expect("the folder is writable");
        let target = fs::read_to_string(folder.join("target"));
        assert_eq!(target.expect("it is there"), text);
        let link = fs::symlink_metadata(&link).expect("it is there");
        assert!(link.is_symlink());
    }
}

/// Only the system administrator can give a file away; without the permission the test checks
/// nothing.
#[test]
fn a_replaced_file_keeps_its_owner() {
    use std::os::unix::fs::{MetadataExt, chown};
    let path = folder("owner").join("file");
    fs::write(&path, "old").expect("the folder is writable");
    if chown(&path, Some(4711), Some(4712)).is_ok() {
        write(&path, "new").expect("it can be replaced");
        let found = fs::metadata(&path).expect("it is there");
        assert_eq!((found.uid(), found.gid()), (4711, 4712));
    }
}
