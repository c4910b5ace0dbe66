3.1
歩行　試験
　　def_var　n　　　// 歩数
n　=　2　　　　　　　// ソ能表
message　歩数は　%n%　歩
REM　注記：表示ソフト
message ｿﾌﾄ　終了
END
