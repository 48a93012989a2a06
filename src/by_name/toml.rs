//! The form of a text: keys with values, in tables that are one level deep. What the keys mean is for others to say.
//!
//! The lexer and the parser are those of the crate `toml_parser`. Whatever the text, the work is in proportion to its length, and
//! memory is bounded: arrays more than two deep and keys with dots are refused where they begin.

use crate::distribution::tabulated::TABLE_LENGTHS;
use crate::error::Error;
use std::borrow::Cow;
use std::cell::RefCell;
use std::fmt::{Arguments, Display, Formatter, Write};
use toml_parser::decoder::{Encoding, IntegerRadix, ScalarKind};
use toml_parser::parser::{parse_document, EventReceiver};
use toml_parser::{ErrorSink, Expected, ParseError, Source, Span};

/// No surface needs more bytes, not even one with a table of heights.
pub const LONGEST_TEXT: usize = 1 << 20;
/// No surface needs so many words and signs.
const MOST_TOKENS: usize = 1 << 17;

/// Longer keys and words are cut where they are shown.
const SHOWN: usize = 40;

/// What a key is set to.
#[derive(Debug, Clone, PartialEq)]
pub enum Value<'t> {
    Number(f64),
    Flag(bool),
    Word(Cow<'t, str>),
    Numbers(Vec<f64>),
    /// An array of arrays of numbers.
    Rows(Vec<Vec<f64>>),
}

/// A key or a word as a message shows it: cut, and of signs that are none a question mark.
pub struct Shown<'a>(pub &'a str);

impl Display for Shown<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        for (i, letter) in self.0.chars().enumerate() {
            if i == SHOWN {
                return f.write_str("...");
            }
            f.write_char(if letter.is_control() { '?' } else { letter })?;
        }
        Ok(())
    }
}

impl Display for Value<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(number) => crate::error::Value::from(*number).fmt(f),
            Self::Flag(flag) => flag.fmt(f),
            Self::Word(word) => write!(f, "\"{}\"", Shown(word)),
            Self::Numbers(numbers) => match numbers[..] {
                [one, other] => write!(f, "[{}, {}]", Value::Number(one), Value::Number(other)),
                _ => f.write_str("[...]"),
            },
            Self::Rows(_) => f.write_str("[[...]]"),
        }
    }
}

/// Something wrong, and at which byte of the text.
pub struct Problem {
    pub at: usize,
    pub error: Error,
}

/// Boxed, as it is far larger than what is read.
pub type Outcome<T> = Result<T, Box<Problem>>;

impl Problem {
    #[cold]
    #[inline(never)]
    pub fn new(at: usize, says: Arguments) -> Box<Self> {
        Self::of(at, Error::Meaningless(Cow::Owned(says.to_string())))
    }

    #[cold]
    #[inline(never)]
    pub fn of(at: usize, error: Error) -> Box<Self> {
        Box::new(Self { at, error })
    }

    /// The error, with the line of the text.
    pub fn in_text(self, text: &[u8]) -> Error {
        Error::InText { line: line(text, self.at), error: Box::new(self.error) }
    }
}

/// The line of a byte of a text, from 1.
pub fn line(text: &[u8], at: usize) -> usize {
    1 + text[..at.min(text.len())].iter().filter(|&&byte| byte == b'\n').count()
}

/// What takes the tables and the keys of a text in their order.
pub trait Keys<'t> {
    /// The keys that follow are those of a table, or of none.
    fn table(&mut self, name: Option<&str>, at: usize) -> Outcome<()>;
    fn key(&mut self, name: &str, at: usize, value: Value<'t>) -> Outcome<()>;
}

/// The text of bytes.
///
/// # Errors
/// One that is too long, or not UTF-8.
pub fn text(bytes: &[u8]) -> Result<&str, Error> {
    if bytes.len() > LONGEST_TEXT {
        let says = "longer than 1 MiB: must be a surface file, whose keys docs/solvers.md has";
        return Err(Error::Meaningless(Cow::Borrowed(says)));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        Problem::new(error.valid_up_to(), format_args!("must be UTF-8: save the text in this encoding")).in_text(bytes)
    })
}

/// Hands all tables and keys of a text on, up to the first that is refused.
pub fn read<'t>(text: &'t str, keys: &mut dyn Keys<'t>) -> Outcome<()> {
    let source = Source::new(text);
    let count = source.lex().take(MOST_TOKENS + 1).count();
    if count > MOST_TOKENS {
        let says = format_args!("too many words and signs: must be a surface file, whose keys docs/solvers.md has");
        return Err(Problem::new(0, says));
    }
    let mut tokens = Vec::with_capacity(count);
    tokens.extend(source.lex());
    let first = RefCell::new(None);
    let [is_header, has_header, is_inside] = [false; 3];
    let (key, array, rows) = (None, None, None);
    let mut reader = Reader { source, keys, first: &first, key, is_header, has_header, is_inside, array, rows };
    let mut syntax = |error: ParseError| {
        first.borrow_mut().get_or_insert_with(|| of_syntax(&error, text));
    };
    parse_document(&tokens, &mut reader, &mut syntax);
    first.into_inner().map_or(Ok(()), Err)
}

