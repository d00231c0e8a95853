//! Operations on quads of numbers. They are called within [`pulp::Arch::dispatch`] and are therefore inlined.

use crate::sparse::{QUAD, Quad};

/// True if the processor has fused products. WebAssembly has none, and their replacement takes ten times longer.
const IS_FUSED: bool = !cfg!(target_family = "wasm");

/// Returns a b + c, rounded once if the processor has the instruction.
#[inline(always)]
pub(super) fn mul_add(a: f64, b: f64, c: f64) -> f64 {
    if IS_FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// Computes y += s x.
#[inline(always)]
pub(super) fn add_product(y: &mut Quad, s: f64, x: &Quad) {
    for lane in 0..QUAD {
        y[lane] = mul_add(s, x[lane], y[lane]);
    }
}

/// Computes y += x ∘ z.
#[inline(always)]
pub(super) fn add_products(y: &mut Quad, x: &Quad, z: &Quad) {
    for lane in 0..QUAD {
        y[lane] = mul_add(x[lane], z[lane], y[lane]);
    }
}

/// Keeps a loop over quads as it is, at the end of an iteration. It contains no instruction.
///
/// Otherwise the compiler combines several iterations into wider vectors. The loops are so short that their remainders and
/// permutations take several times longer.
#[inline(always)]
pub(super) fn keep_quads() {
    std::hint::black_box(());
}

/// Computes x/d from 1/d with the accuracy of a division: equal rows remain equal, and their difference remains zero.
///
/// Source: Markstein (1990).
#[inline(always)]
pub(super) fn quotient(x: &Quad, d: f64, by: f64) -> Quad {
    let mut quotient = [0.0; QUAD];
    for lane in 0..QUAD {
        let near = by * x[lane];
        quotient[lane] = if IS_FUSED { (-near).mul_add(d, x[lane]).mul_add(by, near) } else { x[lane] / d };
    }
    quotient
}
