//! Colours on light and dark grounds.

use plotters::style::RGBColor;
use tip_sim::urdf::xml::permitted;

/// On a light ground, and on a dark one.
type Pair = [u32; 2];

const GROUND: Pair = [0xFFFFFF, 0x0D1117];
const INK: Pair = [0x24292F, 0xE6EDF3];
const GRID: Pair = [0xD8DEE4, 0x30363D];
const ALARM: Pair = [0xCF222E, 0xFF7B72];
/// Told apart by most who do not see all colours; a tenth leg does not exist.
const LEGS: [Pair; 9] = [
    [0xC2570C, 0xFF9E57],
    [0x0B6BAB, 0x58B5F0],
    [0x0A7F5A, 0x3DD6A3],
    [0xA0307A, 0xEE8FCB],
    [0x8A6A00, 0xE5C54B],
    [0x5350A8, 0xABA8FF],
    [0x7A4A3A, 0xDBA791],
    [0x48720D, 0xA9DB5A],
    [0x57606A, 0xB7BFC8],
];

fn light([light, _]: Pair) -> RGBColor {
    let [_, red, green, blue] = light.to_be_bytes();
    RGBColor(red, green, blue)
}

/// Behind everything.
pub(super) fn ground() -> RGBColor {
    light(GROUND)
}

/// Of texts and axes.
pub(super) fn ink() -> RGBColor {
    light(INK)
}

/// Of lines that only guide the eye.
pub(super) fn grid() -> RGBColor {
    light(GRID)
}

/// Of falls.
pub(super) fn alarm() -> RGBColor {
    light(ALARM)
}

/// Of a leg, from 0.
pub(super) fn leg(number: usize) -> RGBColor {
    LEGS.get(number).copied().map_or(ink(), light)
}

/// The drawing with a name for those who hear it, and other colours where the reader's ground is dark.
pub(super) fn themed(svg: &str, name: &str) -> String {
    let rule = |[light, dark]: Pair| {
        format!(
            "[fill=\"#{light:06X}\"]{{fill:#{dark:06X}}}[stroke=\"#{light:06X}\"]{{stroke:#{dark:06X}}}"
        )
    };
    let pairs = [GROUND, INK, GRID, ALARM].into_iter().chain(LEGS);
    let rules: String = pairs.map(rule).collect();
    let name = permitted(name).replace('&', "&amp;").replace('<', "&lt;");
    let head = format!(
        "<title>{name}</title>\n<style>@media (prefers-color-scheme: dark){{{rules}}}</style>\n"
    );
    match svg.split_once(">\n") {
        Some((element, rest)) => format!("{element}>\n{head}{rest}"),
        None => svg.to_owned(),
    }
}
