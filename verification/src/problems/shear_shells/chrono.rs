//! Unit tests of the four-node shell of Project Chrono.

use std::f64::consts::FRAC_PI_2;

use super::mesh::{MeshModel, edge, isotropic, probe};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "chrono_shell_isotropic",
        title: "Unit test of Chrono: damped plate with a force at a corner",
        source: "Project Chrono, utest_FEA_ANCFShell_Iso with its file UT_ANCFShellIso.txt: element 3423 of the same coordinates. Its test \
                 compares ten steps with a tolerance of 5e-5 m; the file has the whole motion. Rest at -0.6490 m by thin shells, \
                 32 x 32 elements",
        sketch: r"
      |/+------+          1 × 1 × 0.01 m, E = 210 MPa, ν = 0.3, ρ = 500 kg/m³, τ = 0.08 s
      |/|      |          4 × 4 elements, step of 1 ms, trapezoidal rule
      |/+------o |        50 N at the corner
               V",
        goal: "First ten steps within 1e-4 m; motion within 1.5 % of the deflection; deflection at rest within 0.2 % of its limit, for 4 x 4 \
               elements of four nodes and thin ones. That of Chrono is 0.8 % less than the limit (8 x 8: 0.12 %, 16 x 16: 0.04 %)",
        run: isotropic_plate,
    },
    Problem {
        name: "chrono_shell_laminate",
        title: "Unit test of Chrono: quarter of a laminated cylinder with a force at a corner",
        source: "Project Chrono, utest_FEA_ANCFShell_Ort with its file UT_ANCFShellLam.txt. Rest at z = 0.1990 m by thin shells, 32 x 32 \
                 elements",
        sketch: r"
             .o           R = 1 m, length 1 m, two plies of 5 mm at 20 and -20 degrees
           .' |           E = 200 and 100 MPa, ν = 0.3, G = 38.4615 MPa, ρ = 500 kg/m³, τ = 0.25 s
      |/_.'   V           6 × 6 elements, step of 2 ms, trapezoidal rule, 10 N at the corner",
        goal: "First ten steps within 1e-5 m; motion within 0.5 % of the deflection; deflection at rest within 1 % of its limit. Chrono's is \
               1.1 % less than the limit",
        run: laminate,
    },
    Problem {
        name: "chrono_shell_gravity",
        title: "Unit test of Chrono: quarter of a laminated cylinder that falls under its weight",
        source: "Project Chrono, utest_FEA_ANCFShell_OrtGrav with its file UT_ANCFShellOrtGrav.txt. Chrono starts without accelerations, \
                 which delays its motion by about a quarter of a step",
        sketch: r"
             .o           as before, without damping, moduli three times as large
           .'             8 × 8 elements, step of 1 ms, trapezoidal rule, 9.81 m/s²
      |/_.'",
        goal: "Motion of the corner within 1 % of its largest deflection for one second",
        run: weight,
    },
];

/// Instants and vertical positions of the corner by Chrono.
type Motion = &'static [[f64; 2]];

const ISOTROPIC: [Motion; 2] = [
    &[
        [0.001, -0.0001836],
        [0.002, -0.000787217],
        [0.003, -0.00175835],
        [0.005, -0.00441871],
        [0.007, -0.00781022],
        [0.01, -0.0139189],
    ],
    &[
        [0.2, -0.628019],
        [0.4, -0.767687],
        [0.6, -0.611783],
        [0.8, -0.582075],
        [1.0, -0.669261],
        [1.2, -0.662158],
        [1.4, -0.628131],
        [1.6, -0.639438],
        [1.8, -0.651583],
        [2.0, -0.644091],
    ],
];

const LAMINATE: [Motion; 2] = [
    &[
        [0.002, 0.999994],
        [0.004, 0.99997],
        [0.006, 0.999925],
        [0.01, 0.999777],
        [0.014, 0.999553],
        [0.02, 0.999081],
    ],
    &[
        [0.4, 0.798208],
        [0.8, 0.438137],
        [1.2, 0.124086],
        [1.6, 0.0333012],
        [2.0, 0.1072],
        [2.4, 0.211681],
        [2.8, 0.26396],
        [3.2, 0.256327],
        [3.6, 0.222185],
        [4.0, 0.195779],
    ],
];

