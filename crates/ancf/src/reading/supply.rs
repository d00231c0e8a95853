//! External functions of a model, which the program supplies by name.

use ancf_mechanics::functions::{ExternalFunction, ForceFunction};
use ancf_mechanics::laws::UserForceLaw;

use crate::model::{JointLaw, Load, Model, TimeFunction, Varying};

impl Model {
    /// Supplies an external function of time by its name; returns true if the model uses it.
    ///
    /// Example: a motor that a program controls.
    ///
    ///
    /// ```
    /// use ancf::mechanics::functions::{ExternalFunction, FunctionValue};
    /// use ancf::record::Series;
    /// use ancf::{Model, simulate};
    ///
    /// let mut model = Model::parse(
    ///     r#"
    ///     bodies = [{ kind = "rigid", name = "rotor", center = [0, 0, 0], mass = 2, inertia = [0.1, 0.1, 0.2] }]
    ///
    ///     [[joints]]
    ///     kind = "revolute"
    ///     name = "shaft"
    ///     a = { body = "rotor", at = "center" }
    ///     axis = [0, 0, 1]
    ///     drive = { angle = 0.5, time = { kind = "external", name = "motor" } }
    ///
    ///     [analysis]
    ///     kind = "dynamics"
    ///     duration = 1
    ///     step = 1e-2
    ///     scheme = { spectral_radius = 0.8 }
    ///     "#,
    /// )?;
    /// let motor = |t: f64| FunctionValue { value: t * t, rate: 2.0 * t, acceleration: 2.0 };
    /// assert!(model.supply("motor", ExternalFunction::new(motor)));
    /// let mut series = Series::new();
    /// simulate(&model, &mut series)?;
    /// let angle = series.column("shaft.angle").and_then(|angle| angle.last()).ok_or("no angle")?;
    /// assert!((angle - 0.5).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn supply(&mut self, name: &str, function: ExternalFunction) -> bool {
        let mut is_used = false;
        for time in self.time_functions_mut() {
            if let TimeFunction::Varying(Varying::External { name: own, supplied, .. }) = time
                && own == name
            {
                (*supplied, is_used) = (Some(function.clone()), true);
            }
        }
        is_used
    }

    /// Supplies an external force by its name; returns true if the model uses it.
    ///
    /// Example: a spring between a mass and the origin. The period of vibration is one unit of time.
    ///
    /// ```
    /// use ancf::mechanics::functions::ForceFunction;
    /// use ancf::record::Series;
    /// use ancf::{Model, simulate};
    ///
    /// let mut model = Model::parse(
    ///     r#"
    ///     gravity = [0, 0, -10]
    ///     bodies = [{ kind = "mass", name = "bob", center = [0, 0, -1], mass = 2 }]
    ///     loads = [{ kind = "external", name = "spring", on = { body = "bob", at = "center" } }]
    ///     probes = [{ name = "bob", on = { body = "bob", at = "center" } }]
    ///     analysis = { kind = "dynamics", duration = 1, step = 1e-3, scheme = "average_acceleration" }
    ///     "#,
    /// )?;
    /// let stiffness = 2.0 * std::f64::consts::TAU.powi(2);
    /// let spring = move |_t: f64, x: [f64; 3], _v: [f64; 3]| x.map(|x| -stiffness * x);
    /// assert!(model.supply_force("spring", ForceFunction::new(spring)));
    /// let mut series = Series::new();
    /// simulate(&model, &mut series)?;
    /// let z = series.column("bob.z").and_then(|z| z.last()).ok_or("no such column")?;
    /// assert!((z - -1.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn supply_force(&mut self, name: &str, function: ForceFunction) -> bool {
        let mut is_used = false;
        for load in &mut self.loads {
            if let Load::External(external) = load
                && external.name == name
            {
                (external.supplied, is_used) = (Some(function.clone()), true);
            }
        }
        is_used
    }

    /// Supplies an external force law of joints by its name; returns true if the model uses it.
    ///
    /// The key `autonomous` of the law in the model decides whether the force has an energy.
    ///
    /// Example: a hardening spring, with derivatives by dual numbers.
    ///
    /// ```
    /// use ancf::mechanics::laws::{LawNumber, UserForceLaw};
    /// use ancf::record::Series;
    /// use ancf::{Model, simulate};
    ///
    /// let mut model = Model::parse(
    ///     r#"
    ///     bodies = [{ kind = "mass", name = "bob", center = [1.5, 0, 0], mass = 2 }]
    ///
    ///     [[joints]]
    ///     kind = "spring"
    ///     name = "spring"
    ///     a = { body = "bob", at = "center" }
    ///     b = { point = [0, 0, 0] }
    ///     length = 1
    ///     tension = { kind = "external", name = "hardening", autonomous = true }
    ///
    ///     [analysis]
    ///     kind = "dynamics"
    ///     duration = 1
    ///     step = 1e-3
    ///     "#,
    /// )?;
    /// let law = |_t: f64, x: LawNumber, _v: LawNumber| x * 10.0 + x * x * x * 40.0;
    /// assert!(model.supply_law("hardening", UserForceLaw::by_dual_numbers(law, true)));
    /// let mut series = Series::new();
    /// simulate(&model, &mut series)?;
    /// let speed = series.column("spring.speed").ok_or("no such column")?;
    /// let fastest = speed.iter().copied().fold(0.0, f64::min);
    /// assert!((fastest + (2.0 * (5.0 * 0.25 + 10.0 * 0.0625) / 2.0_f64).sqrt()).abs() < 1e-3); // ½ m v² = U(0.5)
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn supply_law(&mut self, name: &str, law: UserForceLaw) -> bool {
        let mut is_used = false;
        for own in self.joints.iter_mut().flat_map(|joint| joint.kind_mut().laws_mut()) {
            if let JointLaw::External { name: own, supplied, .. } = own
                && own == name
            {
                (*supplied, is_used) = (Some(law.clone()), true);
            }
        }
        is_used
    }
}
