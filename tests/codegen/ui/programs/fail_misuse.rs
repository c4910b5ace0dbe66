tip_macros::include_tip!("broken.prg", speed = 3);
tip_macros::include_tip!("broken.prg", robot = arm);
tip_macros::include_tip!("broken.prg", robot = hand, robot = generic);
tip_macros::include_tip!("broken.prg" Broken);
tip_macros::include_tip!(broken.prg);
tip_macros::tip!(Wave "3.1");
tip_macros::tip!();

fn main() {}
