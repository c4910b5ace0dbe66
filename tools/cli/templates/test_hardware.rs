//! The program on our own drives.

use <<crate>>::hardware::Drives;

use <<crate>>::<<items>>;

use tip_runtime::machine::Machine;
<<model>>
#[test]
fn the_drives_take_the_first_second() {
    let robot = Machine::new(<<Program>>::new(), &<<MODEL>>, Drives::new());
    let mut robot = robot.unwrap();
    while robot.cycles() as f64 * robot.period() < 1000.0 {
        assert!(robot.cycle().is_running(), "{:?}", robot.emergency());
    }
}
