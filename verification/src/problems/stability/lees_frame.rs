use crate::problems::models::{ROD, Rod, clamp, hinge, joint};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Frame with snap-through and snap-back.
pub const PROBLEM: Problem = Problem {
    name: "lees_frame",
    title: "Lee's frame: limit points and snap-back",
    source: "Lee, Manuel & Rossow (1968); path and limit points by shooting of the planar Reissner rod, with \
                 residuals of 1e-12",
    sketch: r"
        24   | P        96
      +======v==================o     w: down, u: right, both where P acts
      ||
      || 120     E = 7.2e6, A = 6, I = 2
      ||
      o",
    goal: "Limit points and path within 1e-3 of the load or of the frame's size: 20 cable elements per leg, without \
               shear, and 20 \
           linked elements per leg, with shear (ν = 0.3, k = 5/6). In the law of St. Venant and Kirchhoff compression \
           reduces the \
           bending stiffness, in the reference it does not. The axial stiffness of the beams is therefore a thousand \
           times larger, \
           which changes the results by less than 1e-3. The foot of the cables is a beam of length 2 on a hinge: a spherical \
           joint would permit a rotation out of the plane. Stability out of the plane is not considered",
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

/// Returns the frame with its hinges and load. The axial stiffness is multiplied by `stiffer`.
fn frame(stiffer: f64, legs: &str, foot: &str, end: &str) -> String {
    let [area, factor] = [6.0 * stiffer, 5.0 / 6.0 / stiffer];
    format!(
        r#"
        materials.material = {{ density = 1, young = 7.2e6, poisson = 0.3 }}
        sections.section = {{ kind = "general", area = {area}, iy = 2, iz = 2, ky = {factor}, kz = {factor} }}
        {legs}{foot}{end}
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
        "#,
        foot = hinge("foot", foot, "start")
    )
}

/// Returns a leg of 20 elements.
fn leg(name: &str, element: &str, [from, to]: [[f64; 3]; 2]) -> String {
    Rod { name, element, from, to, elements: 20, keys: "" }.to_string()
}

/// Returns the clamp of the start of `above` to the end of `below`.
fn corner(name: &str, above: &str, below: &str) -> String {
    clamp(name, above, &format!("{{ body = \"{below}\", at = \"end\" }}"))
}

fn beams() -> String {
    let legs = [
        leg("column", "linked", [[0.0; 3], [0.0, LEG, 0.0]]),
        leg("beam", "linked", [[0.0, LEG, 0.0], [LEG, LEG, 0.0]]),
        corner("corner", "beam", "column"),
    ];
    frame(1e3, &legs.concat(), "column", &hinge("end", "beam", "end"))
}

fn cables() -> String {
    let legs = [
        Rod { name: "hinge", element: "linked", to: [0.0, 2.0, 0.0], ..ROD }.to_string(),
        leg("column", "cable", [[0.0, 2.0, 0.0], [0.0, LEG, 0.0]]),
        leg("beam", "cable", [[0.0, LEG, 0.0], [LEG, LEG, 0.0]]),
        corner("on the hinge", "column", "hinge"),
        corner("corner", "beam", "column"),
    ];
    let end = joint("spherical", "end", "{ body = \"beam\", at = \"end\" }");
    frame(1.0, &legs.concat(), "hinge", &end)
}

/// Returns u, P, w of every point.
fn path(solved: &SolvedModel) -> Result<Vec<[f64; 3]>, VerificationError> {
    let places = solved.points("p.x", "p.y")?;
    let loads = solved.column("load")?;
    Ok(places.iter().zip(loads).map(|([x, y], load)| [x - 24.0, load * UNIT, LEG - y]).collect())
}

/// Returns P, w, u of the first maximum and the first minimum.
fn limits(solved: &SolvedModel, path: &[[f64; 3]]) -> Result<Limits, VerificationError> {
    let kinds = solved.column("limit")?;
    let first = |kind: f64| {
        let row = kinds.iter().position(|&limit| limit == kind);
        let point = row.and_then(|row| path.get(row));
        let [u, p, w] = *point.ok_or_else(|| VerificationError::Missing(format!("limit point {kind}")))?;
        Ok::<_, VerificationError>([p, w, u])
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

/// Returns P and w at a given u by cubic Lagrange interpolation.
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

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for (name, model, references) in [("linked", beams(), SHEAR), ("cable", cables(), NO_SHEAR)] {
        let solved = solve(&model)?;
        let ours = path(&solved)?;
        compare_limits(&mut findings, name, limits(&solved, &ours)?, references);
        if name == "cable" {
            for [u, p, w] in PATH {
                let found =
                    at(&ours, u).ok_or_else(|| VerificationError::Missing(format!("point with u = {u}")))?;
                findings.compare(format!("P at u = {u}, {name}"), found[0], p, NO_SHEAR[0][0], 1e-3);
                findings.compare(format!("w at u = {u}, {name}"), found[1], w, LEG, 1e-3);
            }
        }
        let points = ours.iter().map(|&[_, p, w]| [w, p]).collect();
        curves.push(PlotCurve::line(name, points));
    }
    let limits = NO_SHEAR.iter().map(|&[p, w, _]| [w, p]);
    let points = PATH.iter().map(|&[_, p, w]| [w, p]).chain(limits).collect();
    curves.push(PlotCurve::points("exact rod, without shear", points));
    findings.plot(Plot::new("Load against the displacement of its point", ["w", "P"], curves));
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
