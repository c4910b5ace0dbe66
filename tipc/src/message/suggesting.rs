//! What was meant by a word that is unknown.

use smol_str::SmolStr;

messages! {
    /// What a suggestion says.
    Suggesting;

    DidYouMean { near: SmolStr }
        "did you mean `{near}`?",
        "`{near}` の間違いではありませんか?";
}
