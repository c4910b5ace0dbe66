//! Events of a run, as command lines and files write them.

use tip_runtime::command::Port;
use tip_runtime::plant::Noise;
use tip_sim::event::{Keys, SensorAt};
use tip_sim::{Event, Events, Inputs};

#[test]
fn keys_are_characters_or_hexadecimal_bytes() {
    let keys = |text: &str| text.parse::<Keys>().map(|keys| keys.0);
    let key = |cycle, byte| Event::Key(byte).at(cycle);
    assert_eq!(keys("3:a"), Ok(vec![key(3, b'a')]));
    assert_eq!(
        keys("0:0,0::,12:0x1B,12:0x2c"),
        Ok(vec![
            key(0, b'0'),
            key(0, b':'),
            key(12, 0x1B),
            key(12, 0x2C)
        ])
    );
    for wrong in [
        "", "3", "3:", "x:a", "3:ab", "3:0x100", "3:0xG0", "3:あ", "3:a,",
    ] {
        assert!(keys(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn a_sensor_names_an_input_a_voltage_and_a_cycle() {
    let sensor = |text: &str| {
        let sensor = text.parse::<SensorAt>();
        sensor.map(|sensor| sensor.events(20.0).collect::<Vec<_>>())
    };
    let expected = |port, volts, cycle| Ok(vec![Event::Sensor(port, volts).at(cycle)]);
    for (text, expected) in [
        ("VR1=8@300", expected(Port::Knob(1), 8.0, 300)),
        ("paw4=-0.5@0", expected(Port::Paw(4), -0.5, 0)),
        ("J23=1@7", expected(Port::Joint(2, 3), 1.0, 7)),
        ("ANTENNA=5@1", expected(Port::Antenna, 5.0, 1)),
    ] {
        assert_eq!(sensor(text), expected);
    }
    for wrong in [
        "VR1",
        "VR1=8",
        "VR4=8@1",
        "PAW5=8@1",
        "VR0=8@1",
        "J0=1@1",
        "J123=1@1",
        "X=1@1",
        "VR1=inf@1",
        "VR1=8@-1",
        "VR1=@1",
        "VR1=8@2s..",
        "VR1=8@5s..2s",
        "VR1=8@300..300",
        "VR1=8@100..3s",
        "VR1=8@-1s",
    ] {
        assert!(sensor(wrong).is_err(), "{wrong}");
    }
}

/// 2 s are 100 cycles of 20 ms, or 200 of 10 ms. A stick springs back to the middle, another input to nothing.
#[test]
fn a_sensor_reads_something_for_a_while() {
    let events = |text: &str, period| {
        let sensor: SensorAt = text.parse().expect(text);
        sensor.events(period).collect::<Vec<_>>()
    };
    let read = |port, volts, cycle| Event::Sensor(port, volts).at(cycle);
    let stick = Port::Knob(1);
    let expected = [read(stick, 8.0, 100), read(stick, 5.0, 250)];
    assert_eq!(events("VR1=8@2s..5s", 20.0), expected);
    let expected = [read(stick, 8.0, 200), read(stick, 5.0, 500)];
    assert_eq!(events("VR1=8@2s..5s", 10.0), expected);
    let expected = [read(Port::Paw(1), 2.0, 10), read(Port::Paw(1), 0.0, 30)];
    assert_eq!(events("PAW1=2@10..30", 20.0), expected);
    let expected = "100:VR1=8, 250:VR1=5".parse::<Events>();
    assert_eq!("100..250:VR1=8".parse::<Events>(), expected);
    for wrong in ["250..100:VR1=8", "100..250:key F", "100..:VR1=8"] {
        assert!(wrong.parse::<Events>().is_err(), "{wrong}");
    }
}

#[test]
fn inputs_are_read_from_what_they_are_written_as() {
    let text =
        "--keys 0:F,3:0x2C,9:0x1B --sensor ANTENNA=1@0 --sensor J23=-0.5@7 --halt 5 --cycles 90";
    let inputs: Inputs = text.parse().unwrap();
    let events = inputs.events.to_string();
    assert_eq!(
        events,
        "0:key F, 0:ANTENNA=1, 3:key 0x2C, 5:halt, 7:J23=-0.5, 9:key 0x1B"
    );
    assert_eq!(inputs.cycles, Some(90));
    assert_eq!(inputs.to_string(), text);
    assert_eq!("".parse(), Ok(Inputs::default()));
    for wrong in ["--keys", "--halt x", "--cycles -1", "--out 3", "VR1=8@3"] {
        assert!(wrong.parse::<Inputs>().is_err(), "{wrong}");
    }
}

#[test]
fn what_has_no_short_form_stands_in_the_full_one() {
    let text = "--keys 3:a --events '4:touch on,9:read fails' --cycles 12";
    let inputs: Inputs = text.parse().unwrap();
    assert_eq!(
        inputs.events.to_string(),
        "3:key a, 4:touch on, 9:read fails"
    );
    assert_eq!(inputs.to_string(), text);
}

#[test]
fn every_event_is_read_from_what_it_is_written_as() {
    let events = [
        Event::Key(b'F'),
        Event::Key(b','),
        Event::Key(0x1B),
        Event::Halt,
        Event::Sensor(Port::Knob(1), 8.0),
        Event::Sensor(Port::Joint(2, 3), -0.5),
        Event::Sensor(Port::Antenna, 1e-3),
        Event::Set("P.X".to_owned(), -1.5),
        Event::Touch(true),
        Event::Touch(false),
        Event::Push([50.0, 0.0, -20.5], 10),
        Event::Noise(Noise {
            angle: 0.1,
            volts: 0.0,
            seed: 7,
        }),
        Event::ReadFails,
        Event::WriteFails,
    ];
    for event in events {
        let text = event.to_string();
        assert_eq!(text.parse(), Ok(event.clone()));
        // JSON has the same text as a string.
        let json = serde_json::to_value(&event).expect("every event has a text");
        assert_eq!(json, text);
        assert_eq!(serde_json::from_value(json).ok(), Some(event));
    }
    assert!(serde_json::from_value::<Event>("jump".into()).is_err());
}

#[test]
fn a_list_keeps_the_order_of_its_cycles_and_in_a_cycle_its_own() {
    let events: Events = "900:halt, 10:key F,10: key g , 300:vr1=8".parse().unwrap();
    assert_eq!(
        events.to_string(),
        "10:key F, 10:key g, 300:VR1=8, 900:halt"
    );
    assert_eq!(" ".parse(), Ok(Events::NONE));
    let nonsense: Events = "3:ANTENNA=nan".parse().unwrap();
    assert_eq!(nonsense.to_string(), "3:ANTENNA=NaN");
}

#[test]
fn what_is_no_event_is_told() {
    for (wrong, reported) in [
        ("halt", "'halt' is not CYCLE:EVENT"),
        ("x:halt", "'x:halt' is not CYCLE:EVENT"),
        ("3:stop", "'stop' is not an event"),
        ("3:key", "'key' is not an event"),
        ("3:key ab", "'key ab' is not an event"),
        ("3:VR9=1", "'VR9=1' is not an event"),
        ("3:VR1=x", "'VR1=x' is not an event"),
        ("3:push 1 2 for 3", "'push 1 2 for 3' is not an event"),
        (
            "3:push 1 2 inf for 3",
            "'push 1 2 inf for 3' is not an event",
        ),
        ("3:push 1 2 3", "'push 1 2 3' is not an event"),
        ("3:noise -1 0 seed 1", "'noise -1 0 seed 1' is not an event"),
        ("3:noise 1 0", "'noise 1 0' is not an event"),
        ("3:halt,", "'' is not CYCLE:EVENT"),
    ] {
        let error = wrong.parse::<Events>().expect_err(wrong).to_string();
        assert!(error.starts_with(reported), "{error}");
    }
}
