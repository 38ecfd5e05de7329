//! Ranges of axes, their ticks, and the numbers beside them.
//!
//! Ticks lie at the multiples of a step `m * 10^e` with `m` in `{1, 2, 5}`. They are counted in integers and
//! rounded once, so that a label never shows `0.30000000000000004`.

/// An interval of data values with `lo <= hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    pub(super) lo: f64,
    pub(super) hi: f64,
}

impl Range {
    /// What an empty panel shows.
    pub(super) const UNIT: Self = Self { lo: 0.0, hi: 1.0 };

    /// The smallest range that contains all values; none without values.
    pub(super) fn hull(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let join = |range: Self, value: f64| Self { lo: range.lo.min(value), hi: range.hi.max(value) };
        values
            .into_iter()
            .fold(None, |range, value| Some(join(range.unwrap_or(Self { lo: value, hi: value }), value)))
    }

    /// The smallest range that contains all ranges; none without ranges.
    pub(super) fn union(ranges: impl IntoIterator<Item = Self>) -> Option<Self> {
        Self::hull(ranges.into_iter().flat_map(|range| [range.lo, range.hi]))
    }

    pub(super) fn span(self) -> f64 {
        self.hi - self.lo
    }

    /// Whether the values differ by no more than rounding: `span <= 1e-10 * max(|lo|, |hi|)`.
    pub(super) fn is_flat(self) -> bool {
        self.span() <= 1e-10 * self.lo.abs().max(self.hi.abs())
    }

    /// Whether ticks can be counted: a span of `1e-290` to `1e290` and of `1e-12 * max(|lo|, |hi|)` at least.
    pub(super) fn is_countable(self) -> bool {
        let least = 1e-12 * self.lo.abs().max(self.hi.abs());
        (1e-290..=1e290).contains(&self.span()) && self.span() >= least
    }

    /// The same range, or the neighbourhood of a constant: `v ± |v|/2`, or `±1` about zero.
    pub(super) fn widened(self) -> Self {
        if !self.is_flat() {
            return self;
        }
        let room = if self.hi == 0.0 { 1.0 } else { self.hi.abs() / 2.0 };
        Self { lo: self.lo - room, hi: self.hi + room }
    }

    /// The range that shows this one on `length` pixels with free pixels before and after it.
    pub(super) fn padded(self, before: f64, after: f64, length: f64) -> Self {
        let unit = self.span() / (length - before - after);
        Self { lo: self.lo - before * unit, hi: self.hi + after * unit }
    }

    /// The range with the same centre and the given span.
    pub(super) fn about_centre(self, span: f64) -> Self {
        let centre = self.lo + self.span() / 2.0;
        Self { lo: centre - span / 2.0, hi: centre + span / 2.0 }
    }
}

/// A tick: its place in data units and its label.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

/// The distance of ticks, `m * 10^exponent`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Step {
    m: i64,
    exponent: i32,
}

impl Step {
    /// The least step that cuts the range into at most so many intervals.
    pub(super) fn new(range: Range, intervals: usize) -> Self {
        let raw = range.span() / intervals as f64;
        let exponent = raw.log10().floor() as i32;
        let long_enough = |m: &i64| multiple(*m as f64, exponent) >= raw * (1.0 - 1e-9);
        match [1, 2, 5].into_iter().find(long_enough) {
            Some(m) => Self { m, exponent },
            None => Self { m: 1, exponent: exponent + 1 },
        }
    }

    /// Its length.
    pub(super) fn length(self) -> f64 {
        multiple(self.m as f64, self.exponent)
    }

    /// The multiples of the step in a range.
    pub(super) fn ticks(self, range: Range) -> Vec<Tick> {
        let (lo, hi) = (range.lo / self.length(), range.hi / self.length());
        let indices = (lo - 1e-9).ceil() as i64..=(hi + 1e-9).floor() as i64;
        let values: Vec<f64> = indices.map(|i| multiple((i * self.m) as f64, self.exponent)).collect();
        let largest = values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let tick = |value| Tick { value, label: number(value, self.exponent, largest) };
        values.into_iter().map(tick).collect()
    }
}

/// The value `m * 10^exponent`, rounded once for the usual exponents.
fn multiple(m: f64, exponent: i32) -> f64 {
    if (-22..0).contains(&exponent) { m / 10_f64.powi(-exponent) } else { m * 10_f64.powi(exponent) }
}

