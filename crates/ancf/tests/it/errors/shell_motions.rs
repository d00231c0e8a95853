//! Errors of motions of shells: ratios of estimated and true errors, starts, and results that do not change.

use ancf::estimate::MotionErrors;
use ancf::record::Series;
use ancf::simulate;

use super::motions::{ratio, run};
use super::shells::{Quadrilaterals, Shell, Thin, Triangles};
use crate::common::models::parse;

const SIDES: [f64; 2] = [1.0, 0.2];

/// Strip that is clamped at its left edge and released under its weight; ω = 20 rad/s for small vibrations.
fn strip(shell: Shell, elements: [u32; 2], record: &str, rest: &str) -> String {
    format!(
        "gravity = [0, 0, -9.81]\nmaterials.m = {{ young = 1e9, density = 1000 }}\n{}\
         [[joints]]\nkind = \"support\"\nname = \"root\"\na = {{ body = \"s\", at = {} }}\ncondition = \"clamped\"\n{}{rest}",
        shell.body(SIDES, elements, 0.02),
        shell.edge("left"),
        shell.probe(SIDES, [1.0, 0.1], record),
    )
}

/// Analysis of 0.4 s in steps h.
fn motion(step: &str, rest: &str) -> String {
    format!(
        "[analysis]\nkind = \"dynamics\"\nduration = 0.4\nstep = {step}\nscheme = {{ spectral_radius = 0.8 }}\n{rest}"
    )
}

/// The estimate is that of the steps and the mesh: the reference has a quarter of both.
#[test]
fn errors_of_free_vibrations() {
    let text = |shell, elements, h: f64| strip(shell, elements, "", &motion(&h.to_string(), ""));
    let fine = run(&text(Thin, [12, 2], 1.25e-3), false).0;
    for (shell, elements, h) in [
        (Thin, [1, 1], 1.25e-3),
        (Thin, [2, 1], 1e-2),
        (Quadrilaterals, [4, 1], 5e-3),
        (Quadrilaterals, [8, 1], 1e-2),
        (Triangles, [8, 1], 5e-3),
    ] {
        let (found, errors) = run(&text(shell, elements, h), true);
        let [ratio, size] = ratio(&found, &fine, (h / 1.25e-3).round() as usize, "p.z");
        assert!((0.5..2.0).contains(&ratio), "{shell:?}, {elements:?}, {h}: {ratio} of {size}");
        let errors = errors.unwrap();
        assert!(errors.are_steps_known && errors.is_mesh_known && !errors.is_rough);
        let finer = errors.finer.as_ref().unwrap();
        let order = if shell == Thin { 4.0 } else { 2.0 };
        assert_eq!((finer.order, finer.reason.as_deref()), (Some(order), None));
        assert!(errors.sentence().contains("a second solution with"), "{}", errors.sentence());
    }
}

/// Errors of the steps of forces and stresses are derivatives along those of the state.
#[test]
fn all_columns_of_shells_have_errors() {
    for shell in [Thin, Quadrilaterals] {
        let record = "record = [\"motion\", \"rotation\", \"resultants\", \"surface_stress\"]";
        let text = strip(shell, [2, 1], record, &motion("0.01", ""));
        let (found, errors) = run(&text, true);
        let values = errors.unwrap().values;
        for column in ["p.z", "p.e2", "p.muu", "p.von_mises", "root.my"] {
            let of_column = |name: &str| found.column(name).unwrap().last().copied();
            let value = values.iter().find(|value| value.column == column).unwrap();
            assert_eq!(of_column(&format!("{column}_error")), Some(value.error), "{column}");
            assert_eq!(of_column(column), Some(value.value), "{column}");
            assert!(value.error.is_finite());
        }
        let count = found.columns().filter(|(name, _)| name.ends_with("_error")).count();
        assert_eq!(count, values.len());
    }
}

/// Adaptive and divided steps, jumps of loads and output at intervals: the estimate leaves the motion, and the second motion takes its steps.
#[test]
fn motions_with_and_without_errors_are_equal() {
    let pulse = "[[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nforce = [0, 0, 300]\ntime = { kind = \"step\", at = 0.0523, until = 0.2 }\n";
    for (shell, elements, step, rest) in [
        (Thin, [2, 1], "{ tolerance = 1e-3 }", ""),
        (Quadrilaterals, [4, 1], "5e-3", "[output]\ninterval = 0.04\n"),
        (Thin, [2, 1], "0.05", ""),
    ] {
        let text = strip(shell, elements, "", &format!("{pulse}{}", motion(step, rest)));
        let [(with, errors), (without, _)] = [true, false].map(|has_errors| run(&text, has_errors));
        for (column, values) in without.columns() {
            let same = with.column(column).unwrap();
            assert!(same.iter().zip(values).all(|(a, b)| a.to_bits() == b.to_bits()), "{column}");
        }
        let errors = errors.unwrap();
        assert!(errors.is_mesh_known && errors.worst().unwrap().1[1] < 0.2, "{}", errors.sentence());
    }
}

