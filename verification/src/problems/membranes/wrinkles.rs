//! Stretched strip that wrinkles in bending.

use crate::problems::shear_shells::mesh::{MeshModel, isotropic};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[Problem {
    name: "wrinkled_strip",
    title: "Stretched membrane with wrinkles in bending: tension field",
    source: "Stein & Hedgepeth (1961). Beyond M = P H/6 the strip is wrinkled over H - c, c = 3 (H/2 - M/P), and κ = 2 P/(E h c²); below, κ = 12 M/(E h H³)",
    sketch: r"
    | ~~~~~~~~ |            H = 1, L = 1, h = 0.01, E = 3, ν = 0
  P <|========|> P          P = 3e-7, M/(P H) = 0.1, 0.2, 0.3, 0.4
    |    M     |            plane of symmetry on the left, rigid edge on the right",
    goal: "Rotation of the edge within 1 % with 20 elements over the height, thin or with four nodes, and 5 % with triangles; 1e-4 of the energy against \
           compression remains",
    run: wrinkles,
}];

/// Elements of the strip.
#[derive(Clone, Copy, Debug)]
enum Elements {
    Thin,
    Quadrilaterals,
    Triangles,
}

impl Elements {
    /// Strip, and the names of its edges at both ends.
    fn strip(self, field: bool) -> (String, [&'static str; 2]) {
        let membrane = format!("membrane = {{ tension_field = {field} }}\n");
        if let Self::Thin = self {
            let text = format!(
                "materials.m = {{ density = 1, young = 3, poisson = 0 }}\n\
                 [[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [2, 20]\nthickness = 0.01\nmaterial = \"m\"\n{membrane}\
                 surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0] }}\n"
            );
            return (text, ["u_start", "u_end"]);
        }
        let mesh = MeshModel::plate([10, 20], [1.0; 2], 0.01, isotropic([3.0, 0.0, 1.0]))
            .with_point("left", [0.0, 0.5, 0.0]);
        let mesh = MeshModel { keys: membrane, ..mesh };
        let is_divided = matches!(self, Self::Triangles);
        (mesh.divided(|_| is_divided).to_string(), ["u0", "u1"])
    }
}

/// Rotation of the rigid edge.
fn rotation(elements: Elements, ratio: f64, field: bool) -> Result<f64, VerificationError> {
    let (strip, [left, right]) = elements.strip(field);
    let middle = if let Elements::Thin = elements { "[0, 0.5]" } else { "{ point = \"left\" }" };
    let solved = solve(&format!(
        "analysis = {{ kind = \"statics\" }}\n{strip}\
         [[bodies]]\nkind = \"rigid\"\nname = \"hub\"\ncenter = [1, 0.5, 0]\nmass = 1\ninertia = [1, 1, 1]\n\
         [[joints]]\nkind = \"support\"\nname = \"l\"\na = {{ body = \"s\", at = {{ edge = \"{left}\" }} }}\ncondition = \"symmetry\"\n\
         [[joints]]\nkind = \"support\"\nname = \"r\"\na = {{ body = \"s\", at = {{ edge = \"{right}\" }} }}\n\
         b = {{ body = \"hub\", at = \"center\" }}\ncondition = \"clamped\"\n\
         [[joints]]\nkind = \"planar\"\nname = \"plane\"\na = {{ body = \"hub\", at = \"center\" }}\nnormal = [0, 0, 1]\n\
         [[joints]]\nkind = \"support\"\nname = \"y\"\na = {{ body = \"s\", at = {middle} }}\ncondition = \"guided\"\naxes = [\"y\"]\n\
         [[loads]]\nkind = \"force\"\non = {{ body = \"hub\", at = \"center\" }}\nforce = [{TENSION:?}, 0, 0]\n\
         [[loads]]\nkind = \"moment\"\non = {{ body = \"hub\", at = \"center\" }}\nmoment = [0, 0, {:?}]\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"hub\", at = \"center\" }}\nrecord = [\"rotation\"]\n",
        ratio * TENSION
    ))?;
    Ok(2.0 * solved.last("p.e3")?.asin())
}

const TENSION: f64 = 3e-7;
/// E h.
const STIFFNESS: f64 = 0.03;

fn exact(ratio: f64) -> f64 {
    let height = (3.0 * (0.5 - ratio)).min(1.0);
    if height == 1.0 {
        12.0 * ratio * TENSION / STIFFNESS
    } else {
        2.0 * TENSION / (STIFFNESS * height * height)
    }
}

fn wrinkles() -> Result<Findings, VerificationError> {
    let (mut found, mut points) = (Findings::default(), Vec::new());
    for ratio in [0.1, 0.2, 0.3, 0.4] {
        let (angle, exact) = (rotation(Elements::Thin, ratio, true)?, exact(ratio));
        found.compare(format!("rotation, M/(P H) = {ratio}"), angle, exact, exact, 1e-2);
        points.push([ratio, angle]);
    }
    for (kind, name, tolerance) in [
        (Elements::Quadrilaterals, "quadrilaterals with shear", 1e-2),
        // Triangles of constant strain are stiff in bending in their plane.
        (Elements::Triangles, "triangles", 5e-2),
    ] {
        let (angle, exact) = (rotation(kind, 0.3, true)?, exact(0.3));
        found.compare(format!("rotation, M/(P H) = 0.3, {name}"), angle, exact, exact, tolerance);
    }
    let (angle, flat) = (rotation(Elements::Thin, 0.4, false)?, 12.0 * 0.4 * TENSION / STIFFNESS);
    found.compare("rotation without wrinkles, M/(P H) = 0.4", angle, flat, flat, 1e-2);
    let curve = (0..=84).map(|k| 0.005 * f64::from(k)).map(|ratio| [ratio, exact(ratio)]).collect();
    let curves = vec![PlotCurve::line("Stein & Hedgepeth", curve), PlotCurve::points("computed", points)];
    found.plot(Plot::new("Rotation of the edge", ["M/(P H)", "rotation"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
