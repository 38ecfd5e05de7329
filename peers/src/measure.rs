//! Races: all candidates of a row run in turns within one process, so that noise hits them alike.

use std::hint::black_box;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// Who runs. The order is that of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    Symspline,
    Prepared,
    Direct,
    Bound,
    Curvo,
    Truck,
    Monstertruck,
    Bsplines,
}

impl Column {
    pub const ALL: [Self; 8] = [
        Self::Symspline,
        Self::Prepared,
        Self::Direct,
        Self::Bound,
        Self::Curvo,
        Self::Truck,
        Self::Monstertruck,
        Self::Bsplines,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Self::Symspline => "symspline",
            Self::Prepared => "symspline, prepared",
            Self::Direct => "bound, no table",
            Self::Bound => "bound",
            Self::Curvo => "curvo",
            Self::Truck => "truck-geometry",
            Self::Monstertruck => "monstertruck-geometry",
            Self::Bsplines => "bsplines",
        }
    }
}

/// What came out for one candidate.
#[derive(Clone, Copy, Debug)]
pub enum Outcome {
    /// Seconds a run; `error` is the largest difference from exact values, relative to the largest of them.
    Time { least: f64, median: f64, error: f64, larger: bool },
    /// The error is above the tolerance.
    Wrong { error: f64 },
    /// It panicked or returned an error.
    Fails,
    /// A run would take longer than [`LONGEST`] seconds.
    Slow,
}

/// One row of the table.
#[derive(Clone, Debug)]
pub struct Row {
    pub group: &'static str,
    pub name: String,
    /// Things done in a run: points, spans, knots.
    pub count: usize,
    pub unit: &'static str,
    pub tolerance: f64,
    pub cells: Vec<(Column, Outcome)>,
}

/// What a candidate is checked by: values, and the number of coefficients of a result.
#[derive(Clone, Debug, Default)]
pub struct Found {
    pub values: Vec<f64>,
    pub size: Option<usize>,
}

impl From<Vec<f64>> for Found {
    fn from(values: Vec<f64>) -> Self {
        Self { values, size: None }
    }
}

/// The most a single run may take, in seconds.
const LONGEST: f64 = 4.0;
/// A round of a fast candidate repeats it for about this long, in seconds.
const ROUND: f64 = 2e-4;
const MOST_ROUNDS: usize = 400;
const LEAST_ROUNDS: usize = 6;
/// The number of laps of a run that is cut.
const LAPS: usize = 20;
/// A candidate whose run in laps takes a second does so many things less.
const THIN: f64 = 50.0;

/// All rows, and how long each may take.
#[derive(Debug)]
pub struct Session {
    pub rows: Vec<Row>,
    pub budget: Duration,
}

impl Session {
    pub fn race(&self, group: &'static str, name: &str, (count, unit): (usize, &'static str)) -> Race {
        let row = Row { group, name: name.into(), count, unit, tolerance: 0.0, cells: Vec::new() };
        let before = self.rows.iter().rev().find(|row| row.name == name && row.group == group).cloned();
        let budget = self.budget.as_secs_f64();
        Race { before, budget, laps: 1, row, expected: Found::default(), runners: Vec::new() }
    }
}

struct Runner {
    column: Column,
    run: Box<dyn FnMut(Lap)>,
    repeats: usize,
    thin: usize,
    /// Of each lap, round by round.
    seconds: Vec<Vec<f64>>,
    spent: f64,
    error: f64,
    larger: bool,
}

/// A part of a run: slow candidates do one thing in `thin` only.
#[derive(Clone, Copy, Debug)]
pub struct Lap {
    index: usize,
    thin: usize,
}

impl Lap {
    /// The part of a list that belongs to the lap.
    pub fn of<T>(self, list: &[T]) -> &[T] {
        let length = list.len() / LAPS;
        let start = self.index * length;
        &list[start..start + length / self.thin]
    }
}

/// A row in the making.
pub struct Race {
    /// The row of the same name with another size.
    before: Option<Row>,
    budget: f64,
    laps: usize,
    row: Row,
    expected: Found,
    runners: Vec<Runner>,
}

impl Race {
    /// What every candidate has to find, up to `tolerance` times the largest value.
    pub fn expect(mut self, expected: impl Into<Found>, tolerance: f64) -> Self {
        self.expected = expected.into();
        self.row.tolerance = tolerance;
        self
    }

