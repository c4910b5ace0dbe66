//! Geometries: their shapes, poses, masses and inertias.

use super::super::ImportError;
use super::super::transform::{Transform, point_tensor};
use super::super::tree::Geometry;
use super::elements::Merged;
use super::{Compiler, unit, upright};
use crate::message::Importing;
use std::f64::consts::PI;

/// Density of a geometry that states none, kg/m³.
const DENSITY: f64 = 1000.0;
/// The geometries that are primitives, then the others.
const TYPES: [&str; 9] = [
    "sphere",
    "capsule",
    "cylinder",
    "box",
    "ellipsoid",
    "mesh",
    "plane",
    "hfield",
    "sdf",
];

/// A geometry in the frame of its body.
#[derive(Clone, Debug)]
pub(super) struct Geom {
    pub(super) shape: Shape,
    pub(super) pose: Transform,
    /// True if it can touch others.
    pub(super) collides: bool,
    pub(super) class: usize,
    /// Mass, kg; `None` for a mesh without a stated mass.
    pub(super) mass: Option<f64>,
    /// True if its group counts for inertias.
    pub(super) has_weight: bool,
}

/// A primitive with its sizes (m), or another geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    Sphere {
        radius: f64,
    },
    /// The half length is that of the cylinder.
    Capsule {
        radius: f64,
        half: f64,
    },
    Cylinder {
        radius: f64,
        half: f64,
    },
    /// Half sides.
    Box([f64; 3]),
    /// Half axes.
    Ellipsoid([f64; 3]),
    Other,
}

impl Geom {
    /// Reads a geometry in a frame of its body.
    pub(super) fn read(
        of: &Merged<'_, '_>,
        compiler: &Compiler,
        frame: &Transform,
    ) -> Result<Self, ImportError> {
        // A mesh in a class makes a mesh of a geometry whose type is left open.
        let kind = match (of.word("type", &TYPES)?, of.attribute("mesh")) {
            (_, Some(_)) => "mesh",
            (kind, None) => kind.map_or(TYPES[0], |index| TYPES[index]),
        };
        let mut pose = compiler.pose(of)?;
        let sizes = match kind {
            "sphere" => 1,
            "capsule" | "cylinder" => 2,
            "box" | "ellipsoid" => 3,
            _ => 0,
        };
        let is_long = sizes > 1;
        let ends = match is_long {
            true => of.vector::<6>("fromto", "0 0 0 0 0 -0.2")?,
            false => None,
        };
        // The length is that between the ends.
        let least = if ends.is_some() { 1 } else { sizes };
        let mut size = match sizes {
            0 => Vec::new(),
            _ => of
                .numbers("size", least, 3, "0.02 0.1 0.1")?
                .ok_or_else(|| {
                    ImportError::new(Importing::NoAttribute {
                        at: of.files.place(of.element.at),
                        element: of.element.name.clone(),
                        attribute: "size",
                        example: "0.02 0.1 0.1",
                    })
                })?,
        };
        if let Some([a, b, c, d, e, f]) = ends {
            let [from, to] = [[a, b, c], [d, e, f]];
            let along = [0, 1, 2].map(|i| to[i] - from[i]);
            let half = along.iter().map(|part| part * part).sum::<f64>().sqrt() / 2.0;
            let turn = unit(along).map(upright).unwrap_or_default();
            pose = turn.moved([0, 1, 2].map(|i| (from[i] + to[i]) / 2.0));
            let radius = size.first().copied().unwrap_or_default();
            size = match kind {
                "capsule" | "cylinder" => vec![radius, half],
                _ => vec![radius, radius, half],
            };
        }
        if size.iter().take(sizes).any(|size| *size < 0.0) {
            return Err(ImportError::new(Importing::NegativeSize {
                at: of.place("size"),
                element: of.element.name.clone(),
                attribute: "size",
            }));
        }
        let shape = match (kind, size.as_slice()) {
            ("sphere", [radius, ..]) => Shape::Sphere { radius: *radius },
            ("capsule", [radius, half, ..]) => Shape::Capsule {
                radius: *radius,
                half: *half,
            },
            ("cylinder", [radius, half, ..]) => Shape::Cylinder {
                radius: *radius,
                half: *half,
            },
            ("box", [x, y, z]) => Shape::Box([*x, *y, *z]),
            ("ellipsoid", [x, y, z]) => Shape::Ellipsoid([*x, *y, *z]),
            _ => Shape::Other,
        };
        let bits = |name, example| -> Result<bool, ImportError> {
            Ok(of.number(name, example)?.is_none_or(|bits| bits != 0.0))
        };
        let collides = bits("contype", "1")? | bits("conaffinity", "1")?;
        let group = of.number("group", "0")?.unwrap_or_default();
        let [first, last] = compiler.inertia_groups;
        let density = of.number("density", "1000")?.unwrap_or(DENSITY);
        let stated = of.number("mass", "0.1")?;
        for (name, value) in [("mass", stated), ("density", Some(density))] {
            if value.is_some_and(|value| value < 0.0) {
                return Err(ImportError::new(Importing::NegativeSize {
                    at: of.place(name),
                    element: of.element.name.clone(),
                    attribute: name,
                }));
            }
        }
        let mass = match (stated, shape) {
            (Some(mass), _) => Some(mass),
            (None, Shape::Other) if density > 0.0 => None,
            (None, _) => Some(density * shape.volume()),
        };
        Ok(Geom {
            shape,
            pose: frame.then(&pose),
            collides,
            class: of.class,
            mass,
            has_weight: (first..=last).contains(&group),
        })
    }

