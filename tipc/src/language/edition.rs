//! The editions of the language.

use std::fmt;

macro_rules! editions {
    ($( $(#[$doc:meta])* $variant:ident $number:literal; )*) => {
        /// An edition of the language, in the order in which they came. Line 1 of a program chooses it.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Edition {
            $( $(#[$doc])* $variant, )*
        }

        impl Edition {
            /// Every edition, the oldest first.
            pub const ALL: &'static [Edition] = &[$( Edition::$variant, )*];

            /// Returns the number that line 1 names it by.
            pub const fn number(self) -> f64 {
                match self { $( Edition::$variant => $number, )* }
            }
        }
    };
}

editions! {
    /// T.I.P. 3.1: what a program is read by if its number names no edition.
    #[default]
    V3_1 3.1;
    /// T.I.P. 3.2: what the author of the language planned next (T.I.P. 3.1 §1-2).
    V3_2 3.2;
}

impl Edition {
    /// Returns the edition of that number; 3.1 if it names none.
    pub fn of(number: f64) -> Edition {
        let mut all = Edition::ALL.iter().copied();
        all.find(|edition| edition.number() == number)
            .unwrap_or_default()
    }

    /// Returns true if a mistake that stops the program when it runs is refused when it loads; 3.1 warns of it.
    pub const fn is_strict(self) -> bool {
        matches!(self, Edition::V3_2)
    }
}

impl fmt::Display for Edition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.number())
    }
}

#[cfg(test)]
mod tests {
    use super::Edition;

    // clauses: 1.3 12.1
    #[test]
    fn a_number_that_names_no_edition_is_read_by_the_rules_of_3_1() {
        assert_eq!(Edition::of(3.1), Edition::V3_1);
        assert_eq!(Edition::of(3.2), Edition::V3_2);
        for number in [0.0, 2.0, 3.0, 3.10001, 9.9, f64::NAN] {
            assert_eq!(Edition::of(number), Edition::V3_1, "{number}");
        }
    }

    #[test]
    fn editions_are_ordered_by_their_numbers() {
        let pairs = Edition::ALL.windows(2);
        for pair in pairs {
            assert!(pair[0] < pair[1] && pair[0].number() < pair[1].number());
        }
        assert_eq!(Edition::V3_1.to_string(), "3.1");
    }
}
