//! `tip.toml`: settings of the programs in its folder.

use super::keys::Part;
use super::open;
use super::section::{Found, Section};
use crate::load::Loaded;
use crate::message::Describing;
use crate::published;
use crate::robot::Robot;
use crate::source::Encoding;
use glob::{MatchOptions, Pattern};
use tip_runtime::scene::Scene;

/// Settings of a `tip.toml` for the programs in its folder and below.
///
/// ```
/// let text = b"robot = \"hand\"\n[[programs]]\nfiles = \"old/*.prg\"\nencoding = \"shift_jis\"\n";
/// let project = tipc::description::parse_project("tip.toml", text, |_| true).expect("it is right");
/// let said = project.of("old/grasp.prg");
/// assert_eq!(said.robot, Some("hand"));
/// assert_eq!(said.encoding, Some(tipc::source::Encoding::ShiftJis));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Project {
    every: Said,
    some: Vec<(Pattern, Said)>,
}

#[derive(Clone, Debug, Default, PartialEq)]
struct Said {
    robot: Option<String>,
    encoding: Option<Encoding>,
    scene: Option<String>,
}

/// Settings of one program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings<'a> {
    /// The robot: a name, or a description by its path from the folder of `tip.toml`.
    pub robot: Option<&'a str>,
    /// Encoding of the file.
    pub encoding: Option<Encoding>,
    /// Surroundings of the robot: a name, or a file by its path from that folder.
    pub scene: Option<&'a str>,
}

/// Reads a `tip.toml`. `name` is the file's name in diagnostics. `is_there` returns true if a file exists, by its path
/// from that folder.
///
/// # Errors
/// All faults of the file, each at its location, as a [`Loaded`] without a program.
pub fn parse_project(
    name: &str,
    bytes: &[u8],
    is_there: impl Fn(&str) -> bool,
) -> Result<Project, Box<Loaded>> {
    open(name, bytes, Part::Project, |_, top, found| {
        let mut project = Project {
            every: said(top, &is_there, found),
            some: Vec::new(),
        };
        let parts = top.tables("programs", Part::Programs, found);
        for part in parts.unwrap_or_default() {
            let said = said(part, &is_there, found);
            if let Some((location, files)) = part.text("files", found) {
                let pattern = Pattern::new(files).ok();
                let key = "files".to_owned();
                let refused =
                    || part.refuse("files", location, Describing::CannotBeThis { key }, found);
                if let Some(pattern) = pattern.or_else(refused) {
                    project.some.push((pattern, said));
                }
            }
        }
        Some(project)
    })
}

fn said(section: Section<'_>, is_there: &dyn Fn(&str) -> bool, found: &mut Found) -> Said {
    let robots = Robot::ALL.iter().map(|robot| robot.name());
    let robots = robots.chain(published::ALL.iter().map(|robot| robot.name));
    let scenes = Scene::NAMES.iter().copied();
    let words = [
        ("auto", Encoding::Auto),
        ("utf-8", Encoding::Utf8),
        ("shift_jis", Encoding::ShiftJis),
    ];
    Said {
        robot: named(section, "robot", robots, is_there, found),
        encoding: match section.has("encoding") {
            true => section.choice("encoding", &words, found),
            false => None,
        },
        scene: named(section, "scene", scenes, is_there, found),
    }
}

/// Reads a name that is known, or the path of a file that exists.
fn named(
    section: Section<'_>,
    key: &str,
    known: impl Iterator<Item = &'static str> + Clone,
    is_there: &dyn Fn(&str) -> bool,
    found: &mut Found,
) -> Option<String> {
    let (location, text) = section.text(key, found)?;
    let is_file = text.ends_with(".toml");
    if known.clone().any(|name| name == text) || is_file && is_there(text) {
        return Some(text.to_owned());
    }
    if is_file {
        let file = text.to_owned();
        return section.refuse(key, location, Describing::NoFile { file }, found);
    }
    section.refuse_word(key, (location, text), known, found)
}

impl Project {
    /// Returns the settings of a program, by its path from the folder of `tip.toml`, with `/` between folders. If
    /// several parts match, the last one counts.
    pub fn of(&self, path: &str) -> Settings<'_> {
        let meant = self.some.iter();
        let meant = meant.filter(|(files, _)| files.matches_with(path, AS_IN_SHELLS));
        let mut settings = Settings::default();
        for said in std::iter::once(&self.every).chain(meant.map(|(_, said)| said)) {
            settings = Settings {
                robot: said.robot.as_deref().or(settings.robot),
                encoding: said.encoding.or(settings.encoding),
                scene: said.scene.as_deref().or(settings.scene),
            };
        }
        settings
    }
}

/// Glob rules of shells: `?` is a character of a name, `*` any characters of one, `**` any folders.
const AS_IN_SHELLS: MatchOptions = MatchOptions {
    case_sensitive: true,
    require_literal_separator: true,
    require_literal_leading_dot: false,
};

#[cfg(test)]
mod tests {
    use super::{Settings, parse_project};
    use crate::render;
    use crate::source::Encoding;

