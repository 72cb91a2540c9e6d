//! The house's shape in figures: how long its functions and files are, how many values they take,
//! how large its crates, and which public types share a name.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;

use anyhow::Context as _;
use proc_macro2::Span;
use syn::visit::Visit;

use crate::tidy::{TextFile, text_files};

/// Values that a function may take before it is counted as taking many.
const FEW_VALUES: usize = 4;

/// Lines of a file above which it is named.
const FILE_LINES: usize = 700;

/// One function of the product.
struct Function {
    place: String,
    lines: usize,
    /// What it takes besides `self`; a tuple counts as many as it holds.
    values: usize,
}

/// What the product's files hold.
#[derive(Default)]
struct Shape {
    functions: Vec<Function>,
    /// Lines without the tests in the same files, by crate.
    crates: BTreeMap<String, usize>,
    /// Lines with them, by file.
    long_files: Vec<(usize, String)>,
    /// Where public types are defined, by name.
    types: BTreeMap<String, Vec<String>>,
}

/// Prints the figures; a bar that is not kept is a figure, not a failure.
pub(crate) fn run(repository: &Path) -> anyhow::Result<ExitCode> {
    let files = text_files(repository)?;
    let mut shape = Shape::default();
    for file in &files {
        if let Some(crate_name) = product(&file.path) {
            shape.add(crate_name, file)?;
        }
    }
    shape.print();
    Ok(ExitCode::SUCCESS)
}

/// The crate whose product code a file is.
fn product(path: &str) -> Option<&str> {
    let (name, rest) = path.strip_prefix("crates/")?.split_once('/')?;
    let is_code = rest.starts_with("src/") && rest.ends_with(".rs");
    (is_code && !rest.ends_with("/tests.rs") && !rest.contains("/tests/")).then_some(name)
}

impl Shape {
    fn add(&mut self, crate_name: &str, file: &TextFile) -> anyhow::Result<()> {
        let tree = syn::parse_file(&file.text).with_context(|| file.path.clone())?;
        let mut visitor = Visitor {
            path: &file.path,
            shape: self,
            test_lines: 0,
        };
        visitor.visit_file(&tree);
        let test_lines = visitor.test_lines;
        let lines = file.text.lines().count();
        *self.crates.entry(crate_name.to_owned()).or_default() += lines - test_lines;
        if FILE_LINES < lines {
            self.long_files.push((lines, file.path.clone()));
        }
        Ok(())
    }

    fn print(mut self) {
        let total: usize = self.crates.values().sum();
        println!("product lines, tests in the same files left out: {total}");
        let mut crates: Vec<_> = self
            .crates
            .iter()
            .map(|(name, lines)| (lines, name))
            .collect();
        crates.sort_unstable_by(|one, other| other.cmp(one));
        for (lines, name) in crates {
            println!("  {lines:6} {name}");
        }
        self.functions.sort_by_key(|function| function.lines);
        let at = |per_cent: usize| {
            let index = self.functions.len().saturating_sub(1) * per_cent / 100;
            self.functions
                .get(index)
                .map_or(0, |function| function.lines)
        };
        println!(
            "functions: {}; lines of the median {}, of p90 {}, of the longest {}",
            self.functions.len(),
            at(50),
            at(90),
            at(100)
        );
        let many = self
            .functions
            .iter()
            .filter(|function| FEW_VALUES < function.values);
        let mut many: Vec<_> = many
            .map(|function| (function.values, &function.place))
            .collect();
        many.sort_unstable_by(|one, other| other.cmp(one));
        println!(
            "functions that take more than {FEW_VALUES} values, those in tuples counted: {}",
            many.len()
        );
        for (values, place) in many {
            println!("  {values:6} {place}");
        }
        self.long_files
            .sort_unstable_by(|one, other| other.cmp(one));
        println!("files over {FILE_LINES} lines: {}", self.long_files.len());
        for (lines, path) in self.long_files {
            println!("  {lines:6} {path}");
        }
        self.types.retain(|_, places| 1 < places.len());
        println!("names that several public types have: {}", self.types.len());
        for (name, places) in self.types {
            println!("  {name}: {}", places.join(", "));
        }
    }
}

/// Walks one file.
struct Visitor<'v> {
    path: &'v str,
    shape: &'v mut Shape,
    test_lines: usize,
}