/// What the parser says, in words.
#[cold]
fn of_syntax(error: &ParseError, text: &str) -> Box<Problem> {
    let [start, found] = [error.context(), error.unexpected()].map(|span| span.map(|span| span.start()));
    // What has no end is shown where it begins.
    let at = found.filter(|&at| at < text.trim_end().len()).or(start).or(found).unwrap_or_default();
    const NUMBERS: &str = "; numbers are written as 0.15, 10.0 or 1e-4";
    let expected = error.expected().unwrap_or_default().iter().map(|one| match one {
        Expected::Literal("\n") => "a new line".to_owned(),
        Expected::Literal(sign) => format!("`{sign}`"),
        Expected::Description(words) => (*words).to_owned(),
        _ => String::new(),
    });
    let expected = expected.collect::<Vec<_>>().join(" or ");
    let expected = if expected.is_empty() { expected } else { format!(", expected {expected}") };
    let written = text.as_bytes();
    let likely = match written.get(at) {
        Some(b'.' | b'+' | b'-' | b'0'..=b'9') => NUMBERS,
        _ if written.get(..at).is_some_and(|before| before.ends_with(b".")) => NUMBERS,
        Some(b',') => "; is it the point of a number?",
        Some(b':') => "; is it to be an equals sign?",
        _ => "",
    };
    Problem::new(at, format_args!("not TOML: {}{expected}{likely}", error.description()))
}

/// Keys and values out of the parser's events.
struct Reader<'t, 'r> {
    source: Source<'t>,
    keys: &'r mut dyn Keys<'t>,
    /// The first problem, after which nothing is read.
    first: &'r RefCell<Option<Box<Problem>>>,
    key: Option<(Cow<'t, str>, usize)>,
    /// Within the brackets of a table's name.
    is_header: bool,
    /// After the first of them.
    has_header: bool,
    /// Within the braces of a table that is a value.
    is_inside: bool,
    array: Option<Vec<f64>>,
    /// Those before, of an array of arrays.
    rows: Option<Vec<Vec<f64>>>,
}

impl<'t> Reader<'t, '_> {
    fn is_over(&self) -> bool {
        self.first.borrow().is_some()
    }

    fn check(&mut self, outcome: Outcome<()>) {
        if let Err(problem) = outcome {
            self.first.borrow_mut().get_or_insert(problem);
        }
    }

    /// Refuses what the last key has, or the place if there is none.
    #[cold]
    #[inline(never)]
    fn refuse(&mut self, span: Span, says: Arguments) {
        let problem = match self.key.take() {
            Some((key, at)) => Problem::new(at, format_args!("{}: {says}", Shown(&key))),
            None => Problem::new(span.start(), says),
        };
        self.check(Err(problem));
    }

    /// Hands the last key on as the name of a table.
    fn begin_table(&mut self) {
        if let Some((name, at)) = self.key.take().filter(|_| !self.is_over()) {
            let outcome = self.keys.table(Some(&name), at);
            self.check(outcome);
        }
    }

    fn set(&mut self, value: Value<'t>) {
        if let Some((key, at)) = self.key.take() {
            let outcome = self.keys.key(&key, at, value);
            self.check(outcome);
        }
    }

    /// A value that is one word or number.
    fn value(&mut self, span: Span, encoding: Option<Encoding>, error: &mut dyn ErrorSink) -> Option<Value<'t>> {
        let raw = toml_parser::Raw::new_unchecked(self.source.get(span)?.as_str(), encoding, span);
        if encoding.is_none() && is_bare_word(raw.as_str()) {
            let neither = format!("{} is neither a number without unit nor a word in quotes", Shown(raw.as_str()));
            let says = if raw.as_str().is_empty() { "has no value" } else { &neither };
            self.refuse(span, format_args!("{says}"));
            return None;
        }
        let mut text = Cow::Borrowed("");
        let kind = raw.decode_scalar(&mut text, error);
        if self.is_over() {
            return None;
        }
        let number = match kind {
            ScalarKind::String => return Some(Value::Word(text)),
            ScalarKind::Boolean(flag) => return Some(Value::Flag(flag)),
            ScalarKind::Float | ScalarKind::Integer(IntegerRadix::Dec) => text.parse::<f64>().ok(),
            ScalarKind::Integer(radix) => u64::from_str_radix(&text, radix.value()).ok().map(|number| number as f64),
            ScalarKind::DateTime => None,
        };
        let is_large = number.is_some_and(f64::is_infinite) && !text.ends_with("inf");
        match number {
            Some(number) if !is_large => Some(Value::Number(number)),
            _ => {
                let says = if is_large { "is too large for a number" } else { "must be a number or a word in quotes" };
                self.refuse(span, format_args!("{} {says}", Shown(&text)));
                None
            }
        }
    }
}

