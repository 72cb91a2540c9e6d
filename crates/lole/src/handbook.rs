//! `lole completions` and `lole man`: what shells and manuals know of the command line.

use std::io::Write as _;

use clap::Command;
use clap_mangen::Man;
use lole_language::Language;

use crate::args::{CompletionsArgs, ManArgs};
use crate::{Failure, output, summary, usage};

/// Writes what the shell completes to standard output.
pub(crate) fn complete(args: &CompletionsArgs) -> Result<(), Failure> {
    // Shells show the same words in any language but for their hints.
    let mut command = usage::command(Language::English);
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, "lole", &mut script);
    summary::heard(std::io::stdout().write_all(&script));
    Ok(())
}

/// Writes a page for the program and one for each command, in the reader's language.
pub(crate) fn man(args: &ManArgs, language: Language) -> Result<(), Failure> {
    let mut command = usage::command(language);
    command.build();
    let mut output = output::create(&args.out).map_err(Failure::Usage)?;
    for (name, page) in pages(&command)? {
        output.write(&name, &page).map_err(Failure::error)?;
    }
    let paths = output.finish().map_err(Failure::error)?;
    summary::print_files(&paths, language);
    Ok(())
}

/// Names of files and their pages.
fn pages(command: &Command) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let subcommands = command.get_subcommands();
    let subcommands = subcommands.filter(|sub| sub.get_name() != "help");
    let all = std::iter::once(command).chain(subcommands);
    all.map(|command| {
        let name = command.get_display_name().unwrap_or(command.get_name());
        let mut page = Vec::new();
        let man = Man::new(command.clone());
        man.render(&mut page).map_err(Failure::error)?;
        Ok((format!("{name}.1"), page))
    })
    .collect()
}