    /// Cuts a run into laps, whose least times are added up: the shorter a lap, the rarer it is disturbed.
    pub fn in_laps(mut self) -> Self {
        self.laps = LAPS;
        self
    }

    /// Enters a candidate that runs on a state of its own, lap by lap. It runs once and is checked.
    pub fn add<S: 'static>(
        &mut self,
        column: Column,
        state: impl FnOnce() -> S,
        mut run: impl FnMut(&mut S, Lap) + 'static,
        look: impl FnOnce(&S) -> Found,
    ) {
        if let Some(outcome) = self.forecast(column) {
            self.row.cells.push((column, outcome));
            return;
        }
        let laps = self.laps;
        let first = catch_unwind(AssertUnwindSafe(|| {
            let mut state = state();
            let lap = |index: usize| {
                let start = Instant::now();
                run(&mut state, Lap { index, thin: 1 });
                vec![start.elapsed().as_secs_f64()]
            };
            let seconds: Vec<Vec<f64>> = (0..laps).map(lap).collect();
            (seconds, look(&state), state)
        }));
        let Ok((seconds, found, mut state)) = first else {
            self.row.cells.push((column, Outcome::Fails));
            return;
        };
        let error = self.error(&found);
        if error > self.row.tolerance || error.is_nan() {
            self.row.cells.push((column, Outcome::Wrong { error }));
            return;
        }
        let larger = matches!((found.size, self.expected.size), (Some(n), Some(least)) if n > least);
        let spent: f64 = seconds.iter().flatten().sum();
        let repeats = (ROUND * laps as f64 / spent.max(1e-9)).ceil().max(1.0) as usize;
        let thin = if laps > 1 { (THIN * spent).ceil().clamp(1.0, THIN) as usize } else { 1 };
        let run = Box::new(move |lap: Lap| run(black_box(&mut state), lap));
        self.runners.push(Runner { column, run, repeats, thin, seconds, spent, error, larger });
    }

    /// What a smaller size foretells, for quadratic growth.
    fn forecast(&self, column: Column) -> Option<Outcome> {
        let before = self.before.as_ref()?;
        let (_, outcome) = before.cells.iter().find(|(other, _)| *other == column)?;
        match outcome {
            Outcome::Time { least, .. } => {
                let growth = self.row.count as f64 / before.count as f64;
                (least * growth * growth > LONGEST).then_some(Outcome::Slow)
            }
            Outcome::Wrong { .. } => None,
            other => Some(*other),
        }
    }

    /// The largest difference, relative to the largest value.
    fn error(&self, found: &Found) -> f64 {
        let expected = &self.expected.values;
        let lost = matches!((found.size, self.expected.size), (Some(n), Some(least)) if n < least);
        if found.values.len() != expected.len() || lost {
            return f64::INFINITY;
        }
        let size = expected.iter().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
        let differences = found.values.iter().zip(expected).map(|(x, y)| (x - y).abs());
        differences.fold(0.0, |most: f64, x| if x > most || x.is_nan() { x } else { most }) / size
    }

    /// Runs them in turns until the time is used up. A candidate drops out when its own share is spent.
    pub fn run(mut self) -> Row {
        let share = self.budget / self.runners.len().max(1) as f64;
        let goes = |runner: &Runner| {
            let spent = runner.spent;
            spent < share || (spent < LONGEST && runner.seconds[0].len() < LEAST_ROUNDS)
        };
        for _ in 0..MOST_ROUNDS {
            let going: Vec<bool> = self.runners.iter().map(goes).collect();
            if !going.contains(&true) {
                break;
            }
            for index in 0..self.laps {
                for (runner, _) in self.runners.iter_mut().zip(&going).filter(|(_, goes)| **goes) {
                    let (lap, start) = (Lap { index, thin: runner.thin }, Instant::now());
                    (0..runner.repeats).for_each(|_| (runner.run)(lap));
                    let seconds = start.elapsed().as_secs_f64();
                    runner.spent += seconds;
                    runner.seconds[index].push(seconds * runner.thin as f64 / runner.repeats as f64);
                }
            }
        }
        for mut runner in self.runners {
            runner.seconds.iter_mut().for_each(|lap| lap.sort_by(f64::total_cmp));
            let least = runner.seconds.iter().map(|lap| lap[0]).sum();
            let median = runner.seconds.iter().map(|lap| lap[lap.len() / 2]).sum();
            let time = Outcome::Time { least, median, error: runner.error, larger: runner.larger };
            self.row.cells.push((runner.column, time));
        }
        self.row
    }
}
