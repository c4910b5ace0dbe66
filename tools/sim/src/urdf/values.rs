//! Values of attributes, and of descriptions.

/// A name as a comment or a report may hold it.
pub(super) fn printed(name: &str) -> String {
    name.replace(char::is_control, "?")
}

/// One number, and nothing else.
pub(super) fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok()
}

/// The numbers among the words of a text.
pub(super) fn numbers(text: &str) -> impl Iterator<Item = f64> {
    text.split_whitespace().filter_map(|word| word.parse().ok())
}

/// Three numbers.
pub(super) fn vector(text: &str) -> Option<[f64; 3]> {
    numbers(text).collect::<Vec<_>>().try_into().ok()
}

/// Four numbers, and nothing else.
pub(super) fn quaternion(text: &str) -> Option<[f64; 4]> {
    let words: Option<Vec<f64>> = text.split_whitespace().map(number).collect();
    words?.try_into().ok()
}

/// Roll, pitch and yaw of a quaternion (x, y, z, w) of any length, as urdfdom has them.
pub(super) fn roll_pitch_yaw(quaternion: [f64; 4]) -> [f64; 3] {
    /// The sine of a pitch that leaves roll and yaw about the same axis.
    const UPRIGHT: f64 = 0.99999;
    let length = quaternion
        .iter()
        .map(|part| part * part)
        .sum::<f64>()
        .sqrt();
    let [x, y, z, w] = match length > 0.0 {
        true => quaternion.map(|part| part / length),
        false => [0.0, 0.0, 0.0, 1.0],
    };
    let sin_pitch = -2.0 * (x * z - w * y);
    if sin_pitch <= -UPRIGHT {
        [0.0, -std::f64::consts::FRAC_PI_2, 2.0 * libm::atan2(x, -y)]
    } else if sin_pitch >= UPRIGHT {
        [0.0, std::f64::consts::FRAC_PI_2, 2.0 * libm::atan2(-x, y)]
    } else {
        let [xx, yy, zz, ww] = [x, y, z, w].map(|part| part * part);
        [
            libm::atan2(2.0 * (y * z + w * x), ww - xx - yy + zz),
            libm::asin(sin_pitch),
            libm::atan2(2.0 * (x * y + w * z), ww + xx - yy - zz),
        ]
    }
}

/// Rounds a measure to a millionth: changes of units and frames leave noise beyond that.
pub(super) fn measure(value: f64) -> f64 {
    to(1e6, value)
}

/// A value to so many parts of its unit.
pub(super) fn to(parts: f64, value: f64) -> f64 {
    // Adding 0 makes of −0 a plain 0.
    (value * parts).round() / parts + 0.0
}
