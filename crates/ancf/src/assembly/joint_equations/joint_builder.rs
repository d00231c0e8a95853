//! Joints as equations between markers.

use ancf_mechanics::bodies::across;
use ancf_mechanics::constraints::{Coincide, Drive, Perpendicular, Wrench};
use ancf_mechanics::kinematics::{Attachment, ElementAxis, Marker};
use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use super::freedom::Freedom;
use super::gap::Gap;
use super::joint_links::{Ends, Links};
use crate::model::{Clamped, Clock, End, Freed, Ground, Joint, Place};

/// The equations of one joint.
#[derive(Debug)]
pub(crate) struct JointEquations {
    pub(crate) name: String,
    /// The next free multiplier.
    next: usize,
    /// The first coordinate of its own and the first multiplier.
    first: [usize; 2],
    coincide: Vec<Coincide>,
    perpendicular: Vec<Perpendicular>,
    drives: Vec<Drive>,
    links: Links,
}

/// What joints hold on to.
pub(crate) trait Holds {
    /// A place.
    fn attachment(&self, place: &Place) -> Attachment;

    /// The axes of the elements of a flexible body, and the arc length of a place on it.
    fn beam(&self, place: &Place) -> Option<(Vec<ElementAxis>, f64)>;
}

/// Cosine of the angle beyond which sections or lines that meet are at a corner: 5°.
const CORNER: f64 = 0.996;

impl JointEquations {
    /// The equations of a joint, by coordinates and multipliers from `first` on. `locking` says whether its end `a` is on a beam of
    /// the continuum formulation, `coupled` which of its freedoms are coupled to others.
    pub(crate) fn new(
        joint: &Joint,
        locking: bool,
        first: [usize; 2],
        clock: Clock,
        coupled: impl Fn(Freed) -> bool,
        bodies: &impl Holds,
    ) -> Self {
        let (a, b) = joint.ends();
        let here = bodies.attachment(a);
        let there = match b {
            End::Place(place) => bodies.attachment(place),
            End::Point(Ground { point }) if joint.spans() => Attachment::ground(Vector3::from(*point)),
            End::Ground | End::Point(_) => Attachment::ground(here.point.reference()),
        };
        let mut equations = Self {
            name: joint.name().to_owned(),
            next: first[1],
            first,
            coincide: Vec::new(),
            perpendicular: Vec::new(),
            drives: Vec::new(),
            links: Links::new(first, clock),
        };
        equations.tie(joint, locking, clock, [&here, &there]);
        let beam =
            if let (Joint::Slide(_), End::Place(place)) = (joint, b) { bodies.beam(place) } else { None };
        let mut links = Links::new([first[0], equations.next], clock);
        links.add(joint, &Ends { a: &here, b: &there, beam }, coupled);
        Self { links, ..equations }
    }

    /// Ties points and directions, of the joints that do.
    fn tie(&mut self, joint: &Joint, locking: bool, clock: Clock, [here, there]: [&Attachment; 2]) {
        let ties = matches!(
            joint,
            Joint::Clamp { .. } | Joint::Revolute { .. } | Joint::Spherical { .. } | Joint::Drive { .. }
        );
        if !ties {
            return;
        }
        if !joint.moves_place() {
            let place = self.take(3);
            self.coincide.push(match joint.ends().1 {
                End::Point(Ground { point: target }) => {
                    Coincide::toward(&here.point, Vector3::from(*target), place)
                }
                _ => Coincide::points(&here.point, &there.point, place),
            });
        }
        let fixed =
            |fix: &Option<Clamped>| fix.unwrap_or(if locking { Clamped::All } else { Clamped::Section });
        match joint {
            Joint::Clamp { fix, .. } => self.clamp(here, there, fixed(fix)),
            Joint::Drive { axis: None, fix, .. } => self.clamp(here, there, fixed(fix)),
            Joint::Drive { axis: Some(axis), angle, time, fix, .. } => {
                let (axis, function) = (Vector3::from(*axis).normalize(), clock.function(time));
                for &direction in fixed(fix).of(&reference(here)) {
                    let multipliers = self.take(3);
                    let a = here.direction(direction);
                    self.drives.push(Drive::new(&a, axis, *angle, function.clone(), multipliers));
                }
            }
            Joint::Revolute { axis, .. } => {
                let axis = Vector3::from(*axis).normalize();
                for normal in across(axis) {
                    self.keep_angle(&here.direction(axis), &there.direction(normal));
                }
                let hinge = self.perpendicular.drain(..).map(|angle| angle.named("hinge axis"));
                self.perpendicular = hinge.collect();
            }
            _ => {}
        }
    }

