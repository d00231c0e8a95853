use std::sync::Arc;

use ancf_solver::equations::{State, Term};
use nalgebra::{Matrix2, Vector3};
use smallvec::SmallVec;

use super::bicubic_surface::BicubicSurface;
use super::edge_planes::EdgePlanes;
use super::target::{SurfaceTarget, hull};
use crate::contact::parts::{
    AlignedBox, ClosestContact, ContactGeometry, ContactPartners, ContactPoint, ContactPose, Foot,
    FootErrors, FootWeight, PointContact, SurfaceGeometry, share, sorted,
};
use crate::kinematics::{BicubicNet, CONVEX};
use crate::laws::ContactLaw;
use crate::shells::{ElementSurface, VECTORS};

/// Contact between points of a body and the middle surface of an element of another or the same thin shell.
///
/// The surface is smooth across elements. A point belongs to the element that contains its closest point.
pub type ThinContact = ClosestContact<ThinPartners, 2>;

/// Points of a body and the surface of an element in contact.
#[derive(Clone, Debug)]
pub struct ThinPartners {
    surface: ElementSurface,
    /// Free edges of the element: ξ = 0 and ξ = 1, η = 0 and η = 1.
    free: [[bool; 2]; 2],
    /// Half the thickness of the element less the smallest one, if it varies.
    excess: Option<Arc<BicubicNet<f64>>>,
    points: Vec<ContactPoint>,
    /// Largest radius of the points less the smallest one.
    largest: f64,
}

impl SurfaceTarget for SurfaceGeometry {
    type Surface = BicubicSurface;

    fn of(shell: &ContactGeometry) -> &[Self] {
        &shell.surfaces
    }

    fn surface(&self, s: &State) -> BicubicSurface {
        BicubicSurface::new(&self.surface, self.excess.as_ref(), &s.q, &Vector3::zeros())
    }

    fn visit_near(
        &self,
        surface: &BicubicSurface,
        reach: f64,
        points: &mut dyn Iterator<Item = (usize, Vector3<f64>, f64)>,
        _: &dyn Fn(usize, usize) -> bool,
        visit: &mut dyn FnMut(usize, f64),
    ) {
        let mut planes = None;
        for (i, point, radius) in points {
            let planes = planes.get_or_insert_with(|| EdgePlanes::new(surface, self.free, reach));
            if planes.are_passed(&point) {
                continue;
            }
            if let Some(foot) = Foot::on_surface(&point, surface, self.free) {
                let found = foot.d.norm() / (radius + foot.excess);
                if found <= 2.0 {
                    visit(i, found);
                }
            }
        }
    }

    fn contact(
        &self,
        points: &[ContactPoint],
        _: &dyn Fn(usize, usize) -> bool,
        radius: f64,
        law: ContactLaw,
    ) -> Arc<dyn Term> {
        Arc::new(ThinContact::with_element(points, self, radius, law))
    }

    fn number(&self) -> usize {
        self.number
    }
}

impl ThinContact {
    /// Creates the contact of some points with an element of another thin shell, if there is such an element.
    ///
    /// `radius` is the sum of the smallest radii of both bodies.
    pub fn new(
        points: &[ContactPoint],
        (shell, element): (&ContactGeometry, usize),
        radius: f64,
        law: ContactLaw,
    ) -> Option<Self> {
        Some(Self::with_element(points, shell.surfaces.get(element)?, radius, law))
    }

    fn with_element(
        points: &[ContactPoint],
        SurfaceGeometry { surface, free, excess, .. }: &SurfaceGeometry,
        radius: f64,
        law: ContactLaw,
    ) -> Self {
        let of_points = points.iter().flat_map(|point| point.place.coordinates());
        let coordinates = sorted(of_points.chain(surface.coordinates()));
        let largest = points.iter().map(|point| point.excess).fold(0.0, f64::max);
        let local = |point: &ContactPoint| point.at(point.place.within(&coordinates));
        let points = points.iter().map(local).collect();
        let (surface, excess) = (surface.within(&coordinates), excess.clone());
        let partners = ThinPartners { surface, free: *free, excess, points, largest };
        Self { partners, coordinates, radius, law }
    }
}

