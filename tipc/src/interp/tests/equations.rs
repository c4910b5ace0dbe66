//! Equations between structs, and functions.

use super::script::Script;
use super::{A, B, P, path, set, value_of};
use crate::fixture::{constant, member, scalar};
use crate::program::{
    Action, Arithmetic, Axis, Function, Operand, ScalarExpression, StructExpression,
};

// clauses: 4.2 4.3 4.7 4.8
#[test]
fn structs_are_set_member_by_member() {
    let expressions = [
        (StructExpression::Copy(P), [3.0, 0.0, 4.0]),
        (StructExpression::UnitVect(P), [0.6, 0.0, 0.8]),
        (
            StructExpression::Binary {
                left: P,
                operation: Arithmetic::Sub,
                right: P,
            },
            [0.0, 0.0, 0.0],
        ),
        (
            StructExpression::Rotate {
                axis: Axis::Y,
                operand: P,
                angle: constant(0.0),
            },
            [3.0, 0.0, 4.0],
        ),
    ];
    for (value, expected) in expressions {
        let members = [3.0, 0.0, 4.0];
        let mut actions: Vec<Action> = (0..3)
            .map(|n| Action::SetScalar {
                target: member(P, n),
                update: None,
                value: ScalarExpression::Operand(constant(members[n])),
            })
            .collect();
        actions.push(Action::SetStruct {
            target: P + 1,
            update: None,
            value,
        });
        let (interpreter, _) = path(actions, &mut Script::default());
        let members = ["Q.X", "Q.Y", "Q.Z"].map(|name| value_of(&interpreter, name));
        assert_eq!(members, expected.map(Some));
    }
}

// clauses: 4.4 4.5 4.6
#[test]
fn functions_read_one_operand_and_keep_its_sign() {
    let minus_a = Operand::Scalar {
        scalar: scalar(A),
        negative: true,
    };
    let (interpreter, _) = path(
        vec![
            set(A, 2.5),
            Action::SetScalar {
                target: scalar(B),
                update: None,
                value: ScalarExpression::Function {
                    function: Function::Int,
                    operand: minus_a,
                },
            },
            Action::SetScalar {
                target: scalar(A),
                update: Some(Arithmetic::Mul),
                value: ScalarExpression::Atan2 {
                    y: constant(0.0),
                    x: constant(-1.0),
                },
            },
        ],
        &mut Script::default(),
    );
    assert_eq!(value_of(&interpreter, "B"), Some(-3.0));
    assert_eq!(value_of(&interpreter, "A"), Some(450.0));
}
