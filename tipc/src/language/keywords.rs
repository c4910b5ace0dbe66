//! The words that the parser reads itself: declarations, control words, texts, ends.

use super::{Bilingual, Edition};
use smol_str::{SmolStr, StrExt};
use std::collections::HashMap;
use std::fmt;
use std::sync::LazyLock;

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The keyword.
    pub keyword: Keyword,
    /// Spelling of the word.
    pub word: &'static str,
    /// The first edition that has it.
    pub since: Edition,
    /// The section of T.I.P. that describes it.
    pub section: &'static str,
    /// The clause of the language reference.
    pub clause: &'static str,
    /// One line for the reference.
    pub description: Bilingual,
}

macro_rules! keywords {
    ($( $variant:ident {
        word: $word:literal,
        since: $since:expr,
        section: $section:literal,
        clause: $clause:literal,
        description: $english:literal, $japanese:literal,
    } )*) => {
        /// A word that the parser reads itself.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Keyword {
            $( #[doc = concat!("`", $word, "`: ", $english)] $variant, )*
        }

        /// Every keyword.
        pub const KEYWORDS: &[Row] = &[$( Row {
            keyword: Keyword::$variant,
            word: $word,
            since: $since,
            section: $section,
            clause: $clause,
            description: Bilingual {
                english: $english,
                japanese: $japanese,
            },
        }, )*];
    };
}

