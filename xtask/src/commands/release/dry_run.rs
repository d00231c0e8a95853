//! A release: all packages, each tried from its package alone.

use std::time::{Duration, Instant};

use super::{container, platforms};
use crate::packages::release::Release;
use crate::packages::{build, checksums, crates, interface, materials, source, wheel};
use crate::system::environment::Environment;
use crate::system::shell::{Done, root, say};

type Part = fn(&Release) -> Done;

/// Parts of a release in their order.
const PARTS: [(&str, Part); 8] = [
    ("interface", |_| interface::check(&[])),
    ("crates", publish),
    ("program", |release| platforms::native(release).map(|_| ())),
    ("wheel", python),
    ("musl", platforms::try_musl),
    ("windows", platforms::try_windows),
    ("container", |_| container::check()),
    ("materials", bill),
];

/// Builds and tries all packages. Publishes nothing.
pub(crate) fn all(options: &[String]) -> Done {
    let choice = Choice::of(options)?;
    let release = Release::new(&choice.profile)?;
    let mut times = Vec::new();
    let done = PARTS.iter().filter(|(name, _)| choice.has(name)).try_for_each(|(name, part)| {
        say(&format!("\n== release: {name}"));
        let start = Instant::now();
        let done = part(&release);
        times.push((*name, start.elapsed()));
        done.map_err(|why| format!("{name}: {why}"))
    });
    print(&times);
    done?;
    checksums::write(&release.packages)?;
    checksums::check(&release.packages)?;
    crates::report_placeholders()?;
    say(&format!("the packages are in {}; nothing was published", release.packages.display()));
    Ok(())
}

/// Options of the command.
struct Choice {
    profile: String,
    only: Vec<String>,
}

impl Choice {
    fn of(options: &[String]) -> Result<Self, String> {
        let mut choice = Self { profile: "dist".to_owned(), only: Vec::new() };
        let mut is_trial = false;
        let mut options = options.iter();
        while let Some(option) = options.next() {
            let mut value = || options.next().ok_or_else(|| format!("{option} requires a value"));
            match option.as_str() {
                "--dry-run" => is_trial = true,
                "--profile" => choice.profile.clone_from(value()?),
                "--only" => choice.only.extend(value()?.split(',').map(str::to_owned)),
                unknown => {
                    return Err(format!("unknown option `{unknown}`, expected --dry-run, --profile, --only"));
                }
            }
        }
        if !is_trial {
            return Err(
                "expected --dry-run: this command publishes nothing; docs/releasing.md has the steps"
                    .to_owned(),
            );
        }
        let names = PARTS.map(|(name, _)| name);
        match choice.only.iter().find(|name| !names.contains(&name.as_str())) {
            Some(unknown) => Err(format!("unknown part `{unknown}`, expected {}", names.join(", "))),
            None => Ok(choice),
        }
    }

    fn has(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|only| only == name)
    }
}

fn print(times: &[(&str, Duration)]) {
    say("\n== time of each part");
    for (name, time) in times {
        say(&format!("{:7.0} s  {name}", time.as_secs_f64()));
    }
}

fn publish(release: &Release) -> Done {
    crates::publish_dry_run(release, &source::unpacked(release)?)
}

/// Wheel with the program of this machine, built from the source archive and tried in an empty environment.
fn python(release: &Release) -> Done {
    let source = source::unpacked(release)?;
    let built = build::program(release, &source, None)?;
    let environment = Environment::at(&root().join("target/python"))?;
    environment.install(["mypy>=1.11", "pyright[nodejs]>=1.1.390"])?;
    let settings = ["--config-settings", &format!("build-args=--locked --profile {}", release.profile)];
    let folder = release.work.join("wheel");
    let options = wheel::Options { settings: &settings, variables: &build::variables(release, &source) };
    let file = wheel::build(&environment, &source, &built, &options, &folder)?;
    wheel::test(&file, &environment, &folder)?;
    crate::packages::release::copy(&file, &release.packages.join(file.file_name().unwrap_or_default()))
}

fn bill(release: &Release) -> Done {
    materials::write(release, &source::unpacked(release)?, &build::host()?)
}
