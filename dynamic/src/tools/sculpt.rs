//! Shapes in the hands of a sculptor.

use crate::error::{Error, Result};
use crate::number::Field;
use crate::over::Coords;
use crate::shape;
use crate::tools::edit::{AnyDrag, Of};
use crate::tools::elastic::{AnyBreadth, AnyElastic, Pulls, material};
use crate::tools::forces::{Load, Loaded};
use crate::tools::shape::{At, all_points, coords, place, point};
use crate::value::Value;
use std::fmt::Debug;
use symspline::{Drag, Elastic, Material, Reach, Sculptor, Spread};

/// A shape in the hands of a sculptor; see [`Sculptor`].
pub trait Sculpts: Debug + Send + Sync {
    /// The shape as it is shown.
    fn shape(&self) -> Value;
    /// Holds the shape at a place.
    ///
    /// # Errors
    /// Those of [`Sculptor::grab`].
    fn grab(&mut self, at: &Coords, reach: Option<&[AnyBreadth]>) -> Result<()>;
    /// Takes the place that is held to a target; the force.
    ///
    /// # Errors
    /// Those of [`Sculptor::drag_to`].
    fn drag_to(&mut self, target: &Coords) -> Result<Coords>;
    /// Shows the shape under a force.
    ///
    /// # Errors
    /// Those of [`Sculptor::push`].
    fn push(&mut self, force: &Coords) -> Result<()>;
    /// Keeps what is shown.
    fn commit(&mut self) -> bool;
    /// Lets go.
    fn cancel(&mut self) -> bool;
    /// Takes back the last edit.
    fn undo(&mut self) -> bool;
    /// Does it again.
    fn redo(&mut self) -> bool;
    /// How many edits can be undone and done again.
    fn edits(&self) -> (usize, usize);
    /// How many control points a grip here would move.
    ///
    /// # Errors
    /// Those of [`Sculptor::resolution`].
    fn resolution(&self, at: &Coords) -> Result<Vec<usize>>;
    /// Inserts knots near a place.
    ///
    /// # Errors
    /// Those of [`Sculptor::refine`].
    fn refine(&mut self, at: &Coords, distances: &Coords, counts: &[usize]) -> Result<usize>;
    /// Moves control points by vectors.
    ///
    /// # Errors
    /// Those of [`Sculptor::move_points`].
    fn move_points(&mut self, indices: &[usize], by: &Coords) -> Result<()>;
    /// Adds forces of a body.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`Sculptor::push_all`].
    fn push_all(&mut self, body: &AnyElastic, load: &Load) -> Result<()>;
    /// The body that a grip here would have.
    ///
    /// # Errors
    /// Those of [`Sculptor::elastic`].
    fn elastic(&mut self, at: &Coords) -> Result<AnyElastic>;
    /// The force of the grip, prepared.
    fn pull(&self) -> Option<Box<dyn Pulls>>;
    /// Where the place that is held was, and the force under which the shape is shown.
    fn held(&self) -> Option<(Coords, Coords)>;
    /// Takes other materials, another reach and another spread, from the next grip on.
    ///
    /// # Errors
    /// Those of [`Sculptor::set_materials`] and [`Sculptor::set_reach`].
    fn set(
        &mut self,
        materials: Option<&[Coords]>,
        reach: Option<&[AnyBreadth]>,
        spread: Option<Spread>,
    ) -> Result<()>;
}

fn reaches<T: Field>(reach: &[AnyBreadth]) -> Result<Vec<Reach<T>>> {
    reach.iter().map(AnyBreadth::reach).collect()
}

