//! Rhai: a script that the host runs in each cycle; its state is in the scope.

use crate::asked::Asked;
use native::Entrant;
use native::motion::Motion;
use rhai::{AST, Engine, EvalAltResult, Scope};
use std::cell::Cell;
use std::rc::Rc;
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow};

pub(crate) struct Script {
    engine: Engine,
    ast: AST,
    scope: Scope<'static>,
    asked: Rc<Cell<Option<Asked>>>,
}

impl Script {
    pub(crate) fn new(motion: Motion) -> Result<Self, Box<EvalAltResult>> {
        let (script, numbers) = peers::rhai::spell(&motion.program());
        let mut scope = Scope::new();
        scope.push("at", 0_i64).push("back", 0_i64);
        for name in numbers {
            scope.push(name, 0.0_f64);
        }
        let asked = Rc::new(Cell::new(None));
        let mut engine = Engine::new();
        engine.set_max_expr_depths(0, 0);
        let put = |op: i64, target: i64, values, count| {
            Some(Asked {
                op: op as usize,
                target: target as u8,
                values,
                count,
            })
        };
        let to = Rc::clone(&asked);
        engine.register_fn("ask", move |op: i64, target: i64| {
            to.set(put(op, target, [0.0; 3], 0));
        });
        let to = Rc::clone(&asked);
        engine.register_fn("ask", move |op: i64, target: i64, v: f64| {
            to.set(put(op, target, [v, 0.0, 0.0], 1));
        });
        let to = Rc::clone(&asked);
        engine.register_fn(
            "ask",
            move |op: i64, target: i64, x: f64, y: f64, z: f64| {
                to.set(put(op, target, [x, y, z], 3));
            },
        );
        Ok(Script {
            ast: engine.compile_with_scope(&scope, script)?,
            engine,
            scope,
            asked,
        })
    }
}

impl Entrant for Script {
    fn cycle(&mut self, robot: &mut dyn Context) -> Result<Flow, Fault> {
        self.engine
            .run_ast_with_scope(&mut self.scope, &self.ast)
            .map_err(|_| Fault::Domain)?;
        match self.asked.take() {
            Some(asked) => asked.of(robot),
            None => Ok(Flow::Next),
        }
    }
}
