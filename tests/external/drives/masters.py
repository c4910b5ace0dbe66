"""Moves three simulated servos with masters of other makers, and compares what they read. Usage: masters.py SERVO PORT"""

import asyncio
import math
import sys
import time

SERVO, PORT = sys.argv[1:]
IDS = [1, 2, 3]
if SERVO.startswith("moteus"):
    import moteus
    from moteus import fdcanusb_device
elif SERVO.startswith("LX"):
    import lewansoul_lx16a
    import serial
else:
    import dynamixel_sdk as sdk
    import rustypot


def check(what, found, expected, tolerance=0):
    close = all(abs(one - other) <= tolerance for one, other in zip(found, expected, strict=True))
    print(f"{SERVO} {what}: {found}")
    if not close:
        sys.exit(f"{SERVO} {what}: {found} instead of {expected}")


def patient(ask):
    """Repeats a request: the makers' time-outs are short for a machine that does other things as well."""
    for _ in range(20):
        answer = ask()
        if (answer if isinstance(answer, int) else answer[1]) == 0:
            return answer
        time.sleep(0.05)
    sys.exit(f"{SERVO}: {answer}")


def by_rustypot():
    """Radians about the middle; rustypot has counts for XL430."""
    kind = {
        "AX-12": "AxPyController",
        "XL430-W250": "Xl430PyController",
        "STS3215": "Sts3215PyController",
    }[SERVO]
    bus = getattr(rustypot, kind)(PORT, 1_000_000, 0.2)
    for number in IDS:
        assert bus.ping(number), number
    assert not bus.ping(9)
    for number in IDS:
        bus.write_torque_enable(number, True)
    goals = [0.2, -0.3, 0.5]
    raw = SERVO == "XL430-W250"
    counts = [round(2048 + goal / (2 * math.pi) * 4096) for goal in goals]
    bus.sync_write_goal_position(IDS, counts if raw else goals)
    time.sleep(1.5)
    if SERVO == "AX-12":
        found = [bus.read_present_position(number) for number in IDS]
    else:
        found = bus.sync_read_present_position(IDS)
    found = [one[0] if isinstance(one, list) else one for one in found]
    if raw:
        found = [(count - 2048) / 4096 * 2 * math.pi for count in found]
    # A count of an AX is 0.29 deg.
    check("rustypot position", found, goals, math.radians(0.6))
    return goals


def by_sdk(goals):
    """Counts."""
    wide = SERVO != "AX-12"
    port, packet = sdk.PortHandler(PORT), sdk.PacketHandler(2.0 if wide else 1.0)
    assert port.openPort() and port.setBaudRate(1_000_000)
    for number in IDS:
        model, _, error = patient(lambda: packet.ping(port, number))
        assert error == 0, (number, error)
        check("sdk model", [model], [1060 if wide else 12])
    turn, middle = (4096, 2048) if wide else (1228.8, 512)
    counts = [middle + goal / (2 * math.pi) * turn for goal in goals]
    address, size = (132, 4) if wide else (36, 2)
    read = packet.read4ByteTxRx if wide else packet.read2ByteTxRx
    found = []
    for number in IDS:
        value, _, error = patient(lambda: read(port, number, address))
        assert error == 0, (number, error)
        found.append(value)
    check("sdk position", found, counts, 2)
    if wide:
        group = sdk.GroupSyncRead(port, packet, address, size)
        assert all(group.addParam(number) for number in IDS)
        patient(group.txRxPacket)
        together = [group.getData(number, address, size) for number in IDS]
        check("sdk sync read", together, found, 1)
        patient(group.fastSyncRead)
        together = [group.getData(number, address, size) for number in IDS]
        check("sdk fast sync read", together, found, 1)
    goal = sdk.GroupSyncWrite(port, packet, 116 if wide else 30, size)
    for number in IDS:
        goal.addParam(number, list(int(middle).to_bytes(size, "little")))
    assert goal.txPacket() == 0
    time.sleep(1.5)
    found = [patient(lambda: read(port, number, address))[0] for number in IDS]
    check("sdk moved", found, [middle] * 3, 2)
    port.closePort()


def by_lewansoul():
    """Counts of 0.24 deg, mV and °C."""
    line = serial.Serial(PORT, 115200, timeout=1)
    bus = lewansoul_lx16a.ServoController(line, timeout=1)
    check("lewansoul identity", [bus.get_servo_id(number) for number in IDS], IDS)
    check("lewansoul limits", bus.get_position_limits(1), [0, 1000])
    check("lewansoul voltage", [bus.get_voltage(1)], [7400], 50)
    check("lewansoul temperature", [bus.get_temperature(1)], [30], 1)
    for number in IDS:
        bus.motor_on(number)
        assert bus.is_motor_on(number), number
    goals = [450, 620, 500]
    for number, goal in zip(IDS, goals, strict=True):
        bus.move(number, goal, 800)
    time.sleep(1.5)
    check("lewansoul position", [bus.get_position(number) for number in IDS], goals, 1)
    for number in IDS:
        bus.motor_off(number)
        assert not bus.is_motor_on(number), number


async def by_moteus():
    """Turns. A pseudo-terminal is not found among the adapters of this machine: it is said to be one."""
    fdcanusb_device._get_fdcanusb_properties = lambda path: {"is_fdcanusb": True}
    transport = moteus.Fdcanusb(PORT)
    controllers = [moteus.Controller(id=number, transport=transport) for number in IDS]
    for controller in controllers:
        state = await controller.set_stop(query=True)
        assert state.values[moteus.Register.MODE] == moteus.Mode.STOPPED
    goals = [0.1, -0.2, 0.05]
    limits = {"velocity_limit": 0.5, "maximum_torque": 1.0, "watchdog_timeout": math.nan}
    for _ in range(3):
        moves = [
            controller.make_position(position=goal, query=True, **limits)
            for controller, goal in zip(controllers, goals, strict=True)
        ]
        states = await transport.cycle(moves)
        await asyncio.sleep(0.7)
    assert all(state.values[moteus.Register.MODE] == moteus.Mode.POSITION for state in states)
    found = [state.values[moteus.Register.POSITION] for state in states]
    check("moteus position", found, goals, 1e-4)
    # Without commands a controller stops following, and says so.
    await transport.cycle([controllers[0].make_position(position=0.3, watchdog_timeout=0.1)])
    await asyncio.sleep(0.5)
    state = await controllers[0].query()
    assert state.values[moteus.Register.MODE] == moteus.Mode.TIMEOUT, state


if SERVO.startswith("moteus"):
    asyncio.run(asyncio.wait_for(by_moteus(), 30))
elif SERVO.startswith("LX"):
    by_lewansoul()
else:
    goals = by_rustypot()
    if SERVO != "STS3215":
        by_sdk(goals)
