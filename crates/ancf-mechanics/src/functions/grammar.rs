use thiserror::Error;
use winnow::ascii::{digit0, digit1, multispace0};
use winnow::combinator::{Infix, Prefix, alt, expression, opt, preceded, separated};
use winnow::error::{ContextError, ErrMode, StrContext, StrContextValue};
use winnow::stream::{Stateful, Stream as _};
use winnow::token::{one_of, take_while};
use winnow::{ModalResult, Parser};

use super::syntax_node::{Binary, SyntaxNode, Unary};

/// Maximum number of characters of a formula. It also limits the recursion depth.
const LENGTH: usize = 1000;
/// Maximum depth of nested brackets.
const DEPTH: usize = 40;

/// Expected inputs; the names of the variables are inserted for `{}`.
const OPERAND: &str = "a number, {}, `pi`, a function or a bracket";
const NAME: &str = "{}, `pi` or a function: sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, ln, \
                    sqrt, abs, sign, min, max or if";
const ARGUMENTS: &str = "one argument, two of `min` and `max`, three of `if`";
const OPERATOR: &str = "an operator or the end; powers of powers in brackets";

/// Syntax error in a formula.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("character {}: expected {expected}", .at + 1)]
pub struct ExpressionError {
    /// Position as the index of the character, from 0.
    pub at: usize,
    /// Expected input at this position.
    pub expected: String,
}

type ParseFailure = ErrMode<ContextError>;
/// Rest of a formula, with the names of its variables.
type Rest<'i> = Stateful<&'i str, &'i [&'i str]>;

/// Parses a whole formula with the given variables.
pub(crate) fn parse(text: &str, variables: &[&str]) -> Result<SyntaxNode, ExpressionError> {
    let error = |at, expected: &str| Err(ExpressionError { at, expected: expected.into() });
    if text.chars().count() > LENGTH {
        return error(LENGTH, "at most 1000 characters");
    }
    let mut open = 0_usize;
    for (at, c) in text.chars().enumerate() {
        open = (open + usize::from(c == '(')).saturating_sub(usize::from(c == ')'));
        if open > DEPTH {
            return error(at, "at most 40 nested brackets");
        }
    }
    let whole = |i: &mut Rest<'_>| {
        let node = sum(i)?;
        multispace0.parse_next(i)?;
        if i.input.is_empty() { Ok(node) } else { expected(OPERATOR) }
    };
    { whole }.parse(Rest { input: text, state: variables }).map_err(|failure| {
        let said = failure.inner().context().find_map(|context| match context {
            StrContext::Expected(StrContextValue::Description(expected)) => Some(*expected),
            _ => None,
        });
        let at = text[..failure.char_span().start.min(text.len())].chars().count();
        let names: Vec<String> = variables.iter().map(|name| format!("`{name}`")).collect();
        ExpressionError { at, expected: said.unwrap_or(OPERAND).replace("{}", &names.join(", ")) }
    })
}

/// Returns a fatal error with the expected input.
fn expected<T>(what: &'static str) -> ModalResult<T> {
    let mut error = ContextError::new();
    error.push(StrContext::Expected(StrContextValue::Description(what)));
    Err(ErrMode::Cut(error))
}

/// Parsers of operands and operators.
fn sum(i: &mut Rest<'_>) -> ModalResult<SyntaxNode> {
    expression(operand).prefix(sign).infix(operator).parse_next(i)
}

fn sign<'i>(i: &mut Rest<'i>) -> ModalResult<Prefix<Rest<'i>, SyntaxNode, ParseFailure>> {
    multispace0.parse_next(i)?;
    match opt(one_of(['+', '-'])).parse_next(i)? {
        Some(_) if i.input.trim_start().starts_with(['+', '-']) => expected(OPERAND),
        Some('-') => Ok(Prefix(30, |_, x| Ok(SyntaxNode::One(Unary::Negative, Box::new(x))))),
        Some(_) => Ok(Prefix(30, |_, x| Ok(x))),
        None => expected(OPERAND),
    }
}

