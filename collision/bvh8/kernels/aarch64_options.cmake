# Highway compiles its NEON target with these instructions; g++ inlines nothing into functions compiled without them.
set(CAMPUSWALK_KERNEL_OPTIONS -march=armv8-a+crypto)
