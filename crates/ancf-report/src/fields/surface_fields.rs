//! Scalars of shells: resultants, stresses at both faces and in the middle, strain energy.

use ancf::mechanics::shells::SurfaceStress;
use ancf::units::{Dimension, Scales};

/// Number of fields.
pub(super) const COUNT: usize = 20;

/// Names, symbols, dimensions, and true for both signs.
pub(super) const FIELDS: [(&str, &str, Dimension, bool); COUNT] = [
    ("von Mises stress top", "σv", Dimension::STRESS, false),
    ("von Mises stress middle", "σv", Dimension::STRESS, false),
    ("von Mises stress bottom", "σv", Dimension::STRESS, false),
    ("principal stress 1 top", "σ1", Dimension::STRESS, true),
    ("principal stress 2 top", "σ2", Dimension::STRESS, true),
    ("principal stress 1 bottom", "σ1", Dimension::STRESS, true),
    ("principal stress 2 bottom", "σ2", Dimension::STRESS, true),
    ("stress uu top", "σuu", Dimension::STRESS, true),
    ("stress vv top", "σvv", Dimension::STRESS, true),
    ("stress uv top", "σuv", Dimension::STRESS, true),
    ("stress uu bottom", "σuu", Dimension::STRESS, true),
    ("stress vv bottom", "σvv", Dimension::STRESS, true),
    ("stress uv bottom", "σuv", Dimension::STRESS, true),
    ("membrane force uu", "nuu", Dimension::FORCE_PER_LENGTH, true),
    ("membrane force vv", "nvv", Dimension::FORCE_PER_LENGTH, true),
    ("membrane force uv", "nuv", Dimension::FORCE_PER_LENGTH, true),
    ("moment uu", "muu", Dimension::FORCE, true),
    ("moment vv", "mvv", Dimension::FORCE, true),
    ("moment uv", "muv", Dimension::FORCE, true),
    ("energy density", "w", Dimension::FORCE_PER_LENGTH, false),
];

/// Values of the fields at a station, in the user's units.
pub(super) fn values(found: &SurfaceStress, scales: &Scales) -> [f64; COUNT] {
    let [top, middle, bottom] = found.von_mises();
    let [high, _, low] = found.principal();
    let [upper, _, lower] = found.layers;
    let (n, m) = (found.force, found.moment);
    let numbers = [
        [top, middle, bottom, high[0], high[1], low[0], low[1], upper.x, upper.y, upper.z],
        [lower.x, lower.y, lower.z, n.x, n.y, n.z, m.x, m.y, m.z, found.energy()],
    ];
    let numbers: [f64; COUNT] = std::array::from_fn(|k| numbers[k / 10][k % 10]);
    std::array::from_fn(|k| numbers[k] * scales.unit(FIELDS[k].2))
}
