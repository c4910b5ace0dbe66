//! So many of something, as an argument of messages.

tipc::count_table! {
    /// So many errors.
    Errors: "1 error", "エラー1件"; "{count} errors", "エラー{count}件";
}

tipc::count_table! {
    /// So many warnings.
    Warnings: "1 warning", "警告1件"; "{count} warnings", "警告{count}件";
}

tipc::count_table! {
    /// So many steps.
    Steps: "1 step", "1ステップ"; "{count} steps", "{count}ステップ";
}

tipc::count_table! {
    /// So many control cycles.
    Cycles: "1 cycle", "1周期"; "{count} cycles", "{count}周期";
}

tipc::count_table! {
    /// So many files.
    Files: "1 file", "1ファイル"; "{count} files", "{count}ファイル";
}
