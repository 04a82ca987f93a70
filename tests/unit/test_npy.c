/* An array of NumPy from a table's text, however that is cut, and whatever its columns turn out to be. Oracle: the bytes that the
 * format says, written down here. */
#include "unit/check.h"

#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "report/csv.h"
#include "report/npy.h"

static const char decimal[] =
    "# first\nn,late,word,empty\n1,2.5,,\n-0,,a,\n0.1,1e-05,bc,\n# between\n3,eighteen letters..,abcdefghi,\n4,x,,\n# last\n";

static char *write_in_pieces(const char *text, size_t length, size_t piece, size_t *size)
{
    char path[] = "/tmp/jellett_npy_XXXXXX", *data = calloc(1, 4096);
    jlt_npy *array = NULL;
    jlt_file place;
    FILE *file;

    close(mkstemp(path));
    assert_ok(jlt_file_begin(&place, path));
    assert_ok(jlt_npy_create(&array, &place));
    for (size_t at = 0; at < length; at += piece)
        assert_ok(jlt_npy_take(array, text + at, piece < length - at ? piece : length - at));
    assert_ok(jlt_file_commit(&place));
    jlt_npy_destroy(array);
    jlt_file_end(&place);
    file = fopen(path, "r");
    *size = fread(data, 1, 4096, file);
    fclose(file);
    unlink(path);
    return data;
}

static double number_at(const char *data)
{
    double value;

    memcpy(&value, data, sizeof value);
    return value;
}

static void columns_become_texts_when_their_fields_show_it(void **unused)
{
    static const char head[] =
        "{'descr': [('n', '<f8'), ('late', '|S32'), ('word', '|S32'), ('empty', '<f8')], 'fortran_order': False, "
        "'shape': (5,), }";
    static const char *const late[] = { "2.5", "", "1e-05", "eighteen letters..", "x" }, *const word[] = { "", "a", "bc",
                                                                                                           "abcdefghi", "" };
    static const double n[] = { 1, -0.0, 0.1, 3, 4 };

    (void)unused;
    for (size_t piece = 1; piece < sizeof decimal + 1; piece++) {
        size_t size = 0;
        char *data = write_in_pieces(decimal, sizeof decimal - 1, piece, &size), *rows = data + 192;
        assert_memory_equal(data, "\x93NUMPY\1\0\xb6\0", 10);
        assert_memory_equal(data + 10, head, sizeof head - 1);
        for (size_t i = 10 + sizeof head - 1; i < 191; i++) assert_int_equal(data[i], ' ');
        assert_int_equal(rows[-1], '\n');
        for (size_t i = 0; i < 5; i++, rows += 80) {
            assert_memory_equal(rows, &n[i], 8);
            assert_string_equal(rows + 8, late[i]);
            assert_string_equal(rows + 40, word[i]);
            assert_true(number_at(rows + 72) != number_at(rows + 72));
        }
        assert_string_equal(rows, "# first\n# between\n# last\n");
        assert_int_equal(size, (size_t)(rows - data) + strlen(rows));
        free(data);
    }
}

/* A table in which numbers are decimal or bits, of the same bytes as an array: `early` is a text from the first row on, `late`
 * becomes one after some. */
static char *mixed_table(void (*write)(FILE *, const double *, size_t), size_t *size)
{
    static const double endings[] = { 0x1.a0a0a0a0a0a0ap10, 0x1.c2c230a2c230ap-30, 0x1.0000000a00000p0, -0x1.1010101010101p-1 };
    const double n[] = { 0.1, -0.0, NAN, INFINITY, 1e-320, 1e300 };
    char *text = NULL;
    FILE *file = open_memstream(&text, size);

    fputs("a,b,c,d,early,late,word\n", file);
    for (unsigned row = 0; row < 9; row++) {
        write(file, endings, 4);
        fputc(',', file);
        if (row == 0) fputs("x", file);
        else write(file, &endings[row % 4], 1); /* more digits than a text of this column has letters so far */
        fputc(',', file);
        if (row == 6) fputs("x", file);
        else write(file, &n[row % 6], 1);
        fputs(",\1\n", file); /* a text that begins like bits */
    }
    assert_int_equal(fclose(file), 0);
    return text;
}

static void numbers_may_be_bits(void **unused)
{
    size_t expected = 0, length = 0, size = 0;
    char *text = mixed_table(jlt_csv_values, &length), *array = write_in_pieces(text, length, length, &expected);

    (void)unused;
    free(text);
    text = mixed_table(jlt_csv_bits, &length);
    for (size_t piece = 1; piece <= length; piece++) {
        char *data = write_in_pieces(text, length, piece, &size);
        assert_int_equal(size, expected);
        assert_memory_equal(data, array, expected);
        free(data);
    }
    free(text);
    free(array);
}

