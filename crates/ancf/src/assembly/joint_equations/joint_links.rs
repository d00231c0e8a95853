//! What joints are made of besides the ties of points and directions: measures kept and resisted, and joint coordinates.

use ancf_mechanics::constraints::{Angle, Measure, Slide, Target, Tie, Wrench};
use ancf_mechanics::forces::{Friction, Spring, Strut};
use ancf_mechanics::functions::Function;
use ancf_mechanics::kinematics::{Attachment, ElementAxis};
use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use super::freedom::{Freedom, Source};
use crate::model::{Acting, Bushing, Clock, Distance, Freed, Joint, PointSpring};

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
pub(crate) struct Links {
    links: Vec<Link>,
    pub(crate) freedoms: Vec<Freedom>,
    /// The next free coordinate and multiplier.
    coordinate: usize,
    multiplier: usize,
    clock: Clock,
}

/// The ends of a joint.
pub(crate) struct Ends<'a> {
    pub(crate) a: &'a Attachment,
    pub(crate) b: &'a Attachment,
    /// The axes of the elements of b and the arc length there, for what slides along it.
    pub(crate) beam: Option<(Vec<ElementAxis>, f64)>,
}

impl Links {
    /// No links yet; numbers are counted on from these.
    pub(crate) const fn new([coordinate, multiplier]: [usize; 2], clock: Clock) -> Self {
        Self { links: Vec::new(), freedoms: Vec::new(), coordinate, multiplier, clock }
    }

    /// The next free coordinate and multiplier.
    pub(crate) const fn next(&self) -> [usize; 2] {
        [self.coordinate, self.multiplier]
    }

    /// Adds the parts of a joint; `coupled` says which freedoms are to be coordinates in any case.
    pub(crate) fn add(&mut self, joint: &Joint, ends: &Ends<'_>, coupled: impl Fn(Freed) -> bool) {
        let (a, b) = (ends.a, ends.b);
        let unit = |axis: [f64; 3]| Vector3::from(axis).normalize();
        let angle = |links: &mut Self, axis, acting: Acting<'_>| {
            links.angle(a, b, axis, &acting, coupled(Freed::Angle));
        };
        let moves = |links: &mut Self, axis, acting: Acting<'_>| {
            links.displacement(super::measures::along(a, b, axis), &acting, coupled(Freed::Displacement));
        };
        match joint {
            Joint::Drive { displacement, time, .. } if joint.moves_place() => {
                for (row, way) in super::measures::meeting(a, b).into_iter().zip(displacement) {
                    self.tie("driven position", row, Target::new(*way, self.clock.function(time)));
                }
            }
            Joint::Clamp { .. } | Joint::Spherical { .. } | Joint::Drive { .. } => {}
            Joint::Revolute { axis, .. } => angle(self, unit(*axis), joint.turning()),
            Joint::Universal(j) => {
                self.keep(
                    &[(POSITION, 3), ("angle of the arms", 1)],
                    super::measures::universal(a, b, [j.axis_a, j.axis_b].map(unit)),
                );
            }
            Joint::Cylindrical(j) => {
                self.keep(&[(GUIDE, 2), (AXIS, 2)], super::measures::cylindrical(a, b, unit(j.axis)));
                angle(self, unit(j.axis), joint.turning());
                moves(self, unit(j.axis), joint.moving());
            }
            Joint::Prismatic(j) => {
                let names = [(GUIDE, 2), (AXIS, 2), ("rotation about the axis", 1)];
                self.keep(&names, super::measures::prismatic(a, b, unit(j.axis)));
                moves(self, unit(j.axis), joint.moving());
            }
            Joint::Planar(j) => {
                self.keep(&[("plane", 1), ("normal", 2)], super::measures::planar(a, b, unit(j.normal)))
            }
            Joint::PointOnLine(j) => {
                self.keep(&[(GUIDE, 2)], super::measures::on_line(a, b, unit(j.axis)));
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
        let markers = super::measures::hinge(a, b, axis);
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
        let (measure, length) = super::measures::half_square(a, b);
        self.tie("length", measure, Target::of_length(length, *change, self.clock.function(time)));
        self.freedoms
            .push(Freedom { source: Source::Length(super::measures::apart(a, b)), coordinate: None });
    }

    fn bushing(&mut self, a: &Attachment, b: &Attachment, Bushing { stiffness, damping, .. }: &Bushing) {
        for (k, measure) in super::measures::bushing(a, b).into_iter().enumerate() {
            if stiffness[k] > 0.0 || damping[k] > 0.0 {
                self.links.push(Link::Spring(Spring::new(measure, stiffness[k], damping[k])));
            }
        }
    }

    fn strut(&mut self, a: &Attachment, b: &Attachment, spring: &PointSpring) {
        let apart = super::measures::apart(a, b);
        let length = spring.length.unwrap_or_else(|| apart.reference().norm());
        let strut = Strut::new(&a.point, &b.point, spring.stiffness, spring.damping, length);
        self.links.push(Link::Strut(if spring.tension_only { strut.rope() } else { strut }));
        self.freedoms.push(Freedom { source: Source::Length(apart), coordinate: None });
    }

    pub(crate) fn terms(&self) -> impl Iterator<Item = Box<dyn Term>> + '_ {
        self.links.iter().flat_map(Link::terms)
    }

    /// What the parts exert on the first end.
    pub(crate) fn reactions<'a>(&'a self, s: &'a State) -> impl Iterator<Item = Wrench> + 'a {
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
