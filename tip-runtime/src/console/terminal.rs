//! A terminal console: keys as they are pressed, bar graphs and the message on one line.

pub use raw::TerminalState;

use super::key::{Key, KeyDecoder};
use super::{Bars, Console};
use crate::emergency::Report;
use crate::printable::Printable;
use core::fmt::Display;
use core::mem;
use std::io::{self, IsTerminal, Read, Stdout, Write};
use std::string::{String, ToString};

/// The byte of Ctrl-C.
const CONTROL_C: u8 = 0x03;
/// The escape sequence that moves to the start of the line and clears it.
const CLEAR: &str = "\r\x1b[2K";
/// The byte of the RETURN key: software emergency stop.
const RETURN: u8 = 0x0D;

/// The terminal of standard input, showing messages on an output.
///
/// While it lives, keys arrive without RETURN and unechoed; dropping it restores the terminal. If
/// standard input is not a terminal, it is left alone and no keys arrive.
///
/// A process in the background gets no keys: they are not meant for it, and the system would suspend
/// it for reading them.
///
/// Ctrl-C arrives as a byte as well: it stops the robot as the RETURN key does, unless
/// [`report_interrupts`](Self::report_interrupts) says otherwise.
#[derive(Debug)]
pub struct Terminal<W: Write = Stdout> {
    output: W,
    /// The output is a terminal, whose line can be overwritten.
    rewrites: bool,
    silent: bool,
    /// Bar graphs, shown only where the line can be overwritten.
    graphs: [String; 2],
    text: String,
    stops_on_interrupt: bool,
    interrupted: bool,
    raw: Option<raw::Raw>,
    decoder: KeyDecoder,
}

impl Terminal {
    /// Shows messages on standard output.
    pub fn new() -> Self {
        let output = io::stdout();
        let rewrites = output.is_terminal();
        Self::on(output, rewrites)
    }

    /// Returns true if the keys of standard input are meant for this process: it is in the foreground of
    /// its terminal, or of none. Creating a terminal in the background suspends the process; one that
    /// handles the signal for that, SIGTTOU, would wait forever.
    pub fn is_in_foreground() -> bool {
        raw::is_in_foreground()
    }
}

impl Default for Terminal {
    fn default() -> Self {
        Self::new()
    }
}

impl<W: Write> Terminal<W> {
    /// Shows messages on `output`, each in place of the previous one if `rewrites` says that this
    /// is possible.
    pub fn on(output: W, rewrites: bool) -> Self {
        Terminal {
            raw: raw::Raw::enter(),
            ..Self::without_keys(output, rewrites)
        }
    }

    fn without_keys(output: W, rewrites: bool) -> Self {
        Terminal {
            output,
            rewrites,
            silent: false,
            graphs: Default::default(),
            text: String::new(),
            stops_on_interrupt: true,
            interrupted: false,
            raw: None,
            decoder: KeyDecoder::default(),
        }
    }

    /// Makes Ctrl-C only set [`interrupted`](Self::interrupted); the host decides what follows.
    #[must_use]
    pub fn report_interrupts(mut self) -> Self {
        self.stops_on_interrupt = false;
        self
    }

    /// Returns true if Ctrl-C was pressed.
    pub fn interrupted(&self) -> bool {
        self.interrupted
    }

    /// Returns the next key that was pressed, arrows included.
    pub fn pressed(&mut self) -> Option<Key> {
        let mut decoder = mem::take(&mut self.decoder);
        let key = decoder.key(|| self.byte());
        self.decoder = decoder;
        key
    }

    /// Returns the next byte of standard input; RETURN for Ctrl-C, if it stops the robot.
    fn byte(&mut self) -> Option<u8> {
        self.raw.as_ref().filter(|_| raw::is_in_foreground())?;
        let mut byte = [0];
        match io::stdin().read(&mut byte) {
            Ok(1) => {}
            _ => return None,
        }
        match byte {
            [CONTROL_C] => {
                self.interrupted = true;
                self.stops_on_interrupt.then_some(RETURN)
            }
            [byte] => Some(byte),
        }
    }
}

