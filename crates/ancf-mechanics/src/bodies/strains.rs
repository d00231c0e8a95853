use ancf_solver::equations::State;
use nalgebra::{Matrix3, Vector3};

use super::mesh::{BeamMesh, StressLaw};
use crate::kinematics::{VectorKind, gauss2};
use crate::sections::{
    AA, AD, AE, BE, CD, DD, DE, DIRECTORS, Directors, EE, STRAINS, Strains, all_strains, linked_strain_terms,
    local_strain,
};

/// Strain in a section of a flexible body.
#[derive(Clone, Copy, Debug)]
pub struct SectionStrain {
    /// Reference directors.
    g0: Directors,
    /// Strains of the pairs of directors.
    products: Strains,
    /// Prescribed strains of the pairs of directors.
    prescribed: Strains,
    /// Stretch ε of a cable, which has no strain in the section, and its prescribed part.
    stretch: Option<[f64; 2]>,
}

impl SectionStrain {
    /// Returns the Green-Lagrange strain at (y, z) in the frame of the reference section, or the stretch of a cable.
    pub fn at(&self, [y, z]: [f64; 2]) -> Matrix3<f64> {
        if let Some([stretch, _]) = self.stretch {
            return Matrix3::from_diagonal(&Vector3::new(stretch, 0.0, 0.0));
        }
        local_strain(&self.g0, &self.products, y, z)
    }

    /// Returns the strain less the prescribed one: it determines the stress.
    fn elastic_at(&self, [y, z]: [f64; 2]) -> Matrix3<f64> {
        if let Some([stretch, prescribed]) = self.stretch {
            return Matrix3::from_diagonal(&Vector3::new(stretch - prescribed, 0.0, 0.0));
        }
        let elastic = std::array::from_fn(|k| self.products[k] - self.prescribed[k]);
        local_strain(&self.g0, &elastic, y, z)
    }
}

/// Shear strains of the warping of a section by a twist, for the gradient of the warping function.
fn warped(twist: f64, [y, z]: [f64; 2]) -> Matrix3<f64> {
    let [y, z] = [y, z].map(|slope| 0.5 * twist * slope);
    Matrix3::new(0.0, y, z, y, 0.0, 0.0, z, 0.0, 0.0)
}

impl BeamMesh {
    /// Returns the Green-Lagrange strain and the second Piola-Kirchhoff stress at a point of the section at an arc
    /// length: its coordinates (y, z), and the gradient of the warping function of the section there.
    ///
    /// The components refer to the frame of the reference section. The stress follows the formulation and the strain less the [prescribed one](Self::prestrain). A rod has normal
    /// stresses E times normal strains, plus the stress of lateral contraction on the axis. Shear stresses are G times
    /// shear strains. Those of torsion contain the warping; those of shear forces have no correction factor, which is an average over a
    /// section. A cable has stretch ε and stress E ε.
    pub fn strain_and_stress(
        &self,
        state: &State,
        s: f64,
        (point, warping): ([f64; 2], [f64; 2]),
    ) -> [Matrix3<f64>; 2] {
        let section = self.section_strain(state, s);
        let (mut strain, mut elastic) = (section.at(point), section.elastic_at(point));
        if section.stretch.is_some() {
            return [strain, elastic * self.lame.young()];
        }
        if let StressLaw::Rod { .. } = self.elasticity {
            let twist = |of: &Strains| 0.5 * (of[BE] - of[CD]);
            strain += warped(twist(&section.products), warping);
            elastic += warped(twist(&section.products) - twist(&section.prescribed), warping);
        }
        [strain, self.stress(&elastic, &section.elastic_at([0.0; 2]))]
    }

    /// Returns the strain in the section at an arc length.
    pub fn section_strain(&self, state: &State, s: f64) -> SectionStrain {
        let (element, xi) = self.locate(s);
        let [g0, u] = self.directors(state, element, xi);
        let mut products = all_strains(&g0, &u);
        if self.has_middle_nodes() {
            self.interpolate_from_gauss_points(state, element, xi, &mut products);
        }
        if self.elasticity == (StressLaw::Rod { linked: true }) {
            for (strain, added, factor) in linked_strain_terms(xi, self.length) {
                products[strain] += factor * products[added];
            }
            self.interpolate_linked_strains(state, element, xi, &mut products);
        }
        let is_line = self.elasticity == StressLaw::Line;
        let stretch = is_line.then(|| {
            let strain = (g0[0] + u[0]).norm() / g0[0].norm() - 1.0;
            [strain, self.prestrain(state, element, xi).0]
        });
        let prescribed = if is_line { [0.0; STRAINS] } else { self.section_prestrains(state, s, &g0) };
        SectionStrain { g0, products, prescribed, stretch }
    }

