use super::layer::Layer;

/// Thickness, material and layers of a shell of either kind.
#[derive(Clone, Copy, Debug)]
pub struct Layup<'a> {
    /// Thickness, or the mean over the area of one that varies.
    pub thickness: f64,
    /// True if the thickness varies: those of layers are proportions of it.
    pub varies: bool,
    /// Name of the material.
    pub material: &'a str,
    /// Layers; empty for a single one of the material.
    pub layers: &'a [Layer],
}

impl<'a> Layup<'a> {
    /// Materials, thicknesses and angles of the layers, from the lower to the upper side.
    pub(crate) fn plies(self) -> Vec<(&'a str, f64, f64)> {
        let count = self.layers.len() as f64;
        let sum: f64 = self.layers.iter().filter_map(|layer| layer.thickness).sum();
        let ratio = if self.varies { self.thickness / sum } else { 1.0 };
        let of = |layer: &Layer| layer.thickness.map_or(self.thickness / count, |own| own * ratio);
        if self.layers.is_empty() {
            return vec![(self.material, self.thickness, 0.0)];
        }
        let material = |layer: &'a Layer| layer.material.as_deref().unwrap_or(self.material);
        self.layers.iter().map(|layer| (material(layer), of(layer), layer.angle)).collect()
    }
}
