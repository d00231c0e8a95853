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
    /// Sum of the three.
    pub fn total(&self) -> f64 {
        self.kinetic + self.strain + self.potential
    }

    /// The largest of the three in size.
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

/// Rates at which the sum of the energies changes: d(T + U + V)/dt = work − dissipation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Power {
    /// Supplied by loads that have no potential and by prescribed motions.
    pub work: f64,
    /// Lost by damping, drag and friction.
    pub dissipation: f64,
}

impl AddAssign for Power {
    fn add_assign(&mut self, other: Self) {
        self.work += other.work;
        self.dissipation += other.dissipation;
    }
}

/// How often constraints are differentiated in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Φ(q, t).
    Position,
    /// Φ̇ = Φ_q v + Φ_t: what the velocities violate, the drift of index-3 schemes.
    Velocity,
    /// (Φ_q v)_q v + Φ_tt, the part of Φ̈ without accelerations.
    Acceleration,
}
