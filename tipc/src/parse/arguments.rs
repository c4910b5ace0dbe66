//! Operands in a row, as commands have them.

use super::reader::{Fault, Parsed, Reader};
use crate::foreign;
use crate::lex::{DELIMITERS, Kind, Token};
use crate::message::{Habit, Message, Parsing};
use crate::syntax::{Operand, upper_case};

impl Reader<'_> {
    /// Operands up to the end; at the first bad one, those before it and what is wrong.
    ///
    /// After an operand a sign belongs to the next one and needs a delimiter before it.
    pub(super) fn operands(&mut self) -> (Vec<Operand>, Parsed<()>) {
        let mut operands = Vec::with_capacity(self.left());
        while let Some(token) = self.peek() {
            let is_sign = token.kind != Kind::Word;
            if is_sign && !token.spaced && !operands.is_empty() {
                return (operands, Err(self.glued(token)));
            }
            match self.operand() {
                Ok(operand) => operands.push(operand),
                Err(fault) => return (operands, Err(fault)),
            }
        }
        (operands, Ok(()))
    }

    fn glued(&self, token: Token) -> Fault {
        let text = self.slice(token.span).into();
        let reason = Parsing::BetweenArguments { text };
        let help: Message = match token.kind {
            // `50 mm/s`
            Kind::Arithmetic(_)
                if self
                    .before()
                    .is_some_and(|it| foreign::is_unit(self.slice(it.span))) =>
            {
                Habit::NoUnit.into()
            }
            Kind::Arithmetic(_) if self.names_axes() => Habit::ArgumentNames.into(),
            Kind::Arithmetic(_) => Habit::CalculateArgument.into(),
            Kind::Assign(_) => Habit::ArgumentNames.into(),
            Kind::Colon if self.names_axes() => Habit::ArgumentNames.into(),
            _ => Parsing::SeparateArguments.into(),
        };
        self.fault_with_help(token.span, reason, help)
    }

    /// `X100 Y200 Z-50`, as in G-code, or `X:100`.
    fn names_axes(&self) -> bool {
        let mut words = self.slice(self.whole()).split(DELIMITERS);
        words.any(|word| foreign::axis_value(&upper_case(word).replace(':', "")).is_some())
    }
}
