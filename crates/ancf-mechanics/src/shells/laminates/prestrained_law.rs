use nalgebra::{Matrix2, Matrix3, Vector3};

use super::membrane_law::{MembraneEnergy, MembraneLaw, MembraneState};
use super::section::{strain_components, strain_tensor, strain_transform};

/// Returns the symmetric tensor of stresses (11, 22, 12).
const fn stress_tensor(n: &Vector3<f64>) -> Matrix2<f64> {
    let [[n11, n22, n12]] = n.data.0;
    Matrix2::new(n11, n12, n12, n22)
}

/// Returns the components (11, 22, 12) of the symmetric part of a tensor.
fn stress_components(n: &Matrix2<f64>) -> Vector3<f64> {
    Vector3::new(n.m11, n.m22, 0.5 * (n.m12 + n.m21))
}

/// Inverse G of a deformation F⁰ with F⁰ᵀ F⁰ = 1 + 2 ε⁰, from the reference shape to the free one. Both are upper triangles.
///
/// The rotation of F⁰ is without effect on the energy of an isotropic membrane.
fn inverse_deformation(prescribed: &Vector3<f64>) -> Matrix2<f64> {
    let c = Matrix2::identity() + strain_tensor(prescribed) * 2.0;
    let first = c.m11.sqrt();
    let shear = c.m12 / first;
    let second = (c.m22 - shear * shear).sqrt();
    Matrix2::new(1.0 / first, -shear / (first * second), 0.0, 1.0 / second)
}

/// Elastic state of a membrane beyond its free shape.
struct FreeState {
    /// Inverse G of the deformation to the free shape.
    inverse: Matrix2<f64>,
    /// Matrix of the components of strains for the change from the reference shape to the free one.
    transform: Matrix3<f64>,
    /// Elastic strain Gᵀ (ε − ε⁰) G.
    strain: Vector3<f64>,
    /// State of the elastic strain.
    state: MembraneState,
}

impl MembraneLaw {
    /// Returns the state of strains (11, 22, 2·12) in an orthonormal basis, with prescribed strains ε⁰ of the free membrane.
    ///
    /// The linear law has the elastic strain ε − ε⁰. The neo-Hookean law has F⁰⁻ᵀ (ε − ε⁰) F⁰⁻¹, with F⁰ᵀ F⁰ = 1 + 2 ε⁰: its
    /// stretches are those beyond the free shape. The energy is that per area of the reference shape, with the volume of the reference
    /// shape. Derivatives are those by ε.
    pub fn strained_state(&self, [strain, prescribed]: [&Vector3<f64>; 2]) -> MembraneState {
        match self.energy {
            _ if *prescribed == Vector3::zeros() => self.state(strain),
            MembraneEnergy::Linear { .. } => self.state(&(strain - prescribed)),
            MembraneEnergy::NeoHookean { .. } => {
                let FreeState { transform, state, .. } = self.free_state([strain, prescribed]);
                MembraneState {
                    energy: state.energy,
                    force: transform.transpose() * state.force,
                    stiffness: transform.transpose() * state.stiffness * transform,
                }
            }
        }
    }

    fn free_state(&self, [strain, prescribed]: [&Vector3<f64>; 2]) -> FreeState {
        let inverse = inverse_deformation(prescribed);
        let transform = strain_transform([[inverse.m11, inverse.m21], [inverse.m12, inverse.m22]]);
        let strain = transform * (strain - prescribed);
        FreeState { inverse, transform, strain, state: self.state(&strain) }
    }

    /// Returns −∂W/∂ε⁰, the force on the prescribed strains.
    ///
    /// The linear law has n. The neo-Hookean law has G τ Gᵀ with τ = n C of the elastic state, since n and C have the same directions.
    pub fn prescribed_force(&self, [strain, prescribed]: [&Vector3<f64>; 2]) -> Vector3<f64> {
        match self.energy {
            MembraneEnergy::Linear { .. } => self.state(&(strain - prescribed)).force,
            MembraneEnergy::NeoHookean { .. } => {
                let free = self.free_state([strain, prescribed]);
                let stretched = Matrix2::identity() + strain_tensor(&free.strain) * 2.0;
                let force = stress_tensor(&free.state.force) * stretched;
                stress_components(&(free.inverse * force * free.inverse.transpose()))
            }
        }
    }

