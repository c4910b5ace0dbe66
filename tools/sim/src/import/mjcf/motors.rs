//! The greatest torques of actuators, by the joints that they turn.

use super::super::ImportError;
use super::Compiler;
use super::elements::{Classes, Element, Files, Merged};
use std::collections::BTreeMap;

/// The greatest torque of all actuators of each joint (N·m); infinite if one of them has no limit.
pub(super) fn read<'a>(
    root: &'a Element,
    classes: &Classes<'a>,
    files: &Files,
    compiler: &Compiler,
) -> Result<BTreeMap<&'a str, f64>, ImportError> {
    let mut torques = BTreeMap::new();
    for element in root.section("actuator") {
        let of = Merged {
            element,
            class: classes.named(element.attribute("class"), 0, files)?,
            classes,
            files,
        };
        let joint = element
            .value("joint")
            .or_else(|| element.value("jointinparent"));
        let Some(joint) = joint else {
            continue;
        };
        let gear = of.numbers("gear", 1, 6, "1")?;
        let gear = gear.and_then(|gear| gear.first().copied()).unwrap_or(1.0);
        let force = strongest(&of, "forcerange", "forcelimited", compiler)?;
        let gain = match element.name.as_str() {
            "motor" => Some(1.0),
            // A fixed gain without feedback.
            "general" if is_plain(&of)? => {
                let gain = of.numbers("gainprm", 1, 10, "1")?;
                Some(gain.and_then(|gain| gain.first().copied()).unwrap_or(1.0))
            }
            _ => None,
        };
        let control = match gain {
            Some(gain) => strongest(&of, "ctrlrange", "ctrllimited", compiler)? * gain.abs(),
            None => f64::INFINITY,
        };
        *torques.entry(joint).or_default() += force.min(control) * gear.abs();
    }
    Ok(torques)
}

fn is_plain(of: &Merged<'_, '_>) -> Result<bool, ImportError> {
    let is = |name, word: &str| of.value(name).is_none_or(|own| own == word);
    Ok(is("gaintype", "fixed") && is("biastype", "none"))
}

/// Returns the smaller end of a range, infinite if it does not limit.
pub(super) fn strongest(
    of: &Merged<'_, '_>,
    range: &'static str,
    limited: &'static str,
    compiler: &Compiler,
) -> Result<f64, ImportError> {
    let Some([least, most]) = of.vector(range, "-20 20")? else {
        return Ok(f64::INFINITY);
    };
    let is_limited = match of.word(limited, &["false", "true", "auto"])? {
        Some(0) => false,
        Some(1) => true,
        _ => compiler.auto_limits,
    };
    match is_limited && least < most {
        true => Ok(least.abs().min(most.abs())),
        false => Ok(f64::INFINITY),
    }
}
