//! What a client changes or asks while the program stands.

use super::message::{Evaluate, SetVariable};
use super::session::{Answer, Host, Session};
use super::shown;
use serde_json::json;
use tip_sim::Event;
use tip_sim::debug::{Discard, Move, Refused, Value};
use tip_sim::message::Debugging;

/// What a change begins with that may discard what was run after it.
const DISCARD: &str = "discard ";

impl<H: Host> Session<H> {
    pub(super) fn set_variable(&mut self, asked: &SetVariable) -> Answer {
        let debugger = &self.standing()?.debugger;
        let value = match asked.value.trim().parse::<f64>() {
            Ok(value) => value,
            Err(_) => match debugger.evaluate(&asked.value) {
                Ok(Value::Number(value)) => value,
                Ok(Value::Truth(_)) => {
                    let text = asked.value.trim().to_owned().into();
                    return Err(self.text(Debugging::Truth { text }));
                }
                Err(refused) => return Err(refused.text(self.lang())),
            },
        };
        let name = asked.name.trim().to_ascii_uppercase();
        self.change(Event::Set(name.clone(), value), Discard::Nothing)?;
        let lang = self.lang();
        let debugger = &self.standing()?.debugger;
        let value = debugger.value(&name).ok().flatten();
        Ok(Some(json!({ "value": shown::number(value, lang) })))
    }

    /// Makes something happen. In the past it is refused at first; asking for the same again confirms it.
    fn change(&mut self, event: Event, discard: Discard) -> Result<(), String> {
        let lang = self.lang();
        let confirmed = self.refused.take();
        let debugger = &mut self.standing()?.debugger;
        let this = (debugger.now(), event.to_string());
        let discard = match confirmed.as_ref() == Some(&this) {
            true => Discard::Later,
            false => discard,
        };
        match debugger.happens(event, discard) {
            Ok(()) => {
                if self.client.supports_invalidated_event {
                    self.event("invalidated", Some(json!({ "areas": ["all"] })));
                }
                Ok(())
            }
            Err(refused @ Refused::WouldDiscard(_)) => {
                self.refused = Some(this);
                let refused = refused.text(lang).into();
                let again = Debugging::AgainConfirms { refused };
                Err(again.in_lang(lang).to_string())
            }
            Err(refused) => Err(refused.text(lang)),
        }
    }

    /// An expression; in the console also something that happens, `N = 5`, or `to 300`.
    pub(super) fn evaluate(&mut self, asked: &Evaluate) -> Answer {
        let text = asked.expression.trim();
        if asked.context.as_deref() == Some("repl")
            && let Some(done) = self.command(text)
        {
            done?;
            return Ok(Some(json!({ "result": "", "variablesReference": 0 })));
        }
        let lang = self.lang();
        let debugger = &self.standing()?.debugger;
        let name = text.to_ascii_uppercase();
        let variables = debugger.variables();
        if let Some((place, variable)) = (0..).zip(&variables).find(|(_, it)| it.name == name) {
            return Ok(Some(json!({
                "result": shown::value(variable, lang),
                "variablesReference": shown::reference(place, variable),
            })));
        }
        let result = match debugger.value(text) {
            Ok(value) => shown::number(value, lang),
            Err(_) => match debugger.evaluate(text) {
                Ok(Value::Number(value)) => value.to_string(),
                Ok(Value::Truth(truth)) => truth.to_string(),
                Err(refused) => return Err(refused.text(lang)),
            },
        };
        Ok(Some(json!({ "result": result, "variablesReference": 0 })))
    }

    /// What a line of the console does, if it is a command.
    fn command(&mut self, text: &str) -> Option<Result<(), String>> {
        if let Some(cycle) = text.strip_prefix("to ") {
            let cycle = cycle.trim().parse().ok()?;
            self.has_moved = true;
            return Some(self.go(Move::To(cycle)).map(|_| ()));
        }
        let (discard, rest) = match text.strip_prefix(DISCARD) {
            Some(rest) => (Discard::Later, rest.trim()),
            None => (Discard::Nothing, text),
        };
        let event = rest.parse().ok().or_else(|| Event::assignment(rest))?;
        Some(self.change(event, discard))
    }
}