const WEIGHT: Motion = &[
    [0.1, 0.961709],
    [0.2, 0.861246],
    [0.3, 0.669673],
    [0.4, 0.438267],
    [0.5, 0.122321],
    [0.6, -0.122391],
    [0.7, -0.276005],
    [0.8, -0.355489],
    [0.9, -0.221916],
    [1.0, -0.0748314],
];

/// Force at the corner `place`. The load is zero at the start, since Chrono starts without accelerations.
fn force(place: &str, force: f64, step: f64) -> String {
    format!(
        "[[loads]]\nkind = \"force\"\non = {{ body = \"s\", at = {place} }}\nforce = [0, 0, {force:?}]\n\
         time = {{ kind = \"table\", times = [0, {step:?}], values = [0, 1] }}\n"
    )
}

fn dynamics(step: f64, duration: f64) -> String {
    format!(
        "[analysis]\nkind = \"dynamics\"\nduration = {duration:?}\nstep = {step:?}\nscheme = \"average_acceleration\"\n"
    )
}

/// Compares the motion of the corner at instants, relative to a length.
fn compare(
    found: &mut Findings,
    solved: &SolvedModel,
    instants: Motion,
    (length, tolerance): (f64, f64),
) -> Result<(), VerificationError> {
    for &[time, exact] in instants {
        found.compare(format!("z at {time} s"), solved.at("tip.z", time)?, exact, length, tolerance);
    }
    Ok(())
}

fn plot(
    found: &mut Findings,
    solved: &SolvedModel,
    name: &str,
    chrono: Motion,
) -> Result<(), VerificationError> {
    let curves = vec![
        PlotCurve::line(name, solved.points("t", "tip.z")?),
        PlotCurve::points("Chrono, same mesh and step", chrono.to_vec()),
    ];
    found.plot(Plot::new("Height of the corner", ["t, s", "z, m"], curves));
    Ok(())
}

/// Rest position of the corner by statics.
fn rest(model: &str) -> Result<f64, VerificationError> {
    solve(&format!("{model}[analysis]\nkind = \"statics\"\n"))?.last("tip.z")
}

fn isotropic_plate() -> Result<Findings, VerificationError> {
    const DEFLECTION: f64 = 0.6490;
    let material = format!("{}, damping = {{ strain = 0.08 }}", isotropic([2.1e8, 0.3, 500.0]));
    let plate = MeshModel::plate([4, 4], [1.0, 1.0], 0.01, material.clone());
    let model = format!(
        "{plate}{}{}{}",
        edge("u0", "\"clamped\""),
        force(&place(&plate), -50.0, 1e-3),
        probe("tip", "p11")
    );
    let solved = solve(&(model.clone() + &dynamics(1e-3, 2.0)))?;
    let mut found = Findings::default();
    compare(&mut found, &solved, ISOTROPIC[0], (1.0, 1e-4))?;
    compare(&mut found, &solved, ISOTROPIC[1], (DEFLECTION, 1.5e-2))?;
    let thin = format!(
        "materials.m = {{ {material} }}\n[[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [4, 4]\nthickness = 0.01\nmaterial = \"m\"\n\
         surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0] }}\n{THIN_CLAMP}{}{THIN_PROBE}",
        force("[1, 1]", -50.0, 1e-3)
    );
    for (name, model) in [("four nodes", model), ("thin", thin)] {
        found.compare(format!("z at rest, {name}"), rest(&model)?, -DEFLECTION, DEFLECTION, 2e-3);
    }
    plot(&mut found, &solved, "4 x 4 elements of four nodes", ISOTROPIC[1])?;
    Ok(found)
}

