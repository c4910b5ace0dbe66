//! A command of a program as written, taken to pieces.

use super::form::{Form, Slot};
use std::collections::{BTreeSet, HashMap};
use tipc::Robot;
use tipc::language::reserved::motion_flags;
use tipc::syntax::{Module, Operand, OperandKind, StatementKind, VariableKind};

/// The declared variables of a program.
pub type Names = HashMap<String, VariableKind>;

/// Declarations of a program, VAR_KEY included.
pub fn names(module: &Module) -> Names {
    let mut names = Names::from([("VAR_KEY".to_owned(), VariableKind::Var)]);
    for statement in &module.statements {
        if let StatementKind::Define {
            kind, names: words, ..
        } = &statement.kind
        {
            names.extend(words.iter().map(|word| (word.node.to_string(), *kind)));
        }
    }
    names
}

/// One argument.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The word, if it is one without sign and member.
    pub word: Option<String>,
    sort: Sort,
    negative: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sort {
    Number,
    Var,
    /// A member; of which type, if that has it.
    Member(Option<VariableKind>),
    Pos,
    Joint,
    Unknown,
}

impl Piece {
    fn new(operand: &Operand, names: &Names) -> Self {
        let (sort, word) = match &operand.kind {
            OperandKind::Number(_) => (Sort::Number, None),
            OperandKind::Name(name) => {
                let sort = match names.get(name.as_str()) {
                    Some(VariableKind::Var) => Sort::Var,
                    Some(VariableKind::Pos) => Sort::Pos,
                    Some(VariableKind::Joint) => Sort::Joint,
                    None if name.starts_with("CHAR_") => Sort::Number,
                    None => Sort::Unknown,
                };
                (sort, Some(name.to_string()))
            }
            OperandKind::Member(words) => {
                let kind = names.get(words.0.as_str());
                let sort = kind.map_or(Sort::Unknown, |kind| {
                    Sort::Member(has(*kind, &words.1).then_some(*kind))
                });
                (sort, None)
            }
        };
        Piece {
            word: word.filter(|_| !operand.negative),
            sort,
            negative: operand.negative,
        }
    }

    /// Returns true if it can stand where the slot is. An unknown name could be anything.
    pub fn fits(&self, slot: Slot) -> bool {
        let scalar = matches!(self.sort, Sort::Number | Sort::Var | Sort::Member(Some(_)));
        match slot {
            _ if self.sort == Sort::Unknown => true,
            Slot::Scalar => scalar,
            Slot::Plain => matches!(self.sort, Sort::Number | Sort::Var),
            Slot::Constant => self.sort == Sort::Number,
            _ if self.negative => false,
            Slot::Pos | Slot::IntoPos => self.sort == Sort::Pos,
            Slot::Joint | Slot::IntoJoint => self.sort == Sort::Joint,
            Slot::IntoVar => self.sort == Sort::Var,
            Slot::IntoMember => self.sort == Sort::Member(Some(VariableKind::Joint)),
        }
    }

    fn is(&self, words: &[&str]) -> bool {
        self.word
            .as_deref()
            .is_some_and(|word| words.contains(&word))
    }

    /// `R`, `A` or `HS`
    pub fn is_flag(&self) -> bool {
        self.is(&motion_flags().collect::<Vec<_>>())
    }
}

fn has(kind: VariableKind, member: &str) -> bool {
    match kind {
        VariableKind::Var => false,
        VariableKind::Pos => ["X", "Y", "Z"].contains(&member),
        VariableKind::Joint => ["J1", "J2", "J3"].contains(&member),
    }
}

/// A command as written; flags in the places where they are allowed are taken out.
#[derive(Clone, Debug)]
pub struct Written {
    /// `HS` comes first.
    pub hs: bool,
    /// The other arguments.
    pub pieces: Vec<Piece>,
    /// `R` and `A` before values.
    pub flags: BTreeSet<String>,
    /// True if something after the pieces is not an argument at all.
    pub malformed: bool,
}

impl Written {
    /// Reads the arguments as the form's command does.
    pub fn new(arguments: &[Operand], malformed: bool, names: &Names, form: &Form) -> Self {
        let mut pieces: Vec<Piece> = arguments
            .iter()
            .map(|operand| Piece::new(operand, names))
            .collect();
        let takes = form.arguments();
        let takes_hs = takes.is_some_and(|takes| takes.hs);
        let hs = takes_hs && pieces.first().is_some_and(|first| first.is(&["HS"]));
        if hs {
            pieces.remove(0);
        }
        let mut flags = BTreeSet::new();
        if takes.is_some_and(|takes| takes.relative) {
            let before_value = |at: usize, piece: &Piece| {
                let value = pieces.get(at + 1).is_none_or(|next| !next.is_flag());
                at > 0 && value && piece.is(&["R", "A"])
            };
            let (used, rest): (Vec<_>, Vec<_>) = pieces
                .iter()
                .enumerate()
                .partition(|(at, piece)| before_value(*at, piece));
            flags = used
                .into_iter()
                .filter_map(|(_, piece)| piece.word.clone())
                .collect();
            pieces = rest.into_iter().map(|(_, piece)| piece.clone()).collect();
        }
        Written {
            hs,
            pieces,
            flags,
            malformed,
        }
    }

    /// Returns true if HS, R and A stand as the form has them.
    pub fn is_flagged_as(&self, form: &Form) -> bool {
        let flagged = match form.flag {
            Some(flag) => self.flags.contains(flag),
            None => self.flags.is_empty(),
        };
        self.hs == form.hs && flagged
    }

    /// Which of the first pieces stand where the form has something else.
    pub fn misfits(&self, form: &Form, robot: Robot) -> Vec<usize> {
        let heads = usize::from(form.head.is_some());
        let misfits = |(at, piece): (usize, &Piece)| {
            let fits = match form.head.filter(|_| at == 0) {
                Some(head) => {
                    let word = piece.word.as_deref();
                    word.is_some_and(|word| head.names_on(word, robot))
                }
                None => {
                    let slot = form.values.get(at - heads);
                    let flag = form.is_motion() && piece.is_flag();
                    slot.is_none_or(|slot| piece.fits(*slot)) && !flag
                }
            };
            (!fits).then_some(at)
        };
        self.pieces.iter().enumerate().filter_map(misfits).collect()
    }
}
