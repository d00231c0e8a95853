/// Number with the smallest number of digits that distinguishes it from other numbers.
pub(crate) fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 || !x.is_finite() || (1e-4..1e7).contains(&size) { x.to_string() } else { format!("{x:e}") }
}

/// Formats a number with at most six digits and without trailing zeros. Small and large numbers have an exponent.
pub fn short(x: f64) -> String {
    let plain = x == 0.0 || (1e-4..1e9).contains(&x.abs());
    let rounded = format!("{x:.5e}").parse::<f64>();
    rounded.map_or_else(|_| x.to_string(), |x| if plain { x.to_string() } else { format!("{x:e}") })
}

/// Formats a relative number as a percentage of two digits. Sizes below 1e-6 % are not distinguished.
pub fn percentage(x: f64) -> String {
    let percent = 100.0 * x;
    let size = format!("{:.1e}", percent.abs()).parse().unwrap_or(percent.abs());
    let size = if size < 1e-6 { "1e-6".to_owned() } else { short(size) };
    let sign = if x < 0.0 { "-" } else { "" };
    format!("{sign}{size} %")
}

/// Text in quotes, shortened to 40 characters.
pub(crate) fn quoted(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{:?}", format!("{}…", &text[..end])),
        None => format!("{text:?}"),
    }
}

/// List such as `a, b or c`.
pub(crate) fn listed(words: impl IntoIterator<Item = String>, last: &str) -> String {
    let mut words: Vec<_> = words.into_iter().collect();
    match words.pop() {
        Some(end) if !words.is_empty() => format!("{} {last} {end}", words.join(", ")),
        end => end.unwrap_or_default(),
    }
}

/// Words of other programs, and the words for the same thing in models.
const SYNONYMS: [(&str, &str); 51] = [
    ("b", "width"),
    ("ball", "spherical"),
    ("c", "damping"),
    ("com", "center"),
    ("d", "diameter"),
    ("dt", "step"),
    ("e", "young"),
    ("e_modulus", "young"),
    ("eigen", "modes"),
    ("elastic_modulus", "young"),
    ("elasticity", "young"),
    ("end", "to"),
    ("fixed", "clamp"),
    ("frequencies", "modes"),
    ("g", "gravity"),
    ("h", "height"),
    ("hinge", "revolute"),
    ("k", "stiffness"),
    ("l", "length"),
    ("l", "to"),
    ("length", "to"),
    ("m", "mass"),
    ("modal", "modes"),
    ("modulus", "young"),
    ("mu", "friction"),
    ("n", "elements"),
    ("n_elements", "elements"),
    ("nel", "elements"),
    ("nu", "poisson"),
    ("omega", "spin"),
    ("p1", "from"),
    ("p2", "to"),
    ("pin", "revolute"),
    ("poisson_ratio", "poisson"),
    ("poissons_ratio", "poisson"),
    ("pos", "center"),
    ("position", "center"),
    ("r", "diameter"),
    ("r", "radius"),
    ("radius", "diameter"),
    ("rho", "density"),
    ("slider", "prismatic"),
    ("start", "from"),
    ("t", "time"),
    ("t_end", "duration"),
    ("time_step", "step"),
    ("transient", "dynamics"),
    ("translational", "prismatic"),
    ("w", "width"),
    ("weld", "clamp"),
    ("youngs_modulus", "young"),
];

/// Candidate with the meaning of a word of other programs.
fn synonym<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let meanings = SYNONYMS.iter().filter(|(other, _)| other.eq_ignore_ascii_case(word));
    meanings
        .into_iter()
        .find_map(|(_, meant)| candidates.iter().copied().find(|candidate| candidate == meant))
}

/// Candidate that a word means: one with the same meaning in other programs, or the nearest one to a misspelt word, if at most a
/// third of the letters differ.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let candidates: Vec<&str> = candidates.into_iter().collect();
    if let Some(meant) = synonym(word, &candidates) {
        return Some(meant);
    }
    let word = word.to_lowercase();
    let distance = |candidate: &str| strsim::damerau_levenshtein(&word, &candidate.to_lowercase());
    let near = candidates.into_iter().map(|candidate| (distance(candidate), candidate));
    let (distance, candidate) = near.min_by_key(|(distance, _)| *distance)?;
    let (length, own) = (word.chars().count(), candidate.chars().count());
    (distance < own && distance <= 1.max(length.max(own) / 3)).then_some(candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn words_of_other_programs_are_known() {
        let joints = ["clamp", "revolute", "slide", "prismatic"];
        for (word, meant) in
            [("fixed", "clamp"), ("Hinge", "revolute"), ("slider", "prismatic"), ("clmp", "clamp")]
        {
            assert_eq!(nearest(word, joints), Some(meant));
        }
        assert_eq!(nearest("nu", ["young", "poisson"]), Some("poisson"));
        assert_eq!(nearest("radius", ["height"]), None);
        assert_eq!(nearest("L", ["from", "to", "elements"]), Some("to"));
        assert_eq!(nearest("L", ["length", "to"]), Some("length"));
    }
}
