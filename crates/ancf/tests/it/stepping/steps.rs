//! Steps against runs, snapshots, and invalid arguments.

use ancf::solver::newton::Interrupt;
use ancf::{Simulation, StepError, Stepper};

use crate::common::models::parse;
use crate::runs::checkpoints::{further_runs, short_runs};
use crate::runs::recorder::run;

fn bits(row: &[f64]) -> Vec<u64> {
    row.iter().map(|x| x.to_bits()).collect()
}

/// Names of the columns that depend on the last step of the output interval, or are missing: counts.
fn state_columns(stepper: &Stepper) -> Vec<usize> {
    let columns = stepper.columns();
    (0..columns.len()).filter(|&i| columns[i].name != "iterations").collect()
}

fn duration(model: &ancf::Model) -> f64 {
    model.analysis.dynamics().unwrap().duration
}

/// All schemes, contacts, friction, redundant joints, velocity jumps, error control and equilibria: the same bits as a run.
#[test]
fn advancing_to_the_end_equals_a_run() {
    for (name, model) in short_runs().into_iter().chain(further_runs()).filter(|(_, one)| !one.output.errors)
    {
        // With an output interval, steps of a run end at its multiples.
        if model.output.interval.is_some() {
            continue;
        }
        let (recorder, summary) = run(&model, false);
        let mut stepper = Stepper::new(&model).unwrap();
        let counted = state_columns(&stepper);
        let assert_equal = |row: &[f64], there: &[u64]| {
            let own = bits(row);
            assert!(counted.iter().all(|&i| own[i] == there[i]), "{name}");
        };
        assert_equal(stepper.row(), &recorder.rows[0]);
        stepper.advance(duration(&model)).unwrap();
        assert_equal(stepper.row(), recorder.rows.last().unwrap());
        let own = stepper.summary();
        assert_eq!((own.steps, own.iterations), (summary.steps, summary.iterations), "{name}");
    }
}

/// The continuation after a snapshot has the same bits in the same stepper and in another one.
#[test]
fn snapshots_continue_with_equal_bits() {
    for (name, model) in short_runs().into_iter().chain(further_runs()).filter(|(_, one)| !one.output.errors)
    {
        let end = duration(&model);
        let mut stepper = Stepper::new(&model).unwrap();
        for part in [0.0, 0.37, 0.81] {
            stepper.advance(part * end).unwrap();
            let saved = stepper.save().unwrap();
            stepper.advance(0.95 * end).unwrap();
            let row = bits(stepper.row());
            let mut other = Stepper::new(&model).unwrap();
            other.restore(&saved).unwrap();
            assert_eq!(other.save().unwrap(), saved, "{name}");
            other.advance(0.95 * end).unwrap();
            assert_eq!(bits(other.row()), row, "{name}, other stepper");
            stepper.restore(&saved).unwrap();
            stepper.advance(0.95 * end).unwrap();
            assert_eq!(bits(stepper.row()), row, "{name}");
            assert_eq!(stepper.save().unwrap(), other.save().unwrap(), "{name}");
            stepper.restore(&saved).unwrap();
        }
    }
}

/// Mass on a spring with a force that jumps.
fn oscillator(analysis: &str) -> String {
    format!(
        "bodies = [{{ kind = \"mass\", name = \"m\", center = [0, 0, 0], mass = 2 }}]\n\
         probes = [{{ name = \"m\", on = {{ body = \"m\", at = \"center\" }} }}]\n\
         [[loads]]\nkind = \"force\"\non = {{ body = \"m\", at = \"center\" }}\nforce = [6, 0, 0]\n\
         time = {{ kind = \"step\", at = 0.1, until = 0.35 }}\n\
         [analysis]\nkind = \"dynamics\"\nduration = 1\n{analysis}\n"
    )
}

/// One step across two jumps: x = ½ a T² + a T (t − 0.35) with T = 0.25, exact for average acceleration.
#[test]
fn steps_end_at_jumps_of_loads() {
    let mut stepper =
        Stepper::new(&parse(&oscillator("step = 0.01\nscheme = \"average_acceleration\""))).unwrap();
    let report = stepper.step(0.8).unwrap();
    assert_eq!(report.substeps, 3);
    assert_eq!(stepper.time(), 0.8);
    let expected = 3.0 * 0.25 * (0.125 + 0.45);
    assert!((stepper.read("m.x").unwrap() - expected).abs() < 1e-14);
    assert!((stepper.read("m.vx").unwrap() - 0.75).abs() < 1e-14);
    // Beyond the duration.
    stepper.advance(2.0).unwrap();
    assert_eq!(stepper.time(), 2.0);
    assert!((stepper.read("m.x").unwrap() - 3.0 * 0.25 * (0.125 + 1.65)).abs() < 1e-12);
}

