"""Environments for learning: gymnasium's VectorEnv, and that of stable-baselines3, over one native batch."""

from collections.abc import Mapping, Sequence
from os import PathLike

import gymnasium as gym
import numpy as np
from gymnasium.vector.utils import batch_space

from . import _arguments as arguments
from . import _native
from ._sweep import spec


class VecEnv(gym.vector.VectorEnv):
    """Runs of a program side by side. Actions set variables of the program, which it reads in a loop of its own.

    `actions` maps variables to their bounds, `observations` are names that `Run.read` takes, and the reward of a step is the
    increase of `reward`, one of these names. A step is `cycles` control cycles. An environment terminates when its program ends or
    its robot falls, which costs `fall` of reward, and is truncated after `until` s. The other options are those of `spec`: each
    episode is the next case, so that random values in `vary` randomise the surroundings.
    """

    metadata = {"autoreset_mode": gym.vector.AutoresetMode.SAME_STEP}

    def __init__(
        self,
        program: str | PathLike,
        num_envs: int,
        *,
        actions: Mapping[str, tuple[float, float]],
        observations: Sequence[str],
        reward: str = "forward",
        fall: float = 0.0,
        cycles: int = 5,
        **options,
    ):
        options.setdefault("repeat", 1_000_000)
        self.num_envs = arguments.count("num_envs", num_envs, 1)
        self._fall = arguments.number("fall", fall)
        cycles = arguments.count("cycles", cycles, 1)
        if not isinstance(reward, str):
            raise arguments.wrong("reward", "a name", reward)
        observations = arguments.names("observations", observations)
        low, high = _bounds(actions)
        names = [*observations, reward, "falls"]
        self._batch = _native.Batch(spec(program, **options), num_envs, list(actions), names, cycles)
        self._next = num_envs
        self.single_action_space = gym.spaces.Box(low, high)
        self.single_observation_space = gym.spaces.Box(-np.inf, np.inf, (len(observations),), np.float32)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._last = self._read()

    def _read(self):
        numbers = np.frombuffer(self._batch.observe(), "<f8").reshape(self.num_envs, -1)
        return np.nan_to_num(numbers)

    def _restart(self, index):
        self._batch.reset(index, self._next)
        self._next += 1

    def reset(self, *, seed=None, options=None):
        """Starts all environments. With a seed, their cases count from there."""
        if seed is not None:
            self._next = arguments.count("seed", seed)
        for index in range(self.num_envs):
            self._restart(index)
        self._last = self._read()
        return self._last[:, :-2].astype(np.float32), {}

    def step(self, actions):
        """Sets the actions and runs the cycles of a step."""
        actions = np.ascontiguousarray(actions, "<f8").reshape(self.num_envs, -1)
        ends = np.frombuffer(self._batch.step(actions.tobytes()), np.uint8)
        now = self._read()
        falls = now[:, -1] > self._last[:, -1]
        rewards = now[:, -2] - self._last[:, -2] - self._fall * falls
        terminated, truncated = (ends == 1) | falls, (ends == 2) & ~falls
        done, infos = terminated | truncated, {}
        if done.any():
            # One element for each environment, as gymnasium's own environments have it: an array, or None.
            final = np.full(self.num_envs, None, object)
            for index in np.flatnonzero(done):
                final[index] = now[index, :-2].astype(np.float32)
            infos = {"final_obs": final, "_final_obs": done}
            for index in np.flatnonzero(done):
                self._restart(index)
            now = self._read()
        self._last = now
        return now[:, :-2].astype(np.float32), rewards, terminated, truncated, infos


def _bounds(actions):
    """Returns the least and the greatest values of actions."""
    if not isinstance(actions, Mapping) or not actions:
        raise arguments.wrong("actions", "a mapping of variables to their bounds", actions)
    for name, bounds in actions.items():
        if not isinstance(bounds, Sequence) or isinstance(bounds, str) or len(bounds) != 2:
            raise arguments.wrong(f"actions[{name!r}]", "a pair of bounds", bounds)
        low, high = (arguments.number(f"actions[{name!r}]", bound) for bound in bounds)
        if low >= high:
            raise arguments.wrong(f"actions[{name!r}]", "a lower bound and a higher one", bounds)
    return (np.array(bound, np.float32) for bound in zip(*actions.values()))


def sb3_vec_env(*arguments, **options):
    """Returns a stable-baselines3 VecEnv; the arguments are those of `VecEnv`."""
    from stable_baselines3.common.vec_env import VecEnv as Base

    class Adapter(Base):
        def __init__(self, env):
            self._env, self._actions = env, None
            super().__init__(env.num_envs, env.single_observation_space, env.single_action_space)

        def reset(self):
            observations, _ = self._env.reset(seed=self._seeds[0])
            self._reset_seeds()
            return observations

        def step_async(self, actions):
            self._actions = actions

        def step_wait(self):
            observations, rewards, terminated, truncated, infos = self._env.step(self._actions)
            each = [{} for _ in range(self.num_envs)]
            for index in np.flatnonzero(terminated | truncated):
                each[index] = {"terminal_observation": infos["final_obs"][index], "TimeLimit.truncated": bool(truncated[index])}
            return observations, rewards.astype(np.float32), terminated | truncated, each

        def close(self):
            self._env.close()

        def get_attr(self, name, indices=None):
            return [getattr(self._env, name)] * len(list(self._get_indices(indices)))

        def set_attr(self, name, value, indices=None):
            setattr(self._env, name, value)

        def env_method(self, name, *arguments, indices=None, **options):
            return [getattr(self._env, name)(*arguments, **options)] * len(list(self._get_indices(indices)))

        def env_is_wrapped(self, wrapper_class, indices=None):
            return [False] * len(list(self._get_indices(indices)))

    return Adapter(VecEnv(*arguments, **options))
