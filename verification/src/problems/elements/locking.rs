use crate::problems::models::{Cantilever, KIM, KIM_BENDING, KIM_BY_NUMBERS};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Convergence of the elements.
pub const PROBLEM: Problem = Problem {
    name: "locking",
    title: "Error of the tip against the number of elements",
    source: "Linear beam with shear, closed form, as by Kim et al. (2017); Reissner's rod by shooting; strip of \
                 Dowell & Traybar \
             (1975) as a Reissner rod with shear factor one and the polar moment of area, by shooting",
    sketch: r"
  |/|=====+=====+=====+=====     n = 1, 2, 4, 8, 16, 32 elements of each kind
           each a 1/n of L       own weight | P L²/EI = 10 | bending about both axes with torsion",
    goal: "Under own weight with ν = 0.3 the continuum converges to (λ+2G) I instead of E I, −1.5165423 mm instead of \
               −2.0413, with \
           the law 1/(3n²), and `enhanced` to the beam with the same law, to 1e-6; under large loads both lock on \
           coarse meshes, \
           the continuum as in an independent implementation, to 1e-9. `linked`, `quadratic` and the cable, which has no \
           torsion, are within 1e-3 from 8 elements on",
    run,
};

const TIGHT: &str = "first = 0.1\nstop = { rule = \"energy\", tolerance = 1e-11 }";

/// Section with a tenth of the diameter of the rod of Kim et al.
const THIN: &str = "{ kind = \"circle\", diameter = 0.002 }";
/// General section with the constants of the rectangle.
const THIN_BY_NUMBERS: &str = "{ kind = \"general\", area = 3.141592653589793e-6, iy = 7.853981633974483e-13, iz = \
    7.853981633974483e-13 }";

const MESHES: [u32; 6] = [1, 2, 4, 8, 16, 32];
const KINDS: [&str; 5] = ["continuum", "enhanced", "linked", "quadratic", "cable"];

/// Section of 12.377 × 3.2024 mm by its numbers.
const STRIP: &str = "{ kind = \"general\", area = 3.9636104800000002e-05, iy = 3.3873562668807646e-11, iz = \
    5.0598833394746008e-10 }";

/// Section of 12.377 × 3.2024 mm.
const RECTANGLE: &str = "{ kind = \"rectangle\", height = 12.377e-3, width = 3.2024e-3 }";

/// Returns the tip displacements of all meshes.
fn tips<'a>(of: impl Fn(u32) -> Cantilever<'a>, load: f64) -> Result<Vec<[f64; 3]>, VerificationError> {
    MESHES
        .into_iter()
        .map(|elements| {
            let cantilever = of(elements);
            let solved = solve(&cantilever.model())?;
            let [x, y, z] = ["tip.x", "tip.y", "tip.z"].map(|name| solved.last(name));
            Ok([(x? - cantilever.length) / load, y? / load, z? / load])
        })
        .collect()
}

/// Returns the error of a tip relative to the displacement.
fn error(tip: &[f64; 3], limit: &[f64; 3]) -> f64 {
    let norm = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    norm([0, 1, 2].map(|i| tip[i] - limit[i])) / norm(*limit)
}

fn curve(name: &str, tips: &[[f64; 3]], limit: &[f64; 3]) -> PlotCurve {
    let points = MESHES.iter().zip(tips).map(|(&n, tip)| [f64::from(n), error(tip, limit)]).collect();
    PlotCurve::line(name, points)
}

fn plot(title: &str, curves: Vec<PlotCurve>) -> Plot {
    Plot::new(title, ["elements", "error / displacement"], curves).with_logarithmic_axes([true, true])
}

/// Compares the rod of Kim et al. with ν = 0.3 under a small part of its weight (linear).
fn own_weight(findings: &mut Findings) -> Result<(), VerificationError> {
    let mut curves = Vec::new();
    for kind in KINDS {
        let of = |elements| Cantilever {
            element: kind,
            elements,
            section: if kind == "cable" { KIM.section } else { KIM_BY_NUMBERS },
            material: "{ density = 8030, young = 193e9, poisson = 0.3 }",
            statics: "load = 1e-5",
            ..KIM
        };
        // q L⁴/8 E I and q L²/2 G A, m.
        let (bending, shear) = (2.040_784_974_093_264e-3, 5.306_040_933e-7);
        let (bending, shear) = match kind {
            "continuum" => (bending / 1.346_153_846_153_846, shear),
            "cable" => (bending, 0.0),
            _ => (bending, shear),
        };
        let tips = tips(of, 1e-5)?;
        let limit = [0.0, -bending - shear, 0.0];
        for (&n, tip) in MESHES.iter().zip(&tips) {
            let what = format!("own weight, {kind}, {n} elements, mm");
            let depth = -1e3 * tip[1];
            if kind == "continuum" || kind == "enhanced" {
                let law = 1e3 * (bending * (1.0 - 1.0 / (3.0 * f64::from(n * n))) + shear);
                findings.compare(what, depth, law, law, 1e-6);
            } else if n >= 8 {
                findings.compare(what, depth, -1e3 * limit[1], depth, 1e-3);
            }
        }
        curves.push(curve(kind, &tips, &limit));
    }
    findings.plot(plot("Own weight, ν = 0.3, linear; each against its own limit", curves));
    Ok(())
}

