    // Keys steer the gait while its sticks have 0 V. Sticks of your own are set here, and in each cycle.
    for stick in 1..=3 {
        drives.inputs_mut().set(tip_runtime::command::Port::Knob(stick), 0.0);
    }
