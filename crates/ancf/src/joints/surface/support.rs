use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::condition::{SupportCondition, SupportedAxis};
use super::edge_equations::add_equations;
use super::mesh_equations::{self, MeshSupport};
use crate::errors::{Finding, finding, quoted};
use crate::joints::parts::{End, JointBuilder, JointContext, JointKind};
use crate::model::{At, Body, EdgeName, Place, ShearShell};
use crate::units::Scaled;

/// Support of an edge or of a node of a shell by the ground, or of an edge by a rigid body.
///
/// The normal of a thin shell rotates about an edge by the slope across it. The director of a shear-deformable shell is constrained
/// itself. Stretches and thickness stay free.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Edge or node of a shell, on which the reaction acts. Moments of the reaction of an edge refer to its middle.
    pub a: Place,
    /// Rigid body with which the edge moves, at any of its places; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Constrained motions.
    pub condition: SupportCondition,
    /// Global axes along which displacements are zero, for `condition = "guided"`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub axes: Vec<SupportedAxis>,
    /// True for a hard support of an edge of a shear-deformable shell: directors do not rotate along it. For `"hinged"` and `"guided"`.
    #[serde(default, skip_serializing_if = "is_soft")]
    pub hard: bool,
}

const fn is_soft(hard: &bool) -> bool {
    !*hard
}

impl JointKind for Support {
    fn word(&self) -> &'static str {
        "support"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        match (self.condition, &self.a.at) {
            (SupportCondition::Clamped, _) => 6,
            (SupportCondition::Hinged, At::Edge(_)) => 5,
            (SupportCondition::Hinged | SupportCondition::Symmetry, _) => 3,
            (SupportCondition::Guided, _) => self.axes.len(),
        }
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        if builder.shear_shell().is_some() {
            let Self { a, condition, axes, hard, .. } = self;
            let support = MeshSupport { at: &a.at, condition: *condition, axes, hard: *hard };
            return mesh_equations::add_equations(builder, support);
        }
        add_equations(builder, &self.a.at, self.condition, &self.axes);
    }

    fn is_distributed(&self) -> bool {
        true
    }

    fn check(&self, path: &str, context: &dyn JointContext) -> Vec<Finding> {
        let Some(body) = context.body(&self.a) else { return Vec::new() };
        if let Body::ShearShell(shell) = body {
            return self.check_mesh(path, shell, context);
        }
        let Body::Shell(shell) = body else {
            let found = format!("{}, which is no shell", quoted(body.name()));
            let expected = "a shell; joints such as \"clamp\" support other bodies";
            return vec![finding(format!("{path}.a.body"), found, expected).rests_on(["bodies".into()])];
        };
        if self.a.offset != [0.0; 3] {
            return vec![finding(
                format!("{path}.a.offset"),
                "an arm",
                "no arm: edges and nodes are supported",
            )];
        }
        if self.hard {
            let expected = "no key `hard`: only edges of shear-deformable shells have it";
            return vec![finding(format!("{path}.hard"), "true", expected)];
        }
        let is_edge = matches!(self.a.at, At::Edge(_));
        if let End::Place(b) = &self.b {
            return self.check_body(path, b, is_edge, context);
        }
        let needs_edge = matches!(self.condition, SupportCondition::Clamped | SupportCondition::Symmetry);
        if needs_edge && !is_edge {
            let expected =
                "an edge, such as { edge = \"u_start\" }; at a node `condition` is \"hinged\" or \"guided\"";
            return vec![finding(format!("{path}.a.at"), "a point", expected)];
        }
        if let Some(error) = self.rule_of_axes(path) {
            return vec![error];
        }
        let At::Edge(place) = &self.a.at else { return Vec::new() };
        if matches!(place.edge, EdgeName::Named(_)) {
            return Vec::new();
        }
        let is_unfit = self.condition == SupportCondition::Symmetry && !shell.is_plane_edge(&place.edge);
        let unfit = is_unfit.then(|| {
            let found = "an edge that the lines across it do not meet at right angles in one plane";
            let expected =
                "\"clamped\", \"hinged\" or \"guided\", or a surface whose edge is in a plane of symmetry";
            finding(format!("{path}.condition"), found, expected).rests_on(["bodies".into()])
        });
        unfit.into_iter().collect()
    }
}

