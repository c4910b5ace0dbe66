//! The user's project, as cargo reports it: where the runtime comes from, and the build.

use super::NotBuilt;
use serde_json::Value;
use std::ffi::OsString;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// The version of this crate; that of the project's runtime must be the same.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

const WHERE: &str = "run it in the folder of a project that depends on tip-runtime, or name its Cargo.toml by --manifest-path";

/// A cargo project that depends on the runtime.
#[derive(Debug)]
pub struct Project {
    /// Folder in which cargo runs, so that the project's configuration and toolchain count.
    folder: PathBuf,
    /// Folder in which packages are written and built.
    pub(super) target: PathBuf,
    /// The project's lock file, if it has one.
    pub(super) lock: PathBuf,
    /// Source of tip-runtime: a TOML table without braces.
    pub(super) runtime: String,
    /// Source of tip-sim, in the same form.
    pub(super) sim: String,
}

impl Project {
    /// Returns the project around the current folder, or that of a manifest.
    ///
    /// # Errors
    /// There is none, it does not depend on tip-runtime, or on that of another version.
    pub fn find(manifest: Option<&Path>) -> Result<Self, NotBuilt> {
        let folder = match manifest.and_then(Path::parent) {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let folder = fs::canonicalize(folder)
            .map_err(|error| NotBuilt::Failed(format!("{}: {error}; {WHERE}", folder.display())))?;
        let metadata = metadata(&folder)?;
        let packages = metadata["packages"]
            .as_array()
            .map_or(&[][..], Vec::as_slice);
        let package = |name: &str| packages.iter().find(|package| package["name"] == name);
        let runtime = package("tip-runtime").ok_or_else(|| {
            let folder = folder.display();
            NotBuilt::Failed(format!(
                "the project in {folder} does not depend on tip-runtime: {WHERE}"
            ))
        })?;
        same_version(runtime)?;
        let runtime_source = source(runtime);
        let sim = match package("tip-sim") {
            Some(sim) => {
                same_version(sim)?;
                source(sim)
            }
            None => matching_sim(runtime, &runtime_source)?,
        };
        let path = |key: &str| PathBuf::from(metadata[key].as_str().unwrap_or_default());
        Ok(Project {
            target: path("target_directory").join("tip-verify"),
            lock: path("workspace_root").join("Cargo.lock"),
            runtime: runtime_source,
            sim,
            folder,
        })
    }

    /// Builds the package at `manifest` in release mode; gives its executable.
    pub(super) fn build(&self, manifest: &Path) -> Result<PathBuf, NotBuilt> {
        let mut command = Command::new(cargo());
        command
            .args([
                "build",
                "--release",
                "--message-format",
                "json-render-diagnostics",
            ])
            .arg("--manifest-path")
            .arg(manifest)
            .arg("--target-dir")
            .arg(self.target.join("build"))
            .current_dir(&self.folder)
            .stdin(Stdio::null())
            .stderr(Stdio::inherit());
        if !io::stderr().is_terminal() {
            command.arg("--quiet");
        }
        let output = command.output().map_err(no_cargo)?;
        let text = String::from_utf8_lossy(&output.stdout);
        let messages = text
            .lines()
            .filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let mut executables =
            messages.filter_map(|message| message["executable"].as_str().map(PathBuf::from));
        match executables.next_back() {
            Some(executable) if output.status.success() => Ok(executable),
            _ => Err(NotBuilt::Failed(format!(
                "cargo could not build {} ({}): it says above why. Without a network, `cargo fetch` in the project first; \
                 an error in src/program.rs is a defect of tip",
                manifest.display(),
                output.status
            ))),
        }
    }

    /// Returns the version that a tool of the project reports.
    pub fn version_of(&self, variable: &str, tool: &str) -> String {
        let tool = env::var_os(variable).unwrap_or_else(|| tool.into());
        let output = Command::new(tool)
            .arg("--version")
            .current_dir(&self.folder)
            .output();
        let text = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
        text.unwrap_or_else(|_| "of unknown version".to_owned())
    }
}

/// Returns the cargo to run; cargo names itself to the processes that it starts.
fn cargo() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

fn no_cargo(error: io::Error) -> NotBuilt {
    NotBuilt::Failed(match error.kind() {
        io::ErrorKind::NotFound => {
            "cargo is not there, and it has to build the program: https://rustup.rs installs it"
                .to_owned()
        }
        _ => format!("cargo does not start: {error}"),
    })
}

/// Returns the project's metadata from cargo.
fn metadata(folder: &Path) -> Result<Value, NotBuilt> {
    let mut command = Command::new(cargo());
    command
        .args(["metadata", "--format-version", "1"])
        .current_dir(folder);
    let output = command.output().map_err(no_cargo)?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let folder = folder.display();
        if said.contains("could not find `Cargo.toml`") {
            return Err(NotBuilt::Failed(format!(
                "the program is compiled in a Cargo project that depends on tip-runtime, and {folder} is in none: \
                 `tip new demo` makes one; {WHERE}"
            )));
        }
        return Err(NotBuilt::NoProject {
            reason: format!("cargo cannot read the project in {folder}: {WHERE}"),
            said,
        });
    }
    serde_json::from_slice(&output.stdout)
        .map_err(|error| NotBuilt::Failed(format!("cargo metadata: {error}")))
}