    /// Returns the geometry as a description can have it.
    pub(super) fn geometry(&self) -> Geometry {
        match self.shape {
            Shape::Sphere { radius } => Geometry::Sphere { radius },
            Shape::Capsule { radius, half } => Geometry::Capsule {
                radius,
                length: 2.0 * half,
            },
            Shape::Cylinder { radius, half } => Geometry::Cylinder {
                radius,
                length: 2.0 * half,
            },
            Shape::Box(half) => Geometry::Box(half.map(|half| 2.0 * half)),
            Shape::Ellipsoid(_) | Shape::Other => Geometry::Mesh,
        }
    }
}

impl Shape {
    /// Returns the volume, m³.
    fn volume(&self) -> f64 {
        let ball = |[x, y, z]: [f64; 3]| 4.0 / 3.0 * PI * x * y * z;
        match *self {
            Shape::Sphere { radius } => ball([radius; 3]),
            Shape::Capsule { radius, half } => {
                ball([radius; 3]) + PI * radius * radius * 2.0 * half
            }
            Shape::Cylinder { radius, half } => PI * radius * radius * 2.0 * half,
            Shape::Box([x, y, z]) => 8.0 * x * y * z,
            Shape::Ellipsoid(half) => ball(half),
            Shape::Other => 0.0,
        }
    }

    /// Returns the principal moments of inertia for a mass, kg·m².
    fn moments(&self, mass: f64) -> [f64; 3] {
        let pairs = |[x, y, z]: [f64; 3]| [y + z, x + z, x + y].map(|sum| mass * sum);
        match *self {
            Shape::Sphere { radius } => [0.4 * mass * radius * radius; 3],
            Shape::Cylinder { radius, half } => {
                let across = mass * (3.0 * radius * radius + 4.0 * half * half) / 12.0;
                [across, across, mass * radius * radius / 2.0]
            }
            Shape::Capsule { radius, half } => {
                let (r, h) = (radius, 2.0 * half);
                let volume = self.volume();
                let share = if volume > 0.0 {
                    4.0 / 3.0 * PI * r * r * r / volume
                } else {
                    0.0
                };
                let (caps, rod) = (mass * share, mass * (1.0 - share));
                let across = rod * (3.0 * r * r + h * h) / 12.0
                    + caps * (0.4 * r * r + 0.375 * r * h + 0.25 * h * h);
                [across, across, rod * r * r / 2.0 + caps * 0.4 * r * r]
            }
            Shape::Box(half) => pairs(half.map(|half| half * half / 3.0)),
            Shape::Ellipsoid(half) => pairs(half.map(|half| half * half / 5.0)),
            Shape::Other => [0.0; 3],
        }
    }
}

/// Returns mass, centre (m) and tensor about it (kg·m², along the axes of the body) of geometries.
pub(super) fn inertia(geoms: &[Geom]) -> (f64, [f64; 3], [f64; 6]) {
    let heavy = || {
        let weights = geoms.iter().filter(|geom| geom.has_weight);
        weights.filter_map(|geom| Some((geom, geom.mass.filter(|mass| *mass > 0.0)?)))
    };
    let mass: f64 = heavy().map(|(_, mass)| mass).sum();
    if mass <= 0.0 {
        return (0.0, [0.0; 3], [0.0; 6]);
    }
    let centre = heavy().fold([0.0; 3], |sum, (geom, own)| {
        [0, 1, 2].map(|i| sum[i] + own / mass * geom.pose.at[i])
    });
    let tensor = heavy().fold([0.0; 6], |sum, (geom, own)| {
        let [xx, yy, zz] = geom.shape.moments(own);
        let turned = geom.pose.tensor([xx, yy, zz, 0.0, 0.0, 0.0]);
        let away = [0, 1, 2].map(|i| geom.pose.at[i] - centre[i]);
        let moved = point_tensor(own, away);
        std::array::from_fn(|i| sum[i] + turned[i] + moved[i])
    });
    (mass, centre, tensor)
}
