//! How Rust spells the run-time's vocabulary: commands, targets, inputs, flags and numbers.

use super::ident::identifier;
use crate::program::{Flag, Op, Port, Target, Teach};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// A number that reads back to the same bits.
pub(crate) fn number(value: f64) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed(value.abs());
    if value.is_sign_negative() {
        quote!(-#magnitude)
    } else {
        quote!(#magnitude)
    }
}

pub(super) fn op(op: Op) -> TokenStream {
    let variant = identifier(&format!("{op:?}"));
    quote!(Op::#variant)
}

pub(super) fn target(target: Target) -> TokenStream {
    match target {
        Target::None => quote!(Target::None),
        Target::All => quote!(Target::All),
        Target::Floor => quote!(Target::Floor),
        Target::Foot(leg) => {
            let leg = small(leg);
            quote!(Target::Foot(#leg))
        }
        Target::Joint(leg, joint) => {
            let (leg, joint) = (small(leg), small(joint));
            quote!(Target::Joint(#leg, #joint))
        }
    }
}

pub(super) fn teach(what: Teach) -> TokenStream {
    match what {
        Teach::Position => quote!(Teach::Position),
        Teach::Angle => quote!(Teach::Angle),
        Teach::Torque => quote!(Teach::Torque),
        Teach::Force => quote!(Teach::Force),
    }
}

pub(super) fn port(port: Port) -> TokenStream {
    match port {
        Port::Channel(n) => {
            let n = small(n);
            quote!(Port::Channel(#n))
        }
        Port::Knob(n) => {
            let n = small(n);
            quote!(Port::Knob(#n))
        }
        Port::Joint(leg, joint) => {
            let (leg, joint) = (small(leg), small(joint));
            quote!(Port::Joint(#leg, #joint))
        }
        Port::Paw(n) => {
            let n = small(n);
            quote!(Port::Paw(#n))
        }
        Port::Antenna => quote!(Port::Antenna),
    }
}

pub(super) fn flag(flag: Flag) -> TokenStream {
    match flag {
        Flag::HaltRequest => quote!(Flag::HaltRequest),
        Flag::KbHit => quote!(Flag::KbHit),
        Flag::Inpos(of) => {
            let of = target(of);
            quote!(Flag::Inpos(#of))
        }
        Flag::Near(of) => {
            let of = target(of);
            quote!(Flag::Near(#of))
        }
        Flag::Special(n) => {
            let n = small(n);
            quote!(Flag::Special(#n))
        }
        Flag::Antenna => quote!(Flag::Antenna),
    }
}

pub(super) fn small(n: u8) -> Literal {
    Literal::u8_unsuffixed(n)
}
