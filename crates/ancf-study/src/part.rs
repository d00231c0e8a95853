//! Division of a study into parts for job arrays.

use std::str::FromStr;

/// Part `k` of `n`, `k` from 1: every n-th case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StudyPart {
    k: usize,
    n: usize,
}

impl FromStr for StudyPart {
    type Err = String;

    /// Reads `K/N`.
    fn from_str(text: &str) -> Result<Self, String> {
        let parts =
            text.split_once('/').and_then(|(k, n)| Some((k.trim().parse().ok()?, n.trim().parse().ok()?)));
        match parts {
            Some((k, n)) if 1 <= k && k <= n => Ok(Self { k, n }),
            _ => Err("expected K/N with K from 1 to N, such as 3/10".into()),
        }
    }
}

impl StudyPart {
    /// All cases.
    pub const ALL: Self = Self { k: 1, n: 1 };

    /// Returns the name of the results file. Every division has its own names.
    pub fn file_name(self) -> String {
        format!("cases-{}-of-{}.parquet", self.k, self.n)
    }

    /// Returns the cases of this part.
    pub fn cases(self, count: usize) -> Vec<usize> {
        (self.k - 1..count).step_by(self.n).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_disjoint_and_complete() {
        let part = |text: &str| text.parse::<StudyPart>().unwrap();
        assert_eq!(part("1/2").cases(5), [0, 2, 4]);
        assert_eq!(part(" 2 / 2").cases(5), [1, 3]);
        assert_eq!(part("2/3").file_name(), "cases-2-of-3.parquet");
        for wrong in ["0/2", "3/2", "2", "a/b"] {
            assert!(wrong.parse::<StudyPart>().is_err(), "{wrong}");
        }
    }
}
