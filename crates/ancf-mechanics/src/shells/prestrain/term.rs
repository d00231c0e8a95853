use ancf_solver::equations::{Energy, Local, LocalMatrix, LocalStep, Term, Weights};

use super::element::StrainedElement;
use super::prescription::{Prescribed, Prescription};
use super::source::SurfacePrestrain;

/// Prescribed strains ε⁰ of a shell element whose stresses are linear in its strains: the stresses are D (ε − ε⁰) + τD (ε̇ − ε̇⁰).
#[derive(Clone)]
pub(super) struct ShellPrestrain<E: StrainedElement>(Prescription<E>);

impl<E: StrainedElement> ShellPrestrain<E> {
    /// Creates the term of an element for the sources that cover it.
    pub(super) fn new(element: E, sources: Vec<SurfacePrestrain>) -> Self {
        Self(Prescription::new(element, sources))
    }

    const fn element(&self) -> &E {
        &self.0.element
    }

    /// Returns the stresses −D ε⁰ − τD ε̇⁰.
    fn stress(&self, at: &Local<'_>) -> E::Strains {
        let Prescribed { strains, rates } = self.0.at(at);
        let mut sum = E::scaled(-1.0, &strains);
        E::add(&mut sum, -self.element().retardation(), &rates);
        self.element().stress_of(&sum)
    }
}

impl<E: StrainedElement> Term for ShellPrestrain<E> {
    fn coordinates(&self) -> &[usize] {
        self.element().coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.element().add_forces_of(at.q, &self.stress(at), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.element().add_rounding_of(at.q, &self.stress(at), floor);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        if w.q != 0.0 {
            self.element().add_stiffness_of(at.q, &E::scaled(w.q, &self.stress(at)), k);
        }
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let stress = self.element().exact_work(self.stress(&step.middle), step);
        self.element().add_forces_of(step.middle.q, &stress, r);
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let stress = self.element().exact_work(self.stress(&step.middle), step);
        self.element().add_stiffness_of(step.middle.q, &E::scaled(w.q, &stress), k);
    }

    /// First-order response of the prescribed strains to the increment of the load factor.
    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let rates = E::scaled(-1.0, &self.0.response(at, by).rates);
        self.element().add_stiffness_of(at.q, &self.element().stress_of(&rates), k);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let Prescribed { strains, .. } = self.0.at(at);
        let stress = self.element().stress_of(&strains);
        let total = self.element().strains_of(at.q);
        let strain = 0.5 * E::product(&stress, &strains) - E::product(&stress, &total);
        Energy { strain, ..Energy::default() }
    }

    /// Returns −ε̇⁰ D (ε − ε⁰) + ε̇ τD ε̇⁰ of all points.
    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let Prescribed { strains, rates } = self.0.at(at);
        let stress = self.element().stress_of(&rates);
        let total = self.element().strains_of(at.q);
        E::product(&stress, &strains) - E::product(&stress, &total)
            + self.0.viscous_power(&rates, &self.element().rates_of(at.q, at.v))
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn flow_power(&self, at: &Local<'_>) -> f64 {
        self.0.flow_power(at)
    }
}
