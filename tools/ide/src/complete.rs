//! What can be written at a place.

mod place;

use crate::hover::usage;
use crate::targets::{robot_flags, robot_inputs, targets};
use crate::template::template;
use crate::{Document, Offer, OfferKind};
use place::Place;
use tip_runtime::command::Teach;
use tipc::language::commands::{Arguments, COMMANDS, Command, Form, Meaning, Targets, Values};
use tipc::language::functions::FUNCTIONS;
use tipc::language::reserved::{JOINT, Kind, LOOP, POSITION, RESERVED, VAR_KEY, motion_flags};
use tipc::language::{Bilingual, Keyword};
use tipc::source::Span;
use tipc::symbols::{Definition, DefinitionKind};
use tipc::syntax::VariableKind;

/// The types of variables.
const SCALARS: &[VariableKind] = &[VariableKind::Var, VariableKind::Pos, VariableKind::Joint];

impl Document {
    /// What can be written at a byte of the text. The word that is begun there goes; offers are not filtered by it.
    pub fn complete(&self, offset: usize) -> Vec<Offer> {
        let Some((place, span)) = self.place(offset) else {
            return Vec::new();
        };
        let mut offers = self.offers(&place, span.start);
        for offer in &mut offers {
            offer.span = span;
        }
        offers
    }

    /// The same, but no more than `most`: of more, those that have the typed letters in this order. Whether these are all.
    pub fn complete_with(&self, offset: usize, most: usize) -> (Vec<Offer>, bool) {
        let mut offers = self.complete(offset);
        let are_all = offers.len() <= most;
        if !are_all {
            offers.retain(|offer| {
                let typed = Span::new(offer.span.start, offset.max(offer.span.start));
                has_letters(&offer.label, self.slice(typed))
            });
            offers.truncate(most);
        }
        (offers, are_all)
    }

    fn offers(&self, place: &Place, at: usize) -> Vec<Offer> {
        match place {
            Place::Version => {
                let version = self.loaded.module.edition.to_string();
                vec![Offer::new(version, OfferKind::Constant, Bilingual::EMPTY)]
            }
            Place::Start => self.starts(),
            Place::Member(name) => self.members(name),
            Place::Label(keyword) => self.labels(*keyword, at),
            Place::Declaration => Vec::new(),
            Place::Condition(keyword) => self.condition(*keyword),
            Place::Counting(particle) => {
                let mut offers = self.variables(SCALARS);
                offers.extend(particle.map(keyword_offer));
                offers
            }
            Place::Counter | Place::Placeholder => self.variables(&[VariableKind::Var]),
            Place::Right => {
                let mut offers = self.variables(SCALARS);
                offers.extend(functions());
                offers.extend(constants());
                offers
            }
            Place::Argument(command, written) => self.arguments(command, *written),
        }
    }

    /// What begins a statement.
    fn starts(&self) -> Vec<Offer> {
        let robot = self.robot();
        let edition = self.loaded.module.edition;
        let rows = COMMANDS.iter();
        let rows = rows.filter(|row| row.since <= edition && row.robots.contains(robot));
        let mut offers: Vec<Offer> = rows.map(|row| command_offer(row, self)).collect();
        offers.extend(self.variables(SCALARS));
        offers
    }

    /// Variables of these types, and members of those that have them.
    fn variables(&self, kinds: &[VariableKind]) -> Vec<Offer> {
        let definitions = self.loaded.symbols.definitions().iter();
        let mut offers = Vec::new();
        for definition in definitions {
            let DefinitionKind::Variable(kind) = definition.kind else {
                continue;
            };
            if kinds.contains(&kind) {
                let description = match definition.place {
                    None => reserved_line(VAR_KEY),
                    Some(_) => Bilingual::EMPTY,
                };
                let name = definition.name.as_str();
                let offer = Offer::new(name, OfferKind::Variable, description);
                offers.push(offer.detail(declaring(kind).word()));
            }
        }
        offers
    }

    fn members(&self, name: &str) -> Vec<Offer> {
        let upper = name.to_ascii_uppercase();
        let mut definitions = self.loaded.symbols.definitions().iter();
        let kind = definitions.find(|it| it.name == upper).map(|it| it.kind);
        let names: Vec<String> = match kind {
            Some(DefinitionKind::Variable(VariableKind::Pos)) => {
                POSITION.map(str::to_owned).to_vec()
            }
            Some(DefinitionKind::Variable(VariableKind::Joint)) => {
                let joints = self.robot().signature().joints;
                (1..=joints)
                    .map(|joint| format!("{JOINT}{joint}"))
                    .collect()
            }
            _ => Vec::new(),
        };
        let offers = names.into_iter().map(|name| {
            let description =
                crate::word::member_row(&name).map_or(Bilingual::EMPTY, |row| row.description);
            Offer::new(name, OfferKind::Member, description)
        });
        offers.collect()
    }

