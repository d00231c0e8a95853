//! Random valid models: chains of beams, cables and rigid bodies.

use std::fmt::Write;

use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

/// What a link of a chain is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Beam,
    Quadratic,
    Cable,
    Rigid,
}

/// A link from the end of the one before it.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    pub(crate) kind: Kind,
    pub(crate) span: Vector3<f64>,
    pub(crate) elements: u32,
    /// Joined to the one before by a hinge, if both have directions; else by a ball.
    pub(crate) hinged: bool,
}

/// A chain, held by the ground at its start or free, under weight and a force, with a spring to the ground.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    pub(crate) links: Vec<Link>,
    pub(crate) held: bool,
    pub(crate) gravity: Vector3<f64>,
    pub(crate) force: Vector3<f64>,
    pub(crate) spring: Option<f64>,
    pub(crate) velocity: Vector3<f64>,
}

/// How a chain is written down.
#[derive(Clone, Debug)]
pub(crate) struct Setting {
    pub(crate) turn: Rotation3<f64>,
    pub(crate) shift: Vector3<f64>,
    pub(crate) scales: &'static str,
    pub(crate) backwards: bool,
    pub(crate) step: f64,
    pub(crate) duration: f64,
}

impl Setting {
    pub(crate) fn plain(step: f64, duration: f64) -> Self {
        let (turn, shift) = (Rotation3::identity(), Vector3::zeros());
        Self { turn, shift, scales: "{ kind = \"none\" }", backwards: false, step, duration }
    }
}

fn vector(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0_f64..1.0).prop_map(move |x| size * Vector3::from(x))
}

fn link() -> impl Strategy<Value = Link> {
    let kind = prop::sample::select(vec![Kind::Beam, Kind::Quadratic, Kind::Cable, Kind::Rigid]);
    let span = vector(1.0).prop_filter("a length", |span| span.norm() > 0.3);
    (kind, span, 1_u32..3, any::<bool>()).prop_map(|(kind, span, elements, hinged)| Link {
        kind,
        span,
        elements,
        hinged,
    })
}

/// Chains of one to three links.
pub(crate) fn chain() -> impl Strategy<Value = Chain> {
    let links = prop::collection::vec(link(), 1..4);
    let spring = prop::option::of(1.0_f64..100.0);
    (links, any::<bool>(), vector(10.0), vector(1.0), spring, vector(1.0)).prop_map(
        |(links, held, gravity, force, spring, velocity)| Chain {
            links,
            held,
            gravity,
            force,
            spring,
            velocity,
        },
    )
}

impl Chain {
    /// The same without what is outside of it.
    pub(crate) fn free(self) -> Self {
        let none = Vector3::zeros();
        Self { held: false, gravity: none, force: none, spring: None, ..self }
    }

    /// The number of the link at whose end the probe `tip` is.
    fn last(&self) -> usize {
        self.links.len() - 1
    }

    /// As a model file.
    pub(crate) fn text(&self, setting: &Setting) -> String {
        let place = |x: &Vector3<f64>| setting.turn * x + setting.shift;
        let mut text = format!(
            "gravity = {}\nscales = {}\n\
             materials.soft = {{ density = 1000, young = 1e6, poisson = 0.3 }}\n\
             sections.round = {{ kind = \"circle\", diameter = 0.04 }}\n",
            list(&(setting.turn * self.gravity)),
            setting.scales
        );
        let (mut bodies, mut at) = (Vec::new(), Vector3::zeros());
        let mut joints = String::new();
        for (i, link) in self.links.iter().enumerate() {
            let end = at + link.span;
            bodies.push(self.body(i, &place(&at), &place(&end), setting));
            if i > 0 || self.held {
                joints += &self.joint(i, &place(&at), setting);
            }
            at = end;
        }
        if setting.backwards {
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
            let force = list(&(setting.turn * self.force));
            let _ = writeln!(text, "[[loads]]\nkind = \"force\"\non = {tip}\nforce = {force}");
        }
        let Setting { step, duration, .. } = setting;
        let _ = writeln!(
            text,
            "[[probes]]\nname = \"tip\"\non = {tip}\n[analysis]\nkind = \"dynamics\"\nduration = {duration}\n\
             step = {step}\nscheme = {{ spectral_radius = 0.9 }}\nstop = {{ rule = \"energy\", tolerance = 1e-10 }}"
        );
        text
    }

    fn body(&self, i: usize, from: &Vector3<f64>, to: &Vector3<f64>, setting: &Setting) -> String {
        let Link { kind, elements, span, .. } = &self.links[i];
        let (from_to, velocity) =
            (format!("from = {}\nto = {}", list(from), list(to)), list(&(setting.turn * self.velocity)));
        let motion =
            if self.held { String::new() } else { format!("motion = {{ velocity = {velocity} }}\n") };
        let own = match kind {
            Kind::Rigid => {
                let center = list(&(0.5 * (from + to)));
                format!("kind = \"rigid\"\ncenter = {center}\nmass = 1\ninertia = [0.1, 0.1, 0.1]\n")
            }
            Kind::Cable => format!(
                "kind = \"cable\"\n{from_to}\nelements = {elements}\nsection = \"round\"\nmaterial = \"soft\"\n"
            ),
            Kind::Beam | Kind::Quadratic => {
                let formulation = if *kind == Kind::Beam { "linked" } else { "quadratic" };
                // Across: any direction will do that turns with the world.
                let across = if span.x.abs() < 0.7 * span.norm() { Vector3::x() } else { Vector3::y() };
                let up = list(&(setting.turn * across));
                format!(
                    "kind = \"beam\"\n{from_to}\nelements = {elements}\nsection = \"round\"\nmaterial = \"soft\"\n\
                     formulation = \"{formulation}\"\nup = {up}\n"
                )
            }
        };
        format!("[[bodies]]\nname = \"b{i}\"\n{own}{motion}")
    }

    fn joint(&self, i: usize, at: &Vector3<f64>, setting: &Setting) -> String {
        let has_directions = |i: usize| self.links[i].kind != Kind::Cable;
        let hinged = self.links[i].hinged && has_directions(i) && (i == 0 || has_directions(i - 1));
        let kind = if hinged {
            let span = self.links[i].span;
            let axis = span.cross(&Vector3::new(0.3, -0.5, 0.8));
            format!("kind = \"revolute\"\naxis = {}", list(&(setting.turn * axis)))
        } else {
            "kind = \"spherical\"".to_owned()
        };
        let b = if i > 0 { format!("b = {}\n", self.at(i - 1, "end", at)) } else { String::new() };
        format!("[[joints]]\nname = \"j{i}\"\n{kind}\na = {}\n{b}", self.at(i, "start", at))
    }

    /// An end of a link, which is at a point.
    fn at(&self, i: usize, end: &str, point: &Vector3<f64>) -> String {
        match self.links[i].kind {
            Kind::Rigid => format!("{{ body = \"b{i}\", at = {} }}", list(point)),
            _ => format!("{{ body = \"b{i}\", at = \"{end}\" }}"),
        }
    }
}

fn list(x: &Vector3<f64>) -> String {
    format!("[{:?}, {:?}, {:?}]", x.x, x.y, x.z)
}
