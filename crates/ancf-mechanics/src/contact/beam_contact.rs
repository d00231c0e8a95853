use ancf_solver::equations::{
    Energy, Inadmissibility, LOCAL, Local, LocalMatrix, LocalStep, State, Term, Weights,
};
use nalgebra::Vector3;

use super::axis_curve::{AxisCurve, AxisHull};
use super::crossing::SMALLEST_DISTANCE;
use super::point_contact::{Foot, PointContact, vector};
use crate::kinematics::{ElementAxis, Marker};
use crate::laws::ContactLaw;

/// Contact between points of a beam axis and the axis of an element of another beam or the same beam.
///
/// With the closest point r(s) of the element and d = p − r(s), the gap is |d| minus both radii. The forces N d/|d| +
/// friction act on p and, reversed, on r(s). Since |d| is minimal at s, ∂|d|/∂s = 0. The forces are thus exact
/// derivatives at constant s. Only the tangent contains ds = (r′·δd + d·δr′)/(r′·r′ − d·r″). The relative velocity is
/// that of the axes, w = ṗ − Ṡᵢrᵢ. Friction treats beams as lines. It conserves momentum, and angular momentum except
/// for the couple of the friction forces over the distance of the axes.
///
/// A point belongs to the element that contains its projection. At a node it belongs to both elements by halves, so a
/// chain of elements with a smooth axis has a single contact. Beyond a free end it belongs to the end, which is round.
#[derive(Clone, Debug)]
pub struct BeamContact {
    /// One or two axes.
    axes: Vec<ElementAxis>,
    /// Points in contact with each axis.
    sides: Vec<ContactSide>,
    coordinates: Vec<usize>,
    /// Sum of both radii.
    radius: f64,
    law: ContactLaw,
}

/// Points of a beam that are in contact with an element.
#[derive(Clone, Debug)]
struct ContactSide {
    points: ContactPoints,
    /// Length of beam that each point represents.
    length: f64,
    /// Free ends of the element.
    ends: [bool; 2],
}

#[derive(Clone, Debug)]
enum ContactPoints {
    Single(Marker),
    /// Equidistant points of the other axis, except the given ones.
    Along {
        count: usize,
        except: Vec<usize>,
    },
}

/// Element of a beam with the contact points on it.
#[derive(Clone, Debug)]
pub(super) struct ContactElement<'a> {
    pub(super) axis: &'a ElementAxis,
    /// Free ends of the beam.
    pub(super) ends: [bool; 2],
    /// Number of points, and the length of beam that each represents.
    pub(super) count: usize,
    pub(super) length: f64,
    /// Points that have no contact with the other element.
    pub(super) except: Vec<usize>,
}

impl BeamContact {
    /// Creates the contact of a point that represents a length of its beam.
    ///
    /// `radius` is the sum of both radii. `ends` marks the ends of the element that are free ends of its beam.
    pub fn new(
        point: &Marker,
        axis: &ElementAxis,
        ends: [bool; 2],
        radius: f64,
        length: f64,
        law: ContactLaw,
    ) -> Self {
        let coordinates = sorted(point.coordinates().chain(axis.coordinates()));
        let points = ContactPoints::Single(point.within(&coordinates));
        let axes = vec![axis.within(&coordinates)];
        Self { axes, sides: vec![ContactSide { points, length, ends }], coordinates, radius, law }
    }

