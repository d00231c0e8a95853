//! Velocities and accelerations of surfaces in files for ParaView.

use crate::common::Run;
use crate::paraview::{Grid, cross, written};

/// Asserts that the first points of a grid have the velocities v + ω × r and the accelerations ω × (ω × r), ω along z, v along x.
fn assert_spins(grid: &Grid, corners: usize, spin: f64, speed: f64) {
    let (points, v, a) = (grid.points(), grid.vectors("velocity"), grid.vectors("acceleration"));
    let centre: [f64; 3] =
        std::array::from_fn(|k| points[..corners].iter().map(|x| x[k]).sum::<f64>() / corners as f64);
    for k in 0..corners {
        let arm: [f64; 3] = std::array::from_fn(|i| points[k][i] - centre[i]);
        let expected = cross([0.0, 0.0, spin], arm);
        let inward = cross([0.0, 0.0, spin], expected);
        for i in 0..3 {
            let drift = if i == 0 { speed } else { 0.0 };
            // Velocities have single precision.
            let allowed = 1e-5 * spin.max(1e-2 * speed);
            assert!((v[k][i] - drift - expected[i]).abs() < allowed, "{:?}, not {expected:?}", v[k]);
            assert!((a[k][i] - inward[i]).abs() < 1e-5 * spin * spin, "{:?}, not {inward:?}", a[k]);
        }
    }
}

/// Spinning brick in units of the solver that differ from those of the model, also at speeds far above those of its corners; closed
/// surfaces of bricks and masses.
#[test]
fn corners_of_rigid_bodies_move_as_rigid_bodies_do() {
    let (m, a, b, c) = (2.0, 0.3_f64, 0.2_f64, 0.1_f64);
    let inertia = [b * b + c * c, a * a + c * c, a * a + b * b].map(|x| m * x / 12.0);
    for (speed, time) in [(5.0, 1.0), (5.0, 10.0), (5e4, 1e-3)] {
        let text = format!(
            "scales = {{ kind = \"given\", length = 2, time = {time}, force = 7 }}\n\
             [[bodies]]\nkind = \"rigid\"\nname = \"brick\"\ncenter = [0, 0, 0]\nmass = {m}\ninertia = {inertia:?}\n\
             motion = {{ spin = [0, 0, 2], velocity = [{speed}, 0, 0] }}\n\
             [[bodies]]\nkind = \"mass\"\nname = \"far\"\ncenter = [10, 0, 0]\nmass = 1\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 1e-3\n"
        );
        let run = Run::of(&text, 100);
        let all = written(&run, "sections");
        assert!(all.len() > 3);
        assert!(all.iter().all(|(_, grid)| grid.is_closed()));
        // At the start, velocities are independent of the time integration.
        let (_, grid) = &all[0];
        assert!((grid.volume(0) / (a * b * c) - 1.0).abs() < 1e-9);
        // Octahedron with semi-axes r and volume 4 r³/3; r is a fiftieth of the size of the reference state.
        assert!((grid.volume(1) / (4.0 / 3.0 * 0.2_f64.powi(3)) - 1.0).abs() < 1e-9, "{}", grid.volume(1));
        assert_spins(grid, 8, 2.0, speed);
    }
}

/// Spinning beam of 0.1 mm in metres.
#[test]
fn skins_of_beams_move_as_rigid_bodies_do() {
    let text = "scales = { kind = \"auto\" }\n\
        materials.silicon = { density = 2330, young = 1.6e11 }\n\
        sections.s = { kind = \"rectangle\", height = 4e-6, width = 8e-6 }\n\
        [[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [-5e-5, 0, 0]\nto = [5e-5, 0, 0]\nup = [0, 0, 1]\nelements = 2\n\
        section = \"s\"\nmaterial = \"silicon\"\n\
        motion = { spin = [0, 0, 3], about = [0, 0, 0] }\n\
        [analysis]\nkind = \"dynamics\"\nduration = 1e-6\nstep = 1e-7\n";
    let run = Run::of(text, 1);
    let (_, grid) = &written(&run, "sections")[0];
    let (points, v) = (grid.points(), grid.vectors("velocity"));
    for (point, v) in points.iter().zip(v) {
        let expected = cross([0.0, 0.0, 3.0], *point);
        for i in 0..3 {
            assert!((v[i] - expected[i]).abs() < 1e-5 * 3.0 * 5e-5, "{v:?}, not {expected:?}");
        }
    }
}
