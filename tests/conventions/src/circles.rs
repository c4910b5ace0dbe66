//! Modules that import each other in a loop.

use crate::imports::{Import, imports};
use crate::modules::Module;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

type Path = Vec<String>;
type Graph = BTreeMap<Path, BTreeSet<Import>>;

/// Some modules, each of which needs all others of them.
#[derive(Clone, Debug)]
pub struct Circle {
    /// Imports between modules.
    pub edges: Vec<(Path, Import)>,
}

impl fmt::Display for Circle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (from, import) in &self.edges {
            let to = import.module.join("::");
            writeln!(f, "  {} -> {to}: {}", from.join("::"), import.name)?;
        }
        Ok(())
    }
}

/// All loops among the modules of a crate.
pub fn circles(modules: &BTreeMap<Path, Module>) -> Vec<Circle> {
    let graph: Graph = modules
        .values()
        .map(|module| (module.path.clone(), imports(module, modules)))
        .collect();
    let reach: BTreeMap<&Path, BTreeSet<&Path>> = graph
        .keys()
        .map(|path| (path, reachable(&graph, path)))
        .collect();
    let mut seen = BTreeSet::new();
    let mut found = Vec::new();
    for path in graph.keys() {
        let loops_with = |other: &&Path| reach[*other].contains(path);
        let members: BTreeSet<&Path> = reach[path].iter().copied().filter(loops_with).collect();
        if !members.is_empty() && seen.insert(members.clone()) {
            found.push(Circle {
                edges: edges(&graph, &members),
            });
        }
    }
    found
}

/// The modules that a module needs, itself only if a loop leads back.
fn reachable<'g>(graph: &'g Graph, from: &Path) -> BTreeSet<&'g Path> {
    let mut found = BTreeSet::new();
    let mut open = vec![from];
    while let Some(path) = open.pop() {
        for import in &graph[path] {
            if let Some((next, _)) = graph.get_key_value(&import.module)
                && found.insert(next)
            {
                open.push(next);
            }
        }
    }
    found
}

fn edges(graph: &Graph, members: &BTreeSet<&Path>) -> Vec<(Path, Import)> {
    let inside = |import: &&Import| members.contains(&import.module);
    members
        .iter()
        .flat_map(|from| {
            let imports = graph[*from].iter().filter(inside);
            imports.map(|import| ((*from).clone(), import.clone()))
        })
        .collect()
}
