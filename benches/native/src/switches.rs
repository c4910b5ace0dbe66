//! The motions in C: a `switch` in a function, compiled with -O2.

use peers::code;
use std::ffi::{c_int, c_void};
use std::slice;
use tip_runtime::command::{Command, Op, Poll, Value};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow};

use crate::Entrant;

#[repr(C)]
struct CValue {
    v: f64,
    relative: bool,
}

#[repr(C)]
struct CCommand {
    op: u8,
    target: u8,
    hs: bool,
    values: *const CValue,
    count: usize,
}

#[repr(C)]
struct CRobot {
    ask: unsafe extern "C" fn(*mut CRobot, *const CCommand) -> c_int,
    asked: u64,
    context: *mut c_void,
}

const NEXT: c_int = 0;
const WAIT: c_int = 1;
const FAULT: c_int = 3;

type Step = unsafe extern "C" fn(*mut c_void, *mut CRobot) -> c_int;

unsafe extern "C" {
    fn answer_at_once(robot: *mut CRobot, command: *const CCommand) -> c_int;
}

/// A motion in C and its state.
pub(crate) struct Switch {
    step: Step,
    state: Vec<u64>,
    robot: CRobot,
}

impl Switch {
    /// `is_traced`: whether its commands reach the cycle's robot; else a robot of C answers them at
    /// once, so that C pays for no translation.
    fn new(step: Step, size: usize, is_traced: bool) -> Self {
        let ask = if is_traced { pass_on } else { answer_at_once };
        Switch {
            step,
            state: vec![0; size.div_ceil(size_of::<u64>())],
            robot: CRobot {
                ask,
                asked: 0,
                context: std::ptr::null_mut(),
            },
        }
    }
}

impl Entrant for Switch {
    fn cycle(&mut self, mut robot: &mut dyn Context) -> Result<Flow, Fault> {
        self.robot.context = (&raw mut robot).cast();
        // SAFETY: the state is as large and as aligned as C says, and all zeros is a state.
        match unsafe { (self.step)(self.state.as_mut_ptr().cast(), &mut self.robot) } {
            NEXT => Ok(Flow::Next),
            WAIT => Ok(Flow::Wait),
            _ => Err(Fault::Domain),
        }
    }

    fn state_bytes(&self) -> usize {
        size_of_val(self.state.as_slice())
    }
}

unsafe extern "C" fn pass_on(robot: *mut CRobot, command: *const CCommand) -> c_int {
    // SAFETY: C hands on the robot of `Switch::cycle`, whose context is valid in this cycle, and a
    // command with as many values as it says.
    let (cx, command) = unsafe {
        let cx: *mut &mut dyn Context = (*robot).context.cast();
        (&mut *cx, &*command)
    };
    let values: &[CValue] = match command.count {
        0 => &[],
        // SAFETY: as above.
        count => unsafe { slice::from_raw_parts(command.values, count) },
    };
    let values: Vec<Value> = values
        .iter()
        .map(|value| match value.relative {
            true => Value::Relative(value.v),
            false => Value::Absolute(value.v),
        })
        .collect();
    let asked = cx.command(&Command {
        op: code::op(usize::from(command.op)).unwrap_or(Op::AllStop),
        hs: command.hs,
        target: code::target(command.target),
        values: &values,
    });
    match asked {
        Ok(Poll::Done) => NEXT,
        Ok(Poll::Pending) => WAIT,
        Err(_) => FAULT,
    }
}

macro_rules! switches {
    ($($name:ident $step:ident $size:ident)*) => {
        unsafe extern "C" {
            $(
                fn $step(motion: *mut c_void, robot: *mut CRobot) -> c_int;
                static $size: usize;
            )*
        }
        $(
            pub(crate) fn $name(is_traced: bool) -> Switch {
                // SAFETY: a constant of the C file.
                Switch::new($step, unsafe { $size }, is_traced)
            }
        )*
    };
}

switches! {
    walk_loop step_walk_loop size_of_walk_loop
    steps100 step_steps100 size_of_steps100
    steps1000 step_steps1000 size_of_steps1000
    steps10000 step_steps10000 size_of_steps10000
}
