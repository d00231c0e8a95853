use ancf_mechanics::elements::TwoNodeLaw;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Element type and elasticity law of a beam.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Formulation {
    /// Two nodes, 24 coordinates, three-dimensional elasticity (Kim et al. 2017). The element of the paper locks: the bending
    /// stiffness is (λ+2G) I instead of E I, the torsion constant is the polar moment of area. With n elements the error is
    /// 1/(3n²).
    Continuum,
    /// Continuum element with the elasticity of a rod (Gerstmayr, Matikainen & Mikkola 2008). The Poisson effect is limited to
    /// the axis. Shear factors and St. Venant's torsion constant apply.
    Enhanced,
    /// Enhanced element with linked strains, free of shear locking. One element is exact for end loads. The default.
    #[default]
    Linked,
    /// Three nodes, 27 coordinates, elasticity of a rod, two integration points (Nachbagauer, Gruber & Gerstmayr 2013).
    Quadratic,
}

impl Formulation {
    /// Law of the two-node element; `None` for three-node elements.
    pub(crate) const fn two_node_law(self) -> Option<TwoNodeLaw> {
        match self {
            Self::Continuum => Some(TwoNodeLaw::Continuum),
            Self::Enhanced => Some(TwoNodeLaw::Enhanced),
            Self::Linked => Some(TwoNodeLaw::Linked),
            Self::Quadratic => None,
        }
    }

    /// True for elements with a middle node. The tangent of their axis has kinks at the ends of elements.
    pub const fn has_middle_node(self) -> bool {
        self.two_node_law().is_none()
    }

    /// True for elements that are too stiff in bending on coarse meshes.
    pub(crate) const fn has_shear_locking(self) -> bool {
        matches!(self, Self::Continuum | Self::Enhanced)
    }

    /// Name in a model file.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Continuum => "continuum",
            Self::Enhanced => "enhanced",
            Self::Linked => "linked",
            Self::Quadratic => "quadratic",
        }
    }

    /// True if the law is three-dimensional and integrated over the section.
    pub(crate) const fn is_continuum(self) -> bool {
        matches!(self, Self::Continuum)
    }
}
