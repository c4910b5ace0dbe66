//! `--foot`: links that end legs, and places on them.

use crate::message::Using;
use crate::usage::Wrong;
use tip_sim::urdf::Foot;

/// What stands after one `--foot`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Feet(pub(super) Vec<Foot>);

/// Feet with commas between them: each a link, or `LINK=X,Y,Z`.
pub(super) fn feet(text: &str) -> Result<Feet, Wrong> {
    let wrong = || {
        Wrong(Using::NotAFoot {
            text: text.to_owned(),
        })
    };
    let mut words = text.split(',');
    let mut feet = Vec::new();
    while let Some(word) = words.next() {
        let foot = match word.split_once('=') {
            None => Some(Foot::from(word)),
            Some((link, x)) => place([Some(x), words.next(), words.next()]).map(|at| Foot {
                link: link.to_owned(),
                at,
            }),
        };
        feet.push(
            foot.filter(|foot| !foot.link.is_empty())
                .ok_or_else(wrong)?,
        );
    }
    Ok(Feet(feet))
}

/// Three finite numbers.
fn place(words: [Option<&str>; 3]) -> Option<[f64; 3]> {
    let mut at = [0.0; 3];
    for (place, word) in at.iter_mut().zip(words) {
        *place = word?
            .trim()
            .parse()
            .ok()
            .filter(|it: &f64| it.is_finite())?;
    }
    Some(at)
}

#[cfg(test)]
mod tests {
    use super::feet;
    use tip_sim::urdf::Foot;

    #[test]
    fn links_and_places_on_them_stand_side_by_side() {
        let foot = |link: &str, at| Foot {
            link: link.to_owned(),
            at,
        };
        let read = |text: &str| feet(text).ok().map(|feet| feet.0);
        assert_eq!(read("toe"), Some(vec![foot("toe", [0.0; 3])]));
        assert_eq!(
            read("l=0.1,-2e-3,0,r,m=1, 2 ,3"),
            Some(vec![
                foot("l", [0.1, -0.002, 0.0]),
                foot("r", [0.0; 3]),
                foot("m", [1.0, 2.0, 3.0]),
            ])
        );
        for wrong in [
            "",
            "toe,",
            "l=",
            "l=1",
            "l=1,2",
            "l=1,2,r",
            "l=1,2,inf",
            "=1,2,3",
        ] {
            assert_eq!(read(wrong), None, "{wrong}");
        }
    }
}
