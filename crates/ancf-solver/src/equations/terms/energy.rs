use std::ops::AddAssign;

use serde::{Deserialize, Serialize};

/// Energies of a state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Energy {
    /// ½ vᵀ M v.
    pub kinetic: f64,
    /// Strain energy U(q).
    pub strain: f64,
    /// Potential of conservative loads, zero in the reference configuration.
    pub potential: f64,
}

impl Energy {
    /// Returns the total energy.
    pub fn total(&self) -> f64 {
        self.kinetic + self.strain + self.potential
    }

    /// Returns the largest magnitude of the three energies.
    pub fn largest(&self) -> f64 {
        self.kinetic.abs().max(self.strain.abs()).max(self.potential.abs())
    }
}

impl AddAssign for Energy {
    fn add_assign(&mut self, other: Self) {
        self.kinetic += other.kinetic;
        self.strain += other.strain;
        self.potential += other.potential;
    }
}

/// Power balance of the total energy: d(T + U + V)/dt = work − dissipation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Power {
    /// Power supplied by prescribed motions and by loads without a potential.
    pub work: f64,
    /// Power dissipated by damping, drag and friction.
    pub dissipation: f64,
}

impl AddAssign for Power {
    fn add_assign(&mut self, other: Self) {
        self.work += other.work;
        self.dissipation += other.dissipation;
    }
}

/// Order of the time derivative of the constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Φ(q, t).
    Position,
    /// Φ̇ = Φ_q v + Φ_t. In index-3 schemes this is the velocity drift.
    Velocity,
    /// (Φ_q v)_q v + Φ_tt, the part of Φ̈ without accelerations.
    Acceleration,
}
