//! Rust tokens of a program's state: the struct, its constructor and its implementations.

use super::expression::place;
use super::ident::{field, in_comment};
use super::step::States;
use super::{Emitter, header_of, ident};
use crate::program::{Variable, VariableKind};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::collections::BTreeSet;
use tip_runtime::model::Family;

impl Emitter<'_> {
    fn has_calls(&self, mentioned: &BTreeSet<String>) -> bool {
        mentioned.contains("calls") || self.has_threads()
    }

    pub(super) fn has_threads(&self) -> bool {
        !self.program.threads.is_empty()
    }

    /// Returns the type of the field of the other places of a program with threads.
    fn threads_type(&self) -> Option<TokenStream> {
        let runtime = self.runtime;
        let count = Literal::usize_unsuffixed(self.program.threads.len() + 1);
        let threads = quote!(#runtime::generated::Threads::<#count>);
        self.has_threads().then_some(threads)
    }

    /// Returns the struct; `mentioned` are the words of its states.
    pub(super) fn structure(&self, mentioned: &BTreeSet<String>) -> TokenStream {
        let Emitter {
            visibility,
            attributes,
            runtime,
            name,
            ..
        } = self;
        let gap = (!attributes.is_empty()).then(|| quote!(#[doc = ""]));
        let source = in_comment(&self.program.source_name).replace('`', "'");
        let header = format!(
            " {}",
            header_of(&format!("`{source}`"), self.program.source_hash)
        );
        let robot = self.program.signature.robot;
        let about = format!(" The motion program `{source}`, compiled for the robot `{robot}`.");
        let fields = self.program.variables.iter().map(|variable| {
            let (field, kind) = (field(variable), self.field_type(variable));
            quote!(#field: #kind,)
        });
        let not_taken = self.has_taken_state.then(|| quote!(not_taken: bool,));
        let calls = self
            .has_calls(mentioned)
            .then(|| quote!(calls: #runtime::program::CallStack,));
        let threads = self
            .threads_type()
            .map(|threads| quote!(threads: #threads,));
        quote! {
            #attributes
            #gap
            #[doc = #about]
            #[doc = ""]
            #[doc = #header]
            #[derive(::core::clone::Clone, ::core::fmt::Debug)]
            #[allow(non_snake_case, clippy::all, clippy::pedantic)]
            #visibility struct #name {
                at: u32,
                #not_taken
                #calls
                #threads
                #(#fields)*
            }
        }
    }

    /// Returns the constructor and the tables.
    pub(super) fn inherent_impl(&self, states: &States) -> TokenStream {
        let name = &self.name;
        let constructor = self.constructor(&states.mentioned);
        let tables = self.tables(states);
        quote! {
            #[allow(unused_qualifications, clippy::all, clippy::pedantic)]
            impl #name {
                #tables
                #constructor
            }
        }
    }

    fn constructor(&self, mentioned: &BTreeSet<String>) -> TokenStream {
        let Emitter {
            visibility,
            runtime,
            ..
        } = self;
        let fields = self.program.variables.iter().map(|variable| {
            let field = field(variable);
            let initial = match variable.special {
                Some(_) => quote!(Scalar::of(0.0)),
                None => quote!(Scalar::UNASSIGNED),
            };
            let initial = match variable.kind {
                VariableKind::Var => initial,
                VariableKind::Pos | VariableKind::Joint => {
                    let size = Literal::usize_unsuffixed(variable.size());
                    quote!([#initial; #size])
                }
            };
            quote!(#field: #initial,)
        });
        let not_taken = self.has_taken_state.then(|| quote!(not_taken: false,));
        let calls = self
            .has_calls(mentioned)
            .then(|| quote!(calls: #runtime::program::CallStack::new(),));
        let threads = self
            .threads_type()
            .map(|threads| quote!(threads: #threads::new(),));
        quote! {
            #[doc = " At step 0, with every variable unassigned."]
            #visibility const fn new() -> Self {
                use #runtime::ops::Scalar;
                Self {
                    at: 0,
                    #not_taken
                    #calls
                    #threads
                    #(#fields)*
                }
            }
        }
    }

    /// Returns the source line of each step, and the steps of the labels that states name.
    fn tables(&self, states: &States) -> TokenStream {
        let States {
            lines, mentioned, ..
        } = states;
        let labels = self
            .labels
            .iter()
            .filter(|(_, name)| mentioned.contains(&name.to_string()))
            .map(|(step, name)| {
                let step = Literal::u32_unsuffixed(*step);
                quote!(const #name: u32 = #step;)
            });
        quote! {
            const LINES: &'static [u32] = &[#lines];
            #(#labels)*
        }
    }

    /// Implements the runtime's `State`, which rows of data need.
    pub(super) fn state_impl(&self, name: &TokenStream) -> TokenStream {
        let taken = self
            .has_taken_state
            .then(|| quote!(self.not_taken = false;));
        quote! {
            impl State for #name {
                fn at_mut(&mut self) -> &mut u32 {
                    &mut self.at
                }
                fn go(&mut self, step: u32) -> Result<Flow, Fault> {
                    self.at = step;
                    #taken
                    Ok(Flow::Next)
                }
            }
        }
    }

    /// Returns the other paths from a state to the next one; only those that a state takes.
    pub(super) fn moves(&self, mentioned: &BTreeSet<String>) -> TokenStream {
        let skip = quote! {
            fn skip(&mut self, step: u32) -> Result<Flow, Fault> {
                self.at = step;
                self.not_taken = true;
                Ok(Flow::Next)
            }
        };
        let after = quote! {
            fn after(&mut self, done: Result<(), Domain>, step: u32) -> Result<Flow, Fault> {
                done?;
                self.go(step)
            }
        };
        let branch = quote! {
            fn branch(&mut self, passes: Result<bool, Domain>, yes: u32, no: u32) -> Result<Flow, Fault> {
                self.go(if passes? { yes } else { no })
            }
        };
        let call = quote! {
            fn call(&mut self, step: u32, back: u32) -> Result<Flow, Fault> {
                self.calls.push(back)?;
                self.go(step)
            }
        };
        let back = quote! {
            fn back(&mut self) -> Result<Flow, Fault> {
                match self.calls.pop() {
                    Ok(back) => self.go(back),
                    Err(_) => self.threads.end(),
                }
            }
        };
        let back = match self.has_threads() {
            true => back,
            false => TokenStream::new(),
        };
        let behind = [
            ("after", after),
            ("branch", branch),
            ("call", call),
            ("back", back),
        ]
        .map(|(name, function)| mentioned.contains(name).then_some(function));
        let skip = mentioned.contains("skip").then_some(skip);
        quote! { #skip #(#behind)* }
    }

    pub(super) fn default_impl(&self) -> TokenStream {
        let name = &self.name;
        quote! {
            #[automatically_derived]
            impl ::core::default::Default for #name {
                fn default() -> Self {
                    Self::new()
                }
            }
        }
    }

    pub(super) fn program_impl(&self) -> TokenStream {
        let Emitter {
            runtime,
            name,
            program,
            ..
        } = self;
        let (source, title) = (&program.source_name, &program.title);
        let signature = self.signature();
        let (scalars, assignments) = (self.scalars(), self.assignments());
        let (threads, specials) = (self.thread_methods(), self.specials_method());
        quote! {
            #[automatically_derived]
            #[allow(unused_qualifications, clippy::all, clippy::pedantic)]
            impl #runtime::program::Program for #name {
                fn signature(&self) -> #runtime::program::Signature {
                    #signature
                }
                fn name(&self) -> &str {
                    #source
                }
                fn title(&self) -> &str {
                    #title
                }
                fn at(&self) -> u32 {
                    self.at
                }
                fn step(
                    &mut self,
                    cx: &mut dyn #runtime::program::Context,
                ) -> ::core::result::Result<#runtime::program::Flow, #runtime::fault::Fault> {
                    #runtime::generated::step(Self::STEPS, self, cx)
                }
                fn scalar(&self, i: usize) -> ::core::option::Option<(&str, ::core::option::Option<f64>)> {
                    use ::core::option::Option::{None, Some};
                    Some(match i {
                        #scalars
                        _ => return None,
                    })
                }
                fn set_scalar(&mut self, i: usize, value: f64) {
                    match i {
                        #assignments
                        _ => {}
                    }
                }
                fn line(&self, step: u32) -> u32 {
                    use ::core::option::Option::{None, Some};
                    match Self::LINES.get(step as usize) {
                        Some(line) => *line,
                        None => 0,
                    }
                }
                fn reset(&mut self) {
                    *self = Self::new();
                }
                #threads
                #specials
            }
        }
    }

    /// Returns the methods of a program with threads.
    fn thread_methods(&self) -> Option<TokenStream> {
        let runtime = self.runtime;
        let threads = || (1_u8..).zip(&self.program.threads);
        let names = threads().map(|(n, thread)| {
            let (n, name) = (ident::small(n), &thread.name);
            quote!(#n => #name,)
        });
        let firsts = threads().map(|(n, thread)| {
            let (n, first) = (ident::small(n), Literal::u32_unsuffixed(thread.first));
            quote!(#n => #first,)
        });
        let methods = quote! {
            fn thread(&self, n: u8) -> ::core::option::Option<(&str, u32)> {
                let name = match n {
                    #(#names)*
                    _ => return ::core::option::Option::None,
                };
                ::core::option::Option::Some((name, self.threads.at(n, self.at)))
            }
            fn select(&mut self, thread: u8) {
                let place = #runtime::generated::Position {
                    at: self.at,
                    not_taken: self.not_taken,
                    calls: self.calls,
                };
                let place = self.threads.select(thread, place);
                self.at = place.at;
                self.not_taken = place.not_taken;
                self.calls = place.calls;
            }
            fn begin(&mut self, thread: u8) {
                let first = match thread {
                    #(#firsts)*
                    _ => return,
                };
                self.threads.begin(thread, first);
            }
        };
        self.has_threads().then_some(methods)
    }

    /// Returns the method of a program that shares variables with native code.
    fn specials_method(&self) -> Option<TokenStream> {
        let shared = self.program.variables.iter();
        let shared = shared.filter(|variable| variable.special.is_some());
        let count: usize = shared.map(Variable::size).sum();
        let number = Literal::usize_unsuffixed(count);
        (count > 0).then(|| {
            quote! {
                fn specials(&self) -> usize {
                    #number
                }
            }
        })
    }

    fn signature(&self) -> TokenStream {
        let runtime = self.runtime;
        let signature = self.program.signature;
        let robot = signature.robot;
        let family = match signature.family {
            Family::Titan => quote!(Titan),
            Family::Hand => quote!(Hand),
            Family::Generic => quote!(Generic),
        };
        let (legs, joints) = (ident::small(signature.legs), ident::small(signature.joints));
        quote! {
            #runtime::program::Signature {
                robot: #robot,
                family: #runtime::model::Family::#family,
                legs: #legs,
                joints: #joints,
            }
        }
    }

    /// Returns the arms that give name and value of each scalar.
    fn scalars(&self) -> TokenStream {
        let arm = |(index, name, place)| quote!(#index => (#name, #place.assigned()),);
        self.places().map(arm).collect()
    }

    /// Returns the arms that assign each scalar.
    fn assignments(&self) -> TokenStream {
        let arm = |(index, _, place)| quote!(#index => #place.set(value),);
        self.places().map(arm).collect()
    }

    /// Returns index, name and place expression of each scalar.
    fn places(&self) -> impl Iterator<Item = (Literal, String, TokenStream)> + '_ {
        self.program.variables.iter().flat_map(|variable| {
            let names = variable.scalar_names().enumerate();
            names.map(move |(member, name)| {
                let index = Literal::usize_unsuffixed(variable.first + member);
                (index, name, place(variable, member))
            })
        })
    }

    fn field_type(&self, variable: &Variable) -> TokenStream {
        let runtime = self.runtime;
        match variable.kind {
            VariableKind::Var => quote!(#runtime::ops::Scalar),
            VariableKind::Pos | VariableKind::Joint => {
                let size = Literal::usize_unsuffixed(variable.size());
                quote!([#runtime::ops::Scalar; #size])
            }
        }
    }
}
