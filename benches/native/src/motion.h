/* A robot as C programs ask it, and what a step of a motion comes to. */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum flow { NEXT, WAIT, FINISHED, FAULT };

struct value {
  double v;
  bool relative;
};

struct command {
  uint8_t op;
  uint8_t target;
  bool hs;
  const struct value *values;
  size_t count;
};

struct robot {
  /* Answers NEXT, WAIT or FAULT. */
  int (*ask)(struct robot *, const struct command *);
  uint64_t asked;
  void *context;
};

static inline int ask(struct robot *robot, uint8_t op, uint8_t target,
                      const struct value *values, size_t count) {
  struct command command = {op, target, false, values, count};
  return robot->ask(robot, &command);
}
