//! Shape functions, curves, surfaces, quadrature, and points and directions linear in the coordinates.

mod attachment;
mod axis;
mod body_vector;
mod curves;
mod frame;
mod line;
mod marker;
mod nodal_vector;
mod quadrature;
mod rotation;
mod section_frame;
mod shape;
mod surfaces;

pub(crate) use attachment::round_to_zero;
pub use attachment::{Attachment, Directions};
pub use axis::ElementAxis;
pub use body_vector::BodyVector;
pub(crate) use body_vector::add_section;
pub use curves::{
    ReferenceCurve, ReferenceNode, Spline, TridiagonalRow, solve_cyclic_tridiagonal, solve_tridiagonal,
};
pub use frame::{Real, add_symmetric};
pub(crate) use frame::{constant, visit_skew};
pub(crate) use line::{AxialStretch, Bend, BendBlocks};
pub use marker::Marker;
pub use nodal_vector::NodalVector;
pub use quadrature::{gauss, gauss2, gauss3};
pub(crate) use quadrature::{gauss4, lobatto3, simpson_points};
pub(crate) use rotation::{relative_driven_rotation, relative_rotation};
pub use section_frame::{FrameValues, SectionFrame};
pub use shape::{BeamShape, Interpolation, QuadraticShape, VectorKind};
pub(crate) use surfaces::{
    BicubicNet, CONVEX, OffsetValues, SurfaceSlopes, SurfaceValues, closest_offset_point, closest_point,
    gap_slopes,
};
