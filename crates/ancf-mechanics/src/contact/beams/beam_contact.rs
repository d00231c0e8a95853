use ancf_solver::equations::{LOCAL, State};
use nalgebra::Vector3;
use smallvec::SmallVec;

use super::axis_curve::{AxisCurve, AxisHull};
use crate::contact::parts::{
    ClosestContact, ContactPartners, ContactPose, Foot, FootErrors, FootWeight, PointContact, share, sorted,
};
use crate::kinematics::{ElementAxis, Marker};
use crate::laws::ContactLaw;

/// Contact between points of a beam axis and the axis of an element of another beam or the same beam.
pub type BeamContact = ClosestContact<BeamPartners, 1>;

/// Points of beams and axes of elements in contact.
#[derive(Clone, Debug)]
pub struct BeamPartners {
    /// One or two axes.
    axes: Vec<ElementAxis>,
    /// Points in contact with each axis.
    sides: Vec<ContactSide>,
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
        let partners = BeamPartners { axes, sides: vec![ContactSide { points, length, ends }] };
        Self { partners, coordinates, radius, law }
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
        Self { partners: BeamPartners { axes, sides }, coordinates, radius, law }
    }

    /// Returns true if a point and an axis of a state overlap by more than a fraction of their radii.
    pub(super) fn overlaps(&self, s: &State, part: f64) -> bool {
        let mut q = [0.0; LOCAL];
        self.coordinates.iter().zip(&mut q).for_each(|(&c, q)| *q = s.q[c]);
        self.pose(&q).is_nearer((1.0 - part) * self.radius)
    }
}

impl Foot<1> {
    /// Finds the foot of a point on an element with a length, if the element has a share in the contact.
    ///
    /// `ends` marks the free ends of the beam.
    pub(super) fn on_axis(
        point: &Vector3<f64>,
        curve: &AxisCurve,
        length: f64,
        ends: [bool; 2],
    ) -> Option<Self> {
        let xi = curve.closest(point);
        let [r, slope, curvature] = curve.at(xi);
        let d = point - r;
        let bent = slope.norm_squared() - d.dot(&curvature);
        let share = share(xi, d.dot(&slope) / bent, ends);
        let is_inside = xi > 0.0 && xi < 1.0;
        let compliance = if is_inside { length * length / bent } else { 0.0 };
        (share > 0.0).then(|| Self {
            at: [xi],
            share,
            d,
            excess: 0.0,
            slopes: [slope / length],
            compliance: [[compliance]],
        })
    }
}

/// Geometry of a contact in a state.
#[derive(Debug)]
pub struct BeamPose<'a> {
    partners: &'a BeamPartners,
    radius: f64,
    law: &'a ContactLaw,
    q: &'a [f64],
    /// Origin of the curves. Differences of positions have smaller rounding errors.
    origin: Vector3<f64>,
    curves: [AxisCurve; 2],
    hulls: [AxisHull; 2],
}

impl ContactPartners<1> for BeamPartners {
    type Pose<'a> = BeamPose<'a>;

    fn pose<'a>(&'a self, q: &'a [f64], (radius, law): (f64, &'a ContactLaw)) -> BeamPose<'a> {
        let (first, last) = (&self.axes[0], &self.axes[self.axes.len() - 1]);
        let origin = first.start_point(q);
        let curves = [first, last].map(|axis| AxisCurve::new(axis, q, &origin));
        let hulls = curves.each_ref().map(AxisHull::new);
        BeamPose { partners: self, radius, law, q, origin, curves, hulls }
    }
}

impl BeamPose<'_> {
    fn side(&self, side: usize) -> &ContactSide {
        &self.partners.sides[side]
    }

    fn count(&self, side: usize) -> usize {
        match &self.side(side).points {
            ContactPoints::Single(_) => 1,
            ContactPoints::Along { count, .. } => *count,
        }
    }

    fn point(&self, side: usize, i: usize) -> Vector3<f64> {
        match &self.side(side).points {
            ContactPoints::Single(point) => point.reference() - self.origin + point.sum(self.q),
            ContactPoints::Along { count, .. } => self.curves[1 - side].point(place(i, *count)),
        }
    }

    /// Returns true if a point is nearer to the other element than a limit, in its share or not.
    fn is_nearer(&self, limit: f64) -> bool {
        let distance = |side: usize, i: usize| {
            let (point, curve) = (self.point(side, i), &self.curves[side]);
            (point - curve.point(curve.closest(&point))).norm()
        };
        (0..self.partners.sides.len()).any(|side| (0..self.count(side)).any(|i| distance(side, i) < limit))
    }

    /// Returns the vectors of a point with their weights.
    fn point_weights(&self, side: usize, i: usize) -> SmallVec<[(usize, f64); 4]> {
        match &self.side(side).points {
            ContactPoints::Single(point) => SmallVec::from_slice(point.parts()),
            ContactPoints::Along { count, .. } => {
                let own = &self.partners.axes[1 - side];
                let [weights, ..] = own.weights_at(place(i, *count));
                own.vectors().iter().copied().zip(weights).collect()
            }
        }
    }
}

impl ContactPose<1> for BeamPose<'_> {
    fn visit_near(&self, visit: &mut dyn FnMut([usize; 2])) {
        for (side, ContactSide { points, .. }) in self.partners.sides.iter().enumerate() {
            match points {
                ContactPoints::Single(_) => {
                    if self.hulls[side].distance(&self.point(side, 0)) <= self.radius {
                        visit([side, 0]);
                    }
                }
                ContactPoints::Along { count, except } => {
                    let own = (&self.curves[1 - side], *count);
                    self.hulls[1 - side].scan(own, &self.hulls[side], self.radius, |i, _, _| {
                        if !except.contains(&i) {
                            visit([side, i]);
                        }
                        self.radius
                    });
                }
            }
        }
    }

    fn with_foot(&self, [side, i]: [usize; 2], visit: &mut dyn FnMut(&PointContact<'_, 1>)) {
        let (axis, ContactSide { length, ends, .. }) = (&self.partners.axes[side], self.side(side));
        let point = self.point(side, i);
        let Some(foot) = Foot::on_axis(&point, &self.curves[side], axis.length(), *ends) else { return };
        let [values, slopes, _] = axis.weights_at(foot.at[0]);
        let of_point = self.point_weights(side, i);
        let of_point = of_point.into_iter().map(|(first, place)| FootWeight { first, place, slopes: [0.0] });
        let vectors = axis.vectors().iter().enumerate();
        let of_axis = vectors.map(|(k, &first)| FootWeight { first, place: -values[k], slopes: [slopes[k]] });
        let weights: SmallVec<[FootWeight<1>; 8]> = of_point.chain(of_axis).collect();
        let (law, radius, range) = (self.law, self.radius, axis.length());
        visit(&PointContact { law, radius, size: *length, foot, weights: &weights, range });
    }

    fn errors(&self, [side, i]: [usize; 2], [xi]: [f64; 1]) -> FootErrors<1> {
        let [sizes, slopes] = self.partners.axes[side].sizes(self.q, xi);
        let size = match &self.side(side).points {
            ContactPoints::Single(point) => point.size(self.q),
            ContactPoints::Along { count, .. } => {
                self.partners.axes[1 - side].sizes(self.q, place(i, *count))[0]
            }
        };
        (size + sizes, [slopes])
    }
}

/// Returns ξ of a point.
fn place(i: usize, count: usize) -> f64 {
    (i as f64 + 0.5) / count as f64
}
