//! Interactive sculpting: grab a shape, drag it, let go, and take it back.

use crate::coeff::{Coeff, check_pair};
use crate::deform::bodies::Bodies;
use crate::deform::breadth::Breadth;
use crate::deform::elastic::{Elastic, Spread};
use crate::deform::forces::Forces;
use crate::deform::history::{Edit, History};
use crate::deform::material::Material;
use crate::deform::pull::Pull;
use crate::deform::reach::{Reach, knots_within};
use crate::deform::restorable::Restorable;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::tensor::along::Direction;

/// How many edits can be undone unless something else is said.
const LIMIT: usize = 100;

/// A shape in the hands of a sculptor: a curve or surface, polynomial or rational, what it is made of, and how far a grip reaches.
///
/// [`grab`](Self::grab) prepares a force at a place. [`drag_to`](Self::drag_to) and [`push`](Self::push) show the shape under it,
/// always starting from the shape that was grabbed: what is shown depends on the last target alone, and back at the start the
/// shape is what it was, bit by bit. [`commit`](Self::commit) keeps what is shown as one edit, [`cancel`](Self::cancel) drops it.
/// A drag costs one pass over the control points that move, and grabbing again with the same reach no new factorisation.
///
/// A sculptor is a value: a clone of it is a state to come back to. An operation that fails leaves it as it is.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Curve, Material, Q, Reach, Scalar, Sculptor, SplineSpace};
/// let points = (0..9).map(|i| vector![Q::int(i), Q::int(0)]).collect();
/// let line = Curve::new(SplineSpace::uniform(3, 6, Q::int(0), Q::int(6))?, points)?;
/// let mut sculptor = Sculptor::new(line.clone(), Material::new(Q::int(1), Q::int(2))?)
///     .with_reach([Reach::Nearest(5)])?;
///
/// sculptor.grab(&Q::frac(5, 2))?;
/// for height in 1..=3 {
///     sculptor.drag_to(&vector![Q::int(4), Q::int(height)])?;
/// }
/// assert!(sculptor.commit());
/// assert_eq!(sculptor.shape().at(&Q::frac(5, 2))?, vector![Q::int(4), Q::int(3)]);
/// assert_eq!(sculptor.shape().at(&Q::int(6))?, line.at(&Q::int(6))?);
///
/// assert!(sculptor.undo());
/// assert_eq!(sculptor.shape(), &line);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sculptor<T: Scalar, S: Restorable<T>> {
    shape: S,
    /// One for each direction.
    materials: Vec<Material<T>>,
    /// One for each direction.
    reach: Vec<Reach<T>>,
    spread: Spread,
    bodies: Bodies<T>,
    grip: Option<Grip<T, S>>,
    history: History<T, S>,
}

/// A shape that is held at a place.
#[derive(Clone, Debug)]
struct Grip<T: Scalar, S: Restorable<T>> {
    pull: Pull<T, S>,
    /// Where the place was.
    start: S::Point,
    /// The control points that move, as they were.
    before: Vec<(usize, S::Stored)>,
    force: S::Point,
}

impl<T: Scalar, S: Restorable<T>> Sculptor<T, S> {
    /// A shape of one material, all of which moves but the ends or edges.
    pub fn new(shape: S, material: Material<T>) -> Self {
        let directions = S::DIRECTIONS.len();
        Self {
            shape,
            materials: vec![material; directions],
            reach: vec![Reach::All; directions],
            spread: Spread::default(),
            bodies: Bodies::new(),
            grip: None,
            history: History::new(LIMIT),
        }
    }

    /// The same with a material for each direction.
    ///
    /// # Errors
    /// As [`set_materials`](Self::set_materials).
    pub fn with_materials(mut self, materials: impl IntoIterator<Item = Material<T>>) -> Result<Self> {
        self.set_materials(materials)?;
        Ok(self)
    }

    /// The same with a reach, or a [`Breadth`], for each direction.
    ///
    /// # Errors
    /// As [`set_reach`](Self::set_reach).
    pub fn with_reach<R: Into<Reach<T>>>(mut self, reach: impl IntoIterator<Item = R>) -> Result<Self> {
        self.set_reach(reach)?;
        Ok(self)
    }

