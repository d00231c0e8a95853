//! Stresses, energy and stiffness of shear-deformable shells whose membrane forces may have a law that is not linear in the strains.

use nalgebra::{SMatrix, Vector3};
use pulp::{Arch, Simd, WithSimd};

use super::profile::ShearProfile;
use super::strains::{Gradients, SURFACE, Strains};
use crate::shells::laminates::MembranePoints;

/// Returns the membrane strain at an integration point.
pub(super) fn membrane<const S: usize>(strains: &Strains<S>, k: usize) -> Vector3<f64> {
    strains.fixed_rows::<3>(SURFACE * k).into()
}

impl<const V: usize, const S: usize> ShearProfile<V, S> {
    /// Replaces the membrane forces at the integration points if the section has a law of them.
    ///
    /// Such an element has no enhanced strains and its section no coupling, so that membrane forces depend on the membrane strains at
    /// their point only.
    pub(super) fn with_forces(
        &self,
        mut stress: Strains<S>,
        force: impl Fn(&MembranePoints, usize) -> Vector3<f64>,
    ) -> Strains<S> {
        if let Some(law) = &self.membrane {
            for k in 0..self.shape.surface_points().len() {
                stress.fixed_rows_mut::<3>(SURFACE * k).copy_from(&force(law, k));
            }
        }
        stress
    }

    /// Computes the stresses of strains by the linear law.
    pub(super) fn linear_stress(&self, strains: &Strains<S>) -> Strains<S> {
        let mut stress = Strains::zeros();
        Arch::new().dispatch(LinearStress { stiffness: &self.stiffness, strains, stress: &mut stress });
        stress
    }

    /// Computes the stresses of strains.
    pub(super) fn stress(&self, strains: &Strains<S>) -> Strains<S> {
        self.with_forces(self.linear_stress(strains), |law, k| law.force(k, &membrane(strains, k)))
    }

    /// Computes the strain energy.
    pub(super) fn strain_energy(&self, strains: &Strains<S>) -> f64 {
        let others = self.with_forces(self.linear_stress(strains), |_, _| Vector3::zeros());
        let energy = 0.5 * strains.dot(&others);
        let of_law = |law: &MembranePoints| -> f64 {
            (0..self.shape.surface_points().len()).map(|k| law.energy(k, &membrane(strains, k))).sum()
        };
        self.membrane.as_ref().map_or(energy, |law| energy + of_law(law))
    }

    /// Computes multiples of the stiffness of the coordinates in a state and of the linear one, from the gradients of the strains.
    pub(super) fn material_stiffness<const C: usize>(
        &self,
        gradients: &Gradients<S, C>,
        strains: &Strains<S>,
        shares: [f64; 2],
    ) -> [[f64; C]; C] {
        let mut matrix = [[0.0; C]; C];
        let mut multiply = |stiffness: &SMatrix<f64, S, S>, factor| {
            Arch::new().dispatch(Product { stiffness, factor, gradients, matrix: &mut matrix });
        };
        let Some(law) = &self.membrane else {
            multiply(&self.stiffness, shares[0] + shares[1]);
            return matrix;
        };
        let mut stiffness = *self.stiffness * (shares[0] + shares[1]);
        for k in 0..self.shape.surface_points().len() {
            let own = law.stiffness(k, &membrane(strains, k), shares);
            stiffness.fixed_view_mut::<3, 3>(SURFACE * k, SURFACE * k).copy_from(&own);
        }
        multiply(&stiffness, 1.0);
        matrix
    }

    /// Computes the change of the stresses in a state for a small change of the strains.
    pub(super) fn stress_change(&self, strains: &Strains<S>, change: &Strains<S>) -> Strains<S> {
        self.with_forces(self.linear_stress(change), |law, k| {
            law.stiffness(k, &membrane(strains, k), [1.0, 0.0]) * membrane(change, k)
        })
    }

    /// Computes the stresses that follow from those of a state by its stiffness, for a linear change of its strains, minus the stresses
    /// of another state.
    pub(super) fn predicted_stress(
        &self,
        (before, change): (&Strains<S>, &Strains<S>),
        now: &Strains<S>,
    ) -> Strains<S> {
        self.with_forces(self.linear_stress(&(before + change - now)), |law, k| {
            let [then, now] = [before, now].map(|strains| law.force(k, &membrane(strains, k)));
            then + law.stiffness(k, &membrane(before, k), [1.0, 0.0]) * membrane(change, k) - now
        })
    }

    /// Computes the stresses of strains between those at both ends of a step, with membrane forces that do the work of the energy on
    /// the change of the membrane strains.
    pub(super) fn step_stress(&self, strains: &Strains<S>, ends: [&Strains<S>; 2]) -> Strains<S> {
        self.with_forces(self.linear_stress(strains), |law, k| {
            law.force(k, &membrane(strains, k)) + law.correction(k, ends.map(|end| membrane(end, k)))
        })
    }
}

/// Stresses K e of strains e with the stiffness K.
struct LinearStress<'a, const S: usize> {
    stiffness: &'a SMatrix<f64, S, S>,
    strains: &'a Strains<S>,
    stress: &'a mut Strains<S>,
}

impl<const S: usize> WithSimd for LinearStress<'_, S> {
    type Output = ();

    #[inline(always)]
    fn with_simd<P: Simd>(self, simd: P) {
        let mut sum = [0.0; S];
        for (column, strain) in self.stiffness.data.0.iter().zip(self.strains) {
            add_multiple(simd, *strain, column, &mut sum);
        }
        self.stress.data.0 = [sum];
    }
}

/// Product f Bᵀ K B of the gradients B of the strains and their stiffness K.
struct Product<'a, const S: usize, const C: usize> {
    stiffness: &'a SMatrix<f64, S, S>,
    factor: f64,
    gradients: &'a Gradients<S, C>,
    matrix: &'a mut [[f64; C]; C],
}

/// Adds a multiple of a row to another.
#[inline(always)]
fn add_multiple<P: Simd, const N: usize>(simd: P, factor: f64, from: &[f64; N], to: &mut [f64; N]) {
    let (from, from_rest) = P::as_simd_f64s(from);
    let (to, to_rest) = P::as_mut_simd_f64s(to);
    let wide = simd.splat_f64s(factor);
    for (to, from) in to.iter_mut().zip(from) {
        *to = simd.mul_add_f64s(wide, *from, *to);
    }
    for (to, from) in to_rest.iter_mut().zip(from_rest) {
        *to += factor * from;
    }
}

impl<const S: usize, const C: usize> WithSimd for Product<'_, S, C> {
    type Output = ();

    #[inline(always)]
    fn with_simd<P: Simd>(self, simd: P) {
        let mut rows = [[0.0; C]; S];
        for (k, row) in rows.iter_mut().enumerate() {
            for (l, gradient) in self.gradients.iter().enumerate() {
                // Strains of the surface, of transverse shear and of the thickness are not coupled.
                let entry = self.stiffness[(l, k)];
                if entry != 0.0 {
                    add_multiple(simd, self.factor * entry, gradient, row);
                }
            }
        }
        for (i, row) in self.matrix.iter_mut().enumerate() {
            for (gradient, product) in self.gradients.iter().zip(&rows) {
                if gradient[i] != 0.0 {
                    add_multiple(simd, gradient[i], product, row);
                }
            }
        }
    }
}
