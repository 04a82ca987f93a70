# gcc 14.2 of Debian 13 turns choices by a bit of a word around: of (mask >> k) & 1 ? a : k it computes k where the bit is set, and
# of k == 1 || k == 7 ? a : k as well, which it makes such a choice. Its first pass of if-conversion does; later ones do not.
include(CheckCSourceRuns)
if(NOT CMAKE_CROSSCOMPILING)
  set(CMAKE_REQUIRED_FLAGS -O2)
  check_c_source_runs("
    __attribute__((noinline)) static int choose(unsigned k) { return (0x82u >> k) & 1 ? 10 : (int)k; }
    int main(void)
    {
        volatile unsigned set = 7, clear = 2;
        return choose(set) != 10 || choose(clear) != 2;
    }" JLT_CHOOSES_BY_BIT)
  unset(CMAKE_REQUIRED_FLAGS)
  if(NOT JLT_CHOOSES_BY_BIT)
    add_compile_options(-fno-if-conversion)
  endif()
endif()
