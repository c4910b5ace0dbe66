//! Compiles the motion program; its errors stop the build with their line and column.

fn main() -> Result<(), tipc::BuildError> {
    tipc::compile("motions/push_up.prg")
}
