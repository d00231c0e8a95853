//! Inputs of loads and drives, against closed forms.

use ancf::record::Series;
use ancf::{InputUse, Model, StepError, Stepper, simulate};

use crate::common::models::parse;

const SCALES: [&str; 3] = [
    "",
    "scales = { kind = \"given\", length = 3, force = 0.7, time = 0.13 }\n",
    "scales = { kind = \"auto\" }\n",
];

/// Mass of 2 with a thrust along x.
fn cart(scales: &str, value: f64, analysis: &str) -> String {
    format!(
        "{scales}bodies = [{{ kind = \"mass\", name = \"m\", center = [1, 0, 0], mass = 2 }}]\n\
         inputs = [{{ name = \"thrust\", value = {value} }}]\n\
         probes = [{{ name = \"m\", on = {{ body = \"m\", at = \"center\" }} }}]\n\
         [[loads]]\nkind = \"force\"\non = {{ body = \"m\", at = \"center\" }}\nforce = [4, 0, 0]\n\
         time = {{ kind = \"input\", name = \"thrust\" }}\n\
         [analysis]\nkind = \"dynamics\"\nduration = 1\n{analysis}\n"
    )
}

const EXACT: &str = "step = 0.01\nscheme = \"average_acceleration\"";

/// Piecewise constant and linear forces: velocities and work are exact for average acceleration with the steps at the jumps.
#[test]
fn forces_follow_their_inputs() {
    for scales in SCALES {
        for analysis in [
            EXACT,
            "step = { tolerance = 1e-8 }\nscheme = { spectral_radius = 0.8 }",
            "step = 0.01\nscheme = \"energy\"",
        ] {
            let mut stepper = Stepper::new(&parse(&cart(scales, 0.5, analysis))).unwrap();
            let tolerance = if analysis == EXACT { 1e-12 } else { 2e-6 };
            let near = |found: f64, expected: f64| {
                assert!(
                    (found - expected).abs() < tolerance,
                    "{scales}, {analysis}: {found}, not {expected}"
                );
            };
            stepper.advance(0.2).unwrap();
            near(stepper.read("m.vx").unwrap(), 0.2);
            stepper.set("thrust", -1.0).unwrap();
            // The jump is that of the next step.
            near(stepper.read("m.ax").unwrap(), 1.0);
            stepper.step(0.1).unwrap();
            near(stepper.read("m.vx").unwrap(), 0.0);
            near(stepper.read("m.ax").unwrap(), -2.0);
            // From −1 to 1 within 0.2: mean 0, then 1.
            stepper.set_within("thrust", 1.0, 0.2).unwrap();
            stepper.advance(0.4).unwrap();
            near(stepper.input("thrust").unwrap(), 0.0);
            near(stepper.read("m.vx").unwrap(), -0.1);
            stepper.advance(0.9).unwrap();
            near(stepper.read("m.vx").unwrap(), 0.8);
            let energies = stepper.energies();
            near(energies[0].1, 0.64);
            // The work of varying forces has the error of the quadrature.
            assert!((energies[3].1 - 0.64).abs() < 4e-4 && energies[5].1.abs() < 4e-4, "{energies:?}");
        }
    }
}

/// Runs use the declared value, in dynamics and in statics.
#[test]
fn runs_use_the_declared_values() {
    for scales in SCALES {
        let model = parse(&cart(scales, 0.5, EXACT));
        let mut series = Series::new();
        let summary = simulate(&model, &mut series).unwrap();
        assert!((series.column("m.x").unwrap().last().unwrap() - 1.5).abs() < 1e-12);
        assert_eq!(summary.inputs, [("thrust".to_owned(), 0.5)]);
        let spring = "[[joints]]\nkind = \"spring\"\nname = \"s\"\na = { body = \"m\", at = \"center\" }\n\
                      b = { point = [0, 0, 0] }\nstiffness = 8\nlength = 1\n[analysis]";
        let text = cart(scales, 0.5, "").replace("[analysis]", spring);
        let text = text.replace("\"dynamics\"\nduration = 1\n", "\"statics\"\n");
        let text = text.replace(
            "name = \"s\"",
            "name = \"s\"\n[[joints]]\nkind = \"prismatic\"\nname = \"rail\"\na = { body = \"m\", at = \"center\" }\naxis = [1, 0, 0]\n[[joints]]\nkind = \"spring\"\nname = \"s\"",
        );
        let text = text.replacen("[[joints]]\nkind = \"spring\"\nname = \"s\"\n", "", 1);
        let text = text
            .replace("kind = \"mass\"", "kind = \"rigid\"")
            .replace("mass = 2", "mass = 2, inertia = [1, 1, 1]");
        let mut series = Series::new();
        let summary = simulate(&parse(&text), &mut series).unwrap();
        assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
        assert!((series.column("m.x").unwrap().last().unwrap() - 1.25).abs() < 1e-9);
    }
}

