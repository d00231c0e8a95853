//! Properties of beam elements: rigid-body motions, rank of the stiffness, dissipation, energy of the continuum.

use ancf::model::{Damping, Formulation, Material, MaterialLaw, Section};
use ancf::solver::equations::Weights;
use nalgebra::{Cholesky, DVector, Rotation3, SymmetricEigen, Vector3};

use crate::common::continuum;
use crate::common::models::beams::{BY_KIND, BeamCase, BeamElement, FORMULATIONS, LENGTH, beam_cases};
use crate::common::random::Random;
use crate::common::sample::{Sample, energy, residual, tangent};

/// All beam elements without gravity.
fn elements() -> impl Iterator<Item = BeamElement> {
    beam_cases().into_iter().map(|case| case.element(Vector3::zeros()))
}

/// Translation, rotation and angular velocity of any size: no energy, no elastic and no viscous force.
#[test]
fn rigid_motion_has_no_energy_and_no_force() {
    let mut random = Random(24);
    let damped = [Damping { strain: 0.2, ..Damping::default() }, BY_KIND].into_iter().flat_map(|damping| {
        let cases = beam_cases().into_iter().filter(move |case| case.supports(&damping));
        cases.map(move |case| BeamCase { damping, ..case }.element(Vector3::zeros()))
    });
    for element in elements().chain(damped) {
        let (term, name, stiffness) = (element.term.as_ref(), &element.name, element.stiffness());
        for _ in 0..5 {
            let (turn, shift) = (Rotation3::new(random.vector3() * 3.0), random.vector3() * 10.0);
            let mut at = Sample::rest(term);
            at.q = element.rigid_displacement(turn, shift);
            at.v = element.rigid_velocity(&at.q, random.vector3(), random.vector3());
            let force = residual(term, &at).amax() / element.slope;
            assert!(force < 1e-10 * stiffness, "{name}: force {force:e}");
            let strain = energy(term, &at).strain;
            assert!(strain < 1e-20 * stiffness * LENGTH, "{name}: energy {strain:e}");
        }
    }
}

/// Zero eigenvalues of the stiffness belong to three translations and three rotations; the mass is positive definite.
#[test]
fn stiffness_has_six_rigid_modes_and_mass_is_definite() {
    for BeamElement { name, term, .. } in elements() {
        let rest = Sample::rest(term.as_ref());
        let eigenvalues = |w| {
            let k = tangent(term.as_ref(), &rest, w);
            let mut values = SymmetricEigen::new(k).eigenvalues.data.as_vec().clone();
            values.sort_unstable_by(f64::total_cmp);
            values
        };
        let (stiffness, mass) = (eigenvalues(Weights::STIFFNESS), eigenvalues(Weights::MASS));
        let largest = stiffness[stiffness.len() - 1];
        assert!(stiffness[0] > -1e-13 * largest, "{name}: {stiffness:?}");
        assert!(stiffness[5] < 1e-13 * largest, "{name}: {stiffness:?}");
        assert!(stiffness[6] > 1e-5 * largest, "{name}: {stiffness:?}");
        assert!(mass[0] > 1e-5 * mass[mass.len() - 1], "{name}: {mass:?}");
    }
}

/// Lowest frequency of a free, slender, straight element: not below that of the free beam, 4.730⁴ EI/ρAl⁴.
///
/// Reduced integration causes no mode without stiffness.
#[test]
fn slender_elements_have_no_zero_energy_modes() {
    for formulation in FORMULATIONS {
        for poisson in [0.0, 0.3, 0.45, -0.3] {
            for section in [Section::circle(LENGTH / 50.0), Section::rectangle(LENGTH / 20.0, LENGTH / 100.0)]
            {
                let moments = section.moments();
                let BeamElement { name, term, .. } =
                    BeamCase::straight(formulation, section, poisson).element(Vector3::zeros());
                let rest = Sample::rest(term.as_ref());
                let mass = tangent(term.as_ref(), &rest, Weights::MASS);
                let stiffness = tangent(term.as_ref(), &rest, Weights::STIFFNESS);
                let root = Cholesky::new(mass).expect("the mass is positive definite").l();
                let half = root.solve_lower_triangular(&stiffness).unwrap().transpose();
                let mut squares = SymmetricEigen::new(root.solve_lower_triangular(&half).unwrap())
                    .eigenvalues
                    .data
                    .as_vec()
                    .clone();
                squares.sort_unstable_by(f64::total_cmp);
                let lowest = 4.730_f64.powi(4) * 30.0 * moments.yy.min(moments.zz)
                    / (2.0 * moments.area * LENGTH.powi(4));
                assert!(squares[5].abs().max(squares[0].abs()) < 1e-2 * lowest, "{name}: {squares:?}");
                assert!(squares[6] > 0.9 * lowest, "{name}: {squares:?}, {lowest}");
            }
        }
    }
}

