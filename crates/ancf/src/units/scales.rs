//! Dimensions of quantities, and units of length, time and force.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Dimension of a quantity: exponents of length, time and force.
///
/// A force has (0, 0, 1), a modulus (−2, 0, 1), a density F T² L⁻⁴ has (−4, 2, 1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// Exponent of length.
    pub length: i32,
    /// Exponent of time.
    pub time: i32,
    /// Exponent of force.
    pub force: i32,
}

impl Dimension {
    /// Pure number.
    pub const NUMBER: Self = Self::new(0, 0, 0);
    /// L.
    pub const LENGTH: Self = Self::new(1, 0, 0);
    /// L², of areas.
    pub const AREA: Self = Self::new(2, 0, 0);
    /// L³.
    pub const VOLUME: Self = Self::new(3, 0, 0);
    /// L⁴, of second moments of area and of torsion constants.
    pub const SECOND_MOMENT: Self = Self::new(4, 0, 0);
    /// T.
    pub const TIME: Self = Self::new(0, 1, 0);
    /// F.
    pub const FORCE: Self = Self::new(0, 0, 1);
    /// 1/T.
    pub const RATE: Self = Self::new(0, -1, 0);
    /// L/T.
    pub const VELOCITY: Self = Self::new(1, -1, 0);
    /// L/T².
    pub const ACCELERATION: Self = Self::new(1, -2, 0);
    /// F/L, of loads per length.
    pub const FORCE_PER_LENGTH: Self = Self::new(-1, 0, 1);
    /// F L, of moments and of energies.
    pub const ENERGY: Self = Self::new(1, 0, 1);
    /// F L/T, of powers.
    pub const POWER: Self = Self::new(1, -1, 1);
    /// F/L², of moduli and of stresses.
    pub const STRESS: Self = Self::new(-2, 0, 1);
    /// Mass per volume, F T²/L⁴.
    pub const DENSITY: Self = Self::new(-4, 2, 1);

    /// F T²/L.
    pub const MASS: Self = Self::new(-1, 2, 1);
    /// F T, of linear momenta.
    pub const MOMENTUM: Self = Self::new(0, 1, 1);
    /// F L T, of angular momenta.
    pub const ANGULAR_MOMENTUM: Self = Self::new(1, 1, 1);
    /// Mass times L², of moments of inertia.
    pub const INERTIA: Self = Self::new(1, 2, 1);

    /// Dimension Lˡ Tᵗ Fᶠ.
    pub const fn new(length: i32, time: i32, force: i32) -> Self {
        Self { length, time, force }
    }
}

/// Units of length, time and force to which a model is converted.
///
/// A quantity x of dimension Lˡ Tᵗ Fᶠ has the value x* = x / (Lˡ Tᵗ Fᶠ) in these units.
///
/// Scales form a group: identity [`Scales::UNIT`], composition [`Scales::then`], inverse [`Scales::inverse`].
///
/// Scales are expressed in the units of the model, any coherent system.
/// Source: Kim et al. (2017), eqs (7), (8), (26), (33).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scales {
    /// Unit of length, `L_ND`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub length: f64,
    /// Unit of time, `T_ND`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub time: f64,
    /// Unit of force, `F_ND`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub force: f64,
}

impl Scales {
    /// Units of the model.
    pub const UNIT: Self = Self { length: 1.0, time: 1.0, force: 1.0 };

    /// Units of the model, the default of keys.
    pub(crate) const fn unit_scales() -> Self {
        Self::UNIT
    }

    /// True for the units of the model.
    pub(crate) fn is_unit(&self) -> bool {
        *self == Self::UNIT
    }

    /// Units with the time T = L √(ρA/F) (Kim et al. 2017, eq. 7).
    ///
    /// `line_mass` is the mass per length ρA of the beam.
    pub fn from_force(length: f64, force: f64, line_mass: f64) -> Self {
        Self { length, time: length * (line_mass / force).sqrt(), force }
    }

    /// Nearest powers of two. Conversion to these units is exact: only the binary exponents of numbers change.
    #[must_use]
    pub fn rounded(&self) -> Self {
        let near = |x: f64| x.log2().round().exp2();
        Self { length: near(self.length), time: near(self.time), force: near(self.force) }
    }

    /// Unit Lˡ Tᵗ Fᶠ of a quantity of dimension `of`.
    pub fn unit(&self, of: Dimension) -> f64 {
        self.length.powi(of.length) * self.time.powi(of.time) * self.force.powi(of.force)
    }

    /// Composition: units `next`, measured in these units.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        Self {
            length: self.length * next.length,
            time: self.time * next.time,
            force: self.force * next.force,
        }
    }

    /// Inverse: conversion to these units and then to their inverse is the identity.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { length: 1.0 / self.length, time: 1.0 / self.time, force: 1.0 / self.force }
    }
}
