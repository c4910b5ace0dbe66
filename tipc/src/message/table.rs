//! How tables of messages are written.

/// An enum of messages, a row for each: its name, its arguments and its text in each language, in which `{argument}`
/// stands for the argument. A row that lacks a text, an argument that a text does not name and a hole that is not an
/// argument do not compile.
macro_rules! messages {
    (
        $( #[$meta:meta] )* $table:ident;
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
                assert!(crate::message::say::fits($english, ARGUMENTS), "{}", $english);
                assert!(crate::message::say::fits($japanese, ARGUMENTS), "{}", $japanese);
            };
        )*

        impl $table {
            /// Its text in a language.
            pub fn in_lang(&self, lang: crate::message::Lang) -> impl std::fmt::Display {
                crate::message::say::Said(self, lang)
            }
        }

        #[cfg(test)]
        impl $table {
            /// Table, row and texts of each message.
            pub(crate) const ROWS: &'static [crate::message::tests::Row] = &[$( crate::message::tests::Row {
                table: stringify!($table),
                row: stringify!($name),
                english: $english,
                japanese: $japanese,
            }, )*];

            /// Each message once, with the arguments of a turn.
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

        impl crate::message::say::Say for $table {
            fn say(&self, lang: crate::message::Lang, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $( $table::$name $( { $( $argument ),* } )? => crate::message::say::fill(
                        f,
                        lang,
                        lang.pick($english, $japanese),
                        &[$( $( (stringify!($argument), $argument) ),* )?],
                    ), )*
                }
            }
        }

        impl std::fmt::Display for $table {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.in_lang(crate::message::Lang::English).fmt(f)
            }
        }
    };
}

/// A table of two rows for so many of something: one of it, and any other number, for which `{count}` stands.
macro_rules! counted {
    (
        $( #[$meta:meta] )* $table:ident:
        $one:literal, $one_japanese:literal; $several:literal, $several_japanese:literal;
    ) => {
        messages! {
            $( #[$meta] )* $table;

            One $one, $one_japanese;
            Several { count: usize } $several, $several_japanese;
        }

        impl From<usize> for $table {
            fn from(count: usize) -> Self {
                match count {
                    1 => $table::One,
                    count => $table::Several { count },
                }
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
                }
            }
        }

        /// The rows of every table.
        #[cfg(test)]
        pub(crate) const ROWS: &[&[tests::Row]] = &[$( $( #[$meta] )* $table::ROWS, )*];

        /// The messages of every table, with the arguments of a turn.
        #[cfg(test)]
        fn each(turn: usize) -> Vec<Message> {
            let mut messages = Vec::new();
            $(
                $( #[$meta] )*
                messages.extend($table::each(turn).into_iter().map(Message::from));
            )*
            messages
        }
    };
}
