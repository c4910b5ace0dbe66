//! Types of equations (T.I.P. 3.1 §5).

use super::names::ResolvedOperand;
use super::resolve::Resolver;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::functions::{self, Operation};
use crate::message::phrase::{Operands, Type};
use crate::message::{Calculating, Message, Naming, Parsing, Suggestion};
use crate::program::{Action, Axis, ScalarExpression, StructExpression, StructOperand};
use crate::source::Span;
use crate::symbols::Access;
use crate::syntax::{Equation, Expression, Operand, OperandKind, VariableKind, Word};
use tip_runtime::function::Function;

/// The right side of an equation with its type.
enum Value {
    Scalar(ScalarExpression),
    Struct(VariableKind, StructExpression),
}

impl Resolver<'_> {
    pub(super) fn equation(&mut self, equation: &Equation) -> Option<Action> {
        let guess = self.type_in(equation);
        let target = self
            .resolve_operand_as(&equation.target, Code::Equation, guess)
            .ok();
        if let Some(target) = target {
            let access = match equation.update {
                Some(_) => Access::Update,
                None => Access::Assign,
            };
            self.uses.operand(&equation.target, target, access);
        }
        let value = self.expression(&equation.value, target, guess);
        let assignment = self.assignment(equation, target?, value?)?;
        self.warn_of_domain(equation);
        Some(assignment)
    }

    fn assignment(
        &mut self,
        equation: &Equation,
        target: ResolvedOperand,
        value: Value,
    ) -> Option<Action> {
        let update = equation.update;
        let location = equation.target.span;
        match (target, value) {
            (ResolvedOperand::Constant(_), _) => self.refuse_with(
                Code::Equation,
                location,
                Parsing::ConstantAssigned,
                Calculating::LeftSideIs,
            ),
            (ResolvedOperand::Reading { reading, .. }, _) => {
                let word = reading.to_string().into();
                let reason = Naming::ReadingAssigned { word };
                self.refuse_with(Code::Equation, location, reason, Calculating::LeftSideIs)
            }
            (
                ResolvedOperand::Scalar { negative: true, .. }
                | ResolvedOperand::Struct { negative: true, .. },
                _,
            ) => self.refuse(Code::Equation, location, Calculating::LeftSideSign),
            (ResolvedOperand::Scalar { scalar, .. }, Value::Scalar(value)) => {
                Some(Action::SetScalar {
                    target: scalar,
                    update,
                    value,
                })
            }
            (ResolvedOperand::Struct { variable, kind, .. }, Value::Struct(of, value))
                if kind == of =>
            {
                Some(Action::SetStruct {
                    target: variable,
                    update,
                    value,
                })
            }
            (target, value) => {
                let reason = Calculating::SidesDiffer {
                    left: type_of(kind_of(target)),
                    right: type_of(value.kind()),
                };
                let fault =
                    Diagnostic::new(Code::Equation, expression_span(&equation.value), reason)
                        .label(location, Calculating::LeftSide);
                self.report(fault.help(Calculating::OneType));
                None
            }
        }
    }

    /// Returns the type of an equation, if an operand shows it: all operands have one type, except those of functions.
    fn type_in(&self, equation: &Equation) -> Option<VariableKind> {
        let known = |operand: &Operand| match &operand.kind {
            OperandKind::Number(_) | OperandKind::Member(_) => Some(VariableKind::Var),
            OperandKind::Name(name) => self.names.kind_of(name),
        };
        match &equation.value {
            Expression::Operand(operand) => known(operand),
            Expression::Binary { left, right, .. } => known(left).or_else(|| known(right)),
            Expression::Function { name, .. } => {
                match functions::find(&name.node, self.names.edition)? {
                    Operation::Scalar(_) | Operation::Atan2 | Operation::Norm => {
                        Some(VariableKind::Var)
                    }
                    Operation::UnitVect | Operation::Rotate(_) => Some(VariableKind::Pos),
                }
            }
        }
        .or_else(|| known(&equation.target))
    }

    /// Resolves the right side. `target` is the type of the left side, if known; `guess` is the type that an undeclared
    /// name is used as.
    fn expression(
        &mut self,
        expression: &Expression,
        target: Option<ResolvedOperand>,
        guess: Option<VariableKind>,
    ) -> Option<Value> {
        match expression {
            Expression::Operand(operand) => {
                let meant = self.value(operand, guess)?;
                match meant.structure() {
                    Some((whole, kind, _)) => {
                        Some(Value::Struct(kind, StructExpression::Copy(whole)))
                    }
                    None => Some(Value::Scalar(ScalarExpression::Operand(meant.number()?))),
                }
            }
            Expression::Binary {
                left,
                operation,
                right,
            } => {
                let (first, second) = (self.value(left, guess), self.value(right, guess));
                let (first, second) = (first?, second?);
                match (first.structure(), second.structure()) {
                    (Some((left, kind, _)), Some((right, of, _))) if kind == of => {
                        Some(Value::Struct(
                            kind,
                            StructExpression::Binary {
                                left,
                                operation: *operation,
                                right,
                            },
                        ))
                    }
                    _ => match (first.number(), second.number()) {
                        (Some(left), Some(right)) => {
                            Some(Value::Scalar(ScalarExpression::Binary {
                                left,
                                operation: *operation,
                                right,
                            }))
                        }
                        _ => {
                            let reason = Calculating::NotTogether {
                                first: type_of(kind_of(first)),
                                second: type_of(kind_of(second)),
                            };
                            let location = match target.map(kind_of) {
                                Some(wanted) if wanted == kind_of(first) => right.span,
                                _ => left.span.to(right.span),
                            };
                            let fault = Diagnostic::new(Code::Equation, location, reason);
                            let is_number = kind_of(first).is_none() || kind_of(second).is_none();
                            let help: Message = match is_number {
                                true => Suggestion::MemberByMember.into(),
                                false => Calculating::OneType.into(),
                            };
                            self.report(fault.help(help));
                            None
                        }
                    },
                }
            }
            Expression::Function { name, operands } => self.function(name, operands),
        }
    }

    fn function(&mut self, name: &Word, operands: &[Operand]) -> Option<Value> {
        let operation = functions::find(&name.node, self.names.edition)?;
        let wanted = operation.operands();
        if operands.len() != wanted {
            let location = operands.get(wanted).map_or(name.span, |extra| extra.span);
            let reason = Calculating::OtherOperands {
                function: name.node.clone(),
                wanted: match wanted {
                    1 => Operands::One,
                    _ => Operands::Two,
                },
                found: operands.len(),
            };
            let fault = Diagnostic::new(Code::Equation, location, reason);
            let help = match (operation, operands.len()) {
                // `ATAN y x`
                (Operation::Scalar(Function::Atan), 2) => usage(Operation::Atan2),
                _ => usage(operation),
            };
            self.report(fault.help(help));
            return None;
        }
        match operation {
            Operation::Atan2 => {
                let y = self.number(&operands[0], Code::Equation).ok();
                let x = self.number(&operands[1], Code::Equation).ok();
                Some(Value::Scalar(ScalarExpression::Atan2 { y: y?, x: x? }))
            }
            Operation::Norm => {
                let (variable, _) = self.structure(&operands[0], None)?;
                Some(Value::Scalar(ScalarExpression::Norm(variable)))
            }
            Operation::UnitVect => {
                let (variable, kind) = self.structure(&operands[0], Some(VariableKind::Pos))?;
                Some(Value::Struct(kind, StructExpression::UnitVect(variable)))
            }
            Operation::Rotate(axis) => self.rotation(axis, operands),
            Operation::Scalar(function) => {
                let operand = self.number(&operands[0], Code::Equation).ok()?;
                Some(Value::Scalar(ScalarExpression::Function {
                    function,
                    operand,
                }))
            }
        }
    }

    fn rotation(&mut self, axis: Axis, operands: &[Operand]) -> Option<Value> {
        let turned = self.structure(&operands[0], Some(VariableKind::Pos));
        // Operands in the wrong order are one mistake; two undeclared names are two.
        if turned.is_none() && self.is_declared(&operands[0]) {
            return None;
        }
        let angle = self.variable_or_constant(&operands[1], Code::Equation).ok();
        let ((operand, kind), angle) = (turned?, angle?);
        Some(Value::Struct(
            kind,
            StructExpression::Rotate {
                axis,
                operand,
                angle,
            },
        ))
    }

    fn is_declared(&self, operand: &Operand) -> bool {
        match &operand.kind {
            OperandKind::Name(name) => self.names.kind_of(name).is_some(),
            OperandKind::Number(_) | OperandKind::Member(_) => true,
        }
    }

    /// Resolves a whole struct; if `kind` is given, one of that type.
    fn structure(
        &mut self,
        operand: &Operand,
        kind: Option<VariableKind>,
    ) -> Option<(StructOperand, VariableKind)> {
        match self.value(operand, kind)?.structure() {
            Some((whole, of, _)) if kind.is_none_or(|kind| kind == of) => Some((whole, of)),
            _ => {
                let wanted = kind.map_or(Type::PosOrJoint, |kind| type_of(Some(kind)));
                let reason = Calculating::BelongsHere { wanted };
                self.refuse_with(
                    Code::Equation,
                    operand.span,
                    reason,
                    Calculating::WholeVariable,
                )
            }
        }
    }

    /// Resolves an operand that the equation reads, as a variable of this type; a struct has no sign.
    fn value(&mut self, operand: &Operand, guess: Option<VariableKind>) -> Option<ResolvedOperand> {
        let meant = self
            .resolve_operand_as(operand, Code::Equation, guess)
            .ok()?;
        self.uses.operand(operand, meant, Access::Read);
        if let Some((_, _, true)) = meant.structure() {
            return self.refuse_with(
                Code::Equation,
                operand.span,
                Calculating::StructSign,
                Calculating::ChangeMembers,
            );
        }
        Some(meant)
    }
}

