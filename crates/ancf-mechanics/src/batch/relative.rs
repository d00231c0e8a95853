use ancf_solver::equations::Lanes;
use pulp::Simd;

use crate::kinematics::VectorKind;
use crate::lanes::{Lane, Pass, VectorLanes, added, minus, plus, scaled};
use crate::sections::STRAINS;

/// Assignment of the vectors of an element to its axis and its sections.
///
/// Strains depend on the differences to the first vector of the same kind, and on the first vectors of kind Y and Z.
/// There are A vectors of the axis, without the first position, and B vectors of each section kind.
#[derive(Clone, Debug)]
pub(crate) struct VectorLayout<const A: usize, const B: usize> {
    /// Vectors of the axis without the first one, each with true for a position.
    pub axis: [(usize, bool); A],
    pub y: [usize; B],
    pub z: [usize; B],
}

impl<const A: usize, const B: usize> VectorLayout<A, B> {
    /// Creates the layout of vectors of the given kinds, starting with a position.
    pub fn new(kinds: &[VectorKind]) -> Self {
        let of = |expected: &[VectorKind]| -> Vec<usize> {
            (0..kinds.len()).filter(|&i| expected.contains(&kinds[i])).collect()
        };
        let (axis, y, z) =
            (of(&[VectorKind::Position, VectorKind::Slope]), of(&[VectorKind::Y]), of(&[VectorKind::Z]));
        Self {
            axis: std::array::from_fn(|i| (axis[i + 1], kinds[axis[i + 1]] == VectorKind::Position)),
            y: std::array::from_fn(|i| y[i]),
            z: std::array::from_fn(|i| z[i]),
        }
    }
}

/// Vectors relative to the first one of their kind, and the first ones of kind Y and Z, or corresponding quantities.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct RelativeLanes<S: Simd, const A: usize, const B: usize> {
    pub axis: [VectorLanes<S>; A],
    pub y: [VectorLanes<S>; B],
    pub z: [VectorLanes<S>; B],
}

#[inline(always)]
fn vector<S: Simd>(pass: Pass<S>, x: &[Lanes], number: usize) -> VectorLanes<S> {
    pass.vector(&x[3 * number..3 * number + 3])
}

#[inline(always)]
fn differences<S: Simd, const B: usize>(
    pass: Pass<S>,
    x: &[Lanes],
    numbers: &[usize; B],
) -> [VectorLanes<S>; B] {
    let first = vector(pass, x, numbers[0]);
    let mut differences = [first; B];
    for i in 1..B {
        differences[i] = minus(vector(pass, x, numbers[i]), first);
    }
    differences
}

impl<S: Simd, const A: usize, const B: usize> RelativeLanes<S, A, B> {
    #[inline(always)]
    pub fn zero(pass: Pass<S>) -> Self {
        Self { axis: [pass.zeros(); A], y: [pass.zeros(); B], z: [pass.zeros(); B] }
    }

    #[inline(always)]
    pub fn of(pass: Pass<S>, layout: &VectorLayout<A, B>, x: &[Lanes]) -> Self {
        let (first, mut axis) = (vector(pass, x, 0), [pass.zeros(); A]);
        for i in 0..A {
            let (number, position) = layout.axis[i];
            axis[i] = vector(pass, x, number);
            if position {
                axis[i] = minus(axis[i], first);
            }
        }
        Self { axis, y: differences(pass, x, &layout.y), z: differences(pass, x, &layout.z) }
    }

    /// Returns the difference from other vectors.
    #[inline(always)]
    pub fn minus(mut self, other: &Self) -> Self {
        let subtract = |own: &mut [VectorLanes<S>], other: &[VectorLanes<S>]| {
            own.iter_mut().zip(other).for_each(|(own, other)| *own = minus(*own, *other));
        };
        subtract(&mut self.axis, &other.axis);
        subtract(&mut self.y, &other.y);
        subtract(&mut self.z, &other.z);
        self
    }