    /// The same where forces are spread in this way.
    #[must_use]
    pub fn with_spread(mut self, spread: Spread) -> Self {
        self.set_spread(spread);
        self
    }

    /// The same with room for so many edits that can be undone; the oldest are forgotten first. It is 100 otherwise.
    #[must_use]
    pub fn with_limit(mut self, limit: usize) -> Self {
        self.history.keep(limit);
        self
    }

    /// Takes a material for each direction, from the next grip on.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one for each direction.
    pub fn set_materials(&mut self, materials: impl IntoIterator<Item = Material<T>>) -> Result<()> {
        self.materials = one_each::<T, S, _>(materials)?;
        Ok(())
    }

    /// Takes a reach, or a [`Breadth`], for each direction, from the next grip on.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one for each direction.
    pub fn set_reach<R: Into<Reach<T>>>(&mut self, reach: impl IntoIterator<Item = R>) -> Result<()> {
        self.reach = one_each::<T, S, _>(reach.into_iter().map(Into::into))?;
        Ok(())
    }

    /// Spreads forces in this way, from the next grip on.
    pub fn set_spread(&mut self, spread: Spread) {
        self.spread = spread;
    }

    /// The shape as it is shown, under the force of a grip if there is one.
    pub fn shape(&self) -> &S {
        &self.shape
    }

    /// The shape as it is shown.
    pub fn into_shape(self) -> S {
        self.shape
    }

    /// The force of the grip, prepared: where it acts, how the control points answer.
    pub fn pull(&self) -> Option<&Pull<T, S>> {
        self.grip.as_ref().map(|grip| &grip.pull)
    }

    /// Where the place that is held was when it was grabbed.
    pub fn start(&self) -> Option<&S::Point> {
        self.grip.as_ref().map(|grip| &grip.start)
    }

    /// The force under which the shape is shown.
    pub fn force(&self) -> Option<&S::Point> {
        self.grip.as_ref().map(|grip| &grip.force)
    }

    /// How many edits can be undone, and how many done again.
    pub fn edits(&self) -> (usize, usize) {
        self.history.counts()
    }

