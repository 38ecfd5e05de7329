//! The elements of a document that are drawn, with their transforms.

use crate::error::{Place, Problem, Result};
use crate::outline::Point;
use nalgebra::vector;
use roxmltree::{Document, Node};
use std::collections::HashMap;
use svgtypes::Transform;

/// How deep groups and uses may be nested.
const DEEPEST: usize = 64;
/// How many elements may be drawn, those that are used again counted again.
const MOST: usize = 1 << 20;
/// How many letters elements may have that are drawn again, beyond those of the document.
const MOST_LETTERS: usize = 1 << 25;

/// A map of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Affine(Option<Transform>);

impl Affine {
    /// Where a point goes; without transforms it keeps its bits.
    pub fn at(&self, p: Point) -> Point {
        match &self.0 {
            None => p,
            Some(t) => vector![t.a * p[0] + t.c * p[1] + t.e, t.b * p[0] + t.d * p[1] + t.f],
        }
    }

    /// The map that does `inner` first.
    fn after(&self, inner: Transform) -> Self {
        let Some(t) = &self.0 else { return Self(Some(inner)) };
        Self(Some(Transform {
            a: t.a * inner.a + t.c * inner.b,
            b: t.b * inner.a + t.d * inner.b,
            c: t.a * inner.c + t.c * inner.d,
            d: t.b * inner.c + t.d * inner.d,
            e: t.a * inner.e + t.c * inner.f + t.e,
            f: t.b * inner.e + t.d * inner.f + t.f,
        }))
    }
}

/// The place of an element in its text.
pub(super) fn place(node: Node<'_, '_>) -> Place {
    let at = node.document().text_pos_at(node.range().start);
    Place::Line { line: at.row as usize, column: at.col as usize }
}

/// What is done with an element that is drawn.
pub(super) type Draw<'a> = &'a mut dyn FnMut(Node<'_, '_>, Affine) -> Result<()>;

/// Draws all elements of a document.
///
/// # Errors
/// [`Problem::Syntax`] with line and column, and those of `draw`.
pub(super) fn draw_all(document: &Document<'_>, draw: Draw<'_>) -> Result<()> {
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let found = root.tag_name().name();
        return Err(Problem::Syntax(format!("the root is '{found}', not 'svg'")).at(place(root)));
    }
    let mut ids = HashMap::new();
    for node in document.descendants() {
        if let Some(id) = node.attribute("id") {
            ids.entry(id).or_insert(node);
        }
    }
    Walk { draw, ids, count: 0, letters: 0 }.children(root, Affine(None), 0)
}

struct Walk<'a, 'd, 'i> {
    draw: Draw<'a>,
    /// The elements that may be used, the first of each name.
    ids: HashMap<&'d str, Node<'d, 'i>>,
    count: usize,
    letters: usize,
}

impl Walk<'_, '_, '_> {
    fn children(&mut self, node: Node<'_, '_>, affine: Affine, depth: usize) -> Result<()> {
        node.children().filter(Node::is_element).try_for_each(|child| self.element(child, affine, depth))
    }

    fn element(&mut self, node: Node<'_, '_>, outer: Affine, depth: usize) -> Result<()> {
        let refused = |what: &str| Err(Problem::Syntax(what.to_owned()).at(place(node)));
        self.count += 1;
        if self.count > MOST {
            return refused("more elements are drawn than are read");
        }
        if depth > DEEPEST {
            return refused("elements are nested too deep, or use themselves");
        }
        let name = node.tag_name().name();
        let is_drawn = ["g", "a", "switch", "use", "svg"].contains(&name)
            || ["path", "line", "polyline", "polygon", "circle", "ellipse", "rect"].contains(&name);
        if !is_drawn || node.tag_name().namespace().is_some_and(|space| !space.ends_with("/svg")) {
            return Ok(());
        }
        let mut affine = outer;
        if let Some(text) = node.attribute("transform") {
            match text.parse::<Transform>() {
                Ok(transform) => affine = outer.after(transform),
                Err(error) => return refused(&format!("'transform': {error}")),
            }
        }
        if node.attribute("style").is_some_and(|style| style.contains("transform")) {
            return refused("transforms in 'style' are not read");
        }
        match name {
            "g" | "a" | "switch" => self.children(node, affine, depth + 1),
            "svg" => refused("a drawing in a drawing is not read"),
            "use" => self.used(node, affine, depth + 1),
            _ => {
                self.letters += node.range().len();
                match self.letters > MOST_LETTERS + node.document().input_text().len() {
                    true => refused("long elements are drawn more often than is read"),
                    false => (self.draw)(node, affine),
                }
            }
        }
    }

    fn used(&mut self, node: Node<'_, '_>, affine: Affine, depth: usize) -> Result<()> {
        let refused = |what: String| Err(Problem::Syntax(what).at(place(node)));
        let href = node.attributes().find(|attribute| attribute.name() == "href");
        let Some(id) = href.and_then(|href| href.value().strip_prefix('#')) else {
            return refused("'use' needs an element of this document".into());
        };
        let Some(target) = self.ids.get(id).copied() else {
            return refused(format!("there is no element '{}'", id.chars().take(40).collect::<String>()));
        };
        if target.tag_name().name() == "symbol" {
            return refused("symbols are not read".into());
        }
        let shift = |name: &str| node.attribute(name).map_or(Ok(0.0), str::parse::<f64>);
        match (shift("x"), shift("y")) {
            (Ok(0.0), Ok(0.0)) => self.element(target, affine, depth),
            (Ok(x), Ok(y)) => {
                let moved = affine.after(Transform { a: 1.0, b: 0.0, c: 0.0, d: 1.0, e: x, f: y });
                self.element(target, moved, depth)
            }
            _ => refused("'x' and 'y' of 'use' are to be numbers".into()),
        }
    }
}
