//! Rust tokens of the table of states: one row for each step, and a function for each row that needs code.

use super::Emitter;
use super::ident::in_comment;
use super::ident::{identifier, state};
use super::step::State;
use crate::program::StepId;
use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::quote;
use std::collections::BTreeSet;

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
pub(super) struct GeneratedStep {
    pub(super) row: TokenStream,
    /// Function that the row leads to, if it needs code.
    pub(super) function: TokenStream,
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
        self.with_moves(states)
    }

    /// Returns the states with one row, no line and no function in the place of all.
    #[cfg(feature = "build")]
    pub(super) fn outline(&self, row: TokenStream) -> States {
        let mut states = States {
            rows: row,
            ..States::default()
        };
        for (_, id) in self.program.steps.iter().zip(0..) {
            let GeneratedStep { row, function } = self.generate_step(id);
            states.mention([&row, &function]);
        }
        self.with_moves(states)
    }

    fn with_moves(&self, mut states: States) -> States {
        states.mentioned.insert("Step".to_owned());
        states.mention([&self.state_impl(&TokenStream::new())]);
        let moves = self.moves(&states.mentioned);
        states.mention([&moves]);
        states.functions.extend(moves);
        states
    }

    /// Generates the code of one step.
    pub(super) fn generate_step(&self, id: StepId) -> GeneratedStep {
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
