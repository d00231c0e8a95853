//! Runs resumed from checkpoints are bitwise equal to uninterrupted runs.

use ancf::{Checkpoint, Error, Model, ResumeError, Simulation, Summary};

use super::recorder::{Recorder, bytes, file, interrupted, read, resumed, run, run_to};
use crate::common::models::{files, parse};

/// Beam clamped at its start, with additional parts and an analysis.
fn beam(damping: &str, parts: &str, analysis: &str) -> Model {
    parse(&format!(
        "gravity = [0, -9.81, 0]\nmaterials.m = {{ density = 1000, young = 2e8{damping} }}\n\
         sections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
         [[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nelements = 3\nsection = \"s\"\n\
         material = \"m\"\n[[joints]]\nkind = \"clamp\"\nname = \"root\"\na = {{ body = \"b\", at = \"start\" }}\n\
         [[probes]]\nname = \"tip\"\non = {{ body = \"b\", at = \"end\" }}\n{parts}\n\
         [analysis]\nkind = \"dynamics\"\n{analysis}\n"
    ))
}

const PULSE: &str = "[[loads]]\nkind = \"force\"\non = { body = \"b\", at = \"end\" }\nforce = [0, 1, 2]\n\
                     time = { kind = \"step\", at = 0.0123, until = 0.03 }\n";

/// Arm whose drive changes its rate suddenly: velocity jumps.
fn velocity_jumps(analysis: &str) -> Model {
    parse(&format!(
        "bodies = [{{ kind = \"rigid\", name = \"arm\", center = [1, 0, 0], mass = 2, inertia = [1, 2, 3] }},\n\
         {{ kind = \"rigid\", name = \"end\", center = [2, 0, 0], mass = 1, inertia = [1, 1, 1] }}]\n\
         [[joints]]\nkind = \"revolute\"\nname = \"motor\"\na = {{ body = \"arm\", at = [0, 0, 0] }}\naxis = [0, 0, 1]\n\
         drive = {{ angle = 1, time = {{ kind = \"table\", times = [0, 0.02, 0.05, 1], values = [0, 0.1, 0, 1] }} }}\n\
         [[joints]]\nkind = \"revolute\"\nname = \"elbow\"\na = {{ body = \"end\", at = [2, 0, 0] }}\n\
         b = {{ body = \"arm\", at = [2, 0, 0] }}\naxis = [0, 0, 1]\nspring = {{ stiffness = 10, damping = 1 }}\n\
         [analysis]\nkind = \"dynamics\"\n{analysis}\n"
    ))
}

/// Cable that falls on another one and on a floor.
fn falling(analysis: &str) -> Model {
    parse(&format!(
        "gravity = [0, 0, -9.81]\n\
         materials.m = {{ density = 1000, young = 1e7, damping = {{ strain = 1e-3 }} }}\n\
         sections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
         bodies = [{{ kind = \"cable\", name = \"low\", from = [-0.2, 0, 0], to = [0.2, 0, 0.01], elements = 4, section = \"s\", \
         material = \"m\" }},\n\
         {{ kind = \"cable\", name = \"high\", from = [0, -0.2, 0.07], to = [0.05, 0.2, 0.1], elements = 4, section = \"s\", \
         material = \"m\" }}]\n\
         [[contacts]]\nwith = {{ kind = \"plane\", point = [0, 0, -0.02], normal = [0, 0, 1] }}\nstiffness = 1e5\n\
         friction = 0.3\nslip_speed = 0.01\n\
         [[contacts]]\nwith = {{ kind = \"bodies\" }}\nstiffness = 1e5\n\
         [analysis]\nkind = \"dynamics\"\n{analysis}\n"
    ))
}

const EQUILIBRIUM: &str = "[initial]\nfrom = \"equilibrium\"";
const HALF: &str = "scheme = { spectral_radius = 0.5 }";

/// Sheet that is released from its equilibrium.
fn sheet(settings: &str) -> Model {
    parse(&format!(
        "gravity = [0, 0, -9.81]\nmaterials.m = {{ young = 1e9, density = 1000 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"s\"\nmaterial = \"m\"\nthickness = 0.02\nelements = [2, 1]\n\
         surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 0.2, 0] }}\n\
         [[joints]]\nkind = \"support\"\nname = \"root\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\n\
         condition = \"clamped\"\n[[probes]]\nname = \"tip\"\non = {{ body = \"s\", at = [1, 0.5] }}\n\
         [[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nforce = [0, 0, 100]\n\
         time = {{ kind = \"step\", at = 0.0123, until = 0.03 }}\n{EQUILIBRIUM}\n\
         [analysis]\nkind = \"dynamics\"\nduration = 0.1\n{HALF}\n{settings}\n"
    ))
}

/// Short runs with errors and from an equilibrium.
pub(crate) fn further_runs() -> [(&'static str, Model); 6] {
    let errors = |parts: &str, settings: &str| {
        beam("", parts, &format!("duration = 0.08\n{settings}\n{HALF}\n[output]\nerrors = true"))
    };
    let damped = ", damping = { strain = 1e-3, mass = 0.5 }";
    let settled = |damping: &str, step: &str| {
        beam(damping, PULSE, &format!("duration = 0.1\n{step}\n{HALF}\n{EQUILIBRIUM}"))
    };
    [
        ("errors", errors(PULSE, "step = 2e-3")),
        ("errors, adaptive", errors("", "step = { tolerance = 1e-4 }")),
        ("errors of a shell", sheet("step = 2e-3\n[output]\nerrors = true\ninterval = 0.01")),
        ("errors of a shell, adaptive", sheet("step = { tolerance = 1e-4 }\n[output]\nerrors = true")),
        ("from equilibrium", settled(damped, "step = 4e-3")),
        ("from equilibrium, adaptive", settled("", "step = { tolerance = 1e-4 }")),
    ]
}

/// Short runs of many kinds.
pub(crate) fn short_runs() -> Vec<(&'static str, Model)> {
    let damped = ", damping = { strain = 1e-3, mass = 0.5 }";
    let joint = "[[joints]]\nkind = \"spherical\"\nname = \"again\"\na = { body = \"b\", at = \"start\" }\n";
    vec![
        ("cantilever", file("cantilever", "duration = 0.05\nstep = 1e-3\nstart = \"zero\"")),
        ("reused tangents", beam("", "", &format!("duration = 0.2\nstep = 2e-3\n{HALF}"))),
        ("new tangents", beam("", "", &format!("duration = 0.05\nstep = 2e-3\nnewton = \"full\"\n{HALF}"))),
        (
            "absolute rule",
            beam("", "", "duration = 0.05\nstep = 2e-3\nstop = { rule = \"increment\", tolerance = 1e-9 }"),
        ),
        ("damping", beam(damped, PULSE, "duration = 0.051\nstep = 2e-3")),
        ("divided steps", beam("", "", "duration = 1\nstep = 0.1\nmax_iterations = 6")),
        ("redundant joints", beam("", joint, &format!("duration = 0.04\nstep = 2e-3\n{HALF}"))),
        ("four bars", file("four_bar", &format!("duration = 0.6\nstep = 0.02\n{HALF}"))),
        ("double pendulum", file("double_pendulum", "duration = 0.04\nstep = 1e-3")),
        (
            "slider-crank",
            file(
                "slider_crank",
                "duration = 0.001\nstep = 2e-5\nscheme = { spectral_radius = 0.9 }\n[output]\ninterval = 1.5e-4",
            ),
        ),
        ("rotor", file("rotor", "duration = 0.003\nstep = 1e-4\nscheme = { spectral_radius = 0.95 }")),
        ("adaptive", beam("", PULSE, &format!("duration = 0.1\nstep = {{ tolerance = 1e-4 }}\n{HALF}"))),
        (
            "adaptive, at intervals",
            beam(
                "",
                PULSE,
                &format!("duration = 0.1\nstep = {{ tolerance = 1e-5 }}\n{HALF}\n[output]\ninterval = 0.03"),
            ),
        ),
        ("velocity jumps", velocity_jumps(&format!("duration = 0.1\nstep = 3e-3\n{HALF}"))),
        (
            "velocity jumps, adaptive",
            velocity_jumps(&format!(
                "duration = 0.1\nstep = {{ tolerance = 1e-5 }}\n{HALF}\n[output]\ninterval = 0.01"
            )),
        ),
        ("energy, tumbling", velocity_jumps("duration = 0.1\nstep = 3e-3\nscheme = \"energy\"")),
        ("energy, beam", beam("", PULSE, "duration = 0.1\nstep = 4e-3\nscheme = { energy_damping = 1e-3 }")),
        (
            "energy, divided",
            beam("", "", "duration = 0.5\nstep = 0.1\nmax_iterations = 7\nscheme = \"energy\""),
        ),
        ("energy, falling", falling("duration = 0.16\nstep = 2e-3\nscheme = \"energy\"")),
        ("band brake", file("belt", "duration = 0.03\nstep = 1e-3\nscheme = { spectral_radius = 0.8 }")),
        ("falling", falling(&format!("duration = 0.16\nstep = 2e-3\n{HALF}"))),
        (
            "falling, at intervals",
            falling(&format!("duration = 0.16\nstep = 4e-3\n{HALF}\n[output]\ninterval = 0.02")),
        ),
        ("falling, adaptive", falling(&format!("duration = 0.14\nstep = {{ tolerance = 1e-3 }}\n{HALF}"))),
    ]
}

/// Asserts that a resumed run is the remainder of the whole run.
fn assert_rest(name: &str, from: &[u8], rest: &(Recorder, Summary), whole: &(Recorder, Summary)) {
    let (checkpoint, at) = (read(from), format!("{name}, at t = {}", read(from).time()));
    assert_eq!(rest.0.columns, whole.0.columns, "{at}");
    assert!(rest.0.rows == whole.0.rows[checkpoint.rows() as usize..], "{at}: rows differ");
    assert_eq!(rest.1, whole.1, "{at}");
    assert_eq!(rest.1.time.to_bits(), whole.1.time.to_bits(), "{at}");
}

/// Equally spaced items, including the first and the last.
fn some<T>(all: &[T], count: usize) -> impl Iterator<Item = &T> {
    let last = all.len() - 1;
    (0..=count).map(move |i| &all[i * last / count])
}

#[test]
fn resumed_runs_equal_uninterrupted_runs() {
    for (name, model) in short_runs().into_iter().chain(further_runs()) {
        let (plain, taken) = (run(&model, false), run(&model, true));
        assert!(plain.1.outcome.is_finished(), "{name}: {:?}", plain.1.outcome);
        assert!(plain.0.rows == taken.0.rows && plain.1 == taken.1, "{name}: checkpoints change results");
        let all = &taken.0.checkpoints;
        assert_eq!(read(&all[0]).rows(), 1, "{name}");
        assert!(all.len() as u64 > plain.1.steps, "{name}: one per step");
        for from in some(all, 7) {
            let rest = resumed(&model, from);
            assert_rest(name, from, &rest, &plain);
            // Checkpoints of the resumed run are equal, too.
            let first = all.len() - rest.0.checkpoints.len();
            assert!(rest.0.checkpoints == all[first..], "{name}: checkpoints differ");
        }
    }
}

/// The short runs have divided steps, redundant constraints, rejected steps, contact pairs and reused tangents.
#[test]
pub(crate) fn short_runs_cover_all_features() {
    let summary = |requested: &str| {
        let (_, model) = short_runs().into_iter().find(|(name, _)| *name == requested).unwrap();
        let (recorder, summary) = run(&model, true);
        let sizes: Vec<_> = recorder.checkpoints.iter().map(Vec::len).collect();
        (summary, sizes)
    };
    assert!(summary("divided steps").0.divided_steps > 0);
    assert!(!summary("redundant joints").0.redundant.is_empty());
    assert!(summary("adaptive").0.rejected_steps > 0);
    // Checkpoints contain contact pairs.
    let (_, mut sizes) = summary("falling");
    sizes.sort_unstable();
    sizes.dedup();
    assert!(sizes.len() > 3, "{sizes:?}");
    // With reused tangents, checkpoints contain the states of their evaluation.
    let [reused, new] = ["reused tangents", "new tangents"].map(|name| summary(name).1[5]);
    assert!(reused as f64 > 1.3 * new as f64, "{reused}, {new}");
}

/// Interrupts in any iteration discard the incomplete step.
#[test]
fn interrupted_runs_resume() {
    for (name, model) in short_runs().into_iter().chain(further_runs()) {
        let whole = run(&model, false);
        let (_, _, queries) = interrupted(&model, u64::MAX);
        let stride = (queries / 15).max(1);
        for n in (1..queries).filter(|n| n % stride == 0) {
            let (recorder, summary, _) = interrupted(&model, n);
            assert_eq!(summary.outcome, ancf::Outcome::Stopped, "{name}");
            let last = recorder.last.unwrap();
            assert_eq!(read(&last).rows(), recorder.rows.len() as u64, "{name}");
            assert!(recorder.rows == whole.0.rows[..recorder.rows.len()], "{name}");
            assert_rest(&format!("{name}, interrupt {n}"), &last, &resumed(&model, &last), &whole);
        }
    }
}

/// A sink ends a run after the row that it received.
#[test]
fn runs_ended_by_a_sink_resume() {
    for (name, model) in short_runs().into_iter().chain(further_runs()) {
        let whole = run(&model, false);
        let (recorder, _) = run_to(&model, 3);
        let last = recorder.last.unwrap();
        assert_eq!(read(&last).rows(), 3);
        assert_rest(name, &last, &resumed(&model, &last), &whole);
    }
}

/// A run resumed after a failure fails again with the same summary.
#[test]
fn resumed_failures_are_equal() {
    let failing = [
        "duration = 1\nstep = 0.1\nmax_iterations = 6\nmax_halvings = 1",
        "duration = 1\nstep = 0.1\nmax_iterations = 3\nmax_halvings = 4",
    ];
    for analysis in failing {
        let model = beam("", "", analysis);
        let whole = run(&model, false);
        assert!(matches!(whole.1.outcome, ancf::Outcome::Failed { .. }), "{:?}", whole.1);
        let last = whole.0.last.clone().unwrap();
        assert_rest(analysis, &last, &resumed(&model, &last), &whole);
    }
}

/// Returns the reason for which a checkpoint is rejected.
fn resume_error(model: &Model, checkpoint: &Checkpoint) -> ResumeError {
    let mut recorder = Recorder::default();
    let Err(Error::Checkpoint(mismatch)) = Simulation::new(model).unwrap().resume(checkpoint, &mut recorder)
    else {
        panic!("the checkpoint is accepted")
    };
    assert!(recorder.columns.is_empty(), "nothing is recorded");
    mismatch
}

#[test]
fn checkpoints_of_other_models_are_rejected() {
    let settings = "duration = 0.02\nstep = 2e-3";
    let model = beam("", "", settings);
    let all = run(&model, true).0.checkpoints;
    let checkpoint = read(&all[3]);
    assert_eq!(resume_error(&beam("", PULSE, settings), &checkpoint), ResumeError::Model);
    assert_eq!(
        resume_error(&beam(", damping = { mass = 1 }", "", settings), &checkpoint),
        ResumeError::Model
    );
    assert_eq!(resume_error(&beam("", "", "duration = 0.03\nstep = 2e-3"), &checkpoint), ResumeError::Model);
    assert_eq!(resume_error(&file("double_pendulum", settings), &checkpoint), ResumeError::Model);
    assert_eq!(resume_error(&files::model("column"), &checkpoint), ResumeError::Analysis);
    // The first byte is the version of the format.
    let mut other = all[3].clone();
    other[0] += 1;
    assert!(matches!(resume_error(&model, &read(&other)), ResumeError::Version { found: 15, expected: 14 }));
}

/// Resumes from damaged data with a limit on the queries, since the run may be slow.
fn resume_damaged(model: &Model, damaged: &[u8]) {
    let Ok(checkpoint) = postcard::from_bytes::<Checkpoint>(damaged) else { return };
    let simulation = Simulation::new(model).unwrap();
    let queries = std::sync::atomic::AtomicU32::new(0);
    let limit = move || queries.fetch_add(1, std::sync::atomic::Ordering::Relaxed) > 300;
    let simulation = simulation.with_interrupt(ancf::solver::newton::Interrupt::new(limit));
    let _ = simulation.resume(&checkpoint, &mut Recorder::default());
}

/// Damaged checkpoints are rejected or resumed, without panics and infinite loops.
#[test]
fn damaged_checkpoints_cause_no_panic() {
    let mut seed = 1_u64;
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize
    };
    let names = ["reused tangents", "divided steps", "velocity jumps, adaptive", "falling", "slider-crank"];
    for (name, model) in
        short_runs().into_iter().chain(further_runs()).filter(|(name, _)| names.contains(name))
    {
        let all = run(&model, true).0.checkpoints;
        for _ in 0..150 {
            let mut damaged = all[random() % all.len()].clone();
            // The version and the hash of the model are unchanged; otherwise all checkpoints would be rejected.
            let first = 12.min(damaged.len() - 1);
            for _ in 0..=random() % 3 {
                // Scalars are at the start and at the end, long vectors between them.
                let size = damaged.len() - first;
                let at = match random() % 3 {
                    0 => first + random() % size,
                    1 => first + random() % size.min(120),
                    _ => damaged.len() - 1 - random() % size.min(120),
                };
                damaged[at] = [0, 1, 0x7f, 0x80, 0xff, random() as u8][random() % 6];
            }
            if random() % 10 == 0 {
                damaged.truncate(random() % damaged.len());
            }
            resume_damaged(&model, &damaged);
        }
        assert!(!name.is_empty());
    }
}

#[test]
fn checkpoints_are_written_exactly() {
    let all = run(&beam("", "", "duration = 0.02\nstep = 2e-3"), true).0.checkpoints;
    for one in &all {
        assert_eq!(bytes(&read(one)), *one);
    }
}
