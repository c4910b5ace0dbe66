3.1
A value is set, then changed in each way
DEF_VAR N
N = 8
N += 2                       // 10
N -= 4                       // 6
N *= 3                       // 18
N /= 9                       // 2
MESSAGE N is %N%
END
