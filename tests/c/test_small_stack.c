/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every kind of long call on a thread with a stack of 128 kB, what a thread has under musl, or of 256 kB if flang compiled the
 * library: none needs more than the header says. */
#define _XOPEN_SOURCE 700 /* pthread_attr_setstack */

#include "long_calls.h"

#include <pthread.h>

enum { KB = 1024, STACK = STACK_KB * KB, MOST = MOST_KB * KB, PAINT = 0xA5 };

typedef struct task {
    void (*run)(numbers *out);
    numbers out;
} task;

static void *run(void *argument)
{
    task *t = argument;
    t->run(&t->out);
    return NULL;
}

static void nothing(numbers *out) { (void)out; }

/* Runs one case on a thread with a stack in the middle of this memory of three stacks; how much it writes to. */
static int used_by(unsigned char *memory, task *t)
{
    pthread_attr_t attributes;
    pthread_t thread;
    int unused = 0;

    memset(memory, PAINT, 3 * STACK);
    CHECK_INT(pthread_attr_init(&attributes), 0);
    CHECK_INT(pthread_attr_setstack(&attributes, memory + 2 * STACK, STACK), 0);
    CHECK_INT(pthread_create(&thread, &attributes, run, t), 0);
    CHECK_INT(pthread_join(thread, NULL), 0);
    CHECK_INT(pthread_attr_destroy(&attributes), 0);
    while (unused < 3 * STACK && memory[unused] == PAINT) unused++;
    return 3 * STACK - unused;
}

int main(void)
{
    unsigned char *memory = aligned_alloc(STACK, 3 * STACK);
    static task here, there;

    there.run = nothing;
    const int base = used_by(memory, &there);
    for (int i = 0; i < LONG_CALLS; i++) {
        here = there = (task){long_calls[i].run, {0, {0.0}}};
        here.run(&here.out);
        const int used = used_by(memory, &there);
        printf("%s: %d kB\n", long_calls[i].name, (used - base) / KB);
        CHECK_TRUE(used <= STACK && used - base <= MOST);
        CHECK_TRUE(here.out.count > 0);
        for (int j = 0; j < here.out.count; j++) CHECK_CLOSE(there.out.values[j], here.out.values[j], 0.0);
    }
    free(memory);
    return check_report("threads with a small stack");
}
