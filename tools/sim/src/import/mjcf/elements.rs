//! The elements of an MJCF file with those of the files that it includes, their default classes, and
//! the values of their attributes. The meaning of elements is in [`bodies`](super::bodies).

use super::super::ImportError;
use super::super::xml;
use crate::message::{Importing, Place};
use roxmltree::{Document, Node};
use std::collections::BTreeMap;
use std::path::{Component, Path};
use tipc::embed::{self, LIMIT};
use tipc::message::list::List;

/// Maximum number of elements, those of included files among them.
const MAX_ELEMENTS: usize = 100_000;
/// Maximum nesting depth, through included files.
const MAX_DEPTH: usize = 100;
/// Maximum number of included files.
const MAX_FILES: usize = 100;

/// A byte of one of the files.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    file: usize,
    byte: usize,
}

/// An element of the main file or of an included one.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) attributes: Vec<Attribute>,
    pub(super) children: Vec<Element>,
    pub(super) at: Spot,
}

#[derive(Debug)]
pub(super) struct Attribute {
    pub(super) name: String,
    pub(super) value: String,
    pub(super) at: Spot,
}

impl Element {
    pub(super) fn attribute(&self, name: &str) -> Option<&Attribute> {
        self.attributes.iter().find(|own| own.name == name)
    }

    pub(super) fn value(&self, name: &str) -> Option<&str> {
        self.attribute(name).map(|own| own.value.as_str())
    }

    /// Iterates over the children of all children of a name: sections may be repeated.
    pub(super) fn section(&self, name: &'static str) -> impl Iterator<Item = &Element> {
        let sections = self.children.iter().filter(move |one| one.name == name);
        sections.flat_map(|one| &one.children)
    }
}

/// The texts of all files, for the places in errors.
#[derive(Debug, Default)]
pub(super) struct Files {
    /// Names in includes, and texts; the main file comes first.
    files: Vec<(String, String)>,
}

impl Files {
    /// Returns the line and column of a byte, with the name of an included file.
    pub(super) fn place(&self, spot: Spot) -> Place {
        let Some((file, text)) = self.files.get(spot.file) else {
            return Place::At { line: 1, column: 1 };
        };
        match (spot.file, xml::position(text, spot.byte)) {
            (0, place) | (_, place @ Place::In { .. }) => place,
            (_, Place::At { line, column }) => Place::In {
                file: file.clone(),
                line,
                column,
            },
        }
    }

    /// Reads the elements of the main file and of those that it includes below a folder.
    pub(super) fn read(
        &mut self,
        document: &Document<'_>,
        folder: Option<&Path>,
    ) -> Result<Element, ImportError> {
        self.files
            .push((String::new(), document.input_text().to_owned()));
        let mut reader = Reader {
            files: self,
            folder,
            count: 0,
            bytes: document.input_text().len(),
        };
        let mut read = Vec::new();
        reader.element(document.root_element(), 0, 0, &mut read)?;
        // A root that is an include has been refused as no MJCF.
        read.pop().ok_or_else(|| {
            ImportError::new(Importing::NotARobot {
                element: document.root_element().tag_name().name().to_owned(),
            })
        })
    }
}

struct Reader<'a> {
    files: &'a mut Files,
    folder: Option<&'a Path>,
    /// Number of elements.
    count: usize,
    /// Size of all files.
    bytes: usize,
}

