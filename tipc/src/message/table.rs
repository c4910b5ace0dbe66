//! How tables of messages are written.

/// An enum of messages, a row for each: its name, its arguments and its text, in which `{argument}` stands for
/// the argument. A row without text, an argument that no text names and a hole that is not an argument do not compile.
macro_rules! messages {
    (
        $( #[$meta:meta] )* $table:ident;
        $( $name:ident $( { $( $argument:ident: $type:ty ),* } )? $english:literal; )*
    ) => {
        $( #[$meta] )*
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum $table {
            $(
                #[doc = concat!("```text\n", $english, "\n```")]
                $name $( { $(
                    #[doc = concat!("`{", stringify!($argument), "}`")]
                    $argument: $type,
                )* } )?,
            )*
        }

        #[cfg(test)]
        impl $table {
            /// Table, row and text of each message.
            pub(crate) const ROWS: &'static [(&'static str, &'static str, &'static str)] =
                &[$( (stringify!($table), stringify!($name), $english), )*];

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

        impl std::fmt::Display for $table {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $( $table::$name $( { $( $argument ),* } )? => {
                        write!(f, $english $( $( , $argument = $argument )* )?)
                    } )*
                }
            }
        }
    };
}

/// [`Message`](super::Message): a message of any of these tables.
macro_rules! tables {
    ($( $( #[$meta:meta] )* $table:ident, )*) => {
        /// A message, whose [`Display`](std::fmt::Display) is its text.
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

        impl std::fmt::Display for Message {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $( $( #[$meta] )* Message::$table(message) => message.fmt(f), )*
                }
            }
        }

        /// The rows of every table.
        #[cfg(test)]
        const ROWS: &[&[(&str, &str, &str)]] = &[$( $( #[$meta] )* $table::ROWS, )*];

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
