use ancf::nalgebra::Vector3;
use serde_json::{Map, Value, json};

use crate::random::{Random, rounded};

/// Kind of the analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Task {
    Dynamics,
    Statics,
    Path,
    Modes,
    Buckling,
}

/// Kind of a body, as far as joints and loads depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Beam,
    Quadratic,
    Cable,
    Rigid,
    Mass,
    Shell,
}

impl Kind {
    /// True for bodies with a section or a frame.
    pub(super) const fn has_frame(self) -> bool {
        matches!(self, Self::Beam | Self::Quadratic | Self::Rigid | Self::Shell)
    }

    /// True for bodies with an axis.
    pub(super) const fn is_flexible(self) -> bool {
        matches!(self, Self::Beam | Self::Quadratic | Self::Cable)
    }
}

/// Place of a body to which joints, loads and probes attach.
#[derive(Clone, Debug)]
pub(super) struct Spot {
    /// Name of the body.
    pub(super) body: String,
    pub(super) kind: Kind,
    pub(super) at: Value,
    pub(super) point: Vector3<f64>,
    /// True at an end of an axis or on a rigid body, false between the ends.
    pub(super) is_end: bool,
}

impl Spot {
    /// Place as in a model file.
    pub(super) fn place(&self) -> Value {
        json!({ "body": self.body, "at": self.at })
    }

    /// Place with a rigid arm to a point.
    pub(super) fn place_of(&self, point: &Vector3<f64>) -> Value {
        let arm = point - self.point;
        if arm.norm() < 1e-12 {
            return self.place();
        }
        json!({ "body": self.body, "at": self.at, "offset": list(&arm) })
    }
}

/// Magnitudes of a model: of its longest beam.
#[derive(Clone, Copy, Debug)]
pub(super) struct Magnitudes {
    pub(super) length: f64,
    pub(super) diameter: f64,
    pub(super) young: f64,
    pub(super) density: f64,
}

impl Magnitudes {
    fn random(random: &mut Random) -> Self {
        Self {
            length: random.within(0.5, 1.5),
            diameter: random.spread(0.03, 0.15),
            young: random.spread(1e7, 2e9),
            density: random.spread(800.0, 8000.0),
        }
    }

    /// Bending stiffness of a circular section.
    pub(super) fn bending(&self) -> f64 {
        self.young * self.diameter.powi(4) * 0.049
    }

    /// Force that bends a beam of this length by about a third of its length.
    pub(super) fn force(&self) -> f64 {
        self.bending() / self.length.powi(2)
    }

    /// Moment that bends a beam of this length by a radian.
    pub(super) fn moment(&self) -> f64 {
        self.bending() / self.length
    }

    /// Mass of a beam of this length.
    pub(super) fn mass(&self) -> f64 {
        self.density * 0.785 * self.diameter.powi(2) * self.length
    }

    /// Period of the first bending vibration of a cantilever.
    pub(super) fn period(&self) -> f64 {
        1.8 * (self.mass() * self.length.powi(3) / self.bending()).sqrt()
    }
}

/// Model in the making.
#[derive(Debug)]
pub(super) struct Draft {
    pub(super) random: Random,
    pub(super) task: Task,
    /// True for a system without support.
    pub(super) is_free: bool,
    pub(super) sizes: Magnitudes,
    pub(super) materials: Map<String, Value>,
    pub(super) sections: Map<String, Value>,
    pub(super) bodies: Vec<Value>,
    pub(super) joints: Vec<Value>,
    pub(super) couplings: Vec<Value>,
    pub(super) loads: Vec<Value>,
    pub(super) contacts: Vec<Value>,
    pub(super) probes: Vec<Value>,
    pub(super) spots: Vec<Spot>,
}

impl Draft {
    pub(super) fn new(mut random: Random) -> Self {
        let tasks = [
            (0.5, Task::Dynamics),
            (0.22, Task::Statics),
            (0.08, Task::Path),
            (0.12, Task::Modes),
            (0.08, Task::Buckling),
        ];
        let task = random.weighted(&tasks);
        let free = match task {
            Task::Dynamics => 0.2,
            Task::Modes => 0.15,
            _ => 0.0,
        };
        let is_free = random.chance(free);
        let sizes = Magnitudes::random(&mut random);
        Self {
            random,
            task,
            is_free,
            sizes,
            materials: Map::new(),
            sections: Map::new(),
            bodies: Vec::new(),
            joints: Vec::new(),
            couplings: Vec::new(),
            loads: Vec::new(),
            contacts: Vec::new(),
            probes: Vec::new(),
            spots: Vec::new(),
        }
    }

    /// True for analyses that require support of all motions.
    pub(super) fn is_static(&self) -> bool {
        self.task != Task::Dynamics
    }

    /// Random vector of a magnitude, along a global axis in half of the cases.
    pub(super) fn vector(&mut self, magnitude: f64) -> Vector3<f64> {
        let direction = if self.random.chance(0.4) {
            let mut axis = Vector3::zeros();
            axis[self.random.index(3)] = if self.random.chance(0.5) { 1.0 } else { -1.0 };
            axis
        } else {
            self.random.direction()
        };
        (direction * magnitude).map(rounded)
    }

    /// Function of time of a load; none in statics.
    pub(super) fn time(&mut self, is_motion: bool) -> Value {
        let end = rounded(self.sizes.period());
        if self.is_static() {
            return json!(1.0);
        }
        let smooth =
            json!({ "kind": "expression", "text": "t^2*(3 - 2*t)/(1 + t^2)", "unit": rounded(2.0 / end) });
        if is_motion {
            return smooth;
        }
        match self.random.index(5) {
            0 => json!(1.0),
            1 => json!({ "kind": "sine", "frequency": rounded(0.7 / end), "phase": 0.0 }),
            2 => json!({ "kind": "ramp", "end": rounded(0.5 * end) }),
            3 => {
                json!({ "kind": "table", "times": [0.0, rounded(0.2 * end), rounded(0.5 * end)], "values": [0.0, 1.0, -0.5] })
            }
            _ => smooth,
        }
    }
}

/// Array of a model file.
pub(super) fn list(x: &Vector3<f64>) -> Value {
    json!([x.x, x.y, x.z])
}
