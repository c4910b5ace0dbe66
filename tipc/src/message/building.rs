//! What is said to build scripts.

messages! {
    /// What a compilation in a build script says, beside what is wrong with the program.
    Building;

    Rust { error: String } "{error}";
    OneType "type_name names the type of one program, and there are several";
    NoRust { text: String, error: String } "\"{text}\": {error}";
    NoFile { path: String } "{path} names no file";
    LineBreak { path: String } "{path}: Cargo cannot be told of a path with a line break: rename the file or its folder";
    SameOutput { one: String, other: String } "{one} and {other} would compile to the same file: give them different names or folders";
    NoOutDir "OUT_DIR is not set: call this from a build script, or choose an out_dir";
    CannotWrite { path: String, error: String } "File can not write({path}): {error}";
}
