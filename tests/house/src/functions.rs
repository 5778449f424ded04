//! The functions of a file: how many lines and how many parameters each has. Those that a macro makes are read as well, from the text of
//! the macro.

use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};
use syn::{FnArg, Pat, Token, Type};

/// A function with a body, or one that a trait asks for.
#[derive(Debug, PartialEq)]
pub struct Function {
    /// Its name, behind those of the modules in this file, types and functions around it.
    pub name: String,
    /// Lines from `fn` to the brace that closes it; 0 without a body.
    pub lines: usize,
    /// Parameters, `self` not counted, a tuple by its members; none where they are not ours to choose or cannot be read.
    pub parameters: Option<usize>,
}

/// All functions of a file.
#[must_use]
pub fn functions(file: &syn::File) -> Vec<Function> {
    let mut reader = Reader::default();
    reader.visit_file(file);
    reader.found
}

#[derive(Default)]
struct Reader {
    around: Vec<String>,
    found: Vec<Function>,
}

impl Reader {
    /// Reads what is inside something with a name.
    fn inside(&mut self, name: String, read: impl FnOnce(&mut Self)) {
        self.around.push(name);
        read(self);
        self.around.pop();
    }

    fn add(&mut self, name: &str, lines: usize, parameters: Option<usize>) {
        let name = [self.around.join("::").as_str(), name].join("::");
        self.found.push(Function { name: name.trim_start_matches("::").to_owned(), lines, parameters });
    }

    fn signature(&mut self, of: &syn::Signature, body: Option<&syn::Block>) {
        let lines = body.map_or(0, |body| lines(of.fn_token.span, body.brace_token.span.close()));
        let foreign = of.abi.as_ref().is_some_and(|abi| abi.name.as_ref().is_none_or(|name| name.value() != "Rust"));
        self.add(&of.ident.to_string(), lines, (!foreign).then(|| parameters(of.inputs.iter())));
    }

    /// What stands in a macro: functions are looked for, at any depth.
    fn tokens(&mut self, stream: TokenStream) {
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        for (at, token) in tokens.iter().enumerate() {
            match token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(ident) if ident == "fn" => {
                    self.in_macro(&tokens[..at], ident.span(), &tokens[at + 1..])
                }
                _ => {}
            }
        }
    }

    /// A function in a macro: what stands before its `fn`, and what follows. A type such as `fn(u8)` has no name.
    fn in_macro(&mut self, before: &[TokenTree], begins: Span, behind: &[TokenTree]) {
        let made = usize::from(matches!(behind.first(), Some(TokenTree::Punct(punct)) if punct.as_char() == '$'));
        let Some(TokenTree::Ident(name)) = behind.get(made) else { return };
        let foreign = before.iter().rev().take(2).any(|token| matches!(token, TokenTree::Ident(it) if it == "extern"));
        let ends = behind.iter().position(|token| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';'));
        let groups = outside_angles(&behind[..ends.unwrap_or(behind.len())]);
        let of = |delimiter| groups.iter().find(|group| group.delimiter() == delimiter);
        let (Some(taken), Some(body)) = (of(Delimiter::Parenthesis), of(Delimiter::Brace)) else { return };
        let parameters = if foreign { None } else { written(taken.stream()) };
        self.add(&name.to_string(), lines(begins, body.span_close()), parameters);
    }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        self.inside(item.ident.to_string(), |reader| visit::visit_item_mod(reader, item));
    }

    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        self.inside(item.ident.to_string(), |reader| visit::visit_item_trait(reader, item));
    }

    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        let name = match &*item.self_ty {
            Type::Path(path) => path.path.segments.last().map(|segment| segment.ident.to_string()),
            _ => None,
        };
        self.inside(name.unwrap_or_else(|| "impl".to_owned()), |reader| visit::visit_item_impl(reader, item));
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.signature(&item.sig, Some(&item.block));
        self.inside(item.sig.ident.to_string(), |reader| visit::visit_item_fn(reader, item));
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.signature(&item.sig, Some(&item.block));
        self.inside(item.sig.ident.to_string(), |reader| visit::visit_impl_item_fn(reader, item));
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        self.signature(&item.sig, item.default.as_ref());
        self.inside(item.sig.ident.to_string(), |reader| visit::visit_trait_item_fn(reader, item));
    }

    fn visit_macro(&mut self, item: &'ast syn::Macro) {
        self.tokens(item.tokens.clone());
    }
}

/// Lines from one place to the end of another, both counted.
fn lines(begins: Span, closes: Span) -> usize {
    closes.end().line + 1 - begins.start().line
}

/// The groups that do not stand between `<` and `>`, as in `f<F: Fn(u8)>(of: F)`.
fn outside_angles(tokens: &[TokenTree]) -> Vec<&Group> {
    let (mut depth, mut arrow, mut groups) = (0_usize, false, Vec::new());
    for token in tokens {
        match token {
            TokenTree::Punct(punct) if punct.as_char() == '<' => depth += 1,
            TokenTree::Punct(punct) if punct.as_char() == '>' && !arrow => depth = depth.saturating_sub(1),
            TokenTree::Group(group) if depth == 0 => groups.push(group),
            _ => {}
        }
        arrow = matches!(token, TokenTree::Punct(punct) if punct.as_char() == '-');
    }
    groups
}

