//! Random valid models: chains of beams, cables and rigid bodies.

use std::fmt::Write;

use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

/// Body of a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LinkKind {
    Beam,
    Quadratic,
    Cable,
    Rigid,
}

/// Link that starts at the end of the previous link.
#[derive(Clone, Debug)]
pub(super) struct Link {
    pub(super) kind: LinkKind,
    pub(super) span: Vector3<f64>,
    pub(super) elements: u32,
    /// Revolute joint to the previous link if both have directions; otherwise spherical joint.
    pub(super) hinged: bool,
}

/// Chain with a joint to the ground or free, with gravity, a tip force and a spring to the ground.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) links: Vec<Link>,
    pub(super) grounded: bool,
    pub(super) gravity: Vector3<f64>,
    pub(super) force: Vector3<f64>,
    pub(super) spring: Option<f64>,
    pub(super) velocity: Vector3<f64>,
}

/// Representation of a chain as a model file.
#[derive(Clone, Debug)]
pub(super) struct Notation {
    pub(super) turn: Rotation3<f64>,
    pub(super) shift: Vector3<f64>,
    pub(super) scales: &'static str,
    pub(super) reversed: bool,
    pub(super) step: f64,
    pub(super) duration: f64,
}

impl Notation {
    /// Unrotated, unscaled representation.
    pub(super) fn plain(step: f64, duration: f64) -> Self {
        let (turn, shift) = (Rotation3::identity(), Vector3::zeros());
        Self { turn, shift, scales: "{ kind = \"none\" }", reversed: false, step, duration }
    }
}

fn vector(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0_f64..1.0).prop_map(move |x| size * Vector3::from(x))
}

fn link() -> impl Strategy<Value = Link> {
    let kind =
        prop::sample::select(vec![LinkKind::Beam, LinkKind::Quadratic, LinkKind::Cable, LinkKind::Rigid]);
    let span = vector(1.0).prop_filter("length", |span| span.norm() > 0.3);
    (kind, span, 1_u32..3, any::<bool>()).prop_map(|(kind, span, elements, hinged)| Link {
        kind,
        span,
        elements,
        hinged,
    })
}

/// Random chains of one to three links.
pub(super) fn chain() -> impl Strategy<Value = Chain> {
    let links = prop::collection::vec(link(), 1..4);
    let spring = prop::option::of(1.0_f64..100.0);
    (links, any::<bool>(), vector(10.0), vector(1.0), spring, vector(1.0)).prop_map(
        |(links, grounded, gravity, force, spring, velocity)| Chain {
            links,
            grounded,
            gravity,
            force,
            spring,
            velocity,
        },
    )
}

impl Chain {
    /// Chain without joints to the ground and external forces.
    pub(super) fn free(self) -> Self {
        let none = Vector3::zeros();
        Self { grounded: false, gravity: none, force: none, spring: None, ..self }
    }

    /// Index of the last link, which carries the probe `tip`.
    fn last(&self) -> usize {
        self.links.len() - 1
    }