static void what_is_no_table_is_refused(void **unused)
{
    static const char *const good[] = { "a,b\n1,2\n", "a,b\n1,2\n", "a,a,a\n" }, *const bad[] = { "1\n", "1,2,3\n", "1,2\n" };
    char path[] = "/tmp/jellett_npy_XXXXXX";
    jlt_npy *array = NULL;
    jlt_file place;

    (void)unused;
    close(mkstemp(path));
    for (size_t i = 0; i < 3; i++) {
        assert_ok(jlt_file_begin(&place, path));
        assert_ok(jlt_npy_create(&array, &place));
        assert_ok(jlt_npy_take(array, good[i], strlen(good[i])));
        assert_int_equal(jlt_npy_take(array, bad[i], strlen(bad[i])), JLT_ERR_ARG);
        assert_int_equal(jlt_npy_take(array, "1,2\n", 4), JLT_ERR_ARG);
        assert_int_equal(jlt_file_commit_lines(&place), JLT_ERR_EMPTY); /* also the row before: a file that is there stays */
        jlt_npy_destroy(array);
        jlt_file_end(&place);
    }
    unlink(path);
    assert_ok(jlt_file_begin(&place, "/dev/null"));
    assert_int_equal(jlt_npy_create(&array, &place), JLT_ERR_UNSUPPORTED);
    jlt_file_end(&place);
}

/* The number of the write that fails after half of its bytes; 0: none. */
static unsigned fails, puts_made;

jlt_status __real_jlt_file_put(const jlt_file *self, const char *data, size_t size, size_t offset);
jlt_status __wrap_jlt_file_put(const jlt_file *self, const char *data, size_t size, size_t offset);
jlt_status __wrap_jlt_file_put(const jlt_file *self, const char *data, size_t size, size_t offset)
{
    if (++puts_made != fails) return __real_jlt_file_put(self, data, size, offset);
    assert_ok(__real_jlt_file_put(self, data, size / 2, offset));
    errno = ENOSPC;
    return JLT_ERR_IO;
}

static void a_row_is_saved_as_it_was_taken_or_not_at_all(void **unused)
{
    enum { ROWS = 24 };
    char path[] = "/tmp/jellett_npy_XXXXXX", data[8192];

    (void)unused;
    close(mkstemp(path));
    for (bool whole = false; !whole; fails = whole ? 0 : fails + 1) {
        jlt_npy *array = NULL;
        jlt_file place;
        unsigned width, rows;
        puts_made = 0;
        assert_ok(jlt_file_begin(&place, path));
        assert_ok(jlt_npy_create(&array, &place));
        jlt_status st = jlt_npy_take(array, "n,word\n", 7);
        for (int i = 0; st == JLT_OK && i < ROWS; i++) { /* words, then longer ones, so that rows in the file move twice */
            const int digits = i < 8 ? 1 : i < 16 ? 50 : 200;
            st = jlt_npy_take(array, data, (size_t)sprintf(data, "%d,%0*d%s\n", i, digits, i, i < 8 ? "" : "x"));
        }
        whole = st == JLT_OK && puts_made < fails;
        if (jlt_file_commit_lines(&place) == JLT_OK) {
            FILE *file = fopen(path, "r");
            data[fread(data, 1, sizeof data - 1, file)] = '\0';
            fclose(file);
            const char *type = strstr(data + 10, "'word', '") + 9, *row = data + 10 + (unsigned char)data[8];
            if (sscanf(type, "|S%u", &width) != 1) width = 8;
            assert_int_equal(sscanf(strstr(data + 10, "'shape'"), "'shape': (%u", &rows), 1);
            for (unsigned i = 0; i < rows; i++, row += 8 + width) {
                assert_true(number_at(row) == i);
                assert_true((*type == '|' ? strtod(row + 8, NULL) : number_at(row + 8)) == i);
            }
            assert_true(!whole || rows == ROWS);
        }
        jlt_npy_destroy(array);
        jlt_file_end(&place);
    }
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_become_texts_when_their_fields_show_it),
        cmocka_unit_test(numbers_may_be_bits),
        cmocka_unit_test(what_is_no_table_is_refused),
        cmocka_unit_test(a_row_is_saved_as_it_was_taken_or_not_at_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
