//! Shells: classes, reasons, columns and refinement of errors by a second solution.

use ancf::estimate::{DiscretisationErrors, Resolution};
use ancf::solver::newton::Interrupt;
use ancf::{Model, refine};

use super::shells::{Quadrilaterals, STATICS, Shell, Thin, assert_effective};
use super::{errors, of, summary};
use crate::common::assertions::assert_near;
use crate::common::models::parse;
use crate::common::solutions::{Run, SOLVER_COLUMNS, assert_same_columns};

/// Strip of 10 × 1 × 0.1 that is clamped at its left edge, with a probe `p` at its tip.
fn strip(shell: Shell, elements: [u32; 2], rest: &str) -> String {
    let sides = [10.0, 1.0];
    format!(
        "output.errors = true\nmaterials.m = {{ young = 1.2e6, poisson = 0.3, density = 1000 }}\n{}\
         [[joints]]\nkind = \"support\"\nname = \"root\"\na = {{ body = \"s\", at = {} }}\ncondition = \"clamped\"\n{}{rest}",
        shell.body(sides, elements, 0.1),
        shell.edge("left"),
        shell.probe(
            sides,
            [10.0, 0.5],
            "record = [\"motion\", \"rotation\", \"resultants\", \"surface_stress\"]"
        ),
    )
}

/// Load at the right edge.
fn edge_force(shell: Shell) -> String {
    let edge = shell.edge("right").replace("{ edge = ", "").replace(" }", "");
    format!("[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = {edge}\nforce = [0, 0, 0.05]\n")
}

fn reason(errors: &DiscretisationErrors) -> &str {
    errors.finer.as_ref().and_then(|finer| finer.reason.as_deref()).unwrap_or_default()
}

/// Damped modes and paths are rejected; without a request nothing is stated.
#[test]
fn errors_are_stated_on_request_where_they_are_known() {
    for analysis in ["kind = \"modes\"\ndamped = true", "kind = \"path\""] {
        let text = strip(Thin, [2, 1], &format!("{}[analysis]\n{analysis}\n", edge_force(Thin)));
        let found = Model::parse(&text).expect_err(analysis);
        assert!(found.0.iter().any(|error| error.path == "output.errors"), "{analysis}: {found}");
    }
    let text = strip(Thin, [2, 1], &(edge_force(Thin) + STATICS));
    assert!(summary(&text.replace("output.errors = true", "")).errors.is_none());
}

/// The second solution leaves the results unchanged, and its columns are those of the last state.
#[test]
fn results_are_those_of_the_given_mesh() {
    for shell in [Thin, Quadrilaterals] {
        let rest = edge_force(shell) + &STATICS.replace("stop", "first = 0.5\nstop");
        let text = strip(shell, [4, 2], &rest);
        let (with, without) =
            (Run::of(&parse(&text)), Run::of(&parse(&text.replace("output.errors = true", ""))));
        // `unstable` is not a number at the start.
        let excluded = [SOLVER_COLUMNS.as_slice(), &["unstable"]].concat();
        assert_same_columns("errors", [&without, &with], &excluded, 0.0, 0.0);
        let found = with.summary.errors.as_ref().unwrap();
        for value in &found.values {
            assert_eq!(with.last(&value.column), value.value, "{}", value.column);
            assert_eq!(with.last(&format!("{}_error", value.column)), value.error, "{}", value.column);
        }
        let count = with.columns().filter(|(name, _)| name.ends_with("_error")).count();
        assert_eq!(count, found.values.len());
        let [first, half, full] = with.column("p.z_error") else { panic!("three rows") };
        // Small displacements: half the load has half the error.
        assert!(first.is_nan());
        assert_near("half the load", *half, 0.5 * full, 0.05 * full.abs());
        let [own] = found.bodies.as_slice() else { panic!("one body: {found:?}") };
        assert_eq!((own.share, own.body.as_str()), (1.0, "s"));
    }
}