/// x and deflection of the inextensible rod for P L²/EI = 10.
const INEXTENSIBLE: [f64; 2] = [0.445_004_402_246_249, 0.810_609_024_880_296];
/// x and deflection of Reissner's rod with shear factor one for P L²/EI = 10, ν = 0.
const REISSNER: [f64; 2] = [0.444_975_285_0, 0.810_909_230_6];
/// x and deflection of the rod without shear for P L²/EI = 10.
const STRETCHED: [f64; 2] = [0.445_033_517_081, 0.810_808_827_703];

/// Continuum with all gradients clamped, by an independent implementation: elements, x and deflection.
const CONTINUUM: [(u32, [f64; 2]); 3] = [
    (8, [0.504_768_178_6, 0.765_059_780_0]),
    (16, [0.451_090_141_5, 0.805_697_971_3]),
    (32, [0.445_228_040_1, 0.810_515_993_3]),
];

/// Compares the rod with ν = 0 under P L²/EI = 10. The limits have a tenth of the diameter, a hundredth of strain and shear.
fn elastica(findings: &mut Findings) -> Result<(), VerificationError> {
    for (elements, reference) in CONTINUUM {
        let load = format!("kind = \"force\"\nforce = [0, {:e}, 0]", -10.0 * KIM_BENDING);
        let whole =
            Cantilever { elements, gravity: 0.0, fix: "all", load: Some(&load), statics: TIGHT, ..KIM };
        let solved = solve(&whole.model())?;
        for (axis, sign, reference) in [("x", 1.0, reference[0]), ("y", -1.0, reference[1])] {
            let what = format!("P L²/EI = 10, continuum, {elements} elements, {axis}/L");
            findings.compare(what, sign * solved.last(&format!("tip.{axis}"))?, reference, 1.0, 1e-9);
        }
    }
    let mut curves = Vec::new();
    for kind in KINDS {
        let thick = if kind == "cable" { STRETCHED } else { REISSNER };
        let [x, y] = [0, 1].map(|i| INEXTENSIBLE[i] + 0.01 * (thick[i] - INEXTENSIBLE[i]));
        let of = |elements| Cantilever {
            element: kind,
            elements,
            section: if kind == "cable" { THIN } else { THIN_BY_NUMBERS },
            gravity: 0.0,
            load: Some("kind = \"force\"\nforce = [0, -1.515818455357075, 0]"),
            statics: TIGHT,
            offset: 1e-3,
            ..KIM
        };
        let tips = tips(of, 1.0)?;
        let limit = [x - 1.0, -y, 0.0];
        from_eight(findings, "P L²/EI = 10", kind, &tips, &limit);
        curves.push(curve(kind, &tips, &limit));
    }
    findings.plot(plot("Dead load at the tip, P L²/EI = 10, L/d = 500", curves));
    Ok(())
}

/// Continuum with all gradients clamped, by an independent implementation: elements and displacements.
const STRIPS: [(u32, [f64; 3]); 3] = [
    (8, [-0.012_429_688_9, -0.007_551_501_1, 0.100_984_592_1]),
    (16, [-0.013_921_977_6, -0.007_616_050_4, 0.107_386_636_9]),
    (32, [-0.014_041_049_2, -0.007_624_595_3, 0.107_889_862_5]),
];

/// Compares a strip bent about both axes and twisted: 8.896 N at 45°.
fn strip(findings: &mut Findings) -> Result<(), VerificationError> {
    let mut curves = Vec::new();
    let (sin, cos) = std::f64::consts::FRAC_PI_4.sin_cos();
    let load = format!("kind = \"force\"\nforce = [0, {:e}, {:e}]", -8.896 * cos, 8.896 * sin);
    let of = |element, elements, fix| Cantilever {
        element,
        elements,
        length: 0.508,
        section: STRIP,
        material: "{ density = 2700, young = 71.7e9 }",
        gravity: 0.0,
        load: Some(&load),
        fix,
        statics: TIGHT,
        offset: 1e-3,
    };
    let limit = [-0.014_052_389_9, -0.007_626_729_5, 0.107_940_750_1];
    for (elements, reference) in STRIPS {
        let solved = solve(&Cantilever { section: RECTANGLE, ..of("continuum", elements, "all") }.model())?;
        for (axis, name) in ["tip.x", "tip.y", "tip.z"].into_iter().enumerate() {
            let moved = solved.last(name)? - if axis == 0 { 0.508 } else { 0.0 };
            let what = format!("strip, continuum, {elements} elements, {name}, m");
            findings.compare(what, moved, reference[axis], 0.508, 1e-9);
        }
    }
    for kind in &KINDS[..4] {
        let tips = tips(|elements| of(kind, elements, "section"), 1.0)?;
        from_eight(findings, "strip", kind, &tips, &limit);
        curves.push(curve(kind, &tips, &limit));
    }
    findings.plot(plot("Strip bent about both axes and twisted", curves));
    Ok(())
}

/// Compares elements without locking, from eight elements.
fn from_eight(findings: &mut Findings, what: &str, kind: &str, tips: &[[f64; 3]], limit: &[f64; 3]) {
    if kind == "continuum" || kind == "enhanced" {
        return;
    }
    for (&n, tip) in MESHES.iter().zip(tips).filter(|(n, _)| **n >= 8) {
        findings.compare(format!("{what}, {kind}, {n} elements, error"), error(tip, limit), 0.0, 1.0, 1e-3);
    }
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    own_weight(&mut findings)?;
    elastica(&mut findings)?;
    strip(&mut findings)?;
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
