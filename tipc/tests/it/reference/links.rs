//! Links between documents lead somewhere.

use crate::reference::{documents, read, workspace};

#[test]
fn links_lead_to_files_and_headings() {
    for document in documents() {
        let text = read(&document);
        for link in links(&text) {
            let (path, place) = link.split_once('#').unwrap_or((link, ""));
            let folder = document.rsplit_once('/').map_or("", |(folder, _)| folder);
            let target = match path {
                "" => document.clone(),
                _ => format!("{folder}/{path}")
                    .trim_start_matches('/')
                    .to_owned(),
            };
            let file = workspace().join(&target);
            assert!(file.exists(), "{document}: {link}");
            let found = place.is_empty() || anchors(&read(&target)).contains(&place.to_owned());
            assert!(found, "{document}: {link} has no such heading");
        }
    }
}

/// Returns what is between `](` and `)`, without addresses.
fn links(text: &str) -> impl Iterator<Item = &str> {
    let targets = text.split("](").skip(1);
    targets
        .filter_map(|rest| rest.split(')').next())
        .filter(|link| !link.contains("://"))
}

fn anchors(text: &str) -> Vec<String> {
    let headings = text.lines().filter(|line| line.starts_with('#'));
    headings.map(anchor).collect()
}

/// Returns the anchor that a heading gets.
pub(crate) fn anchor(heading: &str) -> String {
    let words = heading.trim_start_matches('#').trim().to_lowercase();
    words
        .chars()
        .filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'))
        .map(|c| if c == ' ' { '-' } else { c })
        .collect()
}
