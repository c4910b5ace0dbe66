//! What is said of files and their bytes.

use super::Text;

messages! {
    /// What reading says.
    Reading;

    System { error: Text } "{error}", "{error}";
    NoFile
        "there is no such file: look at its name and its folder",
        "このファイルはありません。名前とフォルダを確かめてください";
    NotAllowed
        "the file may not be read: look at its permissions",
        "ファイルを読む権限がありません。アクセス権を確かめてください";
    TwoFiles { first: Text, second: Text }
        "the path leads to two files, {first} and {second}; write a path that leads to one of them only",
        "このパスには{first}と{second}の二つのファイルがあります。どちらか一方だけを指すパスにしてください";
    Folder
        "this is a folder: name the files in it, as FOLDER/*.prg",
        "これはフォルダです。フォルダ/*.prg のように中のファイルを指定してください";
    NotRegular
        "this is a device, a pipe or a socket, which may never end: name a regular file",
        "これはデバイス、パイプ、またはソケットで、読み込みが終わらないことがあります。通常のファイルを指定してください";
    TooLarge { limit: usize }
        "the file is larger than {limit} MiB, the limit: split it, or look at whether it is the right file",
        "ファイルが上限の{limit} MiBを超えています。分割するか、正しいファイルかどうか確かめてください";
    Changed
        "the file has changed since it was read, and is left as it is: read it again",
        "読み込んだ後にファイルが変更されたため、書き込みませんでした。もう一度読み込んでください";
    Linked
        "a link to another file has taken the place of the file, and is not followed",
        "ファイルが別のファイルへのリンクに置き換わっています。リンクはたどりません";
    NotValid { byte: usize, encoding: &'static str }
        "byte {byte} of the file is not valid {encoding}",
        "ファイルの{byte}バイト目が{encoding}として正しくありません";
    NotTheOtherEither { encoding: &'static str, byte: usize }
        "the file is not {encoding} either (byte {byte}); save it in one of the two encodings",
        "{encoding}でもありません({byte}バイト目)。どちらかの文字コードで保存してください";
    OtherCharacters
        "this is read as other characters than those that were written",
        "書かれたものとは別の文字として読まれています";
    SaveInThatEncoding
        "save the file in that encoding, or name the right one",
        "その文字コードで保存するか、正しい文字コードを指定してください";
}
