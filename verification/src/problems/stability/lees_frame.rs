use crate::{Curve, Error, Findings, Plot, Problem, Solved, solve};

/// A frame that snaps through and back.
pub const PROBLEM: Problem = Problem {
    name: "lees_frame",
    title: "Lee's frame: limit points and snap-back",
    source: "Lee, Manuel & Rossow (1968); path and limit points by shooting of the planar Reissner rod, with residuals of 1e-12",
    sketch: r"
        24   | P        96
      +======v==================o     w: down, u: right, both where P acts
      ||
      || 120     E = 7.2e6, A = 6, I = 2
      ||
      o",
    goal: "Limit points and path within 1e-3 of the load or of the frame's size: 20 cable elements a leg, without shear, and 20 \
           linked elements a leg, with it (ν = 0.3, k = 5/6). In St. Venant and Kirchhoff's law compression softens bending, in \
           the reference it does not; the beams are therefore a thousand times stiffer against stretch, which by itself is \
           worth less than 1e-3. The hinge of the cables is the first 2 of the column, a beam: a \
           spherical joint would let the frame turn over out of its plane. Stability out of the plane is not the subject",
    run,
};

/// Unit of the load.
const UNIT: f64 = 1e4;
const LEG: f64 = 120.0;

/// P, w, u of the maximum and the minimum.
type Limits = [[f64; 3]; 2];
const SHEAR: Limits = [[18544.527094, 48.7542404, 26.878328], [-9392.489640, 58.2249580, 90.177001]];
const NO_SHEAR: Limits = [[18556.727538, 48.7351372, 26.880574], [-9414.431556, 58.2168153, 90.195674]];

/// u, P, w without shear.
const PATH: [[f64; 3]; 6] = [
    [10.0, 15829.825191, 29.4368128],
    [20.0, 18159.703621, 42.6565341],
    [40.0, 17413.334037, 56.2415489],
    [60.0, 12545.351650, 60.9643858],
    [80.0, -1700.053370, 51.5705736],
    [90.0, -9412.201523, 57.9378957],
];

const BEAM: &str = "kind = \"beam\"\nformulation = \"linked\"";
const CABLE: &str = "kind = \"cable\"";

/// A leg, `kind` of body with what only that has.
fn leg(name: &str, kind: &str, [from, to]: [[f64; 3]; 2], elements: u32) -> String {
    format!(
        r#"
        [[bodies]]
        {kind}
        name = "{name}"
        from = {from:?}
        to = {to:?}
        elements = {elements}
        section = "s"
        material = "m"
        "#
    )
}

fn corner(name: &str, above: &str, below: &str) -> String {
    format!(
        r#"
        [[joints]]
        kind = "clamp"
        name = "{name}"
        a = {{ body = "{above}", at = "start" }}
        b = {{ body = "{below}", at = "end" }}
        "#
    )
}

/// What both frames have: material, section, hinges, load, analysis. Against stretch they are so many times stiffer.
fn frame(stiffer: f64, legs: &str, foot: &str, end: &str) -> String {
    let [area, factor] = [6.0 * stiffer, 5.0 / 6.0 / stiffer];
    format!(
        r#"
        materials.m = {{ density = 1, young = 7.2e6, poisson = 0.3 }}
        sections.s = {{ kind = "general", area = {area}, iy = 2, iz = 2, ky = {factor}, kz = {factor} }}
        {legs}
        [[joints]]
        kind = "revolute"
        name = "foot"
        a = {{ body = "{foot}", at = "start" }}
        axis = [0, 0, 1]
        {end}
        [[loads]]
        kind = "force"
        on = {{ body = "beam", at = 24 }}
        force = [0, -{UNIT}, 0]

        [[probes]]
        name = "p"
        on = {{ body = "beam", at = 24 }}

        [analysis]
        kind = "path"
        load = 2
        first = 0.02
        largest = 0.1
        "#
    )
}

fn beams() -> String {
    let legs = [
        leg("column", BEAM, [[0.0; 3], [0.0, LEG, 0.0]], 20),
        leg("beam", BEAM, [[0.0, LEG, 0.0], [LEG, LEG, 0.0]], 20),
        corner("corner", "beam", "column"),
    ];
    let end = "[[joints]]\nkind = \"revolute\"\nname = \"end\"\na = { body = \"beam\", at = \"end\" }\naxis = [0, 0, 1]";
    frame(1e3, &legs.concat(), "column", end)
}

