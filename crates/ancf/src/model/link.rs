//! What joints are made of besides the ties of points and directions: measures kept and resisted, and joint coordinates.

use nalgebra::Vector3;

use super::acting::Acting;
use super::coupling::Freed;
use super::freedom::{Freedom, Source};
use super::function::Clock;
use super::joint_rows as rows;
use super::{Bushing, Distance, Joint, PointSpring};
use crate::function::Function;
use crate::mechanics::{
    Angle, Attachment, ElementAxis, Friction, Measure, Slide, Spring, Strut, Target, Tie, Wrench,
};
use crate::system::{State, Term};

/// One part of a joint.
#[derive(Clone, Debug)]
enum Link {
    Tie(Tie),
    Angle(Angle),
    Slide(Vec<Slide>),
    Spring(Spring),
    Strut(Strut),
    Friction(Friction),
}

/// What equations of several joints tie.
const POSITION: &str = "position";
const GUIDE: &str = "guide";
const AXIS: &str = "axis";

/// Parts of a joint, with the coordinates and multipliers that they use.
#[derive(Debug)]
pub(super) struct Links {
    links: Vec<Link>,
    pub(super) freedoms: Vec<Freedom>,
    /// The next free coordinate and multiplier.
    coordinate: usize,
    multiplier: usize,
    clock: Clock,
}

/// The ends of a joint.
pub(super) struct Ends<'a> {
    pub(super) a: &'a Attachment,
    pub(super) b: &'a Attachment,
    /// The axes of the elements of b and the arc length there, for what slides along it.
    pub(super) beam: Option<(Vec<ElementAxis>, f64)>,
}

impl Links {
    /// No links yet; numbers are counted on from these.
    pub(super) const fn new([coordinate, multiplier]: [usize; 2], clock: Clock) -> Self {
        Self { links: Vec::new(), freedoms: Vec::new(), coordinate, multiplier, clock }
    }

    /// The next free coordinate and multiplier.
    pub(super) const fn next(&self) -> [usize; 2] {
        [self.coordinate, self.multiplier]
    }

