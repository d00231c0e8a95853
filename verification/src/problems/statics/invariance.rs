use crate::{Curve, Error, Findings, Mark, Plot, Problem, Solved, solve};

/// One frame in other units, at other places, in other order.
pub const PROBLEM: Problem = Problem {
    name: "invariance",
    title: "The same frame in other units, elsewhere, turned, written in reverse order",
    source: "Invariance under change of units and of the observer; each is compared with the frame in m, kg, s at the origin",
    sketch: r"
                    | P        two legs of 1 m, d = 20 mm, E = 2 GPa,
  |/|===============+          P in space, P L²/EI about 1
                     \\
                      \\",
    goal: "Statics, path and modes of the loaded frame: displacements and frequencies within 1e-9, the same number of steps and \
           iterations. The units are mm, t, s; the other place is a kilometre away; all without `scales`",
    run,
};

type Vector = [f64; 3];

/// How the frame is stated.
#[derive(Clone, Copy)]
struct Stated {
    name: &'static str,
    /// A metre and a kilogram in its units; the second is a second.
    metre: f64,
    kilogram: f64,
    /// Where the origin goes, in metres.
    place: Vector,
    /// Whether it is turned.
    turned: bool,
    /// Whether bodies, joints and probes are in reverse order.
    reversed: bool,
}

const PLAIN: Stated =
    Stated { name: "m, kg, s", metre: 1.0, kilogram: 1.0, place: [0.0; 3], turned: false, reversed: false };

const OTHERS: [Stated; 4] = [
    Stated { name: "mm, t, s", metre: 1e3, kilogram: 1e-3, ..PLAIN },
    Stated { name: "a kilometre away", place: [600.0, 0.0, 800.0], ..PLAIN },
    Stated { name: "turned", turned: true, ..PLAIN },
    Stated { name: "in reverse order", reversed: true, ..PLAIN },
];

/// The rows of a rotation.
const ROTATION: [Vector; 3] = [
    [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0],
    [2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0],
    [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0],
];

impl Stated {
    fn turn(&self, v: Vector) -> Vector {
        if self.turned { ROTATION.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum()) } else { v }
    }

    fn turn_back(&self, v: Vector) -> Vector {
        let column = |j: usize| ROTATION.iter().zip(v).map(|(row, x)| row[j] * x).sum();
        if self.turned { [0, 1, 2].map(column) } else { v }
    }

    fn point(&self, v: Vector) -> Vector {
        let [x, y, z] = self.turn(v);
        let [a, b, c] = self.place;
        [x + a, y + b, z + c].map(|x| x * self.metre)
    }

    /// The displacement of the tip in metres, turned back.
    fn displacement(&self, solved: &Solved) -> Result<Vector, Error> {
        let [x, y, z] = [solved.last("tip.x")?, solved.last("tip.y")?, solved.last("tip.z")?];
        let [a, b, c] = self.point(TIP);
        Ok(self.turn_back([x - a, y - b, z - c]).map(|x| x / self.metre))
    }

    fn leg(&self, name: &str, formulation: &str, [from, to]: [Vector; 2]) -> String {
        let up = self.turn([0.0, 1.0, 0.0]);
        let [from, to] = [from, to].map(|v| self.point(v));
        format!(
            r#"
            [[bodies]]
            kind = "beam"
            name = "{name}"
            from = {from:?}
            to = {to:?}
            up = {up:?}
            elements = 4
            formulation = "{formulation}"
            section = "round"
            material = "m"
            "#
        )
    }

    fn model(&self, analysis: &str) -> String {
        let Self { metre, kilogram, .. } = self;
        let [density, young] = [1200.0 * kilogram / metre.powi(3), 2e9 * kilogram / metre];
        let diameter = 0.02 * metre;
        let force = self.turn([6.0, -9.0, 12.0]).map(|f| f * kilogram * metre);
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
            materials.m = {{ density = {density}, young = {young} }}
            sections.round = {{ kind = "circle", diameter = {diameter} }}
            {}{}
            [[loads]]
            kind = "force"
            on = {{ body = "second", at = "end" }}
            force = {force:?}

            [[probes]]
            name = "tip"
            on = {{ body = "second", at = "end" }}

            [analysis]
            {analysis}
            "#,
            bodies.concat(),
            joints.concat()
        )
    }
}

const ELBOW: Vector = [1.0, 0.0, 0.0];
const TIP: Vector = [1.0, 0.0, 1.0];

fn clamp(name: &str, body: &str, to: &str) -> String {
    format!(
        r#"
        [[joints]]
        kind = "clamp"
        name = "{name}"
        a = {{ body = "{body}", at = "start" }}
        b = {to}
        "#
    )
}

const MODES: &str = "kind = \"modes\"\ncount = 4\nabout = \"equilibrium\"";

/// What statics or a path of a frame must share with that of another: tip and work done.
fn compare(findings: &mut Findings, kind: &str, stated: Stated) -> Result<Vec<[f64; 2]>, Error> {
    let analysis = format!("kind = \"{kind}\"\nfirst = 0.1");
    let [plain, other] = [solve(&PLAIN.model(&analysis))?, solve(&stated.model(&analysis))?];
    let [references, ours] = [PLAIN.displacement(&plain)?, stated.displacement(&other)?];
    for ((axis, ours), reference) in ["x", "y", "z"].into_iter().zip(ours).zip(references) {
        findings.compare(format!("u{axis} in m, {kind}, {}", stated.name), ours, reference, 1.0, 1e-9);
    }
    let counts = |solved: &Solved| [solved.summary.steps as f64, solved.summary.iterations as f64];
    for ((what, ours), reference) in
        ["steps", "iterations"].into_iter().zip(counts(&other)).zip(counts(&plain))
    {
        findings.compare(format!("{what}, {kind}, {}", stated.name), ours, reference, 1.0, 0.0);
    }
    plain.points("tip.y", "tip.z")
}

fn frequencies(findings: &mut Findings, stated: Stated) -> Result<(), Error> {
    let [plain, other] = [solve(&PLAIN.model(MODES))?, solve(&stated.model(MODES))?];
    let pairs = other.column("frequency")?.iter().zip(plain.column("frequency")?);
    for (mode, (&ours, &reference)) in (1..).zip(pairs) {
        let what = format!("frequency {mode} in 1/s, {}", stated.name);
        findings.compare(what, ours, reference, reference, 1e-9);
    }
    Ok(())
}

fn run() -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for stated in OTHERS {
        frequencies(&mut findings, stated)?;
    }
    for (kind, mark) in [("statics", Mark::Points), ("path", Mark::Line)] {
        let mut points = Vec::new();
        for stated in OTHERS {
            points = compare(&mut findings, kind, stated)?;
        }
        curves.push(Curve { name: kind.into(), mark, points });
    }
    findings.plots.push(Plot {
        title: "Way of the tip as the load grows".into(),
        axes: ["y in m".into(), "z in m".into()],
        equal: true,
        curves,
        ..Plot::default()
    });
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        super::super::assert_holds(&super::PROBLEM);
    }
}
