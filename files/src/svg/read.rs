//! Reading SVG.

use super::document::{Affine, draw_all, place};
use super::shape;
use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use roxmltree::{Document, Node, ParsingOptions};

/// How many nodes of a document are read at most.
const MOST: u32 = 1 << 24;

/// The outlines of a drawing, one curve for each subpath, in the order in which they are drawn.
///
/// # Errors
/// [`Problem::Syntax`] and [`Problem::Value`] with line and column: of the element, if it is about one.
pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>> {
    let text = std::str::from_utf8(bytes)
        .map_err(|error| Problem::Syntax("this is not UTF-8".into()).at(Place::Byte(error.valid_up_to())))?;
    // Drawing programs tell their document type. Entities are expanded within bounds.
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MOST, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let at = error.pos();
        let place = Place::Line { line: at.row as usize, column: at.col as usize };
        let text = error.to_string();
        let text = text.rsplit_once(" at ").map_or(text.as_str(), |(text, _)| text).to_owned();
        Problem::Syntax(text).at(place)
    })?;
    let mut entries = Vec::new();
    draw_all(&document, &mut |node: Node<'_, '_>, affine: Affine| {
        let at = |problem: Problem| problem.at(place(node));
        let name = node.attribute("data-name").or_else(|| node.attribute("id")).map(str::to_owned);
        for outline in shape::outlines(node).map_err(at)? {
            let drawn = outline.mapped(|p| affine.at(p));
            if let Some(value) = drawn.value().map_err(at)? {
                entries.push(Entry { name: name.clone(), value });
            }
        }
        Ok(())
    })?;
    Ok(entries)
}
