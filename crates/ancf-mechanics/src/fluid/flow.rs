use nalgebra::{Matrix3, Vector3};

use crate::functions::Function;

/// A fluid that fills all space and moves as one, u = U f(t): a uniform current.
#[derive(Clone, Debug)]
pub struct Fluid {
    /// Mass per volume ρ.
    pub density: f64,
    /// Acceleration of gravity g.
    pub gravity: Vector3<f64>,
    /// Velocity U.
    pub current: Vector3<f64>,
    /// Function of time f by which it is multiplied.
    pub function: Function,
}

impl Fluid {
    /// The velocity u.
    pub(crate) fn velocity(&self, t: f64) -> Vector3<f64> {
        self.current * self.function.value(t)
    }

    /// Its rate u̇.
    pub(crate) fn acceleration(&self, t: f64) -> Vector3<f64> {
        self.current * self.function.at(t).rate
    }
}

/// What of a section matters to the fluid around it.
///
/// Coefficients are those across the line, then those along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hull {
    /// Diameter d that meets the flow.
    pub diameter: f64,
    /// Area A of the fluid that it displaces.
    pub area: f64,
    /// Coefficients of drag, C_n of the diameter and C_t of the circumference.
    pub drag: [f64; 2],
    /// Coefficients of added mass, of the fluid that it displaces.
    pub added_mass: [f64; 2],
}

/// What the fluid does at a point of the line, per the length that belongs to the point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wetted {
    /// ½ρ d C_n and ½ρ π d C_t, times the length.
    drag: [f64; 2],
    /// ρ A C_a across and along, times the length.
    added: [f64; 2],
    /// ρ A times the length.
    displaced: f64,
}

/// The motion of line and fluid at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flow {
    /// Tangent p/|p|.
    pub tangent: Vector3<f64>,
    /// |p|, p = dr/ds.
    pub stretch: f64,
    /// Velocity of the fluid, seen from the line.
    pub relative: Vector3<f64>,
    /// Likewise its acceleration, by which the added mass is multiplied.
    pub accelerated: Vector3<f64>,
    /// The load factor, by which drag is multiplied.
    pub load: f64,
}

/// What a force F depends on: ∂F/∂p, ∂F/∂w and ∂F/∂b, for a relative velocity w and a relative acceleration b.
pub(crate) struct Slopes {
    pub gradient: Matrix3<f64>,
    pub velocity: Matrix3<f64>,
    pub acceleration: Matrix3<f64>,
}

impl Wetted {
    pub(crate) fn new(fluid: &Fluid, hull: &Hull, length: f64) -> Self {
        let (pressed, displaced) =
            (0.5 * fluid.density * hull.diameter * length, fluid.density * hull.area * length);
        let [normal, tangential] = hull.drag;
        Self {
            drag: [pressed * normal, pressed * std::f64::consts::PI * tangential],
            added: hull.added_mass.map(|c| c * displaced),
            displaced,
        }
    }

    /// ρ A times the length.
    pub(crate) fn displaced(&self) -> f64 {
        self.displaced
    }

    /// ½ρ d C_n |w_n| w_n + ½ρ π d C_t |w_t| w_t t.
    pub(crate) fn drag(&self, flow: &Flow) -> Vector3<f64> {
        let (along, across) = flow.parts(&flow.relative);
        let [normal, tangential] = self.drag;
        let drag = across * (normal * across.norm()) + flow.tangent * (tangential * along.abs() * along);
        drag * flow.load
    }

    /// The added mass times a vector.
    pub(crate) fn added(&self, flow: &Flow, x: &Vector3<f64>) -> Vector3<f64> {
        let (along, across) = flow.parts(x);
        across * self.added[0] + flow.tangent * (along * self.added[1])
    }

    /// ½ v·Ṁv of the added mass M on a line whose gradient changes at the rate ṗ.
    pub(crate) fn turning(&self, flow: &Flow, v: &Vector3<f64>, rate: &Vector3<f64>) -> f64 {
        let (_, turn) = flow.parts(rate);
        (self.added[1] - self.added[0]) * v.dot(&turn) * v.dot(&flow.tangent) / flow.stretch
    }

    /// The derivatives of drag and added mass.
    pub(crate) fn slopes(&self, flow: &Flow) -> Slopes {
        let (t, w, b) = (&flow.tangent, &flow.relative, &flow.accelerated);
        let (along, across) = flow.parts(w);
        let speed = across.norm();
        let [normal, tangential] = self.drag.map(|c| c * flow.load);
        let projector = Matrix3::identity() - t * t.transpose();
        // |w| w has no second derivative where w vanishes; its first is zero there.
        let flat = if speed > 0.0 { across * across.transpose() / speed } else { Matrix3::zeros() };
        let velocity =
            (projector * speed + flat) * normal + t * t.transpose() * (2.0 * tangential * along.abs());
        let identity = Matrix3::identity();
        // By the tangent t: of w_n = w − t (t·w), of t·w, and of (M_t − M_n) t (t·b).
        let sideways = identity * along + t * w.transpose();
        let of_speed = if speed > 0.0 { across * across.transpose() * (along / speed) } else { flat };
        let turned = sideways * (-normal * speed) - of_speed * normal
            + (t * w.transpose() * 2.0 + identity * along) * (tangential * along.abs())
            + (identity * t.dot(b) + t * b.transpose()) * (self.added[1] - self.added[0]);
        let acceleration = projector * self.added[0] + t * t.transpose() * self.added[1];
        Slopes { gradient: turned * projector / flow.stretch, velocity, acceleration }
    }

    /// A bound of the rounding error of the force, given that of p and the magnitudes that w and b are made of.
    pub(crate) fn rounding(&self, flow: &Flow, [p, w, b]: [f64; 3]) -> f64 {
        let (drag, added) = (self.drag[0] + self.drag[1], self.added[0] + self.added[1]);
        let turn = p / flow.stretch;
        let (speed, rate) = (flow.relative.norm(), flow.accelerated.norm());
        let of_drag = (drag * flow.load).abs() * speed * (2.0 * w + 3.0 * speed * (1.0 + turn));
        f64::EPSILON * (of_drag + added * (b + 2.0 * rate * (1.0 + turn)))
    }
}

impl Flow {
    /// x·t and x − t (t·x).
    fn parts(&self, x: &Vector3<f64>) -> (f64, Vector3<f64>) {
        let along = self.tangent.dot(x);
        (along, x - self.tangent * along)
    }
}
