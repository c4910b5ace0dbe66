//! What its user is asked, and what becomes of the answer.

use super::app::App;
use super::question::Question;
use tip_sim::Event;
use tip_sim::debug::{Discard, Move, Value, When};
use tip_sim::message::Debugging;
use tipc::message::Text;

impl App {
    pub(crate) fn ask(&mut self, question: Question) {
        self.answer = None;
        self.question = Some((question, String::new()));
    }

    /// The answer to the question is complete.
    pub(crate) fn answered(&mut self) {
        let Some((question, text)) = self.question.take() else {
            return;
        };
        let text = text.trim();
        match question {
            Question::Event => self.make_happen(text),
            Question::Expression => self.show_value(text),
            Question::Watch => {
                self.watch(text);
            }
            Question::Who => {
                if let Some(watch) = self.watch(text) {
                    self.go(Move::SetBack(watch));
                }
            }
            Question::Cycle => match text.parse() {
                Ok(cycle) => self.go(Move::To(cycle)),
                Err(_) => self.answer = Some(self.say(Debugging::NotANumber { text: word(text) })),
            },
            Question::Condition => self.ask(Question::Passes(text.to_owned())),
            Question::Passes(condition) => self.place(&When {
                condition: said(&condition),
                hits: said(text),
            }),
            Question::Name => self.stop_before(text),
            Question::Discard(..) => {}
        }
    }

    /// A change of the past is confirmed, or not.
    pub(crate) fn confirmed(&mut self, yes: bool) {
        if let Some((Question::Discard(event, _), _)) = self.question.take()
            && yes
        {
            self.change(event, Discard::Later);
        }
    }

    fn make_happen(&mut self, text: &str) {
        match text.parse().ok().or_else(|| Event::assignment(text)) {
            Some(event) => self.change(event, Discard::Nothing),
            None => {
                let text = word(text);
                self.answer = Some(self.say(Debugging::NeitherEventNorAssignment { text }));
            }
        }
    }

    fn show_value(&mut self, text: &str) {
        let unassigned = || self.say(Debugging::Unassigned);
        let value = match (self.debugger.value(text), self.debugger.evaluate(text)) {
            (Ok(value), _) => value.map_or_else(unassigned, |value| value.to_string()),
            (_, Ok(Value::Number(value))) => value.to_string(),
            (_, Ok(Value::Truth(truth))) => truth.to_string(),
            (_, Err(refused)) => return self.refuse(&refused),
        };
        let (text, value) = (word(text), word(&value));
        self.answer = Some(self.say(Debugging::Comes { text, value }));
    }

    /// Stops before every step of a name, or no more.
    fn stop_before(&mut self, name: &str) {
        let upper = name.trim_end_matches(':').to_ascii_uppercase();
        let name = word(&upper);
        if let Some(id) = self.named.remove(&upper) {
            self.debugger.remove_breakpoint(id);
            self.answer = Some(self.say(Debugging::StopsNoMore { name }));
            return;
        }
        match self.debugger.break_at_name(&upper, &When::default()) {
            Ok(placed) => {
                self.named.insert(upper, placed.id);
                self.answer = Some(self.say(Debugging::StopsBefore { name }));
            }
            Err(refused) => self.refuse(&refused),
        }
    }

    /// Watches a variable in the place of any other; without a name none.
    fn watch(&mut self, name: &str) -> Option<u32> {
        self.debugger.unwatch_all();
        self.watched = None;
        if name.is_empty() {
            return None;
        }
        match self.debugger.watch(name) {
            Ok(id) => {
                let upper = name.to_ascii_uppercase();
                let name = word(&upper);
                self.watched = Some(upper);
                self.answer = Some(self.say(Debugging::Watches { name }));
                Some(id)
            }
            Err(refused) => {
                self.refuse(&refused);
                None
            }
        }
    }
}

/// A text, unless it says nothing.
fn said(text: &str) -> Option<&str> {
    (!text.is_empty()).then_some(text)
}

fn word(text: &str) -> Text {
    Text::from(text.to_owned())
}
