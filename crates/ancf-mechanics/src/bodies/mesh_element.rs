use std::fmt;

use ancf_solver::equations::Term;

use crate::elements::{
    Beam24, Beam27, Cable12, ElementPlace, Prestrain, PrestrainTerm, Prestrained, StrainEnergy,
};
use crate::kinematics::{BeamShape, Interpolation, QuadraticShape, VectorKind};

/// Kind of a nodal vector, its weight in r, r_y or r_z, and its weights in the directors.
pub(crate) type VectorWeights = (VectorKind, f64, [f64; 3]);

/// Element type of a mesh along an axis.
///
/// A new type implements this trait beside [`Term`], and gets a constructor of [`BeamMesh`](super::BeamMesh).
pub(crate) trait MeshElement: Term + Prestrained + Clone + fmt::Debug + 'static {
    /// Kinds of the vectors of a node.
    const NODE: &'static [VectorKind];

    /// Number of nodes between the starts of consecutive elements.
    const NODES: usize;

    /// Returns the weights of the vectors of an element of length l and slope length ℓ at ξ.
    fn weights(length: f64, slope: f64, xi: f64) -> Vec<VectorWeights>;

    /// Returns the strain energy by part at the coordinates of the element.
    fn strain_energy(&self, q: &[f64]) -> StrainEnergy;

    /// Returns ∫ ρ S_i dV for each vector.
    fn first_moments(&self) -> &[f64];

    /// Returns the entry M_ab = ∫ ρ S_a S_b dV of the compact mass matrix.
    fn mass(&self, a: usize, b: usize) -> f64;
}

impl MeshElement for Beam24 {
    const NODE: &'static [VectorKind] =
        &[VectorKind::Position, VectorKind::Slope, VectorKind::Y, VectorKind::Z];
    const NODES: usize = 1;

    fn weights(length: f64, slope: f64, xi: f64) -> Vec<VectorWeights> {
        interpolation_weights(&BeamShape { length, slope }, xi)
    }

    fn strain_energy(&self, q: &[f64]) -> StrainEnergy {
        self.parts(q)
    }

    fn first_moments(&self) -> &[f64] {
        self.profile().first_moments()
    }

    fn mass(&self, a: usize, b: usize) -> f64 {
        self.profile().mass()[a][b]
    }
}

impl MeshElement for Beam27 {
    const NODE: &'static [VectorKind] = &[VectorKind::Position, VectorKind::Y, VectorKind::Z];
    const NODES: usize = 2;

    fn weights(length: f64, slope: f64, xi: f64) -> Vec<VectorWeights> {
        interpolation_weights(&QuadraticShape { length, slope }, xi)
    }

    fn strain_energy(&self, q: &[f64]) -> StrainEnergy {
        self.parts(q)
    }

    fn first_moments(&self) -> &[f64] {
        self.profile().first_moments()
    }

    fn mass(&self, a: usize, b: usize) -> f64 {
        self.profile().mass()[a][b]
    }
}

impl MeshElement for Cable12 {
    const NODE: &'static [VectorKind] = &[VectorKind::Position, VectorKind::Slope];
    const NODES: usize = 1;

    fn weights(length: f64, slope: f64, xi: f64) -> Vec<VectorWeights> {
        let mut weights = interpolation_weights(&BeamShape { length, slope }, xi);
        weights.retain(|(kind, ..)| Self::NODE.contains(kind));
        weights
    }

    fn strain_energy(&self, q: &[f64]) -> StrainEnergy {
        let [axial, bending] = self.parts(q);
        StrainEnergy { axial, bending, ..StrainEnergy::default() }
    }

    fn first_moments(&self) -> &[f64] {
        self.profile().first_moments()
    }

    fn mass(&self, a: usize, b: usize) -> f64 {
        self.profile().mass()[a][b]
    }
}

fn interpolation_weights<const N: usize, S: Interpolation<N>>(shape: &S, xi: f64) -> Vec<VectorWeights> {
    let (values, directors) = (shape.values(xi), shape.directors(xi));
    (0..N).map(|i| (S::KINDS[i], values[i], directors[i])).collect()
}

/// Elements of a mesh, all of one type.
pub(crate) trait ElementList: fmt::Debug + Send + Sync {
    /// Returns the number of elements.
    fn count(&self) -> usize;

    /// Returns an element as a term.
    fn term(&self, element: usize) -> &dyn Term;

    /// Copies the elements as terms.
    fn terms(&self) -> Vec<Box<dyn Term>>;

    /// Returns the strain energy of an element by part at its coordinates.
    fn strain_energy(&self, element: usize, q: &[f64]) -> StrainEnergy;

    /// Creates the term of the strains that sources prescribe for an element.
    fn prestrained(
        &self,
        element: usize,
        place: ElementPlace,
        sources: &[Prestrain],
    ) -> Option<Box<dyn PrestrainTerm>>;

    /// Returns ∫ ρ S_i dV of an element for each vector.
    fn first_moments(&self, element: usize) -> &[f64];

    /// Returns the entry M_ab of the compact mass matrix of an element.
    fn mass(&self, element: usize, a: usize, b: usize) -> f64;

    /// Returns the kinds of the vectors of a node.
    fn node(&self) -> &'static [VectorKind];

    /// Returns the number of vectors between the starts of consecutive elements.
    fn stride(&self) -> usize;

    /// Returns the weights of the vectors of an element of length l and slope length ℓ at ξ.
    fn weights(&self, length: f64, slope: f64, xi: f64) -> Vec<VectorWeights>;
}

impl<E: MeshElement> ElementList for Vec<E> {
    fn count(&self) -> usize {
        self.len()
    }

    fn term(&self, element: usize) -> &dyn Term {
        &self[element]
    }

    fn terms(&self) -> Vec<Box<dyn Term>> {
        self.iter().map(|element| Box::new(element.clone()) as _).collect()
    }

    fn strain_energy(&self, element: usize, q: &[f64]) -> StrainEnergy {
        self[element].strain_energy(q)
    }

    fn prestrained(
        &self,
        element: usize,
        place: ElementPlace,
        sources: &[Prestrain],
    ) -> Option<Box<dyn PrestrainTerm>> {
        self[element].prestrained(place, sources)
    }

    fn first_moments(&self, element: usize) -> &[f64] {
        self[element].first_moments()
    }

    fn mass(&self, element: usize, a: usize, b: usize) -> f64 {
        self[element].mass(a, b)
    }

    fn node(&self) -> &'static [VectorKind] {
        E::NODE
    }

    fn stride(&self) -> usize {
        E::NODES * E::NODE.len()
    }

    fn weights(&self, length: f64, slope: f64, xi: f64) -> Vec<VectorWeights> {
        E::weights(length, slope, xi)
    }
}
