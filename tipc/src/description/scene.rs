//! Scenes from TOML files: the floor and the objects around a simulated robot.

use super::keys::Part;
use super::open;
use super::section::{Found, Section, Sign, fault};
use crate::load::Loaded;
use crate::message::Describing;
use tip_runtime::model::Range;
use tip_runtime::scene::{Block, Object, Scene, SceneError, Shape, Simulation};

/// Reads a scene. `name` is the file's name in diagnostics.
///
/// # Errors
/// All faults of the file, each at its location, as a [`Loaded`] without a program.
pub fn parse_scene(name: &str, bytes: &[u8]) -> Result<Scene, Box<Loaded>> {
    open(name, bytes, Part::Scene, |_, top, found| {
        Some(read(top, found))
    })
}

fn read(top: Section<'_>, found: &mut Found) -> Scene {
    let mut scene = Scene::EMPTY;
    if top.has("plant") {
        scene.plant = top.choice("plant", &Simulation::NAMES, found);
    }
    if let Some(floor) = top.table("floor", Part::Floor, found) {
        let height = floor.number("height", Sign::Any, found);
        let slope = floor.numbers("slope", Sign::Any, found);
        let friction = floor.number("friction", Sign::NotNegative, found);
        scene.floor.height = height.unwrap_or(scene.floor.height);
        scene.floor.slope = slope.unwrap_or(scene.floor.slope);
        scene.friction = friction.unwrap_or(scene.friction);
    }
    for section in top
        .tables("object", Part::Object, found)
        .unwrap_or_default()
    {
        let Some(object) = object(section, found) else {
            continue;
        };
        match scene.with_object(object) {
            Ok(with) => scene = with,
            Err(error) => found.push(refused(section, error)),
        }
    }
    let blocks = top.tables("block", Part::Block, found).unwrap_or_default();
    for section in blocks {
        let Some(block) = block(section, found) else {
            continue;
        };
        match scene.with_block(block) {
            Ok(with) => scene = with,
            Err(error) => found.push(refused(section, error)),
        }
    }
    scene
}

fn block(section: Section<'_>, found: &mut Found) -> Option<Block> {
    let [x, y] = ["x", "y"].map(|key| section.extent(key, found));
    let height = section.number("height", Sign::Any, found);
    let ends = |range: Range| [range.min, range.max];
    Some(Block {
        x: ends(x?),
        y: ends(y?),
        height: height?,
    })
}

fn object(section: Section<'_>, found: &mut Found) -> Option<Object> {
    let shape = shape(section, found);
    let mass = section.number("mass", Sign::Positive, found);
    let friction = section.number("friction", Sign::NotNegative, found);
    let x = section.number("x", Sign::Any, found);
    let y = section.number("y", Sign::Any, found);
    let angle = section.number("angle", Sign::Any, found);
    Some(Object {
        shape: shape?,
        mass: mass?,
        friction: friction.unwrap_or(0.5),
        x: x.unwrap_or(0.0),
        y,
        angle: angle.unwrap_or(0.0),
    })
}

/// Reads a box or a disc, depending on the key.
fn shape(section: Section<'_>, found: &mut Found) -> Option<Shape> {
    match (section.has("size"), section.has("radius")) {
        (true, false) => {
            let [width, height] = section.numbers("size", Sign::Size, found)?;
            Some(Shape::Box { width, height })
        }
        (false, true) => {
            let radius = section.number("radius", Sign::Size, found)?;
            Some(Shape::Disc { radius })
        }
        (both, _) => {
            let reason = if both {
                Describing::BothShapes
            } else {
                Describing::NoShape
            };
            let help = Describing::Shapes;
            found.push(fault(section.part, section.location, reason, help));
            None
        }
    }
}

