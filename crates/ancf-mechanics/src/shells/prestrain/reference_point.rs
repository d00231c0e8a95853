use nalgebra::Vector3;

/// Tangents and curvature of a reference surface at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReferencePoint {
    /// Tangents r_ξ and r_η.
    pub(crate) tangents: [Vector3<f64>; 2],
    /// Covariant components (ξξ, ηη, 2 ξη) of the curvature r_,α·n_,β of the normal n, positive with the centre opposite to the normal.
    pub(crate) curvature: Vector3<f64>,
}

impl ReferencePoint {
    /// Creates a point of a plane.
    pub(crate) fn flat(tangents: [Vector3<f64>; 2]) -> Self {
        Self { tangents, curvature: Vector3::zeros() }
    }

    /// Creates a point of a surface with the derivatives r_ξ, r_η, r_ξξ, r_ηη, r_ξη.
    pub(crate) fn of_surface([t, s, tt, ss, ts]: [Vector3<f64>; 5]) -> Self {
        let n = t.cross(&s).normalize();
        Self { tangents: [t, s], curvature: -Vector3::new(n.dot(&tt), n.dot(&ss), 2.0 * n.dot(&ts)) }
    }

    /// Creates a point of a surface with a director field d in place of the normal, given d_ξ and d_η.
    pub(crate) fn of_directors([t, s]: [Vector3<f64>; 2], [of_t, of_s]: [Vector3<f64>; 2]) -> Self {
        let curvature = Vector3::new(t.dot(&of_t), s.dot(&of_s), t.dot(&of_s) + s.dot(&of_t));
        Self { tangents: [t, s], curvature }
    }
}