    /// Returns the change of the forces for small changes of the strains and the prescribed ones.
    pub fn force_change(
        &self,
        [strain, prescribed]: [&Vector3<f64>; 2],
        [change, of_prescribed]: [&Vector3<f64>; 2],
    ) -> Vector3<f64> {
        match self.energy {
            MembraneEnergy::Linear { .. } => {
                self.state(&(strain - prescribed)).stiffness * (change - of_prescribed)
            }
            MembraneEnergy::NeoHookean { .. } => {
                let FreeState { inverse, strain, state, .. } = self.free_state([strain, prescribed]);
                let pulled = |e: &Vector3<f64>| inverse.transpose() * strain_tensor(e) * inverse;
                // Ḟ⁰ F⁰⁻¹, an upper triangle with the symmetric part Gᵀ ε̇⁰ G.
                let rate = pulled(of_prescribed);
                let rate = Matrix2::new(rate.m11, 2.0 * rate.m12, 0.0, rate.m22);
                let stretched = Matrix2::identity() + strain_tensor(&strain) * 2.0;
                let elastic = strain_components(&(pulled(change) - stretched * rate));
                let turned = rate * stress_tensor(&state.force);
                let force = stress_tensor(&(state.stiffness * elastic)) - turned - turned.transpose();
                stress_components(&(inverse * force * inverse.transpose()))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: [MembraneEnergy; 2] = [
        MembraneEnergy::Linear { stiffness: 3.0, poisson: 0.3 },
        MembraneEnergy::NeoHookean { stiffness: 2.0 },
    ];

    fn laws() -> impl Iterator<Item = MembraneLaw> {
        let tensions = [None, Some(1e-3)];
        LAWS.into_iter()
            .flat_map(move |energy| tensions.map(|tension_field| MembraneLaw { energy, tension_field }))
    }

    fn strains() -> [[Vector3<f64>; 2]; 3] {
        [
            // Tension in both directions, wrinkles, and slack.
            [Vector3::new(0.2, 0.1, 0.15), Vector3::new(-0.1, -0.05, 0.08)],
            [Vector3::new(0.1, -0.1, 0.05), Vector3::new(-0.12, 0.2, -0.1)],
            [Vector3::new(-0.1, -0.12, 0.02), Vector3::new(0.2, 0.1, 0.05)],
        ]
    }

    /// Derivative by central differences along a line.
    fn difference(of: impl Fn(f64) -> f64) -> f64 {
        let h = 1e-6;
        (of(h) - of(-h)) / (2.0 * h)
    }

    #[test]
    fn forces_are_derivatives_of_the_energy() {
        let along = Vector3::new(0.3, -0.2, 0.5);
        for law in laws() {
            for [e, e0] in strains() {
                let energy = |x: Vector3<f64>, x0: Vector3<f64>| law.strained_state([&x, &x0]).energy;
                let force = law.strained_state([&e, &e0]).force.dot(&along);
                let by_strain = difference(|h| energy(e + along * h, e0));
                assert!((force - by_strain).abs() < 1e-8, "{law:?}: {force} {by_strain}");
                let force = -law.prescribed_force([&e, &e0]).dot(&along);
                let by_prescribed = difference(|h| energy(e, e0 + along * h));
                assert!((force - by_prescribed).abs() < 1e-8, "{law:?}: {force} {by_prescribed}");
            }
        }
    }

    #[test]
    fn changes_are_derivatives_of_the_forces() {
        let [along, prescribed] = [Vector3::new(0.3, -0.2, 0.5), Vector3::new(-0.1, 0.4, 0.3)];
        let zero = Vector3::zeros();
        for law in laws() {
            for [e, e0] in strains() {
                let force =
                    |x: Vector3<f64>, x0: Vector3<f64>, i: usize| law.strained_state([&x, &x0]).force[i];
                let stiffness = law.strained_state([&e, &e0]).stiffness;
                let [both, alone] =
                    [prescribed, zero].map(|rate| law.force_change([&e, &e0], [&along, &rate]));
                for i in 0..3 {
                    let expected = difference(|h| force(e + along * h, e0 + prescribed * h, i));
                    assert!((both[i] - expected).abs() < 2e-8, "{law:?} {i}: {} {expected}", both[i]);
                    assert!((alone[i] - (stiffness * along)[i]).abs() < 1e-12, "{law:?} {i}");
                }
            }
        }
    }

    /// Without stress in the free shape; with those of the stretch beyond it: stretches multiply.
    #[test]
    fn stretches_multiply() {
        let law = MembraneLaw { energy: LAWS[1], tension_field: None };
        let green = |stretch: f64| 0.5 * (stretch * stretch - 1.0);
        let free = Vector3::new(green(1.2), green(0.7), 0.0);
        assert!(law.strained_state([&free, &free]).force.norm() < 1e-15);
        let (total, elastic) = (
            Vector3::new(green(1.2 * 1.1), green(0.7 * 1.3), 0.0),
            Vector3::new(green(1.1), green(1.3), 0.0),
        );
        let [found, expected] = [law.strained_state([&total, &free]), law.state(&elastic)];
        assert!((found.energy - expected.energy).abs() < 1e-15);
        // n of the reference shape is that of the free shape divided by the squares of its stretches.
        assert!((found.force.x - expected.force.x / 1.44).abs() < 1e-14);
        assert!((found.force.y - expected.force.y / 0.49).abs() < 1e-14);
    }
}
