//! How Rust spells steps: one match arm each, in functions of a bounded number of arms.

use super::expression::Values;
use super::ident::{chunk, field, identifier};
use super::word;
use super::{CHUNK, Emitter, Steps};
use crate::program::{Action, End, Step, StepId};
use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::{format_ident, quote};
use std::collections::BTreeSet;

impl Emitter<'_> {
    /// Every state, in functions of [`CHUNK`] states.
    pub(super) fn steps(&self) -> Steps {
        let mut functions = TokenStream::new();
        let mut mentioned = BTreeSet::new();
        for (n, steps) in self.program.steps.chunks(CHUNK).enumerate() {
            functions.extend(self.function(n * CHUNK, steps, &mut mentioned));
        }
        Steps {
            functions,
            mentioned,
        }
    }

    fn function(
        &self,
        first: usize,
        steps: &[Step],
        mentioned: &mut BTreeSet<String>,
    ) -> TokenStream {
        let runtime = self.runtime;
        let name = chunk(first);
        let arms: TokenStream = (first..)
            .zip(steps)
            .map(|(number, step)| self.arm(number as StepId, step))
            .collect();
        let body = quote! {
            let flow = match self.at {
                #arms
                _ => return Err(Fault::WrongStep),
            };
            Ok(flow)
        };
        let mut words = BTreeSet::new();
        collect_words(&body, &mut words);
        let imports = self.imports(&words);
        let context = if words.contains("cx") {
            quote!(cx)
        } else {
            quote!(_)
        };
        mentioned.extend(words);
        quote! {
            fn #name(
                &mut self,
                #context: &mut dyn #runtime::program::Context,
            ) -> ::core::result::Result<#runtime::program::Flow, #runtime::fault::Fault> {
                #imports
                #body
            }
        }
    }

    /// What a function's body mentions: no name of the surrounding scope can get in between.
    fn imports(&self, words: &BTreeSet<String>) -> TokenStream {
        let runtime = self.runtime;
        let option = import(quote!(::core::option::Option), words, &["Some"]);
        let result = import(quote!(::core::result::Result), words, &["Err", "Ok"]);
        let command = ["Flag", "Op", "Port", "Target", "Teach", "Value"];
        let command = import(quote!(#runtime::command), words, &command);
        let fault = import(quote!(#runtime::fault), words, &["Fault"]);
        let ops = import(runtime.clone(), words, &["ops"]);
        let scalar = import(quote!(#runtime::ops), words, &["Scalar"]);
        let program = import(quote!(#runtime::program), words, &["End", "Flow"]);
        quote! { #option #result #command #fault #ops #scalar #program }
    }

    fn arm(&self, number: StepId, step: &Step) -> TokenStream {
        let doc = format!(" {}:{}: {}", self.program.source_name, step.line, step.text);
        let number_token = Literal::u32_unsuffixed(number);
        let action = self.action(number, &step.action);
        quote! {
            #[doc = #doc]
            #number_token => #action
        }
    }

    /// The arm's body; its value is a `Flow`.
    fn action(&self, step: StepId, action: &Action) -> TokenStream {
        let next = step + 1;
        let values = Values {
            program: self.program,
            assignment: &self.assignment,
            step,
        };
        match action {
            Action::Nothing => {
                let go = self.go(next);
                quote!(#go,)
            }
            Action::SetScalar {
                target,
                update,
                value,
            } => {
                let go = self.go(next);
                let set = values.set_scalar(*target, *update, *value);
                quote!({ #set #go })
            }
            Action::SetStruct {
                target,
                update,
                value,
            } => {
                let go = self.go(next);
                let set = values.set_struct(*target, *update, *value);
                quote!({ #set #go })
            }
            Action::If {
                condition,
                otherwise,
            } => {
                let condition = values.condition(*condition);
                let (go, skip) = (self.go(next), self.skip(*otherwise));
                quote!(if #condition { #go } else { #skip },)
            }
            Action::ElseIf {
                condition,
                otherwise,
            } => {
                let condition = values.condition(*condition);
                let (go, pass) = (self.go(next), self.go(*otherwise));
                let skip = self.skip(*otherwise);
                quote! {
                    if !self.not_taken { #pass } else if #condition { #go } else { #skip },
                }
            }
            Action::Else { end } => {
                let (go, pass) = (self.go(next), self.go(*end));
                quote!(if self.not_taken { #go } else { #pass },)
            }
            Action::While { condition, exit } => {
                let condition = values.condition(*condition);
                let (go, exit) = (self.go(next), self.go(*exit));
                quote!(if #condition { #go } else { #exit },)
            }
            Action::Goto { to } => {
                let go = self.go(*to);
                quote!(#go,)
            }
            Action::Until { condition, back } => {
                let condition = values.condition(*condition);
                let (go, back) = (self.go(next), self.go(*back));
                quote!(if #condition { #go } else { #back },)
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
                let (go, exit) = (self.go(next), self.go(*exit));
                quote!({
                    let from = #from;
                    let to = #to;
                    let by = #by;
                    let enters = ops::for_test(from, to, by)?;
                    #place.set(from);
                    if enters { #go } else { #exit }
                })
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
                let (again, go) = (self.go(*body), self.go(next));
                quote!({
                    let value = #old;
                    let by = #by;
                    let to = #to;
                    let value = ops::add(value, by)?;
                    let repeats = ops::for_test(value, to, by)?;
                    #place.set(value);
                    if repeats { #again } else { #go }
                })
            }
            Action::IfGoto { condition, to } => {
                let condition = values.condition(*condition);
                let (jump, go) = (self.go(*to), self.go(next));
                quote!(if #condition { #jump } else { #go },)
            }
            Action::Gosub { to } => {
                let call = self.call(*to, next);
                quote!({ #call })
            }
            Action::IfGosub { condition, to } => {
                let condition = values.condition(*condition);
                let (call, go) = (self.call(*to, next), self.go(next));
                quote!(if #condition { #call } else { #go },)
            }
            Action::Return => quote!({
                let back = self.calls.pop()?;
                self.go(back)
            }),
            Action::Finish(End::End) => quote!(Flow::Finished(End::End),),
            Action::Finish(End::Exit) => quote!(Flow::Finished(End::Exit),),
            Action::Command {
                op,
                hs,
                target,
                arguments,
            } => {
                let ask = if *hs { "command_hs" } else { "command" };
                let (ask, op, target) = (identifier(ask), word::op(*op), word::target(*target));
                let next = self.step_number(next);
                if arguments.is_empty() {
                    return quote!(self.#ask(cx, #op, #target, &[], #next)?,);
                }
                let values = values.of_arguments(arguments);
                quote!({
                    let values = #values;
                    self.#ask(cx, #op, #target, &values, #next)?
                })
            }
            Action::TeachStruct { what, target, into } => {
                let (what, target) = (word::teach(*what), word::target(*target));
                let variable = &self.program.variables[*into];
                let place = field(variable);
                let members: Vec<Ident> = (1..=variable.size())
                    .map(|member| format_ident!("m{member}"))
                    .collect();
                let go = self.go(next);
                quote!({
                    let [#(#members,)* ..] = cx.teach(#what, #target)?;
                    self.#place = [#(#members),*].map(Scalar::of);
                    #go
                })
            }
            Action::TeachScalar { what, target, into } => {
                let place = values.place(*into);
                let (what, target) = (word::teach(*what), word::target(*target));
                let go = self.go(next);
                quote!({
                    let [measured, ..] = cx.teach(#what, #target)?;
                    #place.set(measured);
                    #go
                })
            }
            Action::AdIn { port, into } => {
                let (place, port) = (values.place(*into), word::port(*port));
                let go = self.go(next);
                quote!({
                    #place.set(cx.analog(#port)?);
                    #go
                })
            }
            Action::KeyIn { into } => {
                let place = values.place(*into);
                let go = self.go(next);
                quote!(if let Some(key) = cx.key() {
                    #place.set(key as f64);
                    #go
                } else {
                    Flow::Wait
                },)
            }
            Action::Message { parts } => {
                let text = values.message(parts);
                let go = self.go(next);
                quote!({ #text #go })
            }
        }
    }

    /// On to a step, "taken".
    fn go(&self, step: StepId) -> TokenStream {
        let step = self.step_number(step);
        quote!(self.go(#step))
    }

    /// From a false IF or ELSEIF on to a step, "not taken".
    fn skip(&self, step: StepId) -> TokenStream {
        let step = self.step_number(step);
        if self.has_taken_state() {
            quote!(self.skip(#step))
        } else {
            quote!(self.go(#step))
        }
    }

    fn call(&self, to: StepId, back: StepId) -> TokenStream {
        let back = self.step_number(back);
        let go = self.go(to);
        quote! {
            self.calls.push(#back)?;
            #go
        }
    }

    /// A step's number, or the constant of the label that stands there.
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

/// A `use` of those candidates that are mentioned.
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
                let word = ident.to_string();
                if !words.contains(&word) {
                    words.insert(word);
                }
            }
            TokenTree::Group(group) => collect_words(&group.stream(), words),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}