/// Strip that swings from its equilibrium under a released load: the first error is that of the equilibrium.
#[test]
fn errors_from_an_equilibrium() {
    let load = "[[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nforce = [0, 0, 100]\ntime = { kind = \"step\", at = 0, until = 0.05 }\n\
                [initial]\nfrom = \"equilibrium\"\n";
    let text = |elements, h: f64| strip(Thin, elements, "", &format!("{load}{}", motion(&h.to_string(), "")));
    let fine = run(&text([8, 1], 2.5e-3), false).0;
    let (found, errors) = run(&text([1, 1], 5e-3), true);
    let [ratio, size] = ratio(&found, &fine, 2, "p.z");
    assert!((0.5..2.0).contains(&ratio), "{ratio} of {size}");
    let first = |series: &Series, column: &str| series.column(column).unwrap()[0];
    let missing = first(&fine, "p.z") - first(&found, "p.z");
    let effectivity = first(&found, "p.z_error") / missing;
    assert!((0.7..1.4).contains(&effectivity), "{effectivity} of {missing}");
    assert!(errors.unwrap().is_mesh_known);
}

/// Free flight of a sheet has no errors.
#[test]
fn rigid_translations_are_exact() {
    for shell in [Thin, Quadrilaterals] {
        let body = shell
            .body(SIDES, [2, 1], 0.02)
            .replace("name = \"s\"\n", "name = \"s\"\nmotion = { velocity = [1, 2, 3] }\n");
        let text = format!(
            "materials.m = {{ young = 1e9, density = 1000 }}\n{body}{}{}",
            shell.probe(SIDES, [1.0, 0.1], ""),
            motion("0.1", "")
        );
        let errors = run(&text, true).1.unwrap();
        let [probe] = errors.probes.as_slice() else { panic!("one probe") };
        assert!(probe.displacement > 1.0 && probe.steps + probe.mesh < 1e-9, "{shell:?}: {probe:?}");
    }
}

/// Units have no effect, and forces at points are a reason for an order of magnitude.
#[test]
fn relative_errors_and_reasons() {
    let relative = |errors: &MotionErrors| errors.worst().unwrap().1;
    let text = strip(Thin, [2, 1], "", &motion("0.01", ""));
    let scaled = format!("scales = {{ kind = \"given\", length = 0.01, time = 3, force = 700 }}\n{text}");
    let [own, same] = [&text, &scaled].map(|text| relative(&run(text, true).1.unwrap()));
    for (own, same) in own.iter().zip(same) {
        assert!((own / same - 1.0).abs() < 1e-4, "{own} {same}");
    }
    let force = "[[loads]]\nkind = \"force\"\non = { body = \"s\", at = [1, 0.5] }\nforce = [0, 0, 1]\n";
    let errors = run(&strip(Thin, [2, 1], "", &format!("{force}{}", motion("0.01", ""))), true).1.unwrap();
    assert!(errors.is_rough && errors.is_mesh_known);
    assert!(errors.sentence().contains("forces act at points of shell `s`"), "{}", errors.sentence());
}

/// A force within an element of a curved mesh has no place on the finer one: the motion finishes, and the mesh is not known.
#[test]
fn failed_second_motions_are_stated() {
    let body = Quadrilaterals.body(SIDES, [2, 1], 0.02);
    let bent =
        body.replace("[0.5, 0.0, 0.0]", "[0.5, 0.0, 0.05]").replace("[0.5, 0.2, 0.0]", "[0.5, 0.2, 0.05]");
    let force =
        "[[loads]]\nkind = \"force\"\non = { body = \"s\", at = [0.75, 0.1, 0.025] }\nforce = [0, 0, 0.01]\n";
    let text =
        strip(Quadrilaterals, [2, 1], "", &format!("{force}{}", motion("0.02", ""))).replace(&body, &bent);
    let mut model = parse(&text);
    model.output.errors = true;
    let mut series = Series::new();
    let errors = simulate(&model, &mut series).unwrap().motion_errors.unwrap();
    assert!(errors.are_steps_known && !errors.is_mesh_known && errors.values.is_empty());
    let sentence = errors.sentence();
    assert!(sentence.contains("mesh not known") && sentence.contains("`loads[0].on.at`"), "{sentence}");
    assert!(series.column("p.z_error").unwrap().iter().all(|error| error.is_nan()));
}