    /// Adds forces on the relative vectors to the forces on the vectors of the element.
    #[inline(always)]
    pub fn add_to<const N: usize>(&self, layout: &VectorLayout<A, B>, force: &mut [VectorLanes<S>; N]) {
        for i in 0..A {
            let (number, position) = layout.axis[i];
            force[number] = added(force[number], self.axis[i]);
            if position {
                force[0] = minus(force[0], self.axis[i]);
            }
        }
        for (numbers, share) in [(&layout.y, &self.y), (&layout.z, &self.z)] {
            let first = numbers[0];
            force[first] = added(force[first], share[0]);
            for i in 1..B {
                force[numbers[i]] = added(force[numbers[i]], share[i]);
                force[first] = minus(force[first], share[i]);
            }
        }
    }
}

/// Weights of the vectors ([`RelativeLanes`]) in the directors at a station.
#[derive(Clone, Debug)]
pub(crate) struct MixWeights<const A: usize, const B: usize> {
    /// Weights in a, h and k.
    pub axis: [[f64; 3]; A],
    /// Weights in d and b, or in e and c. The first vector has no weight in b and c.
    pub section: [[f64; 2]; B],
}

/// Directors of a pass, padded to a power of two.
pub(crate) type DirectorLanes<S> = [VectorLanes<S>; 8];

impl<const A: usize, const B: usize> MixWeights<A, B> {
    /// Computes the directors from the vectors, with h and k if required.
    #[inline(always)]
    pub fn directors<S: Simd>(
        &self,
        pass: Pass<S>,
        x: &RelativeLanes<S, A, B>,
        reach: usize,
    ) -> DirectorLanes<S> {
        let mut u = [pass.zeros(); 8];
        for i in 0..A {
            u[0] = plus(u[0], x.axis[i], pass.splat(self.axis[i][0]));
        }
        [u[3], u[1]] = self.of_section(pass, &x.y);
        [u[4], u[2]] = self.of_section(pass, &x.z);
        if reach > 5 {
            for i in 0..A {
                u[5] = plus(u[5], x.axis[i], pass.splat(self.axis[i][1]));
                u[6] = plus(u[6], x.axis[i], pass.splat(self.axis[i][2]));
            }
        }
        u
    }

    /// Computes d and b from the vectors of kind Y, or e and c from those of kind Z.
    #[inline(always)]
    fn of_section<S: Simd>(&self, pass: Pass<S>, x: &[VectorLanes<S>; B]) -> [VectorLanes<S>; 2] {
        let (mut value, mut slope) = (scaled(x[0], pass.splat(self.section[0][0])), pass.zeros());
        for i in 1..B {
            value = plus(value, x[i], pass.splat(self.section[i][0]));
            slope = plus(slope, x[i], pass.splat(self.section[i][1]));
        }
        [value, slope]
    }

    #[inline(always)]
    fn to_section<S: Simd>(
        &self,
        pass: Pass<S>,
        [value, slope]: [VectorLanes<S>; 2],
        force: &mut [VectorLanes<S>; B],
    ) {
        force[0] = plus(force[0], value, pass.splat(self.section[0][0]));
        for i in 1..B {
            let sum = plus(force[i], value, pass.splat(self.section[i][0]));
            force[i] = plus(sum, slope, pass.splat(self.section[i][1]));
        }
    }

    /// Distributes forces of the directors to the vectors.
    #[inline(always)]
    pub fn spread<S: Simd>(
        &self,
        pass: Pass<S>,
        p: &DirectorLanes<S>,
        force: &mut RelativeLanes<S, A, B>,
        reach: usize,
    ) {
        for i in 0..A {
            force.axis[i] = plus(force.axis[i], p[0], pass.splat(self.axis[i][0]));
        }
        self.to_section(pass, [p[3], p[1]], &mut force.y);
        self.to_section(pass, [p[4], p[2]], &mut force.z);
        if reach > 5 {
            for i in 0..A {
                force.axis[i] = plus(force.axis[i], p[5], pass.splat(self.axis[i][1]));
                force.axis[i] = plus(force.axis[i], p[6], pass.splat(self.axis[i][2]));
            }
        }
    }
}

/// Number for each strain of a law, for each term of a pass.
pub(crate) type StrainLanes<S> = [Lane<S>; STRAINS];