    #[test]
    fn a_pattern_stays_in_its_folder_unless_two_stars_say_otherwise() {
        let means = |pattern: &str, path| {
            let text = format!("[[programs]]\nfiles = \"{pattern}\"\nrobot = \"hand\"\n");
            let project =
                parse_project("tip.toml", text.as_bytes(), |_| true).expect("it is right");
            project.of(path).robot.is_some()
        };
        for (pattern, path) in [
            ("walk.prg", "walk.prg"),
            ("w?lk.prg", "walk.prg"),
            ("歩*", "歩く.prg"),
            ("**/grasp.prg", "grasp.prg"),
            ("**/grasp.prg", "a/b/grasp.prg"),
            ("a/**/*.prg", "a/b/c/d.prg"),
            ("a/**/*.prg", "a/d.prg"),
        ] {
            assert!(means(pattern, path), "{pattern} {path}");
        }
        for (pattern, path) in [
            ("*.prg", "hand/grasp.prg"),
            ("hand/?", "hand/ab"),
            ("WALK.prg", "walk.prg"),
            ("**/grasp.prg", "nograsp.prg"),
        ] {
            assert!(!means(pattern, path), "{pattern} {path}");
        }
    }

    #[test]
    fn the_last_part_that_means_a_program_counts() {
        let text = b"robot = \"hand\"\nencoding = \"utf-8\"\n\
            [[programs]]\nfiles = \"old/*\"\nencoding = \"shift_jis\"\nscene = \"cylinder\"\n\
            [[programs]]\nfiles = \"old/six.prg\"\nrobot = \"robots/six.toml\"\n";
        let project = parse_project("tip.toml", text, |_| true).expect("it is right");
        let hand = Settings {
            robot: Some("hand"),
            encoding: Some(Encoding::Utf8),
            scene: None,
        };
        assert_eq!(project.of("grasp.prg"), hand);
        let old = Settings {
            encoding: Some(Encoding::ShiftJis),
            scene: Some("cylinder"),
            ..hand
        };
        assert_eq!(project.of("old/grasp.prg"), old);
        let six = Settings {
            robot: Some("robots/six.toml"),
            ..old
        };
        assert_eq!(project.of("old/six.prg"), six);
        let empty = parse_project("tip.toml", b"", |_| true).expect("nothing is needed");
        assert_eq!(empty.of("walk.prg"), Settings::default());
    }

    /// Returns true if a file is beside the wrong ones.
    fn is_there(file: &str) -> bool {
        file == "robots/six.toml"
    }

    /// Checks what is reported about a wrong one.
    #[track_caller]
    fn check(text: &str, expected: &[&str]) {
        let loaded = parse_project("tip.toml", text.as_bytes(), is_there).expect_err("it is wrong");
        let found = loaded.diagnostics.iter();
        let lines =
            found.map(|one| render::short(&loaded.source, one, crate::message::Lang::English));
        let lines: Vec<String> = lines.map(|line| line.trim_end().to_owned()).collect();
        assert_eq!(lines, expected);
    }

    #[test]
    fn each_fault_is_reported_at_its_location() {
        check(
            "robto = \"hand\"\n[[programs]]\nencoding = \"latin1\"\n",
            &[
                "tip.toml:1:1: error[E408]: the project has no key `robto` (TIP_ERR:Wrong tip.toml)",
                "tip.toml:2:1: error[E408]: [[programs]] lacks `files` (TIP_ERR:Wrong tip.toml)",
                "tip.toml:3:12: error[E408]: `encoding` cannot be this (TIP_ERR:Wrong tip.toml)",
            ],
        );
        let help = |text: &str| {
            let loaded =
                parse_project("tip.toml", text.as_bytes(), is_there).expect_err("it is wrong");
            let first = loaded.diagnostics.first();
            let help = first.and_then(|found| found.help.as_ref());
            help.map(|help| help.in_lang(crate::message::Lang::English).to_string())
        };
        for (text, near) in [
            ("robot = \"Titan9\"", "titan8"),
            ("robot = \"phantom\"", "phantomx"),
            ("scene = \"cilinder\"", "cylinder"),
            ("encoding = \"utf8\"", "utf-8"),
        ] {
            assert_eq!(
                help(text),
                Some(format!("did you mean `{near}`?")),
                "{text}"
            );
        }
        // Nothing is near to this one.
        let forms = "`robot` is a robot's name, or a description's \"FILE.toml\"";
        assert_eq!(help("robot = \"rover\"").as_deref(), Some(forms));
        check(
            "robot = \"titan9\"\nscene = 5\n[[programs]]\nfiles = \"a**\"\n",
            &[
                "tip.toml:1:9: error[E408]: `robot` cannot be this (TIP_ERR:Wrong tip.toml)",
                "tip.toml:2:9: error[E408]: a number cannot stand here (TIP_ERR:Wrong tip.toml)",
                "tip.toml:4:9: error[E408]: `files` cannot be this (TIP_ERR:Wrong tip.toml)",
            ],
        );
        // The first file is there.
        let parts = "[[programs]]\nfiles = \"*\"\nrobot = \"sixth.toml\"\nscene = \"step.toml\"\n";
        let missing = |location, file| {
            let reason =
                format!("there is no file `{file}`: paths begin at the folder of tip.toml");
            format!("tip.toml:{location}: error[E408]: {reason} (TIP_ERR:Wrong tip.toml)")
        };
        check(
            &format!("robot = \"robots/six.toml\"\n{parts}"),
            &[&missing("4:9", "sixth.toml"), &missing("5:9", "step.toml")],
        );
    }
}
