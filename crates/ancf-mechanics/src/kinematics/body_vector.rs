use ancf_solver::equations::{LocalMatrix, State};
use nalgebra::{Matrix3, SMatrix, Vector3};

use super::frame::NEGLIGIBLE;
use super::marker::Marker;
use super::section_frame::SectionFrame;

/// Vector of a body or of the ground: a [`Marker`], plus vectors that are constant in the frames of sections.
///
/// a = x₀ + Σᵢ wᵢ q[vᵢ..vᵢ+3] + Σⱼ cⱼ Rⱼ(q) Xⱼ. Points and directions of rigid bodies, of the ground and of cables are
/// markers. A direction of a section is R X with the rotation R of the [`SectionFrame`]; a point at an arm from the axis
/// is r + R X.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyVector {
    linear: Marker,
    turned: Vec<TurnedVector>,
}

/// Vector R X in the frame of a section.
#[derive(Clone, Debug, PartialEq)]
struct TurnedVector {
    frame: SectionFrame,
    /// X: value in the reference state.
    reference: Vector3<f64>,
}

impl From<Marker> for BodyVector {
    fn from(linear: Marker) -> Self {
        Self { linear, turned: Vec::new() }
    }
}

impl From<&Marker> for BodyVector {
    fn from(linear: &Marker) -> Self {
        linear.clone().into()
    }
}

impl From<&Self> for BodyVector {
    fn from(vector: &Self) -> Self {
        vector.clone()
    }
}

impl BodyVector {
    /// Creates a fixed vector: a point or a direction of the ground.
    pub const fn fixed(reference: Vector3<f64>) -> Self {
        Self { linear: Marker::fixed(reference), turned: Vec::new() }
    }

    /// Creates the direction of a section with the reference value X.
    pub fn turned(frame: &SectionFrame, reference: Vector3<f64>) -> Self {
        let turned = TurnedVector { frame: frame.clone(), reference };
        Self { linear: Marker::fixed(Vector3::zeros()), turned: vec![turned] }
    }

