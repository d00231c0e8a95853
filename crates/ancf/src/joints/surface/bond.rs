use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bond_equations::add_equations;
use super::bond_feet::{Unfit, feet};
use crate::errors::{Finding, finding, quoted};
use crate::joints::parts::{End, JointBuilder, JointContext, JointKind};
use crate::model::{Body, Formulation, Place};
use crate::units::Scaled;

/// Bond of a beam or a cable to a shell along its whole length.
///
/// The beam is a stiffener in the middle surface or at a distance from it, with full composite action. Its sections rotate with the shell
/// about its axis, on a shear-deformable shell also across it.
///
/// The elements of a beam on a thin shell are no longer than those of the shell. The nodes of a beam on a shear-deformable shell are over
/// nodes of the mesh along a line of edges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Bond {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Beam or cable, on which the reaction acts. Its moment refers to this place.
    pub a: Place,
    /// Shell, at any of its places.
    pub b: End,
}

impl JointKind for Bond {
    fn word(&self) -> &'static str {
        "bond"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        6
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        add_equations(builder);
    }

    fn is_distributed(&self) -> bool {
        true
    }

    fn check(&self, path: &str, context: &dyn JointContext) -> Vec<Finding> {
        let End::Place(b) = &self.b else {
            let found = "an end that is not on a body";
            return vec![finding(format!("{path}.b"), found, "a place on a shell")];
        };
        let (Some(beam), Some(shell)) = (context.body(&self.a), context.body(b)) else { return Vec::new() };
        let mut findings = Vec::new();
        for (end, place) in [("a", &self.a), ("b", b)] {
            if place.offset != [0.0; 3] {
                let expected = "no arm: the whole beam is bonded, at its distance from the shell";
                findings.push(finding(format!("{path}.{end}.offset"), "an arm", expected));
            }
        }
        let mut is_no = |end: &str, body: &Body, what: &str, expected: &str| {
            let found = format!("{}, which is no {what}", quoted(body.name()));
            let error = finding(format!("{path}.{end}.body"), found, expected);
            findings.push(error.rests_on(["bodies".into()]));
        };
        if !matches!(beam, Body::Beam(_) | Body::Cable(_)) {
            is_no("a", beam, "beam", "a beam or a cable");
        }
        if !shell.is_shell() {
            is_no("b", shell, "shell", "a shell");
        }
        if !findings.is_empty() || beam.elements() == 0 || shell.elements() == 0 || beam.curve().is_none() {
            return findings;
        }
        if let Body::Beam(data) = beam
            && data.formulation == Formulation::Quadratic
        {
            let found = format!("{} of the formulation \"quadratic\"", quoted(beam.name()));
            let expected = "a cable or a beam of two-node elements, whose tangent is continuous";
            return vec![finding(format!("{path}.a.body"), found, expected).rests_on(["bodies".into()])];
        }
        if shell.shear_shell().is_some_and(|shell| shell.defect().is_some()) {
            return findings;
        }
        let error = feet(beam, shell).err().map(|Unfit { found, expected }| {
            finding(path.to_owned(), found, expected).rests_on(["bodies".into()])
        });
        error.into_iter().collect()
    }
}