keywords! {
    DefVar {
        word: "DEF_VAR",
        since: Edition::V3_1,
        section: "§7-10-1",
        clause: "3.1",
        description: "Declares scalar variables; takes no step.", "スカラー変数を宣言します。ステップにはなりません。",
    }
    DefPos {
        word: "DEF_POS",
        since: Edition::V3_1,
        section: "§7-10-1",
        clause: "3.1",
        description: "Declares positions with members X, Y, Z in mm; takes no step.", "メンバーX、Y、Z(mm)を持つ座標型変数を宣言します。ステップにはなりません。",
    }
    DefJoint {
        word: "DEF_JOINT",
        since: Edition::V3_1,
        section: "§7-10-1",
        clause: "3.1",
        description: "Declares joint variables with one member J1…Jn a joint; takes no step.", "関節ごとにメンバーJ1…Jnを持つ関節型変数を宣言します。ステップにはなりません。",
    }
    If {
        word: "IF",
        since: Edition::V3_1,
        section: "§7-6-1, §7-6-7, §7-6-8",
        clause: "7.20",
        description: "Opens a block, or jumps, if the condition holds.", "条件が成り立つとき、ブロックを実行するか、ジャンプします。",
    }
    Then {
        word: "THEN",
        since: Edition::V3_1,
        section: "§7-6-1",
        clause: "2.6",
        description: "Ends the condition of IF and ELSEIF; the block follows.", "IFとELSEIFの条件の終わりです。次の行からブロックが始まります。",
    }
    ElseIf {
        word: "ELSEIF",
        since: Edition::V3_1,
        section: "§7-6-1",
        clause: "7.20",
        description: "Opens another branch of IF.", "IFの別の分岐を始めます。",
    }
    Else {
        word: "ELSE",
        since: Edition::V3_1,
        section: "§7-6-1",
        clause: "7.20",
        description: "Opens the last branch of IF; alone on its line.", "IFの最後の分岐を始めます。1行に単独で書きます。",
    }
    EndIf {
        word: "ENDIF",
        since: Edition::V3_1,
        section: "§7-6-1",
        clause: "7.20",
        description: "Closes IF; alone on its line.", "IFを閉じます。1行に単独で書きます。",
    }
    While {
        word: "WHILE",
        since: Edition::V3_1,
        section: "§7-6-2",
        clause: "7.20",
        description: "Repeats the block while the condition holds.", "条件が成り立つ間、ブロックを繰り返します。",
    }
    Wend {
        word: "WEND",
        since: Edition::V3_1,
        section: "§7-6-2",
        clause: "7.20",
        description: "Closes WHILE; alone on its line.", "WHILEを閉じます。1行に単独で書きます。",
    }
    Repeat {
        word: "REPEAT",
        since: Edition::V3_1,
        section: "§7-6-3",
        clause: "7.20",
        description: "Opens a block that runs at least once; alone on its line.", "少なくとも1回は実行されるブロックを始めます。1行に単独で書きます。",
    }
    Until {
        word: "UNTIL",
        since: Edition::V3_1,
        section: "§7-6-3",
        clause: "7.20",
        description: "Closes REPEAT, which goes on until the condition holds.", "REPEATを閉じます。条件が成り立つまで繰り返します。",
    }
    For {
        word: "FOR",
        since: Edition::V3_1,
        section: "§7-6-4",
        clause: "7.20",
        description: "Counts a variable through a block.", "変数を数えながらブロックを繰り返します。",
    }
    To {
        word: "TO",
        since: Edition::V3_1,
        section: "§7-6-4",
        clause: "7.20",
        description: "Stands before the last value of FOR.", "FORの終了値の前に書きます。",
    }
    Step {
        word: "STEP",
        since: Edition::V3_1,
        section: "§7-6-4",
        clause: "7.20",
        description: "Stands before the increment of FOR.", "FORの増分の前に書きます。",
    }
    Next {
        word: "NEXT",
        since: Edition::V3_1,
        section: "§7-6-4",
        clause: "7.20",
        description: "Closes FOR.", "FORを閉じます。",
    }
    Subroutine {
        word: "SUBROUTINE",
        since: Edition::V3_1,
        section: "§7-6-5",
        clause: "7.20",
        description: "Opens a subroutine.", "サブルーチンを始めます。",
    }
    SubEnd {
        word: "SUBEND",
        since: Edition::V3_1,
        section: "§7-6-5",
        clause: "7.20",
        description: "Closes SUBROUTINE and returns.", "SUBROUTINEを閉じ、呼び出し元に戻ります。",
    }
    Call {
        word: "CALL",
        since: Edition::V3_1,
        section: "§7-6-6",
        clause: "7.20",
        description: "Calls a SUBROUTINE.", "SUBROUTINEを呼び出します。",
    }
    Goto {
        word: "GOTO",
        since: Edition::V3_1,
        section: "§7-7-1",
        clause: "7.20",
        description: "Jumps to a label; without one to the nearest LOOP above.", "ラベルへジャンプします。省略すると、上にある最も近いLOOPへ飛びます。",
    }
    Gosub {
        word: "GOSUB",
        since: Edition::V3_1,
        section: "§7-7-2",
        clause: "7.20",
        description: "Calls a label or SUBROUTINE.", "ラベルまたはSUBROUTINEを呼び出します。",
    }
    Return {
        word: "RETURN",
        since: Edition::V3_1,
        section: "§7-7-3",
        clause: "7.20",
        description: "Returns to the step after the call.", "呼び出しの次のステップに戻ります。",
    }
    Message {
        word: "MESSAGE",
        since: Edition::V3_1,
        section: "§7-9-4",
        clause: "7.35",
        description: "Shows a line of text with the values of variables.", "変数の値を入れた1行の文字列を表示します。",
    }
    Rem {
        word: "REM",
        since: Edition::V3_1,
        section: "§7-10-2",
        clause: "7.38",
        description: "Does nothing for one cycle.", "1周期の間、何もしません。",
    }
    End {
        word: "END",
        since: Edition::V3_1,
        section: "§7-10-3",
        clause: "7.39",
        description: "Ends the program, and its text.", "プログラムを終了します。プログラムの文面もここまでです。",
    }
    Exit {
        word: "EXIT",
        since: Edition::V3_1,
        section: "§7-10-4",
        clause: "7.39",
        description: "Ends the program.", "プログラムを終了します。",
    }
    Define {
        word: "DEFINE",
        since: Edition::V3_2,
        section: "§1-2-10",
        clause: "13.1",
        description: "Names a constant; takes no step.", "定数に名前を付けます。ステップにはなりません。",
    }
    Thread {
        word: "THREAD",
        since: Edition::V3_2,
        section: "§1-2-9",
        clause: "15.1",
        description: "Opens a thread, which runs besides the main program.", "メインプログラムと並行して動くスレッドを始めます。",
    }
    ThreadEnd {
        word: "THREADEND",
        since: Edition::V3_2,
        section: "§1-2-9",
        clause: "15.1",
        description: "Closes THREAD and ends the thread.", "THREADを閉じ、スレッドを終了します。",
    }
    StartThread {
        word: "START_THREAD",
        since: Edition::V3_2,
        section: "§1-2-9",
        clause: "15.1",
        description: "Starts a thread with the next cycle.", "次の周期からスレッドを動かします。",
    }
    StopThread {
        word: "STOP_THREAD",
        since: Edition::V3_2,
        section: "§1-2-9",
        clause: "15.1",
        description: "Stops a thread with this cycle.", "この周期でスレッドを止めます。",
    }
    WaitThread {
        word: "WAIT_THREAD",
        since: Edition::V3_2,
        section: "§1-2-9",
        clause: "15.1",
        description: "Waits until a thread does not run.", "スレッドが終わるまで待ちます。",
    }
    FileMessage {
        word: "F_MESSAGE",
        since: Edition::V3_2,
        section: "§1-2-4",
        clause: "17.2",
        description: "Appends a text with the values of variables to FOUT.LOG.", "変数の値を入れた文字列をFOUT.LOGに追加します。",
    }
}

