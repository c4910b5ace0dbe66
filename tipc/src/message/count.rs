//! So many of something, as an argument of messages.

messages! {
    /// So many errors.
    Errors;

    One "1 error", "エラー1件";
    Several { count: usize } "{count} errors", "エラー{count}件";
}

impl From<usize> for Errors {
    fn from(count: usize) -> Self {
        match count {
            1 => Errors::One,
            count => Errors::Several { count },
        }
    }
}

messages! {
    /// So many warnings.
    Warnings;

    One "1 warning", "警告1件";
    Several { count: usize } "{count} warnings", "警告{count}件";
}

impl From<usize> for Warnings {
    fn from(count: usize) -> Self {
        match count {
            1 => Warnings::One,
            count => Warnings::Several { count },
        }
    }
}

messages! {
    /// So many steps.
    Steps;

    One "1 step", "1ステップ";
    Several { count: usize } "{count} steps", "{count}ステップ";
}

impl From<usize> for Steps {
    fn from(count: usize) -> Self {
        match count {
            1 => Steps::One,
            count => Steps::Several { count },
        }
    }
}

messages! {
    /// So many control cycles.
    Cycles;

    One "1 cycle", "1周期";
    Several { count: usize } "{count} cycles", "{count}周期";
}

impl From<usize> for Cycles {
    fn from(count: usize) -> Self {
        match count {
            1 => Cycles::One,
            count => Cycles::Several { count },
        }
    }
}

messages! {
    /// So many files.
    Files;

    One "1 file", "1ファイル";
    Several { count: usize } "{count} files", "{count}ファイル";
}

impl From<usize> for Files {
    fn from(count: usize) -> Self {
        match count {
            1 => Files::One,
            count => Files::Several { count },
        }
    }
}

messages! {
    /// What is not shown.
    More;

    One "... and 1 more finding", "……ほかに1件あります";
    Several { count: usize } "... and {count} more findings", "……ほかに{count}件あります";
}

impl From<usize> for More {
    fn from(count: usize) -> Self {
        match count {
            1 => More::One,
            count => More::Several { count },
        }
    }
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
