//! Character set of the terminal.

use std::env;

/// True if the locale has Unicode characters.
pub fn is_unicode() -> bool {
    is_unicode_locale(|name| env::var(name).ok())
}

fn is_unicode_locale(variable: impl Fn(&str) -> Option<String>) -> bool {
    let set = |name: &&str| variable(name).filter(|value| !value.is_empty());
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"].iter().find_map(set).unwrap_or_default().to_lowercase();
    cfg!(windows) || locale.contains("utf-8") || locale.contains("utf8")
}

#[cfg(test)]
mod tests {
    use super::is_unicode_locale;

    #[test]
    fn the_first_locale_that_is_set_counts() {
        let locale = |set: &'static [(&str, &str)]| {
            is_unicode_locale(|name| {
                set.iter().find(|(n, _)| *n == name).map(|(_, value)| (*value).to_owned())
            })
        };
        assert!(locale(&[("LANG", "de_DE.UTF-8")]));
        assert!(locale(&[("LC_ALL", ""), ("LC_CTYPE", "C.utf8"), ("LANG", "C")]));
        assert!(cfg!(windows) || !locale(&[("LC_ALL", "C"), ("LANG", "en_GB.UTF-8")]));
        assert!(cfg!(windows) || !locale(&[]));
    }
}
