//! Memory use of a file: its text, and a number for each of its lines.

use allocation_counter::measure;
use tipc::source::{Encoding, Source};
use tipc::{Options, load};

const MEGABYTES: usize = 5 << 20;

/// Bytes that the index takes for a line: where it starts.
const START: u64 = size_of::<usize>() as u64;

/// Returns the most bytes that are in use while the file is decoded, and how many lines it has.
fn decoding(bytes: &[u8], encoding: Encoding) -> (u64, u64) {
    let mut lines = 0;
    let used = measure(|| {
        let (source, _) = Source::decode("a.prg", bytes, encoding);
        lines = u64::from(source.line_count());
    });
    (used.bytes_max, lines)
}

#[test]
fn a_blank_line_costs_its_byte_and_its_start() {
    let bytes = vec![b'\n'; MEGABYTES];
    let (used, lines) = decoding(&bytes, Encoding::Auto);
    assert_eq!(lines, MEGABYTES as u64);
    let least = lines + START * lines;
    assert!(used < least + lines / 100, "{used} bytes for {lines} lines");
}

#[test]
fn a_line_of_the_longest_length_costs_its_bytes_and_its_start() {
    let line = [b'x'; 1023];
    let bytes = [&line[..], b"\n"].concat().repeat(MEGABYTES / 1024);
    let (used, lines) = decoding(&bytes, Encoding::Auto);
    let name = 16;
    assert!(
        used <= bytes.len() as u64 + START * lines + name,
        "{used} bytes for {lines} lines"
    );
}

#[test]
fn shift_jis_is_kept_once_beside_its_text() {
    let mut bytes = vec![b'\n'; MEGABYTES];
    bytes.extend(b"\x95\x5C");
    for encoding in [Encoding::Auto, Encoding::ShiftJis] {
        let (used, lines) = decoding(&bytes, encoding);
        assert!(
            used < 2 * (1 + START) * lines + lines / 50,
            "{used} bytes for {lines} lines"
        );
    }
}

// clauses: 1.2
#[test]
fn loading_blank_lines_asks_for_no_more_than_their_text_and_starts() {
    let mut bytes = b"3.1\nt\n".to_vec();
    bytes.resize(MEGABYTES, b'\n');
    bytes.extend(b"END\n");
    let mut steps = 0;
    let used = measure(|| {
        let program = load("a.prg", &bytes, &Options::default()).program;
        steps = program.expect("it loads").steps().len();
    });
    assert_eq!(steps, 1);
    let length = bytes.len() as u64;
    assert!(
        used.bytes_max < (1 + START) * length + length / 50,
        "{} bytes",
        used.bytes_max
    );
}
