//! Sequences of analyses: statics from given states, motions that continue in time, conditions that end motions.

use ancf::reading::AnalysisSequence;
use ancf::record::Series;
use ancf::{GivenState, InitialReport, Model, Simulation, Summary};

use super::given_states::States;
use crate::common::models::parse;

/// Runs all analyses of a sequence, each from the last state before it. Returns their columns and summaries.
pub(super) fn run_all(text: &str) -> Vec<(Series, Summary)> {
    let sequence = AnalysisSequence::parse(text).unwrap().expect("a list of analyses");
    let (mut time, mut runs) = (0.0, Vec::new());
    let mut last: Option<GivenState> = None;
    for stage in sequence.stages {
        let model = Model::parse(&stage.text(time)).unwrap();
        let simulation = Simulation::new(&model).unwrap();
        let start = last.as_ref().map(|given| simulation.start_from(given).unwrap());
        let mut states = States::default();
        let summary = match &start {
            Some(start) => simulation.run_from(start, &mut states).unwrap(),
            None => simulation.run(&mut states).unwrap(),
        };
        assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
        let state = states.states.pop().unwrap();
        if model.analysis.dynamics().is_some() {
            time = summary.time;
        }
        let counted = simulation.counted_angles().into_iter();
        let angles = counted.map(|name| (name.clone(), self::last(&states.series, &name)));
        last = Some(simulation.given_state(&state, "the analysis before").with_angles(angles));
        runs.push((states.series, summary));
    }
    runs
}

pub(super) fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

