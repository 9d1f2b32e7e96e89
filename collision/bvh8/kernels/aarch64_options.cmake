# The instructions of Highway's NEON target: g++ can't inline it into functions that are compiled without them.
set(CAMPUSWALK_KERNEL_OPTIONS -march=armv8-a+crypto)