/// Whether a word stands without quotes where a value is due.
fn is_bare_word(raw: &str) -> bool {
    let number = raw.trim_start_matches(['+', '-']);
    let is_number =
        number.starts_with(|first: char| first.is_ascii_digit() || first == '.') || ["inf", "nan"].contains(&number);
    !(is_number && !raw.contains(' ') || ["true", "false"].contains(&raw))
}

impl<'t> EventReceiver for Reader<'t, '_> {
    fn std_table_open(&mut self, _: Span, _: &mut dyn ErrorSink) {
        (self.is_header, self.has_header, self.key) = (true, true, None);
    }

    fn std_table_close(&mut self, _: Span, _: &mut dyn ErrorSink) {
        self.is_header = false;
        self.begin_table();
    }

    fn array_table_open(&mut self, span: Span, _: &mut dyn ErrorSink) {
        self.key = None;
        self.refuse(span, format_args!("a table is given once, in single brackets"));
    }

    fn inline_table_open(&mut self, span: Span, _: &mut dyn ErrorSink) -> bool {
        if self.is_over() {
            return false;
        }
        if self.is_inside || self.has_header || self.array.is_some() || self.rows.is_some() {
            self.refuse(span, format_args!("must be a number, an array of numbers or a word in quotes, not a table"));
            return false;
        }
        self.begin_table();
        self.is_inside = true;
        true
    }

    fn inline_table_close(&mut self, span: Span, _: &mut dyn ErrorSink) {
        self.is_inside = false;
        if !self.is_over() {
            let outcome = self.keys.table(None, span.start());
            self.check(outcome);
        }
    }

    fn array_open(&mut self, span: Span, _: &mut dyn ErrorSink) -> bool {
        if self.is_over() {
            return false;
        }
        match (&self.array, &self.rows) {
            (Some(numbers), None) if numbers.is_empty() => self.rows = Some(Vec::new()),
            (Some(_), _) => {
                self.refuse(span, format_args!("must be an array of numbers, or of arrays of numbers"));
                return false;
            }
            (None, _) => {}
        }
        self.array = Some(Vec::new());
        true
    }

    fn array_close(&mut self, _: Span, _: &mut dyn ErrorSink) {
        if self.is_over() {
            return;
        }
        match (self.array.take(), &mut self.rows) {
            (Some(numbers), Some(rows)) => rows.push(numbers),
            (Some(numbers), None) => self.set(Value::Numbers(numbers)),
            (None, _) => {
                let rows = self.rows.take().unwrap_or_default();
                self.set(Value::Rows(rows));
            }
        }
    }

    fn simple_key(&mut self, span: Span, encoding: Option<Encoding>, error: &mut dyn ErrorSink) {
        let Some(raw) = self.source.get(span).filter(|_| !self.is_over()) else { return };
        let mut name = Cow::Borrowed("");
        toml_parser::Raw::new_unchecked(raw.as_str(), encoding, span).decode_key(&mut name, error);
        self.key = Some((name, span.start()));
    }

    fn key_sep(&mut self, span: Span, _: &mut dyn ErrorSink) {
        if !self.is_over() {
            let says = match self.is_header {
                true => "there are no tables in tables here",
                false => "keys with dots are not read here: write the table, as [materials], above its keys",
            };
            self.refuse(span, format_args!("{says}"));
        }
    }

    fn scalar(&mut self, span: Span, encoding: Option<Encoding>, error: &mut dyn ErrorSink) {
        if self.is_over() {
            return;
        }
        let Some(value) = self.value(span, encoding, error) else { return };
        if self.array.is_none() && self.rows.is_some() {
            return self.refuse(span, format_args!("must be an array of numbers, or of arrays of numbers"));
        }
        let Some(numbers) = &mut self.array else { return self.set(value) };
        match value {
            Value::Number(number) if numbers.len() < TABLE_LENGTHS.1 => numbers.push(number),
            Value::Number(_) => self.refuse(span, format_args!("more than {} numbers", TABLE_LENGTHS.1)),
            _ => self.refuse(span, format_args!("must be an array of numbers alone; a word has no brackets")),
        }
    }

    fn comment(&mut self, span: Span, error: &mut dyn ErrorSink) {
        if let Some(raw) = self.source.get(span) {
            raw.decode_comment(error);
        }
    }

    fn newline(&mut self, span: Span, error: &mut dyn ErrorSink) {
        if let Some(raw) = self.source.get(span) {
            raw.decode_newline(error);
        }
    }
}
