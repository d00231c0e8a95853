use ancf_solver::equations::{Lanes, Level, LocalLanes};
use pulp::Simd;

use super::entry_list::EntryList;
use crate::constraints::BilinearRow;
use crate::kinematics::Marker;
use crate::lanes::{Lane, LaneNumber, Pass, VectorLanes, added, dot, dot_add, plus, scaled};

/// Constraint rows of several terms with equal structure, one term in each lane ([`BilinearRow`]).
///
/// The evaluation has no closures, which would not be compiled for the vector instructions of the kernel.
#[derive(Debug)]
pub(super) struct BilinearLanes {
    /// Number of coordinates of a term. Its multipliers follow.
    coordinates: usize,
    rows: Vec<RowLanes>,
}

#[derive(Debug)]
struct RowLanes {
    products: Vec<ProductLanes>,
    linear: Vec<LinearLanes>,
    /// Constants g and h, or `None` if they are zero.
    offset: Option<[Lanes; 2]>,
}

/// Product c a·b.
#[derive(Debug)]
struct ProductLanes {
    factor: Lanes,
    vectors: [VectorSum; 2],
    /// Second derivatives c w u of pairs of coordinate vectors, each with the numbers of its three entries.
    curvature: Vec<(Lanes, [usize; 3])>,
}

/// Vector x₀ + Σ w q.
#[derive(Debug)]
struct VectorSum {
    reference: [Lanes; 3],
    parts: Vec<VectorPart>,
}

/// Weight of a vector of coordinates, and the numbers of its entries in the row of the multiplier.
#[derive(Debug)]
struct VectorPart {
    first: usize,
    weight: Lanes,
    entries: [usize; 3],
}

/// Factor of a coordinate, and the number of its entry.
#[derive(Debug)]
struct LinearLanes {
    coordinate: usize,
    factor: Lanes,
    entry: usize,
}

impl BilinearLanes {
    /// Creates the rows of terms with a number of coordinates, and adds the entries of their tangents.
    pub fn new(coordinates: usize, terms: &[Vec<BilinearRow>], entries: &mut EntryList) -> Self {
        let row = |k: usize| {
            let rows: Vec<&BilinearRow> = terms.iter().map(|rows| &rows[k]).collect();
            RowLanes::new(coordinates + k, &rows, entries)
        };
        Self { coordinates, rows: (0..terms[0].len()).map(row).collect() }
    }

