//! What is said where a crate is made.

use tipc::message::Text;

tipc::message_table! {
    /// What becomes of a new crate.
    Making;

    Made { folder: Text, robot: String }
        "made {folder}, a crate for {robot}:",
        "{robot}用のクレート {folder} を作成しました:";
    Next
        "next:",
        "次のコマンド:";
    FolderTaken { folder: Text }
        "`{folder}` is there already: choose another name, or move it away",
        "`{folder}` はすでにあります。別の名前を指定するか、移動してください";
    NoFolder { folder: Text }
        "there is no folder `{folder}`: `mkdir -p {folder}` makes it",
        "フォルダー `{folder}` がありません。`mkdir -p {folder}` で作成できます";
    NotMade { folder: Text, error: Text, name: String }
        "`{folder}` cannot be made: {error}; name a folder that you may write to, as `tipc new ~/{name}` does",
        "`{folder}` を作成できません: {error}。`tipc new ~/{name}` のように、書き込めるフォルダーを指定してください";
    NotForManifest { folder: Text }
        "`{folder}` is not UTF-8, or has a control character, so that a Cargo.toml cannot name it: rename the folder of the checkout",
        "`{folder}` はUTF-8でないか制御文字を含むため、Cargo.tomlに書けません。チェックアウトのフォルダー名を変えてください";
    NotACheckout { folder: Text, version: String }
        "`{folder}` is not a checkout of this project in version {version}: name the folder that holds tip-runtime and tip-macros",
        "`{folder}` はこのプロジェクト(バージョン{version})のチェックアウトではありません。tip-runtimeとtip-macrosのあるフォルダーを指定してください";
}
