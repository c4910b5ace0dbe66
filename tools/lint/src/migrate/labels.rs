//! Labels whose names became words of the language.

use super::Migrator;
use super::lines::Piece;
use crate::message::Migrating;
use std::collections::{HashMap, HashSet};
use tipc::language::Edition;
use tipc::language::reserved::is_reserved;
use tipc::source::Span;

/// The one word that may be a label all the same.
const LOOP: &str = "LOOP";

impl Migrator<'_> {
    /// Gives such labels another name, wherever they are.
    pub(super) fn labels(&mut self, pieces: &[Piece]) {
        let upper = |span: Span| self.source.slice(span).to_ascii_uppercase();
        let declared: Vec<Span> = pieces.iter().filter_map(Piece::label).collect();
        let names: HashSet<String> = declared.iter().map(|span| upper(*span)).collect();
        let statements = pieces.iter().filter_map(Piece::statement);
        let jumps = statements.flat_map(|statement| statement.jumps());
        let mut free: HashMap<String, String> = HashMap::new();
        for span in jumps.chain(declared).collect::<Vec<Span>>() {
            let name = self.source.slice(span).to_ascii_uppercase();
            let clashes =
                names.contains(&name) && name != LOOP && is_reserved(&name, Edition::V3_1);
            if clashes {
                let new = free.entry(name.clone());
                let new = new.or_insert_with(|| free_name(&name, &names)).clone();
                self.rename(span, &new);
                self.change(span, Migrating::Label { name, new });
            }
        }
    }
}

/// Returns a name that no label has.
fn free_name(name: &str, names: &HashSet<String>) -> String {
    let candidates = (1..).map(|number| format!("{name}_{number}"));
    let mut free = candidates.filter(|candidate| !names.contains(candidate));
    free.next().unwrap_or_default()
}
