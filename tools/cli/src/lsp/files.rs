//! The files of this machine around a program.

use super::surroundings::{Chosen, Surroundings};
use crate::choices::EncodingName;
use crate::robot::RobotChoice;
use crate::usage::Wrong;
use crate::{embedded, explain, project};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::{env, fs};
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::{Loaded, Options, render};

/// The files of this machine.
pub(crate) struct Files {
    robot: Option<RobotChoice>,
    known: HashMap<String, Rc<Chosen>>,
    /// What is to be said of the crates around programs, each with the robot that it is given.
    crates: HashMap<(PathBuf, String), Option<Diagnostic>>,
    pages: HashMap<(String, Lang), Option<String>>,
}

impl Files {
    /// `robot`: that of every program.
    pub(crate) fn new(robot: Option<RobotChoice>) -> Self {
        Files {
            robot,
            known: HashMap::new(),
            crates: HashMap::new(),
            pages: HashMap::new(),
        }
    }

    /// The choice, from the strongest to the weakest.
    fn choice(
        &self,
        path: Option<&Path>,
        asked: Option<&str>,
        lang: Lang,
    ) -> Result<RobotChoice, String> {
        if let Some(choice) = &self.robot {
            return Ok(choice.clone());
        }
        if let Some(asked) = asked {
            let choice: RobotChoice = asked.parse().map_err(|wrong: Wrong| wrong.text(lang))?;
            return Ok(choice.beside(path));
        }
        let given = path.map_or(Ok(None), project::of);
        let given = given.map_err(|loaded| first_finding(&loaded, lang))?;
        Ok(given.and_then(|given| given.robot).unwrap_or_default())
    }
}

impl Surroundings for Files {
    fn robot(&mut self, path: Option<&Path>, asked: Option<&str>, lang: Lang) -> Rc<Chosen> {
        let (choice, complaint) = match self.choice(path, asked, lang) {
            Ok(choice) => (choice, None),
            Err(complaint) => (RobotChoice::default(), Some(complaint)),
        };
        let key = format!("{choice:?} {complaint:?} {lang:?}");
        if let Some(chosen) = self.known.get(&key) {
            return Rc::clone(chosen);
        }
        let chosen = Rc::new(chosen(&choice, complaint, lang));
        self.known.insert(key, Rc::clone(&chosen));
        chosen
    }

    fn other_robot(&mut self, path: &Path, asked: Option<&str>) -> Option<Diagnostic> {
        if self.robot.is_some() || asked.is_some() {
            return None;
        }
        let given = project::of(path).ok().flatten()?;
        let key = (path.to_owned(), given.to_string());
        let warning = || embedded::warning(path, given.file(), given.robot.as_ref()?);
        self.crates.entry(key).or_insert_with(warning).clone()
    }

    fn page(&mut self, code: &str, lang: Lang) -> Option<String> {
        let key = (code.to_owned(), lang);
        let page = self.pages.entry(key).or_insert_with(|| written(code, lang));
        page.clone()
    }

    fn encoding(&mut self, path: &Path) -> Option<String> {
        let given = project::of(path).ok().flatten()?;
        given.encoding.map(EncodingName::name)
    }

    fn forget(&mut self) {
        self.known.clear();
        self.crates.clear();
    }
}

/// The robot, or the standard one and why.
fn chosen(choice: &RobotChoice, complaint: Option<String>, lang: Lang) -> Chosen {
    match choice.load() {
        Ok(robot) => Chosen {
            options: Options {
                robot: robot.robot(),
                ..Options::default()
            },
            robot: robot.simulated().ok(),
            complaint,
        },
        Err(loaded) => Chosen {
            complaint: Some(first_finding(&loaded, lang)),
            ..chosen(&RobotChoice::default(), None, lang)
        },
    }
}

/// The first finding about a file, in a line.
fn first_finding(loaded: &Loaded, lang: Lang) -> String {
    let first = loaded.diagnostics.first();
    first.map_or_else(String::new, |first| {
        let line = render::short(&loaded.source, first, lang);
        line.trim_end().to_owned()
    })
}

/// Writes the page about a code into the cache of this user; its address.
fn written(code: &str, lang: Lang) -> Option<String> {
    let text = explain::page(code, lang)?;
    let language = if lang == Lang::Japanese { "ja" } else { "en" };
    let version = env!("CARGO_PKG_VERSION");
    let folder = cache()?.join("tip").join(version).join(language);
    let path = folder.join(format!("{code}.md"));
    if fs::read(&path).ok().as_deref() != Some(text.as_bytes()) {
        fs::create_dir_all(&folder).ok()?;
        fs::write(&path, text).ok()?;
    }
    Some(crate::sarif::uri(path.to_str()?))
}

/// Where programs keep what they can make again.
fn cache() -> Option<PathBuf> {
    let named = |name: &str| {
        env::var_os(name)
            .map(PathBuf::from)
            .filter(|path| path.is_absolute())
    };
    named("XDG_CACHE_HOME")
        .or_else(|| named("LOCALAPPDATA"))
        .or_else(|| Some(named("HOME")?.join(".cache")))
}
