//! Mass distribution of a link or a body, where the file gives it.

use super::section::{Found, Section, Sign};
use crate::message::Describing;
use tip_runtime::model::Spread;

/// Reads the keys `centre` and `inertia` of a table, with a default for the one that it leaves out; `None` if it has
/// neither.
pub(super) fn read(section: Section<'_>, even: Spread, found: &mut Found) -> Option<Spread> {
    let centre = section.numbers("centre", Sign::Any, found);
    let inertia = section.numbers("inertia", Sign::Any, found);
    if centre.is_none() && inertia.is_none() {
        return None;
    }
    let spread = Spread {
        centre: centre.unwrap_or(even.centre),
        inertia: inertia.unwrap_or(even.inertia),
    };
    if spread.is_sound() {
        return Some(spread);
    }
    let location = section.location_of("inertia");
    section.refuse("inertia", location, Describing::NoBodysInertia, found)
}

/// Returns the distribution for a link that is turned and mirrored: `turned` gives the turn of a direction, `mirror`
/// the sign of each coordinate.
pub(super) fn placed(
    spread: &Spread,
    turned: impl Fn([f64; 3]) -> [f64; 3],
    mirror: [f64; 3],
) -> Spread {
    let [xx, yy, zz, xy, xz, yz] = spread.inertia;
    // Rows are turned, and then, since the tensor is symmetric, columns.
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(&turned);
    let column = |axis: usize| turned(rows.map(|row| row[axis]));
    let columns = [column(0), column(1), column(2)];
    let at = |i: usize, j: usize| mirror[i] * mirror[j] * columns[i][j];
    let centre = turned(spread.centre);
    Spread {
        centre: [0, 1, 2].map(|axis| mirror[axis] * centre[axis]),
        inertia: [at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(0, 2), at(1, 2)],
    }
}
