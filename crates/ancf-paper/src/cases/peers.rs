//! Times of other programs for the cantilever of the paper: 2 s, steps of 1 ms, processor time, one thread, no files.
//!
//! They are not measured by this report. EXUDYN was measured by `cargo xtask peers` on the machine named below, Chrono manually
//! on a similar one (`docs/performance.md`).

/// Project Chrono with its 24-coordinate beam (`ChElementBeamANCF_3243`), HHT with α = 0, in s, if measured. The order is that of
/// [`ELEMENTS`](super::models::ELEMENTS).
pub const CHRONO: [Option<f64>; 6] = [Some(0.062), None, Some(0.321), None, None, Some(1.348)];
/// EXUDYN with its 12-coordinate cable (`ObjectANCFCable`), Newmark's scheme with β = 0.36 and γ = 0.70, modified Newton method
/// with the relative tolerance 1e-5 of the residual, s.
pub const EXUDYN: [f64; 6] = [0.0116, 0.0175, 0.0312, 0.0548, 0.0781, 0.106];
/// Version and machine of Chrono.
pub const CHRONO_CONDITIONS: &str =
    "Project Chrono 10.0-dev (-O3 -march=native), on a 2-core AMD EPYC virtual machine at 2.6 GHz";
/// Version and machine of EXUDYN.
pub const EXUDYN_CONDITIONS: &str =
    "EXUDYN 1.13.6 from PyPI, on a 2-core AMD EPYC virtual machine at 2.6 GHz";