impl Visitor<'_> {
    fn measure(&mut self, signature: &syn::Signature, block: &syn::Block) {
        let line = signature.fn_token.span.start().line;
        let end = block.brace_token.span.close().end().line;
        let values = signature.inputs.iter().map(|input| match input {
            syn::FnArg::Receiver(_) => 0,
            syn::FnArg::Typed(typed) => values_in(&typed.ty),
        });
        self.shape.functions.push(Function {
            place: format!("{}:{line} {}", self.path, signature.ident),
            lines: end + 1 - line,
            values: values.sum(),
        });
    }

    fn define(&mut self, visibility: &syn::Visibility, name: &syn::Ident) {
        if matches!(visibility, syn::Visibility::Public(_)) {
            let places = self.shape.types.entry(name.to_string()).or_default();
            places.push(self.path.to_owned());
        }
    }
}

/// How many values a parameter of a type holds.
fn values_in(ty: &syn::Type) -> usize {
    match ty {
        syn::Type::Tuple(tuple) => tuple.elems.iter().map(values_in).sum(),
        syn::Type::Reference(reference) => values_in(&reference.elem),
        syn::Type::Paren(paren) => values_in(&paren.elem),
        _ => 1,
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("test")
            || attribute.path().is_ident("cfg")
                && attribute
                    .parse_args::<syn::Ident>()
                    .is_ok_and(|name| name == "test")
    })
}

fn lines_of(start: Span, end: Span) -> usize {
    end.end().line + 1 - start.start().line
}

impl<'ast> Visit<'ast> for Visitor<'_> {
    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        if !is_test(&module.attrs) {
            syn::visit::visit_item_mod(self, module);
        } else if let Some((brace, _)) = &module.content {
            self.test_lines += lines_of(module.mod_token.span, brace.span.close());
        }
    }

    fn visit_item_fn(&mut self, function: &'ast syn::ItemFn) {
        if !is_test(&function.attrs) {
            self.measure(&function.sig, &function.block);
            syn::visit::visit_item_fn(self, function);
        }
    }

    fn visit_impl_item_fn(&mut self, function: &'ast syn::ImplItemFn) {
        if !is_test(&function.attrs) {
            self.measure(&function.sig, &function.block);
            syn::visit::visit_impl_item_fn(self, function);
        }
    }

    fn visit_item_struct(&mut self, item: &'ast syn::ItemStruct) {
        self.define(&item.vis, &item.ident);
    }

    fn visit_item_enum(&mut self, item: &'ast syn::ItemEnum) {
        self.define(&item.vis, &item.ident);
    }

    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        self.define(&item.vis, &item.ident);
        syn::visit::visit_item_trait(self, item);
    }

    fn visit_item_type(&mut self, item: &'ast syn::ItemType) {
        self.define(&item.vis, &item.ident);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape_of(text: &str) -> Shape {
        let mut shape = Shape::default();
        let file = TextFile {
            path: "crates/some/src/some.rs".to_owned(),
            text: text.to_owned(),
        };
        shape.add("some", &file).unwrap();
        shape
    }

    #[test]
    fn tuples_do_not_hide_values_and_tests_are_no_product() {
        let shape = shape_of(
            "struct One;\nimpl One {\n    fn two(&self, (a, b): (u8, &u8), c: &(u8, (u8, u8))) {\n    }\n}\n\
             #[cfg(test)]\nmod tests {\n    fn three() {}\n}\n",
        );
        assert_eq!(shape.functions.len(), 1);
        assert_eq!(
            (shape.functions[0].values, shape.functions[0].lines),
            (5, 2)
        );
        assert_eq!(shape.crates["some"], 6);
    }

    #[test]
    fn only_public_types_share_names() {
        let shape = shape_of(
            "pub struct One;\nmod two {\n    pub enum One {}\n    pub(crate) struct Two;\n}\n",
        );
        assert_eq!(shape.types.len(), 1);
        assert_eq!(shape.types["One"].len(), 2);
    }

    #[test]
    fn what_lies_beside_the_product_is_not_counted() {
        assert_eq!(product("crates/some/src/one.rs"), Some("some"));
        assert_eq!(product("crates/some/tests/one.rs"), None);
        assert_eq!(product("crates/some/src/one/tests.rs"), None);
        assert_eq!(product("xtask/src/main.rs"), None);
    }
}
