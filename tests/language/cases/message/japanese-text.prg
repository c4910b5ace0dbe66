3.1
Japanese text
DEF_VAR A
A = 12.25
MESSAGE 高さは　%A.1% mm です
MESSAGE ｱｲｳ
END
