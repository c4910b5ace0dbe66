//! The picture of a gait.

use walking::Gait;

#[test]
fn a_short_gait_has_a_column_for_each_cycle() {
    let mut gait = Gait::default();
    gait.push([true, true, false, true]);
    gait.push([false, true, true, true]);
    assert_eq!(gait.to_string(), "  F1  #.\n  F2  ##\n  F3  .#\n  F4  ##\n");
}

#[test]
fn a_long_gait_fits_the_width_and_shows_what_lasts_longer() {
    let mut gait = Gait::default();
    for cycle in 0..720 {
        gait.push([cycle % 10 < 6, cycle % 10 < 4, true, false]);
    }
    assert_eq!(gait.column(), 10);
    let picture = gait.to_string();
    let marks: Vec<&str> = picture.lines().map(|line| &line[6..]).collect();
    assert_eq!(
        marks,
        [
            "#".repeat(72),
            ".".repeat(72),
            "#".repeat(72),
            ".".repeat(72)
        ]
    );
}

#[test]
fn no_cycles_make_an_empty_picture() {
    assert!(
        Gait::<4>::default()
            .to_string()
            .lines()
            .all(|line| line.ends_with(' '))
    );
}
