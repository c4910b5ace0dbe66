//! The messages of this crate, and the parts of them that vary.
//!
//! ```
//! use tip_lint::message::Changes;
//!
//! assert_eq!(Changes::from(2).to_string(), "2 changes");
//! ```

use tipc::message::list::List;

mod fixing;
mod foreign;
mod linting;
mod migrating;

pub use fixing::Fixing;
pub use foreign::Foreign;
pub use linting::{Allowing, Lack, Linting, Stretch};
pub use migrating::Migrating;

tipc::count_table! {
    /// A number of changes of a program.
    Changes: "1 change", "変更1か所"; "{count} changes", "変更{count}か所";
}

tipc::count_table! {
    /// A number of questions about a program.
    Questions: "1 question", "質問1件"; "{count} questions", "質問{count}件";
}

tipc::count_table! {
    /// A number of diagnostics.
    Diagnostics: "1 finding", "1件"; "{count} findings", "{count}件";
}

tipc::count_table! {
    /// A number of diagnostics beyond those that are reported.
    More: "... and 1 more finding", "……ほかに1件あります"; "... and {count} more findings", "……ほかに{count}件あります";
}

tipc::message_table! {
    /// The robots that a migrated program loads for.
    Loads;

    ForNone "loads for no robot yet; `tip check` on the new program says why", "まだどのロボットでも読み込めません。新しいプログラムを`tip check`にかけると理由が分かります";
    For { robots: List } "loads for {robots}", "{robots}で読み込めます";
}

tipc::message_table! {
    /// Reason for an added declaration.
    Declared;

    OneType ": variables are declared since 3.0, AGL and TRQ as one type", "(3.0から変数は宣言が必要です。AGLとTRQは一つの型になりました)";
    Plainly ": variables are declared since 3.0", "(3.0から変数は宣言が必要です)";
}

tipc::message_table! {
    /// Messages of the formatter.
    Formatting;

    DoesNotLoad
        "left as it is: a program with errors cannot be formatted",
        "そのままにしました。エラーのあるプログラムは整形できません";
    LineTooLong { line: u32, limit: usize }
        "left as it is: line {line} would be longer than {limit} bytes; break it in two",
        "そのままにしました。整形すると{line}行目が{limit}バイトを超えます。2行に分けてください";
    OtherEncoding { encoding: &'static str }
        "left as it is: without its full-width blanks the file would be read as {encoding}; name its encoding",
        "そのままにしました。全角の空白がなくなると{encoding}として読まれます。文字コードを指定してください";
    OtherProgram
        "left as it is: formatted, it would be another program; this is a defect of tip, please report it",
        "そのままにしました。整形すると別のプログラムになってしまいます。tipの不具合ですので報告してください";
}
