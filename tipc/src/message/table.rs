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
            /// Text that has no row yet.
            Text(String),
            $(
                $( #[$meta] )*
                #[doc = concat!("One of [`", stringify!($table), "`].")]
                $table($table),
            )*
        }

        impl From<String> for Message {
            fn from(text: String) -> Self {
                Message::Text(text)
            }
        }

        impl From<&str> for Message {
            fn from(text: &str) -> Self {
                Message::Text(text.to_owned())
            }
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
                    Message::Text(text) => f.write_str(text),
                    $( $( #[$meta] )* Message::$table(message) => message.fmt(f), )*
                }
            }
        }
    };
}