impl Reader<'_> {
    /// Reads an element; an include is replaced by the elements of its file.
    fn element(
        &mut self,
        node: Node<'_, '_>,
        file: usize,
        depth: usize,
        into: &mut Vec<Element>,
    ) -> Result<(), ImportError> {
        let spot = |byte| Spot { file, byte };
        let at = spot(node.range().start);
        self.count += 1;
        if self.count > MAX_ELEMENTS {
            return Err(ImportError::new(Importing::TooManyElements {
                at: self.files.place(at),
                most: MAX_ELEMENTS,
            }));
        }
        let name = node.tag_name().name();
        if depth > MAX_DEPTH {
            return Err(ImportError::new(Importing::TooDeep {
                element: name.to_owned(),
                most: MAX_DEPTH as u32,
            }));
        }
        if name == "include" {
            return self.include(node, at, depth, into);
        }
        let attributes = node.attributes().map(|own| Attribute {
            name: own.name().to_owned(),
            value: own.value().to_owned(),
            at: spot(own.range().start),
        });
        let mut element = Element {
            name: name.to_owned(),
            attributes: attributes.collect(),
            children: Vec::new(),
            at,
        };
        for child in node.children().filter(Node::is_element) {
            self.element(child, file, depth + 1, &mut element.children)?;
        }
        into.push(element);
        Ok(())
    }

    fn include(
        &mut self,
        node: Node<'_, '_>,
        at: Spot,
        depth: usize,
        into: &mut Vec<Element>,
    ) -> Result<(), ImportError> {
        let at = self.files.place(at);
        let Some(name) = node.attribute("file") else {
            return Err(ImportError::new(Importing::NoAttribute {
                at,
                element: "include".to_owned(),
                attribute: "file",
                example: "legs.xml",
            }));
        };
        let text = self.included(name, &at)?;
        let text = xml::without_late_declaration(&text).into_owned();
        let inside = |error: ImportError| {
            ImportError::new(Importing::InIncluded {
                at: at.clone(),
                file: name.to_owned(),
                reason: error.to_string().into(),
            })
        };
        let document = xml::parse(&text).map_err(inside)?;
        let file = self.files.files.len();
        self.files.files.push((name.to_owned(), text.clone()));
        // The root element of an included file only holds others.
        let root = document.root_element();
        for child in root.children().filter(Node::is_element) {
            self.element(child, file, depth, into)?;
        }
        Ok(())
    }

    /// Returns the text of an included file: a regular file below the folder of the main file, which is
    /// included once, as MuJoCo has it.
    fn included(&mut self, name: &str, at: &Place) -> Result<String, ImportError> {
        let refused = |reason: Importing| Err(ImportError::new(reason));
        let (at, file) = (at.clone(), name.to_owned());
        let Some(folder) = self.folder else {
            return refused(Importing::IncludeWithoutFolder { at, file });
        };
        let is_plain = |part| matches!(part, Component::Normal(_) | Component::CurDir);
        if !Path::new(name).components().all(is_plain) {
            return refused(Importing::IncludeOutside { at, file });
        }
        let path = folder.join(name);
        // A link may lead out of the folder.
        if let (Ok(real), Ok(folder)) = (path.canonicalize(), folder.canonicalize())
            && !real.starts_with(&folder)
        {
            return refused(Importing::IncludeOutside { at, file });
        }
        let is_same = |other: &str| {
            let plain = |name| {
                let parts = Path::new(name).components();
                parts
                    .filter(|part| *part != Component::CurDir)
                    .collect::<Vec<_>>()
            };
            plain(other) == plain(name)
        };
        let mut known = self.files.files.iter().skip(1);
        if known.any(|(other, _)| is_same(other)) {
            return refused(Importing::IncludedTwice { at, file });
        }
        if self.files.files.len() > MAX_FILES {
            return refused(Importing::TooManyIncludes {
                at,
                most: MAX_FILES,
            });
        }
        let bytes = match embed::read_file(&path, LIMIT) {
            Ok(bytes) => bytes,
            Err(reason) => {
                let reason = reason.to_string().into();
                return refused(Importing::CannotInclude { at, file, reason });
            }
        };
        self.bytes += bytes.len();
        if self.bytes > LIMIT << 20 {
            return refused(Importing::IncludesTooLarge { at, limit: LIMIT });
        }
        xml::decode(&bytes)
    }
}

/// The default classes.
pub(super) struct Classes<'a> {
    classes: Vec<Class<'a>>,
    indices: BTreeMap<&'a str, usize>,
}

struct Class<'a> {
    parent: Option<usize>,
    /// Attributes by the kind of element and their name.
    own: BTreeMap<&'a str, BTreeMap<&'a str, &'a Attribute>>,
}

/// The name of the class that all others inherit from.
const MAIN: &str = "main";

impl<'a> Classes<'a> {
    pub(super) fn read(root: &'a Element, files: &Files) -> Result<Self, ImportError> {
        let mut classes = Classes {
            classes: vec![Class {
                parent: None,
                own: BTreeMap::new(),
            }],
            indices: BTreeMap::from([(MAIN, 0)]),
        };
        for element in root.children.iter().filter(|one| one.name == "default") {
            if let Some(name) = element.value("class") {
                classes.indices.insert(name, 0);
            }
            classes.add(element, 0, files)?;
        }
        Ok(classes)
    }

    /// Adds the contents of a `<default>` to a class. Its depth is bounded by that of the file.
    fn add(
        &mut self,
        element: &'a Element,
        class: usize,
        files: &Files,
    ) -> Result<(), ImportError> {
        for child in &element.children {
            if child.name == "default" {
                let Some(name) = child.attribute("class") else {
                    return Err(ImportError::new(Importing::NoAttribute {
                        at: files.place(child.at),
                        element: child.name.clone(),
                        attribute: "class",
                        example: "leg",
                    }));
                };
                let index = self.classes.len();
                if self.indices.insert(&name.value, index).is_some() {
                    return Err(ImportError::new(Importing::ClassTwice {
                        at: files.place(name.at),
                        class: name.value.clone(),
                    }));
                }
                self.classes.push(Class {
                    parent: Some(class),
                    own: BTreeMap::new(),
                });
                self.add(child, index, files)?;
            } else if let Some(class) = self.classes.get_mut(class) {
                let own = class.own.entry(kind(&child.name)).or_default();
                own.extend(child.attributes.iter().map(|one| (one.name.as_str(), one)));
            }
        }
        Ok(())
    }

