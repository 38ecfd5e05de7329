//! Ratios measured in one process: candidates run in turn, and the least time of many short rounds counts.
//!
//! Other work on the machine slows a round now and then; the least of many is the round that nothing slowed. Long runs are
//! always interrupted: where the system tells it, the time on the processor counts for them.

#![allow(dead_code, reason = "each bench uses a part")]

use std::time::{Duration, Instant};

/// The length of a round, and that of one of long runs.
const ROUND: Duration = Duration::from_millis(2);
const LONG_ROUND: Duration = Duration::from_millis(80);

/// Something to time under a name.
pub struct Candidate<'a> {
    pub name: String,
    run: Box<dyn FnMut() + 'a>,
    repeats: u32,
    least: Duration,
}

/// The candidate that runs `f` and keeps the compiler from leaving its result out.
pub fn candidate<'a, R>(name: impl Into<String>, mut f: impl FnMut() -> R + 'a) -> Candidate<'a> {
    let run = Box::new(move || drop(std::hint::black_box(f())));
    Candidate { name: name.into(), run, repeats: 1, least: Duration::MAX }
}

impl Candidate<'_> {
    fn round(&mut self) -> Duration {
        let (start, busy) = (Instant::now(), time_on_processor());
        (0..self.repeats).for_each(|_| (self.run)());
        let elapsed = start.elapsed();
        match (busy, time_on_processor()) {
            (Some(from), Some(to)) if elapsed > LONG_ROUND / 2 => elapsed.min(to - from),
            _ => elapsed,
        }
    }
}

/// What the system counts in steps of some milliseconds.
fn time_on_processor() -> Option<Duration> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split_whitespace().next()?.parse().ok().map(Duration::from_nanos)
}

/// The least seconds a run of each candidate.
pub fn seconds(candidates: &mut [Candidate<'_>]) -> Vec<f64> {
    const LONG: Duration = Duration::from_millis(4);
    const ROUNDS: usize = 40;
    for c in candidates.iter_mut() {
        let once = c.round().max(Duration::from_nanos(20));
        let round = if once < LONG { ROUND } else { LONG_ROUND };
        c.repeats = (round.as_nanos() / once.as_nanos()).clamp(1, 1 << 20) as u32;
    }
    for round in 0..ROUNDS {
        for c in candidates.iter_mut().filter(|c| round < 5 || c.least < LONG) {
            c.least = c.least.min(c.round() / c.repeats);
        }
    }
    candidates.iter().map(|c| c.least.as_secs_f64()).collect()
}

/// Prints the time of the first candidate, and of the others how many times that they take.
pub fn compare(what: &str, mut candidates: Vec<Candidate<'_>>) -> Vec<f64> {
    let times = seconds(&mut candidates);
    print!("{what:<26} {} {:>9.3} µs", candidates[0].name, times[0] * 1e6);
    for (c, time) in candidates.iter().zip(&times).skip(1) {
        print!(" | {} {:>8.1}", c.name, time / times[0]);
    }
    println!();
    times
}
