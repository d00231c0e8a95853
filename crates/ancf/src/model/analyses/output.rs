use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::bodies::Place;
use crate::units::Scaled;

/// Place where motion, section forces, strain or stress are recorded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name in the outputs. The columns are `name.x`, `name.vx`, `name.ax` and so on.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Place on the axis.
    pub on: Place,
    /// Coordinates (y, z) of the point in the section, length; on the axis by default.
    #[serde(default)]
    #[unit(length)]
    pub offset: [f64; 2],
    /// Recorded quantities; the motion by default.
    #[serde(default = "Probe::motion")]
    #[schemars(length(min = 1))]
    pub record: Vec<Quantity>,
}

impl Probe {
    /// Probe of the motion of a point on the axis.
    pub fn of_motion(name: &str, on: Place) -> Self {
        Self { name: name.into(), on, offset: [0.0; 2], record: Self::motion() }
    }

    fn motion() -> Vec<Quantity> {
        vec![Quantity::Motion]
    }
}

/// Quantity that a probe records.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Position, velocity and acceleration of the point.
    Motion,
    /// Euler parameters of the rotation of the section or the rigid body, `e0`, `e1`, `e2`, `e3`. Angular velocity in the
    /// global frame, `wx`, `wy`, `wz`.
    Rotation,
    /// Axial force, shear forces, torque and bending moments in the frame of the section: `N`, `Qy`, `Qz`, `T`, `My`, `Mz`.
    /// The part beyond the section exerts them on the part before.
    SectionForces,
    /// Green-Lagrange strain at the point in the frame of the section: `exx`, `eyy`, `ezz`, `exy`, `exz`, `eyz`.
    Strain,
    /// Second Piola-Kirchhoff stress at the point: `sxx` and so on.
    Stress,
    /// Readings of an inertial sensor at the point, along axes that turn with the section or the rigid body and are the global ones in
    /// the undeformed state: acceleration less gravity, `imu_ax`, `imu_ay`, `imu_az`, and angular velocity, `imu_wx`, `imu_wy`, `imu_wz`.
    InertialSensor,
    /// Membrane forces and moments per length of a shell: `nuu`, `nvv`, `nuv`, `muu`, `mvv`, `muv`. Components are those in the
    /// orthonormal frame of the undeformed surface: u along ∂r/∂u, v normal to it. Moments are positive for tension at the top, the side of the normal.
    Resultants,
    /// Second Piola-Kirchhoff stress of a shell at the top, in the middle and at the bottom, in the same frame: `suu_top`, `svv_top`,
    /// `suv_top`, `suu_middle` and so on. The largest equivalent stress of both faces, `von_mises`.
    SurfaceStress,
}

/// Content and frequency of the output.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Interval of recorded instants, time. A step ends at each of them. Every step is recorded by default.
    #[unit(time)]
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub interval: Option<f64>,
    /// Recording of every n-th instant or load factor only. The first and the last one are always recorded, and all modes,
    /// critical loads and points of paths.
    #[schemars(range(min = 1))]
    pub every: u32,
    /// True to record the parts of the strain energy of each body.
    pub energy_parts: bool,
    /// True to record the mass center, the linear and angular momentum about the origin, the kinetic and the strain energy of
    /// each body, and the first three of the model.
    pub momentum: bool,
    /// True to record the power of each joint and load on the bodies, in dynamics.
    pub power: bool,
    /// True to estimate the errors of the recorded values in each state, columns `p.x_error` and so on: exact less computed. In
    /// dynamics those of the time steps and of the mesh, where the run takes two to three times as long. In statics those of the
    /// mesh. With shells those of the mesh, also of undamped modes and buckling, follow from a second solution with four times the elements.
    pub errors: bool,
    /// True to write `probes.csv`.
    pub csv: bool,
    /// True to write `results.parquet`.
    pub parquet: bool,
    /// Approximate number of states stored for figures and reports, evenly spaced in time. The first and the last state are
    /// always stored. All equilibria, modes and critical loads are stored, unless 0.
    pub states: u32,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            interval: None,
            every: 1,
            energy_parts: false,
            momentum: false,
            power: false,
            errors: false,
            csv: true,
            parquet: true,
            states: 200,
        }
    }
}
