//! Programs and a robot that bear the names of the prelude.

fn main() -> Result<(), tipc::BuildError> {
    let mut config = tipc::Config::new();
    config.runtime_path("::robot");
    config.compile(&["motions/ok.prg", "motions/option.prg"])?;
    config.compile_robot("motions/some.toml")
}