    /// Returns the stress of a strain. The rod law also depends on the strain on the axis.
    fn stress(&self, strain: &Matrix3<f64>, on_axis: &Matrix3<f64>) -> Matrix3<f64> {
        let (lambda, shear, identity) = (self.lame.lambda, self.lame.shear, Matrix3::identity());
        let hooke = |e: &Matrix3<f64>| identity * (lambda * e.trace()) + e * (2.0 * shear);
        match self.elasticity {
            StressLaw::Continuum => hooke(strain),
            StressLaw::NeoHookean => {
                let c = identity + strain * 2.0;
                let inverse = c.try_inverse().unwrap_or_else(|| Matrix3::repeat(f64::NAN));
                (identity - inverse) * shear + inverse * (0.5 * lambda * c.determinant().ln())
            }
            StressLaw::Rod { .. } | StressLaw::Line => {
                let young = self.lame.young();
                let normal = |e: &Matrix3<f64>| Matrix3::from_diagonal(&e.diagonal());
                let rod = normal(strain) * young + (strain - normal(strain)) * (2.0 * shear);
                rod + normal(&hooke(on_axis)) - normal(on_axis) * young
            }
        }
    }

    /// Replaces the strains of three-node elements by linear ones with the values at the two Gauss points, where their energy is integrated.
    ///
    /// Elsewhere the axial strain also contains the difference between the parabola of the element and its curved axis, which
    /// is larger than the strain of the load. The deformation of the section has its own points at the nodes.
    fn interpolate_from_gauss_points(&self, state: &State, element: usize, xi: f64, products: &mut Strains) {
        let points = gauss2().map(|(at, _)| at);
        let [first, second] = points.map(|at| self.products(state, element, at));
        let part = (xi - points[0]) / (points[1] - points[0]);
        for k in (0..STRAINS).filter(|k| ![DD, DE, EE].contains(k)) {
            products[k] = first[k] + part * (second[k] - first[k]);
        }
    }

    /// Replaces strains of linked elements by linear ones: shear strains and the strains in the section by those of the nodes, where they have
    /// energy, and the axial strain by the regression line of its parabola through the points of Simpson's rule.
    ///
    /// Between the nodes the shear strain also contains the rotation of the section under bending, and the strains in the section the
    /// shortening of interpolated directors. Both are larger than those of the load.
    fn interpolate_linked_strains(&self, state: &State, element: usize, xi: f64, products: &mut Strains) {
        let [start, middle, end] = [0.0, 0.5, 1.0].map(|at| self.products(state, element, at));
        for k in [AD, AE, DD, DE, EE] {
            products[k] = start[k] + xi * (end[k] - start[k]);
        }
        let mean = (start[AA] + 4.0 * middle[AA] + end[AA]) / 6.0;
        products[AA] = mean + (xi - 0.5) * (end[AA] - start[AA]);
    }

    /// Returns the strains of the pairs of directors at ξ of an element.
    fn products(&self, state: &State, element: usize, xi: f64) -> Strains {
        let [g0, u] = self.directors(state, element, xi);
        all_strains(&g0, &u)
    }

    /// Returns the reference directors at ξ of an element, and their increments.
    fn directors(&self, state: &State, element: usize, xi: f64) -> [Directors; 2] {
        let offset = element * self.stride();
        let base = [self.reference[offset], self.displacement(state, offset)];
        let (mut g0, mut u) = ([Vector3::zeros(); DIRECTORS], [Vector3::zeros(); DIRECTORS]);
        for (i, (kind, _, weights)) in self.weights(xi).into_iter().enumerate() {
            let mut vectors = [self.reference[offset + i], self.displacement(state, offset + i)];
            if kind == VectorKind::Position {
                vectors = [vectors[0] - base[0], vectors[1] - base[1]];
            }
            for (director, weight) in kind.directors().into_iter().zip(weights) {
                g0[director] += vectors[0] * weight;
                u[director] += vectors[1] * weight;
            }
        }
        [g0, u]
    }
}
