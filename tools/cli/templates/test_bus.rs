//! The program on simulated servos in place of those of `robot.toml`.

use <<crate>>::<<items>>;

use tip_drives::described::{self, Described};
use tip_drives::guard::Step;
use tip_drives::operator;
use tip_drives::port::SIMULATED;
use tip_runtime::machine::Machine;

#[test]
fn the_servos_take_the_first_second() {
    let description = described::read("robot.toml", include_bytes!("../robot.toml")).unwrap();
    let robot = Described::new(&description).unwrap();
    let mut drives = operator::open(&robot, SIMULATED).unwrap();
<<sticks>>    drives.connect().unwrap();
    let step = drives.approach(&robot.initial, robot.bus.start);
    assert_eq!(step, Ok(Step::Arrived));
    let machine = Machine::new(<<Program>>::new(), &<<MODEL>>, drives);
    let mut machine = machine.unwrap();
    while machine.cycles() as f64 * machine.period() < 1000.0 {
        assert!(machine.cycle().is_running(), "{:?}", machine.emergency());
        machine.hardware_mut().wait();
    }
    assert_eq!(operator::leave(machine.hardware_mut(), &robot), Ok(()));
}
