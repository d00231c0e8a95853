//! Edges of shells that are joined, and supports that meet at corners.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use ancf::record::Series;
use ancf::{Model, simulate};

use crate::common::assertions::{assert_near, assert_relative};

fn run(text: &str) -> (Series, Vec<String>) {
    let model = Model::parse(text).unwrap();
    let warnings = model.diagnose().unwrap().warnings;
    let mut series = Series::new();
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    (series, warnings)
}

fn shell(name: &str, surface: &str, elements: [u32; 2]) -> String {
    format!(
        "[[bodies]]\nkind = \"shell\"\nname = \"{name}\"\nsurface = {{ {surface} }}\nelements = {elements:?}\nthickness = 0.01\n\
         material = \"m\"\n"
    )
}

fn seam(name: &str, [a, edge]: [&str; 2], [b, other]: [&str; 2], condition: &str) -> String {
    format!(
        "[[joints]]\nkind = \"seam\"\nname = \"{name}\"\na = {{ body = \"{a}\", at = {{ edge = \"{edge}\" }} }}\n\
         b = {{ body = \"{b}\", at = {{ edge = \"{other}\" }} }}\ncondition = \"{condition}\"\n"
    )
}

fn support(body: &str, edge: &str, condition: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{body} {edge}\"\na = {{ body = \"{body}\", at = {{ edge = \"{edge}\" }} }}\n\
         condition = \"{condition}\"\n"
    )
}

const MATERIAL: &str = "materials.m = { density = 100, young = 1.092e7, poisson = 0.3 }\n";

/// Supports of all edges state the motion of the corners twice. The second statements are left out.
#[test]
fn supports_meet_at_corners_without_redundancy() {
    let flat = "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0]";
    for condition in ["clamped", "hinged"] {
        let edges =
            ["u_start", "u_end", "v_start", "v_end"].map(|edge| support("s", edge, condition)).concat();
        let text =
            format!("{MATERIAL}{}{edges}[analysis]\nkind = \"modes\"\ncount = 1\n", shell("s", flat, [4, 4]));
        let (series, warnings) = run(&text);
        assert!(warnings.is_empty(), "{condition}: {warnings:?}");
        // Thin plate with D = 1 and ρh = 1: 35.9851911 clamped, 2 π² hinged.
        let exact = if condition == "clamped" { 35.9851911 } else { 2.0 * PI * PI };
        assert_relative(condition, TAU * series.column("frequency").unwrap()[0], exact, 4e-3);
    }
}

/// Two halves of a cantilever plate, the second one with reversed directions, deflect as one patch.
#[test]
fn rigid_seams_join_patches() {
    let end = |body: &str, edge: &str, at: &str| {
        format!(
            "[[loads]]\nkind = \"edge_force\"\nbody = \"{body}\"\nedge = \"{edge}\"\nforce = [0, 0, 0.6]\n\
             [[probes]]\nname = \"A\"\non = {{ body = \"{body}\", at = {at} }}\n[analysis]\nkind = \"statics\"\n"
        )
    };
    let whole = "kind = \"flat\", corner = [0, 0, 0], side_u = [2, 0, 0], side_v = [0, 1, 0]";
    let one = format!(
        "{MATERIAL}{}{}{}",
        shell("s", whole, [8, 4]),
        support("s", "u_start", "clamped"),
        end("s", "u_end", "[1, 1]")
    );
    let halves = [
        "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0]",
        "kind = \"flat\", corner = [2, 1, 0], side_u = [-1, 0, 0], side_v = [0, -1, 0]",
    ];
    let joined = format!(
        "{MATERIAL}{}{}{}{}{}",
        shell("s", halves[0], [4, 4]),
        shell("t", halves[1], [4, 4]),
        support("s", "u_start", "clamped"),
        seam("j", ["s", "u_end"], ["t", "u_end"], "rigid"),
        end("t", "u_start", "[0, 0]")
    );
    let ((one, _), (two, warnings)) = (run(&one), run(&joined));
    assert!(warnings.is_empty(), "{warnings:?}");
    let last = |series: &Series, name: &str| *series.column(name).unwrap().last().unwrap();
    assert!(last(&one, "A.z") > 0.5, "{}", last(&one, "A.z"));
    for axis in ["A.x", "A.y", "A.z"] {
        assert!(
            (last(&one, axis) - last(&two, axis)).abs() < 2e-4,
            "{axis}: {} {}",
            last(&one, axis),
            last(&two, axis)
        );
    }
    // The seam carries the load of the second half.
    assert_near("force", last(&two, "j.fz"), 0.6, 1e-6);
}