/// The units of the equations have no effect.
#[test]
fn scales_leave_the_errors_of_shells() {
    for shell in [Thin, Quadrilaterals] {
        let text = strip(shell, [4, 2], &(edge_force(shell) + STATICS));
        let scaled = format!("scales = {{ kind = \"given\", length = 0.01, time = 3, force = 700 }}\n{text}");
        let [own, scaled] = [errors(&text), errors(&scaled)];
        for column in ["p.x", "p.z", "p.e2", "p.muu", "p.von_mises", "root.my"] {
            let ([_, error], [_, same]) = (of(&own, column), of(&scaled, column));
            assert_near(column, same, error, 1e-6 * error.abs() + 1e-12);
        }
    }
}

/// Forces at points, joints of nodes and contacts make the errors orders of magnitude, with a reason.
#[test]
fn irregular_solutions_are_rough() {
    for (shell, at, order) in [(Thin, "[1.0, 0.5]", 2.0), (Quadrilaterals, "[10.0, 0.5, 0]", 1.0)] {
        let force = format!(
            "[[loads]]\nkind = \"force\"\non = {{ body = \"s\", at = {at} }}\nforce = [0, 0, 0.05]\n{STATICS}"
        );
        let found = errors(&strip(shell, [4, 2], &force));
        assert_eq!((found.resolution, found.finer.as_ref().unwrap().order), (Resolution::Rough, Some(order)));
        assert!(found.sentence().contains("forces act at points of shell `s`"), "{}", found.sentence());
        let contact = "[[contacts]]\nwith = { kind = \"plane\", point = [0, 0, -0.3], normal = [0, 0, 1] }\nsurface_stiffness = 1e4\n";
        let found = errors(&strip(shell, [4, 2], &(edge_force(shell) + contact + STATICS)));
        assert_eq!((found.resolution, reason(&found)), (Resolution::Rough, "the model has contacts"));
    }
}

/// A force within an element of a curved mesh has no place on the finer one: the run finishes and states the reason.
#[test]
fn failed_second_solutions_are_stated() {
    let bent = |shell: &str| {
        shell.replace("[5.0, 0.0, 0.0]", "[5.0, 0.0, 0.5]").replace("[5.0, 1.0, 0.0]", "[5.0, 1.0, 0.5]")
    };
    let force =
        "[[loads]]\nkind = \"force\"\non = { body = \"s\", at = [7.5, 0.5, 0.25] }\nforce = [0, 0, 0.01]\n";
    let text = bent(&strip(Quadrilaterals, [2, 1], &(force.to_owned() + STATICS)));
    let found = summary(&text);
    let own = found.errors.as_ref().unwrap();
    assert_eq!(own.resolution, Resolution::Unknown);
    assert!(reason(own).contains("`loads[0].on.at`") && own.values.is_empty(), "{own:?}");
    assert!(found.warnings.contains(&own.sentence()), "{:?}", found.warnings);
}

/// A shell that carries a beam by a rigid body: errors are those of both.
#[test]
fn shell_with_a_beam() {
    let model = |shell: Shell, elements: [u32; 2], beam: u32, formulation: &str| {
        let bodies = format!(
            "[[bodies]]\nkind = \"rigid\"\nname = \"r\"\ncenter = [10, 0.5, 0]\nmass = 1\ninertia = [1, 1, 1]\n\
             [[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [10, 0.5, 0]\nto = [14, 0.5, 0]\nelements = {beam}\n\
             section = \"s\"\nmaterial = \"m\"\nformulation = \"{formulation}\"\n\
             [[joints]]\nkind = \"support\"\nname = \"j\"\na = {{ body = \"s\", at = {} }}\n\
             b = {{ body = \"r\", at = \"center\" }}\ncondition = \"clamped\"\n\
             [[joints]]\nkind = \"clamp\"\nname = \"k\"\na = {{ body = \"b\", at = \"start\" }}\nb = {{ body = \"r\", at = \"center\" }}\n\
             [[loads]]\nkind = \"force\"\non = {{ body = \"b\", at = \"end\" }}\nforce = [0, 0, 0.02]\n\
             [[probes]]\nname = \"q\"\non = {{ body = \"b\", at = \"end\" }}\n{STATICS}",
            shell.edge("right")
        );
        let section = "sections.s = { kind = \"rectangle\", height = 0.1, width = 0.1 }\n";
        format!("{section}{}", strip(shell, elements, &bodies))
    };
    for shell in [Thin, Quadrilaterals] {
        let [value, error] = of(&errors(&model(shell, [20, 2], 8, "linked")), "q.z");
        for formulation in ["linked", "enhanced"] {
            let found = errors(&model(shell, [4, 2], 2, formulation));
            let sentence = found.sentence();
            assert_effective(
                &format!("{shell:?}, {formulation}: {sentence}"),
                of(&found, "q.z"),
                value + error,
            );
            assert!(
                found.bodies.is_empty() && sentence.contains("not divided among the bodies"),
                "{sentence}"
            );
        }
        let locked = errors(&model(shell, [4, 2], 2, "continuum"));
        assert_eq!(locked.resolution, Resolution::Unknown);
        assert!(reason(&locked).contains("Poisson locking"), "{locked:?}");
    }
}

