use std::sync::Arc;

use ancf_solver::equations::{Energy, Local, LocalMatrix, LocalStep, Term, Weights};

use super::element::StrainedElement;
use super::source::{Factors, SurfacePrestrain, each_part, factors};

/// Prescribed strains ε⁰ of a shell element: the stresses are D (ε − ε⁰) + τD (ε̇ − ε̇⁰).
///
/// ε⁰ is Green's strain ½ (UᵀU − 1) with the elongations U = 1 + Σ f_s ε_s of the sources s with the factors f_s, and the curvatures
/// and strains of tensions, which are linear in the factors.
#[derive(Clone)]
pub(super) struct ShellPrestrain<E: StrainedElement> {
    element: E,
    sources: Arc<Vec<SurfacePrestrain>>,
    parts: Vec<Part<E::Strains>>,
}

/// Part of the prescribed strains: strains times the factors of one or two sources.
#[derive(Clone)]
struct Part<S> {
    sources: [Option<usize>; 2],
    strains: S,
}

/// Prescribed strains and their rates.
struct Prescribed<S> {
    strains: S,
    rates: S,
}

impl<E: StrainedElement> ShellPrestrain<E> {
    /// Creates the term of an element for the sources that cover it.
    pub(super) fn new(element: E, sources: Vec<SurfacePrestrain>) -> Self {
        let (mut parts, all) = (Vec::new(), sources.iter().collect::<Vec<_>>());
        each_part(&all, |sources, field| parts.push(Part { sources, strains: element.sampled(field) }));
        Self { element, sources: Arc::new(sources), parts }
    }

    fn prescribed(&self, at: &Local<'_>) -> Prescribed<E::Strains> {
        self.prescribed_by(&factors(&self.sources, at.t, at.load))
    }

    fn prescribed_by(&self, factors: &Factors) -> Prescribed<E::Strains> {
        let mut sum = Prescribed { strains: E::zero(), rates: E::zero() };
        let factor = |source: Option<usize>| source.map_or([1.0, 0.0], |k| factors[k]);
        for Part { sources, strains } in &self.parts {
            let [[f, df], [g, dg]] = sources.map(factor);
            E::add(&mut sum.strains, f * g, strains);
            E::add(&mut sum.rates, df * g + f * dg, strains);
        }
        sum
    }

    /// Returns the stresses −D ε⁰ − τD ε̇⁰.
    fn stress(&self, at: &Local<'_>) -> E::Strains {
        let Prescribed { strains, rates } = self.prescribed(at);
        let mut sum = E::zero();
        E::add(&mut sum, -1.0, &strains);
        E::add(&mut sum, -self.element.retardation(), &rates);
        self.element.stress_of(&sum)
    }

    /// Returns ε̇⁰ τD ε̇.
    fn viscous_power(&self, prescribed: &E::Strains, rates: &E::Strains) -> f64 {
        self.element.retardation() * E::product(&self.element.stress_of(prescribed), rates)
    }
}

impl<E: StrainedElement> Term for ShellPrestrain<E> {
    fn coordinates(&self) -> &[usize] {
        self.element.coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.element.add_forces_of(at.q, &self.stress(at), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.element.add_rounding_of(at.q, &self.stress(at), floor);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        if w.q != 0.0 {
            let mut scaled = E::zero();
            E::add(&mut scaled, w.q, &self.stress(at));
            self.element.add_stiffness_of(at.q, &scaled, k);
        }
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let stress = self.element.exact_work(self.stress(&step.middle), step);
        self.element.add_forces_of(step.middle.q, &stress, r);
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let mut scaled = E::zero();
        E::add(&mut scaled, w.q, &self.element.exact_work(self.stress(&step.middle), step));
        self.element.add_stiffness_of(step.middle.q, &scaled, k);
    }

    /// First-order response of the prescribed strains to the increment of the load factor.
    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let [mut factors, increments] = [at.load, by.load].map(|load| factors(&self.sources, at.t, load));
        factors.iter_mut().zip(increments).for_each(|(factor, [increment, _])| factor[1] = increment);
        let mut rates = E::zero();
        E::add(&mut rates, -1.0, &self.prescribed_by(&factors).rates);
        self.element.add_stiffness_of(at.q, &self.element.stress_of(&rates), k);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let Prescribed { strains, .. } = self.prescribed(at);
        let stress = self.element.stress_of(&strains);
        let total = self.element.strains_of(at.q);
        let strain = 0.5 * E::product(&stress, &strains) - E::product(&stress, &total);
        Energy { strain, ..Energy::default() }
    }

    /// Returns −ε̇⁰ D (ε − ε⁰) + ε̇ τD ε̇⁰ of all points.
    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let Prescribed { strains, rates } = self.prescribed(at);
        let stress = self.element.stress_of(&rates);
        let total = self.element.strains_of(at.q);
        E::product(&stress, &strains) - E::product(&stress, &total)
            + self.viscous_power(&rates, &self.element.rates_of(at.q, at.v))
    }

    fn is_damped(&self) -> bool {
        false
    }

    /// Returns ε̇⁰ τD (ε̇⁰ − 2ε̇): with the damping of the element it is the dissipated power of ε̇ − ε̇⁰.
    fn flow_power(&self, at: &Local<'_>) -> f64 {
        if self.element.retardation() == 0.0 {
            return 0.0;
        }
        let Prescribed { rates, .. } = self.prescribed(at);
        let own = self.element.rates_of(at.q, at.v);
        self.viscous_power(&rates, &rates) - 2.0 * self.viscous_power(&rates, &own)
    }
}
