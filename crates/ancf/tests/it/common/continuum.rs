//! Reference values for the element as a three-dimensional continuum, by numerical integration over the volume.
//!
//! Independent of the library except for the five Gauss points along the axis.

use std::f64::consts::TAU;

use ancf::mechanics::kinematics::gauss;
use ancf::mechanics::sections::Lame;
use ancf::model::{Circle, Ellipse, Rectangle, Section, Tube};
use nalgebra::{Matrix3, Vector3};

/// Returns ∫ f dA over a section.
pub(crate) fn integrate_section(section: Section, f: impl Fn([f64; 2]) -> f64) -> f64 {
    points(section).iter().map(|&(at, w)| w * f(at)).sum()
}

/// Returns the strain energy per volume of material coordinates, (½λ tr² E + G E:E) det J₀.
///
/// E = ½(FᵀF − I) with F = J J₀⁻¹.
pub(crate) fn energy_density(lame: Lame, j: &Matrix3<f64>, j0: &Matrix3<f64>) -> f64 {
    let strain = green_strain(&(j * j0.try_inverse().unwrap()));
    j0.determinant() * (0.5 * lame.lambda * strain.trace().powi(2) + lame.shear * strain.norm_squared())
}

/// Returns ∫ f dV over an element, exact for polynomials of degree nine along x and four across.
pub(crate) fn integrate(length: f64, section: Section, f: impl Fn([f64; 3]) -> f64) -> f64 {
    let across = points(section);
    let slice = |x: f64| across.iter().map(|&([y, z], w)| w * f([x, y, z])).sum::<f64>();
    gauss().iter().map(|&(xi, w)| w * length * slice(xi * length)).sum()
}

/// Points (y, z) and weights of a cross-section: product rule, in polar coordinates except for the rectangle.
fn points(section: Section) -> Vec<([f64; 2], f64)> {
    let pairs = |second: Vec<(f64, f64)>| {
        gauss()
            .into_iter()
            .flat_map(move |(x, w)| second.clone().into_iter().map(move |(y, u)| (x, y, w * u)))
    };
    match section {
        Section::Rectangle(Rectangle { height, width }) => pairs(gauss().to_vec())
            .map(|(y, z, w)| ([height * (y - 0.5), width * (z - 0.5)], w * height * width))
            .collect(),
        Section::Circle(Circle { diameter }) => rings(pairs, diameter, diameter, 0.0),
        Section::Tube(Tube { outer, inner }) => rings(pairs, outer, outer, inner / outer),
        Section::Ellipse(Ellipse { height, width }) => rings(pairs, height, width, 0.0),
        Section::General(_) | Section::Custom(_) => panic!("the section has no known shape"),
    }
}

/// Points and weights between two similar ellipses; `m` is the size of the inner one relative to the outer one.
fn rings<I: Iterator<Item = (f64, f64, f64)>>(
    pairs: impl Fn(Vec<(f64, f64)>) -> I,
    height: f64,
    width: f64,
    m: f64,
) -> Vec<([f64; 2], f64)> {
    pairs((0..8).map(|k| (TAU * f64::from(k) / 8.0, TAU / 8.0)).collect())
        .map(|(part, angle, w)| (m + (1.0 - m) * part, angle, (1.0 - m) * w))
        .map(|(r, angle, w)| {
            ([0.5 * height * r * angle.cos(), 0.5 * width * r * angle.sin()], 0.25 * height * width * w * r)
        })
        .collect()
}

/// Shape functions S₁ .. S₈ at a point, with S₂ = s(ξ − 2ξ² + ξ³), S₆ = s(ξ³ − ξ²) and s = l/ℓ.
///
/// Source: Kim et al. (2017), eqs (5), (12).
pub(crate) fn shape_values(length: f64, slope: f64, [x, y, z]: [f64; 3]) -> [f64; 8] {
    let (xi, s) = (x / length, length / slope);
    let (xi2, xi3) = (xi * xi, xi * xi * xi);
    let near = [1.0 - 3.0 * xi2 + 2.0 * xi3, s * (xi - 2.0 * xi2 + xi3), y * (1.0 - xi), z * (1.0 - xi)];
    let far = [3.0 * xi2 - 2.0 * xi3, s * (xi3 - xi2), y * xi, z * xi];
    [near[0], near[1], near[2] / slope, near[3] / slope, far[0], far[1], far[2] / slope, far[3] / slope]
}

/// Gradients of the shape functions.
pub(crate) fn shape_gradients(length: f64, slope: f64, [x, y, z]: [f64; 3]) -> [Vector3<f64>; 8] {
    let (xi, eta, zeta) = (x / length, y / length, z / length);
    let bend = Vector3::new((6.0 * xi - 6.0 * xi * xi) / length, 0.0, 0.0);
    [
        -bend,
        Vector3::new(1.0 - 4.0 * xi + 3.0 * xi * xi, 0.0, 0.0) / slope,
        Vector3::new(-eta, 1.0 - xi, 0.0) / slope,
        Vector3::new(-zeta, 0.0, 1.0 - xi) / slope,
        bend,
        Vector3::new(3.0 * xi * xi - 2.0 * xi, 0.0, 0.0) / slope,
        Vector3::new(eta, xi, 0.0) / slope,
        Vector3::new(zeta, 0.0, xi) / slope,
    ]
}

/// Deformation gradient J = Σₐ eₐ ∇Sₐᵀ.
pub(crate) fn deformation_gradient(e: &[Vector3<f64>; 8], gradients: &[Vector3<f64>; 8]) -> Matrix3<f64> {
    e.iter().zip(gradients).map(|(e, gradient)| e * gradient.transpose()).sum()
}

/// Green-Lagrange strain E = ½(JᵀJ − I).
pub(crate) fn green_strain(j: &Matrix3<f64>) -> Matrix3<f64> {
    (j.transpose() * j - Matrix3::identity()) * 0.5
}

/// Deformation gradient at (y, z) of the directors r_x, ∂r_y/∂x, ∂r_z/∂x, r_y, r_z.
pub(crate) fn gradient_of_directors(g: &[Vector3<f64>], [y, z]: [f64; 2]) -> Matrix3<f64> {
    Matrix3::from_columns(&[g[0] + g[1] * y + g[2] * z, g[3], g[4]])
}