/// Seams keep their edges: two shells in a row have the errors of one.
#[test]
fn seam_of_two_shells() {
    for shell in [Thin, Quadrilaterals] {
        let one = errors(&strip(shell, [4, 2], &(edge_force(shell) + STATICS)));
        let whole = strip(shell, [2, 2], &(edge_force(shell) + STATICS));
        let half = shell.body([5.0, 1.0], [2, 2], 0.1);
        let own = shell.body([10.0, 1.0], [2, 2], 0.1);
        let shifted = match shell {
            Thin => half.replace("corner = [0, 0, 0]", "corner = [5, 0, 0]"),
            _ => {
                let moved = half.replace("[5.0, ", "[10.0, ").replace("[2.5, ", "[7.5, ");
                moved
                    .replace("[0.0, 0.0, 0.0]", "[5.0, 0.0, 0.0]")
                    .replace("[0.0, 0.5, 0.0]", "[5.0, 0.5, 0.0]")
                    .replace("[0.0, 1.0, 0.0]", "[5.0, 1.0, 0.0]")
            }
        };
        let first = half.replace("name = \"s\"", "name = \"t\"");
        let seam = format!(
            "[[joints]]\nkind = \"seam\"\nname = \"w\"\na = {{ body = \"t\", at = {} }}\nb = {{ body = \"s\", at = {} }}\n",
            shell.edge("right"),
            shell.edge("left")
        );
        let text = whole
            .replace(&own, &(first + &shifted))
            .replace("name = \"root\"\na = { body = \"s\"", "name = \"root\"\na = { body = \"t\"");
        let two = errors(&(text + &seam));
        let ([_, error], [_, same]) = (of(&one, "p.z"), of(&two, "p.z"));
        assert_near(&format!("{shell:?}"), same, error, 0.01 * error.abs());
    }
}

/// Thin shells are refined to a requested error by twice the elements; meshes with given nodes are not.
#[test]
fn refinement_of_shells() {
    let run = |shell: Shell| {
        let text = strip(shell, [2, 1], &(edge_force(shell) + STATICS)).replace("output.errors = true", "");
        let refined = refine(&parse(&text), 5e-3, &Interrupt::default(), |_, _| ()).unwrap();
        let mut summary = Run::of(&refined.model).summary;
        refined.history.add_to(&mut summary);
        summary
    };
    let thin = run(Thin);
    assert!(thin.meshes.len() > 1 && thin.meshes.last().unwrap().error.unwrap() <= 5e-3, "{:?}", thin.meshes);
    assert_eq!(thin.meshes[1].elements[0].1, 4 * thin.meshes[0].elements[0].1);
    assert!(thin.errors.is_some() && thin.warnings.is_empty(), "{:?}", thin.warnings);
    let given = run(Quadrilaterals);
    assert!(given.warnings.iter().any(|text| text.contains("create its mesh")), "{:?}", given.warnings);
}
