//! Von Mises truss in closed form.

use ancf::solver::equations::{Energy, Local, LocalMatrix, System, Term, Weights};

/// Shallow von Mises truss: two bars from (±a, 0) to the apex (0, h), loaded through a spring.
///
/// ```text
///            P = load × `push`
///            v
///            <  spring, downward displacement q[2] of its upper end
///            o  apex (q[0], h − q[1])
///        /       \
///     /             \
///   ^                 ^
/// ```
///
/// Green strain ε = (l² − L²)/2L² and energy ½ EA L ε² of each bar give P = EA (h² − z²) z / L³ at the height z. Limit
/// points are at z = ±h/√3. Unit mass at each point.
pub(super) struct Truss {
    /// Half the span a.
    pub(super) a: f64,
    /// Height h.
    pub(super) h: f64,
    /// EA of the bars.
    pub(super) stiffness: f64,
    /// Stiffness of the spring.
    pub(super) spring: f64,
    /// P at load factor one.
    pub(super) push: f64,
}

impl Truss {
    /// System with the truss only.
    pub(super) fn system(self) -> System {
        System::new(3, 0, vec![Box::new(self)])
    }

    /// L³ of a bar.
    fn cube(&self) -> f64 {
        self.a.hypot(self.h).powi(3)
    }

    /// P at a height z of the apex.
    pub(super) fn load(&self, z: f64) -> f64 {
        self.stiffness * (self.h * self.h - z * z) * z / self.cube()
    }

    /// Vectors from the supports to the apex.
    fn bars(&self, q: &[f64]) -> [[f64; 2]; 2] {
        [[self.a + q[0], self.h - q[1]], [q[0] - self.a, self.h - q[1]]]
    }

    /// l² − L² of a bar.
    fn extension(&self, [x, z]: [f64; 2]) -> f64 {
        x * x + z * z - self.a * self.a - self.h * self.h
    }
}

impl Term for Truss {
    fn coordinates(&self) -> &[usize] {
        &[0, 1, 2]
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        for bar in self.bars(at.q) {
            let n = 0.5 * self.stiffness / self.cube() * self.extension(bar);
            r[0] += n * bar[0];
            r[1] -= n * bar[1];
        }
        let force = self.spring * (at.q[2] - at.q[1]);
        r[1] -= force;
        r[2] += force - at.load * self.push;
        r.iter_mut().zip(at.a).for_each(|(r, a)| *r += a);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        for bar in self.bars(at.q) {
            let size = self.stiffness / self.cube() * (self.a * self.a + self.h * self.h);
            floor[0] += f64::EPSILON * size * bar[0].abs();
            floor[1] += f64::EPSILON * size * bar[1].abs();
        }
        let force = self.spring * (at.q[2].abs() + at.q[1].abs());
        floor[1] += f64::EPSILON * force;
        floor[2] += f64::EPSILON * (force + (at.load * self.push).abs());
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        for bar in self.bars(at.q) {
            let c = w.q * self.stiffness / self.cube();
            let direction = [bar[0], -bar[1]];
            for i in 0..2 {
                k.add(i, i, 0.5 * c * self.extension(bar));
                for j in 0..=i {
                    k.add(i, j, c * direction[i] * direction[j]);
                }
            }
        }
        k.add(1, 1, w.q * self.spring);
        k.add(2, 2, w.q * self.spring);
        k.add(2, 1, -w.q * self.spring);
        for i in 0..3 {
            k.add(i, i, w.a);
        }
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let square = self.a * self.a + self.h * self.h;
        let bars = self.bars(at.q).map(|bar| self.extension(bar).powi(2)).iter().sum::<f64>();
        let strain = bars * self.stiffness * square.sqrt() / (8.0 * square * square)
            + 0.5 * self.spring * (at.q[2] - at.q[1]).powi(2);
        Energy { strain, potential: -at.load * self.push * at.q[2], ..Energy::default() }
    }
}
