
// The robot as data, from its description.
tip_macros::include_robot!(pub "robot.toml" as ROBOT);
