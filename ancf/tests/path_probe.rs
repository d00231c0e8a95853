#![cfg(test)]
#![allow(dead_code, unused, reason="x")]
#[path = "common/rod.rs"]
mod rod;
use ancf::Model;
use ancf::analysis::*;
use ancf::model::*;
use ancf::model::Material;
use ancf::system::*;
use std::ops::ControlFlow;

fn beam(name: &str, from: [f64;3], to: [f64;3], elements: u32) -> Body {
    Body::Beam(Beam { name: name.into(), from, to, up: None, elements, section: "s".into(), material: "m".into(), slopes: Slopes::Gradient })
}
fn frame(elements: u32, fix: Clamped) -> Model {
    let base = rod::free(1);
    let place = |body: &str, at| Place { body: body.into(), at };
    let hinge = |name: &str, a| Joint::Revolute { name: name.into(), a, b: End::Ground, axis: [0.0, 0.0, 1.0] };
    Model {
        gravity: [0.0; 3],
        materials: [("m".into(), Material { density: 1.0, young: 7.2e6, poisson: 0.0 })].into(),
        sections: [("s".into(), Section::Rectangle { height: 2.0, width: 3.0 })].into(),
        bodies: vec![beam("column", [0.0; 3], [0.0, 120.0, 0.0], elements), beam("girder", [0.0, 120.0, 0.0], [120.0, 120.0, 0.0], elements)],
        joints: vec![hinge("foot", place("column", At::End(AtEnd::Start))), hinge("far", place("girder", At::End(AtEnd::End))),
            Joint::Clamp { name: "corner".into(), a: place("girder", At::End(AtEnd::Start)), b: End::Place(place("column", At::End(AtEnd::End))), fix }],
        loads: vec![Load::Force { on: place("girder", At::Length(24.0)), force: [0.0, -10000.0, 0.0] }],
        probes: vec![Probe { name: "p".into(), on: place("girder", At::Length(24.0)) }],
        ..base
    }
}
#[test]
fn lee() {
    let n: u32 = std::env::var("N").ok().and_then(|x| x.parse().ok()).unwrap_or(10);
    let mut model = frame(n, Clamped::Section);
    if let Body::Beam(b) = &mut model.bodies[0] { b.up = Some([1.0,0.0,0.0]); }
    let assembly = model.assemble().unwrap();
    let mut start = assembly.rest();
    start.load = 0.0;
    let newton = Newton::new(assembly.system.matrix(), ancf::analysis::Stop::Energy(1e-10), 50).unwrap();
    let mut path = Path::new(&assembly.system, newton, ArcSteps::from(0.2), start).unwrap();
    let marker = &assembly.probes[0].1;
    let mut iters = 0;
    let left = path.follow(&Until { load: Some(3.0), points: 200, length: f64::INFINITY }, |s, p| {
        let d = marker.sum(&s.q);
        iters += p.equilibrium.iterations;
        println!("{:8.4} P {:12.4} u {:10.5} w {:10.5} slope {:9.2e} it {:3} att {:2} unst {:?} {:?}", p.length, 10000.0*s.load, d.x, -d.y, p.slope, p.equilibrium.iterations, p.equilibrium.attempts, p.equilibrium.unstable, p.limit);
        ControlFlow::Continue(())
    });
    println!("{left:?} total iterations {iters}");
}
