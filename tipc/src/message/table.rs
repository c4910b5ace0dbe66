//! Macros for tables of messages.

/// Defines an enum of messages in the crate that calls it, which any [`Message`](crate::message::Message) can hold.
///
/// A row is a name, its arguments and its text in each language, in which `{argument}` stands for the argument. A row that
/// lacks a text, an argument that a text does not name and a hole that is not an argument do not compile.
///
/// ```
/// use tipc::message::{Lang, Message};
///
/// tipc::message_table! {
///     /// Greetings.
///     Greeting;
///
///     Hello { name: String } "hello, {name}", "{name}さん、こんにちは";
/// }
///
/// let name = "TITAN".to_owned();
/// let hello = Message::from(Greeting::Hello { name });
/// assert_eq!(hello.to_string(), "hello, TITAN");
/// assert_eq!(hello.in_lang(Lang::Japanese).to_string(), "TITANさん、こんにちは");
/// assert!(hello.get::<Greeting>().is_some());
/// ```
#[macro_export]
macro_rules! message_table {
    (
        @enum $( #[$meta:meta] )* $table:ident;
        $( $name:ident $( { $( $argument:ident: $type:ty ),* } )? $english:literal, $japanese:literal; )*
    ) => {
        $( #[$meta] )*
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum $table {
            $(
                #[doc = concat!("```text\n", $english, "\n", $japanese, "\n```")]
                $name $( { $(
                    #[doc = concat!("`{", stringify!($argument), "}`")]
                    $argument: $type,
                )* } )?,
            )*
        }

        $(
            const _: () = {
                const ARGUMENTS: &[&str] = &[$( $( stringify!($argument) ),* )?];
                assert!($crate::message::say::fits($english, ARGUMENTS), "{}", $english);
                assert!($crate::message::say::fits($japanese, ARGUMENTS), "{}", $japanese);
            };
        )*

        impl $table {
            /// Returns its text in a language.
            pub fn in_lang(&self, lang: $crate::message::Lang) -> impl ::std::fmt::Display {
                $crate::message::say::Said(self, lang)
            }
        }

        impl $crate::message::say::Say for $table {
            fn say(
                &self,
                lang: $crate::message::Lang,
                f: &mut ::std::fmt::Formatter<'_>,
            ) -> ::std::fmt::Result {
                match self {
                    $( $table::$name $( { $( $argument ),* } )? => $crate::message::say::fill(
                        f,
                        lang,
                        lang.pick($english, $japanese),
                        &[$( $( (stringify!($argument), $argument) ),* )?],
                    ), )*
                }
            }
        }

        impl ::std::fmt::Display for $table {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                self.in_lang($crate::message::Lang::English).fmt(f)
            }
        }
    };
    ( $( #[$meta:meta] )* $table:ident; $( $rows:tt )* ) => {
        $crate::message_table! { @enum $( #[$meta] )* $table; $( $rows )* }

        impl ::std::convert::From<$table> for $crate::message::Message {
            fn from(message: $table) -> Self {
                $crate::message::Message::Other($crate::message::Other::new(message))
            }
        }
    };
}

/// Defines a table of two rows for a number of things: one, and any other number, for which `{count}` stands.
#[macro_export]
macro_rules! count_table {
    (
        $( #[$meta:meta] )* $table:ident:
        $one:literal, $one_japanese:literal; $several:literal, $several_japanese:literal;
    ) => {
        $crate::message_table! {
            $( #[$meta] )* $table;

            One $one, $one_japanese;
            Several { count: usize } $several, $several_japanese;
        }

        impl ::std::convert::From<usize> for $table {
            fn from(count: usize) -> Self {
                match count {
                    1 => $table::One,
                    count => $table::Several { count },
                }
            }
        }
    };
}

/// A table of this crate: its rows are tried with sample arguments. A reason has the finer codes of its diagnostics, one
/// for each class that it may be of.
macro_rules! messages {
    (
        $( #[$meta:meta] )* $table:ident;
        $(
            $name:ident $( { $( $argument:ident: $type:ty ),* } )? $( [ $( $code:literal )+ ] )?
            $english:literal, $japanese:literal;
        )*
    ) => {
        $crate::message_table! {
            @enum $( #[$meta] )* $table;
            $( $name $( { $( $argument: $type ),* } )? $english, $japanese; )*
        }

        impl $table {
            /// Returns the finer codes of diagnostics with this reason.
            #[allow(dead_code, reason = "parts of messages have no codes")]
            pub(crate) const fn codes(&self) -> &'static [&'static str] {
                match self {
                    $( $table::$name { .. } => &[$( $( $code, )+ )?], )*
                }
            }
        }

        #[cfg(test)]
        impl $table {

            /// Returns each message once, with the arguments of a turn.
            pub(crate) fn each(turn: usize) -> Vec<$table> {
                let _ = turn;
                vec![$( $table::$name $( { $(
                    $argument: crate::message::tests::Sample::sample(turn),
                )* } )?, )*]
            }
        }

        #[cfg(test)]
        impl crate::message::tests::Sample for $table {
            fn sample(turn: usize) -> Self {
                let mut each = $table::each(turn);
                each.swap_remove(turn % each.len())
            }
        }
    };
}

/// [`Message`](super::Message): a message of any of these tables.
macro_rules! tables {
    ($( $( #[$meta:meta] )* $table:ident, )*) => {
        /// A message. Its [`Display`](std::fmt::Display) is its English text.
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum Message {
            $(
                $( #[$meta] )*
                #[doc = concat!("One of [`", stringify!($table), "`].")]
                $table($table),
            )*
            /// One of a table of another crate.
            Other(Other),
        }

        $(
            $( #[$meta] )*
            impl From<$table> for Message {
                fn from(message: $table) -> Self {
                    Message::$table(message)
                }
            }
        )*

        impl say::Say for Message {
            fn say(&self, lang: Lang, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $( $( #[$meta] )* Message::$table(message) => message.say(lang, f), )*
                    Message::Other(message) => message.say(lang, f),
                }
            }
        }

        impl Message {
            /// Returns the finer codes of diagnostics with this reason.
            pub(crate) const fn codes(&self) -> &'static [&'static str] {
                match self {
                    $( $( #[$meta] )* Message::$table(message) => message.codes(), )*
                    Message::Other(_) => &[],
                }
            }
        }

        /// Returns the messages of every table, with the arguments of a turn.
        #[cfg(test)]
        pub(crate) fn each(turn: usize) -> Vec<Message> {
            let mut messages = Vec::new();
            $(
                $( #[$meta] )*
                messages.extend($table::each(turn).into_iter().map(Message::from));
            )*
            messages
        }
    };
}
