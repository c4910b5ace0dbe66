//! Messages to build scripts.

use super::Text;

messages! {
    /// Messages of a compilation in a build script, besides what is wrong with the program.
    Building;

    Rust { error: Text } "{error}", "{error}";
    OneType
        "type_name names the type of one program, and there are several",
        "type_nameは1つのプログラムの型名ですが、プログラムが複数あります";
    NoRust { text: String, error: Text }
        "\"{text}\": {error}",
        "\"{text}\": {error}";
    NoFile { path: Text }
        "{path} does not name a file",
        "{path}はファイルを指していません";
    LineBreak { path: Text }
        "{path}: Cargo cannot track a path with a line break: rename the file or its folder",
        "{path}: 改行を含むパスはCargoに渡せません。ファイルかフォルダの名前を変えてください";
    SameOutput { one: Text, other: Text }
        "{one} and {other} would compile to the same file: give them different names or folders",
        "{one}と{other}のコンパイル結果が同じファイルになります。名前かフォルダを変えてください";
    NoOutDir
        "OUT_DIR is not set: call this from a build script, or choose an out_dir",
        "OUT_DIRが設定されていません。ビルドスクリプトから呼ぶか、out_dirを指定してください";
    CannotWrite { path: Text, error: Text }
        "File can not write({path}): {error}",
        "{path}に書き込めません: {error}";
}
