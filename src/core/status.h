/** The status that every fallible function returns, and the macros that pass a failure on and give back what a block holds. */
#ifndef JLT_CORE_STATUS_H
#define JLT_CORE_STATUS_H

#define JLT_STATUS_LIST(X)                                                    \
    X(JLT_OK, "success")                                                      \
    X(JLT_ERR_ARG, "argument outside its contract")                           \
    X(JLT_ERR_DOMAIN, "state or parameter outside the model's domain")        \
    X(JLT_ERR_NONFINITE, "a value is not finite or overflowed on the way")   \
    X(JLT_ERR_NO_CONVERGENCE, "an iteration did not converge")                \
    X(JLT_ERR_NO_PROGRESS, "the step size fell below what time resolves")     \
    X(JLT_ERR_BUDGET, "the budget of steps is spent")                         \
    X(JLT_ERR_EMPTY, "no state has the levels asked for")                     \
    X(JLT_ERR_UNSUPPORTED, "the model has no such kernel")                    \
    X(JLT_ERR_NOMEM, "out of memory")                                         \
    X(JLT_ERR_IO, "input or output failed")

#define JLT_STATUS_ENUM(name, text) name,
typedef enum { JLT_STATUS_LIST(JLT_STATUS_ENUM) } jlt_status;
#undef JLT_STATUS_ENUM

#if defined(__GNUC__)
#define JLT_CHECKED __attribute__((warn_unused_result))
/* Marks a function whose argument number `at` is a printf format for the arguments from number `first` on. */
#define JLT_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define JLT_CHECKED
#define JLT_PRINTF(at, first)
#endif

/* If a call fails, return its status, or the exit status of a command: where there is nothing to clean up. */
#define JLT_PASS(call)                              \
    do {                                            \
        const __typeof__(call) jlt_passed = (call); \
        if (jlt_passed != 0) return jlt_passed;     \
    } while (0)

/* If a call fails, leave its status in `st` and go to the label `done`, where the function cleans up. */
#define JLT_TRY(call)                            \
    do {                                         \
        if ((st = (call)) != JLT_OK) goto done;  \
    } while (0)

/* Marks a variable for which `clear`, called with its address, gives back what it holds where its block ends, however it is left;
 * a pointer to an object of its own is declared by JLT_OWNED, and set to NULL where the object is handed on:
 *     JLT_OWNED(jlt_map) *map = NULL;
 * No JLT_TRY may stand before them in their block. JLT_OWNED_TYPE stands beside the type's destroy. */
#define JLT_CLEARED(clear) __attribute__((cleanup(clear)))
#define JLT_OWNED(type) JLT_CLEARED(type##_destroy_at) type
#define JLT_OWNED_TYPE(type) \
    static inline void type##_destroy_at(type **place) { type##_destroy(*place); }

/* The meaning of a status, one sentence without a full stop; never NULL. */
const char *jlt_status_text(jlt_status status);

#endif
