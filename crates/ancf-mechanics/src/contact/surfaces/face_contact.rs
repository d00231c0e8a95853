use std::sync::Arc;

use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;
use smallvec::SmallVec;

use super::face_surface::FaceSurface;
use super::target::{SurfaceTarget, hull};
use crate::contact::parts::{
    AlignedBox, ClosestContact, ContactGeometry, ContactPartners, ContactPoint, ContactPose, FaceGeometry,
    FaceNodes, FacePart, FootErrors, FootWeight, PartWeights, PointContact, sorted,
};
use crate::laws::ContactLaw;
use crate::shells::{NODES, Shape};

/// Contact between points of a body and the middle surface of an element of another or the same shear-deformable shell.
///
/// Elements join with kinks, at which closest points jump. The distance from each element, edge and node has a continuous
/// derivative. The potential of a point is their sum over elements, less that over inner edges, plus that over inner nodes (Li et
/// al. 2023). Where elements join smoothly it is the potential of the closest point. In a valley, both sides act.
pub type FaceContact = ClosestContact<FacePartners, 2>;

/// Points of a body and an element in contact.
#[derive(Clone, Debug)]
pub struct FacePartners {
    shape: Shape,
    nodes: FaceNodes,
    /// Half the thickness at the nodes less the smallest one, if it varies.
    excess: Option<SmallVec<[f64; NODES]>>,
    points: Vec<(ContactPoint, PartWeights)>,
    /// Largest radius of the points less the smallest one.
    largest: f64,
}

impl SurfaceTarget for FaceGeometry {
    type Surface = FaceSurface;

    fn of(shell: &ContactGeometry) -> &[Self] {
        &shell.faces
    }

    fn surface(&self, s: &State) -> FaceSurface {
        FaceSurface::new((self.shape, self.excess.as_ref()), &self.nodes, &s.q, &Vector3::zeros())
    }

    fn visit_near(
        &self,
        surface: &FaceSurface,
        _: f64,
        points: &mut dyn Iterator<Item = (usize, Vector3<f64>, f64)>,
        is_joined: &dyn Fn(usize, usize) -> bool,
        visit: &mut dyn FnMut(usize, f64),
    ) {
        for (i, point, radius) in points {
            let (part, found) = surface.closest_part(&point, radius);
            if found > 2.0 {
                continue;
            }
            // Only next to joined elements, the sum of the weights of a part can be 0.
            let acts = part == FacePart::Surface || !self.has_neighbour(|k| is_joined(i, k)) || {
                let weights = self.weights(|k| is_joined(i, k));
                !surface.acting_parts(&weights, &point, (radius, 2.0)).is_empty()
            };
            if acts {
                visit(i, found);
            }
        }
    }

    fn contact(
        &self,
        points: &[ContactPoint],
        is_joined: &dyn Fn(usize, usize) -> bool,
        radius: f64,
        law: ContactLaw,
    ) -> Arc<dyn Term> {
        let weights = |i: usize| self.weights(|element| is_joined(i, element));
        Arc::new(FaceContact::weighted(points, weights, self, radius, law))
    }

    fn number(&self) -> usize {
        self.number()
    }
}

impl FaceContact {
    /// Creates the contact of some points with an element of another shell, if there is such an element.
    ///
    /// `radius` is the sum of the smallest radii of both bodies.
    pub fn new(
        points: &[ContactPoint],
        (shell, element): (&ContactGeometry, usize),
        radius: f64,
        law: ContactLaw,
    ) -> Option<Self> {
        let face = shell.faces.get(element)?;
        Some(Self::weighted(points, |_| face.weights(|_| false), face, radius, law))
    }

