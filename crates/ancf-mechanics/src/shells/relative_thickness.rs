use super::mesh::ShellMesh;
use super::thin::VECTORS;

impl ShellMesh {
    /// Returns the thickness at (ξ, η) of an element, relative to that of the whole shell.
    pub(crate) fn relative_thickness(&self, element: usize, at: [f64; 2]) -> f64 {
        self.sections.as_ref().map_or(1.0, |field| field.at(element, at).scale)
    }

    /// Returns the relative thickness and its derivatives by ξ, η and both at the nodes of each element, in the order of its vectors;
    /// `None` if it is constant.
    pub(crate) fn relative_thicknesses(&self) -> Option<Vec<[f64; VECTORS]>> {
        self.sections.as_ref()?;
        let slopes = nodal_slopes(self.divisions(), |element, at| self.relative_thickness(element, at));
        let constant = |a: usize| if a.is_multiple_of(4) { slopes[0][0] } else { 0.0 };
        let is_constant = |own: &[f64; VECTORS]| (0..VECTORS).all(|a| own[a] == constant(a));
        (!slopes.iter().all(is_constant)).then_some(slopes)
    }
}

/// Position on a line of elements, in elements, with its weights in the value and in the slope at a node.
type Sample = (f64, [f64; 2]);

/// Distance of the samples of a slope, in elements. The slope of a jump at a node is that of a ramp over half an element.
const STEP: f64 = 0.25;

/// Samples of the value and the slope at node i of n elements, of second order.
fn samples(i: usize, n: usize) -> [Sample; 3] {
    let (at, h) = (i as f64, 2.0 * STEP);
    let sample = |shift: f64, value: f64, slope: f64| (at + shift * STEP, [value, slope / h]);
    if i == 0 {
        [sample(0.0, 1.0, -3.0), sample(1.0, 0.0, 4.0), sample(2.0, 0.0, -1.0)]
    } else if i == n {
        [sample(-2.0, 0.0, 1.0), sample(-1.0, 0.0, -4.0), sample(0.0, 1.0, 3.0)]
    } else {
        [sample(-1.0, 0.0, -1.0), sample(0.0, 1.0, 0.0), sample(1.0, 0.0, 1.0)]
    }
}

/// Computes a number h on a patch of n × m elements and h_ξ, h_η and h_ξη at the nodes of each element, in the order of its vectors.
///
/// `at` returns h at a place (ξ, η) of an element. The bicubic interpolation of the result is continuous with its slopes.
fn nodal_slopes([n, m]: [usize; 2], at: impl Fn(usize, [f64; 2]) -> f64) -> Vec<[f64; VECTORS]> {
    let part = |x: f64, count: usize| {
        let element = (x.floor() as usize).min(count - 1);
        (element, x - element as f64)
    };
    let value = |x: f64, y: f64| {
        let ((i, x), (j, y)) = (part(x, n), part(y, m));
        at(j * n + i, [x, y])
    };
    let of_node = |i: usize, j: usize| {
        let mut slopes = [0.0; 4];
        for (x, along) in samples(i, n) {
            for (y, across) in samples(j, m) {
                let weights = [0, 1, 2, 3].map(|kind| along[kind % 2] * across[kind / 2]);
                if weights != [0.0; 4] {
                    let here = value(x, y);
                    slopes.iter_mut().zip(weights).for_each(|(sum, weight)| *sum += weight * here);
                }
            }
        }
        slopes
    };
    let nodes: Vec<[f64; 4]> =
        (0..=m).flat_map(|j| (0..=n).map(move |i| (i, j))).map(|(i, j)| of_node(i, j)).collect();
    let element = |k: usize| {
        let (i, j) = (k % n, k / n);
        std::array::from_fn(|a| nodes[(j + a / 8) * (n + 1) + i + a / 4 % 2][a % 4])
    };
    (0..n * m).map(element).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::BicubicNet;

    /// A biquadratic number is exact, also at the edges of the patch. Elements join with equal slopes for any number.
    #[test]
    fn biquadratic_numbers_are_exact() {
        let divisions = [3, 2];
        let place = |k: usize, [x, y]: [f64; 2]| [(k % 3) as f64 + x, (k / 3) as f64 + y];
        let number = |[x, y]: [f64; 2]| (1.0 + 0.3 * x - 0.2 * x * x) * (2.0 - 0.4 * y + 0.1 * y * y);
        let nets: Vec<_> = nodal_slopes(divisions, |k, at| number(place(k, at)))
            .iter()
            .map(BicubicNet::from_nodes)
            .collect();
        for (k, net) in nets.iter().enumerate() {
            for at in [[0.0, 0.0], [0.3, 0.8], [1.0, 0.5]] {
                let exact = number(place(k, at));
                assert!((net.value(at) - exact).abs() < 1e-14, "{k} {at:?}: {} {exact}", net.value(at));
            }
        }
        let rough = nodal_slopes(divisions, |k, at| (7.0 * (place(k, at)[0] * place(k, at)[1])).sin());
        let rough: Vec<_> = rough.iter().map(BicubicNet::from_nodes).collect();
        for y in [0.0, 0.4, 1.0] {
            let [before, after] = [rough[0].at([1.0, y]), rough[1].at([0.0, y])];
            assert!((0..3).all(|k| (before[k] - after[k]).abs() < 1e-13), "{before:?} {after:?}");
        }
    }
}
