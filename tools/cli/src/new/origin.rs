//! The source of the dependencies of a new crate: a checkout on this machine, or the registry.

use super::name::CratePath;
use crate::message::Making;
use crate::project::real;
use std::path::{Component, Path, PathBuf, absolute};
use tipc::embed::{LIMIT, read_file};

/// The version of this command and of the crates.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The folder that this command was built from, if it still exists.
const BUILT_FROM: &str = env!("CARGO_MANIFEST_DIR");

/// Folders of a checkout.
const MACROS: &str = "tip-macros";
const RUNTIME: &str = "tip-runtime";
const SIM: &str = "tools/sim";

/// The source of the dependencies.
#[derive(Debug)]
pub(super) enum Origin {
    /// A checkout, and its path in the manifest.
    Checkout { folder: PathBuf, named: PathBuf },
    /// The registry.
    Published,
}

impl Origin {
    /// Returns the checkout that is given, else the one that this command was built from, else the registry.
    ///
    /// # Errors
    /// What is asked for is not a checkout of this version.
    pub(super) fn find(asked: Option<&Path>, place: &CratePath) -> Result<Self, Making> {
        if let Some(folder) = asked {
            let refused = || Making::NotACheckout {
                folder: folder.display().to_string().into(),
                version: VERSION.to_owned(),
            };
            let named = seen_from(place.folder(), folder);
            let checkout = Self::checkout(folder, named);
            return checkout.ok_or_else(refused)?.nameable();
        }
        let built_from = Path::new(BUILT_FROM).ancestors().nth(2);
        let found = built_from.and_then(|folder| Self::checkout(folder, folder.to_owned()));
        found.unwrap_or(Origin::Published).nameable()
    }

    /// Refuses a checkout with a path that a manifest cannot name.
    fn nameable(self) -> Result<Self, Making> {
        match &self {
            Origin::Checkout { named, .. } if !named.to_str().is_some_and(is_plain) => {
                Err(Making::NotForManifest {
                    folder: named.display().to_string().into(),
                })
            }
            _ => Ok(self),
        }
    }

    fn checkout(folder: &Path, named: PathBuf) -> Option<Self> {
        let manifest =
            String::from_utf8(read_file(&folder.join("Cargo.toml"), LIMIT).ok()?).ok()?;
        let version = format!("version = \"{VERSION}\"");
        let has = |name: &&str| folder.join(name).join("Cargo.toml").is_file();
        let is_ours =
            manifest.lines().any(|line| line == version) && [MACROS, RUNTIME, SIM].iter().all(has);
        is_ours.then(|| Origin::Checkout {
            folder: folder.to_owned(),
            named,
        })
    }

    /// Returns the dependency on the macros, without braces.
    pub(super) fn macros(&self) -> String {
        self.dependency(MACROS)
    }

    /// Returns the dependency on the runtime.
    pub(super) fn runtime(&self) -> String {
        self.dependency(RUNTIME)
    }

    /// Returns the dependency on the simulator.
    pub(super) fn sim(&self) -> String {
        self.dependency(SIM)
    }

    fn dependency(&self, folder: &str) -> String {
        match self {
            Origin::Checkout { named, .. } => {
                let path = named.join(folder).to_string_lossy().into_owned();
                // A string of JSON is one of TOML too.
                format!("path = {}", serde_json::Value::from(path))
            }
            Origin::Published => format!("version = \"={VERSION}\""),
        }
    }

    /// Returns the lock file of the checkout.
    pub(super) fn lock(&self) -> Option<Vec<u8>> {
        match self {
            Origin::Checkout { folder, .. } => read_file(&folder.join("Cargo.lock"), LIMIT).ok(),
            Origin::Published => None,
        }
    }
}

fn is_plain(path: &str) -> bool {
    !path.contains(char::is_control)
}

/// Converts a path from here to one from a new folder.
fn seen_from(place: &Path, path: &Path) -> PathBuf {
    // `..` after a link leads elsewhere.
    let here = real(Path::new("."));
    let is_below = place.is_relative() && real(place) == here.join(place);
    if path.is_absolute() || !is_below {
        return absolute(path).unwrap_or_else(|_| path.to_owned());
    }
    let is_real = |part: &Component<'_>| *part != Component::CurDir;
    let up = place
        .components()
        .filter(is_real)
        .map(|_| Component::ParentDir);
    up.chain(path.components().filter(is_real)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_checkout_keeps_its_place_beside_the_crate() {
        for (place, path, seen) in [
            ("demo", "tip", "../tip"),
            ("demo", "../tip", "../../tip"),
            ("robots/demo", "./tip", "../../tip"),
            ("./demo", ".", ".."),
            ("demo", "/src/tip", "/src/tip"),
        ] {
            let seen_from = seen_from(Path::new(place), Path::new(path));
            assert_eq!(seen_from, Path::new(seen), "{place}: {path}");
        }
        let far = seen_from(Path::new("/demo"), Path::new("tip"));
        assert!(far.is_absolute(), "{far:?}");
    }

    #[test]
    fn published_crates_are_those_of_this_version() {
        let expected = format!("version = \"={VERSION}\"");
        assert_eq!(Origin::Published.sim(), expected);
    }
}
