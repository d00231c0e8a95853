//! Time of the processor: what a computation costs, whatever else the machine does meanwhile.

/// Seconds that this process has had a processor, all threads together.
///
/// It is the process, not the thread: work may be done by threads of a pool, even if that has one thread only.
#[cfg(unix)]
pub fn own() -> f64 {
    use nix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::CLOCK_PROCESS_CPUTIME_ID)
        .map_or(f64::NAN, |t| t.tv_sec() as f64 + 1e-9 * t.tv_nsec() as f64)
}

/// Seconds that children which have ended had a processor, with what the system did for them.
#[cfg(unix)]
pub fn of_children() -> f64 {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeVal;
    let seconds = |t: TimeVal| t.tv_sec() as f64 + 1e-6 * t.tv_usec() as f64;
    getrusage(UsageWho::RUSAGE_CHILDREN)
        .map_or(f64::NAN, |usage| seconds(usage.user_time()) + seconds(usage.system_time()))
}

/// Seconds on the wall, where nothing tells the time of the processor.
#[cfg(not(unix))]
pub fn own() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}

/// Seconds on the wall, where nothing tells the time of the processor.
#[cfg(not(unix))]
pub fn of_children() -> f64 {
    own()
}