    /// Adds the parts of a joint; `coupled` says which freedoms are to be coordinates in any case.
    pub(super) fn add(&mut self, joint: &Joint, ends: &Ends<'_>, coupled: impl Fn(Freed) -> bool) {
        let (a, b) = (ends.a, ends.b);
        let unit = |axis: [f64; 3]| Vector3::from(axis).normalize();
        let angle = |links: &mut Self, axis, acting: Acting<'_>| {
            links.angle(a, b, axis, &acting, coupled(Freed::Angle));
        };
        let moves = |links: &mut Self, axis, acting: Acting<'_>| {
            links.displacement(rows::along(a, b, axis), &acting, coupled(Freed::Displacement));
        };
        match joint {
            Joint::Drive { displacement, time, .. } if joint.moves_place() => {
                for (row, way) in rows::meeting(a, b).into_iter().zip(displacement) {
                    self.tie("driven position", row, Target::new(*way, self.clock.function(time)));
                }
            }
            Joint::Clamp { .. } | Joint::Spherical { .. } | Joint::Drive { .. } => {}
            Joint::Revolute { axis, .. } => angle(self, unit(*axis), joint.turning()),
            Joint::Universal(j) => {
                self.keep(
                    &[(POSITION, 3), ("angle of the arms", 1)],
                    rows::universal(a, b, [j.axis_a, j.axis_b].map(unit)),
                );
            }
            Joint::Cylindrical(j) => {
                self.keep(&[(GUIDE, 2), (AXIS, 2)], rows::cylindrical(a, b, unit(j.axis)));
                angle(self, unit(j.axis), joint.turning());
                moves(self, unit(j.axis), joint.moving());
            }
            Joint::Prismatic(j) => {
                let names = [(GUIDE, 2), (AXIS, 2), ("rotation about the axis", 1)];
                self.keep(&names, rows::prismatic(a, b, unit(j.axis)));
                moves(self, unit(j.axis), joint.moving());
            }
            Joint::Planar(j) => self.keep(&[("plane", 1), ("normal", 2)], rows::planar(a, b, unit(j.normal))),
            Joint::PointOnLine(j) => {
                self.keep(&[(GUIDE, 2)], rows::on_line(a, b, unit(j.axis)));
                moves(self, unit(j.axis), Acting::default());
            }
            Joint::Distance(j) => self.distance(a, b, j),
            Joint::Slide(_) => self.slide(ends, &joint.moving()),
            Joint::Bushing(j) => self.bushing(a, b, j),
            Joint::Spring(j) => self.strut(a, b, j),
        }
    }

    fn take_coordinate(&mut self) -> usize {
        self.coordinate += 1;
        self.coordinate - 1
    }

    fn take(&mut self, count: usize) -> usize {
        self.multiplier += count;
        self.multiplier - count
    }

    fn tie(&mut self, name: &'static str, measure: Measure, target: Target) {
        let multiplier = self.take(1);
        self.links.push(Link::Tie(Tie::driven(measure, target, multiplier).named(name)));
    }

    /// Keeps measures, so many of each name.
    fn keep(&mut self, names: &[(&'static str, usize)], measures: Vec<Measure>) {
        let names = names.iter().flat_map(|&(name, count)| std::iter::repeat_n(name, count));
        names.zip(measures).for_each(|(name, measure)| self.tie(name, measure, Target::NONE));
    }

    fn angle(
        &mut self,
        a: &Attachment,
        b: &Attachment,
        axis: Vector3<f64>,
        acting: &Acting<'_>,
        coupled: bool,
    ) {
        let markers = rows::hinge(a, b, axis);
        let mut coordinate = None;
        if coupled || acting.is_some() {
            let (own, multiplier) = (self.take_coordinate(), self.take(1));
            let [p, u, v] = &markers;
            self.links.push(Link::Angle(Angle::new(own, p, [u, v], multiplier)));
            self.act(own, acting);
            coordinate = Some(own);
        }
        self.freedoms.push(Freedom { source: Source::Angle(markers), coordinate });
    }

    fn displacement(&mut self, measure: Measure, acting: &Acting<'_>, coupled: bool) {
        let mut coordinate = None;
        if coupled || acting.is_some() {
            let (own, multiplier) = (self.take_coordinate(), self.take(1));
            let tie = Tie::defining(own, measure.clone(), multiplier);
            self.links.push(Link::Tie(tie.named("definition of the displacement")));
            self.act(own, acting);
            coordinate = Some(own);
        }
        self.freedoms.push(Freedom { source: Source::Displacement(measure), coordinate });
    }

    fn slide(&mut self, ends: &Ends<'_>, acting: &Acting<'_>) {
        let Some((axes, start)) = &ends.beam else { return };
        let (own, first) = (self.take_coordinate(), self.take(3));
        let slides = Slide::along(axes.iter().cloned(), &ends.a.point, own, *start, first);
        self.links.push(Link::Slide(slides));
        self.act(own, acting);
        self.freedoms.push(Freedom { source: Source::Position(*start), coordinate: Some(own) });
    }

    /// Drive, spring and friction of a joint coordinate.
    fn act(&mut self, coordinate: usize, acting: &Acting<'_>) {
        let measure = || Measure::coordinate(coordinate);
        if let Some(drive) = &acting.drive {
            self.tie("drive", measure(), drive.target(self.clock));
        }
        if let Some([stiffness, damping, rest]) = acting.spring {
            let rest = Target::new(rest, Function::ONE);
            self.links.push(Link::Spring(Spring::set(measure(), stiffness, damping, rest)));
        }
        if let Some([force, creep]) = acting.friction {
            self.links.push(Link::Friction(Friction::new(measure(), force, creep)));
        }
    }

    fn distance(&mut self, a: &Attachment, b: &Attachment, Distance { change, time, .. }: &Distance) {
        let (measure, length) = rows::half_square(a, b);
        self.tie("length", measure, Target::of_length(length, *change, self.clock.function(time)));
        self.freedoms.push(Freedom { source: Source::Length(rows::apart(a, b)), coordinate: None });
    }

    fn bushing(&mut self, a: &Attachment, b: &Attachment, Bushing { stiffness, damping, .. }: &Bushing) {
        for (k, measure) in rows::bushing(a, b).into_iter().enumerate() {
            if stiffness[k] > 0.0 || damping[k] > 0.0 {
                self.links.push(Link::Spring(Spring::new(measure, stiffness[k], damping[k])));
            }
        }
    }

    fn strut(&mut self, a: &Attachment, b: &Attachment, spring: &PointSpring) {
        let apart = rows::apart(a, b);
        let length = spring.length.unwrap_or_else(|| apart.reference().norm());
        let strut = Strut::new(&a.point, &b.point, spring.stiffness, spring.damping, length);
        self.links.push(Link::Strut(if spring.tension_only { strut.rope() } else { strut }));
        self.freedoms.push(Freedom { source: Source::Length(apart), coordinate: None });
    }

    pub(super) fn terms(&self) -> impl Iterator<Item = Box<dyn Term>> + '_ {
        self.links.iter().flat_map(Link::terms)
    }

    /// What the parts exert on the first end.
    pub(super) fn reactions<'a>(&'a self, s: &'a State) -> impl Iterator<Item = Wrench> + 'a {
        self.links.iter().map(|link| link.reaction(s))
    }
}

impl Link {
    fn terms(&self) -> Vec<Box<dyn Term>> {
        match self.clone() {
            Self::Tie(term) => vec![Box::new(term)],
            Self::Angle(term) => vec![Box::new(term)],
            Self::Slide(terms) => terms.into_iter().map(|term| Box::new(term) as Box<dyn Term>).collect(),
            Self::Spring(term) => vec![Box::new(term)],
            Self::Strut(term) => vec![Box::new(term)],
            Self::Friction(term) => vec![Box::new(term)],
        }
    }

    fn reaction(&self, s: &State) -> Wrench {
        match self {
            Self::Tie(term) => term.reaction(s),
            Self::Angle(term) => term.reaction(s),
            Self::Slide(terms) => terms.first().map_or_else(Wrench::default, |term| term.reaction(s)),
            Self::Spring(term) => term.reaction(s),
            Self::Strut(term) => term.reaction(s),
            Self::Friction(term) => term.reaction(s),
        }
    }
}
