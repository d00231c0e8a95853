use std::sync::Arc;

use ancf_solver::equations::Local;

use super::element::StrainedElement;
use super::source::{Factors, SurfacePrestrain, each_part, factors};

/// Prescribed strains ε⁰ of an element as functions of time and load factor.
///
/// ε⁰ is Green's strain ½ (UᵀU − 1) with the elongations U = 1 + Σ f_s ε_s of the sources s with the factors f_s, and the curvatures
/// and strains of tensions, which are linear in the factors.
#[derive(Clone)]
pub(super) struct Prescription<E: StrainedElement> {
    pub(super) element: E,
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
pub(super) struct Prescribed<S> {
    pub(super) strains: S,
    pub(super) rates: S,
}

impl<E: StrainedElement> Prescription<E> {
    /// Samples the strains of sources at the points of an element.
    pub(super) fn new(element: E, sources: Vec<SurfacePrestrain>) -> Self {
        let (mut parts, all) = (Vec::new(), sources.iter().collect::<Vec<_>>());
        each_part(&all, |sources, field| parts.push(Part { sources, strains: element.sampled(field) }));
        Self { element, sources: Arc::new(sources), parts }
    }

    /// Returns the prescribed strains in a state.
    pub(super) fn at(&self, at: &Local<'_>) -> Prescribed<E::Strains> {
        self.by(&factors(&self.sources, at.t, at.load))
    }

    /// Returns the prescribed strains in a state, and as rates their change by the increment of the load factor.
    pub(super) fn response(&self, at: &Local<'_>, by: &Local<'_>) -> Prescribed<E::Strains> {
        let [mut factors, increments] = [at.load, by.load].map(|load| factors(&self.sources, at.t, load));
        factors.iter_mut().zip(increments).for_each(|(factor, [increment, _])| factor[1] = increment);
        self.by(&factors)
    }

    fn by(&self, factors: &Factors) -> Prescribed<E::Strains> {
        let mut sum = Prescribed { strains: E::zero(), rates: E::zero() };
        let factor = |source: Option<usize>| source.map_or([1.0, 0.0], |k| factors[k]);
        for Part { sources, strains } in &self.parts {
            let [[f, df], [g, dg]] = sources.map(factor);
            E::add(&mut sum.strains, f * g, strains);
            E::add(&mut sum.rates, df * g + f * dg, strains);
        }
        sum
    }

    /// Returns ε̇⁰ τD ε̇.
    pub(super) fn viscous_power(&self, prescribed: &E::Strains, rates: &E::Strains) -> f64 {
        self.element.retardation() * E::product(&self.element.stress_of(prescribed), rates)
    }

    /// Returns ε̇⁰ τD (ε̇⁰ − 2ε̇): with the damping of the element it is the dissipated power of ε̇ − ε̇⁰.
    pub(super) fn flow_power(&self, at: &Local<'_>) -> f64 {
        if self.element.retardation() == 0.0 {
            return 0.0;
        }
        let Prescribed { rates, .. } = self.at(at);
        let own = self.element.rates_of(at.q, at.v);
        self.viscous_power(&rates, &rates) - 2.0 * self.viscous_power(&rates, &own)
    }
}
