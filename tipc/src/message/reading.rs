//! What is said of files and their bytes.

messages! {
    /// What reading says.
    Reading;

    System { error: String } "{error}";
    NotValid { byte: usize, encoding: &'static str } "byte {byte} of the file is not valid {encoding}";
    NotTheOtherEither { encoding: &'static str, byte: usize } "the file is no {encoding} either (byte {byte}); save it in one of the two encodings";
    SaveInThatEncoding "save the file in that encoding, or name the right one";
}
