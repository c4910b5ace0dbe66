extern crate std;

use super::*;
use std::println;

/// Returns the bytes that the largest robot moves by, without its model and its inputs.
fn working_memory() -> usize {
    let model = size_of::<[Leg<9>; 9]>();
    let inputs = size_of::<Overrides<[LegInputs<9>; 9]>>();
    size_of::<DynamicPlant<9, 9>>() - model - inputs
}

#[test]
fn the_largest_robot_moves_in_sixteen_kilobytes() {
    let sizes = [
        size_of::<DynamicPlant<4, 3>>(),
        size_of::<DynamicPlant<6, 3>>(),
        size_of::<DynamicPlant<9, 9>>(),
    ];
    println!("4 x 3, 6 x 3, 9 x 9: {sizes:?} bytes");
    let working = working_memory();
    println!("without model and inputs, 9 x 9: {working} bytes");
    assert!(working <= 16 * 1024, "{working}");
}
