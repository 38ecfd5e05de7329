//! Reading DXF.

use crate::dxf::entity::{Entity, cut_off};
use crate::dxf::groups::{Group, Groups};
use crate::entry::Entry;
use crate::error::{Problem, Result};
use crate::nurbs::real;

/// The kinds that are curves.
const CURVES: [&str; 6] = ["SPLINE", "LINE", "ARC", "CIRCLE", "ELLIPSE", "LWPOLYLINE"];

/// The longest name of a block, in bytes: all curves in it have it. The format has 255 letters, each of 7 bytes at most.
const LONGEST_BLOCK: usize = 255 * 7;

/// The curves of a DXF file, in the order of the file.
///
/// # Errors
/// [`Problem::Syntax`] and [`Problem::Value`] with the line: of a group that is wrong, or of an entity that is wrong as a whole.
pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>> {
    let mut drawing = Drawing::default();
    let mut groups = Groups::new(bytes)?;
    while let Some(group) = groups.next()? {
        match group.code {
            0 => {
                drawing.finish()?;
                if group.value.trim() == "EOF" {
                    return drawing.ended(group.line);
                }
                drawing.start(&group)?;
            }
            // A comment.
            999 => {}
            _ => drawing.add(group)?,
        }
    }
    Err(cut_off(groups.line(), "its end mark, EOF"))
}

#[derive(Default)]
struct Drawing<'a> {
    /// The section, if one is open, and its name once it is told.
    section: Option<String>,
    /// The name of the block, if one is open.
    block: Option<String>,
    /// What was started last: a curve, or a mark whose name comes.
    open: Open<'a>,
    entries: Vec<Entry>,
}

#[derive(Default)]
enum Open<'a> {
    #[default]
    Nothing,
    Section,
    Block,
    Curve(Entity<'a>),
}

impl<'a> Drawing<'a> {
    fn finish(&mut self) -> Result<()> {
        let Open::Curve(entity) = std::mem::take(&mut self.open) else { return Ok(()) };
        let value = match entity.kind.as_str() {
            "SPLINE" => entity.spline(),
            "LINE" => entity.line(),
            "ELLIPSE" => entity.ellipse(),
            "LWPOLYLINE" => entity.polyline(),
            _ => entity.arc(),
        }?;
        self.entries.push(Entry { name: entity.name(self.block.as_deref()), value });
        Ok(())
    }

    fn start(&mut self, group: &Group<'a>) -> Result<()> {
        let kind = group.value.trim();
        let wrong = |what: &str| Err(Problem::Syntax(what.to_owned()).at_line(group.line));
        match (kind, self.section.as_deref()) {
            ("SECTION", Some(_)) => return wrong("a section begins before the last one ends"),
            ("SECTION", None) => (self.section, self.open) = (Some(String::new()), Open::Section),
            ("ENDSEC", None) => return wrong("a section ends that has not begun"),
            ("ENDSEC", Some(_)) => (self.section, self.block) = (None, None),
            (_, None) => {
                let kind = real::shown(kind);
                return wrong(&format!("'{kind}' stands outside of all sections"));
            }
            ("BLOCK", Some("BLOCKS")) => self.open = Open::Block,
            ("ENDBLK", Some("BLOCKS")) => self.block = None,
            (kind, Some("BLOCKS" | "ENTITIES")) if CURVES.contains(&kind) => {
                let entity = Entity { kind: kind.to_owned(), line: group.line, groups: Vec::new() };
                self.open = Open::Curve(entity);
            }
            _ => {}
        }
        Ok(())
    }

    fn add(&mut self, group: Group<'a>) -> Result<()> {
        match (&mut self.open, group.code) {
            (Open::Curve(entity), _) => entity.groups.push(group),
            (Open::Section, 2) => {
                (self.section, self.open) = (Some(group.value.trim().to_owned()), Open::Nothing);
            }
            (Open::Block, 2) if group.value.len() > LONGEST_BLOCK => {
                let wrong = format!("a block has a name of {} bytes", group.value.len());
                return Err(Problem::Syntax(wrong).at_line(group.line));
            }
            (Open::Block, 2) => {
                (self.block, self.open) = (Some(group.value.trim().to_owned()), Open::Nothing);
            }
            _ => {}
        }
        Ok(())
    }

    fn ended(self, line: usize) -> Result<Vec<Entry>> {
        match self.section {
            Some(section) => Err(cut_off(line, &format!("the section {} does", real::shown(&section)))),
            None => Ok(self.entries),
        }
    }
}
