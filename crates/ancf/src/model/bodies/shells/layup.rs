use super::layer::Layer;

/// Thickness, material and layers of a shell of either kind.
#[derive(Clone, Copy, Debug)]
pub struct Layup<'a> {
    /// Thickness.
    pub thickness: f64,
    /// Name of the material.
    pub material: &'a str,
    /// Layers; empty for a single one of the material.
    pub layers: &'a [Layer],
}

impl<'a> Layup<'a> {
    /// Materials, thicknesses and angles of the layers, from the lower to the upper side.
    pub(crate) fn plies(self) -> Vec<(&'a str, f64, f64)> {
        let count = self.layers.len() as f64;
        let of = |layer: &Layer| layer.thickness.unwrap_or(self.thickness / count);
        if self.layers.is_empty() {
            return vec![(self.material, self.thickness, 0.0)];
        }
        let material = |layer: &'a Layer| layer.material.as_deref().unwrap_or(self.material);
        self.layers.iter().map(|layer| (material(layer), of(layer), layer.angle)).collect()
    }
}