impl<T: Field, S: Loaded<T>> Sculpts for Sculptor<T, S>
where
    AnyElastic: Of<T, Inner = Elastic<T>> + From<Elastic<T>>,
    AnyDrag: From<Drag<T>>,
    S::Parameter: At<T>,
{
    fn shape(&self) -> Value {
        Self::shape(self).clone().value()
    }

    fn grab(&mut self, at: &Coords, reach: Option<&[AnyBreadth]>) -> Result<()> {
        let at = place(at)?;
        match reach {
            Some(reach) => self.grab_with(&at, reaches(reach)?)?,
            None => Self::grab(self, &at)?,
        };
        Ok(())
    }

    fn drag_to(&mut self, target: &Coords) -> Result<Coords> {
        Ok(coords::<T, _>(&Self::drag_to(self, &point(target)?)?))
    }

    fn push(&mut self, force: &Coords) -> Result<()> {
        Ok(Self::push(self, &point(force)?)?)
    }

    fn commit(&mut self) -> bool {
        Self::commit(self)
    }

    fn cancel(&mut self) -> bool {
        Self::cancel(self)
    }

    fn undo(&mut self) -> bool {
        Self::undo(self)
    }

    fn redo(&mut self) -> bool {
        Self::redo(self)
    }

    fn edits(&self) -> (usize, usize) {
        Self::edits(self)
    }

    fn resolution(&self, at: &Coords) -> Result<Vec<usize>> {
        Ok(Self::resolution(self, &place(at)?)?)
    }

    fn refine(&mut self, at: &Coords, distances: &Coords, counts: &[usize]) -> Result<usize> {
        Ok(Self::refine(self, &place(at)?, &T::all_of(distances)?, counts)?)
    }

    fn move_points(&mut self, indices: &[usize], by: &Coords) -> Result<()> {
        let by: Vec<S::Point> = all_points(by)?;
        if by.len() != indices.len() {
            return Err(Error::Dimensions { left: indices.len(), right: by.len() });
        }
        Ok(Self::move_points(self, &indices.iter().copied().zip(by).collect::<Vec<_>>())?)
    }

    fn push_all(&mut self, body: &AnyElastic, load: &Load) -> Result<()> {
        let body = Of::<T>::of(body)?;
        let forces = load.of(body, Self::shape(self))?;
        Ok(Self::push_all(self, &forces)?)
    }

    fn elastic(&mut self, at: &Coords) -> Result<AnyElastic> {
        Ok(Self::elastic(self, &place(at)?)?.into())
    }

    fn pull(&self) -> Option<Box<dyn Pulls>> {
        Some(Box::new(Self::pull(self)?.clone()))
    }

    fn held(&self) -> Option<(Coords, Coords)> {
        Some((coords::<T, _>(self.start()?), coords::<T, _>(self.force()?)))
    }

    fn set(
        &mut self,
        materials: Option<&[Coords]>,
        reach: Option<&[AnyBreadth]>,
        spread: Option<Spread>,
    ) -> Result<()> {
        if let Some(all) = materials {
            self.set_materials(all.iter().map(material).collect::<Result<Vec<_>>>()?)?;
        }
        if let Some(reach) = reach {
            self.set_reach(reaches(reach)?)?;
        }
        if let Some(spread) = spread {
            self.set_spread(spread);
        }
        Ok(())
    }
}

/// A shape of a material in the hands of a sculptor; see [`Sculptor`].
///
/// # Errors
/// [`Error::NoSuch`], and those of [`Sculptor::with_reach`].
pub fn sculptor(
    shape: &Value,
    materials: &[Coords],
    reach: Option<&[AnyBreadth]>,
    spread: Spread,
    limit: Option<usize>,
) -> Result<Box<dyn Sculpts>> {
    fn of<T: Field, S: Loaded<T>>(
        shape: &S,
        materials: &[Coords],
        reach: Option<&[AnyBreadth]>,
        spread: Spread,
        limit: Option<usize>,
    ) -> Result<Sculptor<T, S>> {
        let all = materials.iter().map(material).collect::<Result<Vec<Material<T>>>>()?;
        let Some(first) = all.first() else {
            return Err(Error::Dimensions { left: 1, right: 0 });
        };
        let mut found = Sculptor::new(shape.clone(), first.clone()).with_spread(spread);
        if all.len() > 1 {
            found = found.with_materials(all)?;
        }
        if let Some(reach) = reach {
            found = found.with_reach(reaches::<T>(reach)?)?;
        }
        Ok(match limit {
            Some(limit) => found.with_limit(limit),
            None => found,
        })
    }
    shape!(shape, "sculptor", T, s => Ok(Box::new(of::<T, _>(s, materials, reach, spread, limit)?) as Box<dyn Sculpts>))
}