    /// So many multipliers; returns the first.
    fn take(&mut self, count: usize) -> usize {
        self.next += count;
        self.next - count
    }

    /// Number of multipliers.
    pub(crate) fn multipliers(&self) -> usize {
        self.links.next()[1] - self.first[1]
    }

    /// Number of coordinates of its own.
    pub(crate) fn coordinates(&self) -> usize {
        self.links.next()[0] - self.first[0]
    }

    /// The angles and displacements by which it moves.
    pub(crate) fn freedoms(&self) -> &[Freedom] {
        &self.links.freedoms
    }

    /// The same with its gap treated in one way or the other.
    pub(crate) fn with_gap(mut self, gap: Gap) -> Self {
        let of = |place: Coincide| match gap {
            Gap::Kept => place.kept(),
            Gap::Drawn => place.drawn(),
            Gap::Closed => place.closed(),
        };
        self.coincide =
            self.coincide.into_iter().map(|tie| if tie.is_of_points() { of(tie) } else { tie }).collect();
        self
    }

    /// What is between its places in the reference state.
    pub(crate) fn gap(&self) -> Vector3<f64> {
        let place = self.coincide.iter().find(|tie| tie.is_of_points());
        place.map_or_else(Vector3::zeros, Coincide::gap)
    }

    /// Its multipliers.
    pub(crate) fn range(&self) -> std::ops::Range<usize> {
        let [_, next] = self.links.next();
        self.first[1]..next
    }

    pub(crate) fn terms(&self) -> impl Iterator<Item = Box<dyn Term>> {
        let coincide = self.coincide.iter().cloned().map(|c| Box::new(c) as Box<dyn Term>);
        let perpendicular = self.perpendicular.iter().cloned().map(|c| Box::new(c) as Box<dyn Term>);
        let drives = self.drives.iter().cloned().map(|c| Box::new(c) as Box<dyn Term>);
        coincide.chain(perpendicular).chain(drives).chain(self.links.terms())
    }

    /// What the joint exerts on its end `a`.
    pub(crate) fn reaction(&self, s: &State) -> Wrench {
        let coincide = self.coincide.iter().map(|c| c.reaction(s));
        let perpendicular = self.perpendicular.iter().map(|c| c.reaction(s));
        let drives = self.drives.iter().map(|c| c.reaction(s));
        coincide.chain(perpendicular).chain(drives).chain(self.links.reactions(s)).fold(
            Wrench::default(),
            |sum, part| Wrench { force: sum.force + part.force, moment: sum.moment + part.moment },
        )
    }

    fn keep_angle(&mut self, a: &Marker, b: &Marker) {
        let multiplier = self.take(1);
        self.perpendicular.push(Perpendicular::new(a, b, multiplier));
    }

    /// Ties orientations.
    fn clamp(&mut self, here: &Attachment, there: &Attachment, fix: Clamped) {
        use ancf_mechanics::kinematics::Directions::{Line, None, Rigid, Section};
        match (&here.directions, &there.directions) {
            (None, _) | (_, None) => {}
            (Rigid(_), Rigid(_)) => {
                let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
                for k in 0..3 {
                    self.keep_angle(&here.direction(axes[k]), &there.direction(axes[(k + 1) % 3]));
                }
            }
            (Section(a), Section(b)) if fix == Clamped::Section && corner(a, b) => self.tie_corner(a, b),
            (Section(_), Section(_) | Rigid(_)) => {
                self.tie_directions(here, there, fix.of(&reference(here)));
            }
            (Rigid(_), Section(_)) => self.tie_directions(here, there, fix.of(&reference(there))),
            // A line has a tangent only: it stays normal to what the other end has across it.
            (Line(tangent), Line(other)) if lines_corner(tangent, other) => self.keep_angle(tangent, other),
            (Line(tangent), Line(_)) => self.tie_directions(here, there, &[tangent.reference()]),
            (Line(tangent), Section(_) | Rigid(_)) => {
                if fix == Clamped::All {
                    return self.tie_directions(here, there, &[tangent.reference()]);
                }
                let tangent = tangent.reference().normalize();
                for normal in across(tangent) {
                    self.keep_angle(&here.direction(tangent), &there.direction(normal));
                }
            }
            (Section(_) | Rigid(_), Line(tangent)) => {
                let tangent = tangent.reference().normalize();
                for normal in across(tangent) {
                    self.keep_angle(&there.direction(tangent), &here.direction(normal));
                }
            }
        }
    }

