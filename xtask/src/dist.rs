//! Packages for machines without a compiler: an archive and a Debian package of both programs, with the licenses of
//! what is built in, a bill of materials and checksums.
//!
//! Paths of this machine are replaced in the programs, and the time in all of it is that of the last commit, so that
//! nothing in them depends on where and when they were built.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use anyhow::{Context as _, ensure};

/// Both programs: the command, and the window beside it.
const PROGRAMS: [&str; 2] = ["lole", "lole-studio"];
/// The crates that they are built from.
const PACKAGES: [&str; 2] = ["lole", "lole_studio"];
/// What goes with them as it is, from the repository's root.
const TEXTS: [&str; 6] = [
    "README.md",
    "README.ja.md",
    "CHANGELOG.md",
    "NOTICE",
    "LICENSE-MIT",
    "LICENSE-APACHE",
];
/// Tools that packages are made with, and the version that was tried.
const TOOLS: [[&str; 2]; 4] = [
    ["cargo-about", "0.8.4"],
    ["cargo-auditable", "0.7.7"],
    ["cargo-cyclonedx", "0.5.7"],
    ["cargo-packager", "0.11.8"],
];
/// Libraries that the window opens when it starts, and that no linker knows of.
const DEPENDS: [&str; 11] = [
    "libc6",
    "libgcc-s1",
    "libx11-6",
    "libx11-xcb1",
    "libxcursor1",
    "libxi6",
    "libxkbcommon0",
    "libxkbcommon-x11-0",
    "libwayland-client0",
    "libvulkan1 | libegl1",
    "mesa-vulkan-drivers | vulkan-icd",
];

/// Where things are for one run.
struct Bench<'a> {
    repository: &'a Path,
    /// The folder that everything is written to.
    folder: PathBuf,
    /// As in the workspace's manifest.
    version: String,
    /// Seconds since 1970 of the last commit.
    epoch: String,
}

/// Builds all of it into one folder.
pub(crate) fn run(repository: &Path) -> anyhow::Result<ExitCode> {
    if let Some(sentence) = missing() {
        println!("{sentence}");
        return Ok(ExitCode::FAILURE);
    }
    let folder = super::web::target(repository).join("dist");
    // What an earlier build left is no part of this one; Cargo's own folder is kept.
    for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_file() {
            fs::remove_file(path)?;
        }
    }
    fs::create_dir_all(&folder)?;
    let bench = Bench::new(repository, folder)?;
    bench.build()?;
    let stage = bench.stage()?;
    bench.bill()?;
    bench.archive(&stage)?;
    bench.package(&stage)?;
    bench.checksums()?;
    println!("packages are in {}", bench.folder.display());
    Ok(ExitCode::SUCCESS)
}

