//! Choice of the units of the equations.

use nalgebra::Vector3;

use crate::model::Model;
use crate::units::{ChosenScales, ScaleChoice, Scales};

/// Quantities of a model from which its units are chosen.
struct ReferenceQuantities {
    name: String,
    length: f64,
    line_mass: f64,
    /// Unit of force without gravity, and its formula.
    force: f64,
    force_formula: &'static str,
}

impl Model {
    /// Chooses the units in which the equations of this model are solved.
    ///
    /// The model must be valid (see [`Model::check`]).
    pub fn scales(&self) -> ChosenScales {
        if self.scales == ScaleChoice::None {
            return ChosenScales { scales: Scales::UNIT, reason: "the user's own units".into() };
        }
        let ReferenceQuantities { name, length, line_mass, force, force_formula } =
            self.reference_quantities();
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
                format!("length L and {force_formula} of {name}, time by eq. (7), as powers of two"),
            ),
        };
        ChosenScales { scales, reason }
    }

    /// Quantities of the longest flexible body, or of the whole model if all bodies are rigid.
    fn reference_quantities(&self) -> ReferenceQuantities {
        let flexible = self.bodies.iter().filter(|body| body.is_flexible());
        if let Some(body) = flexible.max_by(|a, b| a.length().total_cmp(&b.length())) {
            let (length, (line_mass, bending)) = (body.length(), self.line_properties(body));
            let (name, force) = (format!("the longest body, `{}`", body.name()), bending / length.powi(2));
            return ReferenceQuantities { name, length, line_mass, force, force_formula: "E I/L2" };
        }
        let (length, mass) = (self.length(), self.mass());
        let shells = self.bodies.iter().filter_map(|body| Some((body, body.layup()?)));
        if let Some((shell, layup)) = shells.max_by(|(a, _), (b, _)| a.length().total_cmp(&b.length())) {
            let length = shell.length();
            let section = self.laminate(layup).section();
            return ReferenceQuantities {
                name: format!("the largest shell, `{}`", shell.name()),
                length,
                line_mass: section.density * shell.area() / length,
                force: section.bending[(0, 0)].max(section.bending[(1, 1)]) / length,
                force_formula: "D/L",
            };
        }
        // Without gravity the rate of a motion of rigid bodies is not known, but its duration.
        let duration = self.analysis.dynamics().map(|own| own.duration);
        ReferenceQuantities {
            name: "the whole model".into(),
            length,
            line_mass: mass / length,
            force: mass * length / duration.unwrap_or(1.0).powi(2),
            force_formula: if duration.is_some() {
                "mass times L by the squared duration"
            } else {
                "mass times L"
            },
        }
    }
}
