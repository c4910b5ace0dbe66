//! Where a leg ends, as it is named.

use std::fmt;

/// A place on a link.
///
/// ```
/// use tip_sim::urdf::Foot;
///
/// assert_eq!(Foot::from("toe").to_string(), "toe");
/// let tip = Foot { link: "shank".to_owned(), at: [0.0, 0.0, -0.13] };
/// assert_eq!(tip.to_string(), "shank=0,0,-0.13");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Foot {
    /// The link.
    pub link: String,
    /// Where it is in the frame of the link: m.
    pub at: [f64; 3],
}

/// Where the frame of a link is.
impl From<&str> for Foot {
    fn from(link: &str) -> Self {
        Foot {
            link: link.to_owned(),
            at: [0.0; 3],
        }
    }
}

impl fmt::Display for Foot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Foot { link, at } = self;
        match at {
            [0.0, 0.0, 0.0] => f.write_str(link),
            [x, y, z] => write!(f, "{link}={x},{y},{z}"),
        }
    }
}
