3.1
歩行　テスト
MESSAGE　前へ
　PTP　F1　R　10,0　0
　　FOO　1
MESSAGE 終　わり　　// 注
END
