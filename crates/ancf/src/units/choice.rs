use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::scales::Scales;
use crate::model::{Body, Model, Place, PointMass, Rigid};

/// How the units of the equations are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum ScaleChoice {
    /// The user's own: the dimensional form.
    #[default]
    None,
    /// Of Kim et al. (2017): length of the beam, weight of one element, time by eq. (7). For one beam under gravity.
    Paper,
    /// The longest body's length L; the weight of that body, or E I/L² without gravity; time by eq. (7); each rounded to a
    /// power of two, so that nothing is lost on the way to these units and back.
    Auto,
    /// Given by number.
    Given {
        /// Unit of length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        length: f64,
        /// Unit of force.
        #[schemars(extend("exclusiveMinimum" = 0))]
        force: f64,
        /// Unit of time; by eq. (7) with the ρA of the longest body if left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        time: Option<f64>,
    },
}

/// The units chosen for a model, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// The units.
    pub scales: Scales,
    /// How they were chosen, in words.
    pub reason: String,
}

/// What the units of a model are taken from.
struct Largest {
    name: String,
    length: f64,
    line_mass: f64,
    /// The unit of force without gravity, and what it is.
    force: f64,
    of_force: &'static str,
}

impl Model {
    /// The units in which the equations of this model are to be solved.
    ///
    /// The model must be a valid one (see [`Model::check`]).
    pub fn scales(&self) -> Chosen {
        if self.scales == ScaleChoice::None {
            return Chosen { scales: Scales::UNIT, reason: "the user's own units".into() };
        }
        let Largest { name, length, line_mass, force, of_force } = self.largest();
        let weight = line_mass * length * Vector3::from(self.gravity).norm();
        let (scales, reason) = match self.scales {
            ScaleChoice::Given { length, force, time } => {
                let by_eq_7 = Scales::from_force(length, force, line_mass);
                (Scales { time: time.unwrap_or(by_eq_7.time), ..by_eq_7 }, "given".into())
            }
            ScaleChoice::Paper => (
                Scales::from_force(length, weight / f64::from(self.bodies[0].elements()), line_mass),
                format!("length of {name}, weight of one element, time by eq. (7)"),
            ),
            ScaleChoice::Auto | ScaleChoice::None if weight > 0.0 => (
                Scales::from_force(length, weight, line_mass).rounded(),
                format!("length and weight of {name}, time by eq. (7), as powers of two"),
            ),
            ScaleChoice::Auto | ScaleChoice::None => (
                Scales::from_force(length, force, line_mass).rounded(),
                format!("length L and {of_force} of {name}, time by eq. (7), as powers of two"),
            ),
        };
        Chosen { scales, reason }
    }

    /// The longest flexible body; of rigid ones only, all of them.
    fn largest(&self) -> Largest {
        let flexible = self.bodies.iter().filter(|body| body.is_flexible());
        if let Some(body) = flexible.max_by(|a, b| a.length().total_cmp(&b.length())) {
            let (length, (line_mass, bending)) = (body.length(), self.line(body));
            let (name, force) = (format!("the longest body, `{}`", body.name()), bending / length.powi(2));
            return Largest { name, length, line_mass, force, of_force: "E I/L2" };
        }
        let (length, mass) = (self.length(), self.mass());
        let name = "the whole model".into();
        Largest { name, length, line_mass: mass / length, force: mass * length, of_force: "mass times L" }
    }

    /// The mass of all bodies.
    pub fn mass(&self) -> f64 {
        let mass = |body: &Body| match body {
            Body::Rigid(Rigid { mass, .. }) | Body::Mass(PointMass { mass, .. }) => *mass,
            Body::Beam(_) | Body::Cable(_) => self.line(body).0 * body.length(),
        };
        self.bodies.iter().map(mass).sum()
    }

    /// The length of the longest body; of rigid ones only, the largest of their distances and radii of gyration.
    pub fn length(&self) -> f64 {
        let longest = self.bodies.iter().map(Body::length).fold(0.0, f64::max);
        if longest > 0.0 {
            return longest;
        }
        let centres = self.bodies.iter().map(|body| Vector3::from(body.span()[0]));
        let joints = self.joints.iter().filter_map(|joint| self.point(joint.ends().0));
        let points: Vec<Vector3<f64>> = centres.chain(joints).collect();
        let gyration = self.bodies.iter().filter_map(|body| match body {
            Body::Rigid(rigid) => Some((rigid.tensor().trace() / rigid.mass).sqrt()),
            _ => None,
        });
        let reach = points.iter().map(|point| (point - points[0]).norm()).chain(gyration).fold(0.0, f64::max);
        if reach > 0.0 { reach } else { 1.0 }
    }

    /// The point of a place in the reference state, if there is one.
    pub(crate) fn point(&self, place: &Place) -> Option<Vector3<f64>> {
        let body = self.bodies.iter().find(|body| body.name() == place.body)?;
        Some(body.point(place.at)? + Vector3::from(place.offset))
    }

    /// ρA and the smaller E I of a flexible body.
    fn line(&self, body: &Body) -> (f64, f64) {
        let Some((section, material)) = body.stuff() else { return (0.0, 0.0) };
        let (material, section) = (&self.materials[material], self.sections[section].moments());
        (material.density * section.area, material.young * section.yy.min(section.zz))
    }
}
