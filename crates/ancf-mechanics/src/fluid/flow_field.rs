use nalgebra::{Matrix3, Vector3};

use crate::functions::Function;

/// Unbounded fluid with a uniform current u = U f(t).
#[derive(Clone, Debug)]
pub struct FlowField {
    /// Density ρ, mass/volume.
    pub density: f64,
    /// Acceleration of gravity g.
    pub gravity: Vector3<f64>,
    /// Velocity U.
    pub current: Vector3<f64>,
    /// Function of time f that scales the velocity.
    pub function: Function,
}

impl FlowField {
    /// Returns the velocity u.
    pub(crate) fn velocity(&self, t: f64) -> Vector3<f64> {
        self.current * self.function.value(t)
    }

    /// Returns the acceleration u̇.
    pub(crate) fn acceleration(&self, t: f64) -> Vector3<f64> {
        self.current * self.function.at(t).rate
    }

    /// Returns the motion of the fluid at a time.
    pub(super) fn motion(&self, t: f64) -> FluidMotion {
        FluidMotion { velocity: self.velocity(t), acceleration: self.acceleration(t) }
    }

    /// Returns buoyancy and the force of the accelerated fluid, without load factor.
    pub(super) fn displaced(&self, motion: &FluidMotion, coefficients: &HydroCoefficients) -> Vector3<f64> {
        (motion.acceleration - self.gravity) * coefficients.displaced()
    }
}

/// Fluid motion at one time.
pub(super) struct FluidMotion {
    pub(super) velocity: Vector3<f64>,
    pub(super) acceleration: Vector3<f64>,
}

/// Hydrodynamic properties of a shell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HydroSurface {
    /// Thickness h, of a shell whose thickness varies that of the whole shell.
    pub thickness: f64,
    /// Drag coefficients: C_n across the surface, and C_t along it.
    pub drag: [f64; 2],
    /// Lift coefficient C_l.
    pub lift: f64,
    /// Length a of the added mass ρ a per area.
    pub added_length: f64,
}

/// Hydrodynamic properties of a section.
///
/// Coefficients are given for the normal and for the tangential direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HydroSection {
    /// Diameter d exposed to the flow.
    pub diameter: f64,
    /// Displaced area A.
    pub area: f64,
    /// Drag coefficients: C_n with the diameter, and C_t with the circumference.
    pub drag: [f64; 2],
    /// Added mass coefficients, relative to the displaced fluid.
    pub added_mass: [f64; 2],
}

/// Hydrodynamic coefficients of a point of a line or a surface, integrated over the length or the area that belongs to the point.
///
/// The direction of a line is its tangent, that of a surface its normal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HydroCoefficients {
    /// Coefficients of |w| w of the parts of w across and along the direction: ½ρ d C_n and ½ρ π d C_t of a line, ½ρ C_t and ½ρ C_n of a
    /// surface.
    drag: [f64; 2],
    /// Coefficient ½ρ C_l of |w across| (w along) along the direction of a surface; 0 for a line.
    lift: f64,
    /// Added mass across and along the direction.
    added: [f64; 2],
    /// Mass of the displaced fluid.
    displaced: f64,
}

/// Motion of a line or a surface and the fluid at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RelativeFlow {
    /// Direction p/|p|: the tangent of a line, or the normal of a surface.
    pub tangent: Vector3<f64>,
    /// Magnitude |p| of p = dr/ds or p = r_ξ × r_η.
    pub stretch: f64,
    /// Velocity of the fluid relative to the body.
    pub relative: Vector3<f64>,
    /// Acceleration of the fluid relative to the body, which the added mass multiplies.
    pub relative_acceleration: Vector3<f64>,
    /// Load factor, which multiplies the drag.
    pub load: f64,
}

/// Derivatives ∂F/∂p, ∂F/∂w and ∂F/∂b of a force F, for a relative velocity w and a relative acceleration b.
pub(crate) struct ForceDerivatives {
    pub gradient: Matrix3<f64>,
    pub velocity: Matrix3<f64>,
    pub acceleration: Matrix3<f64>,
}

impl HydroCoefficients {
    pub(crate) fn new(fluid: &FlowField, section: &HydroSection, length: f64) -> Self {
        let (dynamic_pressure, displaced) =
            (0.5 * fluid.density * section.diameter * length, fluid.density * section.area * length);
        let [normal, tangential] = section.drag;
        Self {
            drag: [dynamic_pressure * normal, dynamic_pressure * std::f64::consts::PI * tangential],
            lift: 0.0,
            added: section.added_mass.map(|c| c * displaced),
            displaced,
        }
    }

