use std::fs;
use std::hint::black_box;
use std::process::Command;

use pulp::{Arch, Simd, WithSimd};
use serde::{Deserialize, Serialize};

use super::clock;

/// Machine with the measured peak performance of one core.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Machine {
    /// Name of the processor.
    pub processor: String,
    /// Number of cores available to the program.
    pub cores: usize,
    /// Compiler of this program.
    pub compiler: String,
    /// Floating-point operations per second: fused multiply-add with the widest vectors.
    pub flops: f64,
    /// Bytes per second between memory and registers.
    pub bytes: f64,
    /// Bytes per second between second-level cache and registers.
    pub cached: f64,
}

impl Machine {
    /// Measures this machine.
    pub fn this() -> Self {
        let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let name = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
        Self {
            processor: name.map_or("unknown processor", |(_, name)| name).to_owned(),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            compiler: compiler(),
            flops: maximum(5, flops),
            bytes: maximum(5, bytes),
            cached: maximum(5, cached),
        }
    }
}

/// Version of the compiler: the first two words of `rustc --version`.
pub fn compiler() -> String {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(rustc).arg("--version").output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    text.split_whitespace().take(2).collect::<Vec<_>>().join(" ")
}

fn maximum(times: usize, measure: impl Fn() -> f64) -> f64 {
    (0..times).map(|_| measure()).fold(0.0, f64::max)
}

/// Independent chains of fused multiply-adds, enough to hide their latency.
struct Chains(usize);

/// Number of chains.
const CHAINS: usize = 12;

impl WithSimd for Chains {
    type Output = (f64, usize);

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let (factor, term) = (simd.splat_f64s(black_box(1.0 - 1e-9)), simd.splat_f64s(black_box(1e-9)));
        let mut sums = [simd.splat_f64s(1.0); CHAINS];
        for _ in 0..self.0 {
            for sum in &mut sums {
                *sum = simd.mul_add_f64s(*sum, factor, term);
            }
        }
        let lanes = size_of::<S::f64s>() / size_of::<f64>();
        (sums.iter().map(|&sum| simd.reduce_sum_f64s(sum)).sum(), lanes)
    }
}

/// Measures floating-point operations per second.
fn flops() -> f64 {
    const TIMES: usize = 4_000_000;
    let start = clock::own();
    let (sum, lanes) = Arch::new().dispatch(Chains(TIMES));
    black_box(sum);
    (2 * lanes * CHAINS * TIMES) as f64 / (clock::own() - start)
}

/// Vector triad a = b + x c.
struct Triad<'a> {
    a: &'a mut [f64],
    b: &'a [f64],
    c: &'a [f64],
}

impl WithSimd for Triad<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let x = simd.splat_f64s(black_box(3.0));
        let ((a, _), (b, _), (c, _)) =
            (S::as_mut_simd_f64s(self.a), S::as_simd_f64s(self.b), S::as_simd_f64s(self.c));
        for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
            *a = simd.mul_add_f64s(x, *c, *b);
        }
    }
}

/// Measures triads of vectors of a length per second.
fn triads(length: usize, times: usize) -> f64 {
    let (mut a, b, c) = (vec![1.0; length], vec![2.0; length], vec![3.0; length]);
    let mut run = || {
        let start = clock::own();
        for _ in 0..times {
            Arch::new().dispatch(Triad { a: &mut a, b: &b, c: &c });
            black_box(&a);
        }
        times as f64 / (clock::own() - start)
    };
    run();
    run().max(run())
}

/// Measures bytes per second from memory: two numbers read, one read by the cache before it is written, one written
/// (McCalpin 1995).
fn bytes() -> f64 {
    const LENGTH: usize = 8 << 20;
    (4 * 8 * LENGTH) as f64 * triads(LENGTH, 1)
}

/// Measures bytes per second from the cache: two numbers read, one written.
fn cached() -> f64 {
    const LENGTH: usize = 10_000;
    (3 * 8 * LENGTH) as f64 * triads(LENGTH, 1000)
}
