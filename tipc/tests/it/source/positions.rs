//! Positions, compared with those that counting from the start of the file gives.

use crate::source::hostile::File;
use crate::source::random::Random;
use tipc::source::{Encoding, Position, Source, Unit};

const UNITS: [Unit; 4] = [Unit::Byte, Unit::Utf8, Unit::Utf16, Unit::Character];

/// Start of a character.
struct Place {
    offset: usize,
    /// The line, and the column in each of [`UNITS`].
    position: (u32, [u32; 4]),
    /// Line and column as reports give them: what is behind a line counts on.
    reported: (u32, u32),
    /// Width in each unit.
    width: [u32; 4],
    /// It is part of a line's end.
    ends: bool,
}

/// Returns the places of all characters, and of the end, by counting.
fn counted(file: &File) -> Vec<Place> {
    let mut places = Vec::new();
    let (mut offset, mut line, mut columns) = (0, 1, [1; 4]);
    let (mut reported_line, mut reported_column) = (1, 1);
    let characters = &file.characters;
    for (index, (char, bytes)) in characters.iter().enumerate() {
        let width = [
            bytes.len() as u32,
            char.len_utf8() as u32,
            char.len_utf16() as u32,
            1,
        ];
        places.push(Place {
            offset,
            position: (line, columns),
            reported: (reported_line, reported_column),
            width,
            ends: matches!(char, '\n' | '\r'),
        });
        offset += char.len_utf8();
        reported_column += 1;
        let next = characters.get(index + 1).map(|(char, _)| *char);
        match (char, next) {
            ('\r', Some('\n')) => {}
            ('\n' | '\r', _) => {
                (line, columns) = (line + 1, [1; 4]);
                if next.is_some() {
                    (reported_line, reported_column) = (line, 1);
                }
            }
            _ => (0..4).for_each(|unit| columns[unit] += width[unit]),
        }
    }
    places.push(Place {
        offset,
        position: (line, columns),
        reported: (reported_line, reported_column),
        width: [1_000_000; 4],
        ends: true,
    });
    places
}

fn examine(source: &Source, place: &Place) {
    assert_eq!(source.line_column(place.offset), place.reported);
    let (line, columns) = place.position;
    for (index, unit) in UNITS.into_iter().enumerate() {
        let expected = Position {
            line,
            column: columns[index],
        };
        assert_eq!(source.position(place.offset, unit), expected, "{unit:?}");
    }
}

/// Checks the way back, also from inside a character and from after the line.
fn examine_back(source: &Source, places: &[Place], index: usize) {
    let place = &places[index];
    let (line, columns) = place.position;
    let behind = index > 0 && places[index - 1].position == place.position;
    // The second half of CRLF has no position of its own.
    let offset = if behind {
        places[index - 1].offset
    } else {
        place.offset
    };
    for (unit, name) in UNITS.into_iter().enumerate() {
        let inside = if place.ends { 3 } else { place.width[unit] };
        for ahead in (0..inside).chain(
            [u32::MAX - columns[unit]]
                .into_iter()
                .filter(|_| place.ends),
        ) {
            let column = columns[unit] + ahead;
            let position = Position { line, column };
            assert_eq!(
                source.offset(position, name),
                offset,
                "{name:?} {position:?}"
            );
        }
    }
}

#[test]
fn positions_are_those_of_counting() {
    let mut random = Random(5);
    for round in 0..1500 {
        let file = File::random(&mut random, round % 40);
        let source = file.source();
        let places = counted(&file);
        for (index, place) in places.iter().enumerate() {
            examine(&source, place);
            examine_back(&source, &places, index);
        }
    }
}

#[test]
fn positions_in_long_files_and_lines() {
    let mut random = Random(6);
    for round in 0..8 {
        let mut file = File::random(&mut random, 9000);
        if round % 2 == 0 {
            // One line, or few.
            let keep = random.below(3);
            let mut ends = 0;
            let is_end = |char: char| matches!(char, '\n' | '\r');
            file.characters.retain(|(char, _)| {
                ends += usize::from(is_end(*char));
                !is_end(*char) || ends < keep
            });
            let bytes = file.characters.iter().flat_map(|(_, bytes)| *bytes);
            file.bytes = bytes.copied().chain([0x1A]).collect();
        }
        let (source, _) = Source::decode("long.prg", &file.bytes, file.encoding);
        let text: String = file.characters.iter().map(|(char, _)| *char).collect();
        if source.text() != text {
            // What was cut out stood between bytes that now are one character.
            continue;
        }
        let places = counted(&file);
        for (index, place) in places.iter().enumerate() {
            examine(&source, place);
            examine_back(&source, &places, index);
        }
    }
}

/// Decodes UTF-8 and converts, both ways.
#[track_caller]
fn check(text: &str, offset: usize, unit: Unit, line: u32, column: u32) {
    let (source, _) = Source::decode("a.prg", text.as_bytes(), Encoding::Utf8);
    let position = Position { line, column };
    assert_eq!(source.position(offset, unit), position, "to");
    assert_eq!(source.offset(position, unit), offset, "back");
}

#[test]
fn columns_by_hand() {
    // Robot, two units of UTF-16 and four bytes; a tab is one of everything.
    check("x\n\t🤖b", 7, Unit::Utf16, 2, 4);
    check("x\n\t🤖b", 7, Unit::Character, 2, 3);
    check("x\n\t🤖b", 7, Unit::Utf8, 2, 6);
    check("\u{FEFF}x", 1, Unit::Byte, 1, 2);
    check("a\r\nb", 3, Unit::Utf8, 2, 1);
    // After the last end of a line an editor shows one more line.
    check("a\n", 2, Unit::Utf16, 2, 1);
    check("", 0, Unit::Utf16, 1, 1);
}

#[test]
fn columns_of_shift_jis_are_those_of_the_file() {
    // HIRAGANA A (two bytes), half-width KATAKANA A (one), B.
    let (source, _) = Source::decode("a.prg", b"\x82\xA0\xB1B", Encoding::Auto);
    assert_eq!(source.text(), "あｱB");
    for (unit, column) in [
        (Unit::Byte, 4),
        (Unit::Utf8, 7),
        (Unit::Utf16, 3),
        (Unit::Character, 3),
    ] {
        let position = Position { line: 1, column };
        assert_eq!(source.position(6, unit), position);
        assert_eq!(source.offset(position, unit), 6);
    }
}

#[test]
fn what_is_no_position_is_moved_to_one() {
    let (source, _) = Source::decode("a.prg", "é🤖\r\nb".as_bytes(), Encoding::Utf8);
    let offset = |line, column| source.offset(Position { line, column }, Unit::Utf16);
    assert_eq!(offset(0, 2), 2);
    assert_eq!(offset(1, 0), 0);
    assert_eq!(offset(1, 2), 2);
    // Between the surrogates.
    assert_eq!(offset(1, 3), 2);
    assert_eq!(offset(1, 4), 6);
    assert_eq!(offset(1, 5), 6);
    assert_eq!(offset(1, u32::MAX), 6);
    assert_eq!(offset(2, 9), 9);
    assert_eq!(offset(3, 1), 9);
    assert_eq!(offset(u32::MAX, u32::MAX), 9);
    let column = |offset| source.position(offset, Unit::Utf16);
    // Inside a character, between CR and LF, after the text.
    assert_eq!(column(4), Position { line: 1, column: 2 });
    assert_eq!(column(7), Position { line: 1, column: 4 });
    assert_eq!(column(usize::MAX), Position { line: 2, column: 2 });
}
