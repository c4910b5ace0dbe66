/* walk.prg as a static library. All angles are in degrees. The comments of src/lib.rs say more. */
#ifndef WALK_H
#define WALK_H

#ifdef __cplusplus
extern "C" {
#endif

enum { WALK_LEGS = 4, WALK_JOINTS = 3 };

typedef struct {
    double angles[WALK_LEGS][WALK_JOINTS]; /* measured */
} walk_sensors;

typedef struct {
    double angles[WALK_LEGS][WALK_JOINTS]; /* commanded */
    double rates[WALK_LEGS][WALK_JOINTS];  /* deg/s */
} walk_outputs;

enum { WALK_RUNNING = 0, WALK_ENDED = 1, WALK_EMERGENCY = 2, WALK_NOT_STARTED = 3 };

/* Starts the program anew, and gives the initial posture. Returns the sampling time, ms. */
double walk_start(walk_outputs *outputs);

/* Runs one control cycle. Call it once in each sampling time, from one thread. */
int walk_cycle(const walk_sensors *sensors, walk_outputs *outputs);

#ifdef __cplusplus
}
#endif

#endif
