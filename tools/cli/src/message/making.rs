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
    Walks { travel: f64 }
        "the motion was tried: the simulated robot comes {travel} mm forward and does not fall, with mass and without",
        "動作を試しました: シミュレーションのロボットは、質量の有無にかかわらず倒れずに{travel} mm前進します";
    WalksWithoutMass { travel: f64 }
        "the motion was tried: the simulated robot comes {travel} mm forward and does not fall; with mass (`--plant dynamic`) it falls, or comes less far",
        "動作を試しました: シミュレーションのロボットは倒れずに{travel} mm前進しますが、質量を持つプラント(`--plant dynamic`)では倒れるか、そこまで進みません";
    NoGait { falls: u32 }
        "no gait was found; the motion bends one leg after the other instead, and the simulated robot falls {falls} times in it:",
        "歩容が見つからないので、脚を1本ずつ曲げる動作にしました。シミュレーションで倒れる回数は{falls}です。理由:";
    TooFewLegs
        "a robot that stands on its feet needs four legs to lift one",
        "1本を上げて立つには脚が4本必要です";
    OutOfReach
        "feet do not reach where a gait has them, or slip: set another `initial`, as by `tipc robot import --stand`, or wider limits",
        "足先が歩容の位置に届かないか、滑ります。`tipc robot import --stand` などで `initial` を変えるか、`limits` を広げてください";
    Falls
        "the simulated robot falls on every gait that was tried: set another `initial`, as by `tipc robot import --stand`",
        "試したどの歩容でも、シミュレーションのロボットが倒れます。`tipc robot import --stand` などで `initial` を変えてください";
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
