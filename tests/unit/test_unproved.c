/* What the library tells of kernels that rest on claims without a proof. The registry here stands in for that of the models
 * built in, all of whose claims are proved. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "kernel/descriptor.h"
#include "registry.h"

#include <string.h>

static const jlt_descriptor proved = { .model = "proved", .variant = "", .time = "", .elimination = "" };
static const jlt_descriptor general = { .model = "top", .variant = "", .time = "", .elimination = "", .unproved = "integral F" };
static const jlt_descriptor chart = { .model = "top", .variant = "", .time = "", .elimination = "e",
                                      .unproved = "integral F, eliminate e" };
static const jlt_descriptor timed = { .model = "top", .variant = "", .time = "t", .elimination = "", .unproved = "time t" };

const jlt_descriptor *const jlt_registry[] = { &proved, &general, &chart, &timed };
const unsigned jlt_registry_count = 4;

static void claims_of_all_descriptors_of_a_model_are_told_once(void **unused)
{
    char claims[128];
    (void)unused;
    assert_true(jlt_descriptor_unproved(claims, sizeof claims, "top"));
    assert_string_equal(claims, "integral F, eliminate e, time t");
}

static void a_proved_model_and_one_that_is_not_there_have_no_such_claims(void **unused)
{
    char claims[128] = "before";
    (void)unused;
    assert_false(jlt_descriptor_unproved(claims, sizeof claims, "proved"));
    assert_string_equal(claims, "");
    assert_false(jlt_descriptor_unproved(claims, sizeof claims, "absent"));
}

static void a_list_that_is_too_long_is_cut_within_its_room(void **unused)
{
    char claims[16];
    (void)unused;
    memset(claims, 'x', sizeof claims);
    assert_true(jlt_descriptor_unproved(claims, 12, "top"));
    assert_true(strlen(claims) < 12);
    assert_memory_equal(claims, "integral F", 10);
    assert_true(claims[12] == 'x');
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(claims_of_all_descriptors_of_a_model_are_told_once),
                                        cmocka_unit_test(a_proved_model_and_one_that_is_not_there_have_no_such_claims),
                                        cmocka_unit_test(a_list_that_is_too_long_is_cut_within_its_room) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
