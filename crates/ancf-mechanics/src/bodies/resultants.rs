use ancf_solver::equations::{LOCAL, Local, State};
use nalgebra::{Matrix3, Vector3};

use super::mesh::{BeamMesh, StressLaw};
use crate::constraints::Wrench;
use crate::kinematics::VectorKind;
use crate::sections::{DIRECTORS, Directors, all_strains, linked_strain_terms, local_strains};

impl BeamMesh {
    /// Returns the force and the moment about the section centre at an arc length, in the global frame.
    ///
    /// They are exerted by the part at greater arc length on the other part. Resolved in
    /// [`section_frame`](Self::section_frame), a positive first component of the force is tension.
    ///
    /// At the nodes, the resultants balance inertia, body force and damping of one element. They are exact for any mesh
    /// if the element has no other loads. Within an element they are interpolated linearly.
    pub fn resultants(&self, state: &State, s: f64) -> Wrench {
        let (element, xi) = self.locate(s);
        let [start, end] = self.ends(state, element);
        Wrench {
            force: end.force * xi - start.force * (1.0 - xi),
            moment: end.moment * xi - start.moment * (1.0 - xi),
        }
    }

    /// Returns N, Qy, Qz and T, My, Mz: the [`resultants`](Self::resultants) in the
    /// [`section_frame`](Self::section_frame).
    pub fn section_forces(&self, state: &State, s: f64) -> Wrench {
        let (wrench, frame) = (self.resultants(state, s), self.section_frame(state, s));
        let seen = |x: Vector3<f64>| Vector3::from(frame.map(|axis| axis.dot(&x)));
        Wrench { force: seen(wrench.force), moment: seen(wrench.moment) }
    }

    /// Returns the forces and moments that balance an element at its two ends.
    fn ends(&self, state: &State, element: usize) -> [Wrench; 2] {
        let term = self.term(element);
        let coordinates = term.coordinates();
        let n = coordinates.len();
        let mut local = [[0.0; LOCAL]; 4];
        for (i, &c) in coordinates.iter().enumerate() {
            local[0][i] = state.q[c];
            local[1][i] = state.v[c];
            local[2][i] = state.a[c];
        }
        let [q, v, a, mut r] = local;
        let at = Local { q: &q[..n], v: &v[..n], a: &a[..n], lambda: &[], t: state.t, load: state.load };
        term.residual(&at, &mut r[..n]);
        let kinds = self.node_kinds();
        let last = n / 3 - kinds.len();
        let offset = element * self.stride();
        [0, last].map(|first| {
            let mut wrench = Wrench::default();
            for (i, kind) in kinds.iter().enumerate() {
                let place = first + i;
                let force = Vector3::from_column_slice(&r[3 * place..3 * place + 3]);
                if *kind == VectorKind::Position {
                    wrench.force += force;
                } else {
                    let vector = self.reference[offset + place]
                        + Vector3::from_column_slice(&q[3 * place..3 * place + 3]);
                    wrench.moment += vector.cross(&force);
                }
            }
            wrench
        })
    }

    /// Returns the axes of the [`SectionFrame`](crate::kinematics::SectionFrame) at an arc length.
    ///
    /// For a cable, they are the tangent and two arbitrary normal directions.
    pub fn section_frame(&self, state: &State, s: f64) -> [Vector3<f64>; 3] {
        if let Some(frame) = self.frame(s) {
            return frame.at(&state.q).axes;
        }
        let [tangent, ..] = self.axes(s);
        let normal = tangent.value(state).normalize();
        let [y, z] = normals_to(normal);
        [normal, y, z]
    }
}

impl BeamMesh {
    /// Returns the Green-Lagrange strain and the second Piola-Kirchhoff stress at (y, z) of the section at an arc
    /// length.
    ///
    /// The components refer to the frame of the reference section. The stress follows the formulation. A rod has normal
    /// stresses E times normal strains, plus the stress of lateral contraction on the axis. Shear stresses are G times
    /// shear strains, without torsion and shear correction factors, which are averages over a section. A cable has
    /// stretch ε and stress E ε.
    pub fn strain_and_stress(&self, state: &State, s: f64, [y, z]: [f64; 2]) -> [Matrix3<f64>; 2] {
        let (g0, u, xi) = self.directors(state, s);
        if self.elasticity == StressLaw::Line {
            let (length, moved) = (g0[0].norm(), (g0[0] + u[0]).norm());
            let stretch = moved / length - 1.0;
            let along = Matrix3::from_diagonal(&Vector3::new(stretch, 0.0, 0.0));
            return [along, along * self.lame.young()];
        }
        let mut products = all_strains(&g0, &u);
        if self.elasticity == (StressLaw::Rod { linked: true }) {
            for (strain, added, factor) in linked_strain_terms(xi, self.length) {
                products[strain] += factor * products[added];
            }
        }
        let at = |y: f64, z: f64| {
            let (rows, _) = local_strains(&g0, y, z);
            let [xx, yy, zz, xy, xz, yz] =
                rows.map(|row| row.iter().zip(&products).map(|(row, product)| row * product).sum::<f64>());
            Matrix3::new(xx, 0.5 * xy, 0.5 * xz, 0.5 * xy, yy, 0.5 * yz, 0.5 * xz, 0.5 * yz, zz)
        };
        let strain = at(y, z);
        [strain, self.stress(&strain, &at(0.0, 0.0))]
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

    /// Returns the reference directors at an arc length, their increments, and ξ.
    fn directors(&self, state: &State, s: f64) -> (Directors, Directors, f64) {
        let (element, xi) = self.locate(s);
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
        (g0, u, xi)
    }

    fn displacement(&self, state: &State, vector: usize) -> Vector3<f64> {
        let first = self.first + 3 * vector;
        Vector3::from_column_slice(&state.q[first..first + 3])
    }
}

/// Returns two orthonormal vectors normal to a unit vector. Global axes are used where possible.
pub fn normals_to(axis: Vector3<f64>) -> [Vector3<f64>; 2] {
    let least = axis.iamin();
    let guide = Vector3::from_fn(|i, _| if i == least { 1.0 } else { 0.0 });
    let first = (guide - axis * axis.dot(&guide)).normalize();
    [first, axis.cross(&first)]
}