    /// Creates a linear combination of vectors.
    pub fn combined<'a>(terms: impl IntoIterator<Item = (f64, &'a Self)>) -> Self {
        let terms: Vec<(f64, &Self)> = terms.into_iter().collect();
        let linear = Marker::combined(terms.iter().map(|(factor, vector)| (*factor, &vector.linear)));
        let scaled = |factor: f64, part: &TurnedVector| TurnedVector {
            frame: part.frame.clone(),
            reference: part.reference * factor,
        };
        let parts =
            terms.iter().flat_map(|(factor, vector)| vector.turned.iter().map(|part| scaled(*factor, part)));
        let mut turned: Vec<TurnedVector> = Vec::new();
        for part in parts {
            match turned.iter_mut().find(|known| known.frame == part.frame) {
                Some(known) => known.reference += part.reference,
                None => turned.push(part),
            }
        }
        Self { linear, turned }
    }

    /// Returns the marker of a vector that is linear in the coordinates.
    pub fn marker(&self) -> Option<&Marker> {
        self.turned.is_empty().then_some(&self.linear)
    }

    /// Returns the part that is linear in the coordinates: of a point at an arm from the axis, the point of the axis.
    pub const fn linear(&self) -> &Marker {
        &self.linear
    }

    /// Returns true if the vector is linear in the coordinates.
    pub const fn is_linear(&self) -> bool {
        self.turned.is_empty()
    }

    /// Returns the value in the reference state.
    pub fn reference(&self) -> Vector3<f64> {
        self.turned.iter().fold(self.linear.reference(), |sum, part| sum + part.reference)
    }

    /// Returns the derivatives of a·b by the coordinates in the reference state.
    pub fn product_gradient(a: &Self, b: &Self) -> Vec<(usize, f64)> {
        let coordinates = Self::union_coordinates([a, b]);
        let (own, other) = (a.within(&coordinates), b.within(&coordinates));
        let q = vec![0.0; coordinates.len()];
        let derivative = |(i, &coordinate): (usize, &usize)| {
            let mut x = q.clone();
            x[i] = 1.0;
            let rate = own.rate(&q, &x).dot(&b.reference()) + a.reference().dot(&other.rate(&q, &x));
            (coordinate, rate)
        };
        coordinates.iter().enumerate().map(derivative).filter(|(_, rate)| *rate != 0.0).collect()
    }

    /// Returns the value in a state.
    pub fn value(&self, s: &State) -> Vector3<f64> {
        self.at(&s.q)
    }

    /// Returns the change from the reference state, without cancellation.
    pub fn displacement(&self, s: &State) -> Vector3<f64> {
        self.change(&s.q)
    }

    /// Returns the first variation along x in a state: ∂a/∂q x.
    pub fn variation(&self, s: &State, x: &[f64]) -> Vector3<f64> {
        self.rate(&s.q, x)
    }

    /// Returns the rate in a state.
    pub fn velocity(&self, s: &State) -> Vector3<f64> {
        self.rate(&s.q, &s.v)
    }

    /// Returns the second time derivative in a state.
    pub fn acceleration(&self, s: &State) -> Vector3<f64> {
        self.rate(&s.q, &s.a) + self.rate_slope(&s.q, &s.v)
    }

    /// Returns all coordinates, with repetitions.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> {
        self.linear.coordinates().chain(self.turned.iter().flat_map(|part| part.frame.coordinates()))
    }

    /// Returns the sorted coordinates of several vectors without repetition.
    pub fn union_coordinates<'a>(vectors: impl IntoIterator<Item = &'a Self>) -> Vec<usize> {
        let mut coordinates: Vec<usize> = vectors.into_iter().flat_map(Self::coordinates).collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        coordinates
    }

    /// Renumbers the coordinates for a term with the given coordinate list.
    pub(crate) fn within(&self, coordinates: &[usize]) -> Self {
        let within =
            |part: &TurnedVector| TurnedVector { frame: part.frame.within(coordinates), ..part.clone() };
        Self { linear: self.linear.within(coordinates), turned: self.turned.iter().map(within).collect() }
    }

    /// Returns the value at coordinates q.
    pub(crate) fn at(&self, q: &[f64]) -> Vector3<f64> {
        let linear = self.linear.reference() + self.linear.sum(q);
        self.turned.iter().fold(linear, |sum, part| sum + part.frame.at(q).turned(&part.reference))
    }

    /// Returns the change from the reference state, without cancellation.
    pub(crate) fn change(&self, q: &[f64]) -> Vector3<f64> {
        let linear = self.linear.sum(q);
        self.turned.iter().fold(linear, |sum, part| sum + part.frame.at(q).change(&part.reference))
    }

    /// Returns the derivative along x: ∂a/∂q x.
    pub(crate) fn rate(&self, q: &[f64], x: &[f64]) -> Vector3<f64> {
        self.turned.iter().fold(self.linear.sum(x), |sum, part| {
            let values = part.frame.at(q);
            sum + values.spin(part.frame.rates(x)).cross(&values.turned(&part.reference))
        })
    }

    /// Returns the second derivative along x: ∂(∂a/∂q x)/∂q x.
    pub(crate) fn rate_slope(&self, q: &[f64], x: &[f64]) -> Vector3<f64> {
        self.turned.iter().fold(Vector3::zeros(), |sum, part| {
            let (values, rates) = (part.frame.at(q), part.frame.rates(x));
            let (a, spin) = (values.turned(&part.reference), values.spin(rates));
            sum + values.spin_rate(rates).cross(&a) + spin.cross(&spin.cross(&a))
        })
    }

    /// Adds the forces (∂a/∂q)ᵀ f.
    pub fn add(&self, q: &[f64], f: Vector3<f64>, rows: &mut [f64]) {
        self.linear.add(f, rows);
        for part in &self.turned {
            let values = part.frame.at(q);
            part.frame.add(values.forces(&values.turned(&part.reference).cross(&f)), rows);
        }
    }

    /// Adds the derivative of (∂a/∂q)ᵀ f along x for a constant f.
    pub(crate) fn add_slope(&self, q: &[f64], x: &[f64], f: Vector3<f64>, rows: &mut [f64]) {
        for part in &self.turned {
            let (values, rates) = (part.frame.at(q), part.frame.rates(x));
            let a = values.turned(&part.reference);
            let [d, e] = values.forces(&values.spin(rates).cross(&a).cross(&f));
            let [dd, de] = values.force_variation(&a.cross(&f), rates);
            part.frame.add([d + dd, e + de], rows);
        }
    }

    /// Calls `visit(first, ∂a/∂q[first..first + 3])` for each vector of coordinates.
    pub(crate) fn blocks(&self, q: &[f64], mut visit: impl FnMut(usize, Matrix3<f64>)) {
        for &(first, w) in self.linear.parts() {
            visit(first, Matrix3::from_diagonal_element(w));
        }
        for part in &self.turned {
            let values = part.frame.at(q);
            let lever = values.turned(&part.reference).cross_matrix();
            for (director, variation) in part.frame.directors().iter().zip(values.variation()) {
                let block = -lever * variation;
                for &(first, w) in director.parts() {
                    visit(first, block * w);
                }
            }
        }
    }

    /// Adds the lower triangle of f·∂²a/∂q² for a constant f.
    pub(crate) fn add_curvature(&self, q: &[f64], f: Vector3<f64>, k: &mut LocalMatrix<'_>) {
        for part in &self.turned {
            add_section(&part.frame, &part.frame.at(q).curvature(&part.reference, &f), 1.0, k);
        }
    }

    /// Adds the lower triangle of (∂a/∂q)ᵀ h ∂b/∂q and its transpose.
    pub(crate) fn add_product(&self, other: &Self, q: &[f64], h: f64, k: &mut LocalMatrix<'_>) {
        let mut add = |i: usize, j: usize, value: f64| {
            if i >= j {
                k.add(i, j, value);
            }
        };
        if let (Some(a), Some(b)) = (self.marker(), other.marker()) {
            let h = Matrix3::from_diagonal_element(h);
            a.product(b, &h, &mut add);
            b.product(a, &h, &mut add);
            return;
        }
        self.blocks(q, |i, a| {
            other.blocks(q, |j, b| {
                let block = a.transpose() * b * h;
                for (m, n) in (0..3).flat_map(|m| (0..3).map(move |n| (m, n))) {
                    add(i + m, j + n, block[(m, n)]);
                    add(j + n, i + m, block[(m, n)]);
                }
            });
        });
    }

    /// Adds the lower triangle of the symmetric part of (∂a/∂q)ᵀ h ∂a/∂q.
    pub(crate) fn add_quadratic(&self, q: &[f64], h: &Matrix3<f64>, k: &mut LocalMatrix<'_>) {
        let h = (h + h.transpose()) * 0.5;
        let mut add = |i: usize, j: usize, value: f64| {
            if i >= j {
                k.add(i, j, value);
            }
        };
        if let Some(marker) = self.marker() {
            return marker.product(marker, &h, add);
        }
        self.blocks(q, |i, a| {
            self.blocks(q, |j, b| {
                let block = a.transpose() * h * b;
                for (m, n) in (0..3).flat_map(|m| (0..3).map(move |n| (m, n))) {
                    add(i + m, j + n, block[(m, n)]);
                }
            });
        });
    }

    /// Visits the lower entries of the skew part of (∂a/∂q)ᵀ h ∂b/∂q.
    pub(crate) fn visit_skew(
        &self,
        other: &Self,
        q: &[f64],
        h: &Matrix3<f64>,
        visit: &mut dyn FnMut(usize, usize, f64),
    ) {
        self.blocks(q, |i, a| {
            other.blocks(q, |j, b| {
                let block = a.transpose() * h * b * 0.5;
                let negligible = NEGLIGIBLE * block.amax();
                for (m, n) in (0..3).flat_map(|m| (0..3).map(move |n| (m, n))) {
                    let (row, column, value) = (i + m, j + n, block[(m, n)]);
                    if value.abs() <= negligible || row == column {
                        continue;
                    }
                    if row > column { visit(row, column, value) } else { visit(column, row, -value) }
                }
            });
        });
    }

    /// Returns the sum of magnitudes in the value.
    pub(crate) fn size(&self, q: &[f64]) -> f64 {
        self.turned.iter().fold(self.linear.size(q), |sum, part| sum + part.reference.norm())
    }

    /// Returns the sum of magnitudes in the derivative along x.
    pub(crate) fn rate_size(&self, q: &[f64], x: &[f64]) -> f64 {
        self.turned.iter().fold(self.linear.sum_of_sizes(x), |sum, part| {
            let directors: f64 = part.frame.directors().iter().map(|director| director.sum_of_sizes(x)).sum();
            sum + directors * part.frame.at(q).magnification() * part.reference.norm()
        })
    }

    /// Returns bounds of the rounding errors of the value and of its change.
    pub(crate) fn errors(&self, q: &[f64]) -> [f64; 2] {
        let of_linear = [self.linear.size(q), self.linear.sum_of_sizes(q)].map(|size| f64::EPSILON * size);
        self.turned.iter().fold(of_linear, |[value, change], part| {
            let [of_value, of_change] = part.frame.errors(q);
            let size = part.reference.norm();
            [value + of_value * size, change + of_change * size]
        })
    }

    /// Adds bounds of the rounding errors of (∂a/∂q)ᵀ f for a force of size `f` with the error `error`.
    pub(crate) fn add_errors(&self, q: &[f64], f: f64, error: f64, floor: &mut [f64]) {
        for &(first, w) in self.linear.parts() {
            let bound = (error + f64::EPSILON * f) * w.abs();
            floor[first..first + 3].iter_mut().for_each(|row| *row += bound);
        }
        for part in &self.turned {
            let size = part.reference.norm();
            part.frame.add_errors(q, size * f, size * error, floor);
        }
    }
}

/// Adds w times the lower triangle of a symmetric matrix over d and e of a section.
pub(crate) fn add_section(frame: &SectionFrame, h: &SMatrix<f64, 6, 6>, w: f64, k: &mut LocalMatrix<'_>) {
    let [d, e] = frame.directors();
    super::frame::add_symmetric(&[d, e], h, w, k);
}
