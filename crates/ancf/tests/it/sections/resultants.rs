//! Section forces and moments against statics of the part beyond the section, in every formulation, at large rotations.

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::kinematics::gauss;
use ancf::model::{ClampedGradients, Formulation, Load, Section, Shape, Slopes};
use ancf::solver::equations::State;
use nalgebra::{Rotation3, Vector3};

use crate::common::models::beams::FORMULATIONS;
use crate::common::models::rod;
use crate::common::solutions::equilibrium;

/// Thick, soft cantilever of two elements: straight, or a twisted arc of 60°.
fn cantilever(formulation: Formulation, curved: bool, slopes: Slopes) -> Model {
    let mut model = rod::clamped(2, ClampedGradients::Section);
    model.gravity = [0.0; 3];
    model.sections.insert("circle".into(), Section::rectangle(0.1, 0.06));
    (rod::material(&mut model).young, rod::material(&mut model).poisson) = (1e6, 0.3);
    let beam = rod::beam(&mut model);
    (beam.formulation, beam.slopes) = (formulation, slopes);
    if curved {
        beam.shape = Shape::Arc { through: [0.5, 0.13, 0.0] };
        beam.twist = 0.7;
    }
    model
}

/// All formulations: straight and curved, with both slope coordinates.
fn cantilevers() -> impl Iterator<Item = (String, Model)> {
    let shapes = [(false, Slopes::Gradient), (true, Slopes::Gradient), (true, Slopes::Length)];
    FORMULATIONS.into_iter().flat_map(move |formulation| {
        shapes.map(|(curved, slopes)| {
            (
                format!("{formulation:?}, curved: {curved}, {slopes:?}"),
                cantilever(formulation, curved, slopes),
            )
        })
    })
}

fn mesh(assembly: &Assembly) -> &BeamMesh {
    assembly.mesh("rod").unwrap()
}

/// Force of the load and its moment about the centre of the section, as exerted by the part beyond.
#[test]
fn tip_force_determines_the_section_forces() {
    let force = Vector3::new(-1.0, -4.0, 2.0);
    for (name, mut model) in cantilevers() {
        model.loads = vec![Load::force(rod::end(), force.into())];
        let (assembly, state) = equilibrium(&model, 10);
        let (mesh, tip) = (mesh(&assembly), assembly.probes[0].1.value(&state));
        assert!((tip - assembly.probes[0].1.reference()).norm() > 0.1, "{name}: small displacement");
        for part in [0.0, 0.5, 1.0] {
            let s = part * mesh.length();
            let wrench = mesh.resultants(&state, s, &[]);
            let lever = tip - mesh.point(s).value(&state);
            assert!((wrench.force - force).norm() < 1e-9 * force.norm(), "{name}, {part}: {wrench:?}");
            assert!((wrench.moment - lever.cross(&force)).norm() < 1e-9 * force.norm(), "{name}: {wrench:?}");
        }
        let reaction = assembly.reactions(&state).next().unwrap();
        let root = mesh.resultants(&state, 0.0, &[]);
        assert!((reaction.force + root.force).norm() < 1e-9 * force.norm(), "{name}");
        assert!((reaction.moment + root.moment).norm() < 1e-9 * force.norm(), "{name}");
    }
}

/// Weight ρ A g of the part beyond and its moment ∫ρA (r − r(s)) × g ds on the deformed axis.
#[test]
fn own_weight_determines_the_section_forces() {
    let gravity = Vector3::new(0.5, -3.0, 1.0);
    for (name, mut model) in cantilevers() {
        model.gravity = gravity.into();
        rod::material(&mut model).density = 300.0;
        let (assembly, state) = equilibrium(&model, 10);
        let mesh = mesh(&assembly);
        let (length, line) = (mesh.length(), 300.0 * model.sections["circle"].moments().area);
        let weight = gravity * line * length;
        for half in [0.0, 1.0, 2.0] {
            let s = 0.5 * half * length;
            let at = mesh.point(s).value(&state);
            // The axis is a polynomial in each half.
            let halves = (0..2).filter(|&k| f64::from(k) >= half);
            let points = halves.flat_map(|k| gauss().map(|(x, w)| (0.5 * (f64::from(k) + x), 0.5 * w)));
            let lever: Vector3<f64> =
                points.map(|(x, w)| (mesh.point(x * length).value(&state) - at) * w).sum();
            let wrench = mesh.resultants(&state, s, &[]);
            let (force, moment) = (weight * (1.0 - 0.5 * half), lever.cross(&weight));
            assert!((wrench.force - force).norm() < 1e-9 * weight.norm(), "{name}, {s}: {wrench:?}, {force}");
            assert!((wrench.moment - moment).norm() < 1e-9 * weight.norm(), "{name}, {s}: {wrench:?}");
        }
    }
}

/// Components in the section frame: tension along the normal, shear forces across it, torque about it.
///
/// A rod along x with the tip forces N along x and Q along y has M_z = Q (L − s): the part beyond bends the part before
/// towards y.
#[test]
fn section_forces_have_the_signs_of_the_part_beyond() {
    let (tension, push) = (2.0, 1e-3);
    let mut model = cantilever(Formulation::Linked, false, Slopes::Gradient);
    model.loads = vec![Load::force(rod::end(), [tension, push, 0.0])];
    let (assembly, state) = equilibrium(&model, 1);
    let mesh = mesh(&assembly);
    let wrench = mesh.resultants(&state, 0.5, &[]);
    let frame = mesh.section_frame(&state, 0.5);
    let [force, moment] = [wrench.force, wrench.moment].map(|v| frame.map(|axis| axis.dot(&v)));
    assert!((force[0] / tension - 1.0).abs() < 1e-3 && (force[1] / push - 1.0).abs() < 0.2, "{force:?}");
    assert!((moment[2] / (0.5 * push) - 1.0).abs() < 0.2, "{moment:?}");
    assert!(moment[0].abs() + moment[1].abs() + force[2].abs() < 1e-12, "{force:?}, {moment:?}");
}

/// Section frames rotate with the body.
#[test]
fn section_frames_rotate_with_the_body() {
    for (name, model) in cantilevers() {
        let assembly = model.assemble().unwrap();
        let (mesh, rest, turn) =
            (mesh(&assembly), assembly.rest(), Rotation3::new(Vector3::new(0.3, -1.0, 2.0)));
        let mut state: State = assembly.rest();
        for vector in mesh.vectors(&assembly.rest()) {
            for (axis, moved) in (turn * vector.value - vector.value).iter().enumerate() {
                state.q[vector.first + axis] = *moved;
            }
        }
        for s in [0.0, 0.3 * mesh.length(), mesh.length()] {
            let (before, after) = (mesh.section_frame(&rest, s), mesh.section_frame(&state, s));
            for (before, after) in before.iter().zip(&after) {
                assert!((turn * before - after).norm() < 1e-13, "{name}");
            }
            let [normal, y, z] = after;
            assert!((normal.cross(&y) - z).norm() < 1e-13 && normal.dot(&y).abs() < 1e-13, "{name}");
        }
        let tangent = mesh.axes(0.0)[0].value(&rest).normalize();
        assert!((mesh.section_frame(&rest, 0.0)[0] - tangent).norm() < 0.1, "{name}: normal along the axis");
    }
}
