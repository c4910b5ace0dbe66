3.2
Computed faults fail when they run
DEF_VAR A
A = 1E308 * 10
END