    /// How many control points along each direction a grip here would move: few mean that knots are missing.
    ///
    /// # Errors
    /// Those of [`Breadth::coeffs`], but for [`DeformError::NothingMoves`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Material, Reach, Sculptor, SplineSpace};
    /// let rod = Function::constant(SplineSpace::uniform(3, 10, 0.0, 1.0)?, 0.0)?;
    /// let mut sculptor = Sculptor::new(rod, Material::new(1.0, 1.0)?).with_reach([Reach::Within(0.25)])?;
    /// assert_eq!(sculptor.resolution(&0.5)?, [1]);
    /// sculptor.refine(&0.5, &[0.25], &[6])?;
    /// assert_eq!(sculptor.resolution(&0.5)?, [6]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn resolution(&self, at: &S::Parameter) -> Result<Vec<usize>> {
        let count = |(direction, breadth): (&Direction, Breadth<T>)| match breadth
            .coeffs(self.shape.space_along(*direction))
        {
            Ok(moving) => Ok(moving.len()),
            Err(Error::Deform(DeformError::NothingMoves)) => Ok(0),
            Err(other) => Err(other),
        };
        S::DIRECTIONS.iter().zip(self.breadths(at, &self.reach)?).map(count).collect()
    }

    /// The body that a grip here would have, for a set of [`Forces`].
    ///
    /// # Errors
    /// Those of [`Elastic::of`].
    pub fn elastic(&mut self, at: &S::Parameter) -> Result<Elastic<T>> {
        let breadths = self.breadths(at, &self.reach)?;
        Ok(self.bodies.of(&self.shape, &self.materials, &breadths, self.spread)?.clone())
    }

    /// Holds the shape at a place. What was held before is kept, as by [`commit`](Self::commit).
    ///
    /// # Errors
    /// Those of [`Elastic::of`] and of [`Elastic::pull`]; then what was held is still held.
    pub fn grab(&mut self, at: &S::Parameter) -> Result<&Pull<T, S>> {
        let breadths = self.breadths(at, &self.reach)?;
        let body = self.bodies.of(&self.shape, &self.materials, &breadths, self.spread)?;
        let pull = body.pull(&self.shape, at)?;
        let start = self.shape.derivative_of(at, S::VALUE)?;
        let stored = self.shape.stored();
        let before = pull.response().indices().iter().map(|i| (*i, stored[*i].clone())).collect();
        self.commit();
        let force = start.zero_like();
        Ok(&self.grip.insert(Grip { pull, start, before, force }).pull)
    }

    /// As [`grab`](Self::grab), with a reach of its own for each direction.
    ///
    /// # Errors
    /// As [`grab`](Self::grab); [`Error::CoefficientCount`] unless there is a reach for each direction.
    pub fn grab_with<R: Into<Reach<T>>>(
        &mut self,
        at: &S::Parameter,
        reach: impl IntoIterator<Item = R>,
    ) -> Result<&Pull<T, S>> {
        let reach = one_each::<T, S, _>(reach.into_iter().map(Into::into))?;
        let usual = std::mem::replace(&mut self.reach, reach);
        let grabbed = self.grab(at).map(|_| ());
        self.reach = usual;
        grabbed?;
        Ok(&self.grip.as_ref().expect("it was grabbed just now").pull)
    }

    /// Shows the shape with the place that is held at `target`, and returns the force that this takes.
    ///
    /// # Errors
    /// [`DeformError::NothingHeld`]; [`Error::NotFinite`], also on overflow; [`Error::Ragged`] for a row of another length than
    /// the control points.
    pub fn drag_to(&mut self, target: &S::Point) -> Result<S::Point> {
        let grip = self.grip.as_ref().ok_or(DeformError::NothingHeld)?;
        check_pair(&grip.start, target)?;
        let force = grip.pull.force_for(&target.minus(&grip.start));
        self.push(&force)?;
        Ok(force)
    }

    /// Shows the shape under `force` at the place that is held.
    ///
    /// # Errors
    /// As [`drag_to`](Self::drag_to).
    pub fn push(&mut self, force: &S::Point) -> Result<()> {
        let grip = self.grip.as_mut().ok_or(DeformError::NothingHeld)?;
        check_pair(&grip.start, force)?;
        let moved =
            |((i, stored), row): (&(usize, S::Stored), &[T])| (*i, S::moved(stored, &force.scaled(&row[0])));
        let rows = grip.pull.response().rows();
        self.shape.put(match force.vanishes() {
            // Adding zero would change the sign of a zero.
            true => grip.before.clone(),
            false => grip.before.iter().zip(rows).map(moved).collect(),
        })?;
        grip.force = force.clone();
        Ok(())
    }

    /// Lets go and keeps what is shown as one edit. Returns whether there is one: not if nothing was held, or under no force.
    pub fn commit(&mut self) -> bool {
        let pushed = self.grip.take().filter(|grip| !grip.force.vanishes());
        let before = pushed.map(|grip| grip.before);
        before.map(|before| self.history.push(Edit::Points(before))).is_some()
    }

    /// Lets go, and the shape is as it was when it was grabbed. Returns whether it was held.
    pub fn cancel(&mut self) -> bool {
        let Some(grip) = self.grip.take() else { return false };
        self.shape.put(grip.before).expect("these control points were there before");
        true
    }

    /// Takes back the last edit, or only lets go as by [`cancel`](Self::cancel) if the shape is held. Returns whether there was
    /// anything to take back.
    pub fn undo(&mut self) -> bool {
        self.cancel() || self.history.undo(&mut self.shape)
    }

    /// Does the last edit again that was undone. Returns whether there was one; while the shape is held nothing is done.
    pub fn redo(&mut self) -> bool {
        self.grip.is_none() && self.history.redo(&mut self.shape)
    }

    /// Moves control points, each by a vector, as one edit: what any other tool found out. What was held is kept.
    ///
    /// # Errors
    /// As [`Controlled::move_points`](crate::Controlled::move_points).
    pub fn move_points(&mut self, moves: &[(usize, S::Point)]) -> Result<()> {
        let mut indices: Vec<usize> = moves.iter().map(|(i, _)| *i).collect();
        indices.sort_unstable();
        indices.dedup();
        let stored = self.shape.stored();
        let before: Vec<_> = indices.into_iter().filter_map(|i| Some((i, stored.get(i)?.clone()))).collect();
        self.shape.move_points(moves)?;
        self.commit();
        if !before.is_empty() {
            self.history.push(Edit::Points(before));
        }
        Ok(())
    }

    /// Adds forces to those on the shape, as one edit. What was held is kept.
    ///
    /// # Errors
    /// As [`Forces::push`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Forces, Function, Material, Sculptor, SplineSpace};
    /// let rod = Function::constant(SplineSpace::uniform(3, 5, 0.0, 1.0)?, 0.0)?;
    /// let mut sculptor = Sculptor::new(rod, Material::new(1.0, 0.1)?);
    /// let elastic = sculptor.elastic(&0.5)?;
    /// let mut forces = Forces::new(&elastic, sculptor.shape())?;
    /// forces.at(&0.25, 3.0)?.at(&0.75, -3.0)?;
    /// sculptor.push_all(&forces)?;
    /// assert!(sculptor.shape().at(&0.25)? > 0.0 && sculptor.shape().at(&0.75)? < 0.0);
    /// assert!(sculptor.undo() && !sculptor.undo());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn push_all(&mut self, forces: &Forces<'_, T, S>) -> Result<()> {
        forces.elastic.check(&self.shape)?;
        self.move_points(&forces.displacements()?)
    }

    /// Inserts knots, as one edit, until along each direction at least so many control points have no influence farther from a
    /// place than a distance, and returns how many knots. What was held is kept.
    ///
    /// The ends of the interval become knots, then the middles of its longest spans. Nothing is inserted where there is room
    /// already. [`Reach::Within`] with the same distance has these control points.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is a distance and a count for each direction; [`Error::OutsideDomain`];
    /// [`Error::EmptyDomain`] for a distance that is not positive; [`Error::TooLarge`]; [`Error::SpanOutOfRange`] if floating
    /// point has no numbers left between two knots.
    pub fn refine(&mut self, at: &S::Parameter, distances: &[T], counts: &[usize]) -> Result<usize> {
        let distances = one_each::<T, S, _>(distances)?;
        let counts = one_each::<T, S, _>(counts)?;
        let each = S::DIRECTIONS.iter().zip(distances.into_iter().zip(counts));
        let knots = each.map(|(direction, (distance, count))| {
            let space = self.shape.space_along(*direction);
            Ok((*direction, knots_within(space, S::coordinate(at, *direction), distance, *count)?))
        });
        let knots = knots.collect::<Result<Vec<_>>>()?;
        let inserted = knots.iter().map(|(_, knots)| knots.len()).sum();
        if let Some((finer, edit)) = Edit::inserting(&self.shape, knots)? {
            self.commit();
            self.shape = finer;
            self.history.push(edit);
        }
        Ok(inserted)
    }

    /// The breadth of a grip here.
    fn breadths(&self, at: &S::Parameter, reach: &[Reach<T>]) -> Result<Vec<Breadth<T>>> {
        let breadth = |(direction, reach): (&Direction, &Reach<T>)| {
            reach.breadth(self.shape.space_along(*direction), S::coordinate(at, *direction))
        };
        S::DIRECTIONS.iter().zip(reach).map(breadth).collect()
    }
}

/// What was given, if there is one for each direction.
fn one_each<T: Scalar, S: Restorable<T>, X>(given: impl IntoIterator<Item = X>) -> Result<Vec<X>> {
    let expected = S::DIRECTIONS.len();
    // One more is enough to see that there are too many.
    let given: Vec<X> = given.into_iter().take(expected + 1).collect();
    match given.len() {
        found if found == expected => Ok(given),
        found => Err(Error::CoefficientCount { expected, found }),
    }
}
