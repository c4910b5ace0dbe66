//! Rust tokens of steps: each is a row of the table of states, or a function that the row leads to.

use super::expression::Values;
use super::ident::{field, identifier, in_comment, state};
use super::{Emitter, ident};
use crate::program::{Action, Argument, End, Operand, ScalarExpression, StepId};
use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::{format_ident, quote};
use std::collections::BTreeSet;

/// The generated form of a step.
pub(super) enum State {
    /// A row that needs no code.
    Row(TokenStream),
    /// The body of a function; its value is a `Result<Flow, Fault>`.
    Function(TokenStream),
}

impl Emitter<'_> {
    /// Generates the form of a step with this action.
    pub(super) fn state(&self, step: StepId, action: &Action) -> State {
        let next = step + 1;
        let values = Values {
            program: self.program,
            assignment: &self.assignment,
            step,
        };
        let body = match action {
            Action::Nothing => return self.row_of_move(next),
            Action::SetScalar {
                target,
                update,
                value,
            } => {
                let place = values.place(*target);
                let (before, value) = match (update, *value) {
                    (Some(operation), value) => values.update(*target, *operation, value),
                    (None, ScalarExpression::Operand(operand)) => {
                        let (value, go) = (values.operand(operand), self.go(next));
                        return State::Function(quote!(#place.set(#value); #go));
                    }
                    (None, value) => (None, values.calculated(value)),
                };
                let after = self.after(quote!(#place.assign(#value)), next);
                quote!(#before #after)
            }
            Action::SetStruct {
                target,
                update,
                value,
            } => {
                let go = self.go(next);
                let set = values.set_struct(*target, *update, *value);
                quote!(#set #go)
            }
            Action::If {
                condition,
                otherwise,
            } => {
                let condition = values.condition(*condition);
                let (go, skip) = (self.go(next), self.skip(*otherwise));
                quote!(if #condition { #go } else { #skip })
            }
            Action::ElseIf {
                condition,
                otherwise,
            } => {
                let condition = values.condition(*condition);
                let (go, pass) = (self.go(next), self.go(*otherwise));
                let skip = self.skip(*otherwise);
                quote! {
                    if !self.not_taken { #pass } else if #condition { #go } else { #skip }
                }
            }
            Action::Else { end } => {
                let (go, pass) = (self.go(next), self.go(*end));
                quote!(if self.not_taken { #go } else { #pass })
            }
            Action::While { condition, exit } => {
                let condition = values.condition(*condition);
                let (go, exit) = (self.go(next), self.go(*exit));
                quote!(if #condition { #go } else { #exit })
            }
            Action::Goto { to } => return self.row_of_move(*to),
            Action::Until { condition, back } => {
                let condition = values.condition(*condition);
                let (go, back) = (self.go(next), self.go(*back));
                quote!(if #condition { #go } else { #back })
            }
            Action::For {
                variable,
                from,
                to,
                step,
                exit,
            } => {
                let (from, to, by) = (
                    values.operand(*from),
                    values.operand(*to),
                    values.operand(*step),
                );
                let place = values.place(*variable);
                self.branch(quote!(#place.begin(#from, #to, #by)), next, *exit)
            }
            Action::Next {
                variable,
                to,
                step,
                body,
            } => {
                let (old, by, to) = (
                    values.read(*variable),
                    values.operand(*step),
                    values.operand(*to),
                );
                let place = values.place(*variable);
                self.branch(quote!(#place.advance(#old, #by, #to)), *body, next)
            }
            Action::IfGoto { condition, to } => {
                let condition = values.condition(*condition);
                let (jump, go) = (self.go(*to), self.go(next));
                quote!(if #condition { #jump } else { #go })
            }
            Action::Gosub { to } => self.call(*to, next),
            Action::IfGosub { condition, to } => {
                let condition = values.condition(*condition);
                let (call, go) = (self.call(*to, next), self.go(next));
                quote!(if #condition { #call } else { #go })
            }
            Action::Return if self.has_threads() => quote!(self.back()),
            Action::Return => quote! {
                let back = self.calls.pop()?;
                self.go(back)
            },
            Action::Finish(End::End) => quote!(Ok(Flow::Finished(End::End))),
            Action::Finish(End::Exit) => quote!(Ok(Flow::Finished(End::Exit))),
            Action::Command {
                op,
                hs,
                target,
                arguments,
            } => {
                let (op, target) = (ident::op(*op), ident::target(*target));
                let values = values.of_arguments(arguments);
                let command =
                    quote!(&Command { op: #op, hs: #hs, target: #target, values: &#values });
                let next = self.step_number(next);
                if arguments.iter().all(is_constant) {
                    return State::Row(quote!(Step::ask(#command, #next)));
                }
                quote! {
                    let command = #command;
                    cx.ask(command, &mut self.at, #next)
                }
            }
            Action::TeachStruct { what, target, into } => {
                let (what, target) = (ident::teach(*what), ident::target(*target));
                let variable = &self.program.variables[*into];
                let place = field(variable);
                let members: Vec<Ident> = (1..=variable.size())
                    .map(|member| format_ident!("m{member}"))
                    .collect();
                let go = self.go(next);
                quote! {
                    let [#(#members,)* ..] = cx.teach(#what, #target)?;
                    self.#place = [#(#members),*].map(Scalar::of);
                    #go
                }
            }
            Action::TeachScalar { what, target, into } => {
                let place = values.place(*into);
                let (what, target) = (ident::teach(*what), ident::target(*target));
                let go = self.go(next);
                quote! {
                    let [measured, ..] = cx.teach(#what, #target)?;
                    #place.set(measured);
                    #go
                }
            }
            Action::AdIn { port, into } => {
                let (place, port) = (values.place(*into), ident::port(*port));
                let go = self.go(next);
                quote!(#place.set(cx.analog(#port)?); #go)
            }
            Action::KeyIn { into } => {
                let place = values.place(*into);
                let go = self.go(next);
                quote!(if let Some(key) = cx.key() {
                    #place.set(key as f64);
                    #go
                } else {
                    Ok(Flow::Wait)
                })
            }
            Action::StartThread { thread } => {
                let (thread, go) = (ident::thread(*thread), self.go(next));
                quote!(cx.start_thread(#thread)?; #go)
            }
            Action::StopThread { thread } => {
                let (thread, go) = (ident::thread(*thread), self.go(next));
                quote!(cx.stop_thread(#thread); #go)
            }
            Action::WaitThread { thread } => {
                let (thread, go) = (ident::thread(*thread), self.go(next));
                quote!(match cx.wait_thread(#thread)? {
                    Poll::Done => #go,
                    Poll::Pending => Ok(Flow::Wait),
                })
            }
            Action::ThreadEnd => quote!(self.threads.end()),
            Action::FileMessage { parts } => {
                let text = values.message(&format_ident!("append"), parts);
                let go = self.go(next);
                quote!(#text #go)
            }
            Action::Message { parts } => {
                let text = values.message(&format_ident!("message"), parts);
                let go = self.go(next);
                quote!(#text #go)
            }
        };
        State::Function(body)
    }

    /// Returns a row that only leads on to a step.
    fn row_of_move(&self, to: StepId) -> State {
        let to = self.step_number(to);
        State::Row(quote!(Step::go(#to)))
    }

    /// Returns the code that goes on to a step, "taken".
    fn go(&self, step: StepId) -> TokenStream {
        let step = self.step_number(step);
        quote!(self.go(#step))
    }

    /// Returns the code that goes from a false IF or ELSEIF on to a step, "not taken".
    fn skip(&self, step: StepId) -> TokenStream {
        let step = self.step_number(step);
        if self.has_taken_state {
            quote!(self.skip(#step))
        } else {
            quote!(self.go(#step))
        }
    }

    fn call(&self, to: StepId, back: StepId) -> TokenStream {
        let (to, back) = (self.step_number(to), self.step_number(back));
        quote!(self.call(#to, #back))
    }

    /// Returns the code that goes on to a step after what may fail: one `?` for all steps, since compiling one takes
    /// longer than all the rest of a short step.
    fn after(&self, done: TokenStream, step: StepId) -> TokenStream {
        let step = self.step_number(step);
        quote! {
            let done = #done;
            self.after(done, #step)
        }
    }

    /// Returns the code that goes on to one of two steps after a test that may fail.
    fn branch(&self, test: TokenStream, yes: StepId, no: StepId) -> TokenStream {
        let (yes, no) = (self.step_number(yes), self.step_number(no));
        quote! {
            let passes = #test;
            self.branch(passes, #yes, #no)
        }
    }

    /// Returns a step's number, or the constant of the label that stands there.
    fn step_number(&self, step: StepId) -> TokenStream {
        match self.labels.binary_search_by_key(&step, |(at, _)| *at) {
            Ok(label) => {
                let name = &self.labels[label].1;
                quote!(Self::#name)
            }
            Err(_) => {
                let step = Literal::u32_unsuffixed(step);
                quote!(#step)
            }
        }
    }
}

fn is_constant(argument: &Argument) -> bool {
    matches!(argument.operand, Operand::Constant(_))
}

/// The states of a program.
#[derive(Default)]
pub(super) struct States {
    /// The source line of each step.
    pub(super) lines: TokenStream,
    rows: TokenStream,
    /// Functions of the rows that need code, and of what moves between states.
    functions: TokenStream,
    /// The words that rows and functions mention.
    pub(super) mentioned: BTreeSet<String>,
}

/// Generated code of a step.
struct GeneratedStep {
    row: TokenStream,
    /// Function that the row leads to, if it needs code.
    function: TokenStream,
}

impl Emitter<'_> {
    /// Returns the states, and what moves between them.
    pub(super) fn states(&self) -> States {
        let mut states = States::default();
        for (step, id) in self.program.steps.iter().zip(0..) {
            let line = Literal::u32_unsuffixed(step.line);
            states.lines.extend(quote!(#line,));
            let GeneratedStep { row, function } = self.generate_step(id);
            states.mention([&row, &function]);
            states.rows.extend(row);
            states.functions.extend(function);
        }
        states.mentioned.insert("Step".to_owned());
        states.mention([&self.state_impl(&TokenStream::new())]);
        let moves = self.moves(&states.mentioned);
        states.mention([&moves]);
        states.functions.extend(moves);
        states
    }

    /// Generates the code of one step.
    fn generate_step(&self, id: StepId) -> GeneratedStep {
        let step = &self.program.steps[id as usize];
        let doc = format!(" {}:{}: {}", self.program.source_name, step.line, step.text);
        let doc = in_comment(&doc);
        match self.state(id, &step.action) {
            State::Row(row) => GeneratedStep {
                row: quote!(#[doc = #doc] #row,),
                function: TokenStream::new(),
            },
            State::Function(body) => {
                let name = state(id);
                GeneratedStep {
                    row: quote!(Step::run(Self::#name),),
                    function: function(&name, &doc, &body),
                }
            }
        }
    }

    /// Returns the table and its functions, in a scope of their own for what they import.
    pub(super) fn table(&self, states: &States) -> TokenStream {
        let States {
            rows,
            functions,
            mentioned,
            ..
        } = states;
        let imports = self.imports(mentioned);
        let name = &self.name;
        // A type that has the name of an import can only be meant outside of this scope.
        let mut imported = BTreeSet::new();
        collect_words(&imports, &mut imported);
        let name = match imported.contains(&name.to_string()) {
            true => quote!(self::#name),
            false => quote!(#name),
        };
        let state = self.state_impl(&name);
        quote! {
            #[allow(unused_qualifications, clippy::all, clippy::pedantic)]
            const _: () = {
                #imports
                impl #name {
                    #[allow(unused_doc_comments)]
                    const STEPS: &'static [Step<Self>] = &[#rows];
                    #functions
                }
                #state
            };
        }
    }

    /// Imports what the states mention: no name of the surrounding scope can get in between.
    fn imports(&self, words: &BTreeSet<String>) -> TokenStream {
        let runtime = self.runtime;
        let option = import(quote!(::core::option::Option), words, &["Some"]);
        let result = import(quote!(::core::result), words, &["Result"]);
        let ok = import(quote!(::core::result::Result), words, &["Err", "Ok"]);
        let command = [
            "Command", "Flag", "Op", "Poll", "Port", "Reading", "Target", "Teach", "Value",
        ];
        let command = import(quote!(#runtime::command), words, &command);
        let fault = import(quote!(#runtime::fault), words, &["Fault"]);
        let row = import(
            quote!(#runtime::generated),
            words,
            &["Row", "State", "Step"],
        );
        let ops = import(runtime.clone(), words, &["ops"]);
        let values = import(
            quote!(#runtime::ops),
            words,
            &["Domain", "Message", "Part", "Scalar"],
        );
        let program = import(
            quote!(#runtime::program),
            words,
            &["Context", "End", "Flow"],
        );
        quote! {
            #option #result #ok #command #fault
            #row #ops #values #program
        }
    }
}

impl States {
    fn mention<'a>(&mut self, tokens: impl IntoIterator<Item = &'a TokenStream>) {
        for tokens in tokens {
            collect_words(tokens, &mut self.mentioned);
        }
    }
}

fn function(name: &Ident, doc: &str, body: &TokenStream) -> TokenStream {
    let mut words = BTreeSet::new();
    collect_words(body, &mut words);
    let context = if words.contains("cx") {
        quote!(cx)
    } else {
        quote!(_)
    };
    quote! {
        #[doc = #doc]
        fn #name(&mut self, #context: &mut dyn Context, _: Row<Self>) -> Result<Flow, Fault> {
            #body
        }
    }
}

/// Returns a `use` of those candidates that are mentioned.
fn import(from: TokenStream, words: &BTreeSet<String>, candidates: &[&str]) -> TokenStream {
    let names: Vec<Ident> = candidates
        .iter()
        .filter(|word| words.contains(**word))
        .map(|word| identifier(word))
        .collect();
    match names.as_slice() {
        [] => TokenStream::new(),
        [name] => quote!(use #from::#name;),
        names => quote!(use #from::{#(#names),*};),
    }
}

/// Adds every identifier that occurs in the tokens.
fn collect_words(tokens: &TokenStream, words: &mut BTreeSet<String>) {
    for token in tokens.clone() {
        match token {
            TokenTree::Ident(ident) => {
                words.insert(ident.to_string());
            }
            TokenTree::Group(group) => collect_words(&group.stream(), words),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}
