//! Every form of a command that has arguments, derived from the table of commands.

use tip_runtime::command::{Op, Teach};
use tip_runtime::model::Family;
use tipc::Robot;
use tipc::language::Edition;
use tipc::language::commands::{self, Arguments, Command, Joints, Limit, Meaning, Targets, Values};

/// One form of a command.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    /// The command.
    pub command: &'static Command,
    /// Its name as written here: its own, or that of older programs.
    pub name: &'static str,
    /// The first edition that has the form.
    pub since: Edition,
    /// `HS` comes first.
    pub hs: bool,
    /// The target or input.
    pub head: Option<Head>,
    /// `R` or `A` before a value.
    pub flag: Option<&'static str>,
    /// Arguments after the name.
    pub values: Vec<Slot>,
}

/// A sort of target or input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Head {
    /// `Fn`
    Foot,
    /// `Jnm`; only joint m of each leg if there is a number.
    Joint(Option<u8>),
    /// `Jn3`, on the hand alone.
    ThirdOfHand,
    /// `ALL`
    All,
    /// `FLOOR`
    Floor,
    /// `VRn`
    Knob,
    /// `PAWn`
    Paw,
    /// `ANTENNA`
    Antenna,
}

/// A sort of argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// `S`: a constant, VAR or member.
    Scalar,
    /// `V`: a constant or VAR.
    Plain,
    /// A constant.
    Constant,
    /// A POS to read.
    Pos,
    /// A JOINT to read.
    Joint,
    /// A VAR to fill.
    IntoVar,
    /// A member to fill.
    IntoMember,
    /// A POS to fill.
    IntoPos,
    /// A JOINT to fill.
    IntoJoint,
}

impl Form {
    /// Every form of a command, under each of its names.
    pub fn all(command: &'static Command) -> Vec<Form> {
        let names = [Some(command.name), command.alias];
        let plain = |name, since| Form {
            command,
            name,
            since,
            hs: false,
            head: None,
            flag: None,
            values: Vec::new(),
        };
        names
            .into_iter()
            .flatten()
            .flat_map(|name| {
                let mut forms = plain(name, command.since).completed(command.form);
                if let Some((since, form)) = command.later_form {
                    let mut more = plain(name, since).completed(form);
                    more.retain(|form| !forms.iter().any(|old| old.text() == form.text()));
                    forms.extend(more);
                }
                forms
            })
            .collect()
    }

    fn completed(self, form: commands::Form) -> Vec<Form> {
        use Slot::{Constant, IntoVar, Plain};
        match form {
            commands::Form::Robot(arguments) => self.robot(arguments),
            commands::Form::Special => [
                vec![Constant],
                vec![Constant, Plain],
                vec![Constant, Plain, Plain],
            ]
            .map(|values| self.with(None, values))
            .to_vec(),
            commands::Form::Teach(targets) => self.teach(targets),
            commands::Form::AdIn => {
                let inputs = [Head::Knob, Head::Joint(None), Head::Paw, Head::Antenna];
                let mut forms = vec![self.with(None, vec![Constant, Constant, IntoVar])];
                forms.extend(inputs.map(|input| self.with(Some(input), vec![IntoVar])));
                forms
            }
            commands::Form::KeyIn => {
                vec![self.with(None, vec![]), self.with(None, vec![IntoVar])]
            }
            commands::Form::Words(_) => Vec::new(),
        }
    }

    fn with(&self, head: Option<Head>, values: Vec<Slot>) -> Form {
        Form {
            head,
            values,
            ..self.clone()
        }
    }

    fn robot(&self, arguments: Arguments) -> Vec<Form> {
        let mut forms = Vec::new();
        for head in heads(arguments.targets) {
            for values in value_lists(arguments.values, head) {
                for flag in [None, Some("R"), Some("A")] {
                    let stands = arguments.relative && !values.is_empty();
                    for hs in [false, true] {
                        if (flag.is_none() || stands) && (!hs || arguments.hs) {
                            let form = self.with(head, values.clone());
                            forms.push(Form { hs, flag, ..form });
                        }
                    }
                }
            }
        }
        forms
    }

