//! Openers and closers (T.I.P. 3.1 §7-6, §4-2 path 4).

use crate::codes::Code;
use crate::diagnostic::Diagnostic;
use crate::syntax::{Module, Operand, OperandKind, Shape, Span, Statement, StatementKind};

/// What a block is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BlockKind {
    /// One branch of an IF.
    If,
    While,
    Repeat,
    For,
    Subroutine,
}

impl BlockKind {
    const fn opener(self) -> &'static str {
        match self {
            BlockKind::If => "IF",
            BlockKind::While => "WHILE",
            BlockKind::Repeat => "REPEAT",
            BlockKind::For => "FOR",
            BlockKind::Subroutine => "SUBROUTINE",
        }
    }

    const fn closer(self) -> &'static str {
        match self {
            BlockKind::If => "ENDIF",
            BlockKind::While => "WEND",
            BlockKind::Repeat => "UNTIL",
            BlockKind::For => "NEXT",
            BlockKind::Subroutine => "SUBEND",
        }
    }
}

/// A block, by the index of the statement that opens it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    pub(crate) kind: BlockKind,
    pub(crate) opener: usize,
    pub(crate) parent: Option<usize>,
}

/// How a control word is tied to others, by the indices of statements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Link {
    /// Of IF, ELSEIF: the next ELSEIF, ELSE or ENDIF. Of ELSE: ENDIF. Of WHILE, FOR: the closer.
    /// Of WEND, UNTIL, NEXT: the opener.
    pub(crate) partner: Option<usize>,
}

/// The block structure of a module.
#[derive(Clone, Debug, Default)]
pub(crate) struct Blocks {
    pub(crate) blocks: Vec<Block>,
    /// The innermost block around each statement.
    pub(crate) around: Vec<Option<usize>>,
    /// The ties of each statement.
    pub(crate) links: Vec<Link>,
}

impl Blocks {
    /// The blocks around a statement, innermost first.
    pub(crate) fn chain(&self, statement: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(self.around[statement], |block| self.blocks[*block].parent)
    }
}

/// Ties every control word to its partner and reports those without one.
pub(crate) fn blocks(module: &Module, found: &mut Vec<Diagnostic>) -> Blocks {
    let count = module.statements.len();
    let mut matcher = Matcher {
        module,
        result: Blocks {
            blocks: Vec::new(),
            around: vec![None; count],
            links: vec![Link::default(); count],
        },
        open: Vec::new(),
        found,
    };
    for index in 0..count {
        matcher.statement(index);
    }
    matcher.close_rest();
    matcher.result
}

struct Open {
    kind: BlockKind,
    /// The statement that opened the whole construct.
    first: usize,
    /// The latest branch of an IF, whose link is still to be set.
    branch: usize,
    /// ELSE has stood.
    has_else: bool,
    /// The block of the current branch.
    block: usize,
}

struct Matcher<'a> {
    module: &'a Module,
    result: Blocks,
    open: Vec<Open>,
    found: &'a mut Vec<Diagnostic>,
}

