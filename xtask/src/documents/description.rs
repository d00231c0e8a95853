//! Parts of the description of a key: default value and meaning.

/// Words of the units in descriptions, such as `force length/time²`.
const UNITS: [&str; 12] =
    ["length", "time", "force", "mass", "area", "volume", "1", "radian", "radians", "cycle", "cycles", "in"];

/// Description of a key, split into meaning and default value.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Description {
    /// Text without unit and default value.
    pub(super) meaning: String,
    /// Default value in words.
    pub(super) default: Option<String>,
}

impl Description {
    /// Splits a description. Units between commas or semicolons are removed, since they have a column of their own.
    pub(super) fn of(text: &str) -> Self {
        let mut description = Self::default();
        let mut meanings: Vec<String> = Vec::new();
        for sentence in sentences(&text.split_whitespace().collect::<Vec<_>>().join(" ")) {
            if let Some(default) = sentence.strip_prefix("By default ") {
                description.default = Some(default.trim_start_matches("it ").to_owned());
            } else {
                let is_first = meanings.is_empty();
                meanings.push(description.meaning_of(sentence, is_first));
            }
        }
        meanings.retain(|sentence| !sentence.is_empty());
        description.meaning = meanings.join(". ");
        description
    }

    /// Meaning of one sentence. A part such as `; 1 by default` becomes the default value.
    fn meaning_of(&mut self, sentence: &str, is_first: bool) -> String {
        let parts: Vec<&str> = sentence.split("; ").collect();
        let mut kept = Vec::new();
        for (i, part) in parts.iter().enumerate() {
            match part.strip_suffix(" by default").or_else(|| part.strip_prefix("by default ")) {
                Some(default) if i > 0 || !is_first => {
                    self.default = Some(lower_case(default.trim_end_matches(',')));
                }
                _ => kept.push(without_units(part)),
            }
        }
        kept.retain(|part| !part.is_empty());
        kept.join("; ")
    }
}

/// Splits a text into sentences without full stops. A full stop before other signs than a capital does not end a sentence.
fn sentences(text: &str) -> Vec<&str> {
    let mut sentences = Vec::new();
    let mut start = 0;
    for (at, _) in text.match_indices(". ") {
        if text[at + 2..].starts_with(char::is_uppercase) {
            sentences.push(&text[start..at]);
            start = at + 2;
        }
    }
    sentences.push(text[start..].trim_end_matches('.'));
    sentences
}

fn lower_case(text: &str) -> String {
    let mut letters = text.chars();
    letters
        .next()
        .map(|letter| letter.to_lowercase().collect::<String>() + letters.as_str())
        .unwrap_or_default()
}

fn without_units(text: &str) -> String {
    let parts: Vec<&str> = text.split(", ").collect();
    let (first, rest) = parts.split_first().unwrap_or((&"", &[]));
    let rest = rest.iter().filter(|part| !is_unit(part));
    let first = if is_unit(first) { None } else { Some(first) };
    first.into_iter().chain(rest).copied().collect::<Vec<_>>().join(", ")
}

fn is_unit(text: &str) -> bool {
    let words = || text.split([' ', '/']).map(|word| word.trim_end_matches(['²', '³', '⁴']));
    words().all(|word| UNITS.contains(&word)) && words().any(|word| word != "1" && word != "in")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn description(text: &str) -> (String, String) {
        let Description { meaning, default } = Description::of(text);
        (meaning, default.unwrap_or_default())
    }

    #[test]
    fn units_and_defaults_are_separated_from_the_meaning() {
        for (text, meaning, default) in [
            ("Young's modulus E, force/area.", "Young's modulus E", ""),
            ("Torsion constant, length⁴; iy + iz by default.", "Torsion constant", "iy + iz"),
            (
                "Angle, in radians. The function of time multiplies it.",
                "Angle. The function of time multiplies it",
                "",
            ),
            (
                "Length at zero force, length. By default the distance.",
                "Length at zero force",
                "the distance",
            ),
            ("Poisson's ratio ν, −1 < ν < 0.5; 0 by default.", "Poisson's ratio ν, −1 < ν < 0.5", "0"),
            ("Unit of length, length.", "Unit of length", ""),
            ("True to close gaps. Gaps are errors by default.", "True to close gaps", "gaps are errors"),
            ("Unit of time. By default it follows from eq. (7).", "Unit of time", "follows from eq. (7)"),
        ] {
            assert_eq!(description(text), (meaning.to_owned(), default.to_owned()));
        }
    }
}
