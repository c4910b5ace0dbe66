tip_macros::include_robot!(HEXAPOD);
tip_macros::include_robot!("hexapod.toml", robot = generic);
tip_macros::include_robot!("hexapod.toml", runtime = ::tip_runtime, runtime = ::tip_runtime);
tip_macros::include_robot!("/no/such/folder/gone.toml");

fn main() {}