impl<W: Write> Console for Terminal<W> {
    fn key(&mut self, _cycle: u64) -> Option<u8> {
        loop {
            match self.pressed()? {
                Key::Byte(byte) => return Some(byte),
                // An arrow is no key of a program.
                Key::Up | Key::Down | Key::Left | Key::Right => {}
            }
        }
    }

    fn message(&mut self, text: &dyn Display) {
        if self.silent {
            return;
        }
        let text = Printable::message(text);
        if self.rewrites {
            self.text = text.to_string();
            self.rewrite();
        } else {
            let _ = writeln!(self.output, "{text}");
            let _ = self.output.flush();
        }
    }

    fn silent(&mut self, on: bool) {
        if on && self.rewrites && !self.silent {
            self.text.clear();
            let _ = write!(self.output, "{CLEAR}");
            let _ = self.output.flush();
        }
        self.silent = on;
    }

    fn bars(&mut self, graph: u8, bars: Bars<'_>) {
        let Some(shown) = self.graphs.get_mut(usize::from(graph)) else {
            return;
        };
        let gap = if bars.0.is_empty() { "" } else { " " };
        let drawn = std::format!("{bars}{gap}");
        let changed = drawn != *shown;
        *shown = drawn;
        if changed && self.rewrites && !self.silent {
            self.rewrite();
        }
    }

    fn emergency(&mut self, report: &Report<'_>) {
        self.report(report);
    }

    /// Moves to the next line, so that the last message stays.
    fn ended(&mut self) {
        if self.rewrites && !self.silent {
            let _ = writeln!(self.output);
        }
    }
}

/// Writes to the output: a console cannot refuse a text, so a closed output loses it.
impl<W: Write> Terminal<W> {
    fn rewrite(&mut self) {
        let Terminal {
            output,
            graphs: [first, second],
            text,
            ..
        } = self;
        let _ = write!(output, "{CLEAR}{first}{second}{text}");
        let _ = output.flush();
    }

    /// Prints several lines, even under SILENT_ON.
    fn report(&mut self, text: &dyn Display) {
        let start = if self.rewrites { CLEAR } else { "" };
        let _ = write!(self.output, "{start}{text}");
        let _ = self.output.flush();
    }
}

/// Standard input without line editing.
#[cfg(unix)]
mod raw {
    use rustix::process::getpgrp;
    use rustix::termios::{
        InputModes, LocalModes, OptionalActions, SpecialCodeIndex, Termios, tcgetattr, tcgetpgrp,
        tcsetattr,
    };
    use std::io::{IsTerminal, stdin};

    /// The saved mode of the standard input's terminal, for a host that has to end a process without
    /// dropping its [`Terminal`](super::Terminal).
    #[derive(Debug)]
    pub struct TerminalState(Option<Termios>);

    impl TerminalState {
        /// Returns the current mode. If standard input is not a terminal, or refuses, there is nothing
        /// to restore.
        pub fn now() -> Self {
            let input = stdin();
            let state = input.is_terminal().then(|| tcgetattr(&input).ok());
            TerminalState(state.flatten())
        }

        /// Restores the saved mode, unless another process has the terminal now.
        pub fn restore(&self) {
            if let Some(state) = self.0.as_ref().filter(|_| is_in_foreground()) {
                // Nothing is left to be done for a terminal that is gone.
                let _ = tcsetattr(stdin(), OptionalActions::Now, state);
            }
        }
    }

    /// Standard input without line editing; dropping it restores the former mode.
    #[derive(Debug)]
    pub(super) struct Raw(TerminalState);

    impl Raw {
        /// Switches line editing off; `None` if standard input is not a terminal, or refuses.
        pub(super) fn enter() -> Option<Self> {
            let former = TerminalState::now();
            let mut raw = former.0.clone()?;
            raw.local_modes
                .remove(LocalModes::ICANON | LocalModes::ECHO | LocalModes::ISIG);
            raw.input_modes.remove(InputModes::ICRNL | InputModes::IXON);
            // Reading gives what there is, immediately.
            raw.special_codes[SpecialCodeIndex::VMIN] = 0;
            raw.special_codes[SpecialCodeIndex::VTIME] = 0;
            tcsetattr(stdin(), OptionalActions::Now, &raw).ok()?;
            Some(Raw(former))
        }
    }