    /// Text of the model file.
    pub(super) fn text(&self, notation: &Notation) -> String {
        let place = |x: &Vector3<f64>| notation.turn * x + notation.shift;
        let mut text = format!(
            "gravity = {}\nscales = {}\n\
             materials.soft = {{ density = 1000, young = 1e6, poisson = 0.3 }}\n\
             sections.round = {{ kind = \"circle\", diameter = 0.04 }}\n",
            list(&(notation.turn * self.gravity)),
            notation.scales
        );
        let (mut bodies, mut at) = (Vec::new(), Vector3::zeros());
        let mut joints = String::new();
        for (i, link) in self.links.iter().enumerate() {
            let end = at + link.span;
            bodies.push(self.body(i, &place(&at), &place(&end), notation));
            if i > 0 || self.grounded {
                joints += &self.joint(i, &place(&at), notation);
            }
            at = end;
        }
        if notation.reversed {
            bodies.reverse();
        }
        text += &bodies.concat();
        text += &joints;
        let tip = self.at(self.last(), "end", &place(&at));
        if let Some(stiffness) = self.spring {
            let anchor = list(&place(&(at + Vector3::new(0.5, 0.3, 0.2))));
            let _ = writeln!(
                text,
                "[[joints]]\nkind = \"spring\"\nname = \"spring\"\na = {tip}\nb = {{ point = {anchor} }}\nstiffness = {stiffness}"
            );
        }
        if self.force != Vector3::zeros() {
            let force = list(&(notation.turn * self.force));
            let _ = writeln!(text, "[[loads]]\nkind = \"force\"\non = {tip}\nforce = {force}");
        }
        let Notation { step, duration, .. } = notation;
        let _ = writeln!(
            text,
            "[[probes]]\nname = \"tip\"\non = {tip}\n[analysis]\nkind = \"dynamics\"\nduration = {duration}\n\
             step = {step}\nscheme = {{ spectral_radius = 0.9 }}\nstop = {{ rule = \"energy\", tolerance = 1e-10 }}"
        );
        text
    }

    fn body(&self, i: usize, from: &Vector3<f64>, to: &Vector3<f64>, notation: &Notation) -> String {
        let Link { kind, elements, span, .. } = &self.links[i];
        let (from_to, velocity) =
            (format!("from = {}\nto = {}", list(from), list(to)), list(&(notation.turn * self.velocity)));
        let motion =
            if self.grounded { String::new() } else { format!("motion = {{ velocity = {velocity} }}\n") };
        let own = match kind {
            LinkKind::Rigid => {
                let center = list(&(0.5 * (from + to)));
                format!("kind = \"rigid\"\ncenter = {center}\nmass = 1\ninertia = [0.1, 0.1, 0.1]\n")
            }
            LinkKind::Cable => format!(
                "kind = \"cable\"\n{from_to}\nelements = {elements}\nsection = \"round\"\nmaterial = \"soft\"\n"
            ),
            LinkKind::Beam | LinkKind::Quadratic => {
                let formulation = if *kind == LinkKind::Beam { "linked" } else { "quadratic" };
                // Any normal direction that rotates with the frame.
                let across = if span.x.abs() < 0.7 * span.norm() { Vector3::x() } else { Vector3::y() };
                let up = list(&(notation.turn * across));
                format!(
                    "kind = \"beam\"\n{from_to}\nelements = {elements}\nsection = \"round\"\nmaterial = \"soft\"\n\
                     formulation = \"{formulation}\"\nup = {up}\n"
                )
            }
        };
        format!("[[bodies]]\nname = \"b{i}\"\n{own}{motion}")
    }

    fn joint(&self, i: usize, at: &Vector3<f64>, notation: &Notation) -> String {
        let has_directions = |i: usize| self.links[i].kind != LinkKind::Cable;
        let hinged = self.links[i].hinged && has_directions(i) && (i == 0 || has_directions(i - 1));
        let kind = if hinged {
            let span = self.links[i].span;
            let axis = span.cross(&Vector3::new(0.3, -0.5, 0.8));
            format!("kind = \"revolute\"\naxis = {}", list(&(notation.turn * axis)))
        } else {
            "kind = \"spherical\"".to_owned()
        };
        let b = if i > 0 { format!("b = {}\n", self.at(i - 1, "end", at)) } else { String::new() };
        format!("[[joints]]\nname = \"j{i}\"\n{kind}\na = {}\n{b}", self.at(i, "start", at))
    }

    /// Place at an end of a link; `point` are its coordinates.
    fn at(&self, i: usize, end: &str, point: &Vector3<f64>) -> String {
        match self.links[i].kind {
            LinkKind::Rigid => format!("{{ body = \"b{i}\", at = {} }}", list(point)),
            _ => format!("{{ body = \"b{i}\", at = \"{end}\" }}"),
        }
    }
}

fn list(x: &Vector3<f64>) -> String {
    format!("[{:?}, {:?}, {:?}]", x.x, x.y, x.z)
}
