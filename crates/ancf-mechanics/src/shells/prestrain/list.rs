use std::fmt;
use std::sync::Arc;

use ancf_solver::equations::{LOCAL, Local, State, Term};
use nalgebra::Vector3;

use super::law_element::LawElement;
use super::law_term::LawPrestrain;
use super::reference_point::ReferencePoint;
use super::source::{Covariant, Factors, SurfaceLaw, SurfacePrestrain, each_part, factors};
use super::term::ShellPrestrain;

/// Prescribed strains of a shell, with the terms of the elements that have any.
#[derive(Clone, Default)]
pub(crate) struct SurfacePrestrains {
    sources: Arc<Vec<SurfacePrestrain>>,
    terms: Vec<(usize, Arc<dyn PrestrainTerm>)>,
}

impl fmt::Debug for SurfacePrestrains {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SurfacePrestrains").field("sources", &self.sources).finish_non_exhaustive()
    }
}

/// Term of the prescribed strains of an element.
trait PrestrainTerm: Term {
    /// Copies the term.
    fn copied(&self) -> Box<dyn Term>;
}

impl<T: Term + Clone + 'static> PrestrainTerm for T {
    fn copied(&self) -> Box<dyn Term> {
        Box::new(self.clone())
    }
}

/// Term of the prescribed strains of an element, of any kind of element.
#[derive(Clone)]
pub(crate) struct ElementPrestrain(Arc<dyn PrestrainTerm>);

impl ElementPrestrain {
    /// Creates the term of an element for the sources that cover it.
    pub(crate) fn new<E: LawElement>(element: &E, sources: Vec<SurfacePrestrain>) -> Self {
        let element = element.clone();
        match element.law() {
            None => Self(Arc::new(ShellPrestrain::new(element, sources))),
            Some(_) => Self(Arc::new(LawPrestrain::new(element, sources))),
        }
    }
}

impl SurfacePrestrains {
    /// Creates the terms of all elements that sources cover.
    pub(crate) fn new(
        sources: Vec<SurfacePrestrain>,
        elements: usize,
        of: impl Fn(usize, Vec<SurfacePrestrain>) -> ElementPrestrain,
    ) -> Self {
        let term = |element: usize| {
            let here: Vec<_> = sources.iter().filter(|source| source.covers(element)).cloned().collect();
            (!here.is_empty()).then(|| (element, of(element, here).0))
        };
        let terms = (0..elements).filter_map(term).collect();
        Self { sources: Arc::new(sources), terms }
    }

    /// Copies the terms.
    pub(crate) fn copied(&self) -> impl Iterator<Item = Box<dyn Term>> {
        self.terms.iter().map(|(_, term)| term.copied())
    }

    /// Returns the strain energy that the terms add to that of the elements. `displacements` returns those of an element.
    pub(crate) fn strain_energy(&self, state: &State, displacements: impl Fn(usize) -> Vec<f64>) -> f64 {
        let zeros = [0.0; LOCAL];
        let of = |(element, term): &(usize, Arc<dyn PrestrainTerm>)| {
            let q = displacements(*element);
            let still = &zeros[..q.len()];
            let at = Local { q: &q, v: still, a: still, lambda: &[], t: state.t, load: state.load };
            term.energy(&at).strain
        };
        self.terms.iter().map(of).sum()
    }

    /// Returns the factors of the sources in a state.
    pub(crate) fn factors(&self, state: &State) -> Factors {
        factors(&self.sources, state.t, state.load)
    }

    /// Returns the prescribed strains of an element at a point of its reference surface, and their rates, for factors of the sources.
    pub(crate) fn at(
        &self,
        element: usize,
        law: &SurfaceLaw,
        point: &ReferencePoint,
        factors: &Factors,
    ) -> [Covariant; 2] {
        let mut sums = [[Vector3::zeros(); 2]; 2];
        let covering = self.sources.iter().zip(factors).filter(|(source, _)| source.covers(element));
        let (here, factors): (Vec<&SurfacePrestrain>, Vec<&[f64; 2]>) = covering.unzip();
        each_part(&here, |sources, field| {
            let [[f, df], [g, dg]] = sources.map(|source| source.map_or([1.0, 0.0], |k| *factors[k]));
            let strains = field(law, point);
            for (sum, factor) in sums.iter_mut().zip([f * g, df * g + f * dg]) {
                sum.iter_mut().zip(strains).for_each(|(sum, strain)| *sum += strain * factor);
            }
        });
        sums
    }
}