    /// Creates the coefficients of an area of a surface.
    pub(super) fn of_surface(fluid: &FlowField, surface: &HydroSurface, area: f64) -> Self {
        let (dynamic_pressure, mass) = (0.5 * fluid.density * area, fluid.density * area);
        let [normal, tangential] = surface.drag;
        Self {
            drag: [dynamic_pressure * tangential, dynamic_pressure * normal],
            lift: dynamic_pressure * surface.lift,
            added: [0.0, mass * surface.added_length],
            displaced: mass * surface.thickness,
        }
    }

    /// Returns the mass of the displaced fluid.
    pub(crate) fn displaced(&self) -> f64 {
        self.displaced
    }

    /// Returns the drag ½ρ d C_n |w_n| w_n + ½ρ π d C_t |w_t| w_t t of a line, or the drag and the lift of a surface.
    pub(crate) fn drag(&self, flow: &RelativeFlow) -> Vector3<f64> {
        let (along, normal_part) = flow.parts(&flow.relative);
        let [normal, tangential] = self.drag;
        let speed = normal_part.norm();
        let pressure = (tangential * along.abs() + self.lift * speed) * along;
        (normal_part * (normal * speed) + flow.tangent * pressure) * flow.load
    }

    /// Multiplies a vector by the added mass.
    pub(crate) fn added(&self, flow: &RelativeFlow, x: &Vector3<f64>) -> Vector3<f64> {
        let (along, normal_part) = flow.parts(x);
        normal_part * self.added[0] + flow.tangent * (along * self.added[1])
    }

    /// Returns ½ v·Ṁv of the added mass M of a line or a surface whose p changes at the rate ṗ.
    pub(crate) fn rotation_power(&self, flow: &RelativeFlow, v: &Vector3<f64>, rate: &Vector3<f64>) -> f64 {
        let (_, turn) = flow.parts(rate);
        (self.added[1] - self.added[0]) * v.dot(&turn) * v.dot(&flow.tangent) / flow.stretch
    }

    /// Computes the derivatives of drag and added mass.
    pub(crate) fn derivatives(&self, flow: &RelativeFlow) -> ForceDerivatives {
        let (t, w, b) = (&flow.tangent, &flow.relative, &flow.relative_acceleration);
        let (along, normal_part) = flow.parts(w);
        let speed = normal_part.norm();
        let ([normal, tangential], lift) = (self.drag.map(|c| c * flow.load), self.lift * flow.load);
        // Direction of w_n.
        let ahead = if speed > 0.0 { normal_part / speed } else { Vector3::zeros() };
        let projector = Matrix3::identity() - t * t.transpose();
        // |w| w has no second derivative at w = 0; its first derivative is zero there.
        let flat = if speed > 0.0 { normal_part * normal_part.transpose() / speed } else { Matrix3::zeros() };
        let velocity = (projector * speed + flat) * normal
            + t * t.transpose() * (2.0 * tangential * along.abs())
            + t * (ahead * along + t * speed).transpose() * lift;
        let identity = Matrix3::identity();
        // Derivatives by the tangent t: of w_n = w − t (t·w), of t·w, and of (M_t − M_n) t (t·b).
        let sideways = identity * along + t * w.transpose();
        let of_speed =
            if speed > 0.0 { normal_part * normal_part.transpose() * (along / speed) } else { flat };
        let turned = sideways * (-normal * speed) - of_speed * normal
            + (t * w.transpose() * 2.0 + identity * along) * (tangential * along.abs())
            + (identity * t.dot(b) + t * b.transpose()) * (self.added[1] - self.added[0])
            + (identity * (speed * along) + t * (w * speed - ahead * (along * along)).transpose()) * lift;
        let acceleration = projector * self.added[0] + t * t.transpose() * self.added[1];
        ForceDerivatives { gradient: turned * projector / flow.stretch, velocity, acceleration }
    }

    /// Bounds the rounding error of the force, given the error of p and the magnitudes in w and b.
    pub(crate) fn rounding(&self, flow: &RelativeFlow, [p, w, b]: [f64; 3]) -> f64 {
        let (drag, added) = (self.drag[0] + self.drag[1] + self.lift, self.added[0] + self.added[1]);
        let turn = p / flow.stretch;
        let (speed, rate) = (flow.relative.norm(), flow.relative_acceleration.norm());
        let of_drag = (drag * flow.load).abs() * speed * (2.0 * w + 3.0 * speed * (1.0 + turn));
        f64::EPSILON * (of_drag + added * (b + 2.0 * rate * (1.0 + turn)))
    }
}

impl RelativeFlow {
    /// Returns x·t and x − t (t·x).
    fn parts(&self, x: &Vector3<f64>) -> (f64, Vector3<f64>) {
        let along = self.tangent.dot(x);
        (along, x - self.tangent * along)
    }
}
