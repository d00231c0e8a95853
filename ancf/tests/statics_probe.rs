#![cfg(test)]
#![allow(dead_code, unused, reason="x")]
#[path = "common/rod.rs"]
mod rod;
use ancf::Model;
use ancf::analysis::*;
use ancf::model::*;
use ancf::system::*;
use std::ops::ControlFlow;

fn loaded(elements: u32, alpha: f64) -> Model {
    let mut model = rod::cantilever(elements);
    model.gravity = [0.0; 3];
    let force = -alpha * model.materials["steel"].young * model.sections["circle"].moments().yy;
    model.loads = vec![Load::Force { on: rod::end(), force: [0.0, force, 0.0] }];
    model
}
fn run(name: &str, model: &Model, first: f64) {
    let assembly = model.assemble().unwrap();
    let mut start = assembly.rest();
    start.load = 0.0;
    let max: u32 = std::env::var("MAXIT").ok().and_then(|x| x.parse().ok()).unwrap_or(50);
    let newton = Newton::new(assembly.system.matrix(), ancf::analysis::Stop::Energy(1e-10), max).unwrap();
    let mut statics = Statics::new(&assembly.system, newton, Increments { first, ..Increments::default() }, start);
    let mut n = 0;
    let done = statics.advance(1.0, |_, _| { n += 1; ControlFlow::Continue(()) });
    let tip = assembly.probes[0].1.value(statics.state());
    match done {
        Ok(d) => println!("{name:30} iters {:4} attempts {:3} accepted {n:3} floor {} unstable {:?} tip {:.10} {:.10} {:.3e}", d.iterations, d.attempts, d.floor, d.unstable, tip.x, tip.y, tip.z),
        Err(e) => println!("{name:30} {e}"),
    }
}
#[test]
fn measure() {
    for n in [8, 16, 32] {
        run(&format!("alpha 1 n {n}"), &loaded(n, 1.0), 1.0);
        run(&format!("alpha 5 n {n}"), &loaded(n, 5.0), 1.0);
        run(&format!("alpha 10 n {n}"), &loaded(n, 10.0), 1.0);
        let mut model = rod::cantilever(n);
        rod::material(&mut model).young /= 1000.0;
        run(&format!("soft n {n}"), &model, 1.0);
    }
    for n in [16, 64] { for a in [1.0, 5.0, 10.0, 20.0, 50.0, 100.0] {
        run(&format!("Alpha {a} n {n}"), &loaded(n, a), 1.0);
    }
    for a in [1.02, 1.2, 2.0, 4.0] {
        let mut m = loaded(n, 1e-3);
        let pi2 = std::f64::consts::PI.powi(2)/4.0;
        if let Load::Force{force,..} = &mut m.loads[0] { let p = force[1]*1e3; force[0] = a*pi2*p; }
        run(&format!("Column {a} n {n}"), &m, 1.0);
    }
    for a in [1.0, 10.0, 100.0] {
        let mut m = loaded(n, a);
        if let Load::Force{force,..} = &mut m.loads[0] { let p = force[1]; force[0] = 0.5*p; force[2]=0.7*p; }
        run(&format!("Spatial {a} n {n}"), &m, 1.0);
    }
    for a in [1.0, 10.0, 100.0] {
        let mut m = loaded(n, a);
        *m.sections.get_mut("circle").unwrap() = Section::Rectangle{height: 0.005, width: 0.05};
        let ei = m.materials["steel"].young * m.sections["circle"].moments().yy;
        if let Load::Force{force,..} = &mut m.loads[0] { force[1] = -a*ei; force[2] = -a*ei; }
        run(&format!("Strip {a} n {n}"), &m, 1.0);
    }
    for d in [0.005, 0.001] { for a in [1.0, 10.0, 100.0] {
        let mut m = loaded(n, a);
        *m.sections.get_mut("circle").unwrap() = Section::Circle{diameter: d};
        let ei = m.materials["steel"].young * m.sections["circle"].moments().yy;
        if let Load::Force{force,..} = &mut m.loads[0] { force[1] = -a*ei; force[2] = -a*ei; }
        run(&format!("Wire {d} {a} n {n}"), &m, 1.0);
    } }
    for a in [1e3, 1e4, 1e5] {
        let mut model = rod::cantilever(n);
        rod::material(&mut model).young /= a;
        run(&format!("Soft {a} n {n}"), &model, 1.0);
    } }
    for n in [1, 10, 100, 1000] {
        run(&format!("self n {n}"), &rod::cantilever(n), 1.0);
    }
}
