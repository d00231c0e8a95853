//! CPU time, which is independent of the other load of the machine, and memory.

/// CPU time of this process in seconds, summed over all threads.
///
/// The time of one thread would not include work in the thread pool, even if the pool has one thread only.
#[cfg(unix)]
pub fn own() -> f64 {
    use nix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::CLOCK_PROCESS_CPUTIME_ID)
        .map_or(f64::NAN, |t| t.tv_sec() as f64 + 1e-9 * t.tv_nsec() as f64)
}

/// User and system CPU time of all terminated child processes in seconds.
#[cfg(unix)]
pub fn of_children() -> f64 {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeVal;
    let seconds = |t: TimeVal| t.tv_sec() as f64 + 1e-6 * t.tv_usec() as f64;
    getrusage(UsageWho::RUSAGE_CHILDREN)
        .map_or(f64::NAN, |usage| seconds(usage.user_time()) + seconds(usage.system_time()))
}

/// Maximum resident memory of all terminated child processes in bytes.
#[cfg(unix)]
pub fn memory_of_children() -> f64 {
    use nix::sys::resource::{UsageWho, getrusage};
    getrusage(UsageWho::RUSAGE_CHILDREN).map_or(f64::NAN, |usage| 1024.0 * usage.max_rss() as f64)
}

/// Not available on this system.
#[cfg(not(unix))]
pub fn memory_of_children() -> f64 {
    f64::NAN
}

/// Wall-clock time in seconds, on systems without CPU time.
#[cfg(not(unix))]
pub fn own() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}

/// Wall-clock time in seconds, on systems without CPU time.
#[cfg(not(unix))]
pub fn of_children() -> f64 {
    own()
}
