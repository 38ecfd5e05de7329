//! Curves and surfaces as elastic bodies: pulls, forces, anchors.

use crate::each;
use crate::error::{Error, Result};
use crate::number::{Field, Number, flat};
use crate::over::{Coords, Over};
use crate::shape;
use crate::tools::constraints::{Rows, Wishes, rows};
use crate::tools::edit::{AnyDrag, Of};
use crate::tools::forces::{Load, Loaded};
use crate::tools::shape::{Shape, all_points, coords, place, point};
use crate::value::Value;
use std::fmt::Debug;
use symspline::{Anchored, Breadth, Drag, Elastic, FullEnergy, Material, Pull, Q, Reach, Spread};

/// Which coefficients may move, or how far a grip reaches; see [`Breadth`] and [`Reach`].
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "as in Breadth and Reach")]
pub enum AnyBreadth {
    Whole,
    BetweenEnds(usize),
    Range(usize, usize),
    Around(Number, usize),
    Within(Number, Number),
    Listed(Vec<usize>),
    All,
    Nearest(usize),
    Distance(Number),
}

impl AnyBreadth {
    pub(crate) fn of<T: Field>(&self) -> Result<Breadth<T>> {
        Ok(match self {
            Self::Whole => Breadth::Whole,
            Self::All => Breadth::BetweenEnds(1),
            Self::BetweenEnds(n) => Breadth::BetweenEnds(*n),
            Self::Range(a, b) => Breadth::Range(*a..*b),
            Self::Around(x, n) => Breadth::Around(T::of(x)?, *n),
            Self::Within(a, b) => Breadth::Within(T::of(a)?, T::of(b)?),
            Self::Listed(all) => Breadth::Listed(all.clone()),
            Self::Nearest(_) | Self::Distance(_) => {
                return Err(Error::NoSuch {
                    operation: "breadth",
                    left: String::from("a reach, which goes with the place of a grip"),
                    right: String::new(),
                });
            }
        })
    }

    pub(crate) fn reach<T: Field>(&self) -> Result<Reach<T>> {
        Ok(match self {
            Self::All => Reach::All,
            Self::Nearest(n) => Reach::Nearest(*n),
            Self::Distance(d) => Reach::Within(T::of(d)?),
            breadth => Reach::Fixed(breadth.of()?),
        })
    }
}

/// Weights of the derivatives of order 0, 1, 2 and so on; see [`Material`].
pub fn material<T: Field>(weights: &Coords) -> Result<Material<T>> {
    Ok(Material::of_orders(T::all_of(weights)?)?)
}

/// What the shape costs, of a surface by the materials along both directions; see [`Material::energy`] and
/// [`FullEnergy::of_materials`].
///
/// # Errors
/// [`Error::NoSuch`] for rational shapes, and those of the library.
pub fn energy(shape: &Value, materials: &[Coords]) -> Result<Number> {
    match (shape, materials) {
        (Value::Spline(any), [one]) => each!(any, T, s => Ok(material::<T>(one)?.energy(s)?.number())),
        (Value::Surface(any), [u, v]) => {
            each!(any, T, s => Ok(FullEnergy::of_materials(&material::<T>(u)?, &material(v)?)?.energy(s)?.number()))
        }
        (Value::Surface(_), [one]) => energy(shape, &[one.clone(), one.clone()]),
        _ => Err(shape.none_of("energy")),
    }
}

/// An elastic body; see [`Elastic`].
pub type AnyElastic = Over<Elastic<f64>, Elastic<Q>>;

impl From<Elastic<f64>> for AnyElastic {
    fn from(elastic: Elastic<f64>) -> Self {
        Self::Float(elastic)
    }
}

impl From<Elastic<Q>> for AnyElastic {
    fn from(elastic: Elastic<Q>) -> Self {
        Self::Exact(elastic)
    }
}

/// A force at one place, prepared; see [`Pull`].
pub trait Pulls: Debug + Send + Sync {
    /// How far the point moves under a unit force.
    fn give(&self) -> Number;

    /// How the control points answer a unit force.
    fn response(&self) -> AnyDrag;

    /// The force that moves the point by a vector.
    ///
    /// # Errors
    /// [`Error::Dimensions`].
    fn force_for(&self, change: &Coords) -> Result<Coords>;

    /// The shape under a further force.
    ///
    /// # Errors
    /// Those of [`Pull::push`].
    fn pushed(&self, shape: &Value, force: &Coords) -> Result<Value>;

