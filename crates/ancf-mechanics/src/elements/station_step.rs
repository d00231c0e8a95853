//! Forces of sections in steps of the energy-momentum scheme.

use super::station::{BeamStation, RelativeVectors, StationLaw, mirror};
use crate::kinematics::Interpolation;
use crate::sections::{Directors, Stiffness, sum};

impl<const N: usize> BeamStation<N> {
    /// Computes elastic and viscous forces of the directors per length in the middle of a step.
    pub(crate) fn average_forces<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        [from, middle, to]: [&Directors; 3],
        shares: [f64; 2],
        v: Option<&RelativeVectors<N>>,
    ) -> Directors {
        let g = sum(g0, middle);
        let mut p = match &self.law {
            StationLaw::Quadratic(law) => {
                law.of_resultants(&law.average_resultants(g0, [from, to], shares), &g)
            }
            StationLaw::Hyperelastic(law) => law.average_forces(g0, [from, to]),
        };
        if let (Some(law), Some(v)) = (&self.viscosity, v) {
            let viscous = law.of_resultants(&law.viscous(&g, &self.directors::<S>(v)), &g);
            p.iter_mut().zip(viscous).for_each(|(p, viscous)| *p += viscous);
        }
        p
    }

    /// Computes all blocks of a symmetric tangent of [`average_forces`](Self::average_forces): stresses of the step, and
    /// derivatives of strains of the middle.
    pub(crate) fn average_stiffness<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        [from, middle, to]: [&Directors; 3],
        shares: [f64; 2],
        v: Option<&RelativeVectors<N>>,
        [wq, wv]: [f64; 2],
        h: &mut Stiffness,
    ) {
        let StationLaw::Quadratic(law) = &self.law else {
            return self.stiffness::<S>(g0, middle, v, [wq, wv], h);
        };
        self.stiffness::<S>(g0, middle, v, [0.0, wv], h);
        let g = sum(g0, middle);
        law.add_geometric(&law.average_resultants(g0, [from, to], shares), wq, h);
        law.add_squares(&g, 2.0 * shares[1] * wq, h);
        if let (Some(law), Some(v)) = (&self.viscosity, v) {
            law.add_geometric(&law.viscous(&g, &self.directors::<S>(v)), wq, h);
        }
        mirror(h, self.law.reach());
    }
}
