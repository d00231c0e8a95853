use ancf_solver::equations::State;
use nalgebra::{Matrix3, Vector3};

use super::mesh::{BeamMesh, StressLaw};
use crate::elements::section_prestrains;
use crate::kinematics::{VectorKind, gauss2};
use crate::sections::{
    AA, AD, AE, BE, CD, DD, DE, DIRECTORS, DeformationFactors, Directors, EE, STRAINS, Strains, all_rates,
    all_strains, linked_strain_terms, local_strain,
};

/// Strain in a section of a flexible body.
#[derive(Clone, Copy, Debug)]
pub struct SectionStrain {
    /// Reference directors.
    g0: Directors,
    /// Strains of the pairs of directors.
    products: Strains,
    /// Stretch ε of a cable, which has no strain in the section.
    stretch: Option<f64>,
}

impl SectionStrain {
    /// Returns the Green-Lagrange strain at (y, z) in the frame of the reference section, or the stretch of a cable.
    pub fn at(&self, [y, z]: [f64; 2]) -> Matrix3<f64> {
        if let Some(stretch) = self.stretch {
            return Matrix3::from_diagonal(&Vector3::new(stretch, 0.0, 0.0));
        }
        local_strain(&self.g0, &self.products, y, z)
    }

    /// Returns the strain at a point with the shear strains of the warping there. Only rods have warping.
    fn warped_at(&self, (point, warping): SectionPoint) -> Matrix3<f64> {
        let twist = 0.5 * (self.products[BE] - self.products[CD]);
        self.at(point) + warped(twist, warping)
    }

    /// Returns the strain less another one.
    fn less(&self, other: &Self) -> Self {
        Self {
            g0: self.g0,
            products: std::array::from_fn(|k| self.products[k] - other.products[k]),
            stretch: self.stretch.zip(other.stretch).map(|(own, other)| own - other),
        }
    }
}

/// Point (y, z) of a section, and the gradient of the warping function there.
type SectionPoint = ([f64; 2], [f64; 2]);

/// Shear strains of the warping of a section by a twist, for the gradient of the warping function.
fn warped(twist: f64, [y, z]: [f64; 2]) -> Matrix3<f64> {
    let [y, z] = [y, z].map(|slope| 0.5 * twist * slope);
    Matrix3::new(0.0, y, z, y, 0.0, 0.0, z, 0.0, 0.0)
}

impl BeamMesh {
    /// Returns the Green-Lagrange strain and the second Piola-Kirchhoff stress at a point of the section at an arc
    /// length: its coordinates (y, z), and the gradient of the warping function of the section there.
    ///
    /// The components refer to the frame of the reference section. The stress follows the formulation, and the strain less the
    /// [prescribed one](Self::prestrain) plus its rate times the retardation time. A rod has normal
    /// stresses E times normal strains, plus the stress of lateral contraction on the axis. Shear stresses are G times
    /// shear strains. Those of torsion contain the warping; those of shear forces have no correction factor, which is an average over a
    /// section. A cable has stretch ε and stress E ε.
    pub fn strain_and_stress(&self, state: &State, s: f64, point: SectionPoint) -> [Matrix3<f64>; 2] {
        let section = self.section_strain(state, s);
        let [prescribed, prescribed_rate] = self.prescribed_strain(state, s, &section);
        let elastic = section.less(&prescribed);
        let is_rod = matches!(self.elasticity, StressLaw::Rod { .. });
        let at = |strain: &SectionStrain, (point, warping): SectionPoint| {
            if is_rod { strain.warped_at((point, warping)) } else { strain.at(point) }
        };
        let on_axis = ([0.0; 2], [0.0; 2]);
        let stress = self.stress(&at(&elastic, point), &at(&elastic, on_axis));
        let damping = if self.retardation == DeformationFactors::default() {
            Matrix3::zeros()
        } else {
            let rate = self.strain_rate(state, s).less(&prescribed_rate);
            self.damping_stress(&at(&rate, point), &at(&rate, on_axis))
        };
        [at(&section, point), stress + damping]
    }

    /// Returns the strain in the section at an arc length.
    pub fn section_strain(&self, state: &State, s: f64) -> SectionStrain {
        let (element, xi) = self.locate(s);
        let [g0, u] = self.directors(element, xi, &state.q);
        let products = |xi: f64| {
            let [g0, u] = self.directors(element, xi, &state.q);
            all_strains(&g0, &u)
        };
        let is_line = self.elasticity == StressLaw::Line;
        let stretch = is_line.then(|| (g0[0] + u[0]).norm() / g0[0].norm() - 1.0);
        SectionStrain { g0, products: self.interpolated(xi, all_strains(&g0, &u), &products), stretch }
    }

    /// Returns the rate of the strain in the section at an arc length.
    fn strain_rate(&self, state: &State, s: f64) -> SectionStrain {
        let (element, xi) = self.locate(s);
        let present = |xi: f64| {
            let [g0, u] = self.directors(element, xi, &state.q);
            [g0, std::array::from_fn(|k| g0[k] + u[k]), self.directors(element, xi, &state.v)[1]]
        };
        let rates = |xi: f64| {
            let [_, directors, rates] = present(xi);
            all_rates(&directors, &rates)
        };
        let [g0, directors, rate] = present(xi);
        let is_line = self.elasticity == StressLaw::Line;
        let stretch = is_line.then(|| {
            let tangent = directors[0];
            tangent.dot(&rate[0]) / (tangent.norm() * g0[0].norm())
        });
        let products = self.interpolated(xi, all_rates(&directors, &rate), &rates);
        SectionStrain { g0, products, stretch }
    }

