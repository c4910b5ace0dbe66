//! Versions of URDF.

/// What the attribute `version` of the robot says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Version {
    major: u32,
    minor: u32,
}

impl Version {
    pub(super) const V1_0: Self = Version { major: 1, minor: 0 };
    /// Brings `quat_xyzw` of `<origin>`.
    pub(super) const V1_1: Self = Version { major: 1, minor: 1 };
    /// What `<limit>` leaves out is without limit, and numbers have to be possible.
    pub(super) const V1_2: Self = Version { major: 1, minor: 2 };

    /// A version that is missing or malformed is 1.0, as urdfdom has it.
    pub(super) fn from_attribute(text: Option<&str>) -> Self {
        text.and_then(Version::parse).unwrap_or(Version::V1_0)
    }

    /// Whether it is one of those that there are.
    pub(super) fn is_known(text: &str) -> bool {
        let known = [Version::V1_0, Version::V1_1, Version::V1_2];
        Version::parse(text).is_some_and(|version| known.contains(&version))
    }

    /// The version whose rules hold for it.
    pub(super) fn read_as(self) -> &'static str {
        match self {
            later if later >= Version::V1_2 => "1.2",
            Version::V1_1 => "1.1",
            _ => "1.0",
        }
    }

    fn parse(text: &str) -> Option<Self> {
        let (major, minor) = text.trim().split_once('.')?;
        Some(Version {
            major: major.parse().ok()?,
            minor: minor.parse().ok()?,
        })
    }
}
