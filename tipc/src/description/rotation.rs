//! Turns in degrees.

/// Returns sine and cosine of an angle in degrees, exact at every quarter turn.
pub(super) fn sin_cos(angle: f64) -> [f64; 2] {
    let quarters = (angle / 90.0).floor();
    let (sin, cos) = libm::sincos((angle - quarters * 90.0).to_radians());
    match quarters.rem_euclid(4.0) as u8 {
        0 => [sin, cos],
        1 => [cos, -sin],
        2 => [-sin, -cos],
        _ => [-cos, sin],
    }
}