fn cables() -> String {
    let legs = [
        leg("hinge", BEAM, [[0.0; 3], [0.0, 2.0, 0.0]], 1),
        leg("column", CABLE, [[0.0, 2.0, 0.0], [0.0, LEG, 0.0]], 20),
        leg("beam", CABLE, [[0.0, LEG, 0.0], [LEG, LEG, 0.0]], 20),
        corner("on the hinge", "column", "hinge"),
        corner("corner", "beam", "column"),
    ];
    let end = "[[joints]]\nkind = \"spherical\"\nname = \"end\"\na = { body = \"beam\", at = \"end\" }";
    frame(1.0, &legs.concat(), "hinge", end)
}

/// u, P, w of every point.
fn path(solved: &Solved) -> Result<Vec<[f64; 3]>, Error> {
    let places = solved.points("p.x", "p.y")?;
    let loads = solved.column("load")?;
    Ok(places.iter().zip(loads).map(|([x, y], load)| [x - 24.0, load * UNIT, LEG - y]).collect())
}

/// P, w, u of the first maximum and the first minimum.
fn limits(solved: &Solved, path: &[[f64; 3]]) -> Result<Limits, Error> {
    let kinds = solved.column("limit")?;
    let first = |kind: f64| {
        let row = kinds.iter().position(|&limit| limit == kind);
        let point = row.and_then(|row| path.get(row));
        let [u, p, w] = *point.ok_or_else(|| Error::Missing(format!("limit point {kind}")))?;
        Ok::<_, Error>([p, w, u])
    };
    Ok([first(1.0)?, first(-1.0)?])
}

fn compare_limits(findings: &mut Findings, name: &str, ours: Limits, references: Limits) {
    for ((point, ours), references) in ["maximum", "minimum"].into_iter().zip(ours).zip(references) {
        findings.compare(format!("P at its {point}, {name}"), ours[0], references[0], references[0], 1e-3);
        findings.compare(format!("w there, {name}"), ours[1], references[1], LEG, 1e-3);
        findings.compare(format!("u there, {name}"), ours[2], references[2], LEG, 1e-3);
    }
}

/// P and w at a given u by Lagrange's cubic through the two points before and the two beyond.
fn at(path: &[[f64; 3]], u: f64) -> Option<[f64; 2]> {
    let beyond = path.iter().position(|point| point[0] > u)?;
    let near = path.get(beyond.checked_sub(2)?..beyond + 2)?;
    let mut sum = [0.0; 2];
    for (i, point) in near.iter().enumerate() {
        let others = near.iter().enumerate().filter(|&(j, _)| j != i);
        let weight: f64 = others.map(|(_, other)| (u - other[0]) / (point[0] - other[0])).product();
        sum = [sum[0] + weight * point[1], sum[1] + weight * point[2]];
    }
    Some(sum)
}

fn run() -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for (name, model, references) in [("linked", beams(), SHEAR), ("cable", cables(), NO_SHEAR)] {
        let solved = solve(&model)?;
        let ours = path(&solved)?;
        compare_limits(&mut findings, name, limits(&solved, &ours)?, references);
        if name == "cable" {
            for [u, p, w] in PATH {
                let found = at(&ours, u).ok_or_else(|| Error::Missing(format!("point with u = {u}")))?;
                findings.compare(format!("P at u = {u}, {name}"), found[0], p, NO_SHEAR[0][0], 1e-3);
                findings.compare(format!("w at u = {u}, {name}"), found[1], w, LEG, 1e-3);
            }
        }
        let points = ours.iter().map(|&[_, p, w]| [w, p]).collect();
        curves.push(Curve::line(name, points));
    }
    let limits = NO_SHEAR.iter().map(|&[p, w, _]| [w, p]);
    let points = PATH.iter().map(|&[_, p, w]| [w, p]).chain(limits).collect();
    curves.push(Curve::points("exact rod, without shear", points));
    findings.plots.push(Plot {
        title: "Load over the descent of its point".into(),
        axes: ["w".into(), "P".into()],
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
