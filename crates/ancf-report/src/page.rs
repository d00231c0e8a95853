use std::io::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use serde_json::Value;

use crate::container::header;

/// The viewer, built from `viewer/`.
const SCRIPT: &str = include_str!("../assets/viewer.js");
const STYLE: &str = include_str!("../assets/viewer.css");

/// What a page may do: run its own scripts, show pictures that it made; nothing from any network.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
                      img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'";
/// The same, but for scenes of the server that it came from.
const LIVE_POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
                           img-src data: blob:; font-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'";

/// One HTML file with a scene, the viewer and all: it loads nothing else.
pub fn page(container: &[u8]) -> String {
    let header = header(container).unwrap_or_default();
    let title = header["title"].as_str().filter(|title| !title.is_empty()).unwrap_or("ancf");
    let data = STANDARD.encode(zipped(container));
    let scene = html! { script type="application/octet-stream" id="scene" { (PreEscaped(data)) } };
    whole(title, POLICY, &scene, &plain(&header))
}

/// The page that [`Server`](crate::Server) gives, which asks for its scene at `/scene`.
pub fn live_page() -> String {
    let scene = html! { script type="application/octet-stream" id="scene" data-src="/scene" {} };
    whole("ancf", LIVE_POLICY, &scene, &html! {})
}

/// Bytes in gzip.
pub(crate) fn zipped(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    // A vector takes everything.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}

fn whole(title: &str, policy: &str, scene: &Markup, plain: &Markup) -> String {
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
                    p { "The animation and the charts of this page are drawn by a script, and scripts are off." }
                    (plain)
                }
                (scene)
                script { (PreEscaped(inline(SCRIPT))) }
            }
        }
    };
    page.into_string()
}

/// A script that can stand in a page: `</script` and `<!--`, which would end or change it, are to be found in its texts only,
/// where `\x3c` says the same as `<`.
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

/// What there is to say without a picture.
fn plain(header: &Value) -> Markup {
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
