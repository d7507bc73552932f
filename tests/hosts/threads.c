/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A host of 16 threads, in which each makes every kind of long call, each in another order: the same bits as one thread alone.
   ThreadSanitizer makes each of them 20 times as long; it finds a race between 4, too. */
#include "../c/long_calls.h"

#include <pthread.h>

#ifdef __SANITIZE_THREAD__
enum { THREADS = 4 };
#else
enum { THREADS = 16 };
#endif

static numbers expected[LONG_CALLS];

typedef struct task {
    int number, different;
} task;

static void *run(void *of)
{
    task *const mine = of;
    numbers *const found = malloc(sizeof *found);
    for (int i = 0; i < LONG_CALLS && found; i++) {
        const int k = (i + mine->number) % LONG_CALLS;
        found->count = 0;
        long_calls[k].run(found);
        if (found->count != expected[k].count
            || memcmp(found->values, expected[k].values, (size_t)found->count * sizeof(double)) != 0) {
            fprintf(stderr, "%s differs in thread %d\n", long_calls[k].name, mine->number);
            mine->different++;
        }
    }
    free(found);
    return NULL;
}

int main(void)
{
    pthread_t threads[THREADS];
    task tasks[THREADS];

    for (int i = 0; i < LONG_CALLS; i++) long_calls[i].run(&expected[i]);
    for (int i = 0; i < THREADS; i++) {
        tasks[i] = (task){i, 0};
        CHECK_INT(pthread_create(&threads[i], NULL, run, &tasks[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
        CHECK_INT(tasks[i].different, 0);
    }
    printf("threads: %d thread groups\n", THREADS * LONG_CALLS);
    return check_report("threads");
}
