//! The functions of one number that equations have (T.I.P. 3.1 §5-2).
//!
//! ```
//! use tip_runtime::function::Function;
//!
//! assert_eq!(Function::ALL[0].leaf(), "int");
//! # #[cfg(feature = "ops")] {
//! use tip_runtime::ops::Domain;
//!
//! assert_eq!(Function::Int.call(-2.5), Ok(-3.0));
//! assert_eq!(Function::Sqrt.call(-2.5), Err(Domain));
//! # }
//! ```

#[cfg(feature = "ops")]
use crate::ops;

macro_rules! functions {
    ($( $variant:ident $leaf:ident, )*) => {
        /// A function of one number; the leaf arithmetic of [`ops`](crate::ops) defines it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Function {
            $( #[doc = concat!("`ops::", stringify!($leaf), "`")] $variant, )*
        }

        impl Function {
            /// Every function, in the order of the language's reference.
            pub const ALL: &'static [Function] = &[$( Function::$variant, )*];

            /// Returns the name of the function's leaf in `ops`.
            pub const fn leaf(self) -> &'static str {
                match self { $( Function::$variant => stringify!($leaf), )* }
            }

            /// Returns the function's value.
            ///
            /// # Errors
            /// `Domain` where the function has no value, or the value is not finite.
            #[cfg(feature = "ops")]
            #[inline]
            pub fn call(self, operand: f64) -> Result<f64, ops::Domain> {
                match self { $( Function::$variant => ops::$leaf(operand), )* }
            }
        }
    };
}

functions! {
    Int int,
    Abs abs,
    Sqrt sqrt,
    Sin sin,
    Cos cos,
    Tan tan,
    Asin asin,
    Acos acos,
    Atan atan,
    Deg2Rad deg2rad,
    Rad2Deg rad2deg,
}