    /// The shape with the point at a target, and the force that this took.
    ///
    /// # Errors
    /// Those of [`Pull::move_to`].
    fn moved_to(&self, shape: &Value, target: &Coords) -> Result<(Value, Coords)>;
}

impl<T: Field, S: Shape<T>> Pulls for Pull<T, S>
where
    AnyDrag: From<Drag<T>>,
{
    fn give(&self) -> Number {
        Self::give(self).clone().number()
    }

    fn response(&self) -> AnyDrag {
        Self::response(self).clone().into()
    }

    fn force_for(&self, change: &Coords) -> Result<Coords> {
        Ok(coords::<T, _>(&Self::force_for(self, &point(change)?)))
    }

    fn pushed(&self, shape: &Value, force: &Coords) -> Result<Value> {
        let mut shape = S::inside(shape)?.clone();
        self.push(&mut shape, &point(force)?)?;
        Ok(shape.value())
    }

    fn moved_to(&self, shape: &Value, target: &Coords) -> Result<(Value, Coords)> {
        let mut shape = S::inside(shape)?.clone();
        let force = self.move_to(&mut shape, &point(target)?)?;
        Ok((shape.value(), coords::<T, _>(&force)))
    }
}

/// A shape, and the forces that it took.
pub type Moved = (Value, Coords);

/// Constraints at least energy; see [`Anchored`].
pub trait Anchors: Debug + Send + Sync {
    /// The rows of the constraints.
    fn rows(&self) -> Rows;

    /// The shape with the constrained values changed, and the forces.
    ///
    /// # Errors
    /// Those of [`Anchored::drag`].
    fn dragged(&self, shape: &Value, changes: &Coords) -> Result<Moved>;

    /// The shape with the constrained values given, and the forces.
    ///
    /// # Errors
    /// Those of [`Anchored::meet`].
    fn met(&self, shape: &Value, targets: &Coords) -> Result<Moved>;

    /// The shape under further forces, the constrained values as they were, and the forces that hold them.
    ///
    /// # Errors
    /// Those of [`Anchored::push`].
    fn pushed(&self, shape: &Value, load: &Load) -> Result<Moved>;

    /// The shape with the constrained values on a curve at even parameters, and the forces.
    ///
    /// # Errors
    /// [`Error::NoSuch`], and those of [`Anchored::meet_curve`].
    fn met_curve(&self, shape: &Value, target: &Value) -> Result<Moved>;

    /// The shape without other forces, and the forces that hold it.
    ///
    /// # Errors
    /// Those of [`Anchored::relax`].
    fn relaxed(&self, shape: &Value) -> Result<Moved>;
}

#[derive(Debug)]
struct Anchor<T: Field, S: Shape<T>> {
    body: Elastic<T>,
    held: Anchored<T, S>,
}

impl<T: Field, S: Shape<T>> Anchor<T, S> {
    fn edit(
        &self,
        shape: &Value,
        edit: impl FnOnce(&mut S) -> Result<Vec<S::Point>>,
    ) -> Result<(Value, Coords)> {
        let mut shape = S::inside(shape)?.clone();
        let forces = edit(&mut shape)?;
        Ok((shape.value(), flat::<T, _>(&forces)))
    }
}

impl<T: Field, S: Loaded<T>> Anchors for Anchor<T, S> {
    fn rows(&self) -> Rows {
        rows(self.held.rows())
    }

    fn dragged(&self, shape: &Value, changes: &Coords) -> Result<Moved> {
        let changes = all_points(changes)?;
        self.edit(shape, |s| Ok(self.held.drag(s, &changes)?))
    }

    fn met(&self, shape: &Value, targets: &Coords) -> Result<Moved> {
        let targets = all_points(targets)?;
        self.edit(shape, |s| Ok(self.held.meet(s, &targets)?))
    }

    fn pushed(&self, shape: &Value, load: &Load) -> Result<Moved> {
        let forces = load.of(&self.body, S::inside(shape)?)?;
        self.edit(shape, |s| Ok(self.held.push(s, &forces)?))
    }

    fn met_curve(&self, shape: &Value, target: &Value) -> Result<Moved> {
        let target = S::target(target)?;
        self.edit(shape, |s| Ok(self.held.meet_curve(s, target)?))
    }

