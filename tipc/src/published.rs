//! Robots that can be bought or built, each with the figures that were published of it: the descriptions in `robots/`.
//!
//! Wherever a robot is chosen by its name, these names do as well; reading them needs the feature `robot-files`.
//!
//! ```
//! let phantomx = tipc::published::find("phantomx").expect("it is one of them");
//! assert!(phantomx.summary().contains("a hexapod"));
//! # #[cfg(feature = "robot-files")]
//! assert_eq!(phantomx.read().expect("it was tried").robot().signature().legs, 6);
//! ```

/// A robot, and the text that describes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Published {
    /// Name in options, macros and `tip.toml`.
    pub name: &'static str,
    /// Its description: figures, their sources and licences.
    pub text: &'static str,
}

macro_rules! published {
    ($($name:literal)*) => {
        /// Every one.
        pub const ALL: &[Published] = &[$(Published {
            name: $name,
            text: include_str!(concat!("../robots/", $name, ".toml")),
        }),*];
    };
}

published! { "a1" "phantomx" "solo12" "spotmicro" "trifinger" }

/// Returns the robot of that name.
pub fn find(name: &str) -> Option<&'static Published> {
    ALL.iter().find(|robot| robot.name == name)
}

impl Published {
    /// Returns a description of one line.
    pub fn summary(&self) -> &'static str {
        let first = self.text.lines().next().unwrap_or_default();
        first.trim_start_matches(['#', ' '])
    }

    /// Returns the name of the text in messages.
    pub fn file(&self) -> String {
        format!("{}.toml", self.name)
    }
}

#[cfg(all(test, feature = "robot-files"))]
mod tests {
    use super::*;

    #[test]
    fn each_says_where_its_figures_come_from() {
        for robot in ALL {
            let read = robot.read();
            let description = read.unwrap_or_else(|loaded| panic!("{}: {loaded:?}", robot.name));
            assert_eq!(description.name(), robot.name);
            assert_eq!(find(robot.name), Some(robot));
            assert!(robot.summary().contains(": "), "{}", robot.summary());
            for words in [
                "Source of what is marked S: github.com/",
                "Licence: ",
                "What is marked A is assumed",
            ] {
                assert!(robot.text.contains(words), "{}: {words}", robot.name);
            }
        }
        assert_eq!(find("phantomX"), None);
    }
}