/// Corner u = v = 1 as a place of a model file.
fn place(mesh: &MeshModel) -> String {
    format!("{{ node = {} }}", mesh.nodes.len() - 1)
}

const THIN_CLAMP: &str = "[[joints]]\nkind = \"support\"\nname = \"root\"\na = { body = \"s\", at = { edge = \"u_start\" } }\n\
                          condition = \"clamped\"\n";
const THIN_PROBE: &str = "[[probes]]\nname = \"tip\"\non = { body = \"s\", at = [1, 1] }\n";

/// Material of the plies: moduli along and across the fibres, shear modulus and retardation time.
fn ply([young, across, shear, retardation]: [f64; 4]) -> String {
    format!(
        "{}, orthotropic = {{ young = {across:e}, shear = {shear:e}, transverse_shear = {shear:e} }}, damping = {{ strain = {retardation:?} }}",
        isotropic([young, 0.3, 500.0])
    )
}

/// Angles of the plies from a direction that has the angle `from` to the circumference.
fn layers(from: f64) -> String {
    let [lower, upper] = [20.0_f64, -20.0].map(|angle| angle.to_radians() - from);
    format!("layers = [{{ angle = {lower:?} }}, {{ angle = {upper:?} }}]\n")
}

/// Quarter of a cylinder with its fibre angles from the generators.
fn quarter(n: usize, material: String) -> MeshModel {
    let mesh = MeshModel::grid([n, n], 0.01, material, |[u, v]| {
        let (sin, cos) = (FRAC_PI_2 * u).sin_cos();
        [[sin, v, 1.0 - cos], [-sin, 0.0, cos]]
    });
    MeshModel { keys: format!("fibre_axis = [0, 1, 0]\n{}", layers(FRAC_PI_2)), ..mesh }
}

fn laminate() -> Result<Findings, VerificationError> {
    const DEFLECTION: f64 = 1.0 - 0.1990;
    let material = ply([2e8, 1e8, 3.84615e7, 0.25]);
    let mesh = quarter(6, material.clone());
    let model = format!(
        "{mesh}{}{}{}",
        edge("u0", "\"clamped\""),
        force(&place(&mesh), -10.0, 2e-3),
        probe("tip", "p11")
    );
    let solved = solve(&(model.clone() + &dynamics(2e-3, 4.0)))?;
    let mut found = Findings::default();
    compare(&mut found, &solved, LAMINATE[0], (1.0, 1e-5))?;
    compare(&mut found, &solved, LAMINATE[1], (DEFLECTION, 5e-3))?;
    let thin = format!(
        "materials.m = {{ {material} }}\n[[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [6, 6]\nthickness = 0.01\nmaterial = \"m\"\n\
         surface = {{ kind = \"revolved\", from = [0, 0, 0], to = [0, 1, 0], center = [0, 0, 1], axis = [0, -1, 0], angle = {FRAC_PI_2:?} }}\n\
         {}{THIN_CLAMP}{}{THIN_PROBE}",
        layers(0.0),
        force("[1, 1]", -10.0, 2e-3)
    );
    for (name, model) in [("four nodes", model), ("thin", thin)] {
        let z = rest(&model)?;
        found.compare(format!("deflection at rest, {name}"), 1.0 - z, DEFLECTION, DEFLECTION, 1e-2);
    }
    plot(&mut found, &solved, "6 x 6 elements of four nodes", LAMINATE[1])?;
    Ok(found)
}

fn weight() -> Result<Findings, VerificationError> {
    let model = format!(
        "gravity = [0, 0, -9.81]\n{}{}{}{}",
        quarter(8, ply([6e8, 3e8, 1.1538e8, 0.0])),
        edge("u0", "\"clamped\""),
        probe("tip", "p11"),
        dynamics(1e-3, 1.0)
    );
    let (solved, mut found) = (solve(&model)?, Findings::default());
    compare(&mut found, &solved, WEIGHT, (1.36, 1e-2))?;
    plot(&mut found, &solved, "8 x 8 elements of four nodes", WEIGHT)?;
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
