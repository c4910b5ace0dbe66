//! A host's use of a program: it puts it on a simulated robot by its type alone, and reads and sets its
//! variables between control cycles. Both engines answer alike.

use tip_runtime::machine::{Machine, Simulated, Status};
use tip_runtime::model::{Model, hand};
use tip_runtime::program::{End, Program, VariableError};
use tip_runtime::record::JsonLines;
use tip_runtime::robot::For;
use tip_sim::Interpreter;

const STRIDE: &str = "3.1
The host sets the stride
DEF_VAR STRIDE N
DEF_POS P
STRIDE = 10
LOOP:
N = STRIDE + 1
P.Y = N
IF N < 100 GOTO
END
";

tip_macros::tip!(
    Stride,
    "3.1
The host sets the stride
DEF_VAR STRIDE N
DEF_POS P
STRIDE = 10
LOOP:
N = STRIDE + 1
P.Y = N
IF N < 100 GOTO
END
"
);

tip_macros::tip!(Grip, "3.1\nclose\nINITIAL_POSTURE\nEND\n", robot = hand);
tip_macros::tip!(Pause, "3.1\npause\nSLEEP 40\nEND\n", robot = generic);
tip_macros::include_robot!("../../../../tipc/tests/robots/hexapod.toml" as HEXAPOD);
tip_macros::tip!(
    March,
    "3.1\nmarch\nPTP_ANGLE J61 0\nEND\n",
    robot = "../../../../tipc/tests/robots/hexapod.toml"
);

fn interpreted() -> Interpreter {
    let loaded = tipc::load("Stride", STRIDE.as_bytes(), &tipc::Options::default());
    Interpreter::new(loaded.program.expect("it loads"))
}

fn model_of<R: Simulated<L, J>, const L: usize, const J: usize>(
    _: &impl For<R>,
) -> &'static Model<L, J> {
    R::MODEL
}

/// The program ends because the host has set the stride.
fn the_host_ends_it(program: impl Program) {
    let model = model_of(&Stride::new());
    let plant = tip_runtime::plant::SimulatedPlant::new(model);
    let mut machine = Machine::new(program, model, plant).expect("it is for TITAN VIII");
    for _ in 0..9 {
        assert_eq!(machine.cycle(), Status::Running);
    }
    // The default, and twice the four steps of the loop.
    assert_eq!(machine.program().at(), 1);
    assert_eq!(machine.program().get("STRIDE"), Ok(Some(10.0)));
    assert_eq!(machine.program().get("P.Y"), Ok(Some(11.0)));
    assert_eq!(machine.program().get("P.X"), Ok(None));
    assert_eq!(machine.program_mut().set("STRIDE", 99.0), Ok(()));
    for _ in 0..4 {
        assert_eq!(machine.cycle(), Status::Running);
    }
    assert_eq!(machine.program().get("N"), Ok(Some(100.0)));
    assert_eq!(machine.cycle(), Status::Finished(End::End));
}

#[test]
fn a_variable_that_the_host_sets_is_what_the_next_step_reads() {
    the_host_ends_it(Stride::new());
    the_host_ends_it(interpreted());
}

// clauses: 3.4
#[test]
fn the_program_assigns_its_default_after_what_the_host_set_before_the_run() {
    let mut machine = Machine::simulated(Stride::new());
    assert_eq!(machine.program_mut().set("STRIDE", 99.0), Ok(()));
    assert!(machine.cycle().is_running());
    assert_eq!(machine.program().get("STRIDE"), Ok(Some(10.0)));
}

#[test]
fn the_host_is_refused_alike_by_both_engines() {
    let (mut compiled, mut interpreted) = (Stride::new(), interpreted());
    for program in [&mut compiled as &mut dyn Program, &mut interpreted] {
        assert_eq!(program.set("STRIDES", 1.0), Err(VariableError::Unknown));
        assert_eq!(program.set("P", 1.0), Err(VariableError::Unknown));
        assert_eq!(program.set("CHAR_A", 1.0), Err(VariableError::Constant));
        assert_eq!(program.get("CHAR_A"), Err(VariableError::Constant));
        assert_eq!(program.set("N", f64::NAN), Err(VariableError::NotFinite));
        assert_eq!(program.get("N"), Ok(None));
        program.set_scalar(1_000, 1.0); // there is none
        assert_eq!(program.set("p.z", 7.0), Ok(()));
        assert_eq!(program.scalar(5), Some(("P.Z", Some(7.0))));
    }
}

/// `set` lists what steps assign.
#[test]
fn a_trace_does_not_tell_what_the_host_sets() {
    let mut machine = Machine::simulated(Stride::new());
    let mut trace = JsonLines::new(String::new(), false);
    machine.cycle_traced(&mut trace);
    assert_eq!(machine.program_mut().set("STRIDE", 20.0), Ok(()));
    machine.cycle_traced(&mut trace);
    machine.cycle_traced(&mut trace);
    assert_eq!(
        trace.into_inner(),
        "{\"cycle\":0,\"step\":0,\"next\":1,\"set\":{\"STRIDE\":10.0}}\n\
         {\"cycle\":1,\"step\":1,\"next\":2}\n\
         {\"cycle\":2,\"step\":2,\"next\":3,\"set\":{\"N\":21.0}}\n"
    );
}

#[test]
fn each_robot_with_a_name_is_simulated_by_the_type_of_its_program() {
    let mut on_hand = Machine::simulated(Grip::new());
    while on_hand.cycle().is_running() {}
    assert_eq!(on_hand.status(), Status::Finished(End::End));
    assert_eq!(model_of(&Grip::new()).signature(), hand::MODEL.signature());
    let mut on_generic = Machine::simulated(Pause::new());
    while on_generic.cycle().is_running() {}
    assert_eq!(on_generic.status(), Status::Finished(End::End));
}

#[test]
fn a_described_robot_is_simulated_from_its_model() {
    let mut machine = Machine::simulated_on(March::new(), &HEXAPOD).expect("it is for the hexapod");
    while machine.cycle().is_running() {}
    assert_eq!(machine.status(), Status::Finished(End::End));
    let mismatch =
        Machine::simulated_on(Stride::new(), &HEXAPOD).expect_err("it is for TITAN VIII");
    assert_eq!(mismatch.program, Stride::new().signature());
    assert_eq!(mismatch.robot, HEXAPOD.signature());
}