    /// Adds Φ_qᵀ λ and Φ.
    #[inline(always)]
    pub fn add_residual<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, r: &mut [Lanes]) {
        for (k, row) in self.rows.iter().enumerate() {
            let (lambda, mut phi) = (pass.load(&at.lambda[k]), pass.zero());
            for product in &row.products {
                let [a, b] = product.values(pass, at.q);
                phi = product.change(pass, [&a, &b], phi);
                let force = lambda * pass.load(&product.factor);
                product.vectors[0].add(pass, scaled(b.value, force), r);
                product.vectors[1].add(pass, scaled(a.value, force), r);
            }
            for LinearLanes { coordinate, factor, .. } in &row.linear {
                let factor = pass.load(factor);
                phi = factor.mul_add(pass.load(&at.q[*coordinate]), phi);
                add(pass, &mut r[*coordinate], lambda * factor);
            }
            add(pass, &mut r[self.coordinates + k], row.without_offset(pass, at, phi));
        }
    }

    /// Adds the constraints at a level. The rows do not depend on time.
    #[inline(always)]
    pub fn add_constraints<S: Simd>(
        &self,
        pass: Pass<S>,
        at: &LocalLanes<'_>,
        level: Level,
        phi: &mut [Lanes],
    ) {
        for (row, to) in self.rows.iter().zip(phi) {
            let mut phi = pass.zero();
            for product in &row.products {
                let factor = pass.load(&product.factor);
                if level == Level::Position {
                    let [a, b] = product.values(pass, at.q);
                    phi = product.change(pass, [&a, &b], phi);
                    continue;
                }
                let [va, vb] = [product.vectors[0].sum(pass, at.v), product.vectors[1].sum(pass, at.v)];
                phi = if level == Level::Velocity {
                    let [a, b] = product.values(pass, at.q);
                    factor.mul_add(dot_add(a.value, vb, dot(va, b.value)), phi)
                } else {
                    factor.mul_add(dot(va, vb) * pass.splat(2.0), phi)
                };
            }
            let moved = if level == Level::Velocity { at.v } else { at.q };
            if level != Level::Acceleration {
                for LinearLanes { coordinate, factor, .. } in &row.linear {
                    phi = pass.load(factor).mul_add(pass.load(&moved[*coordinate]), phi);
                }
            }
            let phi = if level == Level::Position { row.without_offset(pass, at, phi) } else { phi };
            add(pass, to, phi);
        }
    }

    /// Adds the entries of [w_q Σ λ ∂²Φ/∂q², Φ_qᵀ; Φ_q, 0].
    #[inline(always)]
    pub fn add_tangent<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, w_q: f64, k: &mut [Lanes]) {
        for (row, lambda) in self.rows.iter().zip(at.lambda) {
            let lambda = pass.load(lambda) * pass.splat(w_q);
            for product in &row.products {
                let ([a, b], factor) = (product.values(pass, at.q), pass.load(&product.factor));
                product.vectors[0].add_entries(pass, scaled(b.value, factor), k);
                product.vectors[1].add_entries(pass, scaled(a.value, factor), k);
                for (weight, entries) in &product.curvature {
                    let value = pass.load(weight) * lambda;
                    for &entry in entries {
                        add(pass, &mut k[entry], value);
                    }
                }
            }
            for LinearLanes { factor, entry, .. } in &row.linear {
                add(pass, &mut k[*entry], pass.load(factor));
            }
        }
    }
}

/// Adds to a number of each term.
#[inline(always)]
pub(super) fn add<S: Simd>(pass: Pass<S>, to: &mut Lanes, x: Lane<S>) {
    pass.store(to, pass.load(to) + x);
}

/// Value of a vector and its change from the reference state.
#[derive(Clone, Copy)]
struct MovedVector<S: Simd> {
    value: VectorLanes<S>,
    change: VectorLanes<S>,
}

impl RowLanes {
    fn new(multiplier: usize, rows: &[&BilinearRow], entries: &mut EntryList) -> Self {
        let of = |number: &dyn Fn(&BilinearRow) -> f64| lanes(rows, number);
        let products = (0..rows[0].products.len()).map(|p| ProductLanes::new(multiplier, p, rows, entries));
        let products = products.collect();
        let linear = rows[0].linear.iter().enumerate().map(|(i, &(coordinate, _))| LinearLanes {
            coordinate,
            factor: of(&|row| row.linear[i].1),
            entry: entries.number(multiplier, coordinate),
        });
        let linear = linear.collect();
        let has_offset = rows.iter().any(|row| row.offset != [0.0; 2]);
        let offset = has_offset.then(|| [0, 1].map(|i| of(&|row| row.offset[i])));
        Self { products, linear, offset }
    }

    /// Subtracts g + s h.
    #[inline(always)]
    fn without_offset<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, phi: Lane<S>) -> Lane<S> {
        match &self.offset {
            Some([g, h]) => phi - pass.load(h).mul_add(pass.splat(at.load), pass.load(g)),
            None => phi,
        }
    }
}

/// Returns a number of each row.
fn lanes(rows: &[&BilinearRow], number: &dyn Fn(&BilinearRow) -> f64) -> Lanes {
    Lanes::of(&rows.iter().map(|row| number(row)).collect::<Vec<_>>())
}

