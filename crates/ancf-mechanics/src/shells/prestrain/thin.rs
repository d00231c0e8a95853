use ancf_solver::equations::{LocalMatrix, LocalStep};
use nalgebra::Vector3;

use super::element::{StrainField, StrainedElement};
use super::source::SurfaceLaw;
use crate::shells::element::{Shell48, vectors};
use crate::shells::hermite::{Shape, VECTORS};
use crate::shells::rounding::add_stress_rounding;
use crate::shells::surface_state::ShellStrains;

impl StrainedElement for Shell48 {
    type Strains = ShellStrains;

    fn zero() -> ShellStrains {
        ShellStrains::ZERO
    }

    fn add(sum: &mut ShellStrains, factor: f64, other: &ShellStrains) {
        sum.add(factor, other);
    }

    fn product(stress: &ShellStrains, strains: &ShellStrains) -> f64 {
        stress.product(strains)
    }

    fn law(&self) -> SurfaceLaw<'_> {
        let medium = &self.profile().medium;
        SurfaceLaw { section: &medium.section, axis: medium.axis, stress_axis: None }
    }

    fn retardation(&self) -> f64 {
        self.profile().medium.retardation
    }

    fn sampled(&self, field: StrainField<'_>) -> ShellStrains {
        let (profile, mut strains) = (self.profile(), ShellStrains::ZERO);
        let samples = profile.samples.iter().zip(&self.tables().samples);
        for (strain, ([t, s], sample)) in strains.membrane.iter_mut().zip(samples) {
            *strain = field([t, s])[0][sample.component];
        }
        for (curvature, point) in strains.bending.iter_mut().zip(&profile.points) {
            *curvature = field([&point.reference[0], &point.reference[1]])[1];
        }
        strains
    }

    fn stress_of(&self, strains: &ShellStrains) -> ShellStrains {
        self.profile().stress(self.tables(), strains)
    }

    fn strains_of(&self, q: &[f64]) -> ShellStrains {
        self.state(q).strains
    }

    fn rates_of(&self, q: &[f64], v: &[f64]) -> ShellStrains {
        self.state(q).rates(self.tables(), &vectors(v))
    }

    fn add_forces_of(&self, q: &[f64], stress: &ShellStrains, r: &mut [f64]) {
        let forces =
            self.state(q).forces((self.tables(), self.profile()), stress, &[Vector3::zeros(); VECTORS]);
        for (row, force) in r.iter_mut().zip(forces.iter().flatten()) {
            *row += force;
        }
    }

    fn add_rounding_of(&self, q: &[f64], stress: &ShellStrains, floor: &mut [f64]) {
        let (sizes, mut bound): (Shape, _) = (vectors(q).map(|q| q.norm()), [0.0; VECTORS]);
        add_stress_rounding(self.tables(), self.profile(), &sizes, (&self.state(q), stress), &mut bound);
        floor.iter_mut().enumerate().for_each(|(i, floor)| *floor += bound[i / 3]);
    }

    fn add_stiffness_of(&self, q: &[f64], stress: &ShellStrains, k: &mut LocalMatrix<'_>) {
        self.stiffness(&self.state(q), 0.0, stress).add_to(k);
    }

    fn exact_work(&self, mut stress: ShellStrains, step: &LocalStep<'_>) -> ShellStrains {
        let [before, after] = [&step.from, &step.to].map(|at| self.state(at.q).strains);
        self.correct_moments(&mut stress, &self.state(step.middle.q), [&before, &after], step);
        stress
    }
}