impl Matcher<'_> {
    fn statement(&mut self, index: usize) {
        use BlockKind::{For, If, Repeat, Subroutine, While};
        let statement = &self.module.statements[index];
        let opened = match opening(&statement.kind) {
            Some(kind) => {
                if kind == Subroutine {
                    self.refuse_nested(index);
                }
                self.result.around[index] = self.current();
                self.open(kind, index);
                (kind == Subroutine).then(|| self.current())
            }
            None => None,
        };
        match &statement.kind {
            StatementKind::ElseIf { .. } | StatementKind::Broken(Shape::ElseIf) => {
                self.branch(index, "ELSEIF");
            }
            StatementKind::Else => self.branch(index, "ELSE"),
            StatementKind::EndIf => self.close(index, If, "ENDIF"),
            StatementKind::Wend => self.close(index, While, "WEND"),
            StatementKind::Until { .. } | StatementKind::Broken(Shape::Until) => {
                self.close(index, Repeat, "UNTIL");
            }
            StatementKind::Next { .. } | StatementKind::Broken(Shape::Next) => {
                self.close(index, For, "NEXT");
            }
            StatementKind::SubEnd | StatementKind::Broken(Shape::SubEnd) => {
                self.close(index, Subroutine, "SUBEND");
            }
            _ => {
                if opening(&statement.kind).is_none() {
                    self.result.around[index] = self.current();
                }
            }
        }
        if let Some(inside) = opened {
            // A SUBROUTINE's own step lies inside it: only calls reach it from outside.
            self.result.around[index] = inside;
        }
    }

    fn current(&self) -> Option<usize> {
        self.open.last().map(|open| open.block)
    }

    fn new_block(&mut self, kind: BlockKind, opener: usize, parent: Option<usize>) -> usize {
        self.result.blocks.push(Block {
            kind,
            opener,
            parent,
        });
        self.result.blocks.len() - 1
    }

    fn open(&mut self, kind: BlockKind, index: usize) {
        let parent = self.current();
        let block = self.new_block(kind, index, parent);
        self.open.push(Open {
            kind,
            first: index,
            branch: index,
            has_else: false,
            block,
        });
    }

    fn refuse_nested(&mut self, index: usize) {
        let Some(open) = self.open.last() else {
            return;
        };
        let outer = open.kind.opener();
        let reason = match open.kind {
            BlockKind::Subroutine => "a SUBROUTINE stands inside a SUBROUTINE".to_owned(),
            _ => format!("a SUBROUTINE stands inside {outer}"),
        };
        let help = format!("close {outer} with {} before it", open.kind.closer());
        let fault = Diagnostic::new(Code::Structure, self.place(index), reason)
            .label(
                self.place(open.first),
                format!("this {outer} is still open"),
            )
            .help(help);
        self.found.push(fault);
    }

    fn branch(&mut self, index: usize, name: &str) {
        let Some(depth) = self.unwind(index, BlockKind::If, name) else {
            self.result.around[index] = self.current();
            return;
        };
        let open = &self.open[depth];
        if open.has_else {
            let reason = format!("{name} stands behind the ELSE of its IF");
            let fault = Diagnostic::new(Code::Structure, self.place(index), reason)
                .label(self.place(open.branch), "the ELSE")
                .help("ELSE is the last branch of an IF");
            self.found.push(fault);
        }
        let (first, branch) = (open.first, open.branch);
        let parent = self.result.blocks[open.block].parent;
        self.result.links[branch].partner = Some(index);
        self.result.around[index] = parent;
        let block = self.new_block(BlockKind::If, index, parent);
        let has_else = name == "ELSE" || self.open[depth].has_else;
        self.open[depth] = Open {
            kind: BlockKind::If,
            first,
            branch: index,
            has_else,
            block,
        };
    }

    fn close(&mut self, index: usize, kind: BlockKind, name: &str) {
        let Some(depth) = self.unwind(index, kind, name) else {
            self.result.around[index] = self.current();
            return;
        };
        let Open { branch, first, .. } = self.open[depth];
        self.open.truncate(depth);
        self.result.around[index] = self.current();
        self.result.links[branch].partner = Some(index);
        self.result.links[index].partner = Some(first);
        if kind == BlockKind::For {
            self.check_counter(first, index);
        }
    }

    /// Finds the construct that a word belongs to, and reports the open ones that it leaves behind.
    fn unwind(&mut self, index: usize, kind: BlockKind, name: &str) -> Option<usize> {
        let depth = self.open.iter().rposition(|open| open.kind == kind);
        // A block that leaves a SUBROUTINE open would take all of its rest along.
        let barrier = self
            .open
            .iter()
            .rposition(|open| open.kind == BlockKind::Subroutine);
        let reachable = depth.filter(|depth| barrier.is_none_or(|barrier| *depth >= barrier));
        let Some(depth) = reachable else {
            let reason = format!("no {} is open for this {name}", kind.opener());
            let mut fault = Diagnostic::new(Code::Structure, self.place(index), reason).help(
                format!("{} opens what {} closes", kind.opener(), kind.closer()),
            );
            if let Some(open) = self.open.last() {
                let text = format!("this {} is open", open.kind.opener());
                fault = fault.label(self.place(open.first), text);
            }
            self.found.push(fault);
            return None;
        };
        while self.open.len() > depth + 1 {
            self.leave_open(Some((index, name)));
        }
        Some(depth)
    }

    fn leave_open(&mut self, met: Option<(usize, &str)>) {
        let Some(open) = self.open.pop() else {
            return;
        };
        let (opener, closer) = (open.kind.opener(), open.kind.closer());
        let reason = format!("this {opener} is not closed");
        let mut fault = Diagnostic::new(Code::Structure, self.place(open.first), reason)
            .help(format!("close it with {closer}"));
        fault = match met {
            Some((index, name)) => {
                fault.label(self.place(index), format!("{name} comes before {closer}"))
            }
            None => match self.module.statements.last() {
                Some(last) => fault.label(last.span, format!("the program ends before {closer}")),
                None => fault,
            },
        };
        self.found.push(fault);
    }

    fn close_rest(&mut self) {
        while !self.open.is_empty() {
            self.leave_open(None);
        }
    }

    fn check_counter(&mut self, opener: usize, closer: usize) {
        let (
            StatementKind::For { variable, .. },
            StatementKind::Next {
                variable: Some(named),
                ..
            },
        ) = (
            &self.module.statements[opener].kind,
            &self.module.statements[closer].kind,
        )
        else {
            return;
        };
        if name_of(variable) != name_of(named) {
            let reason = format!(
                "this NEXT names {}",
                name_of(named).unwrap_or("another variable")
            );
            let help = "NEXT names the variable of its FOR, or nothing";
            let fault = Diagnostic::new(Code::Structure, named.span, reason)
                .label(variable.span, "the variable of its FOR")
                .help(help);
            self.found.push(fault);
        }
    }

    fn place(&self, index: usize) -> Span {
        keyword(&self.module.statements[index])
    }
}