/// Checks that both engines are of one version, which is that of this tool.
fn same_version(package: &Value) -> Result<(), NotBuilt> {
    let text = |key: &str| package[key].as_str().unwrap_or_default();
    let (name, version) = (text("name"), text("version"));
    if version == VERSION {
        return Ok(());
    }
    Err(NotBuilt::Failed(format!(
        "the project has {name} {version}, this is tip {VERSION}: `cargo install tip-cli --version {version}` \
         installs the one that belongs to it"
    )))
}

/// Returns the source from which cargo took a package, as a dependency states it.
fn source(package: &Value) -> String {
    let source = package["source"].as_str().unwrap_or_default();
    let (kind, address) = source.split_once('+').unwrap_or_default();
    match kind {
        "git" => {
            let (address, revision) = address.split_once('#').unwrap_or((address, ""));
            let address = address.split('?').next().unwrap_or(address);
            format!("git = {}, rev = {}", quoted(address), quoted(revision))
        }
        "registry" | "sparse" if !address.ends_with("github.com/rust-lang/crates.io-index") => {
            let index = if kind == "sparse" { source } else { address };
            format!(
                "version = \"={VERSION}\", registry-index = {}",
                quoted(index)
            )
        }
        "registry" => format!("version = \"={VERSION}\""),
        _ => format!("path = {}", quoted(&folder_of(package).to_string_lossy())),
    }
}

/// Returns the tip-sim that belongs to a runtime whose project has none: from the same registry,
/// repository or checkout.
fn matching_sim(runtime: &Value, source: &str) -> Result<String, NotBuilt> {
    if !source.starts_with("path") {
        return Ok(source.to_owned());
    }
    let folder = folder_of(runtime).with_file_name("tools").join("sim");
    if folder.join("Cargo.toml").exists() {
        return Ok(format!("path = {}", quoted(&folder.to_string_lossy())));
    }
    Err(NotBuilt::Failed(
        "the project has tip-runtime from a folder, and no tip-sim: add it as a dev-dependency, so that the interpreter can be built"
            .to_owned(),
    ))
}

fn folder_of(package: &Value) -> PathBuf {
    let manifest = Path::new(package["manifest_path"].as_str().unwrap_or_default());
    manifest.parent().unwrap_or(manifest).to_owned()
}

/// Quotes a string for TOML; a string of JSON is one of TOML too, but for one character.
fn quoted(text: &str) -> String {
    Value::from(text).to_string().replace('\x7F', "\\u007F")
}