#[test]
fn invalid_arguments_change_nothing() {
    let model = parse(&oscillator("step = 0.01\nscheme = \"average_acceleration\""));
    let mut stepper = Stepper::new(&model).unwrap();
    stepper.advance(0.3).unwrap();
    let saved = stepper.save().unwrap();
    for h in [0.0, -0.1, f64::NAN, f64::INFINITY, 1e-300, 1e-15] {
        assert!(matches!(stepper.step(h), Err(StepError::Argument(_))), "{h}");
    }
    for until in [0.2, f64::NAN, f64::INFINITY] {
        assert!(matches!(stepper.advance(until), Err(StepError::Argument(_))), "{until}");
    }
    let error = stepper.read("m.y2").unwrap_err().to_string();
    assert!(error.starts_with("column: found \"m.y2\"") && error.contains("\"m.y\""), "{error}");
    assert!(stepper.set("thrust", 1.0).unwrap_err().to_string().contains("the model has none"));
    let mut wrong = saved.clone();
    *wrong.last_mut().unwrap() ^= 1;
    let other = parse(&oscillator("step = 0.02\nscheme = \"average_acceleration\""));
    let other = Stepper::new(&other).unwrap().save().unwrap();
    for (bytes, why) in [
        (&wrong[..], "damaged"),
        (&saved[..40], "damaged"),
        (b"", "not a snapshot"),
        (&saved[..8], "damaged"),
        (&other[..], "another model"),
    ] {
        let error = stepper.restore(bytes).unwrap_err();
        assert!(matches!(&error, StepError::Snapshot(text) if text.contains(why)), "{error}");
    }
    assert_eq!(stepper.save().unwrap(), saved);
    assert_eq!(stepper.advance(0.3).unwrap().substeps, 0);
}

/// Analyses without time, and estimates of errors, are rejected.
#[test]
fn only_motions_are_advanced() {
    let text =
        oscillator("step = 0.01").replace("\"dynamics\"\nduration = 1\nstep = 0.01", "\"modes\"\ncount = 1");
    let text = text.replace("time = { kind = \"step\", at = 0.1, until = 0.35 }\n", "");
    let error = Stepper::new(&parse(&text)).unwrap_err().to_string();
    assert!(error.contains("analysis.kind"), "{error}");
    let text = oscillator("step = 0.01\n[output]\nerrors = true");
    let error = Stepper::new(&parse(&text)).unwrap_err().to_string();
    assert!(error.contains("output.errors"), "{error}");
}

/// A step that fails states time and place; a smaller one continues from the same state.
#[test]
fn failed_steps_state_time_and_cause() {
    let (_, model) = short_runs().into_iter().find(|(name, _)| *name == "divided steps").unwrap();
    let text = toml::to_string(&model).unwrap().replace("max_halvings = 10", "max_halvings = 0");
    let mut stepper = Stepper::new(&parse(&text)).unwrap();
    let saved = stepper.save().unwrap();
    let StepError::Failed(error) = stepper.step(0.25).unwrap_err() else { panic!("another error") };
    assert!(error.starts_with("failed at t = 0.25") && error.contains("at: body `b`"), "{error}");
    assert_eq!(stepper.time(), 0.0);
    stepper.step(1e-3).unwrap();
    let row = bits(stepper.row());
    stepper.restore(&saved).unwrap();
    stepper.step(1e-3).unwrap();
    assert_eq!(bits(stepper.row())[0], row[0]);
}

/// Steppers move between threads, and two of one model do not affect each other.
#[test]
fn steppers_are_independent() {
    let (_, model) = short_runs().into_iter().find(|(name, _)| *name == "falling").unwrap();
    let alone = |mut stepper: Stepper| {
        stepper.advance(0.06).unwrap();
        bits(stepper.row())
    };
    let expected = alone(Stepper::new(&model).unwrap());
    let rows: Vec<_> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..2)
            .map(|_| Stepper::new(&model).unwrap())
            .map(|own| scope.spawn(move || alone(own)))
            .collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert!(rows.iter().all(|row| *row == expected));
    let stopped = Simulation::new(&model).unwrap().with_interrupt(Interrupt::new(|| true));
    let mut stepper = Stepper::start(stopped, None).unwrap();
    assert!(matches!(stepper.step(1e-3), Err(StepError::Interrupted)));
}

