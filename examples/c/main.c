/* Joints that are at once where they are commanded to be. Prints the bits of each command, a line for each cycle. */
#include "walk.h"
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static void print(const walk_outputs *outputs) {
    for (int leg = 0; leg < WALK_LEGS; leg++) {
        for (int joint = 0; joint < WALK_JOINTS; joint++) {
            uint64_t bits;
            memcpy(&bits, &outputs->angles[leg][joint], sizeof bits);
            printf("%016" PRIx64 "%c", bits, leg + 1 == WALK_LEGS && joint + 1 == WALK_JOINTS ? '\n' : ' ');
        }
    }
}

int main(void) {
    walk_sensors sensors;
    walk_outputs outputs;
    double period = walk_start(&outputs);
    int status = WALK_RUNNING;
    unsigned cycles = 0;
    while (status == WALK_RUNNING) {
        memcpy(sensors.angles, outputs.angles, sizeof sensors.angles);
        status = walk_cycle(&sensors, &outputs);
        print(&outputs);
        cycles++;
    }
    fprintf(stderr, "%u cycles of %g ms, status %d\n", cycles, period, status);
    return status == WALK_ENDED ? 0 : 1;
}
