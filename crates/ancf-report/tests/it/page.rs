//! The page holds the scene, and asks for nothing else.

use std::io::Read;

use ancf_report::{BUDGET, Recording, live_page, page, scene};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::GzDecoder;

use crate::common::Run;

fn run() -> Run {
    Run::of_file("models/cantilever.toml", 0.05, 5)
}

#[test]
fn a_page_holds_its_scene() {
    let run = run();
    let container = scene(&run.recording(), BUDGET);
    let text = page(&container);
    let (_, data) = text.split_once("id=\"scene\">").expect("a scene");
    let (data, _) = data.split_once("</script>").expect("its end");
    let zipped = STANDARD.decode(data).expect("base64");
    let mut bytes = Vec::new();
    GzDecoder::new(zipped.as_slice()).read_to_end(&mut bytes).expect("gzip");
    assert_eq!(bytes, container);
}

#[test]
fn a_page_loads_nothing() {
    let run = run();
    for text in [page(&scene(&run.recording(), BUDGET)), live_page()] {
        for attribute in ["src=", "href=", "@import", "url("] {
            for (at, _) in text.match_indices(attribute) {
                let value = text[at + attribute.len()..].trim_start_matches(['"', '\'', ' ']);
                let far = ["http:", "https:", "//"].iter().any(|start| value.starts_with(start));
                assert!(!far, "{}", &value[..value.len().min(60)]);
            }
        }
        assert!(text.contains("<meta charset=\"utf-8\">"));
        assert!(text.contains("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'"));
        assert!(text.contains("name=\"viewport\""));
    }
    assert!(live_page().contains("data-src=\"/scene\""));
    assert!(!page(&[]).contains("connect-src"), "no network at all");
}

#[test]
fn what_is_said_in_a_model_is_text_in_the_page() {
    let run = run();
    let bad = "</title></script><script>alert(1)</script><img src=x onerror=alert(1)>";
    let recording = Recording {
        title: bad,
        text: bad,
        messages: vec![bad.into()],
        summary: vec![(bad.into(), bad.into())],
        ..run.recording()
    };
    let text = page(&scene(&recording, BUDGET));
    assert!(!text.contains("<script>alert") && !text.contains("<img"), "it is escaped");
    assert!(text.contains("&lt;/title&gt;"));
    // The two scripts of the page are all that there are.
    assert_eq!(text.to_lowercase().matches("</script").count(), 2);
    assert_eq!(text.matches("</style").count(), 1);
}

#[test]
fn without_scripts_there_is_a_summary() {
    let run = run();
    let text = page(&scene(&run.recording(), BUDGET));
    let (_, rest) = text.split_once("<noscript>").expect("a summary");
    let (plain, _) = rest.split_once("</noscript>").expect("its end");
    assert!(plain.contains("<th>steps</th><td>50</td>"), "{plain}");
    assert!(plain.contains("finished"));
}

#[test]
fn what_is_no_container_gives_a_page_too() {
    for bytes in
        [&b""[..], b"ANCF", b"ANCF\x01\0\0\0\xff\xff\xff\xff\0\0\0\0", b"ANCF\x01\0\0\0\x02\0\0\0\0\0\0\0{}"]
    {
        assert!(page(bytes).contains("<title>ancf</title>"));
    }
}
