//! Lua 5.4 or LuaJIT: a coroutine that the host resumes in each cycle.

use crate::asked::Asked;
use mlua::{Function, Lua, Thread};
use native::Entrant;
use native::motion::Motion;
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow};

/// Which of the two this program holds.
pub(crate) const NAME: &str = if cfg!(feature = "luajit") {
    "luajit"
} else {
    "lua54"
};

pub(crate) struct Coroutine {
    thread: Thread,
    _lua: Lua,
}

impl Coroutine {
    pub(crate) fn new(motion: Motion) -> mlua::Result<Self> {
        let lua = Lua::new();
        let main: Function = lua.load(peers::lua::spell(&motion.program())).eval()?;
        Ok(Coroutine {
            thread: lua.create_thread(main)?,
            _lua: lua,
        })
    }
}

/// Command, target, values: as many as were yielded.
type Yielded = (
    Option<usize>,
    Option<u8>,
    Option<f64>,
    Option<f64>,
    Option<f64>,
);

impl Entrant for Coroutine {
    fn cycle(&mut self, robot: &mut dyn Context) -> Result<Flow, Fault> {
        let yielded: mlua::Result<Yielded> = self.thread.resume(());
        let (Some(op), Some(target), x, y, z) = yielded.map_err(|_| Fault::Domain)? else {
            return Ok(Flow::Next);
        };
        let values = [x, y, z];
        let asked = Asked {
            op,
            target,
            values: values.map(Option::unwrap_or_default),
            count: values.iter().flatten().count(),
        };
        asked.of(robot)
    }
}
