//! Rust tokens of the arguments of commands and messages.

use super::expression::Values;
use super::ident;
use crate::program::{Argument, Mark, MessagePart, Operand, Scalar, VariableKind};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

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