    impl Drop for Raw {
        fn drop(&mut self) {
            self.0.restore();
        }
    }

    /// Returns true also for a terminal that does not control this process: it has no foreground.
    pub(super) fn is_in_foreground() -> bool {
        tcgetpgrp(stdin()).map_or(true, |foreground| foreground == getpgrp())
    }
}

/// Standard input without line editing: not available on this system.
#[cfg(not(unix))]
mod raw {
    /// The saved mode of the standard input's terminal: on this system it is never changed.
    #[derive(Debug)]
    pub struct TerminalState;

    impl TerminalState {
        /// Returns the current mode.
        pub fn now() -> Self {
            TerminalState
        }

        /// Does nothing: there is nothing to restore.
        pub fn restore(&self) {}
    }

    #[derive(Debug)]
    pub(super) struct Raw;

    impl Raw {
        pub(super) fn enter() -> Option<Self> {
            None
        }
    }

    /// Returns true: there is no background here.
    pub(super) fn is_in_foreground() -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    fn shown(rewrites: bool, act: impl FnOnce(&mut Terminal<Vec<u8>>)) -> std::string::String {
        let mut line = Terminal::without_keys(Vec::new(), rewrites);
        act(&mut line);
        std::string::String::from_utf8(line.output).expect("text")
    }

    // clauses: 7.34 7.35
    #[test]
    fn a_terminal_shows_one_message_in_place_of_the_other() {
        let text = shown(true, |line| {
            line.message(&"one");
            line.message(&"");
            line.ended();
        });
        assert_eq!(text, "\r\x1b[2Kone\r\x1b[2K\n");
    }

    // clauses: 7.35
    #[test]
    fn a_file_keeps_every_message() {
        let text = shown(false, |line| {
            line.message(&"one");
            line.message(&"two");
            line.ended();
        });
        assert_eq!(text, "one\ntwo\n");
    }

    // clauses: 7.34
    #[test]
    fn a_message_cannot_steer_the_terminal() {
        let say =
            |line: &mut Terminal<Vec<u8>>| line.message(&"\x07a\tb\x1b[31m\n\u{9b}2J\u{202e}");
        let shown_as = "\x07a\tb\\u{1b}[31m\\u{a}\\u{9b}2J\\u{202e}";
        assert_eq!(shown(true, say), std::format!("{CLEAR}{shown_as}"));
        assert_eq!(shown(false, say), std::format!("{shown_as}\n"));
    }

    // clauses: 7.35 7.48
    #[test]
    fn bar_graphs_stand_before_the_message_and_are_drawn_when_they_change() {
        let act = |line: &mut Terminal<Vec<u8>>| {
            line.message(&"one");
            line.bars(1, Bars(&[0.0, 1.0]));
            line.bars(0, Bars(&[1.0]));
            line.bars(0, Bars(&[1.0]));
            line.message(&"two");
            line.bars(1, Bars(&[]));
            line.bars(2, Bars(&[1.0]));
            line.silent(true);
            line.bars(0, Bars(&[0.0]));
            line.silent(false);
            line.bars(0, Bars(&[]));
        };
        let lines = ["one", "▁█ one", "█ ▁█ one", "█ ▁█ two", "█ two", "", ""];
        let expected: String = lines.map(|line| std::format!("{CLEAR}{line}")).concat();
        assert_eq!(shown(true, act), expected);
        assert_eq!(shown(false, act), "one\ntwo\n");
    }

    // clauses: 7.37
    #[test]
    fn silence_clears_the_line_and_lets_only_emergencies_through() {
        let text = shown(true, |line| {
            line.silent(true);
            line.message(&"one");
            line.report(&"TIP_ERR\n");
            line.silent(false);
            line.message(&"two");
        });
        assert_eq!(text, "\r\x1b[2K\r\x1b[2KTIP_ERR\n\r\x1b[2Ktwo");
    }
}
