//! What the viewer says about what it was not given.

/// A number of things with their word.
pub(crate) fn count(number: usize, one: &str, several: &str) -> String {
    if number == 1 { format!("1 {one}") } else { format!("{number} {several}") }
}

/// That not all frames are shown.
pub(crate) fn thinned(shown: usize, all: usize) -> String {
    format!("{shown} of {} are shown, evenly spaced, to keep the file small", count(all, "frame", "frames"))
}

/// That fewer stations are shown than there should be.
pub(crate) fn coarse(parts: u32) -> String {
    let lines = count(parts as usize, "straight piece", "straight pieces");
    format!("each element is drawn by {lines}, to keep the file small")
}

/// That frames could not be drawn.
pub(crate) fn not_finite(number: usize) -> String {
    format!("{} left out: not all positions are numbers", count(number, "frame", "frames"))
}

/// That frames are those of another model.
pub(crate) fn unfit(number: usize) -> String {
    format!("{} left out: of another model", count(number, "frame", "frames"))
}

/// That there is nothing but the model.
pub(crate) const EMPTY: &str = "no states were recorded yet: the undeformed state is shown";
