use ancf_solver::equations::{Local, Term};

use super::source::{ElementPlace, Prestrain};
use crate::elements::StrainEnergy;

/// Forces of the prescribed strains of one element.
///
/// The strain energy of an element and its term is ½∫(ε − ε⁰)ᵀ D (ε − ε⁰) dx: that of the element is ½∫εᵀ D ε dx.
pub(crate) trait PrestrainTerm: Term {
    /// Copies the term.
    fn copied(&self) -> Box<dyn Term>;

    /// Adds the residual without the viscous part of the rates of the prescribed strains.
    fn add_elastic(&self, at: &Local<'_>, r: &mut [f64]);

    /// Returns the energy of the term by part: what it adds to the parts of the element.
    fn parts(&self, at: &Local<'_>) -> StrainEnergy;
}

/// Element whose strains can be prescribed.
pub(crate) trait Prestrained {
    /// Creates the term of the sources that cover an element, at its place; `None` if the law of the element is not quadratic in the
    /// strains.
    fn prestrained(&self, place: ElementPlace, sources: &[Prestrain]) -> Option<Box<dyn PrestrainTerm>>;
}
