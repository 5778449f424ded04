//! The paths that a source says: in `use` items, in types and expressions, and in what is handed to macros and attributes. What is only
//! compiled for tests is left out.

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, Item, Meta, UseTree};

/// A path in its parts, such as `crate`, `a`, `b`.
pub type Parts = Vec<String>;

/// What a `use` item brings in: a path, and the name that it has from there on; none for all that is there.
pub type Used = (Parts, Option<String>);

/// What a `use` item brings in; nothing where it begins with `::`, which is another crate.
#[must_use]
pub fn used(item: &syn::ItemUse) -> Vec<Used> {
    let mut found = Vec::new();
    if item.leading_colon.is_none() {
        branches(&item.tree, &mut Vec::new(), &mut found);
    }
    found
}

fn branches(tree: &UseTree, before: &mut Parts, found: &mut Vec<Used>) {
    let mut leaf = |name: &syn::Ident, known: String| {
        // `a::{self}` is `a`.
        let itself = name == "self" && !before.is_empty();
        let path: Parts = before.iter().cloned().chain((!itself).then(|| name.to_string())).collect();
        let known = if known == "self" { path.last().cloned().unwrap_or_default() } else { known };
        found.push((path, Some(known)));
    };
    match tree {
        UseTree::Name(name) => leaf(&name.ident, name.ident.to_string()),
        UseTree::Rename(name) => leaf(&name.ident, name.rename.to_string()),
        UseTree::Glob(_) => found.push((before.clone(), None)),
        UseTree::Group(group) => group.items.iter().for_each(|tree| branches(tree, before, found)),
        UseTree::Path(path) => {
            before.push(path.ident.to_string());
            branches(&path.tree, before, found);
            before.pop();
        }
    }
}

/// Whether something is compiled for tests only.
#[must_use]
pub fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("cfg") => {
            let condition = list.tokens.to_string().replace(' ', "");
            condition == "test" || condition.starts_with("all(test,")
        }
        _ => false,
    })
}

/// The attributes of an item.
#[must_use]
pub fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::ExternCrate(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::ForeignMod(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::TraitAlias(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Union(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// All paths that an item says, those of one part among them.
#[must_use]
pub fn said(item: &Item) -> Vec<Parts> {
    let mut said = Said { paths: Vec::new() };
    said.visit_item(item);
    said.paths
}

struct Said {
    paths: Vec<Parts>,
}

impl Said {
    /// Names with `::` between them, wherever they stand; not those behind a dot, which are fields and methods.
    fn tokens(&mut self, stream: TokenStream) {
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        let is = |at: usize, c: char| matches!(tokens.get(at), Some(TokenTree::Punct(punct)) if punct.as_char() == c);
        let mut at = 0;
        while at < tokens.len() {
            match &tokens[at] {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(first) => {
                    let begins = at == 0 || !(is(at - 1, '.') || at > 1 && is(at - 1, ':') && is(at - 2, ':'));
                    let mut path = vec![first.to_string()];
                    while is(at + 1, ':') && is(at + 2, ':') {
                        let Some(TokenTree::Ident(next)) = tokens.get(at + 3) else { break };
                        path.push(next.to_string());
                        at += 3;
                    }
                    self.paths.extend(begins.then_some(path));
                }
                _ => {}
            }
            at += 1;
        }
    }
}

impl<'ast> Visit<'ast> for Said {
    fn visit_item(&mut self, item: &'ast Item) {
        if !is_for_tests(attributes(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if !is_for_tests(&item.attrs) {
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.paths.extend(used(item).into_iter().map(|(path, _)| path));
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            self.paths.push(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, item: &'ast syn::Macro) {
        visit::visit_macro(self, item);
        self.tokens(item.tokens.clone());
    }

    fn visit_attribute(&mut self, attribute: &'ast Attribute) {
        if let Meta::List(list) = &attribute.meta {
            self.tokens(list.tokens.clone());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn longer(text: &str) -> Vec<String> {
        let file = syn::parse_file(text).unwrap();
        let paths = file.items.iter().flat_map(said);
        paths.filter(|path| path.len() > 1).map(|path| path.join("::")).collect()
    }

    #[test]
    fn what_is_used_is_taken_apart() {
        let item: syn::ItemUse = syn::parse_str("pub(super) use a::{self, b::{C as D, e::*}, f};").unwrap();
        let found: Vec<_> = used(&item).into_iter().map(|(path, name)| (path.join("::"), name)).collect();
        let one = |path: &str, name: &str| (path.to_owned(), Some(name.to_owned()));
        assert_eq!(found, [one("a", "a"), one("a::b::C", "D"), ("a::b::e".to_owned(), None), one("a::f", "f")]);
        assert!(used(&syn::parse_str("use ::a::b;").unwrap()).is_empty(), "another crate");
    }

    #[test]
    fn paths_are_found_in_types_expressions_macros_and_attributes() {
        let text = "#[arg(parser = crate::a::parse)]\nstruct S(super::b::T<self::c::U>);\n\
                    fn f() { use super::d::V; assert!(x.y, \"{}\", crate::e::g(h::i)); ::other::j(); k::l::<m::N>(); }";
        let expected =
            ["crate::a::parse", "super::b::T", "self::c::U", "super::d::V", "crate::e::g", "h::i", "k::l", "m::N"];
        assert_eq!(longer(text), expected);
    }

    #[test]
    fn comments_strings_and_tests_say_none() {
        let text = "/// See [`crate::a::B`].\nfn f() { /* super::c::d() */ g(\"crate::e::h\"); }\n\
                    #[cfg(test)]\nuse super::i::J;\n#[cfg(all(test, unix))]\nfn t() { crate::k::l() }\n\
                    impl S { #[cfg(test)] fn u() { crate::m::n() } }\n#[cfg(not(test))]\nfn w() { o::p() }\n";
        assert_eq!(longer(text), ["o::p"]);
    }
}
