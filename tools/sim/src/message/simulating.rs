//! Messages on a plant that another process simulates.

use tipc::message::Text;

tipc::message_table! {
    /// Messages on a plant that another process simulates.
    Simulating;

    CannotStart { program: Text, reason: Text }
        "the external plant '{program}' does not start: {reason}",
        "外部プラント '{program}' を起動できません: {reason}";
    NoAnswer { to: Text, seconds: Text }
        "the external plant has not answered '{to}' within {seconds} s",
        "外部プラントが '{to}' に{seconds}秒以内に応答しませんでした";
    Exited { to: Text, status: Text }
        "the external plant ended with exit status {status} before it answered '{to}'",
        "外部プラントが '{to}' に応答する前に終了コード{status}で終了しました";
    Killed { to: Text }
        "the external plant was ended by a signal before it answered '{to}'",
        "外部プラントが '{to}' に応答する前にシグナルで終了しました";
    Closed { to: Text }
        "the external plant closed its standard output before it answered '{to}'",
        "外部プラントが '{to}' に応答する前に標準出力を閉じました";
    TooLong { to: Text, bytes: Text }
        "the external plant's answer to '{to}' has more than {bytes} bytes",
        "'{to}' への外部プラントの応答が{bytes}バイトを超えています";
    NotText { to: Text }
        "the external plant's answer to '{to}' is not UTF-8",
        "'{to}' への外部プラントの応答がUTF-8ではありません";
    NotAnswer { to: Text, line: String, begins: &'static str }
        "the external plant's answer to '{to}' is '{line}'; it has to begin with '{begins}'",
        "'{to}' への外部プラントの応答が '{line}' です。'{begins}' で始めてください";
    UnknownWord { to: Text, word: String }
        "the external plant's answer to '{to}': '{word}' is not KEY=VALUES with a key of this answer",
        "'{to}' への外部プラントの応答: '{word}' はこの応答で使えるキーの KEY=VALUES ではありません";
    Twice { to: Text, key: &'static str }
        "the external plant's answer to '{to}' has '{key}' twice",
        "'{to}' への外部プラントの応答に '{key}' が2回あります";
    Missing { to: Text, key: &'static str }
        "the external plant's answer to '{to}' lacks '{key}'",
        "'{to}' への外部プラントの応答に '{key}' がありません";
    OtherVersion { found: String, version: Text }
        "the external plant speaks version '{found}' of the protocol; this is version {version}",
        "外部プラントのプロトコルのバージョンは '{found}' ですが、こちらはバージョン{version}です";
    OtherCycle { to: Text, found: String }
        "the external plant answered '{to}' for cycle '{found}'",
        "外部プラントが '{to}' に対してサイクル '{found}' の応答を返しました";
    OtherCount { to: Text, key: &'static str, wanted: Text, found: Text }
        "the external plant's answer to '{to}': '{key}' needs {wanted} numbers, and has {found}",
        "'{to}' への外部プラントの応答: '{key}' に必要な数値は{wanted}個ですが、{found}個あります";
    NotNumber { to: Text, key: &'static str, place: Text, word: String }
        "the external plant's answer to '{to}': '{word}' is not a number ('{key}' of {place})",
        "'{to}' への外部プラントの応答: '{word}' は数値ではありません({place} の '{key}')";
    NotFinite { to: Text, key: &'static str, place: Text }
        "the external plant's answer to '{to}': '{key}' of {place} is not finite",
        "'{to}' への外部プラントの応答: {place} の '{key}' が有限の値ではありません";
    Copy
        "a copy of a run, or one that was taken back, has no external plant",
        "コピーした実行や巻き戻した実行には外部プラントがありません";
}
