//! The targets of commands.

use super::UnknownWord;
use core::fmt;
use core::str::FromStr;

/// The target of a command. Legs and joints count from 1, as in the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// No target.
    None,
    /// `ALL`.
    All,
    /// `FLOOR`: the slider of the Hiroshima Hand.
    Floor,
    /// `Fn`: a foot or finger.
    Foot(u8),
    /// `Jnm`: joint m of leg n.
    Joint(u8, u8),
}

impl Target {
    /// Returns the target's word, or its prefix: digits follow `F` and `J`.
    pub const fn stem(self) -> &'static str {
        match self {
            Target::None => "",
            Target::All => "ALL",
            Target::Floor => "FLOOR",
            Target::Foot(_) => "F",
            Target::Joint(..) => "J",
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.stem())?;
        match self {
            Target::None | Target::All | Target::Floor => Ok(()),
            Target::Foot(leg) => write!(f, "{leg}"),
            Target::Joint(leg, joint) => write!(f, "{leg}{joint}"),
        }
    }
}

impl FromStr for Target {
    type Err = UnknownWord;

    /// Parses a name in capital letters, of any leg and joint that the language can name.
    fn from_str(word: &str) -> Result<Self, UnknownWord> {
        let digits = |of: Target| word.strip_prefix(of.stem()).map(str::as_bytes);
        match (digits(Target::Foot(1)), digits(Target::Joint(1, 1))) {
            (Some([leg @ b'1'..=b'9']), _) => Ok(Target::Foot(leg - b'0')),
            (_, Some([leg @ b'1'..=b'9', joint @ b'1'..=b'9'])) => {
                Ok(Target::Joint(leg - b'0', joint - b'0'))
            }
            _ => [Target::All, Target::Floor]
                .into_iter()
                .find(|target| target.stem() == word)
                .ok_or(UnknownWord),
        }
    }
}