fn operator<'i>(i: &mut Rest<'i>) -> ModalResult<Infix<Rest<'i>, SyntaxNode, ParseFailure>> {
    let sign = one_of(['+', '-', '*', '/', '^', '<', '>']).take();
    let operator = preceded(multispace0, alt(("<=", ">=", sign))).parse_next(i)?;
    Ok(match operator {
        "+" => Infix::Left(10, |_, x, y| Ok(SyntaxNode::two(Binary::Sum, x, y))),
        "-" => Infix::Left(10, |_, x, y| Ok(SyntaxNode::two(Binary::Difference, x, y))),
        "*" => Infix::Left(20, |_, x, y| Ok(SyntaxNode::two(Binary::Product, x, y))),
        "/" => Infix::Left(20, |_, x, y| Ok(SyntaxNode::two(Binary::Quotient, x, y))),
        "<" => Infix::Neither(5, |_, x, y| Ok(SyntaxNode::two(Binary::Less, x, y))),
        ">" => Infix::Neither(5, |_, x, y| Ok(SyntaxNode::two(Binary::Greater, x, y))),
        "<=" => Infix::Neither(5, |_, x, y| Ok(SyntaxNode::two(Binary::LessEqual, x, y))),
        ">=" => Infix::Neither(5, |_, x, y| Ok(SyntaxNode::two(Binary::GreaterEqual, x, y))),
        _ => Infix::Neither(40, |_, x, y| Ok(SyntaxNode::two(Binary::Power, x, y))),
    })
}

fn operand(i: &mut Rest<'_>) -> ModalResult<SyntaxNode> {
    multispace0.parse_next(i)?;
    match i.input.chars().next() {
        Some('0'..='9' | '.') => number(i),
        Some('a'..='z' | 'A'..='Z' | '_') => name(i),
        Some('(') => {
            i.next_token();
            let inner = fatal(sum(i))?;
            close(i, "`)` or an operator")?;
            Ok(inner)
        }
        Some('+' | '-') => Err(ErrMode::Backtrack(ContextError::new())),
        _ => expected(OPERAND),
    }
}

fn number(i: &mut Rest<'_>) -> ModalResult<SyntaxNode> {
    let exponent = (one_of(['e', 'E']), opt(one_of(['+', '-'])), digit1);
    let digits = (digit0, opt(('.', digit0)), opt(exponent)).take();
    let number = digits.verify_map(|text: &str| text.parse().ok().filter(|x: &f64| x.is_finite()));
    match opt(number).parse_next(i)? {
        Some(x) => Ok(SyntaxNode::Number(x)),
        None => expected("a finite number"),
    }
}

fn name(i: &mut Rest<'_>) -> ModalResult<SyntaxNode> {
    let start = i.checkpoint();
    let name = take_while(1.., |c: char| c.is_ascii_alphanumeric() || c == '_').parse_next(i)?;
    if let Some(number) = i.state.iter().position(|own| *own == name) {
        return Ok(SyntaxNode::Variable(number));
    }
    if name == "pi" {
        return Ok(SyntaxNode::Number(std::f64::consts::PI));
    }
    let call = opt((multispace0, '(')).parse_next(i)?;
    let known = FUNCTIONS.contains(&name);
    if call.is_none() || !known {
        i.reset(&start);
        return expected(NAME);
    }
    let arguments = fatal(separated(1..=3, sum, (multispace0, ',')).parse_next(i))?;
    close(i, "`)`, `,` or an operator")?;
    match SyntaxNode::call(name, arguments) {
        Some(node) => Ok(node),
        None => {
            i.reset(&start);
            expected(ARGUMENTS)
        }
    }
}

/// Names of the functions of formulas.
const FUNCTIONS: [&str; 17] = [
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "ln", "sqrt", "abs", "sign",
    "min", "max", "if",
];

/// True if a name has a meaning in all formulas: a function or `pi`.
pub(crate) fn is_reserved(name: &str) -> bool {
    name == "pi" || FUNCTIONS.contains(&name)
}

fn close(i: &mut Rest<'_>, what: &'static str) -> ModalResult<()> {
    multispace0.parse_next(i)?;
    match opt(')').parse_next(i)? {
        Some(_) => Ok(()),
        None => expected(what),
    }
}

/// Turns a failure into a fatal error, without trying alternatives.
fn fatal<T>(result: ModalResult<T>) -> ModalResult<T> {
    result.map_err(ErrMode::cut)
}
