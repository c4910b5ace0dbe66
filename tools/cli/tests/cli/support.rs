//! A folder for each test, and the command in it.

use std::fs;
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use std::sync::OnceLock;

/// A folder of its own for each test.
pub(crate) struct Folder(PathBuf);

impl Folder {
    /// An empty folder; `name` is the test's own.
    pub(crate) fn new(name: &str) -> Self {
        let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
            .join("cli")
            .join(name);
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("the target folder is writable");
        Folder(path)
    }

    /// Writes a file, and the folders on the way to it.
    pub(crate) fn file(self, name: &str, content: impl AsRef<[u8]>) -> Self {
        let path = self.0.join(name);
        path.parent().map(fs::create_dir_all);
        fs::write(path, content).expect("the folder is writable");
        self
    }

    /// Writes a program that sets itself apart by its statements only.
    pub(crate) fn program(self, name: &str, statements: &str) -> Self {
        self.file(name, format!("3.1\ntest\n{statements}\n"))
    }

    /// Returns the path of a file, which need not exist.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// The text of a file.
    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Returns true if a file exists.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.0.join(name).exists()
    }

    /// The names of everything in it, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the folder exists");
        let mut names: Vec<_> = entries
            .map(|entry| {
                entry
                    .expect("readable")
                    .file_name()
                    .to_string_lossy()
                    .into_owned()
            })
            .collect();
        names.sort();
        names
    }

    /// The command, in this folder, with these arguments.
    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = process(env!("CARGO_BIN_EXE_tip"));
        command
            .current_dir(&self.0)
            .args(arguments)
            .stdin(Stdio::null());
        // The language is English, whoever runs the tests.
        for variable in ["LC_ALL", "LC_MESSAGES", "LANG"] {
            command.env_remove(variable);
        }
        command
    }

    /// Runs the command to its end.
    pub(crate) fn tip(&self, arguments: &[&str]) -> Outcome {
        let output = self.command(arguments).output().expect("tip starts");
        Outcome::of(output)
    }
}

/// A process with the signals of a shell in the foreground: what runs the tests may ignore Ctrl-C, as background jobs do.
pub(crate) fn process(program: &str) -> Command {
    static IS_IGNORED: OnceLock<bool> = OnceLock::new();
    let is_ignored = || {
        let survivor = Command::new("sh").args(["-c", "kill -INT $$"]).status();
        cfg!(unix) && survivor.is_ok_and(|status| status.success())
    };
    if !IS_IGNORED.get_or_init(is_ignored) {
        return Command::new(program);
    }
    let mut command = Command::new("env");
    command.args(["--default-signal=INT,HUP,TERM", program]);
    command
}

/// Starts a command with keys; its outputs are piped.
pub(crate) fn start(command: &mut Command, keys: impl Into<Stdio>) -> Child {
    command.stdin(keys).stdout(Stdio::piped());
    command.stderr(Stdio::piped()).spawn().expect("it starts")
}

/// Returns a command whose last arguments are another one, in the same folder and with the same variables.
pub(crate) fn through(wrapper: &[&str], inner: &Command) -> Command {
    let mut command = Command::new(wrapper[0]);
    command.args(&wrapper[1..]);
    command.arg(inner.get_program()).args(inner.get_args());
    let variables = inner.get_envs();
    command.envs(variables.filter_map(|(key, value)| Some((key, value?))));
    if let Some(folder) = inner.get_current_dir() {
        command.current_dir(folder);
    }
    command
}

/// The output and the exit status of a command.
#[derive(Debug)]
pub(crate) struct Outcome {
    pub(crate) status: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Outcome {
    pub(crate) fn of(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("output is UTF-8");
        Outcome {
            status: output.status.code().expect("tip ends by itself"),
            out: text(output.stdout),
            err: text(output.stderr),
        }
    }

    /// Fails unless the exit status is this one.
    pub(crate) fn expect(self, status: i32) -> Self {
        assert_eq!(self.status, status, "{self:#?}");
        self
    }

    /// The lines of standard output.
    pub(crate) fn lines(&self) -> Vec<&str> {
        self.out.lines().collect()
    }
}
