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
