use ancf_mechanics::bodies::BeamMesh;
use nalgebra::Vector3;

use super::context::LoadContext;
use crate::errors::{Finding, finding, number, quoted};
use crate::model::{At, Body, NamedPosition, ON_AXIS};

/// Part of a body's axis with a load per length that varies linearly.
#[derive(Clone, Copy, Debug)]
pub struct AxisPart<'a> {
    /// Name of the body.
    pub body: &'a str,
    /// Start of the part.
    pub from: &'a At,
    /// End of the part.
    pub to: &'a At,
    /// Load per length at the start and at the end.
    pub loads: [[f64; 3]; 2],
}

/// Arc lengths of a loaded part, with its load per length.
#[derive(Clone, Copy, Debug)]
pub(in crate::loads) struct LoadedSpan {
    pub(in crate::loads) ends: [f64; 2],
    pub(in crate::loads) loads: [Vector3<f64>; 2],
}

impl AxisPart<'_> {
    /// True if the part is the whole body.
    pub(in crate::loads) fn is_whole(&self) -> bool {
        *self.from == At::Named(NamedPosition::Start) && *self.to == At::Named(NamedPosition::End)
    }

    /// Checks that the part is on a flexible body and has a length.
    pub(in crate::loads) fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let Some((owner, body)) = context.body(self.body) else { return Vec::new() };
        if !body.is_flexible() {
            let found = format!("a load per length of {}, which has none", quoted(self.body));
            return vec![finding(format!("{path}.body"), found, "a beam or a cable").rests_on([owner])];
        }
        let length = body.length();
        if length <= 0.0 {
            return Vec::new(); // Another check reports it.
        }
        let rests_on = |keys: &[&str]| {
            let axis = ["from", "to", "shape"].map(|key| format!("{owner}.{key}"));
            axis.into_iter().chain(keys.iter().map(|key| format!("{path}.{key}"))).collect::<Vec<_>>()
        };
        let mut findings = Vec::new();
        let [from, to] = [self.from, self.to].map(|at| body.arc_length(at));
        let beyond = |s: f64| s > length * (1.0 + ON_AXIS);
        let expected = format!("at most {}, the length of {}", number(length), quoted(body.name()));
        for (key, s) in [("from", from), ("to", to)].into_iter().filter(|(_, s)| beyond(*s)) {
            let error = finding(format!("{path}.{key}"), number(s), expected.clone());
            findings.push(error.rests_on(rests_on(&["body"])));
        }
        if !beyond(from) && !beyond(to) && to - from <= length * ON_AXIS {
            let key = if matches!(self.to, At::Length(_)) { "to" } else { "from" };
            let found = format!("a load from {} to {}", number(from), number(to));
            let error = finding(format!("{path}.{key}"), found, "a part of the body that has a length");
            findings.push(error.rests_on(rests_on(&["body", "from", "to"])));
        }
        findings
    }

    /// Arc lengths of the part on its body.
    pub(in crate::loads) fn span(&self, body: &Body) -> LoadedSpan {
        LoadedSpan {
            ends: [self.from, self.to].map(|at| body.arc_length(at)),
            loads: self.loads.map(Vector3::from),
        }
    }
}

impl LoadedSpan {
    /// Fraction of the way from the start to the end at an arc length.
    pub(in crate::loads) fn fraction(&self, s: f64) -> f64 {
        let [from, to] = self.ends;
        (s - from) / (to - from)
    }

    /// Load per length at an arc length.
    fn load(&self, s: f64) -> Vector3<f64> {
        let [first, last] = self.loads;
        first + (last - first) * self.fraction(s)
    }

    /// Integration points: arc lengths with the load that each one stands for.
    pub(in crate::loads) fn points(&self, mesh: &BeamMesh) -> Vec<(f64, Vector3<f64>)> {
        let [from, to] = self.ends;
        let spans = mesh.element_spans(from..to);
        let points = spans.flat_map(|span| span.points());
        points.map(|(s, length)| (s, self.load(s) * length)).collect()
    }
}

/// Start of an axis, the default of `from`.
pub(in crate::loads) fn start() -> At {
    At::Named(NamedPosition::Start)
}

/// End of an axis, the default of `to`.
pub(in crate::loads) fn end() -> At {
    At::Named(NamedPosition::End)
}
