//! Import and export declarations of TypeScript code.

/// A declaration that names another file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Declaration {
    /// Line, from 1.
    pub(super) line: usize,
    /// Text in quotes.
    pub(super) source: String,
    /// Names in the other file, with the names here. `*` stands for all.
    pub(super) names: Vec<(String, String)>,
    /// True for `export .. from`.
    pub(super) is_export: bool,
}

/// Collects the declarations of a file. The second result is true if the file has nothing else.
pub(super) fn parse(code: &str) -> (Vec<Declaration>, bool) {
    let code = without_comments(code);
    let mut found = Vec::new();
    let mut is_facade = true;
    let mut lines = code.lines().enumerate();
    while let Some((at, line)) = lines.next() {
        let start = line.trim_start();
        let is_import = word(start, "import").is_some_and(|rest| !rest.trim_start().starts_with(['(', '.']));
        let exported = word(start, "export").map(str::trim_start);
        let exported = exported.map(|rest| word(rest, "type").map_or(rest, str::trim_start));
        let is_export = exported.is_some_and(|rest| rest.starts_with(['{', '*']));
        if !is_import && !is_export {
            is_facade &= start.is_empty();
            continue;
        }
        let mut text = start.to_owned();
        while !is_complete(&text)
            && let Some((_, line)) = lines.next()
        {
            text += " ";
            text += line.trim();
        }
        match quoted(&text) {
            Some((clause, source)) => {
                is_facade &= is_export;
                found.push(Declaration { line: at + 1, source, names: names(clause), is_export });
            }
            None => is_facade = false,
        }
    }
    found.extend(dynamic(&code));
    let is_facade = is_facade && !found.is_empty();
    (found, is_facade)
}

/// Strips a word from the start of a text.
fn word<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    text.strip_prefix(word)
        .filter(|rest| !rest.starts_with(|next: char| next.is_alphanumeric() || next == '_'))
}

/// True for a declaration with its last quote, or with a semicolon, or without a source.
fn is_complete(text: &str) -> bool {
    quoted(text).is_some() || text.trim_end().ends_with(';')
}

/// Splits a declaration into the clause before its source and the source.
fn quoted(text: &str) -> Option<(&str, String)> {
    let open = text.find(['"', '\''])?;
    let quote = &text[open..=open];
    let close = text[open + 1..].find(quote)?;
    Some((&text[..open], text[open + 1..open + 1 + close].to_owned()))
}

/// Reads the names of a clause such as `import type A, { b as c } from`.
fn names(clause: &str) -> Vec<(String, String)> {
    let clause = clause.trim().trim_end_matches("from").trim();
    let clause = word(clause, "import").or_else(|| word(clause, "export")).unwrap_or(clause).trim();
    let is_type =
        |rest: &str| rest.trim_start().starts_with(['{', '*']) || !rest.trim_start().starts_with(',');
    let clause = word(clause, "type").filter(|rest| !rest.is_empty() && is_type(rest)).unwrap_or(clause);
    let (outer, inner) = match (clause.find('{'), clause.rfind('}')) {
        (Some(open), Some(close)) => {
            (clause[..open].to_owned() + &clause[close + 1..], &clause[open + 1..close])
        }
        _ => (clause.to_owned(), ""),
    };
    let mut found = Vec::new();
    for name in outer.split(',').map(str::trim).filter(|name| !name.is_empty()) {
        let here = name.strip_prefix('*').map(|rest| rest.trim().trim_start_matches("as").trim());
        found.push(
            here.map_or(("default".to_owned(), name.to_owned()), |here| ("*".to_owned(), here.to_owned())),
        );
    }
    for name in inner.split(',').map(str::trim).filter(|name| !name.is_empty()) {
        let name = word(name, "type").map_or(name, str::trim_start);
        let (there, here) = name.split_once(" as ").unwrap_or((name, name));
        found.push((there.trim().to_owned(), here.trim().to_owned()));
    }
    found
}

/// Collects `import("source")`, also in types.
fn dynamic(code: &str) -> Vec<Declaration> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("import") {
        let is_whole = !code[..at]
            .ends_with(|before: char| before.is_alphanumeric() || ['_', '.', '$'].contains(&before));
        let rest = code[at + "import".len()..].trim_start().strip_prefix('(').map(str::trim_start);
        let is_quoted = |rest: &&str| is_whole && rest.starts_with(['"', '\'']);
        if let Some((_, source)) = rest.filter(is_quoted).and_then(quoted) {
            let line = code[..at].matches('\n').count() + 1;
            found.push(Declaration {
                line,
                source,
                names: vec![("*".into(), String::new())],
                is_export: false,
            });
        }
    }
    found
}

/// Blanks out comments that begin a line or follow a space. Others may be part of a text.
fn without_comments(code: &str) -> String {
    let mut is_open = false;
    let mut lines = Vec::new();
    for line in code.lines() {
        let mut rest = line;
        let mut text = String::new();
        loop {
            if is_open {
                let Some(end) = rest.find("*/") else { break };
                rest = &rest[end + 2..];
                is_open = false;
            }
            let start = ["//", "/*"].iter().filter_map(|mark| {
                rest.match_indices(mark)
                    .map(|(at, _)| at)
                    .find(|&at| rest[..at].is_empty() || rest[..at].ends_with(char::is_whitespace))
            });
            let Some(start) = start.min() else {
                text += rest;
                break;
            };
            text += &rest[..start];
            if rest[start..].starts_with("//") {
                break;
            }
            is_open = true;
            rest = &rest[start + 2..];
        }
        lines.push(text);
    }
    lines.join("\n")
}
