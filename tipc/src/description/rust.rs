//! Rust tokens of a robot: a constant that holds its model.

use super::{Description, Leg};
#[cfg(feature = "build")]
use crate::emit::under;
use crate::emit::{Options, header_of, in_comment, number};
use crate::robot::Facts;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;
use tip_runtime::model::{
    Body, Forces, InertialProperties, Inverse, Joint, Part, Range, Slider, Standards, TOUCHING,
    TorqueUnit, generic,
};

impl Description {
    /// Returns the robot as a `const` of the runtime's `Model`. Its name is `options.name`, else [`const_name`] of the
    /// file. Equal descriptions and options give equal tokens.
    pub fn to_rust(&self, options: &Options) -> TokenStream {
        let Options {
            name,
            visibility,
            attributes,
            runtime,
        } = options;
        let gap = (!attributes.is_empty()).then(|| quote!(#[doc = ""]));
        let name = name
            .clone()
            .unwrap_or_else(|| const_name(&self.source_name));
        let legs = self.legs.iter().map(|leg| leg.to_rust(runtime));
        let (legs_count, joints_count) = (size(self.legs.len()), size(self.joints()));
        let (source, robot) = (self.source_name.replace('`', "'"), self.name);
        let about = format!(
            " The robot `{}`: {legs_count} × {joints_count} joints on its legs.",
            in_comment(robot)
        );
        let header = format!(" {}", header_of(&format!("`{source}`"), self.source_hash));
        let inverse = match self.inverse {
            Inverse::YawPitchPitch => quote!(YawPitchPitch),
            Inverse::RollPitchPitch => quote!(RollPitchPitch),
            Inverse::Planar => quote!(Planar),
            Inverse::LeastSquares => quote!(LeastSquares),
        };
        let body = optional(self.body.map(|body| body_to_rust(body, runtime)));
        let standards = standards_to_rust(self.standards, runtime);
        let periods = range(self.periods, runtime);
        let contact = number(self.contact);
        let lamps = Literal::u8_unsuffixed(self.lamps);
        let forces = optional(self.forces.map(|forces| forces_to_rust(forces, runtime)));
        let slider = optional(self.slider.map(|slider| slider_to_rust(slider, runtime)));
        let may_touch = may_touch_to_rust(&self.may_touch, runtime);
        quote! {
            #attributes
            #gap
            #[doc = #about]
            #[doc = ""]
            #[doc = #header]
            #[allow(clippy::all, clippy::pedantic)]
            #visibility const #name: #runtime::model::Model<#legs_count, #joints_count> = #runtime::model::Model {
                inverse: #runtime::model::Inverse::#inverse,
                body: #body,
                standards: #standards,
                periods: #periods,
                contact: #contact,
                lamps: #lamps,
                forces: #forces,
                slider: #slider,
                #may_touch
                ..#runtime::model::Model::generic(#robot, [#(#legs),*])
            };
        }
    }
}

#[cfg(feature = "build")]
impl Description {
    /// Returns the tokens of [`to_rust`](Self::to_rust) as formatted source text under a header comment.
    ///
    /// # Errors
    /// The tokens are not a Rust file; a visibility or runtime path that is none can cause it.
    pub fn pretty(&self, options: &Options) -> Result<String, syn::Error> {
        let header = header_of(&self.source_name, self.source_hash);
        under(&header, self.to_rust(options))
    }
}

/// Returns a constant of the robot's name in place of one whose description cannot be used, so that only that is
/// reported.
pub fn skeleton(source_name: &str, options: &Options) -> TokenStream {
    let point = Range::new(0.0, 0.0);
    let joint = Joint {
        axis: [0.0, 0.0, 1.0],
        link: [0.0; 3],
        limits: point,
        outer: point,
        mass: 0.0,
        inertial: None,
        torque: 0.0,
        radius: None,
    };
    let leg = Leg {
        base: [0.0; 3],
        joints: vec![joint],
        initial: vec![0.0],
        shapes: Vec::new(),
    };
    let generic = generic::MODEL;
    let stands_in = Description {
        bus: None,
        source_name: source_name.to_owned(),
        source_hash: 0,
        name: "",
        legs: vec![leg],
        inverse: Inverse::LeastSquares,
        body: None,
        standards: generic.standards,
        periods: generic.periods,
        contact: generic.contact,
        lamps: generic.lamps,
        forces: None,
        slider: None,
        may_touch: [None; TOUCHING],
        shapes: Vec::new(),
        limits: Facts::of(&generic::MODEL).limits,
    };
    stands_in.to_rust(options)
}

/// Returns the constant that a description gets: its file's name without folders and extension, in capitals
/// (`my robot.toml` is `MY_ROBOT`). Characters other than ASCII letters and digits separate words; where no
/// word is left the name is `ROBOT`.
pub fn const_name(source_name: &str) -> Ident {
    let file = source_name
        .rsplit(['/', '\\'])
        .next()
        .unwrap_or(source_name);
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let words = stem.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<String> = words
        .filter(|word| !word.is_empty())
        .map(str::to_ascii_uppercase)
        .collect();
    let name = match words.join("_") {
        name if name.is_empty() => "ROBOT".to_owned(),
        name if name.starts_with(|c: char| c.is_ascii_digit()) => format!("ROBOT_{name}"),
        name => name,
    };
    Ident::new(&name, Span::call_site())
}

impl Leg {
    fn to_rust(&self, runtime: &TokenStream) -> TokenStream {
        let base = numbers(&self.base);
        let joints = self
            .joints
            .iter()
            .map(|joint| joint_to_rust(*joint, runtime));
        let initial = numbers(&self.initial);
        quote! {
            #runtime::model::Leg {
                base: #base,
                joints: [#(#joints),*],
                initial: #initial,
            }
        }
    }
}

/// Returns the field of the parts that may touch; nothing if there are none.
fn may_touch_to_rust(pairs: &[Option<[Part; 2]>], runtime: &TokenStream) -> Option<TokenStream> {
    let part = |part: Part| match part {
        Part::Body => quote!(#runtime::model::Part::Body),
        Part::Link(leg, joint) => {
            let [leg, joint] = [leg, joint].map(Literal::u8_unsuffixed);
            quote!(#runtime::model::Part::Link(#leg, #joint))
        }
    };
    pairs.iter().any(Option::is_some).then(|| {
        let pairs = pairs.iter().map(|pair| {
            optional(pair.map(|pair| {
                let pair = pair.map(part);
                quote!([#(#pair),*])
            }))
        });
        quote!(may_touch: [#(#pairs),*],)
    })
}

fn joint_to_rust(joint: Joint, runtime: &TokenStream) -> TokenStream {
    let (axis, link) = (numbers(&joint.axis), numbers(&joint.link));
    let (limits, outer) = (range(joint.limits, runtime), range(joint.outer, runtime));
    let (mass, torque) = (number(joint.mass), number(joint.torque));
    let inertial = inertial_to_rust(joint.inertial, runtime);
    let radius = optional(joint.radius.map(|radius| {
        let radius = number(radius);
        quote!(#radius)
    }));
    quote! {
        #runtime::model::Joint {
            axis: #axis,
            link: #link,
            limits: #limits,
            outer: #outer,
            mass: #mass,
            inertial: #inertial,
            torque: #torque,
            radius: #radius,
        }
    }
}

fn body_to_rust(body: Body, runtime: &TokenStream) -> TokenStream {
    let [x, y, z] = [body.x, body.y, body.z].map(|extent| range(extent, runtime));
    let (mass, inertial) = (number(body.mass), inertial_to_rust(body.inertial, runtime));
    quote!(#runtime::model::Body { x: #x, y: #y, z: #z, mass: #mass, inertial: #inertial })
}

fn inertial_to_rust(inertial: Option<InertialProperties>, runtime: &TokenStream) -> TokenStream {
    optional(inertial.map(|InertialProperties { centre, inertia }| {
        let (centre, inertia) = (numbers(&centre), numbers(&inertia));
        quote!(#runtime::model::InertialProperties { centre: #centre, inertia: #inertia })
    }))
}

fn standards_to_rust(standards: Standards, runtime: &TokenStream) -> TokenStream {
    let Standards {
        v_max,
        a_max,
        omega_max,
        omega_dot_max,
        just_position,
        just_angle,
        near_position,
        near_angle,
        period,
    } = standards;
    let [v_max, a_max, omega_max, omega_dot_max] =
        [v_max, a_max, omega_max, omega_dot_max].map(number);
    let [just_position, just_angle] = [just_position, just_angle].map(number);
    let [near_position, near_angle] = [near_position, near_angle].map(number);
    let period = number(period);
    quote! {
        #runtime::model::Standards {
            v_max: #v_max,
            a_max: #a_max,
            omega_max: #omega_max,
            omega_dot_max: #omega_dot_max,
            just_position: #just_position,
            just_angle: #just_angle,
            near_position: #near_position,
            near_angle: #near_angle,
            period: #period,
        }
    }
}

fn forces_to_rust(forces: Forces, runtime: &TokenStream) -> TokenStream {
    let unit = match forces.unit {
        TorqueUnit::NewtonMetre => quote!(NewtonMetre),
        TorqueUnit::MillinewtonMetre => quote!(MillinewtonMetre),
    };
    let torque_max = number(forces.torque_max);
    let angle_stiffness = number(forces.angle_stiffness);
    let position_stiffness = number(forces.position_stiffness);
    let search_torque = number(forces.search_torque);
    let search_force = number(forces.search_force);
    let contact_torque = number(forces.contact_torque);
    quote! {
        #runtime::model::Forces {
            unit: #runtime::model::TorqueUnit::#unit,
            torque_max: #torque_max,
            angle_stiffness: #angle_stiffness,
            position_stiffness: #position_stiffness,
            search_torque: #search_torque,
            search_force: #search_force,
            contact_torque: #contact_torque,
        }
    }
}

fn slider_to_rust(slider: Slider, runtime: &TokenStream) -> TokenStream {
    let initial = numbers(&slider.initial);
    let [x, y, z] = slider.travel.map(|travel| range(travel, runtime));
    quote!(#runtime::model::Slider { initial: #initial, travel: [#x, #y, #z] })
}

fn range(range: Range, runtime: &TokenStream) -> TokenStream {
    let (min, max) = (number(range.min), number(range.max));
    quote!(#runtime::model::Range { min: #min, max: #max })
}

fn numbers(values: &[f64]) -> TokenStream {
    let values = values.iter().map(|value| number(*value));
    quote!([#(#values),*])
}

fn optional(value: Option<TokenStream>) -> TokenStream {
    match value {
        Some(value) => quote!(::core::option::Option::Some(#value)),
        None => quote!(::core::option::Option::None),
    }
}

fn size(count: usize) -> Literal {
    Literal::usize_unsuffixed(count)
}