/// Returns the message that shows the form of a function.
fn usage(operation: Operation) -> Calculating {
    let function = operation.word();
    match operation {
        Operation::Atan2 => Calculating::WriteOfTwo { function },
        Operation::Norm => Calculating::WriteOfStruct { function },
        Operation::UnitVect => Calculating::WriteOfPos { function },
        Operation::Rotate(_) => Calculating::WriteRotation { function },
        Operation::Scalar(_) => Calculating::WriteFunction { function },
    }
}

impl Value {
    fn kind(&self) -> Option<VariableKind> {
        match self {
            Value::Scalar(_) => None,
            Value::Struct(kind, _) => Some(*kind),
        }
    }
}

fn kind_of(meant: ResolvedOperand) -> Option<VariableKind> {
    meant.structure().map(|(_, kind, _)| kind)
}

/// Returns the type of an operand; `None` is a number.
pub(super) fn type_of(kind: Option<VariableKind>) -> Type {
    match kind {
        Some(VariableKind::Pos) => Type::Pos,
        Some(VariableKind::Joint) => Type::Joint,
        Some(VariableKind::Var) | None => Type::Number,
    }
}

fn expression_span(expression: &Expression) -> Span {
    match expression {
        Expression::Operand(operand) => operand.span,
        Expression::Binary { left, right, .. } => left.span.to(right.span),
        Expression::Function { name, operands } => operands
            .last()
            .map_or(name.span, |last| name.span.to(last.span)),
    }
}
