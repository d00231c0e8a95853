use nalgebra::Vector3;

/// Sine of the angle between an axis and the normal below which the projection on the surface has no direction.
const NORMAL: f64 = 1e-3;

/// True if an axis has no projection on a surface with a normal.
pub(crate) fn is_parallel(normal: &Vector3<f64>, axis: &[f64; 3]) -> bool {
    normal.normalize().cross(&Vector3::from(*axis).normalize()).norm() < NORMAL
}
