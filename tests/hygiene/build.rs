//! Programs whose types bear the names of the prelude.

fn main() -> Result<(), tipc::BuildError> {
    tipc::Config::new()
        .runtime_path("::robot")
        .compile(&["motions/ok.prg", "motions/option.prg"])
}
