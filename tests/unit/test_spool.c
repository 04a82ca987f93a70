/* The spool gives back what was put in, sequence by sequence, whatever the order of writing, with few records in memory. */
#include "unit/check.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "core/spool.h"

enum { SEQUENCES = 7, WIDTH = 3 };

static void fill(double *record, size_t sequence, size_t number)
{
    record[0] = (double)sequence;
    record[1] = (double)number;
    record[2] = 1 / (1 + (double)(sequence + number));
}

/* Sequences of 0, 1, room - 1, room, room + 1, 5 room and 5 room + 2 records, added in a random order. */
static void every_sequence_is_read_as_it_was_written(void **unused)
{
    (void)unused;
    for (size_t room = 1; room <= 64; room *= 4) {
        const size_t lengths[SEQUENCES] = { 0, 1, room - 1, room, room + 1, 5 * room, 5 * room + 2 };
        jlt_spool *spool;
        size_t left = 0, added[SEQUENCES] = { 0 };
        uint64_t seed = 1;

        assert_int_equal(jlt_spool_create(&spool, WIDTH, SEQUENCES, room), JLT_OK);
        for (size_t s = 0; s < SEQUENCES; s++) left += lengths[s];
        while (left > 0) {
            const size_t s = (size_t)((seed = seed * 6364136223846793005u + 1442695040888963407u) >> 33) % SEQUENCES;
            double record[WIDTH];
            if (added[s] == lengths[s]) continue;
            fill(record, s, added[s]++);
            assert_int_equal(jlt_spool_add(spool, s, record), JLT_OK);
            left--;
        }
        for (size_t round = 0; round < 2; round++)
            for (size_t s = SEQUENCES; s-- > 0;) {
                double record[WIDTH], expected[WIDTH];
                jlt_spool_rewind(spool, s);
                for (size_t n = 0; n < lengths[s]; n++) {
                    fill(expected, s, n);
                    assert_int_equal(jlt_spool_read(spool, record), JLT_OK);
                    assert_memory_equal(record, expected, sizeof record);
                }
                assert_int_equal(jlt_spool_read(spool, record), JLT_ERR_EMPTY);
            }
        jlt_spool_destroy(spool);
    }
}

/* A program that is started while the spool lives does not inherit its file. */
static void the_file_is_closed_in_other_programs(void **unused)
{
    const int next = dup(STDOUT_FILENO); /* the number that the file is going to have */
    double record[WIDTH] = { 0 };
    jlt_spool *spool;

    (void)unused;
    assert_true(next >= 0);
    assert_int_equal(close(next), 0);
    assert_int_equal(jlt_spool_create(&spool, WIDTH, 1, 1), JLT_OK);
    assert_int_equal(fcntl(next, F_GETFD), -1);
    assert_int_equal(jlt_spool_add(spool, 0, record), JLT_OK);
    assert_int_equal(jlt_spool_add(spool, 0, record), JLT_OK);
    assert_int_equal(fcntl(next, F_GETFD), FD_CLOEXEC);
    jlt_spool_destroy(spool);
}

static void without_a_folder_memory_alone_serves(void **unused)
{
    jlt_spool *spool;
    double record[WIDTH] = { 0 };

    (void)unused;
    assert_int_equal(setenv("TMPDIR", "/no/such/folder", 1), 0);
    assert_int_equal(jlt_spool_create(&spool, WIDTH, 1, 2), JLT_OK);
    assert_int_equal(jlt_spool_add(spool, 0, record), JLT_OK);
    assert_int_equal(jlt_spool_add(spool, 0, record), JLT_OK);
    assert_int_equal(jlt_spool_add(spool, 0, record), JLT_ERR_IO);
    assert_int_equal(unsetenv("TMPDIR"), 0);
    jlt_spool_destroy(spool);
    assert_int_equal(jlt_spool_create(&spool, 0, 1, 2), JLT_ERR_ARG);
    assert_int_equal(jlt_spool_create(&spool, 1, (size_t)1 << 60, 1 << 10), JLT_ERR_NOMEM);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_sequence_is_read_as_it_was_written),
        cmocka_unit_test(the_file_is_closed_in_other_programs),
        cmocka_unit_test(without_a_folder_memory_alone_serves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
