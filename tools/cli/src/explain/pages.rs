//! The pages, one for each code and language. A code whose page is missing does not compile.

/// What there is to read about a code.
pub(super) struct Page {
    pub(super) code: &'static str,
    pub(super) english: &'static str,
    pub(super) japanese: &'static str,
}

macro_rules! pages {
    ($( $code:literal )*) => {
        /// Every page, in order of the codes.
        pub(super) const PAGES: &[Page] = &[$( Page {
            code: $code,
            english: include_str!(concat!("../../pages/en/", $code, ".md")),
            japanese: include_str!(concat!("../../pages/ja/", $code, ".md")),
        }, )*];
    };
}

pages! {
    "E101" "E102" "E103" "E104" "E105" "E106" "E107" "E108" "E201"
    "E202" "E203" "E204" "E205" "E206" "E207" "E301" "E401" "E402"
    "W101" "W102" "W103" "W104" "W105" "W106" "W107" "W108" "W109"
}

#[cfg(test)]
mod tests {
    use super::PAGES;
    use tipc::code::Code;
    use tipc::description::{parse, parse_scene};
    use tipc::{Options, load};

    /// The blocks of a page: the wrong one and the right one, or none of a code that no text causes.
    fn blocks(page: &str) -> Vec<(&str, &str)> {
        let parts = page.split("```").skip(1).step_by(2);
        parts.filter_map(|block| block.split_once('\n')).collect()
    }

    /// The codes of what is wrong with a block.
    fn codes((kind, text): (&str, &str), code: Code) -> Vec<Code> {
        let found = match (kind, code) {
            ("tip", _) => load("page.prg", text.as_bytes(), &Options::default()).diagnostics,
            (_, Code::Scene) => parse_scene("page.toml", text.as_bytes())
                .map_or_else(|loaded| loaded.diagnostics, |_| Vec::new()),
            (_, _) => parse("page.toml", text.as_bytes())
                .map_or_else(|loaded| loaded.diagnostics, |_| Vec::new()),
        };
        found.iter().map(|finding| finding.code).collect()
    }

    #[test]
    fn every_code_has_its_page_and_every_page_its_code() {
        let pages: Vec<&str> = PAGES.iter().map(|page| page.code).collect();
        let codes: Vec<&str> = Code::ALL.iter().map(|code| code.id()).collect();
        assert_eq!(pages, codes);
    }

    #[test]
    fn the_programs_of_each_page_are_wrong_and_right() {
        // What no text causes.
        let without = ["E101", "E102", "E103", "E104"];
        for (page, code) in PAGES.iter().zip(Code::ALL) {
            let english = blocks(page.english);
            assert_eq!(english, blocks(page.japanese), "{}", page.code);
            match english.as_slice() {
                [wrong, right] => {
                    assert_eq!(codes(*wrong, *code), [*code], "{}", page.code);
                    assert_eq!(codes(*right, *code), [], "{}", page.code);
                }
                blocks => assert!(
                    blocks.is_empty() && without.contains(&page.code),
                    "{}",
                    page.code
                ),
            }
        }
    }

    #[test]
    fn each_page_begins_with_its_code_and_message() {
        for (page, code) in PAGES.iter().zip(Code::ALL) {
            let title = code.template().replace("{}", "…");
            let start = format!("# {}: {title}\n", page.code);
            for text in [page.english, page.japanese] {
                assert!(text.starts_with(&start), "{text}");
            }
        }
    }
}
