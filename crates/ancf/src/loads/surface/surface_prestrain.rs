use ancf_mechanics::functions::Function;
use ancf_mechanics::shells::SurfacePrestrain as MeshPrestrain;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::{Finding, finding, number};
use crate::loads::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::model::{Body, MembraneKind, TimeFunction, axis_on_shell, region_of_shell, shell_body};
use crate::units::Scaled;

/// Change of the stress-free shape of a shell: heating, swelling, pretension, natural curvature.
///
/// Components are (11, 22, 2·12) of strains and curvatures and (11, 22, 12) of forces, in the frame of stresses or that of `axis`.
/// Strains, tensions and curvatures of all loads of a shell add up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct SurfacePrestrain {
    /// Name of the shell.
    pub body: String,
    /// Elongations and shear without stress: [0.01, 0.01, 0] enlarges a free shell by 1 %, [αΔT, αΔT, 0] is that of a warmer shell.
    #[serde(default)]
    #[unit(number)]
    #[schemars(inner(range(min = -0.5, max = 1.0)))]
    pub strain: [f64; 3],
    /// Membrane forces in the reference shape, positive in tension; force/length.
    #[serde(default)]
    #[unit(force / length)]
    pub tension: [f64; 3],
    /// Curvatures without stress, in addition to those of the reference shape, positive if the side of the normal is longer; radians/length.
    #[serde(default)]
    #[unit(radian / length)]
    pub curvature: [f64; 3],
    /// Axis whose projection on the surface is the direction 1; that of the stresses by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(number)]
    pub axis: Option<[f64; 3]>,
    /// Name of a group of elements of a shear-deformable shell; the whole shell by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// Function of time that multiplies strains, tensions and curvatures. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for SurfacePrestrain {
    fn noun(&self) -> &'static str {
        "prestrain of a shell"
    }

    /// Adds nothing: prescribed strains are part of the elements (the `source` method).
    fn build(&self, _builder: &mut LoadBuilder<'_>) {}

    fn bodies(&self) -> Vec<(String, &str)> {
        vec![("body".into(), &self.body)]
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        Some(&mut self.time)
    }

    /// Viscous stresses depend on the rate.
    fn uses_rates(&self) -> bool {
        true
    }

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let body = || context.body(&self.body);
        if let Some(error) = shell_body(path, body()) {
            return vec![error];
        }
        let region = region_of_shell(path, self.region.as_deref(), body());
        let axis = self.axis.and_then(|axis| axis_on_shell(format!("{path}.axis"), axis, body()));
        let tension = self.check_tension(path, context).or_else(|| self.check_law(path, context));
        region.into_iter().chain(axis).chain(tension).collect()
    }
}

/// Largest tension, relative to E h.
const LARGEST: f64 = 0.25;
/// Relative error of a principal force of zero.
const ROUNDING: f64 = 1e-12;

impl SurfacePrestrain {
    /// Prescribed strains of the elements of a shell.
    pub(crate) fn source(&self, body: &Body, function: Function) -> MeshPrestrain {
        let region = match body {
            Body::ShearShell(shell) if self.region.is_some() => shell.region(self.region.as_deref()),
            _ => None,
        };
        MeshPrestrain {
            strain: Vector3::from(self.strain),
            curvature: Vector3::from(self.curvature),
            tension: Vector3::from(self.tension),
            axis: self.axis.map(Vector3::from),
            elements: region,
            function,
        }
    }

    /// Checks that the law of the membrane has the forces of the tension in the reference shape.
    fn check_law(&self, path: &str, context: &dyn LoadContext) -> Option<Finding> {
        let (owner, body) = context.body(&self.body)?;
        let membrane = body.membrane()?;
        let [n11, n22, n12] = self.tension;
        let [mean, radius] = [0.5 * (n11 + n22), (0.5 * (n11 - n22)).hypot(n12)];
        let least = mean - radius;
        let (found, expected) = if self.tension == [0.0; 3] {
            return None;
        } else if membrane.law == MembraneKind::NeoHookean {
            let expected = "`strain`: a neo-Hookean membrane at the stretch λ has the strain 1/λ − 1";
            ("a tension of a neo-Hookean membrane".into(), expected)
        } else if membrane.tension_field && least < -ROUNDING * radius {
            let expected = "principal forces of zero or more: a tension field has no compressive forces";
            (format!("the principal force {}", number(least)), expected)
        } else {
            return None;
        };
        Some(finding(format!("{path}.tension"), found, expected).rests_on([format!("{owner}.membrane")]))
    }

    /// Checks that the strain of the tension is small.
    fn check_tension(&self, path: &str, context: &dyn LoadContext) -> Option<Finding> {
        let (owner, body) = context.body(&self.body)?;
        let layup = body.layup()?;
        let rigidity = |(name, thickness, _): (&str, f64, f64)| {
            let material = context.material(name)?;
            let transverse = material.orthotropic.map_or(material.young, |orthotropic| orthotropic.young);
            Some(material.young.min(transverse) * thickness)
        };
        // Of the thinnest place of a thickness that varies.
        let part = body.field_shell()?.thickness_range().least / layup.thickness;
        let rigidity = part * layup.plies().into_iter().map(rigidity).sum::<Option<f64>>()?;
        let largest = self.tension.iter().fold(0.0, |largest: f64, n| largest.max(n.abs()));
        (largest > LARGEST * rigidity).then(|| {
            let found = format!("{} times E h", number(largest / rigidity));
            let expected = format!("at most {} times E h = {}", number(LARGEST), number(rigidity));
            let rests_on = [format!("{owner}.thickness"), "materials".into()];
            finding(format!("{path}.tension"), found, expected).rests_on(rests_on)
        })
    }
}
