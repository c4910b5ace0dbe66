//! Every entrant, by the name that tables and benchmarks give it.

use crate::{lua, rhai, rune};
use native::motion::Motion;
use native::{Entrant, Name};

/// An entrant's name and what makes one.
pub struct Entry {
    /// Its name.
    pub name: &'static str,
    make: Make,
}

enum Make {
    Native(Name),
    Lua,
    Rhai,
    Rune,
}

/// Everybody who takes part. With LuaJIT in the place of Lua 5.4 only the compiled program
/// is measured again, to compare with.
pub fn roster() -> Vec<Entry> {
    let lua = Entry {
        name: lua::NAME,
        make: Make::Lua,
    };
    let is_wanted = |name: &Name| !cfg!(feature = "luajit") || *name == Name::Compiled;
    let native = Name::ALL.into_iter().filter(is_wanted).map(|name| Entry {
        name: name.name(),
        make: Make::Native(name),
    });
    let rhai = Entry {
        name: "rhai",
        make: Make::Rhai,
    };
    let rune = Entry {
        name: "rune",
        make: Make::Rune,
    };
    let scripts = match cfg!(feature = "luajit") {
        true => vec![lua],
        false => vec![lua, rhai, rune],
    };
    native.chain(scripts).collect()
}

impl Entry {
    /// The entrant at its first step; `is_traced` if its trace is wanted.
    ///
    /// # Panics
    /// If a script does not load.
    pub fn entrant(&self, motion: Motion, is_traced: bool) -> Box<dyn Entrant> {
        match self.make {
            Make::Native(name) => native::entrant(name, motion, is_traced),
            Make::Lua => Box::new(lua::Coroutine::new(motion).expect("a Lua script")),
            Make::Rhai => Box::new(rhai::Script::new(motion).expect("a Rhai script")),
            Make::Rune => Box::new(rune::Script::new(motion).expect("a Rune script")),
        }
    }
}