/// Beam with a body at its end and a force that an input sets.
fn held_beam(analysis: &str) -> ancf::Model {
    parse(&format!(
        r#"gravity = [0, 0, -9.81]
        inputs = [{{ name = "u", value = 0 }}]
        materials.m = {{ density = 1000, young = 1e7, poisson = 0.3 }}
        sections.s = {{ kind = "circle", diameter = 0.05 }}
        bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "s", material = "m" }},
            {{ kind = "rigid", name = "r", center = [1, 0, 0], mass = 2, inertia = [0.1, 0.1, 0.1] }}]
        joints = [{{ kind = "clamp", name = "c", a = {{ body = "b", at = "start" }} }},
            {{ kind = "clamp", name = "d", a = {{ body = "b", at = "end" }}, b = {{ body = "r", at = "center" }} }}]
        loads = [{{ kind = "force", on = {{ body = "b", at = "end" }}, force = [0, 0, 1], time = {{ kind = "input", name = "u" }} }}]
        probes = [{{ name = "p", on = {{ body = "b", at = "end" }} }}]
        [analysis]
        kind = "dynamics"
        duration = 1
        {analysis}"#
    ))
}

/// Tiny distances, such as a rounding error of the time, do not multiply rounding errors of the positions.
#[test]
fn tiny_steps_keep_accelerations_and_reactions() {
    let h: f64 = 1.0 / 3000.0;
    let columns = ["p.z", "p.vz", "p.az", "c.fz", "d.fz"];
    for analysis in [
        "step = 2e-3\nscheme = { spectral_radius = 0.8 }",
        "step = 2e-3\nscheme = \"average_acceleration\"",
        "step = { tolerance = 1e-6 }",
    ] {
        // Without a distance, and with distances that end a step and begin the next one.
        let moved = |distances: &[f64]| {
            let mut stepper = Stepper::new(&held_beam(analysis)).unwrap();
            stepper.set("u", 30.0).unwrap();
            (0..18).for_each(|_| _ = stepper.step(h).unwrap());
            for distance in distances {
                stepper.advance(stepper.time() + distance).unwrap();
            }
            let read = |stepper: &mut Stepper| columns.map(|column| stepper.read(column).unwrap());
            let near = read(&mut stepper);
            (0..3).for_each(|_| _ = stepper.step(h).unwrap());
            (near, read(&mut stepper))
        };
        let exact = moved(&[]);
        for distances in [
            &[8.7e-19][..],
            &[1e-17; 3],
            &[1e-15],
            &[1e-13; 5],
            &[1e-11],
            &[1e-9; 3],
            &[1.9e-9],
            &[2.1e-9],
            &[1e-8; 4],
            &[1e-7],
            &[1.9e-6],
        ] {
            let found = moved(distances);
            for (found, exact) in [(found.0, exact.0), (found.1, exact.1)] {
                let sizes = [1.0, 1.0, 10.0, 60.0, 60.0];
                for ((column, size), (a, b)) in columns.iter().zip(sizes).zip(found.into_iter().zip(exact)) {
                    assert!((a - b).abs() < 5e-3 * size, "{analysis}, {distances:?}, {column}: {a} {b}");
                }
            }
        }
    }
}

/// A time before the present one by a rounding error is the present one.
#[test]
fn a_time_within_its_rounding_error_has_no_step() {
    let mut stepper = Stepper::new(&held_beam("step = 2e-3")).unwrap();
    (0..10).for_each(|_| _ = stepper.step(0.001).unwrap());
    let time = stepper.time();
    let row = stepper.row().to_vec();
    for until in [0.01, time.next_down()] {
        stepper.advance(until).unwrap();
        assert_eq!((stepper.time().to_bits(), bits(stepper.row())), (time.to_bits(), bits(&row)), "{until}");
    }
    // A later time is reached, so that loops end.
    let columns = ["p.z", "p.vz", "p.az", "c.fz"];
    let read = |stepper: &mut Stepper| columns.map(|column| stepper.read(column).unwrap());
    let before = read(&mut stepper);
    stepper.advance(time.next_up()).unwrap();
    assert_eq!(stepper.time().to_bits(), time.next_up().to_bits());
    for (a, b) in read(&mut stepper).into_iter().zip(before) {
        assert!((a - b).abs() < 2e-3 * (1.0 + b.abs()), "{a} {b}");
    }
    assert!(stepper.advance(time - 1e-6).is_err());
}