    /// Creates the contact of some points with an element. `weights` returns those of a point.
    fn weighted(
        points: &[ContactPoint],
        weights: impl Fn(usize) -> PartWeights,
        face: &FaceGeometry,
        radius: f64,
        law: ContactLaw,
    ) -> Self {
        let of_points = points.iter().flat_map(|point| point.place.coordinates());
        let of_face = face.nodes.iter().flat_map(|(first, _)| *first..*first + 3);
        let coordinates = sorted(of_points.chain(of_face));
        let local =
            |(i, point): (usize, &ContactPoint)| (point.at(point.place.within(&coordinates)), weights(i));
        let largest = points.iter().map(|point| point.excess).fold(0.0, f64::max);
        let points = points.iter().enumerate().map(local).collect();
        let (nodes, excess) = (face.nodes_within(&coordinates), face.excess.clone());
        let partners = FacePartners { shape: face.shape, nodes, excess, points, largest };
        Self { partners, coordinates, radius, law }
    }
}

/// Geometry of a contact in a state. A point is identified by a part of the element and its index.
#[derive(Debug)]
pub struct FacePose<'a> {
    partners: &'a FacePartners,
    radius: f64,
    law: &'a ContactLaw,
    q: &'a [f64],
    /// Origin of the surface. Differences of positions have smaller rounding errors.
    origin: Vector3<f64>,
    surface: FaceSurface,
    hull: AlignedBox,
}

impl ContactPartners<2> for FacePartners {
    type Pose<'a> = FacePose<'a>;

    fn pose<'a>(&'a self, q: &'a [f64], (radius, law): (f64, &'a ContactLaw)) -> FacePose<'a> {
        let (first, reference) = self.nodes[0];
        let origin = reference + Vector3::new(q[first], q[first + 1], q[first + 2]);
        let surface = FaceSurface::new((self.shape, self.excess.as_ref()), &self.nodes, q, &origin);
        let hull = hull(&surface, 1.0, radius + self.largest);
        FacePose { partners: self, radius, law, q, origin, surface, hull }
    }
}

impl FacePose<'_> {
    fn point(&self, i: usize) -> Vector3<f64> {
        let place = &self.partners.points[i].0.place;
        place.reference() - self.origin + place.sum(self.q)
    }
}

impl ContactPose<2> for FacePose<'_> {
    fn visit_near(&self, visit: &mut dyn FnMut([usize; 2])) {
        for (i, (own, weights)) in self.partners.points.iter().enumerate() {
            let point = self.point(i);
            if self.hull.contains(&point) {
                let parts = self.surface.acting_parts(weights, &point, (self.radius + own.excess, 1.0));
                parts.into_iter().for_each(|part| visit([part.number(), i]));
            }
        }
    }

    fn with_foot(&self, [number, i]: [usize; 2], visit: &mut dyn FnMut(&PointContact<'_, 2>)) {
        let (ContactPoint { place, extent, excess }, part_weights) = &self.partners.points[i];
        let foot = self.surface.foot(FacePart::new(number), &self.point(i));
        let [values, x, y] = self.partners.shape.values(foot.at);
        let of_point =
            place.parts().iter().map(|&(first, place)| FootWeight { first, place, slopes: [0.0; 2] });
        let nodes = self.partners.nodes.iter().enumerate();
        let of_surface = nodes.map(|(a, (first, _))| FootWeight {
            first: *first,
            place: -values[a],
            slopes: [x[a], y[a]],
        });
        let weights: SmallVec<[FootWeight<2>; 32]> = of_point.chain(of_surface).collect();
        let radius = self.radius + excess + foot.excess;
        let (law, size) = (self.law, extent * part_weights[number]);
        visit(&PointContact { law, radius, size, foot, weights: &weights, range: 1.0 });
    }

    fn errors(&self, [_, i]: [usize; 2], at: [f64; 2]) -> FootErrors<2> {
        let sizes = self.partners.shape.values(at).map(|weights| {
            let size = |(first, reference): &(usize, Vector3<f64>)| {
                reference.norm() + Vector3::new(self.q[*first], self.q[*first + 1], self.q[*first + 2]).norm()
            };
            let nodes = self.partners.nodes.iter().zip(weights);
            nodes.map(|(node, weight)| weight.abs() * size(node)).sum::<f64>()
        });
        (self.partners.points[i].0.place.size(self.q) + sizes[0], [sizes[1], sizes[2]])
    }
}