/// The parameters that are written in a macro, if they can be read once `$` is left out.
fn written(stream: TokenStream) -> Option<usize> {
    let plain = stream.into_iter().filter(|token| !matches!(token, TokenTree::Punct(punct) if punct.as_char() == '$'));
    let read = Punctuated::<FnArg, Token![,]>::parse_terminated.parse2(plain.collect()).ok()?;
    Some(parameters(read.iter()))
}

/// How many parameters these are.
fn parameters<'a>(of: impl Iterator<Item = &'a FnArg>) -> usize {
    let one = |argument: &FnArg| match argument {
        FnArg::Receiver(_) => 0,
        FnArg::Typed(typed) => in_pattern(&typed.pat).max(in_type(&typed.ty)),
    };
    of.map(one).sum()
}

/// A tuple is as many as its members; all else is one.
fn in_type(of: &Type) -> usize {
    match of {
        Type::Tuple(tuple) => tuple.elems.iter().map(in_type).sum::<usize>().max(1),
        Type::Reference(reference) => in_type(&reference.elem),
        Type::Paren(paren) => in_type(&paren.elem),
        Type::Group(group) => in_type(&group.elem),
        _ => 1,
    }
}

/// The same of a pattern: a tuple's type may have a name.
fn in_pattern(of: &Pat) -> usize {
    match of {
        Pat::Tuple(tuple) => tuple.elems.iter().map(in_pattern).sum::<usize>().max(1),
        Pat::Reference(reference) => in_pattern(&reference.pat),
        Pat::Paren(paren) => in_pattern(&paren.pat),
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Vec<(String, usize, Option<usize>)> {
        let found = functions(&syn::parse_file(text).unwrap());
        found.into_iter().map(|it| (it.name, it.lines, it.parameters)).collect()
    }

    fn one(name: &str, lines: usize, parameters: impl Into<Option<usize>>) -> (String, usize, Option<usize>) {
        (name.to_owned(), lines, parameters.into())
    }

    #[test]
    fn functions_are_found_wherever_they_are_and_named_by_what_is_around_them() {
        let text = "/// fn in_a_comment() {}\n#[test]\nfn a() {\n    fn b() {}\n    let s = \"fn c() {\";\n}\n\
                    mod m {\n    impl<T> Tr for S<T> {\n        fn d(&self) {}\n    }\n    trait Tr {\n        fn e();\n        \
                    fn g() {\n        }\n    }\n}\ntype F = fn(u8) -> u8;\n";
        let expected =
            [one("a", 4, 0), one("a::b", 1, 0), one("m::S::d", 1, 0), one("m::Tr::e", 0, 0), one("m::Tr::g", 2, 0)];
        assert_eq!(read(text), expected);
    }

    #[test]
    fn a_body_is_counted_from_fn_and_without_attributes() {
        let text = "/// Says.\n#[must_use]\npub const fn\na(\n) {\n    // one\n\n    \"}\n\";\n}";
        assert_eq!(read(text), [one("a", 8, 0)]);
    }

    #[test]
    fn parameters_are_counted_by_their_members_and_foreign_ones_are_not() {
        let text = "impl S { fn a(&mut self, x: u8, (y, (z, w)): (u8, (u8, u8)), u: &(u8, [(u8, u8); 3]), v: fn(u8, u8)) {} }\n\
                    fn b((x, y): Pair, (): (), c: impl Fn(u8, u8)) {}\n\
                    unsafe extern \"C\" fn c(a: u8, b: u8) {}\nextern \"C\" { fn d(a: u8); }\nextern \"Rust\" fn e(a: u8) {}\n";
        assert_eq!(read(text), [one("S::a", 1, 7), one("b", 1, 4), one("c", 1, None), one("e", 1, 1)]);
    }

    #[test]
    fn functions_in_macros_are_counted_and_what_only_looks_like_one_is_not() {
        let text = "macro_rules! m {\n    ($name:ident, $f:ty) => {\n        pub fn $name<F: Fn(u8) -> u8>(&self, a: $f, b: u8) -> u8 {\n\
                    \n        }\n        unsafe extern \"C\" fn glue(a: u8) {}\n    };\n}\n\
                    m! { call: fn(u8, u8) -> u8; other: fn(u8) }\nfn f() { assert!(x, \"fn no() {}\"); }\n\
                    cases! { fn c(a in 0..3, b in 1..2) {\n} }\nm! { fn declared(a: u8); fn g($($x: u8),*) {} }\n";
        let expected = [one("name", 3, 2), one("glue", 1, None), one("f", 1, 0), one("c", 2, None), one("g", 1, None)];
        assert_eq!(read(text), expected);
    }
}