/// Reports what the plant cannot simulate.
fn refused(section: Section<'_>, error: SceneError) -> crate::diagnostic::Diagnostic {
    let (key, help) = match error {
        SceneError::Full | SceneError::Blocks => ("", Describing::TakeOneAway),
        SceneError::Size if section.has("radius") => ("radius", Describing::RadiusUnit),
        SceneError::Size => ("size", Describing::SizeUnit),
        SceneError::Mass => ("mass", Describing::MassUnit),
        SceneError::Friction | SceneError::Place => ("", Describing::OnlyNumbers),
    };
    let reason = Describing::Simulated {
        error: error.to_string().into(),
    };
    fault(section.part, section.location_of(key), reason, help)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render;

    fn reported(text: &str) -> Vec<String> {
        let loaded = parse_scene("s.toml", text.as_bytes()).expect_err("it is wrong");
        let lines = loaded.diagnostics.iter();
        let lines = lines.map(|one| render::classical(&loaded.source, one));
        lines.map(|line| line.trim_end().to_owned()).collect()
    }

    #[test]
    fn a_scene_is_a_floor_and_objects() {
        let text = b"[floor]\nheight = 5\nslope = [0.1, 0]\nfriction = 0.7\n\
            [[object]]\nsize = [40, 30]\nmass = 0.05\n\
            [[object]]\nradius = 20\nmass = 1\nfriction = 0.3\nx = -5\ny = 10.5\nangle = 30\n";
        let scene = parse_scene("s.toml", text).expect("a good scene");
        assert_eq!(scene.floor.height, 5.0);
        assert_eq!(scene.floor.slope, [0.1, 0.0]);
        assert_eq!(scene.friction, 0.7);
        let shape = Shape::Box {
            width: 40.0,
            height: 30.0,
        };
        let first = Object {
            shape,
            mass: 0.05,
            friction: 0.5,
            x: 0.0,
            y: None,
            angle: 0.0,
        };
        let second = Object {
            shape: Shape::Disc { radius: 20.0 },
            mass: 1.0,
            friction: 0.3,
            x: -5.0,
            y: Some(10.5),
            angle: 30.0,
        };
        assert_eq!(scene.objects, [Some(first), Some(second), None, None]);
        assert_eq!(parse_scene("s.toml", b"").expect("empty"), Scene::EMPTY);
    }

    #[test]
    fn a_scene_has_steps() {
        let text = b"[[block]]\nx = [-100, 100]\ny = [300, 900]\nheight = 40\n";
        let scene = parse_scene("s.toml", text).expect("a good scene");
        let step = Block {
            x: [-100.0, 100.0],
            y: [300.0, 900.0],
            height: 40.0,
        };
        assert_eq!(scene.blocks.iter().flatten().collect::<Vec<_>>(), [&step]);
        let nine = "[[block]]\nx = [0, 10]\ny = [0, 10]\nheight = 1\n".repeat(9);
        let wrong = "s.toml:33:1: error: TIP_ERR:Wrong scene (RobotError)";
        assert_eq!(reported(&nine), [wrong]);
    }

    #[test]
    fn a_scene_chooses_a_plant() {
        for (name, plant) in Simulation::NAMES {
            let text = format!("plant = \"{name}\"\n");
            let scene = parse_scene("s.toml", text.as_bytes()).expect("a good scene");
            assert_eq!(scene.plant, Some(plant));
        }
        let wrong = "s.toml:1:9: error: TIP_ERR:Wrong scene (RobotError)";
        assert_eq!(reported("plant = \"rigid\"\n"), [wrong]);
    }

    #[test]
    fn every_fault_is_reported_at_its_location() {
        let wrong = "s.toml:LINE: error: TIP_ERR:Wrong scene (RobotError)";
        let at = |lines: &[&str]| -> Vec<String> {
            lines
                .iter()
                .map(|line| wrong.replace("LINE", line))
                .collect()
        };
        assert_eq!(reported("[floor\n"), at(&["1:7"]));
        let text = "[floor]\nhight = 1\nfriction = -1\n[[object]]\nmass = 1\n\
            [[object]]\nsize = [1, 40]\nmass = 1\n[[object]]\nradius = 20\nmass = 0.0009\n\
            [[object]]\nradius = 20\nsize = [1, 1]\nmass = 1\n[[object]]\nradius = \"big\"\n";
        let lines = ["2:1", "3:12", "4:1", "7:8", "11:8", "12:1", "16:1", "17:10"];
        assert_eq!(reported(text), at(&lines));
        let five = "[[object]]\nradius = 20\nmass = 1\n".repeat(5);
        assert_eq!(reported(&five), at(&["13:1"]));
    }
}
