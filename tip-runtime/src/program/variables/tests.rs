use super::VariableError;
use crate::fault::Fault;
use crate::model::Family;
use crate::program::{Context, Flow, Program, Signature};

/// `DEF_VAR STRIDE` and `DEF_POS P`, after the variable that every program has.
struct Walk([Option<f64>; 5]);

const NAMES: [&str; 5] = ["VAR_KEY", "STRIDE", "P.X", "P.Y", "P.Z"];

impl Program for Walk {
    fn signature(&self) -> Signature {
        Signature {
            robot: "none",
            family: Family::Generic,
            legs: 1,
            joints: 1,
        }
    }
    fn name(&self) -> &str {
        "walk"
    }
    fn title(&self) -> &str {
        "walk"
    }
    fn at(&self) -> u32 {
        0
    }
    fn step(&mut self, _: &mut dyn Context) -> Result<Flow, Fault> {
        Ok(Flow::Wait)
    }
    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        Some((*NAMES.get(i)?, *self.0.get(i)?))
    }
    fn set_scalar(&mut self, i: usize, value: f64) {
        self.0[i] = Some(value);
    }
    fn line(&self, _: u32) -> u32 {
        0
    }
    fn reset(&mut self) {}
}

#[test]
fn a_variable_is_read_and_set_by_its_name() {
    let mut walk = Walk([None; 5]);
    assert_eq!(walk.get("STRIDE"), Ok(None));
    assert_eq!(walk.set("STRIDE", 80.0), Ok(()));
    assert_eq!(walk.set("P.Y", -0.5), Ok(()));
    assert_eq!(walk.get("STRIDE"), Ok(Some(80.0)));
    assert_eq!(walk.0, [None, Some(80.0), None, Some(-0.5), None]);
}

// clauses: 1.7
#[test]
fn the_case_of_a_name_does_not_matter() {
    let mut walk = Walk([None; 5]);
    assert_eq!(walk.set("Stride", 1.0), Ok(()));
    assert_eq!(walk.get("stride"), Ok(Some(1.0)));
}

#[test]
fn what_is_no_variable_is_refused() {
    let mut walk = Walk([Some(1.0); 5]);
    for (name, error) in [
        ("STRIDES", VariableError::Unknown),
        ("STRID", VariableError::Unknown),
        ("P", VariableError::Unknown),
        ("", VariableError::Unknown),
        ("歩幅", VariableError::Unknown),
        ("CHAR_A", VariableError::Constant),
        ("char_space", VariableError::Constant),
    ] {
        assert_eq!(walk.get(name), Err(error), "{name}");
        assert_eq!(walk.set(name, 1.0), Err(error), "{name}");
    }
}

#[test]
fn a_value_that_is_not_finite_is_refused_and_changes_nothing() {
    let mut walk = Walk([Some(1.0); 5]);
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(walk.set("STRIDE", value), Err(VariableError::NotFinite));
    }
    assert_eq!(walk.get("STRIDE"), Ok(Some(1.0)));
}

#[test]
fn a_program_that_is_borrowed_has_the_same_variables() {
    let mut walk = Walk([None; 5]);
    let mut borrowed = &mut walk;
    assert_eq!(Program::set(&mut borrowed, "STRIDE", 3.0), Ok(()));
    let dynamic: &dyn Program = &walk;
    assert_eq!(dynamic.get("STRIDE"), Ok(Some(3.0)));
}
