//! How Rust spells the runtime's vocabulary: commands, targets, inputs, flags and numbers.

use super::ident::identifier;
use crate::program::{Flag, Op, Port, Target, Teach};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::fmt::Debug;

/// A number that reads back to the same bits.
pub(crate) fn number(value: f64) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed(value.abs());
    if value.is_sign_negative() {
        quote!(-#magnitude)
    } else {
        quote!(#magnitude)
    }
}

/// A variant of the vocabulary: Rust spells it as `Debug` does, after the name of its type.
fn variant(of: &str, variant: impl Debug) -> TokenStream {
    let spelled = format!("{of}::{variant:?}");
    spelled.parse().unwrap_or_default()
}

pub(super) fn op(op: Op) -> TokenStream {
    variant("Op", op)
}

pub(super) fn target(target: Target) -> TokenStream {
    variant("Target", target)
}

pub(super) fn teach(what: Teach) -> TokenStream {
    variant("Teach", what)
}

pub(super) fn port(port: Port) -> TokenStream {
    variant("Port", port)
}

pub(super) fn flag(flag: Flag) -> TokenStream {
    let Some(of) = flag.target() else {
        return variant("Flag", flag);
    };
    let spelled = format!("{flag:?}");
    let name = identifier(spelled.split('(').next().unwrap_or_default());
    let of = target(of);
    quote!(Flag::#name(#of))
}

pub(super) fn small(n: u8) -> Literal {
    Literal::u8_unsuffixed(n)
}
