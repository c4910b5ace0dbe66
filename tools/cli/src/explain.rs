//! `tip explain`: the page of a code, with a wrong and a right program. A code without a page does not compile.

use crate::Action;
use crate::choices::LangName;
use crate::error::Error;
use crate::message::Using;
use crate::{Status, choices, output};
use clap::Args;
use std::fmt::Write as _;
use tipc::code::{Code, Mistake};
use tipc::message::Lang;
use tipc::message::list::Each;

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip explain E205           with a list of the finer codes
  tip explain E205-03
  tip explain W109 --lang ja

Exit status: 0 if there is such a code, 2 otherwise.")]
pub(super) struct Explain {
    /// A code such as E205-03 or W109, or a class such as E205
    #[arg(value_name = "CODE")]
    code: String,

    /// The language of the page; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

/// Largest number of codes that are suggested.
const MAX_NEAR: usize = 5;

impl Action for Explain {
    fn execute(&self) -> Result<Status, Error> {
        explain(self)
    }
}

/// Prints the page of a code.
fn explain(arguments: &Explain) -> Result<Status, Error> {
    let code = arguments.code.to_ascii_uppercase();
    let lang = choices::lang(arguments.lang);
    let Some(text) = page(&code, lang) else {
        // The class of a finer code that is not there, or the codes that differ by one letter.
        let known = || PAGES.iter().map(|page| page.code);
        let class = code.split('-').next().unwrap_or_default();
        let near = known().filter(|known| strsim::osa_distance(known, &code) == 1);
        let near: Vec<&str> = match known().find(|known| *known == class) {
            Some(class) => vec![class],
            None => near.take(MAX_NEAR).collect(),
        };
        return Err(match near.is_empty() {
            true => Error::usage(Using::NoCode { code }, lang),
            false => {
                let near = Each(near.into_iter().map(str::to_owned).collect());
                Error::usage(Using::NearCodes { code, near }, lang)
            }
        });
    };
    output::print(format!("{text}{}", related(&code, lang)))?;
    Ok(Status::Success)
}

pub(super) fn page(code: &str, lang: Lang) -> Option<&'static str> {
    let page = PAGES.iter().find(|page| page.code == code)?;
    Some(lang.pick(page.english, page.japanese))
}

/// Returns the related codes: the finer ones of a class, or the class of a finer one.
fn related(code: &str, lang: Lang) -> String {
    if let Some(mistake) = Mistake::ALL.iter().find(|mistake| mistake.id == code) {
        let class = mistake.class.id();
        return match lang {
            Lang::Japanese => {
                format!("\n`tip explain {class}` に、{class}のほかのコードがあります。\n")
            }
            _ => format!("\n`tip explain {class}` lists the other codes of {class}.\n"),
        };
    }
    let class = Code::ALL.iter().find(|class| class.id() == code);
    let finer = class
        .into_iter()
        .flat_map(|class| Mistake::of_class(*class));
    let mut text = String::new();
    for mistake in finer {
        if text.is_empty() {
            text += lang.pick("\n## Its finer codes\n\n", "\n## 細かいコード\n\n");
        }
        // Writing to a String cannot fail.
        let _ = writeln!(text, "- `{}`: {}", mistake.id, mistake.title(lang));
    }
    text
}

/// The page of a code.
struct Page {
    code: &'static str,
    english: &'static str,
    japanese: &'static str,
}

macro_rules! pages {
    ($( $code:literal )*) => {
        /// Every page, in order of the codes.
        const PAGES: &[Page] = &[$( Page {
            code: $code,
            english: include_str!(concat!("../pages/en/", $code, ".md")),
            japanese: include_str!(concat!("../pages/ja/", $code, ".md")),
        }, )*];
    };
}

pages! {
    "E101" "E102" "E103" "E104"
    "E105" "E105-01" "E105-02" "E105-03" "E105-04" "E105-05" "E105-06"
    "E106"
    "E107" "E107-01" "E107-02" "E107-03" "E107-04" "E107-05" "E107-06" "E107-07" "E107-08"
    "E108" "E201" "E202" "E203"
    "E204" "E204-01" "E204-02" "E204-03" "E204-04" "E204-05"
    "E205" "E205-01" "E205-02" "E205-03" "E205-04" "E205-05" "E205-06" "E205-07" "E205-08"
    "E205-09" "E205-10" "E205-11" "E205-12" "E205-13" "E205-14" "E205-15" "E205-16" "E205-17"
    "E205-18" "E205-19" "E205-20" "E205-21" "E205-22" "E205-23" "E205-24" "E205-25" "E205-26"
    "E205-27" "E205-28"
    "E206"
    "E207" "E207-01" "E207-02" "E207-03" "E207-04" "E207-05" "E207-06" "E207-07" "E207-08" "E207-09"
    "E301" "E302" "E303" "E304" "E305" "E306"
    "E401" "E402" "E403" "E404" "E405" "E406" "E407" "E408"
    "W101" "W102" "W103" "W104" "W105" "W106" "W107" "W108" "W109"
    "W110" "W111" "W112" "W113" "W114" "W115" "W116" "W117" "W118" "W119" "W120" "W121" "W122" "W123" "W124"
    "W125" "W126" "W127" "W128" "W129" "W130" "W131" "W132" "W133" "W134" "W135" "W136" "W137" "W138"
}

