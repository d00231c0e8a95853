use ancf_solver::equations::{LocalMatrix, LocalStep};
use nalgebra::SVector;

use super::element::{StrainField, StrainedElement};
use super::source::SurfaceLaw;
use crate::shells::shear::{SURFACE, ShearElement, Strains, rates, tangents, vectors};

impl<const V: usize, const S: usize, const C: usize> StrainedElement for ShearElement<V, S, C> {
    type Strains = Strains<S>;

    fn zero() -> Strains<S> {
        Strains::zeros()
    }

    fn add(sum: &mut Strains<S>, factor: f64, other: &Strains<S>) {
        *sum += other * factor;
    }

    fn product(stress: &Strains<S>, strains: &Strains<S>) -> f64 {
        stress.dot(strains)
    }

    fn law(&self) -> SurfaceLaw<'_> {
        let medium = &self.profile().medium;
        let axis = Some(medium.axis);
        SurfaceLaw { section: &medium.section.surface, axis, stress_axis: axis }
    }

    fn retardation(&self) -> f64 {
        self.profile().medium.retardation
    }

    /// Samples membrane strains and curvatures at the integration points. Transverse shear and thickness strains are zero.
    fn sampled(&self, field: StrainField<'_>) -> Strains<S> {
        let (profile, mut strains) = (self.profile(), Strains::<S>::zeros());
        for (k, (at, _)) in profile.shape.surface_points().iter().enumerate() {
            let ([t, s], _) = tangents(profile.shape, *at, &profile.reference);
            for (kind, own) in field([&t, &s]).iter().enumerate() {
                strains.fixed_rows_mut::<3>(SURFACE * k + 3 * kind).copy_from(own);
            }
        }
        strains
    }

    fn stress_of(&self, strains: &Strains<S>) -> Strains<S> {
        self.stress(strains)
    }

    fn strains_of(&self, q: &[f64]) -> Strains<S> {
        self.strains(&vectors(q))
    }

    fn rates_of(&self, q: &[f64], v: &[f64]) -> Strains<S> {
        rates(&self.state(q), v)
    }

    fn add_forces_of(&self, q: &[f64], stress: &Strains<S>, r: &mut [f64]) {
        let forces: SVector<f64, C> = self.state(q).forces(stress);
        r.iter_mut().zip(&forces).for_each(|(row, force)| *row += force);
    }

    fn add_rounding_of(&self, q: &[f64], stress: &Strains<S>, floor: &mut [f64]) {
        let mut bound = [0.0; V];
        let sizes = vectors::<V>(q).map(|q| q.norm());
        self.profile().add_stress_rounding(self.tables(), &sizes, stress, &mut bound);
        floor.iter_mut().enumerate().for_each(|(i, floor)| *floor += bound[i / 3]);
    }

    fn add_stiffness_of(&self, q: &[f64], stress: &Strains<S>, k: &mut LocalMatrix<'_>) {
        self.add_stiffness(&self.state(q), 0.0, stress, k);
    }

    /// Strains are quadratic in the coordinates: the forces of the middle do the work.
    fn exact_work(&self, stress: Strains<S>, _step: &LocalStep<'_>) -> Strains<S> {
        stress
    }
}
