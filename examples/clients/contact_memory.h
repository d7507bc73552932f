/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the contacts of a step remember: on which segment of the law each is, and its record of friction. The records follow each
 * other in one array, as the law takes them. Contacts are found by their grains; those of a step begin an empty one. */
#ifndef CONTACT_MEMORY_H
#define CONTACT_MEMORY_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct contact_memory {
    int room, count, record; /* contacts at most, now; numbers in a record */
    int bits, *slot;         /* 2^bits slots of a hash table: the number of a contact, -1 for none */
    uint64_t *pair;          /* the tags of its grains, the smaller one first */
    int *segment;
    double *records;
} contact_memory;

static void *room_for(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (!memory) exit(EXIT_FAILURE);
    return memory;
}

static contact_memory memory_for(int contacts, int record)
{
    contact_memory m = {contacts, 0, record, 1, NULL, NULL, NULL, NULL};
    while ((1 << m.bits) < 2 * contacts) m.bits++;
    m.slot = room_for((size_t)1 << m.bits, sizeof *m.slot);
    m.pair = room_for((size_t)contacts, sizeof *m.pair);
    m.segment = room_for((size_t)contacts, sizeof *m.segment);
    m.records = room_for((size_t)contacts * (size_t)record + 1, sizeof *m.records);
    memset(m.slot, -1, sizeof *m.slot << m.bits);
    return m;
}

static void free_memory(contact_memory *m)
{
    free(m->slot);
    free(m->pair);
    free(m->segment);
    free(m->records);
}

static void forget(contact_memory *m)
{
    m->count = 0;
    memset(m->slot, -1, sizeof *m->slot << m->bits);
}

static uint64_t pair_of(int tag, int other)
{
    return tag < other ? (uint64_t)tag << 32 | (uint64_t)other : (uint64_t)other << 32 | (uint64_t)tag;
}

/* Where the number of a contact stands, or would. */
static int *find(const contact_memory *m, uint64_t pair)
{
    uint64_t at = pair * UINT64_C(0x9E3779B97F4A7C15) >> (64 - m->bits);
    while (m->slot[at] >= 0 && m->pair[m->slot[at]] != pair) at = (at + 1) & ((UINT64_C(1) << m->bits) - 1);
    return m->slot + at;
}

/* One contact more, with the record of the step before, NULL: of a contact that begins. Returns its number. */
static int remember(contact_memory *m, uint64_t pair, int segment, const double *record)
{
    const size_t bytes = (size_t)m->record * sizeof *m->records;
    double *own = m->records + (size_t)m->count * (size_t)m->record;
    if (m->count == m->room) {
        fprintf(stderr, "more than %d contacts\n", m->room);
        exit(EXIT_FAILURE);
    }
    *find(m, pair) = m->count;
    m->pair[m->count] = pair;
    m->segment[m->count] = segment;
    if (record) memcpy(own, record, bytes);
    else memset(own, 0, bytes);
    return m->count++;
}

#endif
