3.1
half width katakana
SLEEP ｱ
MESSAGE ｱ
REM ｱ
// ｱ
END