/// The word of a statement, or the whole of it.
pub(crate) fn keyword(statement: &Statement) -> Span {
    match &statement.kind {
        StatementKind::If { keyword, .. }
        | StatementKind::ElseIf { keyword, .. }
        | StatementKind::While { keyword, .. }
        | StatementKind::Until { keyword, .. }
        | StatementKind::For { keyword, .. }
        | StatementKind::Next { keyword, .. }
        | StatementKind::Subroutine { keyword, .. } => *keyword,
        _ => statement.span,
    }
}

fn name_of(operand: &Operand) -> Option<&str> {
    match &operand.kind {
        OperandKind::Name { name, member: None } => Some(name),
        _ => None,
    }
}

fn opening(kind: &StatementKind) -> Option<BlockKind> {
    match kind {
        StatementKind::If {
            then: crate::syntax::Then::Block,
            ..
        }
        | StatementKind::Broken(Shape::If) => Some(BlockKind::If),
        StatementKind::While { .. } | StatementKind::Broken(Shape::While) => Some(BlockKind::While),
        StatementKind::Repeat => Some(BlockKind::Repeat),
        StatementKind::For { .. } | StatementKind::Broken(Shape::For) => Some(BlockKind::For),
        StatementKind::Subroutine { .. } | StatementKind::Broken(Shape::Subroutine) => {
            Some(BlockKind::Subroutine)
        }
        _ => None,
    }
}

/// Warns of each SUBROUTINE that the step above it runs into.
pub(crate) fn warn_of_entries(module: &Module, found: &mut Vec<Diagnostic>) {
    let mut open_above = true;
    for statement in &module.statements {
        match &statement.kind {
            StatementKind::Define { .. } => continue,
            StatementKind::Subroutine { keyword, name } if open_above => {
                let reason = "its SUBEND stops a program that comes this way";
                let help = "put GOTO, RETURN or EXIT above it";
                let warning = Diagnostic::new(Code::RunsInto, *keyword, reason);
                found.push(warning.about(&name.node).help(help));
            }
            _ => {}
        }
        open_above = !matches!(
            statement.kind,
            StatementKind::Goto(_)
                | StatementKind::Return
                | StatementKind::SubEnd
                | StatementKind::Exit
                | StatementKind::End
                | StatementKind::Broken(_)
        );
    }
}
