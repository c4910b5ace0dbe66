//! Every case of the language on the interpreter, and the code that is emitted for it.

mod compare;
mod contributing;
mod emitted;
mod interpreted;
mod run;
mod settings;
mod stops;
