//! Rust tokens of operands, arguments, equations and conditions. Evaluation order is that of the tokens:
//! operands left to right, then the operation, then the left side of `op=`, then the result.

use super::ident;
use super::ident::{field, identifier};
use crate::analysis::assignment::Assignment;
use crate::program::{
    Argument, Arithmetic, Axis, Condition, Mark, MessagePart, Operand, Program, Relation, Scalar,
    ScalarExpression, StepId, StructExpression, StructOperand, Variable, VariableId, VariableKind,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Reads and assignments of one step.
pub(super) struct Values<'a> {
    pub(super) program: &'a Program,
    /// Reads that need no test.
    pub(super) assignment: &'a Assignment,
    /// The step.
    pub(super) step: StepId,
}

impl Values<'_> {
    /// Returns the place expression of a scalar.
    pub(super) fn place(&self, scalar: Scalar) -> TokenStream {
        place(&self.program.variables[scalar.variable], scalar.member)
    }

    /// Returns the value of a scalar, or its fault where it may have none.
    pub(super) fn read(&self, scalar: Scalar) -> TokenStream {
        let place = self.place(scalar);
        let index = self.program.scalar_index(scalar);
        if self.assignment.is_always(self.step, index) {
            return quote!(#place.value());
        }
        let index = Literal::usize_unsuffixed(index);
        quote!(#place.get(#index)?)
    }

    /// Returns the members of a struct, or the fault of the first one without a value.
    fn read_struct(&self, variable: VariableId) -> TokenStream {
        let variable = &self.program.variables[variable];
        let name = field(variable);
        let mut members = variable.first..variable.first + variable.size();
        if members.all(|member| self.assignment.is_always(self.step, member)) {
            return quote!(self.#name.map(Scalar::value));
        }
        let first = Literal::usize_unsuffixed(variable.first);
        quote!(ops::get_each(&self.#name, #first)?)
    }

    pub(super) fn operand(&self, operand: Operand) -> TokenStream {
        match operand {
            Operand::Constant(value) => ident::number(value),
            Operand::Scalar {
                scalar,
                negative: false,
            } => self.read(scalar),
            Operand::Scalar {
                scalar,
                negative: true,
            } => {
                let value = self.read(scalar);
                quote!(-#value)
            }
            Operand::Reading {
                reading,
                member,
                negative,
            } => {
                let (reading, member) =
                    (ident::reading(reading), Literal::usize_unsuffixed(member));
                let minus = negative.then(|| quote!(-));
                quote!(#minus cx.reading(#reading)?[#member])
            }
        }
    }

    /// Returns the members of a struct that is a variable or special variable.
    fn read_whole(&self, whole: StructOperand) -> TokenStream {
        match whole {
            StructOperand::Variable(variable) => self.read_struct(variable),
            StructOperand::Reading(reading) => {
                let size = match VariableKind::of_reading(reading) {
                    VariableKind::Joint => usize::from(self.program.signature.joints),
                    VariableKind::Pos | VariableKind::Var => 3,
                };
                let members: Vec<Ident> = (1..=size)
                    .map(|member| format_ident!("m{member}"))
                    .collect();
                let reading = ident::reading(reading);
                quote!({
                    let [#(#members,)* ..] = cx.reading(#reading)?;
                    [#(#members),*]
                })
            }
        }
    }

    /// Returns the code before an assignment, and the value to assign or its fault: a `Result`.
    pub(super) fn update(
        &self,
        target: Scalar,
        operation: Arithmetic,
        value: ScalarExpression,
    ) -> (Option<TokenStream>, TokenStream) {
        let (operation, old) = (arithmetic(operation), self.read(target));
        if let ScalarExpression::Operand(Operand::Constant(value)) = value {
            let value = ident::number(value);
            return (None, quote!(#operation(#old, #value)));
        }
        let value = match value {
            ScalarExpression::Operand(operand) => self.operand(operand),
            calculated => {
                let calculated = self.calculated(calculated);
                quote!(#calculated?)
            }
        };
        (
            Some(quote!(let value = #value;)),
            quote!(#operation(#old, value)),
        )
    }

    /// Returns the value of an expression or its fault: a `Result`.
    pub(super) fn calculated(&self, value: ScalarExpression) -> TokenStream {
        match value {
            ScalarExpression::Operand(operand) => {
                let operand = self.operand(operand);
                quote!(Ok(#operand))
            }
            ScalarExpression::Binary {
                left,
                operation,
                right,
            } => {
                let operation = arithmetic(operation);
                let (left, right) = (self.operand(left), self.operand(right));
                quote!(#operation(#left, #right))
            }
            ScalarExpression::Function { function, operand } => {
                let leaf = identifier(function.leaf());
                let operand = self.operand(operand);
                quote!(ops::#leaf(#operand))
            }
            ScalarExpression::Atan2 { y, x } => {
                let (y, x) = (self.operand(y), self.operand(x));
                quote!(ops::atan2(#y, #x))
            }
            ScalarExpression::Norm(whole) => {
                let members = self.read_whole(whole);
                quote!(ops::norm(#members))
            }
        }
    }

    pub(super) fn set_struct(
        &self,
        target: VariableId,
        update: Option<Arithmetic>,
        value: StructExpression,
    ) -> TokenStream {
        let place = field(&self.program.variables[target]);
        let value = self.struct_expression(value);
        match update {
            None => quote!(self.#place = #value.map(Scalar::of);),
            Some(operation) => {
                let old = self.read_struct(target);
                let operation = arithmetic_each(operation);
                quote! {
                    let value = #value;
                    self.#place = #operation(#old, value)?.map(Scalar::of);
                }
            }
        }
    }

    fn struct_expression(&self, value: StructExpression) -> TokenStream {
        match value {
            StructExpression::Copy(whole) => self.read_whole(whole),
            StructExpression::Binary {
                left,
                operation,
                right,
            } => {
                let operation = arithmetic_each(operation);
                let (left, right) = (self.read_whole(left), self.read_whole(right));
                quote!(#operation(#left, #right)?)
            }
            StructExpression::UnitVect(whole) => {
                let members = self.read_whole(whole);
                quote!(ops::unit_vect(#members)?)
            }
            StructExpression::Rotate {
                axis,
                operand,
                angle,
            } => {
                let turn = match axis {
                    Axis::X => quote!(ops::rot_x),
                    Axis::Y => quote!(ops::rot_y),
                    Axis::Z => quote!(ops::rot_z),
                };
                let (members, angle) = (self.read_whole(operand), self.operand(angle));
                quote!(#turn(#members, #angle)?)
            }
        }
    }

    pub(super) fn condition(&self, condition: Condition) -> TokenStream {
        match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => {
                let relation = relational(relation);
                let (left, right) = (self.operand(left), self.operand(right));
                quote!(#left #relation #right)
            }
            Condition::Flag { flag, negated } => {
                let flag = ident::flag(flag);
                let not = negated.then(|| quote!(!));
                quote!(#not cx.flag(#flag))
            }
        }
    }
}

/// Returns the place expression of a member of a variable; of a VAR that is the variable.
pub(super) fn place(variable: &Variable, member: usize) -> TokenStream {
    let name = field(variable);
    match variable.kind {
        VariableKind::Var => quote!(self.#name),
        VariableKind::Pos | VariableKind::Joint => {
            let member = Literal::usize_unsuffixed(member);
            quote!(self.#name[#member])
        }
    }
}

fn arithmetic(operation: Arithmetic) -> TokenStream {
    match operation {
        Arithmetic::Add => quote!(ops::add),
        Arithmetic::Sub => quote!(ops::sub),
        Arithmetic::Mul => quote!(ops::mul),
        Arithmetic::Div => quote!(ops::div),
    }
}

fn arithmetic_each(operation: Arithmetic) -> TokenStream {
    match operation {
        Arithmetic::Add => quote!(ops::add_each),
        Arithmetic::Sub => quote!(ops::sub_each),
        Arithmetic::Mul => quote!(ops::mul_each),
        Arithmetic::Div => quote!(ops::div_each),
    }
}

fn relational(relation: Relation) -> TokenStream {
    match relation {
        Relation::Eq => quote!(==),
        Relation::Ne => quote!(!=),
        Relation::Lt => quote!(<),
        Relation::Gt => quote!(>),
        Relation::Le => quote!(<=),
        Relation::Ge => quote!(>=),
    }
}

impl Values<'_> {
    /// Returns the operands of a command, as an array of values. An array of numbers alone is a constant of the
    /// program, which a step need not make, since it calls no function.
    pub(super) fn of_arguments(&self, arguments: &[Argument]) -> TokenStream {
        if let Some(members) = self.whole_struct(arguments) {
            return quote!(#members.map(Value::Absolute));
        }
        let values = arguments.iter().map(|argument| {
            let number = self.operand(argument.operand);
            match argument.mark {
                Mark::None => quote!(Value::Absolute(#number)),
                Mark::Relative => quote!(Value::Relative(#number)),
                Mark::Absolute => quote!(Value::Fixed(#number)),
            }
        });
        quote!([#(#values),*])
    }

    /// Returns the members of a struct, if they are the operands, all and in order.
    fn whole_struct(&self, arguments: &[Argument]) -> Option<TokenStream> {
        let variable = match arguments.first()?.operand {
            Operand::Scalar { scalar, .. } => scalar.variable,
            Operand::Constant(_) | Operand::Reading { .. } => return None,
        };
        let members = (0..self.program.variables[variable].size()).map(|member| Argument {
            operand: Operand::Scalar {
                scalar: Scalar { variable, member },
                negative: false,
            },
            mark: Mark::None,
        });
        let is_struct = self.program.variables[variable].kind != VariableKind::Var;
        let is_whole = arguments.iter().copied().eq(members);
        (is_struct && is_whole).then(|| self.read_struct(variable))
    }

    /// Returns the code that hands a text to `show`, a method of the context.
    pub(super) fn message(&self, show: &Ident, parts: &[MessagePart]) -> TokenStream {
        let plain: Option<String> = parts.iter().map(text).collect();
        if let Some(plain) = plain {
            return quote!(cx.#show(&#plain););
        }
        let parts = parts.iter().map(|part| match part {
            MessagePart::Text(text) => quote!(Part::Text(#text)),
            MessagePart::Value { operand, decimals } => {
                let (value, decimals) = (self.operand(*operand), ident::small(*decimals));
                quote!(Part::Number(#value, #decimals))
            }
        });
        quote!(cx.#show(&Message(&[#(#parts),*]));)
    }
}

fn text(part: &MessagePart) -> Option<&str> {
    match part {
        MessagePart::Text(text) => Some(text),
        MessagePart::Value { .. } => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::emit::{Options, emit};
    use crate::fixture::{program, read};
    use crate::program::{Action, MessagePart};

    // clauses: 7.38
    #[test]
    fn a_message_without_values_is_shown_as_it_is() {
        let text = || MessagePart::Text("Hello ".to_owned());
        let value = MessagePart::Value {
            operand: read(0),
            decimals: 1,
        };
        for (parts, shown) in [
            (vec![text()], "message (& \"Hello \")"),
            (
                vec![text(), value],
                "message (& Message (& [Part :: Text (\"Hello \") ,",
            ),
        ] {
            let program = program(&[], vec![Action::Message { parts }]);
            let emitted = emit(&program, &Options::default()).to_string();
            assert!(emitted.contains(shown), "{emitted}");
        }
    }
}
