use std::fmt::Debug;

use ancf_solver::equations::{Energy, Inadmissibility, LOCAL, Local, LocalMatrix, LocalStep, Term, Weights};

use super::limits::SMALLEST_DISTANCE;
use super::point_contact::{FootErrors, PointContact};
use crate::laws::ContactLaw;

/// Points and elements in contact.
pub trait ContactPartners<const N: usize>: Clone + Debug + Send + Sync + 'static {
    /// Geometry in a state.
    type Pose<'a>: ContactPose<N>
    where
        Self: 'a;

    /// Evaluates the geometry for coordinates q, given the sum of the radii and the law.
    fn pose<'a>(&'a self, q: &'a [f64], contact: (f64, &'a ContactLaw)) -> Self::Pose<'a>;
}

/// Points and elements in contact in a state. A point is identified by the number of its element and its index.
pub trait ContactPose<const N: usize> {
    /// Calls `visit` with each point that may be nearer to the other element than the sum of the radii.
    fn visit_near(&self, visit: &mut dyn FnMut([usize; 2]));

    /// Calls `visit` with the contact of a point with its foot, if the element has a share in it.
    fn with_foot(&self, point: [usize; 2], visit: &mut dyn FnMut(&PointContact<'_, N>));

    /// Returns bounds of the errors of a foot.
    fn errors(&self, point: [usize; 2], at: [f64; N]) -> FootErrors<N>;
}

/// Contact between points of a body and an element of another or the same body, at the closest points of the element.
///
/// With the closest point r(x) of the element and d = p − r(x), the gap is |d| minus both radii. The forces N d/|d| +
/// friction act on p and, reversed, on r(x). Since |d| is minimal at x, ∂|d|/∂x = 0. The forces are thus exact
/// derivatives at constant x. Only the tangent contains dx. The relative velocity is that of p and the material point r,
/// w = ṗ − Ṅₐeₐ. Friction treats beams as lines and shells as surfaces. It conserves momentum, and angular momentum except for
/// the couple of the friction forces over |d|.
///
/// A point belongs to the element that contains its projection. At a node or an edge it belongs to the adjacent elements in equal
/// parts, so elements that join smoothly have a single contact. Beyond a free end or edge it belongs to the end, which is round.
#[derive(Clone, Debug)]
pub struct ClosestContact<P, const N: usize> {
    pub(in crate::contact) partners: P,
    pub(in crate::contact) coordinates: Vec<usize>,
    /// Sum of both radii.
    pub(in crate::contact) radius: f64,
    pub(in crate::contact) law: ContactLaw,
}

/// Returns coordinates in ascending order without repetition.
pub(in crate::contact) fn sorted(coordinates: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut coordinates: Vec<usize> = coordinates.collect();
    coordinates.sort_unstable();
    coordinates.dedup();
    coordinates
}

impl<P: ContactPartners<N>, const N: usize> ClosestContact<P, N> {
    /// Evaluates the geometry for the coordinates of the term.
    pub(in crate::contact) fn pose<'a>(&'a self, q: &'a [f64]) -> P::Pose<'a> {
        self.partners.pose(q, (self.radius, &self.law))
    }

    /// Calls `visit` with each point that touches an element.
    fn visit(pose: &P::Pose<'_>, mut visit: impl FnMut(&PointContact<'_, N>, [usize; 2])) {
        pose.visit_near(&mut |point| {
            pose.with_foot(point, &mut |contact| {
                if contact.gap() < 0.0 {
                    visit(contact, point);
                }
            });
        });
    }

    /// Returns the share of the element in the contact of a point.
    fn share(pose: &P::Pose<'_>, point: [usize; 2]) -> f64 {
        let mut share = 0.0;
        pose.with_foot(point, &mut |contact| share = contact.foot.share);
        share
    }

    /// Returns a quantity of a point, or 0 without contact.
    fn value(pose: &P::Pose<'_>, point: [usize; 2], of: impl Fn(&PointContact<'_, N>) -> f64) -> f64 {
        let mut value = 0.0;
        pose.with_foot(point, &mut |contact| {
            if contact.gap() < 0.0 {
                value = of(contact);
            }
        });
        value
    }
}

impl<P: ContactPartners<N>, const N: usize> Term for ClosestContact<P, N> {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        Self::visit(&self.pose(at.q), |contact, _| contact.add_residual(at.v, r));
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let pose = self.pose(at.q);
        Self::visit(&pose, |contact, point| {
            contact.add_rounding(at.v, pose.errors(point, contact.foot.at), floor);
        });
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        Self::visit(&self.pose(at.q), |contact, _| contact.add_tangent(at.v, [w.q, w.v], k));
    }

    /// Requires a distance of more than half the sum of the radii. At smaller distances the force is close to its
    /// reversal.
    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let mut is_admissible = true;
        Self::visit(&self.pose(at.q), |contact, _| {
            is_admissible &= contact.foot.d.norm() > SMALLEST_DISTANCE * contact.radius;
        });
        (!is_admissible).then_some(Inadmissibility::PressedThrough)
    }

    /// The normal force does the work of the potential between both ends. Damping and friction are those of the middle.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        self.residual(&step.middle, r);
        let mut moved = [0.0; LOCAL];
        (0..step.to.q.len()).for_each(|i| moved[i] = step.to.q[i] - step.from.q[i]);
        let [from, middle, to] = [step.from, step.middle, step.to].map(|at| self.pose(at.q));
        let mut correct = |point: [usize; 2]| {
            // The share of a point that moves to another element changes. Its force is that of the middle.
            let shares = [&from, &middle, &to].map(|pose| Self::share(pose, point));
            if shares[0] != shares[1] || shares[1] != shares[2] {
                return;
            }
            let energies = [&from, &to].map(|pose| Self::value(pose, point, |contact| contact.unit_energy()));
            if energies == [0.0; 2] {
                return;
            }
            let pressures =
                [&from, &middle, &to].map(|pose| Self::value(pose, point, |contact| contact.pressure()));
            middle.with_foot(point, &mut |contact| {
                let size = middle.errors(point, contact.foot.at).0 + contact.radius;
                let change = contact.closing(&moved);
                contact.add_normal(ContactLaw::discrete_excess(energies, change, pressures, size), r);
            });
        };
        // Points that touch at the end only follow those that touch at the start.
        Self::visit(&from, |_, point| correct(point));
        Self::visit(&to, |_, point| {
            if Self::value(&from, point, |_| 1.0) == 0.0 {
                correct(point);
            }
        });
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let mut strain = 0.0;
        Self::visit(&self.pose(at.q), |contact, _| strain += contact.energy());
        Energy { strain, ..Energy::default() }
    }

    fn is_damped(&self) -> bool {
        self.law.is_damped()
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        Self::visit(&self.pose(at.q), |contact, _| contact.add_damping(at.v, r));
    }
}
