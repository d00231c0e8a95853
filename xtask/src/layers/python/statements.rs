//! Logical lines of Python code.

/// A simple statement or the head of a compound one. Strings are empty, comments are left out.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Statement {
    /// First line, from 1.
    pub(super) line: usize,
    pub(super) text: String,
}

/// Splits code into statements. Brackets and backslashes continue a line.
pub(super) fn split(code: &str) -> Vec<Statement> {
    let mut reader =
        Reader { code: code.chars().collect(), at: 0, line: 1, depth: 0, start: 1, text: String::new() };
    let mut found = Vec::new();
    while let Some(sign) = reader.next() {
        match sign {
            '#' => {
                while reader.peek(0).is_some_and(|next| next != '\n') {
                    reader.next();
                }
            }
            '"' | '\'' => reader.string(sign),
            '\\' if reader.peek(0) == Some('\n') => {
                reader.next();
                reader.push(' ');
            }
            '\n' | ';' if reader.depth == 0 => found.extend(reader.end()),
            '\n' => reader.push(' '),
            '(' | '[' | '{' => {
                reader.depth += 1;
                reader.push(sign);
            }
            ')' | ']' | '}' => {
                reader.depth = reader.depth.saturating_sub(1);
                reader.push(sign);
            }
            _ => reader.push(sign),
        }
    }
    found.extend(reader.end());
    found
}

struct Reader {
    code: Vec<char>,
    at: usize,
    line: usize,
    /// Open brackets.
    depth: usize,
    /// First line of the statement.
    start: usize,
    text: String,
}

impl Reader {
    fn peek(&self, ahead: usize) -> Option<char> {
        self.code.get(self.at + ahead).copied()
    }

    fn next(&mut self) -> Option<char> {
        let sign = self.peek(0)?;
        self.at += 1;
        self.line += usize::from(sign == '\n');
        Some(sign)
    }

    fn push(&mut self, sign: char) {
        if self.text.trim().is_empty() && !sign.is_whitespace() {
            self.start = self.line;
        }
        self.text.push(sign);
    }

    /// Passes a string whose first quote has been read.
    fn string(&mut self, quote: char) {
        self.push('"');
        self.push('"');
        let is_triple = self.peek(0) == Some(quote) && self.peek(1) == Some(quote);
        if is_triple {
            self.at += 2;
        }
        while let Some(sign) = self.next() {
            if sign == '\\' {
                self.next();
            } else if !is_triple && (sign == quote || sign == '\n') {
                return;
            } else if is_triple && sign == quote && self.peek(0) == Some(quote) && self.peek(1) == Some(quote)
            {
                self.at += 2;
                return;
            }
        }
    }

    fn end(&mut self) -> Option<Statement> {
        let text = std::mem::take(&mut self.text);
        (!text.trim().is_empty()).then(|| Statement { line: self.start, text: text.trim_end().to_owned() })
    }
}
