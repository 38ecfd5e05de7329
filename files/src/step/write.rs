//! Writing STEP.

use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use crate::nurbs::real::written;
use crate::nurbs::{Along, Nurbs};
use crate::step::text;

const HEADER: &str = "ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('splines'),'2;1');
FILE_NAME('','2000-01-01T00:00:00',(''),(''),'symspline','symspline','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('core data for automotive mechanical design processes');
#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('splines','splines','',(#3));
#5=PRODUCT_DEFINITION_FORMATION('','',#4);
#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7=PRODUCT_DEFINITION('design','',#5,#6);
#8=PRODUCT_DEFINITION_SHAPE('','',#7);
#9=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#10=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#11=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#12=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.0E-7),#9,'distance_accuracy_value','');
#13=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#12))GLOBAL_UNIT_ASSIGNED_CONTEXT((#9,#10,#11))REPRESENTATION_CONTEXT('',''));
#14=CARTESIAN_POINT('',(0.0,0.0,0.0));
#15=AXIS2_PLACEMENT_3D('',#14,$,$);
#16=PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#4));
";

/// The last number of the header.
const LAST: usize = 16;

/// The STEP file with these curves and surfaces.
///
/// # Errors
/// [`Problem::NoRoom`] for what is no curve or surface, for weights that are not positive, and for knots inside with more than `degree` copies;
/// [`Problem::Value`].
pub fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>> {
    let mut file = Instances { text: HEADER.to_owned(), last: LAST };
    let (mut curves, mut surfaces) = (Vec::new(), Vec::new());
    for (i, entry) in entries.iter().enumerate() {
        let told = Nurbs::of(&entry.value, "STEP").and_then(|told| match told.along.iter().all(joins) {
            true => Ok(told),
            false => {
                Err(Problem::NoRoom { format: "STEP", value: format!("{} with a jump", entry.value.kind()) })
            }
        });
        let told = told.map_err(|problem| problem.at(Place::Entry(format!("item {i}"))))?;
        let id = file.spline(&told, entry.name.as_deref().unwrap_or_default());
        if told.along.len() == 1 { curves.push(id) } else { surfaces.push(id) }
    }
    if !curves.is_empty() {
        file.set("GEOMETRIC_CURVE_SET", "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION", &curves);
    }
    if !surfaces.is_empty() {
        file.set("GEOMETRIC_SET", "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION", &surfaces);
    }
    file.text.push_str("ENDSEC;\nEND-ISO-10303-21;\n");
    Ok(file.text.into_bytes())
}

/// Whether no knot inside has more than `degree` copies.
fn joins(along: &Along) -> bool {
    let copies = along.multiplicities();
    copies[1..copies.len() - 1].iter().all(|(_, count)| *count <= along.degree)
}

struct Instances {
    text: String,
    last: usize,
}

impl Instances {
    fn put(&mut self, instance: &str) -> usize {
        self.last += 1;
        self.text.push_str(&format!("#{}={instance};\n", self.last));
        self.last
    }

    fn set(&mut self, kind: &str, representation: &str, items: &[usize]) {
        let set = self.put(&format!("{kind}('',{})", list(items.iter().map(reference))));
        let shape = self.put(&format!("{representation}('',(#{set},#15),#13)"));
        self.put(&format!("SHAPE_DEFINITION_REPRESENTATION(#8,#{shape})"));
    }

    fn spline(&mut self, told: &Nurbs, name: &str) -> usize {
        let points: Vec<String> = told
            .points()
            .map(|point| {
                let coords = list(Nurbs::in_space(point).into_iter().map(written));
                reference(&self.put(&format!("CARTESIAN_POINT('',{coords})")))
            })
            .collect();
        let name = text::written(name);
        let columns = told.along.get(1).map_or(points.len(), Along::count);
        // Of a curve the one row, of a surface the rows in a list.
        let grid = |items: Vec<String>| match told.along.len() {
            1 => list(items),
            _ => list(items.chunks(columns).map(list)),
        };
        let closed = |direction: usize| {
            let closed = told.along[direction].periodic || told.closes(direction);
            if closed { ".T." } else { ".F." }
        };
        let of = |item: &dyn Fn(&Along) -> String| told.along.iter().map(item).collect::<Vec<_>>().join(",");
        let degrees = of(&|along| along.degree.to_string());
        let copies = of(&|along| list(along.multiplicities().iter().map(|(_, count)| count)));
        let knots = of(&|along| list(along.multiplicities().iter().map(|(knot, _)| written(*knot))));
        let closed = (0..told.along.len()).map(closed).collect::<Vec<_>>().join(",");
        let kind = if told.along.len() == 1 { "CURVE" } else { "SURFACE" };
        let general = format!("{degrees},{},.UNSPECIFIED.,{closed},.U.", grid(points));
        let own = format!("{copies},{knots},.UNSPECIFIED.");
        self.put(&match &told.weights {
            None => format!("B_SPLINE_{kind}_WITH_KNOTS({name},{general},{own})"),
            Some(weights) => {
                let weights = grid(weights.iter().map(|w| written(*w)).collect());
                format!(
                    "(BOUNDED_{kind}()B_SPLINE_{kind}({general})B_SPLINE_{kind}_WITH_KNOTS({own}){}GEOMETRIC_REPRESENTATION_ITEM()\
                     RATIONAL_B_SPLINE_{kind}({weights})REPRESENTATION_ITEM({name}){})",
                    // The parts stand in the order of the alphabet.
                    if kind == "CURVE" { "CURVE()" } else { "" },
                    if kind == "CURVE" { "" } else { "SURFACE()" },
                )
            }
        })
    }
}

fn reference(id: &usize) -> String {
    format!("#{id}")
}

fn list(items: impl IntoIterator<Item = impl ToString>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    format!("({})", items.join(","))
}
