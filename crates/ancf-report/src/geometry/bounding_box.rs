use nalgebra::Vector3;

/// Returns the lower and upper corner of the box around all finite points; the origin if there are none.
pub(crate) fn bounding_box(points: impl Iterator<Item = Vector3<f64>>) -> [Vector3<f64>; 2] {
    let finite = points.filter(|x| x.iter().all(|x| x.is_finite()));
    let grown = finite.fold(None, |sum: Option<[Vector3<f64>; 2]>, x| {
        Some(sum.map_or([x, x], |[low, high]| [low.inf(&x), high.sup(&x)]))
    });
    grown.unwrap_or([Vector3::zeros(); 2])
}