    fn teach(&self, targets: Targets) -> Vec<Form> {
        let angles = matches!(
            self.command.meaning,
            Meaning::Teach(Teach::Angle | Teach::Torque)
        );
        let receivers = |head| match head {
            _ if !angles => vec![Slot::IntoPos],
            Some(Head::Joint(_)) => vec![Slot::IntoVar, Slot::IntoMember],
            _ => vec![Slot::IntoJoint],
        };
        heads(targets)
            .into_iter()
            .flat_map(|head| receivers(head).into_iter().map(move |into| (head, into)))
            .map(|(head, into)| self.with(head, vec![into]))
            .collect()
    }

    /// Everything that follows the name, as the table writes it.
    pub fn text(&self) -> String {
        let hs = self.hs.then_some("HS");
        let values = self.values.iter().map(|slot| slot.text());
        let words = hs
            .into_iter()
            .chain(self.head.map(Head::text))
            .chain(self.flag)
            .chain(values);
        words.collect::<Vec<_>>().join(" ")
    }

    /// Returns the number of arguments, without flags.
    pub fn length(&self) -> usize {
        usize::from(self.head.is_some()) + self.values.len()
    }

    /// Returns true if any value is read.
    pub fn reads(&self) -> bool {
        use Slot::{Joint, Plain, Pos, Scalar};
        let reads = |slot: &Slot| matches!(slot, Scalar | Plain | Pos | Joint);
        self.values.iter().any(reads)
    }

    /// Returns true if a constant can stand among the values that are read.
    pub fn takes_constants(&self) -> bool {
        let takes = |slot: &Slot| matches!(slot, Slot::Scalar | Slot::Plain);
        self.values.iter().any(takes)
    }

    /// Its arguments in the table.
    pub fn arguments(&self) -> Option<Arguments> {
        match self.command.form {
            commands::Form::Robot(arguments) => Some(arguments),
            _ => None,
        }
    }

    /// Returns true if R, A and HS are flags here.
    pub fn is_motion(&self) -> bool {
        self.arguments().is_some_and(|arguments| arguments.motion)
    }

    /// Returns true if the command refuses some values at runtime.
    pub fn has_limit(&self) -> bool {
        let limited = |arguments: Arguments| arguments.limit != Limit::Any;
        self.arguments().is_some_and(limited)
    }

    /// Returns the words that the robot carries out.
    pub fn op(&self) -> Option<Op> {
        match self.command.meaning {
            Meaning::Robot(op) => Some(op),
            _ => None,
        }
    }
}

fn heads(targets: Targets) -> Vec<Option<Head>> {
    if targets == Targets::NONE {
        return vec![None];
    }
    let joint = match targets.joints {
        Joints::None => None,
        Joints::Every => Some(Head::Joint(None)),
        Joints::Second => Some(Head::Joint(Some(2))),
        Joints::Third => Some(Head::Joint(Some(3))),
        Joints::ThirdOfHand => Some(Head::ThirdOfHand),
    };
    let sorts = [
        targets.foot.then_some(Head::Foot),
        joint,
        targets.all.then_some(Head::All),
        targets.floor.then_some(Head::Floor),
    ];
    sorts.into_iter().flatten().map(Some).collect()
}

