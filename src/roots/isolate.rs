//! Isolation by sign variations and bisection.

use crate::roots::Solvable;
use crate::roots::polynomial::Polynomial;
use crate::roots::square_free::square_free_parts;

/// The bisections in a row after which an exact field looks for multiple roots.
const DEEP: usize = 24;

/// Isolated roots.
pub(super) struct Isolation<T> {
    /// A polynomial that has one simple root in every isolating interval, and no root at its ends.
    pub factor: Polynomial<T>,
    /// Isolating intervals, ascending, with multiplicities; start and end are equal at a root that is known.
    pub roots: Vec<(T, T, usize)>,
}

/// The roots of `polynomial`, ends included, unless it is zero.
pub(super) fn isolation<T: Solvable>(polynomial: &Polynomial<T>) -> Option<Isolation<T>> {
    let (start, end) = polynomial.end_roots()?;
    let (a, b) = polynomial.domain();
    let mut roots = Vec::new();
    roots.extend((start > 0).then(|| (a.clone(), a.clone(), start)));
    let mut factor = polynomial.without_end_roots();
    match bisect(&factor, T::EXACT.then_some(DEEP)) {
        Some(inside) => roots.extend(inside),
        None if T::has_simple_roots(&factor.powers()) => {
            roots.extend(bisect(&factor, None).expect("there is no limit to the depth"));
        }
        None => {
            let parts = square_free_parts(&factor);
            let inside = bisect(&parts[0], None).expect("there is no limit to the depth");
            roots.extend(inside.into_iter().map(|(l, r, _)| {
                let count =
                    parts.iter().filter(|part| part.sign_at(&l) == part.sign_at(&r).reverse()).count();
                (l, r, count)
            }));
            factor = parts.into_iter().next().expect("there is one part at least");
        }
    }
    roots.extend((end > 0).then(|| (b.clone(), b.clone(), end)));
    Some(Isolation { factor, roots })
}

/// What is left to do, in order of place.
enum Task<T> {
    Search(Polynomial<T>, usize),
    Found(T, usize),
}

/// The roots inside the interval, or nothing if more than `limit` bisections in a row do not isolate one.
fn bisect<T: Solvable>(polynomial: &Polynomial<T>, limit: Option<usize>) -> Option<Vec<(T, T, usize)>> {
    let mut found = Vec::new();
    let mut tasks = vec![Task::Search(polynomial.clone(), 0)];
    while let Some(task) = tasks.pop() {
        let (part, depth) = match task {
            Task::Found(x, count) => {
                found.push((x.clone(), x, count));
                continue;
            }
            Task::Search(part, depth) => (part, depth),
        };
        let (count, (a, b)) = (part.variations(), part.domain());
        let bare = part.end_roots() == Some((0, 0));
        if count == 0 {
            continue;
        }
        let Some(middle) = part.middle().filter(|_| count > 1 || !bare) else {
            found.push((a.clone(), b.clone(), count));
            continue;
        };
        if count > 1 && limit == Some(depth) {
            return None;
        }
        let (left, right) = part.split_inside(&middle);
        let (at_middle, _) = right.end_roots().unwrap_or((0, 0));
        tasks.push(Task::Search(right, depth + 1));
        tasks.extend((at_middle > 0).then_some(Task::Found(middle, at_middle)));
        tasks.push(Task::Search(left, depth + 1));
    }
    Some(found)
}