impl Keyword {
    /// Returns its row.
    pub const fn row(self) -> &'static Row {
        &KEYWORDS[self as usize]
    }

    /// Returns true if a text follows it instead of operands.
    pub const fn takes_text(self) -> bool {
        matches!(self, Keyword::Message | Keyword::Rem | Keyword::FileMessage)
    }

    /// Returns true if a word is this one, whatever the case.
    pub fn is(self, word: &str) -> bool {
        self.word().eq_ignore_ascii_case(word)
    }

    /// Returns its spelling.
    pub const fn word(self) -> &'static str {
        self.row().word
    }
}

impl fmt::Display for Keyword {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

impl From<Keyword> for SmolStr {
    fn from(keyword: Keyword) -> Self {
        SmolStr::new_static(keyword.word())
    }
}

static INDEX: LazyLock<HashMap<&str, &Row>> =
    LazyLock::new(|| KEYWORDS.iter().map(|row| (row.word, row)).collect());

/// Returns the keyword that an edition writes so, whatever the case.
pub fn find(word: &str, edition: Edition) -> Option<Keyword> {
    let row = INDEX.get(&*word.to_ascii_uppercase_smolstr())?;
    (row.since <= edition).then_some(row.keyword)
}

#[cfg(test)]
mod tests {
    use super::{KEYWORDS, find};
    use crate::language::Edition;

    #[test]
    fn every_keyword_is_found_by_its_word_and_has_the_row_of_its_index() {
        for row in KEYWORDS {
            assert_eq!(row.keyword.row(), row);
            assert_eq!(find(row.word, row.since), Some(row.keyword));
            let small = row.word.to_ascii_lowercase();
            assert_eq!(find(&small, Edition::V3_2), Some(row.keyword));
        }
        assert_eq!(find("PTP", Edition::V3_1), None);
    }

    // clauses: 12.1
    #[test]
    fn an_edition_has_its_own_words_only() {
        for row in KEYWORDS.iter().filter(|row| row.since == Edition::V3_2) {
            assert_eq!(find(row.word, Edition::V3_1), None, "{}", row.word);
        }
        assert!(find("THREAD", Edition::V3_2).is_some());
    }
}
