#include "core/guard.h"

void jlt_guard_enter(jlt_guard *guard)
{
    feholdexcept(&guard->saved);
    fesetround(FE_TONEAREST);
}

jlt_status jlt_guard_leave(jlt_guard *guard)
{
    const int raised = fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW);

    fesetenv(&guard->saved);
    if (raised & (FE_DIVBYZERO | FE_INVALID)) return JLT_ERR_DOMAIN;
    return raised == 0 ? JLT_OK : JLT_ERR_NONFINITE;
}

jlt_status jlt_guard_leave_finite(jlt_guard *guard)
{
    const int overflowed = fetestexcept(FE_OVERFLOW);

    fesetenv(&guard->saved);
    return overflowed == 0 ? JLT_OK : JLT_ERR_NONFINITE;
}