impl ProductLanes {
    fn new(multiplier: usize, p: usize, rows: &[&BilinearRow], entries: &mut EntryList) -> Self {
        let of = |side: usize| -> Vec<&Marker> { rows.iter().map(|row| &row.products[p].1[side]).collect() };
        let vectors = [of(0), of(1)].map(|markers| VectorSum::new(multiplier, &markers, entries));
        let mut curvature = Vec::new();
        for (i, &(first, _)) in of(0)[0].parts().iter().enumerate() {
            for (j, &(other, _)) in of(1)[0].parts().iter().enumerate() {
                // The pairs (i, j) and (j, i) have the same entries of the symmetric matrix.
                let double = if first == other { 2.0 } else { 1.0 };
                let weight = |row: &BilinearRow| {
                    let (factor, [a, b]) = &row.products[p];
                    double * factor * a.parts()[i].1 * b.parts()[j].1
                };
                curvature.push((lanes(rows, &weight), entries.diagonal(first, other)));
            }
        }
        Self { factor: lanes(rows, &|row| row.products[p].0), vectors, curvature }
    }

    #[inline(always)]
    fn values<S: Simd>(&self, pass: Pass<S>, q: &[Lanes]) -> [MovedVector<S>; 2] {
        let [a, b] = &self.vectors;
        [a.moved(pass, q), b.moved(pass, q)]
    }

    /// Computes Φ + c (a·b − a₀·b₀) without cancellation.
    #[inline(always)]
    fn change<S: Simd>(&self, pass: Pass<S>, [a, b]: [&MovedVector<S>; 2], phi: Lane<S>) -> Lane<S> {
        let reference = pass.vector(&self.vectors[0].reference);
        let change = dot_add(a.change, b.value, dot(reference, b.change));
        pass.load(&self.factor).mul_add(change, phi)
    }
}

impl VectorSum {
    fn new(multiplier: usize, markers: &[&Marker], entries: &mut EntryList) -> Self {
        let of = |number: &dyn Fn(&Marker) -> f64| {
            Lanes::of(&markers.iter().map(|marker| number(marker)).collect::<Vec<_>>())
        };
        let parts = markers[0].parts().iter().enumerate().map(|(i, &(first, _))| VectorPart {
            first,
            weight: of(&|marker| marker.parts()[i].1),
            entries: entries.row(multiplier, first),
        });
        let parts = parts.collect();
        Self { reference: [0, 1, 2].map(|axis| of(&|marker| marker.reference()[axis])), parts }
    }

    /// Computes Σ w x.
    #[inline(always)]
    fn sum<S: Simd>(&self, pass: Pass<S>, x: &[Lanes]) -> VectorLanes<S> {
        let mut sum = pass.zeros();
        for VectorPart { first, weight, .. } in &self.parts {
            sum = plus(sum, pass.vector(&x[*first..first + 3]), pass.load(weight));
        }
        sum
    }

    #[inline(always)]
    fn moved<S: Simd>(&self, pass: Pass<S>, q: &[Lanes]) -> MovedVector<S> {
        let change = self.sum(pass, q);
        MovedVector { value: added(pass.vector(&self.reference), change), change }
    }

    /// Adds the forces of a force on the vector.
    #[inline(always)]
    fn add<S: Simd>(&self, pass: Pass<S>, force: VectorLanes<S>, r: &mut [Lanes]) {
        for VectorPart { first, weight, .. } in &self.parts {
            let (weight, rows) = (pass.load(weight), &mut r[*first..first + 3]);
            for axis in 0..3 {
                let sum = force[axis].mul_add(weight, pass.load(&rows[axis]));
                pass.store(&mut rows[axis], sum);
            }
        }
    }

    /// Adds the derivatives of the row for the derivative by the vector.
    #[inline(always)]
    fn add_entries<S: Simd>(&self, pass: Pass<S>, by: VectorLanes<S>, k: &mut [Lanes]) {
        for VectorPart { weight, entries, .. } in &self.parts {
            let weight = pass.load(weight);
            for axis in 0..3 {
                let sum = by[axis].mul_add(weight, pass.load(&k[entries[axis]]));
                pass.store(&mut k[entries[axis]], sum);
            }
        }
    }
}