    /// Creates the contact of the points of two elements with the respective other element.
    pub(super) fn of_elements(elements: [ContactElement<'_>; 2], radius: f64, law: ContactLaw) -> Self {
        let coordinates = sorted(elements.iter().flat_map(|element| element.axis.coordinates()));
        let axes = elements.iter().map(|element| element.axis.within(&coordinates)).collect();
        let ends = elements.each_ref().map(|element| element.ends);
        let [a, b] = elements.map(|ContactElement { count, except, length, .. }| {
            (ContactPoints::Along { count, except }, length)
        });
        let sides = [b, a].into_iter().zip(ends);
        let sides = sides.map(|((points, length), ends)| ContactSide { points, length, ends }).collect();
        Self { axes, sides, coordinates, radius, law }
    }

    /// Returns true if a point and an axis of a state overlap by more than a fraction of their radii.
    pub(super) fn overlaps(&self, s: &State, part: f64) -> bool {
        let mut q = [0.0; LOCAL];
        self.coordinates.iter().zip(&mut q).for_each(|(&c, q)| *q = s.q[c]);
        let at = ContactState::new(self, &q);
        let distance = |side: usize, i: usize| {
            let (point, curve) = (at.point(side, i), &at.curves[side]);
            (point - curve.point(curve.closest(&point))).norm()
        };
        (0..self.sides.len())
            .any(|side| (0..at.count(side)).any(|i| distance(side, i) < (1.0 - part) * self.radius))
    }
}

fn sorted(coordinates: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut coordinates: Vec<usize> = coordinates.collect();
    coordinates.sort_unstable();
    coordinates.dedup();
    coordinates
}

/// Geometry of a contact in a state.
struct ContactState<'a> {
    contact: &'a BeamContact,
    q: &'a [f64],
    /// Origin of the curves. Differences of positions have smaller rounding errors.
    origin: Vector3<f64>,
    curves: [AxisCurve; 2],
    hulls: [AxisHull; 2],
}

impl<'a> ContactState<'a> {
    fn new(contact: &'a BeamContact, q: &'a [f64]) -> Self {
        let (first, last) = (&contact.axes[0], &contact.axes[contact.axes.len() - 1]);
        let origin = first.start_point(q);
        let curves = [first, last].map(|axis| AxisCurve::new(axis, q, &origin));
        Self { contact, q, origin, curves, hulls: curves.each_ref().map(AxisHull::new) }
    }

    fn count(&self, side: usize) -> usize {
        match &self.contact.sides[side].points {
            ContactPoints::Single(_) => 1,
            ContactPoints::Along { count, .. } => *count,
        }
    }

    fn point(&self, side: usize, i: usize) -> Vector3<f64> {
        match &self.contact.sides[side].points {
            ContactPoints::Single(point) => point.reference() - self.origin + point.sum(self.q),
            ContactPoints::Along { count, .. } => self.curves[1 - side].point(place(i, *count)),
        }
    }

    /// Returns a bound of the rounding error of a point.
    fn size(&self, side: usize, i: usize) -> f64 {
        match &self.contact.sides[side].points {
            ContactPoints::Single(point) => point.size(self.q),
            ContactPoints::Along { count, .. } => {
                self.contact.axes[1 - side].sizes(self.q, place(i, *count))[0]
            }
        }
    }

