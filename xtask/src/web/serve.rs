//! Serves the page on this machine, with the headers that a server for everybody should send too.

use std::fs;
use std::io::{BufRead as _, BufReader, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::{Component, Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context as _, ensure};

/// Where it listens, unless a port is named.
const PORT: u16 = 8125;
/// The longest request that is read [byte].
const LONGEST: usize = 16 << 10;

/// Sent with every file. The page is isolated, so that it may use threads one day; it is asked for anew each time,
/// so that a new build is seen.
const HEADERS: &str = "\
Cross-Origin-Opener-Policy: same-origin\r
Cross-Origin-Embedder-Policy: require-corp\r
Cross-Origin-Resource-Policy: same-origin\r
X-Content-Type-Options: nosniff\r
Referrer-Policy: no-referrer\r
Cache-Control: no-cache\r
Connection: close\r
";

/// Serves a folder until it is stopped.
pub(crate) fn run(folder: &Path, port: Option<&str>) -> anyhow::Result<ExitCode> {
    ensure!(
        folder.join("index.html").exists(),
        "there is no page in {}; build it first: cargo xtask web",
        folder.display()
    );
    let port = match port {
        Some(port) => port.parse().context("the port is a number up to 65535")?,
        None => PORT,
    };
    let listener = TcpListener::bind(("127.0.0.1", port)).with_context(|| {
        format!("port {port} cannot be used; name another: cargo xtask serve 8126")
    })?;
    println!("http://127.0.0.1:{port}/    stop it with Ctrl+C");
    for stream in listener.incoming().flatten() {
        let folder = folder.to_owned();
        std::thread::spawn(move || {
            // A browser that goes away in the middle is no news.
            drop(answer(&stream, &folder));
        });
    }
    Ok(ExitCode::SUCCESS)
}

fn answer(mut stream: &TcpStream, folder: &Path) -> anyhow::Result<()> {
    let mut lines = BufReader::new(std::io::Read::take(stream, LONGEST as u64)).lines();
    let first = lines.next().context("nothing was asked")??;
    for line in lines {
        if line?.is_empty() {
            break;
        }
    }
    let mut words = first.split(' ');
    let is_read = matches!(words.next(), Some("GET" | "HEAD"));
    let path = words.next().and_then(|address| file(folder, address));
    let read = path
        .filter(|_| is_read)
        .and_then(|path| Some((fs::read(&path).ok()?, path)));
    let Some((bytes, path)) = read else {
        write!(
            stream,
            "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n{HEADERS}\r\n"
        )?;
        return Ok(());
    };
    let (kind, length) = (kind(&path), bytes.len());
    write!(
        stream,
        "HTTP/1.1 200 OK\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\n{HEADERS}\r\n"
    )?;
    if !first.starts_with("HEAD") {
        stream.write_all(&bytes)?;
    }
    Ok(())
}

/// The file that an address means; `None` where it leads out of the folder.
fn file(folder: &Path, address: &str) -> Option<PathBuf> {
    let path = address.split(['?', '#']).next()?.trim_start_matches('/');
    let path = Path::new(if path.is_empty() { "index.html" } else { path });
    let is_inside = path
        .components()
        .all(|part| matches!(part, Component::Normal(_)));
    is_inside.then(|| folder.join(path))
}

/// What a browser must be told that a file is.
fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("otf") => "font/otf",
        Some("webmanifest") => "application/manifest+json",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_stay_in_the_folder() {
        let folder = Path::new("page");
        assert_eq!(file(folder, "/"), Some("page/index.html".into()));
        assert_eq!(file(folder, "/a.js?b"), Some("page/a.js".into()));
        assert_eq!(file(folder, "/../secret"), None);
        assert_eq!(file(folder, "//etc/passwd"), Some("page/etc/passwd".into()));
    }
}
