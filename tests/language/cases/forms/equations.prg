3.1
Every equation
DEF_VAR N B C
DEF_POS P M O
DEF_JOINT Q U Y
B = 3; C = 5
M.X = 1; M.Y = 2; M.Z = 2
O.X = 4; O.Y = 6; O.Z = 8
U.J1 = 2; U.J2 = 3; U.J3 = 6
Y.J1 = 4; Y.J2 = 5; Y.J3 = 16
N = B
N = B + C
N = B - C
N = B * C
N = B / C
N = INT 2.5
N = ABS -4
N = SQRT 9
N = SIN 90
N = COS 0
N = TAN 45
N = ASIN 1
N = ACOS 0
N = ATAN 1
N = DEG2RAD 180
N = RAD2DEG 1
N = ATAN2 1 1
N = NORM M
N = NORM U
N = 12; N += B
N = 12; N += B + C
N = 12; N += B - C
N = 12; N += B * C
N = 12; N += B / C
N = 12; N += INT 2.5
N = 12; N += ABS -4
N = 12; N += SQRT 9
N = 12; N += SIN 90
N = 12; N += COS 0
N = 12; N += TAN 45
N = 12; N += ASIN 1
N = 12; N += ACOS 0
N = 12; N += ATAN 1
N = 12; N += DEG2RAD 180
N = 12; N += RAD2DEG 1
N = 12; N += ATAN2 1 1
N = 12; N += NORM M
N = 12; N += NORM U
N = 12; N -= B
N = 12; N -= B + C
N = 12; N -= B - C
N = 12; N -= B * C
N = 12; N -= B / C
N = 12; N -= INT 2.5
N = 12; N -= ABS -4
N = 12; N -= SQRT 9
N = 12; N -= SIN 90
N = 12; N -= COS 0
N = 12; N -= TAN 45
N = 12; N -= ASIN 1
N = 12; N -= ACOS 0
N = 12; N -= ATAN 1
N = 12; N -= DEG2RAD 180
N = 12; N -= RAD2DEG 1
N = 12; N -= ATAN2 1 1
N = 12; N -= NORM M
N = 12; N -= NORM U
N = 12; N *= B
N = 12; N *= B + C
N = 12; N *= B - C
N = 12; N *= B * C
N = 12; N *= B / C
N = 12; N *= INT 2.5
N = 12; N *= ABS -4
N = 12; N *= SQRT 9
N = 12; N *= SIN 90
N = 12; N *= COS 0
N = 12; N *= TAN 45
N = 12; N *= ASIN 1
N = 12; N *= ACOS 0
N = 12; N *= ATAN 1
N = 12; N *= DEG2RAD 180
N = 12; N *= RAD2DEG 1
N = 12; N *= ATAN2 1 1
N = 12; N *= NORM M
N = 12; N *= NORM U
N = 12; N /= B
N = 12; N /= B + C
N = 12; N /= B - C
N = 12; N /= B * C
N = 12; N /= B / C
N = 12; N /= INT 2.5
N = 12; N /= ABS -4
N = 12; N /= SQRT 9
N = 12; N /= SIN 90
N = 12; N /= COS 0
N = 12; N /= TAN 45
N = 12; N /= ASIN 1
N = 12; N /= ACOS 0
N = 12; N /= ATAN 1
N = 12; N /= DEG2RAD 180
N = 12; N /= RAD2DEG 1
N = 12; N /= ATAN2 1 1
N = 12; N /= NORM M
N = 12; N /= NORM U
P = M
P = M + O
P = M - O
P = M * O
P = M / O
P = UNIT_VECT M
P = ROT_X M 0
P = ROT_Y M 0
P = ROT_Z M 0
P.X = 4; P.Y = 5; P.Z = 7; P += M
P.X = 4; P.Y = 5; P.Z = 7; P += M + O
P.X = 4; P.Y = 5; P.Z = 7; P += M - O
P.X = 4; P.Y = 5; P.Z = 7; P += M * O
P.X = 4; P.Y = 5; P.Z = 7; P += M / O
P.X = 4; P.Y = 5; P.Z = 7; P += UNIT_VECT M
P.X = 4; P.Y = 5; P.Z = 7; P += ROT_X M 0
P.X = 4; P.Y = 5; P.Z = 7; P += ROT_Y M 0
P.X = 4; P.Y = 5; P.Z = 7; P += ROT_Z M 0
P.X = 4; P.Y = 5; P.Z = 7; P -= M
P.X = 4; P.Y = 5; P.Z = 7; P -= M + O
P.X = 4; P.Y = 5; P.Z = 7; P -= M - O
P.X = 4; P.Y = 5; P.Z = 7; P -= M * O
P.X = 4; P.Y = 5; P.Z = 7; P -= M / O
P.X = 4; P.Y = 5; P.Z = 7; P -= UNIT_VECT M
P.X = 4; P.Y = 5; P.Z = 7; P -= ROT_X M 0
P.X = 4; P.Y = 5; P.Z = 7; P -= ROT_Y M 0
P.X = 4; P.Y = 5; P.Z = 7; P -= ROT_Z M 0
P.X = 4; P.Y = 5; P.Z = 7; P *= M
P.X = 4; P.Y = 5; P.Z = 7; P *= M + O
P.X = 4; P.Y = 5; P.Z = 7; P *= M - O
P.X = 4; P.Y = 5; P.Z = 7; P *= M * O
P.X = 4; P.Y = 5; P.Z = 7; P *= M / O
P.X = 4; P.Y = 5; P.Z = 7; P *= UNIT_VECT M
P.X = 4; P.Y = 5; P.Z = 7; P *= ROT_X M 0
P.X = 4; P.Y = 5; P.Z = 7; P *= ROT_Y M 0
P.X = 4; P.Y = 5; P.Z = 7; P *= ROT_Z M 0
P.X = 4; P.Y = 5; P.Z = 7; P /= M
P.X = 4; P.Y = 5; P.Z = 7; P /= M + O
P.X = 4; P.Y = 5; P.Z = 7; P /= M - O
P.X = 4; P.Y = 5; P.Z = 7; P /= M * O
P.X = 4; P.Y = 5; P.Z = 7; P /= M / O
P.X = 4; P.Y = 5; P.Z = 7; P /= UNIT_VECT M
P.X = 4; P.Y = 5; P.Z = 7; P /= ROT_X M 0
P.X = 4; P.Y = 5; P.Z = 7; P /= ROT_Y M 0
P.X = 4; P.Y = 5; P.Z = 7; P /= ROT_Z M 0
Q = U
Q = U + Y
Q = U - Y
Q = U * Y
Q = U / Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q += U
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q += U + Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q += U - Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q += U * Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q += U / Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q -= U
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q -= U + Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q -= U - Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q -= U * Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q -= U / Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q *= U
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q *= U + Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q *= U - Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q *= U * Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q *= U / Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q /= U
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q /= U + Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q /= U - Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q /= U * Y
Q.J1 = 4; Q.J2 = 5; Q.J3 = 7; Q /= U / Y
END
