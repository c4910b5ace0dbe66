//! So many of something, as an argument of messages.

counted! {
    /// So many errors.
    Errors: "1 error", "エラー1件"; "{count} errors", "エラー{count}件";
}

counted! {
    /// So many warnings.
    Warnings: "1 warning", "警告1件"; "{count} warnings", "警告{count}件";
}

counted! {
    /// So many steps.
    Steps: "1 step", "1ステップ"; "{count} steps", "{count}ステップ";
}

counted! {
    /// So many control cycles.
    Cycles: "1 cycle", "1周期"; "{count} cycles", "{count}周期";
}

counted! {
    /// So many files.
    Files: "1 file", "1ファイル"; "{count} files", "{count}ファイル";
}

counted! {
    /// What is not shown.
    More: "... and 1 more finding", "……ほかに1件あります"; "... and {count} more findings", "……ほかに{count}件あります";
}

/// The rows of every table.
#[cfg(test)]
pub(crate) const COUNTS: &[&[crate::message::tests::Row]] = &[
    Errors::ROWS,
    Warnings::ROWS,
    Steps::ROWS,
    Cycles::ROWS,
    Files::ROWS,
    More::ROWS,
];