    /// Returns the class that an attribute names; `scope` if there is none.
    pub(super) fn named(
        &self,
        named: Option<&Attribute>,
        scope: usize,
        files: &Files,
    ) -> Result<usize, ImportError> {
        let Some(named) = named else {
            return Ok(scope);
        };
        let found = self.indices.get(named.value.as_str()).copied();
        found.ok_or_else(|| {
            let known = self.indices.keys().take(20);
            ImportError::new(Importing::UnknownClass {
                at: files.place(named.at),
                class: named.value.clone(),
                known: List(known.map(|name| xml::printed(name)).collect()),
            })
        })
    }

    pub(super) fn index(&self, class: &str) -> Option<usize> {
        self.indices.get(class).copied()
    }

    /// Returns an attribute of an element, else that of its class.
    fn attribute(&self, element: &'a Element, class: usize, name: &str) -> Option<&'a Attribute> {
        if let Some(own) = element.attribute(name) {
            return Some(own);
        }
        let mut next = Some(class);
        while let Some(class) = next.and_then(|index| self.classes.get(index)) {
            let own = class.own.get(kind(&element.name));
            if let Some(found) = own.and_then(|own| own.get(name)) {
                return Some(found);
            }
            next = class.parent;
        }
        None
    }
}

/// Returns the kind under which defaults of an element are kept: all actuators share theirs.
fn kind(element: &str) -> &str {
    const ACTUATORS: [&str; 10] = [
        "general",
        "motor",
        "position",
        "velocity",
        "intvelocity",
        "damper",
        "cylinder",
        "muscle",
        "adhesion",
        "dcmotor",
    ];
    match ACTUATORS.contains(&element) {
        true => "actuator",
        false => element,
    }
}

/// An element with the attributes of its class.
#[derive(Clone, Copy)]
pub(super) struct Merged<'a, 'c> {
    pub(super) element: &'a Element,
    pub(super) class: usize,
    pub(super) classes: &'c Classes<'a>,
    pub(super) files: &'c Files,
}

impl<'a> Merged<'a, '_> {
    pub(super) fn attribute(&self, name: &str) -> Option<&'a Attribute> {
        self.classes.attribute(self.element, self.class, name)
    }

    pub(super) fn value(&self, name: &str) -> Option<&'a str> {
        self.attribute(name).map(|own| own.value.trim())
    }

    /// Returns up to `MOST` finite numbers of an attribute, and at least `least`.
    pub(super) fn numbers(
        &self,
        name: &'static str,
        least: usize,
        most: usize,
        example: &'static str,
    ) -> Result<Option<Vec<f64>>, ImportError> {
        let Some(own) = self.attribute(name) else {
            return Ok(None);
        };
        let wrong = || {
            ImportError::new(Importing::NotSoManyNumbers {
                at: self.files.place(own.at),
                element: self.element.name.clone(),
                attribute: name,
                value: own.value.clone(),
                wanted: least,
                example,
            })
        };
        let mut numbers = Vec::new();
        for word in own.value.split_whitespace() {
            let number = word.parse().ok().filter(|number: &f64| number.is_finite());
            numbers.push(number.ok_or_else(wrong)?);
            if numbers.len() > most {
                return Err(wrong());
            }
        }
        match numbers.len() >= least {
            true => Ok(Some(numbers)),
            false => Err(wrong()),
        }
    }

    /// Returns exactly `N` finite numbers of an attribute.
    pub(super) fn vector<const N: usize>(
        &self,
        name: &'static str,
        example: &'static str,
    ) -> Result<Option<[f64; N]>, ImportError> {
        let numbers = self.numbers(name, N, N, example)?;
        Ok(numbers.and_then(|numbers| numbers.try_into().ok()))
    }

    pub(super) fn number(
        &self,
        name: &'static str,
        example: &'static str,
    ) -> Result<Option<f64>, ImportError> {
        let number = self.vector::<1>(name, example)?;
        Ok(number.map(|[number]| number))
    }

    /// Returns the position of an attribute, else of the element.
    pub(super) fn place(&self, name: &str) -> Place {
        let at = self
            .attribute(name)
            .map_or(self.element.at, |found| found.at);
        self.files.place(at)
    }

    /// Returns the index of an attribute's word among those that are known.
    pub(super) fn word(
        &self,
        name: &'static str,
        known: &[&'static str],
    ) -> Result<Option<usize>, ImportError> {
        let Some(own) = self.attribute(name) else {
            return Ok(None);
        };
        let found = known.iter().position(|word| *word == own.value.trim());
        found.map(Some).ok_or_else(|| {
            ImportError::new(Importing::NotAWord {
                at: self.files.place(own.at),
                element: self.element.name.clone(),
                attribute: name,
                value: own.value.clone(),
                known: List(known.iter().map(|word| (*word).to_owned()).collect()),
            })
        })
    }
}
