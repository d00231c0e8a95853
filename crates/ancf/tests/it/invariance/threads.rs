//! Results do not depend on the number of threads.

use ancf::Model;
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::State;
use ancf::solver::newton::{Newton, StopRule};

use crate::common::models::{parse, rod};

/// State of a model after five steps. A rod of 1500 elements has three groups of batches and two branches of the elimination tree.
fn final_state(model: &Model, threads: usize) -> State {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let assembly = model.assemble().unwrap();
        let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-8), 50).unwrap();
        let mut dynamics =
            TimeStepper::new(&assembly.system, SchemeCoefficients::ADAMS, newton, 0, assembly.rest());
        dynamics.restart(0.0).unwrap();
        for step in 1..=5 {
            dynamics.advance(1e-3 * f64::from(step)).unwrap();
        }
        dynamics.state().clone()
    })
}

/// Open chain of 700 rigid bodies with hinges in turn about y and z: three groups of batches for bodies and for joints.
fn chain() -> Model {
    let (mut bodies, mut joints) = (String::new(), String::new());
    for k in 0..700 {
        let (start, end) = (0.1 * f64::from(k), 0.1 * f64::from(k) + 0.05);
        bodies += &format!(
            "{{ kind = \"rigid\", name = \"r{k}\", center = [{end}, 0, 0], mass = 0.1, inertia = [2e-5, 1e-4, 1e-4] }},\n"
        );
        let (before, axis) = (k - 1, if k % 2 == 0 { "[0, 1, 0]" } else { "[0, 0, 1]" });
        let end = if k == 0 {
            String::new()
        } else {
            format!(", b = {{ body = \"r{before}\", at = [{start}, 0, 0] }}")
        };
        joints += &format!(
            "{{ kind = \"revolute\", name = \"j{k}\", a = {{ body = \"r{k}\", at = [{start}, 0, 0] }}{end}, axis = {axis} }},\n"
        );
    }
    parse(&format!(
        "gravity = [0, 0.2, -9.81]\nbodies = [{bodies}]\njoints = [{joints}]\n\
         analysis = {{ kind = \"dynamics\", duration = 1, step = 1e-3 }}"
    ))
}

#[test]
fn threads_do_not_change_a_bit() {
    assert_same(&rod::cantilever(1500));
    assert_same(&chain());
}

fn assert_same(model: &Model) {
    let one = final_state(model, 1);
    assert!(one.q.iter().any(|q| q.abs() > 1e-6), "the rod moves");
    for threads in [2, 3, 4] {
        assert_eq!(final_state(model, threads), one, "{threads} threads");
    }
}
