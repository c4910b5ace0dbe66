//! Titles of fixes.

use super::Diagnostics;
use smol_str::SmolStr;

tipc::message_table! {
    /// The titles of fixes, and what is said of them.
    Fixing;

    Replace { old: SmolStr, new: SmolStr }
        "replace `{old}` with `{new}`",
        "`{old}` を `{new}` に直す";
    Insert { text: SmolStr }
        "insert `{text}`",
        "`{text}` を入れる";
    Remove { text: SmolStr }
        "remove `{text}`",
        "`{text}` を取る";
    RemoveInvisible
        "delete the invisible character",
        "見えない文字を消す";
    RemoveBlanks
        "remove the blanks",
        "空白を取る";
    RemoveParentheses
        "leave the parentheses out",
        "括弧を取る";
    RemoveDeclaration { name: SmolStr }
        "remove the declaration of `{name}`",
        "`{name}` の宣言を消す";
    HalfWidth
        "write it in half-width characters",
        "半角文字で書く";
    Comment
        "make it a comment with `//`",
        "`//` のコメントにする";
    TitleLine
        "put an empty title line before it",
        "その前に空の題名の行を入れる";
    OwnLine { name: SmolStr }
        "assign `{name}` on a line of its own",
        "`{name}` への代入を別の行に書く";
    OwnLines
        "put each statement on a line of its own",
        "文を1行に1つずつ書く";
    Block
        "make a block of it, with its statement on a line of its own",
        "文を別の行に書いて、ブロックにする";
    Show
        "show the text with MESSAGE, without quotes",
        "引用符を取り、MESSAGEで表示する";

    // What `check` says of them.
    Fixed { diagnostics: Diagnostics }
        "fixed {diagnostics}",
        "{diagnostics}を直しました";
    CanFix { diagnostics: Diagnostics }
        "`tip check --fix` fixes {diagnostics}",
        "`tip check --fix` で{diagnostics}を直せます";
    CanFixMore { diagnostics: Diagnostics, all: usize }
        "`tip check --fix` fixes {diagnostics}, with `--unsafe-fixes` {all}: review what it writes",
        "`tip check --fix` で{diagnostics}、`--unsafe-fixes` も付けると{all}件を直せます。結果を確かめてください";
    CanFixLikely { diagnostics: Diagnostics }
        "`tip check --fix --unsafe-fixes` fixes {diagnostics}: review what it writes",
        "`tip check --fix --unsafe-fixes` で{diagnostics}を直せます。結果を確かめてください";
}