impl Foot<2> {
    /// Finds the foot of a point on an element, if the element has a share in the contact. `free` marks its free edges.
    pub(super) fn on_surface(
        point: &Vector3<f64>,
        surface: &BicubicSurface,
        free: [[bool; 2]; 2],
    ) -> Option<Self> {
        let at = surface.closest(point);
        let values = surface.at(at);
        let d = point - values[0];
        let ((gradient, bent, metric), slopes) = surface.slopes(&d, &values, at);
        let moves = [0, 1].map(|k| at[k] > 0.0 && at[k] < 1.0);
        let mut share_of_all = 1.0;
        for k in 0..2 {
            let other = 1 - k;
            // Second derivative along the line on which the other parameter is at its optimum.
            let coupled = if moves[other] { bent[(0, 1)].powi(2) / bent[(other, other)] } else { 0.0 };
            let divisor = (bent[(k, k)] - coupled).max(CONVEX * metric[(k, k)]);
            share_of_all *= share(at[k], gradient[k] / divisor, free[k]);
        }
        if share_of_all <= 0.0 {
            return None;
        }
        let compliance = match moves {
            [true, true] => bent.try_inverse().unwrap_or_else(Matrix2::zeros),
            [false, false] => Matrix2::zeros(),
            [first, _] => {
                let (mut compliance, k) = (Matrix2::zeros(), usize::from(!first));
                compliance[(k, k)] = bent[(k, k)].recip();
                compliance
            }
        };
        let compliance = [0, 1].map(|a| [0, 1].map(|b| compliance[(a, b)]));
        let excess = surface.excess_at(at);
        Some(Self { at, share: share_of_all, d, excess, slopes, compliance })
    }
}

/// Geometry of a contact in a state.
#[derive(Debug)]
pub struct ThinPose<'a> {
    partners: &'a ThinPartners,
    radius: f64,
    law: &'a ContactLaw,
    q: &'a [f64],
    /// Origin of the surface. Differences of positions have smaller rounding errors.
    origin: Vector3<f64>,
    surface: BicubicSurface,
    hull: AlignedBox,
    planes: EdgePlanes,
}

impl ContactPartners<2> for ThinPartners {
    type Pose<'a> = ThinPose<'a>;

    fn pose<'a>(&'a self, q: &'a [f64], (radius, law): (f64, &'a ContactLaw)) -> ThinPose<'a> {
        let origin = self.surface.first_node(q);
        let surface = BicubicSurface::new(&self.surface, self.excess.as_ref(), q, &origin);
        let reach = radius + self.largest;
        let (hull, planes) = (hull(&surface, 1.0, reach), EdgePlanes::new(&surface, self.free, reach));
        ThinPose { partners: self, radius, law, q, origin, surface, hull, planes }
    }
}

impl ThinPose<'_> {
    fn point(&self, i: usize) -> Vector3<f64> {
        let place = &self.partners.points[i].place;
        place.reference() - self.origin + place.sum(self.q)
    }
}

impl ContactPose<2> for ThinPose<'_> {
    fn visit_near(&self, visit: &mut dyn FnMut([usize; 2])) {
        for i in 0..self.partners.points.len() {
            let point = self.point(i);
            if self.hull.contains(&point) && !self.planes.are_passed(&point) {
                visit([0, i]);
            }
        }
    }

    fn with_foot(&self, [_, i]: [usize; 2], visit: &mut dyn FnMut(&PointContact<'_, 2>)) {
        let ContactPoint { place, extent, excess } = &self.partners.points[i];
        let Some(foot) = Foot::on_surface(&self.point(i), &self.surface, self.partners.free) else { return };
        let [values, x, y] = ElementSurface::weights(foot.at);
        let of_point =
            place.parts().iter().map(|&(first, place)| FootWeight { first, place, slopes: [0.0; 2] });
        let vectors = self.partners.surface.vectors();
        let of_surface =
            (0..VECTORS).map(|a| FootWeight { first: vectors[a], place: -values[a], slopes: [x[a], y[a]] });
        let weights: SmallVec<[FootWeight<2>; 32]> = of_point.chain(of_surface).collect();
        let (law, radius) = (self.law, self.radius + excess + foot.excess);
        visit(&PointContact { law, radius, size: *extent, foot, weights: &weights, range: 1.0 });
    }

    fn errors(&self, [_, i]: [usize; 2], at: [f64; 2]) -> FootErrors<2> {
        let [sizes, x, y] = self.partners.surface.sizes(self.q, at);
        (self.partners.points[i].place.size(self.q) + sizes, [x, y])
    }
}
