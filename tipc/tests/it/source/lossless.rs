//! The pieces of a file, one after the other, are the file.

use crate::source::hostile::File;
use std::fs;
use std::path::{Path, PathBuf};
use tip_runtime::random::Random;
use tipc::source::{Encoding, Line, Source, Span};

const ENCODINGS: [Encoding; 3] = [Encoding::Auto, Encoding::Utf8, Encoding::ShiftJis];

/// Returns the mark, the text cut at `cuts`, the tail.
fn joined(source: &Source, cuts: impl IntoIterator<Item = Span>) -> Vec<u8> {
    let mut bytes = source.mark().to_vec();
    for span in cuts {
        bytes.extend_from_slice(source.original(span));
    }
    bytes.extend_from_slice(source.tail());
    bytes
}

/// Takes the file apart into lines and their ends, and into stretches that end anywhere.
fn examine(bytes: &[u8], encoding: Encoding, random: &mut Random) {
    let (source, _) = Source::decode("a.prg", bytes, encoding);
    let lines: Vec<Line> = source.lines().collect();
    let by_line = lines.iter().flat_map(|line| [line.span, line.end]);
    assert!(
        joined(&source, by_line) == bytes,
        "{encoding:?}: {bytes:x?}"
    );
    let length = source.text().len();
    let mut cuts: Vec<usize> = (0..8).map(|_| random.index(length + 1)).collect();
    cuts.extend([0, length]);
    cuts.sort_unstable();
    let anywhere = cuts.windows(2).map(|pair| Span::new(pair[0], pair[1]));
    assert!(
        joined(&source, anywhere) == bytes,
        "{encoding:?}: {bytes:x?}"
    );
    // The index finds the lines that reading from the start does.
    assert_eq!(lines.len(), source.line_count() as usize);
    for _ in 0..8 {
        let line = lines[random.index(lines.len())];
        assert_eq!(source.line(line.number), line, "{bytes:x?}");
    }
}

/// Collects all files under a folder.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("an entry").path();
        match path.is_dir() {
            true => files(&path, found),
            false => found.push(path),
        }
    }
}

// clauses: 1.1
#[test]
fn files_of_the_project() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    for folder in [
        "tests/language/cases",
        "tests/codegen/golden",
        "tests/fuzz/corpus",
        "tests/fuzz/artifacts",
    ] {
        files(&root.join(folder), &mut found);
    }
    // The package alone has none of them.
    assert!(
        found.len() > 300 || !root.join("tests").exists(),
        "{}",
        found.len()
    );
    let mut random = Random::new(7);
    for path in found {
        let bytes = fs::read(&path).expect("a readable file");
        for encoding in ENCODINGS {
            examine(&bytes, encoding, &mut random);
        }
    }
}

// clauses: 1.1
#[test]
fn hostile_texts() {
    let mut random = Random::new(1);
    for round in 0..600 {
        let pieces = if round % 200 == 0 { 9000 } else { round % 60 };
        let file = File::random(&mut random, pieces);
        let source = file.source();
        for encoding in ENCODINGS {
            examine(&file.bytes, encoding, &mut random);
        }
        assert_eq!(source.mark().is_empty(), !file.marked);
        // Every character has its own bytes, also those that the two codes of one character share.
        let mut at = 0;
        for (char, bytes) in file.characters.iter().take(60) {
            let span = Span::new(at, at + char.len_utf8());
            assert_eq!(source.original(span), *bytes, "{at}: {:x?}", file.bytes);
            at = span.end;
        }
    }
}

// clauses: 1.1
#[test]
fn any_bytes() {
    let mut random = Random::new(2);
    for round in 0..600 {
        let length = if round % 300 == 0 { 20_000 } else { round % 40 };
        // Bytes near each other are often of one kind.
        let kinds: [&[u8]; 3] = [b"\r\n\x1A\0 A", b"\x81\x82\xE3\xEF\xBB\xBF\xFF\xA0", b""];
        let kind = kinds[random.index(3)];
        let bytes: Vec<u8> = (0..length)
            .map(|_| match (random.index(3), kind.len()) {
                (0, _) | (_, 0) => random.index(256) as u8,
                (_, count) => kind[random.index(count)],
            })
            .collect();
        for encoding in ENCODINGS {
            examine(&bytes, encoding, &mut random);
        }
    }
}

#[test]
fn ends_of_files() {
    let mut random = Random::new(3);
    for bytes in [
        &b""[..],
        b"\x1A",
        b"\x1A\x1A",
        b"\xEF\xBB\xBF",
        b"\xEF\xBB\xBF\x1A",
        b"\xEF\xBB",
        b"\n",
        b"\r",
        b"\r\n",
        b"\n\r",
        b"\r\n\x1A",
        b"a\x1A\nb\x1A",
        b"\x82",
        b"\x82\x1A",
        b"\x82\xA0\x1A",
        b"\xFF\n\xFF",
    ] {
        for encoding in ENCODINGS {
            examine(bytes, encoding, &mut random);
        }
    }
}

#[test]
fn spans_of_another_file_are_empty_or_cut() {
    let (source, _) = Source::decode("a.prg", b"\x82\xA0b", Encoding::ShiftJis);
    assert_eq!(source.original(Span::new(3, 99)), b"b");
    assert_eq!(source.original(Span::new(50, 99)), b"");
    assert_eq!(source.original(Span::new(4, 0)), b"");
    // What begins in the span is spelled whole.
    assert_eq!(source.original(Span::new(0, 1)), b"\x82\xA0");
    assert_eq!(source.original(Span::new(1, 4)), b"b");
}
