/* Memory runs out at every single allocation while gnuplot draws: the picture is refused, and nobody waits for gnuplot, which waits
 * for somebody to read on. */
#include "unit/check.h"

#include <stdlib.h>
#include <unistd.h>

#include "fault/failing_memory.h"
#include "report/picture.h"

/* A picture several times as large as what a pipe holds. */
static void no_failure_leaves_gnuplot_waiting(void **unused)
{
    static const char whole[] = "set terminal svg\nset samples 20000\nplot sin(x)\n";
    const size_t length = sizeof whole - 1;
    char *picture = NULL;
    size_t size = 0;
    jlt_status st = JLT_ERR_NOMEM;
    long k;

    (void)unused;
    assert_int_equal(jlt_picture_draw(&picture, &size, whole, length), JLT_OK);
    assert_true(size > 4 * 65536);
    free(picture);
    alarm(60); /* a deadlock ends the test */
    for (k = 0; st == JLT_ERR_NOMEM; k++) {
        failing = k;
        st = jlt_picture_draw(&picture, &size, whole, length);
        if (st != JLT_OK) assert_null(picture);
        failing = -1;
    }
    alarm(0);
    assert_int_equal(st, JLT_OK);
    assert_true(k > 3); /* the buffer grew, and each time could not */
    free(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(no_failure_leaves_gnuplot_waiting) };

    if (system("gnuplot --version > /dev/null 2>&1") != 0) return 77;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