    fn relaxed(&self, shape: &Value) -> Result<Moved> {
        self.edit(shape, |s| Ok(self.held.relax(s)?))
    }
}

impl AnyElastic {
    /// The body of a shape: a material for each direction or one for both, a breadth for each direction.
    ///
    /// # Errors
    /// [`Error::NoSuch`], and those of [`Elastic::with_materials`].
    pub fn of_shape(
        shape: &Value,
        materials: &[Coords],
        breadths: &[AnyBreadth],
        spread: Spread,
    ) -> Result<Self> {
        fn of<T: Field, S: Shape<T>>(
            shape: &S,
            materials: &[Coords],
            breadths: &[AnyBreadth],
            spread: Spread,
        ) -> Result<Elastic<T>> {
            let breadths = breadths.iter().map(AnyBreadth::of).collect::<Result<Vec<_>>>()?;
            let body = match materials {
                [one] => Elastic::of(shape, &material(one)?, &breadths)?,
                all => {
                    let all = all.iter().map(material).collect::<Result<Vec<_>>>()?;
                    Elastic::with_materials(shape, &all, &breadths)?
                }
            };
            Ok(body.with_spread(spread))
        }
        shape!(shape, "elastic body", T, s => Ok(of::<T, _>(s, materials, breadths, spread)?.into()))
    }

    /// The control points that may move, along each direction.
    pub fn moving(&self) -> Vec<Vec<usize>> {
        crate::both!(self, e => e.stiffnesses().iter().map(|s| s.moving().to_vec()).collect())
    }

    /// For each direction the answer of the coefficients to a force spread by hats at a parameter.
    ///
    /// # Errors
    /// Those of [`Stiffness::response`](symspline::Stiffness::response).
    pub fn responses(&self, at: &Coords) -> Result<Vec<Coords>> {
        fn of<T: Field>(body: &Elastic<T>, at: &Coords) -> Result<Vec<Coords>> {
            let answer = |(s, x): (&symspline::Stiffness<T>, &T)| Ok(T::coords(s.response(&s.hat_load(x)?)?));
            body.stiffnesses().iter().zip(&T::all_of(at)?).map(answer).collect()
        }
        crate::both!(self, e => of(e, at))
    }

    /// A force at a place of a shape, prepared.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`Elastic::pull`].
    pub fn pull_at(&self, shape: &Value, at: &Coords) -> Result<Box<dyn Pulls>> {
        shape!(shape, "pull", T, s => Ok(Box::new(Of::<T>::of(self)?.pull(s, &place(at)?)?) as Box<dyn Pulls>))
    }

    /// The shape under further forces.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`Forces::push`](symspline::Forces::push).
    pub fn pushed(&self, shape: &Value, load: &Load) -> Result<Value> {
        shape!(shape, "push", T, s => {
            let mut moved = s.clone();
            load.of::<T, _>(Of::<T>::of(self)?, s)?.push(&mut moved)?;
            Ok(moved.value())
        })
    }

    /// The displacements of control points under forces.
    ///
    /// # Errors
    /// As [`pushed`](Self::pushed).
    pub fn displacements(&self, shape: &Value, load: &Load) -> Result<(Vec<usize>, Coords)> {
        fn of<T: Field, S: Loaded<T>>(body: &Elastic<T>, s: &S, load: &Load) -> Result<(Vec<usize>, Coords)> {
            let (places, points): (Vec<usize>, Vec<S::Point>) =
                load.of(body, s)?.displacements()?.into_iter().unzip();
            Ok((places, flat::<T, _>(&points)))
        }
        shape!(shape, "displacements", T, s => of(Of::<T>::of(self)?, s, load))
    }

    /// The load of each control point that forces are.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`Forces::load`](symspline::Forces::load).
    pub fn load(&self, shape: &Value, load: &Load) -> Result<Coords> {
        shape!(shape, "load", T, s => Ok(flat::<T, _>(&load.of(Of::<T>::of(self)?, s)?.load()?)))
    }

    /// Constraints to be met with the least energy.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`Elastic::anchored`].
    pub fn anchored_by(&self, shape: &Value, wishes: &Wishes) -> Result<Box<dyn Anchors>> {
        shape!(shape, "anchors", T, s => {
            let body: &Elastic<T> = Of::<T>::of(self)?;
            Ok(Box::new(Anchor { body: body.clone(), held: body.anchored(&wishes.on(s)?)? }) as Box<dyn Anchors>)
        })
    }
}
