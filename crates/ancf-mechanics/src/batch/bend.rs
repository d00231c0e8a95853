use pulp::Simd;

use super::stiffness::MatrixLanes;
use crate::lanes::{Lane, Pass, VectorLanes, dot, minus, plus, scaled};

/// Bending of a material line at one point, as defined by [`line::Bend`](crate::kinematics::Bend).
pub(crate) struct BendLanes<S: Simd> {
    a: VectorLanes<S>,
    b: VectorLanes<S>,
    /// Products a·b, 1/a·a and 1/|a|.
    ab: Lane<S>,
    over_aa: Lane<S>,
    shortness: Lane<S>,
}

/// Symmetric matrix over the vectors a and b. Block ba has the rows of b.
pub(crate) struct BendBlockLanes<S: Simd> {
    pub aa: MatrixLanes<S>,
    pub ba: MatrixLanes<S>,
    pub bb: MatrixLanes<S>,
}

/// Computes sum += factor × x yᵀ.
#[inline(always)]
fn add_product<S: Simd>(sum: &mut MatrixLanes<S>, x: VectorLanes<S>, y: VectorLanes<S>, factor: Lane<S>) {
    let x = scaled(x, factor);
    for r in 0..3 {
        for c in 0..3 {
            sum[3 * r + c] = x[r].mul_add(y[c], sum[3 * r + c]);
        }
    }
}

#[inline(always)]
fn add_identity<S: Simd>(sum: &mut MatrixLanes<S>, factor: Lane<S>) {
    for r in [0, 4, 8] {
        sum[r] = sum[r] + factor;
    }
}

impl<S: Simd> BendLanes<S> {
    #[inline(always)]
    pub fn new(pass: Pass<S>, a: VectorLanes<S>, b: VectorLanes<S>) -> Self {
        let aa = dot(a, a);
        let over_aa = pass.splat(1.0).over(aa);
        Self { a, b, ab: dot(a, b), over_aa, shortness: over_aa.sqrt() }
    }

    /// Returns β.
    #[inline(always)]
    pub fn strain(&self) -> VectorLanes<S> {
        scaled(plus(self.b, self.a, -(self.ab * self.over_aa)), self.shortness)
    }

    /// Returns β° for the rates of a and b.
    #[inline(always)]
    pub fn rate(&self, pass: Pass<S>, da: VectorLanes<S>, db: VectorLanes<S>) -> VectorLanes<S> {
        let (along_a, along_b) = (dot(self.a, da) * self.over_aa, dot(self.a, db) * self.over_aa);
        let part = self.ab * self.over_aa;
        let of_a = along_b - pass.splat(2.0) * part * along_a;
        let sum = plus(plus(db, da, -part), self.b, -along_a);
        scaled(plus(sum, self.a, -of_a), self.shortness)
    }

    /// Returns Lᵀm for m normal to t.
    #[inline(always)]
    pub fn force(&self, m: VectorLanes<S>) -> [VectorLanes<S>; 2] {
        let sum = plus(scaled(m, self.ab), self.a, dot(self.b, m));
        [scaled(sum, -(self.over_aa * self.shortness)), scaled(m, self.shortness)]
    }

    /// Returns `factor` times the second derivative of ½K².
    #[inline(always)]
    pub fn hessian(&self, pass: Pass<S>, factor: f64) -> BendBlockLanes<S> {
        let (a, b, ab, over) = (self.a, self.b, self.ab, self.over_aa);
        let (two, four, zero) = (pass.splat(2.0), pass.splat(4.0), [pass.zero(); 9]);
        let BendBlockLanes { mut aa, mut ba, mut bb } = BendBlockLanes { aa: zero, ba: zero, bb: zero };
        let of_bb = pass.splat(factor) * over;
        add_identity(&mut bb, of_bb);
        add_product(&mut bb, a, a, -(of_bb * over));
        let of_ba = of_bb * over;
        add_product(&mut ba, minus(scaled(a, four * ab * over), scaled(b, two)), a, of_ba);
        add_product(&mut ba, a, b, -of_ba);
        add_identity(&mut ba, -(ab * of_ba));
        let (b_b, squared) = (dot(b, b), ab * ab * over);
        add_identity(&mut aa, (two * squared - b_b) * of_ba);
        add_product(&mut aa, b, b, -of_ba);
        let of_aa = of_ba * over;
        let along = scaled(a, four * b_b - pass.splat(12.0) * squared);
        add_product(&mut aa, plus(along, b, four * ab), a, of_aa);
        add_product(&mut aa, a, b, four * ab * of_aa);
        BendBlockLanes { aa, ba, bb }
    }

    /// Adds the second derivative of m·β at constant m normal to the tangent.
    #[inline(always)]
    pub fn add_stress_stiffness(&self, pass: Pass<S>, m: VectorLanes<S>, h: &mut BendBlockLanes<S>) {
        let (a, b, work) = (self.a, self.b, dot(m, self.b));
        let cube = self.over_aa * self.shortness;
        add_product(&mut h.ba, m, a, -cube);
        add_product(&mut h.ba, a, m, -cube);
        add_identity(&mut h.aa, -(work * cube));
        add_product(&mut h.aa, m, b, -cube);
        add_product(&mut h.aa, b, m, -cube);
        let of_aa = pass.splat(3.0) * self.over_aa * cube;
        add_product(&mut h.aa, plus(scaled(a, work), m, self.ab), a, of_aa);
        add_product(&mut h.aa, a, m, self.ab * of_aa);
    }

    /// Adds `factor` LᵀL.
    #[inline(always)]
    pub fn add_damping(&self, pass: Pass<S>, factor: f64, h: &mut BendBlockLanes<S>) {
        let (part, factor) = (self.ab * self.over_aa, pass.splat(factor) * self.over_aa);
        // L = (x aᵀ − C/A I, I − a aᵀ/A)/|a| with x = (2 C/A a − b)/A; a·x = C/A.
        let x = minus(scaled(self.a, pass.splat(2.0) * part), self.b);
        let x = scaled(x, self.over_aa);
        add_product(&mut h.aa, scaled(self.a, dot(x, x)), self.a, factor);
        add_product(&mut h.aa, x, self.a, -(part * factor));
        add_product(&mut h.aa, self.a, x, -(part * factor));
        add_identity(&mut h.aa, part * part * factor);
        // (I − a aᵀ/A)(x aᵀ − C/A I).
        add_product(&mut h.ba, x, self.a, factor);
        add_identity(&mut h.ba, -(part * factor));
        let along = dot(self.a, x) * self.over_aa - part * self.over_aa;
        add_product(&mut h.ba, self.a, self.a, -(along * factor));
        add_identity(&mut h.bb, factor);
        add_product(&mut h.bb, self.a, self.a, -(self.over_aa * factor));
    }
}