/// The label of a multiple of `10^exponent` on an axis whose largest label is that of `largest`.
///
/// Plain decimals, with thin spaces between thousands from 10 000 on; a power of ten for an axis of very
/// large or very small numbers.
fn number(value: f64, exponent: i32, largest: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let sign = if value < 0.0 { "\u{2212}" } else { "" };
    let size = value.abs();
    let top = largest.log10().floor() as i32;
    let digits = top - exponent;
    let short = (top >= 6 || exponent < -4) && digits <= 3;
    if (-15..15).contains(&top) && !short {
        let text = format!("{size:.*}", (-exponent).max(0) as usize);
        return format!("{sign}{}", if size >= 1e4 { grouped(&text) } else { text });
    }
    let mantissa = format!("{:.*}", digits.max(0) as usize, multiple(size, -top));
    let power: String = top.to_string().chars().map(superscript).collect();
    format!("{sign}{mantissa}·10{power}")
}

/// A decimal number with thin spaces between the thousands.
fn grouped(text: &str) -> String {
    let point = text.find('.').unwrap_or(text.len());
    let gap = |i: usize| if i > 0 && i < point && (point - i).is_multiple_of(3) { "\u{2009}" } else { "" };
    text.char_indices().map(|(i, digit)| format!("{}{digit}", gap(i))).collect()
}

fn superscript(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(lo: f64, hi: f64, intervals: usize) -> Vec<String> {
        Step::new(Range { lo, hi }, intervals)
            .ticks(Range { lo, hi })
            .into_iter()
            .map(|tick| tick.label)
            .collect()
    }

    #[test]
    fn steps_are_one_two_five() {
        assert_eq!(labels(0.0, 1.0, 5), ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(0.0, 1.0, 10)[3], "0.3");
        assert_eq!(labels(-1.0, 1.0, 5), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
        assert_eq!(labels(0.0, 7.0, 8), ["0", "1", "2", "3", "4", "5", "6", "7"]);
        assert_eq!(labels(0.0, 95.0, 5), ["0", "20", "40", "60", "80"]);
    }

    #[test]
    fn ticks_cover_the_range_and_are_few() {
        for k in 0..400 {
            let lo = f64::from(k - 200) * 0.137;
            let range = Range { lo, hi: lo + 10_f64.powf(f64::from(k % 61) / 7.0 - 4.0) };
            for intervals in 3..12 {
                let marks = Step::new(range, intervals).ticks(range);
                assert!(marks.len() <= intervals + 1 && marks.len() >= intervals * 2 / 5, "{range:?}");
                let slack = 1e-6 * range.span();
                assert!(marks.iter().all(|t| t.value >= range.lo - slack && t.value <= range.hi + slack));
                // No room for one more tick at either end.
                let (Some(first), Some(last)) = (marks.first(), marks.last()) else { continue };
                if marks.len() > 1 {
                    let step = marks[1].value - marks[0].value;
                    assert!(first.value - step < range.lo && last.value + step > range.hi);
                }
            }
        }
    }

    #[test]
    fn numbers_read_well() {
        assert_eq!(labels(0.0, 0.3, 3), ["0", "0.1", "0.2", "0.3"]);
        assert_eq!(labels(9_000.0, 11_000.0, 2), ["9000", "10\u{2009}000", "11\u{2009}000"]);
        assert_eq!(labels(0.0, 2e6, 4)[1], "0.5·10⁶");
        assert_eq!(labels(-1e-7, 1e-7, 2), ["−1·10⁻⁷", "0", "1·10⁻⁷"]);
        assert_eq!(labels(1_000_000.0, 1_000_004.0, 4)[1], "1\u{2009}000\u{2009}001");
        assert_eq!(labels(0.0, 5e-3, 5)[1], "0.001");
        assert_eq!(labels(0.0, 4e300, 4)[3], "3·10³⁰⁰");
    }

    #[test]
    fn constants_get_room() {
        assert_eq!(Range { lo: 0.0, hi: 0.0 }.widened(), Range { lo: -1.0, hi: 1.0 });
        assert_eq!(Range { lo: -4.0, hi: -4.0 }.widened(), Range { lo: -6.0, hi: -2.0 });
        let noise = Range { lo: 1.0, hi: 1.0 + 1e-14 }.widened();
        assert!(noise.span() > 0.9);
        assert_eq!(Range { lo: 1.0, hi: 2.0 }.widened(), Range { lo: 1.0, hi: 2.0 });
    }

    #[test]
    fn padding_is_in_pixels() {
        assert_eq!(Range { lo: 0.0, hi: 80.0 }.padded(10.0, 10.0, 100.0), Range { lo: -10.0, hi: 90.0 });
    }
}