/// Inputs that are applied at once: values are those after the jump, and the next step has the same bits.
#[test]
fn inputs_are_applied_at_once() {
    let model = parse(&cart("", 0.5, EXACT));
    let [mut one, mut other] = [(); 2].map(|()| Stepper::new(&model).unwrap());
    for stepper in [&mut one, &mut other] {
        stepper.advance(0.2).unwrap();
        stepper.set("thrust", -1.0).unwrap();
    }
    one.apply_inputs().unwrap();
    assert!((one.read("m.ax").unwrap() + 2.0).abs() < 1e-12);
    assert!((one.read("m.vx").unwrap() - 0.2).abs() < 1e-12);
    for stepper in [&mut one, &mut other] {
        stepper.step(0.1).unwrap();
    }
    assert_eq!(one.row(), other.row());
    assert_eq!(one.input_use("thrust").unwrap(), InputUse::Load);
    assert!(one.input_use("none").is_err());
}

/// Rotor of inertia 0.5 about z whose hinge is driven.
fn rotor(scales: &str, drive: &str) -> String {
    format!(
        "{scales}bodies = [{{ kind = \"rigid\", name = \"r\", center = [0, 0, 0], mass = 2, inertia = [0.3, 0.3, 0.5] }}]\n\
         inputs = [{{ name = \"motor\" }}]\n\
         [[joints]]\nkind = \"revolute\"\nname = \"shaft\"\na = {{ body = \"r\", at = \"center\" }}\naxis = [0, 0, 1]\n\
         drive = {{ {drive} = 2, time = {{ kind = \"input\", name = \"motor\" }} }}\n\
         [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\nscheme = {{ spectral_radius = 0.8 }}\n"
    )
}

/// A driven rate may jump: angle, work of the velocity jumps ½ J ω², and snapshots in the middle of a transition.
#[test]
fn rates_of_drives_follow_their_inputs() {
    for scales in SCALES {
        let model = parse(&rotor(scales, "rate"));
        let mut stepper = Stepper::new(&model).unwrap();
        stepper.advance(0.1).unwrap();
        stepper.set("motor", 3.0).unwrap();
        stepper.advance(0.3).unwrap();
        let near = |found: f64, expected: f64| {
            assert!((found - expected).abs() < 1e-9, "{scales}: {found}, not {expected}");
        };
        near(stepper.read("shaft.angle").unwrap(), 1.2);
        let work = |stepper: &mut Stepper, expected: f64| {
            let work = stepper.read("work").unwrap();
            assert!((work - expected).abs() < 5e-3, "{scales}: {work}, not {expected}");
        };
        work(&mut stepper, 0.25 * 36.0);
        stepper.set_within("motor", 1.0, 0.1).unwrap();
        stepper.advance(0.33).unwrap();
        let saved = stepper.save().unwrap();
        stepper.advance(0.5).unwrap();
        near(stepper.read("shaft.angle").unwrap(), 1.2 + 0.4 + 0.2);
        work(&mut stepper, 1.0);
        let end: Vec<u64> = stepper.row().iter().map(|x| x.to_bits()).collect();
        let mut other = Stepper::new(&model).unwrap();
        other.restore(&saved).unwrap();
        other.advance(0.5).unwrap();
        assert!(other.row().iter().map(|x| x.to_bits()).eq(end));
    }
}

/// A driven angle follows linear transitions; a jump is rejected.
#[test]
fn driven_positions_do_not_jump() {
    for scales in SCALES {
        let mut stepper = Stepper::new(&parse(&rotor(scales, "angle"))).unwrap();
        let error = stepper.set("motor", 0.3).unwrap_err().to_string();
        assert!(error.contains("`ramp` > 0") && error.contains("must not jump"), "{error}");
        stepper.set("motor", 0.0).unwrap();
        stepper.set_within("motor", 0.3, 0.2).unwrap();
        stepper.advance(0.1).unwrap();
        assert!((stepper.read("shaft.angle").unwrap() - 0.3).abs() < 1e-12);
        assert!((stepper.read("shaft.rate").unwrap() - 3.0).abs() < 1e-9);
        stepper.advance(0.3).unwrap();
        assert!((stepper.read("shaft.angle").unwrap() - 0.6).abs() < 1e-12);
        assert!(stepper.read("shaft.rate").unwrap().abs() < 1e-9);
        let work = stepper.read("work").unwrap();
        assert!(work.abs() < 5e-3, "{work}");
    }
}

#[test]
fn wrong_values_are_rejected() {
    let mut stepper = Stepper::new(&parse(&cart("", 0.0, EXACT))).unwrap();
    for (name, value, ramp) in [
        ("thrust", f64::NAN, 0.0),
        ("thrust", f64::INFINITY, 0.0),
        ("thrust", 1.0, -1.0),
        ("thurst", 1.0, 0.0),
    ] {
        assert!(matches!(stepper.set_within(name, value, ramp), Err(StepError::Argument(_))), "{name}");
    }
    assert!(stepper.set("thurst", 1.0).unwrap_err().to_string().contains("perhaps \"thrust\""));
    let text = cart("", 0.0, EXACT);
    let cases = [
        (text.replace("name = \"thrust\" }", "name = \"trust\" }"), "loads[0].time.name"),
        (text.replace("time = { kind = \"input\", name = \"thrust\" }", ""), "inputs[0].name"),
        (text.replace("value = 0 }]", "value = 0 }, { name = \"thrust\" }]"), "inputs[1].name"),
        (text.replace("value = 0 }]", "value = inf }]"), "inputs[0].value"),
    ];
    for (text, path) in cases {
        let errors = Model::parse(&text).unwrap_err();
        assert!(errors.iter().any(|error| error.path == path), "{path}: {errors}");
    }
}
