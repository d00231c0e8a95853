use crate::problems::models::{Rod, clamp, end_probe, tip_load};
use crate::{Findings, Mark, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Frame in other units, at other places, in another order.
pub const PROBLEM: Problem = Problem {
    name: "invariance",
    title: "One frame in other units, translated, rotated, in reverse order",
    source: "Invariance under change of units and of the observer; reference: the frame in m, kg, s at the origin",
    sketch: r"
                    | P        two legs of 1 m, d = 20 mm, E = 2 GPa,
  |/|===============+          P in space, P L²/EI about 1
                     \\
                      \\",
    goal: "Statics, path and modes of the loaded frame: displacements and frequencies within 1e-9, the same number of \
               steps and \
           iterations. The units are mm, t, s; the translation is one kilometre; all without `scales`",
    run,
};

type Vector = [f64; 3];

/// Statement of the frame.
#[derive(Clone, Copy)]
struct Statement {
    name: &'static str,
    /// Metre and kilogram in the units of the statement. The unit of time is the second.
    metre: f64,
    kilogram: f64,
    /// Translation, in metres.
    translation: Vector,
    /// True if the frame is rotated.
    rotated: bool,
    /// True if bodies and joints are in reverse order.
    reversed: bool,
}

const PLAIN: Statement = Statement {
    name: "m, kg, s",
    metre: 1.0,
    kilogram: 1.0,
    translation: [0.0; 3],
    rotated: false,
    reversed: false,
};

const OTHERS: [Statement; 4] = [
    Statement { name: "mm, t, s", metre: 1e3, kilogram: 1e-3, ..PLAIN },
    Statement { name: "a kilometre away", translation: [600.0, 0.0, 800.0], ..PLAIN },
    Statement { name: "turned", rotated: true, ..PLAIN },
    Statement { name: "in reverse order", reversed: true, ..PLAIN },
];

/// Rotation matrix.
const ROTATION: [Vector; 3] = [
    [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0],
    [2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0],
    [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0],
];

impl Statement {
    fn rotate(&self, v: Vector) -> Vector {
        if self.rotated { ROTATION.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum()) } else { v }
    }

    fn rotate_back(&self, v: Vector) -> Vector {
        let column = |j: usize| ROTATION.iter().zip(v).map(|(row, x)| row[j] * x).sum();
        if self.rotated { [0, 1, 2].map(column) } else { v }
    }

    fn point(&self, v: Vector) -> Vector {
        let [x, y, z] = self.rotate(v);
        let [a, b, c] = self.translation;
        [x + a, y + b, z + c].map(|x| x * self.metre)
    }

    /// Returns the displacement of the tip in metres, rotated back.
    fn displacement(&self, solved: &SolvedModel) -> Result<Vector, VerificationError> {
        let [x, y, z] = [solved.last("tip.x")?, solved.last("tip.y")?, solved.last("tip.z")?];
        let [a, b, c] = self.point(TIP);
        Ok(self.rotate_back([x - a, y - b, z - c]).map(|x| x / self.metre))
    }

    fn leg(&self, name: &str, formulation: &str, [from, to]: [Vector; 2]) -> String {
        let up = self.rotate([0.0, 1.0, 0.0]);
        let [from, to] = [from, to].map(|v| self.point(v));
        Rod { name, element: formulation, from, to, elements: 4, keys: &format!("up = {up:?}") }.to_string()
    }

    fn model(&self, analysis: &str) -> String {
        let Self { metre, kilogram, .. } = self;
        let [density, young] = [1200.0 * kilogram / metre.powi(3), 2e9 * kilogram / metre];
        let diameter = 0.02 * metre;
        let force = self.rotate([6.0, -9.0, 12.0]).map(|f| f * kilogram * metre);
        let mut bodies =
            [self.leg("first", "linked", [[0.0; 3], ELBOW]), self.leg("second", "continuum", [ELBOW, TIP])];
        let mut joints = [
            clamp("root", "first", "\"ground\""),
            clamp("elbow", "second", "{ body = \"first\", at = \"end\" }"),
        ];
        if self.reversed {
            bodies.reverse();
            joints.reverse();
        }
        format!(
            r#"
            materials.material = {{ density = {density}, young = {young} }}
            sections.section = {{ kind = "circle", diameter = {diameter} }}
            {}{}{}{}
            [analysis]
            {analysis}
            "#,
            bodies.concat(),
            joints.concat(),
            tip_load("second", force),
            end_probe("tip", "second")
        )
    }
}

const ELBOW: Vector = [1.0, 0.0, 0.0];
const TIP: Vector = [1.0, 0.0, 1.0];

const MODES: &str = "kind = \"modes\"\ncount = 4\nabout = \"equilibrium\"";

/// Compares tip displacement, steps and iterations of statics or a path with those of the plain frame.
fn compare(
    findings: &mut Findings,
    kind: &str,
    statement: Statement,
) -> Result<Vec<[f64; 2]>, VerificationError> {
    let analysis = format!("kind = \"{kind}\"\nfirst = 0.1");
    let [plain, other] = [solve(&PLAIN.model(&analysis))?, solve(&statement.model(&analysis))?];
    let [references, ours] = [PLAIN.displacement(&plain)?, statement.displacement(&other)?];
    for ((axis, ours), reference) in ["x", "y", "z"].into_iter().zip(ours).zip(references) {
        findings.compare(format!("u{axis} in m, {kind}, {}", statement.name), ours, reference, 1.0, 1e-9);
    }
    let counts = |solved: &SolvedModel| [solved.summary.steps as f64, solved.summary.iterations as f64];
    for ((what, ours), reference) in
        ["steps", "iterations"].into_iter().zip(counts(&other)).zip(counts(&plain))
    {
        findings.compare(format!("{what}, {kind}, {}", statement.name), ours, reference, 1.0, 0.0);
    }
    plain.points("tip.y", "tip.z")
}

fn frequencies(findings: &mut Findings, statement: Statement) -> Result<(), VerificationError> {
    let [plain, other] = [solve(&PLAIN.model(MODES))?, solve(&statement.model(MODES))?];
    let pairs = other.column("frequency")?.iter().zip(plain.column("frequency")?);
    for (mode, (&ours, &reference)) in (1..).zip(pairs) {
        let what = format!("frequency {mode} in 1/s, {}", statement.name);
        findings.compare(what, ours, reference, reference, 1e-9);
    }
    Ok(())
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for statement in OTHERS {
        frequencies(&mut findings, statement)?;
    }
    for (kind, mark) in [("statics", Mark::Points), ("path", Mark::Line)] {
        let mut points = Vec::new();
        for statement in OTHERS {
            points = compare(&mut findings, kind, statement)?;
        }
        curves.push(PlotCurve { name: kind.into(), mark, points });
    }
    findings.plot(
        Plot::new("Path of the tip with increasing load", ["y in m", "z in m"], curves).with_equal_scales(),
    );
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
