/* What the library tells of kernels that rest on claims without a proof: descriptors made up here, as those that are built in have
 * proofs. */
#include "unit/check.h"

#include "kernel/descriptor.h"

static const jlt_descriptor proved, general, chart, timed;
static const jlt_descriptor *const proved_family[] = { &proved, NULL };
static const jlt_descriptor *const top_family[] = { &general, &chart, &timed, NULL };

static const jlt_descriptor proved = { .model = "proved", .variant = "", .time = "", .elimination = "", .family = proved_family };
static const jlt_descriptor general = { .model = "top", .variant = "", .time = "", .elimination = "", .unproved = "integral F",
                                        .family = top_family };
static const jlt_descriptor chart = { .model = "top", .variant = "", .time = "", .elimination = "e",
                                      .unproved = "integral F, eliminate e", .family = top_family };
static const jlt_descriptor timed = { .model = "top", .variant = "", .time = "t", .elimination = "", .unproved = "time t",
                                      .family = top_family };

static void claims_of_all_descriptors_of_a_model_are_told_once(void **unused)
{
    char claims[128];
    (void)unused;
    assert_true(jlt_descriptor_unproved(claims, sizeof claims, &general));
    assert_string_equal(claims, "integral F, eliminate e, time t");
}

static void a_proved_model_has_no_such_claims(void **unused)
{
    char claims[128] = "before";
    (void)unused;
    assert_false(jlt_descriptor_unproved(claims, sizeof claims, &proved));
    assert_string_equal(claims, "");
}

static void a_list_that_is_too_long_is_cut_within_its_room(void **unused)
{
    char claims[16];
    (void)unused;
    memset(claims, 'x', sizeof claims);
    assert_true(jlt_descriptor_unproved(claims, 12, &timed));
    assert_true(strlen(claims) < 12);
    assert_memory_equal(claims, "integral F", 10);
    assert_true(claims[12] == 'x');
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(claims_of_all_descriptors_of_a_model_are_told_once),
                                        cmocka_unit_test(a_proved_model_has_no_such_claims),
                                        cmocka_unit_test(a_list_that_is_too_long_is_cut_within_its_room) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
