//! Rune: a generator that the host resumes in each cycle.

use crate::asked::Asked;
use native::Entrant;
use native::motion::Motion;
use rune::runtime::{Generator, Tuple, Value};
use rune::{Source, Sources, Vm};
use std::error::Error;
use std::sync::Arc;
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow};

pub(crate) struct Script {
    generator: Generator<Vm>,
}

impl Script {
    pub(crate) fn new(motion: Motion) -> Result<Self, Box<dyn Error>> {
        let context = rune::Context::with_default_modules()?;
        let mut sources = Sources::new();
        sources.insert(Source::memory(peers::rune::spell(&motion.program()))?)?;
        let unit = rune::prepare(&mut sources).with_context(&context).build()?;
        let mut vm = Vm::new(Arc::new(context.runtime()?), Arc::new(unit));
        let generator = vm.execute(["main"], ())?.into_generator().into_owned();
        Ok(Script { generator })
    }
}

impl Entrant for Script {
    fn cycle(&mut self, robot: &mut dyn Context) -> Result<Flow, Fault> {
        let value = self.generator.next().into_result();
        let value = value.ok().flatten().ok_or(Fault::Domain)?;
        match asked(&value).ok_or(Fault::Domain)? {
            Some(asked) => asked.of(robot),
            None => Ok(Flow::Next),
        }
    }
}

/// An empty tuple is not a command; nothing at all is a wrong one.
fn asked(value: &Value) -> Option<Option<Asked>> {
    let tuple = value.borrow_tuple_ref().ok()?;
    if tuple.is_empty() {
        return Some(None);
    }
    let whole = |n: usize| tuple.get(n)?.as_integer::<usize>().ok();
    Some(Some(Asked {
        op: whole(0)?,
        target: whole(1)? as u8,
        count: whole(2)?,
        values: [number(&tuple, 3)?, number(&tuple, 4)?, number(&tuple, 5)?],
    }))
}

fn number(tuple: &Tuple, n: usize) -> Option<f64> {
    tuple.get_value(n).into_result().ok().flatten()
}
