//! Messages about omitted frames and stations.

/// Formats a count with its noun.
fn count(number: usize, one: &str, several: &str) -> String {
    if number == 1 { format!("1 {one}") } else { format!("{number} {several}") }
}

/// Message about omitted frames.
pub(super) fn thinned(shown: usize, all: usize) -> String {
    format!("{shown} of {} are shown, evenly spaced, to limit the file size", count(all, "frame", "frames"))
}

/// Message about omitted stations.
pub(super) fn coarse(parts: u32) -> String {
    let segments = count(parts as usize, "straight segment", "straight segments");
    format!("each element is drawn as {segments}, to limit the file size")
}

/// Message about frames that cannot be drawn.
pub(super) fn not_finite(number: usize) -> String {
    format!("{} omitted: not all positions are finite", count(number, "frame", "frames"))
}

/// Message about frames of another model.
pub(super) fn unfit(number: usize) -> String {
    format!("{} omitted: states of another model", count(number, "frame", "frames"))
}

/// Message of a scene without recorded states.
pub(super) const EMPTY: &str = "no recorded states: the undeformed state is shown";