    /// Where a jump at a place can lead, with its colon.
    fn labels(&self, keyword: Keyword, at: usize) -> Vec<Offer> {
        let definitions = self.loaded.symbols.definitions().iter();
        let subroutines = self.subroutines();
        let around = |at: usize| {
            let after = subroutines.partition_point(|inside| inside.start < at);
            let last = after.checked_sub(1)?;
            (at <= subroutines[last].end).then_some(last)
        };
        let here = around(at);
        let fits = |it: &Definition| match it.kind {
            DefinitionKind::Variable(_) => false,
            DefinitionKind::Label => {
                let there = it.place.and_then(|place| around(place.start));
                match keyword {
                    Keyword::Goto => there == here,
                    Keyword::Gosub => it.name != LOOP && (there.is_none() || there == here),
                    _ => false,
                }
            }
            DefinitionKind::Subroutine => keyword != Keyword::Goto,
        };
        let mut names: Vec<&str> = definitions
            .filter(|it| fits(it))
            .map(|it| it.name.as_str())
            .collect();
        names.dedup();
        let offers = names.into_iter().map(|name| {
            let offer = Offer::new(name, OfferKind::Label, Bilingual::EMPTY);
            Offer {
                text: format!("{name}:"),
                ..offer
            }
        });
        offers.collect()
    }

    fn condition(&self, keyword: Keyword) -> Vec<Offer> {
        let mut offers: Vec<Offer> = robot_flags(self.robot())
            .into_iter()
            .map(|(flag, row)| Offer::new(flag.to_string(), OfferKind::Flag, row.description))
            .collect();
        offers.extend(self.variables(SCALARS));
        offers.extend(constants());
        let after: &[Keyword] = match keyword {
            Keyword::If => &[Keyword::Then, Keyword::Goto, Keyword::Gosub],
            Keyword::ElseIf => &[Keyword::Then],
            _ => &[],
        };
        offers.extend(after.iter().copied().map(keyword_offer));
        offers
    }

    /// The arguments of a command after so many that are written.
    fn arguments(&self, command: &Command, written: usize) -> Vec<Offer> {
        match (command.form, written) {
            (Form::Robot(arguments), _) => self.robot_arguments(arguments, written),
            (Form::Teach(of), 0) => self.target_offers(of),
            (Form::Teach(_), _) => match command.meaning {
                Meaning::Teach(Teach::Angle | Teach::Torque) => {
                    self.variables(&[VariableKind::Var, VariableKind::Joint])
                }
                _ => self.variables(&[VariableKind::Pos]),
            },
            (Form::AdIn, 0) => {
                let inputs = robot_inputs(self.robot()).into_iter();
                inputs
                    .map(|(name, description)| Offer::new(name, OfferKind::Target, description))
                    .collect()
            }
            (Form::KeyIn | Form::AdIn | Form::Special, _) => self.variables(&[VariableKind::Var]),
            (Form::Words(_), _) => Vec::new(),
        }
    }

    fn robot_arguments(&self, arguments: Arguments, written: usize) -> Vec<Offer> {
        let has_target = arguments.targets != Targets::NONE;
        let mut offers = Vec::new();
        if has_target && written == 0 {
            offers.extend(self.target_offers(arguments.targets));
        } else if arguments.values != Values::None {
            let kinds: &[VariableKind] = match arguments.values {
                Values::None | Values::One | Values::Three => &[VariableKind::Var],
                Values::Position => &[VariableKind::Var, VariableKind::Pos],
                Values::Angles | Values::PerJoint => &[VariableKind::Var, VariableKind::Joint],
            };
            offers.extend(self.variables(kinds));
        }
        let flags = motion_flags().filter(|flag| match *flag {
            tip_runtime::command::FAST => arguments.hs && written == 0,
            _ => arguments.relative && written > 0,
        });
        offers
            .extend(flags.map(|flag| Offer::new(flag, OfferKind::MotionFlag, reserved_line(flag))));
        offers
    }

    fn target_offers(&self, of: Targets) -> Vec<Offer> {
        let found = targets(of, self.robot()).into_iter();
        found
            .map(|target| {
                Offer::new(
                    target.to_string(),
                    OfferKind::Target,
                    reserved_line(target.stem()),
                )
            })
            .collect()
    }
}

/// Whether a word has letters in this order, whatever their case and whatever stands between them.
fn has_letters(word: &str, letters: &str) -> bool {
    let mut word = word.chars();
    letters
        .chars()
        .all(|letter| word.any(|one| one.eq_ignore_ascii_case(&letter)))
}

fn command_offer(row: &Command, document: &Document) -> Offer {
    let kind = match row.meaning {
        Meaning::Keyword(_) => OfferKind::Keyword,
        _ => OfferKind::Command,
    };
    let robot = document.robot();
    let usage = row.usage(robot);
    let detail = usage.first().map_or("", String::as_str);
    Offer::new(row.name, kind, row.description)
        .detail(detail)
        .template(template(row, robot))
}

fn keyword_offer(keyword: Keyword) -> Offer {
    Offer::new(
        keyword.word(),
        OfferKind::Keyword,
        keyword.row().description,
    )
}

fn functions() -> impl Iterator<Item = Offer> {
    let rows = FUNCTIONS.iter();
    rows.map(|row| Offer::new(row.word, OfferKind::Function, row.description).detail(usage(row)))
}

fn constants() -> impl Iterator<Item = Offer> {
    RESERVED.iter().filter_map(|row| match row.kind {
        Kind::Constant(_) => Some(Offer::new(row.word, OfferKind::Constant, row.description)),
        _ => None,
    })
}

fn reserved_line(word: &str) -> Bilingual {
    let row = RESERVED.iter().find(|row| row.word == word);
    row.map_or(Bilingual::EMPTY, |row| row.description)
}

fn declaring(kind: VariableKind) -> Keyword {
    match kind {
        VariableKind::Var => Keyword::DefVar,
        VariableKind::Pos => Keyword::DefPos,
        VariableKind::Joint => Keyword::DefJoint,
    }
}
