//! Paths in token streams, for macros whose contents are no expressions.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A path or a method call in a token stream.
#[derive(Debug)]
pub(super) struct TokenPath {
    pub(super) segments: Vec<String>,
    /// Line, from 1.
    pub(super) line: usize,
    /// True if parentheses follow.
    pub(super) is_call: bool,
    /// True after a dot.
    pub(super) is_member: bool,
}

/// Collects the paths of a token stream and of its groups.
pub(super) fn paths(tokens: &TokenStream) -> Vec<TokenPath> {
    let mut found = Vec::new();
    scan(tokens, &mut found);
    found
}

fn scan(tokens: &TokenStream, found: &mut Vec<TokenPath>) {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            TokenTree::Group(group) => scan(&group.stream(), found),
            TokenTree::Ident(first) => {
                let before = at.checked_sub(1).map(|before| &tokens[before]);
                let line = first.span().start().line;
                let mut segments = vec![first.to_string()];
                while is_separator(&tokens[at + 1..])
                    && let Some(TokenTree::Ident(next)) = tokens.get(at + 3)
                {
                    segments.push(next.to_string());
                    at += 3;
                }
                let is_call = matches!(
                    tokens.get(at + 1),
                    Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis
                );
                // Fragments `$name` of a macro are no paths, but `$crate` begins one.
                let is_fragment = before.is_some_and(|token| is_punct(token, '$')) && segments[0] != "crate";
                if !is_fragment {
                    let is_member = before.is_some_and(|token| is_punct(token, '.'));
                    found.push(TokenPath { segments, line, is_call, is_member });
                }
            }
            _ => {}
        }
        at += 1;
    }
}

fn is_separator(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [first, second, ..] if is_punct(first, ':') && is_punct(second, ':'))
}

fn is_punct(token: &TokenTree, sign: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == sign)
}
