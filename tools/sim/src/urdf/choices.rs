//! What is chosen about the chains of a file: which are legs, in which order, and where they end.

use super::ImportError;
use super::foot::Foot;
use super::pose::{Pose, Up};
use super::robot::Joint;
use super::tree::Tree;
use super::values::printed;
use crate::message::Importing;
use tipc::message::list::List;

/// What is chosen where a file leaves it open. A chain is named by one of its joints or links, or by words that only the name of
/// its first joint has: `FL` is the chain of `FL_hip_joint`.
///
/// ```
/// use tip_sim::urdf::{Choices, import_with};
///
/// let text = tip_sim::urdf::export(&tip_sim::Robot::named("titan8")?);
/// let order = ["F2", "F1", "F4", "F3"].map(String::from).to_vec();
/// let import = import_with("titan8.urdf", &text, &Choices { order, ..Choices::default() })?;
/// assert!(import.toml.contains("F1: joint J21 to link F2"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Choices {
    /// Feet that are not the last links of their chains, or not where those have their frames.
    pub feet: Vec<Foot>,
    /// Chains that are no legs.
    pub skip: Vec<String>,
    /// The chains that become F1, F2, …; empty for an order by place, from front to rear and left before right.
    pub order: Vec<String>,
    /// Which axis of the file is up; z if nothing is said, and then a robot that lies on its side is refused.
    pub up: Option<Up>,
    /// How far the initial posture of a robot that walks has its feet below the robot frame: mm.
    pub stand: Option<f64>,
}

/// The first joint of a chain, and the pose of its frame.
type First<'a> = (&'a Joint, Pose);

impl Choices {
    /// The first joints of the legs in their order, and what is to be said of the others.
    pub(super) fn legs<'a>(
        &self,
        tree: &Tree<'a>,
        firsts: Vec<First<'a>>,
    ) -> Result<(Vec<First<'a>>, Option<Importing>), ImportError> {
        let skipped = all(tree, &firsts, &self.skip)?;
        let names = |indices: &[usize]| {
            let joints = indices.iter().filter_map(|index| firsts.get(*index));
            List(joints.map(|(joint, _)| printed(&joint.name)).collect())
        };
        let kept: Vec<usize> = (0..firsts.len())
            .filter(|index| !skipped.contains(index))
            .collect();
        if kept.is_empty() {
            let chains = names(&skipped);
            return Err(ImportError::new(Importing::AllLeftOut { chains }));
        }
        let ordered = match self.order.is_empty() {
            true => kept,
            false => self.ordered(tree, &firsts, &kept, names)?,
        };
        let left_out = (!skipped.is_empty()).then(|| Importing::LeftOut {
            chains: names(&skipped),
        });
        let legs = ordered.iter().filter_map(|index| firsts.get(*index));
        Ok((legs.copied().collect(), left_out))
    }

    /// The legs that are kept, each named once.
    fn ordered(
        &self,
        tree: &Tree<'_>,
        firsts: &[First<'_>],
        kept: &[usize],
        names: impl Fn(&[usize]) -> List,
    ) -> Result<Vec<usize>, ImportError> {
        let mut ordered = all(tree, firsts, &self.order)?;
        ordered.retain(|index| kept.contains(index));
        let lacking: Vec<usize> = kept
            .iter()
            .copied()
            .filter(|index| !ordered.contains(index))
            .collect();
        match lacking.as_slice() {
            [] => Ok(ordered),
            lacking => Err(ImportError::new(Importing::NotInOrder {
                chains: names(lacking),
            })),
        }
    }
}

/// The chains that words name, each once.
fn all(tree: &Tree<'_>, firsts: &[First<'_>], words: &[String]) -> Result<Vec<usize>, ImportError> {
    let mut found = Vec::new();
    for word in words {
        let index = one(tree, firsts, word)?;
        if found.contains(&index) {
            return Err(ImportError::new(Importing::ChainTwice {
                word: printed(word),
                chain: printed(&firsts[index].0.name),
            }));
        }
        found.push(index);
    }
    Ok(found)
}

/// The chain that a word names.
fn one(tree: &Tree<'_>, firsts: &[First<'_>], word: &str) -> Result<usize, ImportError> {
    let those = |is: &dyn Fn(&Joint) -> bool| -> Vec<usize> {
        let indices = 0..firsts.len();
        indices.filter(|index| is(firsts[*index].0)).collect()
    };
    let names = |indices: &[usize]| {
        let names = indices.iter().map(|index| printed(&firsts[*index].0.name));
        List(names.collect())
    };
    let whole = those(&|joint| tree.names_after(joint).contains(&word));
    let found = match whole.is_empty() {
        true => those(&|joint| has_words(&joint.name, word)),
        false => whole,
    };
    let word = printed(word);
    match found.as_slice() {
        [index] => Ok(*index),
        [] => Err(ImportError::new(Importing::NoChain {
            word,
            chains: names(&those(&|_| true)),
        })),
        several => Err(ImportError::new(Importing::SeveralChains {
            word,
            chains: names(several),
        })),
    }
}

/// Whether a name has these words in a row, whatever stands between words: `front_left` is in `front_left_hip`.
fn has_words(name: &str, words: &str) -> bool {
    let parts = |text: &str| -> Vec<String> {
        let parts = text.split(|c: char| !c.is_alphanumeric());
        parts
            .filter(|part| !part.is_empty())
            .map(str::to_lowercase)
            .collect()
    };
    let (name, words) = (parts(name), parts(words));
    !words.is_empty() && name.windows(words.len()).any(|some| some == words)
}