    fn tie_directions(&mut self, here: &Attachment, there: &Attachment, directions: &[Vector3<f64>]) {
        for &direction in directions {
            let multipliers = self.take(3);
            let (a, b) = (here.direction(direction), there.direction(direction));
            self.coincide.push(Coincide::directions(&a, &b, multipliers));
        }
    }

    /// Keeps the angles between the sections' directions of two beams that meet at an angle: their rotation is the same, and
    /// each section may change its size.
    ///
    /// Of the four products of r_y, r_z of one with r_y, r_z of the other the three whose rates tell rotations apart best.
    fn tie_corner(&mut self, [_, d, e]: &[Marker; 3], [_, y, z]: &[Marker; 3]) {
        let pairs = [(d, y), (d, z), (e, y), (e, z)];
        let turns = pairs.map(|(a, b)| a.reference().cross(&b.reference()));
        let volume = |left: usize| {
            let kept: Vec<_> = (0..4).filter(|&k| k != left).map(|k| turns[k]).collect();
            kept[0].dot(&kept[1].cross(&kept[2])).abs()
        };
        let left = (0..4).max_by(|&i, &j| volume(i).total_cmp(&volume(j))).unwrap_or(0);
        for (_, (a, b)) in pairs.iter().enumerate().filter(|(k, _)| *k != left) {
            self.keep_angle(a, b);
        }
    }
}

/// Directions in the reference state, of an end that has three.
fn reference(end: &Attachment) -> [Vector3<f64>; 3] {
    end.axes().map_or([Vector3::zeros(); 3], |axes| axes.each_ref().map(|axis| axis.reference()))
}

/// Whether the sections of two beams are not parallel.
fn corner(a: &[Marker; 3], b: &[Marker; 3]) -> bool {
    let [a, b] = [a, b].map(|axes| axes[1].reference().cross(&axes[2].reference()).normalize());
    a.dot(&b).abs() < CORNER
}

/// Whether two lines are not parallel.
fn lines_corner(a: &Marker, b: &Marker) -> bool {
    a.reference().normalize().dot(&b.reference().normalize()).abs() < CORNER
}

impl Clamped {
    /// The directions that are tied, of r_x, r_y and r_z.
    fn of(self, axes: &[Vector3<f64>; 3]) -> &[Vector3<f64>] {
        match self {
            Self::All => axes,
            Self::Section => &axes[1..],
        }
    }
}

impl JointEquations {
    /// What each of its equations ties, in words; those that tie the same are counted.
    pub(crate) fn ties(&self) -> Vec<String> {
        let mut terms: Vec<Box<dyn Term>> = self.terms().collect();
        terms.retain(|term| !term.multipliers().is_empty());
        terms.sort_by_key(|term| term.multipliers().start);
        // The terms of a slide share multipliers.
        terms.dedup_by_key(|term| term.multipliers().start);
        let names = terms.iter().flat_map(|term| (0..term.multipliers().len()).map(|k| term.tie(k)));
        let names: Vec<String> = names.collect();
        let number = |i: usize| {
            let same = |range: &[String]| range.iter().filter(|name| **name == names[i]).count();
            let ordinals = ["first", "second", "third", "fourth", "fifth", "sixth"];
            match (same(&names), ordinals.get(same(&names[..i]))) {
                (2.., Some(ordinal)) => format!("{}, {ordinal} equation", names[i]),
                _ => names[i].clone(),
            }
        };
        (0..names.len()).map(number).collect()
    }
}