    /// Calls `visit` with the contact of a point with its foot, if the element has a share in it.
    fn with_foot(&self, side: usize, i: usize, visit: impl FnOnce(&PointContact<'_>)) {
        let BeamContact { axes, sides, radius, law, .. } = self.contact;
        let (axis, ContactSide { points, length, ends }) = (&axes[side], &sides[side]);
        let point = self.point(side, i);
        let Some(foot) = Foot::new(&point, &self.curves[side], axis.length(), *ends) else { return };
        let with = |point: &[(usize, f64)]| {
            visit(&PointContact { law, radius: *radius, length: *length, foot, point, axis });
        };
        match points {
            ContactPoints::Single(point) => with(point.parts()),
            ContactPoints::Along { count, .. } => {
                let own = &axes[1 - side];
                let [weights, ..] = own.weights_at(place(i, *count));
                let vectors = own.vectors();
                let parts =
                    std::array::from_fn::<_, 4, _>(|k| (vectors.get(k).copied().unwrap_or(0), weights[k]));
                with(&parts[..vectors.len()]);
            }
        }
    }

    /// Calls `visit` with each point that touches an element, with its side and index.
    fn visit(&self, mut visit: impl FnMut(&PointContact<'_>, [usize; 2])) {
        let radius = self.contact.radius;
        let mut touch = |side: usize, i: usize| {
            self.with_foot(side, i, |contact| {
                if contact.gap() < 0.0 {
                    visit(contact, [side, i]);
                }
            });
        };
        for (side, ContactSide { points, .. }) in self.contact.sides.iter().enumerate() {
            match points {
                ContactPoints::Single(_) => {
                    if self.hulls[side].distance(&self.point(side, 0)) <= radius {
                        touch(side, 0);
                    }
                }
                ContactPoints::Along { count, except } => {
                    let own = (&self.curves[1 - side], *count);
                    self.hulls[1 - side].scan(own, &self.hulls[side], radius, |i, _, _| {
                        if !except.contains(&i) {
                            touch(side, i);
                        }
                        radius
                    });
                }
            }
        }
    }

    /// Returns the sum over the touching points.
    fn sum(&self, of: impl Fn(&PointContact<'_>) -> f64) -> f64 {
        let mut sum = 0.0;
        self.visit(|contact, _| sum += of(contact));
        sum
    }

    /// Returns a quantity of a point, or 0 without contact.
    fn value(&self, [side, i]: [usize; 2], of: impl Fn(&PointContact<'_>) -> f64) -> f64 {
        let mut value = 0.0;
        self.with_foot(side, i, |contact| {
            if contact.gap() < 0.0 {
                value = of(contact);
            }
        });
        value
    }
}

/// Returns ξ of a point.
fn place(i: usize, count: usize) -> f64 {
    (i as f64 + 0.5) / count as f64
}

impl Term for BeamContact {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        ContactState::new(self, at.q).visit(|contact, _| contact.add_residual(at.v, r));
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let state = ContactState::new(self, at.q);
        state.visit(|contact, [side, i]| contact.add_rounding([at.q, at.v], state.size(side, i), floor));
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        ContactState::new(self, at.q).visit(|contact, _| contact.add_tangent(at.v, [w.q, w.v], k));
    }

    /// Requires a distance of more than half the sum of the radii. At smaller distances the force is close to its
    /// reversal.
    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let mut is_admissible = true;
        ContactState::new(self, at.q)
            .visit(|contact, _| is_admissible &= contact.foot.d.norm() > SMALLEST_DISTANCE * self.radius);
        (!is_admissible).then_some(Inadmissibility::PressedThrough)
    }

    /// The normal force does the work of the potential between both ends. Damping and friction are those of the middle.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        self.residual(&step.middle, r);
        let mut moved = [0.0; LOCAL];
        (0..step.to.q.len()).for_each(|i| moved[i] = step.to.q[i] - step.from.q[i]);
        let [from, middle, to] = [step.from, step.middle, step.to].map(|at| ContactState::new(self, at.q));
        let mut correct = |point: [usize; 2]| {
            let energies = [&from, &to].map(|state| state.value(point, |contact| contact.energy()));
            if energies == [0.0; 2] {
                return;
            }
            let forces = [&from, &middle, &to].map(|state| state.value(point, |contact| contact.pressure()));
            middle.with_foot(point[0], point[1], |contact| {
                let n = contact.foot.d.normalize();
                let weights = contact.weights();
                let apart = weights.map(|(first, [w, _])| w * n.dot(&vector(&moved, first))).sum();
                let excess = ContactLaw::discrete_force(energies, apart, forces) - forces[1];
                contact.add_force(&(n * excess), r);
            });
        };
        // Points that touch at the end only follow those that touch at the start.
        from.visit(|_, point| correct(point));
        to.visit(|_, point| {
            if from.value(point, |_| 1.0) == 0.0 {
                correct(point);
            }
        });
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        Energy { strain: ContactState::new(self, at.q).sum(|contact| contact.energy()), ..Energy::default() }
    }

    fn is_damped(&self) -> bool {
        self.law.is_damped()
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        ContactState::new(self, at.q).visit(|contact, _| contact.add_damping(at.v, r));
    }
}