/// Clamped arm under its weight, with some joints, loads and analyses.
fn arm(joints: &str, loads: &str, analyses: &str) -> String {
    format!(
        "gravity = [0, 0, -9.81]\nmaterials.m = {{ density = 1000, young = 2e8 }}\n\
         sections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
         bodies = [{{ kind = \"beam\", name = \"arm\", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = \"s\", material = \"m\" }}]\n\
         joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"arm\", at = \"start\" }} }}{joints}]\n\
         loads = [{loads}]\nanalysis = [{analyses}]\n\
         probes = [{{ name = \"tip\", on = {{ body = \"arm\", at = \"end\" }} }}]\n"
    )
}

/// The equilibrium of an elastic structure does not depend on the order in which loads and drives are applied.
#[test]
fn equilibria_do_not_depend_on_their_order() {
    let force = "{ kind = \"force\", on = { body = \"arm\", at = \"end\" }, force = [0, 3, -2]";
    let moment = "{ kind = \"moment\", on = { body = \"arm\", at = 0.5 }, moment = [1, 0, 0.4]";
    let statics = "{ kind = \"statics\", name = \"a\" }";
    let at_once = run_all(&arm("", &format!("{force} }}, {moment} }}"), statics)).remove(0).0;
    let loads = format!("{force}, only_in = [\"c\"] }}, {moment}, not_in = [\"a\"] }}");
    let names = ["a", "b", "c"].map(|name| format!("{{ kind = \"statics\", name = \"{name}\" }}"));
    let steps = run_all(&arm("", &loads, &names.join(", ")));
    for name in ["tip.x", "tip.y", "tip.z", "root.fy", "root.mx", "strain"] {
        let (a, b) = (last(&at_once, name), last(&steps[2].0, name));
        assert!((a - b).abs() < 1e-7 * a.abs(), "{name}: {a} and {b}");
    }
    assert!(matches!(steps[1].1.initial, Some(InitialReport::Released { .. })));
    // The second analysis begins where the first one ended.
    let begin = steps[1].0.column("tip.z").unwrap()[0];
    assert!((begin - last(&steps[0].0, "tip.z")).abs() < 1e-14);
}

/// A load that was removed leaves the undeformed state, also after a large rotation.
#[test]
fn unloading_returns_to_the_undeformed_state() {
    let load = "{ kind = \"force\", on = { body = \"arm\", at = \"end\" }, force = [0, 0, 20], only_in = [\"bent\"] }";
    let analyses = "{ kind = \"statics\", name = \"bent\", first = 0.1 }, { kind = \"statics\", name = \"free\", first = 0.1 }";
    let runs = run_all(&arm("", load, analyses).replace("-9.81", "0"));
    assert!(last(&runs[0].0, "tip.z") > 0.5, "{}", last(&runs[0].0, "tip.z"));
    assert!(last(&runs[1].0, "tip.z").abs() < 1e-9 && last(&runs[1].0, "strain").abs() < 1e-12);
}

/// Statics from a state ends in the equilibrium of its own load factor, which need not be 1.
#[test]
fn load_factors_of_released_states() {
    let load = "{ kind = \"force\", on = { body = \"arm\", at = \"end\" }, force = [0, 0, 0.02] }";
    let run = |first: f64, second: f64| {
        let statics =
            |name: &str, load: f64| format!("{{ kind = \"statics\", name = \"{name}\", load = {load:?} }}");
        let analyses = [statics("a", first), statics("b", second)].join(", ");
        let text = arm("", load, &analyses).replace("-9.81", "0");
        if second == 0.0 { Err(text) } else { Ok(run_all(&text)) }
    };
    let alone = |load: f64| last(&run(0.1, load).unwrap()[1].0, "tip.z");
    let one = last(&run(1.0, 1.0).unwrap()[0].0, "tip.z");
    for (first, second) in [(1.0, 0.5), (1.0, 2.0), (0.5, -1.0), (1.0, -1.0), (-1.0, -1.0)] {
        let runs = run(first, second).unwrap();
        let [tip, force] = ["tip.z", "root.fz"].map(|name| last(&runs[1].0, name));
        assert!((force + 0.02 * second).abs() < 1e-9, "{first} to {second}: {force}");
        assert!((tip - alone(second)).abs() < 1e-9 * one.abs(), "{first} to {second}: {tip}");
        assert!((tip / one - second).abs() < 0.05, "{first} to {second}: {tip} and {one}");
    }
    // Without a load factor nothing is released.
    let text = run(1.0, 0.0).unwrap_err();
    let errors = AnalysisSequence::parse(&text).unwrap_err().to_string();
    assert!(errors.contains("analysis[1].load: found 0"), "{errors}");
}

/// Statics and modes keep the angle that a motion with a driven rate has reached: a hinged rod in the field g at the angle φ has the moment
/// m g L cos φ / 2, and a rod that hangs down the frequency √(3 g/(2 L))/(2 π).
#[test]
fn equilibria_keep_driven_rates() {
    let text = |rate: f64, last: &str| {
        format!(
            "gravity = [0, -9.81, 0]\n\
             bodies = [{{ kind = \"rigid\", name = \"rod\", center = [0.5, 0, 0], mass = 2, inertia = [0.01, 0.1666666666666666, 0.1666666666666666] }}]\n\
             joints = [{{ kind = \"revolute\", name = \"h\", a = {{ body = \"rod\", at = [0, 0, 0] }}, axis = [0, 0, 1], \
             drive = {{ rate = {rate} }} }}]\n\
             probes = [{{ name = \"end\", on = {{ body = \"rod\", at = [1, 0, 0] }} }}]\n\
             analysis = [{{ kind = \"dynamics\", name = \"a\", duration = 0.5, step = 0.01, scheme = {{ spectral_radius = 0.8 }} }}, {last}]\n"
        )
    };
    let runs = run_all(&text(
        1.0,
        "{ kind = \"statics\", name = \"b\" }, { kind = \"dynamics\", name = \"c\", duration = 0.1, step = 0.01 }",
    ));
    let of = |stage: usize, name: &str| last(&runs[stage].0, name);
    let turned = of(0, "h.angle");
    assert!((turned - 0.5).abs() < 1e-9, "{turned}");
    assert!((of(1, "h.angle") - turned).abs() < 1e-12 && (of(1, "end.x") - turned.cos()).abs() < 1e-9);
    assert!((of(1, "h.mz") - 9.81 * turned.cos()).abs() < 1e-8, "{}", of(1, "h.mz"));
    assert!((of(2, "h.angle") - 0.6).abs() < 1e-9, "{}", of(2, "h.angle"));
}

/// A hinge that turns freely counts its turns through all analyses.
#[test]
fn turns_continue() {
    let text = "bodies = [{ kind = \"rigid\", name = \"rotor\", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1], motion = { spin = [0, 0, 10] } }]\n\
        joints = [{ kind = \"revolute\", name = \"h\", a = { body = \"rotor\", at = \"center\" }, axis = [0, 0, 1] }]\n\
        analysis = [{ kind = \"dynamics\", name = \"a\", duration = 1, step = 0.01 },\n\
        { kind = \"dynamics\", name = \"b\", duration = 1, step = 0.01, until = [{ value = \"h.angle\", above = 15.0 }] }]\n";
    let runs = run_all(text);
    let [first, second] = [0, 1].map(|k| runs[k].0.column("h.angle").unwrap());
    let end = *first.last().unwrap();
    assert!((end - 10.0).abs() < 0.02 && (second[0] - end).abs() < 1e-9, "{end} {}", second[0]);
    assert!((15.0..15.2).contains(second.last().unwrap()), "{:?}", second.last());
    assert!(runs[1].1.ended_by.is_some());
    assert_eq!(runs[0].1.warnings.len(), runs[1].1.warnings.len(), "{:?}", runs[1].1.warnings);
}

/// A strut between two springs that was pushed through its plane rests on the other side. Statics from the undeformed state finds
/// the first side.
#[test]
fn a_snapped_strut_stays_on_the_other_side() {
    let spring = |name: &str, x: f64| {
        format!(
            "{{ kind = \"spring\", name = \"{name}\", a = {{ body = \"apex\", at = \"center\" }}, b = {{ point = [{x}, 0, 0] }}, stiffness = 100 }}"
        )
    };
    let text = format!(
        "bodies = [{{ kind = \"mass\", name = \"apex\", center = [0, 0, 0.3], mass = 1 }}]\n\
         joints = [{{ kind = \"point_on_line\", name = \"guide\", a = {{ body = \"apex\", at = \"center\" }}, axis = [0, 0, 1] }},\n\
         {}, {},\n\
         {{ kind = \"spring\", name = \"push\", a = {{ body = \"apex\", at = \"center\" }}, b = {{ point = [0, 0, -2] }}, stiffness = 1000, length = 1.8, only_in = [\"push\"] }}]\n\
         analysis = [{{ kind = \"statics\", name = \"push\", first = 0.1 }}, {{ kind = \"statics\", name = \"leave\", first = 0.1 }}]\n\
         probes = [{{ name = \"apex\", on = {{ body = \"apex\", at = \"center\" }} }}]\n",
        spring("left", -1.0),
        spring("right", 1.0)
    );
    let runs = run_all(&text);
    assert!((last(&runs[1].0, "apex.z") + 0.3).abs() < 1e-9, "{}", last(&runs[1].0, "apex.z"));
    assert!(last(&runs[0].0, "apex.z") > -0.25 && last(&runs[0].0, "apex.z") < -0.15);
}

/// A motion in two parts has the functions of time of the whole motion. It differs by the error of a restart, of second order.
#[test]
fn motions_continue_in_time() {
    let load = "{ kind = \"force\", on = { body = \"arm\", at = \"end\" }, force = [0, 2, 0], time = { kind = \"sine\", frequency = 3 } }";
    let difference = |step: f64| {
        let part = |name: &str, duration: f64| {
            format!("{{ kind = \"dynamics\", name = \"{name}\", duration = {duration}, step = {step} }}")
        };
        let whole = run_all(&arm("", load, &part("whole", 0.4))).remove(0).0;
        let parts = run_all(&arm("", load, &format!("{}, {}", part("a", 0.25), part("b", 0.15))));
        let times = parts[1].0.column("t").unwrap();
        assert!((times[0] - 0.25).abs() < 1e-14 && (times.last().unwrap() - 0.4).abs() < 1e-12);
        assert!((times[1] - times[0] - step).abs() < 1e-12);
        (last(&whole, "tip.y") - last(&parts[1].0, "tip.y")).abs()
    };
    let [coarse, fine] = [2e-3, 5e-4].map(difference);
    assert!(coarse < 1e-4, "{coarse:e}");
    assert!(fine < coarse / 8.0, "{coarse:e} and {fine:e}");
}

/// Jumps of loads after the start of a later motion are at their times, with steps of both kinds.
#[test]
fn jumps_have_their_times_in_later_motions() {
    for step in ["0.01", "{ tolerance = 1e-5 }"] {
        let part = |name: &str| {
            format!("{{ kind = \"dynamics\", name = \"{name}\", duration = 0.5, step = {step} }}")
        };
        let text = format!(
            "bodies = [{{ kind = \"mass\", name = \"m\", center = [0, 0, 0], mass = 2 }}]\n\
             loads = [{{ kind = \"force\", on = {{ body = \"m\", at = \"center\" }}, force = [4, 0, 0], time = {{ kind = \"step\", at = 0.735 }} }}]\n\
             analysis = [{}, {}]\nprobes = [{{ name = \"m\", on = {{ body = \"m\", at = \"center\" }} }}]\n",
            part("rest"),
            part("move")
        );
        let runs = run_all(&text);
        assert_eq!(last(&runs[0].0, "m.x"), 0.0);
        let exact = 0.265_f64.powi(2);
        assert!(
            (last(&runs[1].0, "m.x") - exact).abs() < 1e-12,
            "{step}: {}",
            last(&runs[1].0, "m.x") - exact
        );
    }
}

/// The initial motion of a body is that of the first motion only.
#[test]
fn initial_motions_are_not_repeated() {
    let text = "bodies = [{ kind = \"mass\", name = \"m\", center = [0, 0, 0], mass = 2, motion = { velocity = [3, 0, 0] } }]\n\
         analysis = [{ kind = \"dynamics\", name = \"a\", duration = 0.5, step = 0.1 }, { kind = \"dynamics\", name = \"b\", duration = 0.5, step = 0.1 }]\n\
         probes = [{ name = \"m\", on = { body = \"m\", at = \"center\" } }]\n";
    let runs = run_all(text);
    assert!((last(&runs[1].0, "m.x") - 3.0).abs() < 1e-12);
}

/// A falling mass is released when the force of its hook exceeds a limit, at the time of the closed form.
#[test]
fn a_hook_opens_at_a_force() {
    let text = "bodies = [{ kind = \"mass\", name = \"m\", center = [0, 0, 0], mass = 2 }]\n\
         joints = [{ kind = \"spherical\", name = \"hook\", a = { body = \"m\", at = \"center\" }, only_in = [\"pull\"] }]\n\
         loads = [{ kind = \"force\", on = { body = \"m\", at = \"center\" }, force = [0, 0, -10], time = { kind = \"expression\", text = \"t\" } }]\n\
         probes = [{ name = \"m\", on = { body = \"m\", at = \"center\" } }]\n\
         analysis = [{ kind = \"dynamics\", name = \"pull\", duration = 9, step = 0.01, until = [{ value = \"hook.fz\", above = 7.995 }] },\n\
         { kind = \"dynamics\", name = \"fall\", duration = 1, step = 0.001 }]\n";
    let runs = run_all(text);
    let (pull, summary) = &runs[0];
    assert_eq!(summary.ended_by.as_deref(), Some("`hook.fz` = 8, above 7.995"));
    assert!((summary.time - 0.8).abs() < 1e-12 && (last(pull, "t") - 0.8).abs() < 1e-12);
    assert!(summary.warnings.is_empty(), "{:?}", summary.warnings);
    // m z'' = -10 t from t = 0.8 on: m z = -10 (t^3/6 - 0.32 t + 0.512/3).
    let t = 1.8_f64;
    let exact = -5.0 * (t.powi(3) / 6.0 - 0.32 * t + 0.512 / 3.0);
    assert!((last(&runs[1].0, "m.z") - exact).abs() < 1e-6, "{} and {exact}", last(&runs[1].0, "m.z"));
}

/// Conditions are in the units of the model, whatever the units of the solver. One that is not met is a warning.
#[test]
fn conditions_do_not_depend_on_units() {
    let text = |more: &str, limit: f64| {
        format!(
            "bodies = [{{ kind = \"mass\", name = \"m\", center = [0, 0, 0], mass = 2 }}]\n\
             loads = [{{ kind = \"force\", on = {{ body = \"m\", at = \"center\" }}, force = [0, 0, -20] }}]\n\
             probes = [{{ name = \"m\", on = {{ body = \"m\", at = \"center\" }} }}]\n{more}\
             analysis = {{ kind = \"dynamics\", duration = 1, step = 0.01, until = [{{ value = \"m.z\", below = {limit} }}] }}\n"
        )
    };
    let end = |model: &Model| {
        let simulation = Simulation::new(model).unwrap();
        let summary = simulation.run(&mut States::default()).unwrap();
        (summary.time, summary.warnings, summary.ended_by)
    };
    let own = parse(&text("", -1.246));
    let scaled =
        parse(&text("scales = { kind = \"given\", length = 0.003, force = 70, time = 0.2 }\n", -1.246));
    let converted = own.scaled(&ancf::Scales { length: 0.01, time: 2.0, force: 30.0 });
    for (model, unit) in [(&own, 1.0), (&scaled, 1.0), (&converted, 2.0)] {
        let (time, warnings, ended_by) = end(model);
        assert!((time * unit - 0.5).abs() < 1e-9, "{time}");
        assert!(warnings.is_empty() && ended_by.is_some());
    }
    let (time, warnings, ended_by) = end(&parse(&text("", -9.0)));
    assert!((time - 1.0).abs() < 1e-12 && ended_by.is_none());
    assert!(
        warnings.iter().any(|text| text.contains("no condition of `analysis.until` was met")),
        "{warnings:?}"
    );
}

/// A joint that closes between two moving masses is an inelastic impact: momentum stays, and half of the energy is lost.
#[test]
fn a_joint_that_closes_is_an_inelastic_impact() {
    let text = "bodies = [{ kind = \"mass\", name = \"a\", center = [0, 0, 0], mass = 2, motion = { velocity = [3, 0, 0] } },\n\
         { kind = \"mass\", name = \"b\", center = [0, 0, 0], mass = 2 }]\n\
         joints = [{ kind = \"spherical\", name = \"catch\", a = { body = \"a\", at = \"center\" }, b = { body = \"b\", at = \"center\" }, only_in = [\"joined\"] }]\n\
         analysis = [{ kind = \"dynamics\", name = \"apart\", duration = 1e-6, step = 1e-6 }, { kind = \"dynamics\", name = \"joined\", duration = 1, step = 0.1 }]\n\
         probes = [{ name = \"b\", on = { body = \"b\", at = \"center\" } }]\n";
    let runs = run_all(text);
    assert!((last(&runs[1].0, "b.vx") - 1.5).abs() < 1e-9);
    assert!((runs[1].0.column("kinetic").unwrap()[0] / last(&runs[0].0, "kinetic") - 0.5).abs() < 1e-9);
    let Some(InitialReport::Given { corrected, .. }) = runs[1].1.initial else { panic!("a report") };
    assert!((corrected - 0.5).abs() < 1e-9, "{corrected}");
    assert!(
        runs[1].1.warnings.iter().any(|text| text.contains("kinetic energy")),
        "{:?}",
        runs[1].1.warnings
    );
}

/// Values of other keys may differ between analyses.
#[test]
fn analyses_may_set_values() {
    let force = "{ kind = \"force\", on = { body = \"arm\", at = \"end\" }, force = [0, 0, 1] }";
    let set = "{ kind = \"statics\", name = \"a\" }, { kind = \"statics\", name = \"b\", set = { gravity = [0, 0, 0], \"loads[0].force\" = [0, 1, 0] } }";
    let runs = run_all(&arm("", force, set));
    assert!(last(&runs[1].0, "tip.z").abs() < 1e-9);
    let alone =
        arm("", &force.replace("[0, 0, 1]", "[0, 1, 0]"), "{ kind = \"statics\" }").replace("-9.81", "0");
    let (a, b) = (last(&run_all(&alone)[0].0, "tip.y"), last(&runs[1].0, "tip.y"));
    assert!((a - b).abs() < 1e-8 * a, "{a} {b}");
}

/// A joint with a drive that begins in a later analysis starts at the angle of the body.
#[test]
fn coordinates_of_new_joints_follow_from_the_state() {
    let text = "bodies = [{ kind = \"rigid\", name = \"r\", center = [1, 0, 0], mass = 2, inertia = [0.1, 0.2, 0.3] }]\n\
         joints = [{ kind = \"revolute\", name = \"free\", a = { body = \"r\", at = [0, 0, 0] }, axis = [0, 0, 1], only_in = [\"turn\"] },\n\
         { kind = \"revolute\", name = \"sprung\", a = { body = \"r\", at = [0, 0, 0] }, axis = [0, 0, 1], spring = { stiffness = 5 }, only_in = [\"back\"] }]\n\
         loads = [{ kind = \"moment\", on = { body = \"r\", at = \"center\" }, moment = [0, 0, 2.3], only_in = [\"turn\"] }]\n\
         analysis = [{ kind = \"dynamics\", name = \"turn\", duration = 1, step = 0.01 }, { kind = \"dynamics\", name = \"back\", duration = 0.5, step = 0.01 }]\n\
         probes = [{ name = \"r\", on = { body = \"r\", at = \"center\" } }]\n";
    let runs = run_all(text);
    // Inertia about the hinge 2.3: the angle is t^2/2.
    let angle = runs[1].0.column("sprung.angle").unwrap()[0];
    assert!((angle - 0.5).abs() < 1e-3, "{angle}");
    let Some(InitialReport::Given { moved, .. }) = runs[1].1.initial else { panic!("a report") };
    assert!(moved < 1e-3, "{moved}");
}

/// Modes about the state of an analysis are those about the equilibrium of all loads.
#[test]
fn modes_start_from_the_state_before() {
    let load = "{ kind = \"force\", on = { body = \"arm\", at = \"end\" }, force = [40, 0, 0] }";
    let modes = "{ kind = \"modes\", about = \"equilibrium\", count = 3 }";
    let alone = run_all(&arm("", load, modes)).remove(0).0;
    let after = run_all(&arm("", load, &format!("{{ kind = \"statics\" }}, {modes}"))).remove(1).0;
    for (a, b) in alone.column("frequency").unwrap().iter().zip(after.column("frequency").unwrap()) {
        assert!((a - b).abs() < 1e-7 * a, "{a} {b}");
    }
}

/// All errors of a sequence are reported at their places in the file, errors of shared parts once.
#[test]
fn errors_have_their_places_in_the_file() {
    let message = |text: &str| AnalysisSequence::parse(text).unwrap_err().to_string();
    let load = "{ kind = \"force\", on = { body = \"arm\", at = \"end\" }, force = [0, 0, \"x\"], only_in = [\"hang\", \"puls\"] }";
    let other =
        "{ kind = \"force\", on = { body = \"am\", at = \"end\" }, force = [0, 0, 1], not_in = [\"hang\"] }";
    let analyses = "{ kind = \"statics\", name = \"hang\" }, { kind = \"dynamics\", name = \"pull\", duration = 1, step = 2, set = { gravty = 1 } }";
    let text = arm("", &format!("{load}, {other}"), analyses);
    let errors = message(&text);
    for expected in [
        "loads[0].only_in[1]: found \"puls\", expected an analysis: \"hang\" or \"pull\" (did you mean \"pull\"?)",
        "loads[0].force[2]: found \"x\", expected a number",
        "loads[1].on.body: found \"am\"",
        "analysis[1].step: found 2, expected at most the duration, 1",
        "analysis[1].set.gravty: found unknown key `gravty`",
    ] {
        assert_eq!(errors.matches(expected).count(), 1, "{expected}\n{errors}");
    }
    let twice = arm("", "", "{ kind = \"statics\" }, { kind = \"statics\" }");
    assert!(
        message(&twice)
            .contains("analysis[1].name: found no name, and a second \"statics\", expected a unique name")
    );
    let path = arm("", "", "{ kind = \"statics\" }, { kind = \"path\" }");
    assert!(
        message(&path).contains("for a path, expected \"undeformed\", or an analysis that starts in a state"),
        "{}",
        message(&path)
    );
    let single = Model::parse(&arm("", "", "{ kind = \"statics\" }")).unwrap_err().to_string();
    assert!(single.contains("analysis: found a list of 1 analyses, expected a single analysis"), "{single}");
    let unknown =
        "{ kind = \"dynamics\", duration = 1, step = 0.1, until = [{ value = \"tip.zz\", above = 1 }] }";
    let sequence = AnalysisSequence::parse(&arm("", "", unknown)).unwrap().unwrap();
    let error = Simulation::new(&sequence.stages[0].model).unwrap_err().to_string();
    assert!(
        error.contains("analysis.until[0].value: found \"tip.zz\", expected a column of the results"),
        "{error}"
    );
}
