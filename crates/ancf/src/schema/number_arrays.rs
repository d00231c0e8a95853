//! Long arrays of numbers in a TOML text, which are parsed without the tokens and positions of the TOML parser.

use std::ops::Range;

use toml::Value;

/// Number of bytes above which an array is long.
const LONG: usize = 10_000;
/// Start of the text that stands for a long array.
const MARK: &str = "@long-array-of-numbers:";

/// Text in which long arrays of numbers are replaced by marks.
#[derive(Debug)]
pub(super) struct NumberArrays<'a> {
    text: &'a str,
    /// Text with marks.
    pub(super) marked: String,
    /// Contents of the arrays, by the numbers of their marks.
    contents: Vec<Range<usize>>,
}

impl<'a> NumberArrays<'a> {
    /// Finds the long arrays of a text; `None` without any.
    pub(super) fn of(text: &'a str) -> Option<Self> {
        if text.len() < LONG || text.contains(MARK) {
            return None;
        }
        let (bytes, mut contents, mut at) = (text.as_bytes(), Vec::new(), 0);
        while at < bytes.len() {
            match bytes[at] {
                b'#' => at += bytes[at..].iter().position(|&byte| byte == b'\n').unwrap_or(bytes.len() - at),
                b'"' | b'\'' => at = end_of_text(bytes, at),
                b'[' => {
                    let start = at + 1;
                    let is_part = |byte: &u8| {
                        matches!(
                            byte,
                            b'0'..=b'9'
                                | b'+'
                                | b'-'
                                | b'.'
                                | b'e'
                                | b'E'
                                | b','
                                | b' '
                                | b'\t'
                                | b'\r'
                                | b'\n'
                        )
                    };
                    at = start
                        + bytes[start..]
                            .iter()
                            .position(|byte| !is_part(byte))
                            .unwrap_or(bytes.len() - start);
                    if bytes.get(at) == Some(&b']') && at - start >= LONG && are_numbers(&text[start..at]) {
                        contents.push(start..at);
                    }
                }
                _ => at += 1,
            }
        }
        if contents.is_empty() {
            return None;
        }
        let (mut marked, mut end) = (String::new(), 0);
        for (number, array) in contents.iter().enumerate() {
            marked.push_str(&text[end..array.start]);
            marked.push_str(&format!("'{MARK}{number}'"));
            end = array.end;
        }
        marked.push_str(&text[end..]);
        Some(Self { text, marked, contents })
    }

    /// Returns the numbers of the array for which a text stands.
    pub(super) fn numbers(&self, mark: &str) -> Option<Vec<Value>> {
        let array = self.contents.get(mark.strip_prefix(MARK)?.parse::<usize>().ok()?)?;
        let text = &self.text[array.clone()];
        let mut numbers = Vec::with_capacity(text.bytes().filter(|&byte| byte == b',').count() + 1);
        numbers.extend(tokens(text).map(value));
        Some(numbers)
    }
}

/// End of a text in quotes.
fn end_of_text(bytes: &[u8], start: usize) -> usize {
    let quote = bytes[start];
    let is_long = bytes[start..].starts_with(&[quote; 3]);
    let width = if is_long { 3 } else { 1 };
    let mut at = start + width;
    while at < bytes.len() {
        match bytes[at] {
            b'\\' if quote == b'"' => at += 2,
            byte if byte == quote && bytes[at..].starts_with(&[quote; 3][..width]) => return at + width,
            b'\n' if !is_long => return at,
            _ => at += 1,
        }
    }
    bytes.len()
}

/// Numbers of an array. The last comma may be followed by nothing.
fn tokens(text: &str) -> impl Iterator<Item = &str> {
    let text = text.trim_ascii();
    text.strip_suffix(',').unwrap_or(text).split(',').map(str::trim_ascii)
}

fn are_numbers(text: &str) -> bool {
    text.contains(',') && tokens(text).all(is_number)
}

/// True for a decimal number of TOML without underscores.
fn is_number(token: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let unsigned = |text: &'_ str| text.strip_prefix(['+', '-']).unwrap_or(text).len();
    let (mantissa, exponent) = token.split_once(['e', 'E']).map_or((token, None), |(a, b)| (a, Some(b)));
    let mantissa = &mantissa[mantissa.len() - unsigned(mantissa)..];
    let (whole, fraction) = mantissa.split_once('.').map_or((mantissa, None), |(a, b)| (a, Some(b)));
    let is_exponent = |text: &str| digits(&text[text.len() - unsigned(text)..]);
    digits(whole)
        && (whole.len() == 1 || !whole.starts_with('0'))
        && fraction.is_none_or(digits)
        && exponent.is_none_or(is_exponent)
}

/// Value of a number. Integers of more than 64 bits become numbers with a decimal point.
fn value(token: &str) -> Value {
    let float = || Value::Float(token.parse().unwrap_or(f64::NAN));
    if token.contains(['.', 'e', 'E']) {
        float()
    } else {
        token.parse().map_or_else(|_| float(), Value::Integer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn long(numbers: &[&str]) -> String {
        let count = LONG / numbers.iter().map(|number| number.len() + 2).sum::<usize>() + 1;
        numbers.repeat(count).join(",\n ")
    }

    /// Marked arrays have the values of the TOML parser.
    #[test]
    fn numbers_equal_those_of_the_parser() {
        let numbers = ["0", "-1", "+2.5", "1e3", "-0.5E-7", "12345678901234567890", "6.02e+23", "0.0"];
        let text = format!(
            "# [1,\nname = 'a [3, \"'\nb = \"\"\"\n[4, \\\"\"\"\"\nx = [ {}, ]\ny = [1, 2]",
            long(&numbers)
        );
        let found = NumberArrays::of(&text).unwrap();
        assert_eq!(found.contents.len(), 1);
        let marked: toml::Table = found.marked.parse().unwrap();
        assert_eq!(marked["name"].as_str(), Some("a [3, \""));
        let mark = marked["x"].as_array().unwrap()[0].as_str().unwrap();
        let numbers = found.numbers(mark).unwrap();
        let whole: toml::Table =
            text.replace("12345678901234567890", "1.2345678901234567e19").parse().unwrap();
        assert_eq!(Value::Array(numbers), whole["x"]);
    }

    /// Anything else is left to the TOML parser.
    #[test]
    fn other_arrays_are_not_marked() {
        for wrong in
            ["01", "1.", ".5", "1e", "--1", "1 2", "", "1_0", "0x1", "nan", "1.5.2", "1e2e3", "# 1\n1"]
        {
            let text = format!("x = [{}]", long(&["1", wrong, "2"]));
            assert!(NumberArrays::of(&text).is_none(), "{wrong}");
        }
        assert!(NumberArrays::of(&format!("x = '{}'", long(&["1", "2"]))).is_none());
        assert!(NumberArrays::of(&format!("x = [{}", long(&["1", "2"]))).is_none());
    }
}
