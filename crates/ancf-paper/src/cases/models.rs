//! Models of the three problems of the paper.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use ancf::Model;
use ancf::model::{
    Analysis, At, Beam, Body, Clamp, ClampedGradients, Dynamics, End, EnergyGuard, Formulation, Initial,
    Joint, Material, NamedPosition, NewtonMethod, Output, Place, Probe, Revolute, ScaleChoice, Scheme,
    Section, Slopes, Start,
};
use serde::Serialize;

/// Length of the beam, m (Table 2).
pub const LENGTH: f64 = 1.0;
/// Diameter, m. Table 2 prints 0.20. Eq. (34) and Table 5 require 0.02.
pub const DIAMETER: f64 = 0.02;
/// Density, kg/m³ (Table 2).
pub const DENSITY: f64 = 8030.0;
/// Young's modulus, N/m² (Table 2).
pub const YOUNG: f64 = 193e9;
/// Acceleration of gravity, m/s². Not printed, recovered from the 6263 instants of Table 6 (see `docs/paper.md`).
pub const GRAVITY: f64 = 9.806;
/// Duration, s (Tables 4 to 6).
pub const DURATION: f64 = 2.0;
/// Step size in the time unit of each form (Table 6).
pub const STEP: f64 = 1e-3;
/// Newmark parameter β of the paper.
pub const BETA: f64 = 0.36;
/// Numbers of elements (Tables 3 to 5).
pub const ELEMENTS: [u32; 6] = [1, 2, 5, 10, 15, 20];

/// Problem of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PaperCase {
    /// Section 3.1: cantilever released from the straight state under its own weight.
    Cantilever,
    /// Section 3.2: pendulum on a revolute joint, released from the horizontal.
    Revolute,
    /// Section 3.3: pendulum on a spherical joint, E/1000, equal gravity along -y and -z.
    Spherical,
}

/// Form of the equations of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EquationForm {
    /// SI units, coordinates (r, r_x, r_y, r_z).
    Dimensional,
    /// SI units, coordinates (r, l r_x, l r_y, l r_z).
    LengthSlopes,
    /// Units L_ND, T_ND, F_ND and coordinates (r, l r_x, l r_y, l r_z).
    NonDimensional,
}

/// Returns the time unit T_ND = L √(ρA/F), with F the weight of one element: √(L n/g) (Table 3).
pub fn time_unit(n: u32) -> f64 {
    (LENGTH * f64::from(n) / GRAVITY).sqrt()
}

impl PaperCase {
    /// Returns the name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Cantilever => "cantilever",
            Self::Revolute => "revolute pendulum",
            Self::Spherical => "spherical pendulum",
        }
    }

    /// Returns the model with `n` elements in a form, with the physical step in seconds.
    pub fn model(self, form: EquationForm, n: u32, step: f64) -> Model {
        let end = |end| Place::new("beam", At::Named(end));
        let (name, a, b) = ("joint".to_owned(), end(NamedPosition::Start), End::Ground);
        let joint = match self {
            Self::Cantilever => Joint::Clamp(Clamp { name, a, b, fix: Some(ClampedGradients::All) }),
            Self::Revolute => Joint::Revolute(Revolute {
                name,
                a,
                b,
                axis: [0.0, 0.0, 1.0],
                drive: None,
                spring: None,
                friction: None,
                moment: None,
                stops: None,
            }),
            Self::Spherical => Joint::spherical(&name, a, b),
        };
        let (slopes, scales) = match form {
            EquationForm::Dimensional => (Slopes::Gradient, ScaleChoice::None),
            EquationForm::LengthSlopes => (Slopes::Length, ScaleChoice::None),
            EquationForm::NonDimensional => (Slopes::Length, self.scales(n)),
        };
        Model {
            title: None,
            units: None,
            gravity: if self == Self::Spherical { [0.0, -GRAVITY, -GRAVITY] } else { [0.0, -GRAVITY, 0.0] },
            materials: BTreeMap::from([("steel".into(), self.material())]),
            sections: BTreeMap::from([("rod".into(), Section::circle(DIAMETER))]),
            bodies: vec![Body::Beam(Beam {
                slopes,
                formulation: Formulation::Continuum,
                ..Beam::straight("beam", [[0.0; 3], [LENGTH, 0.0, 0.0]], n, "rod", "steel")
            })],
            joints: vec![joint],
            couplings: Vec::new(),
            loads: Vec::new(),
            inputs: Vec::new(),
            contacts: Vec::new(),
            initial: Initial::default(),
            scales,
            analysis: Analysis::Dynamics(Dynamics {
                // Full Newton method, as in the paper, because iterations are counted.
                newton: NewtonMethod::Full,
                scheme: Scheme::Adams,
                start: Start::Zero,
                // Strong numerical damping, as in the paper.
                energy_guard: EnergyGuard { gain: 1e9, loss: 1e9 },
                // Ends with the last full step, as in the paper.
                ..Dynamics::new((DURATION / step * (1.0 + 1e-12)).floor() * step, step)
            }),
            probes: vec![Probe::of_motion("tip", end(NamedPosition::End))],
            assemble: false,
            output: Output::default(),
        }
    }

    fn material(self) -> Material {
        let young = if self == Self::Spherical { YOUNG / 1000.0 } else { YOUNG };
        Material::elastic(DENSITY, young, 0.0)
    }

    /// Returns the units of the paper. The spherical pendulum has the same units (Table 3), although gravity acts twice.
    fn scales(self, n: u32) -> ScaleChoice {
        match self {
            Self::Cantilever | Self::Revolute => ScaleChoice::Paper,
            Self::Spherical => {
                let area = std::f64::consts::FRAC_PI_4 * DIAMETER * DIAMETER;
                let force = DENSITY * area * LENGTH * GRAVITY / f64::from(n);
                ScaleChoice::Given { length: LENGTH, force, time: None }
            }
        }
    }
}

/// Returns the area of the section, m².
pub fn area() -> f64 {
    PI * DIAMETER * DIAMETER / 4.0
}

/// Returns the second moment of area of the section, m⁴.
pub fn second_moment() -> f64 {
    PI * DIAMETER.powi(4) / 64.0
}