#[cfg(test)]
mod tests {
    use super::PAGES;
    use tip_lint::load;
    use tip_runtime::record::Ending;
    use tip_sim::{Interpreter, Limit, Robot, Run};
    use tipc::Options;
    use tipc::code::{Code, Mistake};
    use tipc::description::{parse, parse_project, parse_scene};
    use tipc::diagnostic::Diagnostic;
    use tipc::message::Lang;
    use tipc::program::Program;

    /// Codes of emergency stops.
    const STOPS: &[&str] = &["E302", "E303", "E304", "E305", "E403", "E404"];

    /// Returns the blocks of a page: a wrong and a right one, or none for a code that no text causes.
    fn blocks(page: &str) -> Vec<(&str, &str)> {
        let parts = page.split("```").skip(1).step_by(2);
        parts.filter_map(|block| block.split_once('\n')).collect()
    }

    /// The subject of a page: a class, or a mistake in it.
    struct About {
        class: Code,
        mistake: Option<&'static Mistake>,
    }

    impl About {
        /// Returns the subjects of all pages, in order.
        fn all() -> Vec<About> {
            let of = |class: &Code| {
                let class = *class;
                let mistakes = Mistake::of_class(class).map(Some);
                let subjects = std::iter::once(None).chain(mistakes);
                subjects.map(move |mistake| About { class, mistake })
            };
            Code::ALL.iter().flat_map(of).collect()
        }

        fn id(&self) -> &'static str {
            self.mistake.map_or(self.class.id(), |mistake| mistake.id)
        }

        fn title(&self, lang: Lang) -> String {
            match self.mistake {
                Some(mistake) => mistake.title(lang).to_owned(),
                None => self.class.template_in(lang).replace("{}", "…"),
            }
        }

        /// Returns the code of a diagnostic as the page shows it.
        fn code(&self, diagnostic: &Diagnostic) -> &'static str {
            match self.mistake {
                Some(_) => diagnostic.id(),
                None => diagnostic.code.id(),
            }
        }
    }

    /// Returns the code of the emergency stop that ends a program, if there is one.
    fn stops(program: Program) -> Option<&'static str> {
        let robot = Robot::named("titan8").expect("a robot");
        let mut run = Run::new(Interpreter::new(program), robot).expect("its robot");
        match run.to_end(Limit::cycles(10_000)) {
            Ending::Program(_) => None,
            Ending::Emergency(emergency) => Some(Code::of_fault(&emergency.fault).id()),
            other => panic!("{other:?}"),
        }
    }

    /// Returns the codes of the diagnostics of a block.
    fn codes((kind, text): (&str, &str), about: &About) -> Vec<&'static str> {
        let found = match (kind, about.class) {
            ("tip", _) => {
                let robot = tip_sim::Robot::named("titan8").expect("a robot");
                let mut loaded = load("page.prg", text.as_bytes(), &Options::default());
                robot.warn(&mut loaded);
                // A warning may predict the stop.
                let program = loaded
                    .program
                    .take()
                    .filter(|_| STOPS.contains(&about.id()));
                if let Some(stop) = program.and_then(stops) {
                    return vec![stop];
                }
                loaded.diagnostics
            }
            (_, Code::Scene) => parse_scene("page.toml", text.as_bytes())
                .map_or_else(|loaded| loaded.diagnostics, |_| Vec::new()),
            (_, Code::Project) => parse_project("page.toml", text.as_bytes(), |_| true)
                .map_or_else(|loaded| loaded.diagnostics, |_| Vec::new()),
            (_, _) => parse("page.toml", text.as_bytes())
                .map_or_else(|loaded| loaded.diagnostics, |_| Vec::new()),
        };
        found
            .iter()
            .map(|diagnostic| about.code(diagnostic))
            .collect()
    }

    #[test]
    fn every_code_has_its_page_and_every_page_its_code() {
        let pages: Vec<&str> = PAGES.iter().map(|page| page.code).collect();
        let codes: Vec<&str> = About::all().iter().map(About::id).collect();
        assert_eq!(pages, codes);
    }

    #[test]
    fn the_programs_of_each_page_are_wrong_and_right() {
        // Codes that no text causes.
        let without = [
            "E101", "E102", "E103", "E104", "E105-06", "E306", "E405", "E406", "E407", "W125",
            "W129",
        ];
        for (page, about) in PAGES.iter().zip(About::all()) {
            let english = blocks(page.english);
            assert_eq!(english, blocks(page.japanese), "{}", page.code);
            match english.as_slice() {
                [wrong, right] => {
                    assert_eq!(codes(*wrong, &about), [page.code], "wrong");
                    assert_eq!(codes(*right, &about), [""; 0], "{}: right", page.code);
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
    fn a_japanese_page_has_no_english_heading() {
        for page in PAGES {
            for heading in page.japanese.lines().filter(|line| line.starts_with('#')) {
                assert!(!heading.is_ascii(), "{}: {heading}", page.code);
            }
        }
    }

    #[test]
    fn each_page_begins_with_its_code_and_title() {
        for (page, about) in PAGES.iter().zip(About::all()) {
            for (lang, text) in [
                (Lang::English, page.english),
                (Lang::Japanese, page.japanese),
            ] {
                let start = format!("# {}: {}\n", page.code, about.title(lang));
                assert!(text.starts_with(&start), "{text}");
            }
        }
    }
}
