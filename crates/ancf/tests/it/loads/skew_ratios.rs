//! Size of the stiffness of loads without a potential, relative to the symmetric stiffness.

use ancf::Model;
use ancf::solver::eigen::skew_ratio;
use ancf::solver::equations::{EquationsOfMotion, Weights};
use nalgebra::{DMatrix, DVector};

/// A cantilever plate and a cantilever strip under follower pressures.
fn plates() -> [Model; 2] {
    [([3, 3], 1.0), ([5, 1], 0.2)].map(|(elements, width)| {
        let text = format!(
            "materials.m = {{ density = 1000, young = 1e7, poisson = 0.3 }}\n\
             [[bodies]]\nkind = \"shell\"\nname = \"s\"\nthickness = 0.02\nmaterial = \"m\"\nelements = {elements:?}\n\
             surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, {width}, 0] }}\n\
             [[joints]]\nkind = \"support\"\nname = \"j\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\n\
             condition = \"clamped\"\n[[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = 20\n\
             [analysis]\nkind = \"statics\"\n"
        );
        Model::parse(&text).unwrap()
    })
}

/// The ratio is the spectral radius of K⁻¹A, here by dense matrices.
#[test]
fn ratio_is_the_spectral_radius() {
    for model in plates() {
        let assembly = model.assemble().unwrap();
        let (mut s, system) = (assembly.rest(), &assembly.system);
        s.load = 1.0;
        let mut left = system.matrix();
        system.tangent(&s, Weights::STIFFNESS, &mut left);
        let (size, n) = (left.pattern().size(), system.coordinates());
        let column = |j: usize| {
            let mut unit = vec![0.0; size];
            unit[j] = 1.0;
            DVector::from_vec(left.times(&unit))
        };
        let dense = DMatrix::from_columns(&(0..size).map(column).collect::<Vec<_>>());
        let mut skew = DMatrix::zeros(n, n);
        for (i, j, value) in system.skew_stiffness(&s) {
            skew[(i, j)] += value;
            skew[(j, i)] -= value;
        }
        let inverse = dense.try_inverse().unwrap();
        let product: DMatrix<f64> = inverse.view((0, 0), (n, n)) * skew;
        let expected = product.complex_eigenvalues().iter().map(|x| x.norm()).fold(0.0, f64::max);
        let found = skew_ratio(system, system.matrix(), &s).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-3 && expected > 1e-4, "{found} not {expected}");
    }
}