/// The lists of values after a head; every named robot has three joints a leg.
fn value_lists(values: Values, head: Option<Head>) -> Vec<Vec<Slot>> {
    let scalars = vec![Slot::Scalar; 3];
    let single = matches!(head, Some(Head::Joint(_)));
    match values {
        Values::None => vec![vec![]],
        Values::One => vec![vec![Slot::Plain]],
        Values::Three => vec![vec![Slot::Plain; 3]],
        Values::Position => vec![scalars, vec![Slot::Pos]],
        Values::Angles if single => vec![vec![Slot::Scalar]],
        Values::PerJoint if single => vec![vec![Slot::Plain]],
        Values::PerJoint if head == Some(Head::All) => {
            vec![vec![Slot::Plain], scalars, vec![Slot::Joint]]
        }
        Values::Angles | Values::PerJoint => vec![scalars, vec![Slot::Joint]],
        Values::PerLeg if head == Some(Head::Foot) => vec![scalars, vec![Slot::Joint]],
        Values::PerLeg => vec![vec![Slot::Plain]],
        Values::ThreeOrPos => vec![vec![Slot::Plain; 3], vec![Slot::Pos]],
        Values::Limits if single => vec![vec![Slot::Scalar; 2]],
        Values::Limits => vec![vec![Slot::Joint; 2]],
    }
}

impl Head {
    /// Returns its spelling in the table.
    pub const fn text(self) -> &'static str {
        match self {
            Head::Foot => "F",
            Head::Joint(None) => "J",
            Head::Joint(Some(2)) => "Jn2",
            Head::Joint(Some(_)) | Head::ThirdOfHand => "Jn3",
            Head::All => "ALL",
            Head::Floor => "FLOOR",
            Head::Knob => "VR",
            Head::Paw => "PAW",
            Head::Antenna => "ANTENNA",
        }
    }

    /// Returns true if a word is of this sort, on whatever robot.
    pub fn names(self, word: &str) -> bool {
        let numbered = |prefix| {
            let digits = word.strip_prefix(prefix).map(str::as_bytes);
            matches!(digits, Some([b'1'..=b'9']))
        };
        match self {
            Head::Foot => numbered("F"),
            Head::Joint(only) => joint(word).is_some_and(|[_, m]| only.is_none_or(|n| n == m)),
            Head::ThirdOfHand => joint(word).is_some_and(|[_, m]| m == 3),
            Head::All | Head::Floor | Head::Antenna => word == self.text(),
            Head::Knob | Head::Paw => numbered(self.text()),
        }
    }

    /// Returns true if a robot has what a word of this sort names.
    pub fn names_on(self, word: &str, robot: Robot) -> bool {
        let signature = robot.signature();
        let digit = word.as_bytes().last().map_or(0, |digit| digit - b'0');
        let stands = match self {
            Head::Foot => digit <= signature.legs,
            Head::Joint(_) | Head::ThirdOfHand => {
                joint(word).is_some_and(|[leg, m]| leg <= signature.legs && m <= signature.joints)
            }
            Head::All | Head::Floor | Head::Antenna => true,
            Head::Knob => digit <= 3,
            Head::Paw => digit <= 4,
        };
        self.names(word) && self.is_on(robot) && stands
    }

    /// Returns true if a robot has anything of this sort ([7.2], [7.21], [7.32]).
    pub fn is_on(self, robot: Robot) -> bool {
        let family = robot.signature().family;
        match self {
            Head::ThirdOfHand | Head::Floor => family == Family::Hand,
            Head::Paw => family == Family::Titan,
            Head::Antenna => family != Family::Generic,
            Head::Foot | Head::Joint(_) | Head::All | Head::Knob => true,
        }
    }

    /// Returns true if it has a number, which may be one that a robot lacks.
    pub const fn is_numbered(self) -> bool {
        !matches!(self, Head::All | Head::Floor | Head::Antenna)
    }
}

/// Leg and joint of `Jnm`.
fn joint(word: &str) -> Option<[u8; 2]> {
    match word.strip_prefix('J')?.as_bytes() {
        [leg @ b'1'..=b'9', m @ b'1'..=b'9'] => Some([leg - b'0', m - b'0']),
        _ => None,
    }
}

impl Slot {
    const fn text(self) -> &'static str {
        match self {
            Slot::Scalar => "S",
            Slot::Plain => "V",
            Slot::Constant => "constant",
            Slot::Pos | Slot::IntoPos => "POS",
            Slot::Joint | Slot::IntoJoint => "JOINT",
            Slot::IntoVar => "VAR",
            Slot::IntoMember => "member",
        }
    }
}
