/// Conjugate residuals for K x = b with approximate solutions z of K z = r: each step minimises the norm of r = b − K x over the direction
/// of z and the last direction.
///
/// Without the last direction the residual decreases at a fixed rate, which is close to one if z is poor in some directions. A part of b
/// outside of the range of K remains in r and has no effect on the other parts.
///
/// Source: Stiefel (1955); Vinsome (1976).
#[derive(Debug, Default)]
pub(super) struct ConjugateResiduals {
    /// Last direction p and its image K p.
    direction: Vec<f64>,
    image: Vec<f64>,
    /// Squared norm of the image; zero before the first step.
    square: f64,
}

impl ConjugateResiduals {
    /// Forgets the last direction.
    pub(super) fn restart(&mut self) {
        self.square = 0.0;
    }

    /// Updates x by a step along `z` with the image `product` = K z, from the residual r. Norms are those of r scaled by `d`.
    pub(super) fn step(&mut self, [z, product]: [&[f64]; 2], d: &[f64], r: &[f64], x: &mut [f64]) {
        let dot = |a: &[f64], b: &[f64]| -> f64 {
            a.iter().zip(b).zip(d).map(|((a, b), d)| (a * d) * (b * d)).sum()
        };
        if self.square > 0.0 {
            let share = -dot(product, &self.image) / self.square;
            let follow = |own: &mut [f64], new: &[f64]| {
                own.iter_mut().zip(new).for_each(|(own, new)| *own = new + share * *own);
            };
            follow(&mut self.direction, z);
            follow(&mut self.image, product);
        } else {
            self.direction.clear();
            self.direction.extend_from_slice(z);
            self.image.clear();
            self.image.extend_from_slice(product);
        }
        self.square = dot(&self.image, &self.image);
        if self.square > 0.0 {
            let length = dot(r, &self.image) / self.square;
            x.iter_mut().zip(&self.direction).for_each(|(x, p)| *x += length * p);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Five eigenvalues are solved in five steps; a contradictory part remains.
    #[test]
    fn steps_are_as_many_as_eigenvalues() {
        let eigenvalues = [1.0, 0.5, 0.1, 1e-2, 1e-3, 0.0];
        let product = |x: &[f64]| -> Vec<f64> { x.iter().zip(&eigenvalues).map(|(x, e)| x * e).collect() };
        for contradiction in [0.0, 0.3] {
            let b = [0.3, -0.2, 0.5, 1.0, -0.7, contradiction];
            let (mut x, mut r, mut steps) = ([0.0; 6], b, ConjugateResiduals::default());
            for _ in 0..5 {
                let z = r;
                steps.step([&z, &product(&z)], &[1.0; 6], &r, &mut x);
                let image = product(&x);
                r = std::array::from_fn(|i| b[i] - image[i]);
            }
            for (i, r) in r.iter().enumerate().take(5) {
                assert!(r.abs() < 1e-8, "{i}: {r}");
            }
            assert!((r[5] - contradiction).abs() < 1e-15);
        }
    }
}