/// Circumferential modes of a closed cylinder without ends, with 2, 3 and 4 waves in pairs: the rings of Rayleigh's theory with
/// ω² = D n² (n² − 1)²/(ρh R⁴ (n² + 1)) for motions without variation along the axis and ν = 0.
#[test]
fn closed_cylinders_have_the_modes_of_rings() {
    let surface = "kind = \"revolved\", from = [1, 0, 0], to = [1, 0, 0.3], center = [0, 0, 0], axis = [0, 0, 1], angle = 6.283185307179586";
    let text = format!(
        "materials.m = {{ density = 100, young = 1.2e7 }}\n{}{}[analysis]\nkind = \"modes\"\ncount = 12\n",
        shell("s", surface, [16, 1]),
        seam("j", ["s", "u_end"], ["s", "u_start"], "rigid")
    );
    let (series, warnings) = run(&text);
    assert!(warnings.iter().all(|warning| !warning.contains("redundant")), "{warnings:?}");
    let found: Vec<f64> = series.column("frequency").unwrap().iter().map(|f| TAU * f).collect();
    let ring = |n: f64| (n * n * (n * n - 1.0).powi(2) / (n * n + 1.0)).sqrt();
    // Six rigid modes, then pairs without variation along the axis (Rayleigh) and linear in it (Love) for n = 2.
    assert!(found[..6].iter().all(|f| f.abs() < 1e-2), "{found:?}");
    assert!(found[6] > 0.5, "{found:?}");
    for n in [2.0, 3.0] {
        let near = found.iter().filter(|f| (*f / ring(n) - 1.0).abs() < 5e-3).count();
        assert!(near == 2, "{n} waves, {}: {found:?}", ring(n));
    }
}

/// A hinged seam has no moment; a rigid one keeps the angle of a kink under a finite rotation.
#[test]
fn kinks_keep_their_angle() {
    let plates = [
        "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0]",
        "kind = \"flat\", corner = [1, 0, 0], side_u = [0, 0, 1], side_v = [0, 1, 0]",
    ];
    let text = format!(
        "{MATERIAL}{}{}{}{}[[loads]]\nkind = \"edge_force\"\nbody = \"t\"\nedge = \"u_end\"\nforce = [2, 0, 0]\n{}[analysis]\n\
         kind = \"statics\"\n",
        shell("s", plates[0], [4, 2]),
        shell("t", plates[1], [4, 2]),
        support("s", "u_start", "clamped"),
        seam("j", ["s", "u_end"], ["t", "u_start"], "rigid"),
        [("P", "s", "[1, 0.5]"), ("Q", "t", "[0, 0.5]")].map(|(name, body, at)| {
            format!("[[probes]]\nname = \"{name}\"\non = {{ body = \"{body}\", at = {at} }}\nrecord = [\"motion\", \"rotation\"]\n")
        }).concat()
    );
    let (series, warnings) = run(&text);
    assert!(warnings.is_empty(), "{warnings:?}");
    let last = |name: &str| *series.column(name).unwrap().last().unwrap();
    // Euler parameters: the edge rotates about y.
    let rotation = ["e0", "e1", "e2", "e3"].map(|e| [last(&format!("P.{e}")), last(&format!("Q.{e}"))]);
    let angle = 2.0 * rotation[2][0].abs().asin();
    assert!(angle > 0.4 && angle < FRAC_PI_2, "{rotation:?}");
    for [p, q] in rotation {
        assert!((p - q).abs() < 1e-3, "{rotation:?}");
    }
}

#[test]
fn edges_that_do_not_fit_are_rejected() {
    let surface =
        |x: f64| format!("kind = \"flat\", corner = [{x:?}, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0]");
    let paths = |x: f64, elements: [u32; 2], ends: [[&str; 2]; 2]| -> Vec<String> {
        let text = format!(
            "{MATERIAL}{}{}{}[analysis]\nkind = \"modes\"\n",
            shell("s", &surface(0.0), [2, 2]),
            shell("t", &surface(x), elements),
            seam("j", ends[0], ends[1], "rigid")
        );
        let errors = Model::parse(&text).map(|_| ());
        errors.err().map_or(Vec::new(), |errors| errors.0.iter().map(|error| error.path.clone()).collect())
    };
    let ends = [["s", "u_end"], ["t", "u_start"]];
    assert_eq!(paths(1.0, [2, 2], ends), Vec::<String>::new());
    assert_eq!(paths(1.0, [2, 3], ends), ["joints[0]"]);
    assert!(paths(1.1, [2, 2], ends).contains(&"joints[0]".to_owned()));
    assert_eq!(paths(1.0, [2, 2], [["s", "u_end"], ["s", "u_end"]]), ["joints[0].b.at"]);
}

/// A straight edge and a helix of one element have common ends, but not the same curve.
#[test]
fn edges_of_different_curves_are_rejected() {
    let twist = 0.4_f64;
    let side = [1.0, 0.5 * (twist.cos() - 1.0), 0.5 * twist.sin()];
    let flat = format!("kind = \"flat\", corner = [0, 0.5, 0], side_u = {side:?}, side_v = [0, 1, 0]");
    let twisted =
        format!("kind = \"twisted\", from = [0, 0, 0], to = [1, 0, 0], width = [0, 1, 0], twist = {twist}");
    let text = format!(
        "{MATERIAL}{}{}{}[analysis]\nkind = \"modes\"\n",
        shell("s", &twisted, [1, 2]),
        shell("t", &flat, [1, 2]),
        seam("j", ["s", "v_end"], ["t", "v_start"], "rigid")
    );
    let errors = Model::parse(&text).unwrap_err().to_string();
    assert!(errors.contains("nodes or tangents differ"), "{errors}");
}
