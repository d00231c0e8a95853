//! Laws of elements: rigid motions, free motions, dissipation.

use crate::common::continuum;
use crate::common::models::beams;
use crate::common::models::beams::{LENGTH, Make, Specimen, makes};
use crate::common::sample::{Random, Sample, energy, residual, tangent};
use ancf::model::{Damping, Formulation, Material, MaterialLaw, Section};
use ancf::system::Weights;
use nalgebra::{Cholesky, DVector, Rotation3, SymmetricEigen, Vector3};

/// Every beam without gravity; stubby ones, so that no part of an energy hides behind another.
fn specimens() -> impl Iterator<Item = Specimen> {
    makes().into_iter().map(|make| make.specimen(Vector3::zeros()))
}

/// Translation, rotation and spin of any size: no energy, no elastic and no viscous force.
#[test]
fn rigid_motion_costs_nothing() {
    let mut random = Random(24);
    let damping = Damping { strain: 0.2, mass: 0.0 };
    let damped = makes().into_iter().map(|make| Make { damping, ..make }.specimen(Vector3::zeros()));
    for specimen in specimens().chain(damped) {
        let (term, name, stiffness) = (specimen.term.as_ref(), &specimen.name, specimen.stiffness());
        for _ in 0..5 {
            let (turn, shift) = (Rotation3::new(random.vector3() * 3.0), random.vector3() * 10.0);
            let mut at = Sample::rest(term);
            at.q = specimen.moved(turn, shift);
            at.v = specimen.spinning(&at.q, random.vector3(), random.vector3());
            let force = residual(term, &at).amax() / specimen.slope;
            assert!(force < 1e-10 * stiffness, "{name}: force {force:e}");
            let strain = energy(term, &at).strain;
            assert!(strain < 1e-20 * stiffness * LENGTH, "{name}: energy {strain:e}");
        }
    }
}

/// A free element has six motions without stiffness, three translations and three rotations, and no other.
#[test]
fn stiffness_has_six_free_motions_and_mass_none() {
    for Specimen { name, term, .. } in specimens() {
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

/// The lowest vibration of a free, slender, straight element is no lower than that of a free beam, 4.730⁴ EI/ρAl⁴: no
/// motion is weak by reduced integration.
#[test]
fn slender_elements_have_no_weak_motion() {
    for formulation in beams::FORMULATIONS {
        for poisson in [0.0, 0.3, 0.45, -0.3] {
            for section in [
                Section::Circle { diameter: LENGTH / 50.0 },
                Section::Rectangle { height: LENGTH / 20.0, width: LENGTH / 100.0 },
            ] {
                let moments = section.moments();
                let Specimen { name, term, .. } =
                    Make::straight(formulation, section, poisson).specimen(Vector3::zeros());
                let rest = Sample::rest(term.as_ref());
                let mass = tangent(term.as_ref(), &rest, Weights::MASS);
                let stiffness = tangent(term.as_ref(), &rest, Weights::STIFFNESS);
                let root = Cholesky::new(mass).expect("mass").l();
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

/// Damping takes energy out, whatever the motion: v·(f(q, v) − f(q, 0)) ≥ 0.
#[test]
fn damping_dissipates() {
    let mut random = Random(7);
    for damping in [Damping { strain: 0.2, mass: 0.0 }, Damping { strain: 0.0, mass: 0.7 }] {
        for make in makes() {
            let Specimen { name, term, .. } = Make { damping, ..make }.specimen(Vector3::zeros());
            for _ in 0..10 {
                let mut at = Sample::random(term.as_ref(), &mut random);
                at.q *= if make.law == MaterialLaw::NeoHookean { 0.1 } else { 1.0 };
                let still = Sample { v: DVector::zeros(at.v.len()), ..at.clone() };
                let force = residual(term.as_ref(), &at) - residual(term.as_ref(), &still);
                let (power, size) = (force.dot(&at.v), force.norm() * at.v.norm());
                assert!(power > 1e-6 * size, "{name}: {power} of {size}");
            }
        }
    }
}

/// Straight beams of the continuum, and bent ones that are thin enough for the rule of the sections.
fn continua(gravity: Vector3<f64>) -> impl Iterator<Item = Specimen> {
    let shaped = |make: &Make| {
        make.formulation == Formulation::Continuum
            && make.law == MaterialLaw::StVenantKirchhoff
            && make.section_end.is_none()
            && !matches!(make.section, Section::General { .. })
    };
    let thin = |make: Make| {
        let rectangle = Section::Rectangle { height: 0.04, width: 0.03 };
        Make { section: if make.bent { rectangle } else { make.section }, ..make }
    };
    makes().into_iter().filter(shaped).map(move |make| thin(make).specimen(gravity))
}

/// ½∫(λ tr² E + 2G E:E) dV over the volume by 125 points and more, with E of F = J J₀⁻¹, is what the element makes of moments
/// of area or of points of the section.
#[test]
fn strain_energy_is_that_of_the_continuum() {
    let mut random = Random(31);
    for Specimen { name, make, term, vectors, slope, length } in continua(Vector3::zeros()) {
        let lame = Material::elastic(2.0, 30.0, make.poisson).lame();
        for _ in 0..5 {
            let at = Sample::random(term.as_ref(), &mut random);
            let reference = std::array::from_fn(|k| vectors[k].value);
            let e = std::array::from_fn(|k| reference[k] + at.q.fixed_rows::<3>(3 * k));
            let density = |x: [f64; 3]| {
                let gradients = continuum::shape_gradients(length, slope, x);
                let [j, j0] = [e, reference].map(|e| continuum::deformation_gradient(&e, &gradients));
                continuum::energy_density(lame, &j, &j0)
            };
            let brute = continuum::integrate(length, make.section, density);
            let (exact, tolerance) =
                (energy(term.as_ref(), &at).strain, if make.bent { 1e-9 } else { 1e-13 });
            assert!((exact / brute - 1.0).abs() < tolerance, "{name}: {exact} and {brute}");
        }
    }
}

/// ½∫ρ v·v dV and −∫ρ g·u dV likewise; the mass of a bent beam is that of its length.
#[test]
fn kinetic_and_potential_energy_are_those_of_the_continuum() {
    let (mut random, gravity, density) = (Random(18), Vector3::new(0.3, -2.0, 0.7), 2.0);
    for Specimen { name, make, term, slope, length, .. } in continua(gravity) {
        let at = Sample::random(term.as_ref(), &mut random);
        let field = |nodes: &DVector<f64>, x| -> Vector3<f64> {
            let values = continuum::shape_values(length, slope, x);
            values.iter().enumerate().map(|(k, s)| nodes.fixed_rows::<3>(3 * k) * *s).sum()
        };
        let kinetic = |x| 0.5 * density * field(&at.v, x).norm_squared();
        let potential = |x| -at.local().load * density * gravity.dot(&field(&at.q, x));
        let exact = energy(term.as_ref(), &at);
        let brute = continuum::integrate(length, make.section, kinetic);
        assert!((exact.kinetic / brute - 1.0).abs() < 1e-13, "{name}: {} and {brute}", exact.kinetic);
        let brute = continuum::integrate(length, make.section, potential);
        assert!((exact.potential - brute).abs() < 1e-14, "{name}: {} and {brute}", exact.potential);
    }
}
