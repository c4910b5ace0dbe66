//! Inputs, keys, messages and lamps (T.I.P. 3.1 §7-9).

use super::{Arguments, Command, Form, Limit, Meaning, Robots, Targets, Values, outcome};
use crate::language::Keyword;
use tip_runtime::command::Op;

pub(super) const ROWS: &[Command] = &[
    Command::new("AD_IN", Meaning::AdIn)
        .place("§7-9-1", "7.32")
        .does("Reads an input into a VAR.", "入力をVARに読み込みます。")
        .form(Form::AdIn)
        .unit("V")
        .fails(outcome::INPUT),
    Command::new("KEY_IN", Meaning::KeyIn)
        .place("§7-9-2", "7.33")
        .does("Waits for a key and stores its upper-case code in the VAR, or in VAR_KEY; empties the buffer.", "キーが押されるまで待ち、その大文字のコードをVAR(省略するとVAR_KEY)に入れて、バッファを空にします。")
        .form(Form::KeyIn)
        .until("a key is in the buffer", "バッファにキーが入る"),
    Command::robot(Op::FlushBuf)
        .place("§7-9-3", "7.34")
        .does("Empties the keyboard buffer.", "キーボードのバッファを空にします。"),
    Command::keyword(Keyword::Message)
        .words("[text]")
        .fails(outcome::READS),
    Command::new("MESSAGE_CLEAR", Meaning::MessageClear)
        .place("§7-9-5", "7.34")
        .does("Clears the message line.", "メッセージ行を消します。"),
    Command::keyword(Keyword::FileMessage)
        .words("[text]")
        .fails(outcome::READS),
    Command::robot(Op::LampOn)
        .place("§7-9-6", "7.36")
        .does("Switches a lamp or relay on.", "ランプまたはリレーをオンにします。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Lamp)),
    Command::robot(Op::LampOff)
        .place("§7-9-7", "7.36")
        .does("Switches a lamp or relay off.", "ランプまたはリレーをオフにします。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Lamp)),
    Command::robot(Op::SilentOn)
        .place("§7-9-8", "7.37")
        .does("Shows as little as possible on the screen.", "画面の表示を最小限にします。")
        .only(Robots::LATER),
    Command::robot(Op::SilentOff)
        .place("§7-9-9", "7.37")
        .does("Shows everything again.", "画面の表示を元に戻します。")
        .only(Robots::LATER),
];