impl Support {
    /// Checks that axes are given if and only if they are used.
    fn rule_of_axes(&self, path: &str) -> Option<Finding> {
        let is_guided = self.condition == SupportCondition::Guided;
        if is_guided == self.axes.is_empty() {
            let [found, expected] = match is_guided {
                true => ["no axes", "axes such as [\"x\", \"y\"]"],
                false => ["axes", "no key `axes` unless `condition` is \"guided\""],
            };
            return Some(finding(format!("{path}.axes"), found, expected));
        }
        (1..self.axes.len())
            .any(|k| self.axes[..k].contains(&self.axes[k]))
            .then(|| finding(format!("{path}.axes"), "an axis a second time", "each axis once"))
    }

    /// Checks a support of a shear-deformable shell.
    fn check_mesh(&self, path: &str, shell: &ShearShell, context: &dyn JointContext) -> Vec<Finding> {
        if self.a.offset != [0.0; 3] {
            let expected = "no arm: edges and nodes are supported";
            return vec![finding(format!("{path}.a.offset"), "an arm", expected)];
        }
        if shell.place(&self.a.at).is_none() || shell.defect().is_some() {
            // The place and the mesh have findings of their own.
            return Vec::new();
        }
        let is_edge = matches!(self.a.at, At::Edge(_));
        if !is_edge && shell.node(&self.a.at).is_none() {
            let expected = "a node, such as { node = 0 }, a named point or an edge";
            return vec![finding(format!("{path}.a.at"), "a point of the surface", expected)];
        }
        if let End::Place(b) = &self.b {
            return self.check_body(path, b, true, context);
        }
        if let Some(error) = self.rule_of_axes(path) {
            return vec![error];
        }
        let unused = matches!(self.condition, SupportCondition::Clamped | SupportCondition::Symmetry);
        if self.hard && (unused || !is_edge) {
            let expected = "no key `hard` unless an edge is \"hinged\" or \"guided\"";
            return vec![finding(format!("{path}.hard"), "true", expected)];
        }
        if self.condition != SupportCondition::Symmetry {
            return Vec::new();
        }
        if !is_edge {
            return vec![finding(format!("{path}.a.at"), "a point", "an edge in a plane of symmetry")];
        }
        let is_unfit = shell.plane_of(&self.a.at).is_none();
        let unfit = is_unfit.then(|| {
            let found = "an edge that is not in a plane with the directors of its nodes";
            let expected = "\"clamped\", \"hinged\" or \"guided\", or an edge in a plane of symmetry; \
                            `directors` of the shell may be given";
            finding(format!("{path}.condition"), found, expected).rests_on(["bodies".into()])
        });
        unfit.into_iter().collect()
    }

    /// Checks a support by a body.
    fn check_body(&self, path: &str, b: &Place, is_edge: bool, context: &dyn JointContext) -> Vec<Finding> {
        let mut findings = Vec::new();
        if let Some(body) = context.body(b)
            && !matches!(body, Body::Rigid(_))
        {
            let found = format!("{}, which is not a rigid body", quoted(body.name()));
            let expected = "a rigid body or \"ground\"; joints of kind \"seam\" connect two shells";
            findings.push(finding(format!("{path}.b.body"), found, expected).rests_on(["bodies".into()]));
        }
        if !is_edge {
            let expected = "an edge, such as { edge = \"u_start\" }; joints such as \"spherical\" connect nodes to bodies";
            findings.push(finding(format!("{path}.a.at"), "a point of a shell on a rigid body", expected));
        }
        if !matches!(self.condition, SupportCondition::Clamped | SupportCondition::Hinged) {
            let expected = "\"clamped\" or \"hinged\" for an edge on a rigid body";
            findings.push(finding(format!("{path}.condition"), "a support by the ground", expected));
        }
        if !self.axes.is_empty() {
            let expected = "no key `axes` unless `condition` is \"guided\"";
            findings.push(finding(format!("{path}.axes"), "axes", expected));
        }
        findings
    }
}
