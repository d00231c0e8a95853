use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Layer of a shell, such as a ply of a laminate.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct Layer {
    /// Angle of the fibres about the normal, in radians, from the direction of u or the projection of `fibre_axis`.
    #[unit(radian)]
    pub angle: f64,
    /// Thickness, length. By default all layers are equally thick. Given thicknesses sum up to the thickness of the shell; where that varies,
    /// they are proportions of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[unit(length)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub thickness: Option<f64>,
    /// Name of the material, a key of `materials`; that of the shell by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
}
