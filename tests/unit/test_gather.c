/* A piece that is gathered is the one that was in the file when it was checked, or none. */
#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "shards/gather.h"

static const char study[] = "{\"pieces\":2}", other_study[] = "{\"pieces\":2,\"a\":1}";
static const char *const rows[] = { "x\n1\n", "x\n2\n" };

/* The file of a shard: both pieces, of the same length, in either order. */
static void write_shard(const char *path, const char *of, size_t first, const char *const text[2])
{
    jlt_shard shard;
    pid_t holder;

    assert_ok(jlt_shard_open(&shard, &holder, path));
    assert_ok(jlt_shard_begin(&shard, of));
    for (size_t i = 0; i < 2; i++) {
        const size_t piece = (first + i) % 2;
        const jlt_shard_record record = { .piece = piece, .rows = text[piece], .rows_size = strlen(text[piece]) };
        assert_ok(jlt_shard_add(&shard, &record));
    }
    jlt_shard_close(&shard);
}

static void a_shard_that_is_written_anew_meanwhile_is_not_taken(void **unused)
{
    static const char *const other_rows[] = { "x\n3\n", "x\n4\n" };
    char path[] = "/tmp/gather-XXXXXX", *message;
    const char *const paths[] = { path };
    const int made = mkstemp(path);
    jlt_shard_record record;
    jlt_gather *gather;
    (void)unused;

    assert_true(made >= 0);
    close(made);
    write_shard(path, study, 0, rows);
    assert_ok(jlt_gather_open(&gather, &message, paths, 1));
    for (size_t i = 0; i < 2; i++) {
        assert_ok(jlt_gather_piece(gather, &record, i));
        assert_int_equal(record.piece, i);
        assert_memory_equal(record.rows, rows[i], strlen(rows[i]));
    }
    write_shard(path, study, 1, rows);
    assert_int_equal(jlt_gather_piece(gather, &record, 0), JLT_ERR_IO);
    write_shard(path, study, 0, other_rows);
    assert_int_equal(jlt_gather_piece(gather, &record, 0), JLT_ERR_IO);
    write_shard(path, other_study, 0, rows);
    assert_int_equal(jlt_gather_piece(gather, &record, 0), JLT_ERR_IO);
    write_shard(path, study, 0, rows);
    assert_ok(jlt_gather_piece(gather, &record, 1));
    jlt_gather_destroy(gather);
    free(message);
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(a_shard_that_is_written_anew_meanwhile_is_not_taken) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
