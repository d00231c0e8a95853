//! Vibration about free, loaded and moving states.
//!
//! Source: Euler's beam with free ends, β₁L = 4.730040744862704, β₂L = 7.853204624095838; the compound pendulum,
//! 3g/2L with the inertia of a thick rod; Wright, Smith, Thresher & Wang (1982), table 1, for the spinning beam clamped on
//! its axis; Euler (1744) for the column.

use ancf::Model;
use ancf::model::{ClampedGradients, Load, Section, Slopes};
use ancf::solver::eigen::modes;
use ancf::solver::equations::{State, Weights};
use ancf::solver::newton::{Interrupt, Newton, StopRule};

use crate::common::assertions::assert_near;
use crate::common::models::rod;
use crate::common::solutions::equilibrium;

/// √(EI/ρA)/L², the unit of angular frequencies.
fn unit(model: &Model) -> f64 {
    let (material, moments) = (model.materials["steel"], model.sections["circle"].moments());
    (material.young * moments.yy / (material.density * moments.area)).sqrt() / rod::LENGTH.powi(2)
}

/// Six rigid-body modes, then pairs of bending modes, in any units. Timoshenko's corrections are below 10⁻⁵.
#[test]
fn free_beam_has_eulers_frequencies() {
    let thin = |elements| {
        let mut model = rod::free(elements);
        model.sections.insert("circle".into(), Section::circle(0.001));
        model
    };
    let unit = unit(&thin(1));
    let frequencies = |model: &Model, time: f64| {
        let assembly = model.assemble().unwrap();
        let found =
            modes(&assembly.system, assembly.system.matrix(), &assembly.rest(), 10, &Interrupt::default())
                .unwrap();
        assert_eq!(found.rigid, 6);
        let omega = |k: usize| found.modes[k].omega_squared.sqrt() / time / unit;
        assert_near("a pair", omega(7) / omega(6), 1.0, 1e-7);
        [omega(6), omega(8)]
    };
    let (coarse, fine) = (frequencies(&thin(32), 1.0), frequencies(&thin(64), 1.0));
    for (k, root) in [4.730040744862704_f64, 7.853204624095838].into_iter().enumerate() {
        let limit = (4.0 * fine[k] - coarse[k]) / 3.0;
        assert_near("a frequency", limit / root.powi(2), 1.0, 2e-5);
    }
    let scales = ancf::Scales { length: 1e-3, time: 100.0, force: 1e5 };
    let mut scaled = thin(32).scaled(&scales);
    rod::beam(&mut scaled).slopes = Slopes::Length;
    let scaled = frequencies(&scaled, scales.time);
    assert_near("in other units", scaled[0] / coarse[0], 1.0, 1e-8);
}

/// Hanging rod: ω²; standing rod: growth rate with −ω².
#[test]
fn compound_pendulum_has_its_frequency() {
    // 3g/2L with J = m (L²/3 + d²/16).
    let exact = 14.71389645776567;
    for (gravity, sign) in [(-rod::GRAVITY, 1.0), (rod::GRAVITY, -1.0)] {
        let vertical = |mut model: Model| {
            rod::beam(&mut model).to = [0.0, -rod::LENGTH, 0.0];
            model.gravity = [0.0, gravity, 0.0];
            model
        };
        let (_, loaded) = equilibrium(&vertical(rod::clamped(8, ClampedGradients::Section)), 1);
        let assembly = vertical(rod::revolute(8)).assemble().unwrap();
        let state = State { q: loaded.q, ..assembly.rest() };
        let found =
            modes(&assembly.system, assembly.system.matrix(), &state, 1, &Interrupt::default()).unwrap();
        assert_near("squared", found.modes[0].omega_squared / (sign * exact), 1.0, 1e-4);
        assert_eq!((found.rigid, found.modes[0].frequency().is_some()), (0, sign > 0.0));
    }
}

/// Out-of-plane frequencies of a spinning beam follow from K and M with the centrifugal tension.
#[test]
fn spinning_beam_has_the_flap_frequencies_of_wright() {
    // Spin, first and second flap frequency, relative to √(EI/ρAL⁴).
    for (spin, table) in [(3.0, [4.7973, 23.3203]), (6.0, [7.3604, 26.8091]), (12.0, [13.1702, 37.6031])] {
        let model = Model { gravity: [0.0; 3], ..rod::cantilever(32) };
        let (unit, assembly) = (unit(&model), model.assemble().unwrap());
        let mut state = assembly.rest();
        let square = (spin * unit).powi(2);
        for vector in assembly.mesh("rod").unwrap().vectors(&assembly.rest()) {
            state.a[vector.first] = -square * vector.value.x;
            state.a[vector.first + 1] = -square * vector.value.y;
        }
        let mut newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 20).unwrap();
        newton.solve(&assembly.system, &mut state, Weights { q: 1.0, v: 0.0, a: -square }).unwrap();
        let found = modes(&assembly.system, assembly.system.matrix(), &state, 4, &Interrupt::default())
            .unwrap()
            .modes;
        for (k, reference) in table.into_iter().enumerate() {
            let omega = found[2 * k].omega_squared.sqrt() / unit;
            assert_near(&format!("mode {k} at spin {spin}"), omega / reference, 1.0, 2e-3);
        }
    }
}

/// ω² of a column depends linearly on the load and vanishes at the critical load.
#[test]
fn squared_frequency_vanishes_at_the_critical_load() {
    let column = |part: f64| {
        let mut model = rod::cantilever(16);
        model.gravity = [0.0; 3];
        model.loads = vec![Load::force(rod::end(), [-part * 3740.132124561166 * 1.00055907, 0.0, 0.0])];
        let (assembly, state) = equilibrium(&model, 1);
        let found = modes(&assembly.system, assembly.system.matrix(), &state, 2, &Interrupt::default())
            .unwrap()
            .modes;
        [found[0].omega_squared, found[1].omega_squared]
    };
    let (below, above) = (column(0.99), column(1.01));
    for k in 0..2 {
        assert!(above[k] < 0.0);
        assert_near("antisymmetry about the critical load", above[k] / below[k], -1.0, 1e-2);
    }
}
