//! Writing DXF.

use crate::dxf::{APPLICATION, flags};
use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use crate::nurbs::Nurbs;
use crate::nurbs::real::written;
use std::fmt::Display;

/// The longest text of extended data, in bytes.
const LONGEST_NAME: usize = 255;

/// The handle of the block that is the drawing.
const MODEL_SPACE: &str = "1F";

/// The first handle that no table has.
const FIRST_HANDLE: usize = 0x100;

/// The DXF file with these curves as SPLINE entities.
///
/// # Errors
/// [`Problem::NoRoom`] for what is no curve, for weights that are not positive, and for names with line breaks or beyond 255 bytes;
/// [`Problem::Value`].
pub fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>> {
    let mut file = Pairs::default();
    file.header(entries.len());
    file.tables();
    file.blocks();
    file.section("ENTITIES");
    for (i, entry) in entries.iter().enumerate() {
        let told = Nurbs::of(&entry.value, "DXF").and_then(|told| match told.along.len() {
            1 => Ok(told),
            _ => Err(Problem::NoRoom { format: "DXF", value: entry.value.kind().to_owned() }),
        });
        told.and_then(|told| file.spline(FIRST_HANDLE + i, &told, entry.name.as_deref()))
            .map_err(|problem| problem.at(Place::Entry(format!("item {i}"))))?;
    }
    file.put(0, "ENDSEC");
    file.objects();
    file.put(0, "EOF");
    Ok(file.text.into_bytes())
}

/// A record of a table: its kind, its class, its handle, and the pairs after those.
type Record<'a> = (&'a str, &'a str, &'a str, &'a [(i32, &'a str)]);

#[derive(Default)]
struct Pairs {
    text: String,
}

impl Pairs {
    fn put(&mut self, code: i32, value: impl Display) {
        self.text.push_str(&format!("{code:>3}\n{value}\n"));
    }

    fn all(&mut self, pairs: &[(i32, &str)]) {
        pairs.iter().for_each(|(code, value)| self.put(*code, value));
    }

    fn section(&mut self, name: &str) {
        self.all(&[(0, "SECTION"), (2, name)]);
    }

    fn header(&mut self, count: usize) {
        self.section("HEADER");
        self.all(&[(9, "$ACADVER"), (1, "AC1021"), (9, "$DWGCODEPAGE"), (3, "ANSI_1252"), (9, "$HANDSEED")]);
        self.put(5, format_args!("{:X}", FIRST_HANDLE + count));
        self.put(0, "ENDSEC");
    }

    /// The tables that every drawing has, with the entries that every drawing has.
    fn tables(&mut self) {
        self.section("TABLES");
        self.table("VPORT", "8", &[]);
        let line = |name| vec![(2, name), (70, "0"), (3, ""), (72, "65"), (73, "0"), (40, "0.0")];
        let (block, layer, solid) = (line("ByBlock"), line("ByLayer"), line("Continuous"));
        let lines = [("14", block.as_slice()), ("15", &layer), ("16", &solid)];
        self.table(
            "LTYPE",
            "5",
            &lines.map(|(handle, rest)| ("LTYPE", "AcDbLinetypeTableRecord", handle, rest)),
        );
        let zero = [(2, "0"), (70, "0"), (62, "7"), (6, "Continuous")];
        self.table("LAYER", "2", &[("LAYER", "AcDbLayerTableRecord", "10", &zero)]);
        let letters = [
            (2, "Standard"),
            (70, "0"),
            (40, "0.0"),
            (41, "1.0"),
            (50, "0.0"),
            (71, "0"),
            (42, "2.5"),
            (3, "txt"),
            (4, ""),
        ];
        self.table("STYLE", "3", &[("STYLE", "AcDbTextStyleTableRecord", "11", &letters)]);
        self.table("VIEW", "6", &[]);
        self.table("UCS", "7", &[]);
        let applications = [("12", [(2, "ACAD"), (70, "0")]), ("13", [(2, APPLICATION), (70, "0")])];
        let records = applications
            .each_ref()
            .map(|(handle, rest)| ("APPID", "AcDbRegAppTableRecord", *handle, rest.as_slice()));
        self.table("APPID", "9", &records);
        let standard = [(2, "Standard"), (70, "0")];
        self.table("DIMSTYLE", "A", &[("DIMSTYLE", "AcDbDimStyleTableRecord", "27", &standard)]);
        let model = [(2, "*Model_Space"), (340, "22")];
        let paper = [(2, "*Paper_Space"), (340, "1E")];
        let records = [(MODEL_SPACE, &model), ("1B", &paper)];
        let records =
            records.map(|(handle, rest)| ("BLOCK_RECORD", "AcDbBlockTableRecord", handle, rest.as_slice()));
        self.table("BLOCK_RECORD", "1", &records);
        self.put(0, "ENDSEC");
    }

