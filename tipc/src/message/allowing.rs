//! What is said of comments that silence warnings.

use smol_str::SmolStr;

messages! {
    /// What is said of comments that silence warnings.
    Allowing;

    NoList
        "this comment names no warnings",
        "このコメントには警告のコードがありません";
    WriteList
        "write the codes of warnings in parentheses, as `// tip: allow(W101, W102)`",
        "`// tip: allow(W101, W102)` のように、警告のコードを括弧の中に書いてください";
    NoCode { name: SmolStr }
        "no warning has the code `{name}`",
        "`{name}` というコードの警告はありません";
    Error { code: &'static str }
        "{code} is an error, and errors stay",
        "{code}はエラーです。エラーは消せません";
    SilencesNothing
        "nothing here has this warning",
        "ここにこの警告はありません";
    TakeOut
        "take the code out",
        "このコードを削除してください";
}
