3.1
utf 8
MESSAGE 歩きます
REM コメント
// 注釈
END
