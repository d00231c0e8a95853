//! Condition numbers of the iteration matrix in the forms proposed for index-3 equations.

use ancf::Model;
use ancf::solver::equations::{EquationsOfMotion, Weights};
use anyhow::{Context, Result};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::models::{BETA, EquationForm, PaperCase};

/// Form of the iteration matrix of a Newton step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum MatrixForm {
    /// [M + βh²K, Φᵀ; βh²Φ, 0] of eq. (37) with dimensional coordinates (r, r_x, r_y, r_z).
    Dimensional,
    /// Eq. (37) with coordinates (r, l r_x, l r_y, l r_z).
    LengthSlopes,
    /// Non-dimensional eq. (37), as in the paper.
    Paper,
    /// Symmetric form: constraint rows divided by βh² (Negrut et al. 2007).
    Symmetric,
    /// Displacements as unknowns, [M/βh² + K, Φᵀ; Φ, 0], without scaling.
    Displacement,
    /// Displacement form scaled from left and right by powers of h (Bottasso, Dopico & Trainelli 2008).
    Bottasso,
    /// Symmetric form equilibrated by diagonal matrices on both sides (Ruiz 2001).
    Equilibrated,
}

impl MatrixForm {
    /// All forms, in the order of the report.
    pub const ALL: [Self; 7] = [
        Self::Dimensional,
        Self::LengthSlopes,
        Self::Paper,
        Self::Symmetric,
        Self::Displacement,
        Self::Bottasso,
        Self::Equilibrated,
    ];

    fn equations(self) -> EquationForm {
        match self {
            Self::Paper => EquationForm::NonDimensional,
            Self::LengthSlopes => EquationForm::LengthSlopes,
            _ => EquationForm::Dimensional,
        }
    }
}

/// Condition numbers of all forms for one mesh and step.
#[derive(Clone, Debug, Serialize)]
pub struct ConditionRow {
    /// Number of elements.
    pub n: u32,
    /// Physical step, s.
    pub h: f64,
    /// 2-norm condition numbers, in the order of [`MatrixForm::ALL`].
    pub condition: [f64; 7],
}

/// Computes the condition numbers of the beam on a spherical joint with Young's modulus `young`, straight and at rest.
///
/// # Errors
/// If the model cannot be assembled.
pub fn condition_row(young: f64, n: u32, h: f64) -> Result<ConditionRow> {
    let mut condition = [0.0; 7];
    for (number, form) in condition.iter_mut().zip(MatrixForm::ALL) {
        let mut model = PaperCase::Spherical.model(form.equations(), n, h);
        model.materials.values_mut().for_each(|material| material.young = young);
        let matrices = Matrices::new(&model)?;
        *number = matrices.condition(form)?;
    }
    Ok(ConditionRow { n, h, condition })
}

/// Bordered matrix of M, K and Φ_q at rest, and the step.
struct Matrices {
    /// [M + βh²K, Φᵀ; Φ, 0].
    symmetric: DMatrix<f64>,
    coordinates: usize,
    beta_h2: f64,
}

impl Matrices {
    fn new(model: &Model) -> Result<Self> {
        let scales = model.scales().scales;
        let dynamics = model.analysis.dynamics().context("the problems of the paper are dynamic")?;
        let h = dynamics.step.fixed().context("the problems of the paper have a fixed step")? / scales.time;
        let assembly = model.scaled(&scales).assemble().ok().context("the model of the paper is valid")?;
        let (system, beta_h2) = (&assembly.system, BETA * h * h);
        let mut tangent = system.matrix();
        system.tangent(&assembly.rest(), Weights { q: beta_h2, v: 0.0, a: 1.0 }, &mut tangent);
        let rows = tangent.dense();
        let symmetric = DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j]);
        Ok(Self { symmetric, coordinates: system.coordinates(), beta_h2 })
    }

    /// Returns ‖J‖₂ ‖J⁻¹‖₂ of J = L S R. S is the symmetric form, L and R are diagonal.
    ///
    /// J⁻¹ is computed from the inverse of the equilibrated matrix. The result is accurate beyond 1/ε too.
    fn condition(&self, form: MatrixForm) -> Result<f64> {
        let (left, right) = self.scaling(form);
        let ruiz = equilibration(&self.symmetric);
        let scaled = |l: &DVector<f64>, r: &DVector<f64>, a: &DMatrix<f64>| {
            DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| l[i] * a[(i, j)] * r[j])
        };
        let equilibrated = scaled(&ruiz, &ruiz, &self.symmetric);
        let inverse = equilibrated.try_inverse().context("the iteration matrix is regular")?;
        let (outer, inner) = (ruiz.component_div(&right), ruiz.component_div(&left));
        Ok(norm(&scaled(&left, &right, &self.symmetric)) * norm(&scaled(&outer, &inner, &inverse)))
    }

    /// Returns the diagonals L and R of a form.
    fn scaling(&self, form: MatrixForm) -> (DVector<f64>, DVector<f64>) {
        let n = self.symmetric.nrows();
        let diagonal = |coordinates: f64, multipliers: f64| {
            DVector::from_fn(n, |i, _| if i < self.coordinates { coordinates } else { multipliers })
        };
        let one = diagonal(1.0, 1.0);
        let b = self.beta_h2;
        match form {
            MatrixForm::Dimensional | MatrixForm::LengthSlopes | MatrixForm::Paper => (diagonal(1.0, b), one),
            MatrixForm::Symmetric => (one.clone(), one),
            MatrixForm::Displacement => (diagonal(1.0 / b, 1.0), diagonal(1.0, b)),
            MatrixForm::Bottasso => {
                let (left, right) = self.scaling(MatrixForm::Displacement);
                (left.component_mul(&diagonal(b, 1.0)), right.component_mul(&diagonal(1.0, 1.0 / b)))
            }
            MatrixForm::Equilibrated => {
                let d = equilibration(&self.symmetric);
                (d.clone(), d)
            }
        }
    }
}

/// Returns the equilibration of Ruiz (2001): repeated division by the square roots of the row maxima.
fn equilibration(a: &DMatrix<f64>) -> DVector<f64> {
    let mut d = DVector::from_element(a.nrows(), 1.0);
    for _ in 0..20 {
        let largest = DVector::from_fn(a.nrows(), |i, _| {
            (0..a.ncols()).map(|j| (d[i] * a[(i, j)] * d[j]).abs()).fold(0.0, f64::max)
        });
        d.component_div_assign(&largest.map(f64::sqrt));
    }
    d
}

/// Computes ‖A‖₂ by power iteration on AᵀA.
fn norm(a: &DMatrix<f64>) -> f64 {
    let mut x = DVector::from_fn(a.ncols(), |i, _| 1.0 + 0.37 * (i as f64).sin());
    let mut norm = 0.0;
    for _ in 0..500 {
        x /= x.norm();
        let y = a * &x;
        let next = y.norm();
        if (next - norm).abs() <= 1e-6 * next {
            return next;
        }
        norm = next;
        x = a.tr_mul(&y);
    }
    norm
}