    fn table(&mut self, name: &str, handle: &str, records: &[Record<'_>]) {
        self.all(&[(0, "TABLE"), (2, name), (5, handle), (330, "0"), (100, "AcDbSymbolTable")]);
        self.put(70, records.len());
        if name == "DIMSTYLE" {
            self.put(100, "AcDbDimStyleTable");
        }
        for (kind, class, record, rest) in records {
            // The handle of a style of dimensions has another code, since 5 was in use.
            let code = if *kind == "DIMSTYLE" { 105 } else { 5 };
            self.all(&[
                (0, kind),
                (code, record),
                (330, handle),
                (100, "AcDbSymbolTableRecord"),
                (100, class),
            ]);
            self.all(rest);
        }
        self.put(0, "ENDTAB");
    }

    fn blocks(&mut self) {
        self.section("BLOCKS");
        for (name, record, begin, end) in
            [("*Model_Space", MODEL_SPACE, "20", "21"), ("*Paper_Space", "1B", "1C", "1D")]
        {
            self.all(&[(0, "BLOCK"), (5, begin), (330, record), (100, "AcDbEntity"), (8, "0")]);
            self.all(&[(100, "AcDbBlockBegin"), (2, name), (70, "0"), (10, "0.0"), (20, "0.0"), (30, "0.0")]);
            self.all(&[(3, name), (1, ""), (0, "ENDBLK"), (5, end), (330, record)]);
            self.all(&[(100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockEnd")]);
        }
        self.put(0, "ENDSEC");
    }

    /// The dictionaries that every drawing has, and the layouts of its two blocks.
    fn objects(&mut self) {
        self.section("OBJECTS");
        self.all(&[(0, "DICTIONARY"), (5, "C"), (330, "0"), (100, "AcDbDictionary"), (281, "1")]);
        self.all(&[(3, "ACAD_GROUP"), (350, "D"), (3, "ACAD_LAYOUT"), (350, "1A")]);
        self.all(&[(0, "DICTIONARY"), (5, "D"), (330, "C"), (100, "AcDbDictionary"), (281, "1")]);
        self.all(&[(0, "DICTIONARY"), (5, "1A"), (330, "C"), (100, "AcDbDictionary"), (281, "1")]);
        self.all(&[(3, "Layout1"), (350, "1E"), (3, "Model"), (350, "22")]);
        for (name, handle, order, block) in [("Layout1", "1E", "1", "1B"), ("Model", "22", "0", MODEL_SPACE)]
        {
            self.all(&[(0, "LAYOUT"), (5, handle), (330, "1A"), (100, "AcDbPlotSettings"), (1, "")]);
            self.all(&[(100, "AcDbLayout"), (1, name), (70, "1"), (71, order), (330, block)]);
        }
        self.put(0, "ENDSEC");
    }

    fn point(&mut self, code: i32, [x, y, z]: [f64; 3]) {
        self.put(code, written(x));
        self.put(code + 10, written(y));
        self.put(code + 20, written(z));
    }

    fn spline(
        &mut self,
        handle: usize,
        told: &Nurbs,
        name: Option<&str>,
    ) -> std::result::Result<(), Problem> {
        let (along, plane) = (&told.along[0], told.dim == 2);
        self.put(0, "SPLINE");
        self.put(5, format_args!("{handle:X}"));
        self.all(&[(330, MODEL_SPACE), (100, "AcDbEntity"), (8, "0"), (100, "AcDbSpline")]);
        if plane {
            self.point(210, [0.0, 0.0, 1.0]);
        }
        let periodic = if along.periodic { flags::CLOSED | flags::PERIODIC } else { 0 };
        let rational = if told.weights.is_some() { flags::RATIONAL } else { 0 };
        self.put(70, periodic | rational | if plane { flags::PLANAR } else { 0 });
        self.put(71, along.degree);
        self.put(72, along.knots.len());
        self.put(73, along.count());
        self.all(&[(74, "0"), (42, "1.0E-9"), (43, "1.0E-10")]);
        along.knots.iter().for_each(|t| self.put(40, written(*t)));
        told.weights.iter().flatten().for_each(|w| self.put(41, written(*w)));
        told.points().for_each(|point| self.point(10, Nurbs::in_space(point)));
        match name {
            Some(name)
                if name.len() > LONGEST_NAME
                    || name.chars().any(char::is_control)
                    || name.contains("\\U+") =>
            {
                Err(Problem::NoRoom { format: "DXF", value: format!("name {name:?}") })
            }
            Some(name) => {
                self.put(1001, APPLICATION);
                self.put(1000, name);
                Ok(())
            }
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dxf::from_bytes;
    use symspline::SplineSpace;
    use symspline_dynamic::{AnySpline, AnySurface, Over};

    fn line(dim: usize) -> AnySpline {
        let space = SplineSpace::bezier(1, 0.0, 0.1).unwrap();
        let coords = [0.1, -0.0, 0.0, 5e-324, 1e300, 0.0];
        AnySpline::new(space.into(), dim, Over::Float(coords[..2 * dim].to_vec())).unwrap()
    }

    #[test]
    fn plane_curves_and_curves_in_space_whose_z_is_zero_are_told_apart() {
        let space = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
        let flat = AnySpline::new(space.into(), 3, Over::Float(vec![1.0, 2.0, 0.0, 3.0, 4.0, 0.0])).unwrap();
        let entries = [Entry::from(line(2)), Entry::named("a \"name\" é", flat), Entry::from(line(3))];
        assert_eq!(from_bytes(&to_bytes(&entries).unwrap()).unwrap(), entries);
    }

    #[test]
    fn what_has_no_room_is_refused_by_its_number() {
        let space = || SplineSpace::bezier(1, 0.0, 1.0).unwrap().into();
        let surface = AnySurface::new(space(), space(), 3, Over::Float(vec![0.0; 12])).unwrap();
        let entries = [Entry::from(line(2)), Entry::from(surface)];
        assert_eq!(to_bytes(&entries).unwrap_err().to_string(), "input: item 1: DXF files hold no surface");
        for name in ["a\nb".to_owned(), "\\U+0041".to_owned(), "x".repeat(256)] {
            assert!(
                matches!(to_bytes(&[Entry::named(name, line(2))]), Err(error) if error.to_string().contains("name"))
            );
        }
    }
}
