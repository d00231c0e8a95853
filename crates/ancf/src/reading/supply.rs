//! Functions that the program supplies to a model, by the names under which the model asks for them.

use ancf_mechanics::functions::{External, ForceFunction};

use crate::checking::{joints_of, loads_of};
use crate::model::{Joint, Load, Model, ModelError, ModelErrors, TimeFunction, Varying};
use crate::schema::quoted;

impl Model {
    /// Supplies a function of time wherever the model asks for one of this name; returns whether it does anywhere.
    ///
    /// A motor that a program controls:
    ///
    /// ```
    /// use ancf::function::{External, Instant};
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
    /// let motor = |t: f64| Instant { value: t * t, rate: 2.0 * t, acceleration: 2.0 };
    /// assert!(model.supply("motor", External::new(motor)));
    /// let mut series = Series::new();
    /// simulate(&model, &mut series)?;
    /// let angle = series.column("shaft.angle").and_then(|angle| angle.last()).ok_or("no angle")?;
    /// assert!((angle - 0.5).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn supply(&mut self, name: &str, function: External) -> bool {
        let mut asked = false;
        for time in self.time_functions_mut() {
            if let TimeFunction::Varying(Varying::External { name: own, supplied, .. }) = time
                && own == name
            {
                (*supplied, asked) = (Some(function.clone()), true);
            }
        }
        asked
    }

    /// Supplies a force wherever the model asks for one of this name; returns whether it does anywhere.
    ///
    /// A spring that holds a mass to the origin, with which it swings once in a unit of time:
    ///
    /// ```
    /// use ancf::function::ForceFunction;
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
        let mut asked = false;
        for load in &mut self.loads {
            if let Load::External { name: own, supplied, .. } = load
                && own == name
            {
                (*supplied, asked) = (Some(function.clone()), true);
            }
        }
        asked
    }

    /// Checks that the program has supplied all functions that the model asks for.
    ///
    /// # Errors
    /// Each place that waits for one.
    pub fn check_supplies(&self) -> Result<(), ModelErrors> {
        let missing = |path: String, what: &str, name: &str| {
            let found = format!("the external {what} {}", quoted(name));
            ModelError::new(
                format!("{path}.name"),
                found,
                "a function that the program supplies under this name",
            )
        };
        let times = self.time_functions().into_iter().filter_map(|(path, time)| match time {
            TimeFunction::Varying(Varying::External { name, supplied: None, .. }) => {
                Some(missing(path, "function", name))
            }
            _ => None,
        });
        let forces = loads_of(self).filter_map(|(path, load)| match load {
            Load::External { name, supplied: None, .. } => Some(missing(path, "force", name)),
            _ => None,
        });
        let errors: Vec<ModelError> = times.chain(forces).collect();
        if errors.is_empty() { Ok(()) } else { Err(ModelErrors(errors)) }
    }

    /// Whether there are functions of time for the program to supply that are supplied already, or are not yet.
    pub(crate) fn has_functions(&self, already: bool) -> bool {
        let is_one = |time: &TimeFunction| match time {
            TimeFunction::Varying(Varying::External { supplied, .. }) => supplied.is_some() == already,
            _ => false,
        };
        self.time_functions().iter().any(|(_, time)| is_one(time))
    }

    /// All functions of time with their paths.
    pub(crate) fn time_functions(&self) -> Vec<(String, &TimeFunction)> {
        let of_loads =
            loads_of(self).filter_map(|(path, load)| load.time().map(|time| (format!("{path}.time"), time)));
        let of_joints = joints_of(self).flat_map(|(path, joint)| {
            let times = joint.times().into_iter();
            times.map(|(table, time)| (format!("{path}{table}.time"), time)).collect::<Vec<_>>()
        });
        of_loads.chain(of_joints).collect()
    }

    /// The same, to be changed.
    fn time_functions_mut(&mut self) -> impl Iterator<Item = &mut TimeFunction> {
        let of_loads = self.loads.iter_mut().filter_map(Load::time_mut);
        of_loads.chain(self.joints.iter_mut().flat_map(Joint::times_mut))
    }
}
