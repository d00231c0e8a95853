//! Natural frequencies of the cantilever of Kim et al. (2017), by element count.
//!
//! Source: independent implementation of the element. Limits: Timoshenko's beam with k = 1 (bending: 13.714693124408,
//! 85.85919781924, 240.0061199541, 469.17308113901 Hz), √(G/ρ)/4L in torsion, √(E/ρ)/4L along the axis.

use ancf::Model;
use ancf::solver::eigen;
use ancf::solver::newton::Interrupt;

use crate::common::assertions::assert_near;
use crate::common::models::rod;

#[derive(Clone, Copy, Debug, PartialEq)]
enum ModeKind {
    Bending,
    Torsion,
    Axial,
    /// Change of size or shape of the section.
    Section,
}

/// Kind of motion of each nodal coordinate of the straight rod: r, r_x, r_y, r_z, each along x, y, z.
const KINDS: [ModeKind; 12] = {
    use ModeKind::{Axial, Bending, Section, Torsion};
    [Axial, Bending, Bending, Axial, Bending, Bending, Bending, Section, Torsion, Bending, Torsion, Section]
};

/// Lowest frequencies of the straight rod in Hz, ascending, with the kind of motion.
fn modes(model: &Model) -> Vec<(f64, ModeKind)> {
    let assembly = model.assemble().unwrap();
    let modes =
        eigen::modes(&assembly.system, assembly.system.matrix(), &assembly.rest(), 20, &Interrupt::default())
            .unwrap();
    assert_eq!(modes.rigid, 0, "the rod is clamped");
    let kind = |shape: &[f64]| {
        let size = |i: &usize| shape[*i].abs();
        let largest = (0..shape.len()).max_by(|i, j| size(i).total_cmp(&size(j)));
        KINDS[largest.unwrap() % KINDS.len()]
    };
    modes.modes.iter().map(|mode| (mode.frequency().unwrap(), kind(&mode.shape))).collect()
}

/// Frequencies of one kind of motion.
fn of(kind: ModeKind, modes: &[(f64, ModeKind)]) -> Vec<f64> {
    modes.iter().filter(|mode| mode.1 == kind).map(|mode| mode.0).collect()
}

/// Asserts pairs of bending frequencies, one for each plane.
fn assert_bending(name: &str, modes: &[(f64, ModeKind)], reference: &[f64]) {
    let bending = of(ModeKind::Bending, modes);
    assert!(bending.len() >= 2 * reference.len(), "{name}: {} bending modes", bending.len());
    for (pair, &reference) in bending.chunks(2).zip(reference) {
        assert_near(&format!("{name}, bending"), pair[0], reference, 1e-6);
        assert_near(&format!("{name}, bending in the other plane"), pair[1], reference, 1e-6);
    }
}

#[test]
fn frequencies_converge_to_timoshenkos_beam() {
    let table: [(u32, &[f64], Option<f64>, f64); 6] = [
        (1, &[17.443131], Some(955.62311), 1379.38327),
        (2, &[14.412091, 146.339242], Some(889.06518), 1301.70679),
        (4, &[13.882588, 93.857136, 301.766185], Some(872.23321), 1262.75351),
        (8, &[13.756332, 87.712915, 252.696002, 516.757620], Some(868.04713), 1243.94811),
        (16, &[13.725091, 86.315379, 243.060966, 480.278523], None, 1234.72748),
        (32, &[13.717296, 85.973121, 240.765392, 471.914774], Some(866.74131), 1230.16459),
    ];
    for (elements, bending, torsion, axial) in table {
        let (name, modes) = (format!("{elements} elements"), modes(&rod::cantilever(elements)));
        assert_bending(&name, &modes, bending);
        if let Some(torsion) = torsion {
            assert_near(&format!("{name}, torsion"), of(ModeKind::Torsion, &modes)[0], torsion, 1e-5);
        }
        assert_near(&format!("{name}, axial"), of(ModeKind::Axial, &modes)[0], axial, 1e-5);
    }
}

/// Limits with (λ+2G)I: 15.910931825754, 99.556825887235, 278.06445474896 Hz.
#[test]
fn bending_frequencies_lock_for_poisson_ratio_0_3() {
    let mut model = rod::cantilever(32);
    rod::material(&mut model).poisson = 0.3;
    assert_bending("nu = 0.3", &modes(&model), &[15.913959, 99.689403, 278.946341]);
}