/// Power of the damping forces in any motion: v·(f(q, v) − f(q, 0)) > 0.
#[test]
fn damping_power_is_positive() {
    let mut random = Random(7);
    let [strain, mass] =
        [(0.2, 0.0), (0.0, 0.7)].map(|(strain, mass)| Damping { strain, mass, ..Damping::default() });
    for damping in [strain, mass, BY_KIND] {
        for case in beam_cases().into_iter().filter(|case| case.supports(&damping)) {
            let BeamElement { name, term, .. } = BeamCase { damping, ..case }.element(Vector3::zeros());
            for _ in 0..10 {
                let mut at = Sample::random(term.as_ref(), &mut random);
                at.q *= if case.law == MaterialLaw::NeoHookean { 0.1 } else { 1.0 };
                let still = Sample { v: DVector::zeros(at.v.len()), ..at.clone() };
                let force = residual(term.as_ref(), &at) - residual(term.as_ref(), &still);
                let (power, size) = (force.dot(&at.v), force.norm() * at.v.norm());
                assert!(power > 1e-6 * size, "{name}: {power} of {size}");
            }
        }
    }
}

/// Prismatic beams of the continuum formulation. Curved ones are thin enough for the integration rule of the sections.
fn continuum_elements(gravity: Vector3<f64>) -> impl Iterator<Item = BeamElement> {
    let prismatic = |case: &BeamCase| {
        case.formulation == Formulation::Continuum
            && case.law == MaterialLaw::StVenantKirchhoff
            && case.section_end.is_none()
            && !matches!(case.section.clone(), Section::General(_))
    };
    let thin = |case: BeamCase| {
        let rectangle = Section::rectangle(0.04, 0.03);
        BeamCase { section: if case.curved { rectangle } else { case.section }, ..case }
    };
    beam_cases().into_iter().filter(prismatic).map(move |case| thin(case).element(gravity))
}

/// Strain energy ½∫(λ tr² E + 2G E:E) dV with E of F = J J₀⁻¹, integrated by at least 125 points.
#[test]
fn strain_energy_is_that_of_the_continuum() {
    let mut random = Random(31);
    for BeamElement { name, case, term, vectors, slope, length } in continuum_elements(Vector3::zeros()) {
        let lame = Material::elastic(2.0, 30.0, case.poisson).lame();
        for _ in 0..5 {
            let at = Sample::random(term.as_ref(), &mut random);
            let reference = std::array::from_fn(|k| vectors[k].value);
            let e = std::array::from_fn(|k| reference[k] + at.q.fixed_rows::<3>(3 * k));
            let density = |x: [f64; 3]| {
                let gradients = continuum::shape_gradients(length, slope, x);
                let [j, j0] = [e, reference].map(|e| continuum::deformation_gradient(&e, &gradients));
                continuum::energy_density(lame, &j, &j0)
            };
            let reference = continuum::integrate(length, case.section.clone(), density);
            let (strain, tolerance) =
                (energy(term.as_ref(), &at).strain, if case.curved { 1e-9 } else { 1e-13 });
            assert!((strain / reference - 1.0).abs() < tolerance, "{name}: {strain} and {reference}");
        }
    }
}

/// Kinetic energy ½∫ρ v·v dV and potential energy −∫ρ g·u dV. The mass of a curved beam is that of its arc length.
#[test]
fn kinetic_and_potential_energy_are_those_of_the_continuum() {
    let (mut random, gravity, density) = (Random(18), Vector3::new(0.3, -2.0, 0.7), 2.0);
    for BeamElement { name, case, term, slope, length, .. } in continuum_elements(gravity) {
        let at = Sample::random(term.as_ref(), &mut random);
        let field = |nodes: &DVector<f64>, x| -> Vector3<f64> {
            let values = continuum::shape_values(length, slope, x);
            values.iter().enumerate().map(|(k, s)| nodes.fixed_rows::<3>(3 * k) * *s).sum()
        };
        let kinetic = |x| 0.5 * density * field(&at.v, x).norm_squared();
        let potential = |x| -at.local().load * density * gravity.dot(&field(&at.q, x));
        let found = energy(term.as_ref(), &at);
        let reference = continuum::integrate(length, case.section.clone(), kinetic);
        assert!((found.kinetic / reference - 1.0).abs() < 1e-13, "{name}: {} and {reference}", found.kinetic);
        let reference = continuum::integrate(length, case.section.clone(), potential);
        assert!((found.potential - reference).abs() < 1e-14, "{name}: {} and {reference}", found.potential);
    }
}
