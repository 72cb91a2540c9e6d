//! Rust files open with `//!` and stay within their budgets, or say why not.

use syn::visit::Visit;

use super::TextFile;

/// Lines of a file above which it must give a reason.
const FILE_LINES: usize = 800;

/// Lines of a function, signature to closing brace, above which it must give a reason.
const FUNCTION_LINES: usize = 80;

/// What opens a reason, in a comment: "Long because the table has one row per key."
const REASON: &str = "Long because";

pub(crate) fn check(files: &[TextFile]) -> Vec<String> {
    files
        .iter()
        .filter(|file| file.path.ends_with(".rs"))
        .flat_map(check_file)
        .collect()
}

fn check_file(file: &TextFile) -> Vec<String> {
    let TextFile { path, text } = file;
    let mut findings = Vec::new();
    if !text.starts_with("//!") {
        findings.push(format!("{path}:1: say in a //! line what the file is"));
    }
    let line_count = text.lines().count();
    if FILE_LINES < line_count && !has_reason(text) {
        findings.push(format!(
            "{path}:1: {line_count} lines; split the file, or give a reason (\"{REASON} …\")"
        ));
    }
    match syn::parse_file(text) {
        Ok(tree) => {
            let mut functions = Functions {
                lines: text.lines().collect(),
                long: Vec::new(),
            };
            functions.visit_file(&tree);
            for (line, name, length) in functions.long {
                findings.push(format!(
                    "{path}:{line}: {name} has {length} lines; split it, or give a reason \
                     (\"{REASON} …\")"
                ));
            }
        }
        Err(error) => findings.push(format!("{path}:{}: {error}", error.span().start().line)),
    }
    findings
}

fn has_reason(text: &str) -> bool {
    text.lines().any(|line| {
        let line = line.trim_start();
        line.starts_with("//") && line.contains(REASON)
    })
}

/// Collects functions that are too long and give no reason.
struct Functions<'t> {
    lines: Vec<&'t str>,
    long: Vec<(usize, String, usize)>,
}

impl Functions<'_> {
    /// The name stands on the first line of all but the most attributed signatures.
    fn measure(&mut self, name: &syn::Ident, block: &syn::Block) {
        let start = name.span().start().line;
        let end = block.brace_token.span.close().end().line;
        let length = (end + 1).saturating_sub(start);
        // The reason may stand above the signature, among its docs and attributes, or inside.
        let before = self.lines[..start.saturating_sub(1)]
            .iter()
            .rev()
            .take_while(|line| {
                let line = line.trim_start();
                line.starts_with("//") || line.starts_with("#[")
            })
            .count();
        let first = start.saturating_sub(1 + before);
        let own = self.lines.get(first..end).unwrap_or_default().join("\n");
        if FUNCTION_LINES < length && !has_reason(&own) {
            self.long.push((start, name.to_string(), length));
        }
    }
}

impl<'ast> Visit<'ast> for Functions<'_> {
    fn visit_item_fn(&mut self, function: &'ast syn::ItemFn) {
        self.measure(&function.sig.ident, &function.block);
        syn::visit::visit_item_fn(self, function);
    }

    fn visit_impl_item_fn(&mut self, function: &'ast syn::ImplItemFn) {
        self.measure(&function.sig.ident, &function.block);
        syn::visit::visit_impl_item_fn(self, function);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings(text: &str) -> Vec<String> {
        check_file(&TextFile {
            path: "some.rs".to_owned(),
            text: text.to_owned(),
        })
    }

    #[test]
    fn a_file_says_what_it_is() {
        assert!(findings("//! Something.\nfn main() {}\n").is_empty());
        assert_eq!(findings("fn main() {}\n").len(), 1);
    }

    #[test]
    fn a_long_function_gives_its_reason() {
        let body = "    step();\n".repeat(79);
        let long = format!("//! Something.\nfn main() {{\n{body}}}\n");
        assert_eq!(findings(&long).len(), 1);
        assert!(findings(&long.replacen("    step();\n", "", 1)).is_empty());
        let reason = "//! Something.\n\n/// Long because it is a table.\n";
        assert!(findings(&format!("{reason}fn main() {{\n{body}}}\n")).is_empty());
    }

    #[test]
    fn a_long_file_gives_its_reason() {
        let long = format!("//! Something.\n{}", "// line\n".repeat(800));
        assert_eq!(findings(&long).len(), 1);
        assert!(findings(&long.replacen("// line", "// Long because of data.", 1)).is_empty());
    }
}
