//! The functions of equations (T.I.P. 3.1 §5-2).

use super::{Bilingual, Edition};
use smol_str::StrExt;
use std::collections::HashMap;
use std::sync::LazyLock;
use tip_runtime::function::Function;

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Spelling of the word.
    pub word: &'static str,
    /// Operation of the function.
    pub operation: Operation,
    /// The first edition that has it.
    pub since: Edition,
    /// The section of T.I.P. that describes it.
    pub section: &'static str,
    /// The clause of the language reference.
    pub clause: &'static str,
    /// One line for the reference.
    pub description: Bilingual,
}

/// Operation of a function, which decides its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A number from a number.
    Scalar(Function),
    /// A number from two numbers: the direction of a point.
    Atan2,
    /// A number from a POS or JOINT.
    Norm,
    /// A POS from a POS.
    UnitVect,
    /// A POS from a POS and a number.
    Rotate(Axis),
}

/// An axis of the robot frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// To the right.
    X,
    /// Forward.
    Y,
    /// Up.
    Z,
}

impl Operation {
    /// Returns the number of operands.
    pub const fn operands(self) -> usize {
        match self {
            Operation::Scalar(_) | Operation::Norm | Operation::UnitVect => 1,
            Operation::Atan2 | Operation::Rotate(_) => 2,
        }
    }

    /// Returns the word that it is written by.
    pub fn word(self) -> &'static str {
        let row = FUNCTIONS.iter().find(|row| row.operation == self);
        row.map_or("", |row| row.word)
    }
}

impl Row {
    /// Creates a function of 3.1.
    const fn new(
        word: &'static str,
        operation: Operation,
        clause: &'static str,
        english: &'static str,
        japanese: &'static str,
    ) -> Self {
        Row {
            word,
            operation,
            since: Edition::V3_1,
            section: "§5-2",
            clause,
            description: Bilingual { english, japanese },
        }
    }

    /// Creates a function of 3.1 from number to number.
    const fn scalar(
        word: &'static str,
        function: Function,
        english: &'static str,
        japanese: &'static str,
    ) -> Self {
        Row::new(word, Operation::Scalar(function), "4.4", english, japanese)
    }
}

/// Every function.
pub const FUNCTIONS: &[Row] = &[
    Row::scalar(
        "INT",
        Function::Int,
        "The largest whole number not above the operand.",
        "引数を超えない最大の整数。",
    ),
    Row::scalar(
        "ABS",
        Function::Abs,
        "The operand without its sign.",
        "絶対値。",
    ),
    Row::scalar("SQRT", Function::Sqrt, "The square root.", "平方根。"),
    Row::scalar(
        "SIN",
        Function::Sin,
        "The sine of an angle in degrees.",
        "角度(度)の正弦。",
    ),
    Row::scalar(
        "COS",
        Function::Cos,
        "The cosine of an angle in degrees.",
        "角度(度)の余弦。",
    ),
    Row::scalar(
        "TAN",
        Function::Tan,
        "The tangent of an angle in degrees.",
        "角度(度)の正接。",
    ),
    Row::scalar(
        "ASIN",
        Function::Asin,
        "The arc sine in degrees.",
        "逆正弦(度)。",
    ),
    Row::scalar(
        "ACOS",
        Function::Acos,
        "The arc cosine in degrees.",
        "逆余弦(度)。",
    ),
    Row::scalar(
        "ATAN",
        Function::Atan,
        "The arc tangent in degrees, of -1 to 1.",
        "-1から1までの数の逆正接(度)。",
    ),
    Row::new(
        "ATAN2",
        Operation::Atan2,
        "4.5",
        "The direction of the point (x, y) in degrees, from y and x.",
        "yとxから求めた、点(x, y)の方向(度)。",
    ),
    Row::scalar(
        "DEG2RAD",
        Function::Deg2Rad,
        "Degrees to radians.",
        "度をラジアンに直します。",
    ),
    Row::scalar(
        "RAD2DEG",
        Function::Rad2Deg,
        "Radians to degrees.",
        "ラジアンを度に直します。",
    ),
    Row::new(
        "NORM",
        Operation::Norm,
        "4.6",
        "The root of the sum of squares of the members.",
        "メンバーの二乗和の平方根。",
    ),
    Row::new(
        "UNIT_VECT",
        Operation::UnitVect,
        "4.7",
        "The same direction with length 1.",
        "同じ向きで長さ1のベクトル。",
    ),
    Row::new(
        "ROT_X",
        Operation::Rotate(Axis::X),
        "4.8",
        "A position turned by degrees about the x axis of the robot frame.",
        "位置をロボット座標系のx軸まわりに指定した角度(度)だけ回したもの。",
    ),
    Row::new(
        "ROT_Y",
        Operation::Rotate(Axis::Y),
        "4.8",
        "A position turned by degrees about the y axis of the robot frame.",
        "位置をロボット座標系のy軸まわりに指定した角度(度)だけ回したもの。",
    ),
    Row::new(
        "ROT_Z",
        Operation::Rotate(Axis::Z),
        "4.8",
        "A position turned by degrees about the z axis of the robot frame.",
        "位置をロボット座標系のz軸まわりに指定した角度(度)だけ回したもの。",
    ),
];

static INDEX: LazyLock<HashMap<&str, &Row>> =
    LazyLock::new(|| FUNCTIONS.iter().map(|row| (row.word, row)).collect());

/// Returns the function that an edition writes so, whatever the case.
pub fn find(word: &str, edition: Edition) -> Option<Operation> {
    let row = INDEX.get(&*word.to_ascii_uppercase_smolstr())?;
    (row.since <= edition).then_some(row.operation)
}

/// Returns the words of the functions.
pub fn words() -> impl Iterator<Item = &'static str> {
    FUNCTIONS.iter().map(|row| row.word)
}

#[cfg(test)]
mod tests {
    use super::{FUNCTIONS, Operation, find};
    use crate::language::Edition;
    use tip_runtime::function::Function;

    #[test]
    fn every_function_is_found_by_its_word() {
        for row in FUNCTIONS {
            assert_eq!(find(row.word, Edition::V3_1), Some(row.operation));
            assert_eq!(row.operation.word(), row.word);
        }
        assert_eq!(find("sqrt", Edition::V3_1), find("SQRT", Edition::V3_1));
        assert_eq!(find("PTP", Edition::V3_1), None);
    }

    #[test]
    fn every_function_of_one_number_has_a_row() {
        for function in Function::ALL {
            assert_ne!(Operation::Scalar(*function).word(), "", "{function:?}");
        }
    }
}
