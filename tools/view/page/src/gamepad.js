// A gamepad with the standard mapping, as sticks, button and keys of a robot. Browsers show gamepads to secure pages: this machine's, and
// those of https.

/** Deflections below this are none. */
const DEAD = 0.1;
/** Reading of a stick at rest, and how far it goes: V. */
const REST = 5;
/** Buttons: B or circle, menu, right trigger. */
const [STOP, HALT, HOLD] = [1, 9, 7];

/** Calls `steer(name, volts)`, `hold(on)`, `stop()` and `halt()` as the first gamepad is moved and pressed. */
export function gamepad({ steer, hold, stop, halt }) {
  if (!navigator.getGamepads) return;
  const shown = {};
  const changed = (name, value) => {
    const before = shown[name];
    shown[name] = value;
    return before !== value && !(before === undefined && !value);
  };
  const look = () => {
    const pad = [...navigator.getGamepads()].find((one) => one?.connected && one.mapping === 'standard');
    const axis = (number, way) => {
      const value = pad?.axes[number] ?? 0;
      return Math.abs(value) < DEAD ? 0 : Math.round(10 * way * value * REST) / 10;
    };
    const isDown = (number) => Boolean(pad?.buttons[number]?.pressed);
    // The emergency stop first.
    if (changed('stop', isDown(STOP)) && shown.stop) stop();
    for (const [name, volts] of [['VR1', axis(1, -1)], ['VR2', axis(0, -1)], ['VR3', axis(2, 1)]]) {
      if (changed(name, volts)) steer(name, REST + volts);
    }
    if (changed('hold', isDown(HOLD))) hold(shown.hold);
    if (changed('halt', isDown(HALT)) && shown.halt) halt();
    // Pages that are not seen draw nothing: the gamepad is not read then.
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}
