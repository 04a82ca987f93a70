/* `prepare` fills the block that the descriptor announces: every entry, and nothing beyond. */
#include "unit/check.h"

#include "kernel/descriptor.h"

enum { ROOM = 4096, PARAMETERS = 64 };

/* A not-a-number whose bits no arithmetic makes. */
static const uint64_t untouched = UINT64_C(0x7ff8dead0000beef);

static bool is_untouched(double entry)
{
    uint64_t bits;
    memcpy(&bits, &entry, sizeof bits);
    return bits == untouched;
}

static void prepare_fills_the_block_and_no_more(void **unused)
{
    static double block[ROOM];
    double params[PARAMETERS];

    (void)unused;
    for (size_t i = 0; i < PARAMETERS; i++) params[i] = 0.5 + (double)i / 16;
    for (size_t d = 0; d < jlt_descriptor_count(); d++) {
        const jlt_descriptor *descriptor = jlt_descriptor_at(d);
        assert_in_range(descriptor->param_count, 0, PARAMETERS);
        assert_in_range(descriptor->prepared_count, 0, ROOM - 1);
        for (size_t i = 0; i < ROOM; i++) memcpy(&block[i], &untouched, sizeof untouched);
        descriptor->prepare(params, block);
        for (size_t i = 0; i < ROOM; i++)
            if (is_untouched(block[i]) != (i >= descriptor->prepared_count))
                fail_msg("%s %s: entry %zu of %u is %s", descriptor->model, descriptor->variant, i, descriptor->prepared_count,
                         is_untouched(block[i]) ? "not written" : "written");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(prepare_fills_the_block_and_no_more) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
