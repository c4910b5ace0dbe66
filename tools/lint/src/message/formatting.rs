//! What is said of programs that cannot be formatted.

tipc::message_table! {
    /// What the formatter says.
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
