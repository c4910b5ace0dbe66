//! Syntax that all peers share: numbers, variables, operations, relations.

use tipc::program::{
    Action, Argument, Arithmetic, Condition, Mark, Operand, Program, Relation, Scalar,
    ScalarExpression, StructExpression, StructOperand, Variable, VariableKind,
};

/// The variables that a program declares: all but `VAR_KEY`.
pub(crate) fn variables(program: &Program) -> impl Iterator<Item = &Variable> {
    program.variables().iter().skip(1)
}

/// Spelling of a variable in one language, lower case.
pub(crate) struct Infix<'a> {
    pub(crate) program: &'a Program,
    /// A number, from its name.
    pub(crate) scalar: fn(&str) -> String,
    /// A member of a position, from the position's name and the member's place.
    pub(crate) member: fn(&str, usize) -> String,
    /// Spelling of "is not".
    pub(crate) not_equal: &'static str,
}

impl<'a> Infix<'a> {
    /// Rust: numbers are fields of `self`.
    pub(crate) fn of_rust(program: &'a Program) -> Self {
        Infix {
            program,
            scalar: |name| format!("self.{name}"),
            member: |name, member| format!("self.{name}[{member}]"),
            not_equal: "!=",
        }
    }

    /// A scripting language: each number is a variable.
    pub(crate) fn of_script(program: &'a Program, not_equal: &'static str) -> Self {
        Infix {
            program,
            scalar: str::to_owned,
            member: |name, member| format!("{name}_{}", ["x", "y", "z"][member]),
            not_equal,
        }
    }
}

/// One assignment.
pub(crate) struct Set {
    pub(crate) place: String,
    pub(crate) value: String,
    /// The value comes from an operation, so that it may not be finite.
    pub(crate) is_calculated: bool,
}

impl Infix<'_> {
    pub(crate) fn place(&self, scalar: Scalar) -> String {
        let variable = &self.program.variables()[scalar.variable];
        let name = variable.name.to_lowercase();
        match variable.kind {
            VariableKind::Var => (self.scalar)(&name),
            VariableKind::Pos | VariableKind::Joint => (self.member)(&name, scalar.member),
        }
    }

    pub(crate) fn operand(&self, operand: Operand) -> String {
        match operand {
            Operand::Constant(value) => format!("{value:?}"),
            Operand::Scalar { scalar, negative } => {
                let sign = if negative { "-" } else { "" };
                format!("{sign}{}", self.place(scalar))
            }
            Operand::Reading { .. } => panic!("readings are beyond the peers"),
        }
    }

    pub(crate) fn arguments(&self, arguments: &[Argument]) -> Vec<String> {
        let value = |argument: &Argument| {
            assert!(argument.mark == Mark::None, "R is beyond the peers");
            self.operand(argument.operand)
        };
        arguments.iter().map(value).collect()
    }

    pub(crate) fn condition(&self, condition: Condition) -> String {
        let Condition::Compare {
            left,
            relation,
            right,
        } = condition
        else {
            panic!("flags are beyond the peers")
        };
        let relation = match relation {
            Relation::Eq => "==",
            Relation::Ne => self.not_equal,
            Relation::Lt => "<",
            Relation::Gt => ">",
            Relation::Le => "<=",
            Relation::Ge => ">=",
        };
        format!("{} {relation} {}", self.operand(left), self.operand(right))
    }

    /// The assignments of an equation; nothing if the action is none.
    pub(crate) fn sets(&self, action: &Action) -> Option<Vec<Set>> {
        match action {
            Action::SetScalar {
                target,
                update,
                value,
            } => {
                let (value, is_calculated) = match *value {
                    ScalarExpression::Operand(operand) => (self.operand(operand), false),
                    ScalarExpression::Binary {
                        left,
                        operation,
                        right,
                    } => {
                        let (left, right) = (self.operand(left), self.operand(right));
                        (infix(&left, operation, &right), true)
                    }
                    _ => panic!("functions are beyond the peers"),
                };
                Some(vec![updated(
                    self.place(*target),
                    *update,
                    value,
                    is_calculated,
                )])
            }
            Action::SetStruct {
                target,
                update,
                value,
            } => {
                let members = 0..self.program.variables()[*target].size();
                let set = |member| {
                    let of = |operand: StructOperand| self.operand(operand.member(member));
                    let (value, is_calculated) = match *value {
                        StructExpression::Copy(operand) => (of(operand), false),
                        StructExpression::Binary {
                            left,
                            operation,
                            right,
                        } => (infix(&of(left), operation, &of(right)), true),
                        _ => panic!("functions are beyond the peers"),
                    };
                    let target = self.place(Scalar {
                        variable: *target,
                        member,
                    });
                    updated(target, *update, value, is_calculated)
                };
                Some(members.map(set).collect())
            }
            _ => None,
        }
    }

    /// The names of all numbers, members one by one.
    pub(crate) fn places(&self) -> Vec<String> {
        let variables = self.program.variables().iter().enumerate();
        variables
            .flat_map(|(variable, it)| {
                (0..it.size()).map(move |member| Scalar { variable, member })
            })
            .map(|scalar| self.place(scalar))
            .collect()
    }
}

fn updated(place: String, update: Option<Arithmetic>, value: String, is_calculated: bool) -> Set {
    match update {
        None => Set {
            place,
            value,
            is_calculated,
        },
        Some(operation) => Set {
            value: infix(&place, operation, &value),
            place,
            is_calculated: true,
        },
    }
}

pub(crate) fn infix(left: &str, operation: Arithmetic, right: &str) -> String {
    let sign = match operation {
        Arithmetic::Add => '+',
        Arithmetic::Sub => '-',
        Arithmetic::Mul => '*',
        Arithmetic::Div => '/',
    };
    format!("{left} {sign} {right}")
}
