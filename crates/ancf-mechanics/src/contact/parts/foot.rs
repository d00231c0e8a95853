use nalgebra::Vector3;

/// Foot of a point on an element: its closest point r(x) with the parameters x, and d = p − r(x).
///
/// An axis has one parameter, the arc length. A surface has two, ξ and η.
#[derive(Clone, Copy, Debug)]
pub struct Foot<const N: usize> {
    /// Position in the element, from 0 to 1.
    pub(in crate::contact) at: [f64; N],
    /// Share of this element in the contact.
    pub(in crate::contact) share: f64,
    pub(in crate::contact) d: Vector3<f64>,
    /// Radius of the element at r less the smallest one.
    pub(in crate::contact) excess: f64,
    /// Derivatives r_α by the parameters. Where the radius varies, d is not normal to them: these are their parts normal to d, along
    /// which the gap has no derivative.
    pub(in crate::contact) slopes: [Vector3<f64>; N],
    /// Compliance C_αβ of dx_α = C_αβ (r_β·δd + d·δr_β). It is 0 for a parameter at the end of its range.
    pub(in crate::contact) compliance: [[f64; N]; N],
}

/// Size of the transition between elements at a node or an edge, relative to their length.
pub(in crate::contact) const NODE_TRANSITION: f64 = 1e-6;

/// Returns the share of an element in the contact of a point, from one coordinate ξ of its foot.
///
/// `over` is the distance of the projection beyond the end at which ξ is, relative to the length. `free` marks the free ends.
pub(in crate::contact) fn share(xi: f64, over: f64, free: [bool; 2]) -> f64 {
    let beyond = [if xi > 0.0 { -xi } else { -over }, if xi < 1.0 { xi - 1.0 } else { over }];
    let part = |beyond: f64, free: bool| {
        if free { 1.0 } else { (0.5 - 0.5 * beyond / NODE_TRANSITION).clamp(0.0, 1.0) }
    };
    part(beyond[0], free[0]) * part(beyond[1], free[1])
}
