3.1
歩行
MESSAGE こんにちは
END