    /// Returns the prescribed strain in the section at an arc length, and its rate.
    fn prescribed_strain(&self, state: &State, s: f64, section: &SectionStrain) -> [SectionStrain; 2] {
        let changes = self.prescribed_changes(state, s);
        let products = section_prestrains(&section.g0, &changes);
        let is_line = section.stretch.is_some();
        std::array::from_fn(|k| SectionStrain {
            g0: section.g0,
            products: products[k],
            stretch: is_line.then_some(changes[k].strain),
        })
    }

    /// Returns the strains at ξ that have energy, from those that follow from the directors there and at other places.
    fn interpolated(&self, xi: f64, mut strains: Strains, products: &dyn Fn(f64) -> Strains) -> Strains {
        if self.has_middle_nodes() {
            interpolate_from_gauss_points(xi, products, &mut strains);
        }
        if self.elasticity == (StressLaw::Rod { linked: true }) {
            for (strain, added, factor) in linked_strain_terms(xi, self.length) {
                strains[strain] += factor * strains[added];
            }
            interpolate_linked_strains(xi, products, &mut strains);
        }
        strains
    }

    /// Returns the stress of the damping, of the rate of the strain at a point and on the axis.
    ///
    /// The strain on the axis is the mean one of the section, up to terms of the second order in the curvature times the radius of gyration.
    fn damping_stress(&self, rate: &Matrix3<f64>, on_axis: &Matrix3<f64>) -> Matrix3<f64> {
        let DeformationFactors { stretch, shear, bending, torsion, section } = self.retardation;
        let times = |normal: f64, sheared: f64| {
            Matrix3::new(normal, sheared, sheared, sheared, section, section, sheared, section, section)
        };
        let of_mean = on_axis.component_mul(&times(stretch, shear));
        let retarded = of_mean + (rate - on_axis).component_mul(&times(bending, torsion));
        match self.elasticity {
            StressLaw::NeoHookean => self.hooke(&retarded),
            _ => self.stress(&retarded, &of_mean),
        }
    }

    /// Returns the stress of Hooke's law.
    fn hooke(&self, strain: &Matrix3<f64>) -> Matrix3<f64> {
        Matrix3::identity() * (self.lame.lambda * strain.trace()) + strain * (2.0 * self.lame.shear)
    }

    /// Returns the stress of a strain. The rod law also depends on the strain on the axis.
    fn stress(&self, strain: &Matrix3<f64>, on_axis: &Matrix3<f64>) -> Matrix3<f64> {
        let (lambda, shear, identity) = (self.lame.lambda, self.lame.shear, Matrix3::identity());
        match self.elasticity {
            StressLaw::Line => strain * self.lame.young(),
            StressLaw::Continuum => self.hooke(strain),
            StressLaw::NeoHookean => {
                let c = identity + strain * 2.0;
                let inverse = c.try_inverse().unwrap_or_else(|| Matrix3::repeat(f64::NAN));
                (identity - inverse) * shear + inverse * (0.5 * lambda * c.determinant().ln())
            }
            StressLaw::Rod { .. } => {
                let young = self.lame.young();
                let normal = |e: &Matrix3<f64>| Matrix3::from_diagonal(&e.diagonal());
                let rod = normal(strain) * young + (strain - normal(strain)) * (2.0 * shear);
                rod + normal(&self.hooke(on_axis)) - normal(on_axis) * young
            }
        }
    }

    /// Returns the reference directors at ξ of an element, and their increments, or with velocities in place of the coordinates their rates.
    fn directors(&self, element: usize, xi: f64, coordinates: &[f64]) -> [Directors; 2] {
        let offset = element * self.stride();
        let base = [self.reference[offset], self.part(coordinates, offset)];
        let (mut g0, mut u) = ([Vector3::zeros(); DIRECTORS], [Vector3::zeros(); DIRECTORS]);
        for (i, (kind, _, weights)) in self.weights(xi).into_iter().enumerate() {
            let mut vectors = [self.reference[offset + i], self.part(coordinates, offset + i)];
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

/// Replaces the strains of three-node elements by linear ones with the values at the two Gauss points, where their energy is integrated.
///
/// Elsewhere the axial strain also contains the difference between the parabola of the element and its curved axis, which
/// is larger than the strain of the load. The deformation of the section has its own points at the nodes.
fn interpolate_from_gauss_points(xi: f64, products: &dyn Fn(f64) -> Strains, strains: &mut Strains) {
    let points = gauss2().map(|(at, _)| at);
    let [first, second] = points.map(products);
    let part = (xi - points[0]) / (points[1] - points[0]);
    for k in (0..STRAINS).filter(|k| ![DD, DE, EE].contains(k)) {
        strains[k] = first[k] + part * (second[k] - first[k]);
    }
}

/// Replaces strains of linked elements by linear ones: shear strains and the strains in the section by those of the nodes, where they have
/// energy, and the axial strain by the regression line of its parabola through the points of Simpson's rule.
///
/// Between the nodes the shear strain also contains the rotation of the section under bending, and the strains in the section the
/// shortening of interpolated directors. Both are larger than those of the load.
fn interpolate_linked_strains(xi: f64, products: &dyn Fn(f64) -> Strains, strains: &mut Strains) {
    let [start, middle, end] = [0.0, 0.5, 1.0].map(products);
    for k in [AD, AE, DD, DE, EE] {
        strains[k] = start[k] + xi * (end[k] - start[k]);
    }
    let mean = (start[AA] + 4.0 * middle[AA] + end[AA]) / 6.0;
    strains[AA] = mean + (xi - 0.5) * (end[AA] - start[AA]);
}
