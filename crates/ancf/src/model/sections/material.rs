use ancf_mechanics::sections::{DeformationFactors, Lame};
use ancf_mechanics::shells::PlyElasticity;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Elastic material with damping. It is isotropic unless `orthotropic` is given.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Density ρ, mass/volume.
    #[unit(mass / length^3)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub density: f64,
    /// Young's modulus E, force/area.
    #[unit(force / length^2)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub young: f64,
    /// Poisson's ratio ν, −1 < ν < 0.5; 0 by default.
    #[serde(default)]
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = -1, "exclusiveMaximum" = 0.5))]
    pub poisson: f64,
    /// Constants transverse to fibres; `young` and `poisson` are then those along them. Only for shells.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orthotropic: Option<Orthotropic>,
    /// Constitutive law.
    #[serde(default)]
    pub law: MaterialLaw,
    /// Material damping.
    #[serde(default)]
    pub damping: Damping,
}

/// Constants of an orthotropic material in plane stress.
///
/// Young's modulus E_L along the fibres and Poisson's ratio ν_LT of the contraction transverse to them are those of the material. The
/// constants have to satisfy ν_LT² < E_L/E_T.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Orthotropic {
    /// Young's modulus E_T transverse to the fibres, force/area.
    #[unit(force / length^2)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub young: f64,
    /// Shear modulus G_LT, force/area. It is also the transverse shear modulus G_LZ.
    #[unit(force / length^2)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub shear: f64,
    /// Transverse shear modulus G_TZ, force/area, normal to the fibres; required by shear-deformable shells.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(force / length^2)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub transverse_shear: Option<f64>,
}

/// Constitutive law of a material, by its strain energy density.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum MaterialLaw {
    /// St. Venant-Kirchhoff: ½(λ tr² E + 2G E:E) with the Green-Lagrange strain E.
    #[default]
    StVenantKirchhoff,
    /// Compressible neo-Hookean: ½G (tr C − 3) − G ln J + ½λ ln² J. Only for the continuum formulation.
    NeoHookean,
}

/// Damping of a material.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct Damping {
    /// Retardation time τ of the Kelvin-Voigt model, time. Stresses follow from the strain E + τ dE/dt.
    #[unit(time)]
    #[schemars(extend("minimum" = 0))]
    pub strain: f64,
    /// Retardation time of the mean axial strain, time; `strain` by default. Only for beams without `formulation = "continuum"` and cables.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[unit(time)]
    #[schemars(extend("minimum" = 0))]
    pub stretch: Option<f64>,
    /// Retardation time of bending, time; `strain` by default. Only for cables and for beams except `continuum`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[unit(time)]
    #[schemars(extend("minimum" = 0))]
    pub bending: Option<f64>,
    /// Retardation time of the shear of beams, time; `strain` by default. Only for beams except `continuum`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[unit(time)]
    #[schemars(extend("minimum" = 0))]
    pub shear: Option<f64>,
    /// Retardation time of the torsion of beams, time; `strain` by default. Only for beams except `continuum`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[unit(time)]
    #[schemars(extend("minimum" = 0))]
    pub torsion: Option<f64>,
    /// Rate α of the mass-proportional damping, 1/time. The force per mass is −α v.
    #[unit(1 / time)]
    #[schemars(extend("minimum" = 0))]
    pub mass: f64,
}

impl Damping {
    /// Returns true if a kind of deformation has a retardation time of its own.
    pub(crate) fn is_by_kind(&self) -> bool {
        [self.stretch, self.bending, self.shear, self.torsion].iter().any(Option::is_some)
    }

    /// Returns true if strains of a beam or cable are damped.
    pub(crate) fn has_retardation(&self) -> bool {
        self.retardation() != DeformationFactors::default()
    }

    /// Returns the retardation times of a beam or cable.
    pub(crate) fn retardation(&self) -> DeformationFactors {
        let of = |time: Option<f64>| time.unwrap_or(self.strain);
        DeformationFactors {
            stretch: of(self.stretch),
            shear: of(self.shear),
            bending: of(self.bending),
            torsion: of(self.torsion),
            section: self.strain,
        }
    }
}

impl Material {
    /// Elastic material without damping.
    pub const fn elastic(density: f64, young: f64, poisson: f64) -> Self {
        let damping =
            Damping { strain: 0.0, stretch: None, bending: None, shear: None, torsion: None, mass: 0.0 };
        Self { density, young, poisson, orthotropic: None, law: MaterialLaw::StVenantKirchhoff, damping }
    }

    /// Elastic constants of a ply.
    pub(crate) fn ply(&self) -> PlyElasticity {
        match self.orthotropic {
            Some(Orthotropic { young, shear, transverse_shear }) => PlyElasticity {
                young: [self.young, young],
                poisson: self.poisson,
                shear,
                transverse_shear: [shear, transverse_shear.unwrap_or(shear)],
            },
            None => PlyElasticity::isotropic(self.young, self.poisson),
        }
    }

    /// Lamé's constants λ = Eν/((1+ν)(1−2ν)) and G = E/(2(1+ν)).
    pub fn lame(&self) -> Lame {
        Lame {
            lambda: self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson)),
            shear: self.young / (2.0 * (1.0 + self.poisson)),
        }
    }
}