/// Builds the programs twice, from the sources here and from a copy of them elsewhere, and says whether they are the
/// same to the bit.
pub(crate) fn twice(repository: &Path) -> anyhow::Result<ExitCode> {
    let changed = output(repository, "git", &["status", "--porcelain"]).unwrap_or_default();
    ensure!(
        changed.is_empty(),
        "commit what has changed: the copy is of the last commit"
    );
    let folder = super::web::target(repository).join("dist");
    let copy = folder.join("again").join("in-a-folder-of-another-name");
    drop(fs::remove_dir_all(&copy));
    fs::create_dir_all(&copy)?;
    let archive = copy.join("sources.tar");
    finish(
        Command::new("git")
            .current_dir(repository)
            .args(["archive", "--output"])
            .arg(&archive)
            .arg("HEAD"),
    )?;
    finish(
        Command::new("tar")
            .current_dir(&copy)
            .args(["-x", "-f", "sources.tar"]),
    )?;
    fs::remove_file(archive)?;
    let first = Bench::new(repository, folder)?;
    let other = Bench {
        repository: &copy,
        folder: copy.join("elsewhere"),
        version: first.version.clone(),
        epoch: first.epoch.clone(),
    };
    let mut is_same = true;
    for bench in [&first, &other] {
        fs::create_dir_all(&bench.folder)?;
        bench.build()?;
    }
    for program in PROGRAMS {
        let [one, two] = [&first, &other].map(|bench| fs::read(bench.program(program)));
        let (one, two) = (one?, two?);
        let says = if one == two {
            "the same"
        } else {
            "not the same"
        };
        println!("{program}: {} bytes, {says} in both", one.len());
        is_same &= one == two;
    }
    fs::remove_dir_all(&copy)?;
    Ok(if is_same {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

/// What says which tool is missing, and how it is installed.
fn missing() -> Option<String> {
    let installed = |name: &str| {
        let mut command = Command::new(name);
        command.arg("--version").output().is_ok()
    };
    let [name, version] = TOOLS.into_iter().find(|[name, _]| !installed(name))?;
    Some(format!(
        "{name} is missing; install it with: cargo install --locked {name}@{version}"
    ))
}

/// The version of all crates.
fn version(repository: &Path) -> anyhow::Result<String> {
    let manifest = fs::read_to_string(repository.join("Cargo.toml"))?;
    let line = manifest
        .lines()
        .find_map(|line| line.strip_prefix("version = \""));
    let version = line.and_then(|rest| rest.strip_suffix('"'));
    Ok(version.context("Cargo.toml names no version")?.to_owned())
}

/// What a command prints, without what stands around it.
fn output(folder: &Path, program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .output()
        .ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

/// Runs a command to its end.
fn finish(command: &mut Command) -> anyhow::Result<()> {
    let name = command.get_program().to_string_lossy().into_owned();
    let status = command
        .status()
        .with_context(|| format!("{name} cannot be run"))?;
    ensure!(status.success(), "{name} failed");
    Ok(())
}

impl<'a> Bench<'a> {
    fn new(repository: &'a Path, folder: PathBuf) -> anyhow::Result<Self> {
        let epoch = output(repository, "git", &["log", "-1", "--format=%ct"]);
        Ok(Self {
            repository,
            folder,
            version: version(repository)?,
            epoch: epoch
                .filter(|it| !it.is_empty())
                .unwrap_or_else(|| "0".to_owned()),
        })
    }

    /// Cargo's own folder of these builds: other flags than usual would build everything anew each time.
    fn built(&self) -> PathBuf {
        self.folder.join("build")
    }

    fn program(&self, name: &str) -> PathBuf {
        self.built().join("release").join(name)
    }

    /// Builds the programs without a path of this machine, each with the list of what is built into it, which
    /// `cargo audit bin` and scanners of containers read.
    fn build(&self) -> anyhow::Result<()> {
        let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
        let home = home.or_else(|| Some(Path::new(&std::env::var_os("HOME")?).join(".cargo")));
        let home = home.context("neither CARGO_HOME nor HOME is set")?;
        let sysroot = output(self.repository, "rustc", &["--print", "sysroot"]).unwrap_or_default();
        let places = [
            (self.repository.display().to_string(), "lole"),
            (home.display().to_string(), "cargo"),
            (sysroot, "rust"),
            // It lies in the first one: of several, the last one counts.
            (self.built().display().to_string(), "built"),
        ];
        let rust = places
            .iter()
            .map(|(from, to)| format!("--remap-path-prefix={from}={to}"));
        let c = places
            .iter()
            .map(|(from, to)| format!("-ffile-prefix-map={from}={to}"));
        let c = c.collect::<Vec<_>>().join(" ");
        let mut cargo = Command::new("cargo");
        cargo
            .current_dir(self.repository)
            .args(["auditable", "build", "--release", "--locked"])
            .args(PACKAGES.iter().flat_map(|package| ["-p", package]))
            // Parted by the one character that no path has.
            .env(
                "CARGO_ENCODED_RUSTFLAGS",
                rust.collect::<Vec<_>>().join("\u{1f}"),
            )
            .env("CFLAGS", &c)
            .env("CXXFLAGS", &c)
            .env("SOURCE_DATE_EPOCH", &self.epoch)
            .env("CARGO_TARGET_DIR", self.built());
        finish(&mut cargo)
    }

    /// Lays everything out as it is unpacked; the folder.
    fn stage(&self) -> anyhow::Result<PathBuf> {
        let name = format!("lole-{}-{}", self.version, std::env::consts::ARCH);
        let stage = self.folder.join("stage").join(name);
        drop(fs::remove_dir_all(&stage));
        fs::create_dir_all(stage.join("completions"))?;
        for program in PROGRAMS {
            fs::copy(self.program(program), stage.join(program))
                .with_context(|| format!("{program} was not built"))?;
        }
        for text in TEXTS {
            fs::copy(self.repository.join(text), stage.join(text))
                .with_context(|| text.to_owned())?;
        }
        let command = stage.join("lole");
        for (folder, locale) in [("man", "en_US.UTF-8"), ("man.ja", "ja_JP.UTF-8")] {
            let mut man = Command::new(&command);
            man.args(["man", "--quiet", "--out"])
                .arg(stage.join(folder))
                .env("LC_ALL", locale);
            finish(&mut man)?;
        }
        for (shell, file) in [("bash", "lole"), ("zsh", "_lole"), ("fish", "lole.fish")] {
            let script = Command::new(&command)
                .args(["completions", shell])
                .output()?;
            ensure!(script.status.success(), "lole completions {shell} failed");
            fs::write(stage.join("completions").join(file), script.stdout)?;
        }
        let licenses = stage.join("third-party-licenses.html");
        let mut about = Command::new("cargo");
        about
            .current_dir(self.repository.join("crates/lole_studio"))
            .args(["about", "generate", "--locked", "--fail", "-c"])
            .arg(self.repository.join("packaging/about.toml"))
            .arg("-o")
            .arg(&licenses)
            .arg(self.repository.join("packaging/about.hbs"));
        finish(&mut about)?;
        Ok(stage)
    }

    /// Writes the bill of materials of each program.
    fn bill(&self) -> anyhow::Result<()> {
        let mut bill = Command::new("cargo");
        bill.current_dir(self.repository)
            .args([
                "cyclonedx",
                "--format",
                "json",
                "--override-filename",
                "lole-bill",
            ])
            .env("SOURCE_DATE_EPOCH", &self.epoch);
        finish(&mut bill)?;
        // The tool writes beside each manifest.
        let crates = fs::read_dir(self.repository.join("crates"))?;
        let crates = crates.filter_map(Result::ok).map(|entry| entry.path());
        for folder in crates.chain([self.repository.join("xtask")]) {
            let written = folder.join("lole-bill.json");
            let name = folder
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            if PACKAGES.contains(&name.as_str()) {
                let program = name.replace('_', "-");
                fs::copy(&written, self.folder.join(format!("{program}.cdx.json")))?;
            }
            drop(fs::remove_file(written));
        }
        Ok(())
    }

    /// Packs the folder so that the same files give the same bytes.
    fn archive(&self, stage: &Path) -> anyhow::Result<()> {
        let name = stage.file_name().unwrap_or_default();
        let archive = format!("{}.tar.gz", name.to_string_lossy());
        let mut tar = Command::new("tar");
        tar.current_dir(self.folder.join("stage"))
            .args([
                "--sort=name",
                "--owner=0",
                "--group=0",
                "--numeric-owner",
                "--mode=u+rwX,go+rX,go-w",
            ])
            .arg(format!("--mtime=@{}", self.epoch))
            .args(["--use-compress-program=gzip -9n", "-cf"])
            .arg(self.folder.join(archive))
            .arg(name);
        finish(&mut tar)
    }

    /// The packages that this machine's kind installs.
    fn package(&self, stage: &Path) -> anyhow::Result<()> {
        let packaging = self.repository.join("packaging");
        let text = fs::read_to_string(packaging.join("Packager.toml"))?;
        let config = self.config(stage, &text);
        // Paths in it are those of its folder.
        let file = packaging.join("Packager.made.toml");
        fs::write(&file, config)?;
        let made = finish(
            Command::new("cargo")
                .current_dir(self.repository)
                .args(["packager", "--formats", "deb", "-c"])
                .arg(&file)
                .env("SOURCE_DATE_EPOCH", &self.epoch),
        );
        fs::remove_file(&file)?;
        made
    }

    /// What the packager is told, with what this run knows.
    fn config(&self, stage: &Path, text: &str) -> String {
        let quoted = |path: &Path| format!("{:?}", path.display().to_string());
        let top = format!(
            "version = \"{}\"\nbinariesDir = {}\noutDir = {}\nbinaries = [{{ path = \"lole\" }}, {{ path = \"lole-studio\", main = true }}]\n",
            self.version,
            quoted(stage),
            quoted(&self.folder),
        );
        let files = [
            ("man", "usr/share/man/man1"),
            ("man.ja", "usr/share/man/ja/man1"),
            (
                "completions/lole",
                "usr/share/bash-completion/completions/lole",
            ),
            (
                "completions/_lole",
                "usr/share/zsh/vendor-completions/_lole",
            ),
            (
                "completions/lole.fish",
                "usr/share/fish/vendor_completions.d/lole.fish",
            ),
            ("NOTICE", "usr/share/doc/lole/NOTICE"),
            ("LICENSE-MIT", "usr/share/doc/lole/LICENSE-MIT"),
            ("LICENSE-APACHE", "usr/share/doc/lole/LICENSE-APACHE"),
            ("README.md", "usr/share/doc/lole/README.md"),
            ("README.ja.md", "usr/share/doc/lole/README.ja.md"),
            (
                "third-party-licenses.html",
                "usr/share/doc/lole/third-party-licenses.html",
            ),
        ];
        let files = files.map(|(from, to)| format!("{} = \"{to}\"\n", quoted(&stage.join(from))));
        let depends = DEPENDS.map(|name| format!("\"{name}\"")).join(", ");
        format!(
            "{top}{text}\n[deb]\ndepends = [{depends}]\ndesktopTemplate = \"lole.desktop\"\nsection = \"graphics\"\n\n[deb.files]\n{}\"lole.xml\" = \"usr/share/mime/packages/lole.xml\"\n",
            files.concat()
        )
    }

    /// One line for each file that is given away.
    fn checksums(&self) -> anyhow::Result<()> {
        let mut names = Vec::new();
        for entry in fs::read_dir(&self.folder)? {
            let entry = entry?;
            if entry.file_type()?.is_file() {
                names.push(entry.file_name());
            }
        }
        names.sort();
        let sums = Command::new("sha256sum")
            .current_dir(&self.folder)
            .args(&names)
            .output();
        let sums = sums.context("sha256sum cannot be run")?;
        ensure!(sums.status.success(), "sha256sum failed");
        fs::write(self.folder.join("SHA256SUMS"), &sums.stdout)?;
        print!("{}", String::from_utf8_lossy(&sums.stdout));
        Ok(())
    }
}
