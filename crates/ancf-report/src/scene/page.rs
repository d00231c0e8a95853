use std::io::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use serde_json::Value;

use super::container::header;

/// Script of the viewer, built from `viewer/`.
const SCRIPT: &str = include_str!("../../assets/viewer.js");
const STYLE: &str = include_str!("../../assets/viewer.css");

/// Content security policy of a report: own scripts and generated images, no network.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
                      img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'";
/// Content security policy of a live page, which requests scenes from its own server.
const LIVE_POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
                           img-src data: blob:; font-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'";

/// Returns a self-contained HTML page with the viewer and a scene. The page loads no other resources.
pub fn page(container: &[u8]) -> String {
    let header = header(container).unwrap_or_default();
    let title = header["title"].as_str().filter(|title| !title.is_empty()).unwrap_or("ancf");
    let data = STANDARD.encode(gzipped(container));
    let scene = html! { script type="application/octet-stream" id="scene" { (PreEscaped(data)) } };
    document(title, POLICY, &scene, &summary(&header))
}

/// Returns the page of [`Server`](crate::Server), which requests its scene at `/scene`.
pub fn live_page() -> String {
    let scene = html! { script type="application/octet-stream" id="scene" data-src="/scene" {} };
    document("ancf", LIVE_POLICY, &scene, &html! {})
}

/// Compresses bytes with gzip.
pub(crate) fn gzipped(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    // Writing into a vector does not fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}

fn document(title: &str, policy: &str, scene: &Markup, fallback: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(policy);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="referrer" content="no-referrer";
                title { (title) }
                link rel="icon" href="data:,";
                style { (PreEscaped(STYLE.replace("</", "<\\/"))) }
            }
            body {
                div id="app" {}
                noscript {
                    h1 { (title) }
                    p { "The animation and the charts require JavaScript, which is disabled." }
                    (fallback)
                }
                (scene)
                script { (PreEscaped(inline(SCRIPT))) }
            }
        }
    };
    page.into_string()
}

/// Escapes a script for a page: replaces `<` by `\x3c` in `</script` and `<!--`, which would end or change the script element.
///
/// These sequences occur only in string literals of the script, where both forms are equivalent.
fn inline(script: &str) -> String {
    let mut text = String::with_capacity(script.len());
    let mut rest = script;
    while let Some(at) = rest.find('<') {
        let after = &rest[at + 1..];
        let starts =
            |word: &&str| after.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word));
        let ends = ["/script", "!--"].iter().any(starts);
        text.push_str(&rest[..at]);
        text.push_str(if ends { "\\x3c" } else { "<" });
        rest = after;
    }
    text.push_str(rest);
    text
}

/// Content of the page without scripts: outcome, messages, summary and model.
fn summary(header: &Value) -> Markup {
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    html! {
        p { (text(&header["program"])) ", " (text(&header["analysis"])) ", " (text(&header["outcome"]["kind"])) }
        @if let Some(message) = header["outcome"]["message"].as_str().filter(|message| !message.is_empty()) {
            p { (message) }
        }
        @for message in list(&header["messages"]) { p { (text(&message)) } }
        table {
            @for row in list(&header["summary"]) { tr { th { (text(&row[0])) } td { (text(&row[1])) } } }
        }
        pre { (text(&header["text"])) }
    }
}
